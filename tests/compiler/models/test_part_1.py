"""What was written in part 1 of the language compiles to the same bytes as before part 2 was there."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any

import pytest

from aseme_dsl.amola.as_json import json_text, models_json
from aseme_dsl.compiler import analyse

ROOT = Path(__file__).parents[3]
HERE = Path(__file__).parent / "part_1"
WRITTEN = [
    *sorted((ROOT / "tests" / "acceptance").glob("*.aseme")),
    HERE / "robocup" / "kouretes.aseme",
    *sorted(HERE.glob("*.aseme")),
]
"""The acceptance files, an example as it was before its text changed, random programs in all of part 1, and
one whose names part 2 uses."""

FINGERPRINTS: dict[str, dict[str, str]] = json.loads((HERE / "fingerprints.json").read_text("utf-8"))
"""The SHA-256 of each model, as it was when the language had only its part 1. Never made anew."""


def key(path: Path) -> str:
    return f"{path.parent.name}/{path.name}"


def fingerprints(path: Path) -> dict[str, str]:
    system = analyse(path).system
    assert system is not None
    models = {name: _as_it_was(model) for name, model in models_json(system).items()}
    return {name: hashlib.sha256(json_text(model).encode()).hexdigest() for name, model in models.items()}


def _as_it_was(model: dict[str, Any]) -> dict[str, Any]:
    """The model with the names that its keys had then (docs/project/renamed.md)."""
    return {"nodes" if name == "states" else name: value for name, value in model.items()}


@pytest.mark.parametrize("path", WRITTEN, ids=key)
def test_its_models_are_the_same_to_the_byte(path: Path) -> None:
    assert fingerprints(path) == FINGERPRINTS[key(path)]


def test_a_fingerprint_for_each() -> None:
    assert len({key(path) for path in WRITTEN}) == len(FINGERPRINTS) == len(WRITTEN)
