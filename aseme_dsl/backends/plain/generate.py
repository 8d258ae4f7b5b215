"""The plain backend: fills its templates with what `codegen/plain` says, or says what it cannot do."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.backends.backend import Artefact, BackendOptions, Refused
from aseme_dsl.backends.shared.generate import environment, messages_file, rendered, source_of, tidy
from aseme_dsl.codegen.plain.generate import generate_plain
from aseme_dsl.codegen.plain.options import TAKEN, PlainOptions
from aseme_dsl.codegen.plain_limits import Limit, limits
from aseme_dsl.diagnostics import Diagnostic, Related
from aseme_dsl.diagnostics.problems.running import AgentFeature, NotPlain, SingleFeature, Unsupported
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.naming import class_name, usable

WATCHED = "_watched"
"""How the module ends whose class tells what happens in it."""

_STANDARD = (
    ("collections.abc", ("Callable", "Mapping")),
    ("random", ("Random",)),
    ("typing", ("Any", "ClassVar")),
)
_RUNTIME = ("ABSENT", "NEVER", "ROUNDS", "UNSTARTED", "Plain")
"""What a module imports where it uses it."""


@dataclass(frozen=True, slots=True)
class PlainBackend:
    """Emits per role the class of its statechart, and one that tells what happens in it; `messages.py`."""

    name: str = "plain"

    def generate(self, system: System, options: BackendOptions) -> tuple[Artefact, ...]:
        """The package of a system.

        Raises:
            Refused: a role does what only an agent can do.
        """
        problems = [problem for chart in system.iacs for problem in problems_of(system, chart)]
        if problems:
            raise Refused(tuple(problems))
        templates = environment(options, Path(__file__).parent / "templates")
        called = class_names(system)
        modules = module_names(system, WATCHED)
        roles = [
            (chart.name, modules[chart.name], classes_of(called[chart.name])[:2]) for chart in system.iacs
        ]
        names = sorted(name for _, _, classes in roles for name in classes)
        exported = f"[{', '.join(map(_quoted, names))}]"
        known = {"system": system, "source": source_of(system), "roles": roles, "exported": exported}
        artefacts = [
            rendered(templates, "plain_system.py.j2", f"{system.name}/__init__.py", known),
            messages_file(system),
        ]
        for chart in system.iacs:
            module = modules[chart.name]
            path = f"{system.name}/{module}"
            name = called[chart.name]
            artefacts.append(Artefact(f"{path}.py", module_text(system, chart, options, name=name)))
            watched = PlainOptions(watched=True, gates=False)
            told = module_text(system, chart, options, watched, board=module, name=name)
            artefacts.append(Artefact(f"{path}{WATCHED}.py", told))
        return tuple(artefacts)


def class_names(system: System) -> dict[str, str]:
    """The class of each role: no other class of the package, no message and no enum is called so."""
    found: dict[str, str] = {}
    taken = TAKEN.union((m.name for m in system.messages), (e.name for e in system.enums))
    for chart in system.iacs:
        wish = name = class_name(chart.name)
        number = 1
        while not taken.isdisjoint(classes_of(name)):
            name, number = f"{wish}Chart{number if number > 1 else ''}", number + 1
        taken |= {*classes_of(name)}
        found[chart.name] = name
    return found


def classes_of(name: str) -> tuple[str, str, str]:
    """The class of a role's statechart and what belongs to it: its blackboard, the class that is watched."""
    return name, f"{name}Blackboard", f"Watched{name}"


def _quoted(name: str) -> str:
    return f'"{name}"'


def module_names(system: System, suffix: str) -> dict[str, str]:
    """The module of each role: no other is called so, nor so with the suffix of the role's second module."""
    found: dict[str, str] = {}
    taken = {"messages"}
    for chart in system.iacs:
        name = usable(chart.name)
        while not taken.isdisjoint({name, name + suffix}):
            name += "_"
        taken |= {name, name + suffix}
        found[chart.name] = name
    return found


def module_text(
    system: System,
    chart: Statechart,
    options: BackendOptions,
    plain: PlainOptions | None = None,
    *,
    board: str = "",
    name: str = "",
) -> str:
    """The module with the class of a role; the blackboard is of its module `board`, if one is named.

    `name` is what `class_names` calls it, if that is known.
    """
    templates = environment(options, Path(__file__).parent / "templates")
    name, its_board, watched = classes_of(name or class_names(system)[chart.name])
    is_watched = plain is not None and plain.watched
    code = generate_plain(system, chart, watched if is_watched else name, plain, its_board)
    standard = [
        f"from {module} import {', '.join(found)}"
        for module, names in _STANDARD
        if (found := [name for name in names if name in code.used])
    ]
    used = [name for name in _RUNTIME if name in code.used]
    known = {
        "system": system,
        "chart": chart,
        "source": source_of(system),
        "code": code,
        "standard": standard,
        "used": used,
        "messages": code.messages_of_methods if board else code.messages,
        "board": f".{board}" if board else "",
    }
    return tidy(rendered(templates, "plain.py.j2", "", known).text)


def problems_of(system: System, chart: Statechart) -> Iterator[Diagnostic]:
    """One problem for each thing that a statechart cannot do here, with all its places."""
    yield from refusals(limits(chart, system.activities), chart, NotPlain)


def refusals(found: Iterable[Limit], chart: Statechart, kind: type[Unsupported]) -> Iterator[Diagnostic]:
    """One problem for each thing that cannot be done, at its first place, with the others."""
    places: dict[AgentFeature | SingleFeature, list[Limit]] = {}
    for limit in found:
        places.setdefault(limit.what, []).append(limit)
    for feature, (first, *others) in places.items():
        related = tuple(Related(limit.span, "and here") for limit in others)
        yield Diagnostic(kind(chart.name, feature), first.span, related)


BACKEND = PlainBackend()
