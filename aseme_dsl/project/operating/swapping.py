"""Swapping: a team changes to another version in two phases, as one epoch: all members, or a majority."""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping
from dataclasses import field
from typing import TYPE_CHECKING

from aseme_dsl.project.operating.whole_team import WholeTeam
from aseme_dsl.project.playing.operate import Node, OperateError, Request, ask_each, unknown_agent
from aseme_dsl.project.playing.remote import Robot
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.control.epoch_proof import proven
from aseme_dsl.runtime.version.epochs import Epoch

if TYPE_CHECKING:
    from aseme_dsl.runtime.control.replies import Reply

WITHIN = 10.0
"""How long, in seconds, a swap waits for conversations to end."""
HOLD = 4.0
"""How long, in seconds, a process waits for the next phase before it decides alone."""
MOST_CREDIBLE = 1 << 40
"""No team has changed so many times: who says so is not believed, and refuses the swap."""
READY = 10.0
"""So many seconds a process may take to read and check the new version."""
ANSWER = 2.5
"""So many seconds a held process may take to answer: then there is time to tell the others what follows."""
_TRY = 0.3
_PAUSE = 0.05


@dataclass(frozen=True, slots=True)
class Swapped:
    """What has become of a swap: the members that have changed, why others have not, and notes.

    `epoch` is its number. A swap of some agents only makes none. `unknown` are those of `unchanged` that were
    asked to change, and have not said what they follow now: they may have changed, too.
    """

    epoch: int | None
    changed: tuple[str, ...]
    unchanged: Mapping[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    unknown: tuple[str, ...] = ()

    @property
    def is_whole(self) -> bool:
        """Whether every member that was meant has changed."""
        return bool(self.changed) and not self.unchanged


def quorum_of(text: str, members: int) -> int:
    """How many of so many members have to change: `all`, or a number that is at least a majority.

    Raises:
        OperateError: it is not.
    """
    if text == "all":
        return members
    majority = members // 2 + 1
    if not (text.isascii() and text.isdigit() and len(text) < 10) or not majority <= int(text) <= members:
        raise OperateError(
            f"--quorum {text}: a team of {members} needs `all`, or a number from {majority} to {members}"
        )
    return int(text)


def swap(
    team: WholeTeam,
    name: str,
    *,
    within: float = WITHIN,
    agents: Iterable[str] | None = None,
    quorum: str = "all",
) -> Swapped:
    """Change a team to the version of this hash: all members, or at least a quorum, or none.

    `team` is what the processes have said of themselves. `within` is how long, in seconds, it is waited for
    conversations that the new version plays differently.

    Raises:
        OperateError: the quorum is not reached; all continue as before.
    """
    names = None if agents is None else list(dict.fromkeys(agents))
    known = {name for node in team.nodes for name in node.agents}
    for wanted in names or ():
        if wanted not in known:
            silent = [reason for reason in team.reasons() if wanted in team.missing]
            raise OperateError(*(silent or [unknown_agent(wanted, team.nodes)]))
    members = list(team.members) if names is None else names
    needed = quorum_of(quorum, len(members))
    nodes = [node for node in team.nodes if set(node.agents) & set(members)]
    if names is None and (len(known & set(members)) < needed or (quorum == "all" and team.silent)):
        raise OperateError(*team.reasons())
    epoch = None if names is not None else 1 + max(map(_epoch, nodes), default=0)
    request: Request = {"request": "swap", "hash": name, "agents": names}
    attempt = _Attempt(nodes, request, epoch, members, needed)
    return attempt.run(team, time.monotonic() + within, within)


def _epoch(node: Node) -> int:
    """The newest epoch that a process knows of; it cannot push the number to where there is none after it."""
    status = node.status
    held = status.get("held")
    number = max(status["epoch"]["number"], held["number"] if held else 0)
    return number if number < MOST_CREDIBLE else 0


class _Attempt:
    """One swap by one operator."""

    def __init__(
        self, nodes: list[Node], request: Request, epoch: int | None, members: Iterable[str], needed: int
    ) -> None:
        self._nodes = nodes
        self._request = request
        self._epoch = epoch
        self._members = frozenset(members)
        self._needed = needed
        self._finished: set[Node] = set()

    def run(self, team: WholeTeam, deadline: float, within: float) -> Swapped:
        unchanged = {name: f"{name} does not answer" for name in team.missing if name in self._members}
        while True:
            last = time.monotonic() >= deadline
            held, busy, problems, notes = self._prepare(last)
            if held:
                break
            if problems and self._needed > self._agents(self._nodes) - self._agents(problems):
                raise OperateError(*dict.fromkeys(text for texts in problems.values() for text in texts))
            if last:
                reasons = [f"{text} after {within:g} s" for texts in busy.values() for text in texts]
                ask_each({n.socket: {**self._request, "phase": "refuse", "reasons": reasons} for n in busy})
                raise OperateError(*reasons)
            time.sleep(_PAUSE)
        for left, why in {**busy, **problems}.items():
            unchanged |= {name: "; ".join(why) for name in self._mine(left)}
        return self._finish(held, unchanged, notes)

    def _prepare(
        self, last: bool
    ) -> tuple[dict[Node, int], dict[Node, list[str]], dict[Node, list[str]], tuple[str, ...]]:
        """Phase 1: hold all that can change, if they are a quorum.

        Gives the swaps that are held, which processes are busy, which have refused, and notes. While some are
        busy and there is time, none is held.
        """
        request = {**self._request, "phase": "ready"}
        ready = self._ask(self._nodes, request, READY)
        busy = {node: reply["reasons"] for node, reply in ready.items() if reply["ok"] and reply["reasons"]}
        problems = {node: reply["reasons"] for node, reply in ready.items() if not reply["ok"]}
        can = [node for node in self._nodes if node not in busy and node not in problems]
        if (busy and not last) or self._agents(can) < self._needed:
            return {}, busy, problems, ()
        prepare: Request = {**self._request, "phase": "prepare", "within": _TRY, "hold": HOLD}
        if self._epoch is not None:
            prepare["epoch"] = self._epoch
        replies = self._ask(can, prepare, ANSWER)
        held = {node: reply["id"] for node, reply in replies.items() if reply.get("state") == "prepared"}
        busy |= {n: r["reasons"] for n, r in replies.items() if r["ok"] and n not in held}
        problems |= {node: reply["reasons"] for node, reply in replies.items() if not reply["ok"]}
        if (busy and not last) or self._agents(held) < self._needed:
            why = "; ".join(text for texts in (*problems.values(), *busy.values()) for text in texts)
            self._roll_back(held, why or "the quorum is not reached")
            return {}, busy, problems, ()
        notes = tuple(note for node in held for note in replies[node]["notes"])
        return held, busy, problems, notes

    def _finish(self, held: dict[Node, int], unchanged: dict[str, str], notes: tuple[str, ...]) -> Swapped:
        """Phase 2: commit, and finish. A process that has committed changes.

        The proof of the epoch goes out now: before, all may still be as it was.
        """
        commits = self._say(held, "commit", proofs={node: self._proof(node) for node in held})
        failed = {node: reply["reasons"] for node, reply in commits.items() if not reply["ok"]}
        done = {node: number for node, number in held.items() if node not in failed}
        if self._agents(done) < self._needed:
            why = "; ".join(text for texts in failed.values() for text in texts)
            if not self._roll_back(held, why):
                raise OperateError(*(text for texts in failed.values() for text in texts))
        else:
            said = self._say(done, "finish")
            self._finished = {node for node, reply in said.items() if reply.get("state") == "done"}
        return self._outcome(held, {**unchanged}, notes)

    def _outcome(self, held: Iterable[Node], unchanged: dict[str, str], notes: tuple[str, ...]) -> Swapped:
        """Ask each process what it follows now; one that does not say so is not counted."""
        end = time.monotonic() + HOLD + 1.0  # those that are on their own have decided by then
        waiting = list(held)
        changed: list[str] = []
        unknown: list[str] = []
        while waiting:
            replies = ask_each({node.socket: {"request": "status"} for node in waiting})
            last = time.monotonic() >= end
            for node in list(waiting):
                reply = replies[node.socket]
                if reply["ok"] and reply["swap"] is None:
                    waiting.remove(node)
                    if self._follows(node, reply):
                        changed += self._mine(node)
                    else:
                        unchanged |= dict.fromkeys(self._mine(node), "it was rolled back there")
                elif last:
                    waiting.remove(node)
                    why = "; ".join(reply.get("reasons", ())) or "its swap is still under way"
                    unchanged |= dict.fromkeys(self._mine(node), f"{why}: it may have changed")
                    unknown += self._mine(node)
            if waiting:
                time.sleep(_PAUSE)
        return Swapped(self._epoch, tuple(sorted(changed)), unchanged, notes, tuple(sorted(unknown)))

    def _follows(self, node: Node, reply: Reply) -> bool:
        """Whether a process follows the version of this swap."""
        if self._epoch is not None:
            found = reply["epoch"]
            return (found["number"], found["hash"]) == (self._epoch, self._request["hash"])
        return node in self._finished

    def _proof(self, node: Node) -> Request:
        """What proves the epoch to a process, and to those that it tells of it."""
        robot = node.socket
        if self._epoch is None or not isinstance(robot, Robot):
            return {}
        epoch = Epoch(self._epoch, str(self._request["hash"]), node.status["epoch"]["base"])
        made = proven(robot.key, robot.system, epoch, self._members, self._needed).proof
        return {} if made is None else {"proof": made.as_data()}

    def _say(
        self,
        held: Mapping[Node, int],
        phase: str,
        reason: str | None = None,
        proofs: Mapping[Node, Request] | None = None,
    ) -> dict[Node, Reply]:
        said: Request = {"request": "swap", "phase": phase}
        if reason:
            said["reason"] = reason[:1000]
        more = proofs or {}
        replies = ask_each(
            {n.socket: {**said, "id": number, **more.get(n, {})} for n, number in held.items()}, ANSWER
        )
        return {node: replies[node.socket] for node in held}

    def _roll_back(self, held: Mapping[Node, int], reason: str) -> list[Node]:
        """Let all continue as before; gives those that did not confirm it."""
        return [node for node, reply in self._say(held, "rollback", reason).items() if not reply["ok"]]

    def _ask(self, nodes: Iterable[Node], request: Request, seconds: float) -> dict[Node, Reply]:
        nodes = list(nodes)
        replies = ask_each({node.socket: request for node in nodes}, seconds)
        return {node: replies[node.socket] for node in nodes}

    def _mine(self, node: Node) -> list[str]:
        """The agents of a process that are meant."""
        return [name for name in node.agents if name in self._members]

    def _agents(self, nodes: Iterable[Node]) -> int:
        return sum(len(self._mine(node)) for node in nodes)


__all__ = ["HOLD", "WITHIN", "Swapped", "quorum_of", "swap"]
