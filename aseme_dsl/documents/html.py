"""HTML: a picture as a part of a page."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from xml.etree import ElementTree

SVG = "http://www.w3.org/2000/svg"
XLINK = "http://www.w3.org/1999/xlink"

FIGURE_CLASS = "aseme-diagram"
PROBLEM_CLASS = "aseme-problem"
COMPACT_CLASS = "aseme-compact"
"""The class of a compact drawing, whose titles are its tips."""

_STYLE = "max-width:100%;height:auto"
"""Never wider than the page."""

_SMALLEST = 0.75
"""A drawing with small text is not made smaller than this: a page that has less room scrolls it."""


def inline(svg: bytes, alt: str, prefix: str, links: Mapping[str, str] | None = None) -> str:
    """The SVG as an element of an HTML page.

    Its ids get a prefix, since a page may have several pictures. A link to a file of the `links` leads to the
    picture with that prefix. A wide compact drawing is scrolled rather than made too small. What Graphviz
    writes as a link that leads nowhere, to hold a tip, becomes a group with a title: a page shows links in
    its own way.
    """
    ElementTree.register_namespace("", SVG)
    ElementTree.register_namespace("xlink", XLINK)
    root = ElementTree.fromstring(svg)
    ours = root.get("class") == COMPACT_CLASS
    for element in list(root.iter()):
        own = element.get("id")
        if own is not None:
            element.set("id", f"{prefix}-{own}")
        for title in () if ours else element.findall(f"{{{SVG}}}title"):
            element.remove(title)  # a name of Graphviz' own, such as cluster_n0
    for link in list(root.iter(f"{{{SVG}}}a")):
        tip = link.attrib.pop(f"{{{XLINK}}}title", None)
        picture = (links or {}).get(link.attrib.pop("href", ""))
        if picture is not None:
            link.set("href", f"#{picture}")
        elif f"{{{XLINK}}}href" not in link.attrib:
            link.tag = f"{{{SVG}}}g"
        if tip is not None:
            title = ElementTree.Element(f"{{{SVG}}}title")
            title.text = tip
            link.insert(0, title)
    root.attrib |= {"id": prefix, "aria-label": alt, "style": _STYLE}
    if not ours:
        root.set("role", "img")
        return ElementTree.tostring(root, encoding="unicode")
    least = float(root.get("width", "0")) * _SMALLEST
    root.set("style", f"{_STYLE};min-width:{least:.0f}px")
    return f'<div style="overflow-x:auto">{ElementTree.tostring(root, encoding="unicode")}</div>'


def image(address: str, alt: str) -> str:
    """A picture that is a file beside the page."""
    return f'<img src="{escape(address)}" alt="{escape(alt)}" style="{_STYLE}">'


def figure(pictures: str, caption: str) -> str:
    """Pictures with what is written under them."""
    under = f"<figcaption>{escape(caption)}</figcaption>" if caption else ""
    return f'<figure class="{FIGURE_CLASS}">{pictures}{under}</figure>'


def problem(report: str) -> str:
    """What is wrong, where the picture would be."""
    return f'<pre class="{PROBLEM_CLASS}">{escape(report)}</pre>'
