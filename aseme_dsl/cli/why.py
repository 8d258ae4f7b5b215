"""`asemec why`: what led an agent to where it was."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from aseme_dsl.cli.asking import WHAT_HELP, answer, question

if TYPE_CHECKING:
    from aseme_dsl.play.asking.answer import Answer
    from aseme_dsl.play.asking.question import Question


@click.command(
    short_help="Tell why an agent did something.",
    help="Tell why an agent was in a state, took a transition or sent a message, when it last did. Listed are"
    " the activities that ended, the messages that came, and the parts of conditions that held, with ages and"
    f" senders. All this was needed: without one of these things, it would not have happened. {WHAT_HELP}",
    epilog="Example: asemec why robot2 KickBall --at 12.5s",
)
@question
def command(
    agent: str, what: str, trace: str | None, moment: int, depth: int, as_json: bool, colour: str
) -> int:
    """Answer; 1 if the trace cannot be read."""
    from aseme_dsl.play.asking.question import Question

    return answer(Question(agent, what, moment, True, depth), trace, as_json, colour, _title)


def _title(asked: Question, trace: str | None, found: Answer) -> str:
    return f"`{asked.what}` happened:" if found.is_so else f"`{asked.what}` did not happen:"
