"""Data stores: each behaviour has one of its own, and behaviours share one that they are given."""

from __future__ import annotations

from typing import Any

import pytest

from aseme_dsl.backends.jade_like import BACKEND
from aseme_dsl.runtime.jade import DataStore, FSMBehaviour, OneShotBehaviour, SequentialBehaviour
from tests.runtime.callbacks import behaviour, kitchen, logs
from tests.runtime.playing import SECOND, Played, play
from tests.support.generated import Generated, generate

ONE = """\
system One
srm one {
  liveness { one = Live . End }
  activities { Live takes 1s  End takes 1s }
}
team One { ann : one }
"""


@pytest.fixture(scope="module")
def one() -> Generated:
    return generate(ONE, backend=BACKEND)


def ran(made: Generated, setup: Any) -> Played:
    generated: Any = made.package.AGENTS["one"]
    kind = type(generated.own, (generated,), {"setup": setup})
    return play(made, {generated.own: kind}, until=5 * SECOND)


class Put(OneShotBehaviour):
    def __init__(self, value: str) -> None:
        self.value = value

    def action(self) -> None:
        self.data_store["found"] = self.value


class Get(OneShotBehaviour):
    def action(self) -> None:
        self.log(f"{self.data_store.get('found')}")


def test_each_behaviour_has_a_store_of_its_own(one: Generated) -> None:
    def setup(agent: Any) -> None:
        around = SequentialBehaviour()
        around.add_sub_behaviour(Put("tea"))
        around.add_sub_behaviour(Get())
        agent.add_behaviour(around)

    assert logs(ran(one, setup)) == ["0 None"]


def test_behaviours_of_an_fsm_share_a_store(one: Generated) -> None:
    def setup(agent: Any) -> None:
        machine = FSMBehaviour()
        for number, (name, inside) in enumerate({"put": Put("tea"), "get": Get()}.items()):
            inside.data_store = machine.data_store
            (machine.register_last_state if number else machine.register_first_state)(inside, name)
        machine.register_default_transition("put", "get")
        agent.add_behaviour(machine)

    assert logs(ran(one, setup)) == ["0 tea"]


def test_what_is_no_data_store_is_refused() -> None:
    with pytest.raises(TypeError, match=r"a data store is a DataStore, not .*found"):
        Get().data_store = {"found": 1}  # type: ignore[assignment]


def test_a_participant_shares_a_store_with_an_added_behaviour() -> None:
    made = kitchen("request", "initiator", "responder")
    store = DataStore()

    def start(self: Any) -> None:
        self.data_store = store

    def order(self: Any) -> Any:
        return made.messages.Order(id="1", what=self.data_store["found"])

    kinds = behaviour(made, "boss", "Initiator", on_start=start, prepare_requests=order)
    (kind,) = kinds.values()
    use = kind.setup  # type: ignore[attr-defined]

    def setup(agent: Any) -> None:
        store["found"] = "soup"
        getting = Get()
        getting.data_store = store
        agent.add_behaviour(getting)
        use(agent)

    kind.setup = setup  # type: ignore[attr-defined]
    played = play(made, kinds, until=5 * SECOND)
    assert logs(played) == ["0 soup"]
    assert played.of("agent_message")[0]["content"] == {"id": "1", "what": "soup"}
