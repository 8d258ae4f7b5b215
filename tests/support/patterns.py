"""All regular expressions of the package: those of the grammar, of its modules, and of what is generated."""

from __future__ import annotations

import ast
import importlib
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from arpeggio import RegExMatch

from aseme_dsl.grammar.parsing.terminals import all_rules, parser_model
from aseme_dsl.grammar.text.recovery import _OUTER, BLOCKS
from aseme_dsl.pygments_lexer import AsemeLexer

ROOT = Path(__file__).parents[2]
_CALLS = {"compile", "match", "search", "fullmatch", "sub", "split", "findall", "finditer"}
_APART = {"aseme_dsl.__main__", "aseme_dsl.grammar.syntax.__main__"}
"""Modules that do something when they are imported."""


@dataclass(frozen=True)
class Pattern:
    """A regular expression, and where it was found."""

    where: str
    text: str | bytes
    flags: int = 0

    def __str__(self) -> str:
        return self.where


def of_grammar() -> Iterator[Pattern]:
    """The terminals of the grammar, and how recovery knows blocks and entries."""
    seen = set()
    for rule, owner in all_rules(parser_model()):
        if isinstance(rule, RegExMatch) and (owner, rule.to_match_regex) not in seen:
            seen.add((owner, rule.to_match_regex))
            yield Pattern(f"grammar {owner} {len(seen)}", rule.to_match_regex, re.MULTILINE)
    for name, block in BLOCKS.items():
        if block.entry:
            yield Pattern(f"recovery {name}", block.entry)
    for name, text in _OUTER.items():
        yield Pattern(f"recovery outer {name}", text)


def of_lexer() -> Iterator[Pattern]:
    """What Pygments colours texts with."""
    for state, entries in AsemeLexer.tokens.items():
        for index, entry in enumerate(entries):
            if isinstance(entry, tuple) and isinstance(entry[0], str):
                yield Pattern(f"lexer {state} {index}", entry[0], AsemeLexer.flags)


def of_modules() -> Iterator[Pattern]:
    """What the modules of the package, their classes included, have compiled when they are imported."""
    for path in sorted((ROOT / "aseme_dsl").rglob("*.py")):
        parts = path.relative_to(ROOT).with_suffix("").parts
        name = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
        if name in _APART:
            continue
        try:
            module = importlib.import_module(name)
        except ImportError:  # of an extra that is not installed
            continue
        spaces = [module, *(item for item in vars(module).values() if isinstance(item, type))]
        for space in spaces:
            if space is not module and space.__module__ != name:
                continue
            for key, value in vars(space).items():
                if isinstance(value, re.Pattern):
                    yield Pattern(f"{name} {key}", value.pattern, value.flags & ~re.UNICODE)
                elif isinstance(value, dict):
                    for inner, item in value.items():
                        if isinstance(item, re.Pattern):
                            yield Pattern(f"{name} {key}[{inner!r}]", item.pattern, item.flags & ~re.UNICODE)


def of_calls() -> Iterator[Pattern]:
    """What stands as a literal in a call of `re`; where it is put together, `x` stands for what is put in."""
    for path in sorted((ROOT / "aseme_dsl").rglob("*.py")):
        if path.name == "prepared.py":
            continue
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Attribute) or not node.args:
                continue
            if not isinstance(node.func.value, ast.Name) or node.func.value.id != "re":
                continue
            text = _literal(node.args[0])
            if node.func.attr in _CALLS and text is not None:
                flags = 0
                for name in ("VERBOSE", "DOTALL", "MULTILINE", "ASCII", "IGNORECASE"):
                    if f"re.{name}" in ast.unparse(node):
                        flags |= int(getattr(re, name))
                yield Pattern(f"{path.relative_to(ROOT)}:{node.lineno}", text, flags)


def _literal(node: ast.expr) -> str | bytes | None:
    match node:
        case ast.Constant(value=str() | bytes() as value):
            return value
        case ast.JoinedStr(values=parts):
            return "".join(str(part.value) if isinstance(part, ast.Constant) else "x" for part in parts)
        case _:
            return None


@cache
def all_patterns() -> tuple[Pattern, ...]:
    """Each once."""
    found = {}
    for pattern in (*of_grammar(), *of_lexer(), *of_modules(), *of_calls()):
        found.setdefault((pattern.text, pattern.flags), pattern)
    return tuple(found.values())
