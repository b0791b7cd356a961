"""The scene language: measures, words, bodies, entities, ports, and the mechanism that they build."""
