"""Values of enums and other types that activities write: in scenarios, runs, replays and proofs."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import Here

PAINTS = """\
system Paints
enum Colour { RED GREEN BLUE }
message Tin { Colour colour }
message Pot { Tin tin  repeated Colour more  optional Colour lid }
topic shop { state Pot }
srm boss {
  var colour : Colour         = Colour.RED
  var more   : list of Colour = []
  var half   : double         = 0
  var parts  : list of double = []
  var wait   : duration       = 1s
  var friend : agent
  liveness { boss = Give . (Rest | Wait) }
  activities {
    Give takes 1s writes shop.state.Pot, colour, more, half, parts, wait, friend
    Rest waits
    Wait waits
  }
  let is_green = colour == Colour.GREEN
  control boss {
    enter Rest : [is_green || shop.state.Pot.tin.colour == Colour.BLUE]
    enter Wait : else
  }
}
team T { boss, other : boss }
"""

WRITTEN = {
    "colour = Colour.GREEN": "colour == Colour.GREEN",
    "more = [Colour.GREEN, Colour.BLUE]": "size(more) == 2 && more[1] == Colour.BLUE",
    "half = 0.5": "half == 0.5",
    "parts = [1, 2.5]": "size(parts) == 2 && parts[0] == 1.0",
    "wait = 3s": "wait == 3s",
}
"""What an activity sets in a scenario, with what is true then."""


@pytest.mark.parametrize("hand", ["", "stepwise"])
@pytest.mark.parametrize("given", WRITTEN)
def test_a_scenario_sets_variables_of_all_types(here: Here, folder: Path, given: str, hand: str) -> None:
    line = f"at 1s boss ends Give sets {given}" if hand else f"activity Give takes 1s sets {given}"
    scenario = f"  boss : boss\n  {hand}\n  {line}\n  at 2s boss has "
    (folder / "a.aseme").write_text(
        f'{PAINTS}scenario "met" {{\n{scenario}[{WRITTEN[given]}]\n}}\n'
        f'scenario "not met" {{\n{scenario}[!({WRITTEN[given]})]\n}}\n'
    )
    done = here("test", "a.aseme", "--traces", "traces", "--json")
    assert [item["verdict"] for item in done.json["scenarios"]] == ["passed", "failed"], done.out
    again = here("replay", "traces/not-met.jsonl.gz")
    assert again.code == 0, again.err


def test_a_table_has_constants_of_enums(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(
        PAINTS + 'scenario "rows" {\n  boss : boss\n'
        "  table (c, state) { (Colour.GREEN, Rest) (Colour.BLUE, Wait) }\n"
        "  activity Give takes 1s sets colour = c\n  by 2s boss in state\n  by 2s boss has [colour == c]\n}\n"
    )
    done = here("test", "a.aseme")
    assert done.code == 0, done.out


CODE = """\
from aseme_dsl.runtime.activity.activities import Activity
from monas.Paints.messages import Colour, Pot, Tin


class Give(Activity):
    def execute(self, context):
        yield 1.0
        context.publish("shop.state.Pot", Pot(Tin(Colour.BLUE), (Colour.GREEN,), Colour.RED))
        context.set_variable("colour", Colour.GREEN)
        context.set_variable("more", [Colour.GREEN, Colour.BLUE])
        context.set_variable("half", 2.5)
        context.set_variable("parts", [1, 2.5])
        context.set_variable("wait", 3)
        context.set_variable("friend", context.agent)
"""


def test_what_code_writes_is_replayed(here: Here, folder: Path) -> None:
    (folder / "a.aseme").write_text(PAINTS)
    (folder / "code").mkdir()
    (folder / "code" / "give.py").write_text(CODE)
    assert here("run", "a.aseme", "--activities", "code", "-o", "out", "--allow", "waiting").code == 0
    again = here("replay", "out")
    assert again.code == 0, again.out + again.err


def test_an_enum_that_a_function_gives_is_played(here: Here, folder: Path) -> None:
    (folder / "choice.py").write_text("def pick():\n    return 0\n")
    (folder / "a.aseme").write_text(
        'system Pick\nenum Colour { RED GREEN BLUE }\nfunction pick() : Colour = "choice:pick"\n'
        "srm robot {\n  liveness { robot = (A | B) . C~ }\n"
        "  control robot { enter A : [pick() == Colour.BLUE]  enter B : else }\n}\n"
        'team T { robot : robot }\nproperty "no A" { never robot in A }\n'
    )
    done = here("prove", "a.aseme", "no A", "--save", "found.aseme")
    assert "REFUTED   no A" in done.out, done.out
    assert "pick() is BLUE" in done.out
    played = here("test", "found.aseme", "--json")
    assert [item["verdict"] for item in played.json["scenarios"]] == ["failed"], played.out


def test_enums_of_a_counterexample_are_played(here: Here, folder: Path) -> None:
    text = PAINTS.replace(", more", "").replace(", parts", "")
    (folder / "a.aseme").write_text(
        text + 'property "no green" { never boss in Rest and boss has [colour == Colour.GREEN] }\n'
        'property "no blue" { never boss in Rest and boss has [shop.state.Pot.tin.colour == Colour.BLUE] }\n'
    )
    done = here("prove", "a.aseme", "no green", "no blue", "--save", "found.aseme")
    for name in ("no green", "no blue"):
        assert f"REFUTED   {name}" in done.out, done.out
    played = here("test", "found.aseme", "--json").json
    assert {item["verdict"] for item in played["scenarios"]} == {"failed"}
