"""The SUC drawing: roles, the use cases they take part in, and what these include (P1, Figure 3)."""

from __future__ import annotations

from aseme_dsl.amola.suc import Role, Suc, UseCase
from aseme_dsl.diagrams.look import style
from aseme_dsl.diagrams.look.dot import Box, Line, Sheet
from aseme_dsl.diagrams.look.labels import Cell, wrapped
from aseme_dsl.diagrams.look.marks import NAME_LINES, cells_label
from aseme_dsl.diagrams.look.tables import titled

_WIDTH = 24

_DASHED = {"style": "dashed"}


def sheet(suc: Suc, name: str) -> Sheet:
    """Lines join a role to its use cases; dashed arrows lead to what a use case «includes».

    The word stands once for all arrows of a use case, where no line crosses it.
    """
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
        included = [name for name in dict.fromkeys(case.includes) if name in cases]
        if included:
            word = f"{own}.includes"
            boxes.append(_word(case.name, word))
            lines.append(Line(own, word, f"{word}.all", _DASHED | {"arrowhead": "none"}))
            lines += [_includes(case.name, name, word, cases[name]) for name in included]
    graph = style.GRAPH | {"rankdir": "LR", "nodesep": "0.3", "ranksep": "0.8"}
    drawn = Sheet(name, tuple(boxes), tuple(lines), graph, style.NODE, style.EDGE)
    return titled(drawn, "Roles and use cases", "")


def _role(role: Role, box_id: str) -> Box:
    mark = Cell((f"«{role.type.value}»",), size=style.SMALL_SIZE, ink=style.PALE_INK, align="CENTER")
    label, text = cells_label([mark, _name(role.name)])
    colours = {"fillcolor": style.ROLE_COLOUR, "color": style.RULE_COLOUR}
    look = colours | {"style": "filled", "class": f"role {role.type.value}"}
    return Box(box_id, look | label | {"tooltip": f"{role.type.value} role {role.name}"}, text)


def _usecase(case: UseCase, box_id: str) -> Box:
    label, lines = cells_label([_name(case.name)])
    tip = [f"use case {case.name}", case.requirements, *(f"realised by {name}" for name in case.realises)]
    look = style.USE_CASE | {"shape": "ellipse", "style": "filled", "class": "usecase", "margin": "0.02,0"}
    return Box(box_id, look | label | {"tooltip": "\n".join(filter(None, tip))}, lines)


def _name(name: str) -> Cell:
    return Cell(wrapped(name, _WIDTH, NAME_LINES), bold=True, align="CENTER", size=style.NAME_SIZE)


def _word(case: str, box_id: str) -> Box:
    lines = ("«includes»",)
    look = {
        "shape": "plaintext",
        "style": "",
        "label": lines[0],
        "fontsize": str(style.SMALL_SIZE),
        "fontcolor": style.PALE_INK,
        "margin": "0.06,0.02",
        "width": "0",
        "height": "0",
        "tooltip": f"what {case} includes",
        "class": "includes",
    }
    return Box(box_id, look, lines)


def _includes(case: str, included: str, source: str, target: str) -> Line:
    look = {"arrowhead": "vee", "tooltip": f"{case} includes {included}", "class": "includes"}
    return Line(source, target, f"{source}.{target}", _DASHED | look)
