"""Plays one peer's behaviour through the match of `world.py`: `python drive.py PEER FILE`.

Run with a Python that has the peer; prints what differs from what is right, or `ok`.
"""

from __future__ import annotations

import asyncio
import importlib.util
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import world

Play = Callable[[str, world.Ball, world.Phase], str]
"""Give an event with what is seen; the state afterwards."""


def _module(path: Path) -> Any:
    spec = importlib.util.spec_from_file_location("behaviour", path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["behaviour"] = module
    spec.loader.exec_module(module)
    return module


def sismic(path: Path) -> Play:
    """Sismic: the chart is YAML, guards are Python texts in it."""
    from sismic.interpreter import Interpreter
    from sismic.io import import_from_yaml

    context = {
        "Phase": world.Phase,
        "Side": world.Side,
        "is_still": world.is_still,
        "ball": None,
        "phase": None,
    }
    chart = Interpreter(import_from_yaml(filepath=str(path)), initial_context=context)
    chart.execute()

    def play(event: str, ball: world.Ball, phase: world.Phase) -> str:
        chart.context.update(ball=ball, phase=phase)
        chart.queue(event).execute()
        return str(chart.configuration[-1])

    return play


def python_statemachine(path: Path) -> Play:
    """python-statemachine: the chart is a Python class."""
    chart = _module(path).Kicker()

    def play(event: str, ball: world.Ball, phase: world.Phase) -> str:
        chart.ball, chart.phase = ball, phase
        chart.send(event)
        return str(next(iter(chart.configuration)).id)

    return play


def transitions(path: Path) -> Play:
    """transitions: the chart is a list of dicts."""
    model = _module(path).machine()

    def play(event: str, ball: world.Ball, phase: world.Phase) -> str:
        model.ball, model.phase = ball, phase
        model.trigger(event)
        return str(model.state)

    return play


def xstate_statemachine(path: Path) -> Play:
    """xstate-statemachine: the chart is XState's JSON, guards are Python functions."""
    from xstate_statemachine import Interpreter

    loop = asyncio.new_event_loop()
    chart = Interpreter(_module(path).machine())
    loop.run_until_complete(chart.start())

    def play(event: str, ball: world.Ball, phase: world.Phase) -> str:
        async def send() -> None:
            await chart.send(event, ball=ball, phase=phase)
            await asyncio.sleep(0.02)

        loop.run_until_complete(send())
        return str(sorted(chart.current_state_ids)[-1]).rpartition(".")[2]

    return play


def main(peer: str, path: Path) -> None:
    """Load, play, compare."""
    loaders: dict[str, Callable[[Path], Play]] = {
        "sismic": sismic,
        "python-statemachine": python_statemachine,
        "transitions": transitions,
        "xstate-statemachine": xstate_statemachine,
    }
    try:
        play = loaders[peer](path)
    except Exception as error:
        print(f"when loaded: {type(error).__name__}: {_line(error)}")
        return
    for number, (event, ball, phase, right) in enumerate(world.DRIVE, 1):
        try:
            state = play(event, ball, phase)
        except Exception as error:
            print(f"at event {number}: {type(error).__name__}: {_line(error)}")
            return
        if state != right:
            print(f"nothing; after event {number} it is in `{state}`, not in `{right}`")
            return
    print("nothing; no difference in this match")


def _line(error: Exception) -> str:
    return " ".join(str(error).split())


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
