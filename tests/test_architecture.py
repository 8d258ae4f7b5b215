"""The layers of the package: imports run downwards only, and a robot loads nothing but the runtime."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import networkx as nx
import pytest

PACKAGE = Path(__file__).resolve().parent.parent / "aseme_dsl"

LAYERS = {
    "cli": 5,
    "documents": 5,
    "pytest_plugin": 5,
    "project": 4,
    "editor": 4,
    "compiler": 3,
    "backends": 3,
    "grammar": 2,
    "diagrams": 2,
    "codegen": 2,
    "interop": 2,
    "play": 2,
    "proofs": 2,
    "worlds": 2,
    "amola": 1,
    "runtime": 1,
    "diagnostics": 1,
    "source": 0,
    "outside": 0,
    "display": 0,
    "standard_library": 0,
    "pygments_lexer": 0,
}
"""Each package, or module beside them, and its layer; a new one is entered here."""

BELOW_ALL = {"records"}
"""What every module may import, and imports none of them: how classes of data are made."""

KNOWS_ONLY = {
    "amola": {"source", "display"},
    "diagnostics": {"source"},
    "runtime": {"source", "outside", "display"},
    "worlds": {"runtime"},
    "proofs": {"amola", "runtime", "source"},
    "play": {"amola", "runtime", "source"},
}
"""Packages that may import less than all that is below them."""

SUBPACKAGES = {
    "compiler": "read names formula types control chart requirements checks stages",
    "codegen": "place seen program code step plain batch",
    "diagrams": "look compact models sequence rendering",
    "editor": "reading files answers typing changes proving",
    "interop": "emf machines export",
    "grammar": "text formulas parsing layout syntax",
    "project": (
        "files settings code building editing spreading playing studying testing stepping proving observing"
        " comparing deploying operating"
    ),
    "runtime": (
        "time chart plain message library ports trace transport platform channel conversation world activity"
        " version workers agent driver team control monitor"
    ),
}
"""The subpackages of a package: each imports only from those before it; modules beside them from all."""

DOZEN = 15
LARGER = {"cli": "a file a command", "worlds/field": "a file a thing on the field"}
"""Packages with more files than a dozen or so, and why."""

TOP = {"__init__", "__main__"}
"""The public face of the package, which sees everything and which no other may see."""


def modules() -> list[Path]:
    return sorted(PACKAGE.rglob("*.py"))


def unit_of(path: Path) -> str:
    first = path.relative_to(PACKAGE).parts[0]
    return first.removesuffix(".py")


def imported_units(path: Path) -> set[str]:
    """What of `LAYERS` a module imports, at its top or inside a function; the whole package is `__init__`."""
    package = ["aseme_dsl", *path.relative_to(PACKAGE).parts[:-1]]
    names: list[str] = []
    for node in ast.walk(ast.parse(path.read_text("utf-8"), str(path))):
        if isinstance(node, ast.Import):
            names += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            origin = ".".join([*base, *([node.module] if node.module else [])])
            # `from aseme_dsl import amola` names one; `from aseme_dsl import __version__` does not.
            names += [f"{origin}.{alias.name}" if origin == "aseme_dsl" else origin for alias in node.names]
    units = set()
    for name in names:
        parts = name.split(".")
        if parts[0] == "aseme_dsl":
            unit = parts[1] if len(parts) > 1 else "__init__"
            units.add(unit if unit in {*LAYERS, *BELOW_ALL} else "__init__")
    return units


def test_every_package_has_its_layer() -> None:
    units = {unit_of(path) for path in modules()} - TOP - BELOW_ALL
    assert units <= set(LAYERS), "enter the new package in LAYERS"


@pytest.mark.parametrize("path", modules(), ids=lambda path: path.relative_to(PACKAGE).as_posix())
def test_imports_run_downwards(path: Path) -> None:
    unit = unit_of(path)
    if unit in TOP:
        return
    if unit in BELOW_ALL:
        assert imported_units(path) == set()
        return
    for other in imported_units(path) - {unit} - BELOW_ALL:
        if unit == "cli" and other == "__init__":
            continue  # the command prints the package's version and uses its public face
        assert other != "__init__", f"{unit} uses the public face of the package, which is above it"
        assert LAYERS[other] < LAYERS[unit], f"{unit} (layer {LAYERS[unit]}) uses {other} ({LAYERS[other]})"
        assert other in KNOWS_ONLY.get(unit, {other}), f"{unit} may not know {other}"


def test_classes_of_data_are_made_late() -> None:
    """What a module compiles when it is loaded, every start of `asemec` that loads it waits for.

    Worlds use nothing of the package, and only runs load them.
    """
    wrong = [
        path.relative_to(PACKAGE).as_posix()
        for path in modules()
        if unit_of(path) not in BELOW_ALL | {"worlds"}
        for node in ast.walk(ast.parse(path.read_text("utf-8"), str(path)))
        if isinstance(node, ast.ImportFrom) and node.module == "dataclasses"
        if any(alias.name == "dataclass" for alias in node.names)
    ]
    assert wrong == [], "write `from aseme_dsl.records import dataclass`"


def imported_modules(path: Path, known: Mapping[str, Path]) -> set[str]:
    """Every module of the package that a module imports, also only for its types."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"), str(path))):
        if isinstance(node, ast.ImportFrom) and node.module is not None:
            for alias in node.names:
                inner = f"{node.module}.{alias.name}"
                found.add(inner if inner in known else node.module)
        elif isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
    return found & set(known)


def known_modules() -> dict[str, Path]:
    known = {}
    for path in modules():
        parts = ["aseme_dsl", *path.relative_to(PACKAGE).with_suffix("").parts]
        known[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return known


def test_no_modules_import_each_other_in_a_circle() -> None:
    known = known_modules()
    imports = {name: imported_modules(path, known) for name, path in known.items()}
    graph = nx.DiGraph((name, other) for name, others in imports.items() for other in others)
    assert [sorted(circle) for circle in nx.strongly_connected_components(graph) if len(circle) > 1] == []


def subpackage_of(module: str) -> tuple[str, str] | None:
    """The package of a module and the subpackage in it: `("compiler", "names")`."""
    parts = module.split(".")[1:]
    if len(parts) < 2 or parts[0] not in SUBPACKAGES:
        return None
    return (parts[0], parts[1]) if parts[1] in SUBPACKAGES[parts[0]].split() else None


@pytest.mark.parametrize("package", SUBPACKAGES)
def test_each_subpackage_is_entered(package: str) -> None:
    found = {path.parent.name for path in (PACKAGE / package).glob("*/__init__.py")}
    assert found == set(SUBPACKAGES[package].split()) - {
        path.stem for path in (PACKAGE / package).glob("*.py")
    }


def test_subpackages_use_only_those_before_them() -> None:
    known = known_modules()
    wrong = []
    for name, path in known.items():
        here = subpackage_of(name)
        for other in imported_modules(path, known) if here else ():
            there = subpackage_of(other)
            beside = there is None and other.startswith(f"aseme_dsl.{here[0]}.") if here else False
            order = SUBPACKAGES[here[0]].split() if here else []
            upwards = here and there and here[0] == there[0] and order.index(here[1]) < order.index(there[1])
            if beside or upwards:
                wrong.append(f"{name} uses {other}")
    assert wrong == []


PRINTERS = ("step", "plain", "batch")
"""The subpackages of `codegen` that only write what `codegen/program` has worked out."""

ANALYSIS = {"FlatChart", "History", "Registers", "Uses", "Following", "resting", "copies_of"}
"""What `codegen/program` puts together, once."""


@pytest.mark.parametrize("printer", PRINTERS)
def test_printers_take_what_a_chart_means_from_its_program(printer: str) -> None:
    wrong = [
        f"{path.name}: {node.id}"
        for path in sorted((PACKAGE / "codegen" / printer).glob("*.py"))
        for node in ast.walk(ast.parse(path.read_text("utf-8"), str(path)))
        if isinstance(node, ast.Name) and node.id in ANALYSIS
    ]
    assert wrong == []


@pytest.mark.parametrize("printer", PRINTERS)
def test_printers_search_no_text(printer: str) -> None:
    searched = {"re", "parse", "find", "partition", "removeprefix", "split"}
    wrong = []
    for path in sorted((PACKAGE / "codegen" / printer).glob("*.py")):
        for node in ast.walk(ast.parse(path.read_text("utf-8"), str(path))):
            if isinstance(node, ast.Import | ast.ImportFrom):
                wrong += [f"{path.name}: {alias.name}" for alias in node.names if alias.name in searched]
            elif isinstance(node, ast.Attribute) and node.attr in searched:
                wrong.append(f"{path.name}: {node.attr}")
    assert wrong == []


def test_no_package_has_many_more_files_than_a_dozen() -> None:
    sizes = {folder: len(list(folder.glob("*.py"))) for folder in {path.parent for path in modules()}}
    large = {folder.relative_to(PACKAGE).as_posix() for folder, size in sizes.items() if size > DOZEN}
    assert large == set(LARGER)


COMPILER_LIBRARIES = ["textx", "arpeggio", "networkx", "jinja2", "graphviz", "click", "jsonschema"]


@pytest.mark.parametrize(
    "module", ["aseme_dsl", "aseme_dsl.runtime", "aseme_dsl.amola", "aseme_dsl.diagnostics"]
)
def test_importing_loads_no_heavy_library(module: str) -> None:
    """What a robot or a script imports comes without the compiler's libraries (they cost 30-130 ms each)."""
    question = f"import sys, {module}; print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", question], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    loaded = set(done.stdout.split())
    assert not loaded & set(COMPILER_LIBRARIES)
    if module == "aseme_dsl.runtime":
        upper = {f"aseme_dsl.{unit}" for unit in LAYERS if unit not in {"runtime", *KNOWS_ONLY["runtime"]}}
        assert not loaded & upper


SMALL = """\
system Walker
message Seen { bool ball }
topic eyes { state Seen }
srm robot {
  liveness { robot = (Walk | Stand)~ }
  control robot {
    enter Walk  : [eyes.state.Seen.ball]
    enter Stand : else
  }
}
team Walkers { one : robot }
"""

NEVER = {
    "aseme_dsl.runtime.team.team",
    "asyncio",
    "google.protobuf",
    "numpy",
    "pygls",
    "lsprotocol",
    "zenoh",
    "spade",
}
"""What none of these commands needs, each of which takes 30 ms and more."""

SOMETIMES = {
    "decimal",
    "difflib",
    "importlib.metadata",
    "json",
    "secrets",
    "subprocess",
    "tempfile",
    "tomllib",
    "aseme_dsl.project.building.build",
    "aseme_dsl.grammar.parsing.explain",
    "aseme_dsl.interop.proto",
    "aseme_dsl.runtime.chart.inputs",
}
"""What is needed only if there is something to be said, mended or configured: together 30 ms."""

NOT_LOADED = {
    ("--version",): {
        *NEVER,
        *COMPILER_LIBRARIES,
        "aseme_dsl.compiler",
        "aseme_dsl.diagnostics",
        "aseme_dsl.runtime.chart.board",
        "json",
        "tomllib",
    }
    - {"click"},
    ("explain", "E101"): {*NEVER, "jinja2", "graphviz", "aseme_dsl.backends"},
    ("fmt", "small.aseme"): {
        *NEVER,
        "jinja2",
        "networkx",
        "graphviz",
        "aseme_dsl.compiler.phases",
    },
    ("check", "small.aseme"): {
        *NEVER,
        *set(COMPILER_LIBRARIES) - {"arpeggio", "click"},  # textX is there for a grammar that has changed
        *SOMETIMES,
        "aseme_dsl.codegen.step",
        "aseme_dsl.backends",
    },
    ("build", "small.aseme", "--only", "models"): {
        *NEVER,
        "jinja2",
        "graphviz",
        "textx",
        "importlib.metadata",
    },
    ("build", "small.aseme", "--only", "monas"): {
        *NEVER - {"google.protobuf"},
        "graphviz",
        "textx",
        "importlib.metadata",
    },
}
"""Of each command line, what it must not import: nobody should wait for what is not used."""


@pytest.mark.parametrize("arguments", NOT_LOADED, ids=" ".join)
def test_commands_import_only_what_they_need(arguments: tuple[str, ...], tmp_path: Path) -> None:
    (tmp_path / "small.aseme").write_text(SMALL, "utf-8")
    question = (
        "import sys; from aseme_dsl.cli import main\n"
        "code = main(sys.argv[1:])\n"
        "print('loaded:', *sys.modules); sys.exit(code)"
    )
    done = subprocess.run(
        [sys.executable, "-c", question, *arguments],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(PACKAGE.parent)},
    )
    assert done.returncode == 0, done.stderr + done.stdout
    loaded = set(done.stdout.rpartition("loaded:")[2].split())
    assert not loaded & NOT_LOADED[arguments]


def test_the_lazy_names_of_the_runtime_are_those_that_it_offers() -> None:
    from aseme_dsl import runtime

    assert sorted(name for names in runtime._MODULES.values() for name in names) == sorted(runtime.__all__)
    for name in runtime.__all__:
        assert getattr(runtime, name) is not None
