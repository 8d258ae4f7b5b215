"""Backend: what one is, what it is given, and how it is found."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, TypeVar

from aseme_dsl.amola.system import System
from aseme_dsl.diagnostics import Diagnostic
from aseme_dsl.records import dataclass

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

GROUP = "aseme_dsl.backends"
"""The entry point group under which another package offers its backend."""
OWN = {
    "monas": "aseme_dsl.backends.monas",
    "jade_like": "aseme_dsl.backends.jade_like",
    "plain": "aseme_dsl.backends.plain",
    "batch": "aseme_dsl.backends.batch",
}
"""Our own backends, with the module whose `BACKEND` each is."""
ROLE_MODULES = {"monas": ("plan", "step"), "jade_like": ("plan", "step", "agent", "behaviours")}
"""The backends whose output is played, with the modules that each generates for a role.

They stand here because `asemec check` looks at imports, and loads no backend for that.
"""
AGENTS = tuple(ROLE_MODULES)
"""The backends whose output is played: what they generate are agents that `aseme_dsl.runtime` runs."""
ACTIVITIES = "activities"
"""Where a backend puts first versions of activities, in its own folder; a project may choose another."""


@dataclass(frozen=True, slots=True)
class Artefact:
    """A file that a backend writes: `path` relative to the backend's folder, with `/`.

    `kept` files belong to the user once they exist: they are written only where there is none.
    """

    path: str
    text: str
    kept: bool = False


_T = TypeVar("_T")


class Known(Protocol):
    """What was generated before: a backend that asks it does again only what has changed."""

    def recall(self, function: Callable[..., _T], *inputs: object) -> _T:
        """`function(*inputs)`, or its earlier result for the same objects. Do not modify the result.

        The function must depend on its inputs alone, and must not call `recall` itself.
        """

    def each(
        self, function: Callable[..., _T], inputs: Iterable[tuple[object, ...]], *common: object
    ) -> tuple[_T, ...]:
        """`recall(function, *item, *common)` for each of the inputs, at next to no cost for the same ones."""

    def same(self, name: object, value: _T) -> _T:
        """`value`, or the equal one that had this name before: an input that is the same object then."""

    def same_values(self, name: object, values: dict[str, _T]) -> dict[str, _T]:
        """The same for each of many values; if all are equal, the very mapping of before."""

    def whole(self, text: str) -> str:
        """A text as it will be written; until then, lines of a source may have other numbers in it."""


class NothingKnown:
    """Everything is generated for the first time."""

    def recall(self, function: Callable[..., _T], *inputs: object) -> _T:
        return function(*inputs)

    def each(
        self, function: Callable[..., _T], inputs: Iterable[tuple[object, ...]], *common: object
    ) -> tuple[_T, ...]:
        return tuple(function(*item, *common) for item in inputs)

    def same(self, name: object, value: _T) -> _T:
        return value

    def same_values(self, name: object, values: dict[str, _T]) -> dict[str, _T]:
        return values

    def whole(self, text: str) -> str:
        return text


NOTHING_KNOWN = NothingKnown()


@dataclass(frozen=True, slots=True)
class BackendOptions:
    """What a project may choose, and what is known from its builds before.

    `templates` is a folder of templates that replace the backend's own, by name.
    """

    templates: Path | None = None
    known: Known = NOTHING_KNOWN


DEFAULT = BackendOptions()


class Backend(Protocol):
    """Turns a system into the files of a platform; the same system gives the same bytes."""

    @property
    def name(self) -> str:
        """The name of the output folder and of `--backend`."""

    def generate(self, system: System, options: BackendOptions) -> tuple[Artefact, ...]:
        """All files of the system, generated ones and first versions of the user's.

        Raises:
            Refused: it cannot do what the system needs.
        """


class Refused(Exception):
    """A backend cannot do what a system needs; it writes nothing then, not even a part."""

    def __init__(self, diagnostics: tuple[Diagnostic, ...]) -> None:
        super().__init__("; ".join(problem.message for problem in diagnostics))
        self.diagnostics = diagnostics


def message_modules(system: str) -> frozenset[str]:
    """The modules from which activities may import the messages of a system, whichever backend is played."""
    return frozenset(f"{name}.{system}.messages" for name in AGENTS)


class UnknownBackend(LookupError):
    """There is no backend of that name; `known` are those that there are."""

    def __init__(self, name: str, known: tuple[str, ...]) -> None:
        super().__init__(f"there is no backend {name}; there are {', '.join(known)}")
        self.known = known


def backend_names() -> tuple[str, ...]:
    """The names of all installed backends."""
    return tuple(sorted({*OWN, *(point.name for point in foreign_backends())}))


def foreign_backends() -> tuple[EntryPoint, ...]:
    """The backends that other packages offer, by name; none of them is called like one of ours."""
    from importlib.metadata import entry_points

    points = (point for point in entry_points(group=GROUP) if point.name not in OWN)
    return tuple(sorted(points, key=lambda point: point.name))


def find_backend(name: str) -> Backend:
    """The backend of that name.

    Raises:
        UnknownBackend: nothing installed offers it.
    """
    if name in OWN:
        return import_module(OWN[name]).BACKEND  # type: ignore[no-any-return]
    for point in foreign_backends():
        if point.name == name:
            return point.load()  # type: ignore[no-any-return]
    raise UnknownBackend(name, backend_names())
