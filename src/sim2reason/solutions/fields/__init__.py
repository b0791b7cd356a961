"""Motion of a charge in electric and magnetic fields, and of a planet in the gravity of its star."""
