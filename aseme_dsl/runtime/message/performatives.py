"""FIPA's communicative acts, which the compiler knows, too: this imports nothing."""

from __future__ import annotations

PERFORMATIVES = (
    "accept_proposal",
    "agree",
    "cancel",
    "cfp",
    "confirm",
    "disconfirm",
    "failure",
    "inform",
    "inform_if",
    "inform_ref",
    "not_understood",
    "propagate",
    "propose",
    "proxy",
    "query_if",
    "query_ref",
    "refuse",
    "reject_proposal",
    "request",
    "request_when",
    "request_whenever",
    "subscribe",
)
"""FIPA's communicative acts, as a document writes them."""

NOT_UNDERSTOOD = "not_understood"
"""The act with which the runtime answers an unexpected message."""
