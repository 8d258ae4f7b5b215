"""Problem: fields and texts of what is wrong."""

from __future__ import annotations

import pytest

from aseme_dsl.diagnostics import Problem
from aseme_dsl.diagnostics.problem import by_name


class _Misspelt(Problem):
    code = "E204"
    name: str
    close: str | None = None

    @property
    def message(self) -> str:
        return f"there is no activity `{self.name}`"

    @property
    def hint(self) -> str | None:
        return f"did you mean `{self.close}`?" if self.close is not None else None


class _OfAModule(_Misspelt):
    module: str = ""


class _Misplaced(Problem):
    name: str
    near: str | None = by_name(default=None, kw_only=True)


class _MisplacedInRole(_Misplaced):
    role: str


def test_texts_are_made_of_the_fields() -> None:
    assert _Misspelt("Wlak").hint is None
    assert _Misspelt("Wlak", close="Walk").hint == "did you mean `Walk`?"
    assert _Misspelt("Wlak").but(name="Rnu").message == "there is no activity `Rnu`"


def test_equal_fields_make_equal_problems() -> None:
    assert _Misspelt("Wlak") == _Misspelt(name="Wlak") == _Misspelt("Wlak", None)
    assert hash(_Misspelt("Wlak")) == hash(_Misspelt("Wlak", None))
    assert _Misspelt("Wlak") != _Misspelt("Wlak", "Walk")
    assert _Misspelt("Wlak") != _OfAModule("Wlak")
    assert repr(_OfAModule("Wlak", module="Feet")) == "_OfAModule(name='Wlak', close=None, module='Feet')"


def test_what_is_given_by_its_name_only_stands_before_fields_without_a_default() -> None:
    assert _MisplacedInRole("Wlak", "player") == _MisplacedInRole(role="player", name="Wlak")
    assert _MisplacedInRole("Wlak", "player").near is None
    assert _MisplacedInRole("Wlak", "player").but(near="Walk").near == "Walk"
    assert repr(_Misplaced("Wlak", near="Walk")) == "_Misplaced(name='Wlak', near='Walk')"
    with pytest.raises(TypeError, match="has the fields name"):
        _Misplaced("Wlak", "Walk")  # type: ignore[misc]


def test_fields_are_given_once_and_do_not_change() -> None:
    with pytest.raises(TypeError, match="needs `name`"):
        _Misspelt()  # type: ignore[call-arg]
    with pytest.raises(TypeError, match="has the fields name, close"):
        _Misspelt("Wlak", nmae="Walk")  # type: ignore[call-arg]
    with pytest.raises(TypeError, match="has the fields name, close"):
        _Misspelt("Wlak", name="Walk")  # type: ignore[misc]
    with pytest.raises(AttributeError, match="does not change"):
        _Misspelt("Wlak").name = "Walk"  # type: ignore[misc]
