"""What every backend for agents writes: of a role its plan and its step class, and the user's activities."""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

from aseme_dsl.amola.expression import duration_text
from aseme_dsl.amola.messages import Kind, Type
from aseme_dsl.amola.srm import Activity, Module
from aseme_dsl.amola.statechart import Statechart, StateType
from aseme_dsl.amola.system import System
from aseme_dsl.backends.backend import ACTIVITIES, DEFAULT, NOTHING_KNOWN, Artefact, BackendOptions, Known
from aseme_dsl.codegen.messages import generate_messages, meaning_of_messages
from aseme_dsl.codegen.place import in_docstring
from aseme_dsl.codegen.plan import Sections, plan_sections, protocol_versions
from aseme_dsl.codegen.seen import seen_by_roles
from aseme_dsl.codegen.step.generate import StepCode, generate_step
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.naming import class_name, module_name, usable
from aseme_dsl.source import is_library_path

if TYPE_CHECKING:
    from jinja2 import Environment


@dataclass(frozen=True, slots=True)
class Filled:
    """A role's files, the hash of what they were made from, and the system as far as the role sees it."""

    files: tuple[Artefact, ...]
    model: str
    seen: System


def environment(options: BackendOptions, own: Path | None = None) -> Environment:
    """Templates by name: those of the user, of the backend (in the folder `own`), or shared.

    As long as none of the user's has changed, it is the same object.
    """
    files = sorted(options.templates.rglob("*")) if options.templates else []
    return _environment(own, options.templates, tuple((path, path.stat().st_mtime_ns) for path in files))


@lru_cache(16)
def _environment(own: Path | None, theirs: Path | None, stamps: tuple[tuple[Path, int], ...]) -> Environment:
    from jinja2 import ChoiceLoader, Environment, FileSystemLoader, StrictUndefined

    folders = [theirs, own, Path(__file__).parent / "templates"]
    made = Environment(
        loader=ChoiceLoader([FileSystemLoader(folder) for folder in folders if folder is not None]),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
        auto_reload=False,
    )
    made.filters["quoted"] = repr
    made.filters["in_docstring"] = in_docstring
    made.filters["imports"] = imports
    made.filters["python_type"] = _python_type
    made.filters["duration"] = duration_text
    made.filters["class_name"] = class_name
    made.filters["module_name"] = module_name
    made.filters["package"] = usable
    return made


def source_of(system: System) -> str:
    """The name of the file that a system stands in."""
    return PurePath(system.span.source.path).name if system.span else system.name


def messages_file(system: System, known: Known = NOTHING_KNOWN) -> Artefact:
    """The messages of a system as Python classes."""
    return known.recall(_messages_file, known.same("of messages", with_types(system)))


def _messages_file(system: System) -> Artefact:
    return Artefact(f"{system.name}/messages.py", generate_messages(system))


def with_types(system: System) -> System:
    """Only the types of a system, and the topics in which it has them."""
    return System(
        system.name,
        enums=system.enums,
        messages=system.messages,
        topics=system.topics,
        protos=system.protos,
    )


def role_files(templates: Environment, system: System, options: BackendOptions) -> list[Filled]:
    """The plan of each role, to read, and the class that runs it."""
    known = options.known
    roles = seen_roles(system, known)
    versions = protocol_versions(system)
    types = known.recall(meaning_of_messages, known.same("of messages", with_types(system)))
    source = source_of(system)
    played = {seen.iacs[0].name: tuple((aip.name, versions[aip.name]) for aip in seen.aips) for seen in roles}
    plans = known.each(_plan, zip(roles, known.same_values("versions", played).values(), strict=True))
    steps = known.each(_step, zip(roles))
    # A user's own templates may read any part of the system.
    shown = [system if options.templates else seen for seen in roles]
    texts = [known.whole(plan.text) for plan in plans]
    filled = zip(shown, roles, plans, steps, texts, strict=True)
    return list(known.each(_filled, filled, templates, source, types))


def seen_roles(system: System, known: Known) -> list[System]:
    """For each role the system as far as it sees it: the same object as long as all that is the same."""
    shared = replace(
        system,
        enums=known.same("enums", system.enums),
        messages=known.same("messages", system.messages),
        topics=known.same("topics", system.topics),
        functions=known.same("functions", system.functions),
        teams=known.same("teams", system.teams),
    )
    found = {item.iacs[0].name: item for item in seen_by_roles(shared)}
    return list(known.same_values("seen", found).values())


def role_models(system: System) -> dict[str, str]:
    """The hash of the model of each role, as its agents and traces have it."""
    versions = protocol_versions(system)
    types = meaning_of_messages(with_types(system))
    return {
        seen.iacs[0].name: _hash(
            _plan(seen, [(aip.name, versions[aip.name]) for aip in seen.aips]).text, types
        )
        for seen in seen_by_roles(system)
    }


@dataclass(frozen=True, slots=True)
class _Plan:
    """The sections of a role's plan, and the text that its hash is of."""

    sections: Sections
    text: str


def _plan(seen: System, versions: Iterable[tuple[str, str]]) -> _Plan:
    chart = seen.iacs[0]
    sections = plan_sections(seen, chart, dict(versions))
    return _Plan(sections, repr((chart.name, seen.name, sections)))


def _filled(
    system: System,
    seen: System,
    plan: _Plan,
    step: StepCode,
    plan_text: str,
    templates: Environment,
    source: str,
    messages: str,
) -> Filled:
    chart = seen.iacs[0]
    folder = f"{system.name}/{usable(chart.name)}"
    model = _hash(plan_text, messages)
    given = {"system": system, "chart": chart, "source": source, "model": model}
    constructors = sorted({item.partition("(")[0] for _, items in plan.sections for item in items} - {""})
    declared = templates.get_template("plan.py.j2").render(
        given, sections=plan.sections, constructors=["Plan", *constructors]
    )
    running = templates.get_template("step.py.j2").render(given, step=step, uses=step.used.__contains__)
    files = (Artefact(f"{folder}/plan.py", declared), Artefact(f"{folder}/step.py", tidy(running)))
    return Filled(files, model, seen)


def _step(seen: System) -> StepCode:
    chart = seen.iacs[0]
    return generate_step(seen, chart, f"{class_name(chart.name)}Step")


def rendered(
    templates: Environment, name: str, path: str, known: Mapping[str, object], *, kept: bool = False
) -> Artefact:
    """A template, filled, as a file."""
    return Artefact(path, templates.get_template(name).render(known), kept)


def system_file(
    templates: Environment, system: System, roles: Sequence[Filled], *, shown: bool = False
) -> Artefact:
    """What every agent of a system carries: its team, and the classes that run its roles; if the roles are
    shown as agents with behaviours, the classes of these, too."""
    known = {
        "system": system,
        "source": source_of(system),
        "model": _hash(*(role.model for role in roles)),
        "sources": repr(_sources(system)),
        "shown": shown,
        "agents": [agent for team in system.teams for agent in team.agents],
    }
    return rendered(templates, "system.py.j2", f"{system.name}/__init__.py", known)


def _sources(system: System) -> dict[str, str]:
    """The files of a system but those of the standard library, by their paths beside the first."""
    if system.span is None:
        return {}
    root = system.span.source
    folder = Path(root.path).absolute().parent
    others = [item for item in system.sources if item.path != root.path and not is_library_path(item.path)]
    whole = {item.path: item.text for item in system.sources}  # what is rebuilt was read in parts
    found = {Path(root.path).name: whole.get(root.path, root.text)}
    for item in others:
        path = os.path.relpath(Path(item.path).absolute(), folder)
        found[path.replace(os.sep, "/")] = item.text
    return found


def activity_files(
    templates: Environment, system: System, options: BackendOptions = DEFAULT
) -> Iterator[Artefact]:
    """First versions of the activities that have code, and of the modules found by their name."""
    yield from _activities(templates, system, options.known)
    yield from _modules(templates, system)


def _activities(templates: Environment, system: System, known: Known) -> Iterator[Artefact]:
    users: dict[str, list[str]] = {}
    performed = known.each(_performed, zip(system.iacs))
    for chart, names in zip(system.iacs, performed, strict=True):
        for name in names:
            users.setdefault(name, []).append(chart.name)
    described = {item.name: item for item in system.activities}
    coded = [name for name in sorted(users) if name not in described or described[name].has_code]
    roles = known.same_values("users", {name: tuple(users[name]) for name in coded})
    said = known.same_values("said", {name: described.get(name) for name in roles})
    items = zip(roles, said.values(), roles.values(), strict=True)
    yield from known.each(_activity, items, templates, system.name, source_of(system))


def _performed(chart: Statechart) -> tuple[str, ...]:
    """The activities of a role."""
    found = (node.activity for node in chart.states if node.type is StateType.BASIC)
    return tuple(dict.fromkeys(name for name in found if name is not None))


def _activity(
    name: str,
    activity: Activity | None,
    roles: Sequence[str],
    templates: Environment,
    system: str,
    source: str,
) -> Artefact:
    given = {
        "name": name,
        "source": source,
        "activity": activity,
        "imports": _message_imports(system, activity),
        "roles": roles,
    }
    return rendered(templates, "activity.py.j2", f"{ACTIVITIES}/{module_name(name)}.py", given, kept=True)


def _modules(templates: Environment, system: System) -> Iterator[Artefact]:
    users: dict[str, list[tuple[str, Module]]] = {}
    for chart in system.iacs:
        for module in chart.modules:
            if not module.target:
                users.setdefault(module.name, []).append((chart.name, module))
    for name, found in sorted(users.items()):
        given = {
            "module": found[0][1],
            "said": found[0][1].statement,
            "every": duration_text(found[0][1].statement.every or 0),
            "source": source_of(system),
            "roles": [role for role, _ in found],
        }
        yield rendered(templates, "module.py.j2", f"{ACTIVITIES}/{module_name(name)}.py", given, kept=True)


_PYTHON = {"double": "float", "string": "str", "duration": "int"}


def _python_type(kind: Type) -> str:
    """A type as Python annotates it; a duration is in ns."""
    return _PYTHON.get(str(kind), str(kind))


def _message_imports(system: str, activity: Activity | None) -> list[str]:
    """The line that brings the messages and enums that an activity is given."""
    parameters = activity.parameters if activity is not None else ()
    names = {item.type.name for item in parameters if item.type.kind in (Kind.ENUM, Kind.MESSAGE)}
    line = imports(sorted(names), f"monas.{system}.messages")
    return [line] if line else []


def imports(names: Sequence[str], module: str) -> str:
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


def tidy(text: str) -> str:
    """Two blank lines at the most, one newline at the end."""
    return re.sub(r"\n{4,}", "\n\n\n", text).rstrip() + "\n"
