"""A small team in the language, for the tests of all drawings."""

from __future__ import annotations

import aseme_dsl
from aseme_dsl.amola.system import System
from aseme_dsl.source import Source

TEAM = """\
system Team

message Ball { bool visible  double distance  double bearing }
message Pass { int to }

topic vision { state Ball }
topic team   { signal Pass }

sag {
  actor player {
    goal score  depends on player "The ball is in the opponents' goal."
    goal defend
  }
  actor goalie {
    goal guard depends on player, goalie
  }
}

suc {
  role center, center_for : abstract
  usecase score  includes attack
  usecase attack by center, center_for  includes walk_to_ball, pass_ball, kick_ball
}

aip attack {
  participant center {
    engage  "This robot is the closest to the ball."
    var tries : int = 0
    process = WalkToBall . [PassBall]
  }
  participant center_for [1..*] {
    engage  "This robot is not the closest."
    process = WalkToGoal . [Receive . KickBall]
  }
  outcome "A shot to goal."
  outcome "The ball is lost."
  clause at most one center

  let can_pass = vision.state.Ball.distance < 6 && vision.state.Ball.visible

  control center {
    enter PassBall : [can_pass] / write_messages.team.signal.Pass
    skip  PassBall : else
  }
  control center_for {
    enter (Receive . KickBall) : [has(team.signal.Pass)]
    skip  (Receive . KickBall) : after(5s)
  }
}

srm player {
  plays attack.center
  plays attack.center_for with WalkToGoal = WalkToTheirGoal
  var limit : int = 80
  liveness {
    player = Vision~ || (play | Wait)+
    play   = Search | center | center_for
  }
  activities {
    Vision every 33ms takes 20ms uses camera writes vision.state.Ball
    Search reads vision.state.Ball
  }
  functionality camera {
    technology "OpenCV"
  }
  control player {
    enter play : [vision.state.Ball.visible]
    enter Wait : else
    repeat (play | Wait) : [limit > 0]
    leave  (play | Wait) : else
  }
  control play {
    enter Search     : [!vision.state.Ball.visible]
    enter center     : [vision.state.Ball.distance < 10]
    enter center_for : else
  }
}

srm goalie {
  liveness { goalie = Guard~ }
}
"""


def compiled(text: str) -> System:
    """The system of a text that must compile."""
    return aseme_dsl.compile(Source("team.aseme", text))
