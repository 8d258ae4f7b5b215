"""`asemec sniff`: what agents have said to each other, as text, as Mermaid and as a picture."""

from __future__ import annotations

import gzip
import json
import os
import shutil
import subprocess
import sys
import threading
import time
from collections.abc import Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from xml.etree import ElementTree

import pytest

from aseme_dsl.cli import main
from aseme_dsl.diagrams.sequence.sequence import Mark
from aseme_dsl.project.playing.following import TraceFollower
from aseme_dsl.project.playing.sniff import Sniffer
from aseme_dsl.runtime.trace import trace_gzip
from aseme_dsl.runtime.trace.trace import format_for
from tests.cli.support import Here
from tests.conftest import Snapshot
from tests.diagrams.overlaps import Painted, overlaps
from tests.diagrams.pictures import SVG

SYSTEM = """
system Kitchen
import protocols
srm boss {
  plays contract_net.manager
  liveness { boss = manager }
  activities { AnnounceJob takes 1s simulated  CollectProposals takes 2s simulated
               AwardContract takes 1s simulated  AwaitOutcome takes 1s simulated
               LearnOutcome takes 1s simulated }
}
srm cook {
  plays contract_net.contractor
  liveness { cook = contractor }
  activities { EvaluateJob takes 100ms  MakeProposal takes 100ms simulated  CarryOut takes 3s
               ReportOutcome takes 1s simulated
               DeclineJob takes 1s simulated  StopWork takes 1s simulated  CloseJob takes 1s simulated }
}
team Kitchen { ann : boss  bob, cid : cook }
"""

DECIDE = """
class EvaluateJob:
    def execute(self, context):
        context.wait(0.1)
        context.set_variable("able", context.agent == "bob")
"""
BREAK = """
class CarryOut:
    def execute(self, context):
        context.wait(1)
        raise RuntimeError("the pan is hot")
"""


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the trace of a contract net: one cook refuses, the other one breaks down."""
    folder = tmp_path_factory.mktemp("kitchen")
    (folder / "kitchen.aseme").write_text(SYSTEM, "utf-8")
    activities = folder / "activities"
    activities.mkdir()
    (activities / "evaluate_job.py").write_text(DECIDE, "utf-8")
    (activities / "carry_out.py").write_text(BREAK, "utf-8")
    main(["run", f"{folder}/kitchen.aseme", "--activities", f"{activities}", "-o", f"{folder}/out", "-q"])
    return folder


@pytest.fixture
def run(played: Path, folder: Path) -> Path:
    """The output of that run, in a copy where one works."""
    shutil.copytree(played, folder, dirs_exist_ok=True)
    return folder / "out"


def lines(text: str) -> list[str]:
    return [" ".join(line.split()) for line in text.splitlines()]


def test_what_is_said_as_lines(run: Path, here: Here) -> None:
    done = here("sniff", "out")
    assert lines(done.out) == [
        "1 s ann -- cfp Job --> bob, cid [contract_net-ann-1]",
        "1.1 s cid -- refuse Job --> ann [contract_net-ann-1]",
        "1.2 s bob -- propose Proposal (cost 0.0) --> ann [contract_net-ann-1]",
        "2.2 s ann -- accept_proposal Contract (contractor bob) --> bob [contract_net-ann-1]",
        "3.2 s ann ! lost bob (failed) [contract_net-ann-1]",
        "3.2 s bob x breaks down: CarryOut: RuntimeError: the pan is hot [contract_net-ann-1]",
    ]
    assert done.code == 0


def test_a_deadline_that_passes_is_shown(run: Path, here: Here) -> None:
    Path("activities/carry_out.py").write_text(BREAK.replace("wait(1)", "wait(600)"), "utf-8")
    here("run", "kitchen.aseme", "--activities", "activities", "-q", "--for", "5min")
    assert lines(here("sniff", "out/trace.jsonl.gz", "--from", "10s").out) == [
        "122.2 s ann ! continues to wait (2min) [contract_net-ann-1]",
        "122.2 s ann -- cancel Contract --> bob [contract_net-ann-1]",
        "123.2 s bob -- inform Contract --> ann [contract_net-ann-1]",
    ]


ON = """
system Shop
message Job { string id }
aip work {
  participant boss { var late : bool  sends request Job  receives inform Job  process = Ask }
  participant hand { sends inform Job  receives request Job  process = Do }
  control boss {
    enter Ask : / send request Job { id = "j" } to hand; start_timer(patience, 2s)
    on Ask    : when [expired(patience)] / late = true
    leave Ask : inform Job from hand [late]
  }
  control hand {
    enter Do : request Job from boss
    leave Do : / send inform Job { .. } to boss
  }
}
srm a { plays work.boss  liveness { a = boss }  activities { Ask waits } }
srm b { plays work.hand  liveness { b = hand }  activities { Do takes 3s simulated } }
team Shop { ann : a  bob : b }
"""


def test_a_deadline_after_which_the_agent_goes_on_waiting(folder: Path, here: Here) -> None:
    Path("shop.aseme").write_text(ON, "utf-8")
    here("run", "shop.aseme", "-q", "--for", "5s", "--allow", "waiting")
    assert lines(here("sniff", "out/trace.jsonl.gz").out) == [
        "0 s ann -- request Job (id j) --> bob [work-ann-1]",
        "2 s ann ! continues to wait (the timer patience) [work-ann-1]",
        "3 s bob -- inform Job --> ann [work-ann-1]",
    ]


def test_filters_say_what_they_leave_out(run: Path, here: Here) -> None:
    done = here("sniff", "out", "--agent", "cid")
    assert [line.split(" -- ")[1].split()[0] for line in lines(done.out)] == [
        "cfp",
        "refuse",
    ]
    assert done.err == "left out: 2 messages and 2 events of 1 conversation\n"
    assert here("sniff", "out", "--protocol", "auction").out == "no agent messages in this trace\n"
    assert here("sniff", "out", "--protocol", "auction", "-o", "none.svg").out.endswith("0 conversations\n")
    assert len(lines(here("sniff", "out", "--conversation", "contract_net-*", "--to", "2s").out)) == 3


def test_as_mermaid(run: Path, here: Here, snapshot: Snapshot) -> None:
    snapshot(here("sniff", "out", "--format", "mermaid").out, "kitchen.mmd")


def test_as_a_picture(run: Path, here: Here, snapshot: Snapshot) -> None:
    done = here("sniff", "out", "-o", "pictures/talk.svg")
    assert done.out == "pictures/talk.svg: 6 rows of 1 conversation\n".replace(
        "/", "\\" if sys.platform == "win32" else "/"
    )
    picture = Path("pictures/talk.svg").read_text("utf-8")
    ElementTree.fromstring(picture)
    snapshot(picture, "kitchen.svg")


def test_as_data(run: Path, here: Here) -> None:
    found = json.loads(here("sniff", "out", "--json", "--agent", "cid").out)
    assert found["rows"][1] == {
        "moment": 1_100_000_000,
        "sender": "cid",
        "receivers": ["ann"],
        "performative": "refuse",
        "message": "Job",
        "whole": '{"id": "", "what": ""}',
        "conversation": "contract_net-ann-1",
    }
    assert found["remarks"] == ["left out: 2 messages and 2 events of 1 conversation"]


ORDERS = """
system Orders
message Dish { string name }
message Meal { string name }
aip ordering {
  participant waiter { sends request Dish  receives inform Meal  process = Order . AwaitMeal }
  participant cook [1..*] { sends inform Meal  receives request Dish  process = Cook }
  control waiter {
    enter Order     : / send request Dish { name = "pie" } to cook
    leave AwaitMeal : inform Meal from cook or after(1min)
  }
  control cook {
    enter Cook : request Dish from waiter
    leave Cook : / send inform Meal { name = "pie" } to waiter
  }
}
srm service { plays ordering.waiter  liveness { service = waiter . Rest }
              activities { Order takes 1s simulated  AwaitMeal takes 5min simulated
               Rest takes 1min simulated } }
srm kitchen { plays ordering.cook  liveness { kitchen = cook }  activities { Cook takes 20s } }
team Orders { ann : service  bob, cat, dan : kitchen }
"""
COOK = """
class Cook:
    def execute(self, context):
        context.wait(LATE if context.agent == "dan" else 20)
"""


@pytest.mark.parametrize(
    ("late", "sniffed", "told", "counts"),
    [
        (20, ["leaves without having taken 2 messages"], "2 agent messages not consumed", (2, 0)),
        (
            25,
            [
                "leaves without having taken inform Meal of cat",
                "did not expect inform Meal: its part in the conversation is over",
            ],
            "1 agent message not consumed, 1 agent message unexpected",
            (1, 1),
        ),
    ],
)
def test_what_is_never_taken_is_told(
    folder: Path, here: Here, late: int, sniffed: list[str], told: str, counts: tuple[int, int]
) -> None:
    Path("orders.aseme").write_text(ORDERS, "utf-8")
    Path("activities").mkdir()
    Path("activities/cook.py").write_text(COOK.replace("LATE", str(late)), "utf-8")
    done = here("run", "orders.aseme", "--activities", "activities", "-q")
    assert f"... {told}; for details: asemec sniff\n" in done.err
    shown = [line for line in lines(here("sniff", "out").out) if " ann ! " in line]
    assert [line.split(" ann ! ")[1].partition(" [")[0] for line in shown] == sniffed
    result = json.loads(here("run", "orders.aseme", "--activities", "activities", "--json").out)["result"]
    assert (result["untaken"], result["unexpected"]) == counts


EXTRA = """
system Orders
message Dish { string name }
message Extra { string name }
aip ordering {
  participant waiter { sends request Dish, inform Extra  process = Order . Add }
  participant cook { var hot : bool = false  receives request Dish, inform Extra  process = Cook . Serve }
  control waiter {
    enter Order : / send request Dish to cook
    leave Add   : / send inform Extra to cook
  }
  control cook {
    enter Cook  : request Dish from waiter
    enter Serve : inform Extra from waiter [hot]
  }
}
srm service { plays ordering.waiter  liveness { service = waiter . Rest }
              activities { Order takes 1s  Add takes 1s  Rest takes 1min } }
srm kitchen { plays ordering.cook  liveness { kitchen = cook }
              activities { Cook takes 30s  Serve takes 1s } }
team Orders { ann : service  bob : kitchen }
"""


def test_what_still_waits_for_its_receiver_at_the_end_is_told(folder: Path, here: Here) -> None:
    Path("orders.aseme").write_text(EXTRA, "utf-8")
    done = here("run", "orders.aseme", "--for", "10s", "-q")
    assert "unread: inform Extra from ann to bob" in done.out
    (shown,) = (line for line in lines(here("sniff", "out").out) if " ! " in line)
    text = "10 s bob ! leaves without having taken inform Extra of ann [ordering-ann-1]"
    assert " ".join(shown.split()) == text
    rows = here("sniff", "out", "--json", "--agent", "bob").json["rows"]
    assert [row["text"] for row in rows if "text" in row] == [
        text[len("10 s bob ! ") : -len(" [ordering-ann-1]")]
    ]


def test_what_nobody_expected_is_told_once(folder: Path, here: Here) -> None:
    text = ORDERS.replace("kitchen = cook", "kitchen = Sleep . cook")
    Path("orders.aseme").write_text(text.replace("{ Cook", "{ Sleep takes 30s  Cook"), "utf-8")
    here("run", "orders.aseme", "--for", "10s", "-q")
    shown = [line for line in lines(here("sniff", "out").out) if " bob ! " in line]
    assert ["did not expect request Dish" in line for line in shown] == [True]


def test_a_message_to_an_agent_that_has_crashed_is_told(folder: Path, here: Here) -> None:
    records = [
        {
            "kind": "run",
            "time": 0,
            "system": "S",
            "clock": "virtual",
            "agents": [{"name": "ann", "role": "a"}, {"name": "bob", "role": "b"}],
        },
        {
            "kind": "agent_message",
            "time": 1,
            "agent": "ann",
            "sequence": 4,
            "to": ["bob"],
            "performative": "inform",
            "message": "M",
            "content": {},
            "conversation": "c-1",
            "protocol": "p",
        },
        {
            "kind": "fault",
            "time": 2,
            "agent": "bob",
            "reason": "M from ann is lost: bob is down",
            "input": ["ann", 4],
        },
    ]
    sniffer = Sniffer()
    sniffer.header(records[0])
    rows = [row for record in records[1:] for row in sniffer.rows(record)]
    assert rows[-1] == Mark(2, "bob", "M from ann is lost: bob is down", "c-1")


def test_what_is_taken_is_not_counted(run: Path, here: Here) -> None:
    """A cook that breaks down while the other one is told of it has not left anything untaken."""
    assert "agent message" not in here("run", "kitchen.aseme", "--activities", "activities").err


# ---- long ones -----------------------------------------------------------------------------------


def header(*agents: str, **members: object) -> dict[str, object]:
    team = [{"name": name, "role": "robot", "model": "m", "source": "w.aseme"} for name in agents]
    return {
        "kind": "header",
        "time": 0,
        "format": 2,
        "system": "Talk",
        "seed": 1,
        "clock": "virtual",
        "agents": team,
        **members,
    }


def mail(seconds: float, sender: str, to: Sequence[str], number: int, **members: object) -> dict[str, object]:
    return {
        "kind": "agent_message",
        "time": int(seconds * 1e9),
        "agent": sender,
        "sequence": number,
        "performative": "inform",
        "message": "Note",
        "content": {"n": number},
        "protocol": "talk",
        "conversation": f"talk-one-{number % 3 + 1}",
        "participant": "speaker",
        "receiver": "listener",
        "to": list(to),
        **members,
    }


FINISH = {"kind": "finish", "time": 99_000_000_000, "reason": "finished", "agents": []}


def write(path: Path, *records: object) -> None:
    path.write_text("".join(f"{json.dumps(record)}\n" for record in records), "utf-8")


def test_a_long_talk_has_pages_and_each_conversation_may_have_its_own(folder: Path, here: Here) -> None:
    write(Path("t.jsonl"), header("one", "two"), *(mail(n, "one", ["two"], n) for n in range(150)), FINISH)
    here("sniff", "t.jsonl", "-o", "talk.svg")
    texts = [Path(name).read_text("utf-8") for name in ("talk.svg", "talk-2.svg", "talk-3.svg")]
    assert not Path("talk-4.svg").exists()
    assert "page 1 of 3" in texts[0] and "page 3 of 3" in texts[2]
    assert sum(text.count(">inform Note") for text in texts) == 150
    here("sniff", "t.jsonl", "-o", "one.svg", "--each")
    assert sorted(path.name for path in folder.glob("one-*")) == [f"one-talk-one-{n}.svg" for n in (1, 2, 3)]


@pytest.mark.parametrize("name", ["talk.svg", "talk.mmd", "talk.txt"])
def test_no_file_of_the_user_becomes_a_picture(folder: Path, here: Here, name: str) -> None:
    write(Path("t.jsonl"), header("one", "two"), *(mail(n, "one", ["two"], n) for n in range(150)), FINISH)
    for _ in range(2):
        assert here("sniff", "t.jsonl", "-o", name).code == 0
    Path(name).write_text("mine")
    done = here("sniff", "t.jsonl", "-o", name)
    assert done.code == 2 and f"{name} is there already" in done.err and Path(name).read_text() == "mine"


def said_by(names: Sequence[str], number: int) -> list[dict[str, object]]:
    """Messages from one to another, of long content."""
    last = len(names)
    return [
        mail(
            n,
            names[n % last],
            [names[(n * 4 + 1) % last]],
            n,
            content={"text": "what is said here is long " * 9},
        )
        for n in range(number)
    ]


def texts_of(file: str) -> list[str]:
    return ["".join(item.itertext()) for item in ElementTree.parse(file).iter(f"{SVG}text")]


def test_nine_agents_and_sixty_messages_do_not_overlap(folder: Path, here: Here) -> None:
    names = [f"agent{n}" for n in range(9)]
    write(Path("t.jsonl"), header(*names), *said_by(names, 60), FINISH)
    here("sniff", "t.jsonl", "-o", "talk.svg")
    assert not Path("talk-2.svg").exists()
    assert texts_of("talk.svg").count("inform Note") == 60
    assert overlaps(Path("talk.svg").read_bytes()) == []


def test_pages_have_the_size_that_is_asked_for(folder: Path, here: Here) -> None:
    names = [f"agent{n}" for n in range(9)]
    write(Path("t.jsonl"), header(*names), *said_by(names, 60), FINISH)
    here("sniff", "t.jsonl", "-o", "talk.svg", "--page", "a4")
    files = sorted(folder.glob("talk*.svg"))
    assert len(files) == 9
    for file in files:
        drawn = Painted(file.read_bytes())
        assert drawn.width <= 1079 and drawn.height <= 740
        assert overlaps(file.read_bytes()) == []
    assert sum(texts_of(str(file)).count("inform Note") for file in files) == 60


def test_many_agents_of_a_role_are_one_lifeline(folder: Path, here: Here) -> None:
    workers = [f"worker{n}" for n in range(1, 39)]
    team = header("boss", "desk", "audit", *workers)
    for agent in team["agents"][3:]:  # type: ignore[index]
        agent["role"] = "worker"
    job = {"conversation": "talk-boss-1", "content": {"n": 7}}
    said = [
        mail(1, "boss", workers, 1, **job),
        *(
            mail(2 + n / 10, name, ["boss"], n, performative="propose" if n % 3 else "refuse", **job)
            for n, name in enumerate(workers)
        ),
        mail(7, "boss", ["worker7"], 2, **job),
        mail(7, "boss", workers[:5], 3, **job),
        mail(8, "worker7", ["worker8", "desk"], 4, **job),
        mail(9, "desk", ["audit"], 5, **job),
    ]
    write(Path("t.jsonl"), team, *said, FINISH)
    here("sniff", "t.jsonl", "-o", "talk.svg")
    drawn = texts_of("talk.svg")
    assert drawn.count("worker[1..38]") == 1
    assert any(text.startswith("38 agents, worker:") for text in drawn)
    rows = [text for text in drawn if text.startswith(("×", "to ", "worker7"))]
    assert rows == [
        "to all: n 7",
        "× 13 until 5.6 s: n 7",
        "× 25 until 5.7 s: n 7",
        "to worker7: n 7",
        "to 5 of 38: n 7",
        "worker7 to worker8: n 7",
    ]
    assert overlaps(Path("talk.svg").read_bytes()) == []
    assert "worker[1..38]" in here("sniff", "t.jsonl", "--format", "mermaid").out
    here("sniff", "t.jsonl", "-o", "all.svg", "--no-group")
    assert set(workers) <= set(texts_of("all.svg"))
    assert overlaps(Path("all.svg").read_bytes()) == []


def test_a_few_agents_are_a_group_where_that_is_asked_for(folder: Path, here: Here) -> None:
    write(
        Path("t.jsonl"),
        header("ann", "bob", "cid"),
        mail(1, "ann", ["bob"], 1),
        mail(2, "cid", ["bob"], 3, performative="request"),
        FINISH,
    )
    here("sniff", "t.jsonl", "-o", "talk.svg", "--group")
    assert {"robot × 3", "ann to bob: n 1", "cid to bob: n 3"} <= set(texts_of("talk.svg"))
    here("sniff", "t.jsonl", "-o", "talk.svg")
    assert {"ann", "bob", "cid"} <= set(texts_of("talk.svg"))


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--page", "a4"), "--page requires a picture"),
        (("--page", "a4", "-o", "talk.mmd"), "--page requires a picture"),
        (("--group",), "--group and --no-group require a diagram"),
        (("--no-group", "-o", "talk.txt"), "--group and --no-group require a diagram"),
    ],
)
def test_options_of_a_diagram_are_refused_for_text(
    folder: Path, here: Here, options: tuple[str, ...], words: str
) -> None:
    write(Path("t.jsonl"), header("one", "two"), mail(1, "one", ["two"], 1), FINISH)
    done = here("sniff", "t.jsonl", *options)
    assert done.code == 2 and words in done.err


def test_names_that_mean_something_to_mermaid(folder: Path, here: Here) -> None:
    said = mail(1, "end", ["r-2"], 1, content={"text": "a; b # c <d>"})
    write(Path("t.jsonl"), header("end", "r-2"), said, FINISH)
    text = here("sniff", "t.jsonl", "--format", "mermaid").out
    assert "participant agent_1 as end<br/>robot: speaker" in text
    assert "agent_1->>agent_2: 1 s inform Note (text a#59; b #35; c #lt;d#gt;)" in text


# ---- several processes, strangers ------------------------------------------------------------------


def test_the_processes_of_a_run_are_put_together(folder: Path, here: Here) -> None:
    early = header("one", clock="real", start="2026-01-01T10:00:00.000000", elsewhere=["two"])
    late = header("two", clock="real", start="2026-01-01T10:00:02.000000", elsewhere=["one"])
    got = {**mail(1.1, "two", [], 1), "kind": "received", "input": ["one", 1]}
    write(Path("a.jsonl"), early, mail(3, "one", ["two"], 1), FINISH)
    write(Path("b.jsonl"), late, got, mail(1.5, "two", ["one"], 2), FINISH)
    assert lines(here("sniff", "a.jsonl", "b.jsonl").out) == [
        "3 s one -- inform Note (n 1) --> two [talk-one-2]",
        "3.5 s two -- inform Note (n 2) --> one [talk-one-3]",
    ]
    # without the other trace, the sender is somebody else
    assert lines(here("sniff", "b.jsonl").out)[0] == "1.1 s one -- inform Note (n 1) --> two [talk-one-2]"


@pytest.mark.parametrize("knows", ["both", "one", "two", "machine"])
def test_the_clocks_of_two_machines_are_compared_by_what_was_measured(
    folder: Path, here: Here, knows: str
) -> None:
    """The dates are 10 s wrong: by them, the answer stands before the question."""
    own = {"clock": 7, "origin": 5 * 10**9}
    theirs = {"clock": 8 if knows != "machine" else 7, "origin": 107 * 10**9}
    start = "2026-01-01T10:00:00.000000"
    one = header("one", clock="real", start=start, elsewhere=["two"], machine=own)
    two = header("two", clock="real", start="2026-01-01T09:59:50.000000", elsewhere=["one"], machine=theirs)
    if knows == "machine":
        two["machine"]["origin"] = 7 * 10**9

    def measured(agent: str, peer: str, difference: int) -> dict[str, Any]:
        what = {"difference": difference * 10**9, "uncertainty": 1000}
        return {"kind": "peer", "time": 9 * 10**9, "agent": agent, "peer": peer, "what": "count", **what}

    of_one = [measured("one", "two", -100)] if knows in ("both", "one") else []
    of_two = [measured("two", "one", 100)] if knows in ("both", "two") else []
    write(Path("a.jsonl"), one, mail(3, "one", ["two"], 1), *of_one, FINISH)
    write(Path("b.jsonl"), two, mail(1.5, "two", ["one"], 2), *of_two, FINISH)
    assert [line.partition(" [")[0] for line in lines(here("sniff", "a.jsonl", "b.jsonl").out)] == [
        "3 s one -- inform Note (n 1) --> two",
        "3.5 s two -- inform Note (n 2) --> one",
    ]


def test_a_folder_stands_for_its_last_run(folder: Path, here: Here) -> None:
    """Of several processes all traces; of a project those in its output."""
    Path("build").mkdir()
    Path("pyproject.toml").write_text('[tool.asemec]\nfiles = ["t.aseme"]\noutput = "build"\n', "utf-8")
    one = header("one", clock="real", start="2026-01-01T10:00:00.000000", elsewhere=["two"])
    two = header("two", clock="real", start="2026-01-01T10:00:02.000000", elsewhere=["one"])
    write(Path("build/trace.jsonl"), header("one"), mail(9, "one", ["two"], 1), FINISH)
    write(Path("build/trace.one.jsonl"), one, mail(3, "one", ["two"], 1), FINISH)
    write(Path("build/trace.two.jsonl"), two, mail(1.5, "two", ["one"], 2), FINISH)
    os.utime("build/trace.jsonl", (1, 1))
    assert [line.split()[0] for line in lines(here("sniff", ".").out)] == ["3", "3.5"]
    os.utime("build/trace.jsonl")
    os.utime("build/trace.one.jsonl", (1, 1))
    os.utime("build/trace.two.jsonl", (1, 1))
    assert [line.split()[0] for line in lines(here("sniff", "build").out)] == ["9"]


# ---- while it is written ---------------------------------------------------------------------------


def test_a_run_is_followed_from_before_its_begin_to_its_end(folder: Path) -> None:
    command = [sys.executable, "-m", "aseme_dsl", "sniff", "out/trace.jsonl", "--follow"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, encoding="utf-8") as sniffing:
        try:
            assert sniffing.stdout is not None
            Path("out").mkdir()
            part = Path("out/trace.jsonl.part")
            with part.open("w", encoding="utf-8") as file:
                text = json.dumps(mail(1, "one", ["two"], 1))
                file.write(f"{json.dumps(header('one', 'two'))}\n{text[:40]}")
                file.flush()
                time.sleep(0.3)
                file.write(f"{text[40:]}\n")
                file.flush()
                assert lines(sniffing.stdout.readline()) == [
                    "1 s one -- inform Note (n 1) --> two [talk-one-2]"
                ]
                file.write(f"{json.dumps(mail(2, 'two', ['one'], 2))}\n{json.dumps(FINISH)}\n")
            part.replace("out/trace.jsonl")
            assert "2 s two" in " ".join(sniffing.stdout.read().split())
            assert sniffing.wait(60) == 0
        finally:
            sniffing.kill()


@pytest.mark.parametrize("name", ["talk.jsonl", "talk.jsonl.gz"])
def test_each_record_is_followed_once_however_the_file_grows(
    name: str, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(trace_gzip, "BLOCK", 2000)
    said = [header("one"), *(mail(number, "one", ["two"], number) for number in range(100)), FINISH]
    file = format_for(Path(name), Path(f"{name}.part"))
    follower = TraceFollower(Path(name))
    seen: list[object] = []
    for number, record in enumerate(said):
        file.put([json.dumps(record)])
        if number % 3 == 0:
            file.flush()
            seen += follower.poll()
            assert seen == said[: number + 1]
    file.finish()
    Path(f"{name}.part").replace(name)
    seen += follower.poll()
    assert seen == said and follower.finished
    assert list(follower.poll()) == []
    follower.close()


def test_what_another_program_has_compressed_cannot_be_followed(folder: Path, here: Here) -> None:
    Path("talk.jsonl.gz").write_bytes(gzip.compress(f"{json.dumps(header('one'))}\n".encode()))
    assert "compressed by another program: it cannot be followed" in here("sniff", "talk.jsonl.gz", "-f").err


WAIT = """
from pathlib import Path
class CarryOut:
    def execute(self, context):
        while not Path("seen").exists():
            context.wait(0.05)
"""


def test_a_run_is_followed_from_before_its_folder(
    folder: Path, here: Here, monkeypatch: pytest.MonkeyPatch
) -> None:
    def begin(_: float) -> None:
        """While nobody looks, the run begins, and ends."""
        Path("out").mkdir()
        write(Path("out/trace.jsonl"), header("one", "two"), mail(1, "one", ["two"], 1), FINISH)

    monkeypatch.setattr("aseme_dsl.cli.sniff.time", SimpleNamespace(sleep=begin))
    done = here("sniff", "out", "--follow")
    assert lines(done.out) == ["1 s one -- inform Note (n 1) --> two [talk-one-2]"], done.err


def test_a_team_that_runs_is_followed(run: Path) -> None:
    """In real time: what is said is seen before the run is over."""
    Path("activities/carry_out.py").write_text(WAIT, "utf-8")
    (run / "trace.jsonl.gz").unlink()
    asemec = [sys.executable, "-m", "aseme_dsl"]
    command = [*asemec, "run", "kitchen.aseme", "--activities", "activities", "--real", "-q"]
    playing = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    sniffing = subprocess.Popen([*asemec, "sniff", "out", "-f"], stdout=subprocess.PIPE, encoding="utf-8")
    watch = threading.Timer(300, lambda: (playing.kill(), sniffing.kill()))
    watch.start()
    try:
        assert sniffing.stdout is not None
        assert "cfp Job" in sniffing.stdout.readline()
        assert playing.poll() is None
        Path("seen").touch()
        assert "failure Outcome" in sniffing.stdout.read()
        assert sniffing.wait(60) == 0
    finally:
        watch.cancel()
        for process in (playing, sniffing):
            process.kill()
            process.wait(60)
        assert sniffing.stdout is not None
        sniffing.stdout.close()


# ---- what cannot be shown --------------------------------------------------------------------------


def test_what_cannot_be_shown_is_said(folder: Path, here: Here) -> None:
    assert "there is no file no.jsonl" in here("sniff", "no.jsonl").err
    Path("torn.jsonl.part").write_text(
        f"{json.dumps(header('one'))}\n{json.dumps(mail(1, 'one', [], 1))}\n", "utf-8"
    )
    torn = here("sniff", "torn.jsonl")
    assert torn.code == 1 and "did not come to its end" in torn.err
    assert lines(torn.out) == ["1 s one -- inform Note (n 1) --> nobody [talk-one-2]"]
    write(Path("t.jsonl"), header("one"), FINISH)
    assert "use .svg, .mmd or .txt" in here("sniff", "t.jsonl", "-o", "t.gif").err
    assert "--each requires -o" in here("sniff", "t.jsonl", "--each").err
    assert "--follow prints text" in here("sniff", "t.jsonl", "-f", "-o", "t.svg").err
    assert here("sniff", "t.jsonl").out == "no agent messages in this trace\n"


def test_what_agents_of_others_say_is_shown(folder: Path, here: Here) -> None:
    """Also what means nothing, of which no line tells that it came."""
    write(
        folder / "trace.jsonl",
        header("ann"),
        {
            "kind": "unexpected",
            "time": 1_000_000_000,
            "agent": "ann",
            "input": ["guest@home", 1],
            "performative": "shout",
            "sender": "guest@home",
            "conversation": "c1",
            "content": "soup!",
            "reason": "FIPA has no performative shout",
        },
        {
            "kind": "conversation",
            "time": 2_000_000_000,
            "agent": "ann",
            "what": "join",
            "conversation": "c2",
            "protocol": "contract_net",
            "participant": "manager",
            "branch": "0.1",
        },
        {"kind": "finish", "time": 3_000_000_000, "reason": "idle", "agents": []},
    )
    assert lines(here("sniff", "trace.jsonl").out) == [
        "1 s guest@home -- shout (soup!) --> ann [c1]",
        "1 s ann ! did not expect shout: FIPA has no performative shout [c1]",
    ]
    assert "contract_net 0 1 0 0" in " ".join(here("trace", "trace.jsonl").out.split())
