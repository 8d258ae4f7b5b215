"""Markup: an XML file as elements with their places, read without anything that XML can do to its reader.

Document types are refused, and with them all entities. Size, depth and number of elements are limited.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import field
from xml.parsers import expat

from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

DEEPEST = 200
"""How many elements may be open at once; the deepest model of the originals has 20 levels."""
MOST = 100_000
"""The largest number of elements of a file; the originals' largest has two hundred."""
_CHUNK = 65_536
_TAG = re.compile(r"<[^\s/>]*")


class Unreadable(Exception):
    """Why a file is not read, and where."""

    def __init__(self, reason: str, place: Span) -> None:
        super().__init__(reason)
        self.place = place


@dataclass(slots=True)
class Element:
    """An element: its tag and its attributes without prefixes, and where it begins.

    Of two attributes that differ in their prefix only, the one without a prefix counts.
    """

    tag: str
    attributes: dict[str, str]
    place: Span
    children: list[Element] = field(default_factory=list)
    text: str = ""
    """What stands directly inside, without the elements there."""
    namespace: str = ""
    prefixed: dict[str, str] = field(default_factory=dict)
    """The attributes that had a prefix, with their namespaces."""

    def said(self, name: str) -> str:
        """An attribute without a prefix, and without blanks at its ends; "" if it is missing."""
        return "" if name in self.prefixed else self.attributes.get(name, "").strip()

    def get(self, name: str) -> str:
        """An attribute, without blanks at its ends; "" if it is missing, or says `null` as EMF once did."""
        value = self.attributes.get(name, "").strip()
        return "" if value == "null" else value

    def named(self, tag: str) -> Iterator[Element]:
        """The children of a tag."""
        return (child for child in self.children if child.tag == tag)


def read_markup(source: Source) -> Element:
    """The root element of an XML text. Raises Unreadable."""
    return _Reader(source).whole()


_SIGN = "\t"
"""What stands between a namespace and a name; no address has it."""


def _parts(name: str) -> tuple[str, str]:
    """The namespace and the name of an element or attribute."""
    namespace, _, local = name.rpartition(_SIGN)
    return namespace, local


class _Reader:
    def __init__(self, source: Source) -> None:
        self.source = source
        self.bytes = source.text.encode("utf-8", "surrogatepass")
        self.root: Element | None = None
        self.open: list[Element] = []
        self.texts: list[list[str]] = []
        self.count = 0
        self.seen = (0, 0)
        """A place in bytes and the same in characters; places only grow."""
        self.parser = expat.ParserCreate("utf-8", _SIGN)
        self.parser.StartElementHandler = self.begin
        self.parser.EndElementHandler = self.end
        self.parser.CharacterDataHandler = self.characters
        self.parser.StartDoctypeDeclHandler = self.doctype
        self.parser.buffer_text = False

    def whole(self) -> Element:
        try:
            for start in range(0, len(self.bytes), _CHUNK):
                self.parser.Parse(self.bytes[start : start + _CHUNK], False)
            self.parser.Parse(b"", True)
        except expat.ExpatError as problem:
            at = min(self.offset(self.parser.ErrorByteIndex), len(self.source.text))
            raise Unreadable(expat.ErrorString(problem.code), self.place(at, 1)) from None
        if self.root is None:
            raise Unreadable("it has no element", self.place(0, 1))
        return self.root

    def begin(self, name: str, attributes: dict[str, str]) -> None:
        at = self.offset(self.parser.CurrentByteIndex)
        tag = _TAG.match(self.source.text, at)
        place = self.place(at, len(tag[0]) if tag is not None else 1)
        self.count += 1
        if len(self.open) >= DEEPEST:
            raise Unreadable(f"its elements are nested more than {DEEPEST} deep", place)
        if self.count > MOST:
            raise Unreadable(f"it has more than {MOST} elements", place)
        plain = {key for key in attributes if _SIGN not in key}
        known = {_parts(key)[1]: value for key, value in attributes.items() if key not in plain}
        prefixed = {local: space for space, local in map(_parts, attributes) if local not in plain}
        known |= {key: attributes[key] for key in plain}
        namespace, local = _parts(name)
        element = Element(local, known, place, namespace=namespace, prefixed=prefixed)
        if self.open:
            self.open[-1].children.append(element)
        else:
            self.root = element
        self.open.append(element)
        self.texts.append([])

    def end(self, _name: str) -> None:
        self.open.pop().text = "".join(self.texts.pop())

    def characters(self, text: str) -> None:
        if self.texts:
            self.texts[-1].append(text)

    def doctype(self, *_declared: object) -> None:
        at = self.offset(self.parser.CurrentByteIndex)
        raise Unreadable("it has a document type", self.place(at, len("<!DOCTYPE")))

    def offset(self, index: int) -> int:
        """The character at a byte."""
        at, characters = self.seen
        if index < at:
            at, characters = 0, 0
        characters += len(self.bytes[at:index].decode("utf-8", "ignore"))
        self.seen = (max(index, 0), characters)
        return characters

    def place(self, start: int, length: int) -> Span:
        return Span(self.source, start, min(start + length, len(self.source.text)))


__all__ = ["DEEPEST", "MOST", "Element", "Unreadable", "read_markup"]
