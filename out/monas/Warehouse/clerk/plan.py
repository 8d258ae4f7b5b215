"""The plan of clerk in Warehouse: its statechart, to read and to inspect.

Generated from a.aseme by asemec; edit that file, not this one.
"""

# A state or transition stands on one line, and names are the document's.
# ruff: noqa: E501, N999, RUF100
from aseme_dsl.runtime.chart.plan import (
    ActivityInfo,
    ChannelInfo,
    Plan,
    Region,
    State,
    Transition,
    Variable,
    register,
)

PLAN = register(
    Plan(
        name="clerk",
        system="Warehouse",
        source="a.aseme",
        model="098329a17ae19d4c",
        states=(
            State("0", "clerk", "OR", at="a.aseme:9:5"),
            State("0.1", "0.1", "START", parent="0", at="a.aseme:14:22"),
            State("0.2", "Sell+", "OR", parent="0", at="a.aseme:14:22"),
            State("0.2.1", "0.2.1", "START", parent="0.2", at="a.aseme:14:22"),
            State("0.2.2", "Sell", "BASIC", parent="0.2", activity="Sell", at="a.aseme:14:22"),
            State("0.2.3", "0.2.3", "END", parent="0.2", at="a.aseme:14:22"),
            State("0.3", "Call", "BASIC", parent="0", activity="Call", at="a.aseme:14:30"),
            State("0.4", "0.4", "END", parent="0", at="a.aseme:14:22"),
        ),
        transitions=(
            Transition("0.1", "0.2", at="a.aseme:14:22"),
            Transition(
                "0.2",
                "0.3",
                condition=("has", ("member", None, "desk.signal.Order", ())),
                text="[has(desk.signal.Order)]",
                at="a.aseme:19:5",
            ),
            Transition("0.3", "0.4", at="a.aseme:14:30"),
            Transition("0.2.1", "0.2.2", at="a.aseme:14:22"),
            Transition(
                "0.2.2",
                "0.2.2",
                condition=("<", ("variable", "sent"), ("const", 3)),
                actions=(
                    ("assign", "sent", ("+", ("variable", "sent"), ("const", 1))),
                    (
                        "assign",
                        "mine",
                        (
                            "append",
                            ("variable", "mine"),
                            (
                                "new",
                                "Order",
                                (
                                    (("id",), ("variable", "sent")),
                                    (("item",), ("const", "box")),
                                    (("place", "x"), ("const", 1.5)),
                                    (("place", "y"), ("const", 2)),
                                ),
                                None,
                            ),
                        ),
                    ),
                    (
                        "assign",
                        "now",
                        (
                            "new",
                            "Order",
                            ((("id",), ("+", ("variable", "now", ("id",)), ("const", 1))),),
                            (("element", ("variable", "mine"), ("const", 0), ()), ("item", "place")),
                        ),
                    ),
                ),
                text='[sent < 3] / sent += 1; append(mine, Order { id = sent, item = "box", place.x = 1.5, place.y = 2 }); now = Order { id = now.id + 1, ..mine[0] }',
                at="a.aseme:17:5",
            ),
            Transition(
                "0.2.2",
                "0.2.3",
                priority=1,
                otherwise=True,
                actions=(
                    (
                        "assign",
                        "now",
                        (
                            "new",
                            "Order",
                            ((("item",), ("const", "last")),),
                            (("element", ("variable", "mine"), ("const", 0), ()), ("id", "place")),
                        ),
                    ),
                    (
                        "assign",
                        "mine",
                        ("put", ("variable", "mine"), ("const", 0), ("new", "Order", (), None)),
                    ),
                    ("fill", ("member", None, "desk.signal.Order", ()), ("variable", "now")),
                    ("publish", "desk.signal.Order"),
                ),
                text='else / now = Order { item = "last", ..mine[0] }; mine[0] = Order { .. }; desk.signal.Order = now; write_messages.desk.signal.Order',
                at="a.aseme:18:5",
            ),
        ),
        variables=(
            Variable("sent", "int", 0),
            Variable("mine", "list of Order", (), length=4),
            Variable("now", "Order", None),
        ),
        regions=(
            Region("0", reads=("desk.signal.Order", "gate.state.Order"), writes=("desk.signal.Order",)),
        ),
        activities=(
            ActivityInfo("Sell", takes=1000000000),
            ActivityInfo("Call", takes=1000000000, reads=("gate.state.Order",)),
        ),
        channels=(
            ChannelInfo("desk.signal.Order", "Order", queued=True, sources=("clerk",)),
            ChannelInfo("gate.state.Order", "Order", sources=("packer",)),
        ),
    )
)
