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


@pytest.mark.parametrize(
    ("action", "reason"),
    [
        ("remove(xs[4])", "list xs of 1 elements has no element 4"),
        ("remove(xs[0 - 1])", "list xs of 1 elements has no element -1"),
        ("xs[1] = 3", "list xs of 1 elements has no element 1"),
        ("xs[0 - n] = 3", "list xs of 1 elements has no element -7"),
    ],
)
def test_an_element_that_is_not_there_fails_the_state(play: Play, action: str, reason: str) -> None:
    run = after(play, f"append(xs, 5); {action}")
    assert reason in str(run.last.failure)
    assert run.variable("xs") == (5,)


def test_an_element_is_set(play: Play) -> None:
    run = after(play, "xs = [1, 2]; xs[1] = n; xs[0] += 4; d = [1]; d[0] = n")
    assert (run.variable("xs"), run.variable("d")) == ((5, 7), (7.0,))


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


@pytest.mark.parametrize(
    ("actions", "number"),
    [
        ("xs = [4, 5, 4]; n = find(xs, 4)", 0),
        ("xs = [4, 5]; n = find(xs, n - 2)", 1),
        ("d = [1, 2.5]; n = find(d, 1)", 0),
        ("ys = [3, 1]; append(xs, 6); n = find(ys, 1); xs[find(xs, 6)] = 0", 1),
    ],
)
def test_an_element_is_found(play: Play, actions: str, number: int) -> None:
    assert after(play, actions).variable("n") == number


@pytest.mark.parametrize("action", ["n = find(xs, 9)", "remove(xs[find(xs, 9)])", "xs[find(xs, 9)] = 1"])
def test_what_is_not_found_is_absent(play: Play, action: str) -> None:
    """ "It is absent where there is none." An action that needs it is not done."""
    run = after(play, f"xs = [1]; {action}; append(xs, 2)")
    assert (run.variable("n"), run.variable("xs"), run.active) == (7, (1, 2), ["B"])
    assert [line for line in run.did if line.startswith("fault")]


def with_messages(play: Play, actions: str, condition: str = "n == 9") -> Run:
    """An agent that has got a message on `t.state.M`, and is in B after these actions."""
    run = play(
        "message Inner { int y  optional int z } message Big { int x  Inner inner  repeated int many }"
        " srm R { var m : M  var o : M  var b : Big  var q : list[2] of M  var n : int = 7"
        " var bs : list of Big"
        " liveness { R = A . B . C }"
        f" control R {{ enter B : / {actions} enter C : when [{condition}] }} }}"
    ).step()
    return run.step(run.heard("t.state.M", x=3, s="a"), run.done("A"))


def test_a_variable_holds_a_message(play: Play) -> None:
    run = with_messages(play, "m = t.state.M; o = m; n = o.x", 'm.x == 3 && o.s == "a" && has(m)')
    assert (run.variable("n"), run.active) == (3, ["C"])


def test_a_message_stays_when_another_comes(play: Play) -> None:
    run = with_messages(play, "m = t.state.M", "m.x == 3 && t.state.M.x == 4")
    run.step(run.heard("t.state.M", x=4))
    assert run.active == ["C"]


@pytest.mark.parametrize("condition", ["m.x != 3", "!(m.x == 3)", "m.on", "has(m)", "size(q) > 0 && m.x < 9"])
def test_a_variable_without_a_message_is_absent(play: Play, condition: str) -> None:
    run = with_messages(play, "n = m.x; o = m", condition)
    assert (run.active, run.variable("n"), run.variable("o")) == (["B"], 7, None)
    assert [line for line in run.did if line.startswith("fault")]


@pytest.mark.parametrize(
    ("condition", "holds"),
    [
        ("contains(q.x, 3)", True),
        ("contains(q.x, 4)", False),
        ("!contains(q.x, 4)", True),
        ('find(q.s, "a") == 0', True),
        ("find(q.x, 4) < 9", False),
        ("!(find(q.x, 4) < 9)", False),
        ("q[find(q.x, n - 1)].s == m.s", True),
        ("contains(bs.inner.y, 8) && find(bs.inner.z, 1) == 1", True),
        ("contains(bs.inner.z, 0)", False),
        ("contains(bs.inner, bs[1].inner)", True),
        ("find(bs[1].many, 5) == 1", True),
    ],
)
def test_an_element_is_found_by_a_member(play: Play, condition: str, holds: bool) -> None:
    """ "An element without an optional member f equals nothing." """
    made = "Big { inner = Inner { y = 7 }, .. }", "Big { many = [4, 5], inner = Inner { y = 8, z = 1 }, .. }"
    actions = f"m = t.state.M; append(q, m); n = 4; append(bs, {made[0]}); append(bs, {made[1]})"
    run = with_messages(play, actions, condition)
    assert run.active == (["C"] if holds else ["B"])


def test_a_variable_is_emptied(play: Play) -> None:
    """ "After `clear(m)` it holds nothing again." """
    actions = "m = t.state.M; o = m; clear(m); n = o.x"
    run = with_messages(play, actions, "!has(m) && has(o) && n == 3")
    assert (run.active, run.variable("m")) == (["C"], None)
    run = with_messages(play, "m = t.state.M; clear(m)", "m.x == 3 || m.x != 3")
    assert run.active == ["B"]


def test_a_list_of_messages(play: Play) -> None:
    actions = "append(q, t.state.M); append(q, q[0]); m = q[1]; remove(q[0]); q[0] = t.state.M"
    run = with_messages(play, actions, "size(q) == 1 && q[0].x == 3 && q[0].s == m.s")
    assert run.active == ["C"]


def test_a_list_of_messages_is_full(play: Play) -> None:
    run = with_messages(play, "append(q, t.state.M); append(q, t.state.M); append(q, t.state.M)")
    assert "list q of at most 2 elements cannot have 3" in str(run.last.failure)


@pytest.mark.parametrize(
    ("actions", "published"),
    [
        ("write_messages.t.data.M { ..m }", "{x=3 s=a}"),
        ("write_messages.t.data.M { x = 5, ..m }", "{x=5 s=a}"),
        ("t.data.M.x = 5; t.data.M = m; write_messages.t.data.M", "{x=3 s=a}"),
        ("t.data.M = m; t.data.M.x = n; write_messages.t.data.M", "{x=7 s=a}"),
    ],
)
def test_a_message_of_a_variable_is_published(play: Play, actions: str, published: str) -> None:
    run = with_messages(play, f"m = t.state.M; {actions}")
    assert f"publish t.data.M {published}" in run.did


def test_nothing_fills_a_draft_from_a_variable_without_a_message(play: Play) -> None:
    run = with_messages(play, "t.data.M = m; write_messages.t.data.M")
    assert "publish t.data.M {}" in run.did
    assert [line for line in run.did if line.startswith("fault")]


@pytest.mark.parametrize(
    ("actions", "condition"),
    [
        ('m = M { x = n, s = "b", .. }', 'm.x == 7 && m.s == "b" && !m.on'),
        ("m = M { x = 1, ..t.state.M }", 'm.x == 1 && m.s == "a" && t.state.M.x == 3'),
        ("append(q, M { .. }); q[0] = M { x = n > 1 ? 5 : 6, ..t.state.M }", "q[0].x == 5"),
        ("b = Big { many = [n, 2], .. }; b = Big { x = size(b.many), ..b }", "b.many[0] == 7 && b.x == 2"),
        ("b = Big { inner.y = 4, .. }; b = Big { inner = b.inner, .. }", "b.inner.y == 4"),
        ("b = Big { inner = Inner { y = 2 }, inner.z = 3, .. }", "b.inner.y == 2 && b.inner.z == 3"),
    ],
)
def test_a_message_is_made(play: Play, actions: str, condition: str) -> None:
    run = with_messages(play, actions, condition)
    assert (run.active, [line for line in run.did if line.startswith("fault")]) == (["C"], [])


@pytest.mark.parametrize(
    ("actions", "condition"),
    [
        ("m = t.state.M; o = M { ..m }", "m == o && m == t.state.M && !(m != o)"),
        ("m = t.state.M; o = M { x = 4, ..m }", "m != o && !(m == o) && o == M { x = 4, ..m }"),
        (
            "append(q, M { x = 1, .. }); append(q, t.state.M)",
            "contains(q, t.state.M) && !contains(q, M { .. })",
        ),
        (
            "append(q, M { x = 1, .. }); append(q, t.state.M); remove(q, t.state.M)",
            "size(q) == 1 && q[0].x == 1",
        ),
        ("b = Big { many = [1], .. }", "b == Big { many = [1], .. } && b != Big { many = [1, 2], .. }"),
        ("m = n > 3 ? t.state.M : o; o = n > 9 ? o : m", "o.x == 3 && m == o"),
    ],
)
def test_messages_are_compared_member_by_member(play: Play, actions: str, condition: str) -> None:
    run = with_messages(play, actions, condition)
    assert (run.active, [line for line in run.did if line.startswith("fault")]) == (["C"], [])


def test_what_is_absent_is_neither_equal_nor_different(play: Play) -> None:
    assert with_messages(play, "m = t.state.M", "m == o || m != o || o == o").active == ["B"]


def test_no_message_is_made_of_what_is_absent(play: Play) -> None:
    run = with_messages(play, "o = M { x = m.x, .. }; o = M { x = 1, ..m }; n = 1")
    assert (run.variable("o"), run.variable("n")) == (None, 1)
    assert len([line for line in run.did if line.startswith("fault")]) == 1
