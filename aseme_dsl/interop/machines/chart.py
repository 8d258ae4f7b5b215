"""Chart: a machine as the text of a `statechart`, with what became of each of its parts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from aseme_dsl.amola.expression import duration_text
from aseme_dsl.amola.statechart import StateType, label_key
from aseme_dsl.interop.emf.charts import one_line
from aseme_dsl.interop.emf.identifiers import Names
from aseme_dsl.interop.emf.report import Fate, Row
from aseme_dsl.interop.machines.differing import Differing, unordered
from aseme_dsl.interop.machines.ecmascript import NUMBERS, Untranslatable
from aseme_dsl.interop.machines.machine import (
    Assigning,
    Cancelling,
    Delaying,
    Doing,
    Machine,
    Move,
    Node,
    Noting,
    Other,
    Raising,
    Shape,
)
from aseme_dsl.interop.machines.places import (
    Goal,
    Unreachable,
    Written,
    by_id,
    entered,
    first_of,
    inner,
    is_and,
    is_composite,
    is_inside,
    is_region,
    is_wrapped,
    path,
    performs,
    places_of,
    scope_of,
)
from aseme_dsl.interop.machines.words import delayed, is_of_engine, words_of
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span


@dataclass(frozen=True, slots=True)
class MachineText:
    """The lines of a role; those that a part of the machine has caused have its number."""

    lines: tuple[str, ...]
    parts: Mapping[int, int]
    rows: tuple[Row, ...]
    targets: Mapping[int, str]
    """The ids of the states to which lines lead."""


@dataclass(slots=True)
class MachinePlan:
    """A machine on its way to text. `problems` are what the compiler says of the lines of its parts."""

    machine: Machine
    name: str
    problems: dict[int, str] = field(default_factory=dict)


def machine_text(plan: MachinePlan, *, with_holes: bool = True) -> MachineText:
    """The text of a machine. Without holes it is for the compiler only: each is a condition that holds."""
    return _Writer(plan, with_holes).written()


class _Writer:
    def __init__(self, plan: MachinePlan, with_holes: bool) -> None:
        self.plan = plan
        self.machine = plan.machine
        self.places = places_of(plan.machine)
        self.words = words_of(plan.machine)
        self.known = by_id(plan.machine)
        self.timed = delayed(plan.machine)
        self.timed_names = {self.words.events.get(name) for name in self.timed}
        self.differing = Differing(plan.machine)
        self.hole = "[?]" if with_holes else "[true]"
        self.lines: list[str] = []
        self.parts: dict[int, int] = {}
        self.rows: dict[Row, None] = {}
        self.targets: dict[int, str] = {}
        self.number = -1
        self.activities: dict[str, bool] = {}
        """What the states perform, and whether it waits."""
        variables = (item.name for item in self.words.variables.values())
        self.names = Names({*self.words.states.values(), *variables})
        self.performed: dict[str, str] = {}
        """The names of what is invoked."""
        self.finals: dict[str, list[Node]] = {}
        for node in plan.machine.nodes():
            if node.shape is Shape.FINAL and node.id in self.places.label:
                self.finals.setdefault(self.places.label[node.id], []).append(node)

    def written(self) -> MachineText:
        machine, plan = self.machine, self.plan
        root = machine.root
        self.row(Fate.KEPT, f"machine {machine.name or plan.name}", root.place, f"statechart {plan.name}")
        self.lines.append(f"statechart {plan.name} {{")
        self.variables()
        for item in sorted(self.places.written, key=lambda item: label_key(item.label)):
            self.state(item)
        for node in machine.nodes():
            self.begin(node)
            for move in node.moves:
                self.move(node, move)
            self.leave(node)
            if node.shape is Shape.HISTORY:
                self.row(Fate.LEFT_OUT, f"history {node.id}", node.place, "formulas have `resume`")
        for node, why in unordered(machine):
            self.row(Fate.DIFFERS, f"events of {node.id}", node.place, why)
        for lost in machine.lost:
            fate = Fate.CHANGED if lost.is_harmless else Fate.LEFT_OUT
            self.row(fate, lost.element, lost.place, lost.why)
        if self.activities:
            self.lines.append("  activities {")
            for name, waits in sorted(self.activities.items()):
                self.lines.append(f"    {name}{' waits' if waits else ''}")
            self.lines.append("  }")
        self.lines.append("}")
        return MachineText(tuple(self.lines), self.parts, tuple(self.rows), self.targets)

    def row(self, fate: Fate, element: str, place: Span | None, now: str) -> None:
        # once, though it may be done on several ways to a state
        self.rows[Row(fate, one_line(element)[:200], place, one_line(now)[:400])] = None

    def line(self, text: str) -> None:
        """A line that the present part has caused."""
        self.parts[len(self.lines)] = self.number
        self.lines.append(f"  {text}")

    def comment(self, text: str) -> None:
        self.lines.append(f"  // {self.machine.format}: {one_line(text)}")

    # ---- variables and states ----------------------------------------------------------------

    def variables(self) -> None:
        for datum in self.machine.data:
            self.number += 1
            known = self.words.variables.get(datum.name)
            reason = self.plan.problems.get(self.number) or self.words.missing.get(datum.name)
            if known is None or reason is not None:
                self.row(Fate.LEFT_OUT, f"data {datum.name}", datum.place, reason or "it has no type")
                self.words.variables.pop(datum.name, None)
                continue
            self.line(f"var {known.name} : {known.type} = {known.initial}")
            now = f"var {known.name} : {known.type}"
            if known.is_computed:
                now += f"; no first value stands in the file: {known.initial}"
            fate = Fate.KEPT if known.name == datum.name and not known.is_computed else Fate.CHANGED
            if why := self.differing.shared(datum.name):
                fate, now = Fate.DIFFERS, f"{now}; {why}"
            self.row(fate, f"data {datum.name}", datum.place, now)

    def state(self, item: Written) -> None:
        node = item.node
        if node is None or node is self.machine.root:
            title = self.plan.name if node is not None else ""
            self.lines.append(f"  state {item.label} {item.type.value} {title}".rstrip())
            if item.type is StateType.END:
                for final in self.finals.get(item.label, ()):
                    now = f"{item.label} END, which is one for all finals of its state"
                    self.row(Fate.CHANGED, f"final {final.id}", final.place, now)
            return
        name = self.words.states[node.id]
        text = f"state {item.label} {item.type.value} {name}"
        now = f"{item.label} {item.type.value} {name}"
        fate = Fate.KEPT if name == node.id else Fate.CHANGED
        if item.type is StateType.BASIC:
            activity = name
            if node.activity:
                activity = self.activity(node)
                text += f" activity {activity}"
                now += f", which performs {activity}"
                fate = Fate.CHANGED
            self.activities[activity] = not node.activity
        elif node.activity:
            self.row(Fate.LEFT_OUT, f"invoke {node.activity}", node.place, "only a state without states")
        if is_wrapped(node):
            fate, now = Fate.CHANGED, f"{now}, in a region of its own"
        self.lines.append(f"  {text}")
        self.row(fate, f"{node.shape.value} {node.id if node.is_named else ''}".strip(), node.place, now)

    def activity(self, node: Node) -> str:
        if node.activity not in self.performed:
            self.performed[node.activity] = self.names.new(node.activity.rpartition("/")[2], "Invoked")
        return self.performed[node.activity]

    # ---- transitions -------------------------------------------------------------------------

    def begin(self, node: Node) -> None:
        """The transition from the START of a composite."""
        start = self.places.start.get(node.id)
        if start is None:
            return
        self.number += 1
        does = list(node.entry)
        if is_wrapped(node):
            goal = Goal(node)
        else:
            ids = node.initial
            first = first_of(node)
            targets = tuple(self.known[item] for item in ids) if ids else (first,) if first else ()
            does += node.initial_does
            try:
                if any(not is_inside(item, node) for item in targets):
                    raise Unreachable("it begins outside of itself")
                goal = entered(node, targets, self.known, is_start=True)
            except Unreachable as reason:
                assert first is not None
                goal = Goal(first)
                title = f"initial {' '.join(node.initial)} of {node.id}"
                self.row(Fate.LEFT_OUT, title, node.place, str(reason))
            does += self.entries(node, goal)
        self.transition(start, goal, "", does, f"start of {node.id}", node.place)

    def entries(self, scope: Node, goal: Goal) -> list[Doing]:
        """What is done on the way to the targets, but for what stands at the STARTs that follow."""
        led = {node.id: node for target in goal.targets for node in path(scope, target)}
        ends = {target.id for target in goal.targets}
        found: list[Doing] = []
        for node in sorted(led.values(), key=lambda node: label_key(self.places.label[node.id])):
            if not (node.id in ends and (is_composite(node) or is_wrapped(node))):
                found += node.entry
        return found

    def move(self, node: Node, move: Move) -> None:
        self.number += 1
        title = self.title(node, move)
        if self.plan.problems.get(self.number, "").startswith("!"):
            self.leave_out(title, move, self.plan.problems[self.number][1:])
            return
        if node.shape in (Shape.FINAL, Shape.HISTORY):
            self.row(Fate.LEFT_OUT, title, move.place, f"no transition leads out of a {node.shape.value}")
            return
        try:
            enabled, notes, is_hole = self.enabled(node, move)
        except Unreachable as reason:
            self.leave_out(title, move, str(reason))
            return
        if is_hole:
            self.comment(title)
        fate = Fate.HOLE if is_hole else Fate.CHANGED
        source = self.places.label[node.id]
        stays = self.machine.format == "XState" and move.is_internal and move.targets == (node.id,)
        if not move.targets or (stays and not is_composite(node) and not is_and(node)):
            does = self.doing(move.does)
            if not does and not move.events:
                self.row(Fate.CHANGED, title, move.place, "nothing: it does nothing and leads nowhere")
                return
            if source == "0":
                self.leave_out(title, move, "the outermost state has no transitions")
                return
            now = f"on {source}"
            if not move.events and move.after is None:
                fate, notes = Fate.DIFFERS, [*notes, "it is taken once, until its condition has not held"]
            self.line(f"{now} : {enabled}{' / ' if does else ''}{'; '.join(does)}")
            self.row(fate, title, move.place, "; ".join([now, *notes]))
            return
        targets = tuple(self.known[item] for item in move.targets)
        if stays and is_composite(node):
            first = first_of(node)
            targets = tuple(self.known[item] for item in node.initial) or ((first,) if first else ())
        try:
            self.lead(node, move, targets, enabled, title, fate, notes)
        except Unreachable as reason:
            self.leave_out(title, move, str(reason))

    def lead(
        self,
        node: Node,
        move: Move,
        targets: tuple[Node, ...],
        enabled: str,
        title: str,
        fate: Fate,
        notes: list[str],
    ) -> None:
        """Write the line, or the lines, of a transition that leads somewhere."""
        inside = all(is_inside(target, node) for target in targets)
        sources = [node]
        if move.is_internal and inside and is_composite(node):
            same = not node.entry and not node.exit and not is_region(node)
            same = same and not any(other.after for other in node.moves)
            if not same:
                sources = self.copied(node, move)
                notes = [*notes, "internal: from each state inside"]
        ends = []
        for source in sources:
            goal = entered(source, targets, self.known)
            scope = scope_of(source, goal.node)
            ends.append((source, goal, [*move.does, *self.entries(scope, goal)]))
            if why := self.differing.overtaken(source, goal.node, move):
                fate, notes = Fate.DIFFERS, [*notes, why]
        for source, goal, does in ends:
            label = self.places.label[source.id]
            if label == "0":
                raise Unreachable("the outermost state has no transitions")
            self.transition(label, goal, enabled, does, None, move.place)
        source, goal, _ = ends[0]
        now = f"{self.places.label[source.id]} -> {self.label_of(goal)}"
        self.row(fate, title, move.place, "; ".join([now, *notes]))

    def copied(self, node: Node, move: Move) -> list[Node]:
        """The states inside one, from which an internal transition leads to one of them."""
        if any(child.shape is Shape.FINAL for child in node.children):
            raise Unreachable("it is internal, and its source may be complete")
        if node.moves[0] is not move:
            raise Unreachable("it is internal, and not the first of its source")
        return inner(node)

    def label_of(self, goal: Goal) -> str:
        """The label of what a transition leads to; of several targets, in parentheses."""
        labels = [self.places.label[target.id] for target in goal.targets]
        return f"({', '.join(sorted(labels, key=label_key))})" if goal.into else labels[0]

    def transition(
        self, source: str, goal: Goal, enabled: str, does: list[Doing], start: str | None, place: Span
    ) -> None:
        said = self.doing(tuple(does))
        text = " ".join(filter(None, (enabled, f"/ {'; '.join(said)}" if said else "")))
        label = self.label_of(goal)
        self.targets[len(self.lines)] = goal.node.id
        self.line(f"{source} -> {label} : {text}".rstrip())
        if start is not None:
            self.row(Fate.CHANGED if said else Fate.KEPT, start, place, f"{source} -> {label}")

    def leave(self, node: Node) -> None:
        if not node.exit:
            return
        self.number += 1
        label = self.places.label.get(node.id, "0")
        if label == "0" or node.shape in (Shape.FINAL, Shape.HISTORY):
            self.row(Fate.LEFT_OUT, f"exit of {node.id}", node.place, f"{node.shape.value} is never left")
            return
        does = self.doing(node.exit)
        if does:
            self.line(f"exit {label} : / {'; '.join(does)}")
            self.row(Fate.CHANGED, f"exit of {node.id}", node.place, f"exit {label}")

    def leave_out(self, title: str, move: Move, why: str) -> None:
        self.comment(f"{title}: {why}")
        self.row(Fate.LEFT_OUT, title, move.place, why)

    def title(self, node: Node, move: Move) -> str:
        event = " ".join(move.events) or ("" if move.after is None else f"after {duration_text(move.after)}")
        guard = move.named or move.guard or ""
        said = " ".join(filter(None, (event, f"[{guard}]" if guard else "")))
        ends = f"{node.id} -> {' '.join(move.targets)}" if move.targets else node.id
        return f"transition {ends}{f' : {said}' if said else ''}"

    # ---- when --------------------------------------------------------------------------------

    def enabled(self, node: Node, move: Move) -> tuple[str, list[str], bool]:
        """What enables a transition, what is to be said of it, and whether it is a hole.

        Raises:
            Unreachable: nothing that it waits for ever comes.
        """
        notes: list[str] = []
        events: list[str] = []
        needs: list[str] = []
        completes = False
        if move.after is not None:
            events.append(f"after({duration_text(move.after)})")
        for descriptor in move.events:
            if descriptor in self.timed and self.timed[descriptor][0] is node:
                after = duration_text(self.timed[descriptor][1].delay)
                events.append(f"after({after})")
                notes.append(f"the delayed event {descriptor} of its entry")
                continue
            asked = self.completion(node, descriptor)
            if asked is not None:
                completes |= asked == ""
                needs += [asked] if asked else []
                notes.append("complete is what stays so until it is left, not an event")
                continue
            if descriptor.startswith(("error", "xstate.error")) and performs(node):
                events.append("error")
                continue
            events += [name for name in self.words.awaited(descriptor) if name not in self.timed_names]
            if descriptor.endswith("*"):
                notes.append("of the events that the file names")
        events = list(dict.fromkeys(events))
        if move.events and not events and not needs and not completes:
            raise Unreachable(f"nothing raises {' '.join(move.events)} here")
        if (needs and (len(needs) > 1 or events or completes)) or (completes and events):
            raise Unreachable("it waits for a completion and for something else")
        guard, is_hole = self.guard(move, notes)
        if needs:
            joined = f"[{needs[0]} && ({guard[1:-1]})]" if guard else f"[{needs[0]}]"
            guard = guard if is_hole else joined
        if completes:
            return guard, notes, is_hole
        if events:
            return " ".join(filter(None, (" or ".join(events), guard))), notes, is_hole
        return f"when {guard or '[true]'}", notes, is_hole

    def guard(self, move: Move, notes: list[str]) -> tuple[str, bool]:
        problem = self.plan.problems.get(self.number)
        if problem is not None:
            notes.append(problem)
            return self.hole, True
        if move.guard is None:
            notes.append(f"the condition `{move.named}` is not one of the file, or in another language")
            return self.hole, True
        if not move.guard:
            return "", False
        try:
            return f"[{self.words.condition(move.guard)}]", False
        except Untranslatable as reason:
            notes.append(str(reason))
            return self.hole, True

    def completion(self, node: Node, descriptor: str) -> str | None:
        """What a completion event asks: "" that the source is complete, or a condition; None for others."""
        for prefix in ("done.state.", "xstate.done.state."):
            if not descriptor.startswith(prefix):
                continue
            state = self.known.get(descriptor.removeprefix(prefix))
            if state is node:
                return ""
            if state is not None and is_inside(state, node) and state.id in self.words.states:
                return f"done({self.words.states[state.id]})"
            raise Unreachable(f"{descriptor} is an event of a state that is not inside this one")
        if descriptor.startswith(("done.invoke", "xstate.done.actor")) and performs(node):
            return ""
        if is_of_engine(descriptor) and not descriptor.startswith(("error", "xstate.error")):
            raise Unreachable(f"nothing raises {descriptor} here")
        return None

    # ---- what is done ------------------------------------------------------------------------

    def doing(self, does: tuple[Doing, ...]) -> list[str]:
        """Actions of the language; what is not one becomes a comment."""
        found: list[str] = []
        for item in does:
            match item:
                case Assigning(variable=name, value=text):
                    found += self.assign(item, name, text)
                case Raising(event=event):
                    if event not in self.words.events:
                        self.undone(f"raise {event}", "it is an event of the engine", item.place)
                        continue
                    if item.is_sent:
                        now = "raised: it comes in the order of all events that are raised"
                        self.row(Fate.CHANGED, f"send {event}", item.place, now)
                    found.append(f"raise {self.words.events[event]}")
                case Delaying(event=event, delay=wait):
                    if event in self.timed and self.timed[event][1] is item:
                        now = f"after({duration_text(wait)}), which ends with the state"
                        self.row(Fate.CHANGED, f"send {event}", item.place, now)
                        continue
                    why = "a delay is from the entry of a state to a transition of that state"
                    self.undone(f"send {event} after {duration_text(wait)}", why, item.place)
                case Cancelling(id=name):
                    if any(name in (said.id, event) for event, (_, said) in self.timed.items()):
                        self.row(Fate.CHANGED, f"cancel {name}", item.place, "after(…) ends with its state")
                        continue
                    self.undone(f"cancel {name}", "no delay of this id is taken over", item.place)
                case Noting(text=text):
                    self.comment(text)
                    self.row(Fate.CHANGED, text, item.place, "a comment")
                case Other(text=text, why=why):
                    self.undone(text, why, item.place)
        return found

    def assign(self, item: Assigning, name: str, text: str) -> list[str]:
        known = self.words.variables.get(name)
        if known is None:
            self.undone(
                f"{name} = {text}", self.words.missing.get(name, "nothing declares the variable"), item.place
            )
            return []
        try:
            said = self.words.value(text)
        except Untranslatable as reason:
            self.undone(f"{name} = {text}", str(reason), item.place)
            return []
        if said.type != known.type and not (said.type in NUMBERS and known.type == "double"):
            self.undone(f"{name} = {text}", f"{name} holds a {known.type}, not a {said.type}", item.place)
            return []
        return [f"{known.name} = {said.text}"]

    def undone(self, text: str, why: str, place: Span) -> None:
        self.comment(text)
        self.row(Fate.LEFT_OUT, text, place, why)


__all__ = ["MachinePlan", "MachineText", "machine_text"]
