"""`asemec prove` with numbers that activities decide, and that a program compares with what it counts."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.support import Here

ROBOT = """\
system S
message Ball {{ double x }}
topic field {{ state Ball }}
srm robot {{
  var wanted : int    = 1
  var more   : int    = 1
  var limit  : double = 3
  var done   : int    = 0
  liveness {{ robot = Plan . Work+ . Rest . End }}
  activities {{ Plan takes 1s writes wanted, more  Work takes 1s  Rest takes 1s  End waits }}
  control robot {{
    repeat Work : [{repeats}] / done = done + 1
    enter Rest : else
    enter End : when [{ends}]
  }}
}}
"""

BOUNDED = """\
system S
srm robot {
  var n : int 0..3
  liveness { robot = Count . (Few | Many) }
  activities { Count writes n }
  control robot {
    enter Few : [n + n < 5 && n != 9]
    enter Many : [n == 2 || n + n > 5]
  }
}
"""
"""One state is reached only if a sum is great, which it is with the greatest value of the variable."""

ONE_OF_MANY = """\
system S
srm robot {{
  var n : int {bounds} = 8
  liveness {{ robot = Think . (Run | Rest) }}
  activities {{ Think writes n }}
  control robot {{ enter Run : [n == 8]  enter Rest : else }}
}}
"""


@pytest.mark.parametrize(
    ("repeats", "ends", "deadlock"),
    [
        pytest.param("done < wanted && done < 3", "done >= 0", "PROVED", id="what is counted is compared"),
        pytest.param("done < 3", "done < wanted || done >= wanted", "PROVED", id="one of two is always true"),
        pytest.param("done < 3", "wanted < more || more <= wanted", "PROVED", id="numbers are compared"),
        pytest.param("done < 3", "wanted + 2 > wanted", "PROVED", id="one is more than the other by so much"),
        pytest.param("done < wanted && done < 3", "done >= wanted", "REFUTED", id="it may be more than 3"),
        pytest.param("done < 3", "wanted + 1 < wanted", "REFUTED", id="it is never less"),
        pytest.param("done < 3", "wanted < done && done < wanted", "REFUTED", id="it is never both"),
        pytest.param("done < 3", "wanted + more > done", "REFUTED", id="the sum may be small"),
        pytest.param("done < 3", "wanted + more > 5 || wanted + more <= 5", "UNDECIDED", id="of a sum"),
        pytest.param("done < 3", "wanted * more >= 0 || done > 0", "UNDECIDED", id="of a product"),
    ],
)
def test_a_wait_for_a_number(here: Here, folder: Path, repeats: str, ends: str, deadlock: str) -> None:
    (folder / "team.aseme").write_text(ROBOT.format(repeats=repeats, ends=ends))
    found = here("prove", "team.aseme", "deadlock", "failures").out.splitlines()
    verdicts = {line.split()[1]: line for line in found if line.split()[1:2] in (["deadlock"], ["failures"])}
    assert verdicts["deadlock"].split()[0] == deadlock, found
    assert verdicts["failures"].split()[0] == "PROVED", found
    if deadlock == "PROVED":
        assert " in 0, 1" not in verdicts["deadlock"]


def test_a_heating_keeps_to_half_a_degree(here: Here, folder: Path) -> None:
    text = ROBOT.format(
        repeats="has(field.state.Ball) && field.state.Ball.x < limit - 0.5 && done < 2", ends="done >= 0"
    )
    (folder / "team.aseme").write_text(text + 'property "p" { never robot has [done > 3] }\n')
    found = here("prove", "team.aseme", "deadlock", "dead states", "failures")
    assert [line.split()[0] for line in found.out.splitlines()] == ["PROVED"] * 3, found
    assert found.code == 0


def test_what_is_written_into_a_text_stays_undecided(here: Here, folder: Path) -> None:
    """A text has digits of a number, and the program compares the text."""
    text = ROBOT.format(repeats="done < 2", ends='listed(who, wanted) != "" || done < wanted')
    text = text.replace("srm robot {", 'srm robot {\n  var who : string = "x"')
    listed = "function listed(string all, double number) : string"
    text = text.replace("message Ball", f'{listed} = "aseme_dsl.runtime.library.agents:_of"\nmessage Ball')
    (folder / "team.aseme").write_text(text)
    found = here("prove", "team.aseme", "deadlock")
    assert "Traceback" not in found.out + found.err
    assert not found.out.startswith("PROVED")


def test_only_what_a_variable_can_hold_is_tried_and_its_bounds_are(here: Here, folder: Path) -> None:
    (folder / "team.aseme").write_text(BOUNDED)
    found = here("prove", "team.aseme", "dead states").out
    assert found.startswith("PROVED    dead states of team [1 robot; any delay; n in 0, 2, 3; "), found


@pytest.mark.parametrize("bounds", ["8..20", "0..8"])
def test_of_the_numbers_that_are_alike_one_is_tried_that_the_variable_can_hold(
    here: Here, folder: Path, bounds: str
) -> None:
    text = ONE_OF_MANY.format(bounds=bounds)
    (folder / "team.aseme").write_text(text)
    found = here("prove", "team.aseme", "dead states")
    assert found.out.startswith("PROVED    dead states of team [1 robot; any delay; "), found
    assert " in " not in found.out
