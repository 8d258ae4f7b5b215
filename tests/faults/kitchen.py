"""A cook that is called away in the middle of a conversation, step by step as a test wants it.

An activity that has a gate lasts until the test opens it: the same code in one process, over a platform, and
in a robot's own process.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from aseme_dsl.runtime import Context

TEXT = """
system Kitchen
message Order  { string id }
message Meal   { string id }
message Reason { string why }

aip serving {
  participant waiter {
    sends    request Order, cancel Order
    receives inform Meal, failure Reason
    process  = Ask . Hurry . (Serve | Sorry | Gone)
  }
  participant cook {
    sends    inform Meal, failure Reason
    receives request Order, cancel Order
    process  = Cook . Ring . Bow
  }
  control waiter {
    enter Ask   : / send request Order { id = "1" } to cook
    enter Hurry : / send cancel Order { id = "1" } to cook
    enter Serve : inform Meal from cook
    enter Sorry : failure Reason from cook
    enter Gone  : lost cook
  }
  control cook {
    enter Cook : request Order from waiter
    enter Ring : / send inform Meal { id = "1" } to waiter
    enter Bow  : cancel Order from waiter
    on abandon : / send failure Reason { why = "left" } to waiter
  }
}

srm human {
  plays serving.waiter
  liveness { human = waiter . Home }
  activities {
    Ask
    Hurry takes 10ms simulated   Serve takes 10ms simulated
    Sorry takes 10ms simulated   Gone takes 10ms simulated
    Home takes 60min simulated
  }
}

srm robot {
  plays serving.cook
  var stop : bool = false
  var charged : bool = false
  liveness {
    robot = day || Clock
    day   = (shift [> Charge)~
    shift = cook . Sweep
  }
  activities {
    Clock writes stop
    Cook
    Charge
    Ring takes 10ms simulated   Bow takes 10ms simulated
    Sweep takes 60min simulated
  }
  control day {
    enter Charge : when [stop && !charged] / charged = true
    resume shift :
  }
}

team Kitchen { ann : human  bob : robot }
"""
"""The cook goes on where it was."""
DISCARDING = TEXT.replace("resume shift :", "resume shift : [!charged]\n    enter shift  : else")
"""The cook forgets what it was at, once it has left it."""
GATES = ("Ask", "Clock", "Cook", "Charge")
NAMES = ("ann", "bob")


@dataclass(frozen=True)
class Gates:
    """What the test has let go on: an empty file each."""

    folder: Path

    def open(self, *activities: str) -> None:
        for activity in activities:
            (self.folder / activity).touch()

    def activity(self, name: str) -> type[Any]:
        """The class of an activity that lasts until its gate is open."""
        gate = self.folder / name

        class Gated:
            def execute(self, context: Context) -> None:
                while not gate.exists():
                    context.wait(0.02)
                if name == "Clock":
                    context.set_variable("stop", True)

        return Gated

    def activities(self) -> dict[str, type[Any]]:
        return {name: self.activity(name) for name in GATES}
