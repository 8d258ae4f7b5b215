"""The style sheet of compact drawings, in light and dark colours."""

from __future__ import annotations

import re
from collections.abc import Collection

from aseme_dsl.amola.statechart import OriginKind, Statechart
from aseme_dsl.diagrams.look.colours import DARK, LIGHT
from aseme_dsl.diagrams.look.style import FONTS

_RULES = """\
text{font-family:{fonts};font-size:12px;fill:{ink}}
.name{font-size:13px;font-weight:bold}.title{font-size:16px;font-weight:bold}.small{font-size:11px;fill:{soft}}
.field{font-weight:bold}[aria-hidden] text:not([id]){pointer-events:none}
.action{font-style:italic;fill:{soft}}text.cut{fill:{cut}}text.error{fill:{error}}
.paper{fill:{paper}}path{fill:none;stroke:{line};stroke-width:1.3}
path.cut{stroke:{cut}}path.error{stroke:{error};stroke-dasharray:5 3}
path.never{stroke:{soft};stroke-dasharray:2 3}
.head{fill:{line};stroke:none}.head.cut{fill:{cut}}.head.error{fill:{error}}.head.never{fill:{soft}}
path.icon{stroke-width:1.3}path.soft{stroke:{soft}}path.icon.error{stroke-dasharray:none;stroke-width:1.8}
path.message{stroke:{message}}path.message.solid{fill:{message}}path.cut.solid{fill:{cut}}path.flap{stroke:{paper}}
.activity{fill:{node};stroke:{node-border};stroke-width:1.3}.pill{fill:{pill};stroke:{frame-border}}
path.choice{fill:{choice};stroke:{choice-border}}
.closed{fill:{frame};stroke:{ink};stroke-width:1.3;stroke-dasharray:2 2}
path.endless{stroke:{soft};stroke-width:1.5}
.nested{fill:{paper};stroke:{frame-border};stroke-dasharray:2 2}
.frame{fill:{frame};stroke:{frame-border}}.parallel,.stack{fill:{paper};stroke:{frame-border}}
path.stack{fill:none}
path.field{stroke:{frame-border};stroke-dasharray:6 4}
.p0{fill:{q0};stroke:{p0};stroke-width:1.3}.p1{fill:{q1};stroke:{p1};stroke-width:1.3}
.p2{fill:{q2};stroke:{p2};stroke-width:1.3}.p3{fill:{q3};stroke:{p3};stroke-width:1.3}
path.p0{stroke:{p0};stroke-width:4}path.p1{stroke:{p1};stroke-width:4}
path.p2{stroke:{p2};stroke-width:4}path.p3{stroke:{p3};stroke-width:4}
.initial{fill:{ink}}a text{text-decoration:underline}.final{fill:{paper};stroke:{ink}}.dot{fill:{ink}}"""


_INSET = (
    ".inset path{stroke-width:1}.inset .thick{stroke-width:2.2}.inset .dashed{stroke-dasharray:5 2}"
    ".inset .line text{paint-order:stroke;stroke:{paper};stroke-width:3px;stroke-linejoin:round}"
    ".f-none{fill:none}.i-none{stroke:none}"
)


def _rules(colours: dict[str, str], nested: Collection[str] = (), sizes: Collection[float] = ()) -> str:
    text = _RULES.replace("{fonts}", FONTS)
    if nested:
        text += f"\n{_INSET}"
        text += "".join(
            f".f-{name}{{fill:{{{name}}}}}.i-{name}{{stroke:{{{name}}}}}" for name in sorted(nested)
        )
        text += "".join(f".s{size:.0f}{{font-size:{size:g}px}}" for size in sorted(sizes))
    for name, colour in colours.items():
        text = text.replace(f"{{{name}}}", colour)
    # Part of a page, the rules must not reach what is around.
    return re.sub(r"(^|\}\n?)([^{}\n]+)\{", _of_drawing, text)


def _of_drawing(match: re.Match[str]) -> str:
    return f"{match[1]}{','.join(f'.aseme-compact {item}' for item in match[2].split(','))}{{"


def style(theme: str | None = None, nested: Collection[str] = (), sizes: Collection[float] = ()) -> str:
    """The style sheet: light, and dark where the reader prefers that; or one `theme` alone.

    Insets have the colours `nested` and texts of these `sizes`.
    """
    names = frozenset(nested) - {""}
    if theme is not None:
        return _rules(DARK if theme == "dark" else LIGHT, names, sizes)
    dark = _rules(DARK, names, sizes)
    return f"{_rules(LIGHT, names, sizes)}\n@media (prefers-color-scheme:dark){{{dark}}}"


def branch_colour(chart: Statechart, label: str) -> int:
    """The number of the colour of a branch: each protocol has one."""
    kind = OriginKind.PROTOCOL
    owners = dict.fromkeys(item.origin.owner for item in chart.states if item.origin.kind is kind)
    return list(owners).index(chart.node(label).origin.owner) % 4
