"""`asemec prove`: where the search of a whole team is cut, runs in which only some agents move count, too."""

from __future__ import annotations

import re

from aseme_dsl.project.proving import prove as prove_module
from aseme_dsl.project.proving.judging import Judge
from aseme_dsl.project.proving.prove import _searched
from tests.cli.test_prove import verdicts

SALE = """\
system Market
message Offer { int euros }
aip sale {
  participant seller {
    sends    cfp Offer, cancel Offer
    receives propose Offer, refuse Offer
    var tired : bool
    process = Call . Look . (Stop | Hear)
  }
  participant buyer [2..4] {
    sends    propose Offer, refuse Offer
    receives cfp Offer, cancel Offer
    var keen : bool
    process = Listen . Think . (Bid | Leave)
  }
  control seller {
    enter Look : / send cfp Offer { euros = 1 } to buyer
    enter Stop : [tired] / send cancel Offer { euros = 1 } to buyer
    enter Hear : propose Offer from buyer or refuse Offer from buyer
  }
  control buyer {
    enter Listen : cfp Offer from seller
    enter Bid    : [keen] / send propose Offer { euros = 2 } to seller
    enter Leave  : else / send refuse Offer { euros = 2 } to seller
  }
}
"""
"""A seller that gives up crosses the answers of its buyers."""
COUNTED = (
    SALE.replace(
        "    var tired : bool\n    process = Call . Look . (Stop | Hear)", "    process = Look . Hear"
    )
    .replace("    enter Stop : [tired] / send cancel Offer { euros = 1 } to buyer\n", "")
    .replace("propose Offer from buyer or refuse Offer from buyer", "when [all_answered(buyer)]")
)
"""The seller waits until each buyer has answered."""
HEARD = """\
system Hall
message Word { int n }
aip news {
  participant speaker { process = Think . Rest }
  participant hearer [2..4] { process = Hear }
  control speaker { enter Rest : / send inform Word { n = 1 } to hearer }
  control hearer  { enter Hear : inform Word from speaker }
}
"""
FEW = re.compile(r"; 15[0-9] states and [0-9]+ in which only some agents move\]$")


def test_what_few_agents_do_counts_where_the_search_of_all_is_cut(prove, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    def asked(question: str, states: int) -> str:
        done = prove(SALE, question, "--robots", "3", "--states", str(states), "--json")
        return verdicts(done)[question]

    assert asked("non-local choice", 150) == "REFUTED"
    assert asked("dead states", 60) == "PROVED"
    monkeypatch.setattr("aseme_dsl.project.proving.searches.first_of", lambda team: iter(()))
    monkeypatch.setattr(Judge, "has_enough", lambda judge, further, left: True)  # no long runs
    assert asked("non-local choice", 150) == "UNDECIDED"
    assert asked("dead states", 60) == "UNDECIDED"


def test_a_counterexample_with_few_agents_is_a_scenario_that_fails(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(SALE, "non-local choice", "--robots", "3", "--states", "150", "--json")
    (found,) = done.json["results"]
    assert "buyer3 : proved_sale_buyer" in found["scenario"]
    assert not any(line.startswith(("buyer2", "buyer3")) for line in found["counterexample"])
    assert FEW.search(f"{found['bounds']}]")


def test_a_wait_that_the_others_end_is_none_for_ever(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(COUNTED, "deadlock", "--robots", "3", "--states", "250", "--json")
    (found,) = done.json["results"]
    assert found["verdict"] == "UNDECIDED"
    assert found["reason"] == "the search was cut after 250 states"
    assert "in which only some agents move" in found["bounds"]


def test_a_message_that_may_be_taken_once_the_others_move_does_not_wait_for_ever(prove, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    def asked() -> str:
        done = prove(COUNTED, "non-local choice", "--robots", "3", "--states", "350", "--json")
        return verdicts(done)["non-local choice"]

    assert asked() == "UNDECIDED"
    monkeypatch.setattr("aseme_dsl.project.proving.judging.Judge._sees_all", True)
    assert asked() == "REFUTED"


def test_a_search_that_is_cut_leaves_half_of_the_budget_to_those_after_it(prove, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    lent: list[tuple[str, float]] = []

    def searched(scope, script, limits, *, still=(), others=(), before=None, **how):  # type: ignore[no-untyped-def]
        kind = "few" if still else "one" if others else "long" if before is not None else "all"
        lent.append((kind, limits.seconds))
        return _searched(scope, script, limits, still=still, others=others, before=before, **how)

    monkeypatch.setattr(prove_module, "_searched", searched)
    prove(SALE, "--robots", "3", "--states", "60", "--budget", "1000s")
    kinds = dict(lent)
    assert lent[0][0] == "all" and lent[0][1] < 501
    assert {"all", "few", "one"} <= {*kinds}
    assert kinds["few"] > 50 and kinds["one"] > 400


def test_first_agents_make_long_runs_where_those_of_all_do_not_come_far(prove, monkeypatch) -> None:  # type: ignore[no-untyped-def]
    made: list[tuple[bool, bool]] = []

    def searched(scope, script, limits, *, still=(), before=None, **how):  # type: ignore[no-untyped-def]
        made.append((before is not None, bool(still)))
        return _searched(scope, script, limits, still=still, before=before, **how)

    monkeypatch.setattr(prove_module, "_searched", searched)
    done = prove(SALE, "dead states", "--robots", "3", "--states", "12", "--json")
    assert verdicts(done) == {"dead states": "PROVED"}
    assert made[-2:] == [(True, False), (True, True)]


def test_nothing_is_searched_twice_where_all_states_were_looked_at(prove) -> None:  # type: ignore[no-untyped-def]
    done = prove(HEARD, "deadlock", "--robots", "3")
    assert done.out.startswith("PROVED    deadlock of protocol news [1 speaker, 3 hearer; any delay; ")
    assert "only some agents" not in done.out
