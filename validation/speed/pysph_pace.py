#!/usr/bin/env python3
"""How many fluid particles PySPH and `aero` move by one step in a second of processor time, on the same flows.

    pip install pysph
    cargo build --release
    python3 validation/speed/pysph_pace.py --aero target/release/aero [wedge] [wedge-fine] [space]

Nothing else needs this script. Both run the published scheme (Villodi & Ramachandran, "Improved solid boundary
treatment for compressible smooth particle hydrodynamics", section 3, without ghost mirrors, its misprints set
right) in double precision on one thread: quintic spline, h = 1.5 dx, evaluate-predict-evaluate-correct. PySPH keeps
its neighbour cache on and compiles with its own flags unless CFLAGS says otherwise. Then `aero` does once more, with its
default scheme and all that it saves.

`wedge` is the Mach 2.5, 20 degree compression corner with open sides at dx = 1/16, run to t = 10: its plateau density tells
that PySPH solves the same flow. `wedge-fine` is its beginning at dx = 1/64; `space` a periodic box of stirred gas.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

os.environ["OMP_NUM_THREADS"] = "1"

import numpy as np
from compyle.api import declare
from compyle.config import get_config
from pysph.base.kernels import QuinticSpline
from pysph.base.nnps import DomainManager, LinkedListNNPS
from pysph.base.utils import get_particle_array
from pysph.sph.acceleration_eval import AccelerationEval
from pysph.sph.equation import Equation, Group
from pysph.sph.integrator import EPECIntegrator
from pysph.sph.integrator_step import IntegratorStep
from pysph.sph.sph_compiler import SPHCompiler

GAMMA = 1.4
ALPHA, BETA, DELTA, KAPPA, CFL = 1.0, 2.0, 0.1, 0.1, 0.5
SMOOTHING_RATIO = 1.5
BUFFER = 6  # spacings
LAYERS = 5

STATE = ["x", "y", "z", "u", "v", "w", "rho", "e", "h", "m"]
STARTS = [name + "0" for name in STATE[:9]]
RATES = ["au", "av", "aw", "arho", "ae"]
OTHERS = ["p", "cs", "vol", "gx", "gy", "gz", "wsum", "nx", "ny", "nz"]
ROOT = Path(__file__).resolve().parents[2]


class StateOfGas(Equation):
    """Eq. 16, and the volume m / rho."""

    def __init__(self, dest, sources):
        self.gamma = GAMMA
        super().__init__(dest, sources)

    def initialize(self, d_idx, d_p, d_cs, d_vol, d_rho, d_e, d_m):
        d_p[d_idx] = (self.gamma - 1.0) * d_rho[d_idx] * d_e[d_idx]
        d_cs[d_idx] = sqrt(self.gamma * d_p[d_idx] / d_rho[d_idx])
        d_vol[d_idx] = d_m[d_idx] / d_rho[d_idx]


class Extrapolate(Equation):
    """Eq. 24: the gas at a ghost; eqs. 26 and 27: its mirror at a slip wall at rest. Constant volume."""

    def __init__(self, dest, sources):
        self.gamma = GAMMA
        super().__init__(dest, sources)

    def initialize(self, d_idx, d_wsum, d_au, d_av, d_aw, d_arho, d_ae, d_gx):
        d_wsum[d_idx] = 0.0
        d_au[d_idx] = 0.0
        d_av[d_idx] = 0.0
        d_aw[d_idx] = 0.0
        d_arho[d_idx] = 0.0
        d_ae[d_idx] = 0.0
        d_gx[d_idx] = 0.0

    def loop(self, d_idx, s_idx, d_wsum, d_au, d_av, d_aw, d_arho, d_ae, d_gx,
             s_u, s_v, s_w, s_p, s_e, s_h, WIJ):
        d_wsum[d_idx] += WIJ
        d_au[d_idx] += s_u[s_idx] * WIJ
        d_av[d_idx] += s_v[s_idx] * WIJ
        d_aw[d_idx] += s_w[s_idx] * WIJ
        d_arho[d_idx] += s_p[s_idx] * WIJ
        d_ae[d_idx] += s_e[s_idx] * WIJ
        d_gx[d_idx] += s_h[s_idx] * WIJ

    def post_loop(self, d_idx, d_wsum, d_au, d_av, d_aw, d_arho, d_ae, d_gx, d_nx, d_ny, d_nz,
                  d_u, d_v, d_w, d_p, d_e, d_h, d_rho, d_cs):
        through = declare("double")
        weight = declare("double")
        # A ghost that no gas sees keeps what it has.
        if d_wsum[d_idx] > 1e-12:
            weight = 1.0 / d_wsum[d_idx]
            through = 2.0 * weight * (d_au[d_idx] * d_nx[d_idx] + d_av[d_idx] * d_ny[d_idx]
                                      + d_aw[d_idx] * d_nz[d_idx])
            d_u[d_idx] = d_au[d_idx] * weight - through * d_nx[d_idx]
            d_v[d_idx] = d_av[d_idx] * weight - through * d_ny[d_idx]
            d_w[d_idx] = d_aw[d_idx] * weight - through * d_nz[d_idx]
            d_p[d_idx] = d_arho[d_idx] * weight
            d_e[d_idx] = d_ae[d_idx] * weight
            d_h[d_idx] = d_gx[d_idx] * weight
            d_rho[d_idx] = d_p[d_idx] / ((self.gamma - 1.0) * d_e[d_idx])
            d_cs[d_idx] = sqrt(self.gamma * d_p[d_idx] / d_rho[d_idx])


class Renormalise(Equation):
    """Eq. 7, and eq. 8 for the density. The matrix is symmetric: xx, xy, yy, xz, yz, zz."""

    def __init__(self, dest, sources, dim):
        self.dim = dim
        super().__init__(dest, sources)

    def initialize(self, d_idx, d_L, d_gx, d_gy, d_gz):
        k = declare("int")
        for k in range(6):
            d_L[6 * d_idx + k] = 0.0
        d_gx[d_idx] = 0.0
        d_gy[d_idx] = 0.0
        d_gz[d_idx] = 0.0

    def loop(self, d_idx, s_idx, d_L, d_gx, d_gy, d_gz, d_rho, s_rho, s_vol, XIJ, DWIJ):
        change = declare("double")
        vol = declare("double")
        vol = s_vol[s_idx]
        change = vol * (s_rho[s_idx] - d_rho[d_idx])
        d_L[6 * d_idx] -= vol * XIJ[0] * DWIJ[0]
        d_L[6 * d_idx + 1] -= vol * XIJ[0] * DWIJ[1]
        d_L[6 * d_idx + 2] -= vol * XIJ[1] * DWIJ[1]
        d_gx[d_idx] += change * DWIJ[0]
        d_gy[d_idx] += change * DWIJ[1]
        if self.dim == 3:
            d_L[6 * d_idx + 3] -= vol * XIJ[0] * DWIJ[2]
            d_L[6 * d_idx + 4] -= vol * XIJ[1] * DWIJ[2]
            d_L[6 * d_idx + 5] -= vol * XIJ[2] * DWIJ[2]
            d_gz[d_idx] += change * DWIJ[2]

    def post_loop(self, d_idx, d_L, d_gx, d_gy, d_gz):
        a, b, c, d, e, f, det, gx, gy, gz = declare("double", 10)
        a = d_L[6 * d_idx]
        b = d_L[6 * d_idx + 1]
        c = d_L[6 * d_idx + 2]
        d = d_L[6 * d_idx + 3]
        e = d_L[6 * d_idx + 4]
        f = d_L[6 * d_idx + 5]
        if self.dim == 2:
            f = 1.0
        det = a * (c * f - e * e) - b * (b * f - d * e) + d * (b * e - c * d)
        if abs(det) < 0.1:
            # Near singular: no renormalisation.
            d_L[6 * d_idx] = 1.0
            d_L[6 * d_idx + 1] = 0.0
            d_L[6 * d_idx + 2] = 1.0
            d_L[6 * d_idx + 3] = 0.0
            d_L[6 * d_idx + 4] = 0.0
            d_L[6 * d_idx + 5] = 1.0
        else:
            det = 1.0 / det
            d_L[6 * d_idx] = (c * f - e * e) * det
            d_L[6 * d_idx + 1] = (d * e - b * f) * det
            d_L[6 * d_idx + 2] = (a * f - d * d) * det
            d_L[6 * d_idx + 3] = (b * e - c * d) * det
            d_L[6 * d_idx + 4] = (b * d - a * e) * det
            d_L[6 * d_idx + 5] = (a * c - b * b) * det
        gx = d_gx[d_idx]
        gy = d_gy[d_idx]
        gz = d_gz[d_idx]
        d_gx[d_idx] = d_L[6 * d_idx] * gx + d_L[6 * d_idx + 1] * gy + d_L[6 * d_idx + 3] * gz
        d_gy[d_idx] = d_L[6 * d_idx + 1] * gx + d_L[6 * d_idx + 2] * gy + d_L[6 * d_idx + 4] * gz
        d_gz[d_idx] = d_L[6 * d_idx + 3] * gx + d_L[6 * d_idx + 4] * gy + d_L[6 * d_idx + 5] * gz


class Still(Equation):
    """Rates of zero, to be added to; `wsum` takes the divergence of the velocity."""

    def initialize(self, d_idx, d_au, d_av, d_aw, d_arho, d_ae, d_wsum):
        d_au[d_idx] = 0.0
        d_av[d_idx] = 0.0
        d_aw[d_idx] = 0.0
        d_arho[d_idx] = 0.0
        d_ae[d_idx] = 0.0
        d_wsum[d_idx] = 0.0


class Rates(Equation):
    """Eqs. 5, 9, 12 and 13; from gas (`phase` 1) also the diffusion and conduction of eqs. 10 and 14."""

    def __init__(self, dest, sources, dim, phase):
        self.dim = dim
        self.phase = phase
        self.alpha = ALPHA
        self.beta = BETA
        self.delta = DELTA
        self.kappa = KAPPA
        super().__init__(dest, sources)

    def loop(self, d_idx, s_idx, d_L, s_L, d_p, s_p, d_rho, s_rho, d_e, s_e, d_cs, s_cs, d_h, s_h, s_vol,
             d_gx, d_gy, d_gz, s_gx, s_gy, s_gz, d_au, d_av, d_aw, d_arho, d_ae, d_wsum, VIJ, XIJ, DWIJ, R2IJ):
        i, j = declare("int", 2)
        gx, gy, gz, vol, approach, c, h, mu, visc, mean, slope, jump, fx, fy, fz, work = declare("double", 16)
        i = 6 * d_idx
        j = 6 * s_idx
        vol = s_vol[s_idx]
        gx = DWIJ[0]
        gy = DWIJ[1]
        gz = DWIJ[2]
        approach = VIJ[0] * XIJ[0] + VIJ[1] * XIJ[1] + VIJ[2] * XIJ[2]
        c = 0.5 * (d_cs[d_idx] + s_cs[s_idx])
        h = 0.5 * (d_h[d_idx] + s_h[s_idx])
        mean = 0.5 * (d_rho[d_idx] + s_rho[s_idx])
        visc = 0.0
        if approach < 0.0:
            mu = h * approach / R2IJ
            visc = vol * s_rho[s_idx] / mean * (self.alpha * c * mu - self.beta * mu * mu)
        if self.dim == 2:
            d_wsum[d_idx] -= vol * (VIJ[0] * (d_L[i] * gx + d_L[i + 1] * gy)
                                    + VIJ[1] * (d_L[i + 1] * gx + d_L[i + 2] * gy))
            fx = (d_p[d_idx] * d_L[i] + s_p[s_idx] * s_L[j]) * gx \
                + (d_p[d_idx] * d_L[i + 1] + s_p[s_idx] * s_L[j + 1]) * gy
            fy = (d_p[d_idx] * d_L[i + 1] + s_p[s_idx] * s_L[j + 1]) * gx \
                + (d_p[d_idx] * d_L[i + 2] + s_p[s_idx] * s_L[j + 2]) * gy
            fz = 0.0
            work = VIJ[0] * gx + VIJ[1] * gy
            slope = XIJ[0] * gx + XIJ[1] * gy
        else:
            d_wsum[d_idx] -= vol * (VIJ[0] * (d_L[i] * gx + d_L[i + 1] * gy + d_L[i + 3] * gz)
                                    + VIJ[1] * (d_L[i + 1] * gx + d_L[i + 2] * gy + d_L[i + 4] * gz)
                                    + VIJ[2] * (d_L[i + 3] * gx + d_L[i + 4] * gy + d_L[i + 5] * gz))
            fx = (d_p[d_idx] * d_L[i] + s_p[s_idx] * s_L[j]) * gx \
                + (d_p[d_idx] * d_L[i + 1] + s_p[s_idx] * s_L[j + 1]) * gy \
                + (d_p[d_idx] * d_L[i + 3] + s_p[s_idx] * s_L[j + 3]) * gz
            fy = (d_p[d_idx] * d_L[i + 1] + s_p[s_idx] * s_L[j + 1]) * gx \
                + (d_p[d_idx] * d_L[i + 2] + s_p[s_idx] * s_L[j + 2]) * gy \
                + (d_p[d_idx] * d_L[i + 4] + s_p[s_idx] * s_L[j + 4]) * gz
            fz = (d_p[d_idx] * d_L[i + 3] + s_p[s_idx] * s_L[j + 3]) * gx \
                + (d_p[d_idx] * d_L[i + 4] + s_p[s_idx] * s_L[j + 4]) * gy \
                + (d_p[d_idx] * d_L[i + 5] + s_p[s_idx] * s_L[j + 5]) * gz
            work = VIJ[0] * gx + VIJ[1] * gy + VIJ[2] * gz
            slope = XIJ[0] * gx + XIJ[1] * gy + XIJ[2] * gz
        d_au[d_idx] += visc * gx - vol / d_rho[d_idx] * fx
        d_av[d_idx] += visc * gy - vol / d_rho[d_idx] * fy
        d_aw[d_idx] += visc * gz - vol / d_rho[d_idx] * fz
        d_ae[d_idx] -= 0.5 * visc * work
        if self.phase == 1 and R2IJ > 0.0:
            # `XIJ` points from j to i, the equations' r_ji the other way.
            slope = -2.0 * c * h * vol * slope / R2IJ
            jump = s_rho[s_idx] - d_rho[d_idx] + 0.5 * (
                (d_gx[d_idx] + s_gx[s_idx]) * XIJ[0] + (d_gy[d_idx] + s_gy[s_idx]) * XIJ[1]
                + (d_gz[d_idx] + s_gz[s_idx]) * XIJ[2])
            d_arho[d_idx] += self.delta * slope * jump
            d_ae[d_idx] += self.kappa * slope * (s_e[s_idx] - d_e[d_idx])

    def post_loop(self, d_idx):
        pass


class Compress(Equation):
    """The divergence's part of eqs. 10 and 14."""

    def initialize(self, d_idx, d_arho, d_ae, d_wsum, d_rho, d_p):
        d_arho[d_idx] -= d_rho[d_idx] * d_wsum[d_idx]
        d_ae[d_idx] -= d_p[d_idx] / d_rho[d_idx] * d_wsum[d_idx]


class Midpoint(IntegratorStep):
    """Eqs. 17 and 33; the velocity that moves a particle is the one of the evaluation."""

    def __init__(self, dim):
        super().__init__()
        self.dim = float(dim)

    def initialize(self, d_idx, d_x, d_y, d_z, d_u, d_v, d_w, d_rho, d_e, d_h,
                   d_x0, d_y0, d_z0, d_u0, d_v0, d_w0, d_rho0, d_e0, d_h0):
        d_x0[d_idx] = d_x[d_idx]
        d_y0[d_idx] = d_y[d_idx]
        d_z0[d_idx] = d_z[d_idx]
        d_u0[d_idx] = d_u[d_idx]
        d_v0[d_idx] = d_v[d_idx]
        d_w0[d_idx] = d_w[d_idx]
        d_rho0[d_idx] = d_rho[d_idx]
        d_e0[d_idx] = d_e[d_idx]
        d_h0[d_idx] = d_h[d_idx]

    def stage1(self, d_idx, d_x, d_y, d_z, d_u, d_v, d_w, d_rho, d_e, d_h, d_x0, d_y0, d_z0, d_u0, d_v0, d_w0,
               d_rho0, d_e0, d_h0, d_au, d_av, d_aw, d_arho, d_ae, dt):
        d_x[d_idx] = d_x0[d_idx] + 0.5 * dt * d_u[d_idx]
        d_y[d_idx] = d_y0[d_idx] + 0.5 * dt * d_v[d_idx]
        d_z[d_idx] = d_z0[d_idx] + 0.5 * dt * d_w[d_idx]
        d_u[d_idx] = d_u0[d_idx] + 0.5 * dt * d_au[d_idx]
        d_v[d_idx] = d_v0[d_idx] + 0.5 * dt * d_av[d_idx]
        d_w[d_idx] = d_w0[d_idx] + 0.5 * dt * d_aw[d_idx]
        d_h[d_idx] = d_h0[d_idx] * (1.0 - 0.5 * dt * d_arho[d_idx] / (self.dim * d_rho[d_idx]))
        d_rho[d_idx] = d_rho0[d_idx] + 0.5 * dt * d_arho[d_idx]
        d_e[d_idx] = d_e0[d_idx] + 0.5 * dt * d_ae[d_idx]

    def stage2(self, d_idx, d_x, d_y, d_z, d_u, d_v, d_w, d_rho, d_e, d_h, d_x0, d_y0, d_z0, d_u0, d_v0, d_w0,
               d_rho0, d_e0, d_h0, d_au, d_av, d_aw, d_arho, d_ae, dt):
        d_h[d_idx] = d_h0[d_idx] - dt * d_h[d_idx] * d_arho[d_idx] / (self.dim * d_rho[d_idx])
        d_x[d_idx] = d_x0[d_idx] + dt * d_u[d_idx]
        d_y[d_idx] = d_y0[d_idx] + dt * d_v[d_idx]
        d_z[d_idx] = d_z0[d_idx] + dt * d_w[d_idx]
        d_u[d_idx] = d_u0[d_idx] + dt * d_au[d_idx]
        d_v[d_idx] = d_v0[d_idx] + dt * d_av[d_idx]
        d_w[d_idx] = d_w0[d_idx] + dt * d_aw[d_idx]
        d_rho[d_idx] = d_rho0[d_idx] + dt * d_arho[d_idx]
        d_e[d_idx] = d_e0[d_idx] + dt * d_ae[d_idx]


class Simulation:
    """The published scheme over PySPH's arrays: gas alone, or gas, open buffers and ghosts."""

    def __init__(self, dim, arrays, domain=None):
        self.gas = arrays[0]
        names = [array.name for array in arrays]
        gases = names[:2]
        # Periodic images work out their own state, and are told the rest by those that they show.
        equations = [Group([StateOfGas(names[0], None)], real=False)]
        if len(names) > 2:
            equations.append(Group([Extrapolate(names[2], gases)]))
        rates = [Still(names[0], None), Rates(names[0], gases, dim, 1)]
        if len(names) > 2:
            rates.append(Rates(names[0], names[2:], dim, 0))
        equations += [
            Group([Renormalise(names[0], names, dim)], post=self.tell_images),
            Group(rates),
            Group([Compress(names[0], None)]),
        ]
        self.gas.gid[:] = np.arange(len(self.gas.gid))
        kernel = QuinticSpline(dim=dim)
        self.integrator = EPECIntegrator(**{names[0]: Midpoint(dim)})
        evaluation = AccelerationEval(arrays, equations, kernel)
        SPHCompiler(evaluation, self.integrator).compile()
        self.nnps = LinkedListNNPS(dim, arrays, radius_scale=kernel.radius_scale, domain=domain, cache=True)
        evaluation.set_nnps(self.nnps)
        self.integrator.set_nnps(self.nnps)
        self.integrator.set_acceleration_evals([evaluation])
        self.time = 0.0
        self.steps = 0
        self.updates = 0

    def tell_images(self):
        """Gives periodic images the gradients of those that they show."""
        gas = self.gas
        real = gas.get_number_of_particles(real=True)
        images = gas.get("gid", only_real_particles=False)[real:]
        if len(images):
            for name, stride in [("L", 6), ("gx", 1), ("gy", 1), ("gz", 1)]:
                values = gas.get(name, only_real_particles=False).reshape(-1, stride)
                values[real:] = values[images]

    def time_step(self):
        """Eqs. 33 to 35, at the rates of the evaluation before."""
        gas = self.gas
        h = gas.h.min()
        pull = np.sqrt((gas.au**2 + gas.av**2 + gas.aw**2).max())
        force = CFL * np.sqrt(h / pull) if pull > 0.0 else np.inf
        return CFL * min(h / gas.cs.max(), force)

    def run(self, end, after=lambda dt: None):
        """Runs to time `end`; returns processor seconds."""
        begin = time.process_time()
        self.gas.cs[:] = np.sqrt(GAMMA * (GAMMA - 1.0) * self.gas.e)
        while self.time < end * (1.0 - 1e-12):
            dt = min(self.time_step(), end - self.time)
            self.nnps.update_domain()
            self.integrator.step(self.time, dt)
            self.time += dt
            self.steps += 1
            self.updates += self.gas.get_number_of_particles(real=True)
            after(dt)
        return time.process_time() - begin


def particles(name, positions, dx, dim, density, velocity, pressure):
    """A particle array of gas on a lattice of spacing `dx`; each of the state a number or an array."""
    count = len(positions)
    full = lambda value: np.broadcast_to(np.asarray(value, float), (count,)).copy()
    place = list(positions.T) + [0.0] * (3 - dim)
    props = dict(zip("xyz", map(full, place)), u=full(velocity[0]), v=full(velocity[1]), w=full(velocity[2]),
                 rho=full(density), p=full(pressure), h=full(SMOOTHING_RATIO * dx))
    array = get_particle_array(name=name, additional_props=STATE + STARTS + RATES + OTHERS, **props)
    array.e[:] = array.p / ((GAMMA - 1.0) * array.rho)
    array.m[:] = array.rho * dx**dim
    array.vol[:] = dx**dim
    array.cs[:] = np.sqrt(GAMMA * array.p / array.rho)
    array.add_property("L", stride=6)
    array.L.reshape(-1, 6)[:] = [1.0, 0.0, 1.0, 0.0, 0.0, 1.0]
    return array


class Wedge:
    """The compression corner; open sides as buffers of free stream, and of gas that has left."""

    ANGLE = np.radians(20.0)
    MACH = 2.5
    MIN, MAX = np.array([-1.0, 0.0]), np.array([3.0, 3.0])

    def __init__(self, dx):
        self.dx = dx
        stream = (1.0, (self.MACH, 0.0, 0.0), 1.0 / GAMMA)
        lattice = self.lattice()
        inside = self.is_inside(lattice)
        ahead = ~inside & (lattice[:, 0] < self.MAX[0])
        gas = particles("gas", lattice[inside], dx, 2, *stream)
        beyond = particles("open", lattice[~inside], dx, 2, *stream)
        beyond.add_property("gone")
        gas.add_property("gone")
        beyond.gone[:] = np.where(ahead[~inside], 0.0, 1.0)
        position, normal = self.ghosts()
        ghosts = particles("ghost", position, dx, 2, *stream)
        ghosts.nx[:], ghosts.ny[:] = normal.T
        self.open, self.column = beyond, 0.0
        self.simulation = Simulation(2, [gas, beyond, ghosts])

    def lattice(self):
        """Lattice points of the domain and its buffers in front, above and behind."""
        dx, margin = self.dx, BUFFER
        count = np.round((self.MAX - self.MIN) / dx).astype(int)
        x = self.MIN[0] + (np.arange(-margin, count[0] + margin) + 0.5) * dx
        y = self.MIN[1] + (np.arange(count[1] + margin) + 0.5) * dx
        points = np.array(np.meshgrid(x, y, indexing="ij")).reshape(2, -1).T
        return points[self.distance(points) >= 0.5 * dx * (1.0 - 1e-6)]

    def distance(self, points):
        """From the wall, into the gas: it is concave, so the nearer of both planes counts."""
        x, y = points.T
        return np.minimum(y, y * np.cos(self.ANGLE) - x * np.sin(self.ANGLE))

    def is_inside(self, points):
        return ((points >= self.MIN) & (points < self.MAX)).all(axis=1)

    def ghosts(self):
        """Layers at depths (k + 1/2) dx below both planes and around the corner between them."""
        dx, reach = self.dx, BUFFER * self.dx
        slope = np.array([np.cos(self.ANGLE), np.sin(self.ANGLE)])
        up = np.array([-slope[1], slope[0]])
        length = (self.MAX[0] + reach) / slope[0]
        position, normal = [], []

        def put(point, n):
            position.append(point)
            normal.append(n)

        for layer in range(LAYERS):
            depth = (layer + 0.5) * dx
            for s in np.arange(0.5 * dx, -self.MIN[0] + reach, dx):
                put(np.array([-s, -depth]), np.array([0.0, 1.0]))
            for s in np.arange(0.5 * dx, length, dx):
                put(s * slope - depth * up, up)
            fan = round(depth * self.ANGLE / dx)
            for k in range(fan):
                turn = self.ANGLE * (k + 0.5) / fan
                n = np.array([-np.sin(turn), np.cos(turn)])
                put(-depth * n, n)
        return np.array(position), np.array(normal)

    def exchange(self, dt):
        """Moves the buffers, lets gas in and out, and adds to the stream what is missing at its head."""
        gas, beyond, dx = self.simulation.gas, self.open, self.dx
        beyond.x += beyond.u * dt
        beyond.y += beyond.v * dt
        place = np.column_stack([beyond.x, beyond.y])
        enters = np.flatnonzero(self.is_inside(place) & (beyond.gone == 0.0))
        if len(enters):
            gas.append_parray(beyond.extract_particles(enters))
        beyond.gone[beyond.x >= self.MAX[0]] = 1.0
        lost = (beyond.x > self.MAX[0] + BUFFER * dx) | (beyond.y > self.MAX[1] + (BUFFER + 1) * dx)
        lost[enters] = True
        if lost.any():
            beyond.remove_particles(np.flatnonzero(lost))
        place = np.column_stack([gas.x, gas.y])
        leaves = np.flatnonzero(~self.is_inside(place) & (self.distance(place) > -2 * dx))
        if len(leaves):
            out = gas.extract_particles(leaves)
            gas.remove_particles(leaves)
            # What leaves through the top would be the undisturbed stream, were it not for the edges.
            out.gone[:] = 1.0
            beyond.append_parray(out)
        self.column += self.MACH * dt
        while self.column >= dx:
            self.column -= dx
            x = self.MIN[0] - (BUFFER + 0.5) * dx + self.column + dx
            y = np.arange(0.5 * dx, self.MAX[1] + BUFFER * dx, dx)
            points = np.column_stack([np.full_like(y, x), y])
            more = particles("more", points, dx, 2, 1.0, (self.MACH, 0.0, 0.0), 1.0 / GAMMA)
            more.add_property("gone")
            beyond.append_parray(more)

    def run(self, end):
        return self.simulation.run(end, self.exchange)

    def plateau(self):
        """Median density between shock and ramp, well off both."""
        gas = self.simulation.gas
        bearing = np.degrees(np.arctan2(gas.y, gas.x))
        chosen = (gas.x > 1.8) & (gas.x < 2.7) & (bearing > 28.0) & (bearing < 35.0)
        return np.median(gas.rho[chosen])


class Space:
    """A periodic unit cube of gas that is stirred gently, on a disordered lattice."""

    CELLS = 30

    def __init__(self):
        dx, cells = 1.0 / self.CELLS, self.CELLS
        line = (np.arange(cells) + 0.5) * dx
        points = np.array(np.meshgrid(line, line, line, indexing="ij")).reshape(3, -1).T
        points += 0.2 * dx * np.random.default_rng(1).uniform(-1.0, 1.0, points.shape)
        x, y, z = 2.0 * np.pi * points.T
        velocity = (0.3 * np.cos(z), 0.3 * np.cos(y + 1.0), 0.3 * np.cos(x + 2.0))
        gas = particles("gas", points, dx, 3, 1.4 + 0.1 * np.sin(x), velocity, 1.0 + 0.1 * np.cos(z))
        domain = DomainManager(
            xmin=0.0, xmax=1.0, ymin=0.0, ymax=1.0, zmin=0.0, zmax=1.0,
            periodic_in_x=True, periodic_in_y=True, periodic_in_z=True, props=None,
        )
        self.simulation = Simulation(3, [gas], domain)

    def run(self, end):
        return self.simulation.run(end)


SPACE = """
dimension = 3
spacing = 0.03333333333333333
end_time = {end}
[domain]
min = [0.0, 0.0, 0.0]
max = [1.0, 1.0, 1.0]
[domain.sides]
x_min = "periodic"
x_max = "periodic"
y_min = "periodic"
y_max = "periodic"
z_min = "periodic"
z_max = "periodic"
[free_stream]
density = 1.4
pressure = 1.0
velocity = [0.0, 0.0, 0.0]
[initial]
disorder = 0.2
[initial.field]
density = "1.4 + 0.1 * sin(2 * pi * x)"
pressure = "1 + 0.1 * cos(2 * pi * z)"
velocity = ["0.3 * cos(2 * pi * z)", "0.3 * cos(2 * pi * y + 1)", "0.3 * cos(2 * pi * x + 2)"]
"""


def aero(program, scene, end, settings):
    """The summary of a run."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.toml"
        path.write_text(scene)
        wishes = ["output.frames=1", f"end_time={end}", *settings]
        command = [program, "run", str(path), "--threads", "1", "--out", folder + "/out"]
        command += [word for wish in wishes for word in ("--set", wish)]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f"pysph_pace.py: {' '.join(command)}: {done.stderr}")
        return json.loads((Path(folder) / "out" / "summary.json").read_text())


def compare(name, program):
    wedge = (ROOT / "cases" / "wedge.toml").read_text()
    if name == "wedge":
        flow, end, scene, more = Wedge(1 / 16), 10.0, wedge, ["spacing=0.0625"]
    elif name == "wedge-fine":
        flow, end, scene, more = Wedge(1 / 64), 0.1, wedge, ["spacing=0.015625"]
    else:
        flow, end = Space(), 0.25
        scene, more = SPACE.format(end=end), []
    seconds = flow.run(end)
    simulation = flow.simulation
    rate = simulation.updates / seconds
    count = simulation.gas.get_number_of_particles(real=True)
    print(f"{name}: PySPH {count} fluid particles, {simulation.steps} steps, {seconds:.1f} s, "
          f"{rate:.0f} updates per CPU second ({1e6 / rate:.2f} us each)")
    if name == "wedge":
        print(f"  plateau density {flow.plateau():.4f} (theory 2.2002; aero by the same equations 2.2255)")
    if program is None:
        return
    published = ["scheme.equations=paper", "scheme.skip_undisturbed=false"]
    single = ["scheme.precision=mixed"]
    for words, settings in [("the same equations", published), ("its default", []), ("pairs in single precision", single)]:
        summary = aero(program, scene, end, more + settings)
        ours = summary["particle_updates_per_cpu_second"]
        print(f"  aero, {words}: {summary['particles']['fluid']} fluid particles, {summary['steps']} steps, "
              f"{ours:.0f} updates per CPU second ({1e6 / ours:.2f} us each), {ours / rate:.1f} times PySPH")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("flows", nargs="*", metavar="FLOW", help="wedge, wedge-fine, space; all unless given")
    parser.add_argument("--aero", metavar="PROGRAM", help="the built program to compare with")
    arguments = parser.parse_args()
    get_config().use_openmp = False
    print(f"load {os.getloadavg()[0]:.1f}")
    for name in arguments.flows or ["wedge", "wedge-fine", "space"]:
        compare(name, arguments.aero)


if __name__ == "__main__":
    main()
