"""Behaviour: for each role and protocol, the shortest runs that one version can do and the other cannot."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from enum import StrEnum
from pathlib import Path
from tempfile import TemporaryDirectory

from aseme_dsl.amola.aip import Aip
from aseme_dsl.amola.system import System
from aseme_dsl.compiler.phases import inspect_files
from aseme_dsl.project.building.build import choose
from aseme_dsl.project.building.project import options_of
from aseme_dsl.project.comparing.structure import Change, Sort, Structure
from aseme_dsl.project.comparing.versions import Compiled
from aseme_dsl.project.playing.operate import generate_version
from aseme_dsl.project.proving.scopes import role_of, scope_of
from aseme_dsl.proofs.compare.frozen import whole
from aseme_dsl.proofs.compare.search import Bounds, Found, compare
from aseme_dsl.proofs.compare.staging import Version
from aseme_dsl.proofs.wording import states_text
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.version.loading import Loaded, load_system
from aseme_dsl.source import is_library_path

MENTIONED = 3
"""So many of the values that are tried are mentioned."""
DECLARED = frozenset(
    "activity module channel function message enum agent role protocol part participant".split()
)
"""What is not looked at in runs, or not only there: a change of it is a difference by itself."""


class Verdict(StrEnum):
    """What was found of a role or participant."""

    EQUAL = "equal"
    DIFFERENT = "different"
    UNDECIDED = "undecided"


@dataclass(frozen=True, slots=True)
class Result:
    """What was found of a role (`role player`) or of a participant (`protocol attack: center`)."""

    what: str
    verdict: Verdict
    bounds: str
    """How far the answer reaches."""
    chart: str = ""
    """The statechart in which it is drawn: `iac.player`, `eac.attack`."""
    found: Found | None = None
    is_unchanged: bool = False
    """Whether the statecharts are the same, but for names."""


def behaviour_of(
    old: Compiled,
    new: Compiled,
    structure: Structure,
    bounds: Bounds,
    told: Callable[[str], None] = lambda text: None,
) -> tuple[Result, ...]:
    """What was found of each role and each participant that both versions have.

    Raises:
        OperateError, LoadError: the code of a version cannot be made.
    """
    assert old.system is not None and new.system is not None
    names = structure.names
    roles = [(_before(item.name, names.get("role", {})), item.name) for item in new.system.iacs]
    known = {item.name for item in old.system.iacs}
    roles = [(one, other) for one, other in roles if one in known]
    if structure.only_names:
        return tuple(
            Result(f"role {other}", Verdict.EQUAL, "unchanged", f"iac.{other}", is_unchanged=True)
            for _, other in roles
        )
    found: list[Result] = []
    with TemporaryDirectory(prefix="asemec-diff-") as folder:
        charts = (
            _loaded(old, old.system, Path(folder) / "old"),
            _loaded(new, new.system, Path(folder) / "new"),
        )
        for one, other in roles:
            told(f"comparing the role {other}")
            plans = charts[0].charts[one].PLAN, charts[1].charts[other].PLAN
            agents = tuple(_agents(old.system, new.system, plans))
            found.append(
                _compared(f"role {other}", f"iac.{other}", charts, (one, other), agents, names, bounds)
            )
        for number, (one_aip, other_aip) in enumerate(_protocols(old.system, new.system, structure)):
            told(f"comparing the protocol {other_aip.name}")
            place = Path(folder) / str(number)
            found += _participants(old, new, one_aip, other_aip, place, names, bounds)
    return tuple(found)


def is_declared(change: Change) -> bool:
    """Whether a change is a difference in behaviour by itself, without a run that shows it."""
    return change.sort is not Sort.RENAMED and change.element.kind in DECLARED and change.element.matters


# ---- roles -------------------------------------------------------------------------------------------


def _loaded(version: Compiled, system: System, folder: Path) -> Loaded:
    package, _ = generate_version(system, folder, choose(version.configuration))
    return load_system(package)


def _agents(old: System, new: System, plans: tuple[Plan, Plan]) -> Iterator[tuple[str, str]]:
    """Agents of both versions that play a role: one of those that begin alike in each.

    Without a team, or for a role that has no agents, one that is called as the role.
    """
    first, second = _begins(old, plans[0]), _begins(new, plans[1])
    seen: set[object] = set()
    for name, begins in second.items():
        pair = name if name in first else next(iter(first))
        if (key := (first[pair], begins)) not in seen:
            seen.add(key)
            yield pair, name


def _begins(system: System, plan: Plan) -> dict[str, str]:
    """The agents of a role, each with what is its own when it begins."""
    names = [agent.name for team in system.teams for agent in team.agents if agent.role == plan.name]
    return {name: plan.begins(name) for name in names or [plan.name]}


def _before(name: str, names: Mapping[str, str]) -> str:
    return next((old for old, new in names.items() if new == name), name)


def _compared(
    what: str,
    chart: str,
    loaded: tuple[Loaded, Loaded],
    roles: tuple[str, str],
    agents: Sequence[tuple[str, str]],
    names: Mapping[str, Mapping[str, str]],
    bounds: Bounds,
) -> Result:
    kinds = loaded[0].charts[roles[0]], loaded[1].charts[roles[1]]
    if _with_names(kinds[0].PLAN, names) == _with_names(kinds[1].PLAN, {}):
        return Result(what, Verdict.EQUAL, "unchanged", chart, is_unchanged=True)
    new_names = {**names.get("activity", {}), **names.get("variable", {}), **names.get("state", {})}
    new_parts = {**names.get("protocol", {}), **names.get("participant", {})}
    first = Version(kinds[0], loaded[0].types, new_names, new_parts)
    found = _all_of(compare(first, Version(kinds[1], loaded[1].types), pair, bounds) for pair in agents)
    tried = f"; tried are {_some(found.tried)}" if found.tried else ""
    if found.differences:
        count = len(found.differences)
        said = f"{count} difference{'s' if count > 1 else ''}"
        said += f", but there may be shorter runs: cut after {found.cut}" if found.cut else ""
        return Result(what, Verdict.DIFFERENT, said, chart, found)
    if found.cut:
        said = f"no difference was found, cut after {found.cut} ({states_text(found.states)}){tried}"
        return Result(what, Verdict.UNDECIDED, said, chart, found)
    if found.left_out or found.is_partial:
        why = found.left_out or "a few values are tried, which do not stand for all"
        said = f"no difference was found in {states_text(found.states)}, but {why}{tried}"
        return Result(what, Verdict.UNDECIDED, said, chart, found)
    said = f"no difference was found in all {states_text(found.states)}"
    return Result(what, Verdict.EQUAL, said, chart, found)


def _all_of(parts: Iterable[Found]) -> Found:
    """What was found for agents with other settings: the first that has a difference, else all together."""
    found: list[Found] = []
    for item in parts:
        if item.differences:
            return item
        found.append(item)
    return Found(
        (),
        sum(item.states for item in found),
        next((item.cut for item in found if item.cut), ""),
        tuple(dict.fromkeys(text for item in found for text in item.tried)),
        next((item.left_out for item in found if item.left_out), ""),
        any(item.is_partial for item in found),
    )


def _some(tried: Sequence[str]) -> str:
    more = f" and {len(tried) - MENTIONED} more" if len(tried) > MENTIONED else ""
    return f"{'; '.join(tried[:MENTIONED])}{more}"


def _with_names(plan: Plan, names: Mapping[str, Mapping[str, str]]) -> str:
    text = whole(plan)
    for pairs in names.values():
        for old, new in pairs.items():
            text = re.sub(rf"(?<!\w){re.escape(old)}(?!\w)", new, text)
    return text


# ---- protocols ---------------------------------------------------------------------------------------


def _protocols(old: System, new: System, structure: Structure) -> Iterator[tuple[Aip, Aip]]:
    """The protocols of the files themselves in which something is different."""
    before = {aip.name: aip for aip in old.aips}
    touched = {item.element.owner.partition(".")[0] for item in structure.changes if item.element.matters}
    for aip in new.aips:
        one = before.get(_before(aip.name, structure.names.get("protocol", {})))
        if one is not None and aip.name in touched and not is_library_path(aip.span.source.path):
            yield one, aip


def _participants(
    old: Compiled,
    new: Compiled,
    one: Aip,
    other: Aip,
    folder: Path,
    names: Mapping[str, Mapping[str, str]],
    bounds: Bounds,
) -> Iterator[Result]:
    loaded: list[Loaded] = []
    for version, aip, place in ((old, one, "old"), (new, other, "new")):
        scope = scope_of(version.root, aip, 1)
        found = inspect_files(scope.root, None, options_of(version.configuration)).analysis
        if found.system is None:
            reason = "it cannot be played alone"
            yield Result(f"protocol {other.name}", Verdict.UNDECIDED, reason, f"eac.{other.name}")
            return
        loaded.append(_loaded(version, found.system, folder / place))
    parts = names.get("participant", {})
    for part in other.participants:
        before = _before(part.name, parts)
        if one.participant(before) is not None:
            roles = role_of(one.name, before), role_of(other.name, part.name)
            what, chart = f"protocol {other.name}: {part.name}", f"eac.{other.name}"
            pair = loaded[0], loaded[1]
            yield _compared(what, chart, pair, roles, [(before, part.name)], names, bounds)


__all__ = ["DECLARED", "Result", "Verdict", "behaviour_of", "is_declared"]
