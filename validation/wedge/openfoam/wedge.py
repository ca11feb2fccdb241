#!/usr/bin/env python3
"""Runs OpenFOAM's rhoCentralFoam on the Mach 2.5, 20 degree compression corner and prints its cost and error.

    python3 wedge.py 8 16 32 [--aero ../../../target/release/aero] [--repeat 3] [--keep DIR]

Each number is a count of cells per unit length. What it needs, which schemes it takes and what counts as cost: `validation/points/openfoam/foam.py`; exits
with status 3 without OpenFOAM. With `--aero` that binary runs the corner about points that stay in the same breath, on the same spacings: marched to
t = 10, settled, and settled with 1 to 4 halvings from eight points to a unit; so that the ratios, at equal error, are of one machine at one time.
The error is the mean of |rho - exact| over the area, in per cent of the mean density, the integral that `aero chart` takes.
"""

import argparse
import csv
import math
import statistics
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "points" / "openfoam"))

import foam

MACH, ANGLE, GAMMA = 2.5, math.radians(20.0), 1.4
# Oblique-shock theory at these values: NACA Report 1135 (1953), eq. 150a.
SHOCK_ANGLE, DENSITY_RATIO = math.radians(42.890), 2.2002
END_TIME = 10.0
LENGTH_BEFORE, LENGTH, HEIGHT, SPAN = 1.0, 3.0, 3.0, 0.1

# Errors at which costs are compared, per cent, by how `aero` goes.
ERRORS = {"marched": (1.8, 1.1, 0.56), "settled": (1.8, 0.56), "refined": (1.8, 0.56, 0.28)}


def write_case(folder: Path, cells: int) -> None:
    """A case of two blocks, one before the corner and one above the ramp."""
    rise = LENGTH * math.tan(ANGLE)
    corners = [(-LENGTH_BEFORE, 0), (0, 0), (LENGTH, rise), (LENGTH, HEIGHT), (0, HEIGHT), (-LENGTH_BEFORE, HEIGHT)]
    up = round(HEIGHT * cells)
    blocks = [((0, 1, 4, 5), round(LENGTH_BEFORE * cells), up), ((1, 2, 3, 4), round(LENGTH * cells), up)]
    mesh, count = foam.hexahedra(corners, blocks, SPAN)
    mesh += foam.patches(
        count,
        {
            "inlet": ("patch", [(5, 0)]),
            "outlet": ("patch", [(2, 3)]),
            "top": ("patch", [(4, 5), (3, 4)]),
            "floor": ("symmetryPlane", [(0, 1)]),
            "ramp": ("symmetryPlane", [(1, 2)]),
        },
    )
    fields = {}
    for name, value in (("p", f"{1.0 / GAMMA:.16g}"), ("T", "1"), ("U", f"({MACH} 0 0)")):
        held = f"{{ type fixedValue; value uniform {value}; }}"
        sides = {"inlet": held, "top": held, "outlet": "{ type zeroGradient; }", "sides": foam.EMPTY}
        sides |= {wall: "{ type symmetryPlane; }" for wall in ("floor", "ramp")}
        fields[name] = (f"uniform {value}", sides)
    foam.write_case(folder, mesh, fields, GAMMA, END_TIME)


def cells_of(cells: int):
    """Centre and area of each cell, in the solver's order: blocks one after the other, x fastest."""
    for first, count, length, slope in ((-LENGTH_BEFORE, round(LENGTH_BEFORE * cells), LENGTH_BEFORE, 0.0), (0.0, round(LENGTH * cells), LENGTH, math.tan(ANGLE))):
        up = round(HEIGHT * cells)
        width = length / count
        for row in range(up):
            for column in range(count):
                edges = [first + width * (column + k) for k in (0, 1)]
                floors = [slope * x if slope else 0.0 for x in edges]
                heights = [(HEIGHT - floor) / up for floor in floors]
                area = width * sum(heights) / 2
                # A trapezium's centroid lies towards its longer side.
                share = (heights[0] + 2 * heights[1]) / (3 * sum(heights))
                x = edges[0] + width * share
                floor = slope * x if slope else 0.0
                yield x, floor + (row + 0.5) * (HEIGHT - floor) / up, area


def density_error(cells, density: list[float]) -> float:
    departure = scale = 0.0
    for (x, y, area), value in zip(cells, density, strict=True):
        exact = DENSITY_RATIO if x > 0 and y < x * math.tan(SHOCK_ANGLE) else 1.0
        departure += abs(value - exact) * area
        scale += exact * area
    return 100 * departure / scale


def foam_run(cells: int, folder: Path) -> tuple[float, float]:
    """Error and seconds."""
    write_case(folder, cells)
    seconds = foam.run_foam(folder)
    return density_error(cells_of(cells), foam.foam_field(folder, "rho")), seconds


def aero_run(aero: Path, settings: list[str], folder: Path) -> tuple[float, float]:
    scene = foam.ROOT / "cases" / "wedge-fixed.toml"
    seconds = foam.run_aero(aero, scene, settings, folder)
    frame = foam.aero_frame(folder)
    cells = [(x, y, volume) for (x, y, _), volume in zip(frame["Points"], frame["volume"])]
    return density_error(cells, frame["density"]), seconds


def aero_runs(options: argparse.Namespace):
    """How `aero` goes, a name for each run, and what it sets."""
    for cells in options.cells:
        yield "marched", f"1/{cells}", [f"spacing={1 / cells}", 'stop="end-time"']
    for cells in options.cells:
        yield "settled", f"1/{cells}", [f"spacing={1 / cells}"]
    for halvings in range(5):
        yield "refined", f"1/8 halved {halvings} times", ["spacing=0.125", f"scheme.refine={halvings}"]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cells", nargs="+", type=int, help="cells per unit length")
    parser.add_argument("--aero", type=Path, help="binary to time beside it")
    parser.add_argument("--repeat", type=int, default=1, help="runs of each, one after another; costs are medians")
    parser.add_argument("--keep", type=Path, help="folder for the cases (default: a temporary one)")
    options = parser.parse_args()
    foam.need_openfoam()
    runs: dict[tuple[str, str], list[tuple[float, float]]] = {}
    with tempfile.TemporaryDirectory() as scratch:
        root = options.keep or Path(scratch)
        for number in range(options.repeat):
            print(f"round {number + 1} of {options.repeat}", file=sys.stderr)
            for cells in options.cells:
                runs.setdefault(("rhoCentralFoam", f"1/{cells}"), []).append(foam_run(cells, root / f"foam-{cells}"))
            for way, name, settings in aero_runs(options) if options.aero else ():
                runs.setdefault((way, name), []).append(aero_run(options.aero, settings, root / "aero"))
    table = csv.writer(sys.stdout)
    table.writerow(["name", "cell", "cpu_seconds", "density_l1_percent"])
    curves: dict[str, list[tuple[float, float]]] = {}
    for (way, name), found in runs.items():
        error, seconds = found[-1][0], statistics.median(seconds for _, seconds in found)
        table.writerow([way if way == "rhoCentralFoam" else f"aero, {way}", name, f"{seconds:.3f}", f"{error:.4f}"])
        curves.setdefault(way, []).append((error, seconds))
    if not options.aero or len(options.cells) < 2:
        return
    table.writerow([])
    table.writerow(["aero", "density_l1_percent", "rhoCentralFoam_seconds", "aero_seconds", "times"])
    for way, errors in ERRORS.items():
        for error in errors:
            peer, own = (foam.at_error(curves[name], error) for name in ("rhoCentralFoam", way))
            table.writerow([way, error, f"{peer:.3f}", f"{own:.4f}", f"{peer / own:.1f}"])


if __name__ == "__main__":
    main()
