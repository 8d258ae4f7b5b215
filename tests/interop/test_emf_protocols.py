"""The statechart of a protocol becomes an `aip` with the process and `control` of each participant."""

from __future__ import annotations

from pathlib import Path

from aseme_dsl.compiler import analyse
from aseme_dsl.interop.emf.comparison import differences
from aseme_dsl.project.editing.import_models import import_models
from tests.conftest import Snapshot
from tests.interop.test_emf_charts import MODELS, foreign, model, text_of

AIP = """<a:AIPmodel xmlns:a="x">
  <participants name="buyer" engaging_rules="It has money." outcomes="Paid." liveness="buyer=Ask.Pay"/>
  <participants name="seller" liveness="seller=Offer"/>
  <protocols name="Deal" participants="//@participants.0 //@participants.1"/>
</a:AIPmodel>"""


def test_the_participants_of_a_protocol_have_formulas_and_control(snapshot: Snapshot) -> None:
    project = import_models([MODELS / "deal.eac"])
    assert not project.diagnostics
    text = text_of(project)
    snapshot(text, "deal.eac.aseme")
    system = analyse("x.aseme", {"x.aseme": text.replace("[?]", "[true]")}).system
    assert system is not None
    assert list(differences(system.eacs[0], foreign("deal.eac"))) == []


def test_an_aip_gives_its_rules_and_outcomes(tmp_path: Path) -> None:
    text = text_of(import_models([model(tmp_path, AIP, "deal.aip"), MODELS / "deal.eac"]))
    assert text.count("aip Deal {") == 1 and 'engage  "It has money."' in text and 'outcome "Paid."' in text
    assert "enter Pay : [market.state.Price.amount < 10]" in text


def test_what_is_not_the_chart_of_a_protocol_is_a_role(tmp_path: Path) -> None:
    text = (
        (MODELS / "deal.eac")
        .read_text("utf-8")
        .replace('name="0.2.2.2.3" label="0.2.2.2.3"', 'label="0.2.2.2.4"')
    )
    assert "statechart deal {" in text_of(import_models([model(tmp_path, text, "deal.eac")]))
