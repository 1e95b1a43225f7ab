"""Reads an .rrd with the reader of Rerun's Python SDK, and holds every value and time against the table."""

from collections import defaultdict

import numpy
from rerun.experimental import RrdReader

from table import Differs, Table, bits, check_folder

VALUES = "Scalars:scalars"


def read(path):
    """By entity, the batches of its scalars, in the order of the file."""
    batches = defaultdict(list)
    for chunk in RrdReader(path).stream():
        batch = chunk.to_record_batch()
        if VALUES in batch.schema.names:
            batches[str(chunk.entity_path)].append(batch)
    return batches


def rows(batches, where):
    """The scalars of each sample, which must stand at steps 0, 1, 2 and so on; and their times in ns."""
    values, steps, times = [], [], []
    for batch in batches:
        lists = batch.column(VALUES)
        width = len(lists[0])
        flat = lists.values.slice(lists.offsets[0].as_py(), len(lists) * width)
        values.append(flat.to_numpy().reshape(-1, width))
        steps.extend(batch.column("step").to_pylist())
        times.extend(batch.column("sim_time").cast("int64").to_pylist())
    if steps != list(range(len(steps))):
        raise Differs(f"{where}: steps are not 0, 1, 2 and so on")
    return numpy.concatenate(values), times


def exact_times(batches, count):
    """What the format promises: step times interval, rounded once, or the times as a column."""
    if "/time/interval_s" in batches:
        interval = batches["/time/interval_s"][0].column(VALUES)[0].as_py()[0]
        return [step * interval for step in range(count)]
    return rows(batches["/time/time_s"], "/time/time_s")[0][:, 0].tolist()


def check(recording, csv):
    table = Table(csv)
    batches = read(recording)
    entities = defaultdict(dict)
    for entity in batches:
        if entity.startswith("/body/"):
            # A body, or a point of one: body/point.
            *subject, kind, channel = entity.removeprefix("/body/").split("/")
            if kind == "plots":
                entities["/".join(subject)][channel] = entity
    times_s = exact_times(batches, len(table.times_s))
    if list(map(bits, times_s)) != list(map(bits, table.times_s)):
        raise Differs("times differ from the table's")
    for body, channels in entities.items():
        columns = table.of_channels(body, len(entities), list(channels))
        for channel, entity in channels.items():
            values, times_ns = rows(batches[entity], entity)
            if times_ns != [round(time_s * 1e9) for time_s in table.times_s]:
                raise Differs(f"{entity}: sim_time differs from the table's times")
            for name, column in zip(columns[channel], values.T, strict=True):
                table.compare(name, column.tolist(), entity)
    return f"{table.all_compared(recording)} values"


if __name__ == "__main__":
    check_folder("rrd", check)
