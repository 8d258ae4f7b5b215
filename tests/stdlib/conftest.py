"""The tests of one protocol stand together, so that a worker which runs them compiles it once."""

from __future__ import annotations

from pathlib import Path

import pytest

FOLDER = Path(__file__).resolve().parent


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    places = [place for place, item in enumerate(items) if item.path.parent == FOLDER]
    ordered = sorted((items[place] for place in places), key=protocol_of)
    for place, item in zip(places, ordered, strict=True):
        items[place] = item


def protocol_of(item: pytest.Item) -> str:
    """The protocol that a test is about; nothing where it is about several."""
    given = item.callspec.params if isinstance(item, pytest.Function) and hasattr(item, "callspec") else {}
    return str(given.get("item", given.get("name", "")))
