"""Stanzas: notes as XMPP messages, written and read as SPADE does it.

The headers are SPADE's metadata: the fields of a data form (XEP-0004) with the title `spade:x:metadata`; the
text is the message's body. SPADE's own classes for that take several times as long.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any
from xml.sax.saxutils import escape, quoteattr

TITLE = "spade:x:metadata"
MESSAGE = "{jabber:client}message"
PRESENCE = "{jabber:client}presence"
_BODY, _ERROR = "{jabber:client}body", "{jabber:client}error"
_FORM, _FORM_TITLE = "{jabber:x:data}x", "{jabber:x:data}title"
_FIELD, _VALUE = "{jabber:x:data}field", "{jabber:x:data}value"
_CONDITIONS = "{urn:ietf:params:xml:ns:xmpp-stanzas}"
_FORBIDDEN = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def written(address: str, headers: Mapping[str, str], body: str, kind: str, name: str = "") -> str:
    """The text of a message stanza of a kind (`chat`, `headline`); what XML cannot contain becomes `?`."""
    pieces = ["<message to=", quoteattr(address), f" type='{kind}'"]
    if name:
        pieces += [" id=", quoteattr(_allowed(name))]
    pieces.append(">")
    if body:
        pieces += ["<body>", escape(_allowed(body)), "</body>"]
    pieces += ["<x xmlns='jabber:x:data' type='form'><title>", TITLE, "</title>"]
    for key, value in headers.items():
        attribute = quoteattr(_allowed(key))
        pieces += ["<field var=", attribute, " type='text-single'><value>", escape(_allowed(value))]
        pieces.append("</value></field>")
    pieces.append("</x></message>")
    return "".join(pieces)


def _allowed(text: str) -> str:
    if text.isascii() and text.isprintable():
        return text
    return _FORBIDDEN.sub("?", text)


def read(xml: Any) -> tuple[dict[str, str], str]:
    """The headers and the text of a message stanza, which is an element tree."""
    headers: dict[str, str] = {}
    body = ""
    for child in xml:
        if child.tag == _BODY:
            body = body or child.text or ""
        elif child.tag == _FORM and child.findtext(_FORM_TITLE) == TITLE:
            for field in child:
                name = field.get("var")
                if name is not None and field.tag == _FIELD:
                    for value in field:
                        if value.tag == _VALUE:
                            headers[name] = value.text or ""
    return headers, body


def condition(xml: Any) -> str:
    """Why a stanza came back: XMPP's name of the error (`service-unavailable`), with its text."""
    error = xml.find(_ERROR)
    if error is None:
        return "it came back"
    names = [item.tag.removeprefix(_CONDITIONS) for item in error if item.tag.startswith(_CONDITIONS)]
    text = error.findtext(f"{_CONDITIONS}text")
    found = ", ".join(name for name in names if name != "text") or "it came back"
    return f"{found} ({text})" if text else found
