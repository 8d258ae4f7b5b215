"""LedHandler: the robots of this field have no lights; `takes` says how long it lasts."""


class LedHandler:
    """Without an `execute`, an activity just lasts as long as the .aseme file says."""
