"""`asemec why`: what led an agent to where it was."""

from __future__ import annotations

import click

from aseme_dsl.cli.asking import WHAT_HELP, answer, question


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
    return answer(
        agent,
        what,
        trace,
        moment,
        depth,
        as_json,
        colour,
        True,
        lambda found: f"`{what}` happened:" if found.is_so else f"`{what}` did not happen:",
    )
