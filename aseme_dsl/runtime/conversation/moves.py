"""Moves: an activity sends only what its protocol allows it to send, and once to each agent."""

from __future__ import annotations

from collections.abc import Iterable

from aseme_dsl.runtime.chart.plan import BranchInfo, Plan, is_in


class MoveError(LookupError):
    """An activity sends what its protocol does not let it send; the text says what the protocol allows."""


Sent = frozenset[tuple[str, str, str]]
"""What one start of an activity has sent: performative, message and agent. Most send nothing, and share one
that is empty."""


def check_move(
    plan: Plan, info: BranchInfo, activity: str, label: str, performative: str, message: str
) -> bool:
    """Whether an activity may send a message more than once to one agent; that it may send it at all.

    Raises:
        MoveError: it may not send it in this state.
    """
    said = f"{performative} {message}"
    if (performative, message) not in info.sends:
        known = ", ".join(" ".join(pair) for pair in info.sends) or "nothing"
        raise MoveError(f"{info.participant} sends {known}, not {said}")
    move = next((item for item in info.moves if item[:2] == (performative, message)), None)
    if move is None:
        raise MoveError(
            f"activity {activity} may not send {said}: a transition of {info.participant} sends it"
        )
    _, _, states, repeatedly = move
    if not any(is_in(label, state) for state in states):
        names = dict.fromkeys(plan.by_label[state].activity or plan.by_label[state].name for state in states)
        raise MoveError(
            f"activity {activity} may not send {said}: {info.protocol}.{info.participant} leaves that to "
            f"{' or '.join(names) or 'nobody'}"
        )
    return repeatedly


def check_once(sent: Sent, info: BranchInfo, activity: str, said: tuple[str, str], to: Iterable[str]) -> Sent:
    """What an activity has sent when it has sent a message to these agents, too.

    Raises:
        MoveError: it has sent it to one of them since its state was entered.
    """
    keys = [(*said, name) for name in to]
    again = next((name for *_, name in keys if (*said, name) in sent), None)
    if again is not None:
        raise MoveError(
            f"activity {activity} has sent {' '.join(said)} to {again} already since its state was entered: "
            f"`sends {' '.join(said)} by {activity} repeatedly` in {info.protocol}.{info.participant} "
            "allows it"
        )
    return sent.union(keys)


def made_before(earlier: Sent, info: BranchInfo, said: tuple[str, str]) -> frozenset[str]:
    """The agents that an activity has sent a message before it was suspended, and sends it no more."""
    if any(item[:2] == said and item[3] for item in info.moves):
        return frozenset()
    return frozenset(name for *what, name in earlier if tuple(what) == said)


__all__ = ["MoveError", "Sent", "check_move", "check_once", "made_before"]
