"""The plan of packer in Warehouse: its statechart, to read and to inspect.

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
    register,
)

PLAN = register(
    Plan(
        name="packer",
        system="Warehouse",
        source="a.aseme",
        model="4bb078ebf23eb809",
        states=(
            State("0", "packer", "OR", at="a.aseme:23:5"),
            State("0.1", "0.1", "START", parent="0", at="a.aseme:24:23"),
            State("0.2", "Idle", "BASIC", parent="0", activity="Idle", at="a.aseme:24:23"),
            State("0.3", "0.3", "END", parent="0", at="a.aseme:24:23"),
        ),
        transitions=(
            Transition("0.1", "0.2", at="a.aseme:24:23"),
            Transition(
                "0.2",
                "0.3",
                when=True,
                condition=("==", ("member", None, "desk.signal.Order", ("item",)), ("const", "last")),
                text='when [desk.signal.Order.item == "last"]',
                at="a.aseme:26:20",
            ),
        ),
        regions=(Region("0", reads=("desk.signal.Order",)),),
        activities=(ActivityInfo("Idle", waits=True),),
        channels=(ChannelInfo("desk.signal.Order", "Order", queued=True, sources=("clerk",)),),
    )
)
