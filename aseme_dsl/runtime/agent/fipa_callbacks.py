"""FIPA callbacks: methods of a participant's behaviour that are the activities of a library protocol.

A class of the user for the participant of a library protocol may have methods that JADE's initiators and
responders have (`prepare_requests`, `handle_cfp`). Each stands for an activity of the protocol for which
there is no other code. What it returns decides, and is sent by the transitions of the protocol.

The activities that only wait, or that fill in what a method has given already, need no code then.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterable, Sequence
from dataclasses import is_dataclass
from typing import Any, Literal, Protocol, assert_never, cast

from aseme_dsl.records import dataclass
from aseme_dsl.runtime.activity.activities import Executable
from aseme_dsl.runtime.activity.context import Context
from aseme_dsl.runtime.chart.inputs import LOST, AgentMessage
from aseme_dsl.runtime.library import agents

Does = Literal[
    "content",
    "decide",
    "result",
    "condition",
    "responses",
    "award",
    "iterate",
    "results",
    "collect",
    "lot",
    "offers",
    "payment",
    "sale",
    "choose",
    "wait",
    "clean",
    "nothing",
]
"""What a callback does with what its method returns.

* `content` prepares it.
* `decide` agrees if there is any.
* `result` has succeeded with it.
* `condition` says whether it came to hold.
* `responses` and `results` only get what has come.
* `award` may choose among it.
* `iterate` may want another round, with the message that begins it.
* `collect` waits as long as the behaviour says.
* `wait` waits until the protocol continues.
* `clean` may say whether it could stop.
* `nothing` is done at once.

In auctions:

* `lot` says what is sold, and from which price.
* `offers` collects and then gets the offers of the round.
* `payment` gets those of a round that was interrupted.
* `sale` says whether it was paid.

`choose` says which agent does it.
"""

FOREVER = 3600.0
"""Waiting is cut in pieces of so many seconds."""
REPLY_WITHIN = 10.0
"""So many seconds an initiator collects answers, if its behaviour has no `reply_within`."""


class RefuseException(Exception):
    """Raised by a `handle_…` of a responder: it refuses."""


class FailureException(Exception):
    """Raised by what carries something out: it has failed. Its argument may be the message that says how."""


@dataclass(frozen=True, slots=True)
class Callback:
    """How an activity is a method: what it does with it, and what of the protocol it sets and sends."""

    does: Does
    method: str = ""
    variable: str = ""
    message: str = ""
    """The type that the method returns."""
    answers: str = ""
    """The performative of the message that the method is given; without one it is the last of all."""


_CLEAN = Callback("clean", "handle_cancel", "stopped", answers="cancel")
_DROP = Callback("clean", "handle_cancel", answers="cancel")
_WAIT = Callback("wait")
_NOTHING = Callback("nothing")
_RESULTS = Callback("results", "handle_all_result_notifications")
_CONTRACTOR = {
    "EvaluateJob": Callback("decide", "handle_cfp", "able", "Proposal"),
    "MakeProposal": _NOTHING,
    "DeclineJob": _NOTHING,
    "CarryOut": Callback("result", "handle_accept_proposal", "succeeded", "Outcome"),
    "ReportOutcome": _NOTHING,
    "StopWork": _DROP,
    "CloseJob": _NOTHING,
}
_PROVIDER = {
    "WeighErrand": Callback("decide", "handle_request", "able"),
    "RunErrand": Callback("result", "prepare_result_notification", "succeeded", "Outcome"),
    "ReportResult": _NOTHING,
    "DropErrand": _DROP,
    "CloseErrand": _NOTHING,
}
_CLIENT = {
    "PrepareErrand": Callback("content", "prepare_requests", message="Errand"),
    "AwaitResult": _WAIT,
    "LearnResult": _RESULTS,
}
_BROKER = {
    "ConsiderErrand": Callback("decide", "handle_proxy", "willing", answers="proxy"),
    "ChooseProvider": Callback("choose", "next_provider", "found", answers="proxy"),
    "AwaitProvider": _WAIT,
    "StopSearch": _DROP,
    "CloseSearch": _NOTHING,
}
_AUCTIONEER = {
    "OpenAuction": Callback("lot", "prepare_cfps", message="Lot"),
    "CallPrice": _NOTHING,
    "CollectOffers": Callback("offers", "handle_all_responses"),
    "AwaitPayment": Callback("payment", "handle_all_responses"),
    "CloseAuction": Callback("sale", "handle_all_result_notifications"),
}
_BIDDER = {
    "ConsiderLot": _NOTHING,
    "DecideOffer": Callback("decide", "handle_cfp", "interested", answers="cfp"),
    "Pay": Callback("decide", "handle_request", "solvent", answers="request"),
    "LeaveAuction": _NOTHING,
}

CALLBACKS: dict[tuple[str, str], dict[str, Callback]] = {
    ("request", "initiator"): {
        "PrepareOrder": Callback("content", "prepare_requests", message="Order"),
        "AwaitOutcome": _WAIT,
        "LearnOutcome": _RESULTS,
    },
    ("request", "responder"): {
        "ConsiderOrder": Callback("decide", "handle_request", "willing"),
        "PerformOrder": Callback("result", "prepare_result_notification", "succeeded", "Outcome"),
        "ReportOutcome": _NOTHING,
        "StopOrder": _CLEAN,
        "CloseOrder": _NOTHING,
    },
    ("query", "initiator"): {
        "PrepareQuestion": Callback("content", "prepare_requests", message="Question"),
        "AwaitAnswer": _WAIT,
        "LearnAnswer": _RESULTS,
    },
    ("query", "responder"): {
        "ConsiderQuestion": Callback("decide", "handle_request", "willing"),
        "FindAnswer": Callback("result", "prepare_result_notification", "known", "Answer"),
        "GiveAnswer": _NOTHING,
        "DropQuestion": _DROP,
        "CloseQuestion": _NOTHING,
    },
    ("request_when", "initiator"): {
        "PrepareInstruction": Callback("content", "prepare_requests", message="Instruction"),
        "AwaitOutcome": _WAIT,
        "LearnOutcome": _RESULTS,
    },
    ("request_when", "responder"): {
        "ConsiderInstruction": Callback("decide", "handle_request", "willing"),
        "AwaitCondition": Callback("condition", "await_condition", "hopeless"),
        "PerformInstruction": Callback("result", "prepare_result_notification", "succeeded", "Outcome"),
        "ReportOutcome": _NOTHING,
        "StopInstruction": _CLEAN,
        "CloseInstruction": _NOTHING,
    },
    ("propose", "initiator"): {
        "PrepareIdea": Callback("content", "prepare_initiations", message="Idea"),
        "AwaitReply": _WAIT,
        "LearnReply": Callback("responses", "handle_all_responses"),
    },
    ("propose", "responder"): {
        "ConsiderIdea": Callback("decide", "prepare_response", "wanted"),
        "StopIdea": _DROP,
        "CloseIdea": _NOTHING,
    },
    ("subscribe", "initiator"): {
        "PrepareSubscription": Callback("content", "prepare_subscriptions", message="Interest"),
        "ReadNews": _NOTHING,
        "AwaitStop": _WAIT,
        "EndSubscription": _RESULTS,
    },
    ("subscribe", "responder"): {
        "ConsiderSubscription": Callback("decide", "handle_subscription", "willing"),
        "WatchSource": Callback("content", "next_notification", message="News"),
        "StopService": _DROP,
        "CloseSubscription": _NOTHING,
    },
    ("contract_net", "manager"): {
        "AnnounceJob": Callback("content", "prepare_cfps", message="Job"),
        "CollectProposals": Callback("collect"),
        "AwardContract": Callback("award", "handle_all_responses"),
        "AwaitOutcome": _WAIT,
        "LearnOutcome": _RESULTS,
    },
    ("contract_net", "contractor"): _CONTRACTOR,
    ("iterated_contract_net", "manager"): {
        "AnnounceJob": Callback("content", "prepare_cfps", message="Job"),
        "CollectProposals": Callback("collect"),
        "DecideRound": Callback("iterate", "handle_all_responses", "again", "Job"),
        "AwaitOutcome": _WAIT,
        "LearnOutcome": _RESULTS,
    },
    ("iterated_contract_net", "contractor"): _CONTRACTOR,
    ("auction", "auctioneer"): _AUCTIONEER,
    ("auction", "bidder"): _BIDDER,
    ("dutch_auction", "auctioneer"): _AUCTIONEER,
    ("dutch_auction", "bidder"): _BIDDER,
    ("brokering", "client"): _CLIENT,
    ("brokering", "broker"): _BROKER,
    ("brokering", "provider"): _PROVIDER,
    ("recruiting", "client"): _CLIENT,
    ("recruiting", "recruiter"): _BROKER,
    ("recruiting", "provider"): _PROVIDER,
}
"""The activities of the library's participants that may be methods."""

ANSWERED_ONCE = (
    ("request", "initiator"),
    ("query", "initiator"),
    ("request_when", "initiator"),
    ("subscribe", "initiator"),
    ("brokering", "client"),
    ("recruiting", "client"),
)
"""Who has all responses with the first one: a single agent is asked."""

RESPONSES = ("agree", "refuse", "not_understood", "propose", "accept_proposal", "reject_proposal")
RESULTS = ("inform", "failure")
NAMING = ("Match",)
"""The types of an inform that is not a result: in recruiting, it names the agent that does the errand."""
OFFERS = ("propose",)
PAYMENTS = ("confirm", "refuse", "not_understood")

NEEDED: tuple[Does, ...] = ("content", "decide", "result", "condition", "lot", "choose")
"""What is not done without the method."""
OPTIONAL: tuple[Does, ...] = ("clean", "award", "iterate")
"""What is done at once without the method."""


class Participant(Protocol):
    """A behaviour that stands for a participant."""

    @property
    def name(self) -> str: ...
    def heard(self) -> Sequence[AgentMessage]:
        """What it has taken in its conversation, the newest at the end."""
        ...

    def default_of(self, message: str) -> Any:
        """A message of a type with its defaults."""
        ...

    def tells_responses(self) -> bool:
        """Whether all responses of this conversation are to be told now, for the first time."""
        ...

    def news(self) -> Sequence[AgentMessage]:
        """What it has taken in its conversation since this was asked last."""
        ...


def methods_of(protocol: str, participant: str, receives: Iterable[tuple[str, str]]) -> tuple[str, ...]:
    """The methods that are called of a behaviour that stands for a participant."""
    table = CALLBACKS.get((protocol, participant), {})
    named = [item.method for item in table.values() if item.method]
    named += [f"handle_{performative}" for performative, _ in receives]
    if any(item.does == "results" for item in table.values()):
        named.append("handle_all_responses")
    return tuple(sorted({*named, "handle_lost"}))


def is_activity(protocol: str, participant: str, method: str) -> bool:
    """Whether a method is an activity, and does not only hear of a message."""
    return any(item.method == method for item in CALLBACKS.get((protocol, participant), {}).values())


def activity_of(callback: Callback, behaviour: Participant) -> type[Executable]:
    """The class of an activity that calls a method of a behaviour."""

    class Called:
        kind = "step"

        def execute(self, context: Context) -> Generator[object, None, None]:
            yield from _run(callback, behaviour, context)

    return Called


def _run(callback: Callback, behaviour: Participant, context: Context) -> Generator[object, None, None]:
    method = getattr(behaviour, callback.method, None) if callback.method else None
    match callback.does:
        case "content":
            context.prepare(_checked((yield from _value(method)), callback, behaviour, needed=True))
        case "decide":
            try:
                made = yield from _value(method, _last(behaviour, callback.answers))
            except RefuseException:
                made = None
            if made and callback.message:
                context.prepare(_checked(made, callback, behaviour, needed=True))
            context.set_variable(callback.variable, bool(made))
        case "result":
            try:
                made = _checked(
                    (yield from _value(method, _last(behaviour))), callback, behaviour, needed=False
                )
                fine = made is not None
            except FailureException as failure:
                made, fine = _checked(_argument(failure), callback, behaviour, needed=False), False
            context.prepare(behaviour.default_of(callback.message) if made is None else made)
            context.set_variable(callback.variable, fine)
        case "responses":
            yield from _tell_responses(behaviour, callback)
        case "award":
            chosen = yield from _awarded(method, behaviour)
            if chosen is not None:
                _choose(context, chosen)
        case "results":
            yield from _tell_responses(behaviour, callback)
            if method is not None:
                results = [item for item in _those(behaviour, RESULTS) if item.message not in NAMING]
                yield from _nothing(method, results, callback, behaviour)
        case "collect":
            yield float(getattr(behaviour, "reply_within", REPLY_WITHIN))
        case "iterate":
            yield from _iterate(callback, behaviour, context)
        case "lot":
            lot = _checked((yield from _value(method)), callback, behaviour, needed=True)
            assert lot is not None  # it is needed
            context.set_variable("lot", getattr(lot, "id"))  # noqa: B009  the message `Lot` of the protocol
            context.set_variable("price", getattr(lot, "price"))  # noqa: B009
        case "offers":
            yield float(getattr(behaviour, "reply_within", REPLY_WITHIN))
            if method is not None:
                yield from _nothing(method, _offers(behaviour), callback, behaviour)
        case "payment":
            if method is not None and (offers := _offers(behaviour)):
                yield from _nothing(method, offers, callback, behaviour)
            yield from _for_ever()
        case "sale":
            if method is not None:
                made = [item for item in _those(behaviour, PAYMENTS) if item.message == "Sale"]
                yield from _nothing(method, made, callback, behaviour)
        case "choose":
            one = yield from _value(method, _last(behaviour, callback.answers))
            if one is not None:
                context.set_variable("chosen", one)
            context.set_variable(callback.variable, one is not None)
        case "condition":
            holds = yield from _value(method)
            context.set_variable(callback.variable, not holds)
        case "wait":
            yield from _for_ever()
        case "clean":
            could = yield from _value(method, _last(behaviour, callback.answers))
            if callback.variable and could is not None:
                context.set_variable(callback.variable, bool(could))
        case "nothing":
            return
        case _:
            assert_never(callback.does)


def _for_ever() -> Generator[object, None, None]:
    while True:
        yield FOREVER


def _tell_responses(behaviour: Participant, callback: Callback) -> Generator[object, None, None]:
    method = getattr(behaviour, "handle_all_responses", None)
    if method is not None and behaviour.tells_responses():
        yield from _nothing(method, _those(behaviour, RESPONSES), callback, behaviour)


def _offers(behaviour: Participant) -> list[AgentMessage]:
    return [item for item in behaviour.news() if item.performative in OFFERS]


def _iterate(callback: Callback, behaviour: Participant, context: Context) -> Generator[object, None, None]:
    """Begin another round with a message, accept an offer or none, or leave that to the protocol."""
    responses = [item for item in behaviour.news() if item.performative in RESPONSES]
    behaviour.tells_responses()
    made = yield from _value(getattr(behaviour, callback.method), responses)
    if made is None:
        return
    if is_dataclass(made):
        context.prepare(_checked(made, callback, behaviour, needed=True))
        context.set_variable(callback.variable, True)
        return
    chosen = _chosen(made, responses, behaviour)
    if len(chosen) > 1:
        raise TypeError(
            f"handle_all_responses of {behaviour.name} returned {made!r}: one agent has the contract"
        )
    if chosen:
        context.set_variable("best", chosen[0])
    else:
        context.set_variable("proposals", 0)


def _awarded(method: object, behaviour: Participant) -> Generator[object, None, list[str] | None]:
    """The agents that are to have the contract, in this order; None: that is left to the protocol."""
    if method is None or not behaviour.tells_responses():
        return None
    responses = _those(behaviour, RESPONSES)
    made = yield from _value(method, responses)
    return None if made is None else _chosen(made, responses, behaviour)


def _chosen(made: object, responses: Sequence[AgentMessage], behaviour: Participant) -> list[str]:
    """The agents that a method has returned. Raises TypeError for one that has not proposed."""
    proposed = {item.sender for item in responses if item.performative == "propose"}
    chosen = list(dict.fromkeys(made)) if isinstance(made, (list, tuple, set)) else [made]
    wrong = next((name for name in chosen if name not in proposed), None)
    if wrong is not None:
        raise TypeError(
            f"handle_all_responses of {behaviour.name} returned {wrong!r}: it returns the agents to accept,"
            f" of {', '.join(sorted(proposed)) or 'nobody'}"
        )
    return [str(name) for name in chosen]


def _choose(context: Context, chosen: Sequence[str]) -> None:
    """Rank those who are chosen before all others, who are rejected then."""
    ranking = ""
    if chosen:
        rest: str = context.get_variable("ranking")
        for name in chosen:
            rest = agents.without(rest, name)
        names = list(chosen)
        while (other := agents.first_of(rest)) is not None:
            names.append(other)
            rest = agents.without(rest, other)
        for place, name in enumerate(names):
            ranking = agents.ranked(ranking, name, place)
        context.set_variable("wanted", len(chosen))
    context.set_variable("ranking", ranking)


def _nothing(
    method: object, messages: list[AgentMessage], callback: Callback, behaviour: Participant
) -> Generator[object, None, None]:
    """Call what only hears of messages. Raises TypeError if it wants to answer them."""
    made = yield from _value(method, messages)
    check_nothing(made, f"{getattr(method, '__name__', callback.method)} of {behaviour.name}")


def check_nothing(made: object, name: str) -> None:
    """Raises TypeError if what only hears of a message has returned something."""
    if made is not None:
        raise TypeError(f"{name} returned {made!r}: it returns nothing, since the protocol says what is sent")


def _value(method: object, *arguments: object) -> Generator[object, None, object]:
    """What a method returns; a generator takes the time that it yields."""
    made = cast("Callable[..., object]", method)(*arguments)
    if isinstance(made, Generator):
        made = yield from made
    return made


def _checked(made: object, callback: Callback, behaviour: Participant, *, needed: bool) -> object:
    """What a method has returned, if it is the message that it should return."""
    if made is None and not needed:
        return None
    is_message = is_dataclass(made) and not isinstance(made, type)
    if not is_message or type(made).__name__ != callback.message:
        found = type(made).__name__ if is_message else repr(made)
        raise TypeError(f"{callback.method} of {behaviour.name} returned {found}, not {callback.message}")
    return made


def _argument(failure: FailureException) -> object:
    """The message with which something has failed, if there is one."""
    found = failure.args[0] if failure.args else None
    return found if is_dataclass(found) else None


def _last(behaviour: Participant, performative: str = "") -> AgentMessage | None:
    """The message that it has taken last, of a performative if that is given.

    One that says that an agent is lost does not count.
    """
    wanted = (item for item in reversed(behaviour.heard()) if performative in ("", item.performative))
    return next((item for item in wanted if item.performative != LOST), None)


def _those(behaviour: Participant, performatives: Iterable[str]) -> list[AgentMessage]:
    return [item for item in behaviour.heard() if item.performative in performatives]


__all__ = [
    "ANSWERED_ONCE",
    "CALLBACKS",
    "NEEDED",
    "OPTIONAL",
    "RESPONSES",
    "RESULTS",
    "Callback",
    "FailureException",
    "RefuseException",
    "activity_of",
    "check_nothing",
    "is_activity",
    "methods_of",
]
