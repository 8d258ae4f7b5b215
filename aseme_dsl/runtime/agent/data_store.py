"""Data stores: what behaviours of one agent keep for each other, as in JADE."""

from __future__ import annotations

from collections.abc import Hashable


class DataStore(dict[Hashable, object]):
    """Values by their keys. `get` gives None for a key that it does not have."""


class HasDataStore:
    """Who has a data store of its own, until it is given another one."""

    _data_store: DataStore | None = None

    @property
    def data_store(self) -> DataStore:
        """What it keeps. Behaviours share what they keep when one is given that of the other."""
        # A subclass need not call the __init__ of its base.
        if self._data_store is None:
            self._data_store = DataStore()
        return self._data_store

    @data_store.setter
    def data_store(self, store: DataStore) -> None:
        if not isinstance(store, DataStore):
            raise TypeError(f"a data store is a DataStore, not {store!r}")
        self._data_store = store


__all__ = ["DataStore", "HasDataStore"]
