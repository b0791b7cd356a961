"""Physics simulators turned into verified problems for language models."""
