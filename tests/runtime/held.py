"""A run in which a message arrives while a step is held up, so that `read_messages` has something to show."""

from __future__ import annotations

import sys
import threading
import time
from pathlib import Path

from aseme_dsl.runtime.team.team import RunResult
from aseme_dsl.runtime.trace.trace import Record
from tests.runtime.playing import SECOND, make
from tests.support.generated import Generated, generate
from tests.support.waiting import LONG

MODULE = "holding"
"""What holds the step: the module of the function that the document calls."""


def play_held(folder: Path) -> tuple[Generated, RunResult, list[Record]]:
    """What was generated, and its run in real time; `folder` gets the module."""
    (folder / f"{MODULE}.py").write_text(
        "import threading\n"
        "inside, go = threading.Event(), threading.Event()\n"
        "def hold(n):\n    inside.set()\n    go.wait(180)\n    return n\n"
    )
    generated = generate(f"""
    system S
    message M {{ int n }}
    topic t {{ state M }}
    function hold(int n) : int = "{MODULE}:hold"
    srm R {{
      liveness {{ R = A . (B | C) }}
      activities {{ A takes 1ms  B takes 1ms  C takes 1ms }}
      control R {{
        enter (B | C) : / hold(1) ; read_messages
        enter B : [t.state.M.n == 5]
        enter C : else
      }}
    }}
    """)
    team, records = make(generated, {}, clock="real", until=60 * SECOND, path=[folder])

    def give() -> None:
        while not hasattr(sys.modules.get(MODULE), "hold"):  # a module is known before it is whole
            time.sleep(0.001)
        holding = sys.modules[MODULE]
        holding.inside.wait(LONG)
        team.bus.give(team.agents[0], "t.state.M", generated.message("M", n=5))
        holding.go.set()

    giver = threading.Thread(target=give)
    giver.start()
    result = team.run()
    giver.join()
    del sys.modules[MODULE]
    return generated, result, records
