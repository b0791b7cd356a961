"""Sentences that state different coefficients of static and kinetic friction."""


def two_coefficients(where: str, of: str = "") -> tuple[str, ...]:
    """Return sentences that state both friction coefficients; `where` is their location (*on this plane*)."""
    static, kinetic = (f"{{{of}{'.' * bool(of)}{name}}}" for name in ("static_friction", "friction"))
    return (
        f"the coefficients of static and kinetic friction {where} are {static} and {kinetic}, respectively.",
        f"{where} the coefficient of static friction is {static} and that of kinetic friction {kinetic}.",
        f"the coefficient of static friction {where} is {static}, that of kinetic friction {kinetic}.",
    )
