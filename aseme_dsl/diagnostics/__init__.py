"""Diagnostics: a problem in a document as data, and its renderings."""

from aseme_dsl.diagnostics.model import (
    CODES,
    GROUPS,
    Code,
    Diagnostic,
    Edit,
    Problem,
    Related,
    Severity,
    Suppressed,
    has_errors,
    in_order,
)
from aseme_dsl.diagnostics.policy import NO_POLICY, Policy, Setting
from aseme_dsl.diagnostics.render import render_json, render_text
from aseme_dsl.diagnostics.suggest import closest, surely

__all__ = [
    "CODES",
    "GROUPS",
    "NO_POLICY",
    "Code",
    "Diagnostic",
    "Edit",
    "Policy",
    "Problem",
    "Related",
    "Setting",
    "Severity",
    "Suppressed",
    "closest",
    "has_errors",
    "in_order",
    "render_json",
    "render_text",
    "surely",
]
