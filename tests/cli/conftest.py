"""Fixtures of the command line's tests."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.support import BAD, GOOD, Done, Here


@pytest.fixture
def here(capsys: pytest.CaptureFixture[str]) -> Here:
    """asemec in this process."""
    return Here(capsys)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A working directory with `good.aseme` and `bad.aseme`."""
    (tmp_path / "good.aseme").write_text(GOOD)
    (tmp_path / "bad.aseme").write_text(BAD)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def prove(here: Here, folder: Path) -> Callable[..., Done]:
    """`asemec prove` of a text, with these further arguments."""

    def call(text: str, *arguments: object) -> Done:
        (folder / "it.aseme").write_text(text)
        return here("prove", "it.aseme", *arguments)

    return call
