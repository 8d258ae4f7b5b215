"""An activity uses only what it declares: everything else raises, with the line to add."""

from __future__ import annotations

from typing import Any

import pytest

from aseme_dsl.backends.jade_like import BACKEND as JADE_LIKE
from aseme_dsl.backends.monas import BACKEND as MONAS
from aseme_dsl.runtime import Context, UndeclaredError
from tests.runtime.playing import SECOND, play
from tests.support.generated import generate

TEXT = """
system S
message M { int n }
topic t { state M  signal M  data M }
srm R {
  var x : int = 0
  liveness { R = A . B }
  activities { A KIND  B takes 1ms }
  control R { enter B : [has(t.state.M) || has(t.signal.M) || has(t.data.M) || x == 0] }
}
"""


def attempts(context: Context, message: Any) -> list[str]:
    """What each way to read and to write says."""
    found = []
    for attempt in (
        lambda: context.read("t.state.M"),
        lambda: context.latest_message("t.state.M"),
        lambda: context.latest_sample("t.state.M"),
        lambda: context.age("t.state.M"),
        lambda: context.snapshot().read("t.state.M"),
        lambda: context.consume("t.signal.M"),
        lambda: context.history("t.data.M"),
        lambda: context.at("t.data.M", 1),
        lambda: context.interpolated("t.data.M", "n", 1),
        lambda: context.mean("t.data.M", "n", 1),
        lambda: context.get_variable("x"),
        lambda: context.set_variable("x", 1),
        lambda: context.publish("t.state.M", message(n=1)),
        lambda: context.snapshot().publish("t.state.M", message(n=1)),
    ):
        with pytest.raises(UndeclaredError) as refused:
            attempt()
        found.append(str(refused.value).partition("add ")[2])
    return found


LINES = [
    f"`activities {{ A {clause} }}` to the .aseme file"
    for clause in (
        *["reads t.state.M"] * 5,
        "reads t.signal.M",
        *["reads t.data.M"] * 4,
        "reads x",
        "writes x",
        *["writes t.state.M"] * 2,
    )
]


@pytest.mark.parametrize("backend", [MONAS, JADE_LIKE], ids=["monas", "jade_like"])
@pytest.mark.parametrize("kind", ["thread", "async", "step", "process"])
def test_what_is_not_declared_raises_with_the_line_to_add(kind: str, backend: Any) -> None:
    generated = generate(TEXT.replace("KIND", "" if kind == "thread" else f"as {kind}"), backend=backend)
    message, said = generated.messages.M, []

    class Plain:
        def execute(self, context: Context) -> None:
            said.extend(attempts(context, message))

    class Async:
        async def execute(self, context: Context) -> None:
            said.extend(attempts(context, message))

    class Step:
        def execute(self, context: Context) -> Any:
            said.extend(attempts(context, message))
            yield 0.0

    kinds: dict[str, type[Any]] = {"async": Async, "step": Step}
    run = play(generated, {"A": kinds.get(kind, Plain)})
    assert said == LINES
    assert run.of("error") == [] and run.of("message") == [] and run.of("variable") == []


def test_an_activity_that_uses_what_it_does_not_declare_fails_and_says_so() -> None:
    class A:
        def execute(self, context: Context) -> None:
            context.read("t.state.M")

    run = play(
        TEXT.replace("KIND", "reads t.state.N").replace("data M }", "data M  state N }\nmessage N { int n }"),
        {"A": A},
    )
    (crash,) = run.of("activity", what="crash")
    assert crash["reason"] == (
        "UndeclaredError: activity A reads t.state.M, which it does not declare (did you mean t.state.N?): "
        "add `activities { A reads t.state.M }` to the .aseme file"
    )


def test_a_module_that_uses_what_it_does_not_declare_fails_and_says_so() -> None:
    text = TEXT.replace("KIND", "takes 1s").replace("control R", "modules { Eye every 1s }\n  control R")

    class Eye:
        def execute(self, context: Context) -> None:
            context.set_variable("x", 3)

    run = play(text, {"Eye": Eye}, until=2 * SECOND)
    assert run.of("module", what="crash")[0]["reason"] == (
        "UndeclaredError: module Eye writes the variable x, which it does not declare: "
        "add `modules { Eye writes x }` to the .aseme file"
    )


def test_the_variables_of_a_participant_are_there_for_its_activities() -> None:
    text = """
    system S
    aip p {
      participant a { var x : int = 0  process = A . B }
      participant b { process = C }
      control a { enter B : [x == 2] }
    }
    srm R { plays p.a  var y : int = 0  liveness { R = a }  activities { B takes 1s } }
    """

    class A:
        def execute(self, context: Context) -> None:
            context.set_variable("x", context.get_variable("x") + 2)
            with pytest.raises(UndeclaredError, match="reads y"):
                context.get_variable("y")

    assert play(text, {"A": A}).order("start") == ["start A", "start B"]
