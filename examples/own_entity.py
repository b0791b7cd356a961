"""An entity of your own: a cart driven by a fan, checked by the conformance kit and simulated by both engines."""

from typing import Annotated

import sim2reason
from sim2reason.authoring import Cart, End, Entity, Force, Frame, Profile, Push, Range, X, either, entity, scale
from sim2reason.testing import check_entity


@entity
class FanCart(Entity):
    """A cart on a smooth level track that a fan drives to the right."""

    cart: Cart
    thrust: Annotated[Force, Range(2.0, 20.0)]

    says = (
        either(
            "a fan drives {cart} to the right along a smooth level track with a constant force of {thrust}.",
            "with a constant force of {thrust} a fan drives {cart} to the right along a smooth level track.",
            "along a smooth level track {cart} is driven to the right by a fan, with a constant force of {thrust}.",
        ),
    )
    rear = End(sites=("hook",), tied="{cart}", leaves="runs level to the left", arrives="reaches {cart} from the left")

    def build(self, room: Frame) -> None:
        """Let the cart slide along x, and let the force of the fan act on it."""
        cart = room.body("cart", self.cart.mass).slide(X)
        cart.force("fan", Push(X, Profile(self.thrust)))
        cart.site("hook", faces=scale(-1.0, X))


check_entity(FanCart)
scene = sim2reason.load("scene: {entities: [{name: fan, type: FanCart, parameters: {cart: {mass: 0.5}, thrust: 2.0}}]}")
print(sim2reason.describe(scene).text)
trace, certificate = sim2reason.certify(scene, duration=1.0)
print(f"The acceleration is {trace.state.a[0, 0]:.3f} m/s²; F/m is {2.0 / 0.5:.3f} m/s².")
