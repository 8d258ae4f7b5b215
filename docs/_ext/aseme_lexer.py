"""Colours for `aseme` code blocks."""

from __future__ import annotations

from typing import Any, ClassVar

from pygments.lexer import RegexLexer, words
from pygments.token import Comment, Keyword, Name, Number, Operator, Punctuation, String, Text, Whitespace
from sphinx.application import Sphinx

# Words that begin a block, an entry or a clause. Most of them are free to be names elsewhere; for
# colours the difference does not matter.
DECLARATIONS = (
    "activities actor aip capability clause control engage enter enum finish function functionality goal "
    "import include includes language leave let liveness message outcome participant plays process "
    "property receives repeat role sag scenario sends skip srm start statechart suc system team topic "
    "usecase var"
).split()
CLAUSES = (
    "above activity after and around as at before below by data depends else ends every for from in leads "
    "most not on once one optional or persist queued radio reads realises repeated send signal state takes "
    "to under uses when with within writes START END OR AND BASIC CONDITION"
).split()
TYPES = (
    "abstract bool bytes double duration external float human int int32 int64 legacy string uint32 uint64"
).split()


class AsemeLexer(RegexLexer):
    """The words, literals and operators of the language; no grammar."""

    name = "ASEME"
    aliases: ClassVar[list[str]] = ["aseme"]
    filenames: ClassVar[list[str]] = ["*.aseme"]
    tokens: ClassVar[dict[str, list[Any]]] = {
        "root": [
            (r"\s+", Whitespace),
            (r"//.*?$", Comment.Single),
            (r"/\*[\s\S]*?\*/", Comment.Multiline),
            (r'"(\\.|[^"\\\n])*"', String),
            (r"\d+(\.\d+)?(ns|us|ms|s|min|h)\b", Number),
            (r"\d+(\.\d+)*([eE][+-]?\d+)?", Number),
            (r"(true|false)\b", Keyword.Constant),
            (words(DECLARATIONS, prefix=r"\b", suffix=r"\b"), Keyword.Declaration),
            (words(CLAUSES, prefix=r"\b", suffix=r"\b"), Keyword),
            (words(TYPES, prefix=r"\b", suffix=r"\b"), Keyword.Type),
            (r"[A-Za-z_][A-Za-z0-9_]*(?=\s*\()", Name.Function),
            (r"[A-Za-z_][A-Za-z0-9_]*", Name),
            (r"->|\[>|[<>=!]=|&&|\|\||[-+*/%<>=!~|@?#ω]", Operator),
            (r"[][(){}.,:;]", Punctuation),
            (r'"[^"\n]*', String),  # not closed: the examples of mistakes have what the language has not
            (r".", Text),
        ]
    }


def setup(app: Sphinx) -> dict[str, bool]:
    """Make ```` ```aseme ```` known to Sphinx."""
    app.add_lexer("aseme", AsemeLexer)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
