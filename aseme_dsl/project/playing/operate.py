"""Operate: what runs from an output folder is asked and changed, in all its processes at once."""

from __future__ import annotations

import tempfile
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl import outside
from aseme_dsl.backends.backend import AGENTS
from aseme_dsl.diagnostics import closest
from aseme_dsl.project.building.build import Choice
from aseme_dsl.project.playing.remote import RemoteError, Robot
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.version.versions import VERSIONS

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System
    from aseme_dsl.runtime.control.replies import Reply
    from aseme_dsl.runtime.version.loading import Loaded

_ANSWER = 5.0
"""How long, in seconds, it is waited for the answer of a process."""
MOST_AT_ONCE = 64
"""So many processes are asked at the same time."""

Request = dict[str, object]
Endpoint = Path | Robot
"""The control socket of a process, or a robot that is reached over its network."""


class OperateError(Exception):
    """What was asked for cannot be done; the arguments say why, a line each."""


@dataclass(frozen=True, slots=True, eq=False)
class Node:
    """A process that runs agents, and what it says of itself."""

    socket: Endpoint
    status: Reply

    @property
    def agents(self) -> tuple[str, ...]:
        return tuple(str(agent["name"]) for agent in self.status.get("agents", ()))


def look(output: Path, robots: Sequence[Robot] | None = None) -> tuple[tuple[Node, ...], tuple[str, ...]]:
    """The processes that run from an output folder and answer, and why others do not.

    If there are `robots`, they are asked instead, over their network.

    Raises:
        OperateError: there is none.
    """
    found: Sequence[Endpoint] = running_from(output) if robots is None else robots
    replies = ask_each({path: {"request": "status"} for path in found})
    there = tuple(Node(path, reply) for path, reply in replies.items() if reply["ok"])
    return there, tuple(text for reply in replies.values() if not reply["ok"] for text in reply["reasons"])


def running_from(output: Path) -> Sequence[Path]:
    """The control sockets of what runs from an output folder.

    Raises:
        OperateError: nothing runs.
    """
    from aseme_dsl.runtime.control.control_socket import endpoints

    found = endpoints(output)
    if not found:
        raise OperateError(f"nothing runs from {output}: `asemec run … --real` does")
    return found


def nodes(output: Path, robots: Sequence[Robot] | None = None) -> tuple[Node, ...]:
    """The processes that run from an output folder.

    Raises:
        OperateError: there is none, or one does not answer.
    """
    there, silent = look(output, robots)
    if silent:
        raise OperateError(*silent)
    return there


def select(output: Path, agent: str, plan: str, robots: Sequence[Robot] | None = None) -> Reply:
    """Have an agent leave its plan and enter another.

    Raises:
        OperateError: there is no such agent, or it cannot.
    """
    there = nodes(output, None if robots is None else [r for r in robots if r.name == agent] or robots)
    node = next((node for node in there if agent in node.agents), None)
    if node is None:
        raise OperateError(unknown_agent(agent, there))
    request: Request = {"request": "select", "agent": agent, "plan": plan}
    return _ask_all({node.socket: request}, 10.0)[node.socket]


def unknown_agent(agent: str, there: Iterable[Node]) -> str:
    """Why an agent cannot be meant: who is meant instead, and who is there."""
    known = [name for node in there for name in node.agents]
    near = closest(agent, known)
    meant = f"did you mean {near}? " if near else ""
    return f"there is no agent {agent}; {meant}there are {', '.join(known)}"


def generate_version(system: System, output: Path, choice: Choice) -> tuple[Path, str]:
    """Write the package of a system with the first backend of agents: one under whose messages those of the
    others are found, too (see `loaded_for`). Gives its folder, and the hash of its models.

    Raises:
        OperateError: it cannot be written.
    """
    files, model = _packages(system, choice, AGENTS[:1])
    home = output / VERSIONS / model
    for name, content in files.items():
        _put(home / name, content)
    return home / next(iter(files)).split("/")[0] / system.name, model


@lru_cache(maxsize=1)  # all packages have the same module names, and activities import the newest
def loaded_for(package: Path, project: Path) -> Loaded:
    """The code of a generated package, for many runs of it in this process. Raises LoadError."""
    from aseme_dsl.runtime.version.loading import RoleBackends, load_system

    return load_system(package, path=[project], mixture=RoleBackends(names=AGENTS))


def write_version(system: System, output: Path, choice: Choice, activities: Path | None) -> tuple[str, str]:
    """Write a version that a running team can be changed to, with its activities; gives its hash and that of
    its models. No other user can write there.

    Raises:
        OperateError: it cannot be written.
    """
    from aseme_dsl.runtime.version.versions import ACTIVITIES, VersionError, hash_of, read_version

    files, model = _packages(system, choice, AGENTS)
    for path in sorted(activities.rglob("*")) if activities is not None and activities.is_dir() else ():
        inside = path.relative_to(str(activities))
        if path.is_file() and not any(part == "__pycache__" or part[0] == "." for part in inside.parts):
            try:
                files[f"{ACTIVITIES}/{inside.as_posix()}"] = outside.read_bytes(path)
            except OSError as problem:
                raise OperateError(f"{path} cannot be read: {problem.strerror or problem}") from problem
    name = hash_of(files)
    store = output / VERSIONS
    try:
        store.mkdir(mode=0o700, parents=True, exist_ok=True)
        if store.stat().st_mode & 0o077:
            store.chmod(0o700)
        if not (store / name).exists():
            part = Path(tempfile.mkdtemp(prefix=".part", dir=store))
            for inside_, content in files.items():
                path = part / inside_
                for around in reversed(path.relative_to(part).parents[:-1]):
                    (part / around).mkdir(mode=0o700, exist_ok=True)
                path.touch(mode=0o600)
                path.write_bytes(content)
            part.rename(store / name)
    except OSError as problem:
        raise OperateError(f"{store / name} cannot be written: {problem.strerror or problem}") from problem
    try:
        read_version(store, name)
    except VersionError as problem:
        raise OperateError(str(problem)) from problem
    return name, model


def activities_of(there: Iterable[Node]) -> Path | None:
    """The folder of activities with which processes were started.

    Raises:
        OperateError: there are several.
    """
    found = {node.status.get("activity_folder") for node in there} - {None}
    if len(found) > 1:
        raise OperateError("the processes have different folders of activities: say which with --activities")
    return Path(str(found.pop())) if found else None


def _packages(system: System, choice: Choice, backends: Sequence[str]) -> tuple[dict[str, bytes], str]:
    """The generated files of a version by their paths in it, and the hash of its models."""
    from aseme_dsl.backends.backend import BackendOptions, find_backend
    from aseme_dsl.project.building.build import with_labels

    labelled = with_labels(system, choice.labels)
    options = BackendOptions(choice.templates)
    artefacts = [(name, item) for name in backends for item in find_backend(name).generate(labelled, options)]
    package = next(item.text for _, item in artefacts if item.path == f"{system.name}/__init__.py")
    model = next(line for line in package.splitlines() if line.startswith("MODEL = ")).split("'")[1]
    texts = {f"{name}/{item.path}": item.text for name, item in artefacts if not item.kept}
    return {path: text.encode("utf-8", "backslashreplace") for path, text in texts.items()}, model


def _put(path: Path, content: bytes) -> None:
    """Write a file that may be there already. Raises OperateError."""
    try:
        if outside.holds(path, content):
            return
        path.parent.mkdir(parents=True, exist_ok=True)
        part = path.with_name(path.name + ".part")
        part.write_bytes(content)
        part.replace(path)
    except OSError as problem:
        raise OperateError(f"{path} cannot be written: {problem.strerror or problem}") from problem


def _ask_all(requests: Mapping[Endpoint, Request], timeout: float) -> dict[Endpoint, Reply]:
    """The replies. Raises OperateError with all the reasons, if one is a refusal or does not come."""
    replies = ask_each(requests, timeout)
    problems = [text for reply in replies.values() if not reply["ok"] for text in reply["reasons"]]
    if problems:
        raise OperateError(*dict.fromkeys(problems))
    return replies


def ask_each(requests: Mapping[Endpoint, Request], timeout: float = _ANSWER) -> dict[Endpoint, Reply]:
    """The replies; who does not answer is taken to refuse."""
    from aseme_dsl.runtime.control.control_socket import ControlError, ask

    def one(endpoint: Endpoint) -> Reply:
        try:
            if isinstance(endpoint, Robot):
                return endpoint.ask(requests[endpoint], timeout)
            return ask(endpoint, requests[endpoint], timeout)
        except (ControlError, RemoteError) as problem:
            return {"ok": False, "reasons": [str(problem)]}

    if not requests:
        return {}
    with ThreadPoolExecutor(min(len(requests), MOST_AT_ONCE)) as pool:
        return dict(zip(requests, pool.map(one, requests), strict=True))
