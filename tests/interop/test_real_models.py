"""The models of the originals, from a folder that `ASEME_MODELS` names: none of them is in this repository.

The folder may have subfolders, as clones of nspan/ASEME, kouretes/KSE and kouretes/Monas have. Each distinct
model comes over with the same labels, types and transitions, and is the same once it went out and came home.
Or it is refused with the reason.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.amola.system import System
from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import render_text
from aseme_dsl.interop.emf.charts import read_chart
from aseme_dsl.interop.emf.comparison import differences, other_names
from aseme_dsl.interop.emf.markup import Unreadable, read_markup
from aseme_dsl.interop.emf.report import summary
from aseme_dsl.interop.emf.system import CHARTS
from aseme_dsl.interop.export.formats import Format, files_of
from aseme_dsl.project.editing.import_models import import_models
from aseme_dsl.source import Source
from tests.interop.exports.test_stct import described

FOLDER = os.environ.get("ASEME_MODELS", "")


def models() -> Iterator[Path]:
    """The models of the folder, each text once."""
    seen: set[bytes] = set()
    for path in sorted(Path(FOLDER).rglob("*")) if FOLDER else ():
        if path.suffix in CHARTS and path.is_file() and (content := path.read_bytes()) not in seen:
            seen.add(content)
            yield path


def _home_again(system: System, folder: Path) -> Statechart:
    """The chart after it went out as a model of KSE and came home."""
    files, refused = files_of(system, system.iacs[0], Format.STCT)
    assert not refused, render_text(refused)
    folder.mkdir()
    (folder / "model.stct").write_text(files[0][1], "utf-8")
    for name, content in import_models([folder / "model.stct"]).files.items():
        (folder / name).write_bytes(content.replace(b"[?]", b"[true]"))
    analysis = analyse(next(folder.glob("*.aseme")))
    assert analysis.system is not None, render_text(analysis.diagnostics)
    return analysis.system.iacs[0]


@pytest.mark.skipif(not FOLDER, reason="ASEME_MODELS names no folder with models of KSE and the ASEME IDE")
def test_the_models_of_the_originals_come_over(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table: list[str] = []
    refused = 0
    for number, path in enumerate(models()):
        project = import_models([path])
        title = f"{path.parent.name}/{path.name}"
        if not project.files:
            assert project.diagnostics, title
            table.append(f"{title}: refused: {project.diagnostics[0].message.partition(': ')[2]}")
            refused += 1
            continue
        theirs = read_chart(read_markup(Source(str(path), path.read_text("utf-8"))))
        folder = tmp_path / str(number)
        for name, content in project.files.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(content.replace(b"[?]", b"[true]"))
        analysis = analyse(next(folder.glob("*.aseme")))
        assert analysis.system is not None, f"{title}\n{render_text(analysis.diagnostics)}"
        (ours,) = analysis.system.iacs
        assert list(differences(ours, theirs)) == [], title
        home = _home_again(analysis.system, folder / "again")
        assert described(home) == described(ours), title
        form = "formulas" if project.formulas else "statechart"
        names = len(list(other_names(ours, theirs)))
        hollow = sum(state.was_hollow for state in theirs.states)
        table.append(
            f"{title}: {form}, {len(theirs.states)} states, {len(theirs.transitions)} transitions;"
            f" {summary(project.rows)}; {names} other names, {hollow} hollow OR states"
        )
    with capsys.disabled():
        print("", *table, f"{len(table) - refused} of {len(table)} models come over", sep="\n")
    assert table, f"{FOLDER} has no models"


@pytest.mark.skipif(not FOLDER, reason="ASEME_MODELS names no folder with models of KSE and the ASEME IDE")
def test_changed_models_of_the_originals_are_read_or_refused() -> None:
    for path in models():
        text = path.read_text("utf-8")
        for at in range(0, len(text), max(1, len(text) // 200)):
            try:
                read_chart(read_markup(Source(str(path), text[:at] + text[at + 7 :])))
            except Unreadable:
                continue
