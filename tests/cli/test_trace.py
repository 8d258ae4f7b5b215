"""`asemec trace`: sums, lists, filters and converts what runs have left."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

from aseme_dsl.runtime.trace.trace_reading import TraceReader
from tests.cli.support import Here
from tests.support.traces import texts_of

ROOT = Path(__file__).parents[2]
HEADER = {
    "kind": "header",
    "time": 0,
    "format": 2,
    "system": "Walker",
    "seed": 7,
    "clock": "virtual",
    "agents": [
        {"name": "one", "role": "robot", "model": "m", "source": "w.aseme"},
        {"name": "two", "role": "robot", "model": "m", "source": "w.aseme"},
    ],
}
SECOND = 1_000_000_000


def activity(seconds: float, agent: str, what: str, label: str, name: str, **members: object) -> object:
    line = {"kind": "activity", "time": int(seconds * SECOND), "agent": agent, "what": what}
    return {**line, "label": label, "activity": name, "token": 1, **members}


def step(seconds: float, agent: str, number: int, source: str, target: str, active: str) -> object:
    way = {"transitions": [0], "source": source, "target": target, "text": "again"}
    line = {"kind": "step", "time": int(seconds * SECOND), "agent": agent, "step": number, "inputs": []}
    return {**line, "taken": [way], "configuration": [active]}


LINES = [
    HEADER,
    step(0, "one", 1, "0.1", "0.2", "0.2"),
    activity(0, "one", "start", "0.2", "Walk"),
    {
        "kind": "message",
        "time": SECOND,
        "agent": "one",
        "sequence": 1,
        "channel": "eyes.state.Seen",
        "message": {"ball": True},
        "to": ["one", "two"],
    },
    step(2, "one", 2, "0.2", "0.3", "0.3"),
    activity(2, "one", "start", "0.3", "Stand"),
    step(4, "one", 3, "0.3", "0.2", "0.2"),
    activity(4, "one", "start", "0.2", "Walk"),
    {
        "kind": "conversation",
        "time": 5 * SECOND,
        "agent": "two",
        "what": "open",
        "conversation": "pass-two-1",
        "participant": "passer",
        "branch": "0.2",
    },
    {"kind": "fault", "time": 6 * SECOND, "agent": "two", "reason": "absent value", "at": "w.aseme:1:2"},
    activity(7, "one", "crash", "0.2", "Walk", reason="ValueError: no"),
    {"kind": "gap", "time": 7 * SECOND, "lines": 12, "reason": "the disk is slower than the run"},
    {"kind": "finish", "time": 8 * SECOND, "reason": "time", "agents": []},
]


@pytest.fixture
def trace(folder: Path) -> Path:
    path = folder / "run.jsonl"
    path.write_text("".join(f"{json.dumps(line)}\n" for line in LINES))
    return path


def test_a_trace_is_summed_up(here: Here, trace: Path) -> None:
    done = here("trace", "run.jsonl")
    assert (done.code, done.err) == (0, "")
    assert (
        done.out
        == """\
run.jsonl: Walker, seed 7, virtual time
0.000 s to 8.000 s, 13 records, ended: time
12 records missing: the disk was slower than the run

agent  role   steps  activities  crashes  faults  failure
one    robot      3           3        1       0
two    robot      0           0        0       1

agent  state  label  times     time  share
one    Walk   0.2        2  6.000 s    75%
one    Stand  0.3        1  2.000 s    25%

channel          messages  from
eyes.state.Seen         1  one 1

protocol  opened  joined  left  messages
pass           1       0     0         0

times  fault
    1  absent value
"""
    )


def test_the_sum_as_json(here: Here, trace: Path) -> None:
    done = here("trace", "run.jsonl", "--json", "--to", "3s")
    [sum_] = done.json["traces"]
    assert (sum_["system"], sum_["to"], sum_["lines"], sum_["problem"]) == ("Walker", 2 * SECOND, 6, None)
    assert sum_["agents"][0]["states"][0] == {
        "label": "0.2",
        "name": "Walk",
        "times": 1,
        "lasted": 2 * SECOND,
    }


@pytest.mark.parametrize(
    "filters, kinds",
    [
        (("--agent", "two"), ["message", "conversation", "fault"]),
        (("--kind", "fault", "--kind", "gap"), ["fault", "gap"]),
        (("--channel", "eyes.*"), ["message"]),
        (("--state", "Stand"), ["activity"]),
        (("--state", "0.3"), ["step", "activity", "step"]),
        (("--from", "4.5s", "--to", "6s"), ["conversation", "fault"]),
        (
            ("--agent", "one", "--kind", "activity", "--state", "0.2", "--from", "1s"),
            ["activity", "activity"],
        ),
    ],
)
def test_filters(here: Here, trace: Path, filters: tuple[str, ...], kinds: list[str]) -> None:
    done = here("trace", "run.jsonl", "--lines", "--json", *filters)
    lines = [json.loads(line) for line in done.out.splitlines()]
    assert [line["kind"] for line in lines] == kinds
    assert all(line in LINES for line in lines)


def test_lines_for_people(here: Here, trace: Path) -> None:
    done = here("trace", "run.jsonl", "--lines", "--from", "1s", "--to", "2s")
    assert (
        done.out
        == """\
     1.000000  one    message       eyes.state.Seen {"ball": true}  to one, two
     2.000000  one    step          step 2: 0.2 -> 0.3 again  in 0.3
     2.000000  one    activity      start Stand (0.3)
"""
    )


def test_converted_and_back(here: Here, trace: Path) -> None:
    done = here("trace", "run.jsonl", "-o", "run.mcap")
    assert (done.code, done.out) == (0, "run.mcap: 13 records\n")
    assert here("trace", "run.mcap", "-o", "back.jsonl").code == 0
    assert Path("back.jsonl").read_bytes() == trace.read_bytes()
    for _ in range(2):  # what is a trace may become another one
        assert here("trace", "run.mcap", "-o", "two.jsonl", "--agent", "two").code == 0
    assert [line.record["kind"] for line in TraceReader(Path("two.jsonl"))] == [
        *("header", "message", "conversation", "fault", "finish")
    ]


def test_no_file_of_the_user_becomes_a_trace(here: Here, trace: Path) -> None:
    Path("mine.jsonl").write_text("{}\n")
    before = trace.read_bytes()
    done = here("trace", "run.jsonl", "-o", "mine.jsonl")
    assert done.code == 2 and "mine.jsonl is there already, and is not a trace that asemec wrote" in done.err
    done = here("trace", "run.jsonl", "-o", "./run.jsonl", "--agent", "two")
    assert done.code == 2 and "run.jsonl is read, and would be written over" in done.err
    done = here("run", "good.aseme", "--for", "1s", "--trace", "good.aseme")
    assert done.code == 2 and "good.aseme is read" in done.err
    assert (Path("mine.jsonl").read_text(), trace.read_bytes()) == ("{}\n", before)


def test_a_torn_trace_is_read_and_the_exit_code_says_so(here: Here, trace: Path) -> None:
    whole = trace.read_bytes()
    trace.rename("run.jsonl.part")
    Path("run.jsonl.part").write_bytes(whole[:-30])
    done = here("trace", "run.jsonl")
    assert done.code == 1
    assert done.out.startswith("run.jsonl.part: Walker") and "12 records" in done.out
    assert done.err.startswith("run.jsonl.part: error[E035]: run.jsonl.part:13: the trace breaks off here")
    done = here("trace", "run.jsonl", "-o", "whole.jsonl")
    assert (done.code, done.out) == (1, "whole.jsonl: 12 records\n")


def test_what_cannot_be_read_is_named(here: Here, trace: Path) -> None:
    Path("bad.jsonl").write_bytes(trace.read_bytes().replace(b'{"kind": "fault"', b"oops", 1))
    done = here("trace", "bad.jsonl", "nowhere.jsonl", "run.jsonl")
    assert done.code == 1 and "run.jsonl: Walker" in done.out
    assert "error[E035]: bad.jsonl:10: a line of a trace is wanted, not 'oops" in done.err
    assert "nowhere.jsonl: error[E001]: there is no file nowhere.jsonl\n" in done.err
    done = here("trace", "bad.jsonl", "-o", "x.mcap")
    assert done.code == 1 and not Path("x.mcap").exists() and not Path("x.mcap.part").exists()
    done = here("trace", "run.jsonl", "--kind", "activty")
    assert done.code == 2 and "Did you mean 'activity'?" in done.err
    assert here("trace", "run.jsonl", "--from", "soon").code == 2
    assert here("trace").code == 1  # nothing has run here


BIG = """
import sys
sys.path.insert(0, {root!r})
from aseme_dsl.cli import main
code = main(["trace", "big.jsonl"]) or main(["trace", "big.jsonl", "-o", "big.mcap"])
code = code or main(["trace", "big.mcap", "-o", "again.jsonl"])
# The peak of this program alone: what getrusage says begins with the memory of the process that started it.
print(next(line.split()[1] for line in open("/proc/self/status") if line.startswith("VmHWM:")))
sys.exit(code)
"""


def test_a_long_trace_needs_little_memory(folder: Path) -> None:
    """A trace of 10 MB is summed up and converted twice with less than 45 MB, 30 of which are the program."""
    middle = "".join(f"{json.dumps(line)}\n" for line in LINES[1:8])
    with Path("big.jsonl").open("w") as file:
        file.write(f"{json.dumps(HEADER)}\n")
        for _ in range(10_000_000 // len(middle)):
            file.write(middle)
        file.write(f"{json.dumps(LINES[-1])}\n")
    done = subprocess.run(
        [sys.executable, "-c", BIG.format(root=str(ROOT))], capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stderr
    assert int(done.stdout.splitlines()[-1]) < 45_000
    assert Path("again.jsonl").read_bytes() == Path("big.jsonl").read_bytes()


def test_lines_name_states_as_the_file_does(here: Here, folder: Path) -> None:
    """Both `Look` have their label behind the name; a part of an AND is called by what it is in."""
    (folder / "two.aseme").write_text("""system Two
srm r {
  liveness { r = Look . ((Look . Go) || Turn) }
  activities { Look takes 1s simulated  Go takes 1s simulated  Turn takes 3s simulated }
}
""")
    assert here("run", "two.aseme", "--quiet", "-o", "two").code == 0
    lines = here(
        "trace", "two/trace.jsonl.gz", "--lines", "--kind", "step", "--kind", "activity"
    ).out.splitlines()
    said = [line[36:].strip() for line in lines]
    assert said[:3] == [
        "step 1: start of r -> Look (0.2)  in Look (0.2)",
        "start Look (0.2)",
        "end Look (0.2)",
    ]
    assert "; start of (Look . Go) || Turn (0.3.2.2.1) -> Turn; " in said[3]
    assert said[3].endswith("  in (Look . Go) || Turn, Look (0.3.2.1.2.2), Turn")
    assert "step 3: Look (0.3.2.1.2.2) -> Go  in (Look . Go) || Turn, Go, Turn" in said
    only = here("trace", "two/trace.jsonl.gz", "--lines", "--state", "Go").out
    assert [" ".join(line.split()[2:5]) for line in only.splitlines()] == [
        "step step 3:",
        "activity start Go",
        "activity end Go",
        "step step 4:",
    ]
    # A trace of before has no names: its labels are shown.
    text = "".join(f"{line}\n" for line in texts_of(folder / "two/trace.jsonl.gz"))
    (folder / "old.jsonl").write_text(re.sub('"names":.*?}},', "", text, count=1))
    assert "0.1 -> 0.2  in 0.2" in here("trace", "old.jsonl", "--lines").out
