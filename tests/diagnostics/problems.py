"""Problems of every kind, for the tests of the renderings."""

from __future__ import annotations

from aseme_dsl.diagnostics import Edit, Related, Severity, Suppressed
from aseme_dsl.source import Source, Span
from tests.support.worded import worded

SOURCE = Source(
    "teams/our team.aseme",
    "system Team\n"
    "\n"
    "srm player {\n"
    "\tliveness { 球 = A | 😀 . Bal }\n"
    "  control player {\n"
    "    enter A : [x <\n"
    "      100%,\n"
    "      y]\n"
    "  }\n"
    "}\n",
)


def span(text: str, source: Source = SOURCE) -> Span:
    """The first place of a text."""
    start = source.text.index(text)
    return Span(source, start, start + len(text))


MISSPELT = worded(
    "E200", "there is no `Bal`", span("Bal"), (Related(span("player"), "in this role"),), "`Ball`?", "Ball"
)
WIDE = worded("W300", "two\nlines: 100%, and a comma", span("A | 😀"))
LONG = worded("N704", "of several lines", span("[x <\n      100%,\n      y]"))
LINES = worded("W602", "of two lines", span("A : [x <\n      100%"), hint="one\ntwo")
INSERTED = worded(
    "E101", "a dot is missing", span("A |"), edits=(Edit(Span(SOURCE, 31, 31), ". "), Edit(span("Bal"), "B"))
)
UNREAD = worded("E001", "there is no file x:y,z.aseme", None, path="../x:y,z.aseme")
HARSH = worded("W001", "empty \x1b[31m\x00", None, path="leer.aseme", level=Severity.ERROR)

ALL = (UNREAD, HARSH, MISSPELT, WIDE, LONG, LINES, INSERTED)
ALLOWED = Suppressed(worded("W301", "never reached", span("Bal")), span("100"), "it will be")
