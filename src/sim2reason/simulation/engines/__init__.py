"""The engines: each is a function from a mechanism and sample times to a trace."""
