"""FIPA callbacks: methods of a participant's behaviour hear of messages, and are the library's activities."""

from __future__ import annotations

import re
from typing import Any

import pytest

from aseme_dsl.backends.jade_like import BACKEND
from aseme_dsl.runtime.agent.fipa_callbacks import CALLBACKS
from aseme_dsl.runtime.jade import FailureException, RefuseException
from aseme_dsl.standard_library import standard_library
from tests.runtime.callbacks import behaviour, heard, kitchen, logs, messages
from tests.runtime.playing import SECOND, Played, play
from tests.support.generated import Generated, generate


@pytest.fixture(scope="module")
def request_() -> Generated:
    return kitchen("request", "initiator", "responder")


@pytest.fixture(scope="module")
def contract_net() -> Generated:
    return kitchen("contract_net", "manager", "contractor")


HEARS = {
    name: heard(name)
    for name in (
        "handle_agree",
        "handle_refuse",
        "handle_inform",
        "handle_failure",
        "handle_all_responses",
        "handle_all_result_notifications",
    )
}

HEARS_OF_OFFERS = {name: method for name, method in HEARS.items() if name != "handle_agree"}


def order(made: Generated) -> Any:
    def prepare_requests(self: Any) -> Any:
        self.set_variable("asked", "bob")
        return made.messages.Order(id="1", what="soup")

    return prepare_requests


def asked(request_: Generated, **cook: Any) -> Played:
    found = behaviour(request_, "boss", "Initiator", prepare_requests=order(request_), **HEARS)
    return play(request_, {**found, **behaviour(request_, "cook", "Responder", **cook)}, until=100 * SECOND)


def test_a_request_with_callbacks_alone(request_: Generated) -> None:
    def prepare_result_notification(self: Any, request: Any) -> Any:
        yield 3
        return request_.messages.Outcome(id=request.content.id, detail="hot")

    played = asked(
        request_,
        handle_request=lambda self, request: request.content.what == "soup",
        prepare_result_notification=prepare_result_notification,
    )
    assert messages(played) == ["0 ann request Order", "0 bob agree Order", "3 bob inform Outcome"]
    assert played.of("agent_message")[-1]["content"] == {"id": "1", "detail": "hot"}
    assert logs(played) == [
        "0 handle_agree: agree of bob",
        "0 handle_all_responses: agree of bob",
        "3 handle_inform: inform of bob",
        "3 handle_all_result_notifications: inform of bob",
    ]
    assert not played.of("fault")


@pytest.mark.parametrize("how", ["false", "raises", "nothing"])
def test_a_request_is_refused(request_: Generated, how: str) -> None:
    def handle_request(self: Any, request: Any) -> Any:
        if how == "raises":
            raise RefuseException("busy")
        return False if how == "false" else None

    played = asked(request_, handle_request=handle_request)
    assert messages(played) == ["0 ann request Order", "0 bob refuse Order"]
    assert logs(played) == [
        "0 handle_refuse: refuse of bob",
        "0 handle_all_responses: refuse of bob",
        "0 handle_all_result_notifications: ",
    ]


@pytest.mark.parametrize("says", [True, False])
def test_a_request_fails(request_: Generated, says: bool) -> None:
    def prepare_result_notification(self: Any, request: Any) -> Any:
        if says:
            raise FailureException(request_.messages.Outcome(id="1", detail="burnt"))
        raise FailureException

    played = asked(
        request_,
        handle_request=lambda self, request: True,
        prepare_result_notification=prepare_result_notification,
    )
    assert messages(played)[-1] == "0 bob failure Outcome"
    assert played.of("agent_message")[-1]["content"]["detail"] == ("burnt" if says else "")  # type: ignore[index]
    assert logs(played)[-2:] == [
        "0 handle_failure: failure of bob",
        "0 handle_all_result_notifications: failure of bob",
    ]


def test_a_contract_net_with_callbacks_alone(contract_net: Generated) -> None:
    made = contract_net.messages

    def handle_cfp(self: Any, cfp: Any) -> Any:
        return made.Proposal(job=cfp.content.id, cost=10.0 if self.agent.name == "bob" else 8.0)

    def handle_accept_proposal(self: Any, accept: Any) -> Any:
        yield 5
        return made.Outcome(id=accept.content.job, detail="cake")

    played = play(
        contract_net,
        {
            **behaviour(
                contract_net,
                "boss",
                "Manager",
                reply_within=2,
                prepare_cfps=lambda self: made.Job(id="7", what="cake"),
                handle_propose=heard("handle_propose"),
                **HEARS_OF_OFFERS,
            ),
            **behaviour(
                contract_net,
                "cook",
                "Contractor",
                handle_cfp=handle_cfp,
                handle_accept_proposal=handle_accept_proposal,
                handle_reject_proposal=heard("handle_reject_proposal"),
            ),
        },
        until=100 * SECOND,
    )
    assert logs(played)[:2] == ["0 handle_propose: propose of bob", "0 handle_propose: propose of cid"]
    assert [line.partition(" ")[2] for line in logs(played)[2:]] == [
        "handle_all_responses: propose of bob, propose of cid",
        "handle_inform: inform of cid",
        "handle_all_result_notifications: inform of cid",
    ]
    assert [line.partition(" ")[2] for line in logs(played, "bob")] == [
        "handle_reject_proposal: reject_proposal of ann"
    ]
    assert not played.of("fault")
    assert played.of("agent_message", performative="accept_proposal")[0]["to"] == ["cid"]


def test_nobody_proposes(contract_net: Generated) -> None:
    made = contract_net.messages
    played = play(
        contract_net,
        {
            **behaviour(
                contract_net,
                "boss",
                "Manager",
                prepare_cfps=lambda self: made.Job(id="7", what="cake"),
                **HEARS_OF_OFFERS,
            ),
            **behaviour(contract_net, "cook", "Contractor", handle_cfp=lambda self, cfp: None),
        },
        until=100 * SECOND,
    )
    assert [line.partition(" ")[2] for line in logs(played)] == [
        "handle_refuse: refuse of bob",
        "handle_refuse: refuse of cid",
        "handle_all_responses: refuse of bob, refuse of cid",
        "handle_all_result_notifications: ",
    ]


@pytest.mark.parametrize(
    ("chosen", "accepted", "rejected"),
    [
        (None, ["cid"], ["bob"]),
        (["bob"], ["bob"], ["cid"]),
        (("bob", "cid"), ["bob", "cid"], []),
        ([], [], ["bob", "cid"]),
    ],
)
def test_all_responses_may_choose_who_is_accepted(
    contract_net: Generated, chosen: Any, accepted: list[str], rejected: list[str]
) -> None:
    played = awarded(contract_net, chosen)
    assert _receivers(played, "accept_proposal") == accepted
    assert _receivers(played, "reject_proposal") == rejected
    assert not played.of("fault")
    assert not played.of("activity", what="crash")


def test_whoever_has_not_proposed_is_not_chosen(contract_net: Generated) -> None:
    played = awarded(contract_net, ["eve"])
    (crash,) = played.of("activity", what="crash")
    assert "handle_all_responses of Manager returned 'eve': it returns the agents to accept" in str(
        crash["reason"]
    )


def awarded(contract_net: Generated, chosen: Any) -> Played:
    made = contract_net.messages
    manager = behaviour(
        contract_net,
        "boss",
        "Manager",
        prepare_cfps=lambda self: made.Job(id="7", what="cake"),
        handle_all_responses=lambda self, responses: chosen,
    )
    cook = behaviour(
        contract_net,
        "cook",
        "Contractor",
        handle_cfp=lambda self, cfp: made.Proposal(job="7", cost=10 if self.agent.name == "bob" else 8),
        handle_accept_proposal=lambda self, accept: made.Outcome(id="7", detail="cake"),
    )
    return play(contract_net, {**manager, **cook}, until=100 * SECOND)


def _receivers(played: Played, performative: str) -> list[str]:
    return [
        name
        for record in played.of("agent_message", performative=performative)
        for name in record["to"]  # type: ignore[attr-defined]
    ]


# ---- any protocol --------------------------------------------------------------------------------

TALK = """\
system Talk
message Order { string what }
aip cooking {
  participant guest {
    sends    request Order
    receives inform Order, refuse Order
    process  = Ask . (Eat | Leave)
  }
  participant cook {
    var fresh : bool = false
    sends    inform Order, refuse Order
    receives request Order
    process  = Look . (Cook | Sorry)
  }
  control guest {
    enter Ask   : / send request Order { what = "soup" } to cook
    enter Eat   : inform Order from cook
    enter Leave : refuse Order from cook
  }
  control cook {
    enter Look  : request Order from guest
    enter Cook  : [fresh]
    enter Sorry : else / send refuse Order to guest
    leave Cook  : / send inform Order to guest
  }
}
srm diner {
  plays cooking.guest
  liveness { diner = guest . Rest }
  activities { Ask takes 1s  Eat takes 1s  Leave takes 1s  Rest takes 1s }
}
srm chef {
  plays cooking.cook
  liveness { chef = cook~ }
  activities { Look takes 1s  Cook takes 1s  Sorry takes 1s }
}
team Talk { ann : diner  bob : chef }
"""


@pytest.fixture(scope="module")
def talk() -> Generated:
    return generate(TALK, backend=BACKEND)


def test_a_handler_of_any_protocol_decides_and_prepares(talk: Generated) -> None:
    def handle_request(self: Any, request: Any) -> None:
        self.set_variable("fresh", request.content.what == "soup")
        self.prepare(talk.messages.Order(what="good soup"))

    def handle_inform(self: Any, inform: Any) -> None:
        self.log(inform.content.what)

    played = play(
        talk,
        {
            **behaviour(talk, "chef", "Cook", handle_request=handle_request),
            **behaviour(talk, "diner", "Guest", handle_inform=handle_inform),
        },
        until=20 * SECOND,
    )
    assert [r["text"] for r in played.of("log")] == ["good soup"]


def test_a_handler_that_raises_or_returns_is_a_fault_and_the_conversation_goes_on(talk: Generated) -> None:
    def handle_request(self: Any, request: Any) -> None:
        raise ValueError("no pot")

    played = play(
        talk,
        {
            **behaviour(talk, "chef", "Cook", handle_request=handle_request),
            **behaviour(talk, "diner", "Guest", handle_refuse=lambda self, refuse: "sorry"),
        },
        until=20 * SECOND,
    )
    told = [str(r["reason"]) for r in played.of("fault")]
    first, second = (text for text in told if text.startswith("handle_"))
    assert first.startswith("handle_request of Cook raised ValueError: no pot (test_fipa_callbacks.py:")
    assert second.startswith("handle_refuse of Guest raised TypeError: handle_refuse returned 'sorry'")
    assert played.result.agents[0].finished


# ---- what nothing would call ---------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "method", "text"),
    [
        (
            "Responder",
            "handle_agree",
            "Responder has handle_agree, which nothing calls: request.responder has",
        ),
        ("Responder", "prepare_requests", "Responder has prepare_requests, which nothing calls"),
        ("Serve", "handle_request", "Serve has handle_request, and Serve is not a participant's part"),
    ],
)
def test_a_method_that_nothing_calls_is_refused(
    request_: Generated, name: str, method: str, text: str
) -> None:
    played = play(request_, behaviour(request_, "cook", name, **{method: lambda self, x: None}), until=SECOND)
    assert any(text in str(r["reason"]) for r in played.of("fault"))


def test_a_callback_for_a_bound_activity_is_refused() -> None:
    made = generate(
        """\
system Kitchen
import protocols
srm cook {
  plays request.responder with PerformOrder = Bake
  liveness { cook = responder~ }
  activities { Bake takes 1s }
}
team Kitchen { bob : cook }
""",
        backend=BACKEND,
    )
    found = behaviour(made, "cook", "Responder", prepare_result_notification=lambda self, request: None)
    played = play(made, found, until=SECOND)
    assert any(
        "prepare_result_notification, which nothing calls: another activity stands for PerformOrder"
        in str(r["reason"])
        for r in played.of("fault")
    )


def test_the_code_of_an_activity_goes_before_the_callback(request_: Generated) -> None:
    class ConsiderOrder:
        def execute(self, context: Any) -> None:
            context.set_variable("willing", False)

    found = behaviour(request_, "boss", "Initiator", prepare_requests=order(request_))
    cook = behaviour(request_, "cook", "Responder", handle_request=lambda self, request: True)
    played = play(request_, {**found, **cook, "ConsiderOrder": ConsiderOrder}, until=SECOND)
    assert messages(played)[-1] == "0 bob refuse Order"
    assert any(
        "handle_request of Responder is not called: ConsiderOrder has code" in str(r["reason"])
        for r in played.of("fault")
    )


def test_a_callback_that_returns_another_message_fails_by_name(request_: Generated) -> None:
    found = behaviour(
        request_, "boss", "Initiator", prepare_requests=lambda self: request_.messages.Outcome(id="1")
    )
    played = play(request_, found, until=SECOND)
    (crash,) = played.of("activity", what="crash", agent="ann")
    assert "prepare_requests of Initiator returned Outcome, not Order" in str(crash["reason"])


def test_every_activity_of_the_table_is_the_librarys() -> None:
    blocks = (standard_library() / "protocols.aseme").read_text("utf-8").split("\naip ")
    for (protocol, participant), table in CALLBACKS.items():
        block = next(item for item in blocks if item.startswith(f"{protocol} "))
        assert f"participant {participant} " in block
        missing = {name for name in table if not re.search(rf"\b{name}\b", block)}
        assert missing <= {"DeclineJob"} if protocol == "iterated_contract_net" else not missing
