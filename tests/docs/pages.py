"""Pages of the documentation: what stands in one, and how its examples are run.

The examples of a page share a folder and run from the top to the bottom. Their language says what they are:

    aseme     a whole file; it must compile without an error or warning
    console   `$ command` and what it says; `asemec` runs in this process, anything else in a shell
    python    a piece of a program; the pieces of a page share their names
    pycon     a Python session, as for doctest
    json, toml  must be valid
    text      a file of another kind, as are rst, markdown, lua, lisp and rust
    diff      a change to a file (see below)
    sh        a command that cannot run here (it installs something, or never ends); only a few are allowed

In what is expected `...` stands for anything: alone on a line for any lines, elsewhere for any text; but not
in what `--help` says, which has such dots of its own. Comments `<!-- word: value -->` before an example,
which readers do not see, say more:

    file: PATH        the example becomes this file
    part of: PATH     the example's lines stand together in this file (`...` skips lines)
    with: NAME        an `aseme` example stands for `// HERE` in completions/NAME.aseme
    reports: CODES    an `aseme` example gives exactly these errors and warnings
    change: PATH      a `diff` is applied to this file
    break: PATH       the same, but to the file as it was before any other `break`
    copy: PATH        (no example follows) a file or folder of the project is copied here
    files of: PAGE    (no example follows) all files that another page makes, as it has them at its end
    drawn: COMMAND    the picture that follows is what this `asemec diagram … -o NAME` draws
    left: PATH        the picture that follows is this file, which a command above has left
"""

from __future__ import annotations

import contextlib
import difflib
import doctest
import io
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import textwrap
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import dev
from aseme_dsl.cli import main
from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import Severity, render_text
from aseme_dsl.source import Source

ROOT = Path(__file__).resolve().parent.parent.parent
COMPLETIONS = Path(__file__).resolve().parent / "completions"

WORDS = ("files of", "file", "part of", "with", "reports", "change", "break", "copy", "drawn", "left")
NOT_RUN = (
    r"python3 dev\.py (play|test|vsix)\b.*",
    r"code --install-extension .*",
    r"python3 -m pip install .*",
    r"(sudo )?apt install .*",
    r"\.venv/bin/.*",
    r"cd .*",
    r"\. \.venv/bin/activate",
    r'eval "\$\(asemec completion bash\)"',
    r"asemec .* --real\b.*",
    r"asemec node .*",
    r"asemec deploy .*--all.*",
    r"asemec team status --key .*",
    r"asemec/\w+/current/start \w+",
    r"python3 install\.py .*",
    r"asemec run .* --platform (spade|mango)\b.*",
    r"asemec .* --cluster .*",
    r"asemec view .*",
    r"asemec .* --watch",
    r"asemec completion fish > .*",
    r"sudo loginctl enable-linger \$USER",
    r"python3 -m venv ~/asemec-env",
    r"\. ~/asemec-env/bin/activate",
)
"""What an `sh` example may say."""


BEGINNING = ("--for", "20s")
"""So much of the match is played: tests/examples/test_robocup.py plays the rest, and has its picture."""


class Wrong(AssertionError):
    """An example is not what the page says."""


@dataclass(frozen=True, slots=True)
class Example:
    """A fenced block, or a picture: where it is, what it is, and what the comments before it say.

    `first` and `last` are the (0-based) lines of its content; of a picture, both are its line.
    """

    language: str
    text: str
    first: int
    last: int
    said: dict[str, str]


@dataclass(slots=True)
class Page:
    """A page, while its examples run in `folder`."""

    path: Path
    folder: Path
    update: bool
    lines: list[str] = field(default_factory=list)
    code: int = 0
    names: dict[str, Any] = field(default_factory=dict)
    whole: dict[str, str] = field(default_factory=dict)
    edits: list[tuple[int, int, list[str]]] = field(default_factory=list)

    def run(self) -> None:
        """Run every example up to what is wrong; with `update`, write what commands say now into the page."""
        self.lines = self.path.read_text("utf-8").split("\n")
        self.names["__name__"] = "__page__"
        try:
            for example in examples(self.lines):
                try:
                    self._run(example)
                except Wrong as wrong:
                    place = os.path.relpath(self.path, ROOT)
                    raise AssertionError(f"{place}:{example.first + 1}: {wrong}") from None
        finally:
            self._write_edits()

    def _write_edits(self) -> None:
        if self.edits:
            for first, last, new in reversed(self.edits):
                self.lines[first:last] = new
            self.path.write_text("\n".join(self.lines), "utf-8")

    def _run(self, example: Example) -> None:
        said = example.said
        if "file" in said:
            self._write(example)
        if "part of" in said:
            self._part(example, self.folder / said["part of"])
            return
        match example.language:
            case "copy":
                copy(ROOT / said["copy"], self.folder)
            case "files of":
                other = (self.path.parent / said["files of"]).read_text("utf-8").split("\n")
                for item in examples(other):
                    if "file" in item.said:
                        self._write(item)
                    elif "change" in item.said:
                        self._diff(item)
            case "picture":
                self._picture(example)
            case "aseme":
                self._aseme(example)
            case "console":
                self._console(example)
            case "python":
                self._python(example)
            case "pycon":
                self._session(example)
            case "json":
                for value in (
                    example.text.splitlines() if said.get("file", "").endswith("l") else [example.text]
                ):
                    json.loads(value)
            case "toml":
                tomllib.loads(example.text)
            case "yaml":
                self._workflow(example)
            case "text" | "rst" | "markdown" | "lua" | "lisp" | "rust" if "file" in said:
                pass
            case "diff":
                self._diff(example)
            case "sh":
                for line in example.text.splitlines():
                    command = line.partition("#")[0].strip()
                    if command and not any(re.fullmatch(pattern, command) for pattern in NOT_RUN):
                        raise Wrong(f"`{command}` could run: make it a console example")
            case language:
                raise Wrong(f"nobody checks examples in {language or 'no language'}")

    def _write(self, example: Example) -> None:
        path = self.folder / example.said["file"]
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(completed(example), "utf-8")

    # ---- the kinds ---------------------------------------------------------------------------

    def _aseme(self, example: Example) -> None:
        text, path = completed(example), example.said.get("file", "example.aseme")
        found = analyse(Source(path, text)).diagnostics
        codes = sorted(item.code for item in found if item.severity is not Severity.NOTE)
        expected = sorted(example.said.get("reports", "").replace(",", " ").split())
        if codes != expected:
            raise Wrong(f"reports {codes}, not {expected}\n{render_text(found)}")

    def _workflow(self, example: Example) -> None:
        """What tells a CI service to run asemec: its commands can be run, whatever they find."""
        import yaml

        yaml.safe_load(example.text)
        for command in re.findall(r"^\s*- (?:run: )?(asemec .*)$", example.text, re.MULTILINE):
            self._command(command)
            if self.code not in (0, 1):
                raise Wrong(f"`{command}` ends with {self.code}")

    def _console(self, example: Example) -> None:
        now: list[str] = []
        for command, output in commands(example.text):
            got = self._command(command)
            is_help = command.endswith(" --help")
            if output != got if is_help else not agrees(output, got):
                if not self.update or (not is_help and "..." in "\n".join(output)):
                    again = "pytest tests/docs --snapshot-update writes it here, except where `...` stands"
                    raise Wrong(f"`{command}` says something else\n{difference(output, got)}\n{again}")
                output = got
            now += [*f"$ {command}".split("\n"), *output]
        if now != clean(example.text):
            self.edits.append((example.first, example.last, now))

    def _command(self, command: str) -> list[str]:
        words = command.replace("\\\n", " ")
        if words == "echo $?":
            return [str(self.code)]
        if words.startswith("cd "):
            os.chdir(words[3:])
            return []
        if words == "python3 dev.py play":
            arguments = [*dev.PLAY[2:], *BEGINNING]
        elif words.startswith("asemec ") and not re.search(r"[|<>*]", words):
            arguments = shlex.split(words)[1:]
        else:
            return self._shell(words)
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            self.code = main(arguments)
        return clean(out.getvalue())

    def _shell(self, command: str) -> list[str]:
        tools = str(Path(sys.executable).parent)
        environment = {**os.environ, "PATH": os.pathsep.join([tools, os.environ.get("PATH", os.defpath)])}
        done = subprocess.run(
            ["bash", "-c", command],
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            timeout=600,
        )
        self.code = done.returncode
        return clean(done.stdout)

    def _python(self, example: Example) -> None:
        code = compile(example.text, f"{self.path.name}:{example.first + 1}", "exec")
        if "file" not in example.said:
            exec(code, self.names)

    def _session(self, example: Example) -> None:
        test = doctest.DocTestParser().get_doctest(
            example.text + "\n", self.names, self.path.name, str(self.path), example.first
        )
        out = io.StringIO()
        runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE)
        runner.run(test, out=out.write, clear_globs=False)
        self.names.update(test.globs)
        if runner.failures:
            raise Wrong(out.getvalue())

    def _part(self, example: Example, path: Path) -> None:
        shown = [line.rstrip() for line in example.text.split("\n")]
        text = "\n" + "\n".join(line.rstrip() for line in path.read_text("utf-8").split("\n"))
        pattern = r"\n"
        for line in shown:
            pattern += r"(?:.*\n)*?" if line.strip() == "..." else loosely(line) + r"\n"
        if not re.search(pattern, text + "\n"):
            raise Wrong(f"this does not stand in {path.name}")

    def _diff(self, example: Example) -> None:
        name = example.said.get("change") or example.said.get("break")
        if name is None:
            raise Wrong("which file does it change?")
        path = self.folder / name
        text = path.read_text("utf-8")
        if "break" in example.said:
            text = self.whole.setdefault(name, text)
        lines = example.text.split("\n")
        before = "".join(f"{line[1:]}\n" for line in lines if line[:1] in (" ", "-", ""))
        after = "".join(f"{line[1:]}\n" for line in lines if line[:1] in (" ", "+", ""))
        if text.count(before) != 1:
            raise Wrong(f"{name} has this {text.count(before)} times:\n{before}")
        path.write_text(text.replace(before, after), "utf-8")

    def _picture(self, example: Example) -> None:
        """Make it again; its texts must be those of the committed one (places depend on the Graphviz)."""
        committed = (self.path.parent / example.text).resolve()
        says: list[str] = []
        if "drawn" in example.said:
            made = self.folder / committed.name
            says = self._command(example.said["drawn"])
        elif "left" in example.said:
            made = self.folder / example.said["left"]
        else:
            made = committed  # another page has made it
        if not made.is_file():
            raise Wrong("\n".join([f"there is no {made.name}", *says]))
        if made == committed:
            return
        if self.update and (not committed.is_file() or texts(committed) != texts(made)):
            committed.parent.mkdir(exist_ok=True)
            shutil.copy(made, committed)
        if not committed.is_file() or texts(committed) != texts(made):
            raise Wrong(f"{committed.name} is not as it was committed: pytest tests/docs --snapshot-update")


def run_console(text: str, folder: Path) -> None:
    """Run the commands of a console, which is on no page, in `folder`, the working directory.

    Raises:
        Wrong: A command says something else.
    """
    Page(Path("console"), folder, update=False)._console(Example("console", text, 0, 0, {}))


# ---- reading -----------------------------------------------------------------------------------


def examples(lines: list[str]) -> Iterator[Example]:
    """The examples of a page, in order."""
    said: dict[str, str] = {}
    number = 0
    while number < len(lines):
        line = lines[number]
        comment = re.fullmatch(r"\s*<!-- ([\w ]+?): (.*?) -->\s*", line)
        fence = re.fullmatch(r"(\s*)(`{3,}|~{3,})\s*(.*)", line)
        picture = re.fullmatch(r"\s*!\[[^]]*\]\(([^)\s]+)\)(\{[^}]*\})?\s*", line)
        if comment is not None and comment[1] == "fmt":
            pass  # says to ruff that generated code stays as it is
        elif comment is not None:
            if comment[1] not in WORDS:
                raise AssertionError(f"line {number + 1}: nobody knows `{comment[1]}`")
            if comment[1] in ("copy", "files of"):
                yield Example(comment[1], "", number, number, {comment[1]: comment[2]})
            else:
                said[comment[1]] = comment[2]
        elif fence is not None:
            first = number + 1
            end = re.compile(rf"\s*{fence[2]}{fence[2][0]}*\s*")
            number = first
            while not end.fullmatch(lines[number]):
                number += 1
            language = fence[3].split()[0] if fence[3] else ""
            if not language.startswith("{"):  # a directive of Sphinx
                indent = len(fence[1])
                text = "\n".join(part[indent:] for part in lines[first:number])
                yield Example(language, text, first, number, said)
            said = {}
        elif picture is not None:
            yield Example("picture", picture[1], number, number, said)
            said = {}
        elif line.strip() and said:
            raise AssertionError(f"line {number}: nothing follows the comment")
        number += 1


def completed(example: Example) -> str:
    """The text of an example, inside what the page says it stands in."""
    text = example.text + "\n"
    if "with" not in example.said:
        return text
    frame = (COMPLETIONS / f"{example.said['with']}.aseme").read_text("utf-8")
    here = re.search(r"^( *)// HERE\n", frame, re.MULTILINE)
    assert here is not None, example.said["with"]
    return frame[: here.start()] + textwrap.indent(text, here[1]) + frame[here.end() :]


def commands(text: str) -> Iterator[tuple[str, list[str]]]:
    """The commands of a console, each with what it is to say."""
    command, output = "", list[str]()
    more = False
    for line in text.split("\n"):
        if more:
            command += f"\n{line}"
            more = line.endswith("\\")
        elif line.startswith("$ "):
            if command:
                yield command, clean("\n".join(output))
            command, output, more = line[2:], [], line.endswith("\\")
        else:
            output.append(line)
    if not command:
        raise Wrong("a console has a command: a line that begins with `$ `")
    yield command, clean("\n".join(output))


def clean(text: str) -> list[str]:
    """Lines without blanks at their ends and without empty lines at the end."""
    lines = [line.rstrip() for line in text.split("\n")]
    while lines and not lines[-1]:
        lines.pop()
    return lines


# ---- comparing ---------------------------------------------------------------------------------


def loosely(line: str) -> str:
    """A pattern for a line in which `...` stands for any text."""
    return ".*?".join(re.escape(part) for part in line.split("..."))


def agrees(expected: list[str], got: list[str]) -> bool:
    """Whether lines are as expected, where `...` stands for any lines, or any text in a line."""
    pattern = "".join(r"(?:.*\n)*?" if line == "..." else loosely(line) + r"\n" for line in expected)
    return re.fullmatch(pattern, "".join(f"{line}\n" for line in got)) is not None


def difference(expected: list[str], got: list[str]) -> str:
    return "\n".join(difflib.unified_diff(expected, got, "the page", "now", lineterm=""))


def texts(picture: Path) -> list[str]:
    """Everything that is written in an SVG."""
    svg = picture.read_text("utf-8")
    return sorted(re.findall(r"<(?:text|title)\b[^>]*>(.*?)</(?:text|title)>", svg, re.DOTALL))


def copy(path: Path, folder: Path) -> None:
    """A file or folder of the project, without what a run has left there."""
    if path.is_dir():
        leave = shutil.ignore_patterns("__pycache__", "build", "out", ".*cache")
        shutil.copytree(path, folder / path.relative_to(ROOT), ignore=leave)
    else:
        shutil.copy(path, folder / path.name)
