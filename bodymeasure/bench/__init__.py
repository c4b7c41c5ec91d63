"""A benchmark of methods: error against time, growth with the number of patches, and stages."""

from bodymeasure.bench.figure import error_against_time
from bodymeasure.bench.records import BenchDocument, to_csv
from bodymeasure.bench.run import benchmark_steps, run_benchmark
from bodymeasure.bench.size import FULL, QUICK, Size
from bodymeasure.bench.write import write_benchmark

__all__ = [
    "FULL",
    "QUICK",
    "BenchDocument",
    "Size",
    "benchmark_steps",
    "error_against_time",
    "run_benchmark",
    "to_csv",
    "write_benchmark",
]
