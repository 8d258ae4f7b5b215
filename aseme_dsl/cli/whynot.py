"""`asemec whynot`: what would have to be otherwise for an agent to be where it is not."""

from __future__ import annotations

import shlex
from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.asking import WHAT_HELP, answer, question

if TYPE_CHECKING:
    from aseme_dsl.play.asking.answer import Answer
    from aseme_dsl.play.asking.question import Question


@click.command(
    short_help="Tell why an agent did not do something.",
    help="Tell why an agent was not in a state, or did not take a transition or send a message. Listed are"
    " the activities that had not ended, the messages that had not come, and the parts of conditions that did"
    " not hold, with ages and senders. What was done instead is listed, too. The answer is tried out in a"
    f" replay: with just these things otherwise, it happens. {WHAT_HELP}",
    epilog="Example: asemec whynot robot2 KickBall --at 12.5s",
)
@question
def command(
    agent: str, what: str, trace: str | None, moment: int, depth: int, as_json: bool, colour: str
) -> int:
    """Answer; 1 if the trace cannot be read."""
    from aseme_dsl.play.asking.question import Question

    return answer(Question(agent, what, moment, False, depth), trace, as_json, colour, _title)


def _title(asked: Question, trace: str | None, found: Answer) -> str:
    if found.is_so:
        from aseme_dsl.project.testing.asking import at_text

        words = ["asemec", "why", asked.agent, asked.what, "--at", at_text(found.now)]
        return f"it is so: ask `{shlex.join(words if trace is None else [*words, trace])}`"
    count = sum(len(stage.changes) for stage in found.stages)
    if not found.stages:
        return f"`{asked.what}` did not happen:"
    things = "this was" if count == 1 else f"these {count} things were"
    return f"`{asked.what}` did not happen; it would have, if {things} otherwise:"
