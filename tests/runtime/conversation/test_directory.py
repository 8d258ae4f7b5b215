"""The directory: who is there, what each offers, and how agents of the team and others come to know it."""

from __future__ import annotations

import json
from functools import cache
from typing import Any, ClassVar

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from aseme_dsl.runtime import Context
from aseme_dsl.runtime.conversation.directory import DirectoryError, Entry, Service
from aseme_dsl.runtime.message.acl import AgentIdentifier
from aseme_dsl.runtime.team.faults import Crash, Faults
from aseme_dsl.runtime.trace.trace import Record
from tests.runtime.outside import Outside
from tests.runtime.playing import MS, SECOND, Played, check_line, make, play
from tests.support.generated import Generated, generate

ASK = """
system S
message Task { int n }
aip ask {
  participant asker { sends request Task  receives inform Task  process = Ask . Wait }
  participant teller [1..*] { sends inform Task  receives request Task  process = Tell }
  control asker {
    enter Ask : / send request Task to teller
    leave Wait : inform Task from teller or after(1s)
  }
  control teller { enter Tell : request Task from asker / send inform Task to asker }
}
srm boss {
  plays ask.asker
  liveness { boss = Look~ || (Rest . asker) }
  activities { Look takes 100ms  Rest takes 5s  Ask takes 1ms  Wait takes 1min }
}
srm worker {
  plays ask.teller
  liveness { worker = teller~ || Beside~ }
  activities { Tell takes 1ms  Beside takes 1h }
}
team T { ann : boss  tim, tom : worker }
""".replace("1h", "60min")


@pytest.fixture(scope="module")
def ask() -> Generated:
    return generate(ASK)


class Quitter:
    """What ends its agent after two seconds."""

    quits: ClassVar[tuple[str, ...]] = ()

    def execute(self, context: Context) -> None:
        context.wait(2)
        if context.agent in self.quits:
            raise RuntimeError("enough")


def quitting(*names: str) -> dict[str, type[Any]]:
    return {"Beside": type("Beside", (Quitter,), {"quits": names})}


def looking(look: Any, **more: Any) -> dict[str, type[Any]]:
    """`Look` of ann calls this with the context and what was seen before; its result is added."""

    class Look:
        seen: ClassVar[list[Any]] = []

        def execute(self, context: Context) -> None:
            found = look(context, self.seen)
            if found is not None:
                self.seen.append(found)

    return {"Look": type("Look", (Look,), more)}


def seen_by(run: Played, activities: dict[str, type[Any]], fails: bool = False) -> list[Any]:
    assert run.result.failed == fails, run.result
    return list(activities["Look"].seen)  # type: ignore[attr-defined]


def names(entries: tuple[Entry, ...]) -> list[str]:
    return [entry.name for entry in entries]


def test_agents_are_found_by_what_they_play(ask: Generated) -> None:
    def look(context: Context, seen: list[Any]) -> Any:
        directory = context.directory
        return [
            names(directory.search("ask.teller")),
            names(directory.search("ask.teller", most=1)),
            names(directory.search(protocol="ask")),
            names(directory.search(name="asker", ontology="S", language="json")),
            names(directory.search("ask.teller", agent="tom")),
            names(directory.search("ask.nobody")),
            [(item.name, item.state, item.role) for item in directory.residents()],
        ]

    code = looking(look)
    found = seen_by(play(ask, code, until=50 * MS), code)
    assert found == [
        [
            ["tim", "tom"],
            ["tim"],
            ["ann", "tim", "tom"],
            ["ann"],
            ["tom"],
            [],
            [("ann", "active", "boss"), ("tim", "active", "worker"), ("tom", "active", "worker")],
        ]
    ]


def test_who_has_ended_is_found_no_more(ask: Generated) -> None:
    def look(context: Context, seen: list[Any]) -> Any:
        states = [item.state for item in context.directory.residents()]
        found = names(context.directory.search("ask.teller")), states
        return (context.now_ns // MS, *found) if not seen or seen[-1][1:] != found else None

    code = {**looking(look), **quitting("tim")}
    assert seen_by(play(ask, code, until=3 * SECOND), code, fails=True) == [
        (0, ["tim", "tom"], ["active", "active", "active"]),
        (2000, ["tom"], ["active", "gone", "active"]),
    ]


def test_what_an_agent_offers_besides(ask: Generated) -> None:
    weather = Service("weather", "sky", properties=(("place", "Chania"),))

    def look(context: Context, seen: list[Any]) -> Any:
        directory, number = context.directory, context.now_ns // (100 * MS)
        if number == 1:
            directory.register(weather)
        elif number == 2:
            with pytest.raises(DirectoryError, match="ann has registered already"):
                directory.register(weather)
            directory.modify(Service("weather", "sea"), Service("tides"), lease=0.25)
        elif number == 6:
            with pytest.raises(DirectoryError, match="ann has registered nothing"):
                directory.deregister()
            directory.register(weather)
        elif number == 7:
            directory.deregister()
        return [
            [service.name for service in entry.services if service.type == "weather"]
            for entry in directory.search("weather")
        ]

    code = looking(look)
    # With `takes`, what an activity does counts at its end.
    run = play(ask, code, until=850 * MS)
    assert seen_by(run, code) == [[], [], [["sky"]], [["sea"]], [["sea"]], [["sea"]], [], [["sky"]], []]
    assert [(r["time"] // MS, r["what"], r.get("until", 0) // MS) for r in run.of("directory")] == [
        (200, "register", 0),
        (300, "modify", 550),
        (550, "expire", 0),
        (700, "register", 0),
        (800, "deregister", 0),
    ]
    assert run.of("directory")[0]["services"] == [
        {"type": "weather", "name": "sky", "properties": {"place": "Chania"}}
    ]


def test_properties_are_searched_for(ask: Generated) -> None:
    def look(context: Context, seen: list[Any]) -> Any:
        if context.now_ns == 0:
            context.directory.register(Service("weather", properties=(("place", "Chania"), ("from", "1"))))
        return [
            names(context.directory.search("weather", properties={"place": p})) for p in ("Chania", "Rome")
        ]

    code = looking(look)
    assert seen_by(play(ask, code, until=150 * MS), code)[-1] == [["ann"], []]


def test_who_subscribes_sees_what_changes(ask: Generated) -> None:
    kept: list[Any] = []

    class Beside:
        def execute(self, context: Context) -> None:
            context.wait(0.25)
            if context.agent == "tim":
                context.directory.register(Service("weather"), lease=0.5)
                context.wait(1)
                raise RuntimeError("enough")

    def look(context: Context, seen: list[Any]) -> Any:
        if not kept:
            kept.append(context.directory.subscribe("weather"))
            kept.append(context.directory.subscribe(agent="tim"))
        weather, tim = ([(c.what, c.entry.name) for c in item.changes()] for item in kept)
        return (context.now_ns // MS, weather, tim) if weather or tim else None

    code = {**looking(look), "Beside": Beside}
    generated = generate(ASK.replace("Beside takes 60min", "").replace("Beside~", "Beside"))
    run = play(generated, code, until=3 * SECOND)
    assert seen_by(run, code, fails=True) == [
        (300, [("modified", "tim")], [("modified", "tim")]),
        (800, [("modified", "tim")], [("modified", "tim")]),
        (1300, [], [("gone", "tim")]),
    ]


def test_who_looks_too_seldom_is_told_to_search_again(ask: Generated) -> None:
    team, _ = make(ask, until=MS)
    directory = team.conversations.directory
    since = directory.number()
    for number in range(5000):
        directory.register(Entry(AgentIdentifier(f"a{number}"), (Service("x"),)))
    changes = directory.changes(Entry(services=(Service("x"),)), since)
    assert (changes[0].what, len(changes)) == ("forgotten", 4097)
    assert directory.changes(Entry(), directory.number()) == ()
    team.run()


def test_who_is_gone_is_not_invited(ask: Generated) -> None:
    run = play(ask, quitting("tim"), until=7 * SECOND)
    assert [r["to"] for r in run.of("agent_message", agent="ann")] == [["tom"]]
    run = play(ask, quitting("tim", "tom"), until=7 * SECOND)
    assert run.of("agent_message") == []
    assert [r["reason"] for r in run.of("fault") if "code" not in r][-1] == (
        "request Task is not sent: ask takes one teller, and there is none"
    )


def test_a_robot_that_crashes_is_gone_until_it_is_back(ask: Generated) -> None:
    def look(context: Context, seen: list[Any]) -> Any:
        there = names(context.directory.search("ask.teller"))
        return (context.now_ns // MS, there) if not seen or seen[-1][1] != there else None

    code = looking(look)
    faults = Faults(crashes=(Crash("tim", 1 * SECOND, 1 * SECOND),))
    assert seen_by(play(ask, code, until=3 * SECOND, faults=faults), code) == [
        (0, ["tim", "tom"]),
        (1000, ["tom"]),
        (2000, ["tim", "tom"]),
    ]


def test_a_process_activity_does_not_see_it(ask: Generated) -> None:
    def look(context: Context, seen: list[Any]) -> Any:
        with pytest.raises(LookupError, match="a 'process' activity cannot reach the directory"):
            context.directory.search("ask.teller")
        return True

    code = looking(look, kind="process")
    assert seen_by(play(ask, code, until=50 * MS), code) == [True]
    code = looking(lambda context, seen: names(context.snapshot().directory.search("ask.teller")))
    assert seen_by(play(ask, code, until=50 * MS), code) == [["tim", "tom"]]


# ---- outsiders -----------------------------------------------------------------------------------


def df(*said: tuple[str, Any], to: str = "df", **more: Any) -> tuple[list[tuple[str, Any]], list[Record]]:
    """What `df` answers an outsider to these messages, one every 100 ms; and the trace."""
    team, records = make(_generated(), until=20 * SECOND)
    alice = Outside(team)
    for number, (act, content) in enumerate(said):
        alice.say(100 * number, act, content, to=to, reply_with=f"r{number}", **more)
    team.run()
    for record in records:
        check_line(record)
    assert all(message.sender == AgentIdentifier(to) for message in alice.heard)
    return alice.answers(), records


@cache
def _generated() -> Generated:
    return generate(ASK)


WEATHER = {"services": [{"type": "weather", "name": "sky", "properties": {"place": "Chania"}}]}
ALICE = {"name": "alice@elsewhere", **WEATHER}


def test_an_outsider_searches() -> None:
    wanted = {"services": [{"type": "ask.teller"}]}
    asked = {"action": "search", "description": wanted}
    everybody, one = df(("request", asked), ("request", {**asked, "max-results": 1}))[0]
    described = {
        "name": "tim",
        "services": [
            {
                "type": "ask.teller",
                "name": "teller",
                "protocols": ["ask"],
                "ontologies": ["S"],
                "languages": ["json"],
            }
        ],
        "protocols": ["ask"],
        "ontologies": ["S"],
        "languages": ["json"],
    }
    assert everybody == ("inform", {"action": "search", "result": [described, {**described, "name": "tom"}]})
    assert one == ("inform", {"action": "search", "result": [described]})


def test_an_outsider_registers() -> None:
    answers, records = df(
        ("request", {"action": "register", "description": {**WEATHER, "lease-time": 0.35}}),
        ("request", {"action": "search", "description": WEATHER}),
        ("request", {"action": "modify", "description": {**ALICE, "protocols": ["ask"]}}),
        ("request", {"action": "search", "description": {"protocols": ["ask"], **WEATHER}}),
        ("request", {"action": "deregister", "description": {"name": "alice@elsewhere"}}),
        ("request", {"action": "search", "description": WEATHER}),
        ("request", {"action": "register", "description": {**WEATHER, "lease-time": 0.05}}),
        ("request", {"action": "search", "description": WEATHER}),
        ontology="FIPA-Agent-Management",
        language="json",
        conversation="c1",
    )
    assert [(act, content["result"]) for act, content in answers] == [
        ("inform", [{**ALICE, "lease-time": 0.35}]),
        ("inform", [ALICE]),
        ("inform", [{**ALICE, "protocols": ["ask"]}]),
        ("inform", [{**ALICE, "protocols": ["ask"]}]),
        ("inform", []),
        ("inform", []),
        ("inform", [{**ALICE, "lease-time": 0.05}]),
        ("inform", []),
    ]
    told = [(r["agent"], r["what"]) for r in records if r["kind"] == "directory"]
    assert told == [
        ("alice@elsewhere", what) for what in ("register", "modify", "deregister", "register", "expire")
    ]


WRONG = {
    "what is not JSON": (("request", "(search)"), ("not-understood", "unrecognised-value")),
    "what is no object": (("request", "[]"), ("not-understood", "unrecognised-value")),
    "what is no text": (("request", b"\xff"), ("not-understood", "unrecognised-value")),
    "an act": (("propose", {}), ("not-understood", "unsupported-act")),
    "no act": (("shout", {}), ("not-understood", "unsupported-act")),
    "no action": (("request", {}), ("refuse", "missing-argument")),
    "an action": (("request", {"action": "dance"}), ("refuse", "unsupported-function")),
    "a parameter": (("request", {"action": "search", "x": 1}), ("refuse", "unexpected-parameter")),
    "a member": (
        ("request", {"action": "search", "description": {"x": 1}}),
        ("refuse", "unexpected-parameter"),
    ),
    "a description": (
        ("request", {"action": "search", "description": 3}),
        ("not-understood", "unrecognised-value"),
    ),
    "services": (
        ("request", {"action": "search", "description": {"services": {}}}),
        ("refuse", "unrecognised-parameter-value"),
    ),
    "a type": (
        ("request", {"action": "search", "description": {"services": [{"type": 3}]}}),
        ("refuse", "unrecognised-parameter-value"),
    ),
    "a list": (
        ("request", {"action": "search", "description": {"protocols": "ask"}}),
        ("refuse", "unrecognised-parameter-value"),
    ),
    "a number": (
        ("request", {"action": "search", "max-results": "all"}),
        ("refuse", "unrecognised-parameter-value"),
    ),
    "a lease": (
        ("request", {"action": "register", "description": {"lease-time": -1}}),
        ("refuse", "unrecognised-parameter-value"),
    ),
    "another agent": (
        ("request", {"action": "register", "description": {"name": "bob@elsewhere"}}),
        ("refuse", "unauthorised"),
    ),
    "one of the team": (
        ("request", {"action": "deregister", "description": {"name": "tim"}}),
        ("refuse", "unauthorised"),
    ),
    "nothing to modify": (
        ("request", {"action": "modify", "description": ALICE}),
        ("failure", "not-registered"),
    ),
    "nothing to take back": (("request", {"action": "deregister"}), ("failure", "not-registered")),
    "no conversation": (("subscribe", {}), ("refuse", "missing-parameter")),
    "no subscription": (("cancel", {}), ("failure", "not-registered")),
}


@pytest.mark.parametrize("case", WRONG)
def test_the_directory_says_what_is_wrong(case: str) -> None:
    said, wanted = WRONG[case]
    ((act, content),), records = df(said)
    assert (act, content["error"]) == wanted
    (told,) = [r for r in records if r["kind"] == "directory"]
    assert (told["agent"], told["what"], told["reason"]) == ("alice@elsewhere", act, content["reason"])


def test_an_agent_of_the_team_takes_what_is_for_the_directory() -> None:
    """On a network `df` has no address of its own."""
    answers, records = df(
        ("request", {"action": "register", "description": WEATHER}),
        ("request", {"action": "search", "description": WEATHER}),
        ("request", {"action": "get-description"}),
        to="tom",
        ontology="FIPA-Agent-Management",
    )
    assert [(act, content.get("result")) for act, content in answers] == [
        ("inform", [ALICE]),
        ("inform", [ALICE]),
        ("refuse", None),
    ]
    early = [r for r in records if r.get("time", 0) < 5 * SECOND]  # then the parts of the team end
    assert [r for r in early if r["kind"] in ("received", "unexpected")] == []


def test_who_registers_twice_is_told() -> None:
    register = ("request", {"action": "register", "description": ALICE})
    assert df(register, register)[0][1] == (
        "failure",
        {
            "error": "already-registered",
            "reason": "alice@elsewhere has registered already: it may modify that",
        },
    )


def test_other_ontologies_and_languages_are_not_understood() -> None:
    search = ("request", {"action": "search"})
    for wrong in ({"ontology": "weather"}, {"language": "kif"}):
        ((act, content),), _ = df(search, **wrong)
        assert (act, content["error"]) == ("not-understood", "unsupported-value")


def test_what_is_not_understood_is_not_answered() -> None:
    answers, records = df(("not-understood", {}))
    assert answers == []
    (told,) = [r for r in records if r["kind"] == "directory"]
    assert told["reason"] == "it does not understand df"


def test_an_outsider_subscribes_and_cancels(ask: Generated) -> None:
    team, _ = make(ask, quitting("tim"), until=7 * SECOND)
    alice, carol = Outside(team), Outside(team, "carol@elsewhere")
    description = {"description": {"services": [{"type": "ask.teller"}]}}
    alice.say(100, "subscribe", description, to="df", conversation="c1", protocol="fipa-subscribe")
    carol.say(1000, "request", {"action": "register", "description": description["description"]}, to="df")
    carol.say(3000, "request", {"action": "deregister"}, to="df")
    alice.say(4000, "cancel", {}, to="df", conversation="c1")
    carol.say(5000, "request", {"action": "register", "description": description["description"]}, to="df")
    team.run()
    agreed, found, came, quit, left, over = alice.heard
    assert {(m.conversation, m.protocol) for m in (agreed, found, came, quit, left)} == {
        ("c1", "fipa-subscribe")
    }
    answers = [content for _, content in alice.answers()]
    assert (agreed.performative, answers[0]) == ("agree", description)
    assert [item["name"] for item in answers[1]["result"]] == ["tim", "tom"]
    changes = [(c["what"], c["description"]["name"]) for a in answers[2:5] for c in a["changes"]]
    assert changes == [("registered", "carol@elsewhere"), ("gone", "tim"), ("gone", "carol@elsewhere")]
    assert (over.performative, answers[5]) == ("inform", {"result": []})


@pytest.mark.parametrize("ends", ["lease", "deregister"])
def test_a_subscription_outlives_what_its_owner_has_registered(ask: Generated, ends: str) -> None:
    team, _ = make(ask, until=7 * SECOND)
    alice, carol = Outside(team), Outside(team, "carol@elsewhere")
    mine: dict[str, Any] = {"services": [{"type": "weather"}]}
    tides = {"description": {"services": [{"type": "tides"}]}}
    if ends == "lease":
        mine["lease-time"] = 1
    alice.say(0, "request", {"action": "register", "description": mine}, to="df")
    alice.say(100, "subscribe", tides, to="df", conversation="c1")
    if ends == "deregister":
        alice.say(1000, "request", {"action": "deregister"}, to="df")
    carol.say(3000, "request", {"action": "register", **tides}, to="df")
    team.run()
    told = [content["changes"] for _, content in alice.answers() if "changes" in content]
    assert [(c["what"], c["description"]["name"]) for (c,) in told] == [("registered", "carol@elsewhere")]


@pytest.mark.parametrize("registered", [True, False])
def test_a_subscription_ends_when_its_owner_cannot_be_reached(ask: Generated, registered: bool) -> None:
    """Whether it has registered something itself or not."""
    team, _ = make(ask, until=7 * SECOND)
    alice, carol = Outside(team), Outside(team, "carol@elsewhere")
    tides = {"description": {"services": [{"type": "tides"}]}}
    if registered:
        alice.say(0, "request", {"action": "register", "description": {}}, to="df")
    alice.say(100, "subscribe", tides, to="df", conversation="c1")
    team.driver.at(1000 * MS, lambda: team.conversations.vanished("alice@elsewhere"))
    carol.say(3000, "request", {"action": "register", **tides}, to="df")
    team.run()
    assert [content for _, content in alice.answers() if "changes" in content] == []


def test_an_outsider_that_has_registered_to_play_a_participant_is_invited(ask: Generated) -> None:
    team, records = make(ask, quitting("tim", "tom"), until=7 * SECOND)
    alice = Outside(team)
    services = [{"type": "ask.teller", "protocols": ["ask"]}]
    alice.say(100, "request", {"action": "register", "description": {"services": services}}, to="df")
    alice.say(5500, "inform", {"n": 3}, to="ann", conversation="ask-ann-1")
    team.run()
    asked = alice.heard[1]
    assert (asked.performative, asked.protocol, asked.conversation) == ("request", "ask", "ask-ann-1")
    left = [
        r for r in records if r["kind"] == "conversation" and r["what"] == "leave" and r["agent"] == "ann"
    ]
    assert left[0]["time"] == 5500 * MS


def test_the_white_pages() -> None:
    answers, _ = df(
        ("request", {"action": "search"}),
        ("request", {"action": "search", "description": {"ownership": "boss"}}),
        ("request", {"action": "get-description"}),
        ("request", {"action": "register"}),
        ("subscribe", {}),
        to="ams",
    )
    assert [content.get("result", content.get("error")) for _, content in answers] == [
        [
            {"name": "ann", "state": "active", "ownership": "boss"},
            {"name": "tim", "state": "active", "ownership": "worker"},
            {"name": "tom", "state": "active", "ownership": "worker"},
        ],
        [{"name": "ann", "state": "active", "ownership": "boss"}],
        {
            "name": "S",
            "ap-services": [{"name": "df", "type": "fipa.df"}, {"name": "ams", "type": "fipa.ams"}],
        },
        "unsupported-function",
        "unsupported-act",
    ]


def test_it_is_the_same_in_real_time(ask: Generated) -> None:
    def look(context: Context, seen: list[Any]) -> Any:
        if not seen:
            context.directory.register(Service("weather"), lease=0.4)
        return len(context.directory.search("ask.teller")), len(context.directory.search("weather"))

    code = looking(look)
    run = play(ask, code, until=60 * SECOND, clock="real", stop=lambda team: _has_expired(code))
    assert set(seen_by(run, code)) == {(2, 1), (2, 0)}
    assert [r["what"] for r in run.of("directory")] == ["register", "expire"]


def _has_expired(code: dict[str, type[Any]]) -> str | None:
    seen = code["Look"].seen  # type: ignore[attr-defined]
    return "seen" if (2, 1) in seen and seen[-1] == (2, 0) else None


words = st.sampled_from(
    [
        *("action", "description", "max-results", "name", "services", "type", "lease-time", "properties"),
        *("register", "search", "modify", "deregister", "get-description", "protocols", "state", "x"),
        *("alice@elsewhere", "tim", "ask.teller", "ask"),
    ]
)
values = st.recursive(
    st.none() | st.booleans() | st.integers(-5, 10**20) | st.floats() | words | st.text(max_size=5),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(words, inner, max_size=4),
    max_leaves=8,
)
contents = st.one_of(
    values,
    st.fixed_dictionaries(
        {"action": words, "description": st.dictionaries(words, values, max_size=3)},
        optional={"max-results": values},
    ),
)


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(
    said=st.lists(
        st.tuples(
            st.sampled_from(["request", "subscribe", "cancel", "inform", "?"]),
            st.sampled_from(["df", "ams"]),
            contents.map(json.dumps) | st.text(max_size=8),
            st.sampled_from(["", "c1", "c2"]),
        ),
        max_size=10,
    )
)
def test_whatever_the_directory_is_asked_it_answers(
    ask: Generated, said: list[tuple[str, str, str, str]]
) -> None:
    team, records = make(ask, until=2 * SECOND)
    alice = Outside(team)
    for number, (act, to, content, conversation) in enumerate(said):
        alice.say(100 * number, act, content, to=to, conversation=conversation, reply_with=f"r{number}")
    result = team.run()
    assert not result.failed
    answered = [message.in_reply_to for message in alice.heard]
    assert [number for number in range(len(said)) if f"r{number}" not in answered] == []
    for record in records:
        if record["kind"] == "directory":
            check_line(record)
