"""Native: the modules of plain statecharts compiled to machine code by mypyc, each beside its Python.

What is compiled is the generated module with the class that it inherits, in one piece, for mypyc wants both.
Python takes the compiled module where there are two of a name; without it the same runs as Python.
"""

from __future__ import annotations

import ast
import inspect
import os
import re
import subprocess
import sys
import sysconfig
import tempfile
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path, PurePosixPath

from aseme_dsl import outside
from aseme_dsl.backends.plain.generate import WATCHED
from aseme_dsl.project.files.write import Planned

BACKEND = "plain"
"""The backend whose modules can be compiled."""

_BASE = "aseme_dsl.runtime.plain.plain"
_FLAGS = "-O2 -g0 -Wl,--build-id=none -Wl,-s"
"""Without what differs from one compilation to the next, and without what only a debugger needs."""


class NativeError(Exception):
    """A module cannot be compiled; the text says why, `path` which."""

    def __init__(self, reason: str, path: str | None = None) -> None:
        super().__init__(reason)
        self.path = path


def compiled(
    files: Iterable[Planned], done: Callable[[int, int], None] = lambda number, of: None
) -> Iterator[Planned]:
    """For each module of a statechart among the files the compiled one, to be imported by its path there.

    `done` is called with how many are compiled, and of how many: with 0 before the first.

    Raises:
        NativeError: mypyc or a C compiler is missing, or cannot compile one.
    """
    others = {file.path: file.content for file in files}
    modules = [file for file in files if _is_chart(file, others)]
    if not modules:
        return
    check_installed()
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        done(0, len(modules))
        for number, made in enumerate(pool.map(lambda file: _compiled(file, others), modules), 1):
            done(number, len(modules))
            yield from made


def _is_chart(file: Planned, others: Collection[str]) -> bool:
    """Whether a file is a class that is not watched: what is watched waits for others anyway."""
    beside = f"{file.path.removesuffix(f'{WATCHED}.py')}.py"
    if file.part != BACKEND or (beside != f"{file.path}.py" and beside in others):
        return False
    return f"from {_BASE} import ".encode() in file.content


def check_installed() -> None:
    """Look whether what the extra `native` brings is there.

    Raises:
        NativeError: it is not.
    """
    from importlib.util import find_spec

    for name in ("mypyc", "setuptools"):
        if find_spec(name) is None:
            raise NativeError(f"--native needs {name}: pip install 'aseme-dsl[native]'")


def _compiled(file: Planned, others: dict[str, bytes]) -> list[Planned]:
    path = PurePosixPath(file.path)
    with tempfile.TemporaryDirectory(prefix="asemec-native-") as temporary:
        folder = Path(temporary) / path.parent
        folder.mkdir(parents=True)
        for name, content in others.items():
            if PurePosixPath(name).parent == path.parent and name.endswith(".py"):
                (folder / PurePosixPath(name).name).write_bytes(content)
        (folder / path.name).write_text(native_source(file.content.decode()), "utf-8")
        done = run_mypyc(Path(temporary), [file.path], ".".join(path.with_suffix("").parts))
        suffix = sysconfig.get_config_var("EXT_SUFFIX")
        # A module in a package is two files: what Python imports, and what is in it.
        made = [folder / f"{path.stem}{suffix}", folder / f"{path.stem}__mypyc{suffix}"]
        if done.returncode != 0 or not all(item.is_file() for item in made):
            raise NativeError(f"this cannot be compiled: {_reason(done)}", file.path)
        return [Planned(str(path.with_name(item.name)), outside.read_bytes(item), file.part) for item in made]


def run_mypyc(folder: Path, modules: Sequence[str], group: str) -> subprocess.CompletedProcess[str]:
    """Compile modules that `native_source` has made where they are; all their code goes into one `group`."""
    configuration = folder / "mypy.ini"
    configuration.write_text(_CONFIGURATION, "utf-8")
    return subprocess.run(
        [sys.executable, "-c", _MYPYC, str(configuration), group, *modules],
        cwd=folder,
        capture_output=True,
        text=True,
        errors="replace",
        env={**os.environ, "CFLAGS": f"{os.environ.get('CFLAGS', '')} {_FLAGS}".strip()},
    )


_MYPYC = """
import sys
from setuptools import setup
from mypyc.build import mypycify

setup(
    ext_modules=mypycify(
        [
            "--config-file", sys.argv[1],
            "--ignore-missing-imports", "--namespace-packages", "--explicit-package-bases", *sys.argv[3:],
        ],
        opt_level="2",
        debug_level="0",
        group_name=sys.argv[2],
    ),
    script_args=["--quiet", "build_ext", "--inplace"],
    packages=[],
)
"""


_CONFIGURATION = f"""
[mypy]
[mypy-aseme_dsl.*]
follow_imports = skip
[mypy-{_BASE}]
follow_imports = normal
"""
"""Of ours only what the class is made of is read: all that messages import takes eight times as long."""


def _reason(done: subprocess.CompletedProcess[str]) -> str:
    """The last line that says something is wrong."""
    lines = [line for line in (done.stdout + done.stderr).splitlines() if line.strip()]
    wrong = [line for line in lines if re.search(r"error|No module|not found|failed", line)]
    return (wrong or lines or [f"mypyc ended with {done.returncode}"])[-1].strip()


def native_source(module: str) -> str:
    """The module with the class `Plain` in it, in the place of its import."""
    from aseme_dsl.runtime.plain import plain

    head, imported, rest = re.split(rf"^(from {re.escape(_BASE)} import .*)$", module, maxsplit=1, flags=re.M)
    assert imported
    rest = re.sub(r"^ +self\..* = UNSTARTED\n", "", rest, flags=re.M)  # an attribute has one type there
    tree = ast.parse(inspect.getsource(plain))
    others = [node.name for node in tree.body if isinstance(node, ast.ClassDef) and node.name != "Plain"]
    kept = [node for node in tree.body if not _is_left_out(node, others)]
    own = f"from {_BASE} import {', '.join(others)}"
    return "\n".join([head, own, *map(ast.unparse, kept), _with_declared_locals(rest)])


def _with_declared_locals(text: str) -> str:
    """The classes, with the type of each local that holds what is on the blackboard.

    A type that is inferred would be too narrow where a test stands before the place that is read first.
    """
    tree = ast.parse(text)
    slots = {
        node.target.attr: ast.unparse(node.annotation)
        for node in ast.walk(tree)
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Attribute)
    }
    lines = text.split("\n")
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    for function in sorted(functions, key=lambda node: node.lineno, reverse=True):
        first = function.body[0]
        found = {
            f"{' ' * first.col_offset}{node.target.id}: {slots[node.value.attr]}"
            for node in ast.walk(function)
            if isinstance(node, ast.NamedExpr) and isinstance(node.value, ast.Attribute)
            if node.value.attr in slots
        }
        lines[first.lineno - 1 : first.lineno - 1] = sorted(found)
    return "\n".join(lines)


def _is_left_out(node: ast.stmt, others: Iterable[str]) -> bool:
    """What a module has only once (what it is for, futures, what it offers), and classes that stay Python."""
    match node:
        case ast.Expr() | ast.ImportFrom(module="__future__"):
            return True
        case ast.ClassDef(name=name):
            return name in others
        case ast.Assign(targets=[ast.Name(id="__all__")]):
            return True
    return False


__all__ = ["NativeError", "check_installed", "compiled", "native_source", "run_mypyc"]
