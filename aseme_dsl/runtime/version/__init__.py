"""Version: generated packages on disk, and how they are imported."""
