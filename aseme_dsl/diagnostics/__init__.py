"""Diagnostics: a problem in a document as data, and its renderings."""

from aseme_dsl.diagnostics.model import CODES, Code, Diagnostic, Related, Severity, has_errors, in_order
from aseme_dsl.diagnostics.render import render_json, render_text
from aseme_dsl.diagnostics.suggest import closest

__all__ = [
    "CODES",
    "Code",
    "Diagnostic",
    "Related",
    "Severity",
    "closest",
    "has_errors",
    "in_order",
    "render_json",
    "render_text",
]
