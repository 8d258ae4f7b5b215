"""The language as textX knows it: `aseme`, for `*.aseme`."""

from __future__ import annotations

from functools import lru_cache
from typing import cast

from textx import LanguageDesc, TextXSyntaxError

from aseme_dsl.grammar.parsing.nodes import File
from aseme_dsl.grammar.parsing.parse import understood
from aseme_dsl.grammar.parsing.rules import TextXModel
from aseme_dsl.grammar.parsing.terminals import metamodel


@lru_cache(maxsize=1)
def _metamodel() -> object:
    made = metamodel()
    made.register_model_processor(_check)
    return made


def _check(model: TextXModel, _metamodel: object) -> None:
    """Refuse a text with mistakes, which the parser has skipped.

    Raises:
        TextXSyntaxError: At the first mistake; its message names the places of the others.
    """
    parser = model._tx_parser
    _, diagnostics = understood(cast(File, model), parser.progress)
    if not diagnostics:
        return
    first, *others = diagnostics
    hint = f" ({first.hint})" if first.hint else ""
    rest = "".join(f"\n{other.span}: {other.message}" for other in others)
    line, column = first.span.source.position(first.span.start) if first.span else (1, 1)
    raise TextXSyntaxError(f"{first.message}{hint}{rest}", line=line, col=column, filename=model._tx_filename)


aseme_language = LanguageDesc(
    "aseme", "*.aseme", "Multi-agent systems after ASEME: goals, roles, protocols, statecharts", _metamodel
)
