from typing import Any

from world import Phase, is_still
from xstate_statemachine import MachineLogic, create_machine

CONFIGURATION: dict[str, Any] = {
    "id": "kicker",
    "initial": "search",
    "states": {
        "search": {
            "on": {
                "done": [
                    {"target": "kick", "guard": "isClose"},
                    {"target": "approach", "guard": "isFar"},
                ]
            }
        },
        "approach": {"on": {"done": {"target": "search"}, "whistle": {"target": "search"}}},
        "kick": {"on": {"done": {"target": "search", "guard": "liesStill"}}},
    },
}


def is_close(context: dict[str, Any], event: Any) -> bool:
    return bool(event.payload["ball"].distance < 0.3 and event.payload["phase"] == Phase.playing)


def is_far(context: dict[str, Any], event: Any) -> bool:
    return bool(event.payload["ball"].distance >= 0.3 or event.payload["phase"] == Phase.idle)


def lies_still(context: dict[str, Any], event: Any) -> bool:
    return is_still(event.payload["ball"].speed)


def machine() -> Any:
    guards = {"isClose": is_close, "isFar": is_far, "liesStill": lies_still}
    return create_machine(CONFIGURATION, logic=MachineLogic(guards=guards))
