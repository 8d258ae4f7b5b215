"""Access: what robots may do to each other over a network, by the names in their certificates."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

OPERATOR = "asemec-operator"
"""The common name of an operator's certificate, which no agent can have."""


def access_rules(robot: str, team: Iterable[str], controlled: bool = False) -> dict[str, object]:
    """Zenoh's `access_control` for a robot: each other one speaks for itself, and hears its own.

    If the team is `controlled`, an operator may ask for control; `robot` may be the `OPERATOR`, too.
    """
    rules: list[dict[str, object]] = []
    subjects: list[dict[str, object]] = []
    policies: list[dict[str, object]] = []

    def allow(name: str, given: Iterable[tuple[str, list[str], list[str]]]) -> None:
        mine: list[dict[str, object]] = [
            {
                "id": f"{name} {number}",
                "permission": "allow",
                "flows": [flow],
                "messages": what,
                "key_exprs": keys,
            }
            for number, (flow, what, keys) in enumerate(given)
        ]
        rules.extend(mine)
        subjects.append({"id": name, "cert_common_names": [name]})
        policies.append({"rules": [rule["id"] for rule in mine], "subjects": [name]})

    for other in team:
        if robot == OPERATOR:
            allow(other, _control(other, "egress", "ingress"))
        elif other != robot:
            allow(other, (*_from(other, robot), *_towards(other, robot)))
    if controlled and robot != OPERATOR:
        allow(OPERATOR, _control(robot, "ingress", "egress"))
    return {
        "enabled": True,
        "default_permission": "deny",
        "rules": rules,
        "subjects": subjects,
        "policies": policies,
    }


def _control(robot: str, to: str, back: str) -> Iterator[tuple[str, list[str], list[str]]]:
    """What passes between an operator and a robot, with the flows to the robot and back."""
    yield to, ["query"], [f"asemec/*/control/{robot}"]
    yield back, ["declare_queryable"], [f"asemec/*/*/{robot}"]
    yield back, ["reply"], [f"asemec/*/control/{robot}"]


_WHO = ["declare_liveliness_subscriber", "liveliness_query"]


def _from(other: str, robot: str) -> Iterator[tuple[str, list[str], list[str]]]:
    """What another robot may do here."""
    yield "ingress", ["put"], [f"asemec/*/to/{robot}/{other}/**"]
    yield "ingress", ["liveliness_token"], [f"asemec/*/here/{other}/*"]
    yield "ingress", _WHO, ["asemec/*/here/*/*"]
    yield "ingress", ["declare_subscriber"], [f"asemec/*/to/{other}/**"]
    yield "ingress", ["declare_queryable"], [f"asemec/*/*/{other}"]
    yield "ingress", ["query"], [f"asemec/*/history/{robot}"]
    yield "ingress", ["reply"], [f"asemec/*/history/{other}"]


def _towards(other: str, robot: str) -> Iterator[tuple[str, list[str], list[str]]]:
    """What goes from here to another robot."""
    yield "egress", ["put"], [f"asemec/*/to/{other}/{robot}/**"]
    yield "egress", ["liveliness_token"], [f"asemec/*/here/{robot}/*"]
    yield "egress", _WHO, ["asemec/*/here/*/*"]
    yield "egress", ["declare_subscriber"], [f"asemec/*/to/{robot}/**"]
    yield "egress", ["declare_queryable"], [f"asemec/*/*/{robot}"]
    yield "egress", ["query"], [f"asemec/*/history/{other}"]
    yield "egress", ["reply"], [f"asemec/*/history/{robot}"]
