#!/usr/bin/env python3
"""Runs OpenFOAM's rhoCentralFoam on the Mach 2.5, 20 degree compression corner and prints its cost and error.

    python3 wedge.py 8 16 32 [--aero ../../../target/release/aero] [--keep DIR]

Each number is a count of cells per unit length. Wants `blockMesh` and `rhoCentralFoam` on the PATH (Debian: package `openfoam`);
exits with status 3 where they are missing. With `--aero` the same spacings are run by that binary in the same breath, particles and
fixed points, so that the ratio is of one machine at one time. Cost is user CPU seconds of the solver's process, meshing not counted;
the error is the mean of |rho - exact| over the area, in per cent of the mean density, the integral that `aero chart` takes.

Fluxes of Kurganov and Tadmor with van Leer's limiter, Euler steps at a Courant number of 0.2: what the solver's own tutorials use.
"""

import argparse
import csv
import json
import math
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

MACH, ANGLE, GAMMA = 2.5, math.radians(20.0), 1.4
# Oblique-shock theory at these values: NACA Report 1135 (1953), eq. 150a.
SHOCK_ANGLE, DENSITY_RATIO = math.radians(42.890), 2.2002
END_TIME = 10.0
LENGTH_BEFORE, LENGTH, HEIGHT, SPAN = 1.0, 3.0, 3.0, 0.1


def foam(kind: str, name: str, body: str) -> str:
    return f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n{body}\n"


def write_case(folder: Path, cells: int) -> None:
    """A case of two blocks, one before the corner and one above the ramp."""
    for part in ("0", "constant", "system"):
        (folder / part).mkdir(parents=True)
    rise = LENGTH * math.tan(ANGLE)
    corners = [(-LENGTH_BEFORE, 0), (0, 0), (LENGTH, rise), (LENGTH, HEIGHT), (0, HEIGHT), (-LENGTH_BEFORE, HEIGHT)]
    points = [f"({x} {y} {z})" for z in (0, SPAN) for x, y in corners]
    up = round(HEIGHT * cells)
    blocks = [
        f"hex (0 1 4 5 6 7 10 11) ({round(LENGTH_BEFORE * cells)} {up} 1) simpleGrading (1 1 1)",
        f"hex (1 2 3 4 7 8 9 10) ({round(LENGTH * cells)} {up} 1) simpleGrading (1 1 1)",
    ]
    patches = {
        "inlet": ("patch", "(0 6 11 5)"),
        "outlet": ("patch", "(2 3 9 8)"),
        "top": ("patch", "(5 11 10 4) (4 10 9 3)"),
        "floor": ("symmetryPlane", "(0 1 7 6)"),
        "ramp": ("symmetryPlane", "(1 2 8 7)"),
    }
    boundary = "\n".join(f"{name} {{ type {kind}; faces ({faces}); }}" for name, (kind, faces) in patches.items())
    mesh = (
        f"convertToMeters 1;\nvertices ({' '.join(points)});\nblocks ({' '.join(blocks)});\nboundary (\n{boundary}\n);\n"
        "defaultPatch { name sides; type empty; }"
    )
    control = (
        "application rhoCentralFoam; startFrom startTime; startTime 0; stopAt endTime; "
        f"endTime {END_TIME}; deltaT 1e-3; writeControl adjustableRunTime; writeInterval {END_TIME}; "
        "writeFormat ascii; writePrecision 10; timePrecision 6; adjustTimeStep yes; maxCo 0.2; maxDeltaT 1;"
    )
    schemes = (
        "fluxScheme Kurganov; ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }\n"
        "divSchemes { default none; div(tauMC) Gauss linear; } laplacianSchemes { default Gauss linear corrected; }\n"
        "interpolationSchemes { default linear; reconstruct(rho) vanLeer; reconstruct(U) vanLeerV; reconstruct(T) vanLeer; }\n"
        "snGradSchemes { default corrected; }"
    )
    solution = (
        'solvers { "(rho|rhoU|rhoE)" { solver diagonal; }\n'
        '"(U|e|h)" { solver smoothSolver; smoother GaussSeidel; nSweeps 2; tolerance 1e-10; relTol 0.01; } }'
    )
    # The gas constant that makes density 1 and the speed of sound 1 at temperature 1: R = 8314.47 / molWeight = 1 / gamma.
    gas = (
        "thermoType { type hePsiThermo; mixture pureMixture; transport const; thermo hConst; equationOfState perfectGas; "
        "specie specie; energy sensibleInternalEnergy; }\n"
        f"mixture {{ specie {{ molWeight {8314.47 * GAMMA:.6f}; }} thermodynamics {{ Cp {1.0 / (GAMMA - 1.0)}; Hf 0; }} "
        "transport { mu 0; Pr 1; } }"
    )
    files = {
        "system/blockMeshDict": ("dictionary", mesh),
        "system/controlDict": ("dictionary", control),
        "system/fvSchemes": ("dictionary", schemes),
        "system/fvSolution": ("dictionary", solution),
        "constant/thermophysicalProperties": ("dictionary", gas),
        "constant/turbulenceProperties": ("dictionary", "simulationType laminar;"),
    }
    fields = {
        "p": ("volScalarField", "[1 -1 -2 0 0 0 0]", f"{1.0 / GAMMA:.16g}"),
        "T": ("volScalarField", "[0 0 0 1 0 0 0]", "1"),
        "U": ("volVectorField", "[0 1 -1 0 0 0 0]", f"({MACH} 0 0)"),
    }
    for name, (kind, dimensions, value) in fields.items():
        held = f"{{ type fixedValue; value uniform {value}; }}"
        sides = {"inlet": held, "top": held, "outlet": "{ type zeroGradient; }", "sides": "{ type empty; }"}
        sides |= {wall: "{ type symmetryPlane; }" for wall in ("floor", "ramp")}
        text = "\n".join(f"{side} {condition}" for side, condition in sides.items())
        body = f"dimensions {dimensions}; internalField uniform {value};\nboundaryField {{ {text} }}"
        files[f"0/{name}"] = (kind, body)
    for path, (kind, body) in files.items():
        (folder / path).write_text(foam(kind, Path(path).name, body))


def timed(command: list[str], folder: Path, environment: dict[str, str]) -> float:
    """User CPU seconds of a command."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{command[0]} failed in {folder}:\n{(done.stdout + done.stderr)[-2000:]}")
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def internal_field(path: Path) -> list[float]:
    """The values of a scalar field that OpenFOAM wrote as text."""
    lines = path.read_text().splitlines()
    start = next(number for number, line in enumerate(lines) if "internalField" in line)
    count = int(lines[start + 1])
    return [float(value) for value in lines[start + 3 : start + 3 + count]]


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


def density_error(density: list[float], cells: int) -> float:
    departure = scale = 0.0
    for (x, y, area), value in zip(cells_of(cells), density, strict=True):
        exact = DENSITY_RATIO if x > 0 and y < x * math.tan(SHOCK_ANGLE) else 1.0
        departure += abs(value - exact) * area
        scale += exact * area
    return 100 * departure / scale


def run_foam(cells: int, folder: Path) -> tuple[float, float]:
    environment = dict(os.environ)
    environment.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    write_case(folder, cells)
    timed(["blockMesh"], folder, environment)
    seconds = timed(["rhoCentralFoam"], folder, environment)
    last = max((p for p in folder.iterdir() if p.name.replace(".", "").isdigit()), key=lambda p: float(p.name))
    return seconds, density_error(internal_field(last / "rho"), cells)


def run_aero(aero: Path, scene: Path, cells: int, folder: Path) -> float:
    command = [str(aero), "run", str(scene), "--threads", "1", "--set", f"spacing={1 / cells}", "--set", "output.frames=1"]
    return timed([*command, "--out", str(folder)], Path.cwd(), dict(os.environ))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cells", nargs="+", type=int, help="cells per unit length")
    parser.add_argument("--aero", type=Path, help="binary to time beside it")
    parser.add_argument("--scene", type=Path, action="append", default=[], help="scenes for that binary")
    parser.add_argument("--keep", type=Path, help="folder for the cases (default: a temporary one)")
    options = parser.parse_args()
    if not all(shutil.which(tool) for tool in ("blockMesh", "rhoCentralFoam")):
        print("OpenFOAM is not installed: no comparison (Debian: apt-get install openfoam)", file=sys.stderr)
        sys.exit(3)
    table = csv.writer(sys.stdout)
    table.writerow(["name", "cell", "cpu_seconds", "density_l1_percent"])
    with tempfile.TemporaryDirectory() as scratch:
        root = options.keep or Path(scratch)
        for cells in options.cells:
            folder = root / f"foam-{cells}"
            shutil.rmtree(folder, ignore_errors=True)
            seconds, error = run_foam(cells, folder)
            table.writerow(["rhoCentralFoam", 1 / cells, f"{seconds:.2f}", f"{error:.4f}"])
            sys.stdout.flush()
            for scene in options.scene if options.aero else []:
                seconds = run_aero(options.aero, scene, cells, root / f"{scene.stem}-{cells}")
                summary = json.loads((root / f"{scene.stem}-{cells}" / "summary.json").read_text())
                table.writerow([f"aero {scene.stem}, {summary['stop_reason']}", 1 / cells, f"{seconds:.2f}", ""])
                sys.stdout.flush()


if __name__ == "__main__":
    main()
