"""What is made from the grammar: rules as data, classes of what is read, and colours for editors.

`files` gives the text of every file; `python -m aseme_dsl.grammar.syntax` writes them.
"""

from __future__ import annotations

from functools import lru_cache

from aseme_dsl.grammar.parsing.rules import prepared_text
from aseme_dsl.grammar.syntax.contexts import outline
from aseme_dsl.grammar.syntax.emacs import emacs_mode
from aseme_dsl.grammar.syntax.nodes import nodes_text
from aseme_dsl.grammar.syntax.pygments import pygments_lexer
from aseme_dsl.grammar.syntax.textmate import textmate_grammar
from aseme_dsl.grammar.syntax.vim import vim_files


@lru_cache(maxsize=1)
def files() -> dict[str, str]:
    """The text of every file that follows from the grammar, by its path from the root of the project."""
    made = outline()
    return {
        "aseme_dsl/grammar/parsing/prepared.py": prepared_text(),
        "aseme_dsl/grammar/parsing/nodes.py": nodes_text(),
        "editors/vscode/syntaxes/aseme.tmLanguage.json": textmate_grammar(made),
        "aseme_dsl/pygments_lexer.py": pygments_lexer(made),
        "editors/emacs/aseme-mode.el": emacs_mode(made),
        **{f"editors/vim/{name}": text for name, text in vim_files(made).items()},
    }
