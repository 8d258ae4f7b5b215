"""Scenarios and properties: forms, names and types in their statements."""

from __future__ import annotations

import re

import pytest

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import has_errors
from aseme_dsl.source import Source

MODEL = """system Pitch
enum Phase { READY PLAYING FINISHED }
message Ball { bool visible  double distance  int seen }
message Game { Phase phase }
message Pass { int to }
topic vision { state Ball }
topic game { state Game }
topic team { signal Pass }
aip attack {
  participant center     { process = Walk . PassBall }
  participant center_for { process = Run . Kick }
  outcome "The striker shoots."
}
srm player {
  plays attack.center, attack.center_for as striker
  var tries : int = 0
  liveness { player = (decide . (center | striker))~ || See~
             decide = Look . [Search] }
  activities {
    See every 30ms writes vision.state.Ball
    Look takes 20ms  Search takes 1s ends found, lost writes tries
    Walk takes 1s  PassBall takes 100ms  Run takes 1s  Kick takes 100ms
  }
  control decide {
    enter Search : Whistle [!vision.state.Ball.visible && tries < 3]
    skip Search  : else
  }
  control player {
    enter center : [game.state.Game.phase == Phase.PLAYING]
    enter striker : else
  }
}
srm keeper { liveness { keeper = Guard~ }  activities { Guard takes 100ms } }
team Pitch { robot1, robot2 : player  post : keeper }
"""


def problems(body: str, block: str = "scenario") -> list[tuple[str, str]]:
    """The errors in a scenario (or property) with this body, as code and underlined text."""
    found = analyse(Source("pitch.aseme", f'{MODEL}{block} "s" {{\n{body}\n}}\n')).diagnostics
    return [(item.code, item.span.text) for item in found if item.code.startswith("E")]


WHOLE = """
  robot1, robot2 : player
  network delay 0..300ms loss 20% reorder
  activity Search ends lost, lost, found takes 1s..3s sets tries = n + 1
  activity Walk takes normal(2s, 300ms)
  activity Look real
  activity Kick fails at 4s
  activity See writes vision.state.Ball { visible = true } every 33ms..50ms
  given ball.distance in 0..300
  given n in -1..3
  table (d, expected) { (50, Kick) (200.5, Walk) }
  world pitch:make  for 20s  points 3
  at 2s robot1 receives vision.state.Ball { visible = true  distance = d } from robot2
  at 2s robot1 receives vision.state.Ball { distance = ball.distance + n, visible = n > 2 }
  at 3s robot1 raises Whistle
  after 500ms in decide robot1 receives vision.state.Ball { visible = false }
  after 500ms sent team.signal.Pass : robot1 in Search
  from 3s for 2s robot2 loses radio  from 3s to 8s partition { robot1 } | { robot2 }
  crash robot1 at 6s   restart robot1 at 9s
  by 3s robot1 in expected
  at 3s not robot1 in (Walk or Run@striker) and (robot1 in Search or vision.state.Ball.distance + 1 < 2)
  within 200ms of game.state.Game.phase == Phase.READY  robot2 in Run@center_for
  never two of player in center
  in order PassBall@center, Kick@center_for
  no message team.signal.Pass before 1s  no sent Pass p by robot1 [p.to == 2] before 2s
  no received Pass by robot2 within 3s after sent team.signal.Pass p [p.to == 2]
  eventually outcome "The striker shoots." within 60s in 95% of 200 seeds
  always robot1 has [vision.state.Ball.visible && tries < 9]
  never fault  robot1 fails by 5s
"""


def test_every_form_is_read() -> None:
    assert problems(WHOLE) == []


def test_statements_are_separated_by_their_words() -> None:
    flat = re.sub(r"\s*\n\s*", " ", WHOLE)
    assert problems(flat) == []


def test_properties() -> None:
    body = """
      assume network delay 0..300ms loss 10%
      assume See writes vision.state.Ball every 33ms..100ms
      assume fair  assume See may fail  assume Search takes 1s..2s  assume at most 1 of player crash
      at most one center
      some player in Search before every player in center
      robot1 in center until sent Pass
      every game.state.Game.phase == Phase.FINISHED leads to post in Guard within 1s
    """
    assert problems(body, "property") == []


@pytest.mark.parametrize(
    ("line", "code", "place"),
    [
        ("robot2 : player  spare : playr", "E229", "playr"),
        ("robot2 : player  robot1 : keeper", "E230", "keeper"),
        ("activity Serch takes 1s", "E229", "Serch"),
        ("activity Search ends losst", "E229", "losst"),
        ("activity Walk ends lost", "E229", "lost"),
        ("activity Search sets trys = 3", "E229", "trys"),
        ("activity Search sets tries = true", "E500", "true"),
        ("activity Search takes 3s..1s", "E230", "3s..1s"),
        ("activity Search lasts 3s", "E117", "lasts"),
        ("always tries < 4", "E229", "tries"),
        ("always treis < 4", "E200", "treis"),
        ("network delay 300ms..0ms", "E036", "300ms..0ms"),
        ("network lag 3", "E117", "lag"),
        ("given n in 5..2", "E230", "5..2"),
        ("given n in 5s..2", "E230", "given n in 5s..2"),
        ("table (d, e) { (1) }", "E230", "(1)"),
        ("table (e) { (Kik) (Walk) }", "E229", "Kik"),
        ("at 2s robot1 recieves vision.state.Ball { }", "E117", "recieves"),
        ("at 2s robot1 receives vision.state.Bal { }", "E502", "Bal"),
        ("at 2s robot1 receives vision.state.Ball { visble = true }", "E501", "visble"),
        ("at 2s robot1 receives vision.state.Ball { visible = 3 }", "E500", "3"),
        ("at 2s robot3 receives vision.state.Ball { }", "E229", "robot3"),
        ("at 2s robot1 receives vision.state.Ball { } from robt", "E229", "robt"),
        ("at 2s robot1 raises Whistl", "E229", "Whistl"),
        ("robot1 raises Whistle", "E117", "robot1"),
        ("by 2 robot1 in Search", "E117", "2"),
        ("assume some player has [true]", "E117", "some"),
        ("assume robot1 in Search", "E117", "in"),
        ("assume every player in Search", "E117", "player in Search"),
        ("assume robo1 has [true]", "E229", "robo1"),
        ("assume robot1 has [3]", "E500", "3"),
        ("by 2s robot1 in Guard", "E229", "Guard"),
        ("by 2s robot1 in PassBall@centre", "E229", "centre"),
        ("by 2s robot1 in Kick@center", "E229", "Kick"),
        ("by 2s robot1 has [vision.state.Ball.seen]", "E500", "vision.state.Ball.seen"),
        ("robot1 in Search", "E117", "robot1 in Search"),
        ("by 3s robot1 Search", "E117", "robot1"),
        ("by 3s robot1 robot1 in Search", "E117", "robot1"),
        ("at 3s 3s robot1 raises Whistle", "E500", "3s"),
        ("no vision.state.Ball before 1s", "E117", "vision.state.Ball"),
        ("allways robot1 in Search", "E117", "allways"),
        ("every Search leads Kick", "E117", "Kick"),
        ("never two of playr in center", "E229", "playr"),
        ("at most 1 player in center", "E117", "player"),
        ('eventually outcome "The striker shots."', "E229", 'outcome "The striker shots."'[8:]),
        ("eventually robot1 in Kick in 195% of 2 seeds", "E230", "in 195% of 2 seeds"),
        ("no sent team.signal.Pass p [p.too == 1] before 1s", "E501", "too"),
        ("no sent Pas before 1s", "E229", "Pas"),
        ("from 8s to 3s robot1 loses radio", "E230", "8s to 3s"),
        ("from 8s to 9s robot1 in Search", "E117", "robot1 in Search"),
        ("crash robot9 at 3s", "E229", "robot9"),
        ("always fault", "E230", "fault"),
        ("always robot1 in Search &&", "E117", "&&"),
        ("always (robot1 in Search", "E117", "Search"),
        ("crash robot1", "E117", "robot1"),
        ("every robot1 in Search leads to Kick in 3s", "E117", "in"),
    ],
)
def test_one_mistake_is_one_message(line: str, code: str, place: str) -> None:
    """Also with sound statements around it; and the next mistake is still seen."""
    assert problems(f"by 1s robot2 in Run\n{line}\nnever robot2 in Run") == [(code, place)]
    assert (code, place) in problems(f"{line}\nnever robot2 in Rum")
    assert ("E229", "Rum") in problems(f"{line}\nnever robot2 in Rum")


def test_the_other_lines_of_a_statement_with_a_mistake_are_not_read() -> None:
    body = "by 1s robot1 on Search\n  and robot1\n  in Rum\nby 2s robot1 in Rim"
    assert problems(body) == [("E117", "robot1"), ("E229", "Rim")]


@pytest.mark.parametrize("depth", [99, 110, 5000])
def test_conditions_may_be_nested_up_to_a_limit(depth: int) -> None:
    found = problems("always " + "(" * depth + "robot1 in Search" + ")" * depth, "property")
    assert [code for code, _ in found] == ([] if depth < 100 else ["E103"])


def test_what_could_not_be_read_is_not_missing() -> None:
    """A formula that cannot be read has no states; that is no reason to report a scenario."""
    text = MODEL.replace("(decide . (center | striker))~", "(decide . . (center | striker))~")
    found = analyse(Source("pitch.aseme", text + 'scenario "s" { by 2s robot1 in Search }')).diagnostics
    assert [item.code for item in found if item.code[0] == "E"] == ["E101"]


def test_a_property_has_no_moments() -> None:
    assert problems("at 2s robot1 in Search", "property") == [("E117", "at")]
    assert problems("always robot3 in Search", "property") == [("E229", "robot3")]


@pytest.mark.parametrize(
    ("name", "hint"), [("robot1", "write `robot1 in Search`"), ("player", "write `player in Search`")]
)
def test_an_agent_or_a_role_is_no_participant(name: str, hint: str) -> None:
    text = f'{MODEL}property "p" {{ never Search@{name} }}'
    found = next(item for item in analyse(Source("pitch.aseme", text)).diagnostics if item.code[0] == "E")
    assert (found.code, found.hint) == ("E229", hint)


def test_the_role_of_an_agent_in_a_property_is_that_of_the_team() -> None:
    wrong = 'by 1s robot1 in Run\nrobot1 : playr\n}\nproperty "p" {\nalways robot1 has [tries < 3]'
    assert problems(wrong) == [("E229", "playr")]


def test_agents_of_a_scenario_are_those_that_it_lists() -> None:
    assert problems("robot1 : player\nby 1s robot2 in Run") == [("E229", "robot2")]
    assert problems("spare[1..3] : player\nby 1s spare3 in Run") == []


def test_a_missing_brace_is_one_message() -> None:
    assert [code for code, _ in problems("at 2s robot1 receives vision.state.Ball { visible = true")] == [
        "E111"
    ]


def test_names_behind_an_alias() -> None:
    away = """system Away
    message Whistle { int number }
    topic judge { signal Whistle }
    srm thief { liveness { thief = Steal~ }  activities { Steal takes 1s } }
    """
    home = """system Home
    import "away.aseme" as away
    srm guard { liveness { guard = Wait~ }  activities { Wait takes 1s } }
    team Home { one : guard  two : away.thief }
    scenario "s" {
      one : guard  two : away.thief
      at 1s two receives away.judge.signal.Whistle { number = 1 }
      by 2s two in Steal
      by 2s two in Steel
    }
    """
    found = analyse(Source("home.aseme", home), sources={"away.aseme": away}).diagnostics
    assert [(item.code, item.span.text) for item in found if item.code[0] == "E"] == [("E229", "Steel")]
    assert has_errors(found)


def test_a_title_stands_for_one_scenario() -> None:
    """A property may have the title of a scenario."""
    text = f'{MODEL}scenario "s" {{ }}\nproperty "s" {{ always robot1 in player }}\nscenario "s" {{ }}\n'
    found = [item for item in analyse(Source("pitch.aseme", text)).diagnostics if item.code == "E201"]
    assert [(item.message, item.span.start) for item in found] == [
        ("the scenario `s` is declared twice", text.rindex('"s"'))
    ]


def test_a_word_of_a_rule_before_a_rule_is_a_condition_that_is_not_there() -> None:
    assert problems("robot1 : player  never in order Walk, Run  for 2s") == [("E229", "in")]


def test_an_input_is_not_a_time() -> None:
    text = f'{MODEL}scenario "s" {{ given t in 1s..5s  at t robot1 raises Whistle }}\n'
    [found] = [item for item in analyse(Source("pitch.aseme", text)).diagnostics if item.code == "E117"]
    assert found.span is not None and found.span.text == "t"
    assert found.hint is not None and found.hint.startswith("write the time itself")


def test_a_variable_of_a_participant_that_is_played_once() -> None:
    part = "participant center     { var best : int = 2  process = Walk . PassBall }"
    text = MODEL.replace("participant center     { process = Walk . PassBall }", part)
    text += 'scenario "s" { by 2s robot1 has [best == 2]  by 3s robot1 has [bets == 2] }\n'
    found = analyse(Source("pitch.aseme", text)).diagnostics
    wrong = [(item.code, item.span.text) for item in found if item.code[0] == "E" and item.span is not None]
    assert wrong == [("E200", "bets")]


@pytest.mark.parametrize(
    ("body", "found"),
    [
        ("robot1, robot1 : player by 1s robot1 in See", [("E230", "robot1")]),
        ("robot1 : player  post : keeper  robot1 : player by 1s post in Guard", [("E230", "robot1")]),
        ("for 3s by 1s post in Guard for 4s", [("E230", "for 4s")]),
        ("network loss 1% by 1s post in Guard network delay 3s", [("E230", "network delay 3s")]),
        ("world by 1s post in Guard world a:b", [("E230", "world a:b")]),
        ("activity See real by 1s post in Guard activity See takes 1s", [("E230", "activity See takes 1s")]),
        ("activity See real takes 1s by 1s post in Guard", [("E230", "activity See real takes 1s")]),
        ("table (a) { (1) } table (b) { (1) } by 1s post in Guard", [("E230", "table (b) { (1) }")]),
        ("table (a) { } by 1s post in Guard", [("E230", "table (a) { }")]),
        ("restart robot1 at 3s", [("E230", "restart robot1 at 3s")]),
        ("restart robot1 at 3s crash robot1 at 4s", [("E230", "restart robot1 at 3s")]),
        ("crash robot1 at 3s restart robot1 at 3s", []),
        ("crash robot1 at 3s crash robot1 at 4s", [("E230", "crash robot1 at 4s")]),
        ("crash robot1 at 3s restart robot1 at 4s crash robot1 at 5s", []),
        ("", []),
        ("for 3s by 4s post in Guard", [("E230", "4s")]),
        ("for 3s no sent Pass before 4s", [("E230", "4s")]),
        ("for 3s robot1 fails by 5s", [("E230", "5s")]),
        ("for 3s from 1s to 4s post loses radio by 3s post in Guard", []),
        ("from 1s to 2s partition { robot1 } | { robot2 }", [("E230", "partition { robot1 } | { robot2 }")]),
        ("from 1s to 2s partition { robot1, post } | { robot2 }", []),
        ("at 1s robot1 receives Pass { to = 1 }", [("E230", "Pass")]),
        ("always vision.state.Ball.visible", [("E230", "vision.state.Ball.visible")]),
        ("robot1 : player always vision.state.Ball.visible", []),
    ],
)
def test_what_does_not_go_together(body: str, found: list[tuple[str, str]]) -> None:
    assert problems(body) == found


UNREAD = """system Pitch
message Ball { int distance }
topic vision { state Ball  signal Ball }
let near = vision.state.Ball.distance < 10
srm seer   { liveness { seer = Look . [Run] }  control seer { enter Run : [near]  skip Run : else } }
srm writer { liveness { writer = Look . Run }
  control writer { enter Run : / vision.state.Ball.distance = 3; write_messages.vision.state.Ball } }
srm runner { liveness { runner = Run } }
team Pitch { ann : seer  bob : runner  cid : writer }
"""


@pytest.mark.parametrize(
    ("body", "place"),
    [
        pytest.param('property "p" { never bob has [near] }', "near", id="a let"),
        pytest.param(
            'property "p" { never runner has [vision.state.Ball.distance > 3 && near] }',
            "vision.state.Ball.distance",
            id="of a role, once",
        ),
        pytest.param(
            'property "p" { never ann has [has(vision.signal.Ball)] }',
            "vision.signal.Ball",
            id="of another kind",
        ),
        pytest.param('scenario "s" { by 3s bob has [near] }', "near", id="in a scenario"),
        pytest.param('property "p" { never ann has [near] }', None, id="it is read"),
        pytest.param('property "p" { never cid has [near] }', None, id="its action fills it"),
        pytest.param(
            'property "p" { never bob has [near] }\n'
            'scenario "s" { at 1s bob receives vision.state.Ball { distance = 3 }  by 3s bob has [near] }',
            None,
            id="a scenario gives it",
        ),
    ],
)
def test_a_condition_on_what_an_agent_does_not_read(body: str, place: str | None) -> None:
    found = analyse(Source("pitch.aseme", UNREAD + body)).diagnostics
    told = [item.span.text for item in found if item.code == "W231" and item.span is not None]
    assert told == ([] if place is None else [place])
