"""CalibrateCamera: the cameras of this field do not need it; `takes` says how long it lasts."""


class CalibrateCamera:
    """Without an `execute`, an activity just lasts as long as the .aseme file says."""
