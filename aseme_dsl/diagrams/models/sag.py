"""The SAG drawing: actors as circles, goals as rounded boxes, and who depends on whom (P1, Figure 2)."""

from __future__ import annotations

from aseme_dsl.amola.sag import Goal, Sag
from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.dot import Box, Line, Sheet
from aseme_dsl.diagrams.look.labels import Cell, wrapped
from aseme_dsl.diagrams.look.marks import NAME_LINES, cells_label
from aseme_dsl.diagrams.look.tables import titled

_WIDTH = 34


def sheet(sag: Sag, name: str) -> Sheet:
    """Arrows lead from an actor to its goals, and from a goal to the actors on whom it depends (dashed).

    They lead from left to right alone, so that none runs back over another: an actor with goals on whom
    others depend stands on the right once more.
    """
    place = {actor.name: f"actor.{index}" for index, actor in enumerate(sag.actors)}
    owners = {goal.depender for goal in sag.goals} & place.keys()
    boxes = [_actor(actor.name, place[actor.name]) for actor in sag.actors]
    again = {name: f"{place[name]}.again" for name in owners}
    asked: dict[str, None] = {}
    lines = []
    for index, goal in enumerate(sag.goals):
        goal_id = f"goal.{index}"
        boxes.append(_goal(goal, goal_id))
        if goal.depender in place:
            tip = {"tooltip": f"{goal.depender} has the goal {goal.name}", "class": "own"}
            lines.append(Line(place[goal.depender], goal_id, f"{goal_id}.own", tip))
        for dependee in dict.fromkeys(goal.dependees):
            if dependee in place:
                asked.setdefault(dependee)
                right = again.get(dependee, place[dependee])
                lines.append(_dependency(goal, dependee, goal_id, place[dependee], right))
    boxes += [_actor(name, again[name], again=True) for name in asked if name in again]
    graph = style.GRAPH | {"rankdir": "LR", "nodesep": "0.25", "ranksep": "0.9"}
    drawn = Sheet(name, tuple(boxes), tuple(lines), graph, style.NODE, style.EDGE)
    key = "solid arrow: has the goal · dashed arrow: depends on the actor"
    return titled(drawn, "Actors and goals", key if asked else "")


def _actor(name: str, box_id: str, *, again: bool = False) -> Box:
    label, lines = cells_label([Cell(wrapped(name, 12, NAME_LINES), bold=True, align="CENTER")])
    look = style.ACTOR | {
        "shape": "circle",
        "style": "filled",
        "margin": "0",
        "class": "actor",
        "tooltip": f"actor {name}, on whom goals depend" if again else f"actor {name}",
    }
    return Box(box_id, look | label, lines)


def _goal(goal: Goal, box_id: str) -> Box:
    name = wrapped(goal.name, _WIDTH, NAME_LINES)
    cells = [Cell(name, bold=True, align="CENTER", size=style.NAME_SIZE)]
    if goal.requirements:
        lines = wrapped(goal.requirements, _WIDTH + 8)
        cells.append(Cell(lines, size=style.SMALL_SIZE, ink=style.PALE_INK, align="CENTER"))
    label, text = cells_label(cells)
    tip = f"goal {goal.name}" + (f": {goal.requirements}" if goal.requirements else "")
    return Box(box_id, style.GOAL | label | {"tooltip": tip, "class": "goal"}, text)


def _dependency(goal: Goal, dependee: str, goal_id: str, actor_id: str, box_id: str) -> Line:
    look = {
        "style": "dashed",
        "arrowhead": "vee",
        "class": "depends",
        "tooltip": f"{goal.name} depends on {dependee}",
    }
    return Line(goal_id, box_id, f"{goal_id}.on.{actor_id}", look)
