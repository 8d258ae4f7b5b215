"""Questions: what may be proved of the declarations of a file, and whether a text means what it meant."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator

from aseme_dsl.editor.files.program import Program
from aseme_dsl.editor.files.view import View
from aseme_dsl.grammar.layout.adding import bare
from aseme_dsl.grammar.text import tree
from aseme_dsl.records import dataclass
from aseme_dsl.source import Span

BUILT_IN = (*("deadlock", "orphan messages", "non-local choice", "agreement", "dead states", "failures"),)
"""The questions of `asemec prove` that a file does not contain."""

TEAM = "team"
"""What `asemec prove` calls the team."""

OF_A_RUN = "proved_"
"""How the names of roles begin that are there for a counterexample only."""


@dataclass(frozen=True, slots=True)
class Question:
    """Something to prove: `asked` are its names for `asemec prove`, all if none; `of` the team and protocols
    that it is about, all if none. `span` is what it stands at, `name` that of it which is marked."""

    key: str
    asked: tuple[str, ...]
    of: tuple[str, ...]
    span: Span
    name: Span


def questions(view: View) -> Iterator[Question]:
    """What may be asked of a file, in the order of the text."""
    teams = 0
    for item in view.file.declarations if view.file is not None else ():
        span = view.whole(item.span)
        match item:
            case tree.System():
                yield Question("all", (), (), span, view.whole(item.name.span))
            case tree.Team():
                teams += 1
                if teams == 1:  # one answer for the agents of all
                    yield Question(TEAM, BUILT_IN, (TEAM,), span, view.whole(item.name.span))
            case tree.Property():
                title = item.title.text
                yield Question(f"property {title}", (title,), (TEAM,), span, view.whole(item.title.span))
            case tree.Aip():
                own = f"protocol {item.name.text}"
                yield Question(own, BUILT_IN, (own,), span, view.whole(item.name.span))
                for clause in item.clauses:
                    text = text_of(clause)
                    place = view.whole(clause.span)
                    yield Question(f"{own} clause {text}", (text,), (own, TEAM), place, place)


def text_of(clause: tree.Clause) -> str:
    """What a clause says, in one line."""
    return " ".join(clause.span.text.split()).removeprefix("clause ")


def digest(program: Program) -> str:
    """What changes when something may be true now that was not: comments, layout and scenarios do not count,
    nor do the roles that a scenario of a counterexample brings along."""
    found = hashlib.sha256()
    for path, file in sorted(program.files.items()):
        found.update(f"\n\n{path}\n".encode("utf-8", "surrogatepass"))
        for item in file.declarations:
            if isinstance(item, tree.Scenario):
                continue
            if isinstance(item, tree.Srm) and item.name.text.startswith(OF_A_RUN):
                continue
            found.update(f"{bare(item.span.text)}\n".encode("utf-8", "surrogatepass"))
    return found.hexdigest()


__all__ = ["BUILT_IN", "OF_A_RUN", "TEAM", "Question", "digest", "questions", "text_of"]
