"""Machines of XState 5, as JSON, become roles with a statechart, and play as XState does."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.interop.emf.report import Fate
from aseme_dsl.project.editing.import_models import import_models
from tests.interop.machines.playing import Imported, Player, imported

PING = {"type": "raise", "event": {"type": "PING"}}
LIGHT: dict[str, Any] = {
    "id": "light",
    "initial": "green",
    "context": {"count": 0},
    "states": {
        "green": {"after": {"1000": "yellow"}, "on": {"SOS": "#stop.blink"}},
        "yellow": {
            "on": {"TIMER": {"target": "red", "actions": {"type": "raise", "event": {"type": "PING"}}}}
        },
        "red": {
            "id": "stop",
            "initial": "walk",
            "states": {"walk": {"on": {"PING": "wait"}}, "wait": {}, "blink": {}, "off": {"type": "final"}},
            "on": {"NEXT": ".off"},
            "onDone": "green",
        },
    },
}


def machine(**states: Any) -> Imported:
    return imported("m.json", json.dumps({"initial": next(iter(states)), "states": states}))


def lines(found: Imported) -> list[str]:
    return [line.strip() for line in found.text.splitlines() if " :" in line]


def test_a_machine_plays() -> None:
    found = imported("light.json", json.dumps(LIGHT, indent=2))
    assert found.lost == ()
    player = Player(found)
    player.wait(1_000_000_000)
    assert player.active() == [{"yellow"}]
    player.send("TIMER")
    assert player.active() == [{"wait"}]  # PING was raised
    player.send("NEXT")
    assert player.active() == [{"green"}]
    player.send("SOS")
    assert player.active() == [{"blink"}]


@pytest.mark.parametrize(
    ("state", "expected"),
    [
        ({"on": {"a.b": "z"}}, "0.2 -> 0.3 : a_b"),
        ({"on": {"go": {"reenter": True, "target": "s"}}}, "0.2 -> 0.2 : go"),
        (
            {"on": {"go": {"target": "s", "actions": {"type": "raise", "event": "e"}}}},
            "on 0.2 : go / raise e",
        ),
        ({"always": "z"}, "0.2 -> 0.3 : when [true]"),
        ({"invoke": {"src": "fetch", "onDone": "z"}}, "0.2 -> 0.3 :"),
        ({"invoke": {"src": "fetch", "onError": "z"}}, "0.2 -> 0.3 : error"),
    ],
)
def test_what_becomes_what(state: dict[str, Any], expected: str) -> None:
    assert expected in lines(machine(s=state, z={"type": "final"}))


def test_an_event_of_xstate_is_not_a_prefix() -> None:
    found = machine(s={"on": {"a": "z", "a.b": "y"}}, y={}, z={})
    assert {"0.2 -> 0.4 : a", "0.2 -> 0.3 : a_b"} <= set(lines(found))


def test_a_transition_of_the_outermost_state_has_a_state_around_it() -> None:
    found = imported("m.json", json.dumps({"initial": "a", "states": {"a": {}, "b": {}}, "on": {"X": ".b"}}))
    player = Player(found)
    player.send("X")
    assert player.active() == [{"b"}]


@pytest.mark.parametrize(
    ("state", "fate", "words"),
    [
        ({"on": {"go": {"target": "s", "guard": "late"}}}, Fate.HOLE, "`late`"),
        ({"on": {"go": {"target": "s", "cond": "late"}}}, Fate.HOLE, "`late`"),
        ({"entry": "beep", "on": {"go": "s"}}, Fate.LEFT_OUT, "beep"),
        ({"after": {"DELAY": "s"}}, Fate.LEFT_OUT, "after DELAY"),
        ({"activities": "x"}, Fate.LEFT_OUT, "`activities`"),
        ({"entry": {"type": "inc", "params": {"by": 2}}, "on": {"go": "s"}}, Fate.LEFT_OUT, 'inc {"by": 2}'),
        ({"on": {"go": {"guard": {"type": "over", "params": {"n": 2}}}}}, Fate.HOLE, 'over {"n": 2}'),
        ({"invoke": {"src": "f", "onSnapshot": {"actions": "x"}}}, Fate.LEFT_OUT, "`onSnapshot`"),
        ({"exit": {**PING, "event": {"type": "PING", "at": 3}}, "on": {"go": "r"}}, Fate.LEFT_OUT, "at"),
        ({"on": {"go": {"target": "r", "description": "why"}}}, Fate.CHANGED, "`description`"),
        ({"initial": {"target": "q", "params": 3}, "states": {"q": {}}}, Fate.LEFT_OUT, "`params`"),
    ],
)
def test_what_cannot_be_said_is_named_with_its_place(state: dict[str, Any], fate: Fate, words: str) -> None:
    rows = [row for row in machine(r={"on": {"to": "s"}}, s=state).rows if row.fate is fate]
    assert any(words in f"{row.element} {row.now}" and row.place is not None for row in rows)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "ends too early"),
        ("[]", "not the configuration"),
        ('{"states": {}}', "it has no states"),
        ('{"states": {"a": 1}}', "not an object"),
        ('{"states": {"a": {"on": {"x": "b"}}}}', "there is no state `b`"),
        ('{"states": {"a": {}, "a": {}}}', "stands twice"),
        ('{"states": {"a": {"type": "odd"}}}', "not one of XState"),
        ('{"states": ' * 300, "more than 200 deep"),
        ('{"states": {"a": {}}} x', "something follows"),
        ('{"states": {"a": "\t"}}', "a text that does not end"),
    ],
)
def test_a_file_that_is_no_machine_is_refused(tmp_path: Path, text: str, reason: str) -> None:
    place = tmp_path / "m.json"
    place.write_text(text, "utf-8")
    project = import_models([place])
    assert project.files == {}
    assert reason in project.diagnostics[0].message
    assert project.diagnostics[0].span is not None


def test_several_targets_in_regions_of_one_parallel_state() -> None:
    found = machine(
        a={"on": {"GO": {"target": ["p.q.q2", "#r2"]}}},
        p={
            "type": "parallel",
            "states": {
                "q": {"initial": "q1", "states": {"q1": {}, "q2": {}}},
                "r": {"initial": "r1", "states": {"r1": {}, "r2": {"id": "r2"}}},
            },
        },
    )
    assert "0.2 -> (0.3.1.3, 0.3.2.3) : GO" in found.text
    player = Player(found)
    player.send("GO")
    assert [sorted(part)[0].rpartition(".")[2] for part in player.active()[-2:]] == ["q2", "r2"]
