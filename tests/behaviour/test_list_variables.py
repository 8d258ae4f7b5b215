"""Variables that are lists: what actions make of them, and what conditions read (semantics, "Lists")."""

from __future__ import annotations

import pytest

from tests.behaviour.conftest import Play
from tests.behaviour.running import Run


def after(play: Play, actions: str, more: str = "") -> Run:
    """An agent in B that has done these actions on the way."""
    run = play(
        "srm R { var xs : list[3] of int  var ys : list of int  var d : list of double  var n : int = 7"
        f" liveness {{ R = A . B . C }} control R {{ enter B : / {actions} {more} }} }}"
    ).step()
    return run.step(run.done("A"))


@pytest.mark.parametrize(
    ("actions", "expected"),
    [
        ("append(xs, 1)", (1,)),
        ("append(xs, 1); append(xs, n)", (1, 7)),
        ("xs = [1, 2, 1]; remove(xs, 1)", (2, 1)),
        ("xs = [1, 2]; remove(xs, 5)", (1, 2)),
        ("xs = [1, 2, 3]; remove(xs[1])", (1, 3)),
        ("xs = [1]; xs = []", ()),
    ],
)
def test_an_action_changes_a_list(play: Play, actions: str, expected: tuple[int, ...]) -> None:
    assert after(play, actions).variable("xs") == expected


def test_a_list_is_copied(play: Play) -> None:
    """A change of one variable is no change of another one that got its list."""
    run = after(play, "append(xs, 1); ys = xs; append(xs, 2); append(ys, 3)")
    assert (run.variable("xs"), run.variable("ys")) == ((1, 2), (1, 3))


def test_an_element_that_is_not_there_is_not_removed(play: Play) -> None:
    run = after(play, "append(xs, 1); remove(xs[4]); remove(xs[0 - 1]); append(xs, 2)")
    assert run.variable("xs") == (1, 2)
    assert [line for line in run.did if line.startswith("fault")]


def test_ints_among_doubles(play: Play) -> None:
    run = after(play, "append(d, 1); append(d, 0.5); append(d, n)")
    assert run.variable("d") == (1.0, 0.5, 7.0)


def test_a_list_that_is_full_fails_the_state(play: Play) -> None:
    run = after(play, "xs = [1, 2, 3]; append(xs, 4)")
    assert "list xs of at most 3 elements cannot have 4" in str(run.last.failure)
    assert run.variable("xs") == (1, 2, 3)


def test_a_condition_reads_it(play: Play) -> None:
    """ "its own region knows the new value immediately" """
    conditions = "enter C : when [size(xs) == 2 && contains(xs, 7) && xs[1] == 7]"
    assert after(play, "xs = [1]; append(xs, 7)", conditions).active == ["C"]


def test_another_region_sees_the_list_in_the_next_step(play: Play) -> None:
    run = play(
        "srm R { var xs : list of int  liveness { R = first || second  first = A . B  second = C . D }"
        " control R { } control first { enter B : / append(xs, 1) }"
        " control second { enter D : when [size(xs) > 0] } }".replace("control R { }", "")
    ).step()
    run.step(run.done("A"))
    run.step()
    assert run.active == ["B", "D"]
