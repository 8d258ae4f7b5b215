"""`df` and `ams` in FIPA's language: agents that speak fipa-agent-management in SL0, as JADE's do."""

from __future__ import annotations

import json
from datetime import UTC, datetime, timedelta
from functools import cache
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from aseme_dsl.runtime.message.acl import FipaMessage
from aseme_dsl.runtime.message.sl import Form, dumps, loads
from aseme_dsl.runtime.trace.trace import Record
from tests.runtime.conversation.test_directory import ASK
from tests.runtime.outside import Outside
from tests.runtime.playing import MS, SECOND, check_line, make
from tests.support.generated import Generated, generate

ALICE = "(agent-identifier :name alice@elsewhere :addresses (sequence http://elsewhere:7778/acc))"
DF, AMS = "(agent-identifier :name df)", "(agent-identifier :name ams)"
WEATHER = (
    "(service-description :type weather :name sky :ontologies (set skies) :protocols (set fipa-contract-net)"
    " :properties (set (property :name place :value Chania) (property :name n :value 3)))"
)
MINE = f"(df-agent-description :name {ALICE} :services (set {WEATHER}))"
WANTED = "(df-agent-description :services (set (service-description :type weather)))"
NOBODY = "(df-agent-description :services (set (service-description :type nothing)))"


@cache
def _generated() -> Generated:
    return generate(ASK)


def action(function: str, manager: str = DF) -> str:
    return f"((action {manager} {function}))"


def talk(*said: tuple[str, str], to: str = "df", **more: Any) -> tuple[list[FipaMessage], list[Record]]:
    """What is answered to these messages, one every 100 ms; and the trace."""
    team, records = make(_generated(), until=1200 * MS)
    alice = Outside(team)
    known = {"language": "fipa-sl0", "ontology": "FIPA-Agent-Management", "protocol": "fipa-request", **more}
    for number, (act, content) in enumerate(said):
        alice.say(100 * number, act, content, to=to, reply_with=f"r{number}", **known)
    team.run()
    for record in records:
        check_line(record)
    return alice.heard, records


def told(messages: list[FipaMessage]) -> list[tuple[str, str]]:
    for message in messages:
        assert message.language == "fipa-sl0"
        assert dumps(*loads(str(message.content))) == message.content
    return [(message.performative, str(message.content)) for message in messages]


def test_an_agent_registers_searches_modifies_and_deregisters() -> None:
    register, search = f"(register {MINE})", f"(search {WANTED})"
    modify = f"(modify (df-agent-description :name {ALICE} :languages (set fipa-sl0 kif)))"
    deregister = f"(deregister (df-agent-description :name {ALICE}))"
    heard, _ = talk(
        *(("request", action(item)) for item in (register, search, modify, search, deregister)),
        conversation="c1",
    )
    described = (
        f"(df-agent-description :name {ALICE} :services (set (service-description :type weather :name sky"
        " :protocols (set fipa-contract-net) :ontologies (set skies)"
        ' :properties (set (property :name place :value Chania) (property :name n :value "3")))))'
    )

    def agreed(function: str) -> tuple[str, str]:
        return "agree", f"((action {DF} {function}) true)"

    def done(function: str) -> tuple[str, str]:
        return "inform", f"((done (action {DF} {function})))"

    assert told(heard) == [
        agreed(register),
        done(register),
        agreed(search),
        ("inform", f"((result (action {DF} {search}) (set {described})))"),
        agreed(modify),
        done(modify),
        agreed(search),
        ("inform", f"((result (action {DF} {search}) (set)))"),
        agreed(deregister),
        done(deregister),
    ]
    assert {(m.conversation, m.protocol, m.ontology) for m in heard} == {
        ("c1", "fipa-request", "FIPA-Agent-Management")
    }
    assert [m.in_reply_to for m in heard] == [f"r{number}" for number in range(5) for _ in "ab"]


def test_what_the_team_plays_is_found_by_its_registered_name() -> None:
    text = ASK.replace("aip ask", "aip propose").replace("ask.", "propose.")
    team, _ = make(generate(text), until=SECOND)
    alice = Outside(team)
    pattern = "(df-agent-description :protocols (set fipa-propose))"
    asked = action(f"(search {pattern} (search-constraints :max-depth 2 :max-results 1))")
    alice.say(0, "request", asked, to="df", language="FIPA-SL0")
    wanted = {"description": {"protocols": ["fipa-propose"]}, "action": "search"}
    alice.say(100, "request", wanted, to="df")
    team.run()
    (result,) = loads(str(alice.heard[1].content))
    assert isinstance(result, Form) and isinstance(result.terms[1], Form)
    (found,) = result.terms[1].terms
    assert isinstance(found, Form)
    assert found.parameter("protocols") == Form("set", ("fipa-propose",))
    assert len(json.loads(str(alice.heard[2].content))["result"]) == 3  # the same in JSON, without a limit


def test_a_lease_is_a_span_or_in_real_time_a_moment() -> None:
    lease = "+00000000T000000350"
    register = f"(register (df-agent-description :services (set {WEATHER}) :lease-time {lease}))"
    heard, records = talk(("request", action(register)))
    assert [r["time"] // MS for r in records if r["kind"] == "directory"] == [0, 350]
    moment = "20260131T120000000Z"
    heard, _ = talk(("request", action(register.replace(lease, moment))))
    ((act, content),) = told(heard)
    assert act == "refuse"
    assert content.endswith("(unrecognised-parameter-value df-agent-description lease-time))")
    team, records = make(_generated(), until=2 * SECOND, clock="real")
    later = (datetime.now(UTC) + timedelta(hours=1)).strftime("%Y%m%dT%H%M%S000Z")
    Outside(team).say(
        0, "request", action(register.replace(lease, later)), to="df", language="fipa-sl", reply_with="r"
    )
    team.driver.at(100 * MS, lambda: team.driver.stop("seen"))
    team.run()
    (told_of,) = [r for r in records if r["kind"] == "directory"]
    assert 3500 < told_of["until"] / SECOND < 3700


WRONG = {
    "no SL": (("request", "{}"), "not-understood", "(unrecognised-value "),
    "no text": (("request", b"\xff"), "not-understood", "(unrecognised-value "),
    "two actions": (
        ("request", f"((action {DF} (search)) (action {DF} (search)))"),
        "not-understood",
        "(unrecognised-value ",
    ),
    "no action": (("request", "(true)"), "not-understood", "(unrecognised-value "),
    "an act": (("propose", action(f"(search {WANTED})")), "not-understood", "(unsupported-act propose)"),
    "no act": (("(shout)", "()"), "not-understood", '(unsupported-act "(shout)")'),
    "a function": (("request", action("(dance 1)")), "refuse", "(unsupported-function dance)"),
    "a function alone": (("request", action("dance")), "refuse", "(unsupported-function dance)"),
    "no argument": (("request", action("(register)")), "refuse", "(missing-argument df-agent-description)"),
    "an argument": (("request", action("(search a)")), "refuse", "(unexpected-argument a)"),
    "another description": (
        ("request", action("(search (ams-agent-description))")),
        "not-understood",
        "(unrecognised-value ",
    ),
    "a parameter": (
        ("request", action("(search (df-agent-description :colour red))")),
        "refuse",
        "(unexpected-parameter df-agent-description colour)",
    ),
    "a service's parameter": (
        ("request", action("(register (df-agent-description :services (set (service-description :x 1))))")),
        "refuse",
        "(unexpected-parameter service-description x)",
    ),
    "a value": (
        ("request", action("(search (df-agent-description :protocols (set 1)))")),
        "refuse",
        "(unrecognised-parameter-value df-agent-description protocols)",
    ),
    "a limit": (
        ("request", action("(search (df-agent-description) (search-constraints :max-results all))")),
        "refuse",
        "(unrecognised-parameter-value search-constraints max-results)",
    ),
    "a lease": (
        ("request", action("(register (df-agent-description :lease-time 5))")),
        "refuse",
        "(unrecognised-parameter-value df-agent-description lease-time)",
    ),
    "another agent": (
        ("request", action("(register (df-agent-description :name (agent-identifier :name bob)))")),
        "refuse",
        "unauthorised",
    ),
    "one of the team": (
        ("request", action("(deregister (df-agent-description :name (agent-identifier :name tim)))")),
        "refuse",
        "unauthorised",
    ),
    "not registered": (
        ("request", action("(deregister (df-agent-description))")),
        "failure",
        "not-registered",
    ),
    "no conversation": (
        ("subscribe", f"((iota ?x (result (action {DF} (search {WANTED})) ?x)))"),
        "refuse",
        "(missing-parameter subscribe conversation-id)",
    ),
    "no subscription": (("cancel", "(true)"), "failure", "not-registered"),
    "no reference": (("subscribe", action(f"(search {WANTED})")), "not-understood", "(unrecognised-value "),
    "a subscription to something else": (
        ("subscribe", f"((iota ?x (result (action {DF} (register {MINE})) ?x)))"),
        "not-understood",
        "(unsupported-value ",
    ),
}


@pytest.mark.parametrize("case", WRONG)
def test_the_reason_is_fipas(case: str) -> None:
    said, act, reason = WRONG[case]
    heard, records = talk(said)
    told(heard)
    answer = heard[-1]
    first, last = loads(str(answer.content))
    assert (answer.performative, isinstance(first, Form) and first.name) == (act, "action")
    assert dumps(last)[1:-1].startswith(reason)
    (line,) = [r for r in records if r["kind"] == "directory"]
    assert (line["agent"], line["what"]) == ("alice@elsewhere", act)


def test_who_registers_twice_is_told_after_the_agreement() -> None:
    register = ("request", action(f"(register {MINE})"))
    heard, _ = talk(register, register)
    assert told(heard)[2:] == [
        ("agree", f"((action {DF} (register {MINE})) true)"),
        ("failure", f"((action {DF} (register {MINE})) already-registered)"),
    ]


def test_an_agent_subscribes_and_cancels() -> None:
    """As JADE does: `iota` of a search; who is gone is described by its name alone."""
    team, _ = make(_generated(), until=7 * SECOND)
    alice, carol = Outside(team), Outside(team, "carol@elsewhere")
    whole = f"(iota ?x (result (action {DF} (search {WANTED} (search-constraints :max-results -1))) ?x))"
    sl: dict[str, Any] = {"to": "df", "language": "fipa-sl", "conversation": "c1"}
    alice.say(0, "subscribe", f"({whole})", protocol="fipa-subscribe", **sl)
    offer = {"services": [{"type": "weather"}]}
    carol.say(1000, "request", {"action": "register", "description": offer}, to="df")
    carol.say(2000, "request", {"action": "deregister"}, to="df")
    alice.say(3000, "cancel", f"((action {DF} (subscribe)))", **sl)
    carol.say(4000, "request", {"action": "register", "description": offer}, to="df")
    team.run()
    named = "(df-agent-description :name (agent-identifier :name carol@elsewhere)"
    assert [(message.performative, message.content) for message in alice.heard] == [
        ("agree", f"({whole})"),
        ("inform", f"((= {whole} (set)))"),
        ("inform", f"((= {whole} (set {named} :services (set (service-description :type weather))))))"),
        ("inform", f"((= {whole} (set {named}))))"),
        ("inform", f"((done (action {DF} (cancel))))"),
    ]
    assert {message.language for message in alice.heard} == {"fipa-sl"}


def test_the_white_pages() -> None:
    get, search = "(get-description)", "(search (ams-agent-description :ownership boss))"
    heard, _ = talk(
        ("request", action(get, AMS)),
        ("request", action(search, AMS)),
        ("request", action("(search)", AMS)),
        ("request", action("(register (ams-agent-description))", AMS)),
        to="ams",
    )
    answers = told(heard)
    assert answers[1] == (
        "inform",
        f"((result (action {AMS} {get}) (ap-description :name S :ap-services (set"
        " (ap-service :name df :type fipa.df) (ap-service :name ams :type fipa.ams)))))",
    )
    assert answers[3] == (
        "inform",
        f"((result (action {AMS} {search}) (set (ams-agent-description :name"
        " (agent-identifier :name ann) :state active :ownership boss))))",
    )
    assert answers[5][1].count("ams-agent-description") == 3
    assert answers[6][0] == "refuse" and "(unsupported-function register)" in answers[6][1]


def test_on_a_platform_any_agent_of_the_team_answers() -> None:
    heard, records = talk(("request", action(f"(search {WANTED})")), to="tom")
    assert [message.performative for message in heard] == ["agree", "inform"]
    assert heard[0].sender is not None and heard[0].sender.name == "tom"
    assert [r for r in records if r["kind"] in ("received", "unexpected")] == []


pieces = st.lists(
    st.sampled_from(
        [
            *("(", ")", "(action ", DF, "(search ", "(register ", "(deregister ", "(iota ?x (result ", "?x"),
            *(WANTED, MINE, NOBODY, "(search-constraints :max-results 1)", ":lease-time ", "1", "(set ", "a"),
            *(" true", "(df-agent-description ", ":services ", ":name ", "+00000000T000000001", '"', '#2"'),
        ]
    ),
    max_size=10,
).map(" ".join)
whole = st.builds(
    lambda function, cut: action(function)[: len(action(function)) - cut],
    st.sampled_from([f"(register {MINE})", f"(search {WANTED})", "(deregister (df-agent-description))"]),
    st.integers(0, 3),
)


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    st.lists(st.tuples(st.sampled_from(["request", "subscribe", "cancel", "?"]), pieces | whole), max_size=6)
)
def test_whatever_is_asked_is_answered(said: list[tuple[str, str]]) -> None:
    heard, _ = talk(*said, conversation="c1")
    answered = {message.in_reply_to for message in heard}
    assert answered == {f"r{number}" for number in range(len(said))}
    told(heard)
