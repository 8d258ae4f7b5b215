"""What is said of a call while its arguments are written."""

from __future__ import annotations

from pathlib import Path

from aseme_dsl.editor.files.known import known_in
from aseme_dsl.editor.typing.signatures import signatures
from aseme_dsl.source import Source
from tests.editor.authoring import CURSOR, PATH, opened

SOCCER = (Path(__file__).parents[2] / "tests/acceptance/kouretes.aseme").read_text("utf-8")


def shown(condition: str) -> str | None:
    """The active signature with its next parameter in `«»`, and how many others there are."""
    marked = SOCCER.replace("[!vision.state.Ball.visible]", condition, 1)
    text = marked.replace(CURSOR, "")
    found = signatures(Source(PATH, text), marked.index(CURSOR), known_in(opened(text)))
    if found is None:
        return None
    one = found.signatures[found.active]
    label = one.label
    if found.parameter < len(one.parameters):
        start, end = one.parameters[found.parameter]
        label = f"{label[:start]}«{label[start:end]}»{label[end:]}"
    others = f" +{len(found.signatures) - 1}" if len(found.signatures) > 1 else ""
    return label + others


def test_a_function_with_the_parameter_that_is_next() -> None:
    assert shown("[can_kick(‸") == "can_kick(«Ball ball») : bool"
    assert shown("[distance_to(world.state.Pose, ‸) > 1]") == (
        "distance_to(Pose pose, «double x», double y) : double"
    )
    assert shown("[distance_to(world.state.Pose, 1, 2‸) > 1]") == (
        "distance_to(Pose pose, double x, «double y») : double"
    )


def test_the_innermost_call_counts() -> None:
    assert shown("[abs(min(1, ‸") == "min(int a, «int b») : int +2"
    assert shown("[abs(min(1, 2) ‸") == "abs(«int a») : int +2"


def test_the_overload_that_fits_what_is_given() -> None:
    assert shown("[max(1.5, ‸") == "max(double a, «double b») : double +2"
    assert shown("[max(200ms, ‸") == "max(duration a, «duration b») : duration +2"


def test_forms_of_the_language() -> None:
    assert shown("[expired(‸") == "expired(«timer»)"
    assert shown("[mean(vision.data.BallTrack.distance, ‸") == ("mean(topic.data.Message.member, «500ms»)")
    assert shown("/ start_timer(pace, ‸") == "start_timer(timer, «200ms»)"


def test_what_activities_and_formulas_are_given() -> None:
    def given(formula: str) -> str | None:
        marked = (
            "system T\nenum Place { HOME }\nsrm r {\n"
            f" liveness {{ r = {formula} deliver(from, to : Place) = MoveTo(from) . MoveTo(to) }}\n"
            " activities { MoveTo(goal : Place) }\n}\n"
        )
        text = marked.replace(CURSOR, "")
        found = signatures(Source(PATH, text), marked.index(CURSOR), known_in(opened(text)))
        return found.signatures[0].label + f" {found.parameter}" if found is not None else None

    assert given("MoveTo(‸Place.HOME)") == "MoveTo(goal : Place) 0"
    assert given("deliver(Place.HOME, ‸Place.HOME)") == "deliver(from, to : Place) 1"
    assert given("Rest(‸)") is None


def test_outside_of_calls_nothing_is_said() -> None:
    assert shown("[vision.state.Ball.visible‸]") is None
    assert shown("[no_such_function(‸") is None
