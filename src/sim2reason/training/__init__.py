"""Training of language models: problems as prompts, models, corpora, rewards, and files of runs.

ProblemSource (settings) ↦ Problem ── PromptStream ── trainer ── Reward ↦ checkpoints, log, report

The libraries of deep learning, those of the extra ``train``, are loaded when a model is loaded or trained, never
when this package is imported.
"""
