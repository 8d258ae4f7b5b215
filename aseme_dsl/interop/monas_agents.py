"""Monas' `agents.xml`: the modules of the original robot software, as a `modules` block.

What is known of the format (Monas, `config/agents.xml`): `<agent>` is a thread with a frequency in Hz that
executes its `<activity>` children in order; `<provider>` is one for hardware, its text is its name;
`<statechart>` names a statechart. `Enable` switches each of them off. Attributes may be written as child
elements, and names in any case. An agent's activities become modules of one period: they are begun in their
order, but one does not wait for another as in Monas. `IsRealTime`, `Priority` and `StatsCycle` have no
counterpart in a role. What modules read and write is in no such file and is to be added.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from xml.parsers import expat

from aseme_dsl.amola.expression import duration_text
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.source import Source, Span

_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)
_PASSED_OVER = frozenset({"isrealtime", "priority", "statscycle"})
_LARGEST = 10_000_000


@dataclass(slots=True)
class _Element:
    name: str
    attributes: dict[str, str]
    place: Span
    text: str = ""
    children: list[_Element] = field(default_factory=list)

    def said(self, name: str) -> str | None:
        """An attribute, or the text of a child element of that name; whatever the case."""
        for key, value in self.attributes.items():
            if key.lower() == name:
                return value.strip()
        return next((item.text.strip() for item in self.children if item.name.lower() == name), None)

    @property
    def is_enabled(self) -> bool:
        return (self.said("enable") or "1").lower() not in ("0", "false", "no")


def modules_of(source: Source) -> tuple[str, tuple[Diagnostic, ...]]:
    """The text of a `modules` block ("" if it cannot be read), and what could not be taken over."""
    found: list[Diagnostic] = []
    root = _parsed(source, found)
    if root is None:
        return "", tuple(found)
    lines: list[str] = []
    statecharts: list[str] = []
    known: set[str] = set()
    any_known = False
    for item in _all(root):
        kind = item.name.lower()
        if kind not in ("agent", "provider", "statechart"):
            continue
        any_known = True
        if kind == "statechart":
            state = "" if item.is_enabled else " (switched off)"
            statecharts.append(f"{(item.said('name') or item.text).strip()}{state}")
        else:
            lines += _thread(item, kind, known, found)
    if not any_known:
        found.append(
            Diagnostic(
                "E220",
                f"{source.path} is no configuration of Monas: it has no agent, provider or statechart",
                root.place,
            )
        )
        return "", tuple(found)
    about = [f"  // statecharts: {', '.join(statecharts)}"] if statecharts else []
    return "\n".join(["modules {", *about, *lines, "}", ""]), tuple(found)


def _thread(item: _Element, kind: str, known: set[str], found: list[Diagnostic]) -> list[str]:
    """The lines of an agent or a provider."""
    name = (item.said("name") or item.text).strip()
    parts = [child for child in item.children if child.name.lower() == "activity"]
    if kind == "provider" or not parts:
        members = [(name, item.is_enabled, item.place)]
    else:
        members = [
            ((part.said("name") or part.text).strip(), item.is_enabled and part.is_enabled, part.place)
            for part in parts
        ]
    _strangers(item, found)
    period = _period(item, name, found)
    lines = [f"  // {kind} {name}"]
    for member, is_enabled, place in members:
        if not _NAME.fullmatch(member):
            found.append(_left_out(f"`{member}` cannot be the name of a module", place))
        elif member in known:
            found.append(_left_out(f"the module `{member}` is there a second time", place))
        else:
            known.add(member)
            clause = f" every {duration_text(period)}" if period is not None else ""
            off = "" if is_enabled and period is not None else "// "
            lines.append(f"  {off}{member}{clause}{'' if is_enabled else '  (switched off)'}")
    return lines


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
        problem = f"`{name}` has no frequency"
    elif frequency == 0:
        problem = f"`{name}` runs without a pause (frequency 0): a module has a period"
    else:
        problem = f"`{written}` is no frequency in Hz"
    found.append(
        Diagnostic("W111", problem, item.place, hint="its modules are commented out: give them `every …`")
    )
    return None


def _strangers(item: _Element, found: list[Diagnostic]) -> None:
    usual = {"name", "activity", "enable", "threadfrequency", "frequency", *_PASSED_OVER}
    for name in (*item.attributes, *(child.name for child in item.children)):
        if name.lower() not in usual:
            found.append(_left_out(f"`{name}` of the {item.name} means nothing here", item.place))


def _left_out(problem: str, place: Span) -> Diagnostic:
    return Diagnostic("W110", f"{problem}: it is left out", place)


def _all(root: _Element) -> Iterator[_Element]:
    """Every element in document order, not those inside agents."""
    waiting = [root]
    while waiting:
        item = waiting.pop()
        yield item
        if item.name.lower() not in ("agent", "provider", "statechart"):
            waiting += reversed(item.children)


def _parsed(source: Source, found: list[Diagnostic]) -> _Element | None:
    """The root element; a diagnostic for what is no XML, and for what XML may do and nobody needs here."""
    top = _Element("", {}, Span(source, 0, 0))
    open_: list[_Element] = [top]
    parser = expat.ParserCreate("utf-8")
    data = source.text.encode("utf-8", "replace")

    def here(length: int) -> Span:
        start = len(data[: parser.CurrentByteIndex].decode("utf-8", "replace"))
        return Span(source, start, min(start + length, len(source.text)))

    def begin(name: str, attributes: dict[str, str]) -> None:
        element = _Element(name, attributes, here(len(name) + 1))
        open_[-1].children.append(element)
        open_.append(element)

    def end(_: str) -> None:
        open_.pop()

    def text(part: str) -> None:
        open_[-1].text += part

    def declares(*_: object) -> None:
        raise _NotThis("it declares entities")

    parser.StartElementHandler = begin
    parser.EndElementHandler = end
    parser.CharacterDataHandler = text
    parser.EntityDeclHandler = declares
    try:
        if len(data) > _LARGEST:
            raise _NotThis("it is too large")
        parser.Parse(data, True)
    except _NotThis as problem:
        message = f"{source.path} is not read: {problem}"
        found.append(Diagnostic("E220", message, Span(source, 0, min(1, len(source.text)))))
        return None
    except expat.ExpatError as problem:
        reason = expat.ErrorString(problem.code)
        message = f"{source.path} is no valid XML: {reason}"
        found.append(Diagnostic("E220", message, _place(source, problem.lineno, problem.offset)))
        return None
    return top.children[0]


def _place(source: Source, line: int, column: int) -> Span:
    """One character, or the last one where the text ends too soon."""
    lines = source.text.count("\n") + 1
    start = source.line_start(min(max(line, 1), lines)) + column
    start = max(0, min(start, len(source.text) - 1))
    return Span(source, start, min(start + 1, len(source.text)))


class _NotThis(Exception):
    """Why a text is not read."""


__all__ = ["modules_of"]
