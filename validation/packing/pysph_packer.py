#!/usr/bin/env python3
"""Packs the circle (R = 10 dx) and the biconvex aerofoil (c = 80 dx) with PySPH's packer and prints
the figures that `cargo run --release -p aero-packer --example figures` prints for this one.

    pip install pysph numpy-stl
    python3 validation/packing/pysph_packer.py circle biconvex

Nothing else needs this script. PySPH's method: Negi & Ramachandran 2021, "Algorithms for uniform particle
initialization in domains with complex boundaries", Comput. Phys. Commun. 265, 108008. Its options are its own
defaults; its first row lies dx/2 inside the surface, as here. Density is summed with the quintic spline,
h = 1.5 dx, over all particles and taken at those within dx of the surface, both sides.
"""

import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

DX = 0.1
SMOOTHING = 1.5 * DX
NODES_PER_DX = 5


def circle():
    radius = 10 * DX
    count = round(2 * np.pi * radius / DX * NODES_PER_DX)
    angle = 2 * np.pi * np.arange(count) / count
    nodes = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    return nodes, lambda p: np.hypot(p[:, 0], p[:, 1]) - radius, (0, 1)


def biconvex():
    chord, sagitta = 80 * DX, 4 * DX
    radius = (chord**2 / 4 + sagitta**2) / (2 * sagitta)
    depth = radius - sagitta
    opening = np.arcsin(0.5 * chord / radius)
    count = round(2 * opening * radius / DX * NODES_PER_DX)
    angle = opening * (1 - 2 * np.arange(count) / count)
    upper = np.column_stack([radius * np.sin(angle), radius * np.cos(angle) - depth])
    nodes = np.vstack([upper, -upper])

    def distance(p):
        """The lens is where both circles overlap; outside beyond a tip the tip is nearest."""
        x, y = p[:, 0], np.abs(p[:, 1])
        to_arc = np.hypot(x, y + depth) - radius
        to_tip = np.hypot(np.abs(x) - chord / 2, y)
        beyond = (to_arc > 0) & (np.abs(np.arctan2(x, y + depth)) > opening)
        return np.where(beyond, to_tip, to_arc)

    return nodes, distance, (0, 1)


def density(points):
    """Summed with the quintic spline, h = 1.5 dx."""
    norm = 7 / (478 * np.pi * SMOOTHING**2)
    tree = cKDTree(points)
    pairs = tree.sparse_distance_matrix(tree, 3 * SMOOTHING, output_type="coo_matrix")
    q = pairs.data / SMOOTHING
    value = (3 - q) ** 5 - 6 * np.clip(2 - q, 0, None) ** 5 + 15 * np.clip(1 - q, 0, None) ** 5
    # A particle's own term is not among the stored pairs.
    total = np.bincount(pairs.row, np.where(pairs.data > 0, value, 0), len(points)) + 66
    return DX * DX * norm * total


def packed(nodes):
    from pysph.tools.packer import Packer

    folder = Path(tempfile.mkdtemp())
    (folder / "body.txt").write_text("".join(f"{x:.12g} {y:.12g}\n" for x, y in nodes))
    packer = Packer(None, str(folder / "packing"), None, lambda group: None, DX, str(folder / "packed.npz"),
                    dim=2, filename=str(folder / "body.txt"), shift=True)
    start = time.process_time()
    packer.run(["--max-steps", "40000"])
    steps = packer.solver.count
    seconds = time.process_time() - start
    packer.post_process(packer.info_filename)
    data = np.load(folder / "packed.npz")
    ghosts = np.column_stack([data["xs"], data["ys"]])
    fluid = np.column_stack([data["xf"], data["yf"]])
    return ghosts, fluid, steps, seconds


def mirror_errors(points, axis):
    image = points.copy()
    image[:, axis] *= -1
    return cKDTree(points).query(image)[0] / DX


def main():
    bodies = {"circle": circle, "biconvex": biconvex}
    names = sys.argv[1:] or list(bodies)
    sys.argv = sys.argv[:1]
    rows = []
    for name in names:
        nodes, distance, axes = bodies[name]()
        ghosts, fluid, steps, seconds = packed(nodes)
        everything = np.vstack([ghosts, fluid])
        error = 100 * (density(everything) - 1)[np.abs(distance(everything)) < DX]
        # Near sharp tips the packer's own split into solid and fluid errs; the exact distance decides.
        ghosts = everything[distance(everything) < 0]
        wall = np.abs(distance(ghosts) + DX / 2) < 0.25 * DX
        offset = np.abs(distance(ghosts)[wall] + DX / 2).max() / DX
        gap = cKDTree(everything).query(everything, k=2)[0][:, 1].min() / DX
        mirror = np.concatenate([mirror_errors(ghosts, axis) for axis in axes])
        rows.append(f"| {name} | {len(ghosts)} | {steps} | {error.std():.2f} | {np.abs(error).max():.2f} "
                    f"| {offset:.0e} | {gap:.2f} | {np.median(mirror):.3f} | {mirror.max():.2f} | {seconds:.1f} |")
    print("| body | ghosts | steps | density std, % | max, % | wall offset, dx | gap, dx "
          "| mirror error, median, dx | largest | CPU s |\n|---|---|---|---|---|---|---|---|---|---|")
    print("\n".join(rows))


if __name__ == "__main__":
    main()
