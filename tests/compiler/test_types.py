"""What expressions mean: every case is a document, and its snapshot says what is wrong with it."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.amola import expression as amola
from aseme_dsl.amola.expression import Literal, Value, operands, value_text, walk
from aseme_dsl.amola.messages import BOOL, DOUBLE, DURATION, INT, STRING, Kind, Type
from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import render_text
from aseme_dsl.source import Source
from tests.conftest import Snapshot
from tests.support.compiling import codes, printed, system
from tests.support.expressions import typed

CASES = sorted((Path(__file__).parent / "types").glob("*.aseme"))


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.stem)
def test_diagnostics(case: Path, snapshot: Snapshot) -> None:
    snapshot(printed(case.read_text("utf-8")), f"types/{case.stem}.txt")


WORLD = """
enum Place { HOME AWAY }
message Point { double x  double y }
message Thing { bool on  int count  double level  string name  Place place  duration since  Point point }
topic s { state Thing  data Thing  signal Thing }
topic robot { state Thing }
function far(Thing thing) : bool = "m:far"
function far(double level) : bool = "m:far"
function sum(double a, double b) : double = "m:sum"
function sum(int a, int b) : int = "m:sum"
let limit = 80
let thing = s.data.Thing
let place = Place.HOME
"""


def value(text: str) -> Value:
    found, diagnostics = typed(text, WORLD)
    assert found is not None, render_text(diagnostics)
    return found


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("1 + 2", INT),
        ("1 + 2.0", DOUBLE),
        ("4 / 2", DOUBLE),
        ("4 % 3", INT),
        ("4.0 % 3", DOUBLE),
        ("1s + 200ms", DURATION),
        ("2 * 1s", DURATION),
        ("1s * 0.5", DURATION),
        ("1s / 2", DURATION),
        ("1s / 200ms", DOUBLE),
        ("-s.state.Thing.since", DURATION),
        ("1 < 2.5", BOOL),
        ('"a" < "b"', BOOL),
        ("s.state.Thing.place == place", BOOL),
        ("!(1 < 2) && true or false", BOOL),
        ("age(s.state.Thing)", DURATION),
        ("at(thing, -1s)", Type(Kind.MESSAGE, "Thing")),
        ("at(thing.point.x, -1s)", DOUBLE),
        ("mean(thing.count, 2 * 1s)", DOUBLE),
        ("max(1, 2)", INT),
        ("max(1, 2.0)", DOUBLE),
        ("abs(-1s)", DURATION),
        ("sum(1, 2)", INT),
        ("sum(1, 2.5)", DOUBLE),
        ("far(limit)", BOOL),
        ("far(thing)", BOOL),
        ("thing.point", Type(Kind.MESSAGE, "Point")),
        ("r1.s.state.Thing.name", STRING),
        ("robot.state.Thing.place", Type(Kind.ENUM, "Place")),
        ("robot.s.state.Thing.place", Type(Kind.ENUM, "Place")),
    ],
)
def test_types(text: str, expected: Type) -> None:
    assert value(text).type == expected


def test_the_first_segment_is_a_host_only_if_no_class_follows_it() -> None:
    on_topic, on_host = value("robot.state.Thing.on"), value("robot.s.state.Thing.on")
    assert isinstance(on_topic, amola.Member) and isinstance(on_host, amola.Member)
    assert (on_topic.host, on_topic.channel.topic) == (None, "robot")
    assert (on_host.host, on_host.channel.topic) == ("robot", "s")


def test_a_let_keeps_its_name_and_a_member_of_it_is_the_messages() -> None:
    assert value_text(value("limit + 1")) == "limit + 1"
    assert value_text(value("limit + 1"), expand=True) == "80 + 1"
    assert value_text(value("thing.count > limit")) == "s.data.Thing.count > limit"


def test_what_at_and_mean_look_back_is_a_literal() -> None:
    offset = value("at(thing, -(2 * 100ms))")
    window = value("mean(thing.level, 1s / 2)")
    assert isinstance(offset, amola.At) and isinstance(offset.offset, Literal)
    assert isinstance(window, amola.Mean) and isinstance(window.window, Literal)
    assert (offset.offset.value, window.window.value) == (-200_000_000, 500_000_000)


def test_an_overload_is_chosen_by_the_types() -> None:
    exact, widened = value("sum(1, 2)"), value("sum(1.0, 2)")
    assert isinstance(exact, amola.Call) and isinstance(widened, amola.Call)
    assert exact.function.result == INT
    assert widened.function.result == DOUBLE


def test_initial_values_are_constants_of_the_variables_type() -> None:
    compiled = system(
        """
        system S
        enum Place { HOME AWAY }
        let limit = 80
        srm r {
          var a : double = limit / 2
          var b : double = 3
          var c : Place = Place.AWAY
          var d : Place
          var e : duration = 2 * 1.5s
          var f : int = -limit
          var g : bool = !false
          var h : string
          var i : double
          liveness { r = A }
        }
        """
    )
    initial = {item.name: item.initial.value for item in compiled.srms[0].variables}
    assert initial == {
        "a": 40.0,
        "b": 3.0,
        "c": "AWAY",
        "d": "HOME",
        "e": 3_000_000_000,
        "f": -80,
        "g": True,
        "h": "",
        "i": 0.0,
    }
    assert isinstance(initial["b"], float)


def test_statements_of_several_roles_about_one_activity_join() -> None:
    compiled = system(
        """
        system S
        message M { int x }
        topic t { state M  data M }
        srm a {
          liveness { a = A . B }
          activities { A uses arm, eye  reads t.state.M, t.data.M for 1s   B takes 1s }
        }
        srm b {
          var count : int
          liveness { b = A . B }
          activities { A every 20ms as step reads t.data.M for 1s, t.state.M  uses eye, arm   B writes count }
        }
        """
    )
    first, second = compiled.activities
    assert (first.uses, first.every, first.kind) == (("arm", "eye"), 20_000_000, "step")
    assert [item.history for item in first.reads] == [0, 1_000_000_000]
    assert (second.takes, second.kind, second.writes_variables) == (1_000_000_000, "thread", ("count",))


def test_a_host_is_an_agent_with_and_without_a_team() -> None:
    text = """
    message M { bool x }
    topic t { state M }
    srm r { liveness { r = A | B } control r { enter A : [HOST.t.state.M.x]  enter B : else } }
    """
    someone = "system S" + text.replace("HOST", "someone")
    assert codes(someone) == ["E513"]
    assert codes(someone + "team T { somebody : r }") == ["E513"]
    assert codes(someone + "team T { someone : r }") == []
    # Who plays a role of a system without a team is called as the role.
    assert codes("system S" + text.replace("HOST", "r")) == []


def test_where_the_team_may_be_elsewhere_any_host_is_accepted() -> None:
    """A file without a `system` is part of others; a team that could not be read may have had the agent."""
    text = """
    message M { bool x }
    topic t { state M }
    srm r { liveness { r = A | B } control r { enter A : [someone.t.state.M.x]  enter B : else } }
    """
    assert "E513" not in codes(text)
    assert "E513" not in codes("system S" + text + "team T { someone r }")
    assert "E513" not in codes("system S" + text + "taem T { someone : r }")


# ---- properties --------------------------------------------------------------------------------

NUMBER = st.one_of(
    st.integers(0, 10**17).map(str),
    st.floats(0, 1e17, allow_nan=False).map(lambda number: f"{number:.10f}"),
    st.sampled_from(["limit", "s.state.Thing.count", "thing.level", "r1.s.signal.Thing.point.x", "0.00001"]),
)
TIME = st.sampled_from(["200ms", "1.5s", "2min", "0.5ms", "age(thing)", "s.state.Thing.since"])
TRUTH = st.sampled_from(
    ["true", "false", "s.state.Thing.on", "has(thing)", "expired(t)", "far(thing)", "place == Place.AWAY"]
)
TEXT = st.sampled_from(['"x"', '"a\\"b\\\\"', "s.state.Thing.name"])


def joined(
    operators: list[str], left: st.SearchStrategy[str], right: st.SearchStrategy[str]
) -> st.SearchStrategy[str]:
    return st.builds(lambda a, o, b: f"({a}) {o} ({b})", left, st.sampled_from(operators), right)


NUMBERS = st.recursive(
    NUMBER,
    lambda inner: st.one_of(
        joined(["+", "-", "*", "/", "%"], inner, inner),
        inner.map(lambda text: f"-({text})"),
        inner.map(lambda text: f"abs({text})"),
        st.builds(lambda a, b: f"max({a}, {b})", inner, inner),
        st.just("mean(thing.level, 300ms)"),
        st.just("(1s) / (age(thing))"),
    ),
    max_leaves=6,
)
TIMES = st.recursive(
    TIME,
    lambda inner: st.one_of(
        joined(["+", "-"], inner, inner),
        joined(["*"], inner, NUMBER),
        joined(["*"], NUMBER, inner),
        inner.map(lambda text: f"-({text})"),
    ),
    max_leaves=4,
)
COMPARED = ["<", "<=", ">", ">=", "==", "!="]
TRUTHS = st.recursive(
    st.one_of(
        TRUTH,
        joined(COMPARED, NUMBERS, NUMBERS),
        joined(COMPARED, TIMES, TIMES),
        joined(COMPARED, TEXT, TEXT),
    ),
    lambda inner: st.one_of(
        joined(["&&", "||", "and", "or", "==", "!="], inner, inner),
        inner.map(lambda text: f"!({text})"),
        st.lists(inner, min_size=3, max_size=4).map(lambda parts: " && ".join(f"({part})" for part in parts)),
    ),
    max_leaves=8,
)


def shape(typed_value: Value) -> list[tuple[str, Type]]:
    return [(type(part).__name__, part.type) for part in walk(typed_value)]


@given(st.one_of(NUMBERS, TIMES, TRUTHS))
@settings(max_examples=80)
def test_the_canonical_spelling_means_the_same(text: str) -> None:
    first = value(text)
    spelled = value_text(first)
    again = value(spelled)
    assert value_text(again) == spelled
    assert shape(again) == shape(first)


@given(st.one_of(NUMBERS, TIMES, TRUTHS))
@settings(max_examples=50)
def test_every_part_of_a_typed_expression_has_a_place(text: str) -> None:
    for part in walk(value(text)):
        assert part.span.start <= part.span.end
        assert isinstance(operands(part), tuple)


WORDS = """
s state signal data Thing on count level name place Place HOME since point x limit thing robot r1
has age at mean expired far sum max abs ( ) ( ) + - * / % < <= == != && || ! , . . . 1 2.5 200ms "x"
true false A B enter skip : [ ] / ; = count write_messages read_messages start_timer send inform to
from error after when else #
""".split()


@given(st.lists(st.sampled_from(WORDS), min_size=1, max_size=25))
@settings(max_examples=80)
def test_no_mixture_of_words_raises_anything(words: list[str]) -> None:
    text = f"""
    system S {WORLD}
    let mixed = {" ".join(words)}
    srm r {{
      var count : int = {" ".join(words[:5])}
      liveness {{ r = A . [B] }}
      control r {{ enter B : [{"".join(words)}]  skip B : {" ".join(words)} }}
    }}
    """
    analyse(Source("test.aseme", text))


@given(TRUTHS, st.integers(0, 1000), st.sampled_from(WORDS))
@settings(max_examples=80)
def test_no_mistake_in_an_expression_raises_anything(text: str, position: int, word: str) -> None:
    position %= len(text) + 1
    found, diagnostics = typed(f"{text[:position]} {word} {text[position + 1 :]}", WORLD)
    assert found is not None or diagnostics
