"""How each rule of the grammar is laid out: the one place that names the rules.

A rule that is added to a `.tx` file gets an entry here; tests/grammar/test_layout_rules.py says which one is
missing. Everything else (blanks, comments, where long lines are broken) follows from the tokens.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from types import MappingProxyType
from typing import TypeAlias

from aseme_dsl.records import dataclass


@dataclass(frozen=True, slots=True)
class Line:
    """An entry on one line; broken where it is too long.

    `columns`: which parts begin a column of the table that neighbouring entries make. A part is named by its
    attribute, its keyword or its rule. `table`: entries of one table are aligned; the rule's name if empty.
    `clauses`: parts that may stand on lines of their own: where the author put them there, they stay there.
    `breaks`: keywords before which a line that is too long may be broken. `tight`: what has no blank before
    it. `padded`: columns in which words of different lengths are followed by what is aligned: True always,
    False only where one stands below another.
    """

    columns: Mapping[str, int] = field(default_factory=dict)
    table: str = ""
    clauses: frozenset[str] = frozenset()
    breaks: frozenset[str] = frozenset()
    tight: str = ""
    padded: Mapping[int, bool] = field(default_factory=dict)
    apart: int = -1
    """A column that has two blanks before it."""
    loose: str = ""
    """A part with which a cell is not counted for the width of its column."""


@dataclass(frozen=True, slots=True)
class Braces:
    """An entry with entries of its own between braces.

    `gap`: how many blanks are between two entries if all stand on one line.
    """

    gap: int = 2
    tight: str = ""


@dataclass(frozen=True, slots=True)
class Words:
    """Braces in which the layout knows no more than words: lines stay lines."""

    tight: str = ""


@dataclass(frozen=True, slots=True)
class Part:
    """Stands inside a line."""

    breaks: frozenset[str] = frozenset()
    tight: str = ""


Shape: TypeAlias = Line | Braces | Words | Part

_USE_CASE = {"By": 1, "Includes": 1, "Realises": 1, "Requirements": 1}
_ACTIVITY = {
    "Every": 1,
    "Takes": 1,
    "Simulated": 1,
    "Waits": 1,
    "Within": 3,
    "As": 1,
    "Uses": 2,
    "Reads": 3,
    "Writes": 3,
    "Ends": 4,
    "Guarantees": 3,
}
_MODULE = {**_ACTIVITY, "ModuleCode": 3}
_GOAL = {"Depends": 1, "Requirements": 2}

SHAPES: Mapping[str, Shape] = MappingProxyType(
    {
        # aseme.tx
        "File": Line(),
        "System": Line(),
        "Import": Line(),
        # messages.tx
        "Enum": Braces(gap=1),
        "EnumConstant": Line({"=": 1}),
        "Message": Braces(),
        "Field": Line({"name": 1, "=": 2}, loose="label"),
        "Topic": Braces(),
        "TopicMessages": Line({"messages": 1}),
        "TopicFrom": Part(),
        "TopicEvery": Part(),
        "TopicExpires": Part(),
        "TopicFlag": Part(),
        "Function": Line(tight="(", breaks=frozenset("=")),
        "Parameter": Part(),
        # requirements.tx
        "Sag": Braces(),
        "Actor": Braces(),
        "Goal": Line(_GOAL, clauses=frozenset(_GOAL), apart=2),
        "Depends": Part(),
        "Requirements": Part(),
        "Suc": Braces(),
        "Roles": Line({":": 1}),
        "UseCase": Line(_USE_CASE, clauses=frozenset(_USE_CASE)),
        "By": Part(),
        "Includes": Part(),
        "Realises": Part(),
        # protocols.tx
        "Aip": Braces(),
        "Outcome": Line(breaks=frozenset(("when",))),
        "Participant": Braces(),
        "Engage": Line({"text": 1}, "participant"),
        "Given": Line({":": 1}),
        "Result": Line({":": 1, "=": 2}),
        "Sends": Line({"messages": 1}, "participant"),
        "Receives": Line({"messages": 1}, "participant"),
        "SentMessage": Part(),
        "AgentMessage": Part(),
        "Process": Line({"=": 1}, "participant", tight="("),
        "Clause": Line(),
        "AtMost": Part(),
        "LeadsTo": Part(breaks=frozenset(("leads", "within"))),
        "Before": Part(breaks=frozenset(("before",))),
        "Places": Part(),
        "Place": Part(),
        # roles.tx
        "Srm": Braces(),
        "Inclusion": Line(),
        "Plays": Line(),
        "Part": Part(breaks=frozenset(("with",))),
        "Busy": Part(breaks=frozenset(("when",))),
        "Binding": Part(),
        "Capability": Line(breaks=frozenset("=")),
        "Liveness": Braces(),
        "Activities": Braces(),
        "Activity": Line(_ACTIVITY, clauses=frozenset(_ACTIVITY), padded={3: False}, tight="("),
        "ActivityParameter": Part(),
        "Modules": Braces(),
        "Module": Line(_MODULE, clauses=frozenset(_MODULE), padded={3: False}),
        "ModuleCode": Part(),
        "Every": Part(),
        "Takes": Part(),
        "Simulated": Part(),
        "Waits": Part(),
        "Within": Part(),
        "As": Part(),
        "Uses": Part(),
        "Reads": Part(),
        "Read": Part(),
        "Writes": Part(),
        "Ends": Part(),
        "Guarantees": Part(breaks=frozenset(("within", "after"))),
        "Sent": Part(),
        "Functionality": Braces(),
        "FunctionalityText": Line({"text": 1}),
        # formulas.tx, expressions.tx
        "Formula": Line({"=": 1}, tight="("),
        "FormulaParameter": Part(),
        "Control": Braces(),
        "Way": Line({":": 1}, padded={0: True}),
        "LabelledWay": Line({"->": 1, ":": 2}),
        "Let": Line({"=": 1}),
        "Var": Line({":": 1, "=": 2}, tight="["),
        # statecharts.tx
        "Statechart": Braces(),
        "StandingWay": Line({"state": 1, ":": 2}),
        "ChartNode": Line({"type": 1, "name": 2, "activity": 3}),
        # deployment.tx
        "Team": Braces(),
        "Agents": Line({":": 1}, breaks=frozenset(("with",))),
        "Setting": Part(),
        "AgentName": Part(tight="["),
        "Scenario": Words(),
        "Property": Words(),
        "Braced": Words(),
        "Braced2": Words(),
        "Braced3": Words(),
    }
)

FORMULAS = frozenset(("FormulaToken", "ProcessToken", "TermToken"))
EXPRESSIONS = frozenset(
    ("ExpressionToken", "ControlToken", "SettingToken", "BindingToken", "BusyToken", "SentToken")
)
"""The terminals whose lists have operators of their own (spacing.py)."""

DROPPED = frozenset(("Separator",))
"""What may be written and means nothing."""
