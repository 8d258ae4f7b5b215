"""The monas backend: fills its templates with what `codegen` says."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

from aseme_dsl.amola.expression import duration_text
from aseme_dsl.amola.messages import Kind, Type
from aseme_dsl.amola.srm import Activity, Module
from aseme_dsl.amola.statechart import NodeType, Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.backends.backend import Artefact, BackendOptions
from aseme_dsl.codegen.messages import generate_messages
from aseme_dsl.codegen.place import in_docstring
from aseme_dsl.codegen.plan import plan_sections
from aseme_dsl.codegen.step import generate_step
from aseme_dsl.runtime.naming import class_name, module_name, usable

if TYPE_CHECKING:
    from jinja2 import Environment

ACTIVITIES = "activities"
"""The folder of activity templates, relative to the backend's; a project may choose another."""


def _environment(options: BackendOptions) -> Environment:
    from jinja2 import ChoiceLoader, Environment, FileSystemLoader, StrictUndefined

    own = FileSystemLoader(Path(__file__).parent / "templates")
    theirs = [FileSystemLoader(options.templates)] if options.templates else []
    environment = Environment(
        loader=ChoiceLoader([*theirs, own]),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
    environment.filters["quoted"] = repr
    environment.filters["in_docstring"] = in_docstring
    environment.filters["imports"] = _imports
    environment.filters["python_type"] = _python_type
    environment.filters["duration"] = duration_text
    environment.filters["class_name"] = class_name
    environment.filters["module_name"] = module_name
    environment.filters["package"] = usable
    return environment


@dataclass(frozen=True, slots=True)
class MonasBackend:
    """Emits per role `plan.py` and `step.py`, one `messages.py`, and a class template per activity."""

    name: str = "monas"

    def generate(self, system: System, options: BackendOptions) -> tuple[Artefact, ...]:
        """The package of a system, and the activities under `activities/`."""
        environment = _environment(options)
        source = PurePath(system.span.source.path).name if system.span else system.name
        artefacts = [Artefact(f"{system.name}/messages.py", generate_messages(system))]
        hashes: list[str] = []
        for chart in system.iacs:
            folder = f"{system.name}/{usable(chart.name)}"
            sections = plan_sections(system, chart)
            model = _hash(repr((chart.name, system.name, sections)), artefacts[0].text)
            hashes.append(model)
            known = {"system": system, "chart": chart, "source": source, "model": model}
            constructors = sorted({item.partition("(")[0] for _, items in sections for item in items} - {""})
            plan = environment.get_template("plan.py.j2").render(
                known, sections=sections, constructors=["Plan", *constructors]
            )
            code = generate_step(system, chart, f"{class_name(chart.name)}Step")
            step = environment.get_template("step.py.j2").render(known, step=code, uses=code.uses)
            package = environment.get_template("role.py.j2").render(known)
            artefacts += [
                Artefact(f"{folder}/__init__.py", package),
                Artefact(f"{folder}/plan.py", plan),
                Artefact(f"{folder}/step.py", _tidy(step)),
            ]
        package = environment.get_template("system.py.j2").render(
            system=system,
            source=source,
            model=_hash(*hashes),
            agents=[agent for team in system.teams for agent in team.agents],
        )
        artefacts.insert(0, Artefact(f"{system.name}/__init__.py", package))
        artefacts += self._activities(environment, system, source)
        artefacts += self._modules(environment, system, source)
        return tuple(artefacts)

    def _activities(self, environment: Environment, system: System, source: str) -> list[Artefact]:
        template = environment.get_template("activity.py.j2")
        users: dict[str, list[Statechart]] = {}
        for chart in system.iacs:
            for node in chart.nodes:
                if node.type is NodeType.BASIC and node.activity is not None:
                    charts = users.setdefault(node.activity, [])
                    if chart not in charts:
                        charts.append(chart)
        return [
            Artefact(
                f"{ACTIVITIES}/{module_name(name)}.py",
                template.render(
                    name=name,
                    source=source,
                    activity=system.activity(name),
                    imports=_message_imports(system, system.activity(name)),
                    roles=[chart.name for chart in users[name]],
                ),
                kept=True,
            )
            for name in sorted(users)
        ]

    def _modules(self, environment: Environment, system: System, source: str) -> list[Artefact]:
        """A class for each module whose code is found by its name."""
        template = environment.get_template("module.py.j2")
        users: dict[str, list[tuple[str, Module]]] = {}
        for chart in system.iacs:
            for module in chart.modules:
                if not module.target:
                    users.setdefault(module.name, []).append((chart.name, module))
        return [
            Artefact(
                f"{ACTIVITIES}/{module_name(name)}.py",
                template.render(
                    module=found[0][1],
                    said=found[0][1].statement,
                    every=duration_text(found[0][1].statement.every or 0),
                    source=source,
                    roles=[role for role, _ in found],
                ),
                kept=True,
            )
            for name, found in sorted(users.items())
        ]


_PYTHON = {"double": "float", "string": "str", "duration": "int"}


def _python_type(kind: Type) -> str:
    """A type as Python annotates it; a duration is in ns."""
    return _PYTHON.get(str(kind), str(kind))


def _message_imports(system: System, activity: Activity | None) -> list[str]:
    """The line that brings the messages and enums that an activity is given."""
    parameters = activity.parameters if activity is not None else ()
    names = {item.type.name for item in parameters if item.type.kind in (Kind.ENUM, Kind.MESSAGE)}
    line = _imports(sorted(names), f"monas.{system.name}.messages")
    return [line] if line else []


def _imports(names: Sequence[str], module: str) -> str:
    """`from module import a, b`, over several lines where one is too short; nothing without names."""
    if not names:
        return ""
    constants = sorted(name for name in names if name.isupper())
    others = sorted((n for n in names if not n.isupper()), key=lambda n: (n[:1].islower(), n))
    line = f"from {module} import {', '.join([*constants, *others])}"
    if len(line) <= 88:
        return line
    return "\n".join([f"from {module} import (", *(f"    {name}," for name in [*constants, *others]), ")"])


def _hash(*texts: str) -> str:
    return hashlib.sha256("\0".join(texts).encode()).hexdigest()[:16]


def _tidy(text: str) -> str:
    """Two blank lines at the most, one newline at the end."""
    return re.sub(r"\n{4,}", "\n\n\n", text).rstrip() + "\n"


BACKEND = MonasBackend()
