#!/usr/bin/env python3
# Copyright (c) 2026  The Gradient_domain_processing authors.
#
# This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the meshes, inputs and reference outputs of the tests.

Nothing here is shared with the package. Operators are integrals of hat functions whose gradients are vectors in space;
a metric is a linear operator T on the tangent plane, T = s1 d1 d1^T + s2 d2 d2^T, which stretches areas by
sqrt(s1 s2) and gives gradients the energy <grad u, T^-1 grad w>. Systems are dense and solved by Cholesky with 40 digits.

  make_references.py               writes everything next to this script
  make_references.py --double      recomputes all cases in double precision and compares them with the files
  make_references.py --check DIR   compares with outputs of the original authors' program kept in DIR
"""

import argparse
import gzip
import math
import os
import sys

import numpy as np
from mpmath import mp, mpf

mp.dps = 40
HERE = os.path.dirname(os.path.abspath(__file__))


# ---------------------------------------------------------------- arithmetic

class Exact:
  """40 digits, dense matrices."""

  @staticmethod
  def array(values):
    values = np.asarray(values)
    out = np.empty(values.shape, dtype=object)
    out.ravel()[:] = [mpf(v) for v in values.ravel().tolist()]
    return out

  sqrt = staticmethod(lambda a: np.frompyfunc(mp.sqrt, 1, 1)(a))

  @staticmethod
  def matrix(rows, columns, i, j, values):
    out = Exact.array(np.zeros((rows, columns)))
    for r, c, v in zip(i, j, values):
      out[r, c] += v
    return out

  @staticmethod
  def solve(matrix, right):
    n = matrix.shape[0]
    factor = []
    for i in range(n):
      row = []
      for j in range(i):
        row.append((matrix[i, j] - mp.fdot(zip(row, factor[j][:j]))) / factor[j][j])
      pivot = matrix[i, i] - mp.fdot(zip(row, row))
      if pivot <= 0:
        raise ArithmeticError("the matrix is not positive definite")
      row.append(mp.sqrt(pivot))
      factor.append(row)
    x = right.copy()
    for k in range(x.shape[1]):
      for i in range(n):
        x[i, k] = (x[i, k] - mp.fdot(zip(factor[i][:i], x[:i, k]))) / factor[i][i]
      for i in reversed(range(n)):
        x[i, k] /= factor[i][i]
        for j in range(i):
          x[j, k] -= factor[i][j] * x[i, k]
    residual = abs(matrix @ x - right).max()
    if residual > mpf("1e-30") * max(abs(right).max(), mpf(1e-3)):
      raise ArithmeticError("residual %s" % residual)
    return x


class Double:
  """Double precision, sparse matrices."""

  array = staticmethod(lambda values: np.array(values, dtype=float))
  sqrt = staticmethod(np.sqrt)

  @staticmethod
  def matrix(rows, columns, i, j, values):
    from scipy.sparse import csc_matrix
    return csc_matrix((values, (i, j)), shape=(rows, columns))

  @staticmethod
  def solve(matrix, right):
    from scipy.sparse.linalg import splu
    return splu(matrix.tocsc()).solve(right)


# ---------------------------------------------------------------- geometry and operators

def dot(a, b):
  return (a * b).sum(-1)


def apply(operator, vector):
  return (operator * vector[..., None, :]).sum(-1)


def outer(a, b):
  return a[..., :, None] * b[..., None, :]


class Metric:
  """The inverse of T, one 3x3 matrix a face, and the factor of areas sqrt(s1 s2)."""

  def __init__(self, inverse, area_factor):
    self.inverse = inverse
    self.area_factor = area_factor


class Surface:
  def __init__(self, points, faces, arithmetic):
    self.ar = arithmetic
    self.points = arithmetic.array(points)
    self.faces = np.asarray(faces, dtype=int)
    self.n = len(points)
    corners = self.points[self.faces]
    self.edges = [corners[:, (i + 1) % 3] - corners[:, i] for i in range(3)]
    self.cross = np.cross(self.edges[0], -self.edges[2])
    length = arithmetic.sqrt(dot(self.cross, self.cross))
    self.face_normal = self.cross / length[:, None]
    self.face_area = length / 2
    self.area = self.face_area.sum()
    # The gradient of a hat function is the opposite edge turned by 90 degrees and divided by twice the area.
    self.hat_gradient = np.stack([np.cross(self.face_normal, self.edges[(i + 1) % 3]) / length[:, None]
                                  for i in range(3)], axis=1)
    identity = arithmetic.array(np.eye(3))
    self.projector = identity - outer(self.face_normal, self.face_normal)
    self.embedding = Metric(self.projector, arithmetic.array(np.ones(len(self.faces))))

  def constant(self, count, value):
    return self.ar.array(np.full(count, value, dtype=float))

  def scatter(self, element):
    """Sums one 3x3 matrix a face into the matrix of the vertices."""
    i = np.repeat(self.faces, 3, axis=1).ravel()
    j = np.tile(self.faces, (1, 3)).ravel()
    return self.ar.matrix(self.n, self.n, i, j, element.reshape(-1))

  def mass(self, metric, alpha):
    """Integrals of alpha phi_i phi_j, alpha linear in each face with the given values at the vertices."""
    a = alpha[self.faces]
    area = self.face_area * metric.area_factor
    element = np.empty((len(self.faces), 3, 3), dtype=self.points.dtype)
    for i in range(3):
      for j in range(3):
        if i == j:
          element[:, i, i] = area * (a[:, i] / 10 + (a[:, (i + 1) % 3] + a[:, (i + 2) % 3]) / 30)
        else:
          element[:, i, j] = area * ((a[:, i] + a[:, j]) / 30 + a[:, 3 - i - j] / 60)
    return self.scatter(element)

  def weighted_gradients(self, metric):
    """area T^-1 grad phi_i: its product with a vector field integrates <grad phi_i, v> over the face."""
    return (self.face_area * metric.area_factor)[:, None, None] * apply(metric.inverse[:, None], self.hat_gradient)

  def element_stiffness(self, metric):
    return (self.weighted_gradients(metric)[:, :, None, :] * self.hat_gradient[:, None, :, :]).sum(-1)

  def stiffness(self, metric, beta):
    return self.scatter(beta[:, None, None] * self.element_stiffness(metric))

  def gradient(self, signal):
    """One vector a face and channel: faces x 3 x channels."""
    return (self.hat_gradient[:, :, :, None] * signal[self.faces][:, :, None, :]).sum(1)

  def divergence(self, metric, field):
    """Integrals of <grad phi_i, field>: vertices x channels."""
    load = (self.weighted_gradients(metric)[:, :, :, None] * field[:, None, :, :]).sum(2)
    return self.gather(load)

  def gather(self, corner_values):
    out = self.ar.array(np.zeros((self.n, corner_values.shape[2])))
    np.add.at(out, self.faces, corner_values)
    return out

  def vertex_normals(self):
    return self.normalized(self.gather(np.repeat(self.cross[:, None, :], 3, axis=1)))

  def normalized(self, vectors):
    return vectors / self.ar.sqrt(dot(vectors, vectors))[:, None]

  def curvature_operator(self, normals):
    """The symmetric tangential part of the derivative of a normal field; its eigenvalues are the principal curvatures."""
    derivative = outer(normals[self.faces], self.hat_gradient).sum(1)
    symmetric = (derivative + np.swapaxes(derivative, 1, 2)) / 2
    p = self.projector
    return self.product(p, self.product(symmetric, p))

  @staticmethod
  def product(a, b):
    return (a[..., :, :, None] * b[..., None, :, :]).sum(-2)

  def principal_curvatures(self, operator):
    """k1 >= k2 and the traceless part of the operator."""
    mean = (operator[:, 0, 0] + operator[:, 1, 1] + operator[:, 2, 2]) / 2
    traceless = operator - mean[:, None, None] * self.projector
    radius = self.ar.sqrt((traceless * traceless).sum((1, 2)) / 2)
    return mean + radius, mean - radius, traceless

  def curvature_metric(self, kind, eps, operator):
    k1, k2, traceless = self.principal_curvatures(operator)
    if kind == "edge_aware":
      s1 = s2 = 1 + eps * (k1 * k1 + k2 * k2)
    else:
      clip = {"anisotropic": lambda k: k,
              "preserve_convex": lambda k: np.maximum(k, 0),
              "preserve_concave": lambda k: np.minimum(k, 0)}[kind]
      s1, s2 = (1 + eps * clip(k) * clip(k) for k in (k1, k2))
    # 1/s1 d1 d1^T + 1/s2 d2 d2^T; where both curvatures are equal, so are s1 and s2.
    difference = k1 - k2
    slope = (1 / s1 - 1 / s2) / np.where(difference == 0, 1, difference)
    mean = (1 / s1 + 1 / s2) / 2
    inverse = mean[:, None, None] * self.projector + slope[:, None, None] * traceless
    return Metric(inverse, self.ar.sqrt(s1 * s2))


# ---------------------------------------------------------------- the methods

def process(surface, metric, signal, alpha, beta, field, fixed=None):
  """Solves (M[alpha] + S[beta]) g = M[alpha] f + D[beta] field; fixed vertices keep their values."""
  mass = surface.mass(metric, alpha)
  matrix = mass + surface.stiffness(metric, beta)
  right = mass @ signal + surface.divergence(metric, beta[:, None, None] * field)
  if fixed is None or not fixed.any():
    return surface.ar.solve(matrix, right)
  free = np.flatnonzero(~fixed)
  held = np.flatnonzero(fixed)
  out = signal.copy()
  out[free] = surface.ar.solve(matrix[free][:, free], right[free] - matrix[free][:, held] @ signal[held])
  return out


def filter_signal(surface, metric, signal, alpha, beta, scale):
  """The plain case: the same weights everywhere, target scale * gradient of the signal."""
  faces = len(surface.faces)
  return process(surface, metric, signal, surface.constant(surface.n, alpha), surface.constant(faces, 1) * beta,
                 scale * surface.gradient(signal))


def smoothed_normals(surface, normals, gamma):
  return surface.normalized(filter_signal(surface, surface.embedding, normals, 1, gamma, 0))


def estimated_metric(surface, kind, eps, gamma):
  operator = surface.curvature_operator(smoothed_normals(surface, surface.vertex_normals(), gamma))
  return surface.curvature_metric(kind, eps, operator)


def fit_to_normals(surface, metric, normals, weight):
  """Positions whose edges are orthogonal to the sum of the normals at their ends."""
  stiffness = surface.element_stiffness(metric)
  load = surface.ar.array(np.zeros((len(surface.faces), 3, 3)))
  for i in range(3):
    for j in range(3):
      if i != j:
        a, b = surface.faces[:, i], surface.faces[:, j]
        d, n = surface.points[b] - surface.points[a], normals[a] + normals[b]
        load[:, i] += stiffness[:, i, j][:, None] * (d - (dot(d, n) / dot(n, n))[:, None] * n)
  mass = surface.mass(metric, surface.constant(surface.n, 1))
  matrix = mass + surface.stiffness(metric, surface.constant(len(surface.faces), 1) * weight)
  return surface.ar.solve(matrix, mass @ surface.points + weight * surface.gather(load))


# ---------------------------------------------------------------- meshes

class Random:
  """A linear congruential generator, so that the meshes are the same everywhere."""

  def __init__(self, seed):
    self.state = seed

  def __call__(self, low, high):
    self.state = (1664525 * self.state + 1013904223) % 2**32
    return low + (high - low) * (self.state / 2**32)


def subdivided_sphere(points, faces, times):
  unit = lambda p: [c / math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) for c in p]
  points = [unit(p) for p in points]
  for _ in range(times):
    middle, finer = {}, []

    def between(a, b):
      key = (min(a, b), max(a, b))
      if key not in middle:
        middle[key] = len(points)
        points.append(unit([points[a][k] + points[b][k] for k in range(3)]))
      return middle[key]

    for a, b, c in faces:
      ab, bc, ca = between(a, b), between(b, c), between(c, a)
      finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
    faces = finer
  return points, faces


def noisy_ellipsoid():
  t = (1 + math.sqrt(5)) / 2
  points = [(-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t),
            (0, -1, -t), (0, 1, -t), (t, 0, -1), (t, 0, 1), (-t, 0, -1), (-t, 0, 1)]
  faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
           (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
           (8, 6, 7), (9, 8, 1)]
  points, faces = subdivided_sphere(points, faces, 2)
  random = Random(1)
  out = []
  for x, y, z in points:
    r = random(0.93, 1.07)
    out.append((0.3 + 1.7 * r * x, -0.2 + 1.3 * r * y, 0.5 + 1.1 * r * z))
  return out, faces


def grid(nx, ny, random, height, skipped):
  """A jittered grid over the unit square with diagonals chosen at random; skipped cells are left open."""
  points = []
  for j in range(ny):
    for i in range(nx):
      x = (i + random(-0.25, 0.25)) / (nx - 1)
      y = (j + random(-0.25, 0.25)) / (ny - 1)
      points.append((x, y, height(x, y) + random(-0.02, 0.02)))
  faces = []
  for j in range(ny - 1):
    for i in range(nx - 1):
      a, b, c, d = j * nx + i, j * nx + i + 1, (j + 1) * nx + i + 1, (j + 1) * nx + i
      first = random(0, 1) < 0.5
      if (i, j) not in skipped:
        faces += [(a, b, c), (a, c, d)] if first else [(b, c, d), (b, d, a)]
  return points, faces


def bumpy_patch():
  height = lambda x, y: (0.3 / (1 + 8 * ((x - 0.3) * (x - 0.3) + (y - 0.6) * (y - 0.6)))
                         - 0.25 / (1 + 10 * ((x - 0.8) * (x - 0.8) + (y - 0.3) * (y - 0.3))))
  points, faces = grid(9, 7, Random(2), height, {(5, 3), (3, 0)})
  return [(2.5 * x, 1.5 * y, 1.5 * z) for x, y, z in points], faces


def creased_box():
  """An L of three blocks; vertices move inside their plane or along their crease, corners stay."""
  random = Random(3)
  blocks = {(0, 0, 0), (1, 0, 0), (0, 0, 1)}
  size = [[0, 0.45, 1.0, 1.3, 1.75], [0, 0.35, 0.8], [0, 0.4, 0.7, 1.1, 1.6]]
  index, planes, faces = {}, [], []
  for block in sorted(blocks):
    for axis in range(3):
      for side in (0, 1):
        neighbor = list(block)
        neighbor[axis] += 2 * side - 1
        if tuple(neighbor) in blocks:
          continue
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for s in range(2):
          for t in range(2):
            quad = []
            for ds, dt in ((0, 0), (1, 0), (1, 1), (0, 1)):
              key = [0, 0, 0]
              key[axis] = 2 * (block[axis] + side)
              key[u], key[v] = 2 * block[u] + s + ds, 2 * block[v] + t + dt
              key = tuple(key)
              if key not in index:
                index[key] = len(planes)
                planes.append(set())
              planes[index[key]].add(axis)
              quad.append(index[key])
            if side == 0:
              quad.reverse()
            a, b, c, d = quad
            faces += [(a, b, c), (a, c, d)] if random(0, 1) < 0.5 else [(b, c, d), (b, d, a)]
  points = []
  for key, vertex in index.items():
    points.append([size[axis][key[axis]] + (0 if axis in planes[vertex] else random(-0.1, 0.1)) for axis in range(3)])
  return points, faces


def three_components():
  """A closed octahedral sphere, an open patch and a tube with two borders."""
  random = Random(4)
  octahedron = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
  sides = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
  points, faces = subdivided_sphere(octahedron, sides, 1)
  points = [[c * r for c in p] for p, r in ((p, random(0.85, 1.15)) for p in points)]
  more, open_faces = grid(6, 5, random, lambda x, y: 0.5 * x * x - 0.6 * x * y + 0.3 * y, set())
  base = len(points)
  points += [(1.6 + 2 * x, -0.7 + 1.6 * y, z) for x, y, z in more]
  faces += [tuple(base + v for v in f) for f in open_faces]
  base = len(points)
  turns = [-3.0, -1.2, -0.5, 0.0, 0.4, 1.0, 2.5]
  for ring in range(3):
    for t in turns:
      r = random(0.65, 0.8)
      points.append((-2.2 + r * (1 - t * t) / (1 + t * t), r * 2 * t / (1 + t * t), 0.55 * ring + random(-0.1, 0.1)))
  m = len(turns)
  for ring in range(2):
    for k in range(m):
      a, b = base + ring * m + k, base + ring * m + (k + 1) % m
      c, d = b + m, a + m
      faces += [(a, b, c), (a, c, d)] if random(0, 1) < 0.5 else [(b, c, d), (b, d, a)]
  return points, faces


MESHES = {"ellipsoid": noisy_ellipsoid, "patch": bumpy_patch, "box": creased_box, "components": three_components}


def check_mesh(name, points, faces, closed):
  """Manifold, consistently oriented, no isolated vertex, no sliver; closed meshes face outwards."""
  def require(condition, what):
    if not condition:
      raise ValueError("%s: %s" % (name, what))
  halfedges = {}
  for f, face in enumerate(faces):
    for i in range(3):
      key = (face[i], face[(i + 1) % 3])
      require(key not in halfedges, "edge used twice in one direction")
      halfedges[key] = f
  require(not closed or all((b, a) in halfedges for a, b in halfedges), "not closed")
  for v in range(len(points)):
    star = [f for f in faces if v in f]
    require(star, "isolated vertex")
    following = {f[(f.index(v) + 1) % 3]: f[(f.index(v) + 2) % 3] for f in star}
    starts = [a for a in following if a not in following.values()] or [next(iter(following))]
    require(len(starts) == 1, "vertex of two fans")
    a, steps = starts[0], 0
    while a in following and steps < len(following):
      a, steps = following[a], steps + 1
    require(steps == len(following), "vertex of two fans")
  p = np.array(points)[np.array(faces)]
  cross = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
  longest = max(np.linalg.norm(p[:, i] - p[:, i - 1], axis=1).max() for i in range(3))
  require(np.linalg.norm(cross, axis=1).min() > 0.01 * longest**2, "sliver")
  require(not closed or (p[:, 0] * np.cross(p[:, 1], p[:, 2])).sum() > 0, "faces inwards")


# ---------------------------------------------------------------- files

def text(value):
  return mp.nstr(value, 17, strip_zeros=False) if isinstance(value, mpf) else "%.17g" % value


def write_table(name, comment, rows):
  with open(os.path.join(HERE, name), "w") as out:
    out.write("# %s\n" % comment)
    for row in rows:
      out.write(" ".join(text(v) for v in row) + "\n")


def read_table(name):
  table = np.loadtxt(os.path.join(HERE, name), comments="#")
  return table[:, None] if table.ndim == 1 else table


def write_off(name, points, faces):
  with open(os.path.join(HERE, name), "w") as out:
    out.write("OFF\n%d %d 0\n" % (len(points), len(faces)))
    for p in points:
      out.write("%.17g %.17g %.17g\n" % tuple(p))
    for f in faces:
      out.write("3 %d %d %d\n" % tuple(f))


def read_off(path):
  with open(path) as stream:
    lines = [line for line in (l.split("#")[0].split() for l in stream) if line]
  counts = [int(c) for c in lines[1][:2]]
  points = [[float(c) for c in line[:3]] for line in lines[2:2 + counts[0]]]
  faces = [[int(c) for c in line[1:4]] for line in lines[2 + counts[0]:2 + sum(counts)]]
  return points, faces


# ---------------------------------------------------------------- inputs of the cases

def user_tensors(surface):
  """T = s1 d1 d1^T + s2 d2 d2^T with d1 along a direction that changes with the face index."""
  index = np.arange(len(surface.faces))
  d1 = surface.normalized(surface.edges[0] - surface.ar.array((index % 5 - 2) / 2)[:, None] * surface.edges[2])
  d2 = np.cross(surface.face_normal, d1)
  s1 = surface.ar.array(1 + index % 4)
  s2 = surface.ar.array(0.5 + (index % 3) / 4)
  combine = lambda a, b: a[:, None, None] * outer(d1, d1) + b[:, None, None] * outer(d2, d2)
  return combine(s1, s2), Metric(combine(1 / s1, 1 / s2), surface.ar.sqrt(s1 * s2))


def target_field(surface):
  """Not a gradient: coordinate gradients stretched and turned by the face index, tangent to the face."""
  turn = surface.ar.array((np.arange(len(surface.faces)) % 3 - 1) / 8)
  p = surface.projector
  return 1.25 * p + turn[:, None, None] * np.roll(p, -1, axis=2)


def write_inputs(name):
  points, faces = MESHES[name]()
  check_mesh(name, points, faces, name in ("ellipsoid", "box"))
  write_off("%s.off" % name, points, faces)
  surface = Surface(points, faces, Exact)
  t1, t2 = surface.edges[0], -surface.edges[2]
  tensor, _ = user_tensors(surface)
  form = lambda a, b: dot(a, apply(tensor, b))
  write_table("%s_input_tensors.txt" % name, "user metric, a row a face: g11 g12 g22, then Txx Txy Txz Tyy Tyz Tzz",
              zip(form(t1, t1), form(t1, t2), form(t2, t2), tensor[:, 0, 0], tensor[:, 0, 1], tensor[:, 0, 2],
                  tensor[:, 1, 1], tensor[:, 1, 2], tensor[:, 2, 2]))
  write_table("%s_input_target.txt" % name, "target gradients, a row a face: the vectors of x, y and z",
              np.swapaxes(target_field(surface), 1, 2).reshape(-1, 9))
  scalar = [x * x - y * z + (i % 3) / 4 for i, (x, y, z) in enumerate(points)]
  write_table("%s_input_scalar.txt" % name, "scalar signal, a row a vertex", [[s] for s in scalar])
  side = np.array([x + 0.3 * y + 0.2 * z for x, y, z in points])
  patch = (side > np.median(side)).astype(int)
  write_table("%s_input_patches.txt" % name, "patch of each vertex", patch[:, None])
  write_table("%s_input_stitch.txt" % name, "signal with a jump between the patches, a row a vertex",
              [[s + 1.5 * p] for s, p in zip(scalar, patch)])
  face_side = side[np.array(faces)].mean(1)
  region = np.flatnonzero(face_side > np.quantile(face_side, 0.4))
  write_table("%s_input_region.txt" % name, "faces of the region", region[:, None])


# ---------------------------------------------------------------- the cases

def pattern(value, count):
  """MODULUS:A:B, A where the index is a multiple of MODULUS and B elsewhere."""
  modulus, a, b = value.split(":")
  return np.where(np.arange(count) % int(modulus) == 0, float(a), float(b))


def cases():
  """Name, kind, parameters: exactly what the index says, and what run() reads."""
  out = []

  def add(name, kind="process", **parameters):
    out.append((name, kind, parameters))

  def processed(name, kind="process", signal="position", weights="relative", metric="embedding", **more):
    add(name, kind, signal=signal, weights=weights, metric=metric, **more)

  plain = dict(alpha="1", beta="1e-4")
  curved = dict(eps="0.02", gamma="1e-4")
  kinds = ("edge_aware", "anisotropic", "preserve_convex", "preserve_concave")

  processed("smooth_1e-3", alpha="1", beta="1e-3", **{"lambda": "0"})
  processed("smooth_1e-4", **plain, **{"lambda": "0"})
  processed("sharpen", **plain, **{"lambda": "2"})
  processed("partial", alpha="3", beta="1e-3", **{"lambda": "0.5"})
  processed("raw_smooth", weights="raw", alpha="1", beta="0.02", **{"lambda": "0"})
  processed("raw_partial", weights="raw", alpha="3", beta="0.01", **{"lambda": "0.5"})
  processed("scalar_smooth", signal="scalar", alpha="1", beta="1e-3", **{"lambda": "0"})
  processed("scalar_sharpen", signal="scalar", **plain, **{"lambda": "2"})
  processed("user_metric_smooth", metric="user", alpha="1", beta="1e-3", **{"lambda": "0"})
  processed("user_metric_sharpen", metric="user", alpha="2", beta="1e-3", **{"lambda": "2"})
  processed("face_beta", alpha="1", face_beta="2:1e-4:1e-3", **{"lambda": "0"})
  processed("face_lambda", alpha="1", beta="1e-3", face_lambda="3:2:0")
  processed("vertex_alpha", vertex_alpha="5:0.5:0.25", beta="1e-3", **{"lambda": "0"})
  processed("all_masks", metric="user", vertex_alpha="5:0.5:0.25", face_beta="2:1e-4:1e-3", face_lambda="3:2:0",
            constrained="7")
  processed("constrained", alpha="1", beta="1e-3", constrained="7", **{"lambda": "0"})
  processed("constrained_harmonic", alpha="0", beta="1", constrained="7", **{"lambda": "0"})
  processed("constrained_partial", alpha="0", beta="1", constrained="7", **{"lambda": "0.5"})
  processed("region_smooth", alpha="1", beta="1e-3", region="file", **{"lambda": "0"})
  processed("region_sharpen", **plain, region="file", **{"lambda": "2"})
  processed("gradients", "fit_to_gradients", alpha="1", beta="0.1", target="file")
  processed("gradients_user_metric", "fit_to_gradients", metric="user", alpha="1", beta="0.1", target="file")
  for kind in kinds:
    processed(kind, metric=kind, **plain, **curved, **{"lambda": "0"})
  processed("edge_aware_sharpen", metric="edge_aware", **plain, **curved, **{"lambda": "2"})
  processed("raw_anisotropic", weights="raw", metric="anisotropic", alpha="1", beta="1e-3", eps="0.05", gamma="1e-3",
            **{"lambda": "0"})
  processed("normals", signal="normal", **plain, **{"lambda": "0"})
  processed("normals_edge_aware", signal="normal", metric="edge_aware", **plain, **curved, **{"lambda": "0"})
  normal_fit = dict(npweight="100", **plain)
  processed("fit_normals", "fit_to_normals", **normal_fit, **{"lambda": "0"})
  processed("fit_normals_given", "fit_to_normals", **normal_fit, **{"lambda": "1"})
  for kind in ("edge_aware", "anisotropic"):
    processed("fit_normals_" + kind, "fit_to_normals", metric=kind, **normal_fit, **curved, **{"lambda": "0"})
  processed("stitch", "stitch", signal="stitch", alpha="1e-3", beta="1", patches="file")
  processed("stitch_user_metric", "stitch", signal="stitch", metric="user", alpha="1e-3", beta="1", patches="file")
  add("vertex_normals", "vertex_normals")
  add("smoothed_normals", "smoothed_normals", weights="relative", gamma="1e-4")
  add("face_curvatures", "face_curvatures", weights="relative", gamma="1e-4")
  return out


def run(name, surface, kind, parameters):
  ar, faces = surface.ar, len(surface.faces)
  unit = surface.area if parameters.get("weights") == "relative" else 1
  number = lambda key: ar.array([float(parameters[key])])[0]
  table = lambda what: ar.array(read_table("%s_input_%s.txt" % (name, what)))

  if kind == "vertex_normals":
    return surface.vertex_normals()
  if kind in ("smoothed_normals", "face_curvatures"):
    normals = smoothed_normals(surface, surface.vertex_normals(), number("gamma") * unit)
    if kind == "smoothed_normals":
      return normals
    k1, k2, _ = surface.principal_curvatures(surface.curvature_operator(normals))
    return np.stack([k2, k1], axis=1)

  if parameters["metric"] == "embedding":
    metric = surface.embedding
  elif parameters["metric"] == "user":
    metric = user_tensors(surface)[1]
  else:
    metric = estimated_metric(surface, parameters["metric"], number("eps") * unit, number("gamma") * unit)

  if kind == "fit_to_normals":
    normals = filter_signal(surface, metric, surface.vertex_normals(), number("alpha"), number("beta") * unit,
                            number("lambda"))
    return fit_to_normals(surface, metric, normals, number("npweight") * unit)

  signal = {"position": lambda: surface.points, "normal": surface.vertex_normals,
            "scalar": lambda: table("scalar"), "stitch": lambda: table("stitch")}[parameters["signal"]]()
  if "vertex_alpha" in parameters:
    modulus, start, step = parameters["vertex_alpha"].split(":")
    alpha = ar.array(float(start) + float(step) * (np.arange(surface.n) % int(modulus)))
  else:
    alpha = surface.constant(surface.n, float(parameters["alpha"]))
  if "face_beta" in parameters:
    beta = ar.array(pattern(parameters["face_beta"], faces)) * unit
  else:
    beta = surface.constant(faces, float(parameters["beta"])) * unit

  if kind == "fit_to_gradients":
    field = np.swapaxes(table("target").reshape(faces, 3, 3), 1, 2)
  elif kind == "stitch":
    patch = read_table("%s_input_patches.txt" % name)[:, 0][surface.faces]
    scale = ((patch[:, 0] == patch[:, 1]) & (patch[:, 1] == patch[:, 2])).astype(float)
    if not 0 < scale.sum() < faces:
      raise ValueError("the patches of %s do not meet in a seam" % name)
    gradient = surface.gradient(signal)
    field = ar.array(scale)[:, None, None] * gradient
    # on a seam, what runs along the edge inside a patch is kept
    for f in np.flatnonzero(scale == 0):
      for i, j in ((0, 1), (1, 2), (2, 0)):
        if patch[f, i] == patch[f, j]:
          edge = surface.points[surface.faces[f, j]] - surface.points[surface.faces[f, i]]
          for channel in range(gradient.shape[2]):
            along = gradient[f][:, channel]
            field[f][:, channel] = edge * ((along * edge).sum() / (edge * edge).sum())
  else:
    scale = pattern(parameters["face_lambda"], faces) if "face_lambda" in parameters \
        else np.full(faces, float(parameters["lambda"]))
    field = ar.array(scale)[:, None, None] * surface.gradient(signal)

  fixed = np.zeros(surface.n, dtype=bool)
  if "constrained" in parameters:
    fixed |= np.arange(surface.n) % int(parameters["constrained"]) == 0
  if "region" in parameters:
    outside = np.ones(faces, dtype=bool)
    outside[read_table("%s_input_region.txt" % name)[:, 0].astype(int)] = False
    fixed[surface.faces[outside].ravel()] = True
    if not 0 < fixed.sum() < surface.n:
      raise ValueError("the region of %s is trivial" % name)
  return process(surface, metric, signal, alpha, beta, field, fixed)


def matrices(surface):
  """The operators as (name, rows, columns, entries), vector fields as 3 numbers a face or as coefficients of two edges."""
  n, faces = surface.n, len(surface.faces)
  one = surface.constant(n, 1)
  vertex_matrix = lambda m: (n, n, [(i, j, m[i, j]) for i in range(n) for j in range(n) if m[i, j] != 0])
  out = [("gradient", 3 * faces, n, [(3 * f + c, surface.faces[f, i], surface.hat_gradient[f, i, c])
                                     for f in range(faces) for c in range(3) for i in range(3)])]
  for suffix, metric in (("", surface.embedding), ("_user_metric", user_tensors(surface)[1])):
    out.append(("mass" + suffix, *vertex_matrix(surface.mass(metric, one))))
    out.append(("stiffness" + suffix, *vertex_matrix(surface.stiffness(metric, surface.constant(faces, 1)))))
    weighted = surface.weighted_gradients(metric)
    out.append(("divergence" + suffix, n, 3 * faces, [(surface.faces[f, i], 3 * f + c, weighted[f, i, c])
                                                      for f in range(faces) for c in range(3) for i in range(3)]))
    # The vectors whose products with (t1, t2) are (1, 0) and (0, 1) are the gradients of the last two hat functions.
    out.append(("divergence_covector" + suffix, n, 2 * faces,
                [(surface.faces[f, i], 2 * f + c, dot(weighted[f, i], surface.hat_gradient[f, c + 1]))
                 for f in range(faces) for c in range(2) for i in range(3)]))
  return out


def check_operators(surface):
  """Identities that hold whatever the metric; a script that fails them must not write references."""
  n, faces = surface.n, len(surface.faces)
  one, tiny = surface.constant(n, 1), mpf("1e-33")
  tensor, metric = user_tensors(surface)
  for m in (surface.embedding, metric):
    total = (surface.face_area * m.area_factor).sum()
    stiffness = surface.stiffness(m, surface.constant(faces, 1))
    errors = [surface.mass(m, one).sum() - total, abs(stiffness @ one).max(), abs(stiffness - stiffness.T).max(),
              abs(surface.divergence(m, surface.gradient(surface.points)) - stiffness @ surface.points).max()]
    if max(abs(e) for e in errors) > tiny * total:
      raise ArithmeticError("an operator identity fails")
  errors = [abs(surface.product(tensor, metric.inverse) - surface.projector).max(),
            abs(surface.gradient(surface.points) - surface.projector).max()]
  if max(errors) > tiny:
    raise ArithmeticError("a tangent operator is wrong")


# ---------------------------------------------------------------- the three modes

def write_all():
  index = []
  for mesh in MESHES:
    write_inputs(mesh)
    surface = Surface(*read_off(os.path.join(HERE, mesh + ".off")), Exact)
    check_operators(surface)
    for name, kind, parameters in cases():
      case = "%s_%s" % (mesh, name)
      result = run(mesh, surface, kind, parameters)
      write_table(case + ".txt", case, result)
      index.append([case, mesh, kind, *result.shape, *("%s=%s" % item for item in parameters.items())])
    if mesh == "patch":
      for name, rows, columns, entries in matrices(surface):
        case = "%s_matrix_%s" % (mesh, name)
        write_table(case + ".txt", "%s: row column value" % case, entries)
        index.append([case, mesh, "matrix", rows, columns, "operator=" + name])
    print(mesh, surface.n, "vertices,", len(surface.faces), "faces", flush=True)
  with open(os.path.join(HERE, "references.txt"), "w") as out:
    out.write("# case mesh kind rows columns parameters\n")
    for row in index:
      out.write(" ".join(str(c) for c in row) + "\n")


def difference(result, reference):
  extent = max(np.ptp(reference[:, k]) for k in range(reference.shape[1]))
  return np.abs(result - reference).max() / extent


def compare_double():
  worst = 0
  for mesh in MESHES:
    surface = Surface(*read_off(os.path.join(HERE, mesh + ".off")), Double)
    for name, kind, parameters in cases():
      d = difference(run(mesh, surface, kind, parameters), read_table("%s_%s.txt" % (mesh, name)))
      worst = max(worst, d)
      print("%-40s %.1e" % (mesh + "_" + name, d))
  print("worst %.1e of the extent" % worst)


def compare_authors(folder):
  """Their curvature weight k means eps = k / 2 without and eps = k with the anisotropic option."""
  print("%-36s %9s %9s" % ("of the signal's extent, input as", "double", "float"))
  for mesh in ("sphere_noisy", "fandisk", "elephant"):
    points, faces = read_off(os.path.join(folder, mesh + ".off"))
    rounded = np.array(points, dtype=np.float32).astype(float)
    surfaces = [Surface(p, faces, Double) for p in (points, rounded)]
    for case, kind, eps, beta, scale in (
        ("a_smooth_1e-3", None, 0, 1e-3, 0), ("a_smooth_1e-4", None, 0, 1e-4, 0), ("a_smooth_1e-5", None, 0, 1e-5, 0),
        ("b_sharpen", None, 0, 1e-4, 2), ("c_edgeaware", "edge_aware", 0.01, 1e-4, 0),
        ("d_aniso", "anisotropic", 0.02, 1e-4, 0), ("e_normals", None, 0, 1e-4, 0),
        ("e_normals_kweight", "edge_aware", 0.01, 1e-4, 0), ("f_fit", None, 0, 1e-4, 0),
        ("f_fit_kweight", "edge_aware", 0.01, 1e-4, 0)):
      with gzip.open(os.path.join(folder, "%s.%s.ply.gz" % (mesh, case)), "rt") as stream:
        while stream.readline().strip() != "end_header":
          pass
        reference = np.array([stream.readline().split() for _ in points], dtype=float)[:, -3:]
      found = []
      for surface in surfaces:
        area = surface.area
        metric = estimated_metric(surface, kind, eps * area, 1e-4 * area) if kind else surface.embedding
        signal = surface.points if case[0] in "abcd" else surface.vertex_normals()
        result = filter_signal(surface, metric, signal, 1, beta * area, scale)
        if case[0] == "f":
          result = fit_to_normals(surface, metric, result, 100 * area)
        found.append(difference(result, reference))
      print("%-36s %9.1e %9.1e" % (mesh + "." + case, *found), flush=True)


def main():
  parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
  parser.add_argument("--double", action="store_true", help="compare the files with double precision (needs scipy)")
  parser.add_argument("--check", metavar="DIR", help="compare with the outputs in DIR (needs scipy)")
  options = parser.parse_args()
  if options.check:
    compare_authors(options.check)
  elif options.double:
    compare_double()
  else:
    write_all()


if __name__ == "__main__":
  sys.exit(main())
