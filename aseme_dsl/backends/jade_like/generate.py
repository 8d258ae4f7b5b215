"""The jade_like backend: what monas writes, and each role as an agent with a tree of behaviours."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, assert_never

from aseme_dsl.amola.aip import Participant
from aseme_dsl.amola.expression import duration_text
from aseme_dsl.amola.statechart import State, Statechart, Transition, transition_text
from aseme_dsl.amola.system import System
from aseme_dsl.backends.backend import ACTIVITIES, Artefact, BackendOptions
from aseme_dsl.backends.jade_like.tree import POINTS, Behaviour, Kind, Tree, Waker, behaviour_tree
from aseme_dsl.backends.shared.generate import (
    activity_files,
    environment,
    messages_file,
    rendered,
    role_files,
    source_of,
    system_file,
)
from aseme_dsl.codegen.place import place
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.conversation.directory import service_of
from aseme_dsl.runtime.message.acl import JSON
from aseme_dsl.runtime.message.naming import class_name, module_name, usable

RESERVED = (*POINTS.values(), *(str(kind) for kind in Kind), "WakerBehaviour")
"""What the modules of behaviours import: no behaviour is called so."""

if TYPE_CHECKING:
    from jinja2 import Environment


@dataclass(frozen=True, slots=True)
class Class:
    """A class of a behaviour, as it is written: what it says of itself, and what its `build` does."""

    name: str
    kind: str
    document: str
    attributes: tuple[str, ...]
    calls: tuple[str, ...] = ()
    points: tuple[str, ...] = ()
    """The points of its own that the calls name."""


@dataclass(frozen=True, slots=True)
class Offer:
    """A participant that a role plays, with what it sends and receives for people."""

    protocol: str
    participant: str
    sends: str
    receives: str

    @property
    def type(self) -> str:
        """The type of service by which the directory lists it."""
        return service_of(self.protocol, self.participant)


@dataclass(frozen=True, slots=True)
class Shown:
    """A role as an agent with behaviours."""

    classes: tuple[Class, ...]
    """The classes of the behaviours, the outermost first."""
    imported: tuple[str, ...]
    """The names of the runtime that these use."""
    offers: tuple[Offer, ...]
    example: str
    """A class from which a user can start."""


@dataclass(frozen=True, slots=True)
class JadeLikeBackend:
    """Emits what monas emits, per role `agent.py` and `behaviours.py`, and a class for the user's own."""

    name: str = "jade_like"

    def generate(self, system: System, options: BackendOptions) -> tuple[Artefact, ...]:
        """The package of a system, and among the activities a class a role that is the user's."""
        templates = environment(options, Path(__file__).parent / "templates")
        messages = messages_file(system, options.known)
        roles = role_files(templates, system, options)
        kept = list(activity_files(templates, system, options))
        taken = {artefact.path for artefact in kept}
        artefacts = [system_file(templates, system, roles, shown=True), messages]
        seen = [
            (system if options.templates else role.seen, role.seen, _own(system, chart, taken))
            for chart, role in zip(system.iacs, roles, strict=True)
        ]
        agents = options.known.each(_agent, seen, templates, source_of(system))
        for (package, behaviours, agent, own), role in zip(agents, roles, strict=True):
            artefacts += [package, *role.files, behaviours, agent]
            kept.append(own)
        return (*artefacts, *kept)


def _agent(
    system: System, seen: System, own: str, templates: Environment, source: str
) -> tuple[Artefact, Artefact, Artefact, Artefact]:
    """Of a role: what is imported of it, its behaviours, its agent, and the user's class beside them."""
    chart, shown = seen.iacs[0], _shown(seen)
    folder = f"{system.name}/{usable(chart.name)}"
    known = {
        "system": system,
        "chart": chart,
        "source": source,
        "shown": True,
        "place": place(chart.span),
        "own": own,
        "main": shown.classes[0].name,
        "services": shown.offers,
        "language": JSON,
        "behaviours": shown.classes,
        "imported": shown.imported,
        "example": shown.example,
    }
    return (
        rendered(templates, "role.py.j2", f"{folder}/__init__.py", known),
        rendered(templates, "behaviours.py.j2", f"{folder}/behaviours.py", known),
        rendered(templates, "agent.py.j2", f"{folder}/agent.py", known),
        rendered(templates, "own_agent.py.j2", f"{ACTIVITIES}/{module_name(own)}.py", known, kept=True),
    )


def _shown(seen: System) -> Shown:
    """The only role of a system, shown."""
    chart = seen.iacs[0]
    tree = behaviour_tree(seen, chart, RESERVED)
    classes = tuple(_classes(chart, tree))
    return Shown(classes, _imported(classes), tuple(_offers(seen, tree)), _example(tree))


def _own(system: System, chart: Statechart, taken: set[str]) -> str:
    """The name of the user's class for a role, whose module no activity has.

    The system's is in it: several systems may have their activities in one folder.
    """
    names = dict.fromkeys(map(class_name, (system.name, chart.name)))
    wish = name = class_name("_".join((*names, "Agent")))
    number = 2
    while f"{ACTIVITIES}/{module_name(name)}.py" in taken:
        name, number = f"{wish}{number}", number + 1
    taken.add(f"{ACTIVITIES}/{module_name(name)}.py")
    return name


def _example(tree: Tree) -> str:
    """A behaviour that a user may want to subclass: the first activity."""
    return next((item.name for item in tree.behaviours if not item.inside), tree.behaviours[0].name)


def _offers(system: System, tree: Tree) -> Iterator[Offer]:
    """The participants that a role plays, in the order in which they stand in it."""
    for protocol, name in dict.fromkeys(item.branch for item in tree.behaviours if item.branch is not None):
        aip = next((item for item in system.aips if item.name == protocol), None)
        participant = aip.participant(name) if aip is not None else None
        yield Offer(protocol, name, *_exchanged(participant))


def _exchanged(participant: Participant | None) -> tuple[str, str]:
    sent = participant.sends if participant is not None else ()
    received = participant.receives if participant is not None else ()
    texts = (", ".join(f"{item.performative} {item.message}" for item in items) for items in (sent, received))
    one, other = (text or "nothing" for text in texts)
    return one, other


# ---- classes ------------------------------------------------------------------------------------


def _classes(chart: Statechart, tree: Tree) -> Iterator[Class]:
    for item in tree.behaviours:
        yield Class(
            item.name,
            item.kind.value,
            _document(chart, item),
            tuple(_attributes(item)),
            tuple(_calls(chart, tree, item)),
            tuple(_points(chart, tree, item)),
        )
        for waker in item.wakers:
            yield Class(
                waker.name,
                "WakerBehaviour",
                f"After {duration_text(waker.timeout)}: {_way(chart, waker.transition)}.",
                (
                    f"at = {place(waker.transition.span)!r}",
                    f"waits_in = {waker.waits_in!r}",
                    f"timeout = {_nanoseconds(waker.timeout)}",
                ),
            )


def _document(chart: Statechart, item: Behaviour) -> str:
    core = chart.node(item.states[-1])
    if core.activity is not None:
        return f"The activity {core.name}." if item.node is core else f"{item.node.name} = {core.name}"
    text = item.node.name
    composed = _formula(chart, item)
    if text.isidentifier() and composed and len(composed) <= 160:
        text = f"{text} = {composed}"
    if item.branch is not None:
        text += f": the part of {item.branch[1]} in {item.branch[0]}"
    return text


def _formula(chart: Statechart, item: Behaviour) -> str:
    """What is in a behaviour, as a formula, where its kind says how it would be written."""
    parts: list[str] = []
    for label in item.inside:
        node: State | None = chart.node(label)
        while node is not None and node.name == node.label:  # a region is called by its label
            node = next((child for child in chart.children(node.label) if child.name != child.label), None)
        parts.append(node.name if node is not None else label)
    match item.kind:
        case Kind.SEQUENTIAL:
            return " . ".join(parts)
        case Kind.PARALLEL:
            return " || ".join(parts)
        case Kind.CYCLIC:
            return f"{parts[0]}~"
        case Kind.ONE_SHOT | Kind.TICKER | Kind.FSM:
            return ""
        case _:
            assert_never(item.kind)


def _attributes(item: Behaviour) -> Iterator[str]:
    yield f"states = {item.states!r}"
    yield f"at = {place(item.node.span)!r}"
    if item.branch is not None:
        yield f"protocol = {item.branch[0]!r}"
        yield f"participant = {item.branch[1]!r}"
    if item.period is not None:
        yield f"period = {_nanoseconds(item.period)}"


def _calls(chart: Statechart, tree: Tree, item: Behaviour) -> Iterator[str]:
    add = "register_state" if item.kind is Kind.FSM else "add_sub_behaviour"
    for label in item.inside:
        yield f"self.{add}({tree.by_state[label].name})"
    wakers: dict[Transition, list[Waker]] = {}
    for waker in item.wakers:
        wakers.setdefault(waker.transition, []).append(waker)
    for transition in item.shown:
        text = transition_text(transition)
        source, target = (_named(chart, tree, item, end) for end in (transition.source, transition.target))
        arguments = [source] if not transition.changes_state else [source, target]
        names = [waker.name for waker in wakers.get(transition, ())]
        if text or names or not transition.changes_state:
            arguments.append(repr(text))
        call = "register_action" if not transition.changes_state else "register_transition"
        if transition.changes_state and _is_default(transition):
            call = "register_default_transition"
        into = [f"into={transition.into!r}"] if transition.into else []
        yield f"self.{call}({', '.join([*arguments, *names, *into])})"


def _is_default(transition: Transition) -> bool:
    """Whether a transition is what happens if nothing else does."""
    said = transition.expression
    plain = said.is_unconditional and not said.when and said.every is None
    return (plain or said.otherwise) and not transition.first


def _named(chart: Statechart, tree: Tree, around: Behaviour, label: str) -> str:
    """A state as a behaviour names it: by its class, as a point of its own, or by its label."""
    behaviour = tree.by_state.get(label)
    if behaviour is not None:
        return behaviour.name if behaviour.label == label else repr(label)
    return _point(chart, around, label) or repr(label)


def _point(chart: Statechart, around: Behaviour, label: str) -> str | None:
    """The point that a state is of a behaviour, if there is one such only."""
    node = chart.node(label)
    alone = sum(other.type is node.type for other in chart.children(node.parent or "")) == 1
    return POINTS[node.type] if alone and node.parent == around.states[-1] else None


def _points(chart: Statechart, tree: Tree, item: Behaviour) -> Iterator[str]:
    """The points that the calls of a behaviour name."""
    for transition in item.shown:
        ends = (transition.source, transition.target) if transition.changes_state else (transition.source,)
        for label in ends:
            point = _point(chart, item, label) if label not in tree.by_state else None
            if point is not None:
                yield point


def _way(chart: Statechart, transition: Transition) -> str:
    """A transition for people: from where it leads where, or in what it does something."""
    ends = [chart.node(label) for label in (transition.source, transition.target)]
    whence, where = (POINTS.get(node.type) or node.name for node in ends)
    if transition.into:
        where = " and ".join(POINTS.get(node.type) or node.name for node in map(chart.node, transition.into))
    around = next((node.name for node in chart.ancestors(ends[0].label) if node.name != node.label), "")
    text = f"from {whence} to {where}" if transition.changes_state else f"in {whence}"
    return f"{text}, in {around}" if around and any(node.type in POINTS for node in ends) else text


def _nanoseconds(duration: int) -> str:
    """`30_000_000_000  # 30s`: a time in ns, with how it is written."""
    return f"{duration:_}  # {duration_text(duration)}"


def _imported(classes: Iterable[Class]) -> tuple[str, ...]:
    """What a module of behaviours uses of the runtime."""
    return tuple(sorted({name for item in classes for name in (item.kind, *item.points)}))


BACKEND = JadeLikeBackend()
