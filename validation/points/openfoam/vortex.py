#!/usr/bin/env python3
"""Runs OpenFOAM's rhoCentralFoam on the isentropic vortex, and `aero` about points that stay beside it, at equal spacings.

    python3 vortex.py 64 128 256 --aero ../../../target/release/aero [--keep DIR]

Each number is a count of cells to a side. What it needs and which schemes it takes: `foam.py`. The vortex of `cases/stress/vortex.toml` (C.-W. Shu,
NASA CR-97-206253 (1997), section 5.1, at rest) stays as it is; the error is the mean of |u - exact| at t = 4 over the largest speed, per cent,
the order that of convergence from one count to the next.
"""

import argparse
import csv
import math
import sys
import tempfile
from pathlib import Path

import foam

GAMMA, STRENGTH, HALF, END_TIME, SPAN = 1.4, 5.0, 5.0, 4.0, 0.1


def speed(r: float) -> float:
    """Of the swirl at a distance from the middle."""
    return STRENGTH / (2 * math.pi) * math.exp(0.5 * (1 - r * r)) * r


# Where r = 1.
LARGEST = speed(1.0)


def heat(r: float) -> float:
    """p / rho."""
    return 1 - (GAMMA - 1) * STRENGTH**2 / (8 * GAMMA * math.pi**2) * math.exp(1 - r * r)


def velocity(x: float, y: float) -> tuple[float, float]:
    r = math.hypot(x, y)
    turn = speed(r) / r
    return -turn * y, turn * x


def centres(cells: int) -> list[tuple[float, float]]:
    """Of the cells, x fastest."""
    places = [HALF * ((2 * k + 1) / cells - 1) for k in range(cells)]
    return [(x, y) for y in places for x in places]


def write_case(folder: Path, cells: int) -> None:
    corners = [(-HALF, -HALF), (HALF, -HALF), (HALF, HALF), (-HALF, HALF)]
    mesh, count = foam.hexahedra(corners, [((0, 1, 2, 3), cells, cells)], SPAN)
    pairs = {"left": ("right", (3, 0)), "right": ("left", (1, 2)), "low": ("high", (0, 1)), "high": ("low", (2, 3))}
    mesh += foam.patches(count, {name: (f"cyclic; neighbourPatch {other}", [edge]) for name, (other, edge) in pairs.items()})
    sides = {name: "{ type cyclic; }" for name in pairs} | {"sides": foam.EMPTY}
    places = centres(cells)
    heats = [heat(math.hypot(x, y)) for x, y in places]
    # The gas of the case has p = rho T / gamma.
    fields = {
        "p": (foam.listed([h ** (GAMMA / (GAMMA - 1)) for h in heats]), sides),
        "T": (foam.listed([GAMMA * h for h in heats]), sides),
        "U": (foam.listed([velocity(x, y) for x, y in places]), sides),
    }
    foam.write_case(folder, mesh, fields, GAMMA, END_TIME)


def error(places, velocities) -> float:
    departures = [math.hypot(u[0] - e[0], u[1] - e[1]) for u, e in ((u, velocity(*place[:2])) for place, u in zip(places, velocities, strict=True))]
    return 100 * sum(departures) / len(departures) / LARGEST


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cells", nargs="+", type=int, help="cells to a side")
    parser.add_argument("--aero", type=Path, help="binary to run beside it")
    parser.add_argument("--keep", type=Path, help="folder for the cases (default: a temporary one)")
    options = parser.parse_args()
    foam.need_openfoam()
    table = csv.writer(sys.stdout)
    table.writerow(["name", "cells", "cpu_seconds", "velocity_error_percent", "order"])
    before: dict[str, tuple[int, float]] = {}

    def told(name: str, cells: int, seconds: float, found: float) -> None:
        order = ""
        if name in before:
            fewer, larger = before[name]
            order = f"{math.log(larger / found) / math.log(cells / fewer):.2f}"
        before[name] = (cells, found)
        table.writerow([name, cells, f"{seconds:.2f}", f"{found:.4f}", order])
        sys.stdout.flush()

    with tempfile.TemporaryDirectory() as scratch:
        root = options.keep or Path(scratch)
        for cells in options.cells:
            folder = root / f"vortex-{cells}"
            write_case(folder, cells)
            seconds = foam.run_foam(folder)
            told("rhoCentralFoam", cells, seconds, error(centres(cells), foam.foam_field(folder, "U")))
            if options.aero:
                scene = foam.ROOT / "cases" / "stress" / "vortex.toml"
                settings = [f"spacing={2 * HALF / cells}", 'scheme.motion="fixed"']
                seconds = foam.run_aero(options.aero, scene, settings, root / "aero")
                frame = foam.aero_frame(root / "aero")
                told("aero", cells, seconds, error(frame["Points"], frame["velocity"]))


if __name__ == "__main__":
    main()
