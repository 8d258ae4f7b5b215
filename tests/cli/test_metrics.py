"""`asemec metrics`: counts and times of one run, compared with a count by hand, and of several runs."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.cli.support import Here
from tests.runtime.playing import MS

TEAM = """\
system Desk
message Job { int n }
sag { actor boss { goal ask "Work is given."  goal rest "It is quiet." } }
suc { usecase ask realises Ask  usecase rest realises Rest, Sleep }
aip hire {
  participant boss {
    sends    request Job
    receives inform Job
    process  = Ask . Listen
  }
  participant hand { sends inform Job  receives request Job  process = Do . Tell }
  control boss { enter Listen : / send request Job { n = 1 } to hand  leave Listen : inform Job from hand }
  control hand { enter Do : request Job from boss  enter Tell : / send inform Job { n = 2 } to boss }
}
srm boss {
  plays hire.boss
  liveness { boss = (boss . Rest)~ }
  activities {
    Ask takes 100ms simulated  Listen takes 1ms simulated
    Rest takes 500ms simulated ends well, badly
  }
}
srm hand {
  plays hire.hand
  liveness { hand = hand~ }
  activities { Do takes 500ms simulated  Tell takes 1ms simulated }
}
team Desk { ann : boss  bob : hand }
"""


@pytest.fixture
def desk(here: Here, folder: Path) -> Here:
    (folder / "desk.aseme").write_text(TEAM)
    for seed in (1, 2):
        arguments = ("--seed", str(seed), "--trace", f"s{seed}.jsonl", "--quiet")
        assert here("run", "desk.aseme", "--for", f"{seed + 4}s", *arguments).code == 0
    return here


def test_counts_and_times_are_those_of_the_trace(desk: Here, folder: Path) -> None:
    found = desk("metrics", "s1.jsonl", "--json").json["metrics"]
    records = [json.loads(line) for line in (folder / "s1.jsonl").read_text().splitlines()]
    # By hand: the activity of a state starts and ends with it.
    began: Counter[str] = Counter()
    lasted: Counter[str] = Counter()
    since: dict[str, int] = {}
    for record in records:
        if record["kind"] == "activity" and record["what"] == "start":
            began[record["activity"]] += 1
            since[record["activity"]] = record["time"]
        elif record["kind"] == "activity" and record["what"] in ("end", "cancel"):
            lasted[record["activity"]] += record["time"] - since.pop(record["activity"])
    for name, start in since.items():
        lasted[name] += records[-1]["time"] - start
    rows = {item["name"]: item for item in found["rows"] if item["kind"] == "state"}
    for name in ("Ask", "Rest", "Do"):
        assert (rows[name]["times"], rows[name]["totals_ns"]) == ([began[name]], [lasted[name]])
        assert sum(rows[name]["lasted_ns"]) == lasted[name] > 0
    # Goals are served while one of their states is active.
    goals = {item["name"]: item for item in found["rows"] if item["kind"] == "goal"}
    assert goals["ask"]["totals_ns"] == [lasted["Ask"]]
    assert goals["rest"]["times"] == [began["Rest"]]
    joined = Counter(item["what"] for item in records if item["kind"] == "conversation")
    (protocol,) = [item for item in found["rows"] if item["kind"] == "protocol"]
    assert (protocol["name"], protocol["times"]) == ("hire", [joined["open"]])
    ended = {
        item["participant"]: sum(sum(item[how]) for how in ("completed", "left", "open"))
        for item in found["parts"]
    }
    assert ended == {"boss": joined["open"], "hand": joined["join"]}
    # The run ends while the last job is done: its hand leaves before the end of its part.
    assert [(item["completed"], item["left"], item["open"]) for item in found["parts"]] == [
        ([joined["open"]], [0], [0]),
        ([joined["join"] - 1], [1], [0]),
    ]
    assert found["messages"] == {"hire": [sum(item["kind"] == "agent_message" for item in records)]}
    well = sum(item.get("outcome") == "well" for item in records)
    assert found["outcomes"] == [{"activity": "Rest", "outcome": "well", "times": [well]}]


def test_several_runs_have_a_mean_and_a_spread(desk: Here, folder: Path) -> None:
    done = desk("metrics", "s1.jsonl", "s2.jsonl", "--plot", "runs.svg")
    assert done.out.startswith("metrics of Desk: 2 runs, 11 s\n\nstate ")
    both = desk("metrics", "s1.jsonl", "s2.jsonl", "--json").json["metrics"]
    alone = [desk("metrics", file, "--json").json["metrics"] for file in ("s1.jsonl", "s2.jsonl")]
    assert [run["seed"] for run in both["runs"]] == [1, 2]
    for whole, one, other in zip(both["rows"], alone[0]["rows"], alone[1]["rows"], strict=True):
        assert whole["times"] == one["times"] + other["times"]
        assert whole["lasted_ns"] == one["lasted_ns"] + other["lasted_ns"]
    drawing = ElementTree.fromstring((folder / "runs.svg").read_bytes())
    assert len(list(drawing.iter("{http://www.w3.org/2000/svg}circle"))) == 2 * 2 * len(both["rows"])
    assert desk("metrics", "s1.jsonl", "--plot", "runs.svg").code == 0
    assert desk("metrics", "s1.jsonl", "--plot", "runs.png").code == 2
    (folder / "mine.svg").write_text("<svg/>")
    assert desk("metrics", "s1.jsonl", "--plot", "mine.svg").code == 2


def test_what_is_not_a_trace_of_this_system_is_an_error(desk: Here, folder: Path) -> None:
    (folder / "desk.aseme").write_text(TEAM.replace("500ms", "600ms"))
    done = desk("metrics", "s1.jsonl", "--source", "desk.aseme")
    assert (done.code, done.out) == (1, "")
    assert "error[E035]: `ann` and `bob` ran another version of `Desk`" in done.err
    (folder / "torn.jsonl").write_text((folder / "s2.jsonl").read_text()[:-40])
    (folder / "desk.aseme").write_text(TEAM)
    torn = desk("metrics", "torn.jsonl")
    assert (torn.code, torn.out.startswith("metrics of Desk")) == (1, True)


def test_a_file_of_coverage_is_not_a_run(desk: Here, folder: Path) -> None:
    (folder / "c.json").write_text("{}")
    done = desk("metrics", "c.json", "s1.jsonl")
    assert (done.code, "1 run" in done.out) == (1, True)
    assert "c.json: error[E035]: it is a file of `asemec test --coverage-file`" in done.out + done.err


def test_a_conversation_with_a_name_of_its_own_belongs_to_its_protocol(desk: Here, folder: Path) -> None:
    """Also one that is still open at the end."""
    lines = [line for line in (folder / "s1.jsonl").read_text().splitlines() if '"what":"leave"' not in line]
    own = [
        line.replace('"hire-ann-', '"talk-').replace(
            '"kind":"conversation"', '"kind":"conversation","protocol":"hire"'
        )
        for line in lines
    ]
    (folder / "open.jsonl").write_text("\n".join((*lines, "")))
    (folder / "own.jsonl").write_text("\n".join((*own, "")))
    found = [desk("metrics", name, "--json").json["metrics"] for name in ("own.jsonl", "open.jsonl")]
    assert own != lines
    assert found[0] == found[1]
    assert any(row["kind"] == "protocol" and row["open"] for row in found[0]["rows"])


def test_what_came_after_a_swap_is_named(here: Here, folder: Path) -> None:
    (folder / "w.aseme").write_text(
        "system W  srm r { liveness { r = A+ }  activities { A takes 70ms } }  team T { w : r }"
    )
    here("run", "w.aseme", "-o", "out", "--for", "600ms", "--trace", "t.jsonl", "-q")
    lines = (folder / "t.jsonl").read_text().splitlines()
    swap = {"kind": "swap", "time": 210 * MS, "agent": "w", "what": "done", "role": "r", "model": "0" * 16}
    place = next(number for number, line in enumerate(lines) if json.loads(line)["time"] > 210 * MS)
    (folder / "t.jsonl").write_text("\n".join([*lines[:place], json.dumps(swap), *lines[place:]]) + "\n")
    told = "w changed to another model at 0.21 s; what came then was not counted"
    assert here("metrics", "t.jsonl").out.startswith(f"note: {told}\n")
    assert here("metrics", "t.jsonl", "--json").json["metrics"]["left_out"] == [told]
