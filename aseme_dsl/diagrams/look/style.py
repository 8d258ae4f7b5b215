"""The one look of all drawings: colours, fonts and sizes.

The hues are those of the original editors (yellow OR, cyan AND, green BASIC, …), light enough for black text.
No meaning rests on colour alone: shape, border and words say the same.
"""

from __future__ import annotations

FONT = "Arial"
"""One name, because Graphviz' built-in metrics know it; the SVG gets the usual replacements."""

INK = "#1a1a1a"
PALE_INK = "#5f5f5f"
LINE = "#3c3c3c"
PAPER = "white"

OR_COLOUR = "#fdffb6"
AND_COLOUR = "#b1f4f0"
BASIC_COLOUR = "#c8f7a0"
ACTOR_COLOUR = "#d6f9f8"
GOAL_COLOUR = "#ffff80"
USE_CASE_COLOUR = "#c4f2a8"
HEAD_COLOUR = "#e8eef4"
ROLE_COLOUR = "white"

PROTOCOL_COLOUR = "#0057a8"
"""Border and mark of states from a protocol. It is dark on every fill, and colour-blind readers tell it from
grey."""

NUMBER_COLOUR = "#003d7a"
"""The numbers of transition expressions."""

TRANSITION_COLOUR = "#c8330a"
PARENT_COLOUR = "#9a9a9a"
"""Figure 5 draws transitions red and the tree grey; here transitions have arrowheads as well."""

TEXT_SIZE = 12
SMALL_SIZE = 9
NUMBER_SIZE = 11

GRAPH = {
    "bgcolor": PAPER,
    "fontname": FONT,
    "fontsize": str(TEXT_SIZE),
    "fontcolor": INK,
    "pad": "0.15",
}
NODE = {
    "fontname": FONT,
    "fontsize": str(TEXT_SIZE),
    "fontcolor": INK,
    "color": LINE,
    "shape": "box",
    "style": "rounded,filled",
    "fillcolor": PAPER,
    "margin": "0.1,0.05",
    "height": "0.36",
    "width": "0.5",
}
EDGE = {
    "fontname": FONT,
    "fontsize": str(NUMBER_SIZE),
    "fontcolor": INK,
    "labelfontname": FONT,
    "color": LINE,
    "arrowsize": "0.7",
}

DOT = {"label": "", "fixedsize": "true", "fillcolor": "black", "color": "black", "style": "filled"}
START_DOT = DOT | {"shape": "circle", "width": "0.17", "height": "0.17"}
END_DOT = DOT | {"shape": "doublecircle", "width": "0.13", "height": "0.13"}
CONDITION_CIRCLE = {
    "shape": "circle",
    "label": "c",
    "style": "filled",
    "width": "0.28",
    "height": "0.28",
    "fixedsize": "true",
    "margin": "0",
}
