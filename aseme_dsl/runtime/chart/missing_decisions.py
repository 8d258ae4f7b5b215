"""Undecided: the choices of a participant that only its activities make, and what they are without code."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan, Term

_SETTLED = frozenset("const enum variable holds ! && || neg == != < <= > >= + - * / // %".split())
"""What changes only with a variable."""


@dataclass(frozen=True, slots=True)
class Undecided:
    """Variables that choices depend on and that are false until an activity sets them; who could."""

    variables: tuple[str, ...]
    activities: tuple[str, ...]


def undecided(plan: Plan, branch: str) -> Undecided:
    """What the activities of a participant, given by its branch, have to agree to.

    Of what they may say or leave (`has(asked)`, `when [withdrawn]`) they decide something by saying nothing:
    so nothing that a line waits for is asked of them.
    """
    inside = branch + "."
    lines = [item for item in plan.transitions if item.source.startswith(inside)]
    set_by_lines = {action[1] for item in lines for action in item.actions if action[0] == "assign"}
    left = [
        item.name
        for item in plan.variables
        if item.scope == branch and item.initial is False and item.name not in set_by_lines
    ]
    asked_for: set[str] = set()
    optional: set[str] = set()
    for item in lines:
        if item.condition is None:
            continue
        terms = list(_terms(item.condition))
        asked = [str(term[1]) for term in terms if term[0] == "variable"]
        if item.when:
            optional.update(asked)
            continue
        if all(name in left for name in asked) and _SETTLED.issuperset(term[0] for term in terms):
            asked_for.update(asked)
    states = (item for item in plan.states if item.label.startswith(inside) and item.activity is not None)
    variables = tuple(name.partition("@")[0] for name in left if name in asked_for - optional)
    return Undecided(variables, tuple(dict.fromkeys(item.activity or "" for item in states)))


def listed(names: Sequence[str], word: str) -> str:
    """`a, b and c`."""
    return f" {word} ".join(filter(None, (", ".join(names[:-1]), names[-1])))


def _terms(term: Term) -> Iterator[Term]:
    waiting = [term]
    while waiting:
        term = waiting.pop()
        yield term
        waiting.extend(item for item in term[1:] if isinstance(item, tuple) and item)
