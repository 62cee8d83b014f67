#!/usr/bin/env python3
# Copyright (c) 2026  The Gradient_domain_processing authors.
#
# This file is part of Gradient_domain_processing, a package for CGAL (www.cgal.org).
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Times gradient_domain_filter on 1, 2, 4, ... threads, by stage.

    run_threads.py PROGRAM MESH.ply [--repetitions 3] [--threads 1,2,4,8,16] [--only WORD] [--output threads.json]

PROGRAM is gradient_domain_filter. Medians of whole processes are printed and written as JSON, which draw_benchmarks.py turns into a plot. Needs
nothing but Python, so that it can be carried with the program to a machine that has more cores.
"""

import argparse
import datetime
import json
import os
import statistics
import subprocess
import tempfile
import time

COMMANDS = {
    "isotropic, Cholesky": ["--solver", "cholmod"],
    "isotropic, conjugate gradients": ["--solver", "cg"],
    "edge-aware by normals, conjugate gradients": ["--metric", "edge-aware", "--curvature", "normals", "--solver", "cg"],
    "edge-aware by jets, conjugate gradients": ["--metric", "edge-aware", "--curvature", "jets", "--solver", "cg"],
}


def thread_counts():
    counts = [1]
    while 2 * counts[-1] <= os.cpu_count():
        counts.append(2 * counts[-1])
    return counts


def run(program, mesh, arguments, threads, folder):
    """Seconds of the process and of its stages."""
    report = os.path.join(folder, "report.json")
    command = [program, mesh, os.path.join(folder, "output.ply"), "--quiet", "--threads", str(threads), "--report", report] + arguments
    begin = time.perf_counter()
    subprocess.run(command, check=True)
    seconds = time.perf_counter() - begin
    with open(report) as stream:
        return {"whole": seconds, **json.load(stream)["seconds"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("mesh")
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--threads", default=",".join(map(str, thread_counts())))
    parser.add_argument("--only", default="")
    parser.add_argument("--output", default="threads.json")
    options = parser.parse_args()
    counts = [int(n) for n in options.threads.split(",")]
    results = []
    with tempfile.TemporaryDirectory() as folder:
        for name, arguments in COMMANDS.items():
            if options.only not in name:
                continue
            times = {n: [] for n in counts}
            for _ in range(options.repetitions):
                for n in counts:
                    times[n].append(run(options.program, options.mesh, arguments, n, folder))
            for n in counts:
                medians = {stage: statistics.median(t[stage] for t in times[n]) for stage in times[n][0]}
                results.append({"command": name, "threads": n, "seconds": medians})
                print(f"{name:<44} {n:3} threads " + " ".join(f"{stage} {s:.3f}" for stage, s in medians.items() if s > 0.0005), flush=True)
    with open("/proc/cpuinfo") as stream:
        processor = next((line.split(":", 1)[1].strip() for line in stream if line.startswith("model name")), "")
    with open(options.output, "w") as stream:
        json.dump({"date": datetime.date.today().isoformat(), "processor": processor, "cores": os.cpu_count(),
                   "mesh": os.path.basename(options.mesh), "threads": results}, stream, indent=1)


if __name__ == "__main__":
    main()
