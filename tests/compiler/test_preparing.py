"""W576: a message that is sent without content before anything can have prepared it."""

from __future__ import annotations

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics.changes import apply
from aseme_dsl.diagnostics.pages import page
from aseme_dsl.source import Source

LINE = "enter Look : request Job from client / send agree Answer to client"


def found(control: str, process: str = "Look") -> list[tuple[str, str]]:
    text = page("W576").wrong.files[0].text
    assert LINE in text and "process  = Look" in text
    text = text.replace(LINE, control).replace("process  = Look", f"process  = {process}")
    problems = analyse(Source("/nowhere/shop.aseme", text)).diagnostics
    return [(item.span.text, item.message) for item in problems if item.code == "W576"]


SENT = "send agree Answer to client"


@pytest.mark.parametrize(
    ("control", "process"),
    [
        pytest.param(f"leave Look : request Job from client / {SENT}", "Look", id="an activity has run"),
        pytest.param("enter Look : / send agree Answer to client", "Look", id="its first message"),
        pytest.param(
            f"enter Look : request Job from client / send agree Answer {{ .. }} to client; {SENT}",
            "Look",
            id="the message is repeated",
        ),
        pytest.param(
            f"enter [Look] : request Job from client  skip Look : [true] / {SENT}  enter Look : else",
            "Other . [Look]",
            id="an activity before a choice",
        ),
        pytest.param(
            f"enter Look : request Job from client / {SENT}", "Look || Other", id="an activity beside it"
        ),
    ],
)
def test_what_may_have_been_prepared(control: str, process: str) -> None:
    assert found(control, process) == []


def test_what_nothing_prepares() -> None:
    failing = "nothing prepares the content of `agree Answer`: the state that is entered fails"
    assert found(LINE) == [(SENT, failing)]


def test_towards_the_end_the_agent_fails() -> None:
    control = f"skip Look : request Job from client / {SENT}  enter Look : after(1s)"
    ((place, message),) = found(control, "[Look]")
    assert place == SENT and message.endswith("the agent fails")


def test_the_fix_says_the_defaults_that_were_sent_before() -> None:
    """A `send` without content used to send defaults."""
    text = page("W576").wrong.files[0].text
    problems = analyse(Source("/nowhere/shop.aseme", text)).diagnostics
    (problem,) = (item for item in problems if item.code == "W576")
    fixed = apply(text, problem.changes)
    assert LINE.replace("agree Answer to", "agree Answer { .. } to") in fixed
    assert analyse(Source("/nowhere/shop.aseme", fixed)).diagnostics == ()
