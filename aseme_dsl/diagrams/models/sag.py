"""The SAG drawing: actors as circles, goals as rounded boxes, and who depends on whom (P1, Figure 2)."""

from __future__ import annotations

from aseme_dsl.amola.sag import Goal, Sag
from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.dot import Box, Line, Sheet
from aseme_dsl.diagrams.look.labels import Cell, wrapped
from aseme_dsl.diagrams.look.marks import NAME_LINES, cells_label

_WIDTH = 34


def sheet(sag: Sag, name: str) -> Sheet:
    """Arrows lead from an actor to its goals, and from a goal to the actors on whom it depends (dashed)."""
    place = {actor.name: f"actor.{index}" for index, actor in enumerate(sag.actors)}
    boxes = [_actor(actor.name, place[actor.name]) for actor in sag.actors]
    lines = []
    for index, goal in enumerate(sag.goals):
        goal_id = f"goal.{index}"
        boxes.append(_goal(goal, goal_id))
        if goal.depender in place:
            tip = {"tooltip": f"{goal.depender} has the goal {goal.name}", "class": "own"}
            lines.append(Line(place[goal.depender], goal_id, f"{goal_id}.own", tip))
        for dependee in dict.fromkeys(goal.dependees):
            if dependee in place:
                lines.append(_dependency(goal, dependee, goal_id, place[dependee]))
    graph = style.GRAPH | {"rankdir": "LR", "nodesep": "0.3", "ranksep": "0.9"}
    return Sheet(name, tuple(boxes), tuple(lines), graph, style.NODE, style.EDGE)


def _actor(name: str, box_id: str) -> Box:
    lines = wrapped(name, 12, NAME_LINES)
    look = {
        "shape": "circle",
        "style": "filled",
        "fillcolor": style.ACTOR_COLOUR,
        "margin": "0.02",
        "class": "actor",
    }
    return Box(box_id, look | {"label": "\n".join(lines), "tooltip": f"actor {name}"}, lines)


def _goal(goal: Goal, box_id: str) -> Box:
    cells = [Cell(wrapped(goal.name, _WIDTH, NAME_LINES), align="CENTER")]
    if goal.requirements:
        lines = wrapped(goal.requirements, _WIDTH + 8)
        cells.append(Cell(lines, size=style.SMALL_SIZE, ink=style.PALE_INK, align="CENTER"))
    label, text = cells_label(cells)
    tip = f"goal {goal.name}" + (f": {goal.requirements}" if goal.requirements else "")
    return Box(box_id, label | {"fillcolor": style.GOAL_COLOUR, "tooltip": tip, "class": "goal"}, text)


def _dependency(goal: Goal, dependee: str, goal_id: str, actor_id: str) -> Line:
    look = {
        "style": "dashed",
        "arrowhead": "vee",
        "class": "depends",
        "tooltip": f"{goal.name} depends on {dependee}",
    }
    return Line(goal_id, actor_id, f"{goal_id}.on.{actor_id}", look)
