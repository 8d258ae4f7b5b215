"""Moving: control lines that are about the same transition after formulas have been written otherwise."""

from __future__ import annotations

import re
from collections.abc import Callable, Container, Mapping, Sequence

from aseme_dsl.amola.liveness import Formula, ungrouped
from aseme_dsl.compiler.formula.formula_to_statechart import Way
from aseme_dsl.compiler.formula.terms import Terms, way, ways
from aseme_dsl.editor.changes.rewriting import Owner, Refused, Replaced
from aseme_dsl.editor.typing.completion import spelled
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass

Translate = Callable[[str, Way], Sequence[tuple[str, Way]]]
"""From a formula and a transition of it to the formulas and transitions that it is now."""


@dataclass(frozen=True, slots=True)
class Moved:
    """A control line as it is written now: in the block of `title`; `origin` is the block it was in."""

    title: str
    text: str
    origin: str


def moved_lines(
    text: str, controls: Sequence[tree.Control], old: Owner, new: Owner, translate: Translate
) -> list[Replaced]:
    """The changes of all control blocks of an owner.

    Raises:
        Refused: A line is about no transition, or its transition has no name any more.
    """
    changes: list[Replaced] = []
    moved: dict[str, list[Moved]] = {}
    blocks: dict[str, tree.Control] = {}
    removed: dict[str, int] = {}
    for control in controls:
        formula = old.formula_of(control.name.text)
        if formula is None:
            continue
        blocks[control.name.text] = control
        terms = old.terms(formula)
        for entry in control.entries:
            if isinstance(entry, tree.LabelledWay):
                continue
            meanings = _meanings(entry, terms, formula, new, translate)
            if [title for title, _, _ in meanings] == [control.name.text]:
                _, verb, term = meanings[0]
                if _blankless(verb + term) != _blankless(entry.verb.text + entry.term.span.text):
                    start, end, line = _rewritten(text, entry, verb, term)
                    changes.append(Replaced(start, end, line))
                continue
            start, end = _extent(text, entry)
            changes.append(Replaced(start, end, ""))
            removed[control.name.text] = removed.get(control.name.text, 0) + 1
            for title, verb, term in meanings:
                head_start, head_end, head = _rewritten(text, entry, verb, term)
                line = text[start:head_start].lstrip() + head + text[head_end:end].rstrip()
                moved.setdefault(title, []).append(Moved(title, line, control.name.text))
    return changes + _placed(text, blocks, moved, removed)


def _meanings(
    entry: tree.Way, terms: Terms, formula: str, new: Owner, translate: Translate
) -> list[tuple[str, str, str]]:
    """The blocks in which a line stands now, with its verb and its term there."""
    found, problem = way(terms, entry.verb, entry.term)
    if found is None:
        raise Refused(problem.message if problem is not None else "a control line is about no transition")
    result = []
    for target, meant in translate(formula, found):
        head = said(new.terms(target), meant, entry.verb.text)
        if head is None:
            raise Refused(f"`{entry.verb} {entry.term.span.text}` would have no name any more")
        result.append((new.titles[target], *head))
    return result


def _rewritten(text: str, entry: tree.Way, verb: str, term: str) -> tuple[int, int, str]:
    """The head of a line up to its colon with another verb and term, its columns as they were if possible."""
    start, end = entry.verb.span.start, entry.term.span.end
    colon = text.find(":", end)
    gap = text[entry.verb.span.end : entry.term.span.start]
    width = colon - entry.term.span.start
    return start, colon, f"{verb:{len(entry.verb.text)}}{gap}{term:{width - 1}} "


def said(terms: Terms, meant: Way, verb: str) -> tuple[str, str] | None:
    """How a control line names a way: verb and term, with this verb if it can, and in few words."""
    found = [
        (other != verb, len(spelled(terms, term)), other, spelled(terms, term))
        for term in terms.parents
        for other, way_ in ways(terms, term).items()
        if way_ == meant
    ]
    return min(found)[2:] if found else None


def _extent(text: str, entry: tree.Way) -> tuple[int, int]:
    """Where an entry stands, with its lines if they are its own."""
    start, end = entry.span.start, entry.span.end
    line = text.rfind("\n", 0, start) + 1
    stop = text.find("\n", end)
    stop = stop if stop >= 0 else len(text)
    behind = text[end:stop].strip()
    if text[line:start].strip() or (behind and not behind.startswith("//")):
        return start, end
    return line, min(stop + 1, len(text))


def _placed(
    text: str,
    blocks: Mapping[str, tree.Control],
    moved: Mapping[str, list[Moved]],
    removed: Mapping[str, int],
) -> list[Replaced]:
    """The lines that have moved, in their blocks or in new ones; blocks that are empty now go."""
    changes: list[Replaced] = []
    written: dict[str, list[str]] = {}  # by the block behind which they stand
    for title, lines in moved.items():
        block = blocks.get(title)
        if block is None:
            indent = _indent(text, blocks[lines[0].origin].span.start)
            body = "".join(f"{indent}  {item.text}\n" for item in lines)
            written.setdefault(lines[0].origin, []).append(f"control {title} {{\n{body}{indent}}}")
            continue
        closing = block.span.end - 1
        line = text.rfind("\n", 0, closing) + 1
        inner = f"{_indent(text, block.span.start)}  "
        body = "".join(f"{inner}{item.text}\n" for item in lines)
        at = line if not text[line:closing].strip() else closing
        changes.append(Replaced(at, at, body if at == line else f"\n{body}"))
    for name, block in blocks.items():
        new_blocks = written.get(name, [])
        indent = _indent(text, block.span.start)
        start, end = block.span.start, block.span.end
        if removed.get(name) != len(block.entries) or name in moved or not block.entries:
            changes += [Replaced(end, end, f"\n{indent}{one}") for one in new_blocks]
        elif new_blocks:
            changes.append(Replaced(start, end, f"\n{indent}".join(new_blocks)))
        else:
            changes.append(Replaced(*_whole_lines(text, start, end), ""))
    return changes


def without_overlaps(changes: Sequence[Replaced]) -> list[Replaced]:
    """Without those that stand inside of another one."""
    return [
        item
        for item in changes
        if not any(
            other is not item and other.start <= item.start and item.end <= other.end and _longer(other, item)
            for other in changes
        )
    ]


def _longer(first: Replaced, second: Replaced) -> bool:
    return first.end - first.start > second.end - second.start


def _whole_lines(text: str, start: int, end: int) -> tuple[int, int]:
    line = text.rfind("\n", 0, start) + 1
    stop = text.find("\n", end)
    if text[line:start].strip() or stop < 0 or text[end:stop].strip():
        return start, end
    return line, stop + 1


def _indent(text: str, offset: int) -> str:
    line = text[text.rfind("\n", 0, offset) + 1 : offset]
    return line[: len(line) - len(line.lstrip())]


def _blankless(text: str) -> str:
    return re.sub(r"\s+", "", text)


def paired(old: Formula, new: Formula, at: Formula | None = None) -> dict[Formula, Formula]:
    """The terms of a formula with those of one of the same shape; what `at` holds is left out."""
    found: dict[Formula, Formula] = {}
    waiting = [(old, new)]
    while waiting:
        one, other = (ungrouped(item) for item in waiting.pop())
        found[one] = other
        if one is not at:
            waiting += zip(one.operands, other.operands, strict=True)
    return found


def unchanged_terms(old: Owner, new: Owner, changed: Container[str]) -> dict[Formula, Formula]:
    """The terms of all formulas that stay as they are."""
    found: dict[Formula, Formula] = {}
    for name in old.formulas.named:
        if name not in changed and name in new.formulas.named:
            found |= paired(old.terms(name).whole, new.terms(name).whole)
    return found


__all__ = ["Translate", "moved_lines", "paired", "said", "unchanged_terms", "without_overlaps"]
