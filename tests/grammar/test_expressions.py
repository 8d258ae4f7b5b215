"""Expressions and transition expressions."""

from __future__ import annotations

import re
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from aseme_dsl.diagnostics.changes import apply
from aseme_dsl.grammar.text import tree
from tests.grammar.reading import condition, declared, mistakes, short, transition


@pytest.mark.parametrize(
    ("text", "spelled"),
    [
        ("a || b && c == d + e * -f", "(a || (b && (c == (d + (e * (-f))))))"),
        ("a && b && c || d || e", "((a && b && c) || d || e)"),
        ("a or b and not c", "(a || (b && (!c)))"),
        ("a - b - c * d / e % f", "((a - b) - (((c * d) / e) % f))"),
        ("!a.b.c.d && !f(x)", "((!a.b.c.d) && (!f(x)))"),
        ("!(a == b)", "(!((a == b)))"),
        ("not not a", "(!(!a))"),
        ("(a < b) == (c < d)", "(((a < b)) == ((c < d)))"),
        ("a == !b", "(a == (!b))"),
        ("-a < +b", "((-a) < (+b))"),
        ("f()", "f()"),
        ('f(a, -1, g(b.c, 200ms), "x")', 'f(a, (-1), g(b.c, 200000000ns), "x")'),
        ("true || false", "(true || false)"),
        ("robot1.team.state.Assignment.center == 3", "(robot1.team.state.Assignment.center == 3)"),
        ("PlayerState.PLAYING != a.state.B.c", "(PlayerState.PLAYING != a.state.B.c)"),
        ("mean(a.data.B.c, 300ms) < 30", "(mean(a.data.B.c, 300000000ns) < 30)"),
        ("at(x, -200ms) >= 1.5", "(at(x, (-200000000ns)) >= 1.5)"),
        ("x.items[i + 1].a.b == -y[0][n]", "(x.items[(i + 1)].a.b == (-y[0][n]))"),
        ("size([]) + [1, a.b][0] % f(x)[0]", "(size([]) + ([1, a.b][0] % f(x)[0]))"),
        ("contains([(a), [b]], c[d[0]])", "contains([(a), [b]], c[d[0]])"),
    ],
)
def test_precedence(text: str, spelled: str) -> None:
    assert short(condition(text)) == spelled


def test_spans_of_operators_and_parts() -> None:
    made = condition("a+b  <  f( c )")
    assert isinstance(made, tree.Binary)
    assert (made.span.text, made.operator_span.text) == ("a+b  <  f( c )", "<")
    assert (made.left.span.text, made.right.span.text) == ("a+b", "f( c )")
    path = condition("vision . state.Ball")
    assert isinstance(path, tree.Path)
    assert [segment.span.text for segment in path.segments] == ["vision", "state", "Ball"]


@pytest.mark.parametrize(
    ("text", "code", "place"),
    [
        ("!a == b", "E107", "=="),
        ("not a < b", "E107", "<"),
        ("!a + b == c", "E107", "+"),
        ("a < b < c", "E107", "<"),
        ("a == b != c", "E107", "!="),
        ("a b", "E102", "b"),
        ("a = b", "E102", "="),
        ("a & b", "E102", "&"),
        ("a | b", "E102", "|"),
        ("a ^ b", "E102", "^"),
        ("a <", "E102", "]"),
        ("(a", "E102", "]"),
        ("a)", "E102", ")"),
        ("f(a,)", "E102", ")"),
        ("f(a b)", "E102", "b"),
        ("* a", "E102", "*"),
        (".5 < a", "E102", "."),
        ("a..b", "E102", "."),
        ("a . 3", "E102", "."),
        ("else", "E102", "else"),
        ("a < and", "E102", "and"),
    ],
)
def test_malformed_conditions(text: str, code: str, place: str) -> None:
    [mistake] = mistakes(f"srm a {{ control f {{ enter A : [{text}] }} }}")
    assert mistake.code == code
    assert mistake.span is not None and mistake.span.text == place


def test_hints() -> None:
    def hint(text: str) -> str | None:
        return mistakes(f"srm a {{ control f {{ enter A : {text} }} }}")[0].hint

    assert hint("[a = b]") == "write '==' to compare"
    assert hint("[a & b]") == "'&&' is and"
    assert hint("[!a.b == c]") == "write !(a.b == …) or (!a.b) == …"
    assert hint("a.b > 3") == "write [a.b > 3]"
    behind = "the condition stands behind all events; where it is for one of them, write an entry for each"
    assert hint("tock [a] or after(2s)") == hint("[a] or tock") == behind
    assert hint("a = 3") == "write / before actions"
    assert hint("send cfp Task to b") == "write / before actions"
    assert hint("inform Done form b") == "did you mean 'from'?"
    assert hint("/ raise start") == "give the event another name"
    assert hint("/ send accept-proposal Award to b") == "names are written with '_': accept_proposal"


@pytest.mark.parametrize(
    ("term", "condition", "meant"),
    [
        ("B", "t.signal.Stop", "when [has(t.signal.Stop)]"),
        ("(B . C)", "x > 3", "when [x > 3]"),
        ("(B.C)", "if x > 3", "when [x > 3]"),
        ("C", "x > 3", "[x > 3]"),
    ],
)
def test_what_interrupts_needs_when(term: str, condition: str, meant: str) -> None:
    """A condition alone is no trigger: E420 would follow."""
    behind = "B . C" if "C" in term else "B"
    text = f"""srm a {{ liveness {{ f = A [> ({behind}) }}
      control f {{
        enter {term} : {condition}
      }} }}"""
    [mistake] = mistakes(text)
    assert (mistake.code, mistake.hint, mistake.fix) == ("E102", f"write {meant}", meant)


def test_an_event_cannot_be_called_like_a_verb() -> None:
    mistake = mistakes("srm a { control f { enter A : / raise start\n enter B : go } }")[0]
    assert mistake.message == "'start' begins a control line and cannot be the name of an event"


def test_a_verb_that_is_right_is_not_mended() -> None:
    mistake = mistakes("srm a { control f { enter A : [b]\n enter!C : else } }")[0]
    assert (mistake.code, mistake.hint, mistake.fix) == ("E102", None, None)
    mistake = mistakes("srm a { control f { enter A : [b]\n entre C : else } }")[0]
    assert mistake.fix == "enter"


@pytest.mark.parametrize(
    ("written", "place", "fix"),
    [
        ("when stop", "when stop", "stop"),
        ("on stop", "on stop", "stop"),
        ("after(2s) or when stop", "when stop", "stop"),
        ("when stop > 3", "stop > 3", "[stop > 3]"),
        ("when t.state.M", "t.state.M", "[has(t.state.M)]"),
        ("when stop / x = 1", "stop", "[stop]"),
    ],
)
def test_an_event_is_written_without_a_word_before_it(written: str, place: str, fix: str) -> None:
    text = f"srm a {{ control f {{ enter A : {written}\n enter B : goal }} }}"
    [mistake] = mistakes(text)
    assert (mistake.code, mistake.span and mistake.span.text, mistake.fix) == ("E102", place, fix)
    assert mistake.hint is not None and fix in mistake.hint
    assert not mistakes(apply(text, mistake.changes))


@pytest.mark.parametrize(
    ("written", "place", "hint", "mended"),
    [
        ("send request Job { id = 3 .. } to b", "..", "write ',' before it: 3, ..", "{ id = 3, .. }"),
        ("send request Job { id = n ..m } to b", "..", "write ',' before it: n, ..m", "{ id = n, ..m }"),
        ("send request Job { ..m, id = 3 } to b", "id", "'..m' stands at the end", None),
        ("send request Job { .. id = 3 } to b", "=", None, None),
        ("write_messages.t.state.M { id = 3, .. }", "..", "members that are not named keep", None),
        ("write_messages.t.state.M { .. }", "..", "members that are not named keep", None),
    ],
)
def test_the_rest_of_a_message_stands_at_its_end(
    written: str, place: str, hint: str | None, mended: str | None
) -> None:
    text = f"srm a {{ control f {{ enter A : / {written} }} }}"
    [mistake] = mistakes(text)
    assert (mistake.code, mistake.span and mistake.span.text) == ("E102", place)
    assert hint is None or hint in (mistake.hint or "")
    if mended is not None:
        assert mended in apply(text, mistake.changes) and not mistakes(apply(text, mistake.changes))


@pytest.mark.parametrize("declared", ["var tired : bool = false", "let tired = 1 < 2"])
def test_a_value_behind_a_word_is_no_event(declared: str) -> None:
    [mistake] = mistakes(f"srm a {{ {declared} control f {{ enter A : when tired }} }}")
    assert (mistake.code, mistake.fix) == ("E102", "[tired]")


# ---- transition expressions --------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "events", "when", "otherwise", "spelled", "actions"),
    [
        ("", (), False, False, None, ()),
        ("else", (), False, True, None, ()),
        ("[a]", (), False, False, "a", ()),
        ("when [a]", (), True, False, "a", ()),
        ("goal", (("Raised", "goal"),), False, False, None, ()),
        ("error", (("Raised", "error"),), False, False, None, ()),
        ("after(5s)", (("After", "5000000000ns"),), False, False, None, ()),
        ("after(pause + 1s) [a]", (("After", "(pause + 1000000000ns)"),), False, False, "a", ()),
        ("inform Done from a", (("Received", "inform", "Done", "a"),), False, False, None, ()),
        (
            "inform Done from contractor or after(2min) or gone [a > 3] / b = 3",
            (("Received", "inform", "Done", "contractor"), ("After", "120000000000ns"), ("Raised", "gone")),
            False,
            False,
            "(a > 3)",
            (("Assign", "b", 3),),
        ),
        ("after(5s) or when [a]", (("After", "5000000000ns"),), True, False, "a", ()),
        ("else / f(x); 3", (), False, True, None, (("Evaluate", "f(x)"), ("Evaluate", 3))),
        (
            "/ read_messages; start_timer(pace, 200ms); send cfp Task to contractor",
            (),
            False,
            False,
            None,
            (
                ("ReadMessages",),
                ("Evaluate", "start_timer(pace, 200000000ns)"),
                ("Send", "cfp", "Task", "contractor"),
            ),
        ),
        (
            "/ robot1.team.state.Pass.to = 3; write_messages . team.state.Pass; n = n + 1; send = 3",
            (),
            False,
            False,
            None,
            (
                ("Assign", "robot1.team.state.Pass.to", 3),
                ("Publish", "team.state.Pass"),
                ("Assign", "n", "(n + 1)"),
                ("Assign", "send", 3),
            ),
        ),
    ],
)
def test_transition_expressions(
    text: str, events: Any, when: bool, otherwise: bool, spelled: str | None, actions: Any
) -> None:
    assert short(transition(text)) == ("TransitionExpression", events, when, otherwise, spelled, actions)


def test_an_expression_ends_where_the_next_entry_begins() -> None:
    text = """srm a { control f {
      enter A :
      enter (B . [C])#2 : [a
         && b.enter] // not here
         / x = 1;
           y = 2
      leave A : skip C : [c] repeat D~ : start (A | B) : finish f : / x = start.y
      0.2.3 -> 0.2.4 : [1.5 < a] 0.1 -> 0.10 :
    } }"""
    entries = declared(text).controls[0].entries
    assert [
        (short(way.verb), short(way.term.formula), way.term.occurrence, short(way.expression)[4:])
        for way in entries
        if isinstance(way, tree.Way)
    ] == [
        ("enter", "A", None, (None, ())),
        ("enter", "(B . [C])", 2, ("(a && b.enter)", (("Assign", "x", 1), ("Assign", "y", 2)))),
        ("leave", "A", None, (None, ())),
        ("skip", "C", None, ("c", ())),
        ("repeat", "D~", None, (None, ())),
        ("start", "(A | B)", None, (None, ())),
        ("finish", "f", None, (None, (("Assign", "x", "start.y"),))),
    ]
    assert [
        (way.source.text, way.targets[0].text, short(way.expression.condition))
        for way in entries
        if isinstance(way, tree.LabelledWay)
    ] == [("0.2.3", "0.2.4", "(1.5 < a)"), ("0.1", "0.10", None)]
    assert entries[1].term.span.text == "(B . [C])#2"
    assert entries[0].expression.span.text == ":"


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("else [a]", "else"),
        ("when", "when"),
        ("when / x = 1", "/"),
        ("a.b.c", "a.b.c"),
        ("a > 3 / b = 1", "a > 3"),
        ("after 5s", "5s"),
        ("inform Done", "Done"),
        ("inform Done by b", "by"),
        ("[a] b", "b"),
        ("[a] / x = 1;", ";"),
        ("[a] / x = ", "="),
        ("[a] / 3 = x", "="),
        ("[a] / ; x = 3", ";"),
        ("[a] / else", "else"),
        ("[a] / f(x) = 3", "="),
        ("[a] / send cfp Task", "Task"),
        ("[a] / write_messages", "write_messages"),
        ("read_messages", "read_messages"),
        ("goal or", "or"),
        ("goal or 3", "3"),
        ("goal = 3", "="),
        ("[a", "a"),
        ("a]", "]"),
        ("[x.items[0 == 1]", "]"),
        ("[x.items[0] == 1", "1"),
        ("[size(x.items[0) > 1]", ")"),
        ("[contains([1, 2, n) ]", ")"),
        ("[x[0]. == 1]", "=="),
        ("[x[] == 1]", "]"),
        ("/ n = way[1", "1"),
        ("/ n = [1, 2", "2"),
        ("/ n = [1 2]", "2"),
        ("/ size(way) = 2", "="),
    ],
)
def test_malformed_transitions(text: str, place: str) -> None:
    [mistake] = mistakes(f"srm a {{ control f {{ enter A : {text}\n leave B : }} }}")
    assert mistake.code == "E102"
    assert mistake.span is not None and mistake.span.text == place


# ---- depth -------------------------------------------------------------------------------------


def test_expressions_may_be_nested_a_hundred_deep() -> None:
    for text in ("(" * 99 + "a" + ")" * 99, "!" * 100 + "a", "f(" * 100 + ")" * 100, " + ".join("a" * 100)):
        condition(text)
    condition(" || ".join("a" * 5000))


@pytest.mark.parametrize(
    "text",
    [
        "(" * 101 + "a" + ")" * 101,
        "(" * 50_000,
        "!" * 101 + "a",
        "f(" * 101 + ")" * 101,
        "[" * 101 + "]" * 101,
        "a" + "[0]" * 101,
        "a[" * 101 + "0" + "]" * 101,
        " + ".join("a" * 102),
        "a || b && c == d + e * (" * 100 + "a" + ")" * 100,
    ],
)
def test_expressions_that_are_too_deep(text: str) -> None:
    [mistake] = mistakes(f"let x = {text}\n")
    assert mistake.code == "E103"


# ---- an independent reader ---------------------------------------------------------------------

LEVELS = [["||", "or"], ["&&", "and"], ["<", "<=", ">", ">=", "==", "!="], ["+", "-"], ["*", "/", "%"]]


def oracle(text: str) -> str:
    """An expression with all its parentheses, read the obvious way: recursive, one call a level."""
    tokens = re.findall(r"\|\||&&|[<>=!]=|[A-Za-z_][\w.]*|[0-9.]+|\S", text)

    def level(depth: int) -> str:
        if depth == len(LEVELS):
            return unary()
        parts = [level(depth + 1)]
        operators: list[str] = []
        while tokens and tokens[0] in LEVELS[depth]:
            operators.append({"or": "||", "and": "&&"}.get(tokens[0], tokens.pop(0)))
            parts.append(level(depth + 1))
        if not operators:
            return parts[0]
        if depth < 2:
            return "(" + f" {operators[0]} ".join(parts) + ")"
        made = parts[0]
        for operator, part in zip(operators, parts[1:], strict=True):
            made = f"({made} {operator} {part})"
        return made

    def unary() -> str:
        if tokens[0] in ("!", "not", "-", "+"):
            return f"({tokens.pop(0).replace('not', '!')}{unary()})"
        first = tokens.pop(0)
        if first == "(":
            inner = level(0)
            tokens.pop(0)
            return f"({inner})"
        if tokens and tokens[0] == "(":
            tokens.pop(0)
            arguments = []
            while tokens[0] != ")":
                arguments.append(level(0))
                if tokens[0] == ",":
                    tokens.pop(0)
            tokens.pop(0)
            return f"{first}({', '.join(arguments)})"
        return first

    return level(0)


def _pop_synonyms(text: str) -> str:
    return re.sub(r"\band\b", "&&", re.sub(r"\bor\b", "||", text))


atoms = st.sampled_from(["a", "b.c", "x.state.M.m", "3", "1.5", "true", "f()", "(a)"])


def _join(operators: list[str], inner: st.SearchStrategy[str], most: int) -> st.SearchStrategy[str]:
    return st.lists(inner, min_size=1, max_size=most).flatmap(
        lambda parts: st.lists(
            st.sampled_from(operators), min_size=len(parts) - 1, max_size=len(parts) - 1
        ).map(lambda used: " ".join(x for pair in zip(parts, [*used, ""], strict=True) for x in pair).strip())
    )


def _levels(atom: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    signed = st.tuples(st.sampled_from(["", "-", "- -"]), atom).map("".join)
    product = _join(["*", "/", "%"], signed, 2)
    total = _join(["+", "-"], product, 2)
    comparison = st.one_of(
        _join(["<", "<=", ">", ">=", "==", "!="], total, 2), atom.map(lambda text: f"! {text}")
    )
    both = _join(["&&", "and"], comparison, 2)
    return _join(["||", "or"], both, 3)


expressions = st.recursive(
    atoms,
    lambda inner: st.one_of(
        _levels(inner.map(lambda text: f"({text})")),
        _levels(atoms),
        st.lists(inner, max_size=3).map(lambda parts: f"g({', '.join(parts)})"),
    ),
    max_leaves=4,
)


@settings(max_examples=150)
@given(expressions)
def test_any_expression_is_read_as_the_obvious_reader_reads_it(text: str) -> None:
    assert str(short(condition(text))) == oracle(_pop_synonyms(text))
