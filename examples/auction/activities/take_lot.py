"""TakeLot: the next thing from the cellar."""

from monas.AuctionHouse.messages import Lot

from aseme_dsl.runtime import Context

CELLAR = (Lot("a clock", 40.0), Lot("a chair", 100.0), Lot("a castle", 500.0))


class TakeLot:
    def execute(self, context: Context) -> str:
        before = context.read("hall.state.Lot")
        number = CELLAR.index(before) + 1 if before in CELLAR else 0
        if number == len(CELLAR):
            return "nothing"
        context.wait(1)
        context.publish("hall.state.Lot", CELLAR[number])
        context.log(f"who wants {CELLAR[number].id}?")
        return "lot"
