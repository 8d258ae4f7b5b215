"""What the pages of these tests draw, and how their pictures are looked at."""

from __future__ import annotations

import re
from xml.etree import ElementTree

WALKER = """\
system Walker
message Seen { bool ball  bool home }
topic eyes { state Seen }
srm robot {
  liveness { robot = (Walk | Stand)+ }
  activities { Walk takes 1s  Stand takes 1s }
  control robot {
    enter Walk  : [eyes.state.Seen.ball]
    enter Stand : else
    leave  (Walk | Stand) : [eyes.state.Seen.home]
    repeat (Walk | Stand) : else
  }
}
"""

SMALL = """\
system Small
srm robot {
  liveness { robot = Look | Wait }
}
"""

BROKEN = SMALL.replace("}\n}", "}\n  activities { Loook }\n}")
"""The same with a mistake in its line 4."""

SVG = "{http://www.w3.org/2000/svg}"


def svgs(html: str) -> list[ElementTree.Element]:
    """The pictures inside a page, each well-formed."""
    return [ElementTree.fromstring(found) for found in re.findall(r"<svg .*?</svg>", html, re.DOTALL)]


def texts(svg: ElementTree.Element) -> list[str]:
    """What is written in a picture."""
    return ["".join(item.itertext()).strip() for item in svg.iter(f"{SVG}text")]


def ids(html: str) -> list[str]:
    return re.findall(r'\bid="([^"]*)"', html)
