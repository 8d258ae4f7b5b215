"""The classes of problems: each code has one or more, and nothing reads their texts to know what is wrong."""

from __future__ import annotations

import ast
import pkgutil
from collections import Counter
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import aseme_dsl
from aseme_dsl.diagnostics import CODES, Problem, problems

PACKAGE = Path(aseme_dsl.__file__).parent
FILES = sorted(path for path in PACKAGE.rglob("*.py") if "diagnostics" not in path.relative_to(PACKAGE).parts)
TEXTS = ("message", "hint")
SEARCHES = frozenset("search match fullmatch findall finditer sub split".split())


for module in pkgutil.walk_packages(problems.__path__, f"{problems.__name__}."):
    import_module(module.name)


def classes(of: type[Problem] = Problem) -> Iterator[type[Problem]]:
    """All that are derived from a class in `diagnostics/problems/`."""
    for kind in of.__subclasses__():
        if kind.__module__.startswith(problems.__name__):
            yield kind
        yield from classes(kind)


def test_every_code_has_a_class_and_every_class_a_code() -> None:
    found = set(classes())
    without = {kind for kind in found if not hasattr(kind, "code")}
    assert {kind.code for kind in found - without} == set(CODES)
    assert all(kind.__subclasses__() for kind in without), "what has no code is there to be derived from"


def test_no_two_classes_are_called_the_same() -> None:
    names = Counter(kind.__name__ for kind in set(classes()) if not kind.__name__.startswith("_"))
    assert [name for name, count in names.items() if count > 1] == []


def test_texts_are_only_shown() -> None:
    assert [place for path in FILES for place in searched(path)] == []


def searched(path: Path) -> Iterator[str]:
    """Where a file searches or compares messages and hints, or makes problems of its own.

    A message of a robot is called so, too: that one is compared.
    """
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        match node:
            case ast.Call(func=ast.Attribute(value=ast.Attribute(attr=attr))) if attr in TEXTS:
                pass
            case ast.Call(func=ast.Attribute(attr=attr), args=args) if attr in SEARCHES and any(
                isinstance(item, ast.Attribute) and item.attr in TEXTS for item in args
            ):
                pass
            case ast.Compare(left=left, ops=ops, comparators=others) if any(
                isinstance(item, ast.Attribute) and item.attr == "hint" for item in (left, *others)
            ) and not isinstance(ops[0], ast.Is | ast.IsNot):
                pass
            case ast.ClassDef(bases=bases) if any(
                isinstance(item, ast.Name) and item.id == Problem.__name__ for item in bases
            ):
                pass
            case _:
                continue
        yield f"{path.relative_to(PACKAGE)}:{node.lineno}"
