"""`aseme_dsl.compile`: what a script calls."""

from __future__ import annotations

from pathlib import Path

import pytest

import aseme_dsl
from aseme_dsl.source import Source

TEXT = "system S\nsrm walker { liveness { walker = Walk } }\n"


def test_a_path_or_a_text_gives_the_system(tmp_path: Path) -> None:
    path = tmp_path / "walker.aseme"
    path.write_text(TEXT, "utf-8")
    for root in (path, str(path), Source("walker.aseme", TEXT)):
        system = aseme_dsl.compile(root)
        assert isinstance(system, aseme_dsl.System)
        chart = system.iac("walker")
        assert chart is not None and len(chart.states) == 4


def test_texts_of_an_editor_go_before_the_files(tmp_path: Path) -> None:
    path = tmp_path / "walker.aseme"
    path.write_text("nonsense", "utf-8")
    assert aseme_dsl.compile(path, sources={str(path): TEXT}).name == "S"


def test_errors_are_raised_all_together_as_data() -> None:
    text = "system S\nsrm a { liveness { a = X  b = Y } }\nsrm c { }\n"
    with pytest.raises(aseme_dsl.CompileError) as raised:
        aseme_dsl.compile(Source("bad.aseme", text))
    assert [item.code for item in raised.value.diagnostics] == ["E302", "E305"]
    assert "bad.aseme:2:27: error[E302]" in str(raised.value)


def test_a_file_that_does_not_exist_is_an_error_of_the_same_kind(tmp_path: Path) -> None:
    with pytest.raises(aseme_dsl.CompileError) as raised:
        aseme_dsl.compile(tmp_path / "nothing.aseme")
    assert [item.code for item in raised.value.diagnostics] == ["E001"]


def test_the_size_limit_is_an_option() -> None:
    source = Source("big.aseme", "system S srm big { liveness { big = (A . B)[20] } }")
    assert aseme_dsl.analyse(source).system is not None
    found = aseme_dsl.analyse(source, options=aseme_dsl.Options(largest=100))
    assert [item.code for item in found.diagnostics] == ["E304"]


def test_a_model_that_explodes_is_refused_before_it_is_built() -> None:
    lines = ["f0 = A . B", *(f"f{n} = f{n - 1} . f{n - 1}" for n in range(1, 64))]
    text = "system S srm f63 { liveness { " + "\n".join(reversed(lines)) + " } }"
    (error,) = aseme_dsl.analyse(Source("big.aseme", text)).diagnostics
    assert error.code == "E304"
    assert "f63 (" in error.message and "limit is 50 000" in error.message
