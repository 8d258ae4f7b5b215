"""`scaffold`: what is missing is written into a file, and nothing else in it changes."""

from __future__ import annotations

from pathlib import Path

import pytest

from aseme_dsl.project.editing.scaffold import Scaffolded, scaffold
from aseme_dsl.source import Source
from tests.conftest import Snapshot

ROOT = Path(__file__).resolve().parents[2]
MISSING = ROOT / "compiler" / "models" / "cases" / "what_is_missing.aseme"
TEXTS = {
    "goals_only": "system S\nsag { actor a { goal x depends on b  goal y }  actor b { goal z } }\n",
    "one_line": "system S srm R { liveness { R = (A | B)+ } }",
    "several_blocks": """\
system S
aip p {
    participant one { process = A | B }
    participant two { process = inner . C  inner = [D] }
}
srm R {
    plays p.two
    liveness { R = two }
}
srm Q {
    plays p.one
    liveness {
        Q = (A | B)
    }
    control Q { enter A : [true]  enter B : else }
}
""",
    "what_is_missing": MISSING.read_text("utf-8"),
}


def run(text: str) -> Scaffolded:
    return scaffold(Source("test.aseme", text))


def is_kept(before: str, after: str) -> bool:
    """Whether every character of one text comes in the other, in its order."""
    rest = iter(after)
    return all(char in rest for char in before)


@pytest.mark.parametrize("name", TEXTS)
def test_the_text_with_its_skeletons(name: str, snapshot: Snapshot) -> None:
    done = run(TEXTS[name])
    assert done.added
    assert is_kept(TEXTS[name], done.text)
    assert {item.severity for item in done.diagnostics} <= {"note"}
    snapshot(done.text, f"{name}.aseme")


@pytest.mark.parametrize("name", TEXTS)
def test_a_second_time_there_is_nothing_to_add(name: str) -> None:
    done = run(TEXTS[name])
    again = run(done.text)
    assert (again.text, again.added) == (done.text, ())


def test_a_file_that_lacks_nothing_stays_as_it_is() -> None:
    text = (ROOT / "acceptance" / "testbehavior.aseme").read_text("utf-8")
    assert run(text) == Scaffolded(text, (), ())


def test_a_file_with_errors_stays_as_it_is() -> None:
    text = TEXTS["goals_only"] + "srm a { liveness { a = A | } }\n"
    done = run(text)
    assert (done.text, done.added) == (text, ())
    assert [item.code for item in done.diagnostics] == ["E101"]


def test_line_ends_and_byte_order_mark_are_kept() -> None:
    done = run("\ufeff" + TEXTS["several_blocks"].replace("\n", "\r\n"))
    assert done.text.startswith("\ufeffsystem S\r\n")
    assert done.text.replace("\r\n", "").count("\n") == 0
    assert done.text[1:].replace("\r\n", "\n") == run(TEXTS["several_blocks"]).text


def test_what_an_imported_file_lacks_is_not_written_here(tmp_path: Path) -> None:
    (tmp_path / "roles.aseme").write_text("srm R { liveness { R = A | B } }\n", "utf-8")
    text = 'system S\nimport "roles.aseme"\nsrm Q { liveness { Q = C+ } }\n'
    done = scaffold(Source(str(tmp_path / "main.aseme"), text))
    assert [item.code for item in done.added] == ["N704"]
    assert "control Q" in done.text and "control R" not in done.text


REFINED = """\
system S
sag { actor robot { goal tidy } }
suc { usecase tidy includes look, grasp }
srm robot {
  liveness {
    robot = (tidy | Rest)  // decided
    tidy = Look . Grasp
  }
  control robot { enter tidy : [true]  enter Rest : else }
}
"""


def test_a_written_file_is_refined_when_use_cases_are_added() -> None:
    text = REFINED.replace(
        "look, grasp }", "look, grasp, put_down  usecase report by robot  usecase ring by robot }"
    )
    done = run(text)
    assert is_kept(text, done.text)
    assert "    robot = (tidy | Rest) ? Report ? Ring  // decided\n" in done.text
    assert "    tidy = Look . Grasp ? PutDown\n" in done.text
    assert {item.code for item in done.diagnostics} == {"E109"}
    assert run(done.text).text == done.text


def test_a_use_case_with_parts_gets_a_formula_that_is_used() -> None:
    text = REFINED.replace("look, grasp }", "look, grasp  usecase report by robot includes call, write }")
    text = text.replace("(tidy | Rest)", "tidy | Rest").replace("Grasp\n", "Grasp  // in this order\n")
    text = text.replace("\n", "\r\n")
    done = run(text)
    assert is_kept(text, done.text)
    assert "robot = (tidy | Rest) ? report  // decided\r\n" in done.text
    assert "    tidy = Look . Grasp  // in this order\r\n    report = Call ? Write\r\n" in done.text
    assert run(done.text).text == done.text


SHOP = """\
system Shop
suc {
  role clerk
  usecase haggle by customer, seller includes offer, answer
  usecase earn by seller includes open_shop, serve
}
srm customer {
  plays haggle.customer as buying
  liveness { customer = buying }
}
srm seller {
  plays haggle.seller as selling
  liveness {
    seller = selling . earn  // decided
    earn = OpenShop . Serve
  }
}
srm clerk { liveness { clerk = Rest } }
aip haggle {
  participant customer {
    engage  "always"
    process = Offer . Answer
  }
  participant seller {
    engage  "always"
    process = Offer | Answer  // either
  }
  outcome "sold"
}
"""


def test_a_use_case_that_a_protocol_includes_later_is_joined_to_its_processes() -> None:
    text = SHOP.replace("offer, answer", "offer, answer, shake")
    done = run(text)
    assert is_kept(text, done.text)
    assert "    process = Offer . Answer ? Shake\n" in done.text
    assert "    process = (Offer | Answer) ? Shake  // either\n" in done.text
    assert {item.code for item in done.diagnostics} == {"E109"}
    assert run(done.text).text == done.text


def test_one_that_only_one_participant_does_is_joined_to_that() -> None:
    text = SHOP.replace("offer, answer", "offer, answer, shake\n  usecase shake by seller")
    done = run(text)
    assert "    process = Offer . Answer\n" in done.text
    assert "    process = (Offer | Answer) ? Shake  // either\n" in done.text


def test_a_role_that_takes_part_later_becomes_a_participant() -> None:
    text = SHOP.replace("by customer, seller", "by customer, seller, clerk")
    done = run(text)
    assert is_kept(text, done.text)
    assert "  participant clerk {\n" in done.text and "    process = Offer ? Answer\n" in done.text
    assert "//   plays haggle.clerk as haggle_clerk\n" in done.text
    assert run(done.text).text == done.text


def test_the_term_of_another_use_case_is_not_meant() -> None:
    text = SHOP.replace("open_shop, serve", "open_shop, serve, close_shop")
    assert "    earn = OpenShop . Serve ? CloseShop\n" in run(text).text


def test_the_advice_for_one_role_does_not_stand_in_for_anothers() -> None:
    once = run(SHOP.replace("  plays haggle.customer as buying\n", "").replace("= buying", "= Rest")).text
    again = run(once.replace("  plays haggle.seller as selling\n", "").replace("selling . ", "")).text
    assert again.count("// The use case haggle; let a formula use the participant:") == 2


def told(done: Scaffolded, code: str) -> list[str]:
    return [item.message for item in done.diagnostics if item.code == code]


def test_the_formula_of_a_renamed_use_case_is_not_written_again() -> None:
    done = run(SHOP.replace("usecase earn", "usecase trade"))
    assert done.text == run(SHOP).text.replace("usecase earn", "usecase trade")
    assert told(done, "W560") == [
        "nothing is called `trade`, and no use case is called like the formula `earn`"
    ]
    assert told(run(SHOP.replace("usecase earn", "usecase trade realises earn")), "W560") == []


def test_the_protocol_of_a_renamed_use_case_is_not_written_again() -> None:
    renamed = SHOP.replace("usecase haggle", "usecase bargain")
    done = run(renamed)
    assert done.text == run(SHOP).text.replace("usecase haggle", "usecase bargain")
    (warning,) = [item for item in done.diagnostics if item.code == "W560"]
    assert str(warning.span) == "test.aseme:4:11"
    assert [str(item.span) for item in warning.related] == ["test.aseme:19:5"]
    assert warning.hint is not None and "`realises haggle`" in warning.hint
    assert told(run(SHOP.replace("usecase haggle", "usecase bargain realises haggle")), "W560") == []
    assert told(run(renamed.replace("haggle", "bargain")), "W560") == []


def test_a_renamed_protocol_gets_what_is_added_to_its_use_case() -> None:
    done = run(
        SHOP.replace("usecase haggle", "usecase bargain").replace("offer, answer", "offer, answer, shake")
    )
    assert "    process = Offer . Answer ? Shake\n" in done.text and "aip bargain" not in done.text


def test_a_protocol_that_others_have_or_that_does_other_things_is_no_renamed_one() -> None:
    other = "  usecase praise by customer, seller includes bow, smile\n"
    done = run(SHOP.replace("  usecase earn", other + "  usecase earn"))
    assert "aip praise {" in done.text and told(done, "W560") == []  # `haggle` has its use case
    done = run(SHOP.replace("  usecase haggle by customer, seller includes offer, answer\n", other))
    assert "aip praise {" in done.text and told(done, "W560") == []


def test_a_renamed_role_is_not_written_again() -> None:
    text = """system S
suc {
  role keeper
  usecase tidy by keeper includes sweep, wash
}
srm cleaner {
  liveness { cleaner = tidy  tidy = Sweep . Wash }
  activities { Sweep takes 1s simulated  Wash takes 1s simulated }
}
"""
    done = run(text)
    assert done.text == text and told(done, "N703") == []
    assert told(done, "W560") == [
        "there is no srm `keeper`, and the use cases do not name the role `cleaner`"
    ]
    other = text.replace("cleaner = tidy  tidy = Sweep . Wash", "cleaner = Cook . Eat").replace(
        "Sweep takes 1s simulated  Wash takes 1s simulated", ""
    )
    assert "srm keeper {" in run(other).text and told(run(other), "W560") == []
    named = text.replace("role keeper", "role keeper\n  role cleaner")
    assert "srm keeper {" in run(named).text and told(run(named), "W560") == []
    assert told(run(text.replace("cleaner", "keeper")), "W560") == []


def test_what_only_advises_is_told_apart() -> None:
    done = run(SHOP.replace("by customer, seller", "by customer, seller, clerk"))
    assert [item.message for item in done.added if item.code == "N702"] == [
        "clerk takes part in the use case `haggle`, but is not a participant of it"
    ]
    assert [item.message for item in done.advised] == [
        "clerk takes part in the use case `haggle`, but plays none of haggle"
    ]


def test_a_use_case_that_is_removed() -> None:
    removed = SHOP.replace("  usecase earn by seller includes open_shop, serve\n", "")
    assert run(removed).text.count("earn") == removed.count("earn")
