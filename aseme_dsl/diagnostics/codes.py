"""The table of diagnostic codes: what each is called and how bad it is."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Code:
    """A kind of problem. `title` is a short sentence without the names of a particular document."""

    code: str
    severity: str
    title: str


_TABLE: dict[str, tuple[str, str]] = {
    # Files (E0xx)
    "E001": ("error", "the file cannot be read"),
    "E002": ("error", "the file is not UTF-8 text"),
    "E003": ("error", "the file is too large"),
    "E004": ("error", "an imported file cannot be found"),
    "E005": ("error", "files import each other in a circle"),
    "E006": ("error", "the file needs a newer compiler"),
    "E007": ("error", "a .proto file cannot be imported"),
    "E008": ("error", "the file declares no system"),
    "E009": ("error", "the output cannot be written"),
    "E010": ("error", "the project's configuration is wrong"),
    "W001": ("warning", "the file is empty"),
    "W002": ("warning", "a generated file was edited and is left alone"),
    "W003": ("warning", "a diagram cannot be drawn"),
    # Comments to asemec (W01x)
    "W010": ("warning", "an allow without a reason"),
    "W011": ("warning", "an allow that allows nothing"),
    "W012": ("warning", "an allow of a code that does not exist"),
    "W013": ("warning", "an allow of what cannot be allowed"),
    "W014": ("warning", "a comment to asemec that means nothing"),
    # Syntax (E1xx)
    "E100": ("error", "something else was expected here"),
    "E101": ("error", "a formula is malformed"),
    "E102": ("error", "an expression is malformed"),
    "E103": ("error", "nesting is too deep"),
    "E104": ("error", "a string is not closed"),
    "E105": ("error", "a character that the language does not have"),
    "E106": ("error", "a keyword cannot be a name here"),
    "E107": ("error", "operators that need parentheses"),
    "E108": ("error", "a number or duration is malformed"),
    "E109": ("error", "an operator is still to be chosen"),
    "E110": ("error", "a comment is not closed"),
    "E111": ("error", "a block is not closed"),
    "E112": ("error", "a brace that closes nothing"),
    "E113": ("error", "too many mistakes to list"),
    "E114": ("error", "something is said twice"),
    "E115": ("error", "a range without numbers in it"),
    # Names and declarations (E2xx)
    "E200": ("error", "an unknown name"),
    "E201": ("error", "a name is declared twice"),
    "E202": ("error", "a reserved name"),
    "E203": ("error", "two different statements about one activity"),
    "E204": ("error", "an unknown activity is described"),
    "E205": ("error", "a participant that does not exist"),
    "E206": ("error", "a binding that binds nothing"),
    "E207": ("error", "an agent without a role that exists"),
    "E208": ("error", "a use case includes itself"),
    "E209": ("error", "a message that contains itself"),
    "E210": ("error", "a field number used twice or out of range"),
    "E211": ("error", "a message that does not fit the radio"),
    "E212": ("error", "a clause names something that is not there"),
    "E213": ("error", "a name that means several things"),
    "E214": ("error", "a function without a Python function to call"),
    "E215": ("error", "a range with too many agents"),
    "E216": ("error", "an enum without constants"),
    "E217": ("error", "topics that are below each other"),
    "W200": ("warning", "a name that is close to a declared one"),
    "W201": ("warning", "an activity without code and without a duration"),
    "W202": ("warning", "a participant that the role does not play"),
    # Formulas (E3xx)
    "E300": ("error", "a recursive formula"),
    "E301": ("error", "two formulas of one name"),
    "E302": ("error", "a formula that nothing uses"),
    "E303": ("error", "a loop whose body may be empty"),
    "E304": ("error", "a model that is too large"),
    "E305": ("error", "a role without a formula"),
    "E306": ("error", "the process of a participant is stated again"),
    "E307": ("error", "a number of instances that is not at least two"),
    "W300": ("warning", "operators mixed without parentheses"),
    "W301": ("warning", "something can never be reached"),
    # Control (E4xx)
    "E400": ("error", "a term that the formula does not have"),
    "E401": ("error", "a term that names several places"),
    "E402": ("error", "a way that this term does not have"),
    "E403": ("error", "control of a formula that does not exist"),
    "E404": ("error", "a choice where a branch has no condition while others have"),
    "E405": ("error", "a choice without any condition"),
    "E406": ("error", "two `else` in one choice"),
    "E407": ("error", "a loop that repeats and leaves without condition"),
    "E408": ("error", "control inside a protocol's branch"),
    "E409": ("error", "a transition leaves its region"),
    "E410": ("error", "a label that the statechart does not have"),
    "E411": ("error", "two control blocks for one formula"),
    "E412": ("error", "a cycle of conditions without a state"),
    "W400": ("warning", "a transition that the formula does not have"),
    "W401": ("warning", "an `else` beside a timer"),
    "W402": ("warning", "a wait for something that never completes"),
    "W403": ("warning", "a cycle that never rests"),
    # Types (E5xx)
    "E500": ("error", "types that do not fit"),
    "E501": ("error", "an unknown member"),
    "E502": ("error", "an unknown topic, message or function"),
    "E503": ("error", "the wrong communication class"),
    "E504": ("error", "wrong arguments"),
    "E505": ("error", "a condition that is not a boolean"),
    "E506": ("error", "an assignment that loses information"),
    "E507": ("error", "something that cannot be assigned to"),
    "E508": ("error", "an unknown enum constant"),
    "E509": ("error", "comparing things that cannot be compared"),
    "E510": ("error", "a `let` that refers to itself"),
    "E511": ("error", "a message that the participant does not send or receive"),
    "E512": ("error", "an unknown performative"),
    "E513": ("error", "an unknown host"),
    "E514": ("error", "an initial value that is not a constant"),
    "E515": ("error", "a duration that is not a constant"),
    "E516": ("error", "a number that is too large"),
    "E517": ("error", "a condition without its brackets"),
    "W500": ("warning", "an action that no one sees"),
    "W501": ("warning", "a timer that is never started"),
    # Statecharts (E6xx): the structural rules of the papers' tools
    "E600": ("error", "a statechart without exactly one root"),
    "E601": ("error", "an OR state without exactly one START"),
    "E602": ("error", "an OR state with several END states"),
    "E603": ("error", "a transition into a START state"),
    "E604": ("error", "a transition out of an END state"),
    "E605": ("error", "an AND state with children that are not OR states"),
    "E606": ("error", "a state that cannot have children has some"),
    "E607": ("error", "a label used twice"),
    "E608": ("error", "an activity that is missing or out of place"),
    "W600": ("warning", "a state that cannot be reached"),
    "W601": ("warning", "a state that cannot be left"),
    "W602": ("warning", "an AND state with fewer than two regions"),
    # What the analyst has not said yet (N7xx)
    "N700": ("note", "a use case that nothing specifies"),
    "N701": ("note", "a protocol that is not written yet"),
    "N702": ("note", "a role without a formula for a use case"),
    "N703": ("note", "a role that is not written yet"),
    "N704": ("note", "transitions without an expression"),
}

CODES: dict[str, Code] = {code: Code(code, severity, title) for code, (severity, title) in _TABLE.items()}

GROUPS = {
    "0": "Files and projects",
    "1": "Syntax",
    "2": "Names and declarations",
    "3": "Formulas",
    "4": "Control",
    "5": "Types",
    "6": "Statecharts",
    "7": "What is not said yet",
}
"""What the codes with a first digit are about."""
