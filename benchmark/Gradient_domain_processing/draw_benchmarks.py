#!/usr/bin/env python3
# Copyright (c) 2026  The Gradient_domain_processing authors.
#
# This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Turns what run_benchmarks.py wrote into the plots and tables of the manual.

    draw_benchmarks.py RESULTS.json [--output FOLDER]

FOLDER (the manual's, unless named) receives fig/performance.png, fig/threads.png, fig/growth.png and performance_tables.txt. "threads" in
RESULTS is what run_threads.py wrote; "earlier", if it is there, has parts and growth of another machine or day. Debian: python3-matplotlib.
"""

import argparse
import json
import math
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

MANUAL = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../doc/Gradient_domain_processing")
OURS = "#b5482f"
PEERS = ["#9aa7b1", "#5f7180", "#c9b458", "#7d9b76"]


def is_ours(command):
    return command in ("isotropic", "edge-aware, normals", "edge-aware, jets")


def by_mesh(results):
    """{mesh: {command: result}}, in the order of the file."""
    meshes = {}
    for result in results:
        meshes.setdefault(result["mesh"], {})[result["command"]] = result
    return meshes


def draw_performance(report, path):
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.6))
    for axis, (title, results) in zip(axes, (("isotropic", report["isotropic"]), ("edge-aware", report["edge_aware"]))):
        meshes = by_mesh(results)
        commands = list(dict.fromkeys(result["command"] for result in results))
        colors = iter(PEERS)
        width = 0.8 / len(commands)
        shade = 0
        for i, command in enumerate(commands):
            color = OURS if is_ours(command) else next(colors)
            places = [m + (i - (len(commands) - 1) / 2) * width for m, mesh in enumerate(meshes) if command in meshes[mesh]]
            heights = [meshes[mesh][command]["seconds"] for mesh in meshes if command in meshes[mesh]]
            axis.bar(places, heights, width, color=color, alpha=1 - 0.35 * shade if is_ours(command) else 1,
                     label=("this package" + (": " + command.split(", ")[1] if ", " in command else "")) if is_ours(command) else command)
            shade += is_ours(command)
        axis.set_yscale("log")
        axis.set_xticks(range(len(meshes)), [f"{mesh} vertices" for mesh in meshes], fontsize=8)
        axis.set_title(f"{title}: seconds, the whole process", fontsize=10)
        axis.grid(axis="y", color="#dddddd", linewidth=0.6)
        axis.set_axisbelow(True)
        axis.legend(fontsize=7, frameon=False)
        for side in ("top", "right"):
            axis.spines[side].set_visible(False)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


STAGES = {"read": "#c9b458", "validate": "#e0d29a", "curvature": "#7d9b76", "metric": "#b9cbb4", "analyze": "#5f7180", "assemble": "#9aa7b1",
          "factor": "#b5482f", "solve": "#dd9a86", "write": "#8a7a2e"}


def by_command(report):
    """{command: [result]}, by number of threads."""
    commands = {}
    for result in report["threads"]:
        commands.setdefault(result["command"], []).append(result)
    return commands


def draw_threads(report, path):
    commands = by_command(report)
    figure, axes = plt.subplots(1, len(commands), figsize=(11, 3.4))
    for axis, (command, results) in zip(axes, commands.items()):
        places = range(len(results))
        bottom = [0] * len(results)
        for stage, color in STAGES.items():
            heights = [r["seconds"].get(stage, 0) for r in results]
            axis.bar(places, heights, 0.7, bottom, color=color, label=stage)
            bottom = [b + h for b, h in zip(bottom, heights)]
        axis.bar(places, [r["seconds"]["whole"] - b for r, b in zip(results, bottom)], 0.7, bottom, color="#dddddd", label="other")
        axis.set_xticks(places, [r["threads"] for r in results], fontsize=8)
        axis.set_xlabel("threads", fontsize=8)
        axis.set_title(command.replace(", conjugate gradients", ",\nconjugate gradients").replace(", Cholesky", ",\nCholesky"), fontsize=8)
        axis.tick_params(labelsize=8)
        for side in ("top", "right"):
            axis.spines[side].set_visible(False)
    axes[0].set_ylabel("seconds, the whole process", fontsize=8)
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, ncol=len(labels), fontsize=7, frameon=False, loc="lower center")
    figure.tight_layout(rect=(0, 0.06, 1, 1))
    figure.savefig(path, dpi=110)


def threads_table(report):
    commands = by_command(report)
    counts = [r["threads"] for r in next(iter(commands.values()))]
    return table(["threads"] + [str(n) for n in counts],
                 [[command] + [f"{r['seconds']['whole']:.2f}" for r in results] for command, results in commands.items()])


def exponent(points):
    """The slope of a line through the logarithms."""
    xs, ys = [math.log(x) for x, _ in points], [math.log(y) for _, y in points]
    x, y = sum(xs) / len(xs), sum(ys) / len(ys)
    return sum((a - x) * (b - y) for a, b in zip(xs, ys)) / sum((a - x) ** 2 for a in xs)


def growth_series(report, key):
    """{command: [(vertices, value)]} with the exponent of meshes of 40,000 vertices and more, where starting costs no longer count."""
    series = {}
    for result in report["growth"]:
        series.setdefault(result["command"], []).append((result["vertices"], result[key]))
    return {command: (points, exponent([p for p in points if p[0] >= 40000])) for command, points in series.items()}


NAMES = {"auto": "Cholesky while it fits", "cg": "conjugate gradients"}


def draw_growth(report, path):
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.4))
    for axis, (key, unit) in zip(axes, (("seconds", "seconds"), ("megabytes", "peak memory, MB"))):
        for (command, (points, slope)), style in zip(growth_series(report, key).items(), ("o-", "s--")):
            axis.plot(*zip(*points), style, color=OURS if command == "auto" else PEERS[1], label=f"{NAMES[command]}: exponent {slope:.2f}")
        axis.set_xscale("log")
        axis.set_yscale("log")
        axis.set_xlabel("vertices", fontsize=8)
        axis.set_title(unit, fontsize=10)
        axis.grid(color="#dddddd", linewidth=0.6)
        axis.legend(fontsize=8, frameon=False)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def comparison(results):
    """A row a mesh: seconds / MB of every command, and how many times slower a peer is than our first command."""
    meshes = by_mesh(results)
    commands = list(dict.fromkeys(result["command"] for result in results))

    def cell(row, command):
        if command not in row:
            return ""
        text = f"{row[command]['seconds']:.2f} / {row[command]['megabytes']:.0f}"
        ours = [row[c]["seconds"] for c in commands if is_ours(c)]
        return text if is_ours(command) else text + " (" + ", ".join(f"{row[command]['seconds'] / s:.1f}x" for s in ours) + ")"

    return table(["vertices"] + [f"**{c}**" if is_ours(c) else c for c in commands],
                 [[mesh] + [cell(row, c) for c in commands] for mesh, row in meshes.items()])


def parts_table(report):
    rows = []
    for part in report["parts"]:
        n, name = f"{part['vertices']:,}", part["benchmark"]
        if name == "assembly":
            rows.append(["assembly: triplets / one thread / all", n, "{triplets:.3f} / {sequential:.3f} / {parallel:.3f}".format(**part),
                         f"{part['triplets'] / part['sequential']:.1f} and {part['triplets'] / part['parallel']:.1f} times faster"])
        elif name == "curvature":
            rows.append(["curvature by jets: plain loop / one thread / all", n, "{plain_loop:.2f} / {sequential:.2f} / {parallel:.2f}".format(**part),
                         f"{part['plain_loop'] / part['sequential']:.1f} and {part['plain_loop'] / part['parallel']:.1f} times faster; "
                         f"{part['sequential_us_per_vertex']:.1f} us a vertex on one thread"])
        elif name == "reuse":
            rows.append(["first solution / new signal or scale / new weight", n, "{first:.2f} / {new_scale:.3f} / {new_weight:.2f}".format(**part),
                         f"{100 * part['new_scale'] / part['first']:.0f} % and {100 * part['new_weight'] / part['first']:.0f} % of the first"])
        elif name == "region":
            rows.append(["whole mesh / one percent of it", n, "{whole:.2f} / {one_percent:.4f}".format(**part),
                         f"{100 * part['one_percent'] / part['whole']:.1f} %"])
        elif name == "threads_sequential":
            parallel = next(p for p in report["parts"] if p["benchmark"] == "threads_parallel" and p["vertices"] == part["vertices"])
            for stage in ("curvature", "metric", "assemble"):
                rows.append([f"stage `{stage}` of edge-aware smoothing: one thread / all", n, f"{part[stage]:.4f} / {parallel[stage]:.4f}",
                             f"{part[stage] / parallel[stage]:.2f} times faster"])
    return table(["what", "vertices", "seconds", "ratio"], rows)


def stages_table(report):
    stages = ["read", "metric", "analyze", "assemble", "factor", "solve", "write", "total"]
    names = {"solver_default": "CHOLMOD", "solver_eigen": "Eigen", "solver_mkl": "MKL PARDISO"}
    rows = [[f"{p['vertices']:,}", names[p["benchmark"]]] + [f"{p[s]:.3f}" for s in stages]
            + [f"{100 * (p['total'] - p['analyze'] - p['factor'] - p['solve']) / (p['factor'] + p['solve']):.0f} %"]
            for p in report["parts"] if p["benchmark"] in names]
    return table(["vertices", "solver"] + stages + ["overhead"], rows)


def growth_table(report):
    rows = [[f"{r['vertices']:,}", NAMES[r["command"]], f"{r['seconds']:.2f}", f"{r['megabytes']:.0f}"] for r in report["growth"]]
    return table(["vertices", "solver", "seconds", "MB"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results")
    parser.add_argument("--output", default=MANUAL)
    options = parser.parse_args()
    with open(options.results) as stream:
        report = json.load(stream)
    earlier = report.get("earlier", report)
    draw_performance(report, os.path.join(options.output, "fig", "performance.png"))
    draw_threads(report, os.path.join(options.output, "fig", "threads.png"))
    draw_growth(earlier, os.path.join(options.output, "fig", "growth.png"))

    def measured(on):
        return f"{on['processor']}, {on['cores']} cores; {on['version']}; {on['system']}; {on['date']}.<br><br>\n"

    with open(os.path.join(options.output, "performance_tables.txt"), "w") as stream:
        stream.write("Measured on: " + measured(report) + "The whole process, isotropic, seconds / MB (times slower than this package):\n\n"
                     + comparison(report["isotropic"])
                     + "\nThe whole process, edge-aware, seconds / MB (times slower than this package with normals, with jets):\n\n"
                     + comparison(report["edge_aware"])
                     + "\nThe whole process by number of threads, on the same processor, seconds:\n\n" + threads_table(report)
                     + "\n" + ("" if earlier is report else "What follows was measured on: " + measured(earlier))
                     + "The stages of `smooth()`, seconds. Overhead is all but ordering, factorization and solution (so the right-hand side counts), "
                     + "relative to the latter two:\n\n" + stages_table(earlier) + "\nParts, seconds:\n\n" + parts_table(earlier)
                     + "\nGrowth, whole process:\n\n" + growth_table(earlier))


if __name__ == "__main__":
    main()
