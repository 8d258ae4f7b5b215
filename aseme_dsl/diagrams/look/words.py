"""Words: texts that describe a drawing for readers who cannot see it."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from aseme_dsl.amola.aip import Aip
from aseme_dsl.amola.srm import Srm
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.amola.system import System
from aseme_dsl.diagrams.look.drawing import Drawing

_NAME = re.compile(r"(?P<kind>\w+)(\.(?P<name>[^.]+))?(\.(tree|nested))?(\.(?P<label>\d[\d.]*)(-\w+)?)?")
"""A drawing's name: `suc`, `iac.player`, `iac.player.tree.0.2.1`."""

_MOST = 8
"""A text lists at most so many names; of more it says the number."""


def words(system: System, drawing: Drawing) -> str:
    """One line of text that says what a drawing of the system shows: the model, and what is in it."""
    parts = _NAME.fullmatch(drawing.name)
    if parts is None:
        return f"{drawing.name} of {system.name}"
    kind, name, label = parts["kind"], parts["name"] or "", parts["label"] or ""
    tellers: dict[str, Callable[[], str]] = {
        "sag": lambda: _sag(system),
        "suc": lambda: _suc(system),
        "aip": lambda: next((_aip(item) for item in system.aips if item.name == name), ""),
        "srm": lambda: next((_srm(item) for item in system.srms if item.name == name), ""),
        "eac": lambda: _chart(system.eac(name), label),
        "iac": lambda: _chart(system.iac(name), label),
    }
    return (tellers[kind]() if kind in tellers else "") or f"{drawing.name} of {system.name}"


def _sag(system: System) -> str:
    sag = system.sag
    actors = _names("actor", [item.name for item in sag.actors])
    return f"Actors and goals of {system.name}: {actors}; {_names('goal', [item.name for item in sag.goals])}"


def _suc(system: System) -> str:
    roles = _names("role", [item.name for item in system.suc.roles])
    cases = _names("use case", [item.name for item in system.suc.usecases])
    return f"Use cases of {system.name}: {roles}; {cases}"


def _aip(aip: Aip) -> str:
    return f"Protocol {aip.name}: {_names('participant', [item.name for item in aip.participants])}"


def _srm(srm: Srm) -> str:
    formulas = _names("formula", [item.name for item in srm.formulas])
    activities = f"; {_names('activity', srm.activities)}" if srm.activities else ""
    return f"Role {srm.name}: {formulas}{activities}"


def _chart(chart: Statechart | None, label: str) -> str:
    if chart is None:
        return ""
    whose = "role" if chart.kind == "IAC" else "protocol"
    nodes = [node for node in chart.states if not label or _is_in(node.label, label)]
    activities = dict.fromkeys(node.name for node in nodes if node.type is StateType.BASIC)
    part = f", state {label}" if label else ""
    told = f"; {_names('activity', list(activities))}" if activities else ""
    return f"Statechart of the {whose} {chart.name}{part}: {_number(len(nodes), 'state')}{told}"


def _is_in(inner: str, outer: str) -> bool:
    return inner == outer or inner.startswith(f"{outer}.")


def _names(noun: str, names: Sequence[str]) -> str:
    """`roles attacker and keeper`, `12 roles`, `no role`."""
    if not names:
        return f"no {noun}"
    if len(names) > _MOST:
        return _number(len(names), noun)
    listed = ", ".join(names[:-1])
    return f"{_plural(noun, len(names))} {f'{listed} and ' if listed else ''}{names[-1]}"


def _number(number: int, noun: str) -> str:
    return f"{number} {_plural(noun, number)}"


def _plural(noun: str, number: int) -> str:
    if number == 1:
        return noun
    return f"{noun[:-1]}ies" if noun.endswith("y") else f"{noun}s"
