from statemachine import State, StateMachine
from world import Ball, Phase, is_still


class Kicker(StateMachine):
    search = State(initial=True)
    choose = State()
    approach = State()
    kick = State()

    ball: Ball
    phase: Phase

    done = search.to(choose) | approach.to(search) | kick.to(search, cond="lies_still")
    whistle = approach.to(search)
    go = choose.to(kick, cond="is_close") | choose.to(approach, cond="is_far")

    def is_close(self) -> bool:
        return self.ball.distance < 0.3 and self.phase == Phase.playing

    def is_far(self) -> bool:
        return self.ball.distance >= 0.3 or self.phase == Phase.idle

    def lies_still(self) -> bool:
        return is_still(self.ball.speed)

    def on_enter_choose(self) -> None:
        self.go()
