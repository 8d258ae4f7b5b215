"""FIPA callbacks: each participant of the library plays its part with methods alone."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from aseme_dsl.runtime.agent.fipa_callbacks import CALLBACKS
from aseme_dsl.runtime.jade import FailureException, RefuseException
from tests.runtime.callbacks import MIDDLES, behaviour, heard, kitchen, logs, messages, town
from tests.runtime.playing import SECOND, Played, play
from tests.support.generated import Generated


def ending(self: Any, results: Any) -> None:
    told = ", ".join(f"{item.performative} of {item.sender}" for item in results)
    self.log(f"{self.get_variable('ending').name}: {told}")


def hears(*names: str) -> dict[str, Any]:
    return {name: heard(name) for name in names}


def texts(played: Played, agent: str = "ann") -> list[str]:
    return [line.partition(" ")[2] for line in logs(played, agent)]


def without_mistakes(played: Played) -> bool:
    return not played.of("fault") and not played.of("activity", what="crash")


def test_each_participant_of_the_library_has_callbacks() -> None:
    assert len(CALLBACKS) == 24


# ---- auctions ------------------------------------------------------------------------------------


def auctioned(protocol: str, limits: dict[str, float], *, pays: Any = True, step: float = 10) -> Played:
    made = kitchen(protocol, "auctioneer", "bidder")

    def prepare_cfps(self: Any) -> Any:
        self.set_variable("step", float(step))
        self.set_variable("reserve", 20.0)
        return made.messages.Lot(id="vase", price=20.0 if protocol == "auction" else 60.0)

    def handle_cfp(self: Any, cfp: Any) -> bool:
        return bool(cfp.content.price <= limits[self.agent.name])

    return play(
        made,
        {
            **behaviour(
                made,
                "boss",
                "Auctioneer",
                reply_within=2,
                prepare_cfps=prepare_cfps,
                handle_all_result_notifications=ending,
                **hears("handle_all_responses", "handle_propose"),
            ),
            **behaviour(
                made,
                "cook",
                "Bidder",
                handle_cfp=handle_cfp,
                handle_request=pays if callable(pays) else lambda self, sale: pays,
                **hears("handle_accept_proposal", "handle_reject_proposal"),
            ),
        },
        until=100 * SECOND,
    )


def test_an_english_auction_with_callbacks_alone() -> None:
    played = auctioned("auction", {"bob": 45, "cid": 30})
    assert without_mistakes(played)
    told = [text for text in texts(played) if not text.startswith("handle_propose")]
    assert told == [
        "handle_all_responses: propose of bob, propose of cid",
        "handle_all_responses: propose of cid, propose of bob",  # bob leads: the first other one is better
        "handle_all_responses: propose of bob",
        "DONE: confirm of bob",
    ]
    (sale,) = played.of("agent_message", performative="request")
    assert sale["content"] == {"lot": "vase", "winner": "bob", "price": 40.0}


def test_an_auction_in_which_nobody_offers() -> None:
    played = auctioned("auction", {"bob": 1, "cid": 1})
    assert texts(played) == ["handle_all_responses: ", "NOBODY: "]
    assert without_mistakes(played)


@pytest.mark.parametrize("protocol", ["auction", "dutch_auction"])
@pytest.mark.parametrize("how", ["returns", "raises"])
def test_a_winner_that_does_not_pay(protocol: str, how: str) -> None:
    def poor(self: Any, sale: Any) -> bool:
        if how == "raises":
            raise RefuseException("no money")
        return False

    played = auctioned(protocol, {"bob": 45, "cid": 30}, pays=poor)
    assert texts(played)[-1] == "REFUSED: refuse of bob"
    assert without_mistakes(played)


def test_a_dutch_auction_with_callbacks_alone() -> None:
    played = auctioned("dutch_auction", {"bob": 45, "cid": 30})
    assert without_mistakes(played)
    assert [text for text in texts(played) if not text.startswith("handle_propose")] == [
        "handle_all_responses: ",
        "handle_all_responses: ",
        "handle_all_responses: propose of bob",
        "DONE: confirm of bob",
    ]
    assert texts(played, "bob") == ["handle_accept_proposal: accept_proposal of ann"]
    (sale,) = played.of("agent_message", performative="request")
    assert sale["content"] == {"lot": "vase", "winner": "bob", "price": 40.0}


# ---- iterated contract net -----------------------------------------------------------------------


def iterated(decide: Callable[[Any, Any, Generated], Any]) -> Played:
    made = kitchen("iterated_contract_net", "manager", "contractor")

    def handle_cfp(self: Any, cfp: Any) -> Any:
        cost = 10.0 if self.agent.name == "bob" else 8.0
        return made.messages.Proposal(job=cfp.content.id, cost=cost / (2 if cfp.content.what == "!" else 1))

    return play(
        made,
        {
            **behaviour(
                made,
                "boss",
                "Manager",
                reply_within=2,
                prepare_cfps=lambda self: made.messages.Job(id="7", what="cake"),
                handle_all_responses=lambda self, responses: decide(self, responses, made),
                handle_all_result_notifications=ending,
            ),
            **behaviour(
                made,
                "cook",
                "Contractor",
                handle_cfp=handle_cfp,
                handle_accept_proposal=lambda self, accept: made.messages.Outcome(id="7", detail="cake"),
            ),
        },
        until=100 * SECOND,
    )


def test_an_iterated_contract_net_with_callbacks_alone() -> None:
    def decide(self: Any, responses: Any, made: Generated) -> Any:
        self.log(f"costs {sorted(item.content.cost for item in responses)}")
        return made.messages.Job(id="7", what="!") if responses[0].content.cost > 5 else None

    played = iterated(decide)
    assert without_mistakes(played)
    assert texts(played) == ["costs [8.0, 10.0]", "costs [4.0, 5.0]", "DONE: inform of cid"]


@pytest.mark.parametrize(
    ("chosen", "told"),
    [("bob", "DONE: inform of bob"), (["cid"], "DONE: inform of cid"), ([], "NOBODY: ")],
)
def test_the_manager_may_choose(chosen: Any, told: str) -> None:
    played = iterated(lambda self, responses, made: chosen)
    assert texts(played) == [told]
    assert without_mistakes(played)


@pytest.mark.parametrize(
    ("chosen", "text"),
    [
        ("eve", "handle_all_responses of Manager returned 'eve': it returns the agents to accept"),
        (
            ["bob", "cid"],
            "handle_all_responses of Manager returned ['bob', 'cid']: one agent has the contract",
        ),
    ],
)
def test_what_the_manager_cannot_choose_fails_by_name(chosen: Any, text: str) -> None:
    (crash,) = iterated(lambda self, responses, made: chosen).of("activity", what="crash")
    assert text in str(crash["reason"])


# ---- brokering, recruiting -----------------------------------------------------------------------


def brokered(
    protocol: str,
    *,
    next_provider: Any,
    handle_proxy: Any = lambda self, proxy: True,
    able: Callable[[str], bool] = lambda name: True,
    prepare_result_notification: Any = None,
) -> Played:
    made = town(protocol)
    result = prepare_result_notification or (
        lambda self, request: made.messages.Outcome(id=request.content.id, detail="warm")
    )
    return play(
        made,
        {
            **behaviour(
                made,
                "asker",
                "Client",
                prepare_requests=lambda self: made.messages.Errand(id="1", what="soup", wanted="cook"),
                handle_all_result_notifications=ending,
                **hears("handle_agree", "handle_all_responses"),
            ),
            **behaviour(
                made,
                "middle",
                MIDDLES[protocol].title(),
                handle_proxy=handle_proxy,
                next_provider=next_provider,
                **hears("handle_refuse"),
            ),
            **behaviour(
                made,
                "doer",
                "Provider",
                handle_request=lambda self, request: able(self.agent.name),
                prepare_result_notification=result,
            ),
        },
        until=300 * SECOND,
    )


def in_turn(*names: str) -> Any:
    left = list(names)

    def next_provider(self: Any, proxy: Any) -> str | None:
        assert proxy.content.wanted == "cook"
        return left.pop(0) if left else None

    return next_provider


@pytest.mark.parametrize("protocol", sorted(MIDDLES))
def test_the_second_provider_does_it(protocol: str) -> None:
    played = brokered(protocol, next_provider=in_turn("bob", "cid"), able=lambda name: name == "cid")
    assert without_mistakes(played)
    assert texts(played, "max") == ["handle_refuse: refuse of bob"]
    told = texts(played)
    assert told[:2] == ["handle_agree: agree of max", "handle_all_responses: agree of max"]
    doer = "max" if protocol == "brokering" else "cid"
    assert told[-1] == f"DONE: inform of {doer}"


@pytest.mark.parametrize("protocol", sorted(MIDDLES))
def test_nobody_can(protocol: str) -> None:
    played = brokered(protocol, next_provider=in_turn("bob", "cid"), able=lambda name: False)
    assert texts(played)[-1] == "NOBODY: failure of max"
    assert without_mistakes(played)


@pytest.mark.parametrize("protocol", sorted(MIDDLES))
def test_who_is_in_the_middle_does_not_want_to(protocol: str) -> None:
    def busy(self: Any, proxy: Any) -> bool:
        raise RefuseException("busy")

    played = brokered(protocol, next_provider=in_turn(), handle_proxy=busy)
    assert messages(played) == ["0 ann proxy Errand", "0 max refuse Errand"]
    assert texts(played) == ["handle_all_responses: refuse of max", "REFUSED: "]


@pytest.mark.parametrize("protocol", sorted(MIDDLES))
def test_the_provider_fails(protocol: str) -> None:
    def fail(self: Any, request: Any) -> None:
        raise FailureException

    played = brokered(protocol, next_provider=in_turn("bob"), prepare_result_notification=fail)
    assert texts(played)[-1].startswith("FAILED: failure of ")
    assert without_mistakes(played)


# ---- request when, query, propose, subscribe -----------------------------------------------------


def talked(
    protocol: str, opener: dict[str, Any], answerer: dict[str, Any], initial: Callable[[Any], Any]
) -> Played:
    made = kitchen(protocol, "initiator", "responder")
    names = {"propose": "prepare_initiations", "subscribe": "prepare_subscriptions"}

    def prepare(self: Any) -> Any:
        self.set_variable("asked", "bob")
        return initial(made.messages)

    prepared = {names.get(protocol, "prepare_requests"): prepare}
    answers = {name: (lambda m: lambda *a: m(made.messages, *a))(method) for name, method in answerer.items()}
    return play(
        made,
        {
            **behaviour(made, "boss", "Initiator", **prepared, **opener),
            **behaviour(made, "cook", "Responder", **answers),
        },
        until=100 * SECOND,
    )


@pytest.mark.parametrize("holds", [True, False])
def test_a_request_when_with_callbacks_alone(holds: bool) -> None:
    def await_condition(made: Any, self: Any) -> Any:
        yield 4
        return holds

    played = talked(
        "request_when",
        {"handle_all_result_notifications": ending, **hears("handle_agree", "handle_all_responses")},
        {
            "handle_request": lambda made, self, request: request.content.condition == "dark",
            "await_condition": await_condition,
            "prepare_result_notification": lambda made, self, request: made.Outcome(id="1", detail="on"),
        },
        lambda made: made.Instruction(id="1", what="lamp", condition="dark"),
    )
    assert without_mistakes(played)
    assert logs(played)[:2] == ["0 handle_agree: agree of bob", "0 handle_all_responses: agree of bob"]
    assert logs(played)[2:] == ["4 DONE: inform of bob" if holds else "4 FAILED: failure of bob"]


@pytest.mark.parametrize("known", [True, False])
def test_a_query_with_callbacks_alone(known: bool) -> None:
    played = talked(
        "query",
        {"handle_all_result_notifications": ending, **hears("handle_all_responses")},
        {
            "handle_request": lambda made, self, query: True,
            "prepare_result_notification": lambda made, self, query: (
                made.Answer(id="1", holds=True, value="rain") if known else None
            ),
        },
        lambda made: made.Question(id="1", about="weather"),
    )
    assert without_mistakes(played)
    told = "DONE: inform of bob" if known else "FAILED: failure of bob"
    assert texts(played) == ["handle_all_responses: agree of bob", told]


@pytest.mark.parametrize("wanted", [True, False])
def test_a_propose_with_callbacks_alone(wanted: bool) -> None:
    played = talked(
        "propose",
        hears("handle_accept_proposal", "handle_reject_proposal", "handle_all_responses"),
        {"prepare_response": lambda made, self, propose: wanted},
        lambda made: made.Idea(id="1", what="walk"),
    )
    assert without_mistakes(played)
    told = "accept_proposal" if wanted else "reject_proposal"
    assert texts(played) == [f"handle_{told}: {told} of bob", f"handle_all_responses: {told} of bob"]


def test_a_subscribe_with_callbacks_alone() -> None:
    def handle_inform(self: Any, inform: Any) -> None:
        if inform.message == "News":
            self.log(f"news {inform.content.value}")
            self.set_variable("withdrawn", inform.content.value == "2")

    def next_notification(made: Any, self: Any) -> Any:
        yield 3
        self.agent.count = getattr(self.agent, "count", 0) + 1
        return made.News(id="1", value=str(self.agent.count))

    played = talked(
        "subscribe",
        {
            "handle_inform": handle_inform,
            "handle_all_result_notifications": ending,
            **hears("handle_agree", "handle_all_responses"),
        },
        {
            "handle_subscription": lambda made, self, subscribe: True,
            "next_notification": next_notification,
            "handle_cancel": lambda made, self, cancel: self.log(f"{cancel.performative} of {cancel.sender}"),
        },
        lambda made: made.Interest(id="1", about="score"),
    )
    assert without_mistakes(played)
    assert logs(played)[:4] == [
        "0 handle_agree: agree of bob",
        "0 handle_all_responses: agree of bob",
        "3 news 1",
        "6 news 2",
    ]
    assert texts(played)[-1].startswith("CANCELLED: ")
    assert logs(played, "bob") == ["6 cancel of ann"]


def test_a_refused_subscription_tells_all_responses() -> None:
    played = talked(
        "subscribe",
        {"handle_all_result_notifications": ending, **hears("handle_all_responses")},
        {
            "handle_subscription": lambda made, self, subscribe: False,
            "next_notification": lambda made, self: made.News(id="1", value="1"),
        },
        lambda made: made.Interest(id="1", about="score"),
    )
    assert texts(played) == ["handle_all_responses: refuse of bob", "REFUSED: "]
