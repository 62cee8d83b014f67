#!/usr/bin/env python3
# Copyright (c) 2026  The Gradient_domain_processing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares gradient_domain_filter_mpi with gradient_domain_filter, and tries what goes wrong.

Usage: test_filter_mpi.py FILTER FILTER_MPI MPIRUN [RANKS...]; the ranks are 1 2 3 4 7 if none are given.
"""

import glob
import math
import os
import random
import signal
import struct
import subprocess
import sys
import tempfile
import time

FILTER, FILTER_MPI, MPIRUN = sys.argv[1:4]
RANKS = [int(n) for n in sys.argv[4:]] or [1, 2, 3, 4, 7]
os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                  OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_btl_vader_single_copy_mechanism="none",
                  OPENBLAS_NUM_THREADS="1")
failures = []


def check(condition, what):
    if not condition:
        failures.append(what)
        print("FAILED: " + what, flush=True)


# ---- meshes: points and triangles; further properties by name

def grid(m, n, height, closed_u=False, closed_v=False):
    points = [height(i / m, j / n) for i in range(m + (not closed_u)) for j in range(n + (not closed_v))]
    columns = n + (not closed_v)
    at = lambda i, j: (i % m if closed_u else i) * columns + (j % n if closed_v else j)
    triangles = []
    for i in range(m):
        for j in range(n):
            a, b, c, d = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
            triangles += [(a, b, c), (a, c, d)]
    return points, triangles


def noisy(mesh, amount, seed=1):
    numbers = random.Random(seed)
    return [tuple(x + numbers.gauss(0, amount) for x in p) for p in mesh[0]], mesh[1]


def torus(m, n):
    def point(u, v):
        r = 1 + 0.4 * math.cos(2 * math.pi * v)
        return r * math.cos(2 * math.pi * u), r * math.sin(2 * math.pi * u), 0.4 * math.sin(2 * math.pi * v)
    return grid(m, n, point, True, True)


def joined(*meshes):
    points, triangles = [], []
    for p, t in meshes:
        triangles += [tuple(v + len(points) for v in f) for f in t]
        points += p
    return points, triangles


def moved(mesh, x):
    return [(p[0] + x, p[1], p[2]) for p in mesh[0]], mesh[1]


def with_seam(mesh, m):
    """Cut along a row of the grid: copies of the vertices in the same place."""
    points, triangles = list(mesh[0]), []
    copies = {}
    for k, f in enumerate(mesh[1]):
        if k >= len(mesh[1]) // 2:
            for v in f:
                if any(v in g for g in mesh[1][:len(mesh[1]) // 2]) and v not in copies:
                    copies[v] = len(points)
                    points.append(points[v])
            f = tuple(copies.get(v, v) for v in f)
        triangles.append(f)
    return points, triangles


def shuffled(mesh):
    order = list(range(len(mesh[0])))
    random.Random(3).shuffle(order)
    place = {v: i for i, v in enumerate(order)}
    triangles = [tuple(place[v] for v in f) for f in mesh[1]]
    random.Random(4).shuffle(triangles)
    return [mesh[0][v] for v in order], triangles


def degenerate(mesh):
    return mesh[0], mesh[1] + [(0, 1, 1), (2, 2, 2), (5, 6, 7)]


def meshes():
    patch = noisy(grid(14, 11, lambda u, v: (u, 0.8 * v, 0.1 * math.sin(5 * u) * math.cos(4 * v))), 0.004)
    ring = noisy(torus(30, 14), 0.01)
    yield "torus", ring
    yield "open", patch
    yield "shuffled", shuffled(ring)
    yield "components", joined(ring, moved(patch, 3), moved(noisy(torus(9, 6), 0.02), -4))
    yield "isolated vertices", joined(([(7., 7, 7)] * 3, []), patch, ([(0.3, 0.2, 9)], []))
    yield "NaN in an unused vertex", joined(patch, ([(math.nan, 0, 0)], []))
    yield "degenerate faces", degenerate(patch)
    yield "seam", with_seam(patch, 14)
    yield "triangle", ([(0., 0, 0), (1, 0, 0), (0, 1, 0.5)], [(0, 1, 2)])
    yield "far away", ([(1e4 + 1e-2 * p[0], p[1] * 1e-2 - 2e4, 1e-2 * p[2]) for p in ring[0]], ring[1])


# ---- files

def properties(points):
    """One of every kind: a constraint, weights, colors, a normal."""
    numbers = random.Random(2)
    for v, _ in enumerate(points):
        n = [numbers.gauss(0, 1) for _ in range(3)]
        length = math.sqrt(sum(x * x for x in n))
        yield (v % 11 == 3, 1 + numbers.random(), 1e-4 * numbers.random(), numbers.randrange(256),
               numbers.randrange(256), numbers.randrange(256), *(x / length for x in n))


def write(path, mesh, with_normals=False):
    points, triangles = mesh
    normals = "".join("property double n%s\n" % x for x in "xyz") if with_normals else ""
    header = ("ply\nformat binary_little_endian 1.0\ncomment of a test\nelement vertex %d\n" % len(points)
              + "".join("property double %s\n" % x for x in "xyz")
              + "property uchar held\nproperty double alpha_weight\nproperty double beta_weight\n"
              + "".join("property uchar %s\n" % c for c in ("red", "green", "blue")) + normals
              + "element face %d\nproperty list uchar int vertex_indices\nproperty int id\n" % len(triangles)
              + "element rest 2\nproperty list uchar short numbers\nend_header\n")
    with open(path, "wb") as file:
        file.write(header.encode())
        for p, (held, a, b, red, green, blue, *n) in zip(points, properties(points)):
            file.write(struct.pack("<3dB2d3B", *p, held, a, b, red, green, blue))
            if with_normals:
                file.write(struct.pack("<3d", *n))
        for k, f in enumerate(triangles):
            file.write(struct.pack("<B3ii", 3, *f, k))
        file.write(struct.pack("<BhhBh", 2, 5, 6, 1, 7))


def read(path, with_normals):
    with open(path, "rb") as file:
        data = file.read()
    head = data.index(b"end_header\n") + len(b"end_header\n")
    count = int(data[:head].split(b"element vertex ")[1].split()[0])
    form = struct.Struct("<3dB2d3B" + ("3d" if with_normals else ""))
    rows = [form.unpack_from(data, head + v * form.size) for v in range(count)]
    return data[:head], rows, data[head + count * form.size:]


def compare(a, b, with_normals):
    """The largest difference of a number, in extents of the surface; colors may be rounded the other way."""
    head_a, rows_a, rest_a = read(a, with_normals)
    head_b, rows_b, rest_b = read(b, with_normals)
    if head_a != head_b or rest_a != rest_b or len(rows_a) != len(rows_b):
        return math.inf
    finite = [r[:3] for r in rows_a if all(map(math.isfinite, r[:3]))]
    extent = max(max(c) - min(c) for c in zip(*finite))
    largest = 0
    for x, y in zip(rows_a, rows_b):
        for i, (p, q) in enumerate(zip(x, y)):
            if struct.pack("<d", p) == struct.pack("<d", q):
                continue
            if math.isnan(p) or math.isnan(q):
                return math.inf
            difference = abs(p - q)
            if i < 3:
                difference /= extent
            elif 6 <= i < 9:
                difference = 0 if difference <= 1 else math.inf
            largest = max(largest, difference)
    return largest


# ---- runs

def run(command, **other):
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=300, **other)


def mpi(ranks, *arguments, **other):
    return run([MPIRUN, "-n", str(ranks), FILTER_MPI, *arguments], **other)


CASES = [
    ("isotropic", [], 1e-9),
    ("sharpen", ["--gradient-scale", "2", "--gradient-weight", "1e-3"], 1e-9),
    ("multigrid", ["--gradient-weight", "30"], 1e-9),
    ("edge-aware by normals", ["--metric", "edge-aware", "--curvature", "normals"], 1e-9),
    ("anisotropic by jets", ["--metric", "anisotropic", "--iterations", "2"], 1e-7),
    ("non-shrinking", ["--non-shrinking"], 1e-9),
    ("enhance-details", ["--operation", "enhance-details", "--metric", "edge-aware", "--curvature", "normals"], 1e-9),
    ("held and weighed", ["--constrain", "held", "--value-weight-property", "alpha_weight",
                          "--gradient-weight-property", "beta_weight"], 1e-9),
    ("colors", ["--signal", "color", "--iterations", "2"], 1e-9),
    ("property", ["--signal", "alpha_weight", "--no-weld"], 1e-9),
]
THOROUGH = {"torus", "seam", "components"}  # all cases on these, a part of them on the others


def compare_all(folder):
    worst = {}
    for k, (name, mesh) in enumerate(meshes()):
        for j, (case, options, tolerance) in enumerate(CASES):
            if name not in THOROUGH and j % 3 != k % 3:
                continue
            with_normals = case in ("isotropic", "non-shrinking")
            source, expected, result = (os.path.join(folder, x) for x in ("in.ply", "expected.ply", "result.ply"))
            write(source, mesh, with_normals)
            one = run([FILTER, source, expected, "--quiet", *options])
            check(one.returncode == 0, "%s, %s: %s" % (name, case, one.stderr))
            for ranks in RANKS if (j + k) % 2 == 0 else RANKS[1::2]:
                many = mpi(ranks, source, result, "--quiet", *options)
                what = "%s, %s, %d ranks" % (name, case, ranks)
                check(many.returncode == 0, what + ": " + many.stderr)
                if many.returncode == 0:
                    difference = compare(expected, result, with_normals)
                    worst[case] = max(worst.get(case, 0), difference)
                    check(difference <= tolerance, "%s: differs by %g" % (what, difference))
    for case, difference in worst.items():
        print("%-24s %g" % (case, difference))


def no_room(folder):
    """The limit is that of the filter, not of mpirun."""
    source, result = os.path.join(folder, "large.ply"), os.path.join(folder, "kept.ply")
    with open(result, "wb") as file:
        file.write(b"as it was")
    limited = 'ulimit -f %d; exec "$0" "$@"' % (os.path.getsize(source) // 2 // 1024)
    failed = run([MPIRUN, "-n", "2", "bash", "-c", limited, FILTER_MPI, source, result])
    check(failed.returncode == 1 and is_one_line(failed.stderr), "no room: %d, %s" % (failed.returncode, failed.stderr))
    with open(result, "rb") as file:
        check(file.read() == b"as it was", "no room: the output has changed")
    check(not glob.glob(os.path.join(folder, ".gradient*")), "no room: a temporary stays")


def is_one_line(text):
    """mpirun adds its own words about exit codes."""
    return sum(line.startswith("gradient_domain_filter_mpi:") for line in text.split("\n")) == 1


def refuse(folder):
    source, result = os.path.join(folder, "in.ply"), os.path.join(folder, "kept.ply")
    mesh = noisy(torus(30, 14), 0.01)
    write(source, mesh)
    with open(source, "rb") as file:
        whole = file.read()

    def fails(what, code, *arguments, **other):
        with open(result, "wb") as file:
            file.write(b"as it was")
        failed = mpi(3, *arguments, **other)
        check(failed.returncode == code, "%s: exit code %d" % (what, failed.returncode))
        check(is_one_line(failed.stderr), "%s: not one line but %s" % (what, failed.stderr))
        with open(result, "rb") as file:
            check(file.read() == b"as it was", what + ": the output has changed")
        check(not glob.glob(os.path.join(folder, ".gradient*")), what + ": a temporary stays")

    def broken(name, data):
        path = os.path.join(folder, name)
        with open(path, "wb") as file:
            file.write(data)
        return path

    head = whole.index(b"end_header\n") + 11
    first_face = head + len(mesh[0]) * (3 * 8 + 1 + 2 * 8 + 3)
    fails("no such file", 1, os.path.join(folder, "none.ply"), result)
    fails("truncated faces", 1, broken("short.ply", whole[:-500]), result)
    fails("truncated vertices", 1, broken("short.ply", whole[:head + 1000]), result)
    fails("truncated header", 1, broken("short.ply", whole[:60]), result)
    fails("text", 1, broken("text.ply", whole.replace(b"binary_little_endian", b"ascii")), result)
    fails("a quadrangle", 1, broken("quad.ply", whole[:first_face + 17 * 700] + b"\4"
                                    + whole[first_face + 17 * 700 + 1:]), result)
    fails("a corner that is no vertex", 1,
          broken("corner.ply", whole[:first_face + 1] + struct.pack("<i", 420) + whole[first_face + 5:]), result)
    fails("NaN", 1, broken("nan.ply", whole[:head] + struct.pack("<d", math.nan) + whole[head + 8:]), result)
    fails("no such property", 1, source, result, "--constrain", "nothing")
    fails("an option of the other program", 2, source, result, "--restore-volume")
    fails("denoise", 2, source, result, "--operation", "denoise")
    fails("no convergence", 1, source, result, env=dict(os.environ, PETSC_OPTIONS="-ksp_max_it 2"))
    check(mpi(2, source, os.path.join(folder, "no", "folder.ply")).returncode == 1, "no folder")


def interrupt(folder):
    """A process that is killed takes the others with it, and nothing is left behind."""
    source, result = os.path.join(folder, "large.ply"), os.path.join(folder, "kept.ply")
    write(source, noisy(torus(700, 300), 0.001))
    with open(result, "wb") as file:
        file.write(b"as it was")
    for wait, number in ((0.4, signal.SIGTERM), (0.8, signal.SIGKILL), (1.2, signal.SIGKILL)):
        job = subprocess.Popen([MPIRUN, "-n", "3", FILTER_MPI, source, result, "--metric", "anisotropic"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        children = []
        while len(children) < 3 and job.poll() is None:
            time.sleep(0.02)
            found = subprocess.run(["ps", "-o", "pid=,comm=", "--ppid", str(job.pid)], stdout=subprocess.PIPE, text=True)
            children = [line.split()[0] for line in found.stdout.split("\n") if "gradient_domain" in line]
        time.sleep(wait)
        for child in children[1:2]:
            try:
                os.kill(int(child), number)
            except ProcessLookupError:
                check(False, "the run to be interrupted was over too early")
        check(job.wait(timeout=60) != 0, "interrupted, and success")
        with open(result, "rb") as file:
            check(file.read() == b"as it was", "interrupted, and the output has changed")
        time.sleep(0.2)
        check(not glob.glob(os.path.join(folder, ".gradient*")), "interrupted, and a temporary stays")


with tempfile.TemporaryDirectory() as temporary:
    compare_all(temporary)
    refuse(temporary)
    interrupt(temporary)
    no_room(temporary)
print("%d failures" % len(failures))
sys.exit(1 if failures else 0)
