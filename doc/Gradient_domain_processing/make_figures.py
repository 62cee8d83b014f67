#!/usr/bin/env python3
# Copyright (c) 2026  The Gradient_domain_processing authors.
#
# This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes the pictures of the manual from runs of the package's programs on the meshes of CGAL.

    make_figures.py BUILD [--data ARCHIVE_OR_FOLDER] [--output FOLDER] [--only NAME ...]

BUILD is a folder in which gradient_domain_filter, the examples and the tests are built. Debian: python3-vtk9, python3-numpy, and
xvfb where there is no display. Running it again gives the same pictures.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../../benchmark/Gradient_domain_processing"))
from cgal_data import ARCHIVE, folder_of_meshes  # noqa: E402

SMOOTHNESS = 2  # pixels are the mean of so many squared

CLAY = (0.84, 0.82, 0.78)
VIEWS = {  # from where, which way is up, how much closer than all of it
    "armadillo": ((0.25, 0.2, -1), (0, 1, 0), 0.97),
    "bunny00": ((-0.15, 0.25, 1), (0, 1, 0), 1.0),
    "fandisk_large": ((0.9, -0.75, 0.75), (0, 0, 1), 1.0),
    "anchor_dense": ((0.6, 0.5, 0.8), (0, 1, 0), 1.0),
    "scan": ((0.45, -0.6, 1), (-0.2, 1, 0), 1.05),
    "square": ((0, 0, 1), (0, 1, 0), 1.0),
}


# ---- meshes ----------------------------------------------------------------------------------------------------------

class Mesh:
    def __init__(self, points, faces, properties=None):
        self.points = np.asarray(points, float)
        self.faces = np.asarray(faces, np.int64)
        self.properties = properties or {}

    def mean_edge(self):
        corners = self.points[self.faces]
        return np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).mean()

    def with_noise(self, level, seed=1):
        """Gaussian noise in all directions, of so many mean edges."""
        noise = np.random.default_rng(seed).normal(size=self.points.shape)
        return Mesh(self.points + level * self.mean_edge() * noise, self.faces)

    def height(self, axis):
        """0 to 1 along a coordinate."""
        x = self.points[:, axis]
        return (x - x.min()) / (x.max() - x.min())


def read_off(path):
    with open(path) as file:
        words = " ".join(line.split("#")[0] for line in file).split()
    n, m = int(words[1]), int(words[2])
    points = np.array(words[4:4 + 3 * n], float).reshape(n, 3)
    faces, at = [], 4 + 3 * n
    for _ in range(m):
        size = int(words[at])
        polygon = [int(w) for w in words[at + 1:at + 1 + size]]
        faces += [[polygon[0], polygon[i], polygon[i + 1]] for i in range(1, size - 1)]
        at += 1 + size
    return Mesh(points, faces)


TYPES = {"char": "i1", "uchar": "u1", "short": "<i2", "ushort": "<u2", "int": "<i4", "uint": "<u4", "float": "<f4", "double": "<f8",
         "int8": "i1", "uint8": "u1", "int16": "<i2", "uint16": "<u2", "int32": "<i4", "uint32": "<u4", "float32": "<f4",
         "float64": "<f8"}


def read_ply(path):
    """A binary little-endian or ASCII PLY of triangles, as the programs of this package write it."""
    with open(path, "rb") as file:
        elements, encoding = [], ""
        while True:
            words = file.readline().decode().split()
            if words[0] == "format":
                encoding = words[1]
            elif words[0] == "element":
                elements.append((words[1], int(words[2]), []))
            elif words[0] == "property":
                elements[-1][2].append(words[1:])
            elif words[0] == "end_header":
                break
        tables = {}
        for name, count, properties in elements:
            fields = []
            for p in properties:
                fields += [("size", TYPES[p[1]]), ("corners", TYPES[p[2]], (3,))] if p[0] == "list" else [(p[1], TYPES[p[0]])]
            kind = np.dtype(fields)
            if encoding == "ascii":
                rows = [file.readline().split() for _ in range(count)]
                table = np.zeros(count, kind)
                for i, row in enumerate(rows):
                    at = 0
                    for field in fields:
                        width = 3 if len(field) == 3 else 1
                        table[field[0]][i] = row[at:at + 3] if width == 3 else row[at]
                        at += width
            else:
                table = np.frombuffer(file.read(count * kind.itemsize), kind)
            tables[name] = table
    vertices = tables["vertex"]
    points = np.stack([vertices[c] for c in "xyz"], axis=1)
    return Mesh(points, tables["face"]["corners"], {n: np.array(vertices[n], float) for n in vertices.dtype.names if n not in "xyz"})


def write_ply(path, mesh):
    names = sorted(mesh.properties)
    with open(path, "wb") as file:
        header = ["ply", "format binary_little_endian 1.0", "element vertex %d" % len(mesh.points)]
        header += ["property double " + n for n in ["x", "y", "z"] + names]
        header += ["element face %d" % len(mesh.faces), "property list uchar int vertex_indices", "end_header"]
        file.write(("\n".join(header) + "\n").encode())
        columns = [mesh.points[:, i] for i in range(3)] + [mesh.properties[n] for n in names]
        file.write(np.stack(columns, axis=1).astype("<f8").tobytes())
        faces = np.zeros(len(mesh.faces), [("size", "u1"), ("corners", "<i4", (3,))])
        faces["size"], faces["corners"] = 3, mesh.faces
        file.write(faces.tobytes())


# ---- programs --------------------------------------------------------------------------------------------------------

class Programs:
    def __init__(self, build, folder):
        self.build, self.folder, self.count = build, folder, 0

    def path(self, name):
        for folder, _, files in os.walk(self.build):
            if name in files and os.access(os.path.join(folder, name), os.X_OK):
                return os.path.join(folder, name)
        sys.exit("%s is not built in %s" % (name, self.build))

    def file(self):
        self.count += 1
        return os.path.join(self.folder, "%d.ply" % self.count)

    def filter(self, mesh, **options):
        """Runs gradient_domain_filter: gradient_weight=1e-4 becomes --gradient-weight 1e-4."""
        source, result = self.file(), self.file()
        write_ply(source, mesh)
        words = []
        for name, value in options.items():
            words += ["--" + name.replace("_", "-"), str(value)]
        subprocess.run([self.path("gradient_domain_filter"), source, result] + words, check=True)
        return read_ply(result)

    def example(self, name, mesh, *results):
        """Runs an example on a mesh and reads what it wrote."""
        source = self.file()
        write_ply(source, mesh)
        subprocess.run([self.path(name), source], check=True, cwd=self.folder, stdout=subprocess.DEVNULL)
        return [read_ply(os.path.join(self.folder, r)) for r in results]

    def range_scan(self):
        """The simulated scan of the tests: noisy, and smoothed by three metrics to the same noise."""
        subprocess.run([self.path("test_range_scan"), self.folder], check=True, stdout=subprocess.DEVNULL)
        names = ["noisy", "isotropic", "edge_aware", "anisotropic"]
        return [read_off(os.path.join(self.folder, name + ".off")) for name in names]


# ---- pictures --------------------------------------------------------------------------------------------------------

def poly_data(mesh, colors):
    import vtk
    from vtk.util import numpy_support
    points = vtk.vtkPoints()
    points.SetData(numpy_support.numpy_to_vtk(mesh.points, deep=True))
    cells = np.hstack([np.full((len(mesh.faces), 1), 3, np.int64), mesh.faces]).ravel()
    array = vtk.vtkCellArray()
    array.SetCells(len(mesh.faces), numpy_support.numpy_to_vtkIdTypeArray(cells, deep=True))
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    data.SetPolys(array)
    if colors is not None:
        bytes_ = np.clip(np.round(255 * colors), 0, 255).astype(np.uint8)
        data.GetPointData().SetScalars(numpy_support.numpy_to_vtk(bytes_, deep=True))
    return data


def photograph(renderer, size):
    import vtk
    from vtk.util import numpy_support
    width, height = SMOOTHNESS * size[0], SMOOTHNESS * size[1]
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(width, height)
    window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    scalars = grab.GetOutput().GetPointData().GetScalars()
    pixels = numpy_support.vtk_to_numpy(scalars).reshape(height, width, 3)[::-1].astype(float)
    window.Finalize()
    return pixels.reshape(size[1], SMOOTHNESS, size[0], SMOOTHNESS, 3).mean(axis=(1, 3)).round().astype(np.uint8)


def render(mesh, view, frame, size, label="", colors=None):
    """One panel: a picture, and what is written below it. `frame` is the mesh by which the camera is set, the same for all panels of a
    row."""
    import vtk
    towards, up, zoom = VIEWS[view]
    towards = np.array(towards, float) / np.linalg.norm(towards)
    right = np.cross(up, towards)
    right /= np.linalg.norm(right)
    above = np.cross(towards, right)
    x, y = frame.points @ right, frame.points @ above
    center = right * (x.max() + x.min()) / 2 + above * (y.max() + y.min()) / 2 + towards * (frame.points @ towards).mean()
    half = 0.52 * max(y.max() - y.min(), (x.max() - x.min()) * size[1] / size[0]) / zoom

    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(poly_data(mesh, colors))
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToFlat()
    look.SetColor(*CLAY)
    look.SetAmbient(0.14)
    look.SetDiffuse(0.86)
    look.SetSpecular(0.12)
    look.SetSpecularPower(18)

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(actor)
    renderer.RemoveAllLights()
    renderer.AutomaticLightCreationOff()
    for offset, strength in (((-0.8, 0.9, 1.0), 0.98), ((1.0, -0.2, 0.8), 0.34)):
        light = vtk.vtkLight()
        light.SetLightTypeToSceneLight()
        light.SetFocalPoint(*center)
        light.SetPosition(*(center + 100 * half * (offset[0] * right + offset[1] * above + offset[2] * towards)))
        light.SetIntensity(strength)
        renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*center)
    camera.SetPosition(*(center + 20 * half * towards))
    camera.SetViewUp(*above)
    camera.SetParallelScale(half)
    renderer.ResetCameraClippingRange()
    return photograph(renderer, size), label


def written(label, width):
    """The line below a panel."""
    import vtk
    text = vtk.vtkTextActor()
    text.SetInput(label)
    text.SetPosition(SMOOTHNESS * width / 2, 8 * SMOOTHNESS)
    style = text.GetTextProperty()
    style.SetFontFamilyToArial()
    style.SetFontSize(15 * SMOOTHNESS)
    style.SetColor(0.2, 0.25, 0.3)
    style.SetJustificationToCentered()
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor2D(text)
    return photograph(renderer, (width, 30))


def cropped(rows, margin=6):
    """Panels of one size without the white around them, the same of all, and with the line below them."""
    ink = np.min([pixels.min(axis=2) for row in rows for pixels, _ in row], axis=0) < 250
    y, x = np.flatnonzero(ink.any(axis=1)), np.flatnonzero(ink.any(axis=0))
    part = np.s_[max(y[0] - margin, 0):y[-1] + margin, max(x[0] - margin, 0):x[-1] + margin]
    result = []
    for row in rows:
        result.append([])
        for pixels, label in row:
            panel = pixels[part]
            result[-1].append(np.concatenate([panel, written(label, panel.shape[1])]) if label else panel)
    return result


def centered(panel, width):
    """A panel with white to its left and right."""
    left = (width - panel.shape[1]) // 2
    return np.pad(panel, ((0, 0), (left, width - panel.shape[1] - left), (0, 0)), constant_values=255)


def write_png(path, rows):
    """Rows of panels, side by side."""
    import vtk
    from vtk.util import numpy_support
    pixels = np.concatenate([np.concatenate(row, axis=1) for row in rows], axis=0)
    image = vtk.vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(np.ascontiguousarray(pixels[::-1]).reshape(-1, 3), deep=True))
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetCompressionLevel(9)
    writer.SetInputData(image)
    writer.Write()
    print("%s: %d x %d, %d KB" % (os.path.basename(path), pixels.shape[1], pixels.shape[0], os.path.getsize(path) // 1024), flush=True)


def diverging(x):
    """-1 to 1: blue, pale, red."""
    x = np.clip(x, -1, 1)[:, None]
    pale, red, blue = np.array([0.93, 0.92, 0.90]), np.array([0.80, 0.16, 0.13]), np.array([0.10, 0.32, 0.72])
    return pale + np.abs(x) * (np.where(x > 0, red, blue) - pale)


def heat(x):
    """0 to 1: pale, orange, dark red."""
    x = np.clip(x, 0, 1)
    return np.stack([np.interp(x, [0, 0.5, 1], c) for c in ((0.93, 0.95, 0.55), (0.92, 0.60, 0.05), (0.90, 0.20, 0.08))], axis=1)


def stripes(x, mesh_size):
    """Isolines: 0 to 1 in dark and pale bands, with an edge as wide as a triangle."""
    wave = np.clip(np.sin(np.pi * 14 * x) / (np.pi * 14 * mesh_size), -1, 1) / 2 + 0.5
    dark, pale = np.array([0.16, 0.34, 0.60]), np.array([0.93, 0.92, 0.90])
    return dark + wave[:, None] * (pale - dark)


def square(n):
    """A square of n x n cells, each cut in two, the cuts in turn."""
    x, y = np.meshgrid(np.arange(n + 1) / n, np.arange(n + 1) / n)
    faces = []
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i
            b, c, d = a + 1, a + n + 2, a + n + 1
            faces += [[a, b, c], [a, c, d]] if (i + j) % 2 else [[a, b, d], [b, c, d]]
    return Mesh(np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1), faces)


# ---- the figures -----------------------------------------------------------------------------------------------------

class Figures:
    def __init__(self, programs, data, output):
        self.programs, self.data, self.output = programs, data, output

    def mesh(self, name):
        return read_off(os.path.join(self.data, name + ".off"))

    def save(self, name, rows):
        write_png(os.path.join(self.output, name + ".png"), cropped(rows))

    def smooth_sharpen(self):
        mesh, view = self.mesh("armadillo"), "armadillo"
        results = [self.programs.filter(mesh, gradient_weight=3e-5, gradient_scale=0), mesh,
                   self.programs.filter(mesh, gradient_weight=3e-5, gradient_scale=2)]
        labels = ["smoothed", "input", "sharpened"]
        self.save("smooth_sharpen", [[render(m, view, mesh, (400, 470), l) for m, l in zip(results, labels)]])

    def weight_sweep(self):
        mesh, view = self.mesh("armadillo"), "armadillo"
        rows = []
        for scale in (0, 0.5, 2):
            row = []
            for weight in ("1e-6", "1e-5", "1e-4", "1e-3"):
                result = self.programs.filter(mesh, gradient_weight=weight, gradient_scale=scale)
                row.append(render(result, view, mesh, (290, 330), "beta = %s, lambda = %g" % (weight, scale)))
            rows.append(row)
        self.save("weight_sweep", rows)

    def noise(self):
        rows = []
        for name, weight, curvature, presmoothing in (("fandisk_large", "1e-4", "0.02", "5e-5"), ("bunny00", "5e-6", "0.001", "3e-5")):
            noisy = self.mesh(name).with_noise(0.25)
            clean = self.programs.filter(noisy, gradient_weight=weight, metric="anisotropic", curvature_weight=curvature,
                                         presmoothing_weight=presmoothing, iterations=4)
            rows += cropped([[render(m, name, noisy, (520, 440)) for m in (noisy, clean)]])
        width = max(panel.shape[1] for row in rows for panel in row)
        write_png(os.path.join(self.output, "noise.png"), [[centered(panel, width) for panel in row] for row in rows])

    def scan(self):
        meshes, labels = self.programs.range_scan(), ["noisy scan", "isotropic", "edge-aware", "anisotropic"]
        points = meshes[0].points
        frame = Mesh(points[(np.abs(points[:, 0]) < 32) & (points[:, 1] > -18) & (points[:, 1] < 30)], [])
        panels = [render(m, "scan", frame, (380, 280), l) for m, l in zip(meshes, labels)]
        rows = [[centered(panel, panel.shape[1] + 14) for panel in row] for row in cropped([panels[:2], panels[2:]])]
        write_png(os.path.join(self.output, "scan.png"), rows)

    def denoising(self):
        clean, view = self.mesh("fandisk_large"), "fandisk_large"
        noisy = clean.with_noise(0.2)
        panels = [clean, noisy, self.programs.filter(noisy, gradient_weight="1e-4"), self.programs.filter(noisy, operation="denoise")]
        labels = ["clean", "noisy", "isotropic", "denoise()"]
        self.save("denoising", [[render(m, view, noisy, (330, 300), l) for m, l in zip(panels, labels)]])

    def metrics(self):
        noisy, view = self.mesh("fandisk_large").with_noise(0.2), "fandisk_large"
        panels = [render(noisy, view, noisy, (400, 360), "input")]
        for metric in ("embedding", "edge-aware", "anisotropic", "preserve-convex", "preserve-concave"):
            curvature = {} if metric == "embedding" else dict(curvature_weight="0.01", presmoothing_weight="1e-4")
            result = self.programs.filter(noisy, gradient_weight="3e-4", metric=metric, **curvature)
            panels.append(render(result, view, noisy, (400, 360), metric))
        self.save("metrics", [panels[:3], panels[3:]])

    def one_sided(self):
        mesh, view = self.mesh("anchor_dense"), "anchor_dense"
        results = [self.programs.filter(mesh, gradient_weight="3e-4", metric="preserve-convex", curvature_weight=0.2, presmoothing_weight="1e-6"),
                   mesh,
                   self.programs.filter(mesh, gradient_weight="3e-4", metric="preserve-concave", curvature_weight=0.2, presmoothing_weight="1e-6")]
        labels = ["convex creases preserved", "input", "concave creases preserved"]
        self.save("one_sided", [[render(m, view, mesh, (400, 380), l) for m, l in zip(results, labels)]])

    def two_passes(self):
        noisy, view = self.mesh("fandisk_large").with_noise(0.1), "fandisk_large"
        first = [noisy,
                 self.programs.filter(noisy, gradient_weight="1e-4"),
                 self.programs.filter(noisy, gradient_weight="1e-4", metric="edge-aware", curvature_weight="0.0007",
                                      presmoothing_weight="3e-5")]
        second = [self.programs.filter(m, gradient_weight="3e-5", gradient_scale=2.5) for m in first]
        labels = ["noisy input", "smoothed", "smoothed edge-aware"], ["sharpened", "smoothed, sharpened", "smoothed edge-aware, sharpened"]
        self.save("two_passes", [[render(m, view, noisy, (400, 360), l) for m, l in zip(row, words)]
                                 for row, words in zip((first, second), labels)])

    def curvature(self):
        clean, view = self.mesh("fandisk_large"), "fandisk_large"
        noisy = clean.with_noise(0.2)
        area = np.linalg.norm(np.cross(clean.points[clean.faces[:, 1]] - clean.points[clean.faces[:, 0]],
                                       clean.points[clean.faces[:, 2]] - clean.points[clean.faces[:, 0]]), axis=1).sum() / 2
        panels = []
        for mesh, weight, label in ((clean, 0, "clean"), (noisy, 0, "noisy"), (noisy, "1e-4", "noisy, presmoothed")):
            found = self.programs.filter(mesh, signal="curvature", presmoothing_weight=weight)
            total = found.properties["curvature"] * area
            panels.append(render(mesh, view, clean, (400, 360), label, heat((np.log10(total + 1e-9) - 0.5) / 3)))
        self.save("curvature", [panels])

    def masks(self):
        mesh, view = self.mesh("armadillo"), "armadillo"
        height = mesh.height(1)
        lower, upper = np.clip((0.45 - height) / 0.05, 0, 1), np.clip((height - 0.6) / 0.05, 0, 1)
        mesh.properties = {"lambda": 1 - lower + upper, "beta": 1e-4 * lower + 3e-5 * upper}
        result = self.programs.filter(mesh, gradient_weight_property="beta", gradient_scale_property="lambda")
        mask = render(mesh, view, mesh, (400, 470), "mask", diverging(lower - upper))
        self.save("masks", [[render(mesh, view, mesh, (400, 470), "input"), mask, render(result, view, mesh, (400, 470), "result")]])

    def stitch(self):
        mesh = self.mesh("bunny00")
        panels = []
        for result, label in zip(self.programs.example("stitch_example", mesh, "two_photographs.ply", "one_photograph.ply"),
                                 ("two photographs", "stitched")):
            colors = np.stack([result.properties[c] for c in ("red", "green", "blue")], axis=1) / 255
            panels.append(render(result, "bunny00", mesh, (520, 480), label, colors))
        self.save("stitch", [panels])

    def fair_patch(self):
        mesh, view = self.mesh("bunny00"), "bunny00"
        height, towards = mesh.points[:, 1], mesh.points[:, 2]
        extent = np.ptp(mesh.points, axis=0).max()
        middle = mesh.points[np.argmax(towards - 0.5 * np.abs(height - height.mean()))]
        inside = np.linalg.norm(mesh.points - middle, axis=1) < 0.16 * extent
        mesh.properties = {"is_in_hole": inside.astype(float), "is_outside": 1.0 - inside}
        membrane = self.programs.filter(mesh, value_weight=0, gradient_weight=1, constrain="is_outside", gradient_scale=0)
        fair = self.programs.filter(membrane, operation="fair", region_vertices="is_in_hole")
        colors = np.where(inside[:, None], [0.93, 0.72, 0.45], CLAY)
        panels = zip((mesh, membrane, fair), ("input", "the patch as a membrane", "fair()"))
        self.save("fair_patch", [[render(m, view, mesh, (400, 400), l, colors) for m, l in panels]])

    def harmonics(self):
        mesh, view = self.mesh("fandisk_large"), "fandisk_large"
        result, = self.programs.example("anisotropic_spectrum_example", mesh, "harmonics.ply")
        panels = []
        for name, label in (("embedding", "embedding"), ("edge_aware", "edge-aware metric"), ("anisotropic", "anisotropic conductance")):
            values = result.properties[name]
            values = values * np.sign(values[np.argmax(np.abs(values))])
            panels.append(render(mesh, view, mesh, (400, 360), label, diverging(1.3 * values / np.abs(values).max())))
        self.save("harmonics", [panels])

    def border_isolines(self):
        mesh = square(80)
        exact = 0.75 * mesh.points[:, 0] + 0.25 * mesh.points[:, 1]
        noisy = exact + 0.06 * np.random.default_rng(5).normal(size=len(exact))
        mesh.properties = {"value": noisy}
        first = self.programs.filter(mesh, signal="value", gradient_weight="0.02")
        second = self.programs.filter(mesh, signal="value", gradient_weight=0, hessian_weight="0.0006")
        panels = zip((exact, noisy, first.properties["value"], second.properties["value"]),
                     ("values", "with noise", "first derivatives", "second derivatives"))
        self.save("border_isolines", [[render(mesh, "square", mesh, (280, 280), l, stripes(v, 1 / 80)) for v, l in panels]])

    def wave_bands(self):
        mesh, view = self.mesh("armadillo"), "armadillo"
        extent = np.ptp(mesh.points, axis=0).max()
        coarse = self.programs.filter(mesh, operation="low-pass", wavelengths=repr(extent / 6))
        fine = self.programs.filter(mesh, operation="low-pass", wavelengths=repr(extent / 24))
        corners = fine.points[fine.faces]
        normals = np.zeros_like(mesh.points)
        for k in range(3):
            np.add.at(normals, fine.faces[:, k], np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        panels = [render(coarse, view, mesh, (380, 450), "longer than 1/6 of the height"),
                  render(fine, view, mesh, (380, 450), "longer than 1/24")]
        for a, b, label, scale in ((fine, coarse, "between the two", 0.02), (mesh, fine, "shorter", 0.004)):
            heights = ((a.points - b.points) * normals).sum(axis=1) / extent
            panels.append(render(fine, view, mesh, (380, 450), label, diverging(heights / scale)))
        self.save("wave_bands", [panels])


NAMES = ["smooth_sharpen", "weight_sweep", "noise", "scan", "denoising", "metrics", "one_sided", "two_passes", "curvature", "masks", "stitch",
         "fair_patch", "harmonics", "border_isolines", "wave_bands"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--data", default=ARCHIVE)
    parser.add_argument("--output", default=os.path.join(HERE, "fig"))
    parser.add_argument("--only", nargs="*", default=NAMES, choices=NAMES)
    arguments = parser.parse_args()

    if not os.environ.get("DISPLAY"):  # Debian's VTK wants an X server, also when it draws off-screen
        if not shutil.which("xvfb-run"):
            sys.exit("There is no display: install xvfb")
        os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 1600x1200x24 -noreset", sys.executable] + sys.argv)

    with tempfile.TemporaryDirectory() as folder:
        data = folder_of_meshes(arguments.data, folder)
        os.makedirs(arguments.output, exist_ok=True)
        figures = Figures(Programs(os.path.abspath(arguments.build), folder), data, arguments.output)
        for name in arguments.only:
            getattr(figures, name)()


if __name__ == "__main__":
    main()
