"""Lists in expressions: elements, sizes, what is contained and what is written out (semantics, "Lists")."""

from __future__ import annotations

import pytest

from aseme_dsl.runtime.chart.inputs import Publication
from tests.behaviour.conftest import Play
from tests.behaviour.running import Run

WORLD = """
message Item { string name  int weight  optional int mark  repeated int codes }
message Stock { repeated Item items  repeated int many  repeated double levels  repeated Colour colours }
topic s { state Stock  signal Stock  data Stock }
"""


def choosing(play: Play, condition: str, variables: str = "") -> Run:
    """An agent that is in A and goes to B as soon as the condition holds."""
    run = play(
        f"{WORLD} srm R {{ {variables} liveness {{ R = A . B }} control R {{ enter B : {condition} }} }}"
    )
    run.step()
    return run.step(run.done("A"))


def goes(run: Run, **members: object) -> bool:
    """Whether it goes on when the message comes."""
    run.step(run.heard("s.state.Stock", **members))
    return run.active == ["B"]


@pytest.mark.parametrize(
    ("index", "many", "found"),
    [
        ("0", (5,), True),
        ("1", (4, 5), True),
        ("1", (5, 4), False),
        ("n", (4, 4, 5), True),
        ("n - 2", (5,), True),
    ],
)
def test_an_element_is_chosen_by_its_number_from_0(
    play: Play, index: str, many: tuple[int, ...], found: bool
) -> None:
    """ "`x.items[i]` is the element with the number i; the first has the number 0" """
    run = choosing(play, f"[s.state.Stock.many[{index}] == 5]", "var n : int = 2")
    assert goes(run, many=many) is found


@pytest.mark.parametrize("index", ["3", "n", "n - 10", "0 - 1"])
def test_there_is_nothing_before_the_first_and_behind_the_last(play: Play, index: str) -> None:
    """ "absent where i is negative or not less than the size": nothing of it holds, and it is no fault"""
    member = f"s.state.Stock.many[{index}]"
    run = choosing(play, f"[{member} == 5 || {member} != 5]", "var n : int = 3")
    assert not goes(run, many=(5, 5, 5))
    assert not [line for line in run.did if line.startswith("fault")]


def test_a_list_is_absent_with_its_message(play: Play) -> None:
    """ "… and where the list is absent" """
    size = "size(s.state.Stock.many)"
    run = choosing(play, f"[{size} >= 0 || !contains(s.state.Stock.many, 1)]")
    assert run.active == ["A"]
    assert goes(run)


@pytest.mark.parametrize(("many", "size"), [((), 0), ((7,), 1), ((7, 7, 7), 3)])
def test_the_size_of_a_list(play: Play, many: tuple[int, ...], size: int) -> None:
    """ "`size(x.items)` is how many elements it has, 0 where nothing was filled" """
    assert goes(choosing(play, f"[size(s.state.Stock.many) == {size}]"), many=many)


def test_what_is_contained(play: Play) -> None:
    """ "`contains(x.items, v)` is whether one of them equals v; ints are looked for among doubles, too" """
    holds = "contains(s.state.Stock.many, n) && contains(s.state.Stock.levels, n)"
    run = choosing(play, f"[{holds} && !contains(s.state.Stock.colours, Colour.RED)]", "var n : int = 2")
    assert not goes(run, many=(1, 3), levels=(2.0,))
    assert not goes(run, many=(1, 2), levels=(2.5,))
    assert goes(run, many=(1, 2), levels=(2.5, 2.0))


def test_a_member_of_an_element(play: Play) -> None:
    """ "Behind an element that is a message stands a member of it, which may be a list again" """
    run = choosing(
        play,
        '[s.state.Stock.items[1].name == "x" && size(s.state.Stock.items[1].codes) == 2 '
        "&& s.state.Stock.items[0].codes[n] == 9]",
        "var n : int = 0",
    )
    item = run.generated.messages.Item
    assert not goes(run, items=(item(codes=(9,)), item("x", codes=(1,))))
    assert not goes(run, items=(item(codes=(9,)),))
    assert goes(run, items=(item(codes=(9,)), item("x", codes=(1, 2))))


def test_an_optional_member_of_an_element(play: Play) -> None:
    """ "optional … absent where it is not there" """
    run = choosing(play, "[s.state.Stock.items[0].mark != 3]")
    item = run.generated.messages.Item
    assert not goes(run, items=(item(),))
    assert goes(run, items=(item(mark=4),))


def test_a_list_that_is_written_out(play: Play) -> None:
    """ "`[a, b]` is a list of these values" """
    run = play("""
        srm R {
          let way = [Colour.BLUE, Colour.GREEN, Colour.BLUE]
          var next : int = 2
          var c : Colour
          var n : int
          liveness { R = A . B . C }
          control R {
            enter A : / c = way[next]; n = size(way); next = next + 1
            enter B : / c = way[next]
          }
        }
    """).step()
    assert (run.variable("c"), run.variable("n")) == (2, 3)
    run.step(run.done("A"))
    assert [line.split()[0] for line in run.did] == ["fault", "start"]
    assert run.variable("c") == 2


def test_a_repeated_member_is_filled(play: Play) -> None:
    """ "A repeated member is filled with a list, as a whole" """
    run = play(f"""{WORLD}
        srm R {{
          var n : int = 3
          var m : int
          liveness {{ R = A . B . C }}
          control R {{
            enter A : / write_messages.s.state.Stock {{ levels = [1, n, 2.5], many = [n, n + 1] }};
                        m = s.state.Stock.many[1]
            enter B : / s.signal.Stock.levels = s.state.Stock.many; s.signal.Stock.colours = [];
                        write_messages.s.signal.Stock
          }}
        }}
    """).step()
    (first,) = run.last.of(Publication)
    assert (first.message.many, first.message.levels) == ((3, 4), (1.0, 3.0, 2.5))
    assert run.variable("m") == 4
    run.step(run.done("A"))
    (second,) = run.last.of(Publication)
    assert (second.message.levels, second.message.colours) == ((3.0, 4.0), ())


def test_nothing_is_filled_with_a_list_of_what_is_absent(play: Play) -> None:
    """ "It is absent where one of them is" """
    run = play(f"""{WORLD}
        srm R {{
          liveness {{ R = A . B }}
          control R {{
            enter A : / s.signal.Stock.many = [1, s.state.Stock.many[0]]; write_messages.s.signal.Stock
          }}
        }}
    """).step()
    assert [line.split()[0] for line in run.did] == ["fault", "publish", "start"]


def test_a_list_as_it_was(play: Play) -> None:
    run = choosing(play, "[at(s.data.Stock.many, -10ms)[0] == 1 && size(at(s.data.Stock.many, -10ms)) == 1]")
    run.step(run.heard("s.data.Stock", ms_ago=20, many=(1,)), run.heard("s.data.Stock", many=(2, 3)))
    assert run.active == ["B"]


def test_a_function_of_the_document_goes_before(play: Play) -> None:
    run = play("""
        function size(int n) : bool = "tests.behaviour.functions:even"
        srm R { liveness { R = A . B } control R { enter B : [size(4)] } }
    """).step()
    assert run.step(run.done("A")).active == ["B"]
