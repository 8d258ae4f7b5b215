"""MCAP: a trace as a file that Foxglove opens, and the lines that such a file holds.

Every line is a message, as it is, on the JSON channel `trace/KIND`; so nothing is lost, and the lines can be
taken out again. What was published is there once more as Protocol Buffers, for those who plot it: on
`AGENT/TOPIC/COMM/MESSAGE`, and what an agent has heard by radio on `AGENT/radio/TOPIC/COMM/MESSAGE`. What
the descriptors in the trace's header cannot say (after a change to another version, perhaps) is JSON there.

The log time is the run's: in real time since 1970, in virtual time since the run began.
"""

from __future__ import annotations

import base64
import contextlib
import io
import json
import re
import struct
import zlib
from collections.abc import Iterable, Iterator, Mapping, Set
from datetime import datetime
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

from aseme_dsl import outside
from aseme_dsl.runtime.message.naming import snake_case
from aseme_dsl.runtime.trace.records import Record, agents_of, as_record
from aseme_dsl.runtime.trace.trace_files import TraceError, to_disk
from aseme_dsl.runtime.trace.trace_schema import line_schema

if TYPE_CHECKING:
    from google.protobuf.message import Message

MAGIC = b"\x89MCAP0\r\n"
PREFIX = "trace/"
"""How the topics of the lines begin."""
CHUNK_BYTES = 1024 * 1024
LONGEST = 64 * 1024 * 1024
"""No line and no record of a trace has so many bytes, nor what a chunk holds: a number beyond is damage."""
MOST_TIMES = 1000
"""A file unpacks to so many times its size at most, and `LONGEST` bytes more."""
_BEGINNING = re.compile(r'\{"kind":"(\w+)","time":(\d+)[,}]')


def require() -> None:
    """Raises TraceError if the package for MCAP is not installed."""
    try:
        import mcap  # noqa: F401
    except ImportError as missing:
        text = "for an MCAP trace the package mcap is needed: pip install 'aseme-dsl[trace]'"
        raise TraceError(text) from missing


# ---- writing -----------------------------------------------------------------------------------


class McapFile:
    """Writes lines into an MCAP file; a `trace_files.Format`."""

    flush_seconds = 1.0  # a flush ends a chunk, and small chunks are packed badly
    may_flush = False

    def __init__(self, path: Path) -> None:
        """Raises OSError if there cannot be a file at `path`, TraceError if mcap is not installed."""
        require()
        from mcap.writer import Writer

        self._file: IO[bytes] = outside.new_file(path)
        self._writer: Any = Writer(self._file, chunk_size=CHUNK_BYTES, compression=_compression())
        self._writer.start(profile="aseme", library="aseme-dsl")
        self._schemas: dict[str, int] = {}
        self._channels: dict[tuple[str, str], int] = {}
        self._origin = 0
        self._descriptors = b""
        self._names: Mapping[str, str] = {}
        self._classes: dict[str, type[Message]] = {}
        self._number = 0

    def put(self, lines: Iterable[str]) -> None:
        for line in lines:
            self._line(line)

    def flush(self) -> None:
        self._writer.flush()

    def sync(self) -> None:
        to_disk(self._file)

    def finish(self) -> None:
        self._writer.finish()
        self._file.flush()
        to_disk(self._file)
        self._file.close()

    def abandon(self) -> None:
        with contextlib.suppress(OSError, ValueError):  # the disk is still full
            self._file.close()

    def _line(self, line: str) -> None:
        found = _BEGINNING.match(line)
        record: Record | None = None
        if found is not None:
            kind, moment = found[1], int(found[2])
        else:
            record = as_record(json.loads(line))
            kind, moment = str(record["kind"]), int(record["time"])
        if kind == "header":
            self._begin(record or as_record(json.loads(line)))
        self._number += 1
        data = line.encode("utf-8", "backslashreplace")
        self._add(self._json_channel(PREFIX + kind, kind), moment, data, moment)
        if kind in ("message", "arrived", "radio_received"):
            self._publication(kind, record or as_record(json.loads(line)), moment)

    def _add(self, channel: int, moment: int, data: bytes, published: int) -> None:
        origin = self._origin
        self._writer.add_message(
            channel, max(0, moment + origin), data, max(0, published + origin), self._number
        )

    def _begin(self, header: Record) -> None:
        """Say whose trace it is, and learn what the messages are."""
        if "start" in header:
            start = datetime.fromisoformat(header["start"])
            self._origin = round(start.timestamp() * 1e6) * 1000
        messages = header.get("messages")
        self._descriptors = base64.b64decode(messages["descriptors"] if messages else "")
        self._names = messages["channels"] if messages else {}
        agents = agents_of(header) if "agents" in header else []
        said: dict[str, str] = {
            name: str(header.get(name))
            for name in ("system", "format", "seed", "clock", "start")
            if name in header
        }
        said["agents"] = " ".join(f"{item['name']}:{item['role']}" for item in agents)
        said["models"] = " ".join(dict.fromkeys(item["model"] for item in agents))
        self._writer.add_metadata("aseme", said)

    # ---- channels ------------------------------------------------------------------------------

    def _json_channel(self, topic: str, kind: str, metadata: Mapping[str, str] | None = None) -> int:
        found = self._channels.get((topic, "json"))
        if found is None:
            schema = 0
            if kind and kind not in self._schemas:
                self._schemas[kind] = self._writer.register_schema(
                    f"aseme.trace.{kind}", "jsonschema", json.dumps(line_schema(kind)).encode()
                )
            schema = self._schemas[kind] if kind else self._any_object()
            found = self._writer.register_channel(topic, "json", schema, dict(metadata or {"kind": kind}))
            self._channels[topic, "json"] = found
        return int(found)

    def _any_object(self) -> int:
        if "" not in self._schemas:
            data = b'{"type":"object"}'
            self._schemas[""] = self._writer.register_schema("aseme.message", "jsonschema", data)
        return self._schemas[""]

    def _proto_channel(self, topic: str, name: str, metadata: Mapping[str, str]) -> int:
        found = self._channels.get((topic, "protobuf"))
        if found is None:
            key = f"protobuf {name}"
            if key not in self._schemas:
                self._schemas[key] = self._writer.register_schema(name, "protobuf", self._descriptors)
            found = self._writer.register_channel(topic, "protobuf", self._schemas[key], dict(metadata))
            self._channels[topic, "protobuf"] = found
        return int(found)

    def _publication(self, kind: str, record: Record, moment: int) -> None:
        channel = str(record["channel"])
        topic, comm, message = channel.split(".", 2)
        if kind == "arrived":
            agent, published = str(record["input"][0]), int(record["measured"])
        else:
            agent, published = str(record.get("sender") or record["agent"]), moment
        place = f"{agent}/{topic}/{comm}/{message}"
        if kind == "radio_received":
            place = f"{record['agent']}/radio/{topic}/{comm}/{message}"
        said = {"agent": agent, "topic": topic, "commType": comm, "message": message}
        content = record["message"]
        name = self._names.get(channel)
        try:
            data = self._proto(name, content) if name is not None else None
        except (KeyError, TypeError, ValueError, AttributeError):  # of another version of the model
            data = None
        if data is not None and name is not None:
            self._add(self._proto_channel(place, name, said), moment, data, published)
        else:
            text = json.dumps(content, ensure_ascii=False).encode("utf-8", "backslashreplace")
            self._add(self._json_channel(place, "", said), moment, text, published)

    def _proto(self, name: str, content: object) -> bytes:
        if not self._classes:
            self._classes = message_classes(self._descriptors)
        proto = self._classes[name]()
        _fill(proto, content)
        return bytes(proto.SerializeToString(deterministic=True))


def _compression() -> Any:
    """The best compression that is installed."""
    from mcap.writer import CompressionType

    with contextlib.suppress(ImportError):
        import zstandard  # noqa: F401

        return CompressionType.ZSTD
    with contextlib.suppress(ImportError):
        import lz4.frame  # noqa: F401

        return CompressionType.LZ4
    return CompressionType.NONE


def message_classes(descriptors: bytes) -> dict[str, type[Message]]:
    """The protobuf classes of a FileDescriptorSet, by their full names."""
    from google.protobuf import descriptor_pb2, descriptor_pool, message_factory

    pool = descriptor_pool.DescriptorPool()
    files = descriptor_pb2.FileDescriptorSet.FromString(descriptors)
    for file in files.file:
        pool.Add(file)
    found: dict[str, type[Message]] = {}
    names = [f"{file.package}.{kind.name}".lstrip(".") for file in files.file for kind in file.message_type]
    waiting = [pool.FindMessageTypeByName(name) for name in names]
    while waiting:
        kind = waiting.pop()
        found[kind.full_name] = message_factory.GetMessageClass(kind)
        waiting.extend(kind.nested_types)
    return found


def _fill(proto: Any, content: Any) -> None:
    """Set the fields of a protobuf message from the members in a line, which stand in the fields' order.

    Raises TypeError or ValueError if they are not of that message.
    """
    for (name, value), field in zip(content.items(), proto.DESCRIPTOR.fields, strict=True):
        if name.strip("_") != field.name.strip("_"):  # of a word of Python's the member has an underscore
            raise ValueError(f"{name} is not {field.name}")
        if value is None:
            continue
        if not field.is_repeated:
            if field.message_type is not None:
                inner = getattr(proto, field.name)
                inner.SetInParent()
                _fill(inner, value)
            else:
                setattr(proto, field.name, _scalar(field, value))
            continue
        target = getattr(proto, field.name)
        if field.message_type is None:
            target.extend(_scalar(field, item) for item in value)
        elif field.message_type.GetOptions().map_entry:
            of_key, of_value = (
                field.message_type.fields_by_name["key"],
                field.message_type.fields_by_name["value"],
            )
            for item in value:
                key = _scalar(of_key, item["key"])
                if of_value.message_type is not None:
                    _fill(target[key], item["value"])
                else:
                    target[key] = _scalar(of_value, item["value"])
        else:
            for item in value:
                _fill(target.add(), item)


def _scalar(field: Any, value: Any) -> Any:
    if field.enum_type is not None and isinstance(value, str):
        numbers = field.enum_type.values_by_name
        # Protocol Buffers know a system's own constants with the enum's name in front.
        own = f"{snake_case(field.enum_type.name).upper()}_{value}"
        return numbers[own if own in numbers else value].number
    if field.type == field.TYPE_BYTES:
        return base64.b64decode(value, validate=True)
    if field.type in (field.TYPE_DOUBLE, field.TYPE_FLOAT):
        return float(value)  # "NaN" and "Infinity", too
    return value


# ---- reading -----------------------------------------------------------------------------------


def lines_in(file: IO[bytes], path: Path) -> Iterator[str]:
    """The lines of a trace in an MCAP file, in their order, as far as it goes.

    Raises:
        TraceError: mcap is not installed; it is damaged or ends early, which can be after many lines.
    """
    require()
    from mcap.exceptions import McapError
    from mcap.records import Channel, Footer
    from mcap.records import Message as McapMessage
    from mcap.stream_reader import StreamReader

    mine: set[int] = set()
    number = 0
    whole = False
    unpacking = _Unpacking(mine)
    bounded: Any = _Bounded(file)
    reader = StreamReader(bounded, emit_chunks=True, validate_crcs=True, record_size_limit=LONGEST)
    try:
        for record in (inner for outer in reader.records for inner in unpacking.records(outer)):
            if type(record) is bytes:
                number += 1
                yield record.decode("utf-8")
            elif isinstance(record, Channel) and record.topic.startswith(PREFIX):
                mine.add(record.id)
            elif isinstance(record, McapMessage) and record.channel_id in mine:
                number += 1
                yield record.data.decode("utf-8")
            elif isinstance(record, Footer):
                whole = True
    except GeneratorExit:
        raise
    except Exception as problem:  # of several libraries, where the data is not MCAP any more
        if not whole:
            what = str(problem) if isinstance(problem, McapError | _Damaged) else ""
            raise Torn(number, what or "the rest cannot be read") from problem
    if not number:
        raise TraceError(f"{path} is an MCAP file, but not a trace of asemec")


class _Unpacking:
    """Unpacks the chunks of a file, up to a limit for all of them together."""

    def __init__(self, wanted: Set[int]) -> None:
        """`wanted` are the numbers of the channels whose messages are, at any time."""
        self._wanted = wanted
        self._packed = self._unpacked = 0

    def records(self, record: Any) -> Iterator[Any]:
        """What is in a chunk, or the record itself if it is none.

        The usual message in a chunk comes as its content alone, and one that is not wanted does not come.

        Raises _Damaged, and what the libraries do.
        """
        from mcap.records import Chunk

        if not isinstance(record, Chunk):
            yield record
            return
        data = _content(record)
        self._packed += len(record.data)
        self._unpacked += len(data)
        if self._unpacked > LONGEST + MOST_TIMES * self._packed:
            raise _Damaged(f"it unpacks to more than {MOST_TIMES} times its size")
        if record.uncompressed_crc and zlib.crc32(data) != record.uncompressed_crc:
            raise _Damaged("the checksum of a chunk is another")
        yield from self._inside(data)

    def _inside(self, data: bytes) -> Iterator[Any]:
        from mcap.exceptions import EndOfFile
        from mcap.records import Channel, Schema
        from mcap.stream_reader import StreamReader

        file, place = io.BytesIO(data), 0
        is_usual = True
        while is_usual:
            # Nearly all are messages. mcap takes ten times as long for one.
            while place + _MESSAGE.size <= len(data):
                opcode, length, channel = _MESSAGE.unpack_from(data, place)
                end = place + _OPCODE_AND_LENGTH + length
                if opcode != _IS_MESSAGE or length <= _BEFORE_CONTENT or end > len(data):
                    break
                if channel in self._wanted:
                    yield data[place + _OPCODE_AND_LENGTH + _BEFORE_CONTENT : end]
                place = end
            file.seek(place)
            inside: Any = _Bounded(file)
            is_usual = False
            with contextlib.suppress(EndOfFile):  # it has no footer
                reader = StreamReader(inside, skip_magic=True, emit_chunks=True, record_size_limit=LONGEST)
                for record in reader.records:
                    place = file.tell()
                    yield record
                    if is_usual := isinstance(record, Channel | Schema):
                        break


def _content(record: Any) -> bytes:
    """What a chunk holds. Raises _Damaged, and what the libraries do."""
    # Not by mcap itself: it believes the size that stands in the compressed data, however large.
    data: bytes
    match record.compression:
        case "":
            data = record.data
        case "zstd":
            import zstandard

            data = zstandard.ZstdDecompressor().stream_reader(record.data).read(LONGEST + 1)
        case "lz4":
            import lz4.frame

            data = lz4.frame.LZ4FrameDecompressor().decompress(record.data, LONGEST + 1)
        case other:
            raise _Damaged(f"there is no compression {other[:20]!r}")
    if len(data) > LONGEST:
        raise _Damaged(f"a chunk holds more than {LONGEST >> 20} MB")
    return data


class _Bounded:
    """A file with a limit for each read: a length that stands in the file may be wrong."""

    def __init__(self, file: IO[bytes]) -> None:
        self._file = file
        self._is_nothing = False

    def read(self, size: int) -> bytes:
        if size > LONGEST:
            raise _Damaged(f"something in it is said to have {size} bytes")
        data = self._file.read(size)
        # A record without a kind and without content: a hole in the file, which may have billions of them.
        if self._is_nothing and data == _NO_SIZE:
            raise _Damaged("there is nothing in it from here on")
        self._is_nothing = data == b"\0"
        return data


_NO_SIZE = bytes(8)
_MESSAGE = struct.Struct("<BQH")
"""How a message begins: what kind of record it is, its size behind that, and its channel."""
_IS_MESSAGE = 5
_OPCODE_AND_LENGTH, _BEFORE_CONTENT = 9, 22


class _Damaged(Exception):
    """Why a chunk cannot be read."""


class Torn(Exception):
    """A trace ends in the middle of something: after so many lines, and why."""

    def __init__(self, lines: int, reason: str) -> None:
        super().__init__(reason)
        self.lines = lines
        self.reason = reason
