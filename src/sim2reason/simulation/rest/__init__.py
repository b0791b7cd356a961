"""Where a mechanism stays at rest, how it oscillates about that, and whether the second engine sees the same."""
