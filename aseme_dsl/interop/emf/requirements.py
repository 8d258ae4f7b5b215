"""Requirements: goals (SAG), use cases (SUC), protocols (AIP) and roles (SRM) of the ASEME IDE, as data."""

from __future__ import annotations

import re
from collections.abc import Iterator

from aseme_dsl.interop.emf.charts import one_line
from aseme_dsl.interop.emf.markup import Element, Unreadable
from aseme_dsl.interop.emf.references import References
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

LONGEST = 20_000
"""How many characters a text may have."""
_ROLE_TYPES = {
    "": "abstract",
    "Abstract": "abstract",
    "System": "system",
    "Legacy_System": "legacy",
    "External_System": "external",
    "Human": "human",
    "HumanRole": "human",
    "SystemRole": "system",
}


@dataclass(frozen=True, slots=True)
class ForeignGoal:
    name: str
    text: str
    depender: str
    dependees: tuple[str, ...]
    place: Span


@dataclass(frozen=True, slots=True)
class ForeignActor:
    name: str
    place: Span


@dataclass(frozen=True, slots=True)
class ForeignRole:
    """A role of use cases; `type` is that of the language, "" for one that is not known."""

    name: str
    type: str
    place: Span


@dataclass(frozen=True, slots=True)
class ForeignUseCase:
    name: str
    text: str
    roles: tuple[str, ...]
    includes: tuple[str, ...]
    place: Span


@dataclass(frozen=True, slots=True)
class ForeignFormula:
    """A line of a liveness text. `name` is "" where it has no left side."""

    name: str
    text: str


@dataclass(frozen=True, slots=True)
class ForeignParticipant:
    name: str
    rule: str
    outcomes: str
    liveness: tuple[ForeignFormula, ...]
    place: Span


@dataclass(frozen=True, slots=True)
class ForeignProtocol:
    name: str
    participants: tuple[ForeignParticipant, ...]
    place: Span


@dataclass(frozen=True, slots=True)
class ForeignFunctionality:
    description: str
    entries: tuple[tuple[str, str], ...]
    place: Span


@dataclass(frozen=True, slots=True)
class ForeignActivity:
    name: str
    functionality: ForeignFunctionality | None
    place: Span


@dataclass(frozen=True, slots=True)
class ForeignCapability:
    name: str
    text: str
    activities: tuple[str, ...]
    place: Span


@dataclass(frozen=True, slots=True)
class ForeignSrmRole:
    name: str
    liveness: tuple[ForeignFormula, ...]
    activities: tuple[ForeignActivity, ...]
    capabilities: tuple[ForeignCapability, ...]
    place: Span


@dataclass(frozen=True, slots=True)
class Requirements:
    """What one or several files hold. `lost` are references that lead nowhere and what nothing refers to."""

    actors: tuple[ForeignActor, ...] = ()
    goals: tuple[ForeignGoal, ...] = ()
    roles: tuple[ForeignRole, ...] = ()
    usecases: tuple[ForeignUseCase, ...] = ()
    protocols: tuple[ForeignProtocol, ...] = ()
    srm_roles: tuple[ForeignSrmRole, ...] = ()
    lost: tuple[tuple[str, Span, str], ...] = ()

    def __add__(self, other: Requirements) -> Requirements:
        return Requirements(
            self.actors + other.actors,
            self.goals + other.goals,
            self.roles + other.roles,
            self.usecases + other.usecases,
            self.protocols + other.protocols,
            self.srm_roles + other.srm_roles,
            self.lost + other.lost,
        )


KINDS = ("SAGmodel", "SUCmodel", "AIPmodel", "SRMmodel")


def is_requirements(document: Element) -> bool:
    """Whether a file has one of these models."""
    return any(top.tag in KINDS for top in References(document).tops)


def read_requirements(document: Element) -> Requirements:
    """The models of a file. Raises Unreadable."""
    reader = _Reader(document)
    found = Requirements()
    for model in reader.references.tops:
        match model.tag:
            case "SAGmodel":
                found += reader.goals(model)
            case "SUCmodel":
                found += reader.usecases(model)
            case "AIPmodel":
                found += reader.protocols(model)
            case "SRMmodel":
                found += reader.roles(model)
            case _:
                reader.lost.append((f"element <{model.tag[:40]}>", model.place, "not part of a model"))
    return found + Requirements(lost=tuple(reader.lost))


class _Reader:
    def __init__(self, document: Element) -> None:
        self.references = References(document)
        self.lost: list[tuple[str, Span, str]] = []

    def goals(self, model: Element) -> Requirements:
        actors = tuple(ForeignActor(_name(item), item.place) for item in model.named("actors"))
        owner = {
            id(goal): _name(actor) for actor in model.named("actors") for goal in self._of(actor, "my_goal")
        }
        goals = tuple(
            ForeignGoal(
                _name(item),
                _text(item, "requirements"),
                next((_name(actor) for actor in self._of(item, "depender")), owner.get(id(item), "")),
                tuple(dict.fromkeys(_name(actor) for actor in self._of(item, "dependee"))),
                item.place,
            )
            for item in model.named("goals")
        )
        self._others(model, ("actors", "goals"))
        return Requirements(actors=actors, goals=goals)

    def usecases(self, model: Element) -> Requirements:
        takes_part: dict[int, list[str]] = {}
        for role in model.named("roles"):
            for usecase in self._of(role, "participates_in"):
                takes_part.setdefault(id(usecase), []).append(_name(role))
        roles = tuple(ForeignRole(_name(item), _role_type(item), item.place) for item in model.named("roles"))
        usecases = tuple(
            ForeignUseCase(
                _name(item),
                _text(item, "specified_by"),
                tuple(
                    dict.fromkeys(
                        [_name(role) for role in self._of(item, "participant")] + takes_part.get(id(item), [])
                    )
                ),
                tuple(dict.fromkeys(_name(other) for other in self._of(item, "include"))),
                item.place,
            )
            for item in model.named("usecases")
        )
        self._others(model, ("roles", "usecases"))
        return Requirements(roles=roles, usecases=usecases)

    def protocols(self, model: Element) -> Requirements:
        used: set[int] = set()
        protocols = []
        for item in model.named("protocols"):
            members = self._of(item, "participants")
            used |= {id(member) for member in members}
            participants = tuple(
                ForeignParticipant(
                    _name(member),
                    _text(member, "engaging_rules"),
                    _text(member, "outcomes"),
                    tuple(formulas_in(member.get("liveness"))),
                    member.place,
                )
                for member in members
            )
            protocols.append(ForeignProtocol(_name(item), participants, item.place))
        for item in model.named("participants"):
            if id(item) not in used:
                self.lost.append((f"participant {_name(item)}", item.place, "no protocol has it"))
        self._others(model, ("participants", "protocols"))
        return Requirements(protocols=tuple(protocols))

    def roles(self, model: Element) -> Requirements:
        functionalities = {
            id(item): ForeignFunctionality(
                _text(item, "description"),
                tuple(
                    (word, text)
                    for word in ("technology", "permissions", "environment", "algorithm")
                    if (text := _text(item, word))
                ),
                item.place,
            )
            for item in model.named("functionalities")
        }
        served = {
            id(activity): functionalities[id(item)]
            for item in model.named("functionalities")
            for activity in self._of(item, "activities")
        }
        activities = {}
        for item in model.named("activities"):
            found = [functionalities.get(id(other)) for other in self._of(item, "functionality")]
            functionality = next(iter(found), served.get(id(item)))
            activities[id(item)] = ForeignActivity(_name(item), functionality, item.place)
        capabilities = {
            id(item): ForeignCapability(
                _name(item),
                _text(item, "description"),
                tuple(dict.fromkeys(_name(other) for other in self._of(item, "capability_activities"))),
                item.place,
            )
            for item in model.named("capabilities")
        }
        used: set[int] = set()
        roles = []
        for item in model.named("roles"):
            own = [other for other in self._of(item, "role_activities") if id(other) in activities]
            able = [other for other in self._of(item, "capabilities") if id(other) in capabilities]
            inner = [part for other in able for part in self._of(other, "capability_activities")]
            own += [part for part in inner if id(part) in activities]
            used |= {id(other) for other in (*own, *able)}
            roles.append(
                ForeignSrmRole(
                    _name(item),
                    tuple(formulas_in(item.get("liveness"))),
                    tuple({id(other): activities[id(other)] for other in own}.values()),
                    tuple(capabilities[id(other)] for other in able),
                    item.place,
                )
            )
        for tag in ("activities", "capabilities"):
            for item in model.named(tag):
                if id(item) not in used:
                    self.lost.append((f"{tag} {_name(item)}", item.place, "no role has it"))
        self._others(model, ("roles", "activities", "capabilities", "functionalities"))
        return Requirements(srm_roles=tuple(roles))

    def _of(self, element: Element, feature: str) -> list[Element]:
        """The elements that a feature leads to; what leads nowhere is kept in mind."""
        found: list[Element] = []
        for item in self.references.of(element, feature):
            if isinstance(item, Element):
                found.append(item)
            else:
                self.lost.append(
                    (f"{feature} of {_name(element)}", element.place, f"`{item[:60]}` is missing")
                )
        return found

    def _others(self, model: Element, known: tuple[str, ...]) -> None:
        for child in model.children:
            if child.tag not in known:
                self.lost.append((f"element <{child.tag[:40]}>", child.place, "the format does not have it"))


def formulas_in(liveness: str) -> Iterator[ForeignFormula]:
    """The lines of a liveness text, each with its left side."""
    for line in re.split(r"[\r\n;]+", liveness):
        name, equals, text = line.partition("=")
        if not equals:
            name, text = "", line
        if name.strip() or text.strip():
            yield ForeignFormula(one_line(name), one_line(text))


def _name(element: Element) -> str:
    name = one_line(element.get("name"))
    if len(name) > 200:
        raise Unreadable("a name has more than 200 characters", element.place)
    return name


def _text(element: Element, feature: str) -> str:
    text = one_line(element.get(feature))
    if len(text) > LONGEST:
        raise Unreadable(f"a text has more than {LONGEST} characters", element.place)
    return text


def _role_type(element: Element) -> str:
    kind = element.get("type").rpartition(":")[2]
    return _ROLE_TYPES.get(kind, "")


__all__ = ["Requirements", "is_requirements", "read_requirements"]
