"""Models as JSON: plain data of a fixed form, described by the schemas beside this file.

Expressions and formulas are canonical texts, in which a `let` is written out. Durations are texts as well
(`200ms`). Places name files as they were given, relative to the system's file, never absolutely.
"""

# By hand: the keys are those of the schemas, not of the classes, and most values are canonical texts. msgspec
# and cattrs need a hook for nearly each class.

from __future__ import annotations

import json
import posixpath
from collections.abc import Callable, Iterable, Iterator
from pathlib import PurePath

from aseme_dsl.amola.aip import Aip, DeclaredVariable, NamedFormula, Participant, Plays
from aseme_dsl.amola.expression import Literal, action_text, duration_text, events_text, value_text
from aseme_dsl.amola.liveness import canonical
from aseme_dsl.amola.messages import DURATION, Bounds, Kind, Parameter
from aseme_dsl.amola.sag import Sag
from aseme_dsl.amola.srm import Activity, Guarantee, Module, Sent, Srm, Subscription
from aseme_dsl.amola.statechart import State, Statechart
from aseme_dsl.amola.suc import Suc
from aseme_dsl.amola.system import System
from aseme_dsl.source import Span, is_library_path

FORMAT = 1
"""The version of the form of all models."""

Json = dict[str, object]


def models_json(system: System) -> dict[str, Json]:
    """Every model of a system by its file's name: `sag.json`, `eac.attack.json`, `iac.player.json`, …"""
    return {name: make(*inputs) for name, make, inputs in model_makers(system)}


def model_makers(system: System) -> Iterator[tuple[str, Callable[..., Json], tuple[object, ...]]]:
    """The same, each model as what makes it of what: of its own parts of the system, and nothing else."""
    folder = folder_of(system)
    yield "sag.json", sag_json, (system.sag, system.name, folder)
    yield "suc.json", suc_json, (system.suc, system.name, folder)
    for aip in system.aips:
        yield f"aip.{aip.name}.json", aip_json, (aip, system.name, folder)
    known = {item.name: item for item in system.activities}
    for srm in system.srms:
        activities = tuple(known[name] for name in srm.activities if name in known)
        yield f"srm.{srm.name}.json", srm_json, (srm, activities, system.name, folder)
    for chart in system.statecharts:
        yield f"{chart.kind.lower()}.{chart.name}.json", statechart_json, (chart, folder)


def json_text(model: Json) -> str:
    """A model as a text that is the same on every machine."""
    return json.dumps(model, indent=2, ensure_ascii=False) + "\n"


def folder_of(system: System) -> PurePath | None:
    """The folder of the system's file: what paths are made relative to."""
    return PurePath(system.span.source.path).parent if system.span is not None else None


def sag_json(sag: Sag, system: str, folder: PurePath | None = None) -> Json:
    """Actors and goals."""
    actors = [{"name": item.name, "span": _span(item.span, folder)} for item in sag.actors]
    goals = [
        {
            "name": item.name,
            "depender": item.depender,
            "dependees": list(item.dependees),
            "requirements": item.requirements,
            "span": _span(item.span, folder),
        }
        for item in sag.goals
    ]
    return {"format": FORMAT, "system": system, "actors": actors, "goals": goals}


def suc_json(suc: Suc, system: str, folder: PurePath | None = None) -> Json:
    """Roles with their types, and use cases."""
    roles = [
        {"name": item.name, "type": item.type.value, "span": _span(item.span, folder)} for item in suc.roles
    ]
    usecases = [
        {
            "name": item.name,
            "participants": list(item.participants),
            "includes": list(item.includes),
            "requirements": item.requirements,
            "realises": list(item.realises),
            "span": _span(item.span, folder),
        }
        for item in suc.usecases
    ]
    return {"format": FORMAT, "system": system, "roles": roles, "usecases": usecases}


def aip_json(aip: Aip, system: str, folder: PurePath | None = None) -> Json:
    """A protocol: participants with their processes, outcomes, clauses."""
    clauses = [
        {
            "kind": item.kind,
            "first": list(item.first),
            "second": list(item.second),
            "count": item.count,
            "within": _duration(item.within),
            "text": item.text,
            "span": _span(item.span, folder),
        }
        for item in aip.clauses
    ]
    reached = [{"outcome": item.text, "when": list(item.when)} for item in aip.outcomes if item.when]
    return {
        "format": FORMAT,
        "name": aip.name,
        "system": system,
        "participants": [_participant(item, folder) for item in aip.participants],
        "outcomes": [item.text for item in aip.outcomes],
        **({"reached": reached} if reached else {}),
        "clauses": clauses,
        "span": _span(aip.span, folder),
    }


def srm_json(srm: Srm, activities: Iterable[Activity], system: str, folder: PurePath | None = None) -> Json:
    """A role: what it plays, its formulas, and its activities with what is said of them."""
    return {
        "format": FORMAT,
        "name": srm.name,
        "system": system,
        **({"includes": list(srm.includes)} if srm.includes else {}),
        "plays": [_plays(item, folder) for item in srm.plays],
        "variables": _variables(srm.variables, folder),
        "formulas": _formulas(srm.formulas, folder),
        "activities": [_activity(item, folder) for item in activities],
        "modules": [_module(item, folder) for item in srm.modules],
        "functionalities": [
            {
                "name": item.name,
                "technology": item.technology,
                "permissions": item.permissions,
                "environment": item.environment,
                "algorithm": item.algorithm,
                "span": _span(item.span, folder),
            }
            for item in srm.functionalities
        ],
        "capabilities": [
            {
                "name": item.name,
                "activities": list(item.activities),
                "description": item.description,
                "span": _span(item.span, folder),
            }
            for item in srm.capabilities
        ],
        "span": _span(srm.span, folder),
    }


def _plays(item: Plays, folder: PurePath | None) -> Json:
    return {
        "protocol": item.protocol,
        "participant": item.participant,
        "name": item.name,
        "bindings": dict(item.bindings),
        **({"given": {n: value_text(v) for n, v in item.inputs}} if item.inputs else {}),
        **({"results": dict(item.results)} if item.results else {}),
        **({"busy": item.busy.text} if item.busy is not None else {}),
        "span": _span(item.span, folder),
    }


def statechart_json(chart: Statechart, folder: PurePath | None = None) -> Json:
    """An EAC or IAC: states in document order, transitions in the template's order."""
    states = [
        {
            "label": node.label,
            "name": node.name,
            "type": node.type.value,
            "parent": node.parent,
            "activity": node.activity,
            "origin": str(node.origin),
            "span": _span(node.span, folder),
            **_arguments(node),
        }
        for node in chart.states
    ]
    transitions = []
    for item in chart.transitions:
        expression = item.expression
        condition = expression.condition
        marks: Json = {"first": True} if item.first else {}
        if not item.changes_state:
            marks["kind"] = item.kind.value
        if item.into:
            marks["into"] = list(item.into)
        if item.resume:
            marks["resume"] = True
        if item.reactive:
            marks["reactive"] = True
        if expression.weight is not None:
            marks["weight"] = expression.weight
        transitions.append(
            {
                "name": item.name,
                "source": item.source,
                "target": item.target,
                "event": events_text(expression),
                "condition": value_text(condition, expand=True) if condition is not None else None,
                "actions": [action_text(action, expand=True) for action in expression.actions],
                "priority": item.priority,
                **marks,
                "origin": str(item.origin),
                "span": _span(item.span, folder),
            }
        )
    return {
        "format": FORMAT,
        "name": chart.name,
        "system": chart.system,
        "states": states,
        "transitions": transitions,
        "variables": [
            {
                "name": item.name,
                "type": str(item.type),
                **_bounds(item.bounds, item.length),
                "initial": _initial(item.initial),
            }
            for item in chart.variables
        ],
        "regions": [
            {
                "label": item.label,
                "reads": [str(channel) for channel in item.reads],
                "writes": [str(channel) for channel in item.writes],
            }
            for item in chart.regions
        ],
        "modules": [_module(item, folder) for item in chart.modules],
    }


def _arguments(node: State) -> Json:
    if not node.arguments:
        return {}
    given = [{"name": item.name, "value": value_text(item.value, expand=True)} for item in node.arguments]
    return {"arguments": given}


def _parameters(parameters: Iterable[Parameter]) -> Json:
    found = [{"name": item.name, "type": str(item.type)} for item in parameters]
    return {"parameters": found} if found else {}


# ---- parts ---------------------------------------------------------------------------------------


def _participant(item: Participant, folder: PurePath | None) -> Json:
    return {
        "name": item.name,
        "least": item.least,
        "most": item.most,
        "engage": list(item.engage),
        **({"plays": [_plays(one, folder) for one in item.plays]} if item.plays else {}),
        **({"given": _inputs(item.inputs, folder)} if item.inputs else {}),
        "variables": _variables(item.variables, folder),
        **({"results": list(item.results)} if item.results else {}),
        "sends": [f"{message.performative} {message.message}" for message in item.sends],
        **_senders(item),
        "receives": [f"{message.performative} {message.message}" for message in item.receives],
        "formulas": _formulas(item.formulas, folder),
        "span": _span(item.span, folder),
    }


def _senders(item: Participant) -> Json:
    """Which activities send what, as far as the protocol says."""
    found = [
        {
            "message": f"{message.performative} {message.message}",
            "activities": list(message.by),
            "repeatedly": message.repeatedly,
        }
        for message in item.sends
        if message.by
    ]
    return {"senders": found} if found else {}


def _variables(variables: Iterable[DeclaredVariable], folder: PurePath | None) -> list[Json]:
    return [
        {
            "name": item.name,
            "type": str(item.type),
            **_bounds(item.bounds, item.length),
            "initial": _initial(item.initial),
            "span": _span(item.span, folder),
        }
        for item in variables
    ]


def _bounds(bounds: Bounds | None, length: int | None) -> Json:
    found: Json = {} if bounds is None else {"bounds": {"least": bounds.least, "most": bounds.most}}
    return found if length is None else {**found, "length": length}


def _inputs(inputs: Iterable[DeclaredVariable], folder: PurePath | None) -> list[Json]:
    return [{"name": i.name, "type": str(i.type), "span": _span(i.span, folder)} for i in inputs]


def _formulas(formulas: Iterable[NamedFormula], folder: PurePath | None) -> list[Json]:
    return [
        {
            "name": item.name,
            "formula": canonical(item.formula),
            "span": _span(item.span, folder),
            **_parameters(item.parameters),
        }
        for item in formulas
    ]


def _activity(item: Activity, folder: PurePath | None) -> Json:
    found: Json = {
        "name": item.name,
        "uses": list(item.uses),
        "every": _duration(item.every),
        "takes": _duration(item.takes),
        "kind": item.kind,
        "reads": [_subscription(read) for read in item.reads],
        "writes": [str(channel) for channel in item.writes] + list(item.writes_variables),
    }
    if item.reads_variables:
        found["reads_variables"] = list(item.reads_variables)
    found |= _parameters(item.parameters)
    if item.within is not None:
        found["within"] = _duration(item.within)
    if item.ends:
        found["ends"] = list(item.ends)
    if item.simulated:
        found["simulated"] = True
    if item.waits:
        found["waits"] = True
    if item.guarantees:
        found["guarantees"] = [_guarantee(one, folder) for one in item.guarantees]
    return {**found, "span": _span(item.span, folder)}


def _guarantee(item: Guarantee, folder: PurePath | None) -> Json:
    found: Json = {"never": _sent(item.said)}
    if item.earlier is not None:
        found |= {"within": _duration(item.within), "after": _sent(item.earlier)}
    return {**found, "span": _span(item.span, folder)}


def _sent(item: Sent) -> Json:
    return {
        "channels": [str(channel) for channel in item.channels],
        "name": item.called,
        "condition": None if item.condition is None else value_text(item.condition),
    }


def _module(item: Module, folder: PurePath | None) -> Json:
    said = _activity(item.statement, folder)
    return {**said, "kind": item.statement.kind or "thread", "target": item.target or None}


def _subscription(item: Subscription) -> Json:
    name = item.topic if item.channel is None else str(item.channel)
    return {
        "channel": name,
        "host": item.host,
        "reach": item.reach,
        "history": _duration(item.history) if item.history else None,
    }


def _initial(literal: Literal) -> object:
    """An initial value in JSON: a duration as in the source; null for an agent or a message."""
    if literal.type.begins_unset:
        return None
    if literal.type.kind is Kind.LIST:
        return []
    if literal.type == DURATION:
        return duration_text(int(literal.value))
    return literal.value


def _duration(nanoseconds: int | None) -> str | None:
    return duration_text(nanoseconds) if nanoseconds is not None else None


def _span(span: Span, folder: PurePath | None) -> Json:
    line, column = span.source.position(span.start)
    end_line, end_column = span.source.position(span.end)
    return {
        "file": shown_path(span.source.path, folder),
        "line": line,
        "column": column,
        "end_line": end_line,
        "end_column": end_column,
    }


def shown_path(path: str, folder: PurePath | None) -> str:
    """A path from `folder`, with forward slashes; only its name, if it cannot be told from there.

    That of a file of the standard library stays as it is.
    """
    if is_library_path(path):
        return path
    place = PurePath(path)
    if not place.is_absolute():
        if folder is None or folder.is_absolute():
            return place.as_posix()
        return posixpath.relpath(place.as_posix(), folder.as_posix())
    if folder is None or not folder.is_absolute():
        return place.name
    up = 0
    base = folder
    while not place.is_relative_to(base) and base != base.parent:
        base, up = base.parent, up + 1
    return (
        PurePath(*[".."] * up, place.relative_to(base)).as_posix()
        if place.is_relative_to(base)
        else place.name
    )


def schema(model: str) -> Json:
    """The JSON Schema (draft 2020-12) of "sag", "suc", "aip", "srm" or "statechart"."""
    from importlib.resources import files

    text = (files("aseme_dsl.amola") / "schemas" / f"{model}.schema.json").read_text("utf-8")
    found: Json = json.loads(text)
    return found


__all__ = [
    "FORMAT",
    "aip_json",
    "folder_of",
    "json_text",
    "models_json",
    "sag_json",
    "schema",
    "shown_path",
    "srm_json",
    "statechart_json",
    "suc_json",
]
