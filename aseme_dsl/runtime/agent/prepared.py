"""Prepared content: what the messages of an agent say that its transitions send without braces.

A draft belongs to the state whose activity has prepared it, and to the protocol branch around it. A message
takes a draft of its branch; the one that opens a conversation may also take one from around the branch. A
later message of the type says again what the last one in this conversation said. What a cancelled activity
has prepared can be sent by the transition that cancels it, and is dropped then.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.chart.plan import Plan, is_in

Branch = str | None
"""The label of a protocol branch, None for what is in none."""


@dataclass(frozen=True, slots=True)
class _Draft:
    label: str
    message: str
    content: object


class Prepared:
    """The drafts of one agent, and what it has sent."""

    def __init__(self) -> None:
        self._drafts: dict[Branch, list[_Draft]] = {}
        self._sent: dict[tuple[str, str], object] = {}
        self._codeless: set[Branch] = set()
        """The branches of which an activity without code has begun: it prepares what it has no code for."""
        self._cancelled: list[tuple[Branch, str]] = []

    def add(self, branch: Branch, label: str, message: str, content: object) -> None:
        """The activity of a state prepares a message; it replaces its own draft."""
        drafts = self._drafts.setdefault(branch, [])
        drafts[:] = [item for item in drafts if (item.label, item.message) != (label, message)]
        drafts.append(_Draft(label, message, content))

    def begun_without_code(self, branch: Branch) -> None:
        """An activity without code begins."""
        self._codeless.add(branch)

    def take(self, plan: Plan, branch: str, message: str, source: str) -> object:
        """The draft of a branch for what a transition out of `source` sends; None if there is none.

        Those of the source go first, then the newest that does not belong to a concurrent state.
        """
        return self._take(plan, branch, message, source)

    def take_around(self, plan: Plan, branch: str, message: str, source: str) -> object:
        """The draft from around a branch for the message that opens its conversation; None without one."""
        for outer in _around(plan, branch):
            content = self._take(plan, outer, message, source)
            if content is not None:
                return content
        return None

    def _take(self, plan: Plan, branch: Branch, message: str, source: str) -> object:
        drafts = [item for item in self._drafts.get(branch, ()) if item.message == message]
        if not drafts:
            return None
        own = [item for item in drafts if is_in(item.label, source)]
        serial = [item for item in drafts if branch is None or not plan.are_concurrent(item.label, source)]
        found = (own or serial or drafts)[-1]
        gone = {id(item) for item in (found, *(own or serial))}
        self._drafts[branch] = [item for item in self._drafts[branch] if id(item) not in gone]
        return found.content

    def repeated(self, branch: str, message: str) -> object:
        """What the last message of a type said in this conversation, None without one."""
        return self._sent.get((branch, message))

    def sent(self, branch: str, message: str, content: object) -> None:
        """A message was sent in the conversation of a branch."""
        self._sent[branch, message] = content

    def has_codeless(self, plan: Plan, branch: str, opens: bool) -> bool:
        """Whether an activity without code has begun that may have prepared a message."""
        around = _around(plan, branch) if opens else ()
        return branch in self._codeless or any(outer in self._codeless for outer in around)

    def cancelled(self, branch: Branch, label: str) -> None:
        """The activity of a state is cancelled in this step."""
        if branch in self._drafts:
            self._cancelled.append((branch, label))

    def end_step(self) -> None:
        """Drop what cancelled activities have prepared."""
        for branch, label in self._cancelled:
            self._drafts[branch] = [item for item in self._drafts.get(branch, ()) if item.label != label]
        self._cancelled.clear()

    def forget(self, branch: str) -> None:
        """A branch is entered or left."""
        self._drafts.pop(branch, None)
        self._codeless.discard(branch)
        for key in [key for key in self._sent if key[0] == branch]:
            del self._sent[key]

    def clear(self) -> None:
        """Nothing was prepared."""
        self.__init__()  # type: ignore[misc]

    def renew(self, labels: Mapping[str, str], understood: Callable[[object], object]) -> None:
        """Let it fit another version of the model, with other labels and messages."""

        def new(branch: Branch) -> Branch:
            return branch if branch is None else labels.get(branch, "")

        self._drafts = {
            new(branch): [
                replace(item, label=labels.get(item.label, ""), content=understood(item.content))
                for item in drafts
            ]
            for branch, drafts in self._drafts.items()
        }
        self._sent = {
            (labels.get(branch, ""), message): understood(content)
            for (branch, message), content in self._sent.items()
        }
        self._codeless = {new(branch) for branch in self._codeless}


def _around(plan: Plan, branch: str) -> Iterable[Branch]:
    """The branches around a branch, innermost first, and then what is in none."""
    outer = [info.label for info in plan.branches if branch.startswith(f"{info.label}.")]
    return (*sorted(outer, key=len, reverse=True), None)


__all__ = ["Prepared"]
