"""Consider: whether the lot is worth it, and whether there is the money."""

from aseme_dsl.runtime import Context


class Consider:
    def execute(self, context: Context, price: float) -> str:
        context.wait(0.2 + context.random.random())
        return "yes" if price <= context.get_variable("budget") else "no"
