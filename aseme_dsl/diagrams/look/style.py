"""The one style of all drawings that Graphviz lays out: colours, fonts and sizes.

The hues of statecharts are those of the original editors (yellow OR, cyan AND, green BASIC, …), light enough
for dark text. No meaning rests on colour alone: shape, border and words say the same.
"""

from __future__ import annotations

from aseme_dsl.diagrams.look.colours import LIGHT

FONT = "Arial"
"""One name, because Graphviz' built-in metrics know it; the SVG gets the usual replacements."""

FONTS = f"{FONT},Liberation Sans,Helvetica,DejaVu Sans Condensed,sans-serif"
"""The fourth is as wide as the first, and is where the others are not: the usual one of Linux is wider."""

INK = LIGHT["ink"]
PALE_INK = LIGHT["soft"]
LINE = LIGHT["line"]
PAPER = LIGHT["paper"]

OR_COLOUR = LIGHT["or"]
AND_COLOUR = LIGHT["and"]
BASIC_COLOUR = LIGHT["basic"]
HEAD_COLOUR = LIGHT["pill"]
ROLE_COLOUR = LIGHT["frame"]
RULE_COLOUR = LIGHT["frame-border"]

ACTOR = {"fillcolor": LIGHT["q0"], "color": LIGHT["p0"]}
GOAL = {"fillcolor": LIGHT["choice"], "color": LIGHT["choice-border"]}
USE_CASE = {"fillcolor": LIGHT["node"], "color": LIGHT["node-border"]}

PROTOCOL_COLOUR = LIGHT["p0"]
"""Border and mark of states from a protocol. It is dark on every fill, and colour-blind readers tell it from
grey."""

NUMBER_COLOUR = LIGHT["number"]
"""The numbers of transition expressions."""

TRANSITION_COLOUR = LIGHT["transition"]
PARENT_COLOUR = LIGHT["frame-border"]
"""Figure 5 draws transitions red and the tree grey; here transitions have arrowheads as well."""

TITLE_SIZE = 16
NAME_SIZE = 13
TEXT_SIZE = 12
SMALL_SIZE = 11
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

DOT = {"label": "", "fixedsize": "true", "fillcolor": INK, "color": INK, "style": "filled"}
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
