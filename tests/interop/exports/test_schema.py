"""Exported SCXML is valid by the schema.

The schema here says of the elements that are written what the Recommendation says of them. `SCXML_SCHEMA`
names the `scxml.xsd` of the W3C, which is not in this repository: then that one is asked, too.
"""

from __future__ import annotations

import os
from functools import cache
from pathlib import Path

import pytest

from aseme_dsl.interop.export.formats import Format, files_of
from tests.interop.exports.taming import tamed
from tests.oracle.charts import text
from tests.oracle.choices import Choices
from tests.support.generated import system_of

etree = pytest.importorskip("lxml.etree", reason="NOT TRIED, for there is no lxml here")

OWN = Path(__file__).with_name("scxml.xsd")
FOREIGN = os.environ.get("SCXML_SCHEMA", "")
CHARTS = int(os.environ.get("EXPORTED_CHARTS", "20"))
ROOT = Path(__file__).parents[3]
FILES = sorted((ROOT / "tests/acceptance").glob("*.aseme"))

PACED = """\
system Paced
srm lamp {
  liveness { lamp = (Dark . Shine)+ }
  control lamp {
    enter Dark : / start_timer(pace, 2s)
    enter Shine : when [expired(pace)] / start_timer(pace, 3s)
    repeat (Dark . Shine) : [expired(pace)]
    leave (Dark . Shine) : after(1min)
  }
}
"""


@cache
def documents() -> tuple[str, ...]:
    texts = [PACED, *(path.read_text("utf-8") for path in FILES)]
    systems = [system_of(item) for item in texts]
    systems += [tamed(system_of(text(Choices(seed)))) for seed in range(CHARTS)]
    return tuple(
        made
        for system in systems
        for chart in system.statecharts
        for _, made in files_of(system, chart, Format.SCXML)[0]
    )


def mistakes(schema: Path, document: str) -> list[str]:
    """What is wrong with a document."""
    found = etree.XMLSchema(etree.parse(schema))
    root = etree.fromstring(document.encode())
    found.validate(root)
    ids = {item.get("id") for item in root.iter(*(f"{{*}}{word}" for word in ("state", "parallel", "final")))}
    targets = [name for item in root.iter("{*}transition") for name in item.get("target", "").split()]
    wrong = [f"no state is called {name}" for name in targets if name not in ids]
    return [*wrong, *(f"line {item.line}: {item.message}" for item in found.error_log)]


def test_what_is_exported_is_valid() -> None:
    made = documents()
    assert len(made) > CHARTS // 2
    assert [found for document in made if (found := mistakes(OWN, document))] == []


@pytest.mark.skipif(not FOREIGN, reason="NOT TRIED: SCXML_SCHEMA names no scxml.xsd of the W3C")
def test_what_is_exported_is_valid_by_the_schema_of_the_w3c() -> None:
    assert [found for document in documents() if (found := mistakes(Path(FOREIGN), document))] == []
    print(f"{len(documents())} documents")


@pytest.mark.parametrize(
    ("written", "instead"),
    [
        (' id="timer.timer_pace_0.2"', ' id="timer.timer_pace_0"'),
        ('sendid="timer.timer_pace_0"', 'sendid="timer.timer_pac"'),
        ('delay="3s"', 'delay="3min"'),
        ("<onentry>", "<onentry><final/>"),
        (' version="1.0" datamodel', " datamodel"),
        ('target="end_0_3"', 'target="end_0_4"'),
        ("<final ", '<final initial="x" '),
    ],
)
def test_what_is_wrong_is_noticed(written: str, instead: str) -> None:
    document = documents()[0]
    assert mistakes(OWN, document) == []
    assert mistakes(OWN, document.replace(written, instead, 1)) != [], document
