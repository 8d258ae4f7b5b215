"""PutDown: the nurse counts the parcels on the ward."""

from aseme_dsl.runtime import Context


class PutDown:
    def execute(self, context: Context) -> None:
        parcels = context.get_variable("parcels") + 1
        context.set_variable("parcels", parcels)
        context.log(f"parcels on the ward: {parcels}")
