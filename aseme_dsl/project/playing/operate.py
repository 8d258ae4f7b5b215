"""Operate: what runs from an output folder is asked and changed, in all its processes at once."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

from aseme_dsl import outside
from aseme_dsl.diagnostics import closest
from aseme_dsl.project.building.build import Choice
from aseme_dsl.project.playing.remote import RemoteError, Robot
from aseme_dsl.records import dataclass
from aseme_dsl.runtime.version.versions import VERSIONS

if TYPE_CHECKING:
    from aseme_dsl.amola.system import System
    from aseme_dsl.runtime.control.replies import Reply
    from aseme_dsl.runtime.version.loading import Loaded

WITHIN = 10.0
"""How long, in seconds, a swap waits for conversations to end."""
_ANSWER = 5.0
"""How long, in seconds, it is waited for the answer of a process."""
MOST_AT_ONCE = 64
"""So many processes are asked at the same time."""
_HOLD = 3.0
_TRY = 0.3
_PAUSE = 0.05

Request = dict[str, object]
Endpoint = Path | Robot
"""The control socket of a process, or a robot that is reached over its network."""


class OperateError(Exception):
    """What was asked for cannot be done; the arguments say why, a line each."""


class PartlyDone(OperateError):
    """Some robots have changed, and others have not, or do not say so; the arguments say which."""


@dataclass(frozen=True, slots=True)
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
    """Write the packages of a system beside those that run, for agents of every backend; gives the folder of
    one of them and the hash of its models.

    Raises:
        OperateError: it cannot be written.
    """
    files, model = _packages(system, choice)
    home = output / VERSIONS / model
    for name, content in files.items():
        _put(home / name, content)
    return home / next(iter(files)).split("/")[0] / system.name, model


@lru_cache(maxsize=1)  # all packages have the same module names, and activities import the newest
def loaded_for(package: Path, project: Path) -> Loaded:
    """The code of a generated package, for many runs of it in this process. Raises LoadError."""
    from aseme_dsl.backends.backend import AGENTS
    from aseme_dsl.runtime.version.loading import RoleBackends, load_system

    return load_system(package, path=[project], mixture=RoleBackends(names=AGENTS))


def write_version(system: System, output: Path, choice: Choice, activities: Path | None) -> tuple[str, str]:
    """Write a version that a running team can be changed to, with its activities; gives its hash and that of
    its models. No other user can write there.

    Raises:
        OperateError: it cannot be written.
    """
    from aseme_dsl.runtime.version.versions import ACTIVITIES, VersionError, hash_of, read_version

    files, model = _packages(system, choice)
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


def _packages(system: System, choice: Choice) -> tuple[dict[str, bytes], str]:
    """The generated files of a version by their paths in it, and the hash of its models."""
    from aseme_dsl.backends.backend import AGENTS, BackendOptions, find_backend
    from aseme_dsl.project.building.build import with_labels

    labelled = with_labels(system, choice.labels)
    options = BackendOptions(choice.templates)
    artefacts = [(name, item) for name in AGENTS for item in find_backend(name).generate(labelled, options)]
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


def swap(
    output: Path,
    name: str,
    *,
    within: float = WITHIN,
    agents: Iterable[str] | None = None,
    robots: Sequence[Robot] | None = None,
) -> tuple[Reply, ...]:
    """Change what runs to the version of this hash, in all processes or in none.

    `within` is how long, in seconds, it is waited for conversations that the new version plays differently.
    Gives what the processes have said.

    Raises:
        OperateError: one of them cannot, or did not confirm; they all continue as before.
        PartlyDone: some have changed.
    """
    names = None if agents is None else list(agents)
    there = nodes(output, robots)
    concerned = [node for node in there if names is None or set(node.agents) & set(names)]
    missing = [name for name in names or () if not any(name in node.agents for node in there)]
    if missing:
        raise OperateError(unknown_agent(missing[0], there))
    request: Request = {
        "request": "swap",
        "hash": name,
        "agents": names,
    }
    sockets = [node.socket for node in concerned]
    deadline = time.monotonic() + within
    while True:
        busy, notes = _prepare(sockets, request)
        if not busy:
            return notes
        if time.monotonic() >= deadline:
            reasons = [f"{reason} after {within:g} s" for reason in busy]
            ask_each({path: {**request, "phase": "refuse", "reasons": reasons} for path in sockets})
            raise OperateError(*reasons)
        time.sleep(_PAUSE)


def _prepare(sockets: list[Endpoint], request: Request) -> tuple[list[str], tuple[Reply, ...]]:
    """One attempt; gives the reasons why processes are busy, if there are any, and the replies."""
    replies = _ask_all({path: {**request, "phase": "ready"} for path in sockets}, 30.0)
    busy = [reason for reply in replies.values() for reason in reply["reasons"]]
    if busy:
        return busy, ()
    prepare = {**request, "phase": "prepare", "within": _TRY, "hold": _HOLD}
    outcome = ask_each({path: prepare for path in sockets}, 30.0)
    held = {path: reply["id"] for path, reply in outcome.items() if reply.get("state") == "prepared"}
    problems = [reason for reply in outcome.values() if not reply["ok"] for reason in reply["reasons"]]
    busy = [reason for reply in outcome.values() if reply["ok"] for reason in reply["reasons"]]
    if problems or busy:
        _roll_back(held, "; ".join(problems or busy))
        if problems:
            raise OperateError(*problems)
        return busy, ()
    for phase in ("commit", "finish"):
        replies = ask_each({path: {"request": "swap", "phase": phase, "id": n} for path, n in held.items()})
        problems = [reason for reply in replies.values() if not reply["ok"] for reason in reply["reasons"]]
        if problems and phase == "commit":
            back = _roll_back(held, "; ".join(problems))
            if back:  # who has confirmed, and does not hear this, changes when the time is over
                raise PartlyDone(*problems, *back, *_models(held))
            raise OperateError(*problems)
        if problems:  # it has been confirmed everywhere: who has not finished does so by itself
            raise PartlyDone(*problems, *_models(held))
    return [], tuple(outcome.values())


def _models(concerned: Iterable[Endpoint]) -> list[str]:
    """Which robot follows which model, when those that are on their own have decided."""
    time.sleep(_HOLD)
    lines: list[str] = []
    for endpoint, reply in ask_each({endpoint: {"request": "status"} for endpoint in concerned}).items():
        agents = reply.get("agents", ()) if reply["ok"] else ()
        lines += [f"{agent['name']} follows model {agent['model']}" for agent in agents]
        if not reply["ok"]:
            lines.append(f"what {endpoint} follows is not known")
    return lines


def _roll_back(held: Mapping[Endpoint, int], reason: str) -> list[str]:
    """Let all processes continue as before; gives a line for each that did not confirm it."""
    requests: dict[Endpoint, Request] = {
        path: {"request": "swap", "phase": "rollback", "id": number, "reason": reason}
        for path, number in held.items()
    }
    return [
        f"it is not known whether it was rolled back: {text}"
        for reply in ask_each(requests).values()
        if not reply["ok"]
        for text in reply["reasons"]
    ]


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
