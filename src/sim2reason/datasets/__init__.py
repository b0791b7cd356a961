"""Datasets on disk: shards, a manifest, a card; made by workers that may be killed at any moment.

    Config (plan) ── position k ↦ Request ── Maker ↦ Made ── build ── shards + README.md + manifest.json
                                                               │
                                             read, verify ─────┘

An item is a pure function of its request, a shard of its range, a dataset of its configuration and the
versions that made it. So any interrupted run can go on, and ends in the same bytes.
"""
