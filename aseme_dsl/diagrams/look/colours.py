"""Colours of all drawings, light and dark, each readable on what it stands on."""

from __future__ import annotations

LIGHT = {
    "paper": "#ffffff",
    "ink": "#1b1f24",
    "soft": "#57606a",
    "line": "#3b434c",
    "cut": "#9a4b00",
    "error": "#c1121f",
    "node": "#eaf5e0",
    "node-border": "#4d7a2c",
    "choice": "#fff3bf",
    "choice-border": "#8a6d00",
    "frame": "#f6f7f9",
    "frame-border": "#7d8792",
    "pill": "#eef1f5",
    "message": "#0b5cad",
    "p0": "#0057a8",
    "q0": "#eef5fc",
    "p1": "#7a1fa2",
    "q1": "#f7effb",
    "p2": "#00695c",
    "q2": "#eaf6f4",
    "p3": "#9f1853",
    "q3": "#fbeef4",
    "or": "#fdffb6",
    "and": "#b1f4f0",
    "basic": "#c8f7a0",
    "number": "#003d7a",
    "transition": "#c8330a",
}

DARK = {
    "paper": "#11151a",
    "ink": "#e6edf3",
    "soft": "#a3adb8",
    "line": "#b3bcc6",
    "cut": "#ffab5e",
    "error": "#ff7b82",
    "node": "#1d2f1c",
    "node-border": "#7fb65a",
    "choice": "#3a3210",
    "choice-border": "#d9b84a",
    "frame": "#181d24",
    "frame-border": "#6b7683",
    "pill": "#1f262e",
    "message": "#79b8ff",
    "p0": "#6cb6ff",
    "q0": "#122033",
    "p1": "#d49bf0",
    "q1": "#251a2c",
    "p2": "#58c9b9",
    "q2": "#102623",
    "p3": "#f28ab8",
    "q3": "#2b1822",
    "or": "#2f2e12",
    "and": "#0f3030",
    "basic": "#1c3314",
    "number": "#9ccaff",
    "transition": "#ff9b7a",
}


def night(svg: str) -> str:
    """Rules that give each light colour in a drawing its dark one, for readers who prefer that."""
    rules = [
        f'.aseme-drawing [{what}="{colour}"]{{{what}:{DARK[name]}}}'
        for name, colour in LIGHT.items()
        for what in ("fill", "stroke")
        if f'{what}="{colour}"' in svg
    ]
    return f"@media (prefers-color-scheme:dark){{{''.join(rules)}}}"


__all__ = ["DARK", "LIGHT", "night"]
