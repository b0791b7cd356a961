"""Reports on evaluation runs: numbers with intervals, plots, and answers side by side."""
