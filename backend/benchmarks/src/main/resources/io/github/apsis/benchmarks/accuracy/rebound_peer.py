"""REBOUND on the same cases, with the same measures of error: one CSV line per setting on standard output.

usage: rebound_peer.py version
       rebound_peer.py nbody CASE.json END HORIZON STEP [--short]   errors until the sample at END, CPU time over HORIZON units
                                                               of time; fixed steps are STEP times a power of two
       rebound_peer.py force CASE.json [--short]
       rebound_peer.py energy CASE.json END                energy error over time: method,dt,tolerance,t,largest error so far

CPU time is that of the process, best of three for orbits, median for forces. Needs rebound 5 and numpy.
"""
import csv
import json
import math
import os
import sys
import time
import warnings
from ctypes import byref

import numpy as np
import rebound

MOMENTS, FEW_MOMENTS = 1500, 300  # at which energy is measured, each costs Python some 50 us; the latter in a short run
FIXED_STEPS = {"leapfrog": (1, 0, -1), "leapfrog4": (1, 0, -1), "leapfrog6": (3, 2, 1, 0), "leapfrog8": (4, 3, 2, 1, 0),
               "whfast": (1, 0), "whfast-c17": (4, 1, 0)}
IAS15 = (("ias15", "PRS23", 1e-9), ("ias15", "PRS23", 1e-5), ("ias15-aarseth85", "AARSETH85", 1e-9), ("ias15-global", "GLOBAL", 1e-9))
BS = (1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13)
PATIENCE = 8.0  # seconds of CPU; what takes longer is not repeated


def name_of(d, path):
    return d.get("id") or os.path.basename(path)[:-len(".json")]


def number(v):
    return float(v)


class Case:
    def __init__(self, path, end=math.inf):
        with open(path, encoding="utf-8") as f:
            d = json.load(f)
        self.id, self.g = name_of(d, path), number(d["G"])
        self.bodies = [[number(b[k]) for k in ("m", "x", "y", "vx", "vy")] for b in d["bodies"]]
        self.m = np.array([b[0] for b in self.bodies], dtype=np.longdouble)
        self.period = number(d.get("period") or 0)
        t0 = number(d.get("t0", 0))
        self.samples = [(number(s["t"]) - t0, np.array([[number(v) for v in b[:2]] for b in s["state"]])) for s in d["samples"]]
        self.samples = [s for s in self.samples if 0 < s[0] <= end]
        self.energy, self.spin = number(d["conserved"]["E"]), number(d["conserved"]["L"])
        self.length_scale, self.energy_scale, self.spin_scale = (number(d[k]) for k in ("length_scale", "energy_scale", "L_scale"))

    def simulation(self, configure):
        sim = rebound.Simulation()
        sim.G = self.g
        for m, x, y, vx, vy in self.bodies:
            sim.add(m=m, x=x, y=y, vx=vx, vy=vy)
        configure(sim)
        return sim

    def state(self, sim):
        r, v = np.zeros((sim.N, 3)), np.zeros((sim.N, 3))
        sim.serialize_particle_data(xyz=r, vxvyvz=v)
        return r[:, :2].astype(np.longdouble), v[:, :2].astype(np.longdouble)

    def conserved_errors(self, sim):
        r, v = self.state(sim)  # in extended precision, so that measuring is not the error
        i, j = np.triu_indices(len(r), 1)
        d = r[i] - r[j]
        energy = (0.5 * self.m * (v * v).sum(1)).sum() - (np.longdouble(self.g) * self.m[i] * self.m[j] / np.sqrt((d * d).sum(1))).sum()
        spin = (self.m * (r[:, 0] * v[:, 1] - r[:, 1] * v[:, 0])).sum()
        return float(abs(energy - self.energy)) / self.energy_scale, float(abs(spin - self.spin)) / self.spin_scale

    def position_error(self, sim, truth):
        r, _ = self.state(sim)
        return float(np.sqrt(((r - truth) ** 2).sum(1)).max()) / self.length_scale


def fixed(name, dt):
    def configure(sim):
        sim.dt = dt
        if name.startswith("leapfrog"):
            sim.integrator = "leapfrog"
            sim.integrator.order = int(name[8:] or 2)
        else:
            sim.integrator = "whfast"
            sim.integrator.safe_mode = 0
            sim.integrator.corrector = 17 if name.endswith("c17") else 0
    return configure


def ias15(mode, epsilon):
    def configure(sim):
        sim.integrator = "ias15"
        sim.integrator.epsilon = epsilon
        sim.integrator.adaptive_mode = mode
    return configure


def bs(epsilon):
    def configure(sim):
        sim.integrator = "bs"
        sim.integrator.eps_rel = epsilon
        sim.integrator.eps_abs = epsilon
    return configure


def settings(case, unit, short):
    """(method, dt or None, tolerance or None, configure)"""
    end = case.samples[-1][0]
    for name, ladder in FIXED_STEPS.items():
        if short:
            ladder = ladder[-2:-1]
        for k in ladder:
            dt = 2.0 ** k * unit
            if k > 2 and case.period < 16 * dt:
                continue
            dt = end / round(end / dt)  # the last sample falls on a step
            yield name, dt, None, fixed(name, dt)
    for name, mode, epsilon in IAS15[:1] if short else IAS15:
        yield name, None, epsilon, ias15(mode, epsilon)
    for epsilon in (1e-8, 1e-12) if short else BS:
        yield "bs", None, epsilon, bs(epsilon)


def advance(sim, t, dt, exact):
    if dt:
        n = round(t / dt) - round(sim.t / dt)
        if n > 0:
            sim.steps(n)
        sim.synchronize()
    else:
        sim.integrate(t, exact_finish_time=1 if exact else 0)


def errors(case, dt, configure, most):
    """Largest errors of energy and angular momentum over the run, and the position error at its end."""
    sim = case.simulation(configure)
    energy = spin = position = 0.0
    before = 0.0
    end = case.samples[-1][0]
    for t, truth in case.samples:
        # a fixed step's energy is read at whole units of time, as limits are: within one it swings and returns
        moments = max(1, round(t - before)) if dt else max(10, int(most * (t - before) / end))
        for k in range(1, moments):
            advance(sim, before + (t - before) * k / moments, dt, False)
            e, l = case.conserved_errors(sim)
            energy, spin = worse(energy, e), worse(spin, l)
        advance(sim, t, dt, True)
        before = t
        e, l = case.conserved_errors(sim)
        energy, spin = worse(energy, e), worse(spin, l)
        if t == end:
            position = case.position_error(sim, truth)
    return energy, spin, position


def cpu_us_per_unit(case, horizon, dt, configure):
    best, spent, runs = float("inf"), 0.0, 0
    while runs < 3 and (runs == 0 or spent < PATIENCE):
        sim = case.simulation(configure)
        start = time.process_time()
        advance(sim, horizon, dt, True)
        taken = time.process_time() - start
        best, spent, runs = min(best, taken), spent + taken, runs + 1
    return best * 1e6 / horizon


def cell(v):
    return "" if v is None else "%.4e" % v


def worse(a, b):
    return a if b <= a or math.isnan(a) else b  # a NaN is the worst of all, and stays


def nbody(path, end, horizon, unit, short):
    case = Case(path, end)
    out = csv.writer(sys.stdout, lineterminator="\n")
    for name, dt, tolerance, configure in settings(case, unit, short):
        try:
            energy, spin, position = errors(case, dt, configure, FEW_MOMENTS if short else MOMENTS)
            cpu = cpu_us_per_unit(case, horizon, dt, configure)
            status = "ok" if energy <= 1 and math.isfinite(position) else "cannot follow"
            row = [cell(cpu), cell(energy), cell(spin), cell(position), status]
        except Exception as e:  # a peer that fails is a row, not the end of the report
            row = ["", "", "", "", "failed: " + str(e).splitlines()[0] if str(e) else "failed"]
        out.writerow([case.id, "rebound-" + name, "" if dt is None else repr(dt), "" if tolerance is None else repr(tolerance)] + row)
        sys.stdout.flush()


def energy_over_time(path, end):
    case = Case(path)
    out = csv.writer(sys.stdout, lineterminator="\n")
    for name, dt, tolerance, configure in (("leapfrog8", 1 / 75, None, fixed("leapfrog8", 1 / 75)),
                                           ("ias15-aarseth85", None, 1e-9, ias15("AARSETH85", 1e-9))):
        sim, worst, t = case.simulation(configure), 0.0, 1.0
        while t <= end * 1.0001:
            advance(sim, t, dt, False)
            worst = worse(worst, case.conserved_errors(sim)[0])
            out.writerow(["rebound-" + name, "" if dt is None else repr(dt), cell(tolerance), "%.6g" % t, "%.4e" % worst])
            t *= 10 ** (1 / 60)


def force(path, short):
    with open(path, encoding="utf-8") as f:
        d = json.load(f)
    with open(os.path.join(os.path.dirname(path), d["csv"]), encoding="utf-8", newline="") as f:
        rows = list(csv.DictReader(f))
    m, x, y, ax, ay = (np.array([number(r[k]) for r in rows]) for k in ("m", "x", "y", "ax", "ay"))
    size = max(abs(x).max(), abs(y).max())
    out = csv.writer(sys.stdout, lineterminator="\n")
    trees = (0.5,) if short else (0.3, 0.5, 0.7, 0.9, 1.0)
    for kind, theta in [("basic", None), ("compensated", None)] + [("tree", th) for th in trees]:
        sim = rebound.Simulation()
        sim.G = number(d["G"])
        if kind == "tree":
            sim.root_size = 2.0 ** math.ceil(math.log2(2.1 * size))
            sim.boundary = "open"
            sim.opening_angle2 = theta * theta
        sim.gravity = kind
        for k in range(len(m)):
            sim.add(m=m[k], x=x[k], y=y[k])
        times = []
        stop = time.time() + 2.5
        while len(times) < 3 or (len(times) < 30 and time.time() < stop):
            start = time.process_time()
            rebound.clibrebound.reb_simulation_update_acceleration(byref(sim))
            times.append((time.process_time() - start) * 1e3)
        if sim.N != len(m):
            raise RuntimeError("REBOUND lost %d bodies" % (len(m) - sim.N))
        a = np.array([(p.ax, p.ay) for p in sim.particles])
        error, true = np.hypot(a[:, 0] - ax, a[:, 1] - ay), np.hypot(ax, ay)
        relative = np.sort(error / true)
        net = math.hypot(math.fsum(m * a[:, 0]), math.fsum(m * a[:, 1])) / (m * np.hypot(a[:, 0], a[:, 1])).sum()
        n = len(m)
        figures = (relative[n // 2], relative[math.ceil(0.99 * n) - 1], relative[-1],
                   math.sqrt((error ** 2).sum() / (true ** 2).sum()), net, sorted(times)[len(times) // 2])
        out.writerow([name_of(d, path), "rebound-" + kind, "" if theta is None else theta] + ["%.4e" % v for v in figures])
        sys.stdout.flush()


def main(arguments):
    short = "--short" in arguments
    warnings.simplefilter("ignore")  # WHFast says at every step that it was not made for such a case
    if arguments[0] == "version":
        print(rebound.__version__)
    elif arguments[0] == "nbody":
        nbody(arguments[1], *map(float, arguments[2:5]), short)
    elif arguments[0] == "energy":
        energy_over_time(arguments[1], float(arguments[2]))
    elif arguments[0] == "force":
        force(arguments[1], short)
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1:])
