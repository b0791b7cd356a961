"""Motions of a body in fields: of a charge in electric and magnetic ones, of a planet about what attracts it."""
