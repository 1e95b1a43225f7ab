"""Reads an .mcap with the official Python library: every checksum, every message, and every state against the table."""

import struct
import zlib
from collections import defaultdict

from mcap.reader import make_reader
from mcap.records import Statistics
from mcap.stream_reader import StreamReader
from mcap_protobuf.decoder import DecoderFactory

from table import Differs, Table, bits, check_folder


def check_summary(data):
    """The library leaves the summary's checksum to its callers."""
    # Opcode, length, where the summary and its offsets begin, checksum; then the magic.
    opcode, length, start, _, expected = struct.unpack("<BQQQI", data[-37:-8])
    if (opcode, length) != (2, 20) or zlib.crc32(data[start:-12]) != expected:
        raise Differs("the summary is not what its checksum says")


def check_records(path):
    """Chunks and data section by their checksums; what statistics and indexes say against what is there."""
    counts, statistics = defaultdict(int), None
    with open(path, "rb") as file:
        for record in StreamReader(file, validate_crcs=True).records:
            if type(record).__name__ == "Message":
                counts[record.channel_id] += 1
            elif isinstance(record, Statistics):
                statistics = record
    if statistics is None or dict(statistics.channel_message_counts) != dict(counts):
        raise Differs(f"statistics {statistics} of a file with {dict(counts)}")
    return sum(counts.values())


def leaves(field, message):
    """The numbers of a field, in the order of its schema."""
    value = getattr(message, field.name)
    if field.message_type is None:
        return [value]
    return [getattr(value, leaf.name) for leaf in field.message_type.fields]


def read_states(path):
    """The samples of each body, as (log time, message); every other message is decoded too."""
    states, seen = defaultdict(list), 0
    with open(path, "rb") as file:
        reader = make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()])
        for schema, channel, message, decoded in reader.iter_decoded_messages():
            seen += 1
            if schema.name == "polhode.BodyState":
                # A body, or a point of one: body/point.
                subject = channel.topic.removeprefix("/body/").removesuffix("/state")
                states[subject].append((message.log_time, decoded))
    return states, seen


def compare(states, table):
    for body, samples in states.items():
        for row, (log_time, state) in enumerate(samples):
            time_s = table.times_s[row]
            stamp = state.timestamp.seconds * 10**9 + state.timestamp.nanos
            if bits(state.time_s) != bits(time_s) or stamp != log_time or log_time != round(time_s * 1e9):
                raise Differs(f"{body}, sample {row}: {state.time_s!r} s, {stamp} ns, {log_time} ns; {time_s!r} s")
        fields = [field for field, _ in samples[0][1].ListFields() if field.name not in ("time_s", "timestamp")]
        channels = table.of_channels(body, len(states), [field.name for field in fields])
        for field in fields:
            columns = list(zip(*[leaves(field, state) for _, state in samples], strict=True))
            for name, values in zip(channels[field.name], columns, strict=True):
                table.compare(name, values, f"{body}/{field.name}")


def check(recording, csv):
    table = Table(csv)
    with open(recording, "rb") as file:
        check_summary(file.read())
    states, seen = read_states(recording)
    if seen != check_records(recording):
        raise Differs(f"{seen} messages by the index, {check_records(recording)} by the records")
    compare(states, table)
    return f"{seen} messages, {table.all_compared(recording)} values"


if __name__ == "__main__":
    check_folder("mcap", check)
