"""Files and what they import: order, buffers, and every way in which a file cannot be read."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.compiler.read.load import Loaded, load
from aseme_dsl.diagnostics import Diagnostic, render_text
from aseme_dsl.source import Source


def write(folder: Path, **files: str | bytes) -> None:
    for name, content in files.items():
        path = folder / f"{name}.aseme"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content.encode() if isinstance(content, str) else content)


def names(loaded: Loaded) -> list[str]:
    return [Path(file.source.path).name for file in loaded.files]


def only(loaded: Loaded) -> Diagnostic:
    assert len(loaded.diagnostics) == 1, render_text(loaded.diagnostics)
    return loaded.diagnostics[0]


def test_files_come_after_what_they_import_and_once_each(tmp_path: Path) -> None:
    write(
        tmp_path,
        main='import "b.aseme"\nimport "c.aseme"\nimport soccer\nimport time',
        b='import "d.aseme"\nimport time',
        c='import "d.aseme"\nimport "b.aseme"',
        d="import soccer",
    )
    loaded = load(tmp_path / "main.aseme")
    assert names(loaded) == ["soccer.aseme", "d.aseme", "time.aseme", "b.aseme", "c.aseme", "main.aseme"]
    assert not loaded.diagnostics
    assert loaded.complete


def test_the_standard_library_has_the_same_path_everywhere(tmp_path: Path) -> None:
    write(tmp_path, main="import soccer")
    assert load(tmp_path / "main.aseme").files[0].source.path == "<stdlib>/soccer.aseme"


def test_paths_are_shown_as_people_wrote_them(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "team").mkdir()
    write(tmp_path / "team", main='import "../shared/words.aseme"')
    write(tmp_path / "shared", words="enum E { A }")
    monkeypatch.chdir(tmp_path)
    loaded = load("team/main.aseme")
    assert [file.source.path for file in loaded.files] == [
        str(Path("shared") / "words.aseme"),
        "team/main.aseme",
    ]


def test_texts_of_an_editor_go_before_the_disk(tmp_path: Path) -> None:
    write(tmp_path, main='import "a.aseme"', a="enum OnDisk { A }")
    sources = {str(tmp_path / "a.aseme"): "enum InEditor { A }", str(tmp_path / "new.aseme"): ""}
    loaded = load(tmp_path / "main.aseme", sources)
    assert loaded.files[0].source.text == "enum InEditor { A }"
    unsaved = Source(str(tmp_path / "main.aseme"), 'import "a.aseme"')
    assert load(unsaved, sources).files[0].source.text == "enum InEditor { A }"
    assert load(Source("<stdin>", "import time")).files[-1].source.path == "<stdin>"


def test_a_buffer_is_found_through_a_link(tmp_path: Path) -> None:
    write(tmp_path / "real", main='import "a.aseme"', a="enum OnDisk { A }")
    (tmp_path / "link").symlink_to(tmp_path / "real")
    loaded = load(
        tmp_path / "link" / "main.aseme", {str(tmp_path / "real" / "a.aseme"): "enum InEditor { A }"}
    )
    assert loaded.files[0].source.text == "enum InEditor { A }"


def test_a_circle_names_everybody_in_it(tmp_path: Path) -> None:
    write(
        tmp_path,
        main='import "a.aseme"',
        a='import "b.aseme"',
        b='import "c.aseme"',
        c='enum E { A }\nimport "a.aseme"',
    )
    loaded = load(tmp_path / "main.aseme")
    found = only(loaded)
    assert found.code == "E005"
    assert "a.aseme → b.aseme → c.aseme → a.aseme" in found.message
    assert found.span is not None
    assert (Path(found.span.source.path).name, found.span.line) == ("c.aseme", 2)
    assert [Path(item.span.source.path).name for item in found.related] == ["a.aseme", "b.aseme"]
    assert names(loaded) == ["c.aseme", "b.aseme", "a.aseme", "main.aseme"]


def test_a_file_that_imports_itself(tmp_path: Path) -> None:
    write(tmp_path, main='import "main.aseme"')
    found = only(load(tmp_path / "main.aseme"))
    assert (found.code, found.message) == ("E005", "main.aseme imports itself")


def test_a_root_that_is_not_there(tmp_path: Path) -> None:
    write(tmp_path, kouretes="")
    found = only(load(tmp_path / "kuretes.aseme"))
    assert (found.code, found.span, found.hint) == ("E001", None, "did you mean `kouretes.aseme`?")
    assert found.path == str(tmp_path / "kuretes.aseme")


def test_an_import_that_is_not_there(tmp_path: Path) -> None:
    write(tmp_path, main='enum E { A }\nimport "word.aseme"', words="")
    loaded = load(tmp_path / "main.aseme")
    found = only(loaded)
    assert found.code == "E004"
    assert found.span is not None and found.span.text == '"word.aseme"'
    assert found.hint == "did you mean `words.aseme`?"
    assert names(loaded) == ["main.aseme"]
    assert not loaded.complete


def test_a_library_that_is_not_there(tmp_path: Path) -> None:
    write(tmp_path, main="import socer\nimport words", words="")
    close, neighbour = load(tmp_path / "main.aseme").diagnostics
    assert (close.code, close.hint, close.fix) == ("E004", "did you mean `soccer`?", "soccer")
    assert (neighbour.code, neighbour.fix) == ("E004", '"words.aseme"')


@pytest.mark.parametrize("written", ["soccer", "soccer.aseme"])
def test_a_library_in_quotes(tmp_path: Path, written: str) -> None:
    write(tmp_path, main=f'import "{written}"')
    found = only(load(tmp_path / "main.aseme"))
    assert (found.code, found.hint, found.fix) == ("E004", "the library is written `import soccer`", "soccer")


@pytest.mark.parametrize(
    ("content", "code", "words"),
    [
        (b"\x7fELF\x00\x01", "E002", "NUL"),
        ("message Größe {}".encode("latin-1"), "E002", "line 1"),
        (b"// ok\n// \xff\n", "E002", "0xff in line 2"),
        (b"language 2\nwhatever is new {{{", "E006", "language 2"),
        (b"language 0", "E006", "no language 0"),
        (b"", "W001", "empty"),
        (b"\xef\xbb\xbf  \r\n\t", "W001", "empty"),
        (b"// " + b"x" * 1000, "E003", "1 003 bytes"),
    ],
)
def test_what_cannot_be_read(tmp_path: Path, content: bytes, code: str, words: str) -> None:
    write(tmp_path, bad=content, main='enum E { A }\nimport "bad.aseme"')
    alone = only(load(tmp_path / "bad.aseme", largest=1000))
    assert alone.code == code
    assert words in alone.message
    imported = only(load(tmp_path / "main.aseme", largest=1000))
    assert (imported.code, imported.message) == (alone.code, alone.message)
    if code != "E006":
        assert (alone.span, alone.path) == (None, str(tmp_path / "bad.aseme"))
        assert imported.span is not None and imported.span.line == 2


def test_a_byte_order_mark_and_foreign_line_ends_mean_nothing(tmp_path: Path) -> None:
    write(tmp_path, main=b"\xef\xbb\xbfenum E {\r\n A\r\n}\r\n")
    loaded = load(tmp_path / "main.aseme")
    assert not loaded.diagnostics
    assert len(loaded.files[0].declarations) == 1
    assert not load(Source("buffer.aseme", "\ufeffenum E { A }")).diagnostics


def test_what_is_no_file(tmp_path: Path) -> None:
    (tmp_path / "folder.aseme").mkdir()
    os.mkfifo(tmp_path / "pipe.aseme")
    assert "is a folder" in only(load(tmp_path / "folder.aseme")).message
    assert "not a regular file" in only(load(tmp_path / "pipe.aseme")).message
    write(tmp_path, main='import "folder.aseme"\nimport ""')
    codes = [item.code for item in load(tmp_path / "main.aseme").diagnostics]
    assert codes == ["E001", "E001"]
    assert only(load("a\0b.aseme")).code == "E001"


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everything")
def test_a_file_that_one_may_not_read(tmp_path: Path) -> None:
    write(tmp_path, main="enum E { A }")
    (tmp_path / "main.aseme").chmod(0)
    assert "Permission denied" in only(load(tmp_path / "main.aseme")).message


def test_syntax_errors_of_all_files_come_in_one_run(tmp_path: Path) -> None:
    write(tmp_path, main='import "a.aseme"\nmessage ? {}', a="enum E { A ")
    found = load(tmp_path / "main.aseme").diagnostics
    assert {Path(item.span.source.path).name for item in found if item.span} == {"a.aseme", "main.aseme"}


def test_a_chain_of_imports_may_be_long(tmp_path: Path) -> None:
    write(tmp_path, **{f"f{n}": f'import "f{n + 1}.aseme"' for n in range(300)}, f300="enum E { A }")
    assert len(load(tmp_path / "f0.aseme").files) == 301


def test_a_name_of_the_library_is_taken() -> None:
    """Only the own declaration can be called otherwise."""
    text = "system S\nimport protocols\nmessage Order { int id }\nsrm a { liveness { a = X } }\n"
    [found] = [item for item in analyse(Source("s.aseme", text)).diagnostics if item.code == "E201"]
    assert found.span is not None and found.span.text == "Order"
    assert found.hint == "rename this one: the other one belongs to the standard library"


@pytest.mark.parametrize("target", ["x" * 300, '"' + "y" * 300 + '.aseme"', '"' + "z" * 300 + '.proto"'])
def test_an_import_that_no_file_can_be_called_is_not_there(tmp_path: Path, target: str) -> None:
    write(tmp_path, main=f"system S\nimport {target}\n")
    found = only(load(tmp_path / "main.aseme"))
    assert found.severity == "error" and found.span is not None
