"""What the comparisons with OpenFOAM's rhoCentralFoam share: cases, time, fields, and `aero` beside it.

Fluxes of Kurganov and Tadmor with van Leer's limiter, Euler steps at a Courant number of 0.2: what the solver's own tutorials use. Wants
`blockMesh` and `rhoCentralFoam` on the PATH (Debian: package `openfoam`). Cost is user CPU seconds of the solver's process, meshing not counted;
of `aero` those of the whole command `aero run` on one thread, cells and one frame included.
"""

import base64
import math
import os
import re
import resource
import shutil
import statistics
import struct
import subprocess
import sys
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]

# What of a folder's patches OpenFOAM takes on the two sides that a plane or a line does not have.
EMPTY = "{ type empty; }"

# That of the solver's tutorials.
COURANT = 0.2

# Short runs are taken so often that they last as long together, s.
LONG_ENOUGH = 0.5


def need_openfoam() -> None:
    if not all(shutil.which(tool) for tool in ("blockMesh", "rhoCentralFoam")):
        print("OpenFOAM is not installed: no comparison (Debian: apt-get install openfoam)", file=sys.stderr)
        sys.exit(3)


def foam(kind: str, name: str, body: str) -> str:
    return f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n{body}\n"


def hexahedra(points: list[tuple[float, float]], blocks: list[tuple[tuple[int, int, int, int], int, int]], span: float) -> tuple[str, int]:
    """Corners of the plane, once at each end of the span, and blocks of so many cells between them; and how many corners the plane has."""
    corners = " ".join(f"({x} {y} {z})" for z in (0, span) for x, y in points)
    count = len(points)
    cut = []
    for around, across, up in blocks:
        ends = " ".join(str(n) for n in (*around, *(count + n for n in around)))
        cut.append(f"hex ({ends}) ({across} {up} 1) simpleGrading (1 1 1)")
    newline = "\n"
    return f"convertToMeters 1;\nvertices ({corners});\nblocks (\n{newline.join(cut)}\n);\n", count


def write_case(folder: Path, mesh: str, fields: dict[str, tuple[str, dict[str, str]]], gamma: float, end_time: float, courant: float = COURANT) -> None:
    """A case: the mesh, and of each of p, T and U what it is inside and on each patch. The gas has p = rho T / gamma."""
    shutil.rmtree(folder, ignore_errors=True)
    for part in ("0", "constant", "system"):
        (folder / part).mkdir(parents=True)
    control = (
        "application rhoCentralFoam; startFrom startTime; startTime 0; stopAt endTime; "
        f"endTime {end_time}; deltaT 1e-3; writeControl adjustableRunTime; writeInterval {end_time}; "
        f"writeFormat ascii; writePrecision 10; timePrecision 6; adjustTimeStep yes; maxCo {courant}; maxDeltaT 1;"
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
    # The gas constant is R = 8314.47 / molWeight = 1 / gamma: at temperature 1 the speed of sound is 1.
    gas = (
        "thermoType { type hePsiThermo; mixture pureMixture; transport const; thermo hConst; equationOfState perfectGas; "
        "specie specie; energy sensibleInternalEnergy; }\n"
        f"mixture {{ specie {{ molWeight {8314.47 * gamma:.6f}; }} thermodynamics {{ Cp {1.0 / (gamma - 1.0)}; Hf 0; }} "
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
    kinds = {
        "p": ("volScalarField", "[1 -1 -2 0 0 0 0]"),
        "T": ("volScalarField", "[0 0 0 1 0 0 0]"),
        "U": ("volVectorField", "[0 1 -1 0 0 0 0]"),
    }
    for name, (inside, patches) in fields.items():
        kind, dimensions = kinds[name]
        text = "\n".join(f"{patch} {condition}" for patch, condition in patches.items())
        body = f"dimensions {dimensions}; internalField {inside};\nboundaryField {{ {text} }}"
        files[f"0/{name}"] = (kind, body)
    for path, (kind, body) in files.items():
        (folder / path).write_text(foam(kind, Path(path).name, body))


def patches(count: int, sides: dict[str, tuple[str, list[tuple[int, int]]]]) -> str:
    """Patches over edges of the plane, each by its two corners, whose plane has `count` of them; the rest is the span's ends."""
    told = []
    for name, (kind, edges) in sides.items():
        faces = " ".join(f"({a} {b} {b + count} {a + count})" for a, b in edges)
        told.append(f"{name} {{ type {kind}; faces ({faces}); }}")
    newline = "\n"
    return f"boundary (\n{newline.join(told)}\n);\ndefaultPatch {{ name sides; type empty; }}"


def listed(values: list[float] | list[tuple[float, float]]) -> str:
    """A field that differs from cell to cell."""
    if isinstance(values[0], tuple):
        rows = "\n".join(f"({x:.12g} {y:.12g} 0)" for x, y in values)
        return f"nonuniform List<vector>\n{len(values)}\n(\n{rows}\n)"
    rows = "\n".join(f"{value:.12g}" for value in values)
    return f"nonuniform List<scalar>\n{len(values)}\n(\n{rows}\n)"


def timed(command: list[str], folder: Path, environment: dict[str, str] | None = None) -> float:
    """User CPU seconds of a command."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{command[0]} failed in {folder}:\n{(done.stdout + done.stderr)[-2000:]}")
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def run_foam(folder: Path) -> float:
    """Runs the case; seconds of the solver."""
    environment = dict(os.environ)
    environment.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    timed(["blockMesh"], folder, environment)
    return timed(["rhoCentralFoam"], folder, environment)


def foam_field(folder: Path, name: str) -> list:
    """The values of a field inside, at the end: numbers, or vectors."""
    last = max((p for p in folder.iterdir() if p.name.replace(".", "").isdigit()), key=lambda p: float(p.name))
    lines = (last / name).read_text().splitlines()
    start = next(number for number, line in enumerate(lines) if "internalField" in line)
    count = int(lines[start + 1])
    rows = lines[start + 3 : start + 3 + count]
    if rows[0].startswith("("):
        return [tuple(float(part) for part in row.strip("()").split()) for row in rows]
    return [float(row) for row in rows]


def run_aero(aero: Path, scene: Path, settings: list[str], folder: Path) -> float:
    """Runs a scene; mean user seconds of the whole command."""
    command = [str(aero), "run", str(scene), "--threads", "1", "--out", str(folder), "--set", "output.frames=1"]
    for setting in settings:
        command += ["--set", setting]
    spent = []
    while sum(spent) < LONG_ENOUGH:
        shutil.rmtree(folder, ignore_errors=True)
        spent.append(timed(command, Path.cwd()))
    return statistics.mean(spent)


def aero_frame(folder: Path) -> dict[str, list]:
    """The arrays of the last frame in a folder of `aero`, by name; vectors as triples."""
    file = max(folder.glob("frame-*.vtp"))
    text = file.read_text()
    head, appended = text.split("<AppendedData encoding=\"base64\">", 1)
    letters = appended.split("_", 1)[1]
    is_compressed = "vtkZLibDataCompressor" in head
    kinds = {"Float64": "d", "Int64": "q", "UInt32": "I", "UInt8": "B"}
    arrays = {}

    def taken(start: int, count: int) -> tuple[bytes, int]:
        end = start + 4 * math.ceil(count / 3)
        return base64.b64decode(letters[start:end])[:count], end

    for kind, name, attributes, offset in re.findall(r'<DataArray type="(\w+)" Name="(\w+)" (.*?) format="appended" offset="(\d+)"/>', head):
        if is_compressed:
            blocks = struct.unpack("<Q", taken(int(offset), 8)[0])[0]
            header, at = taken(int(offset), 8 * (3 + blocks))
            sizes = struct.unpack(f"<{3 + blocks}Q", header)[3:]
            data = taken(at, sum(sizes))[0]
            raw = b""
            for size in sizes:
                raw, data = raw + zlib.decompress(data[:size]), data[size:]
        else:
            header, at = taken(int(offset), 8)
            raw = taken(at, struct.unpack("<Q", header)[0])[0]
        code = kinds[kind]
        values = list(struct.unpack(f"<{len(raw) // struct.calcsize(code)}{code}", raw))
        if 'NumberOfComponents="3"' in attributes:
            values = list(zip(values[::3], values[1::3], values[2::3]))
        arrays[name] = values
    return arrays


def at_error(runs: list[tuple[float, float]], error: float) -> float:
    """Seconds for this error: runs are (error, seconds); between two of them, or beyond the last, on a line over logarithmic axes."""
    runs = sorted(runs, reverse=True)
    after = next((n for n, run in enumerate(runs) if run[0] <= error), len(runs) - 1)
    (e0, s0), (e1, s1) = runs[max(after, 1) - 1], runs[max(after, 1)]
    share = math.log(error / e0) / math.log(e1 / e0)
    return math.exp(math.log(s0) + share * math.log(s1 / s0))
