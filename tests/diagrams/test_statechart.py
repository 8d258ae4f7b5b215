"""What a drawing of a statechart shows of it, and how."""

from __future__ import annotations

import pytest

from aseme_dsl.amola.statechart import Origin, OriginKind, Statechart
from aseme_dsl.diagrams import Expressions, Layout, NoSuchState, Options, draw_statechart, render
from tests.diagrams.building import FIGURE_4, condition, statechart
from tests.diagrams.pictures import Picture, distance_to_border
from tests.diagrams.texts import TEAM, compiled

BEHAVIOUR = """\
system Behaviour
message Ball { bool visible  double distance }
message Game { bool on }
topic vision { state Ball }
topic game   { state Game }
srm robot {
  liveness {
    robot = (Play | NoPlay)+
    Play  = Stare | Scan
  }
  let near = vision.state.Ball.visible && vision.state.Ball.distance < 40
  control robot {
    enter  (Play | NoPlay) : / start_timer(pace, 200ms)
    repeat (Play | NoPlay) : [expired(pace)] / start_timer(pace, 200ms)
    leave  (Play | NoPlay) : after(10min)
    enter  Play            : [game.state.Game.on]
    enter  NoPlay          : else
  }
  control Play {
    enter Scan  : [!near]
    enter Stare : [near]
  }
}
"""


def chart() -> Statechart:
    return compiled(BEHAVIOUR).iacs[0]


def nested(chart: Statechart, **options: object) -> Picture:
    return _picture(chart, Options(layout=Layout.NESTED, **options))  # type: ignore[arg-type]


def tree(chart: Statechart, **options: object) -> Picture:
    return _picture(chart, Options(layout=Layout.TREE, **options))  # type: ignore[arg-type]


def _picture(chart: Statechart, options: Options) -> Picture:
    (drawing,) = draw_statechart(chart, options)
    return Picture(render(drawing, "svg"))


def legend(picture: Picture) -> list[str]:
    """The lines of the drawing's own label."""
    graph = next(item for item in picture.root if item.get("class") == "graph")
    return [text.text for text in graph if text.tag.endswith("text") and text.text and text.text.strip()]


# ---- expressions ----------------------------------------------------------------------------------


def test_expressions_are_numbered_in_the_order_in_which_they_are_tried() -> None:
    shown = nested(chart())
    assert legend(shown) == [
        *("1", "robot: start to (Play | NoPlay)", "/ start_timer(pace, 200ms)"),
        *("2", "robot: (Play | NoPlay) again", "[expired(pace)] / start_timer(pace, 200ms)"),
        *("3", "robot: (Play | NoPlay) to end", "after(10min)"),
        *("4", "(Play | NoPlay): choice to Play", "[game.state.Game.on]"),
        *("5", "(Play | NoPlay): choice to NoPlay", "else"),
        *("6", "Play: choice to Scan", "[!near]"),
        *("7", "Play: choice to Stare", "[near]"),
        *("let near", "= vision.state.Ball.visible && vision.state.Ball.distance < 40"),
    ]
    assert shown.says("t0") == "1"
    assert shown.says("t1.turn") == "2"  # the loop of a composite bears its number where it turns


def test_a_legend_entry_is_found_at_its_transition_in_the_tree_too() -> None:
    shown = tree(chart())
    robot = chart()
    place = next(i for i, t in enumerate(robot.transitions) if robot.node(t.target).name == "NoPlay")
    assert shown.says(f"t{place}") == "5"
    assert "else" in legend(shown)


def test_the_whole_expression_is_in_the_tip_of_transition_and_state() -> None:
    robot = chart()
    choice = next(node for node in robot.states if node.label == "0.2.3.2")
    place = next(i for i, t in enumerate(robot.transitions) if robot.node(t.target).name == "Scan")
    for shown in (nested(robot), tree(robot), nested(robot, expressions=Expressions.NONE)):
        assert "[!near]" in shown.tip(f"t{place}")
        assert "tried as number 1 of 2" in shown.tip(f"t{place}")
        assert "BASIC Scan: [!near]" in shown.tip(f"n{choice.label}")


def test_expressions_can_stand_at_the_transitions() -> None:
    shown = nested(chart(), expressions=Expressions.INLINE)
    assert "after(10min)" in shown.says("t2")
    assert legend(shown) == ["let near", "= vision.state.Ball.visible && vision.state.Ball.distance < 40"]


def test_in_the_tree_expressions_stand_in_the_states() -> None:
    shown = tree(chart(), expressions=Expressions.INLINE)
    assert "to NoPlay: else" in shown.says("n0.2.2")


def test_expressions_can_be_left_out() -> None:
    for shown in (nested(chart(), expressions=Expressions.NONE), tree(chart(), expressions=Expressions.NONE)):
        assert legend(shown) == []
        assert "near" not in shown.text
        assert shown.says("t0") == ""


# ---- parts ----------------------------------------------------------------------------------------


def test_only_the_part_that_is_asked_for_is_drawn() -> None:
    shown = nested(chart(), at="0.2.3")
    states = {id for id in shown.ids if id.startswith("n")}
    assert states == {"n0.2.3", *(f"n0.2.3.{k}" for k in range(1, 6))}
    assert legend(shown)[:3] == ["1", "Play: choice to Scan", "[!near]"]


@pytest.mark.parametrize("layout", [Layout.NESTED, Layout.TREE])
def test_deeper_states_are_closed_and_say_how_much_is_inside(layout: Layout) -> None:
    (drawing,) = draw_statechart(statechart(FIGURE_4), Options(layout=layout, depth=3))
    shown = Picture(render(drawing, "svg"))
    assert "n0.2.5" in shown.ids
    assert "n0.2.5.2" in shown.ids
    assert "n0.2.5.2.1" not in shown.ids
    assert "92 states inside" in shown.says("n0.2.5.2")
    assert "2 states inside" in shown.says("n0.2.1.2")


def test_the_loop_of_a_closed_state_is_drawn_and_those_inside_are_not() -> None:
    chart = statechart("(A . B~)+ . C")
    loops = {
        item.source: f"t{place}" for place, item in enumerate(chart.transitions) if item.source == item.target
    }
    assert list(loops) == ["0.2.2.3.2", "0.2.2"]
    shown = nested(chart, depth=2)
    assert loops["0.2.2"] in shown.ids
    assert loops["0.2.2.3.2"] not in shown.ids


def test_a_label_that_is_none_is_refused() -> None:
    with pytest.raises(NoSuchState, match=r"robot has no state 0\.7"):
        draw_statechart(chart(), Options(at="0.7"))


def test_a_depth_of_nothing_is_refused() -> None:
    with pytest.raises(ValueError, match="at least 1"):
        Options(depth=0)


# ---- states ---------------------------------------------------------------------------------------


def test_the_branch_of_a_protocol_is_marked_in_a_role() -> None:
    player = compiled(TEAM).iacs[0]
    branches = {
        str(node.origin): node.label for node in reversed(player.states) if "protocol" in str(node.origin)
    }
    label = branches["protocol attack.center_for"]
    for shown in (nested(player), tree(player)):
        assert "«attack.center_for»" in shown.says(f"n{label}")
        assert shown.text.count("«attack.center_for»") == 1
        assert shown.text.count("«attack.center»") == 1


def test_in_the_chart_of_a_protocol_nothing_is_marked() -> None:
    center = Origin(OriginKind.PROTOCOL, "attack", "center")
    text = {"attack": "center || other", "center": "A . B", "other": "C"}
    shown = nested(statechart(text, kind="EAC", origins={"center": center}))
    assert "«" not in shown.text


def test_regions_stand_beside_each_other_and_small_ones_in_columns() -> None:
    two = nested(statechart("(A . B) || (C . D)"))
    assert (
        two.frame("n0.2.1")[2] <= two.frame("n0.2.2")[0] or two.frame("n0.2.2")[2] <= two.frame("n0.2.1")[0]
    )
    shown = nested(statechart(FIGURE_4))
    columns = {round(shown.frame(f"n0.2.{k}.1")[0]) for k in range(1, 5)}
    assert len(columns) == 1
    left, _, right, _ = shown.frame("n0")
    assert right - left < 1600


# ---- transitions ----------------------------------------------------------------------------------


def test_lines_end_at_the_borders_of_composites() -> None:
    chart = statechart("(A . B) . (C | D) . (E || F)")
    shown = nested(chart)
    for place, item in enumerate(chart.transitions):
        for label in (item.source, item.target):
            if item.source.count(".") == 1 and chart.children(label):
                frame = shown.frame(f"n{label}")
                assert min(distance_to_border(frame, point) for point in shown.line(f"t{place}")) < 2


def test_the_loop_of_a_composite_runs_beside_it() -> None:
    loop = statechart("(A | B)+", {("0.2", "0.2"): condition()})
    shown = nested(loop)
    place = next(i for i, t in enumerate(loop.transitions) if t.source == t.target)
    frame = shown.frame("n0.2")
    for part in (f"t{place}", f"t{place}.rest"):
        assert min(distance_to_border(frame, point) for point in shown.line(part)) < 2
    assert shown.says(f"t{place}.turn") == "1"
    left, _, right, _ = shown.frame("n0")
    assert all(left <= x <= right for x, _ in shown.line(f"t{place}.side"))


def test_transitions_between_depths_are_drawn() -> None:
    more = [("0.2.2", "0.3.3"), ("0.2.3", "0.2"), ("0.3", "0.3.2"), ("0.3.3", "0.2.2"), ("0.3.3", "0.2")]
    across = statechart("(A . B) . (C . D)", more=more)
    for shown in (nested(across), tree(across)):
        assert {f"t{place}" for place in range(len(across.transitions))} <= shown.ids
    shown = nested(across, at="0.2")
    assert "to 0.3.3\nD" in shown.text
    assert "from 0.3.3\nD" in shown.text


def test_two_transitions_with_the_same_ends_are_both_drawn() -> None:
    double = statechart("A . B", more=[("0.2", "0.3")])
    for shown in (nested(double), tree(double)):
        assert {"t1", "t3"} <= shown.ids
