#!/usr/bin/env python3
"""What denoising does to noise of our own on meshes of CGAL, beside the isotropic and the anisotropic filter at their best weights.

usage: denoise_table.py BUILD [--data ARCHIVE_OR_FOLDER] [--only NAME...]

BUILD is a folder with gradient_domain_filter. Prints a table in Markdown: the mean angle in degrees between the face normals of each mesh
and those of the clean one, and for `denoise()` the passes, the mean shift of vertices in mean edge lengths, and the change of the volume.
The best weights are chosen by looking at the clean mesh, which nobody has; `denoise()` runs at its defaults. Needs numpy.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import numpy as np

from cgal_data import ARCHIVE, folder_of_meshes

NOISES = {"normal": "along normals", "random": "in random directions"}
PAIRS = [("fandisk_large", "normal", 0.1), ("fandisk_large", "normal", 0.3), ("fandisk_large", "random", 0.3), ("fandisk_large", "normal", 0.5),
         ("anchor_dense", "normal", 0.3), ("anchor_dense", "random", 0.5), ("bear", "normal", 0.2),
         ("armadillo", "normal", 0.2), ("camel", "random", 0.3), ("lion-head", "normal", 0.2), ("mannequin-devil", "normal", 0.1),
         ("elephant", "random", 0.1), ("rotor", "normal", 0.1)]
ISOTROPIC = [{"gradient-weight": w} for w in ("1e-6", "3e-6", "1e-5", "3e-5", "1e-4", "3e-4", "1e-3")]
ANISOTROPIC = [{"gradient-weight": w, "metric": "anisotropic", "curvature-weight": c, "presmoothing-weight": "3e-5", "iterations": "3"}
               for w in ("3e-6", "1e-5", "3e-5", "1e-4", "3e-4") for c in ("0.001", "0.01", "0.1")]


def read_off(path):
    words = [w for line in open(path, errors="replace") for w in line.split("#")[0].split()][1:]
    n, m = int(words[0]), int(words[1])
    points = np.array(words[3:3 + 3 * n], float).reshape(n, 3)
    return points, np.array(words[3 + 3 * n:3 + 3 * n + 4 * m], int).reshape(m, 4)[:, 1:]


def write_off(path, points, faces):
    with open(path, "w") as stream:
        stream.write(f"OFF\n{len(points)} {len(faces)} 0\n")
        np.savetxt(stream, points, "%.17g")
        np.savetxt(stream, np.insert(faces, 0, 3, axis=1), "%d")


def area_vectors(points, faces):
    a, b, c = (points[faces[:, i]] for i in range(3))
    return np.cross(b - a, c - a) / 2


def unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-300)


def mean_edge(points, faces):
    return np.mean([np.linalg.norm(points[faces[:, i]] - points[faces[:, i - 1]], axis=1).mean() for i in range(3)])


def with_noise(points, faces, kind, level):
    """Gaussian, of so many mean edge lengths."""
    random = np.random.default_rng(1)
    directions = random.normal(size=points.shape)
    if kind == "normal":
        directions = np.zeros_like(points)
        for i in range(3):
            np.add.at(directions, faces[:, i], area_vectors(points, faces))
    return points + level * mean_edge(points, faces) * random.normal(size=(len(points), 1)) * unit(directions)


def angle(points, clean, faces):
    cosines = (unit(area_vectors(points, faces)) * unit(area_vectors(clean, faces))).sum(axis=1)
    return np.degrees(np.arccos(np.clip(cosines, -1, 1))).mean()


def volume(points, faces):
    return (points[faces[:, 0]] * area_vectors(points, faces)).sum() / 3


def is_closed(faces):
    sides = np.concatenate([np.sort(np.roll(faces, i, axis=1)[:, :2]) for i in range(3)])
    return (np.unique(sides, axis=0, return_counts=True)[1] == 2).all()


class Filter:
    def __init__(self, build, folder):
        self.folder = folder
        self.program = next((os.path.join(d, f) for d, _, files in os.walk(build) for f in files
                             if f == "gradient_domain_filter" and os.access(os.path.join(d, f), os.X_OK)), None)
        if not self.program:
            sys.exit(f"gradient_domain_filter is not in {build}")

    def __call__(self, points, faces, options):
        source, result = (os.path.join(self.folder, name + ".off") for name in ("source", "result"))
        write_off(source, points, faces)
        words = [word for name, value in options.items() for word in ("--" + name, value)]
        subprocess.run([self.program, source, result] + words, check=True)
        return read_off(result)[0]

    def best(self, noisy, clean, faces, sets):
        return min(angle(self(noisy, faces, options), clean, faces) for options in sets)

    def denoise(self, points, faces):
        """The points, and after how many passes they stopped."""
        report = os.path.join(self.folder, "report.json")
        result = self(points, faces, {"operation": "denoise", "report": report})
        with open(report) as stream:
            return result, int(json.load(stream)["passes"])


def row(run, path, name, kind, level):
    clean, faces = read_off(path)
    used, faces = np.unique(faces, return_inverse=True)
    clean, faces = clean[used], faces.reshape(-1, 3)
    noisy = with_noise(clean, faces, kind, level)
    result, passes = run.denoise(noisy, faces)
    shift = np.linalg.norm(result - clean, axis=1).mean() / mean_edge(clean, faces)
    change = 100 * (volume(result, faces) / volume(noisy, faces) - 1)
    return [name, f"{level} {NOISES[kind]}", f"{angle(noisy, clean, faces):.1f}", f"{run.best(noisy, clean, faces, ISOTROPIC):.1f}",
            f"{run.best(noisy, clean, faces, ANISOTROPIC):.1f}", f"{angle(result, clean, faces):.1f}",
            str(passes), f"{shift:.2f}", f"{change:+.2f} %" if is_closed(faces) else "open"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--data", default=ARCHIVE)
    parser.add_argument("--only", nargs="*")
    arguments = parser.parse_args()

    with tempfile.TemporaryDirectory() as folder:
        data = folder_of_meshes(arguments.data, folder)
        run = Filter(arguments.build, folder)
        print("| model | noise, mean edges | noisy | isotropic, best | anisotropic, best | `denoise()` | passes | shift | volume |")
        print("|:--|:--|--:|--:|--:|--:|--:|--:|--:|")
        for name, kind, level in PAIRS:
            if not arguments.only or name in arguments.only:
                print("| " + " | ".join(row(run, os.path.join(data, name + ".off"), name, kind, level)) + " |", flush=True)


if __name__ == "__main__":
    main()
