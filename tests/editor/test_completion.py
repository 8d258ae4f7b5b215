"""What is offered while somebody types, place by place."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.compiler.read.builtins import FORMS
from aseme_dsl.editor.typing.items import ItemKind
from aseme_dsl.editor.typing.names import NEW, PLACES
from aseme_dsl.editor.typing.snippets import WHOLE, filled
from aseme_dsl.grammar.parsing.expected import all_places, expected_after
from tests.conftest import Snapshot
from tests.editor.authoring import CURSOR, accepted, labels, listed, offered
from tests.support.compiling import codes

ROOT = Path(__file__).parents[2]
WAREHOUSE = (ROOT / "tests/acceptance/contract_net.aseme").read_text("utf-8")
SOCCER = (ROOT / "tests/acceptance/kouretes.aseme").read_text("utf-8")


def at(text: str, before: str, typed: str = "") -> str:
    """The text with the cursor right behind the first `before`, where `typed` has been typed."""
    index = text.index(before) + len(before)
    return text[:index] + typed + CURSOR + text[index:]


def instead(text: str, old: str, new: str) -> str:
    """The text with `new`, in which the cursor stands, instead of the first `old`."""
    assert old in text
    return text.replace(old, new, 1)


# ---- the grammar says what may come -------------------------------------------------------------


def test_every_place_of_the_grammar_has_an_answer() -> None:
    places = {
        (rule, attribute)
        for rule, attribute, terminal in all_places()
        if terminal
        in (
            "Name",
            "EntryName",
            "ActName",
            "ActivityName",
            "NodeName",
            "RoleName",
            "SystemName",
            "IncludedName",
            "OutcomeName",
            "Reference",
            "EntryReference",
            "ProtocolName",
        )
        or terminal in ("Path", "Text", "Label")
    }
    assert places - PLACES.keys() - NEW == set()
    assert (PLACES.keys() | NEW) - places == set()


def test_every_declaration_is_offered_as_a_whole() -> None:
    words = {word for item in expected_after("") for word in item.words} - {"language"}
    found = {item.label for item in offered("system Test\n‸")}
    assert words == found
    headless = {"import", "let", "function", "scenario", "property"}  # one line, or still to be designed
    assert words - headless == set(WHOLE)


@pytest.mark.parametrize("word", sorted(WHOLE))
def test_a_whole_declaration_can_be_compiled(word: str) -> None:
    text = filled(WHOLE[word])
    others = {
        "team": "system T\nsrm role { liveness { role = A } }\n",
        "topic": "system T\nmessage Message { bool it }\n",
        "system": "",
    }
    errors = [code for code in codes(others.get(word, "system T\n") + text) if code[0] == "E"]
    assert errors == []


# ---- at the top ----------------------------------------------------------------------------------


def test_nothing_is_offered_in_a_comment_or_in_a_text() -> None:
    assert labels("system T // a word‸") == []
    assert labels("system T /* a\n word‸ */") == []
    assert labels('system T\nsag { actor a { goal g "to‸" } }') == []


def test_imports_are_libraries_and_neighbours(tmp_path: Path) -> None:
    (tmp_path / "field.aseme").write_text("message M { bool b }")
    (tmp_path / "body.proto").write_text("")
    (tmp_path / "notes.txt").write_text("")
    path = str(tmp_path / "team.aseme")
    assert labels("system T\nimport ‸", path) == [
        *("math", "protocols", "resources", "runtime", "soccer", "time"),
        *('"body.proto"', '"field.aseme"'),
    ]
    assert labels('system T\nimport "fi‸"', path) == ["body.proto", "field.aseme"]


def test_types_of_fields_and_variables() -> None:
    text = "system T\nenum E { A }\nmessage M { bool b }\nmessage N { ‸ }\n"
    assert labels(text) == [
        *("bool", "int", "double", "string", "bytes", "duration"),
        *("E", "M", "N", "optional", "repeated"),
    ]
    text = "system T\nenum E { A }\nmessage M { bool b }\nsrm r { var x : ‸ }\n"
    assert labels(text) == ["bool", "int", "double", "string", "duration", "agent", "E", "M", "list"]
    text = "system T\nenum E { A }\nmessage M { bool b }\nsrm r { var x : list of ‸ }\n"
    assert labels(text) == ["bool", "int", "double", "string", "duration", "agent", "E", "M"]


def test_members_of_the_message_in_a_variable() -> None:
    text = "system T\nmessage P { int y }\nmessage M { bool b  P p }\nsrm r { var x : M  let z = x\n"
    text += "liveness { r = A . B } control r { enter B : [CURSOR] } }"
    assert labels(text.replace("CURSOR", "x.‸")) == ["b", "p"]
    assert labels(text.replace("CURSOR", "x.p.‸")) == ["y"]
    assert labels(text.replace("CURSOR", "z.‸")) == ["b", "p"]


def test_an_initial_value_is_a_constant_of_its_type() -> None:
    text = "system T\nenum E { A B }\nsrm r { var x : E = ‸ liveness { r = Work } }\n"
    assert labels(text) == ["E.A", "E.B"]


# ---- messages and topics -------------------------------------------------------------------------


def test_a_topic_offers_messages_it_does_not_carry_yet() -> None:
    text = "system T\nmessage A { bool x }\nmessage B { bool x }\ntopic t { state A, ‸ }\n"
    assert labels(text) == ["B", "A"]


def test_behind_the_messages_of_a_topic() -> None:
    text = "system T\nmessage A { bool x }\ntopic t { state A ‸ }\n"
    assert labels(text)[:4] == ["from", "every", "expires", "queued"]


def test_signals_that_a_state_ignores() -> None:
    text = instead(SOCCER, "  control decision {", "  control decision {\n    on decision : ‸")
    assert "ignores" in labels(text)
    assert "ignores" not in labels(text.replace("on decision", "leave decision"))
    assert labels(text.replace("‸", "ignores team.signal.‸")) == ["Pass"]


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        ("[vision.‸]", ["state", "data"]),
        ("[vision.state.‸]", ["Ball"]),
        ("[vision.state.Ball.‸]", ["visible", "distance", "bearing", "speed"]),
        ("[robot1.vision.‸]", ["state", "data"]),
        ("[keeper.vision.data.BallTrack.be‸]", ["distance", "bearing"]),
        ("[PlayerState.‸]", ["INITIAL", "READY", "SET", "PLAYING", "FINISHED", "PENALISED"]),
        ("/ write_messages.‸", ["game", "vision", "world", "body", "motion", "my", "team"]),
        ("/ write_messages.team.‸", ["state", "signal"]),
        ("/ team.signal.Pass.‸", ["to"]),
        ("[ball.‸]", ["visible", "distance", "bearing", "speed"]),
    ],
)
def test_segment_by_segment(written: str, expected: list[str]) -> None:
    text = instead(SOCCER, "[!vision.state.Ball.visible]", written)
    text = instead(text, "  control decision {", "  let ball = vision.state.Ball\n  control decision {")
    assert [label for label in labels(text) if label in expected or len(expected) < 5] == expected


def test_activities_read_and_write_channels() -> None:
    assert labels(at(SOCCER, "writes vision.")) == ["state", "data"]
    assert labels(at(SOCCER, "writes vision.state.")) == ["Ball"]
    assert labels(at(SOCCER, "reads vision.state.Ball writes "))[:3] == ["game", "vision", "world"]


# ---- formulas and control ------------------------------------------------------------------------


def test_only_terms_that_the_verb_fits() -> None:
    control = "control goalie {\n    "
    assert labels(at(SOCCER, control, "repeat ")) == ["Sensors", "Vision", "(Guard | NoGame)"]
    assert labels(at(SOCCER, control, "finish ")) == ["(Sensors~ || Vision~ || (Stand . (Guard | NoGame)+))"]
    assert "Guard" in labels(at(SOCCER, control, "leave "))
    assert "Stand" not in labels(at(SOCCER, control, "leave "))


def test_terms_without_a_line_come_first() -> None:
    found = labels(
        instead(SOCCER, "    enter ClearBall   : [can_kick(vision.state.Ball)]\n", "    enter ‸\n")
    )
    assert found == ["ClearBall", "ScanForBall", "FollowBall"]
    found = labels(instead(SOCCER, "    enter FollowBall  : [vision.state.Ball.visible]\n", "    enter ‸\n"))
    assert found[0] == "FollowBall"


def test_terms_of_formulas_inside_that_have_no_block() -> None:
    text = (
        "system T\nsrm r {\n  liveness { r = A . work  work = B | (C . A)  rest = D }\n"
        "  control r { enter ‸ }\n}\n"
    )
    assert labels(text) == ["A", "work", "B", "(C . A)", "C"]
    assert labels(text.replace("control r", "control work { enter B : else }  control r")) == ["A", "work"]


def test_a_term_that_stands_twice_has_its_number() -> None:
    text = "system T\nsrm r {\n  liveness { r = A . B . A }\n  control r { enter ‸ }\n}\n"
    assert labels(text) == ["A#1", "B", "A#2"]


def test_a_term_replaces_what_has_been_typed_of_it() -> None:
    text = "system T\nsrm r {\n  liveness { r = X . [A . B] }\n  control r { skip (A . b‸ }\n}\n"
    (item,) = offered(text)
    assert accepted(text.replace(CURSOR, ""), item).splitlines()[3] == "  control r { skip (A . B) }"


def test_terms_of_a_participant_and_of_its_helpers() -> None:
    text = (
        "system T\naip p {\n participant a { process = X . help  help = Y | Z }\n"
        " participant b { process = W }\n control help { enter ‸ }\n}\n"
    )
    assert labels(text) == ["Y", "Z"]
    assert labels(text.replace("control help", "control b")) == ["W"]


def test_on_abandon_is_offered_for_a_participant_only() -> None:
    text = (
        "system T\naip p {\n participant a { process = X . help  help = Y | Z }\n"
        " control a { on ‸ }\n}\nsrm r { liveness { r = Q } }\n"
    )
    assert "abandon" in labels(text)
    assert "abandon" not in labels(text.replace("control a", "control help"))
    role = text.replace("control a { on ‸ }", "").replace("= Q }", "= Q } control r { on ‸ }")
    assert "abandon" not in labels(role)


def test_a_formula_offers_what_is_not_used_yet_first() -> None:
    found = labels(instead(WAREHOUSE, "(NextTask . manager)~", "(NextTask . ‸)~"))
    assert found[0] == "manager"
    assert labels(at(SOCCER, "initialize = Stand . Calib"))[0] == "center"
    assert "initialize" not in labels(at(SOCCER, "initialize = Stand . Calib"))


def test_a_formula_offers_the_others_whichever_is_typed() -> None:
    text = "system T\nsrm r {\n liveness {\n  r = ‸\n  part = A . B\n }\n}\n"
    assert labels(text)[0] == "part"
    text = "system T\naip p { participant a { process = ‸ help = A . B } participant b { process = C } }\n"
    assert labels(text)[0] == "help"


def test_behind_an_operand_no_operand_is_offered() -> None:
    found = labels("system T\nsrm r { liveness { r = A ‸ } }")
    assert found == ["A"]  # the formula that comes next


def test_answers_are_counted_of_participants() -> None:
    text = instead(WAREHOUSE, "inform Done from contractor or", f"when [all_answered({CURSOR})]  //")
    assert labels(text)[:2] == ["manager", "contractor"]


def test_a_message_may_come_from_the_agent_that_a_variable_holds() -> None:
    text = instead(WAREHOUSE, "var bids : int = 0", "var best : agent")
    assert "best" in labels(instead(text, "inform Done from contractor", f"inform Done from {CURSOR}"))


def test_the_activities_of_a_participant_may_send_its_messages() -> None:
    text = instead(WAREHOUSE, "accept_proposal Award, reject", f"accept_proposal Award by {CURSOR}, reject")
    assert labels(text)[:2] == ["Announce", "CollectBids"]


def test_control_is_offered_for_formulas_that_have_none() -> None:
    text = instead(SOCCER, "  control Guard {", "  control ‸ {")
    assert labels(text) == ["Guard", "goalie"]
    text = instead(WAREHOUSE, "  control manager {", "  control ‸ {")
    assert labels(text) == ["manager", "contractor"]


# ---- transition expressions ----------------------------------------------------------------------


INCLUDED = """\
system Twins
message Count { int number }
topic board { state Count }
abstract srm walker {
  var steps : int = 0
  liveness { walk = Step . Rest  back = Rest }
  activities { Step takes 1s  Rest takes 1s }
}
srm robot {
  includes walker
  liveness { robot = (walk | Wait)~ }
  activities { Wait takes 1s }
  control robot { enter walk : [board.state.Count.number > 0]  enter Wait : else }
  control walk {
    enter Step : [true]
  }
}
"""


def test_what_a_role_includes_counts_as_its_own() -> None:
    assert labels(at(INCLUDED, "[true]\n", "    enter ")) == ["Rest", "Step"]
    assert labels(instead(INCLUDED, "control walk", f"control {CURSOR}")) == ["walk", "back", "robot"]
    assert labels(instead(INCLUDED, "(walk", f"({CURSOR}"))[:2] == ["walk", "back"]
    assert "steps" in labels(instead(INCLUDED, "[true]", f"[{CURSOR}]"))
    assert "Step" not in labels(instead(INCLUDED, "{ Wait takes", f"{{ {CURSOR} Wait takes"))


def test_an_event_that_the_participant_receives() -> None:
    found = labels(instead(WAREHOUSE, "cfp Task from manager", "‸"))
    assert found[:4] == [
        "[…]",
        "cfp Task from manager",
        "accept_proposal Award from manager",
        "reject_proposal Award from manager",
    ]
    assert len([name for name in found if name in ("cfp", "inform", "propagate", "subscribe")]) == 4


def test_word_by_word_through_a_received_message() -> None:
    def when(typed: str) -> list[str]:
        return labels(instead(WAREHOUSE, "cfp Task from manager", typed))

    assert when("accept_proposal ‸") == ["Award"]
    assert when("accept_proposal Award ‸") == ["from"]
    assert when("accept_proposal Award from ‸") == ["manager", "contractor"]


def test_word_by_word_through_a_sent_message() -> None:
    def then(typed: str) -> list[str]:
        return labels(instead(WAREHOUSE, "send propose Bid to manager", typed))

    assert then("‸")[:3] == [
        "send propose Bid to manager",
        "send refuse Task to manager",
        "send inform Done to manager",
    ]
    assert then("send ‸")[:4] == ["inform", "propose", "refuse", "accept_proposal"]
    assert len(then("send ‸")) == 22
    assert then("send propose ‸") == ["Bid"]
    assert then("send propose Bid ‸") == ["to"]
    assert then("send propose Bid to ‸") == ["manager", "contractor"]


def test_messages_with_names_and_members() -> None:
    def when(typed: str) -> list[str]:
        return labels(instead(WAREHOUSE, "cfp Task from manager", typed))

    assert when("accept_proposal Award a ‸") == ["from"]
    assert when("accept_proposal Award a from ‸") == ["manager", "contractor"]
    assert when("lost ‸") == ["manager", "contractor"]

    def then(typed: str) -> list[str]:
        return labels(instead(WAREHOUSE, "send propose Bid to manager", typed))

    assert then("send propose Bid { ‸") == ["task", "cost"]
    assert then('send propose Bid { task = "a"  ‸') == ["task", "cost"]
    assert "reachable" in then("send propose Bid { cost = ‸")
    assert then('send propose Bid { task = "a" } ‸') == ["to"]
    assert then('send propose Bid { task = "a" } to ‸') == ["manager", "contractor"]
    assert then("send propose Bid to manager except ‸") == ["manager", "contractor"]


def test_a_message_that_is_made() -> None:
    text = (
        "system T\nmessage Place { int y }\nmessage Order { int id  string item  Place place }\n"
        "topic desk { signal Order from r }\n"
        "srm r { var now : Order  var n : int = 0  var queue : list of Order\n"
        "liveness { r = A . B } control r { enter B : [n > 2] / ACTION } }\n"
    )

    def then(typed: str) -> list[str]:
        return labels(text.replace("ACTION", typed))

    assert then("now = ‸")[:3] == ["desk.signal.Order", "now", "Order"]
    assert [then(f"n = {form}(‸")[0] for form in ("find", "size")] == ["queue", "queue"]
    assert then("n = find(queue.‸") == ["id", "item", "place"]
    assert "clear" in then("‸")
    assert then("append(queue, ‸")[:3] == ["desk.signal.Order", "now", "Order"]
    for begun in ("now = Order { ", "append(queue, Order { id = n, ", "write_messages.desk.signal.Order { "):
        assert then(f"{begun}‸") == ["id", "item", "place"]
        assert then(f"{begun}‸ }}") == ["id", "item", "place"]
        assert then(f"{begun}place.‸") == ["y"]
        assert then(f"{begun}id = queue[0].‸") == ["id", "item", "place"]
        assert then(f"{begun}id = ‸")[:2] == ["now", "n"]
    assert then("append(queue, Order { id = n, .. }); ‸")[:3] == ["now", "n", "queue"]


def test_the_constants_of_the_enum_that_is_compared() -> None:
    text = instead(SOCCER, "player_state == PlayerState.PLAYING", "player_state == ‸")
    assert labels(text)[:3] == ["PlayerState.INITIAL", "PlayerState.READY", "PlayerState.SET"]


def test_what_has_the_type_of_the_argument_comes_first() -> None:
    text = instead(
        SOCCER, "enter ClearBall   : [can_kick(vision.state.Ball)]", "enter ClearBall : [can_kick(‸)]"
    )
    first, *_ = offered(text)
    assert (first.label, first.kind) == ("vision.state.Ball", ItemKind.MESSAGE)


def test_variables_and_lets_of_this_participant_only() -> None:
    text = instead(WAREHOUSE, "[bids > 0]", "[‸]")
    assert labels(text)[0] == "bids"
    assert "reachable" not in labels(text)
    assert "can_pass" in labels(instead(SOCCER, "[can_pass]", "[‸]"))


def test_chance_is_offered_in_actions_but_not_in_conditions() -> None:
    assert "random" in labels(instead(INCLUDED, "[true]", f"/ steps = {CURSOR}"))
    assert "random" not in labels(instead(INCLUDED, "[true]", f"[{CURSOR}]"))
    assert "random" not in labels(instead(INCLUDED, "[true]", f"[steps > abs({CURSOR})]"))


@pytest.mark.parametrize(
    "place", ["enter Step : after(‸", "var steps : double = ‸", "let x = 1 enter Step : after(2 * ‸"]
)
def test_chance_is_not_offered_where_it_may_not_be(place: str) -> None:
    text = "system T\nsrm r {\n  liveness { r = Step . Rest }\n  "
    text += place if place.startswith("var") else f"control r {{ {place}"
    found = labels(text)
    assert "random" not in found and "abs" in found


def test_members_of_an_element_of_a_list() -> None:
    text = (
        "system T\nmessage Ball { double x double y }\nmessage Seen { repeated Ball balls int count }\n"
        "topic eyes { state Seen }\nlet seen = eyes.state.Seen\n"
        "srm r { liveness { r = A . B } control r { enter B : [‸] } }\n"
    )
    for path in ("eyes.state.Seen.balls[0].", "eyes.state.Seen.balls[seen.count - 1].", "seen.balls[0]."):
        assert labels(text.replace("‸", f"{path}‸")) == ["x", "y"]
        assert labels(text.replace("‸", f"1 < {path}x && abs({path}‸")) == ["x", "y"]
    assert labels(text.replace("‸", "seen.balls[seen.‸")) == ["balls", "count"]


def test_statements_of_scenarios_name_what_there_is() -> None:
    for word in ("scenario", "property"):
        text = instead(SOCCER, "\nscenario ", f'\n{word} "x" {{\n  {CURSOR}\n}}\nscenario ')
        found = labels(text)
        assert {"robot1", "center", "ScanForBall", "decision", "vision"} <= set(found)
        assert labels(text.replace(CURSOR, f"vision.{CURSOR}"))[:1] == ["state"]
        assert "Ball" in labels(text.replace(CURSOR, f"vision.state.{CURSOR}"))
        assert "visible" in labels(text.replace(CURSOR, f"when vision.state.Ball.{CURSOR}"))
        assert labels(text.replace(CURSOR, f"given {{ robot1 in Sc{CURSOR} }}")) != []


@pytest.mark.parametrize(
    ("line", "some", "none"),
    [
        ("‸", ["always", "at", "crash", "robot1", "ScanForBall"], ["receives"]),
        ("by 2s robot1 ‸", ["in", "has", "receives"], ["robot1", "vision"]),
        ("by 2s robot1 in Sc‸", ["ScanForBall", "player"], ["robot1", "NoSuchState", "goalie"]),
        ("by 2s robot1 in (ScanForBall or ‸", ["ScanForBall"], ["robot1"]),
        ("at 2s robot1 receives ‸", ["vision", "game"], ["ScanForBall"]),
        ("at 2s robot1 receives vision.state.Ball { ‸", ["visible", "distance"], ["robot1"]),
        ("at 2s robot1 receives vision.state.Ball { visible = true  ‸", ["distance"], ["robot1"]),
        ("no sent ‸", ["Ball", "vision"], ["robot1"]),
        ("activity ‸", ["CheckForBallObservation"], ["robot1"]),
        ("activity CheckForBallObservation ‸", ["takes", "ends", "writes"], ["robot1"]),
        ("never ScanForBall@‸", ["center"], ["robot1"]),
        ("from 1s for 2s robot1 loses ‸", ["radio"], ["robot1"]),
        ("one : ‸", ["player"], ["robot1"]),
        ("always some ‸", ["player"], ["robot1"]),
        ("eventually outcome ‸", ['"The center_for shoots to goal."'], ["robot1"]),
    ],
)
def test_words_of_a_statement(line: str, some: list[str], none: list[str]) -> None:
    text = instead(SOCCER, "\nscenario ", f'\nscenario "x" {{\n  robot1 : player\n  {line}\n}}\nscenario ')
    found = labels(text)
    assert [label for label in some if label not in found] == []
    assert [label for label in none if label in found] == []


def test_timers_and_events_that_are_known() -> None:
    text = instead(SOCCER, "[expired(pace)", "[expired(‸)")
    assert labels(text) == ["pace"]
    text = "system T\nsrm r {\n liveness { r = A . B . C }\n control r { enter B : alarm  enter C : ‸ }\n}\n"
    assert "alarm" in labels(text)


def test_states_that_can_be_asked_for() -> None:
    text = instead(SOCCER, "[vision.state.Ball.visible]", "[in(‸")
    assert labels(text)[:3] == ["player", "initialize", "activate"]
    assert "ScanForBall" in labels(text)


PARAMETERS = """system T
enum Place { HOME FIELD }
srm r {
 var here : Place = Place.HOME
 liveness { r = deliver(Place.HOME, here)  deliver(from, to) = MoveTo(‸from) . Grasp . MoveTo(to) }
 activities { MoveTo(goal : Place)  Grasp takes 1s }
}
"""


def test_what_activities_and_formulas_are_given() -> None:
    assert labels(PARAMETERS)[:5] == ["from", "to", "here", "Place.HOME", "Place.FIELD"]
    text = PARAMETERS.replace(CURSOR, "")
    assert labels(text.replace("MoveTo(from)", "MoveTo(Place.‸)")) == ["HOME", "FIELD"]
    assert labels(text.replace("goal : Place", "goal : ‸"))[:2] == ["bool", "int"]


@pytest.mark.parametrize(
    "place", ["true ? ‸", "true ? ‸ : Place.HOME", "true ? Place.HOME : ‸", "here == to ? ‸"]
)
def test_values_that_are_chosen(place: str) -> None:
    text = PARAMETERS.replace(CURSOR, "")
    assert "here" in labels(text.replace("MoveTo(to)", f"MoveTo({place})"))
    assert "here" in labels(text.replace("= Place.HOME\n", f"= Place.HOME\n let x = {place}\n"))
    team = f"{text}team T {{ one : r with here = {place.replace('here == to', 'index > 1')} }}\n"
    assert "Place" in labels(team)


def test_a_weight_stands_behind_the_condition_of_a_branch() -> None:
    text = (
        "system T\nsrm r {\n liveness { r = A . (B | C) }\n activities { A takes 1s }\n"
        " control r { enter B : [1 < 2] ‸\n leave C : [1 < 2]\n }\n}\n"
    )
    assert {"weight", "enter"} <= set(labels(text))
    assert "weight" not in labels(text.replace(" ‸", "").replace("[1 < 2]\n }", "[1 < 2] ‸\n }"))


def test_outcomes_of_activities() -> None:
    text = (
        "system T\nsrm r {\n liveness { r = Grasp . (Lift | Cry) }\n"
        " activities { Grasp ends held, slipped }\n control r { enter Lift : [CONDITION] }\n}\n"
    )
    assert labels(text.replace("CONDITION", "outcome(‸")) == ["Grasp"]
    assert labels(text.replace("CONDITION", "outcome(Grasp) == ‸")) == ["held", "slipped"]


# ---- protocols, roles, teams ---------------------------------------------------------------------


def test_what_a_role_plays() -> None:
    assert labels(at(SOCCER, "plays attack.")) == ["center", "center_for"]
    assert labels(at(SOCCER, "plays attack.center_for with ")) == [
        *("WalkTowardsGoal", "WalkTowardsBall", "KickBall")
    ]
    assert labels(instead(SOCCER, "plays attack.center\n", "plays ‸\n")) == ["attack"]


def test_activities_that_are_not_described() -> None:
    assert labels(instead(WAREHOUSE, "CollectBids takes 500ms", "‸")) == [
        *("NextTask", "Announce", "CollectBids", "AwardTask", "AwaitResult", "GiveUp")
    ]
    clauses = [item.label for item in offered(instead(WAREHOUSE, "every 1s", "‸")) if item.rank < 10]
    assert {"every", "takes", "simulated", "waits", "within", "as", "uses", "reads", "writes", "ends"} <= set(
        clauses
    )
    assert labels(instead(WAREHOUSE, "every 1s", "as ‸")) == ["thread", "async", "process", "step"]


def test_what_may_be_set_in_agents() -> None:
    text = """system T
srm goalie { var limit : int = 50  var slow : bool  liveness { goalie = A } }
srm other { var far : int  liveness { other = A } }
team T { keeper : goalie with ‸ }
"""
    assert labels(text) == ["limit", "slow"]


def test_types_of_parameters() -> None:
    text = "system T\nenum Place { A }\nsrm r { liveness { r = Go(Place.A) } activities { Go(to : ‸) } }\n"
    assert {"int", "Place"} <= set(labels(text))


def test_roles_of_a_team() -> None:
    assert labels(at(SOCCER, "keeper                 : ")) == ["player", "goalie"]


def test_what_agents_are_set_to() -> None:
    text = (
        "system T\nenum Side { LEFT RIGHT }\n"
        "srm r { var limit : int = 1 var side : Side  liveness { r = A } }\n"
        "team T { one : r with ‸ }\n"
    )
    assert labels(text) == ["limit", "side"]
    assert labels(text.replace("‸", "limit = 3, ‸")) == ["side", "limit"]
    assert labels(text.replace("‸", "side = Side.‸")) == ["LEFT", "RIGHT"]


def test_participants_come_from_the_use_case() -> None:
    text = (
        "system T\nsuc { usecase move by giver, taker includes hand, take }\n"
        "aip move { participant ‸ { process = Give } }\n"
    )
    assert labels(text) == ["giver", "taker"]
    text = text.replace(CURSOR, "giver").replace("aip move {", "aip ‸ {")
    assert labels(text) == ["move"]


# ---- broken texts --------------------------------------------------------------------------------


def test_the_place_is_known_in_a_broken_text() -> None:
    broken = instead(
        SOCCER, "control decision {", "control decision {\n    enter ScanForBall : [vision.state."
    )
    assert labels(broken.replace("[vision.state.", "[vision.state.‸", 1)) == ["Ball"]
    cut = SOCCER[: SOCCER.index("enter KickBall        :")] + "enter ‸"
    assert "TrackBall" in labels(cut)
    garbage = instead(SOCCER, "liveness {", "livness {{ =")
    assert labels(at(garbage, "robot3 : ")) == ["player", "goalie"]


def test_a_line_that_has_gone_wrong_does_not_disturb_the_next() -> None:
    text = "system T\nmessage M { bool b }\ntopic t {\n  stat M form x\n  ‸\n}\n"
    assert labels(text)[:3] == ["signal", "state", "data"]


# ---- for reading ---------------------------------------------------------------------------------

SHOWN = {
    "top": SOCCER + "\n‸",
    "srm": at(SOCCER, "plays attack.center_for with WalkTowardsGoal = WalkTowardsOpponentGoal\n", "  "),
    "participant": at(SOCCER, "  participant center {\n", "    "),
    "control": at(SOCCER, "  control action {\n", "    "),
    "enter": at(SOCCER, "  control action {\n", "    enter "),
    "event": instead(WAREHOUSE, "[reachable]", "‸"),
    "condition": instead(SOCCER, "[!vision.state.Ball.visible]", "[‸]"),
    "action": instead(WAREHOUSE, "send cfp Task to contractor", "‸"),
    "activity": at(SOCCER, "WalkTowardsBall               ", ""),
}


@pytest.mark.parametrize("place", sorted(SHOWN))
def test_what_people_see(place: str, snapshot: Snapshot) -> None:
    # Words of the language are left out, so that a new one does not change this: the grammar has them.
    items = tuple(item for item in offered(SHOWN[place]) if item.kind is not ItemKind.WORD or item.is_snippet)
    snapshot(listed(tuple(item for item in items if item.label not in FORMS)), f"completion_{place}.txt")


def test_of_too_many_those_that_go_with_what_is_typed_are_offered() -> None:
    names = " . ".join(f"Go{number:03}" for number in range(300))
    text = f"system T\nsrm r {{\n  liveness {{ r = {names} }}\n  control r {{\n    enter "
    found = labels(f"{text}Go29{CURSOR} :\n  }}\n}}\n")
    assert {f"Go29{digit}" for digit in range(10)} <= set(found)
    assert "Go001" not in found
    assert len(labels(f"{text}{CURSOR} :\n  }}\n}}\n")) == 200


def test_a_line_that_stays_in_a_state_of_a_chart_offers_the_states() -> None:
    text = "system T statechart r { state 0 OR state 0.1 START state 0.2 BASIC A 0.1 -> 0.2 : on ‸ }"
    assert {"0", "0.1", "0.2"} <= set(labels(text))
    beginning = text.replace("on ‸", "\n‸")
    assert {"on", "exit", "state"} <= set(labels(beginning))


def test_what_a_participant_is_given_is_offered() -> None:
    text = """system House
aip delivery {
  participant courier { given low : bool  result load : int  process = Consider . [Carry] }
  control courier { enter Carry : [!low]  skip Carry : else }
}
srm robot {
  var battery : int
  plays delivery.courier with HERE
  liveness { robot = courier  carry = Lift . Walk }
}
"""
    assert "carry" in labels(text.replace("HERE", f"Carry = {CURSOR}"))
    assert {"low", "load", "Consider"} <= set(labels(text.replace("HERE", CURSOR)))
    assert labels(text.replace("HERE", f"low = {CURSOR}"))[0] == "battery"
    assert "Consider" in labels(text.replace("HERE", f"Carry = {CURSOR}"))
    assert "low" in labels(text.replace("[!low]", f"[{CURSOR}]"))


NESTED = """system House
message Ride { int floor }
aip ride {
  participant passenger { given goal : int  result level : int  process = Call . Travel }
  participant lift { process = Move }
}
aip delivery {
  participant courier {
    plays ride.passenger with goal = floor, Call = Ring
    var floor : int
    process = Consider . passenger . HandOver
  }
  control courier { leave HandOver : [floor == 1] }
}
srm porter {
  plays delivery.courier
  liveness { porter = courier }
  activities { Move takes 1s }
}
"""


def test_what_a_participant_plays_is_offered() -> None:
    assert {"passenger", "lift"} <= set(
        labels(instead(NESTED, "plays ride.passenger with", f"plays ride.{CURSOR} with"))
    )
    bound = labels(instead(NESTED, "with goal = floor, Call = Ring", f"with {CURSOR}"))
    assert {"goal", "level", "Call", "Travel"} <= set(bound)
    assert labels(instead(NESTED, "goal = floor,", f"goal = {CURSOR},"))[0] == "floor"
    assert "passenger" in labels(instead(NESTED, "Consider . passenger", f"Consider . {CURSOR}"))
    assert "plays" in labels(instead(NESTED, "    var floor", f"    {CURSOR}\n    var floor"))


SERVED = NESTED.replace("participant lift {", "participant lift { sends inform Ride ").replace(
    "plays delivery.courier", "plays ride.lift"
)


def test_what_a_busy_participant_answers_is_offered() -> None:
    busy = [
        labels(instead(SERVED, "plays ride.lift", f"plays ride.lift {text}{CURSOR}"))
        for text in ("", "when busy ", "when busy inform ", "when busy inform Ride { ")
    ]
    assert "when" in busy[0]
    assert {"queue", "refuse", "inform"} <= set(busy[1])
    assert busy[2][:1] == ["Ride"]
    assert busy[3][:1] == ["floor"]


def test_what_stands_inside_is_offered_to_the_role() -> None:
    """The activities to describe are those that are performed, under the names that they have got."""
    offered_here = labels(instead(NESTED, "activities { Move takes 1s", f"activities {{ {CURSOR}"))
    assert {"Consider", "HandOver", "Ring", "Travel"} <= set(offered_here)
    assert "passenger" not in offered_here
    bound = labels(instead(NESTED, "plays delivery.courier\n", f"plays delivery.courier with {CURSOR}\n"))
    assert {"Consider", "HandOver", "Ring"} <= set(bound) and "passenger" not in bound
