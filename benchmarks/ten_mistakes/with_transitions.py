from transitions import Machine
from world import Ball, Phase, is_still


class Kicker:
    ball: Ball
    phase: Phase

    def is_close(self) -> bool:
        return self.ball.distance < 0.3 and self.phase == Phase.playing

    def is_far(self) -> bool:
        return self.ball.distance >= 0.3 or self.phase == Phase.idle

    def lies_still(self) -> bool:
        return is_still(self.ball.speed)


def machine() -> Kicker:
    model = Kicker()
    Machine(
        model,
        states=["search", "approach", "kick"],
        initial="search",
        transitions=[
            {"trigger": "done", "source": "search", "dest": "kick", "conditions": "is_close"},
            {"trigger": "done", "source": "search", "dest": "approach", "conditions": "is_far"},
            {"trigger": "done", "source": "approach", "dest": "search"},
            {"trigger": "whistle", "source": "approach", "dest": "search"},
            {"trigger": "done", "source": "kick", "dest": "search", "conditions": "lies_still"},
        ],
    )
    return model
