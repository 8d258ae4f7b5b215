"""Loading: a generated package and the activities of a project, imported from where they are.

A generated package is imported as `FOLDER.SYSTEM` (`monas.Kouretes`), so that activities may import its
messages: `from monas.Kouretes.messages import Ball`. Packages that different backends have generated from one
system have the same messages, under each of their names. The roles of a team may come from several of these
packages (`RoleBackends`). Other imports of functions and activities are looked for in the folders given as
`path`. These folders are on `sys.path` only inside `importing`.
"""

from __future__ import annotations

import ast
import importlib
import itertools
import os
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import field, is_dataclass, replace
from enum import IntEnum
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import ModuleType

from aseme_dsl import outside
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.activities import ActivityFinder, from_package
from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.plan import Plan
from aseme_dsl.runtime.message.as_json import member_types
from aseme_dsl.runtime.message.wire import Schema
from aseme_dsl.runtime.version.versions import ACTIVITIES, VersionFiles, serving

Modules = dict[str, ModuleType]

_numbers = itertools.count(1)


class LoadError(Exception):
    """There is no generated package at a place, or it cannot be imported."""


@dataclass(frozen=True, slots=True)
class RoleBackends:
    """What a team has of packages that stand beside the one that is loaded, in folders of other names.

    Each of `roles` comes from the folder that is its value, instead. `names` are further names of folders:
    under them activities may import the messages, whether there is such a folder or not.
    """

    roles: Mapping[str, str] = field(default_factory=dict)
    names: tuple[str, ...] = ()

    def folders(self, own: str) -> tuple[str, ...]:
        """The names of the folders beside `own` from which something is loaded."""
        return tuple(sorted({*self.roles.values()} - {own}))


PURE = RoleBackends()
"""All roles are of one package."""


@dataclass(frozen=True, slots=True)
class Loaded:
    """A generated system: its roles' charts by name, its team as (agent, role), its messages by name."""

    name: str
    charts: Mapping[str, type[Chart]]
    team: tuple[tuple[str, str], ...]
    messages: Mapping[str, type[object]]
    schema: Schema | None = None
    model: str = ""
    """The hash of all its models."""
    sources: Mapping[str, str] = field(default_factory=dict)
    """The texts that it was generated from, by their paths beside the first."""
    folder: Path | None = None
    path: tuple[Path, ...] = ()
    modules: Modules = field(default_factory=dict, repr=False, compare=False)
    """The modules of its packages, by the names under which they import each other."""
    mixture: RoleBackends = PURE
    code: VersionFiles | None = None
    """The version that it was loaded from; None: the build itself."""
    enums: Mapping[str, type[IntEnum]] = field(default_factory=dict)
    """The classes of its enums by name."""

    @property
    def plans(self) -> tuple[Plan, ...]:
        """The plans of the roles."""
        return tuple(chart.PLAN for chart in self.charts.values())

    @property
    def types(self) -> Mapping[str, type[object]]:
        """The classes of its messages and enums by name."""
        return {**self.messages, **self.enums}


_lent: set[Path] = set()
"""The folders that have been on `sys.path` for a while."""


@contextmanager
def importing(folders: Sequence[Path]) -> Iterator[None]:
    """Inside, modules are looked for in these folders first.

    What other folders of earlier calls have under the same names is forgotten, so that one process may play
    several projects.
    """
    resolved = [folder.resolve() for folder in folders]
    others = {str(folder) for folder in _lent.difference(resolved)}
    # A long study has thousands of modules here: most are passed over by their names.
    for name in [name for name in list(sys.modules) if "." not in name] if others else ():
        file = getattr(sys.modules.get(name), "__file__", None)
        if file is None:
            continue
        home, own = os.path.split(file)
        if own == "__init__.py":
            home = os.path.dirname(home)  # noqa: PTH120  thousands of times a run
        if home in others and any(_has_module(f, name) for f in resolved):
            _forget(name)
    _lent.update(resolved)
    added = [str(folder) for folder in folders]
    sys.path[:0] = added
    importlib.invalidate_caches()
    try:
        yield
    finally:
        for entry in added:
            if entry in sys.path:
                sys.path.remove(entry)


@contextmanager
def forgetting(folder: Path) -> Iterator[None]:
    """Modules of this folder that are imported inside are forgotten afterwards: they are new for the next."""
    folder = folder.resolve()
    before = set(sys.modules)
    try:
        yield
    finally:
        for name, module in list(sys.modules.items()):
            if name in before or "." in name:
                continue
            places = [Path(place) for place in getattr(module, "__path__", [])]
            file = getattr(module, "__file__", None)
            if folder in {place.resolve().parent for place in (*places, *([Path(file)] if file else []))}:
                _forget(name)


def load_beside(
    folder: Path,
    running: Modules,
    path: Sequence[Path] = (),
    mixture: RoleBackends = PURE,
    code: VersionFiles | None = None,
) -> Loaded:
    """Import another version of a system that is running with these modules, and leave them in their place.

    If the messages of both are the same, they are the same classes in both, so that activities of the one
    and of the other understand each other's. What is imported is `code`, where it is given, not the disk.

    Raises:
        LoadError: as `load_system`.
    """
    own = folder.parent.name
    parents = (own, *mixture.folders(own), *mixture.names)
    names = (*parents, *(f"{parent}.{folder.name}" for parent in parents))
    before = {name: module for name, module in sys.modules.items() if _is_inside(name, names)}
    same: Modules = {}
    messages = f"{own}.{folder.name}.messages"
    module = running.get(messages)
    if module is not None and _code(_source_of(module)) == _code(_file_in(folder, "messages.py", code)):
        same[messages] = module
    try:
        return load_system(folder, path, same, mixture, code)
    finally:
        for name in [name for name in sys.modules if _is_inside(name, names)]:
            del sys.modules[name]
        sys.modules.update(before)


def _is_inside(name: str, packages: tuple[str, ...]) -> bool:
    return name in packages or name.startswith(tuple(f"{package}." for package in packages))


def _source_of(module: ModuleType) -> str | bytes | None:
    """The text of a module, as its loader has it."""
    get = getattr(module.__loader__, "get_source", None)
    try:
        source: str | None = get(module.__name__) if get is not None else None
    except ImportError:
        return None
    return source


def _file_in(folder: Path, name: str, code: VersionFiles | None) -> bytes | None:
    """A file of a package; None where there is none."""
    if code is not None:
        return code.code.get(f"{folder.parent.name}/{folder.name}/{name}")
    try:
        return outside.read_bytes(folder / name)
    except OSError:
        return None


def _code(source: str | bytes | None) -> str | None:
    """A module's code without its documentation, which tells where things stand in the source."""
    try:
        tree = ast.parse(source or "")
    except (ValueError, SyntaxError):
        return None
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list):
            node.body = [  # type: ignore[attr-defined]
                item
                for item in body
                if not (isinstance(item, ast.Expr) and isinstance(item.value, ast.Constant))
            ]
    return ast.dump(tree)


@contextmanager
def standing_in(modules: Modules) -> Iterator[None]:
    """Inside, these modules are in the place of those of the same names."""
    before = {name: sys.modules.get(name) for name in modules}
    sys.modules.update(modules)
    try:
        yield
    finally:
        for name, module in before.items():
            if module is None:
                sys.modules.pop(name, None)
            else:
                sys.modules[name] = module


def put_in_place(modules: Modules) -> None:
    """From now on these are the modules of their names."""
    sys.modules.update(modules)


def load_system(
    folder: Path,
    path: Sequence[Path] = (),
    same: Modules | None = None,
    mixture: RoleBackends = PURE,
    code: VersionFiles | None = None,
) -> Loaded:
    """Import the generated package in `folder` (`build/monas/Kouretes`), afresh each time; of the packages
    beside it, those of `mixture`.

    `same` are modules of it that need not be imported again. With `code`, which was read from the folder
    around the backends' (`build`), nothing there is read again.

    Raises:
        LoadError: one is not there, cannot be imported, or is not a generated package; or a package beside it
            was generated from another model.
    """
    found = _load_package(folder, path, same, code)
    own = folder.resolve().parent.name
    modules, charts = dict(found.modules), dict(found.charts)
    system = folder.name
    messages = modules[f"{own}.{system}.messages"]
    # What is said of roles may be of another system's, too.
    roles = {role: kind for role, kind in mixture.roles.items() if role in charts}
    mixture = replace(mixture, roles=roles)
    for name in mixture.folders(own):
        beside = folder.resolve().parent.parent / name / system
        other = _load_package(beside, path, {f"{name}.{system}.messages": messages}, code)
        if other.model != found.model:
            raise LoadError(f"{folder} and {beside} are of different models: build both")
        charts |= {role: other.charts[role] for role, kind in roles.items() if kind == name}
        modules |= other.modules
    for name in mixture.names:
        if name != own and name not in mixture.folders(own):
            modules[name] = modules[own]
            modules[f"{name}.{system}"] = modules[f"{own}.{system}"]
            modules[f"{name}.{system}.messages"] = messages
    sys.modules.update(modules)
    return replace(found, charts=charts, modules=modules, mixture=mixture)


def package_like(code: VersionFiles, system: str, running: Path | None) -> Path:
    """Of a version's packages of a system, the folder of that of the backend of what is running.

    Raises:
        LoadError: it has none of this system.
    """
    backends = [
        path.split("/")[0]
        for path in code.code
        if path.endswith(f"/{system}/messages.py") and path.count("/") == 2
    ]
    if not backends:
        known = ", ".join(code.systems) or "none"
        raise LoadError(f"the version {code.hash[:12]} has no system {system}; it has {known}")
    own = running.parent.name if running is not None else backends[0]
    return code.folder / (own if own in backends else backends[0]) / system


def other_names(modules: Modules) -> dict[str, str]:
    """The folders whose messages are really those of another one, by which these are imported."""
    found: dict[str, str] = {}
    for key, module in modules.items():
        if key.endswith(".messages") and key != module.__name__ and key.count(".") == 2:
            found[key.partition(".")[0]] = module.__name__.partition(".")[0]
    return found


class _Renamed(MetaPathFinder, Loader):
    """Finds the messages of systems under other names of the folders in which their packages are."""

    def __init__(self, names: Mapping[str, str]) -> None:
        self._names = names

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        folder, _, rest = fullname.partition(".")
        if folder not in self._names:
            return None
        if rest.endswith(".messages") and rest.count(".") == 1:
            return ModuleSpec(fullname, self)
        there = rest.count(".") == 0 and not self._is_found(fullname, path)
        return ModuleSpec(fullname, None, is_package=True) if there else None

    def _is_found(self, fullname: str, path: Sequence[str] | None) -> bool:
        """Whether there is a real package of that name."""
        others = [finder for finder in sys.meta_path if finder is not self]
        try:
            return any(finder.find_spec(fullname, path) is not None for finder in others)
        except ModuleNotFoundError:
            return False

    def exec_module(self, module: ModuleType) -> None:
        folder, _, rest = module.__name__.partition(".")
        sys.modules[module.__name__] = importlib.import_module(f"{self._names[folder]}.{rest}")


def know_as(names: Mapping[str, str]) -> None:
    """From now on, messages of packages in the folder that is a value are also found under the key's name."""
    sys.meta_path.insert(0, _Renamed(names))


def _load_package(
    folder: Path, path: Sequence[Path], same: Modules | None = None, code: VersionFiles | None = None
) -> Loaded:
    folder = folder.resolve() if code is None else folder
    if _file_in(folder, "__init__.py", code) is None:
        raise LoadError(f"there is no generated package in {folder}: build it first")
    root = () if code is not None else (folder.parent.parent,)
    folders = (*root, *(entry.resolve() for entry in path))
    parent = folder.parent.name
    name = f"{parent}.{folder.name}"
    _forget(name)
    known = sys.modules.get(parent)
    if known is not None and folder.parent not in [Path(p).resolve() for p in getattr(known, "__path__", [])]:
        _forget(parent)  # it stands for another folder of that name
    with importing(folders), serving(code):
        sys.modules.update(same or {})
        package = _import(name, folder)
        messages = _import(f"{name}.messages", folder)
        charts = getattr(package, "CHARTS", None)
        team = getattr(package, "TEAM", None)
        if not isinstance(charts, dict) or not isinstance(team, tuple):
            raise LoadError(f"{folder} is not a package that asemec has generated")
        classes = {
            key: kind
            for key, kind in vars(messages).items()
            if isinstance(kind, type) and kind.__module__ == messages.__name__ and is_dataclass(kind)
        }
        enums = {
            key: kind
            for key, kind in vars(messages).items()
            if isinstance(kind, type) and kind.__module__ == messages.__name__ and issubclass(kind, IntEnum)
        }
        for kind in classes.values():
            member_types(kind)  # while their module can be found under its name
    system = str(getattr(package, "SYSTEM", folder.name))
    schema = getattr(messages, "SCHEMA", None)
    model = str(getattr(package, "MODEL", ""))
    modules = {key: module for key, module in sys.modules.items() if _is_inside(key, (name,))}
    modules[parent] = sys.modules[parent]
    sources = dict(getattr(package, "SOURCES", {}))
    return Loaded(
        system,
        charts,
        team,
        classes,
        schema,
        model,
        sources,
        folder,
        folders,
        modules,
        code=code,
        enums=enums,
    )


def _has_module(folder: Path, name: str) -> bool:
    return (folder / f"{name}.py").is_file() or (folder / name / "__init__.py").is_file()


def _import(name: str, folder: Path) -> ModuleType:
    try:
        return importlib.import_module(name)
    except (Exception, SystemExit) as error:
        raise LoadError(f"{folder} cannot be imported: {type(error).__name__}: {error}") from error


def _forget(package: str) -> None:
    for name in [n for n in sys.modules if n == package or n.startswith(package + ".")]:
        del sys.modules[name]


def activities_in(folder: Path) -> ActivityFinder:
    """The activities in a folder, one module each; the modules may import each other relatively."""
    folder = folder.resolve()
    name = f"aseme_activities_{next(_numbers)}"
    package = ModuleType(name, "Activities that a run has loaded.")
    package.__path__ = [str(folder)]
    sys.modules[name] = package
    return from_package(name, lambda file: (folder / file).is_file())


def activities_of(code: VersionFiles) -> ActivityFinder:
    """The activities of a version."""
    name = f"aseme_activities_{next(_numbers)}"
    code.as_package(name)
    return from_package(name, lambda file: f"{ACTIVITIES}/{file}" in code.code)
