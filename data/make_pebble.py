#!/usr/bin/env python3
# Copyright (c) 2026  The Gradient_domain_processing authors.
#
# This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes pebble.off: a rounded block with a wavy relief and scanner-like noise, something to smooth and to sharpen.

An icosphere is pushed out to the superquadric |x|^4 + |y|^4 + |z|^4 = 1 and stretched to a block; relief and noise
displace it along the ray from the center. Always the same mesh: the generator of the noise is seeded.

    python3 make_pebble.py > pebble.off
"""
import itertools
import math
import random

SUBDIVISIONS = 4
AXES = (1.0, 0.8, 0.6)
RELIEF = 0.025
NOISE = 0.004


def icosphere(subdivisions):
    golden = (1 + math.sqrt(5)) / 2
    points = []
    for a, b in itertools.product((-1, 1), (-golden, golden)):
        points += [(0, a, b), (a, b, 0), (b, 0, a)]
    length = math.dist(points[0], (0, 0, 0))
    points = [tuple(c / length for c in p) for p in points]
    edge = min(math.dist(points[0], p) for p in points[1:])
    faces = []
    for i, j, k in itertools.combinations(range(12), 3):
        a, b, c = points[i], points[j], points[k]
        if max(math.dist(a, b), math.dist(b, c), math.dist(c, a)) < 1.01 * edge:
            outward = (a[0] * (b[1] * c[2] - b[2] * c[1])
                       + a[1] * (b[2] * c[0] - b[0] * c[2])
                       + a[2] * (b[0] * c[1] - b[1] * c[0])) > 0
            faces.append((i, j, k) if outward else (i, k, j))

    for _ in range(subdivisions):
        middles = {}

        def middle(i, j):
            key = (min(i, j), max(i, j))
            if key not in middles:
                m = [a + b for a, b in zip(points[i], points[j])]
                length = math.hypot(*m)
                middles[key] = len(points)
                points.append(tuple(c / length for c in m))
            return middles[key]

        refined = []
        for i, j, k in faces:
            a, b, c = middle(i, j), middle(j, k), middle(k, i)
            refined += [(i, a, c), (a, j, b), (c, b, k), (a, b, c)]
        faces = refined
    return points, faces


def main():
    noise = random.Random(2016)
    points, faces = icosphere(SUBDIVISIONS)
    print("OFF")
    print(len(points), len(faces), 0)
    for x, y, z in points:
        radius = (x ** 4 + y ** 4 + z ** 4) ** -0.25
        radius *= 1 + RELIEF * math.sin(9 * x + 4 * y) * math.cos(7 * z - 3 * y) + noise.gauss(0, NOISE)
        print(" ".join("%.5f" % (radius * axis * c) for axis, c in zip(AXES, (x, y, z))))
    for face in faces:
        print(3, *face)


if __name__ == "__main__":
    main()
