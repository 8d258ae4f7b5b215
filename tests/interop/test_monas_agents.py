"""Monas' agents.xml becomes a `modules` block."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from aseme_dsl.compiler import analyse
from aseme_dsl.diagnostics import render_text
from aseme_dsl.interop.monas_agents import modules_of
from aseme_dsl.source import Source

TEXT = """<?xml version="1.0"?>
<agents>
  <!-- as in Monas -->
  <agent IsRealTime="0" Priority="0" ThreadFrequency="25" StatsCycle="200" Enable="1">
    <name>KVision</name>
    <activity Enable="1">Vision</activity>
    <activity>LocalWorldState</activity>
    <activity Enable="0">Behavior</activity>
  </agent>
  <agent><ThreadFrequency>30</ThreadFrequency><name>Head</name><activity>HeadController</activity></agent>
  <agent ThreadFrequency="0"><name>Planning</name><activity>PathPlanning</activity></agent>
  <provider ThreadFrequency="10">Sensors</provider>
  <provider>LedHandler</provider>
  <provider ThreadFrequency="10">Sensors</provider>
  <statechart Enable="1">Goalie</statechart>
  <statechart Enable="0">Tester</statechart>
</agents>
"""
MODULES = """modules {
  // statecharts: Goalie, Tester (switched off)
  // agent KVision
  Vision every 40ms
  LocalWorldState every 40ms
  // Behavior every 40ms  (switched off)
  // agent Head
  HeadController every 33.333333ms
  // agent Planning
  // PathPlanning
  // provider Sensors
  Sensors every 100ms
  // provider LedHandler
  // LedHandler
  // provider Sensors
}
"""


def test_agents_and_providers_become_modules_of_their_frequency() -> None:
    text, found = modules_of(Source("agents.xml", TEXT))
    assert text == MODULES
    assert [(item.code, item.message) for item in found] == [
        ("W111", "`Planning` runs without a pause (frequency 0): a module has a period"),
        ("W111", "`LedHandler` has no frequency"),
        ("W110", "the module `Sensors` is there a second time: it is left out"),
    ]


def test_the_block_is_what_an_srm_takes() -> None:
    text, _ = modules_of(Source("agents.xml", TEXT))
    analysis = analyse(Source("a.aseme", f"system S srm robot {{ liveness {{ robot = Walk }} {text} }}"))
    assert analysis.system is not None, render_text(analysis.diagnostics)
    names = [item.name for item in analysis.system.srms[0].modules]
    assert names == ["Vision", "LocalWorldState", "HeadController", "Sensors"]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "no element found"),
        ("<agents>", "no element found"),
        ("<agents></agent>", "mismatched tag"),
        ("<html><body/></html>", "is no configuration of Monas"),
        ('<!DOCTYPE a [<!ENTITY b "c">]><agents>&b;</agents>', "it declares entities"),
        ("<a>" * 5000, "no element found"),
    ],
)
def test_what_cannot_be_read_is_said(text: str, says: str) -> None:
    block, (problem,) = modules_of(Source("agents.xml", text))
    assert block == "" and problem.code == "E220" and says in problem.message


@given(st.text(alphabet="<>/agentprovider ='\"&;é\x00\n0123", max_size=80))
def test_no_text_is_too_strange(text: str) -> None:
    block, found = modules_of(Source("agents.xml", text))
    assert block or found
