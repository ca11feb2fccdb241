#!/usr/bin/env python3
"""Reads every VTK file of a run back with VTK itself and checks what is in it.

    check_vtk.py PATH...

PATH is a folder (its .pvd, .vtp, .vtu and .vti files), a .pvd collection (the files it lists) or one such file.
Needs the `vtk` package (pip install vtk). Exit status: 0 all good, 1 a fault was found, 2 the
command is wrong or there is nothing to check.

Checked for every file: VTK reads it without an error; there are points, all finite; every point of a
cloud has a vertex cell (ParaView shows nothing otherwise); every array is finite and has a value for
each point, of surfaces for each cell.
Checked by the file's name (frame-*.vtp, ghosts-*.vtp, surface-*.vtp, *-ghosts.vtp): the arrays that aero promises,
with their number of components, values that make sense, and the field data of a run with its units. Checked for cells-*.vtu: every cell is
closed, its corners give the volume that it says (of rings about an axis, all of it or none), and the
cells are those of the points of the frame beside it. Checked for field-*.vti: the arrays, finite everywhere
and positive in the gas; points are masked where the cells about them are hidden, and not all of them are;
the gradient of the density is the one that its values have. Checked for a collection: its files exist and
its times rise.
"""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree

try:
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
    from vtkmodules.vtkCommonCore import vtkIdList
    from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
except ImportError as error:
    print(f"check_vtk.py: {error}; install with: pip install vtk", file=sys.stderr)
    sys.exit(2)

# Components of the arrays by kind of file.
FRAME = {
    "velocity": 3,
    "density": 1,
    "pressure": 1,
    "energy": 1,
    "mach": 1,
    "smoothing_length": 1,
    "mass": 1,
    "entropy": 1,
    "kind": 1,
    "id": 1,
}
GHOSTS = {"normal": 3, "distance": 1, "volume": 1, "layer": 1, "body": 1}
CELLS = {"velocity": 3, "density": 1, "pressure": 1, "mach": 1, "volume": 1, "entropy": 1, "id": 1}
FIELD = {"velocity": 3, "density": 1, "pressure": 1, "mach": 1, "entropy": 1, "density_gradient": 3, "vtkValidPointMask": 1}
FIELDS = ("TimeValue", "free_stream_pressure", "free_stream_density", "free_stream_velocity", "gamma", "spacing")
SURFACE = {"normal": 3, "pressure": 1, "pressure_coefficient": 1, "body": 1}

# Values of `kind`.
FLUID, OUTLET, LAST_KIND = 0, 2, 3


def expected_arrays(path):
    """The arrays that a file of this name must have."""
    name = path.name
    if name.startswith(("frame-", "ghosts-")):
        return FRAME
    if name.startswith("surface-"):
        return SURFACE
    if name.endswith("-ghosts.vtp"):
        return GHOSTS
    return {}


def check_values(arrays):
    """What is wrong with the values of the arrays present."""
    faults = []

    def require(ok, message):
        if not numpy.all(ok):
            count = numpy.count_nonzero(~numpy.asarray(ok))
            faults.append(f"{message} at {count} points")

    kind = arrays.get("kind")
    moving = slice(None) if kind is None else kind <= OUTLET
    fluid = slice(None) if kind is None else kind == FLUID
    for name in ("density", "energy"):
        if name in arrays:
            require(arrays[name][fluid] > 0, f"`{name}` is not positive")
    for name in ("smoothing_length", "volume", "spacing"):
        if name in arrays:
            require(arrays[name] > 0, f"`{name}` is not positive")
    for name in ("mach", "layer", "body"):
        if name in arrays:
            require(arrays[name] >= 0, f"`{name}` is negative")
    if kind is not None:
        require(numpy.isin(kind, range(LAST_KIND + 1)), f"`kind` is not one of 0 to {LAST_KIND}")
    if "id" in arrays:
        ids = arrays["id"][moving]
        if len(numpy.unique(ids)) != len(ids):
            faults.append(f"`id` repeats: {len(ids) - len(numpy.unique(ids))} of {len(ids)} are not new")
    if "normal" in arrays:
        length = numpy.linalg.norm(arrays["normal"], axis=1)
        require(numpy.abs(length - 1) < 1e-3, "`normal` is not a unit vector")
    return faults


READERS = {".vtp": vtkXMLPolyDataReader, ".vtu": vtkXMLUnstructuredGridReader, ".vti": vtkXMLImageDataReader}


def read(path):
    """What VTK makes of a file, and what it complains of."""
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    reader = READERS[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    complaints = window.GetOutput().strip()
    return reader.GetOutput(), [f"VTK complains: {' '.join(complaints.split())}"] if complaints else []


def check_file(path):
    """What is wrong with one .vtp file, and a line that describes it."""
    data, complaints = read(path)
    if complaints:
        return complaints, ""
    count = data.GetNumberOfPoints()
    if count == 0:
        return ["there are no points"], ""
    faults = []
    if not numpy.isfinite(vtk_to_numpy(data.GetPoints().GetData())).all():
        faults.append("some positions are not finite")
    of_cells = path.name.startswith("surface-")
    if not of_cells and data.GetNumberOfVerts() != count:
        faults.append(f"{data.GetNumberOfVerts()} vertex cells for {count} points; write one each")
    if path.name.startswith(("frame-", "ghosts-", "surface-")):
        faults += missing_fields(data)
    point_data = data.GetCellData() if of_cells else data.GetPointData()
    count = data.GetNumberOfCells() if of_cells else count
    arrays = {}
    for index in range(point_data.GetNumberOfArrays()):
        array = point_data.GetAbstractArray(index)
        name = array.GetName()
        if name is None or point_data.GetArray(index) is None:
            faults.append(f"array {index} has no name or holds no numbers")
            continue
        values = vtk_to_numpy(array)
        if len(values) != count:
            faults.append(f"`{name}` has {len(values)} entries for {count} {'cells' if of_cells else 'points'}")
        elif not numpy.isfinite(values).all():
            bad = numpy.count_nonzero(~numpy.isfinite(values))
            faults.append(f"`{name}` has {bad} values that are not finite")
        else:
            arrays[name] = values
    for name, components in expected_arrays(path).items():
        array = point_data.GetArray(name)
        if array is None:
            faults.append(f"`{name}` is missing")
        elif array.GetNumberOfComponents() != components:
            faults.append(f"`{name}` has {array.GetNumberOfComponents()} components, not {components}")
            arrays.pop(name, None)
    faults += check_values(arrays)
    return faults, f"{count} {'cells' if of_cells else 'points'}; {', '.join(sorted(arrays)) or 'no arrays'}"


def missing_fields(data):
    """What a file does not say of the whole, and units that are no text."""
    fields = data.GetFieldData()
    faults = [f"field `{name}` is missing" for name in FIELDS if fields.GetArray(name) is None]
    units = fields.GetAbstractArray("units")
    if units is None or not str(units.GetVariantValue(0).ToString()).isprintable() or not units.GetVariantValue(0).ToString():
        faults.append("field `units` is missing or no text")
    return faults


def named_arrays(attributes, wanted):
    """The arrays that must be there, with what is wrong with them."""
    faults, arrays = [], {}
    for name, components in wanted.items():
        array = attributes.GetArray(name)
        if array is None or array.GetNumberOfComponents() != components:
            faults.append(f"`{name}` is missing or has not {components} components")
            continue
        arrays[name] = vtk_to_numpy(array)
        if not numpy.isfinite(arrays[name]).all():
            faults.append(f"`{name}` has values that are not finite")
    return faults, arrays


# Cells that `vtkGhostType` hides.
HIDDEN = 32


def check_field(path):
    """What is wrong with one field on a lattice, and a line that describes it."""
    data, complaints = read(path)
    if complaints:
        return complaints, ""
    faults, arrays = named_arrays(data.GetPointData(), FIELD)
    faults += missing_fields(data)
    ghosts = data.GetCellData().GetArray("vtkGhostType")
    if ghosts is None or data.GetCellGhostArray() is None:
        faults.append("`vtkGhostType` of the cells is missing, or VTK does not take it for that")
    if faults:
        return faults, ""
    shape = data.GetDimensions()[::-1]
    gas = arrays["vtkValidPointMask"].reshape(shape) == 1
    if not gas.any():
        return ["no point lies in the gas"], ""
    for name in ("density", "pressure"):
        if (arrays[name].reshape(shape)[gas] <= 0).any():
            faults.append(f"`{name}` is not positive")
    # A cell is hidden where none of its corners is in the gas.
    shows = gas
    for axis in range(3):
        if shape[axis] > 1:
            shows = numpy.take(shows, range(1, shows.shape[axis]), axis) | numpy.take(shows, range(shows.shape[axis] - 1), axis)
    if ((vtk_to_numpy(ghosts) != HIDDEN) != shows.ravel()).any():
        faults.append("hidden cells are not those that lie in bodies")
    for axis in range(3):
        faults += check_gradient(arrays, gas, shape, 2 - axis, data.GetSpacing()[axis], "xyz"[axis])
    return faults, f"{' x '.join(map(str, data.GetDimensions()))} points, {gas.mean():.1%} in the gas"


def check_gradient(arrays, gas, shape, axis, spacing, letter):
    """Whether the gradient of the density is that of its values, where these rise evenly: shocks of finer gas fall between points."""
    if shape[axis] < 3:
        return []
    density = arrays["density"].reshape(shape)
    found = arrays["density_gradient"].reshape(*shape, 3)[..., "xyz".index(letter)]
    part = lambda values, first, last: numpy.take(values, range(first, shape[axis] - last), axis)
    before, after = part(density, 1, 1) - part(density, 0, 2), part(density, 2, 0) - part(density, 1, 1)
    rise = (before + after) / (2 * spacing)
    inside = part(gas, 2, 0) & part(gas, 0, 2) & part(gas, 1, 1)
    even = inside & (numpy.abs(after - before) < 0.3 * spacing * numpy.abs(rise))
    even &= numpy.abs(rise) > max(0.02 * numpy.abs(rise[inside]).max(initial=0), 1e-9 * density.max() / spacing)
    if numpy.count_nonzero(even) < 10:
        return []
    ratio = numpy.median(part(found, 1, 1)[even] / rise[even])
    if not 0.7 < ratio < 1.4:
        return [f"`density_gradient` along {letter} is {ratio:.2f} times that of the density"]
    return []


# Faces of a hexahedron, seen from without.
HEXAHEDRON = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))


def polygon_area(corners):
    """Area vector of a polygon."""
    edges = corners - corners[0]
    return 0.5 * numpy.cross(edges[:-1], edges[1:]).sum(axis=0)


def cell_volume(points, kind, corners, faces):
    """Volume of a cell, from its corners; and how far its faces are from closing, relative to their area."""
    if kind in (7, 9):
        ring = points[corners]
        return polygon_area(ring)[2], 0.0
    if kind == 12:
        faces = [[corners[k] for k in face] for face in HEXAHEDRON]
    middle = points[corners].mean(axis=0)
    volume, open_area, area = 0.0, numpy.zeros(3), 0.0
    for face in faces:
        ring = points[face] - middle
        for a, b in zip(ring[1:-1], ring[2:]):
            part = 0.5 * numpy.cross(a - ring[0], b - ring[0])
            volume += part @ (ring[0] + a + b) / 9
            open_area += part
            area += numpy.linalg.norm(part)
    return volume, numpy.linalg.norm(open_area) / area


def check_cells(path):
    """What is wrong with one file of cells, and a line that describes it."""
    data, complaints = read(path)
    if complaints:
        return complaints, ""
    count = data.GetNumberOfCells()
    if count == 0:
        return ["there are no cells"], ""
    faults, arrays = named_arrays(data.GetCellData(), CELLS)
    faults += missing_fields(data)
    if faults:
        return faults, ""
    points = vtk_to_numpy(data.GetPoints().GetData())
    if not numpy.isfinite(points).all():
        return ["some corners are not finite"], ""
    ids, numbers = arrays["id"], vtkIdList()
    volumes, worst = dict.fromkeys(ids, 0.0), 0.0
    for cell in range(count):
        kind = data.GetCellType(cell)
        data.GetCellPoints(cell, numbers)
        corners = [numbers.GetId(k) for k in range(numbers.GetNumberOfIds())]
        faces = []
        if kind == 42:
            data.GetFaceStream(cell, numbers)
            stream = [numbers.GetId(k) for k in range(numbers.GetNumberOfIds())]
            at = 1
            while at < len(stream):
                faces.append(stream[at + 1 : at + 1 + stream[at]])
                at += 1 + stream[at]
        volume, gap = cell_volume(points, kind, corners, faces)
        volumes[ids[cell]] += volume
        worst = max(worst, gap)
    if worst > 1e-6:
        faults.append(f"a cell is open by {worst:.1e} of its surface")
    said = dict(zip(ids, arrays["volume"]))
    ratio = numpy.array([volumes[key] / said[key] for key in said])
    total, told = sum(volumes.values()), sum(said.values())
    # Of rings the file shows the meridian.
    frame = path.with_name(path.name.replace("cells-", "frame-")).with_suffix(".vtp")
    is_flat = numpy.abs(ratio - 1).max() < 1e-5
    if not is_flat and numpy.abs(ratio - 1).min() < 1e-9:
        faults.append(f"a cell's corners give {100 * numpy.abs(ratio - 1).max():.1e} % of another volume than it says")
    if frame.is_file():
        there = vtk_to_numpy(read(frame)[0].GetPointData().GetArray("id"))
        if set(there) != set(ids):
            faults.append(f"{len(set(ids))} cells for the {len(there)} points of `{frame.name}`")
    note = f"{count} cells of {len(said)} points; volume {total:.9g}"
    return faults, note if is_flat else f"{note}, of rings {told:.9g}"


CHECKS = {".vtp": check_file, ".vtu": check_cells, ".vti": check_field}


def check_collection(path):
    """What is wrong with a .pvd collection, and the files it lists."""
    try:
        root = ElementTree.parse(path).getroot()
    except ElementTree.ParseError as error:
        return [f"not well-formed: {error}"], []
    if root.tag != "VTKFile" or root.get("type") != "Collection":
        return ["not a VTK collection"], []
    faults, files, last, seen = [], [], None, set()
    for entry in root.iter("DataSet"):
        listed = entry.get("file")
        if not listed:
            faults.append("an entry names no file")
            continue
        try:
            time = float(entry.get("timestep", "nan"))
        except ValueError:
            time = float("nan")
        if not numpy.isfinite(time):
            faults.append(f"`{listed}` has no time")
        elif last is not None and time < last:
            faults.append(f"the time falls from {last} to {time} at `{listed}`")
        key = (time, entry.get("group"), entry.get("part"))
        if key in seen:
            faults.append(f"time {time} comes twice for the same part, at `{listed}`")
        seen.add(key)
        last = time
        target = path.parent / listed
        if target.is_file():
            files.append(target)
        else:
            faults.append(f"`{listed}` does not exist")
    if not files and not faults:
        faults.append("it lists no files")
    return faults, files


def main(arguments):
    if not arguments or arguments[0] in ("-h", "--help"):
        print(__doc__)
        return 0 if arguments else 2
    # Errors are collected per file and reported once.
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    collections, files = [], []
    for path in map(pathlib.Path, arguments):
        if path.is_dir():
            collections += sorted(path.glob("*.pvd"))
            files += [file for suffix in READERS for file in sorted(path.glob(f"*{suffix}"))]
        elif not path.is_file():
            print(f"check_vtk.py: `{path}` does not exist", file=sys.stderr)
            return 2
        elif path.suffix == ".pvd":
            collections.append(path)
        else:
            files.append(path)
    faulty = 0

    def report(path, faults, note):
        nonlocal faulty
        faulty += bool(faults)
        print(f"{'FAULT' if faults else 'ok':5}  {path}  {'' if faults else note}".rstrip())
        for fault in faults:
            print(f"       {fault}")

    for path in collections:
        faults, listed = check_collection(path)
        report(path, faults, f"{len(listed)} files")
        files += listed
    unique = list(dict.fromkeys(path.resolve() for path in files))
    for path in unique:
        report(path, *CHECKS.get(path.suffix, check_file)(path))
    total = len(collections) + len(unique)
    if total == 0:
        print("check_vtk.py: no .pvd, .vtp, .vtu or .vti files to check", file=sys.stderr)
        return 2
    print(f"{total - faulty} of {total} files are good")
    return 1 if faulty else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
