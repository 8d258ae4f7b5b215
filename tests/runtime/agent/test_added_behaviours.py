"""Added behaviours: they run beside the statechart, in virtual time, and receive what no participant does."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import pytest

from aseme_dsl.backends.jade_like import BACKEND
from aseme_dsl.runtime.jade import (
    ANY,
    ACLMessage,
    Behaviour,
    CyclicBehaviour,
    FSMBehaviour,
    MessageTemplate,
    OneShotBehaviour,
    ParallelBehaviour,
    SequentialBehaviour,
    TickerBehaviour,
    WakerBehaviour,
    all_of,
    any_of,
    not_,
)
from aseme_dsl.runtime.message.acl import AgentIdentifier, FipaMessage
from aseme_dsl.runtime.team.faults import Crash, Faults
from tests.faults.changing import version
from tests.runtime.playing import MS, SECOND, Played, make, play
from tests.support.generated import Generated, generate

PAIR = """\
system Pair
message Price { int euros }
srm one {
  liveness { one = Live . End }
  activities { Live takes 1s  End takes 1s }
  control one { enter End : stop [ready] }
  var ready : bool = false
}
srm two {
  liveness { two = Live . End }
  activities { Live takes 1s  End takes 1s }
  control two { enter End : stop }
}
team Pair { ann : one  bob : two }
"""
Setup = Callable[[Any], None]


@pytest.fixture(scope="module")
def pair() -> Generated:
    return generate(PAIR, backend=BACKEND)


def own(made: Generated, **setups: Setup) -> dict[str, type[Any]]:
    """The user's classes of the agents of roles, each with a `setup`."""
    found = {}
    for role, setup in setups.items():
        generated: Any = made.package.AGENTS[role]
        found[generated.own] = type(generated.own, (generated,), {"setup": setup})
    return found


def talk(made: Generated, until: int = 10 * SECOND, **setups: Setup) -> Played:
    return play(made, own(made, **setups), until=until)


def logs(played: Played, agent: str = "ann") -> list[str]:
    return [f"{r['time'] // MS} {r['activity']}: {r['text']}" for r in played.of("log", agent=agent)]


def faults(played: Played) -> list[str]:
    return [str(r["reason"]) for r in played.of("fault")]


class Listen(CyclicBehaviour):
    """Logs what comes."""

    def __init__(self, template: MessageTemplate | None = None, name: str = "") -> None:
        self.template, self.title = template, name

    def action(self) -> None:
        message = self.receive(self.template)
        if message is None:
            self.block()
        else:
            self.log(f"{self.title}{message.performative} {message.content} from {message.sender}")


class Say(OneShotBehaviour):
    """Sends messages."""

    def __init__(self, *messages: ACLMessage) -> None:
        self.messages = messages

    def action(self) -> None:
        for message in self.messages:
            self.send(message)


def to_ann(performative: str, content: Any = "", **members: Any) -> ACLMessage:
    return ACLMessage(performative, content, ("ann",), **members)


# ---- time ----------------------------------------------------------------------------------------


def test_one_shot_waker_and_ticker_keep_virtual_time(pair: Generated) -> None:
    class Once(OneShotBehaviour):
        def action(self) -> None:
            self.log("once")

    class Later(WakerBehaviour):
        def on_wake(self) -> None:
            self.log("woken")

    class Often(TickerBehaviour):
        seconds = 1.5

        def on_tick(self) -> None:
            self.log(f"tick {self.tick_count}")
            if self.tick_count == 3:
                self.stop()

        def on_end(self) -> None:
            self.log("stopped")

    def setup(agent: Any) -> None:
        for item in (Often(), Later(seconds=2), Once()):
            agent.add_behaviour(item)

    played = talk(pair, one=setup)
    assert logs(played) == [
        "0 Once: once",
        "1500 Often: tick 1",
        "2000 Later: woken",
        "3000 Often: tick 2",
        "4500 Often: tick 3",
        "4500 Often: stopped",
    ]
    assert faults(played) == []
    assert [(r["what"], r["behaviour"]) for r in played.of("behaviour")] == [
        ("start", "Often"),
        ("start", "Later"),
        ("start", "Once"),
        ("end", "Once"),
        ("end", "Later"),
        ("end", "Often"),
    ]


def test_two_runs_are_equal(pair: Generated) -> None:
    class Beat(TickerBehaviour):
        def on_tick(self) -> None:
            self.send(to_ann("inform", str(self.tick_count)))

    def one(agent: Any) -> None:
        agent.add_behaviour(Listen())

    def two(agent: Any) -> None:
        agent.add_behaviour(Beat(seconds=0.7))

    first, second = (talk(pair, one=one, two=two).records for _ in range(2))
    assert first == second


def test_a_generator_takes_time_and_waits_for_a_message(pair: Generated) -> None:
    class Ask(OneShotBehaviour):
        def action(self) -> Any:
            yield 2
            asked = self.send(ACLMessage("request", "time?", ("bob",), reply_with="q1"))
            template = MessageTemplate.match_in_reply_to(asked.reply_with)
            answer = yield from self.blocking_receive(template)
            assert answer is not None
            self.log(f"answer {answer.content}")
            silence = yield from self.blocking_receive(template, 3)
            self.log(f"then {silence}")

    class Answer(CyclicBehaviour):
        def action(self) -> Any:
            question = yield from self.blocking_receive()
            yield 1
            self.send(question.create_reply("inform", "noon"))

    def one(agent: Any) -> None:
        agent.add_behaviour(Ask())

    def two(agent: Any) -> None:
        agent.add_behaviour(Answer())

    played = talk(pair, one=one, two=two)
    assert logs(played) == ["3000 Ask: answer noon", "6000 Ask: then None"]
    assert faults(played) == []


def test_blocking_receive_without_yield_from_is_reported(pair: Generated) -> None:
    class Wrong(OneShotBehaviour):
        def action(self) -> None:
            message: Any = self.blocking_receive()
            self.log(message.content)

    played = talk(pair, one=lambda agent: agent.add_behaviour(Wrong()))
    (fault,) = faults(played)
    assert "write `message = yield from self.blocking_receive(…)`" in fault


def test_what_neither_ends_nor_blocks_goes_on_every_10_ms(pair: Generated) -> None:
    class Poll(Behaviour):
        count = 0

        def action(self) -> None:
            self.count += 1

        def done(self) -> bool:
            return self.count == 5

        def on_end(self) -> None:
            self.log("done")

    played = talk(pair, one=lambda agent: agent.add_behaviour(Poll()))
    assert logs(played) == ["40 Poll: done"]


def test_endless_ping_pong_without_time_stops_nobody(pair: Generated) -> None:
    class Echo(CyclicBehaviour):
        def action(self) -> None:
            message = self.receive()
            if message is None:
                self.block()
            else:
                self.send(message.create_reply("inform", message.content))

    class Serve(OneShotBehaviour):
        def action(self) -> None:
            self.send(ACLMessage("inform", "ball", ("ann",), reply_with="x"))

    def two(agent: Any) -> None:
        agent.add_behaviour(Echo())
        agent.add_behaviour(Serve())

    played = talk(pair, until=100 * MS, one=lambda agent: agent.add_behaviour(Echo()), two=two)
    assert played.result.reason == "time"
    assert not played.of("error")
    assert len(played.of("agent_message")) > 500


# ---- composites ----------------------------------------------------------------------------------


class Step(OneShotBehaviour):
    """Logs, and ends with a result."""

    def __init__(self, text: str, result: Any = None, takes: float = 0.0) -> None:
        self.text, self.result, self.takes = text, result, takes

    def action(self) -> Any:
        if self.takes:
            yield self.takes
        self.log(self.text)

    def on_end(self) -> Any:
        return self.result


def test_sequential_and_parallel(pair: Generated) -> None:
    row = SequentialBehaviour()
    both = ParallelBehaviour()
    first = ParallelBehaviour(ANY)
    for item in (Step("b", takes=2), Step("c", takes=1)):
        both.add_sub_behaviour(item)
    for item in (Step("d", takes=2), Step("e", takes=1)):
        first.add_sub_behaviour(item)
    for part in (Step("a", takes=1), both, first, Step("f")):
        row.add_sub_behaviour(part)
    played = talk(pair, one=lambda agent: agent.add_behaviour(row))
    assert [line.partition(" Step: ")[::2] for line in logs(played)] == [
        ("1000", "a"),
        ("2000", "c"),
        ("3000", "b"),
        ("4000", "e"),
        ("4000", "f"),
    ]
    assert played.of("behaviour")[-1]["behaviour"] == "SequentialBehaviour"


class Count(Step):
    """Returns "again" until it has run so often."""

    runs = 0

    def on_end(self) -> Any:
        self.runs += 1
        return "again" if self.runs < 3 else "enough"


class Machine(FSMBehaviour):
    def __init__(self) -> None:
        self.register_first_state(Step("a", takes=1), "A")
        self.register_state(Count("b", takes=1), "B")
        self.register_last_state(Step("c", "fine"), "C")
        self.register_default_transition("A", "B")
        self.register_transition("B", "A", "again")
        self.register_transition("B", "C", "enough")

    def on_end(self) -> Any:
        self.log(f"over with {self.exit_value}")


def test_a_behaviour_is_in_one_place_only() -> None:
    outer, inner = SequentialBehaviour(), SequentialBehaviour()
    outer.add_sub_behaviour(inner)
    for around, item in ((inner, outer), (inner, inner), (SequentialBehaviour(), inner)):
        with pytest.raises(TypeError, match="SequentialBehaviour is in use: make another object"):
            around.add_sub_behaviour(item)


def test_an_fsm_goes_where_its_states_end(pair: Generated) -> None:
    played = talk(pair, one=lambda agent: agent.add_behaviour(Machine()))
    assert logs(played) == [
        "1000 Step: a",
        "2000 Count: b",
        "3000 Step: a",
        "4000 Count: b",
        "5000 Step: a",
        "6000 Count: b",
        "6000 Step: c",
        "6000 Machine: over with fine",
    ]


def test_an_fsm_without_a_transition_for_an_event_is_reported_by_name(pair: Generated) -> None:
    class Machine(FSMBehaviour):
        def __init__(self) -> None:
            self.register_first_state(Step("a", 7), "A")
            self.register_last_state(Step("b"), "B")
            self.register_transition("A", "B", 1)

    played = talk(pair, one=lambda agent: agent.add_behaviour(Machine()))
    (fault,) = faults(played)
    assert "state A has ended with 7, and Machine has no transition for that" in fault
    assert not played.team.agent("ann").shown.added_behaviours  # type: ignore[union-attr]


# ---- messages ------------------------------------------------------------------------------------

NAMES = MessageTemplate
MESSAGES = {
    "plain": to_ann("inform", "plain"),
    "cfp": to_ann("cfp", "cfp", conversation_id="trade"),
    "onto": to_ann("inform", "onto", ontology="books", conversation_id="trade"),
    "proto": to_ann("REQUEST", "proto", protocol="my-protocol", language="xml"),
    "reply": to_ann("accept-proposal", "reply", in_reply_to="r1", reply_with="r2"),
}


@pytest.mark.parametrize(
    ("template", "expected"),
    [
        (NAMES.match_all(), "plain cfp onto proto reply"),
        (NAMES.match_performative("inform"), "plain onto"),
        (NAMES.match_performative("ACCEPT-PROPOSAL"), "reply"),
        (NAMES.match_sender("bob"), "plain cfp onto proto reply"),
        (NAMES.match_sender("cid"), ""),
        (NAMES.match_conversation_id("trade"), "cfp onto"),
        (NAMES.match_ontology("books"), "onto"),
        (NAMES.match_ontology("Pair"), "plain cfp proto reply"),
        (NAMES.match_protocol("my-protocol"), "proto"),
        (NAMES.match_language("xml"), "proto"),
        (NAMES.match_in_reply_to("r1"), "reply"),
        (NAMES.match_reply_with("r2"), "reply"),
        (NAMES.match_content("plain"), "plain"),
        (NAMES.match_message(str), "plain cfp onto proto reply"),
        (NAMES.match(lambda message: len(message.content) == 5), "plain proto reply"),
        (NAMES.match_performative("inform") & NAMES.match_conversation_id("trade"), "onto"),
        (NAMES.match_performative("cfp") | NAMES.match_ontology("books"), "cfp onto"),
        (~NAMES.match_performative("inform"), "cfp proto reply"),
        (
            all_of(
                NAMES.match_conversation_id("trade"),
                not_(any_of(NAMES.match_performative("cfp"), NAMES.match_sender("cid"))),
            ),
            "onto",
        ),
    ],
)
def test_templates(template: MessageTemplate, expected: str) -> None:
    found = [name for name, item in MESSAGES.items() if template.matches(_arrived(item))]
    assert " ".join(found) == expected


def _arrived(message: ACLMessage) -> ACLMessage:
    return replace(message, sender="bob", ontology=message.ontology or "Pair")


def test_each_behaviour_takes_what_its_template_matches_and_the_first_what_both_do(pair: Generated) -> None:
    def one(agent: Any) -> None:
        agent.add_behaviour(Listen(MessageTemplate.match_performative("cfp"), "1 "))
        agent.add_behaviour(Listen(MessageTemplate.match_conversation_id("trade"), "2 "))
        agent.add_behaviour(Listen(~MessageTemplate.match_performative("request"), "3 "))

    def two(agent: Any) -> None:
        agent.add_behaviour(Say(*MESSAGES.values()))

    played = talk(pair, one=one, two=two)
    assert [line.partition("Listen: ")[2] for line in logs(played)] == [
        "1 cfp cfp from bob",
        "2 inform onto from bob",
        "3 inform plain from bob",
        "3 accept_proposal reply from bob",
    ]
    (left,) = played.result.unread  # nobody wants it: it waits, and the run says so
    assert (left.agent, left.performative, left.sender) == ("ann", "request", "bob")


def test_a_message_of_the_system_is_content(pair: Generated) -> None:
    price = pair.messages.Price(euros=7)

    class Pay(CyclicBehaviour):
        def action(self) -> None:
            message = self.receive(MessageTemplate.match_message(type(price)))
            if message is None:
                self.block()
            else:
                self.log(f"{message.content.euros} euros")

    played = talk(
        pair,
        one=lambda agent: agent.add_behaviour(Pay()),
        two=lambda agent: agent.add_behaviour(Say(to_ann("inform", price))),
    )
    assert logs(played) == ["0 Pay: 7 euros"]
    (record,) = played.of("agent_message")
    assert (record["message"], record["content"]) == ("Price", {"euros": 7})


def test_without_behaviours_a_message_is_answered_not_understood(pair: Generated) -> None:
    class Ask(OneShotBehaviour):
        def action(self) -> Any:
            self.send(to_ann("request", "anybody?", conversation_id="c"))
            answer = yield from self.blocking_receive()
            self.log(f"{answer.performative} in {answer.conversation_id}")

    played = talk(pair, two=lambda agent: agent.add_behaviour(Ask()))
    assert logs(played, "bob") == ["0 Ask: not_understood in c"]
    (record,) = played.of("unexpected")
    assert record["reason"] == "ann has no behaviour that could receive it"


def test_a_class_that_is_no_message_of_the_system_is_no_content(pair: Generated) -> None:
    @dataclass(frozen=True)
    class Own:
        number: int = 1

    played = talk(pair, two=lambda agent: agent.add_behaviour(Say(to_ann("inform", Own()))))
    (fault,) = faults(played)
    assert "action of Say raised ValueError: Own is not a message of Pair" in fault


def test_an_unknown_receiver_is_a_fault(pair: Generated) -> None:
    played = talk(pair, one=lambda agent: agent.add_behaviour(Say(ACLMessage("inform", "x", ("nobody",)))))
    (fault,) = faults(played)
    assert fault == "inform cannot be sent: there is no way to nobody"


@pytest.mark.parametrize(
    ("make_it", "text"),
    [
        (lambda: ACLMessage("shout", ""), "FIPA has no performative 'shout'"),
        (
            lambda: ACLMessage("inform", 7),
            "the content is a text or a message that the system declares, not 7",
        ),
        (lambda: ACLMessage("inform", "", "bob"), "receivers is a tuple of names like ('bob',), not 'bob'"),
        (lambda: ACLMessage("inform", "\ud800"), "surrogates not allowed"),
        (lambda: ACLMessage("inform", protocol=None), "protocol is a text, not None"),  # type: ignore[arg-type]
        (lambda: MessageTemplate.match_performative("shout"), "FIPA has no performative 'shout'"),
        (
            lambda: MessageTemplate.match_all() and MessageTemplate.match_sender("bob"),
            "templates are combined by `&`, `|` and `~`, not by `and`, `or` and `not`",
        ),
    ],
)
def test_what_is_no_message_is_refused(make_it: Callable[[], object], text: str) -> None:
    with pytest.raises((TypeError, ValueError), match=re.escape(text)):
        make_it()


# ---- what goes wrong -----------------------------------------------------------------------------


class Broken(CyclicBehaviour):
    def action(self) -> None:
        raise ValueError("no battery")


def test_a_behaviour_that_raises_is_removed_by_name_and_the_others_go_on(pair: Generated) -> None:
    class Beat(TickerBehaviour):
        seconds = 3

        def on_tick(self) -> None:
            self.log("beat")

    def setup(agent: Any) -> None:
        row = SequentialBehaviour()
        row.add_sub_behaviour(Step("first"))
        row.add_sub_behaviour(Broken())
        agent.add_behaviour(row)
        agent.add_behaviour(Beat())

    played = talk(pair, one=setup)
    (fault,) = faults(played)
    assert re.fullmatch(
        r"action of Broken raised ValueError: no battery \(test_added_behaviours\.py:\d+\); the behaviour is"
        r" removed with SequentialBehaviour, which it is in",
        fault,
    )
    assert logs(played)[1:] == ["3000 Beat: beat", "6000 Beat: beat", "9000 Beat: beat"]
    assert not played.team.agent("ann").over or played.result.reason == "time"


@pytest.mark.parametrize("what", ["on_start", "done", "on_end"])
def test_whatever_raises_is_named(pair: Generated, what: str) -> None:
    def fail(self: Any) -> None:
        raise SystemExit("enough")

    kind: Any = type("Bad", (OneShotBehaviour,), {"action": lambda self: None, what: fail})
    played = talk(pair, one=lambda agent: agent.add_behaviour(kind()))
    (fault,) = faults(played)
    assert fault.startswith(f"{what} of Bad raised SystemExit: enough")


class Empty(OneShotBehaviour):
    pass


class Unsure(Behaviour):
    def action(self) -> None:
        pass


class Dull(TickerBehaviour):
    pass


class Timeless(TickerBehaviour):
    def on_tick(self) -> None:
        pass


def lost_transition() -> FSMBehaviour:
    machine = FSMBehaviour()
    machine.register_first_state(Step("a"), "A")
    machine.register_default_transition("A", "Z")
    return machine


def dead_end() -> FSMBehaviour:
    machine = FSMBehaviour()
    machine.register_first_state(Step("a"), "A")
    return machine


@pytest.mark.parametrize(
    ("made", "text"),
    [
        (lambda agent: Empty(), "Empty has no action"),
        (lambda agent: Unsure(), "Unsure has no done"),
        (lambda agent: Dull(1), "Dull has no on_tick"),
        (lambda agent: Timeless(), "Timeless does not say how many seconds its period has"),
        (lambda agent: Step, "Step is a class: add_behaviour(Step())"),
        (lambda agent: SequentialBehaviour(), "SequentialBehaviour has no behaviours in it"),
        (lambda agent: lost_transition(), "FSMBehaviour has a transition with Z; its states are A"),
        (lambda agent: dead_end(), "no transition of FSMBehaviour leaves A: register it as a last state"),
        (lambda agent: agent.main, "One is a view of a state: use(One) in setup"),
        (lambda agent: 7, "7 is not an object of a behaviour of aseme_dsl.runtime.jade"),
    ],
)
def test_what_cannot_run_is_refused_at_once(pair: Generated, made: Callable[[Any], Any], text: str) -> None:
    played = talk(pair, one=lambda agent: agent.add_behaviour(made(agent)))
    (fault,) = faults(played)
    assert text in fault


def test_a_behaviour_of_jade_is_not_used_as_a_view(pair: Generated) -> None:
    played = talk(pair, one=lambda agent: agent.use(Step))
    (fault,) = faults(played)
    assert "Step runs beside the tree: add_behaviour(Step())" in fault


def test_a_behaviour_removes_another_and_itself(pair: Generated) -> None:
    class Beat(TickerBehaviour):
        seconds = 1

        def on_tick(self) -> None:
            self.log("beat")

        def on_end(self) -> None:
            self.log("never")

    class Judge(WakerBehaviour):
        def on_wake(self) -> Any:
            self.agent.remove_behaviour(self.agent.beat)
            self.agent.remove_behaviour(self)
            yield 1
            self.log("never")

    def setup(agent: Any) -> None:
        agent.beat = Beat()
        agent.add_behaviour(agent.beat)
        agent.add_behaviour(Judge(seconds=2.5))

    played = talk(pair, one=setup)
    assert logs(played) == ["1000 Beat: beat", "2000 Beat: beat"]
    assert faults(played) == []


# ---- the statechart ------------------------------------------------------------------------------


def test_behaviours_raise_events_and_use_variables_of_the_role(pair: Generated) -> None:
    class Decide(WakerBehaviour):
        def on_wake(self) -> Any:
            self.agent.raise_event("stop")  # not ready
            yield 1
            self.log(f"ready {self.agent.get_variable('ready')}")
            self.agent.set_variable("ready", True)
            yield 1
            self.agent.raise_event("stop")

    played = talk(pair, one=lambda agent: agent.add_behaviour(Decide(seconds=2)))
    assert logs(played) == ["3000 Decide: ready False"]
    assert [r["time"] // MS for r in played.of("activity", activity="End", what="start")] == [4000]


def test_behaviours_end_with_their_agent(pair: Generated) -> None:
    class Stop(WakerBehaviour):
        def on_wake(self) -> None:
            self.agent.raise_event("stop")

    def two(agent: Any) -> None:
        agent.add_behaviour(Listen())
        agent.add_behaviour(Stop(seconds=1))

    class Late(WakerBehaviour):
        def on_wake(self) -> None:
            self.send(ACLMessage("inform", "too late", ("bob",)))

    played = talk(pair, one=lambda agent: agent.add_behaviour(Late(seconds=5)), two=two)
    assert [(r["what"], r["behaviour"]) for r in played.of("behaviour", agent="bob")][-2:] == [
        ("end", "Stop"),
        ("removed", "Listen"),
    ]
    (unexpected,) = played.of("unexpected", agent="bob")
    assert unexpected["reason"] == "bob has ended"


def test_a_crash_ends_behaviours_and_a_restart_begins_anew(pair: Generated) -> None:
    class Beat(TickerBehaviour):
        seconds = 1

        def on_tick(self) -> None:
            self.log(f"beat {self.tick_count}")

    class Call(TickerBehaviour):
        seconds = 1.3

        def on_tick(self) -> None:
            self.send(to_ann("inform", "hello"))

    def one(agent: Any) -> None:
        agent.add_behaviour(Beat())

    faulty = Faults(crashes=(Crash("ann", 2500 * MS, 2 * SECOND),))
    played = play(
        pair,
        own(pair, one=one, two=lambda agent: agent.add_behaviour(Call())),
        until=6 * SECOND,
        faults=faulty,
    )
    assert logs(played) == ["1000 Beat: beat 1", "2000 Beat: beat 2", "5500 Beat: beat 1"]
    assert any("is lost: ann is down" in text for text in faults(played))


# ---- protocols -----------------------------------------------------------------------------------

TALK = """\
system Talk
message Order { string what }
aip cooking {
  participant guest {
    sends    request Order
    receives inform Order, refuse Order
    process  = Ask . Eat
  }
  participant cook {
    sends    inform Order, refuse Order
    receives request Order
    process  = Cook
  }
  control guest {
    enter Ask : / send request Order { what = "soup" } to cook
    enter Eat : inform Order from cook
  }
  control cook { enter Cook : request Order from guest  leave Cook : / send inform Order to guest }
}
srm diner { plays cooking.guest  liveness { diner = guest . Rest } activities { Ask takes 1s Eat takes 1s
  Rest takes 10s } }
srm chef { plays cooking.cook  liveness { chef = cook~ } activities { Cook takes 1s } }
team Talk { ann : diner  bob : chef }
"""


@pytest.fixture(scope="module")
def cooking() -> Generated:
    return generate(TALK, backend=BACKEND)


def test_messages_of_a_protocol_are_not_stolen_by_a_behaviour(cooking: Generated) -> None:
    played = talk(
        cooking,
        diner=lambda agent: agent.add_behaviour(Listen()),
        chef=lambda agent: agent.add_behaviour(Listen()),
    )
    assert logs(played) == logs(played, "bob") == []
    assert played.order("end") == ["end Ask", "end Cook", "end Eat"]
    assert not played.of("behaviour", what="received")


@pytest.mark.parametrize(
    ("message", "text"),
    [
        (
            ACLMessage("request", "soup", ("bob",), protocol="cooking"),
            "a behaviour may not send request to bob: cooking is a protocol of this system, whose messages"
            " its participants send",
        ),
        (
            ACLMessage("inform", "soup", ("bob",), protocol="FIPA-cooking"),
            "a behaviour may not send inform to bob: cooking is a protocol of this system",
        ),
        (
            ACLMessage("inform", "soup", ("bob",), conversation_id="cooking-ann-1"),
            "a behaviour may not send inform to bob: cooking-ann-1 is a conversation of cooking",
        ),
    ],
)
def test_a_behaviour_does_not_send_what_a_protocol_owns(
    cooking: Generated, message: ACLMessage, text: str
) -> None:
    class Forge(WakerBehaviour):
        def on_wake(self) -> None:
            self.send(message)

    played = talk(cooking, diner=lambda agent: agent.add_behaviour(Forge(seconds=1.2)))
    first, second = faults(played)
    assert first.startswith(text)
    assert second.startswith(f"action of Forge raised MoveError: {text}")
    assert all(r["participant"] for r in played.of("agent_message"))


def test_a_template_for_a_protocol_of_the_system_is_refused(cooking: Generated) -> None:
    template = MessageTemplate.match_protocol("cooking") & MessageTemplate.match_performative("inform")
    played = talk(cooking, diner=lambda agent: agent.add_behaviour(Listen(template)))
    (fault,) = faults(played)
    assert "no behaviour receives messages of cooking: cooking is a protocol of this system" in fault


# ---- external agents -----------------------------------------------------------------------------


def test_an_external_agent_talks_with_behaviours_and_participants_come_first(cooking: Generated) -> None:
    heard: list[FipaMessage] = []

    class Chat(CyclicBehaviour):
        def action(self) -> Any:
            message = yield from self.blocking_receive()
            self.log(f"{message.performative} {message.content} from {message.sender}")
            if message.performative == "query_ref":
                self.send(message.create_reply("inform", "fish"))

    team, records = make(
        cooking, own(cooking, chef=lambda agent: agent.add_behaviour(Chat())), until=10 * SECOND
    )
    conversations = team.conversations
    conversations.add_external_agent("eve", heard.append)
    eve = AgentIdentifier("eve")

    def say(performative: str, content: str, **members: Any) -> None:
        message = FipaMessage(performative, eve, (AgentIdentifier("bob"),), content, **members)
        team.driver.at(2 * SECOND, lambda: conversations.receive_external("bob", message))

    say("query-ref", "what is there?", conversation="c1", reply_with="q1")
    say("request", '{"what": "eggs"}', conversation="c2", protocol="cooking")
    say("request", "no JSON", conversation="c3", protocol="cooking")
    say("inform", "thanks", conversation="c1")
    team.run()
    played = Played(team, None, records)  # type: ignore[arg-type]
    assert logs(played, "bob") == [
        "2000 Chat: query_ref what is there? from eve",
        "2000 Chat: inform thanks from eve",
    ]
    by = {item.conversation: item for item in heard}
    assert (by["c1"].performative, by["c1"].content, by["c1"].in_reply_to) == ("inform", "fish", "q1")
    assert by["c3"].performative == "not-understood"
    assert by["c2"].performative == "inform"  # the cook has taken it


def test_an_external_agent_cannot_turn_a_conversation_of_a_protocol_into_a_free_one(
    cooking: Generated,
) -> None:
    team, records = make(
        cooking, own(cooking, chef=lambda agent: agent.add_behaviour(Listen())), until=10 * SECOND
    )
    team.conversations.add_external_agent("eve", lambda message: None)
    eve, bob = AgentIdentifier("eve"), AgentIdentifier("bob")

    def say(moment: int, performative: str, content: str, protocol: str = "") -> None:
        message = FipaMessage(
            performative, eve, (bob,), content, conversation="cooking-eve-1", protocol=protocol
        )
        team.driver.at(moment, lambda: team.conversations.receive_external("bob", message))

    say(4000 * MS, "inform", "hello")
    say(5000 * MS, "request", '{"what": "eggs"}', "cooking")
    say(5100 * MS, "request", '{"what": "more"}')
    team.run()
    played = Played(team, None, records)  # type: ignore[arg-type]
    assert logs(played, "bob") == ["4000 Listen: inform hello from eve"]
    assert played.of("conversation", what="join", conversation="cooking-eve-1")


# ---- another version -----------------------------------------------------------------------------

VERSION = """\
system S
srm me {{ liveness {{ me = {formula} }} activities {{ A takes 10s  B takes 10s }} }}
team S {{ me : me }}
"""


def test_a_swap_ends_added_behaviours_and_setup_of_the_new_version_adds_its_own() -> None:
    class Beat(TickerBehaviour):
        seconds = 1

        def on_tick(self) -> None:
            self.agent.count += 1
            self.log(f"{self.agent.version} {self.agent.count}")

    def agent(made: Generated, number: int) -> dict[str, type[Any]]:
        def setup(agent: Any) -> None:
            agent.version, agent.count = number, 0
            agent.add_behaviour(Beat())

        def take_over(agent: Any, before: Any) -> None:
            agent.count = before.count

        generated: Any = made.package.AGENTS["me"]
        kind = type(generated.own, (generated,), {"setup": setup, "take_over": take_over})
        return {generated.own: kind}

    old, new = (
        generate(VERSION.format(formula=formula), backend=BACKEND) for formula in ("A . B", "A . B . A")
    )
    team, records = make(old, agent(old, 1), until=5 * SECOND)
    team.swap(version(new, agent(new, 2)), at=2500 * MS)
    team.run()
    assert logs(Played(team, None, records), "me") == [  # type: ignore[arg-type]
        "1000 Beat: 1 1",
        "2000 Beat: 1 2",
        "3500 Beat: 2 3",
        "4500 Beat: 2 4",
    ]
