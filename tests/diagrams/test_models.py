"""Every model of a system has its drawing, and the DOT text of each is as it was."""

from __future__ import annotations

import pytest

from aseme_dsl.amola.system import System
from aseme_dsl.diagrams import Drawing, Layout, NoSuchState, Options, drawings, render
from aseme_dsl.diagrams.look.words import words
from tests.conftest import Snapshot
from tests.diagrams.pictures import Picture
from tests.diagrams.texts import TEAM, compiled

NAMES = [
    *("sag", "suc", "aip.attack", "srm.player", "srm.goalie"),
    *("eac.attack", "eac.attack.nested", "eac.attack.tree"),
    *("iac.player", "iac.player.nested", "iac.player.tree"),
    *("iac.goalie", "iac.goalie.nested", "iac.goalie.tree"),
]
BY_GRAPHVIZ = [name for name in NAMES if name not in ("eac.attack", "iac.player", "iac.goalie")]
ALL = Options(layout=None)


@pytest.fixture(scope="module")
def team() -> System:
    return compiled(TEAM)


@pytest.fixture(scope="module")
def drawn(team: System) -> dict[str, Drawing]:
    return {drawing.name: drawing for drawing in drawings(team, ALL)}


def picture(drawing: Drawing) -> Picture:
    return Picture(render(drawing, "svg"))


def test_every_model_has_a_drawing(drawn: dict[str, Drawing]) -> None:
    assert list(drawn) == NAMES


def test_models_that_a_file_lacks_are_not_drawn() -> None:
    system = compiled("system Small\nsrm r { liveness { r = A . B } }\n")
    assert [drawing.name for drawing in drawings(system)] == ["srm.r", "iac.r"]


@pytest.mark.parametrize("name", BY_GRAPHVIZ)
def test_the_dot_text_is_as_it_was(name: str, drawn: dict[str, Drawing], snapshot: Snapshot) -> None:
    snapshot(drawn[name].dot, f"{name}.dot")


@pytest.mark.parametrize("name", NAMES)
def test_each_drawing_is_described_in_words(name: str, team: System, drawn: dict[str, Drawing]) -> None:
    assert words(team, drawn[name]) != f"{name} of {team.name}"


def test_dot_texts_are_made_the_same_again(drawn: dict[str, Drawing]) -> None:
    again = {drawing.name: drawing.dot for drawing in drawings(compiled(TEAM), ALL)}
    assert again == {name: drawing.dot for name, drawing in drawn.items()}


@pytest.mark.parametrize("name", NAMES)
def test_an_svg_tells_nothing_of_the_machine(name: str, drawn: dict[str, Drawing]) -> None:
    svg = render(drawn[name], "svg")
    assert svg == render(drawn[name], "svg")
    assert b"Generated" not in svg
    assert b"<!--" not in svg
    assert b"graphviz" not in svg.lower()
    assert b"DOCTYPE" not in svg


def test_the_sag_shows_who_wants_what_and_on_whom_it_depends(drawn: dict[str, Drawing]) -> None:
    shown = picture(drawn["sag"])
    assert shown.says("actor.0") == "player"
    assert shown.says("goal.0") == "score\nThe ball is in the opponents' goal."
    assert {"goal.0.own", "goal.0.on.actor.0", "goal.1.own"} <= shown.ids
    assert "goal.1.on.actor.0" not in shown.ids
    assert shown.tip("goal.2.on.actor.0") == "guard depends on player"


def test_the_suc_shows_roles_use_cases_and_what_they_include(drawn: dict[str, Drawing]) -> None:
    shown = picture(drawn["suc"])
    assert "«system»\nplayer" in shown.text
    assert "«abstract»\ncenter_for" in shown.text
    assert shown.text.count("«includes»") == 2  # one for all arrows of a use case
    for name in ("score", "attack", "walk_to_ball", "pass_ball", "kick_ball"):
        assert f"\n{name}\n" in f"\n{shown.text}\n"


def test_the_aip_is_the_table_of_the_paper(drawn: dict[str, Drawing]) -> None:
    lines = picture(drawn["aip.attack"]).text.split("\n")
    for title in ("Participants", "Engagement Rules", "Outcomes (one of)", "Process", "Variables", "Clauses"):
        assert title in lines
    for text in (
        "center",
        "center_for [1..*]",
        "WalkToBall . [PassBall]",
        "tries : int = 0",
        "at most one center",
    ):
        assert text in lines
    assert "Sends" not in lines  # nobody sends anything here


def test_the_srm_shows_all_that_is_known_of_a_role(drawn: dict[str, Drawing]) -> None:
    lines = picture(drawn["srm.player"]).text.split("\n")
    for text in (
        *("Role player", "attack: center, attack: center_for with WalkToGoal = WalkToTheirGoal"),
        *("player = Vision~ || (play | Wait)+", "play = Search | center | center_for"),
        *("limit : int = 80", "camera", "33ms", "20ms", "vision.state.Ball", "OpenCV"),
    ):
        assert text in lines


def test_a_layout_can_be_chosen(team: System) -> None:
    charts = ("eac.attack", "iac.player", "iac.goalie")
    others = [name for name in NAMES if not name.startswith(charts)]
    for layout, ending in ((Layout.COMPACT, ""), (Layout.NESTED, ".nested"), (Layout.TREE, ".tree")):
        names = [drawing.name for drawing in drawings(team, Options(layout=layout))]
        assert names == [*others, *(f"{name}{ending}" for name in charts)]
    assert drawings(team) == drawings(team, Options(layout=Layout.COMPACT))


def test_a_part_is_drawn_of_the_charts_that_have_it(team: System) -> None:
    names = [drawing.name for drawing in drawings(team, Options(at="0.2.2.2", layout=Layout.NESTED))]
    assert names == ["eac.attack.nested.0.2.2.2", "iac.player.nested.0.2.2.2"]
    with pytest.raises(NoSuchState, match=r"no statechart of Team has a state 0\.9"):
        drawings(team, Options(at="0.9"))
