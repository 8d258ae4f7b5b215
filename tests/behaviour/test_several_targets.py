"""A transition into several regions of an AND (semantics, "Transitions"; language, `statechart`)."""

from __future__ import annotations

from tests.behaviour.conftest import Play
from tests.behaviour.test_leading_out import AND
from tests.behaviour.test_waking import settled

MORE = (
    AND
    + """
      state 0.2.3 OR  state 0.2.3.1 START  state 0.2.3.2 BASIC C  0.2.3.1 -> 0.2.3.2 :
      state 0.2.3.3 AND
      state 0.2.3.3.1 OR  state 0.2.3.3.1.1 START  state 0.2.3.3.1.2 BASIC F  state 0.2.3.3.1.3 BASIC G
      state 0.2.3.3.2 OR  state 0.2.3.3.2.1 START  state 0.2.3.3.2.2 BASIC H  state 0.2.3.3.2.3 BASIC I
      0.2.3.3.1.1 -> 0.2.3.3.1.2 :  0.2.3.3.2.1 -> 0.2.3.3.2.2 :
      0.1 -> 0.5 : [n == 0]
    """
)


def test_named_regions_begin_at_their_targets_and_the_others_at_their_starts(play: Play) -> None:
    run = play(MORE + "0.5 -> (0.2.1.3, 0.2.2.3) : e / n = 3 }").step()
    run.step(run.event("e"))
    assert run.active == ["A2", "B2", "C"]
    assert run.did == ["cancel E", "start A2", "start B2", "start C"]
    assert settled(run).variable("n") == 3


def test_the_order_of_the_targets_does_not_matter(play: Play) -> None:
    """The regions are entered in document order."""
    run = play(MORE + "0.5 -> (0.2.2.3, 0.2.1.3) : e }").step()
    run.step(run.event("e"))
    assert run.did == ["cancel E", "start A2", "start B2", "start C"]


def test_a_target_may_be_an_and_with_targets_of_its_own(play: Play) -> None:
    run = play(MORE + "0.5 -> (0.2.1.3, 0.2.3.3.1.3, 0.2.3.3.2.3) : e }").step()
    run.step(run.event("e"))
    assert run.active == ["A2", "B", "G", "I"]


def test_all_targets_may_be_in_an_and_inside_a_region(play: Play) -> None:
    run = play(MORE + "0.5 -> (0.2.3.3.1.3, 0.2.3.3.2.3) : e }").step()
    run.step(run.event("e"))
    assert run.active == ["A", "B", "G", "I"]


def test_a_target_may_be_an_and_that_begins_at_its_starts(play: Play) -> None:
    run = play(MORE + "0.5 -> (0.2.2.3, 0.2.3.3) : e }").step()
    run.step(run.event("e"))
    assert run.active == ["A", "B2", "F", "H"]


def test_from_inside_all_regions_are_left_and_entered_again(play: Play) -> None:
    """ "the lowest OR state that holds source and target": the one around the AND"""
    run = play(MORE + "0.5 -> 0.2 : e  0.2.1.2 -> (0.2.1.3, 0.2.2.3) : f }").step()
    run.step(run.event("e")).step(run.event("f"))
    assert run.did == ["cancel A", "cancel B", "cancel C", "start A2", "start B2", "start C"]


def test_targets_that_are_ends_complete_the_and(play: Play) -> None:
    run = play(AND + "0.1 -> 0.5 : [n == 0]  0.5 -> (0.2.1.4, 0.2.2.4) : e }").step()
    settled(run.step(run.event("e")))
    assert run.taken[-2:] == ["0.5 -> 0.2", "0.2 -> 0.9"]
    assert run.chart.finished


def test_behind_a_choice(play: Play) -> None:
    choice = "state 0.6 CONDITION  0.5 -> 0.6 : e  0.6 -> 0.2 : [n > 0]  0.6 -> (0.2.1.3, 0.2.2.3) : else }"
    run = play(MORE + choice).step()
    run.step(run.event("e"))
    assert run.active == ["A2", "B2", "C"]
