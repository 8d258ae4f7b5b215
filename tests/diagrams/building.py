"""Statecharts built straight from formulas, for the tests of what only reads statecharts."""

from __future__ import annotations

import random
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from aseme_dsl.amola.expression import (
    EMPTY,
    Assign,
    Compare,
    Literal,
    Member,
    TransitionExpression,
    VariableValue,
)
from aseme_dsl.amola.messages import BOOL, INT, STRING, Channel, ChannelKind
from aseme_dsl.amola.statechart import Origin, OriginKind, State, Statechart, StateType, Transition, label_key
from aseme_dsl.source import Source, Span

SPAN = Span(Source("test.aseme", "system Test\n"), 0, 6)
OWN = Origin(OriginKind.FORMULA, "test", "test")

Term = str | tuple["str | int | Term", ...]
"""An activity's or a formula's name, or an operator with its operands: `(".", "A", ("~", "B"))`."""

FIGURE_4 = {
    "player": "Sensors~ || RobotController~ || LedHandler~ || MotionController~ || (initialize . activate)",
    "initialize": "Stand . CalibrateCamera",
    "activate": "Vision~ || Localization~ || ObstacleAvoidance~ || HeadHandler~ || decision~",
    "decision": "CheckForBallObservation . (ScanForBall | action)",
    "action": "TrackBall || (WalkTowardsBall | KickBall | center | center_for)",
    "center": "WalkTowardsBall . [PassBall]",
    "center_for": "WalkTowardsOpponentGoal . [WalkTowardsBall . [KickBall]]",
}
"""The liveness formulas of the paper's player."""


def parse(text: str) -> Term:
    """A formula's text as a term; parentheses are kept, as in `("()", …)`."""
    tokens = re.findall(r"\w+|\|\||[.|*+~()\[\]]", text)
    place = 0

    def infix(operators: tuple[str, ...]) -> Term:
        nonlocal place
        if not operators:
            return postfix()
        parts = [infix(operators[1:])]
        while place < len(tokens) and tokens[place] == operators[0]:
            place += 1
            parts.append(infix(operators[1:]))
        return parts[0] if len(parts) == 1 else (operators[0], *parts)

    def postfix() -> Term:
        nonlocal place
        token = tokens[place]
        place += 1
        term: Term = token
        if token in "([":
            inner = infix(("||", "|", "."))
            place += 1
            term = ("()" if token == "(" else "[]", inner)
        while place < len(tokens) and tokens[place] in "*+~":
            term = (tokens[place], term)
            place += 1
        return term

    return infix(("||", "|", "."))


def spelling(term: Term) -> str:
    """The canonical spelling of a term."""
    if isinstance(term, str):
        return term
    operator, *operands = term
    inner = [spelling(operand) for operand in operands]  # type: ignore[arg-type]
    if operator == "()":
        return f"({inner[0]})"
    if operator == "[]":
        return f"[{inner[0]}]"
    if len(inner) == 1:
        return f"{inner[0]}{operator}"
    return f" {operator} ".join(inner)


def statechart(
    formulas: Mapping[str, str] | str,
    expressions: Mapping[tuple[str, str], TransitionExpression] | None = None,
    *,
    kind: str = "IAC",
    origins: Mapping[str, Origin] | None = None,
    more: Sequence[tuple[str, str]] = (),
) -> Statechart:
    """The statechart of the formulas (the first is the root) by the templates.

    `expressions` are by source and target label, `origins` by the name of a formula (for its whole branch),
    `more` are transitions by label.
    """
    texts = {"Test": formulas} if isinstance(formulas, str) else formulas
    terms = {name: parse(text) for name, text in texts.items()}
    name = next(iter(terms))
    nodes: list[State] = []
    found: list[tuple[str, str]] = []

    def add(label: str, title: str, type: StateType, parent: str | None, origin: Origin) -> None:
        activity = title if type is StateType.BASIC else None
        nodes.append(State(label, title, type, parent, activity, origin, SPAN))

    def point(parent: str, k: int, type: StateType, origin: Origin) -> None:
        add(f"{parent}.{k}", f"{parent}.{k}", type, parent, origin)

    def operand(parent: str, k: int, term: Term, origin: Origin) -> None:
        label = f"{parent}.{k}"
        if isinstance(term, str) and term not in terms:
            add(label, term, StateType.BASIC, parent, origin)
            return
        title = spelling(term)
        if isinstance(term, str):
            origin = (origins or {}).get(term, origin)
            term = terms[term]
        add(label, title, StateType.OR, parent, origin)
        fill(label, term, origin)

    def fill(label: str, term: Term, origin: Origin) -> None:
        while isinstance(term, tuple) and term[0] == "()":
            term = term[1]  # type: ignore[assignment]
        point(label, 1, StateType.START, origin)
        operator, operands = (".", [term]) if isinstance(term, str) else (term[0], list(term[1:]))
        to = [f"{label}.{k}" for k in range(len(operands) + 4)]  # to[k] is child k
        last = 2
        match operator:
            case ".":
                for k, item in enumerate(operands, start=2):
                    operand(label, k, item, origin)  # type: ignore[arg-type]
                last = len(operands) + 2
                found.extend((to[k], to[k + 1]) for k in range(1, last))
            case "|":
                point(label, 2, StateType.CONDITION, origin)
                for k, item in enumerate(operands, start=3):
                    operand(label, k, item, origin)  # type: ignore[arg-type]
                last = len(operands) + 3
                found.append((to[1], to[2]))
                found.extend((to[2], to[k]) for k in range(3, last))
                found.extend((to[k], to[last]) for k in range(last - 1, 2, -1))
            case "||":
                last = 3
                add(to[2], spelling(term), StateType.AND, label, origin)
                found.extend([(to[1], to[2]), (to[2], to[3])])
                for k, item in enumerate(operands, start=1):
                    region = f"{to[2]}.{k}"
                    add(region, region, StateType.OR, to[2], origin)
                    point(region, 1, StateType.START, origin)
                    operand(region, 2, item, origin)  # type: ignore[arg-type]
                    point(region, 3, StateType.END, origin)
                    found.extend([(f"{region}.1", f"{region}.2"), (f"{region}.2", f"{region}.3")])
            case "*" | "[]":
                last = 4
                point(label, 2, StateType.CONDITION, origin)
                operand(label, 3, operands[0], origin)  # type: ignore[arg-type]
                loop = [(to[3], to[3])] if operator == "*" else []
                skip = [(to[2], to[4]), (to[3], to[4])]
                found.extend([(to[1], to[2]), (to[2], to[3]), *loop, *skip])
            case "+" | "~":
                last = 3
                operand(label, 2, operands[0], origin)  # type: ignore[arg-type]
                found.extend([(to[1], to[2]), (to[2], to[2])])
                if operator == "+":
                    found.append((to[2], to[3]))
        if operator != "~":
            point(label, last, StateType.END, origin)

    add("0", name, StateType.OR, None, OWN)
    fill("0", terms[name], OWN)
    nodes.sort(key=lambda node: label_key(node.label))
    plain = [Transition("", source, target, EMPTY, 0, OWN, SPAN) for source, target in found]
    chart = Statechart(name, "Test", kind, tuple(nodes), tuple(plain))
    return with_transitions(chart, expressions or {}, more)


def condition(text: str = "x", number: int = 1) -> TransitionExpression:
    """`[game.state.Ball.<text> == <number>] / seen = true`."""
    member = Member(None, Channel("game", ChannelKind.STATE, "Ball"), (text,), INT, SPAN)
    seen = Assign(VariableValue("seen", BOOL, SPAN), Literal(True, BOOL, SPAN), SPAN)
    return TransitionExpression(
        condition=Compare("==", member, Literal(number, INT, SPAN), SPAN), actions=(seen,), span=SPAN
    )


def says(text: str) -> TransitionExpression:
    """`[name == "<text>"]`: for strings with awkward characters."""
    name = VariableValue("name", STRING, SPAN)
    return TransitionExpression(condition=Compare("==", name, Literal(text, STRING, SPAN), SPAN), span=SPAN)


def random_formula(chance: random.Random, size: int) -> str:
    """A random formula with `size` activities."""
    if size <= 1:
        term = f"{chance.choice(['Walk', 'LookAround', 'Kick', 'GoToPosition', 'Stop'])}{chance.randrange(9)}"
        return term + chance.choice(["", "", "", "~", "+", "*"])
    parts = min(size, chance.choice([2, 2, 3, 4]))
    cuts = sorted(chance.sample(range(1, size), parts - 1))
    sizes = [end - start for start, end in pairwise([0, *cuts, size])]
    operator = chance.choice([" . ", " | ", " || "])
    inner = operator.join(f"({random_formula(chance, part)})" for part in sizes)
    return chance.choice([inner, inner, f"[{inner}]", f"({inner})+", f"({inner})*", f"({inner})~"])


def random_statechart(seed: int, size: int = 6, extra: int = 4) -> Statechart:
    """A random chart: loops, parallel parts, expressions, and `extra` transitions by label.

    These join any two states that are neither START nor END and are in the same region: siblings, a state and
    itself, a state and one around it, states at different depths.
    """
    chance = random.Random(seed)
    chart = statechart(random_formula(chance, size))
    expressions = {
        way: condition(f"x{place}", place) for place, way in enumerate(ways(chart)) if chance.random() < 0.4
    }
    more = []
    free = [node for node in chart.states if node.type in (StateType.BASIC, StateType.OR, StateType.AND)]
    free = [node for node in free if not chart.is_region(node.label)]
    for _ in range(extra if free else 0):
        source = chance.choice(free)
        near = [node for node in free if chart.region_of(node.label) == chart.region_of(source.label)]
        more.append((source.label, chance.choice(near).label))
    return with_transitions(chart, expressions, more)


def ways(chart: Statechart) -> list[tuple[str, str]]:
    """Source and target of each transition."""
    return [(transition.source, transition.target) for transition in chart.transitions]


def with_transitions(
    chart: Statechart,
    expressions: Mapping[tuple[str, str], TransitionExpression],
    more: Sequence[tuple[str, str]] = (),
) -> Statechart:
    """The chart with other expressions, and with more transitions by label."""
    made: list[Transition] = []
    for source, target in (*ways(chart), *more):
        expression = expressions.get((source, target), EMPTY)
        priority = sum(item.source == source for item in made)
        made.append(Transition(f"{source}TO{target}", source, target, expression, priority, OWN, SPAN))
    return replace(chart, transitions=tuple(made))
