"""Protocols: their own chart, and the same branch in every role that plays them."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.amola.expression import expression_text
from aseme_dsl.amola.statechart import Statechart
from aseme_dsl.diagnostics import Severity
from tests.compiler.models.test_templates import arrows, inside, spread
from tests.support.compiling import analysis, codes, system

ACCEPTANCE = Path(__file__).resolve().parents[2] / "acceptance"

AUCTION = """\
system Auction
message Lot { string id }
message Offer { double price }

aip auction {
  participant seller {
    var bids : int = 0
    let enough = bids > 2
    sends cfp Lot   receives propose Offer
    process = Announce . round+ . [Close]
    round   = Call . Collect
  }
  participant bidder [1..*] {
    var budget : double = 10
    var bids   : int = 5
    sends propose Offer   receives cfp Lot
    process = Wait . [Raise]
  }
  control seller {
    enter round  : / send cfp Lot to bidder; bids = 0
    repeat round : [!enough] / bids = bids + 1
    leave round  : else
    enter Close  : [bids > 3]
    skip Close   : else
    0.2.1.2.2 -> 0.2.1.2.4 : after(5s) / bids = 7
  }
  control bidder {
    enter Wait  : cfp Lot from seller
    enter Raise : [budget > 1 && bids > 0] / budget = budget - 1
    skip Raise  : else
  }
}
"""


def branch(chart: Statechart, label: str) -> list[object]:
    """A branch with labels and keys of variables relative to its own label."""

    def relative(text: str | None) -> str:
        return "" if text is None else text.replace(label, "~")

    nodes = [
        (
            relative(node.label),
            relative(node.name),
            node.type,
            relative(node.parent) if node.label != label else "",
            node.activity,
            node.origin,
        )
        for node in chart.states
        if node.label == label or node.label.startswith(label + ".")
    ]
    transitions = [
        (
            relative(item.name),
            relative(item.source),
            relative(item.target),
            expression_text(item.expression),
            item.priority,
            item.origin,
            item.span,
        )
        for item in chart.transitions
        if item.source.startswith(label + ".")
    ]
    variables = [
        (relative(item.name), item.type, item.initial, relative(item.scope))
        for item in chart.variables
        if item.scope == label
    ]
    return [nodes, transitions, variables]


def branch_labels(chart: Statechart) -> list[str]:
    """Where branches of protocols begin: states of a participant in a state that is not."""
    found = []
    for node in chart.states:
        outer = chart.by_label[node.parent].origin if node.parent is not None else None
        if node.origin.kind == "protocol" and node.origin.name and node.origin != outer:
            found.append(node.label)
    return found


def test_the_chart_of_a_protocol_has_a_region_for_each_participant() -> None:
    chart = system((ACCEPTANCE / "kouretes.aseme").read_text("utf-8")).eacs[0]
    assert (chart.name, chart.kind, len(chart.states), len(chart.transitions)) == ("attack", "EAC", 36, 27)
    assert chart.root.name == "attack"
    assert inside(chart, "0") == ["0.1 START", "0.2 AND attack", "0.3 END"]
    assert inside(chart, "0.2") == ["0.2.1 OR center", "0.2.2 OR center_for"]
    assert inside(chart, "0.2.1") == spread("0.2.1.1 START, 0.2.1.2 OR center, 0.2.1.3 END")
    assert arrows(chart, "0", "0.2.1", "0.2.2") == spread(
        "0.1->0.2, 0.2->0.3, 0.2.1.1->0.2.1.2, 0.2.1.2->0.2.1.3, 0.2.2.1->0.2.2.2, 0.2.2.2->0.2.2.3"
    )
    assert [str(chart.node(label).origin) for label in ("0.2", "0.2.1", "0.2.1.2")] == [
        "protocol attack",
        "protocol attack",
        "protocol attack.center",
    ]


def test_helper_formulas_belong_to_the_branch() -> None:
    chart = system(AUCTION).eacs[0]
    assert inside(chart, "0.2.1.2")[2] == "0.2.1.2.3 OR round+"
    assert inside(chart, "0.2.1.2.3.2") == spread(
        "0.2.1.2.3.2.1 START, 0.2.1.2.3.2.2 BASIC Call, 0.2.1.2.3.2.3 BASIC Collect, 0.2.1.2.3.2.4 END"
    )


def test_each_participant_has_its_own_variables() -> None:
    chart = system(AUCTION).eacs[0]
    assert [(item.name, item.scope, item.initial.value) for item in chart.variables] == [
        ("bids@0.2.1.2", "0.2.1.2", 0),
        ("budget@0.2.2.2", "0.2.2.2", 10.0),
        ("bids@0.2.2.2", "0.2.2.2", 5),
    ]


def test_a_branch_is_the_protocols_in_every_role_and_place() -> None:
    text = (
        AUCTION
        + """
srm house {
  plays auction.seller
  plays auction.bidder as rival
  var bids : int = 1
  liveness { house = Open . (seller || part || seller) . rival   part = Rest . seller~ }
  control house { enter Open : [bids == 1] }
}
srm client { plays auction.bidder  liveness { client = bidder } }
"""
    )
    found = system(text)
    protocol = found.eacs[0]
    seller, bidder = branch(protocol, "0.2.1.2"), branch(protocol, "0.2.2.2")
    house, client = found.iacs
    labels = branch_labels(house)
    assert labels == ["0.3.2.1.2", "0.3.2.2.2.3.2", "0.3.2.3.2", "0.4"]
    assert [branch(house, label) for label in labels[:3]] == [seller] * 3
    assert len(house.variables) == 1 + 3 + 2
    # Only the name of the branch itself is the one that the role's formula has for it.
    rival = branch(house, "0.4")
    assert rival[0][0][1] == "rival"  # type: ignore[index]
    assert (rival[0][1:], *rival[1:]) == (bidder[0][1:], *bidder[1:])  # type: ignore[index]
    assert branch_labels(client) == ["0.2"]
    assert branch(client, "0.2") == bidder


def test_a_role_has_its_variables_and_those_of_its_branches_apart() -> None:
    text = (
        AUCTION
        + """
srm house {
  plays auction.seller
  var bids : int = 1
  liveness { house = Open . seller }
  control house { enter seller : [bids == 1] / bids = 2 }
}
"""
    )
    chart = system(text).iacs[0]
    keys = {
        value.name
        for item in chart.transitions
        for value in [action.target for action in item.expression.actions if hasattr(action, "target")]
    }
    assert keys == {"bids", "bids@0.3"}


def test_bindings_give_the_protocols_activities_the_roles_own() -> None:
    text = """system S
aip attack { participant center { process = Walk . [Pass . Walk] } }
srm player {
  plays attack.center with Walk = Crawl
  plays attack.center as other
  liveness { player = Walk . center . other }
}
"""
    found = system(text)
    chart = found.iacs[0]
    assert [
        node.name for node in chart.states if node.label.startswith("0.3.") and node.name != node.label
    ] == [
        "Crawl",
        "[Pass . Crawl]",
        "Pass . Crawl",
        "Pass",
        "Crawl",
    ]
    assert [node.activity for node in chart.states if node.activity] == [
        *("Walk", "Crawl", "Pass", "Crawl"),
        *("Walk", "Pass", "Walk"),
    ]
    assert found.srms[0].activities == ("Walk", "Crawl", "Pass")
    assert [item.name for item in found.activities] == ["Walk", "Crawl", "Pass"]


def test_an_activity_that_is_bound_everywhere_needs_no_code() -> None:
    text = """system S
aip attack { participant center { process = Walk } }
srm player { plays attack.center with Walk = Crawl  liveness { player = center } }
"""
    assert [item.name for item in system(text).activities] == ["Crawl"]


def test_a_participant_may_be_a_whole_formula() -> None:
    text = """system S
aip attack { participant center { process = Walk . Pass } }
srm player { plays attack.center  liveness { player = Look . go  go = center } }
"""
    chart = system(text).iacs[0]
    assert inside(chart, "0.3") == ["0.3.1 START", "0.3.2 OR center", "0.3.3 END"]


def test_an_empty_process_counts_in_the_roles_loops() -> None:
    text = """system S
aip attack { participant center { process = [Pass] } }
srm player { plays attack.center  liveness { player = center~ } }
"""
    assert codes(text) == ["E303"]


def test_labels_of_a_participants_lines_may_not_leave_its_branch() -> None:
    text = """system S
aip attack {
  participant center { process = Walk . Pass }
  participant center_for { process = Run . Kick }
  control center { 0.2.1.2.2 -> 0.2.1.2.4 : after(1s)  0.2.2.2.2 -> 0.2.2.2.4 : after(1s)  0.1 -> 0.2 : }
}
"""
    assert codes(text) == ["W400", "E409", "E409"]


def test_a_wrong_protocol_makes_no_mistakes_in_the_roles_that_play_it() -> None:
    text = """system S
aip attack { participant center { process = Walk . (Pass } }
srm player { plays attack.center  liveness { player = Look . center } }
"""
    assert [code[:2] for code in codes(text)] == ["E1"]


def test_the_branches_of_attack_are_in_the_player_as_in_the_protocol() -> None:
    found = system((ACCEPTANCE / "kouretes.aseme").read_text("utf-8"))
    protocol, player = found.eacs[0], found.iacs[0]
    center, center_for = branch_labels(player)
    assert branch(player, center) == branch(protocol, "0.2.1.2")
    got, expected = branch(player, center_for), branch(protocol, "0.2.2.2")
    assert got != expected  # one activity is bound
    assert str(got).replace("WalkTowardsOpponentGoal", "WalkTowardsGoal") == str(expected)


def test_a_participant_with_another_name_may_be_called_by_its_own_too() -> None:
    text = """system S
aip attack { participant center { process = Walk }  participant wing { process = Run } }
srm player {
  plays attack.center as striker
  plays attack.wing as left
  plays attack.wing as right
  liveness { player = striker . center . left . wing }
}
"""
    chart = system(text).iacs[0]
    assert branch_labels(chart) == ["0.2", "0.3", "0.4"]
    assert inside(chart, "0")[4] == "0.5 BASIC wing"  # which of the two would it be?


@pytest.mark.parametrize(
    ("number", "told"),
    [("0", "E115"), ("0..0", "E115"), ("2..1", "E115"), ("1e300", "E108"), ("0x10", "E108")],
)
def test_a_number_of_agents_that_is_none_is_the_only_mistake(number: str, told: str) -> None:
    text = AUCTION.replace("[1..*]", f"[{number}]")
    assert [item.code for item in analysis(text).diagnostics if item.severity is Severity.ERROR] == [told]
