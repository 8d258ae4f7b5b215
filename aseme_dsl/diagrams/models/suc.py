"""The SUC drawing: roles, the use cases they take part in, and what these include (P1, Figure 3)."""

from __future__ import annotations

from aseme_dsl.amola.suc import Role, Suc, UseCase
from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.dot import Box, Line, Sheet
from aseme_dsl.diagrams.look.labels import Cell, wrapped
from aseme_dsl.diagrams.look.marks import NAME_LINES, cells_label

_WIDTH = 24


def sheet(suc: Suc, name: str) -> Sheet:
    """Lines join a role to its use cases; dashed arrows «includes» lead to what a use case is made of."""
    roles = {role.name: f"role.{index}" for index, role in enumerate(suc.roles)}
    cases = {case.name: f"usecase.{index}" for index, case in enumerate(suc.usecases)}
    boxes = [_role(role, roles[role.name]) for role in suc.roles]
    boxes += [_usecase(case, cases[case.name]) for case in suc.usecases]
    lines = []
    for case in suc.usecases:
        own = cases[case.name]
        for participant in dict.fromkeys(case.participants):
            if participant in roles:
                tip = {
                    "dir": "none",
                    "tooltip": f"{participant} takes part in {case.name}",
                    "class": "participates",
                }
                lines.append(Line(roles[participant], own, f"{roles[participant]}.in.{own}", tip))
        for included in dict.fromkeys(case.includes):
            if included in cases:
                lines.append(_includes(case.name, included, own, cases[included]))
    graph = style.GRAPH | {"rankdir": "LR", "nodesep": "0.3", "ranksep": "0.9"}
    return Sheet(name, tuple(boxes), tuple(lines), graph, style.NODE, style.EDGE)


def _role(role: Role, box_id: str) -> Box:
    mark = Cell((f"«{role.type.value}»",), size=style.SMALL_SIZE, ink=style.PALE_INK, align="CENTER")
    label, text = cells_label([mark, Cell(wrapped(role.name, _WIDTH, NAME_LINES), align="CENTER")])
    look = {"style": "filled", "fillcolor": style.ROLE_COLOUR, "class": f"role {role.type.value}"}
    return Box(box_id, look | label | {"tooltip": f"{role.type.value} role {role.name}"}, text)


def _usecase(case: UseCase, box_id: str) -> Box:
    lines = wrapped(case.name, _WIDTH, NAME_LINES)
    tip = [f"use case {case.name}", case.requirements, *(f"realised by {name}" for name in case.realises)]
    look = {"shape": "ellipse", "style": "filled", "fillcolor": style.USE_CASE_COLOUR, "class": "usecase"}
    return Box(box_id, look | {"label": "\n".join(lines), "tooltip": "\n".join(filter(None, tip))}, lines)


def _includes(case: str, included: str, source: str, target: str) -> Line:
    look = {
        "style": "dashed",
        "arrowhead": "vee",
        "label": "«includes»",
        "fontsize": str(style.SMALL_SIZE),
        "tooltip": f"{case} includes {included}",
        "class": "includes",
    }
    return Line(source, target, f"{source}.includes.{target}", look, ("«includes»",))
