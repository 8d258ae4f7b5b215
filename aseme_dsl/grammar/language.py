"""The language as textX knows it: registered as `aseme` for `*.aseme`."""

from __future__ import annotations

from typing import Any

from textx import LanguageDesc

from aseme_dsl.grammar.terminals import metamodel


def _checked_metamodel() -> Any:
    made = metamodel()
    return made


aseme_language = LanguageDesc(
    "aseme",
    "*.aseme",
    "Multi-agent systems after ASEME: goals, roles, protocols and statecharts",
    _checked_metamodel,
)
