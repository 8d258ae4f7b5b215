"""Traces that somebody has made to do harm: what they say of their sizes is not believed."""

from __future__ import annotations

import json
import struct
from pathlib import Path

import pytest

from aseme_dsl.project.playing.following import TraceFollower
from aseme_dsl.runtime.trace.trace_files import TraceError
from aseme_dsl.runtime.trace.trace_mcap import LONGEST, MAGIC
from aseme_dsl.runtime.trace.trace_reading import TraceReader
from tests.support.traces import HEADER

FIRST = json.dumps(HEADER).encode() + b"\n"
CHANNEL, CHUNK = 4, 6


def record(kind: int, content: bytes, size: int | None = None) -> bytes:
    return struct.pack("<BQ", kind, len(content) if size is None else size) + content


def text(value: bytes, size: int | None = None) -> bytes:
    return struct.pack("<I", len(value) if size is None else size) + value


def chunk(compression: bytes, data: bytes, said: int, size: int | None = None) -> bytes:
    head = struct.pack("<QQQI", 0, 0, said, 0) + text(compression)
    return record(CHUNK, head + struct.pack("<Q", len(data) if size is None else size) + data)


def problem_of(path: Path) -> str:
    reader = TraceReader(path)
    try:
        assert list(reader) == []
    except TraceError as problem:
        return str(problem)
    return reader.problem or ""


def test_what_a_chunk_unpacks_to_is_bounded(tmp_path: Path) -> None:
    zstandard = pytest.importorskip("zstandard")
    frame = pytest.importorskip("lz4.frame")
    zeros = bytes(LONGEST + 10)
    for name, data in (
        (b"zstd", zstandard.compress(zeros)),
        (b"lz4", frame.compress(zeros)),
        (b"zstd", zstandard.ZstdCompressor(write_content_size=False).compress(zeros)),
    ):
        assert len(data) < LONGEST // 100
        for said in (10, LONGEST + 10, 2**63):
            path = tmp_path / "a.mcap"
            path.write_bytes(MAGIC + chunk(name, data, said))
            assert "a chunk holds more than 64 MB" in problem_of(path)


def test_what_all_chunks_unpack_to_is_bounded(tmp_path: Path) -> None:
    zstandard = pytest.importorskip("zstandard")
    zeros = zstandard.compress(record(200, bytes(LONGEST - 100)))
    path = tmp_path / "a.mcap"
    path.write_bytes(MAGIC + 3 * chunk(b"zstd", zeros, LONGEST))
    assert "it unpacks to more than 1000 times its size" in problem_of(path)


def test_lines_that_are_not_records_are_reported_when_followed(tmp_path: Path) -> None:
    path = tmp_path / "a.jsonl"
    path.write_bytes(FIRST + b"nonsense\n" + FIRST + b"{}\n")
    follower = TraceFollower(path)
    assert len(list(follower.poll())) == 2
    assert follower.problem == f"{path}: 2 lines are not records of a trace; the first is line 2"
    follower.close()


@pytest.mark.parametrize(
    "content",
    [
        record(CHANNEL, struct.pack("<HH", 1, 0) + text(b"trace/x", 2**32 - 1)),
        record(CHUNK, b"", 2**63),
        chunk(b"", b"", 0, 2**63),
        chunk(b"", record(CHUNK, b"", 2**40), 0),
        chunk(b"", record(CHANNEL, struct.pack("<HH", 1, 0) + text(b"x", 2**32 - 1)), 0),
        chunk(b"rot13", b"abc", 3),
        chunk(b"zstd", b"abc", 3),
        chunk(b"lz4", b"abc", 3),
        b"\xff" * 1000,
    ],
    ids=["name", "record", "data", "inside", "name inside", "unknown", "zstd", "lz4", "noise"],
)
def test_a_size_that_stands_in_a_file_is_not_believed(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "a.mcap"
    with path.open("wb") as file:
        file.write(MAGIC + content)
        file.truncate(20 << 30)  # what is not there reads as zeros, and takes no room on the disk
    assert "breaks off here" in problem_of(path)


def test_a_line_without_end_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "a.jsonl"
    with path.open("wb") as file:
        file.write(FIRST)
        file.truncate(20 << 30)
    with pytest.raises(TraceError, match=f"a line is longer than {LONGEST} bytes"):
        list(TraceReader(path))
    follower = TraceFollower(path)
    with pytest.raises(TraceError, match=f"a line is longer than {LONGEST} bytes"):
        list(follower.poll())
    follower.close()


def test_a_pipe_is_not_followed(tmp_path: Path) -> None:
    import os

    os.mkfifo(tmp_path / "a.jsonl")
    with pytest.raises(TraceError, match="not a regular file"):
        list(TraceFollower(tmp_path / "a.jsonl").poll())
