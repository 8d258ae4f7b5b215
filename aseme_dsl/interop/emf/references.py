"""References: what `//@nodes.0/@Children.1`, `#/12` and `#_id` lead to in an XMI file."""

from __future__ import annotations

import re

from aseme_dsl.interop.emf.markup import Element

_STEP = re.compile(r"@(?P<feature>\w+)(?:\.(?P<number>[0-9]{1,7}))?")
_ROOT = re.compile(r"/(?P<number>[0-9]{1,7})?")


class References:
    """The elements of a file by what EMF writes for them."""

    def __init__(self, document: Element) -> None:
        self.tops = document.children if document.tag == "XMI" else [document]
        self.ids: dict[str, Element] = {}
        self.places: dict[tuple[int, str], list[Element]] = {}
        waiting = [document]
        while waiting:
            element = waiting.pop()
            if name := element.attributes.get("id"):
                self.ids.setdefault(name, element)
            for child in element.children:
                self.places.setdefault((id(element), child.tag), []).append(child)
            waiting += element.children

    def of(self, element: Element, feature: str) -> list[Element | str]:
        """What a feature leads to: elements, and the text of each reference that leads nowhere."""
        written = element.get(feature).split()
        written += [child.get("href") for child in element.named(feature) if child.get("href")]
        return [self._target(item) or item for item in written]

    def one(self, element: Element, feature: str) -> Element | str | None:
        """The first of them."""
        return next(iter(self.of(element, feature)), None)

    def _target(self, reference: str) -> Element | None:
        text = reference.removeprefix("#")
        if not text.startswith("/"):
            return self.ids.get(text)
        first, *steps = text[1:].split("/")
        top = _ROOT.fullmatch(f"/{first}")
        if top is None or int(top["number"] or 0) >= len(self.tops):
            return None
        found = self.tops[int(top["number"] or 0)]
        for step in steps:
            read = _STEP.fullmatch(step)
            if read is None:
                return None
            places = self.places.get((id(found), read["feature"]), [])
            number = int(read["number"] or 0)
            if number >= len(places):
                return None
            found = places[number]
        return found


__all__ = ["References"]
