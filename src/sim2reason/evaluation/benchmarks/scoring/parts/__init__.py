"""What scoring rules share: where answers stand, numbers, expressions, equations, lists."""
