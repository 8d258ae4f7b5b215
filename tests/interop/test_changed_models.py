"""Changed models, `agents.xml` and `.proto` files: text or a message with its place; never a traceback.

`ASEME_CHANGED_MODELS` says how many of each format are tried; `dev.py long` tries 5 000. Whole projects are
imported from some of them, because the compiler looks at those again and again.
"""

from __future__ import annotations

import os
import random
import re
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from aseme_dsl.compiler.read.load import read_source
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.interop.emf.meaning import Known
from aseme_dsl.interop.emf.system import read_system, system_text
from aseme_dsl.interop.monas_agents import modules_of
from aseme_dsl.interop.proto import read_proto
from aseme_dsl.project.editing.import_models import import_models
from aseme_dsl.source import Source, Span
from tests.interop.changing import changed, limited
from tests.interop.test_monas_agents import TEXT as AGENTS
from tests.interop.test_proto import MOVEIT

CHANGED = int(os.environ.get("ASEME_CHANGED_MODELS", "40"))
WHOLE = max(2, CHANGED // 50)
"""How many projects are imported."""

MODELS = Path(__file__).parent / "models"
FILES = {path.name: path.read_text("utf-8") for path in sorted(MODELS.iterdir())}
_OF_MODELS = (
    '< > " & &lt; &x; &#0; ]]> <!-- <!DOCTYPE <Children <nodes </nodes> TE="[x" type="OR" type="END" '
    'label="0.2" name="" Father_of="//@nodes.0" source="//@nodes.0" //@nodes.9 #_id null ?OP? || ~ . | ( [ '
    "TimeoutAction.t.9 ==NULL \0 é ((("
).split(" ")
_OF_AGENTS = (
    '< > " & <agent> </agent> <agents> <name> <activity> Enable="0" ThreadFrequency="0" ThreadFrequency=1e9 '
    "ThreadFrequency=-1 <statechart> <provider> <!-- --> <?xml <!DOCTYPE \0 é &x;"
).split(" ")
_OF_PROTO = (
    'message enum { } ; = 1 = 0 -1 99999999999 repeated optional oneof map< > "x.proto" import package '
    "syntax reserved [ ] ( ) option // /* */ int32 int64 Goal Phase .a.b \0 é '"
).split(" ")


def _has_place(found: Sequence[Diagnostic], text: str) -> None:
    assert all(item.span is not None for item in found), text


def _model(name: str, text: str) -> bool:
    source = Source(name, text)
    system, found = read_system([source], Known())
    _has_place(found, text)
    if system is None:
        assert found
        return False
    made = system_text(system)
    places = [row for row in made.rows if row.place is None and row.fate != "added"]
    assert places == [], text
    return True


def _agents(name: str, text: str) -> bool:
    made, found = modules_of(Source(name, text))
    _has_place(found, text)
    assert made or found
    return bool(made)


def _proto(name: str, text: str) -> bool:
    source = Source(name, text)
    made, found = read_proto(source, Path("/nowhere") / name, {}, Span(source, 0, min(1, len(text))))
    _has_place(found, text)
    assert made is not None or found
    return made is not None


ALONE = re.sub(r"import \"geometry.*\n", "", MOVEIT).replace("geometry.Pose", "Tolerance")
KINDS: dict[str, tuple[str, list[str], Callable[[str, str], bool]]] = {
    **{name: (text, _OF_MODELS, _model) for name, text in FILES.items()},
    "agents.xml": (AGENTS, _OF_AGENTS, _agents),
    "arm.proto": (ALONE, _OF_PROTO, _proto),
}


@pytest.mark.parametrize("name", KINDS)
def test_changed_files_end_in_text_or_a_message(name: str) -> None:
    text, pieces, read = KINDS[name]
    assert read(name, text)
    taken = 0
    for number in range(CHANGED):
        one = changed(text, pieces, random.Random(f"{name} {number}"))
        with limited(f"{name} {number}"):
            taken += read(name, one)
    assert 0 < taken < CHANGED


def test_an_and_without_regions_is_read() -> None:
    text, pieces, read = KINDS["deal.eac"]
    assert read("deal.eac", changed(text, pieces, random.Random("deal.eac 1677"))) in (True, False)


@pytest.mark.parametrize("name", FILES)
def test_changed_models_are_imported_or_refused(name: str, tmp_path: Path) -> None:
    for number in range(WHOLE):
        path = tmp_path / name
        path.write_text(changed(FILES[name], _OF_MODELS, random.Random(f"whole {name} {number}")), "utf-8")
        if not isinstance(read_source(path), Source):
            continue
        with limited(f"{name} {number}"):
            project = import_models([path])
        assert project.files or project.diagnostics
        assert all(item.span is not None or item.path for item in project.diagnostics)
