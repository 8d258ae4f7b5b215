"""Listeners: who listens to a trace, and that its lines are the same whoever does."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from aseme_dsl.runtime import Setup, Team, read_inputs
from tests.runtime.playing import check_line
from tests.support.generated import generate

TEXT = """
    system S
    message M { int n  string s  bool b  double d  optional int o }
    topic t { state M  signal M }
    srm R {
      liveness { R = (A . [B])+ }
      activities { A every 50ms takes 10ms  B takes 5ms  }
      control R {
        enter B : [t.state.M.n > 2] / t.signal.M.s = "\\"ü\\" and 1 < 2"; write_messages.t.signal.M
        skip B : else
        repeat (A . [B]) : [abs(t.state.M.d) < 5]
        leave (A . [B]) : [t.state.M.b]
      }
    }
    team T { ann, bob : R }
"""
SCRIPT = [
    {"at": "0ms", "channel": "t.state.M", "message": {"n": 1}},
    {"at": "120ms", "channel": "t.state.M", "message": {"n": 3, "d": -1.5, "o": 4}},
    {"at": "300ms", "channel": "t.state.M", "message": {"n": 3, "d": 7.25, "b": True, "s": "fin"}},
]


class Choosy:
    """Listens to steps, and to the ends of activities."""

    def __init__(self) -> None:
        self.asked: list[tuple[str, str | None]] = []
        self.records: list[dict[str, Any]] = []

    def wants(self, kind: str, what: str | None) -> bool:
        self.asked.append((kind, what))
        return kind == "step" or (kind, what) == ("activity", "end")

    def __call__(self, record: dict[str, Any]) -> None:
        self.records.append(record)


def run(path: Path | None, *listeners: Any) -> None:
    generated = generate(TEXT)
    messages = {name: kind for name, kind in vars(generated.messages).items() if isinstance(kind, type)}
    Team(
        [(name, generated.charts[role]) for name, role in generated.package.TEAM],
        {},
        Setup(
            messages=messages,
            timed_inputs=read_inputs([json.dumps(line) for line in SCRIPT], messages),
            trace=path,
            listeners=listeners,
            until_ns=1_000_000_000,
            path=[generated.folder],
        ),
    ).run()


def test_the_lines_are_the_same_whoever_listens(tmp_path: Path) -> None:
    """Lines that nobody listens to are put together by hand: not a byte may differ."""
    records: list[dict[str, Any]] = []
    run(tmp_path / "alone.jsonl")
    run(tmp_path / "heard.jsonl", records.append)
    run(tmp_path / "chosen.jsonl", Choosy())
    alone = (tmp_path / "alone.jsonl").read_bytes()
    assert alone == (tmp_path / "heard.jsonl").read_bytes() == (tmp_path / "chosen.jsonl").read_bytes()
    lines = [json.loads(line) for line in alone.splitlines()]
    assert lines == records
    for line in lines:
        check_line(line)
    assert {line["kind"] for line in lines} >= {"header", "message", "activity", "step", "finish"}


def test_a_listener_is_shown_only_what_it_wants() -> None:
    choosy, records = Choosy(), list[dict[str, Any]]()
    run(None, records.append, choosy)
    wanted = [r for r in records if r["kind"] == "step" or r.get("what") == "end"]
    assert choosy.records == wanted
    assert any(record["kind"] == "message" for record in records)


def test_a_listener_is_asked_once_for_each_kind() -> None:
    choosy = Choosy()
    run(None, choosy)
    assert len(choosy.asked) == len(set(choosy.asked))
