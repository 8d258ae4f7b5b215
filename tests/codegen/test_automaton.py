"""Two protocols are compatible if their participants say the same in the same order."""

from __future__ import annotations

import pytest

from aseme_dsl.codegen.automaton import automaton_of
from aseme_dsl.codegen.plan import protocol_versions
from tests.support.generated import system_of

TEXT = """system S
message Task { string id }
message Bid  { double cost }
aip deal {
  participant asker {
    var n : int = 0
    sends request Task, confirm Bid by Weigh
    receives inform Bid, refuse Task
    process = Ask . Weigh . (Pay | Leave)
  }
  participant teller {
    sends inform Bid, refuse Task
    receives request Task, confirm Bid
    process = Think . [Tell]
  }
  control asker {
    enter Ask   : / send request Task { id = "t" } to teller
    enter Weigh : inform Bid from teller
    enter Pay   : [n > 0]
    enter Leave : else
  }
  control teller {
    enter Think : request Task from asker
    enter Tell  : else / send inform Bid { cost = 1 } to asker
    skip  Tell  : after(5s) / send refuse Task { id = "t" } to asker
    leave Tell  : confirm Bid from asker
  }
}
srm boss { plays deal.asker BOUND liveness { boss = asker } activities { Ask takes 1s  Weigh takes 1s } }
srm aide { plays deal.teller  liveness { aide = teller~ } activities { Think takes 1s  Tell takes 1min } }
team T { ann : boss  bob : aide }
"""


def version(*changes: tuple[str, str]) -> str:
    text = TEXT
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return protocol_versions(system_of(text.replace(" BOUND", "")))["deal"]


def test_the_automaton_is_the_smallest() -> None:
    system = system_of(TEXT.replace(" BOUND", ""))
    (aip,) = system.aips
    eac = system.eac("deal")
    assert eac is not None
    asker, teller = (automaton_of(eac, part) for part in aip.participants)
    ask, offer = ("!", "request", "Task", "teller"), ("?", "inform", "Bid", "teller")
    confirm, refused = ("!", "confirm", "Bid", ""), ("?", "refuse", "Task", "")
    assert asker.ways[0] == ((ask, 1),)
    assert asker.ways[1] == ((offer, 2), (refused, 1))
    assert asker.ways[2] == ((confirm, 2), (refused, 2))
    assert teller.ways[0] == ((("?", "request", "Task", "asker"), 1),)
    assert [[letter[1] for letter, _ in ways] for ways in teller.ways] == [
        ["request"],
        ["inform", "refuse"],
        ["confirm"],
        [],
    ]
    assert teller.ends == {3}


@pytest.mark.parametrize(
    "changes",
    [
        [("Think takes 1s", "Think takes 2s")],
        [("Weigh", "Compare")],
        [(" BOUND", " with Weigh = Compare")],
        [("after(5s)", "after(7s)")],
        [("n > 0", "n > 3")],
        [("Ask . Weigh", "Ask . Rest . Weigh"), ("enter Weigh", "enter Rest")],
        [("Ask . Weigh . (Pay | Leave)", "(Ask . Weigh) . (Pay | Leave)")],
        [("cost = 1", "cost = 2")],
        [("enter Pay   : [n > 0]", "enter Leave : [n > 0]"), ("enter Leave : else", "enter Pay : else")],
    ],
)
def test_what_others_do_not_notice_keeps_the_version(changes: list[tuple[str, str]]) -> None:
    assert version(*changes) == version()


@pytest.mark.parametrize(
    "changes",
    [
        [("double cost", "double price"), ("cost = 1", "price = 1")],
        [("Bid by Weigh", "Bid by Weigh repeatedly")],
        [("Bid by Weigh", "Bid by Ask")],
        [("enter Weigh : inform Bid", "enter Weigh : refuse Task")],
        [('skip  Tell  : after(5s) / send refuse Task { id = "t" } to asker', "skip Tell : after(5s)")],
        [("leave Tell  : confirm Bid from asker", "leave Tell : after(1s)")],
        [("Think . [Tell]", "Think . Tell"), ("skip  Tell ", "leave Tell ")],
        [("participant teller", "participant seller"), ("teller", "seller")],
    ],
)
def test_what_others_notice_changes_it(changes: list[tuple[str, str]]) -> None:
    assert version(*changes) != version()
