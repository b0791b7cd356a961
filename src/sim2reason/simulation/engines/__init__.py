"""The engines: one module or package each, a function from a mechanism and times to a trace."""
