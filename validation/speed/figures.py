#!/usr/bin/env python3
"""Processor time of `aero` per particle and step on periodic boxes of stirred gas, by size, dimension and instruction set.

    cargo build --release
    python3 validation/speed/figures.py target/release/aero [sizes] [vectors] [threads]

`sizes`: the plane from ten thousand to five million particles. `vectors`: 200 000 particles in the plane, 500 000 in
space, with AVX-512, AVX2 and plain arithmetic, pairs in double and in single precision. `threads`: wall time of one
thread over that of two, which means something on an idle machine alone. Medians of several runs; microseconds of user and system time, all passes, no start-up. Output is
a history row per step.
"""

import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

# About so many time steps of a box of sound speed one: the first one evaluates twice.
STEPS = 20
RUNS = 3


def scene(dimension, cells):
    """As the benchmarks' stirred gas."""
    velocity = ["0.3 * cos(2 * pi * {})".format(axis) for axis in ["z", "y", "x"][3 - dimension:]]
    sides = "\n".join(f'{axis}_{end} = "periodic"' for axis in "xyz"[:dimension] for end in ("min", "max"))
    last = "xyz"[dimension - 1]
    return f"""
dimension = {dimension}
spacing = {1.0 / cells!r}
end_time = {0.6 * STEPS / cells!r}
[domain]
min = {[0.0] * dimension}
max = {[1.0] * dimension}
[domain.sides]
{sides}
[free_stream]
density = 1.4
pressure = 1.0
velocity = {[0.0] * dimension}
[initial]
disorder = 0.2
[initial.field]
density = "1.4 + 0.1 * sin(2 * pi * x)"
pressure = "1 + 0.1 * cos(2 * pi * {last})"
velocity = {json.dumps(velocity)}
[output]
frames = 1
region = {{ min = {[0.0] * dimension}, max = {[0.01] * dimension} }}
checkpoint_seconds = 1e6
"""


def run(program, dimension, cells, vectors="", threads=1, precision="double"):
    """The summary of one run."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "box.toml"
        path.write_text(scene(dimension, cells))
        environment = dict(os.environ)
        environment.pop("AERO_VECTORS", None)
        if vectors:
            environment["AERO_VECTORS"] = vectors
        command = [program, "run", str(path), "--threads", str(threads), "--out", folder + "/out"]
        command += ["--set", f"scheme.precision={precision}"]
        done = subprocess.run(command, capture_output=True, text=True, env=environment)
        if done.returncode != 0:
            sys.exit(f"figures.py: {done.stderr}")
        return json.loads((Path(folder) / "out" / "summary.json").read_text())


def cost(program, dimension, cells, vectors="", runs=RUNS, precision="double"):
    """Prints and returns microseconds per particle and step."""
    summaries = [run(program, dimension, cells, vectors, precision=precision) for _ in range(runs)]
    each = [1e6 / summary["particle_updates_per_cpu_second"] for summary in summaries]
    last = summaries[-1]
    peak = last["peak_memory_bytes"] or 0
    count = last["particles"]["fluid"]
    print(
        f"{dimension}D {count:8d} particles {vectors or 'widest':7s} {precision} {statistics.median(each):7.3f} us "
        f"({min(each):.3f} to {max(each):.3f}), {last['steps']} steps, {last['neighbours_mean']:.0f} neighbours, "
        f"{peak / count:.0f} bytes each, load {os.getloadavg()[0]:.1f}",
        flush=True,
    )
    return statistics.median(each)


def main(program, *parts):
    parts = parts or ("sizes", "vectors", "threads")
    if "vectors" in parts:
        for dimension, cells in [(2, 447), (3, 79)]:
            for precision in ["double", "mixed"]:
                for vectors in ["", "avx2", "plain"]:
                    cost(program, dimension, cells, vectors, precision=precision)
    if "sizes" in parts:
        for cells in [100, 224, 447, 1000, 2236]:
            cost(program, 2, cells, runs=RUNS if cells < 2000 else 1)
    if "threads" in parts:
        for dimension, cells in [(2, 447), (3, 60)]:
            ratios = []
            for _ in range(RUNS):
                one, two = (run(program, dimension, cells, threads=n)["wall_seconds"] for n in (1, 2))
                ratios.append(one / two)
            print(f"{dimension}D: two threads {statistics.median(ratios):.2f} times as fast, load {os.getloadavg()[0]:.1f}")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
