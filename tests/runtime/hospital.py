"""A hospital in which a robot rides in a lift while it delivers: one conversation inside another."""

from __future__ import annotations

from tests.runtime.playing import MS, Played

RIDE = """
system Hospital
enum Floor { GROUND WARD }
message Ride { Floor floor }
message Parcel { string id }
aip ride {
  participant passenger {
    given  destination : Floor
    result arrived : bool
    sends    request Ride
    receives inform Ride
    process  = Call . [StepOut]
  }
  participant lift {
    sends    inform Ride
    receives request Ride
    process  = Move . (Open | Stay)
  }
  control passenger {
    enter Call    : / send request Ride { floor = destination } to lift
    enter StepOut : inform Ride from lift / arrived = true
    skip  StepOut : lost lift
  }
  control lift {
    enter Move : request Ride from passenger
    enter Stay : lost passenger
    enter Open : else / send inform Ride { floor = Floor.WARD } to passenger
  }
}
srm cabin {
  plays ride.lift
  liveness { cabin = lift }
  activities { Move takes 3s  Open takes 1s  Stay takes 1s }
}
team T { ann : clerk  agv : porter  otis : cabin }
"""
"""All but the delivery: each test says what the porter and the clerk do."""

LATE = "enter Halt : after(1min)"


def starts(run: Played, agent: str) -> list[str]:
    return [
        f"{r['time'] // MS} {r['activity']}" for r in run.of("activity", agent=agent) if r["what"] == "start"
    ]


def ends(run: Played) -> list[str]:
    return [
        f"{r['time'] // MS} {r['agent']} {r['what']} {r['conversation']} {r.get('reason', '')}".strip()
        for r in run.of("conversation")
        if r["what"] in ("leave", "gone", "suspend", "resume")
    ]
