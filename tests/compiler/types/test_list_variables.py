"""Variables that are lists: what the compiler says of them, and where the models have them."""

from __future__ import annotations

import pytest

from aseme_dsl.amola.as_json import models_json
from aseme_dsl.compiler import analyse
from aseme_dsl.source import Source
from tests.support.generated import system_of

ROLE = """system S
enum Place {{ HALL DOOR }}
srm r {{
  var xs : {declared}
  liveness {{ r = A . B }}
  activities {{ A takes 1s  B takes 1s }}
  control r {{ enter A : / {action}  enter B : [size(xs) >= 0] }}
}}
"""


def text(declared: str = "list[3] of int", action: str = "append(xs, 1)") -> str:
    return ROLE.format(declared=declared, action=action)


def told(written: str) -> list[tuple[str, str, str]]:
    """Code, underlined text and message of each error."""
    found = analyse(Source("one.aseme", written)).diagnostics
    return [(item.code, item.span.text, item.message) for item in found if item.code[0] == "E"]


@pytest.mark.parametrize(
    "written",
    [
        text(),
        text("list of double", "append(xs, 1); remove(xs, 0.5); remove(xs[0])"),
        text("list of string = []", 'xs = ["a", "b"]; append(xs, xs[0])'),
        text("list of Place", "append(xs, Place.HALL); remove(xs, Place.DOOR)"),
        text("list of duration", "append(xs, 2s)"),
        text("list of bool", "xs = [true]; xs = []"),
    ],
)
def test_lists_of_every_value(written: str) -> None:
    assert told(written) == []


NO_LIST = "`append` changes a variable that is a list, not `ys`"
NEVER_EMPTY = "`clear` empties a variable that holds a message or an agent, not "
OTHER = "the list holds values of type int: a string is not among them"
WANTED = "an int is wanted here, not a string"


@pytest.mark.parametrize(
    ("written", "code", "place", "message"),
    [
        (text(action='append(xs, "a")'), "E500", '"a"', WANTED),
        (text(action="remove(xs[true])"), "E500", "true", "an int is wanted here, not a bool"),
        (text(action="append(ys, 1)"), "E535", "ys", NO_LIST),
        (text(action="append([1], 1)"), "E535", "[1]", NO_LIST.replace("ys", "[1]")),
        (text("list[0] of int"), "E518", "0", "a list of this length holds nothing"),
        (text("list[200000] of int"), "E518", "200000", "a list has at most 100000 elements"),
        (text("list of int = [1]"), "E514", "[1]", "the list `xs` begins empty"),
        (text("list of int 0..3"), "E518", "0..3", "the elements of the list `xs` have no bounds"),
        (text("list of agent", "xs = []"), "E500", "agent", "a list does not hold agents"),
        (text(action="xs[0] = true"), "E500", "true", "an int is wanted here, not a bool"),
        (text(action="xs[true] = 1"), "E500", "true", "an int is wanted here, not a bool"),
        (text(action="ys[0] = 1"), "E535", "ys", NO_LIST.replace("`append`", "`xs[i] = v`")),
        (text(action="xs.append(1)"), "E502", "xs.append", "`xs.append` is not a function"),
        (text(action="append(xs, len(xs))"), "E502", "len", "`len` is not a function"),
        (
            text(action="append(xs, xs.length)"),
            "E501",
            "length",
            "the variable `xs` is a list of int: it has no members",
        ),
        (text(action="xs[find(xs)] = 1"), "E504", "find(xs)", "`find` takes 2 arguments, not 1"),
        (text(action='xs[find(xs, "a")] = 1'), "E504", '"a"', OTHER),
        (text(action="clear(xs)"), "E507", "clear(xs)", NEVER_EMPTY + "`xs`, which is a list of int"),
        (text(action="clear(zs)"), "E200", "zs", "there is no variable or let `zs`"),
        (text(action="clear(xs[0])"), "E507", "clear(xs[0])", NEVER_EMPTY + "`xs[0]`"),
        (text(action="xs.index(1)"), "E502", "xs.index", "`xs.index` is not a function"),
        (text(action="xs = append(xs, 1)"), "E504", "append(xs, 1)", "`append` is an action, not a value"),
    ],
)
def test_what_does_not_fit_is_said_once(written: str, code: str, place: str, message: str) -> None:
    assert told(written) == [(code, place, message)]


@pytest.mark.parametrize("action", ["append(xs)", "append()", "remove(xs)", "remove(xs, 1, 2)"])
def test_how_many_arguments_they_take(action: str) -> None:
    assert [code for code, _, _ in told(text(action=action))] == ["E504"]


def test_a_function_of_that_name_goes_before() -> None:
    written = text(action="append(1, 2)") + '\nfunction append(int a, int b) : int = "m:append"\n'
    assert [code for code, _, _ in told(written) if code in ("E504", "E535")] == []


def test_the_models_have_them() -> None:
    models = models_json(system_of(text()))
    for name in ("iac.r.json", "srm.r.json"):
        [variable] = models[name]["variables"]  # type: ignore[misc]
        assert (variable["type"], variable["length"], variable["initial"]) == ("list of int", 3, [])
    [action] = models["iac.r.json"]["transitions"][0]["actions"]  # type: ignore[index]
    assert action == "append(xs, 1)"


MESSAGES = """system S
message Place {{ int x }}
message Order {{ int id  Place place  optional string note  repeated string names }}
message Other {{ int id }}
topic t {{ state Order  state Other }}
srm r {{
  var m : Order
  var o : Order
  var q : list[3] of Order
  liveness {{ r = A . B }}
  activities {{ A takes 1s  B takes 1s }}
  control r {{ enter A : / {action}  enter B : [{condition}] }}
}}
"""


def with_messages(action: str = "m = t.state.Order; append(q, m)", condition: str = "m.id == o.id") -> str:
    return MESSAGES.format(action=action, condition=condition)


@pytest.mark.parametrize(
    "written",
    [
        with_messages(),
        with_messages("m = t.state.Order; o = m; append(q, o); q[0] = m; remove(q[0]); m = q[0]; q = [m, o]"),
        with_messages(
            "write_messages.t.state.Order { ..m }; t.state.Order = q[0]; t.state.Order.id = q[0].id"
        ),
        with_messages(
            "m = Order { id = 1, .. }; append(q, Order { id = m.id + 1, ..m }); q[0] = Order { ..q[0] }"
        ),
        with_messages(
            'm = Order { id = 1, place = Place { x = 2 }, names = ["a"], note = "b" };'
            " o = Order { place = m.place, place.x = 3, .. }; m = Order { id = 1, ..t.state.Order }"
        ),
        with_messages(
            "remove(q, m); m = has(m) ? m : o", "m == o && q[0] != m && contains(q, Order { id = 1, .. })"
        ),
        with_messages(condition='has(m) && has(m.note) && m.place.x == 1 && contains(m.names, "a")'),
        with_messages("clear(m); m = q[find(q.id, 3)]; remove(q[find(q.place.x, m.id)])"),
        with_messages(condition='contains(q.note, "a") && find(q[0].names, "b") == 1'),
        with_messages(condition='q[0].names[1] == "a" && size(q[1].names) > 0 && q[0].place.x < m.place.x'),
    ],
)
def test_variables_hold_messages(written: str) -> None:
    assert told(written) == []


@pytest.mark.parametrize(
    ("written", "code", "place", "message"),
    [
        (
            with_messages("m = t.state.Other"),
            "E500",
            "t.state.Other",
            "an Order is wanted here, not an Other",
        ),
        (with_messages("m.id = 3"), "E507", "m.id", "the message in `m` does not change"),
        (with_messages("q[0].id = 3"), "E507", "q", "the message in `q[0]` does not change"),
        (
            with_messages("write_messages.t.state.Other { ..m }"),
            "E500",
            "m",
            "an Other is wanted here, not an Order",
        ),
        (
            with_messages("m = Order { id = 1 }"),
            "E577",
            "{ id = 1 }",
            "the content of `Order` leaves out `place` and `names`",
        ),
        (
            with_messages("m = Other { id = 1 }"),
            "E500",
            "Other { id = 1 }",
            "an Order is wanted here, not an Other",
        ),
        (with_messages("m = Ordr { .. }"), "E502", "Ordr", "there is no message `Ordr`"),
        (with_messages("m = Order { ids = 1, .. }"), "E501", "ids", "`Order` has no member `ids`"),
        (
            with_messages("m = Order { place.x = 1, place = m.place, .. }"),
            "E225",
            "place",
            "`place` is filled twice",
        ),
        (with_messages("m = Order { ..q }"), "E578", "q", "`q` is not a message"),
        (
            with_messages("m = t.state.Order { .. }"),
            "E502",
            "t.state.Order",
            "`t.state.Order` is what has come on a topic, not the type of a new message",
        ),
        (with_messages("m = Order"), "E200", "Order", "`Order` is the name of a message, not a value"),
        (with_messages("append(q, Order)"), "E200", "Order", "`Order` is the name of a message, not a value"),
        (with_messages("m = Order(1)"), "E502", "Order(1)", "`Order` is not a function"),
        (
            with_messages("m = Order(id = 1)"),
            "E102",
            "=",
            "expected an operator, ',' or ')' after 'id', found '='",
        ),
        (
            with_messages("m = new Order { .. }"),
            "E102",
            "= new Order {",
            "'new' is not a word of the language",
        ),
        (with_messages("append(q, { id = 1 })"), "E102", ", {", "no message stands before '{'"),
        (with_messages("append(q, Order { id: 1 })"), "E102", ", Order {", "a member is filled with '='"),
        (
            with_messages("m = Order { id = 1, to { x = 3 } }"),
            "E102",
            "= Order { id = 1, to {",
            "a member is filled with '='",
        ),
        (with_messages("m = Order { id = 1, .. }.id"), "E102", ".", "no member of a new message is read"),
        (with_messages(condition="m < o"), "E509", "m < o", "`<` does not order values of type Order"),
        (
            with_messages(condition="m == q"),
            "E509",
            "m == q",
            "an Order and a list of Order cannot be compared",
        ),
        (with_messages(condition="m.age > 3"), "E501", "age", "`Order` has no member `age`"),
        (with_messages(condition="contains(q.ids, 1)"), "E501", "ids", "`Order` has no member `ids`"),
        (with_messages(condition="find(q.id.x, 1) == 0"), "E501", "x", "`id` is an int: it has no members"),
        (
            with_messages(condition="contains(q.note, 1)"),
            "E504",
            "1",
            "`note` of an element is a string, not an int",
        ),
        (
            with_messages(condition="q.id == 1"),
            "E501",
            "id",
            "the variable `q` is a list of Order: it has no members",
        ),
        (with_messages("m = none"), "E200", "none", "there is no variable or let `none`"),
        (with_messages(condition="has(q[0])"), "E504", "q[0]", "`has` wants a message, not an Order"),
    ],
)
def test_what_does_not_fit_a_message_is_said_once(written: str, code: str, place: str, message: str) -> None:
    assert told(written) == [(code, place, message)]


def test_braces_stand_inside_braces() -> None:
    """A member may be called `to`, which elsewhere ends the content of a message."""
    written = """system S
message Place { int x }
message Trip { Place start  Place to }
message Far { Trip to  int id }
srm r {
  var far : Far
  liveness { r = A . B . C }
  control r {
    enter A : / far = Far { to = Trip { start = Place { x = 1 }, to = Place { x = 2 } }, id = 1 }
    enter B : [far.to.to.x > 1] / far = Far { to = Trip { start = Place { ..far.to.to }, ..far.to }, ..far }
    enter C : [far.id > 0]
  }
}
"""
    assert told(written) == []


def test_the_models_have_variables_with_messages() -> None:
    variables = models_json(system_of(with_messages()))["iac.r.json"]["variables"]
    assert [(v["type"], v["initial"]) for v in variables] == [  # type: ignore[index, union-attr]
        ("Order", None),
        ("Order", None),
        ("list of Order", []),
    ]
