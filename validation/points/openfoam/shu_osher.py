#!/usr/bin/env python3
"""Runs OpenFOAM's rhoCentralFoam on the shock that runs through waves of density, and `aero` about points that stay beside it, at equal spacings.

    python3 shu_osher.py 20 40 80 --aero ../../../target/release/aero [--fine 800] [--keep DIR]

Each number is a count of cells to a unit of length. What it needs and which schemes it takes: `foam.py`. The flow is that of
`cases/stress/shu-osher.toml` (C.-W. Shu & S. Osher, J. Comput. Phys. 83 (1989) 32, doi:10.1016/0021-9991(89)90222-2); the error is the mean of
|rho - reference| over -4.5 < x < 5 at t = 1.8, in per cent of the reference's mean. References are the finite volumes of `../../shu_osher/profile.csv`,
800 cells in all, and runs of both programs with `--fine` cells to a unit, whose densities are averaged over the cells of the coarser ones. Euler steps over
limited slopes add to waves what they should keep: rhoCentralFoam is run at the Courant number of its tutorials, 0.2, and at a quarter of that, its
reference at a quarter.
"""

import argparse
import csv
import math
import sys
import tempfile
from pathlib import Path

import foam

GAMMA, LOW, HIGH, END_TIME, SPAN = 1.4, -5.0, 5.0, 1.8, 0.1
WINDOW = (-4.5, 5.0)
# Behind the shock: density, velocity, pressure.
BEHIND = (3.857143, 2.629369, 10.33333)

Profile = list[tuple[float, float]]


def start(x: float) -> tuple[float, float, float]:
    return BEHIND if x < -4 else (1 + 0.2 * math.sin(5 * x), 0.0, 1.0)


def centres(cells: int) -> list[float]:
    count = round((HIGH - LOW) * cells)
    return [LOW + (k + 0.5) / cells for k in range(count)]


def write_case(folder: Path, cells: int, courant: float) -> None:
    corners = [(LOW, 0), (HIGH, 0), (HIGH, SPAN), (LOW, SPAN)]
    places = centres(cells)
    mesh, count = foam.hexahedra(corners, [((0, 1, 2, 3), len(places), 1)], SPAN)
    mesh += foam.patches(count, {"inlet": ("patch", [(3, 0)]), "end": ("symmetryPlane", [(1, 2)])})
    states = [start(x) for x in places]
    density, velocity, pressure = BEHIND
    # The gas of the case has p = rho T / gamma.
    rows = {
        "p": (foam.listed([p for _, _, p in states]), pressure),
        "T": (foam.listed([GAMMA * p / rho for rho, _, p in states]), GAMMA * pressure / density),
        "U": (foam.listed([(u, 0.0) for _, u, _ in states]), f"({velocity} 0 0)"),
    }
    fields = {}
    for name, (inside, held) in rows.items():
        inlet = f"{{ type fixedValue; value uniform {held}; }}"
        fields[name] = (inside, {"inlet": inlet, "end": "{ type symmetryPlane; }", "sides": foam.EMPTY})
    foam.write_case(folder, mesh, fields, GAMMA, END_TIME, courant)


def foam_run(cells: int, folder: Path, courant: float) -> tuple[Profile, float]:
    write_case(folder, cells, courant)
    seconds = foam.run_foam(folder)
    return list(zip(centres(cells), foam.foam_field(folder, "rho"), strict=True)), seconds


def aero_run(aero: Path, cells: int, folder: Path) -> tuple[Profile, float]:
    scene = foam.ROOT / "cases" / "stress" / "shu-osher.toml"
    seconds = foam.run_aero(aero, scene, [f"spacing={1 / cells}", 'scheme.motion="fixed"'], folder)
    frame = foam.aero_frame(folder)
    return sorted((x, rho) for (x, _, _), rho in zip(frame["Points"], frame["density"])), seconds


def published() -> Profile:
    with (foam.ROOT / "validation" / "shu_osher" / "profile.csv").open() as file:
        return [(float(row["x"]), float(row["rho"])) for row in csv.DictReader(line for line in file if not line.startswith("#"))]


def mean_of(fine: Profile, low: float, high: float) -> float:
    """Mean of a profile between two places: of its cells there, or interpolated where there are none."""
    there = [rho for x, rho in fine if low < x < high]
    if there:
        return sum(there) / len(there)
    middle = 0.5 * (low + high)
    after = next((n for n, (x, _) in enumerate(fine) if x >= middle), len(fine) - 1)
    (x0, r0), (x1, r1) = fine[max(after, 1) - 1], fine[max(after, 1)]
    return r0 + (r1 - r0) * (middle - x0) / (x1 - x0)


def error(profile: Profile, cells: int, reference: Profile) -> float:
    departure = scale = 0.0
    for x, rho in profile:
        if WINDOW[0] < x < WINDOW[1]:
            exact = mean_of(reference, x - 0.5 / cells, x + 0.5 / cells)
            departure += abs(rho - exact)
            scale += exact
    return 100 * departure / scale


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cells", nargs="+", type=int, help="cells to a unit of length")
    parser.add_argument("--aero", type=Path, help="binary to run beside it")
    parser.add_argument("--fine", type=int, default=800, help="cells to a unit of length of the reference runs")
    parser.add_argument("--keep", type=Path, help="folder for the cases (default: a temporary one)")
    options = parser.parse_args()
    foam.need_openfoam()
    with tempfile.TemporaryDirectory() as scratch:
        root = options.keep or Path(scratch)
        ways = {
            f"rhoCentralFoam, maxCo {courant}": lambda cells, courant=courant: foam_run(cells, root / f"waves-{courant}-{cells}", courant)
            for courant in (foam.COURANT, 0.25 * foam.COURANT)
        }
        if options.aero:
            ways["aero"] = lambda cells: aero_run(options.aero, cells, root / "aero")
        references = {"profile.csv": published()}
        for name, run in list(ways.items())[1:]:
            references[f"{name}, 1/{options.fine}"] = run(options.fine)[0]
        table = csv.writer(sys.stdout)
        table.writerow(["name", "cell", "cpu_seconds", *(f"error_percent, {name}" for name in references)])
        for cells in options.cells:
            for name, run in ways.items():
                profile, seconds = run(cells)
                errors = [f"{error(profile, cells, reference):.3f}" for reference in references.values()]
                table.writerow([name, f"1/{cells}", f"{seconds:.3f}", *errors])
                sys.stdout.flush()


if __name__ == "__main__":
    main()
