"""Evaluation runs: policies answer benchmarks, and every finished sample is written to disk immediately.

OUT/run.json                      settings, seeds, hashes of the data; never a key
OUT/problems/BENCHMARK.jsonl      what is asked, as it was when the run began
OUT/samples/POLICY/BENCHMARK.jsonl   what was answered, one line for each finished sample
OUT/judged/POLICY/BENCHMARK.jsonl    what a judge said, where there is one
OUT/report/                       made anew from all that, whenever it is asked for
"""
