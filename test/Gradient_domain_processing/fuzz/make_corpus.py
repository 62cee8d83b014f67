#!/usr/bin/env python3
# Copyright (c) 2026  The Gradient_domain_processing authors.
#
# This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Writes the seeds of fuzz_filter into corpus/. Files there that begin with found_ are findings and stay."""

import math
import pathlib
import struct

FOLDER = pathlib.Path(__file__).parent / "corpus"


def seed(name, arguments, contents):
    if isinstance(contents, str):
        contents = contents.encode()
    (FOLDER / name).write_bytes(arguments.encode() + b"\n" + contents)


def wave(n):
    """An open grid, not flat."""
    points = [(i, j, round(math.sin(1.3 * i) * math.cos(0.9 * j) / 2, 3)) for j in range(n) for i in range(n)]
    faces = []
    for j in range(n - 1):
        for i in range(n - 1):
            a = j * n + i
            faces += [(a, a + 1, a + n), (a + 1, a + n + 1, a + n)]
    return points, faces


OCTAHEDRON = ([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1.1, 0), (0, 0, 1), (0, 0, -0.9)],
              [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])
CUBE = ([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)],
        [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)])
HEXAGON = ([(2, 0, 0), (1, 2, 0), (-1, 2, 0.1), (-2, 0, 0), (-1, -2, 0), (0, -1, 0)], [(0, 1, 2, 3, 4, 5)])
THREE_ON_AN_EDGE = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, 2)], [(0, 1, 2), (1, 0, 3), (0, 1, 4)])
TWO_UMBRELLAS = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 0, 2)], [(0, 1, 2), (0, 3, 4)])
NEEDLES = ([(0, 0, 0), (1, 0, 0), (2, 0, 0), (1, 1, 0), (1, 0, 0), (1, -1, 1e-13)], [(0, 1, 3), (1, 2, 3), (4, 0, 5), (0, 4, 1)])


def lines(rows):
    return "".join(" ".join(str(x) for x in row) + "\n" for row in rows)


def off(mesh, keyword="OFF", extra=lambda i: ()):
    points, faces = mesh
    return (f"{keyword}\n{len(points)} {len(faces)} 0\n" + lines((*p, *extra(i)) for i, p in enumerate(points))
            + lines((len(f), *f) for f in faces))


def obj(mesh, corner=lambda v: str(v + 1), before=""):
    points, faces = mesh
    return lines(("v", *p) for p in points) + before + lines(("f", *(corner(v) for v in f)) for f in faces)


def ascii_stl(mesh):
    text = "solid s\n"
    for face in mesh[1]:
        text += "facet normal 0 0 0\nouter loop\n" + lines(("vertex", *mesh[0][v]) for v in face) + "endloop\nendfacet\n"
    return text + "endsolid s\n"


def binary_stl(mesh):
    data = bytes(80) + struct.pack("<I", len(mesh[1]))
    for face in mesh[1]:
        data += struct.pack("<12fH", 0, 0, 0, *(x for v in face for x in mesh[0][v]), 0)
    return data


PROPERTIES = [("float", "nx"), ("float", "ny"), ("float", "nz"), ("uchar", "red"), ("uchar", "green"), ("uchar", "blue"),
              ("int", "selected"), ("double", "weight")]


def values(i, p):
    return (*p, 0.5, 0.25, 1, i * 40 % 256, 128, 255 - i, i % 2, 0.5 + i)


def ply_header(form, mesh, properties=(), faces="element face {}\nproperty list uchar int vertex_indices\n"):
    return (f"ply\nformat {form} 1.0\ncomment seed\nelement vertex {len(mesh[0])}\n"
            + "".join(f"property float {x}\n" for x in "xyz") + "".join(f"property {t} {n}\n" for t, n in properties)
            + faces.format(len(mesh[1])) + "end_header\n")


def ascii_ply(mesh):
    return (ply_header("ascii", mesh, PROPERTIES) + lines(values(i, p) for i, p in enumerate(mesh[0]))
            + lines((len(f), *f) for f in mesh[1]))


def binary_ply(mesh, order, properties=()):
    mark = "<" if order == "little" else ">"
    data = ply_header(f"binary_{order}_endian", mesh, properties).encode()
    for i, p in enumerate(mesh[0]):
        data += struct.pack(mark + "6f3Bid", *values(i, p)) if properties else struct.pack(mark + "3f", *p)
    for f in mesh[1]:
        data += struct.pack(mark + f"B{len(f)}i", len(f), *f)
    return data


FOLDER.mkdir(exist_ok=True)
for old in FOLDER.iterdir():
    if not old.name.startswith("found_"):
        old.unlink()

grid = wave(4)
whole = {"off": off(grid), "obj": obj(grid), "ply": ascii_ply(grid), "stl": ascii_stl(OCTAHEDRON)}

# every verb
seed("off", "a.off b.off", off(OCTAHEDRON))
seed("off_sharpen", "a.off b.ply --gradient-scale 4 --gradient-weight 1e-2 --solver cg", whole["off"])
seed("off_normals", "a.off b.off --signal normal --metric edge-aware", off(OCTAHEDRON, "NOFF", lambda i: (0.1, i, 1)))
seed("off_colors", "a.off b.obj --signal color", off(OCTAHEDRON, "COFF", lambda i: (0.1 * i, 0.5, 1.0, 1)))
seed("off_texture", "a.off b.stl --binary", off(OCTAHEDRON, "STOFF", lambda i: (i, 1 - i)))
seed("off_comments", "a.off b.off --border fixed", "# a comment\nOFF # more\n3 1\n\n0 0 0\n+1 0 0 # and\n0 1e0 0\n3 0 1 2 9 9 9\n")
seed("off_no_keyword", "a.off b.off --solver eigen", "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
seed("off_cube", "a.off b.ply", off(CUBE))
seed("off_hexagon", "a.off b.ply --signal normal-to-position", off(HEXAGON))
seed("off_needles", "a.off b.ply --metric anisotropic --curvature-weight 10", off(NEEDLES))
seed("off_isolated", "a.off b.off --operation denoise", off((OCTAHEDRON[0] + [(5, 5, 5)], OCTAHEDRON[1])))
seed("off_tiny", "a.off b.off --metric preserve-convex", off(([tuple(x * 1e-150 for x in p) for p in grid[0]], grid[1])))
seed("off_huge", "a.off b.stl --metric preserve-concave", off(([tuple(x * 1e150 for x in p) for p in grid[0]], grid[1])))
seed("off_far", "a.off b.off --jet-degree 3 --metric edge-aware", off(([tuple(x + 1e8 for x in p) for p in grid[0]], grid[1])))
seed("off_umbrellas", "a.off b.off --restore-volume", off(TWO_UMBRELLAS))
seed("obj", "a.obj b.obj --operation enhance-details", whole["obj"])
seed("obj_normals", "a.obj b.ply --signal normal --iterations 2",
     obj(OCTAHEDRON, lambda v: f"{v + 1}//{v + 1}", lines(("vn", *p) for p in OCTAHEDRON[0])))
seed("obj_texture", "a.obj b.off --metric edge-aware --curvature normals",
     obj(OCTAHEDRON, lambda v: f"{v + 1}/1/1", "vt 0 0\nvn 0 0 1\ng group\ns off\n"))
seed("obj_negative", "a.obj b.off", obj(OCTAHEDRON, lambda v: str(v - 6)))
seed("obj_colors", "a.obj b.ply --signal color --gradient-scale 3",
     obj(([(*p, 0.1 * i, 1, 0) for i, p in enumerate(OCTAHEDRON[0])], OCTAHEDRON[1])))
seed("obj_edge", "a.obj b.obj", obj(THREE_ON_AN_EDGE))
seed("ply", "a.ply b.ply --ascii --constrain selected --value-weight-property weight", whole["ply"])
seed("ply_region", "a.ply b.ply --region selected --border along-border", ascii_ply(wave(5)))
seed("ply_color", "a.ply b.off --signal color --gradient-scale 9 --gradient-weight 1", whole["ply"])
seed("ply_masks", "a.ply b.ply --gradient-weight-property weight --gradient-scale-property nx", ascii_ply(OCTAHEDRON))
seed("ply_little", "a.ply b.ply --signal curvature", binary_ply(grid, "little"))
seed("ply_big", "a.ply b.obj --operation denoise --passes 2", binary_ply(grid, "big", PROPERTIES))
seed("ply_little_properties", "a.ply b.ply --signal normal-to-position", binary_ply(OCTAHEDRON, "little", PROPERTIES))
seed("ply_cube", "a.ply b.stl --area-normalization off", binary_ply(CUBE, "little"))
strips = ply_header("ascii", (OCTAHEDRON[0], [0]), (), "element tristrips {}\nproperty list int int vertex_indices\n")
seed("ply_strips", "a.ply b.ply", strips + lines(OCTAHEDRON[0]) + "9 0 2 4 1 3 -1 0 5 3\n")
seed("ply_other_elements", "a.ply b.ply --threads 1",
     "ply\nformat ascii 1.0\nelement camera 1\nproperty list uchar float view\nproperty float f\n"
     "element vertex 3\nproperty double x\nproperty double y\nproperty double z\nproperty list uchar int near\n"
     "element face 1\nproperty int part\nproperty list uchar uint vertex_index\nend_header\n"
     "2 0.5 0.5 7\n0 0 0 0\n1 0 0 1 2\n0 1 0 2 0 1\n5 3 0 1 2\n")
seed("stl", "a.stl b.stl", whole["stl"])
seed("stl_binary", "a.stl b.stl --binary --restore-volume", binary_stl(OCTAHEDRON))
seed("stl_binary_grid", "a.stl b.off --metric edge-aware --presmoothing-weight 0", binary_stl(grid))
seed("stream", "- - --keep-normals", off(OCTAHEDRON, "NOFF", lambda i: (0.1, i, 1)))
seed("ply_property", "a.ply b.ply --signal weight,nx --missing-values --non-shrinking 3", ascii_ply(grid).replace("0.5 0.25 1 0", "nan 0.25 1 0"))
seed("ply_axes", "a.ply b.ply --axes z --max-displacement 0.1 --precision double --ascii", binary_ply(grid, "big", PROPERTIES))
seed("ply_no_weld", "a.ply b.off --no-weld --gradient-weight 1e-2", ascii_ply(OCTAHEDRON))
seed("obj_continued", "a.obj b.obj --gradient-weight 1e-2", obj(OCTAHEDRON, lambda v: f"{v + 1}//{v % 2 + 1} \\\n", "vn 0 0 1\nvn 0 1 \\\n0\n# c\\\n"))
seed("off_face_colors", "a.off b.ply --operation denoise --noise-level 0.1 --passes 1",
     off((OCTAHEDRON[0], [(0, 2, 4), (2, 1, 4)])).replace("3 0 2 4", "3 0 2 4 255 0 0").replace("3 2 1 4", "3 2 1 4 0 0 9"))
seed("stl_weld", "a.stl b.stl --weld-tolerance 1e-3 --binary", whole["stl"])
seed("stl_quads", "a.stl b.stl --binary", whole["stl"].replace("endloop", "vertex 1 1 1\nendloop"))
seed("obj_comments", "a.obj b.obj --gradient-weight 1e-3", whole["obj"].replace("\n", "# no space\n"))
seed("off_comments_close", "a.off b.off --gradient-weight 0", off(OCTAHEDRON).replace(" 0\n", " 0#zero\n"))
seed("ply_region_nan", "a.ply b.ply --region selected", ascii_ply(grid).replace("0 0 0.0", "nan 0 0.0"))
seed("ply_strips_unsigned", "a.ply b.ply --binary", (FOLDER / "ply_strips").read_text().split("\n", 1)[1].replace("list int int", "list int uint"))
seed("ply_list_spelling", "a.ply b.ply --gradient-weight 0", "ply\nformat ascii 1.0\nelement vertex 3\nproperty list char int near\n"
     "property float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
     "+1 7 0 0 0\n2.0 7 7 1 0 0\n0.2e1 7 7 0 1 0\n+3.0 0 1 2\n")
seed("ply_beyond_types", "a.ply b.ply --binary", ascii_ply(grid).replace("0 0 0.0", "0 0 1e300"))
seed("ply_list_named_as_new", "a.ply b.ply --signal curvature", "ply\nformat ascii 1.0\nelement vertex 4\nproperty list char int curvature\n"
     "property float x\nproperty float y\nproperty float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
     "0 0 0 0\n0 1 0 0\n0 0 1 0\n0 1 1 1\n3 0 1 2\n3 1 3 2\n")
seed("curvature_overflows", "a.off b.ply --signal curvature",
     off(([tuple(x * 1e-160 for x in p) for p in grid[0]], grid[1])))
seed("off_lines", "a.off b.off --non-manifold along-lines --border fixed --gradient-weight 1e-2", off(THREE_ON_AN_EDGE))
seed("ply_heights", "a.ply b.ply --axes z --missing-values", ascii_ply(grid).replace("1 1 0.299", "1 1 nan").replace("2 1 0.16", "2 1 nan"))
seed("help", "--help", "")

# broken ones
for form, text in whole.items():
    seed(f"cut_{form}", f"a.{form} b.ply", text[:2 * len(text) // 3])
    seed(f"empty_{form}", f"a.{form} b.off", "")
    seed(f"nan_{form}", f"a.{form} b.off --metric edge-aware", text.replace("1 0", "nan 0").replace("0.", "1e400 0."))
seed("cut_ply_binary", "a.ply b.ply", binary_ply(grid, "big")[:-7])
seed("cut_stl_binary", "a.stl b.ply", binary_stl(grid)[:-7])
seed("lie_off", "a.off b.off", "OFF\n4000000000 4000000000 0\n0 0 0\n")
seed("lie_off_face", "a.off b.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n")
seed("lie_ply", "a.ply b.ply", ply_header("binary_little_endian", ([0] * 99999, [0] * 99999)))
seed("lie_ply_list", "a.ply b.ply", ply_header("binary_big_endian", ([0], [0])).replace("uchar int", "uint int") + "\0" * 12 + "\x7f" * 4)
seed("lie_stl", "a.stl b.stl", b" " * 80 + b"\xff" * 4 + bytes(50))
seed("indices_off", "a.off b.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n3 0 -1 2\n")
seed("indices_obj", "a.obj b.off", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\nf 1 -9 99999999999999999999\n")
seed("indices_obj_least", "a.obj b.off", "f -9223372036854775808 -9223372036854775808 -9223372036854775808\n" + whole["obj"])
seed("weights", "a.off b.off --value-weight 0 --gradient-weight 1e308", whole["off"])
seed("usage", "a.off b.stl --signal color --metric round", whole["off"])
