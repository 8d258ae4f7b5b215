"""Monas' `agents.xml`: the modules of the original robot software, as a `modules` block.

The format (Monas, `config/agents.xml`), as far as it is known:

- `<agent>` is a thread with a frequency in Hz that executes its `<activity>` children in order.
- `<provider>` is a thread for hardware; its text is its name.
- `<statechart>` names a statechart.

`Enable` switches each of them off. Attributes may be written as child elements, and names in any case.

The file is not XML, and XML libraries refuse it: its elements stand side by side without a root, and in most
versions the values of attributes have no quotes. Both is read here, and so is proper XML, except document
types.

An agent's activities become modules of one period: they are begun in their order, but one does not wait for
another as in Monas. `IsRealTime`, `Priority` and `StatsCycle` have no counterpart in a role. What modules
read and write is in no such file and is to be added.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from dataclasses import field

from aseme_dsl.amola.expression import duration_text
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.diagnostics.problems import files as problems
from aseme_dsl.interop.emf.report import Fate, Row
from aseme_dsl.records import dataclass
from aseme_dsl.source import Source, Span

_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_PASSED_OVER = frozenset({"isrealtime", "priority", "statscycle"})
_KINDS = ("agent", "provider", "statechart")
_LONGEST = 40
"""How much of a name a message shows."""
_DEEPEST = 100
"""How many elements may be open at once; Monas needs two, and a root."""
_MARKUP = (("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>"))
_TAG = re.compile(r"<(/?)([^\W\d][\w.:-]*)")
_ATTRIBUTE = re.compile(r"""\s+([^\s=<>/"']+)\s*=\s*(?:"([^"<]*)"|'([^'<]*)'|([^\s"'<>/]+))""")
_TAG_END = re.compile(r"\s*(/?)>")
_REFERENCE = re.compile(r"&(?:(lt|gt|amp|quot|apos)|#([0-9]{1,7})|#x([0-9A-Fa-f]{1,6}));|&")
_REFERRED = {"lt": "<", "gt": ">", "amp": "&", "quot": '"', "apos": "'"}


@dataclass(slots=True)
class _Element:
    name: str
    attributes: dict[str, str]
    place: Span
    parts: list[str] = field(default_factory=list)
    children: list[_Element] = field(default_factory=list)

    @property
    def text(self) -> str:
        return "".join(self.parts)

    def said(self, name: str) -> str | None:
        """An attribute, or the text of a child element of that name, in upper or lower case."""
        for key, value in self.attributes.items():
            if key.lower() == name:
                return value.strip()
        return next((item.text.strip() for item in self.children if item.name.lower() == name), None)

    @property
    def is_enabled(self) -> bool:
        return (self.said("enable") or "1").lower() not in ("0", "false", "no")


def modules_of(source: Source) -> tuple[str, tuple[Diagnostic, ...]]:
    """The text of a `modules` block ("" if it cannot be read), and what could not be taken over."""
    text, _, found = reported_modules(source)
    return text, found


def reported_modules(source: Source) -> tuple[str, tuple[Row, ...], tuple[Diagnostic, ...]]:
    """As `modules_of`, with what became of each module and statechart."""
    found: list[Diagnostic] = []
    root = _parsed(source, found)
    if root is None:
        return "", (), tuple(found)
    lines: list[str] = []
    statecharts: list[str] = []
    rows: list[Row] = []
    charts: list[Row] = []
    known: set[str] = set()
    any_known = False
    left_out: list[Diagnostic] = []
    for item in _all(root):
        kind = item.name.lower()
        if kind not in _KINDS:
            left_out += _unknown(item, root)
            continue
        any_known = True
        if kind == "statechart":
            state = "" if item.is_enabled else " (switched off)"
            statecharts.append(f"{_name(item)}{state}")
            now = f"a comment{state}: import its model, too"
            charts.append(Row(Fate.LEFT_OUT, f"statechart {_name(item)}", item.place, now))
        else:
            lines += _thread(item, kind, known, found, rows)
    if not any_known:
        found.append(Diagnostic(problems.NotOfMonas(source.path), root.place))
        return "", (), tuple(found)
    found += left_out
    about = [f"  // statecharts: {', '.join(statecharts)}"] if statecharts else []
    return "\n".join(["modules {", *about, *lines, "}", ""]), (*rows, *charts), tuple(found)


def _thread(
    item: _Element, kind: str, known: set[str], found: list[Diagnostic], rows: list[Row]
) -> list[str]:
    """The lines of an agent or a provider."""
    name = _name(item)
    parts = [child for child in item.children if child.name.lower() == "activity"]
    if kind == "provider" or not parts:
        members = [(name, item.is_enabled, item.place)]
    else:
        members = [(_name(part), item.is_enabled and part.is_enabled, part.place) for part in parts]
    _strangers(item, found)
    period = _period(item, name, found)
    lines = [f"  // {kind} {name}"]
    for member, is_enabled, place in members:
        fate = Fate.LEFT_OUT
        if not _NAME.fullmatch(member):
            found.append(Diagnostic(problems.NoModuleName(member), place))
            now = "its name is not one of the language"
        elif member in known:
            found.append(Diagnostic(problems.ModuleAgain(member), place))
            now = "it is there a second time"
        else:
            known.add(member)
            clause = f" every {duration_text(period)}" if period is not None else ""
            off = "" if is_enabled and period is not None else "// "
            if not off:
                fate, now = Fate.KEPT, f"module{clause}"
            elif not is_enabled:
                now = "a comment: it is switched off"
            else:
                now = "a comment: it has no period"
            lines.append(f"  {off}{member}{clause}{'' if is_enabled else '  (switched off)'}")
        rows.append(Row(fate, f"module {member}", place, now))
    return lines


def _name(item: _Element) -> str:
    """On one line, without what cannot be printed: it may stand in a comment."""
    words = " ".join((item.said("name") or item.text).split())
    return "".join(c if c.isprintable() else "?" for c in words)


def _period(item: _Element, name: str, found: list[Diagnostic]) -> int | None:
    """The period in ns; None where there is none."""
    written = item.said("threadfrequency") or item.said("frequency")
    try:
        frequency = float(written) if written is not None else 0.0
    except ValueError:
        frequency = -1.0
    if 0 < frequency <= 1e6:
        return round(1e9 / frequency)
    if written is None:
        problem = problems.NoFrequency(name)
    elif frequency == 0:
        problem = problems.WithoutPause(name)
    else:
        problem = problems.NotFrequency(name, written)
    found.append(Diagnostic(problem, item.place))
    return None


def _strangers(item: _Element, found: list[Diagnostic]) -> None:
    usual = {"name", "activity", "enable", "threadfrequency", "frequency", *_PASSED_OVER}
    for name in (*item.attributes, *(child.name for child in item.children)):
        if name.lower() not in usual:
            found.append(Diagnostic(problems.MeaninglessPart(name, item.name), item.place))


def _unknown(item: _Element, root: _Element) -> Iterator[Diagnostic]:
    """What is not an agent, provider or statechart, and holds none either."""
    if item is not root and not item.children:
        yield Diagnostic(problems.MeaninglessElement(item.name), item.place)
    elif item.text.strip():
        yield Diagnostic(problems.TextBetweenElements(), item.place)


def _all(root: _Element) -> Iterator[_Element]:
    """Every element in document order, not those inside agents."""
    waiting = [root]
    while waiting:
        item = waiting.pop()
        yield item
        if item.name.lower() not in _KINDS:
            waiting += reversed(item.children)


def _parsed(source: Source, found: list[Diagnostic]) -> _Element | None:
    """What holds all elements; None, with a diagnostic, for what is not read."""
    try:
        return _Reader(source).read()
    except _NotThis as problem:
        found.append(Diagnostic(problems.MonasNotRead(source.path, str(problem)), problem.place))
        return None


class _Reader:
    """The elements of a text, one after the other."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.open = [_Element("", {}, Span(source, 0, min(1, len(source.text))))]

    def read(self) -> _Element:
        text = self.source.text
        at = 0
        while at < len(text):
            if text[at] == "<":
                at = self._markup(at)
            else:
                begin, at = at, self._find("<", at, len(text))
                self.open[-1].parts.append(self._plain(begin, at))
        if len(self.open) > 1:
            raise self._not_closed(self.open[-1])
        return self.open[0]

    def _find(self, wanted: str, begin: int, otherwise: int) -> int:
        found = self.source.text.find(wanted, begin)
        return found if found >= 0 else otherwise

    def _markup(self, at: int) -> int:
        """Read what begins with `<`; where it ends."""
        text = self.source.text
        for opening, closing in _MARKUP:
            if text.startswith(opening, at):
                end = self._find(closing, at + len(opening), -1)
                if end < 0:
                    raise self._problem(f"`{opening}` is not closed by `{closing}`", at, len(opening))
                if opening == "<![CDATA[":
                    self.open[-1].parts.append(text[at + len(opening) : end])
                return end + len(closing)
        if text.startswith("<!", at):
            raise self._problem("it has a document type", at, 2)
        tag = _TAG.match(text, at)
        if tag is None:
            raise self._problem("a name is missing after `<`", at, 1)
        attributes: dict[str, str] = {}
        end = tag.end()
        while (attribute := _ATTRIBUTE.match(text, end)) is not None:
            attributes[attribute[1]] = self._plain(*attribute.span(attribute.lastindex or 0))
            end = attribute.end()
        last = _TAG_END.match(text, end)
        if last is None or (tag[1] and (attributes or last[1])):
            raise self._problem(f"the tag `{tag[0][:_LONGEST]}` is not closed by `>`", at, len(tag[0]))
        if tag[1]:
            self._close(tag[2], at, last.end())
        else:
            self._begin(tag[2], attributes, at, is_empty=bool(last[1]))
        return last.end()

    def _begin(self, name: str, attributes: dict[str, str], at: int, *, is_empty: bool) -> None:
        if len(self.open) > _DEEPEST:
            raise self._problem(f"its elements are nested more than {_DEEPEST} deep", at, 1)
        element = _Element(name, attributes, Span(self.source, at, at + len(name) + 1))
        self.open[-1].children.append(element)
        if not is_empty:
            self.open.append(element)

    def _close(self, name: str, at: int, end: int) -> None:
        element = self.open[-1]
        if len(self.open) == 1:
            raise self._problem(f"`</{name[:_LONGEST]}>` closes nothing", at, end - at)
        if element.name != name:
            raise self._problem(
                f"`</{name[:_LONGEST]}>` does not close `<{element.name[:_LONGEST]}>`", at, end - at
            )
        self.open.pop()

    def _not_closed(self, element: _Element) -> _NotThis:
        return _NotThis(f"`<{element.name[:_LONGEST]}>` is not closed", element.place)

    def _plain(self, begin: int, end: int) -> str:
        """A part of the text with its references replaced."""

        def referred(found: re.Match[str]) -> str:
            if found[1]:
                return _REFERRED[found[1]]
            number = int(found[2]) if found[2] else int(found[3], 16) if found[3] else sys.maxunicode + 1
            if number > sys.maxunicode:
                raise self._problem("`&` begins no character reference", begin + found.start(), 1)
            return chr(number)

        return _REFERENCE.sub(referred, self.source.text[begin:end])

    def _problem(self, problem: str, at: int, length: int) -> _NotThis:
        return _NotThis(problem, Span(self.source, at, at + length))


class _NotThis(Exception):
    """Why a text is not read, and where."""

    def __init__(self, problem: str, place: Span) -> None:
        super().__init__(problem)
        self.place = place


__all__ = ["modules_of", "reported_modules"]
