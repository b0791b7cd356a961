"""Reports on training runs: held-out accuracy and studies."""
