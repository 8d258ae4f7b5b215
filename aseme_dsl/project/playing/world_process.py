"""The process in which a project's simulated world passes, while its robots run in processes of their own.

`python -m aseme_dsl.project.playing.world_process` is started by `supervisor`, which writes two lines of JSON
to its standard input: what to simulate, and when all processes are ready the moment at which time begins.
When that input ends, so does the world. On standard output are lines of JSON, too: first the address of the
bodies, then the lines to print.
"""

from __future__ import annotations

import json
import os
import signal
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import IO, TYPE_CHECKING, TypedDict

if TYPE_CHECKING:
    from aseme_dsl.project.settings.configuration import Configuration


class Simulated(TypedDict):
    """The project to simulate, the function that makes its world, the key to its bodies; times are in ns."""

    project: str | None
    folder: str
    path: list[str]
    world: str
    seed: int
    duration: int | None
    key: str


def main() -> int:
    """Simulate; 1 if the project's functions fail."""
    from aseme_dsl.project.playing.play import PlayError
    from aseme_dsl.project.settings.configuration import Configuration, read_configuration
    from aseme_dsl.runtime.version.loading import importing

    lines, out = sys.stdin, _own_output()
    request: Simulated | None = json.loads(lines.readline() or "null")
    if request is None:
        return 1
    path = request["project"]
    configuration = read_configuration(Path(path))[0] if path else Configuration(Path(request["folder"]))
    try:
        with importing([configuration.folder.resolve(), *map(Path, request["path"])]):
            return _simulate(request, configuration, lines, out)
    except PlayError as problem:
        print(str(problem), file=sys.stderr)
        return 1


def _own_output() -> IO[str]:
    """Where our lines go; what the project prints goes to standard error instead."""
    out = os.fdopen(os.dup(1), "w", encoding="utf-8", buffering=1)
    os.dup2(2, 1)
    return out


def _simulate(request: Simulated, configuration: Configuration, lines: IO[str], out: IO[str]) -> int:
    from aseme_dsl.project.playing.play import LOOK_NS, Progress, call, made_world, users_mistakes
    from aseme_dsl.runtime.world.shared_world import WorldServer

    def tell(kind: str, text: str) -> None:
        out.write(json.dumps({kind: text}) + "\n")

    world = made_world(request["world"], request["seed"])
    project = configuration.run
    progress = Progress(world, project.progress if project else None, lambda text: tell("line", text))
    server = WorldServer(world, bytes.fromhex(request["key"]))
    tell("address", server.address)
    begin = json.loads(lines.readline() or "null")
    if begin is None:
        return 0
    stopped = _when_over(lines)
    until = request["duration"]
    following = 0

    def stop() -> bool:
        nonlocal following
        if world.now_ns >= following:
            following = world.now_ns + LOOK_NS
            progress.look(lambda: server.doing)
        over = getattr(world, "over", False) is True or (until is not None and world.now_ns >= until)
        return over or stopped()

    with users_mistakes():
        server.run(begin, stop)
    progress.look(lambda: server.doing)
    if project and project.summary:
        tell("line", str(call(project.summary, world)))
    tell("over", f"{world.now_ns}")
    if not stopped():
        # The robots have time to end the use of their bodies before the bodies vanish.
        deadline = time.monotonic() + 5
        while not stopped() and time.monotonic() < deadline:
            time.sleep(0.02)
    server.close()
    return 0


def _when_over(lines: IO[str]) -> Callable[[], bool]:
    """Whether the supervisor wants this process to end, or has ended itself."""
    over = threading.Event()

    def watch() -> None:
        lines.read()
        over.set()

    def handle(number: int, frame: FrameType | None) -> None:
        over.set()

    signal.signal(signal.SIGTERM, handle)
    signal.signal(signal.SIGINT, handle)
    threading.Thread(target=watch, daemon=True).start()
    return over.is_set


if __name__ == "__main__":
    sys.stdout.flush()
    code = main()
    sys.stderr.flush()
    os._exit(code)  # threads that serve bodies wait in calls that never end
