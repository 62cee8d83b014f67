#!/usr/bin/env python3
"""Times gradient_domain_filter as a whole process, beside other programs, and the parts of the package.

usage: run_benchmarks.py --build BUILD [--data FOLDER] [--sizes 81k,173k,656k,947k] [--repetitions 3] [--output results.json]
                         [--peer 'NAME=COMMAND {input} {output}']... [--edge-aware-peer 'NAME=COMMAND {input} {output}']...
                         [--parts] [--part-repetitions 9] [--growth]

BUILD is a build folder with gradient_domain_filter and benchmark_parts (cmake -DCGAL_GDP_BUILD_BENCHMARKS=ON). The meshes are made from
CGAL's data (Debian: package libcgal-demo): remeshed to the size, for growth subdivided, with noise of 0.2 mean edge lengths. Every command
takes its turn in each repetition; medians are printed as a table and written as JSON, which draw_benchmarks.py turns into plots and tables.
The parts are short, and measured in one process: they need more repetitions than whole processes.
"""
import argparse
import datetime
import json
import os
import platform
import shlex
import statistics
import subprocess
import sys
import time

from cgal_data import ARCHIVE, folder_of_meshes

# name: how it is made, of which mesh of CGAL's data. The sizes of the paper's Table 1, and a series of one shape.
MESHES = {"81k": ("make-scan", "bear", 81000), "173k": ("make-scan", "armadillo", 173000),
          "656k": ("make-scan", "ChineseDragon-10kv", 656000), "947k": ("make-scan", "bunny00", 947000)}
GROWTH = {"11k": ("subdivide", "elephant", 1), "44k": ("subdivide", "elephant", 2), "178k": ("subdivide", "elephant", 3),
          "711k": ("subdivide", "elephant", 4), "2.8M": ("subdivide", "elephant", 5), "10.2M": ("subdivide", "ChineseDragon-10kv", 5)}


def make_mesh(build, folder, name, way, source, amount):
    path = os.path.join(folder, name + ".ply")
    if not os.path.exists(path):
        subprocess.run([find(build, "benchmark_parts"), way, os.path.join(folder_of_meshes(ARCHIVE, folder), source + ".off"), path,
                        str(amount)], check=True)
    return path


def find(build, program):
    for folder, _, files in os.walk(build):
        if program in files and os.access(os.path.join(folder, program), os.X_OK):
            return os.path.join(folder, program)
    sys.exit(f"{program} is not in {build}")


def run(command, environment=None):
    """Seconds, CPU seconds and peak megabytes of one process."""
    begin = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, env=environment)
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{shlex.join(command)}: exit {process.returncode}: {errors.decode(errors='replace')[-500:]}")
    return time.perf_counter() - begin, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def number_of_vertices(path):
    with open(path, "rb") as stream:
        return int(next(line for line in stream if line.startswith(b"element vertex")).split()[2])


def compare(size, path, commands, repetitions, folder):
    """The commands in turns; a list of results."""
    times = {name: [] for name in commands}
    for _ in range(repetitions):
        for name, command in commands.items():
            words = [w.format(input=path, output=os.path.join(folder, "output.ply")) for w in shlex.split(command)]
            times[name].append(run(words))
    results = []
    for name, values in times.items():
        result = {"mesh": size, "vertices": number_of_vertices(path), "command": name, "seconds": statistics.median(v[0] for v in values),
                  "cpu_seconds": statistics.median(v[1] for v in values), "megabytes": max(v[2] for v in values)}
        results.append(result)
        print(f"{size:>6} {name:<24} {result['seconds']:9.2f} s {result['cpu_seconds']:9.2f} CPU s {result['megabytes']:9.0f} MB", flush=True)
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True)
    parser.add_argument("--data", default="benchmark_data")
    parser.add_argument("--sizes", default=",".join(MESHES))
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--output", default="results.json")
    parser.add_argument("--peer", action="append", default=[])
    parser.add_argument("--edge-aware-peer", action="append", default=[])
    parser.add_argument("--parts", action="store_true")
    parser.add_argument("--part-repetitions", type=int, default=9)
    parser.add_argument("--growth", action="store_true")
    options = parser.parse_args()
    os.makedirs(options.data, exist_ok=True)

    program = find(options.build, "gradient_domain_filter")
    filter_command = f"{shlex.quote(program)} {{input}} {{output}} --quiet"
    isotropic = {"isotropic": filter_command, **dict(p.split("=", 1) for p in options.peer)}
    edge_aware = {"edge-aware, normals": filter_command + " --metric edge-aware --curvature normals",
                  "edge-aware, jets": filter_command + " --metric edge-aware --curvature jets",
                  **dict(p.split("=", 1) for p in options.edge_aware_peer)}
    report = {"date": datetime.date.today().isoformat(), "machine": platform.machine(), "cores": len(os.sched_getaffinity(0)),
              "processor": next((l.split(":", 1)[1].strip() for l in open("/proc/cpuinfo") if l.startswith("model name")), ""),
              "system": " ".join(platform.freedesktop_os_release().get(k, "") for k in ("NAME", "VERSION_ID")).strip(),
              "version": subprocess.run([program, "--version"], capture_output=True, text=True).stdout.strip(),
              "isotropic": [], "edge_aware": [], "growth": [], "parts": []}

    for size in filter(None, options.sizes.split(",")):
        path = make_mesh(options.build, options.data, size, *MESHES[size])
        report["isotropic"] += compare(size, path, isotropic, options.repetitions, options.data)
        report["edge_aware"] += compare(size, path, edge_aware, options.repetitions, options.data)
        if options.parts:
            parts = [find(options.build, "benchmark_parts")]
            commands = [parts + [part] for part in ("solver", "assembly", "curvature", "reuse", "region", "threads")]
            if os.path.exists(parts[0] + "_mkl"):
                commands.insert(1, [parts[0] + "_mkl", "solver"])
            for command in commands:
                lines = subprocess.run(command + [path, str(options.part_repetitions)], capture_output=True, text=True, check=True).stdout
                report["parts"] += [json.loads(line) for line in lines.splitlines()]
                print(lines, end="", flush=True)
    if options.growth:
        for size, mesh in GROWTH.items():
            path = make_mesh(options.build, options.data, size, *mesh)
            report["growth"] += compare(size, path, {"auto": filter_command, "cg": filter_command + " --solver cg"}, 1, options.data)
    with open(options.output, "w") as stream:
        json.dump(report, stream, indent=1)


if __name__ == "__main__":
    main()
