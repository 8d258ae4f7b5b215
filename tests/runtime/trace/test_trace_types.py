"""Lines of a trace are read in the same way with msgspec and without it."""

from __future__ import annotations

import json
import random
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl import outside
from aseme_dsl.runtime.trace import trace_types
from aseme_dsl.runtime.trace.trace_check import wrong_in
from aseme_dsl.runtime.trace.trace_reading import TraceReader, record_of
from aseme_dsl.runtime.trace.trace_types import beginning, decoded, is_right

pytest.importorskip("msgspec")

STEP: dict[str, Any] = {
    "kind": "step",
    "time": 1_000,
    "agent": "ann",
    "step": 2,
    "inputs": [["ann", 1], ["bob", 7]],
    "taken": [
        {"transitions": [3], "source": "0.1", "target": "0.2", "text": "[x > 1]", "into": ["0.3", "0.4"]}
    ],
    "configuration": ["0.2.1"],
    "functions": [{"function": "near", "value": 1.5}],
}
LINES: list[dict[str, Any]] = [
    STEP,
    STEP | {"again": True},
    {"kind": "message", "time": 5, "agent": "ann", "sequence": 1, "channel": "pose.data.Pose"}
    | {"message": {"x": "NaN", "y": 10**30}, "to": ["bob"], "via": "radio"},
    {"kind": "activity", "time": 5, "agent": "ann", "what": "crash", "label": "0.1", "activity": "Walk"}
    | {"token": 3, "traceback": [{"file": "a.py", "line": None, "function": "walk"}]},
    {"kind": "agent_message", "time": 7, "agent": "ann", "sequence": 3, "performative": "request"}
    | {"message": "Ball", "content": {"to": "Ä"}, "protocol": "p", "conversation": "p-1", "to": ["bob"]}
    | {"participant": "asker", "receiver": "giver"},
    {"kind": "conversation", "time": 7, "agent": "ann", "what": "open", "conversation": "p-1"}
    | {"participant": "asker", "branch": "0.2"},
    {"kind": "variable", "time": 1, "agent": "ann", "sequence": 4, "variable": "n", "value": [1, None]},
    {"kind": "gap", "time": 2, "lines": 4, "reason": "the disk is slow"},
    {"kind": "unheard of", "time": 3, "anything": {}},
]
VALUES: list[object] = [
    None, True, False, 0, -1, 1.0, 2**63, 2**64, 10**40, "", "step", "0.1", "0.1\n", "a.data.B",
    "\x00", "\ud800", float("nan"), float("inf"), [], [1], ["ann", 1], ["ann", 1, 2],
    [["ann", 0]], {}, {"x": {"y": 1}},
]  # fmt: skip


def _changed(value: Any, chance: random.Random) -> Any:
    """The same with one part of it changed."""
    parts = (
        list(value) if isinstance(value, dict) else list(range(len(value))) if isinstance(value, list) else []
    )
    if not parts or chance.random() < 0.2:
        return chance.choice(VALUES)
    place = chance.choice(parts)
    found = value.copy()
    match chance.randrange(4):
        case 0:
            del found[place]
        case 1 if isinstance(value, dict):
            found[chance.choice(["further", "into", "sequence", "what"])] = chance.choice(VALUES)
        case _:
            found[place] = _changed(found[place], chance)
    return found


def _texts() -> list[str]:
    chance = random.Random(7)
    found = [json.dumps(line, separators=(",", ":"), ensure_ascii=False) for line in LINES]
    for _ in range(3000):
        line = chance.choice(LINES)
        for _ in range(chance.randrange(1, 3)):
            line = _changed(line, chance)
            if not isinstance(line, dict):
                break
        text = json.dumps(line, separators=(",", ":"), ensure_ascii=chance.random() < 0.5)
        if chance.random() < 0.2:
            place = chance.randrange(len(text))
            text = text[:place] + chance.choice(["", "\\", '"', "\x01", ",", "[" * 200]) + text[place + 1 :]
        found.append(text)
    return found


def test_each_line_is_the_same_without_msgspec(monkeypatch: pytest.MonkeyPatch) -> None:
    texts = _texts()
    quick = [
        (decoded(text), [beginning(text, kind) for kind in ("step", "message", "activity")]) for text in texts
    ]
    records = [record_of(text) for text in texts]
    wrong = [None if record is None else wrong_in(record) for record in records]
    right = [record is not None and is_right(record, record["kind"]) for record in records]
    monkeypatch.setattr(trace_types, "_msgspec", lambda: None)
    trace_types._type_of.cache_clear()
    trace_types._reader.cache_clear()
    times = 0
    for text, (found, moments), record, what in zip(texts, quick, records, wrong, strict=True):
        assert repr(record_of(text)) == repr(record)
        assert record is None or wrong_in(record) == what
        assert found is None or repr(found) == repr(outside.loads(text, deepest=10_000))
        for kind, moment in zip(("step", "message", "activity"), moments, strict=True):
            if moment is not None:
                times += 1
                assert record is not None and moment["kind"] == kind
                names = moment.keys() | {"agent", "sequence"}
                assert moment == {name: value for name, value in record.items() if name in names}
                assert what is None
    assert not any(is_right(record, record["kind"]) for record in records if record is not None)
    trace_types._type_of.cache_clear()
    trace_types._reader.cache_clear()
    assert times > 30 and sum(right) > 50 and sum(text is not None for text in wrong) > 500


def test_lines_that_nobody_wants_are_checked(tmp_path: Path) -> None:
    header = {"kind": "header", "time": 0, "format": 2, "system": "s", "seed": 1, "clock": "virtual"}
    rest = [LINES[0], LINES[3], {"kind": "finish", "time": 9, "reason": "the end", "agents": []}]
    path = tmp_path / "trace.jsonl"
    lines = [header | {"agents": [], "names": {}}, *rest]
    path.write_text("".join(json.dumps(line, separators=(",", ":")) + "\n" for line in lines))
    reader = TraceReader(path, ["activity"])
    assert [line.record for line in reader][1:] == [
        {"kind": "step", "time": 1_000, "agent": "ann"},
        LINES[3],
        {"kind": "finish", "time": 9},
    ]
    assert reader.finished and reader.problem is None
    for wrong in ('"source":1', '"source":"x"'):
        damaged = tmp_path / "damaged.jsonl"
        damaged.write_text(path.read_text().replace('"source":"0.1"', wrong))
        with pytest.raises(Exception, match=r"2: this line of the kind 'step' is damaged: taken\.0\.source"):
            list(TraceReader(damaged, ["activity"]))
