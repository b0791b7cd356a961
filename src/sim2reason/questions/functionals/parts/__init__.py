"""What several functionals share."""
