"""Large `.aseme` files that look like what people write and are valid through the whole compiler."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import chain, count

_HEAD = """\
// A plant with many kinds of machine, made for measuring.
system Plant

enum Mode { IDLE RUNNING STOPPED }

message Order   { int number  double weight  bool urgent }
message Report  { int number  double seconds  Mode mode }
message Task    { string id  double x  double y }
message Bid     { string task  double cost }
message Award   { string task }

topic plant { state Report  signal Order }
"""

_PROTOCOL = """\

aip allocation{n} {{
  participant asker{n} {{
    engage   "There is work that nobody does."
    var bids{n} : int = 0
    sends    cfp Task, accept_proposal Award, reject_proposal Award
    receives propose Bid, refuse Task
    process  = Announce{n} . CollectBids{n} . (AwardTask{n} | GiveUp{n})
  }}
  participant worker{n} [1..*] {{
    engage   "The machine is free."
    sends    propose Bid, refuse Task
    receives cfp Task, accept_proposal Award, reject_proposal Award
    process  = Evaluate{n} . (SendBid{n} | Decline{n})
  }}
  outcome "One machine has done the work."

  control asker{n} {{
    enter Announce{n}  : / send cfp Task to worker{n}
    enter AwardTask{n} : [bids{n} > 0]
    enter GiveUp{n}    : else
    leave AwardTask{n} : propose Bid from worker{n} or after(30s)
  }}
  control worker{n} {{
    enter Evaluate{n}  : cfp Task from asker{n}
    enter SendBid{n}   : [unit{n}.state.Reading{n}.level > 0.5] / send propose Bid to asker{n}
    enter Decline{n}   : else / send refuse Task to asker{n}
  }}
}}
"""

_ROLE = """\

message Reading{n} {{ double level  double speed  bool blocked  int count }}
topic unit{n} {{ state Reading{n}  data Reading{n} }}

// ---- machine {n} ------------------------------------------------------------------------
srm machine{n} {{
  plays allocation{p}.asker{p}
  plays allocation{p}.worker{p}
  var runs{n} : int = 0
  let jammed{n} = unit{n}.state.Reading{n}.blocked || unit{n}.state.Reading{n}.speed < 0.1   // m/s

  liveness {{
    machine{n}  = Sensing{n}~ || Cooling{n}~ || (Setup{n} . shift{n}~)
    shift{n}    = Load{n} . (produce{n} | repair{n} | asker{p} | worker{p}) . [Unload{n}]
    produce{n}  = Cut{n} . Drill{n}+ . Polish{n}
    repair{n}   = Stop{n} . Clear{n} . Test{n}
  }}

  activities {{
    Sensing{n}   every 20ms  uses probe{n}   writes unit{n}.state.Reading{n}, unit{n}.data.Reading{n}
    Cooling{n}   every 500ms uses pump{n}    reads unit{n}.data.Reading{n} for 2s
    Setup{n}     takes 3s    uses arm{n}
    Load{n}      takes 1s    uses arm{n}     as thread
    Cut{n}       takes 1.5s  uses blade{n}
    Drill{n}     takes 250ms uses drill{n}
    Polish{n}    takes 1s    uses drill{n}, arm{n}
    Stop{n}      takes 100ms
    Clear{n}     takes 5s    uses arm{n}
    Test{n}      takes 2s    reads unit{n}.state.Reading{n}
    Unload{n}    takes 1s    uses arm{n}
  }}
  functionality arm{n} {{ technology "six axes"  environment "hall {p}" }}

  control shift{n} {{
    enter asker{p}   : [jammed{n} && runs{n} > 10]
    enter worker{p}  : [unit{n}.state.Reading{n}.count % 7 == 3]
    enter repair{n}  : [jammed{n} || unit{n}.state.Reading{n}.level >= 0.9 && !(runs{n} == 0)]
    enter produce{n} : else
    enter Unload{n}  : [mean(unit{n}.data.Reading{n}.speed, 500ms) > 0.2] / runs{n} = runs{n} + 1
    skip  Unload{n}  : else
  }}
  control produce{n} {{
    enter  Drill{n}  : / start_timer(drilling{n}, 200ms)
    repeat Drill{n}  : [expired(drilling{n}) && unit{n}.state.Reading{n}.level < 0.75]
                       / start_timer(drilling{n}, 200ms)
    leave  Drill{n}  : [unit{n}.state.Reading{n}.level >= 0.75]
                       / plant.state.Report.number = runs{n}; write_messages.plant.state.Report
  }}
  control repair{n} {{
    enter Clear{n}   : after(2s)
    enter Clear{n}   : when [unit{n}.state.Reading{n}.speed < 0.01]
    leave Test{n}    : [has(unit{n}.state.Reading{n}) && age(unit{n}.state.Reading{n}) < 1s]
  }}
}}
"""

_ROLES_TO_A_PROTOCOL = 4


def _parts() -> Iterator[str]:
    for n in count(1):
        protocol = (n - 1) // _ROLES_TO_A_PROTOCOL + 1
        if (n - 1) % _ROLES_TO_A_PROTOCOL == 0:
            yield _PROTOCOL.format(n=protocol)
        yield _ROLE.format(n=n, p=protocol)


def large_file(lines: int) -> str:
    """A valid file of about `lines` lines (at least one protocol and one role), always the same."""
    parts: list[str] = []
    roles: list[int] = []
    length = 0
    for part in chain([_HEAD], _parts()):
        parts.append(part)
        length += part.count("\n")
        if part.startswith("\nmessage"):
            roles.append(len(roles) + 1)
            if length + len(roles) + 3 >= lines:
                break
    agents = "".join(f"  agent{n} : machine{n}\n" for n in roles)
    return "".join(parts) + f"\nteam Plant {{\n{agents}}}\n"


def large_project(lines: int) -> dict[str, str]:
    """The same as several files, by name: `plant.aseme`, and a protocol with its roles in each other one."""
    text = large_file(lines)
    head, _, rest = text.partition("\naip ")
    rest, team = f"aip {rest}".rsplit("\nteam ", 1)
    system, _, types = head.partition("\nenum")
    halls = [part for part in re.split(r"(?m)^(?=aip )", rest) if part.strip()]
    files = {
        f"hall{number}.aseme": f'import "types.aseme"\n\n{hall}' for number, hall in enumerate(halls, start=1)
    }
    imports = "".join(f'import "{name}"\n' for name in ("types.aseme", *files))
    return {"types.aseme": f"enum{types}", **files, "plant.aseme": f"{system}\n{imports}\nteam {team}"}
