"""The language of scenes: measures, words, bodies, entities, ports, and the mechanism they build."""
