"""The table that the other formats are held against, by Python's own reading of decimals."""

import csv
import struct
import sys
from pathlib import Path


class Differs(Exception):
    """What a recording says is not what the table says."""


def bits(value):
    """All 64 bits of an f64: -0 is not 0."""
    return struct.pack("<d", value)


class Table:
    """A .csv in columns."""

    def __init__(self, path):
        with open(path, newline="", encoding="utf-8") as file:
            rows = csv.reader(file)
            names = next(rows)
            columns = list(zip(*[[float(text) for text in row] for row in rows], strict=True))
        if len(columns) != len(names):
            raise Differs(f"{path}: {len(names)} names for {len(columns)} columns")
        self.times_s = columns[0]
        self.columns = dict(zip(names[1:], columns[1:], strict=True))
        self.compared = set()

    def of_body(self, body, bodies):
        """A body's columns by their names; with one body, names have no prefix."""
        prefix = f"{body}." if bodies > 1 else ""
        return {name.removeprefix(prefix): name for name in self.columns if name.startswith(prefix)}

    def of_channels(self, body, bodies, channels):
        """Names of the columns of each channel: a column belongs to the longest name that it begins with."""
        found = {channel: [] for channel in channels}
        for short, name in self.of_body(body, bodies).items():
            begins = [channel for channel in channels if short.startswith(f"{channel}_")]
            if not begins:
                raise Differs(f"column {name} is in no channel of the other recording")
            found[max(begins, key=len)].append(name)
        return found

    def compare(self, name, values, where):
        """Every value of a column, to the bit."""
        column = self.columns[name]
        if len(column) != len(values):
            raise Differs(f"{where}: {len(values)} samples, the table has {len(column)}")
        for row, (expected, value) in enumerate(zip(column, values)):
            if bits(expected) != bits(value):
                raise Differs(f"{where}, {name}, sample {row}: {value!r}, the table has {expected!r}")
        self.compared.add(name)

    def all_compared(self, where):
        """How many values there are, times among them, if none was left out."""
        left = sorted(set(self.columns) - self.compared)
        if left:
            raise Differs(f"{where}: nothing to compare with columns {', '.join(left)}")
        return (1 + len(self.columns)) * len(self.times_s)


def check_folder(extension, check):
    """Checks every recording of the folder that the command line names; exits with 1 if one differs."""
    recordings = sorted(Path(sys.argv[1]).glob(f"*.{extension}"))
    failed = not recordings
    for path in recordings:
        try:
            print(f"ok      {path.name}: {check(str(path), str(path.with_suffix('.csv')))}")
        except Differs as difference:
            print(f"FAILED  {path.name}: {difference}")
            failed = True
    sys.exit(failed)
