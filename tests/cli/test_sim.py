"""`asemec sim`: a run goes forwards and backwards, is changed on the way, and stays the same run."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.cli import sim
from aseme_dsl.cli.stepping import WrongCommand, obey
from tests.cli.support import Here

LAMP = """\
system Lamp
message Press { bool long }
topic button { signal Press }
srm lamp {
  var presses : int 0..9
  liveness { lamp = (Dark . Bright)~ }
  activities { Dark waits  Bright takes 2s }
  control lamp {
    enter Bright : when [has(button.signal.Press)] / presses += 1
  }
}
team Home { hall : lamp  stairs : lamp }

scenario "someone comes" {
  at 1s hall receives button.signal.Press { long = false }
  for 10s
}
"""


@pytest.fixture
def lamp(here: Here, folder: Path) -> Callable[..., str]:
    """Steps through the lamp with these commands; what is printed."""

    def play(*commands: str, arguments: tuple[str, ...] = (), text: str = LAMP) -> str:
        (folder / "lamp.aseme").write_text(text)
        done = here("sim", "lamp.aseme", *arguments, input="\n".join((*commands, "")).encode())
        assert done.code in (0, 1)
        assert done.err == ""
        return done.out

    return play


def test_steps_show_what_happens(lamp: Callable[..., str], snapshot: Any) -> None:
    snapshot(lamp("step", "step", "source", "step", arguments=("-k", "someone")), "sim.steps.txt")


def test_a_scenario_with_chosen_values_and_a_longer_end(lamp: Callable[..., str]) -> None:
    scenario = """scenario "long" {
  given level in 3..9
  at 1s hall receives button.signal.Press { long = level > 5 }
  for 100s
}
"""
    said = lamp("go", arguments=("-k", "long"), text=LAMP + scenario)
    assert '{"long": false}' in said
    assert "100 s  time limit reached" in said


def test_it_goes_back_and_another_way(lamp: Callable[..., str], snapshot: Any) -> None:
    said = lamp(
        "to 5s",
        "do hall receives button.signal.Press { long = false }",
        "step",
        "show hall",
        "back",
        "do stairs receives button.signal.Press { long = true }",
        "halt stairs in Bright",
        "go",
        "clear 1",
        "go",
        "back 3",
        "add crash stairs at 5.5s",
        "to 6s",
    )
    snapshot(said, "sim.ways.txt")


@pytest.mark.parametrize(
    ("command", "answer"),
    [
        ("stpe", "'stpe' is not a command. Did you mean 'step'? See help."),
        ("step none", "'none' is not a number from 1 to 100000."),
        ("to tomorrow", "tomorrow"),
        ("clear 1", "Give the number of a halt; see halts."),
        ("do", "Say what to do; see help."),
        ("do nobody raises Alarm", "there is no agent `nobody`"),
        ("halt hall in Brihgt", "Bright"),
        ("add every morning", ""),
        ("do hall jumps", ""),
        ("save", "Say into which file"),
        ("save lamp.aseme", "lamp.aseme"),
        ("save lamp.txt", "Name a .aseme file"),
        ("save nowhere/lamp.aseme", "Name a .aseme file"),
        ("undo", "Nothing was done or added."),
        ("show nobody", "There is no agent 'nobody': hall, stairs."),
    ],
)
def test_a_wrong_command_changes_nothing(lamp: Callable[..., str], command: str, answer: str) -> None:
    said = lamp("to 2s", command, "to 2s").split("> ")
    assert answer in said[2]
    assert len(said[2].splitlines()) == 2
    assert said[3].splitlines()[-3:] == said[1].splitlines()[-3:]


def test_a_broken_expectation_is_named_and_taken_back(lamp: Callable[..., str]) -> None:
    said = lamp("add always hall in Bright", "step", "do hall raises Out", "undo", "to 2s").split("> ")
    assert "broken: always hall in Bright" in said[2]
    assert "The run is over: go back first." in said[3]
    assert said[5].splitlines()[-3] == "2 s"


def test_the_end_breaks_what_is_still_awaited(lamp: Callable[..., str]) -> None:
    assert "60 s  broken: eventually hall in Bright" in lamp("add eventually hall in Bright", "go")


def test_what_was_done_is_saved_as_a_scenario(lamp: Callable[..., str], here: Here, folder: Path) -> None:
    lamp("to 5s", "do hall receives button.signal.Press { long = false }", "add for 9s", "save late.aseme")
    assert (
        (folder / "late.aseme").read_text()
        == """\
import "lamp.aseme"

scenario "late" {
  at 5001ms hall receives button.signal.Press { long = false }
  for 9s
}
"""
    )
    assert "passed   late " in here("test", "late.aseme").out


_MOVES = st.lists(
    st.one_of(
        st.integers(1, 3).map(lambda count: f"step {count}"),
        st.integers(1, 3).map(lambda count: f"back {count}"),
        st.integers(0, 9).map(lambda moment: f"to {moment}s"),
        st.just("halt hall in Bright"),
        st.just("do stairs receives button.signal.Press { long = true }"),
    ),
    max_size=6,
)


@settings(max_examples=6, deadline=None)
@given(_MOVES)
def test_where_a_run_stands_does_not_depend_on_the_way(moves: list[str]) -> None:
    """The oracle is a run that goes there at once."""
    with stepping(LAMP) as stepper:
        for move in moves:
            with suppress(WrongCommand):  # an input at the end of the run
                list(obey(stepper, move))
        if stepper.instant.over:
            list(obey(stepper, "back"))
        with stepping(LAMP, stepper.session.statements) as other:
            other.to(stepper.instant.picture.moment)
            assert other.instant.picture == stepper.instant.picture
            assert other.instant.events == stepper.instant.events


def test_the_screen_follows_keys_and_commands() -> None:
    from textual.widgets import Input, Static

    from aseme_dsl.cli.sim_screen import Screen

    async def use(screen: Screen) -> list[str]:
        found = []
        async with screen.run_test(size=(120, 40)) as pilot:
            for key in ("f10", "f10", "f9"):
                await pilot.press(key)
                await screen.workers.wait_for_complete()
                found.append(str(screen.query_one("#where", Static).render()))
            screen.query_one(Input).value = "to 1500ms"
            await pilot.press("enter")
            await pilot.pause()
            await screen.workers.wait_for_complete()
            found.append(str(screen.query_one("#outline", Static).render()))
            found.append(str(screen.query_one("#known", Static).render()))
            found.append(str(screen.query_one("#lines", Static).render()))
        return found

    statement = "at 1s hall receives button.signal.Press { long = false }"
    with stepping(LAMP, (statement,)) as stepper:
        first, second, third, outline, known, lines = asyncio.run(use(Screen(stepper)))
    assert [text.split("   ")[0] for text in (first, second, third)] == ["1 s", "3 s", "1 s"]
    assert "▶" in outline
    assert "presses = 1" in known
    assert "liveness" in lines


def stepping(text: str, statements: tuple[str, ...] = ()) -> Any:
    """A stepper for a text, closed at the end."""
    from contextlib import contextmanager
    from tempfile import TemporaryDirectory

    @contextmanager
    def opened() -> Iterator[Any]:
        with TemporaryDirectory() as folder:
            path = Path(folder) / "lamp.aseme"
            path.write_text(text)
            with sim.stepper_for(sim.one_system(str(path), None), None, 1, None, statements) as stepper:
                yield stepper

    return opened()


def test_a_crash_is_an_instant(lamp: Callable[..., str]) -> None:
    said = lamp("add crash stairs at 5.5s", "add restart stairs at 5.7s", "to 5.4s", "step", "step")
    assert "    stairs  crashes\n5.5 s" in said, said
    assert "    stairs  starts again" in said, said


def test_of_a_table_the_first_row_is_stepped_through_and_said(here: Here, folder: Path) -> None:
    rows = 'scenario "rows" { table (d) { (true) (false) (true) }  for 1s }\n'
    (folder / "lamp.aseme").write_text(LAMP + rows)
    done = here("sim", "lamp.aseme", "-k", "rows", input=b"")
    assert "first row of its table; `asemec test` plays 2 further rows, too" in done.err, done.err
