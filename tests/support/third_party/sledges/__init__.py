"""Package of a third party with sledges."""
