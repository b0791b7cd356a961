"""How the coefficients of static and of kinetic friction are told where they differ."""


def two_coefficients(where: str, of: str = "") -> tuple[str, ...]:
    """Ways to tell both, `where` they hold, as in *on this plane*; `of` is the field of the body that has them."""
    static, kinetic = (f"{{{of}{'.' * bool(of)}{name}}}" for name in ("static_friction", "friction"))
    return (
        f"the coefficients of static and kinetic friction {where} are {static} and {kinetic}, respectively.",
        f"{where} the coefficient of static friction is {static} and that of kinetic friction {kinetic}.",
        f"the coefficient of static friction {where} is {static}, that of kinetic friction {kinetic}.",
    )
