#!/usr/bin/env python3
"""Do the tests notice when the headers are wrong? Each mutant is the package with one operator, constant or statement changed;
the tests that are meant for that header shall fail on it.

  mutate.py [--number 40] [--seed 1] HEADER_OR_FOLDER...    relative to include/CGAL/Gradient_domain_processing; default: all

All is compiled in the separate form: the parts of internal/compiled/ and the tests are objects, and a mutant costs those that
include its header. One in an _impl.h costs a part, and its tests are linked anew. Tests are run, those that are meant for the header
first, then the cheapest, until one fails, crashes or takes too long: killed. A test none of whose objects has changed is not run; a mutant
that changes no object at all survives as "same code" (it is equivalent, or nothing instantiates it).

Everything happens in a scratch folder; the sample depends on the seed alone. Needs g++ and the libraries of the tests.
"""

import argparse
import concurrent.futures
import fnmatch
import hashlib
import json
import os
import pathlib
import queue
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
PACKAGE = pathlib.Path("CGAL/Gradient_domain_processing")
TESTS = pathlib.Path("test/Gradient_domain_processing")

# Which tests are meant for which headers: the first pattern that fits. Names that do not exist are passed over.
MEANT_FOR = [
    ("Triangle_metric.h", ["test_operators", "test_analytic", "test_degenerate", "test_bad_values"]),
    ("internal/parallel/*", ["test_threads", "test_operators"]),
    ("internal/linear_solver/ordering/*", ["test_elimination_order", "test_linear_solvers"]),
    ("internal/linear_solver/multigrid/*", ["test_conjugate_gradient"]),
    ("Conjugate_gradient_solver_traits.h", ["test_conjugate_gradient"]),
    ("internal/linear_solver/*", ["test_linear_solvers", "test_shared_solvers", "test_solver_reuse", "test_threads"]),
    ("internal/curvature/[Jj]et*", ["test_jet_curvature", "test_curvature"]),
    ("internal/curvature/Ring_collector.h", ["test_jet_curvature", "test_curvature"]),
    ("internal/curvature/*", ["test_curvature", "test_edge_aware", "test_jet_curvature"]),
    ("internal/metric/*", ["test_edge_aware", "test_curvature", "test_operators", "test_references"]),
    ("internal/mesh/*", ["test_read_mesh", "test_volume", "test_regions", "test_bad_values", "test_mesh_types"]),
    ("internal/energy/target_field/*", ["test_stitch", "test_fit", "test_references"]),
    ("internal/energy/border*", ["test_borders"]),
    ("internal/energy/*", ["test_operators", "test_analytic", "test_constraints", "test_masks", "test_borders", "test_references"]),
    ("internal/denoising/*", ["test_denoise", "test_range_scan"]),
    ("internal/filtering/*", ["test_references", "test_regions", "test_signals", "test_volume", "test_bad_values"]),
    ("denoise.h", ["test_denoise", "test_range_scan"]),
    ("stitch.h", ["test_stitch"]),
    ("fit_to_*.h", ["test_fit", "test_reference_fits"]),
    ("*curvature*.h", ["test_curvature", "test_jet_curvature", "test_edge_aware"]),
    ("*_matrix.h", ["test_operators", "test_reference_operators"]),
    ("operators.h", ["test_operators", "test_reference_operators"]),
    ("Signal_traits.h", ["test_signals"]),
    ("visitor.h", ["test_signals", "test_solver_reuse"]),
    ("Gradient_domain_solver.h", ["test_solver_reuse", "test_constraints", "test_masks", "test_bad_values", "test_regions"]),
]
NEVER = {"test_filter_program"}  # needs the command line built
PARTS = "CGAL/Gradient_domain_processing/internal/compiled"

OPERATORS = {
    "+": "-", "-": "+", "*": "/", "/": "*", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=", "<": "<=", "<=": "<", ">": ">=",
    ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&", "++": "--", "--": "++", "%": "*",
}
WORDS = {"true": "false", "false": "true", "min": "max", "max": "min", "sin": "cos", "sqrt": "cbrt"}
TOKEN = re.compile(r"""
    (?P<skip> //[^\n]* | /\*.*?\*/ | ^[ \t]*\#(?:\\\n|[^\n])* | "(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])*' | \[\[.*?\]\])
  | (?P<number> (?<![\w.]) (?:0x[0-9a-fA-F]+ | (?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?) [uUlLfF]* (?![\w.]))
  | (?P<word> [A-Za-z_]\w*)
  | (?P<operator> <<=|>>=|<=>|->|::|<<|>>|\+\+|--|[-+*/%<>=!&|]=|&&|\|\||[-+*/%<>!])
""", re.VERBOSE | re.MULTILINE | re.DOTALL)
STATEMENT = re.compile(r"^[ \t]+(?P<statement>(?!return\b|using\b|typedef\b|static_assert\b|const\b|auto\b|CGAL_\w*assert)"
                       r"(?:continue|break|[A-Za-z_][\w.\[\]>()\-]*(?:\s*[-+*/|&]?=[^=][^;{}]*|\([^;{}]*\)|\+\+))\s*;)[ \t]*(?://.*)?$",
                       re.MULTILINE)


def changed_number(text):
    digits = text.rstrip("uUlLfF")
    suffix = text[len(digits):]
    if re.fullmatch(r"\d+", digits):
        return str(int(digits) + 1 if len(digits) == 1 else 2 * int(digits)) + suffix
    if digits.startswith("0x"):
        return hex(int(digits, 16) + 1) + suffix
    return repr(2 * float(digits) if float(digits) else 1.0) + suffix


def mutants_of(text):
    """(begin, end, replacement) of every change, in the order of the text."""
    found = []
    for m in TOKEN.finditer(text):
        old, new = m.group(), None
        before, after = text[m.start() - 1], text[m.end():m.end() + 1]
        line = text[text.rfind("\n", 0, m.start()) + 1:m.end()]
        if m.lastgroup == "skip" or re.match(r"\s*(CGAL_\w*assert|static_assert|template\b|using\b|typedef\b)", line):
            continue
        if m.lastgroup == "number":
            new = changed_number(old)
        elif m.lastgroup == "word":
            new = WORDS.get(old)
        elif old == "!":
            new = ""
        elif old in ("<", ">", "*", "/", "&&", "||", "==", "!=", "<=", ">=", "%") or old.endswith("="):
            # Operators have spaces around them here; template arguments, pointers and references do not.
            new = OPERATORS.get(old) if before == " " and after == " " else None
        elif old in ("+", "-"):
            is_binary = before == " " and after == " "
            new = OPERATORS[old] if is_binary or old == "+" else ""
        elif old in ("++", "--"):
            new = OPERATORS[old]
        if new is not None:
            found.append((m.start(), m.end(), new))
    for m in STATEMENT.finditer(text):
        if ".reserve(" in m.group():
            continue  # only time
        found.append((m.start("statement"), m.end("statement"), ";"))
    for m in re.finditer(r"\bif\((?!\s*const\b)", text):  # if(x) becomes if(!(x)), up to the closing parenthesis
        depth, end = 1, m.end()
        while end < len(text) and depth:
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            end += 1
        condition = text[m.end():end - 1]
        if ";" not in condition and " = " not in condition:
            found.append((m.end(), end - 1, "!(" + condition + ")"))
    return sorted(set(found))


def limit_memory():
    """Loops without an end may allocate."""
    resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


class Workshop:
    """The scratch folder, the compiler and what is known of every test without a mutation."""

    def __init__(self, arguments):
        self.folder = pathlib.Path(arguments.scratch or tempfile.mkdtemp(prefix="mutation-"))
        self.arguments = arguments
        # How the copies are called shows in no object file: every worker compiles in a folder of its own, by relative paths.
        self.workers = queue.Queue()
        for i in range(arguments.jobs):
            worker = self.folder / f"worker{i}"
            shutil.rmtree(worker, ignore_errors=True)
            shutil.copytree(ROOT / "include", worker / "include")
            shutil.copytree(ROOT / TESTS, worker / "test")
            self.workers.put(worker)
        self.first = self.folder / "worker0"
        self.flags = ["-std=c++17", "-" + arguments.optimization, "-DNDEBUG", "-D_GLIBCXX_ASSERTIONS", "-w", "-Iinclude", "-DCGAL_EIGEN3_ENABLED",
                      "-DCGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED", "-isystem", arguments.eigen]
        self.libraries = ["-lgmp", "-lmpfr", "-ldl", "-lpthread"]
        if pathlib.Path("/usr/include/suitesparse/cholmod.h").exists():
            self.flags += ["-isystem", "/usr/include/suitesparse", "-DCGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD"]
            self.libraries += ["-lcholmod", "-lopenblas"]
        if pathlib.Path("/usr/include/tbb/blocked_range.h").exists():
            self.flags += ["-DCGAL_LINKED_WITH_TBB"]
            self.libraries += ["-ltbb", "-ltbbmalloc"]
        self.foreign = self.folder / "foreign.h"
        self.foreign.write_text("".join(f"#include <{h}>\n" for h in (
            "CGAL/Eigen_solver_traits.h", "CGAL/Monge_via_jet_fitting.h", "CGAL/Simple_cartesian.h", "CGAL/Surface_mesh.h",
            "Eigen/SparseCholesky", "iostream")))
        self.run([arguments.compiler, *self.flags, "-x", "c++-header", str(self.foreign), "-o", str(self.foreign) + ".gch"],
                 self.first, check=True)
        self.objects = self.folder / "objects"
        self.objects.mkdir(exist_ok=True)
        self.baseline = {}
        self.parts = {}
        for part in sorted((ROOT / "include" / PARTS).glob("*.h")):
            for worker in list(self.workers.queue):
                (worker / f"{part.stem}.cpp").write_text(f"#include <{PARTS}/{part.name}>\n")
            self.parts[part.stem] = self.keep(part.stem, f"{part.stem}.cpp")
            if self.parts[part.stem] is None:
                sys.exit(f"mutate.py: {part.name} does not compile")

    @staticmethod
    def run(command, folder, timeout=None, check=False, limit=None):
        result = subprocess.run(command, cwd=folder, timeout=timeout, check=check, preexec_fn=limit,
                                stdout=subprocess.DEVNULL, stderr=None if check else subprocess.DEVNULL)
        return result.returncode == 0

    def compile(self, worker, name, source):
        """The hash of the object file and the headers it was made of, or None."""
        if not self.run([self.arguments.compiler, *self.flags, "-include", str(self.foreign), "-MMD", "-MF", f"{name}.d",
                         "-c", source, "-o", f"{name}.o"], worker):
            return None
        headers = {h.split(str(PACKAGE) + "/")[1] for h in (worker / f"{name}.d").read_text().split() if str(PACKAGE) + "/" in h}
        return {"object": hashlib.sha256((worker / f"{name}.o").read_bytes()).hexdigest(), "headers": headers}

    def keep(self, name, source):
        """Compiles what the headers as they are make of a source."""
        known = self.compile(self.first, name, source)
        if known is not None:
            shutil.move(self.first / f"{name}.o", self.objects / f"{name}.o")
        return known

    def changed(self, worker, name, source, known, header):
        """Whether the object of a source is another one now, or None if it does not compile."""
        if header not in known["headers"]:
            return False
        now = self.compile(worker, name, source)
        return None if now is None else now["object"] != known["object"]

    def passes(self, worker, test, timeout, changed=()):
        objects = [str((worker if name in changed else self.objects) / f"{name}.o") for name in (test, *self.parts)]
        if not self.run([self.arguments.compiler, *objects, "-o", test, *self.libraries], worker):
            return False
        try:
            return self.run([str(worker / test)], worker / "test", timeout, limit=limit_memory)
        except subprocess.TimeoutExpired:
            return False
        finally:
            (worker / test).unlink()

    def learn(self, test):
        """Compiles and runs a test on the headers as they are."""
        start = time.monotonic()
        known = self.keep(test, f"test/{test}.cpp")
        compiled = time.monotonic()
        if known is None or not self.passes(self.first, test, None):
            print(f"{test} does not pass without a mutation: left out", file=sys.stderr)
            return
        end = time.monotonic()
        self.baseline[test] = {**known, "compile": compiled - start, "run": end - compiled, "timeout": 10 + 10 * (end - compiled)}
        print(f"{test}: compiled in {compiled - start:.0f} s, run in {end - compiled:.1f} s", flush=True)

    def cost(self, test, header):
        """What it takes to ask a test about a mutant of a header."""
        known = self.baseline[test]
        return known["run"] + (known["compile"] if header in known["headers"] else 0)


def tests_of(header, arguments):
    """Names of the tests that are meant for a header given relative to the package, and those of the others that are asked."""
    existing = {p.stem for p in (ROOT / TESTS).glob("test_*.cpp")} - NEVER
    if arguments.tests:
        return arguments.tests, []
    meant = []
    for pattern, tests in MEANT_FOR:
        if fnmatch.fnmatchcase(header, pattern):
            meant = [t for t in tests if t in existing]
            break
    return meant, [] if meant and arguments.meant else sorted(existing - set(meant))


def judge(workshop, mutant, tests):
    header, begin, end, replacement = mutant
    worker = workshop.workers.get()
    path = worker / "include" / PACKAGE / header
    original = path.read_text()
    try:
        path.write_text(original[:begin] + replacement + original[end:])
        changed = set()
        for part, known in workshop.parts.items():
            is_changed = workshop.changed(worker, part, f"{part}.cpp", known, header)
            if is_changed is None:
                return "does not compile", part
            if is_changed:
                changed.add(part)
        has_parts_changed, is_any_changed = bool(changed), bool(changed)
        for test in tests:
            is_changed = workshop.changed(worker, test, f"test/{test}.cpp", workshop.baseline[test], header)
            if is_changed is None:
                return "does not compile", test
            if not (is_changed or has_parts_changed):
                continue
            is_any_changed = True
            if not workshop.passes(worker, test, workshop.baseline[test]["timeout"], changed | ({test} if is_changed else set())):
                return "killed", test
        return ("survived", "") if is_any_changed else ("same code", "")
    finally:
        path.write_text(original)
        workshop.workers.put(worker)


def described(mutant):
    header, begin, end, replacement = mutant
    text = (ROOT / "include" / PACKAGE / header).read_text()
    line = text.count("\n", 0, begin) + 1
    first, last = text.rfind("\n", 0, begin) + 1, text.find("\n", end)
    old = " ".join(text[begin:end].split())
    return f"{header}:{line}: `{old}` -> `{replacement}` in: {' '.join(text[first:last].split())}"


def sample(arguments):
    folder = ROOT / "include" / PACKAGE
    headers = []
    for name in arguments.headers or ["."]:
        path = folder / name
        if not path.exists():
            sys.exit(f"mutate.py: no {path}")
        headers += sorted(path.rglob("*.h")) if path.is_dir() else [path]
    mutants = [(str(h.relative_to(folder)), *m) for h in dict.fromkeys(headers) for m in mutants_of(h.read_text())]
    if arguments.number and arguments.number < len(mutants):
        mutants = sorted(random.Random(arguments.seed).sample(mutants, arguments.number))
    return mutants


def print_table(results):
    kinds = ["killed", "survived", "same code", "does not compile"]
    rows = {}
    for mutant, (kind, _) in results:
        for name in (mutant[0], "all"):
            rows.setdefault(name, dict.fromkeys(kinds, 0))[kind] += 1
    print(f"\n{'header':60}" + "".join(f"{k:>18}" for k in kinds) + "     share killed")
    for name in sorted(rows, key=lambda n: (n == "all", n)):
        alive = rows[name]["survived"] + rows[name]["same code"]
        judged = rows[name]["killed"] + alive
        share = f"{100 * rows[name]['killed'] / judged:.0f} %" if judged else "-"
        print(f"{name:60}" + "".join(f"{rows[name][k]:18}" for k in kinds) + f"{share:>17}")
    print("\nAlive:")
    for mutant, (kind, _) in results:
        if kind in ("survived", "same code"):
            print(f"  {kind}: {described(mutant)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("headers", nargs="*")
    parser.add_argument("--number", type=int, default=0, help="size of the sample; 0: every mutant")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--tests", nargs="+", help="these tests in place of those that are meant for a header")
    parser.add_argument("--meant", action="store_true", help="only the tests that are meant for a header, where there are any")
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--optimization", default="O1")
    parser.add_argument("--eigen", default="/usr/include/eigen3")
    parser.add_argument("--scratch", help="folder to work in, kept; by default a temporary one that is removed")
    parser.add_argument("--list", action="store_true", help="print the sample and stop")
    parser.add_argument("--report", help="file for the results as JSON")
    arguments = parser.parse_args()

    mutants = sample(arguments)
    tests = {header: tests_of(header, arguments) for header in {m[0] for m in mutants}}
    if arguments.list:
        for mutant in mutants:
            print(described(mutant), "|", ", ".join(tests[mutant[0]][0]))
        return
    workshop = Workshop(arguments)
    try:
        for test in sorted({t for groups in tests.values() for names in groups for t in names}):
            workshop.learn(test)
        for header, groups in tests.items():
            tests[header] = [t for names in groups
                             for t in sorted((t for t in names if t in workshop.baseline), key=lambda t: workshop.cost(t, header))]
        results = []
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
            futures = [pool.submit(judge, workshop, m, tests[m[0]]) for m in mutants]
            for mutant, future in zip(mutants, futures):
                results.append((mutant, future.result()))
                print(f"[{len(results)}/{len(mutants)}] {' by '.join(filter(None, results[-1][1]))}: {described(mutant)}", flush=True)
    finally:
        if not arguments.scratch:
            shutil.rmtree(workshop.folder, ignore_errors=True)
    print_table(results)
    if arguments.report:
        pathlib.Path(arguments.report).write_text(json.dumps(
            [{"mutant": described(m), "verdict": k, "test": t} for m, (k, t) in results], indent=1) + "\n")


if __name__ == "__main__":
    main()
