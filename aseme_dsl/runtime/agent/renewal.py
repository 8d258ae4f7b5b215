"""Renewal: what has come in for one version of an agent's model, as another version has it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from aseme_dsl.runtime.chart.chart import Chart
from aseme_dsl.runtime.chart.input_queue import Errand, Posted
from aseme_dsl.runtime.chart.inputs import (
    Addressed,
    AgentMessage,
    Completed,
    Crashed,
    Happened,
    Sample,
    Settled,
    Written,
)
from aseme_dsl.runtime.message.convert import Messages, arrived, like, mailed


def renewed(item: Posted, chart: Chart, messages: Messages, labels: Mapping[str, str] | None) -> Posted:
    """An input with its message and, by `labels`, its labels as the plan of a chart has them.

    Raises:
        LookupError: the plan has nothing of that name.
    """
    found = item.input
    match found:
        case Sample(channel):
            if channel in chart.READERS:
                found = arrived(found, messages)
            if labels is not None and found.written_by is not None:
                found = replace(found, written_by=labels.get(found.written_by, ""))
        case AgentMessage():
            found = mailed(found, messages)
            if labels is not None:
                found = replace(found, branch=labels[found.branch])
        case Addressed(branch) | Settled(branch):
            if labels is not None:
                found = replace(found, branch=labels[branch])
        case Completed(label) | Crashed(label):
            if labels is not None:
                found = replace(found, label=labels[label])
        case Written(variable):
            name, _, scope = variable.partition("@")
            key = f"{name}@{labels[scope]}" if scope and labels is not None else variable
            example = chart.variable(key)
            found = Written(key, like(found.value, example, messages))
    return item if found is item.input else replace(item, input=found)


def is_for_any_plan(item: Posted | Errand) -> bool:
    """Whether what has come in means something to another plan than the one that it came for."""
    return not isinstance(item, Posted) or isinstance(item.input, Sample | Happened)
