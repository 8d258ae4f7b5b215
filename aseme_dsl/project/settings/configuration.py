"""Configuration: what a project says about itself in `[tool.asemec]` of its pyproject.toml."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING, TypeGuard

from aseme_dsl import outside
from aseme_dsl.diagnostics import CODES, NO_POLICY, Diagnostic, Policy, Problem, Setting, Severity, closest
from aseme_dsl.diagnostics.problems import settings as problems
from aseme_dsl.diagnostics.problems.files import CannotBeRead, NotUtf8
from aseme_dsl.diagnostics.problems.settings import Fitting
from aseme_dsl.project.files.duration import duration
from aseme_dsl.project.settings.deployment import (
    Deployment,
    HostsOfFile,
    TlsFiles,
    hosts_of,
    network_mistakes,
    read_hosts,
)
from aseme_dsl.project.settings.platform_settings import PLATFORMS, MangoConfiguration, SpadeConfiguration
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.message.by_name import made
from aseme_dsl.runtime.time.clock import USUAL_LENGTH
from aseme_dsl.source import Source, Span

if TYPE_CHECKING:
    import tomllib

    from aseme_dsl.runtime.team.network import Network

FILE = "pyproject.toml"
TABLE = "tool.asemec"
RUN_TABLE = "tool.asemec.run"
OUTPUT = "out"
"""Where a build goes unless something else is said: beside the project's file, or where one works."""


@dataclass(frozen=True, slots=True)
class RunConfiguration:
    """How `asemec run` plays the project.

    `world`, `progress` and `summary` are functions, as `module:name`, found from the project's folder.
    """

    world: str | None = None
    """Called with `seed=…`; gives the `aseme_dsl.runtime.World` whose bodies the agents have. A world
    with a true attribute `over` ends the run."""
    progress: str | None = None
    """Called with the world, ten times a second; gives all there is to tell so far, as a sequence of lines.
    What is new is shown. A second argument, if it takes one, is what each agent is doing (`play.doing`)."""
    summary: str | None = None
    """Called with the world at the end; gives the closing words."""
    duration: int | None = None
    """How long is played, in ns of the run's own time."""
    seed: int | None = None
    trace: Path | None = None
    """Where the trace goes."""
    state: Path | None = None
    """Where `persist` states are kept from one run to the next."""
    network: Network | None = None
    """How bad the links between agents are in virtual time."""
    cancel_within: int | None = None
    """With the rest, what a run in real time asks of the machine: see `runtime.real_time.RealTime`."""
    threads: int | None = None
    processes: int | None = None
    process_memory: int | None = None
    queue: int | None = None
    conversation_limit: int | None = None
    switch_interval: int | None = None
    priority: int | None = None


@dataclass(frozen=True, slots=True)
class Configuration:
    """What a project chooses; None where it says nothing. Paths are as seen from the working directory."""

    folder: Path
    """The folder of the pyproject.toml, or where it was looked for if there is none."""
    path: Path | None = None
    files: tuple[Path, ...] = ()
    """What a command works on if nothing is named."""
    output: Path | None = None
    """Where a build goes: with a `[tool.asemec]` that does not say, `out` beside the pyproject.toml."""
    backends: tuple[str, ...] | None = None
    roles: Mapping[str, str] = field(default_factory=dict)
    """The backend of a role, where it is not the first of `backends`."""
    activities: Path | None = None
    templates: Path | None = None
    max_states: int | None = None
    labels: str | None = None
    expressions: str | None = None
    diagnostics: Policy = NO_POLICY
    run: RunConfiguration | None = None
    deploy: Deployment | None = None
    platform: str | None = None
    """What carries messages between agents in real time: one of `platforms.PLATFORMS`."""
    spade: SpadeConfiguration | None = None
    mango: MangoConfiguration | None = None

    @property
    def seed(self) -> int:
        """The seed of a run for which no other is given."""
        seed = self.run.seed if self.run is not None else None
        return 1 if seed is None else seed

    @property
    def length(self) -> int:
        """How long a run in virtual time takes (ns) for which nothing else is said."""
        return (self.run.duration if self.run is not None else None) or USUAL_LENGTH


def find_configuration(start: Path) -> tuple[Configuration, tuple[Diagnostic, ...]]:
    """The configuration of the project that `start` (a folder) is in: of the nearest pyproject.toml upwards.

    A pyproject.toml without `[tool.asemec]` counts, too: it ends the search, since the folders above are
    another project's. A table with mistakes gives a diagnostic for each, and the rest of what it says.
    """
    start = start if str(start) else Path()
    # `start / ..` rather than an absolute path: people are shown the way they came.
    folder = start
    for _ in range(len(start.absolute().resolve().parts)):
        if (folder / FILE).is_file():
            return read_configuration(folder / FILE)
        folder = folder.parent if folder.name not in ("", "..") else folder / ".."
    return Configuration(start), ()


def place_of(configuration: Configuration, key: str) -> Span | None:
    """Where the project's `[tool.asemec]` has a key."""
    if configuration.path is None:
        return None
    try:
        text = outside.read_bytes(configuration.path).decode("utf-8").replace("\r\n", "\n")
    except (OSError, UnicodeDecodeError):
        return None
    return _place(Source(str(configuration.path), text), TABLE, key)


def read_configuration(path: Path) -> tuple[Configuration, tuple[Diagnostic, ...]]:
    """The configuration in a pyproject.toml."""
    nothing = Configuration(path.parent, path)
    try:
        text = outside.read_bytes(path, _LARGEST).decode("utf-8")
    except OSError as problem:
        unread = CannotBeRead(str(path), problem.strerror or str(problem))
        return nothing, (Diagnostic(unread, None, path=str(path)),)
    except UnicodeDecodeError:
        return nothing, (Diagnostic(NotUtf8(str(path)), None, path=str(path)),)
    return configuration_of(Source(str(path), text.replace("\r\n", "\n")))


def configuration_of(source: Source) -> tuple[Configuration, tuple[Diagnostic, ...]]:
    """The configuration in the text of a pyproject.toml, which need not be on disk."""
    import tomllib

    path = Path(source.path)
    nothing = Configuration(path.parent, path)
    for number, line in enumerate(source.text.split("\n"), 1):
        # tomllib takes longer for each further part of a key, and for each of a key's parts again.
        if line.count(".") > _MOST_PARTS and any(
            part.count(".") > _MOST_PARTS for part in _KEY_ENDS.split(line)
        ):
            long = problems.TooManyPartsOfKey(source.path, number, _MOST_PARTS)
            return nothing, (Diagnostic(long, None, path=source.path),)
    try:
        document = tomllib.loads(source.text)
    except tomllib.TOMLDecodeError as problem:
        return nothing, (_malformed(source, problem),)
    except RecursionError:
        return nothing, (Diagnostic(problems.TomlTooDeep(source.path), None, path=source.path),)
    tool = document.get("tool")
    table = tool.get("asemec", {}) if isinstance(tool, dict) else {}
    reader = _Reader(source)
    given = reader.table(table, TABLE, _keys(path.parent))
    if isinstance(tool, dict) and "asemec" in tool:
        given.setdefault("output", path.parent / OUTPUT)
    deploy = given.get("deploy")
    for key, mistake in network_mistakes(deploy) if isinstance(deploy, Deployment) else ():
        reader.report(f"{TABLE}.deploy", key, mistake)
    # `_keys` gives each field what it has to be
    return made(Configuration, path.parent, path, **given), tuple(reader.diagnostics)


_LARGEST = 1 << 20
"""The largest pyproject.toml, in bytes."""
_MOST_PARTS = 200
"""So many parts a key may have (`a.b.c` has three)."""
_KEY_ENDS = re.compile("[=,{]")

_LEVELS = {**{str(severity): severity for severity in Severity}, "off": None}
"""What `[tool.asemec.diagnostics]` may say of a code."""


class _Wrong(ValueError):
    """A value that does not fit: `wanted` is what does, or all values that do; or `problem` says why."""

    def __init__(self, wanted: Fitting | tuple[str, ...] = (), problem: Problem | None = None) -> None:
        super().__init__()
        self.wanted = wanted
        self.problem = problem


_Convert = Callable[[object], object]


@dataclass(frozen=True, slots=True)
class _Policy:
    """Marks the table of severities; `folder` is what its patterns of paths are relative to."""

    folder: Path


@dataclass(frozen=True, slots=True)
class _Table:
    """A table inside: its keys, what is made of them, and which of them it cannot do without."""

    make: type[object]
    keys: Mapping[str, _Convert | _Table]
    needs: tuple[str, ...] = ()


def _is_path(value: object) -> TypeGuard[str]:
    return isinstance(value, str) and bool(value) and "\0" not in value


def _keys(folder: Path) -> dict[str, _Convert | _Table | _Policy]:
    """Every key of `[tool.asemec]`, with what makes a value of what is written there."""

    def path(value: object) -> Path:
        if not _is_path(value):
            raise _Wrong(Fitting.PATH)
        return folder / value

    def paths(value: object) -> tuple[Path, ...]:
        if not isinstance(value, list) or not all(map(_is_path, value)):
            raise _Wrong(Fitting.PATHS)
        return tuple(folder / item for item in value)

    def hosts(value: object) -> dict[str, str]:
        if not _is_path(value):
            return _hosts(value)
        return _hosts_in(folder / value)

    return {
        "files": paths,
        "output": path,
        "backends": _names,
        "roles": _roles,
        "activities": path,
        "templates": path,
        "max_states": _count,
        "labels": _one_of("plain", "original"),
        "expressions": _one_of("numbered", "inline", "none"),
        "diagnostics": _Policy(folder),
        "run": _Table(
            RunConfiguration,
            {
                "world": _function,
                "progress": _function,
                "summary": _function,
                "duration": _duration,
                "seed": _seed,
                "trace": path,
                "state": path,
                "network": _network,
                "cancel_within": _duration,
                "threads": _count,
                "processes": _count,
                "process_memory": _memory,
                "queue": _count,
                "conversation_limit": _count,
                "switch_interval": _duration,
                "priority": _count,
            },
        ),
        "platform": _one_of(*PLATFORMS),
        "spade": _Table(
            SpadeConfiguration,
            {
                "host": _host,
                "port": _port,
                "domain": _host,
                "account": _account,
                "password": path,
                "register": _flag,
                "verify": _flag,
                "authority": path,
            },
        ),
        "mango": _Table(MangoConfiguration, {"hosts": _hosts_with_ports}),
        "deploy": _Table(
            Deployment,
            {
                "hosts": hosts,
                "interface": _interface,
                "connect": _endpoints,
                "lease": _duration,
                "access": path,
                "control": path,
                "include": _names,
                "tls": _Table(
                    TlsFiles,
                    {"authority": path, "certificate": path, "key": path},
                    ("authority", "certificate", "key"),
                ),
            },
        ),
    }


def _names(value: object) -> tuple[str, ...]:
    if not isinstance(value, list) or not value or not all(isinstance(item, str) and item for item in value):
        raise _Wrong(Fitting.NAMES)
    return tuple(value)


def _roles(value: object) -> dict[str, str]:
    if not isinstance(value, dict) or not all(isinstance(name, str) and name for name in value.values()):
        raise _Wrong(Fitting.BACKENDS)
    return dict(value)


def unknown_roles(configuration: Configuration, roles: Iterable[str]) -> tuple[Diagnostic, ...]:
    """What the project says of roles that its system does not have (`roles`)."""
    known = list(roles)
    strangers = [name for name in configuration.roles if name not in known]
    if not strangers or configuration.path is None:
        return ()
    try:
        source = Source(str(configuration.path), outside.read_text(configuration.path).replace("\r\n", "\n"))
    except (OSError, UnicodeDecodeError):
        return ()
    found = []
    for name in strangers:
        near = closest(name, known)
        problem = problems.NoRoleForBackend(name, near, tuple(known))
        found.append(Diagnostic(problem, _place(source, f"{TABLE}.roles", name)))
    return tuple(found)


def places_of_run(configuration: Configuration, keys: Iterable[str]) -> dict[str, Span]:
    """Where the pyproject.toml gives these keys of its run; without what cannot be found any more."""
    if configuration.path is None:
        return {}
    try:
        source = Source(str(configuration.path), outside.read_text(configuration.path).replace("\r\n", "\n"))
    except (OSError, UnicodeDecodeError):
        return {}
    return {key: place for key in keys if (place := _place(source, RUN_TABLE, key)) is not None}


def _count(value: object) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or value < 1:
        raise _Wrong(Fitting.COUNT)
    return value


def _seed(value: object) -> int:
    if not isinstance(value, int) or isinstance(value, bool):
        raise _Wrong(Fitting.NUMBER)
    return value


def _function(value: object) -> str:
    if not isinstance(value, str) or not re.fullmatch(r"[\w.]+:\w+", value):
        raise _Wrong(Fitting.FUNCTION)
    return value


def _duration(value: object) -> int:
    try:
        nanoseconds = duration(value) if isinstance(value, str) else 0
    except ValueError:
        nanoseconds = 0
    if nanoseconds <= 0:
        raise _Wrong(Fitting.DURATION)
    return nanoseconds


def _network(value: object) -> Network:
    from aseme_dsl.grammar.text.network_words import NetworkWordsError, read_network

    if not isinstance(value, str):
        raise _Wrong(Fitting.NETWORK)
    try:
        return read_network(value)
    except NetworkWordsError as error:
        raise _Wrong(problem=error.problem) from error


def _memory(value: object) -> int:
    written = re.fullmatch(r"(\d+)\s*(MB|GB)", value) if isinstance(value, str) else None
    if written is None or int(written[1]) == 0:
        raise _Wrong(Fitting.MEMORY)
    return int(written[1]) * (1_000_000 if written[2] == "MB" else 1_000_000_000)


def _hosts(value: object) -> dict[str, str]:
    found = hosts_of(value)
    if found is None:
        raise _Wrong(Fitting.ADDRESSES)
    return found


def _hosts_in(path: Path) -> HostsOfFile:
    """The hosts in a file of their own."""
    try:
        return HostsOfFile(path, read_hosts(path))
    except ValueError as problem:
        raise _Wrong(problem=problems.HostsNotRead(str(path), str(problem))) from problem


def _hosts_with_ports(value: object) -> dict[str, str]:
    hosts = _hosts(value)
    if not all(re.search(r":\d{1,5}$", host) for host in hosts.values()):
        raise _Wrong(Fitting.ADDRESSES_WITH_PORTS)
    return hosts


def _host(value: object) -> str:
    if not isinstance(value, str) or not re.fullmatch(r"[\w.:-]+", value):
        raise _Wrong(Fitting.HOST)
    return value


def _port(value: object) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or not 0 < value < 65536:
        raise _Wrong(Fitting.PORT)
    return value


def _account(value: object) -> str:
    if not isinstance(value, str) or not re.fullmatch(r"[\w.-]*ROBOT[\w.-]*", value):
        raise _Wrong(Fitting.ACCOUNT)
    return value


def _flag(value: object) -> bool:
    if not isinstance(value, bool):
        raise _Wrong(Fitting.FLAG)
    return value


def _interface(value: object) -> str:
    if not isinstance(value, str) or not re.fullmatch(r"[\w.:-]+", value):
        raise _Wrong(Fitting.INTERFACE)
    return value


def _endpoints(value: object) -> tuple[str, ...]:
    if not isinstance(value, list) or not all(
        isinstance(item, str) and re.fullmatch(r"(tcp|tls|udp|quic)/\S+:\d{1,5}(#\S+)?", item)
        for item in value
    ):
        raise _Wrong(Fitting.ENDPOINTS)
    return tuple(value)


def _one_of(*choices: str) -> _Convert:
    def convert(value: object) -> str:
        if value not in choices:
            raise _Wrong(choices)
        return str(value)

    return convert


@dataclass(slots=True)
class _Reader:
    """Reads tables and collects what is wrong in them."""

    source: Source
    diagnostics: list[Diagnostic] = field(default_factory=list)

    def table(
        self, table: object, name: str, keys: Mapping[str, _Convert | _Table | _Policy]
    ) -> dict[str, object]:
        """The values of a table, converted; each mistake becomes a diagnostic and is left out."""
        if not isinstance(table, dict):
            self.report(name, None, problems.NotTable(name))
            return {}
        given: dict[str, object] = {}
        for key, value in table.items():
            convert = keys.get(key)
            if convert is None:
                self.report(name, key, _no_key(key, name, keys))
            elif isinstance(convert, _Policy):
                given[key] = Policy(tuple(self.settings(value, f"{name}.{key}", None)), convert.folder)
            elif isinstance(convert, _Table):
                if isinstance(value, dict):
                    inside = self.table(value, f"{name}.{key}", convert.keys)
                    missing = [other for other in convert.needs if other not in value]
                    if missing:
                        inner = f"{name}.{key}"
                        self.report(inner, None, problems.KeyMissing(missing[0], inner))
                    given[key] = made(convert.make, **inside)
                else:
                    self.report(name, key, problems.KeyNotTable(key, f"{name}.{key}"))
            else:
                try:
                    given[key] = convert(value)
                except _Wrong as wrong:
                    self.report(name, key, wrong.problem or problems.NotFitting(key, wrong.wanted))
        return given

    def settings(self, table: object, name: str, path: str | None) -> Iterator[Setting]:
        """`CODE = "severity"`, and tables of the same that are called like the pattern of a path."""
        if not isinstance(table, dict):
            around, _, key = name.rpartition(".")
            self.report(around, key, problems.KeyNotTable(key, name))
            return
        for key, value in table.items():
            if isinstance(value, dict) and path is None:
                yield from self.settings(value, f"{name}.{key}", key)
            elif not (key and any(code.startswith(key) for code in CODES)):
                near = closest(key, [*CODES, *(code[:2] for code in CODES)])
                self.report(name, key, problems.NoSuchDiagnostic(key, near))
            elif not isinstance(value, str) or value not in _LEVELS:
                self.report(name, key, problems.NotFitting(key, tuple(_LEVELS)))
            elif key.startswith("E") and value != "error":
                self.report(name, key, problems.ErrorTurnedDown(key))
            else:
                yield Setting(key, _LEVELS[value], path)

    def report(self, table: str, key: str | None, problem: Problem) -> None:
        """A problem where a key of a table is written, or (None) the table itself."""
        self.diagnostics.append(Diagnostic(problem, _place(self.source, table, key)))


def _no_key(key: str, table: str, keys: Mapping[str, _Convert | _Table | _Policy]) -> Problem:
    inside = [name for name, known in keys.items() if isinstance(known, _Table) and key in known.keys]
    return problems.NoKey(key, table, tuple(inside), closest(key, keys), tuple(keys))


def _place(source: Source, table: str, key: str | None) -> Span:
    """Where a key of a table is written, as well as lines can tell (the TOML parser keeps no places).

    Falls back on the header of the table, then on the first line.
    """
    current, best, start = "", Span(source, 0, len(source.line(1))), 0
    for line in source.text.split("\n"):
        header = re.match(r"\s*\[\s*([^\[\]]+?)\s*\]", line)
        if header is not None:
            current = re.sub(r"""[\s"']""", "", header[1])
            if current == table:
                best = Span(source, start + header.start(1), start + header.end(1))
            elif key is not None and current == f"{table}.{key}":
                return Span(source, start + header.start(1), start + header.end(1))
        elif key is not None:
            written = re.match(r"""\s*([\w."' -]+?)\s*=""", line)
            dotted = re.sub(r"""[\s"']""", "", written[1]) if written else ""
            full = f"{current}.{dotted}" if current else dotted
            if written and (full == f"{table}.{key}" or full.startswith(f"{table}.{key}.")):
                return Span(source, start + written.start(1), start + written.end(1))
        start += len(line) + 1
    return best


def _malformed(source: Source, problem: tomllib.TOMLDecodeError) -> Diagnostic:
    """What tomllib says, with the place that is in its text ("… (at line 3, column 5)")."""
    text = str(problem)
    where = re.search(r"\s*\(at (?:line (\d+), column (\d+)|end of document)\)", text)
    malformed = problems.InvalidToml(source.path, text[: where.start()] if where else text)
    if where is None or where[1] is None:
        start = max(len(source.text.rstrip()) - 1, 0)
        return Diagnostic(malformed, Span(source, start, start + 1))
    line, column = int(where[1]), int(where[2])
    start = sum(len(other) + 1 for other in source.text.split("\n")[: line - 1]) + column - 1
    start = min(start, len(source.text))
    return Diagnostic(malformed, Span(source, start, min(start + 1, len(source.text))))
