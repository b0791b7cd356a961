"""Training: problems as prompts, models, what they learn from, and what a run leaves on disk.

ProblemSource (settings) ↦ Problem ── PromptStream ── trainer ── Reward ↦ checkpoints, log, report

The libraries of deep learning, those of the extra ``train``, are loaded when a model is loaded or trained, never
when this package is imported.
"""
