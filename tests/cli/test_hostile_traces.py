"""Commands that read traces, and traces that somebody has changed: an answer or a message, no traceback."""

from __future__ import annotations

import gzip
import json
import os
import random
import struct
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.runtime.trace.trace_blocks import packed
from tests.cli.support import Here
from tests.support.traces import HEADER, texts_of

SYSTEM = """\
system Talks
message Word { int n }
message Pulse { int n }
topic air { signal Pulse }
aip talk {
  participant asker { sends request Word  receives inform Word  process = Ask . Listen . Think }
  participant other { sends inform Word  receives request Word  process = Hear . Muse . Reply }
  clause every Hear@other leads to Think@asker within 250ms
  control asker { enter Ask : / send request Word { n = 1 } to other  enter Think : inform Word from other }
  control other { enter Hear : request Word from asker  enter Reply : / send inform Word { n = 2 } to asker }
}
srm one {
  plays talk.asker
  var m : int = 0
  liveness { one = asker || Beat~ }
  activities { Ask takes 20ms  Listen takes 1ms  Think takes 50ms  Beat takes 90ms }
  control one { repeat Beat : [m < 9] / m = m + 1 ; write_messages.air.signal.Pulse { n = m } }
}
srm two {
  plays talk.other
  liveness { two = other || See~ }
  activities { Hear takes 100ms  Muse takes 50ms  Reply takes 1ms  See takes 10ms }
  control two { repeat See : [has(air.signal.Pulse)] }
}
team Pair { ann : one  bob : two }
property "it beats" { every ann in Beat leads to sent air.signal.Pulse within 2s }
"""

COMMANDS: list[Callable[[str], list[str]]] = [
    lambda path: ["trace", path],
    lambda path: ["trace", path, "--lines", "--agent", "ann"],
    lambda path: ["trace", path, "-o", "converted.mcap"],
    lambda path: ["sniff", path],
    lambda path: ["sniff", path, "--format", "svg"],
    lambda path: ["replay", path],
    lambda path: ["observe", path],
    lambda path: ["observe", path, "--model", "talks.aseme", "--stories", "stories"],
    lambda path: ["observe", path, "--live", "--for", "10ms"],
    lambda path: ["why", "ann", "Think", path, "--at", "300ms"],
    lambda path: ["whynot", "bob", "Muse", path, "--at", "50ms"],
    lambda path: ["metrics", path, "--source", "talks.aseme"],
    lambda path: ["coverage", path, "--source", "talks.aseme"],
    lambda path: ["goals", "talks.aseme", path],
]


@pytest.fixture
def talks(folder: Path, here: Here) -> list[str]:
    """The lines of a run."""
    (folder / "talks.aseme").write_text(SYSTEM)
    done = here("run", "talks.aseme", "-o", "out", "--for", "400ms", "-q", "--allow", "waiting")
    assert done.code == 0, done.err + done.out
    return texts_of(folder / "out" / "trace.jsonl.gz")


def holds(here: Here, words: list[str], seed: object) -> None:
    """A command gives an answer or a message, as one that reads a trace may."""
    done = here(*words)
    assert done.code in (0, 1, 2), (seed, words, done.err)
    assert "Traceback" not in done.err + done.out and "bug in asemec" not in done.err, (seed, words, done.err)


ODD: list[Any] = [
    None,
    True,
    -1,
    0,
    10**30,
    1.5,
    "",
    "x",
    "0.1",
    [],
    [[]],
    {},
    {"a": 1},
    ["ann", 1],
    "\ud800",
]


def changed(lines: list[str], chance: random.Random) -> list[str]:
    """The lines of a trace with one thing that is otherwise."""
    found = list(lines)
    place = chance.randrange(len(found)) if chance.random() < 0.8 else 0
    match chance.randrange(7):
        case 0:
            del found[place]
        case 1:
            found.insert(place, found[chance.randrange(len(found))])
        case 2:
            found[place] = chance.choice(["", "{}", "[" * 5000, '{"kind":1}', "\x00", found[place][:-5]])
        case 3:
            other = chance.randrange(len(found))
            found[place], found[other] = found[other], found[place]
        case _:
            record = json.loads(found[place])
            _change(record, chance)
            found[place] = json.dumps(record)
    return found


def _change(value: Any, chance: random.Random) -> None:
    """Remove or change one part of a value, at any depth."""
    keys = list(value) if isinstance(value, dict) else list(range(len(value)))
    if not keys:
        return
    key = chance.choice(keys)
    if isinstance(value[key], dict | list) and value[key] and chance.random() < 0.6:
        _change(value[key], chance)
    elif chance.random() < 0.3:
        del value[key]
    elif isinstance(value[key], int) and chance.random() < 0.5:
        value[key] += chance.choice((-1, 1, 7, 10**6))
    else:
        value[key] = chance.choice(ODD)


@pytest.mark.parametrize("seed", range(int(os.environ.get("HOSTILE_TRACES", "5"))))
def test_changed_lines(seed: int, talks: list[str], here: Here) -> None:
    chance = random.Random(f"lines {seed}")
    data = ("\n".join(changed(talks, chance)) + "\n").encode("utf-8", "surrogatepass")
    path = "changed.jsonl"
    if chance.random() < 0.5:
        path, data = "changed.jsonl.gz", packed(data, 1)
    Path(path).write_bytes(data)
    for words in chance.sample(COMMANDS, 4):
        holds(here, words(path), seed)


@pytest.mark.parametrize("seed", range(int(os.environ.get("HOSTILE_TRACES", "5"))))
def test_changed_bytes(seed: int, talks: list[str], here: Here) -> None:
    chance = random.Random(f"bytes {seed}")
    path = Path("changed.jsonl.gz")
    if chance.random() < 0.3:
        path = Path("changed.mcap")
        assert here("trace", "out", "-o", str(path)).code == 0
    else:
        path.write_bytes(b"".join(in_two(talks)))
    data = bytearray(path.read_bytes())
    for _ in range(chance.choice((1, 1, 3, 20))):
        data[min(chance.randrange(len(data)), chance.choice((60, len(data) - 1)))] = chance.randrange(256)
    if chance.random() < 0.3:
        del data[chance.randrange(len(data)) :]
    path.write_bytes(data)
    for words in chance.sample(COMMANDS, 4):
        holds(here, words(str(path)), seed)


def in_two(lines: list[str]) -> list[bytes]:
    """The two blocks of a compressed trace."""
    half = len(lines) // 2
    parts = (lines[:half], 1), (lines[half:], half + 1)
    return [packed("".join(f"{line}\n" for line in part).encode(), start) for part, start in parts]


def block(size: int, line: int = 1, lines: int = 1, marks: bytes = b"", data: bytes = b"") -> bytes:
    """A block of a compressed trace whose header says what it is told to."""
    told = struct.pack("<BQQQqq", 0, size, line, lines, 0, 0) + marks
    head = b"\x1f\x8b\x08\x04\0\0\0\0\0\xff" + struct.pack("<H2sH", 4 + len(told), b"AS", len(told)) + told
    return head + gzip.compress(data)[10:]


FIRST = json.dumps(
    {**HEADER, "agents": [{"name": "ann", "role": "one", "model": "m", "source": "x"}]}
).encode()


@pytest.mark.parametrize(
    ("data", "said"),
    [
        (block(2**63, data=FIRST), "the block at byte 0 is said to have 9223372036854775808 bytes"),
        (block(3, data=FIRST), "the block at byte 0 is said to have 3 bytes"),
        (block(2000, lines=2**64 - 1, data=FIRST), ""),
        (block(2000, marks=zlib.compress(b" " * (2 << 20)), data=FIRST), "it has more than 1 MB"),
        (block(2000, marks=zlib.compress(b'{"ann": 1e9}'), data=FIRST), "it has no checkpoints"),
        (block(2000, marks=b"nonsense", data=FIRST), "the header of the block at byte 0 is damaged"),
        (packed(FIRST + b"\n", 1) + packed(b"{}\n", 7), "is damaged"),
    ],
)
def test_the_header_of_a_block_is_not_believed(folder: Path, here: Here, data: bytes, said: str) -> None:
    (folder / "x.jsonl.gz").write_bytes(data)
    done = here("whynot", "ann", "Walk", "x.jsonl.gz", "--at", "1s")
    assert done.code == 1 and said in done.err and "bug in asemec" not in done.err, done.err


@pytest.mark.parametrize(
    ("header", "said"),
    [
        ({"kind": "header", "time": 0}, "format is missing"),
        ({name: value for name, value in HEADER.items() if name != "agents"}, "agents is missing"),
        ({**HEADER, "agents": ["ann"]}, "agents.0 is not an object"),
        ({**HEADER, "agents": [{"name": 1}]}, "agents.0.role is missing"),
        ({**HEADER, "agents": 3}, "agents is not a list"),
        ({**HEADER, "time": 10**40}, "time is too large"),
    ],
)
def test_a_header_is_named_with_what_is_wrong(
    folder: Path, here: Here, header: dict[str, Any], said: str
) -> None:
    (folder / "talks.aseme").write_text(SYSTEM)
    (folder / "x.jsonl").write_text(json.dumps(header) + "\n")
    for words in COMMANDS:
        done = here(*words("x.jsonl"))
        text = f"x.jsonl:1: this line of the kind 'header' is damaged: {said}"
        assert done.code in (1, 2) and text in done.err, (words("x.jsonl"), done)


def test_a_file_that_unpacks_to_far_more_is_not_read_to_its_end(
    folder: Path, here: Here, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("aseme_dsl.runtime.trace.trace_gzip._MUCH", 1 << 20)
    line = json.dumps({"kind": "note", "time": 1, "text": "a" * 1000}).encode() + b"\n"
    (folder / "x.jsonl.gz").write_bytes(gzip.compress(FIRST + b"\n" + line * 20_000))
    done = here("trace", "x.jsonl.gz")
    assert (done.code, "it unpacks to more than 200 times its size" in done.err) == (1, True), done


def test_a_line_with_millions_of_lists_is_none(folder: Path, here: Here) -> None:
    many = b'{"kind":"note","time":1,"text":[' + b"[]," * 1_100_000 + b"[]]}\n"
    (folder / "x.jsonl.gz").write_bytes(gzip.compress(FIRST + b"\n" + many))
    done = here("trace", "x.jsonl.gz")
    assert (done.code, "x.jsonl.gz:2: a line of a trace is wanted" in done.err) == (1, True), done


def test_a_torn_last_block_is_read_as_far_as_it_goes(talks: list[str], folder: Path, here: Here) -> None:
    from aseme_dsl.runtime.trace.trace_reading import TraceReader

    half = len(talks) // 2
    first, second = in_two(talks)
    path = folder / "torn.jsonl.gz"
    seen = set()
    for share in (0.4, 0.7, 0.95):
        path.write_bytes(first + second[: int(len(second) * share)])
        reader = TraceReader(path)
        read = [line.text for line in reader]
        assert read == talks[: len(read)] and reader.problem is not None
        assert [line.text for line in reader.before(len(talks) + 1)] == read[::-1]
        seen.add(len(read))
    assert len(seen) > 1 and max(seen) > half
    path.write_bytes(first + second[:-30] + b"garbage" + second[-30:])
    read = [line.text for line in TraceReader(path)]
    assert len(read) > half
