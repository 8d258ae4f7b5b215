"""Vim and Neovim show every character as the lexer for Pygments does, and indent as `asemec fmt` does."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

from aseme_dsl.grammar.syntax.contexts import Kind
from aseme_dsl.grammar.syntax.vim import camel
from tests.grammar.syntax.kinds import differences, same
from tests.grammar.syntax.programs import ACCEPTANCE, EVERYTHING, ROOT, laid_out
from tests.support.lanes import IS_LONG

KINDS = {f"aseme{camel(kind)}": same(kind) for kind in Kind} | {"asemeComment": "comment"}
PROGRAMS = [*ACCEPTANCE, EVERYTHING]

SETTINGS = """
set nocompatible encoding=utf-8 nomodeline redrawtime=60000
set runtimepath^={folder}
filetype plugin indent on
syntax on
"""

DUMP = """
let s:files = []
for s:number in range(1, argc())
  execute 'argument' s:number
  let s:rows = []
  for s:line in range(1, line('$'))
    let s:row = []
    for s:column in range(1, strlen(getline(s:line)))
      call add(s:row, synIDattr(synID(s:line, s:column, 1), 'name'))
    endfor
    call add(s:rows, s:row)
  endfor
  call add(s:files, s:rows)
endfor
call writefile([json_encode(s:files)], $VIM_RESULT)
qall!
"""

END = """
normal! G
redraw
call search('^scenario', 'bW')
let s:line = line('.') + 1
let s:found = synIDattr(synID(s:line, match(getline(s:line), '\\S') + 1, 1), 'name')
call writefile([synIDattr(synID(line('.'), 1, 1), 'name'), s:found], $VIM_RESULT)
qall!
"""

INDENT = """
setlocal shiftwidth=2
normal! gg=G
execute 'write!' fnameescape($VIM_RESULT)
qall!
"""


def editors() -> list[str]:
    """The editors of this machine that have syntax highlighting."""
    found = []
    for name in ("nvim", "vim"):
        if shutil.which(name):
            version = subprocess.run([name, "--version"], capture_output=True, text=True).stdout
            if name == "nvim" or "+syntax" in version:
                found.append(name)
    return found


def run(editor: str, folder: Path, script: str, files: list[Path]) -> str:
    """Run a script over files and return what it has written."""
    settings, commands, result = (folder / name for name in ("settings.vim", "script.vim", "result"))
    settings.write_text(SETTINGS.format(folder=ROOT / "editors/vim"), "utf-8")
    commands.write_text(script, "utf-8")
    quiet = ["--headless"] if editor == "nvim" else ["-N", "-es"]
    command = [editor, *quiet, "-i", "NONE", "-n", "-u", str(settings), "-S", str(commands), *map(str, files)]
    environment = {**os.environ, "VIM_RESULT": str(result), "LC_ALL": "C.UTF-8"}
    done = subprocess.run(command, capture_output=True, text=True, env=environment, stdin=subprocess.DEVNULL)
    assert done.returncode == 0 and result.exists(), done.stdout + done.stderr
    return result.read_text("utf-8")


@pytest.fixture(params=["nvim", "vim"])
def editor(request: pytest.FixtureRequest) -> str:
    name: str = request.param
    if name not in editors():
        pytest.skip(
            f"NOT TRIED, for there is no {name} here: apt install {'neovim' if name == 'nvim' else name}"
        )
    return name


def test_the_groups_are_those_of_the_lexer(editor: str, tmp_path: Path) -> None:
    found = json.loads(run(editor, tmp_path, DUMP, PROGRAMS))
    wrong = {}
    for path, rows in zip(PROGRAMS, found, strict=True):
        text = path.read_text("utf-8")
        kinds: list[str] = []
        for line, row in zip(text.removesuffix("\n").split("\n"), rows, strict=True):
            column = 0
            for character in line:
                group = row[column].partition("_")[0]
                kinds.append("" if character.isspace() else KINDS.get(group, f"group {group}"))
                column += len(character.encode())
            kinds.append("")
        wrong[path.name] = differences(text, kinds[: len(text)])
    assert wrong == {path.name: [] for path in PROGRAMS}


def test_the_indentation_is_that_of_fmt(editor: str, tmp_path: Path) -> None:
    """Of lines that are not continued; how those are aligned is for `asemec fmt` to say."""
    text = (ROOT / "tests/acceptance/contract_net.aseme").read_text("utf-8")
    flat = tmp_path / "flat.aseme"
    flat.write_text("".join(line.lstrip(" ") for line in text.splitlines(keepends=True)), "utf-8")
    assert run(editor, tmp_path, INDENT, [flat]) == text


def test_the_end_of_a_long_file_is_shown_without_reading_all_of_it(editor: str, tmp_path: Path) -> None:
    """Vim gives up on colours that take longer than two seconds ('redrawtime')."""
    text = (ROOT / "tests/acceptance/kouretes.aseme").read_text("utf-8")
    long = tmp_path / "long.aseme"
    long.write_text((text + "\n") * 30, "utf-8")
    found = run(editor, tmp_path, END, [long]).split()
    assert [group.partition("_")[0] for group in found] == ["asemeDeclaration", "asemeReference"]


CANONICAL = """
setlocal shiftwidth=2
for s:number in range(1, argc())
  execute 'argument' s:number
  silent normal! gg=G
  silent write
endfor
call writefile([], $VIM_RESULT)
qall!
"""


def test_a_file_that_is_laid_out_stays_as_it_is(editor: str, tmp_path: Path) -> None:
    """`gg=G` keeps what continued lines are aligned with, and sees braces in texts and comments as text."""
    files = laid_out(tmp_path)
    if len(both := editors()) == 2 and not IS_LONG:  # each takes every other file
        files = dict(list(files.items())[both.index(editor) :: 2])
    run(editor, tmp_path, CANONICAL, list(files))
    assert [path.name for path, text in files.items() if path.read_text("utf-8") != text] == []


def test_a_line_that_is_indented_too_far_is_mended(editor: str, tmp_path: Path) -> None:
    file = tmp_path / "far.aseme"
    file.write_text(
        "srm a {\n      liveness {\n         a = B\n         b = C\n    }\n  }\n\n    srm c {\n}\n", "utf-8"
    )
    found = run(editor, tmp_path, INDENT, [file])
    assert found == "srm a {\n  liveness {\n    a = B\n    b = C\n  }\n}\n\nsrm c {\n}\n"
