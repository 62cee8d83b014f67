#!/usr/bin/env python3
"""Do the tests notice when the headers are wrong? Each mutant is the package with one operator, constant, condition or statement
changed; some test shall fail on it.

  mutate.py --scratch FOLDER [--hold 700] [--seed 1] [--first 0] [--number 250] [HEADER_OR_FOLDER...]

One build holds all mutants of a sample (mutants.h), of which the environment chooses one when a test runs. A test that passes without
tells which mutants it reaches, and is asked about these only: the cheapest tests first, until one fails, crashes or takes more than 3 s
and five times the time of the processor that it usually takes. A mutant that no test reaches is alive. The sample is the beginning of a
random order of all changes there are in the headers (default: all of include/); a change that does not compile there, in a constant
expression say, is passed over and counted. Of the mutants that are held, --number are judged from --first on: so a build serves to
sharpen the tests on one sample and to judge them by another, which is fresh. --no-judge and --no-build let both go on side by side.

The scratch folder keeps what is known, and the headers as they were: called again, only tests that changed are compiled, and asked
about the survivors. Where headers changed too, take a new one. All compiles in about an hour of one processor. Needs g++, prlimit, the
libraries of the tests, and 2 GB of memory. The test that needs the command line is not asked. Out-of-bounds indices of containers are
found by the standard library's assertions, as the sanitizers find them in continuous integration.

Known so far, from a pass that was not finished (35 of 45 tests built; those above 7 s, and those sharpened last, not asked about all):
of the first 250 of seed 1, on which tests were sharpened, 198 are killed; of the next 150, at least 103.
"""

import argparse
import collections
import hashlib
import json
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import threading
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
TESTS = ROOT / "test/Gradient_domain_processing"
PARTS = "CGAL/Gradient_domain_processing/internal/compiled"
NEVER = {"test_filter_program"}  # needs the command line

BINARY = {"+": "plus", "-": "minus", "*": "times", "/": "divided", "%": "modulo", "<": "less", "<=": "less_equal", ">": "greater",
          ">=": "greater_equal", "==": "equal", "!=": "not_equal", "+=": "add", "-=": "subtract", "*=": "multiply", "/=": "divide"}
OTHER = {"+": "-", "-": "+", "*": "/", "/": "*", "%": "*", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==",
         "&&": "||", "||": "&&", "++": "--", "--": "++", "(std::min)": "max", "(std::max)": "min", "std::sqrt": "cbrt", "std::sin": "cos",
         "true": "false", "false": "true", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}
TOKEN = re.compile(r"""
    (?P<skip> //[^\n]* | /\*.*?\*/ | ^[ \t]*\#(?:\\\n|[^\n])* | "(?:\\.|[^"\\\n])*" | '(?:\\.|[^'\\\n])*' | \[\[.*?\]\]
            | \boperator\s*[^\s\w(]+)
  | (?P<number> (?<![\w.]) (?:0x[0-9a-fA-F]+ | (?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?) [uUlLfF]* (?![\w.]))
  | (?P<call> \(std::(?:min|max)\)(?=\() | std::(?:sqrt|sin)(?=\())
  | (?P<word> [A-Za-z_]\w*)
  | (?P<operator> <<=|>>=|<=>|->|::|<<|>>|\+\+|--|[-+*/%<>=!&|]=|&&|\|\||[-+*/%<>!])
""", re.VERBOSE | re.MULTILINE | re.DOTALL)
STATEMENT = re.compile(r"^[ \t]+(?P<statement>(?!return\b|if\b|for\b|while\b|using\b|typedef\b|static_assert\b|const\b|auto\b|CGAL_\w*assert)"
                       r"(?:continue|break|[A-Za-z_][\w.\[\]>()\-]*(?:\s*[-+*/|&]?=[^=][^;{}]*|\([^;{}]*\)|\+\+))\s*;)[ \t]*(?://.*)?$",
                       re.MULTILINE)
LOCATION = re.compile(r"^(?:In file included from |\s+from )?include/(\S+?):(\d+)(?::(\d+))?[:,]", re.MULTILINE)

Mutant = collections.namedtuple("Mutant", "header position kind old new edits")  # edits: begin, end, rank, text with @ for the number


def changed_number(text):
    digits = text.rstrip("uUlL" if text.startswith("0x") else "uUlLfF")
    suffix = text[len(digits):]
    if re.fullmatch(r"\d+", digits):
        return str(int(digits) + 1 if len(digits) == 1 else 2 * int(digits)) + suffix
    if digits.startswith("0x"):
        return hex(int(digits, 16) + 1) + suffix
    return repr(2 * float(digits) if float(digits) else 1.0) + suffix


def operand(text, position, step, stops):
    """How far the operand beside a logical operator reaches; comments in the text are blanks."""
    depth, i = 0, position
    opening, closing = ("([{", ")]}") if step > 0 else (")]}", "([{")
    while 0 <= i < len(text):
        if text[i] in opening:
            depth += 1
        elif text[i] in closing:
            if depth == 0:
                break
            depth -= 1
        elif depth == 0:
            if text[i] in ";,?" or (text[i] == ":" and ":" not in (text[i - 1], text[i + 1])):
                break
            if (text[i] == "=" and text[i + 1] != "=" and text[i - 1] not in "=<>!") or text[min(i, i + step):][:2] in stops:
                break
            if text[i] == "n" and re.search(r"\breturn$", text[max(0, i - 7):i + 1]):
                break
        i += step
    piece = text[position:i] if step > 0 else text[i + 1:position]
    return position + len(piece.rstrip()) if step > 0 else position - len(piece.lstrip())


def mutants_of(header, text):
    found, masked = [], list(text)

    def add(kind, begin, end, new, edits):
        found.append(Mutant(header, begin, kind, " ".join(text[begin:end].split()), new, edits))

    for m in TOKEN.finditer(text):
        if m.lastgroup == "skip":
            masked[m.start():m.end()] = [c if c == "\n" else " " for c in m.group()]
    masked = "".join(masked)
    for m in TOKEN.finditer(text):
        old, begin, end = m.group(), m.start(), m.end()
        before, after = text[begin - 1], text[end:end + 1]
        line = text[text.rfind("\n", 0, begin) + 1:end]
        if m.lastgroup == "skip" or re.match(r"\s*(CGAL_\w*assert|static_assert|template\b|using\b|typedef\b)", line):
            continue
        spaced = before == " " and after in " \n"
        if m.lastgroup == "number":
            if not re.match(r"(, \w+)*>", text[end:]):  # no template argument
                new = changed_number(old)
                add("number", begin, end, new, [(begin, end, 2, f"::gdp_mutants::literal(@, {old}, {new})")])
        elif old in ("true", "false"):
            add("number", begin, end, OTHER[old], [(begin, end, 2, f"::gdp_mutants::literal(@, {old}, {OTHER[old]})")])
        elif m.lastgroup == "call":
            name = old.strip("()").split("::")[1]
            add("function", begin, end, OTHER[old], [(begin, end, 2, f"::gdp_mutants::{name}{{@}}")])
        elif old in ("&&", "||") and spaced:
            left = operand(masked, begin - 1, -1, ["||"] if old == "&&" else [])
            right = operand(masked, end, 1, ["&&", "||"] if old == "&&" else ["||"])
            on = "(::gdp_mutants::on(@) != bool("
            add("logic", begin, end, OTHER[old], [(left, left, (1, -right), on * 2), (begin, end, 2, ")) && " + on if old == "&&" else
                                                  ")) || " + on), (right, right, (0, -left), "))))")])
        elif old in BINARY and spaced and text[begin - 2] != ">":
            add("operator", begin, end, OTHER[old], [(begin, end, 2, f"{old} ::gdp_mutants::{BINARY[old]}{{@}} {old}")])
        elif old == "!":
            add("operator", begin, end, "", [(begin, end, 2, "::gdp_mutants::negation{@}->*")])
        elif old == "-" and not after.isspace():
            add("operator", begin, end, "", [(begin, end, 2, "::gdp_mutants::opposite{@}->*")])
        elif old in ("++", "--"):
            name = "increment" if old == "++" else "decrement"
            if re.match(r"[\w(*]", after):
                add("operator", begin, end, OTHER[old], [(begin, end, 2, f"::gdp_mutants::{name}{{@}}->*")])
            elif not re.search(r"\*[\w.]*$", line[:-2]):
                add("operator", begin, end, OTHER[old], [(begin, end, 2, f"->*::gdp_mutants::post_{name}{{@}}")])
    for m in STATEMENT.finditer(masked):
        begin, end = m.span("statement")
        if ".reserve(" not in m.group() and re.search(r"([;{})]|\belse|[^:]:)\s*$", masked[:begin]):  # reserve() takes time only
            add("statement", begin, end, "", [(begin, begin, (1, -end), "if(::gdp_mutants::on(@)) ; else ")])
    for m in re.finditer(r"\bif\((?!\s*const\b)", masked):
        begin, end = m.end(), operand(masked, m.end(), 1, [])
        condition = masked[begin:end]
        if masked[end:end + 1] == ")" and " = " not in condition:
            add("condition", begin, end, "not", [(begin, begin, (1, -end - 1), "::gdp_mutants::on(@) != bool("), (end, end, (0, -begin + 1), ")")])
    return found


class Workshop:
    """The scratch folder: mutated headers, objects, programs, and what is known of mutants and tests."""

    def __init__(self, arguments):
        self.folder = pathlib.Path(arguments.scratch).resolve()
        self.include, self.test = self.folder / "include", self.folder / "test"
        if not (self.folder / "originals").exists():
            shutil.copytree(ROOT / "include", self.folder / "originals")
        self.originals = {str(p.relative_to(self.folder / "originals")): p.read_text()
                          for p in sorted((self.folder / "originals").rglob("*.h"))}
        names = [n for n in self.originals if "/compiled/" not in n and
                 (not arguments.headers or any(str(ROOT / "include" / n).startswith(str(pathlib.Path(h).resolve())) for h in arguments.headers))]
        self.order = [m for n in names for m in mutants_of(n, self.originals[n])]
        random.Random(arguments.seed).shuffle(self.order)
        self.held = self.order[:arguments.hold or None]
        self.state = {"key": hashlib.sha256(json.dumps([self.held, sorted(self.originals.items())]).encode()).hexdigest(), "dropped": {},
                      "objects": {}, "reached": {}, "seconds": {}}
        self.verdicts = {"asked": {}, "killed": {}}
        self.flags = ["-std=c++17", "-O1", "-DNDEBUG", "-D_GLIBCXX_ASSERTIONS", "-w", "-frounding-math", "-Iinclude", "-DCGAL_EIGEN3_ENABLED",
                      "-isystem", arguments.eigen]
        self.libraries = ["-lgmp", "-lmpfr", "-ldl", "-lpthread"]
        if pathlib.Path("/usr/include/suitesparse/cholmod.h").exists():
            self.flags += ["-isystem", "/usr/include/suitesparse", "-DCGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD"]
            self.libraries += ["-lcholmod", "-lopenblas"]
        if pathlib.Path("/usr/include/tbb/blocked_range.h").exists():
            self.flags += ["-DCGAL_LINKED_WITH_TBB"]
            self.libraries += ["-ltbb", "-ltbbmalloc"]
        self.separate = "-DCGAL_GRADIENT_DOMAIN_PROCESSING_COMPILED"
        self.compiler = arguments.compiler
        self.open()

    def open(self):
        known = self.folder / "state.json"
        if known.exists():
            state = json.loads(known.read_text())
            if state["key"] != self.state["key"]:
                sys.exit("mutate.py: the scratch folder is of another sample")
            self.state = state
        if (self.folder / "verdicts.json").exists():
            self.verdicts = json.loads((self.folder / "verdicts.json").read_text())

    def prepare(self):
        shutil.copytree(TESTS, self.test, dirs_exist_ok=True)
        for name in self.originals:
            self.write(name)
        shutil.copy(HERE / "mutants.h", self.folder)
        (self.folder / "main.cpp").write_text(
            "#include <cstdio>\n#include <cstdlib>\nnamespace gdp_mutants {\nextern int chosen;\nextern unsigned char reached[];\n"
            f"int chosen = -1;\nunsigned char reached[{len(self.held)} + 1];\n"
            '__attribute__((constructor(101))) void read() { if(const char* c = std::getenv("GDP_MUTANT")) chosen = std::atoi(c); }\n'
            '__attribute__((destructor(101))) void note() { if(const char* c = std::getenv("GDP_REACHED"))\n'
            '  if(FILE* f = std::fopen(c, "wb")) { std::fwrite(reached, 1, sizeof reached, f); std::fclose(f); } }\n}\n')
        self.run([self.compiler, "-c", "main.cpp"], check=True)
        (self.folder / "foreign.h").write_text("".join(f"#include <{h}>\n" for h in (
            "CGAL/Eigen_solver_traits.h", "CGAL/Monge_via_jet_fitting.h", "CGAL/Simple_cartesian.h", "CGAL/Surface_mesh.h",
            "Eigen/SparseCholesky", "iostream")) + '#include "mutants.h"\n')
        for suffix, more in (("_whole", []), ("_separate", [self.separate])):
            if not (self.folder / f"foreign{suffix}.h.gch").exists():
                shutil.copy(self.folder / "foreign.h", self.folder / f"foreign{suffix}.h")
                self.run([self.compiler, *self.flags, *more, "-x", "c++-header", f"foreign{suffix}.h"], check=True)

    def run(self, command, check=False):
        return subprocess.run(command, cwd=self.folder, check=check, capture_output=not check, text=True)

    def save(self):
        (self.folder / "state.json.new").write_text(json.dumps(self.state))
        (self.folder / "state.json.new").rename(self.folder / "state.json")

    def write(self, name):
        """The header with its mutants that are not dropped; where they are in it goes to self.places."""
        self.places = getattr(self, "places", {})
        text, edits = self.originals[name], []
        for i, m in enumerate(self.held):
            if m.header == name and str(i) not in self.state["dropped"]:
                edits += [(b, e, r if isinstance(r, tuple) else (r, 0), t.replace("@", str(i)), i if b >= m.position else None)
                          for b, e, r, t in m.edits]
        out, at, places = [], 0, []
        for begin, end, _, replacement, i in sorted(edits, key=lambda x: (x[0], x[2])):
            out += [text[at:begin], replacement]
            at = end
            if i is not None:
                done = "".join(out)
                places.append((done.count("\n") + 1, len(done) - done.rfind("\n"), i))
                out = [done]
        mutated = "".join(out) + text[at:]
        lines = mutated.split("\n")  # numbers that are mutated are no constant expressions
        for line in {line for line, _, _ in places}:
            lines[line - 1] = re.sub(r"^(\s*)(constexpr|CGAL_GDP_CONSTANT) (?=(double|float|int|std::\w+) \w+ = )", r"\1static const ", lines[line - 1])
        path = self.include / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("\n".join(lines))
        self.places[name] = places

    def compile(self, source, name, is_separate=True):
        """Compiles, dropping mutants until it succeeds."""
        while True:
            result = self.run([self.compiler, *self.flags, *([self.separate] if is_separate else []), "-include",
                               "foreign_separate.h" if is_separate else "foreign_whole.h", "-c", source, "-o", f"{name}.o"])
            if result.returncode == 0:
                return
            blamed = self.blame(result.stderr)
            if not blamed:
                (self.folder / "errors.txt").write_text(result.stderr)
                sys.exit(f"mutate.py: {source} does not compile, and no mutant is to blame: {self.folder / 'errors.txt'}")
            print(f"  {name}: {len(blamed)} mutants cannot be made", flush=True)
            for i, message in blamed.items():
                self.state["dropped"][str(i)] = message
            for header in {self.held[i].header for i in blamed}:
                self.write(header)
            self.save()

    def blame(self, errors):
        """The mutant nearest to every error: at its place, where it was instantiated, or what its notes point at."""
        lines, blamed, context, pending = errors.split("\n"), {}, [], None
        for line in lines + ["x: error: "]:
            is_error = " error: " in line
            if is_error:
                if pending:
                    blamed.update(self.nearest(pending))
                pending, context = ([line] + context if line != "x: error: " else None), []
            elif " note: " in line and pending:
                pending.append(line)
            elif "required from" in line or "In instantiation" in line or "required by" in line:
                context.append(line)
            if is_error and pending and self.nearest(pending):
                blamed.update(self.nearest(pending))
                pending = None
        return blamed

    def nearest(self, lines):
        for text in lines:
            m = LOCATION.match(text)
            here = [p for p in self.places.get(m[1], []) if p[0] == int(m[2])] if m else []
            if here:
                return {min(here, key=lambda p: abs(p[1] - int(m[3] or 0)))[2]: lines[0].split(" error: ")[1][:150]}
        return {}

    def build_parts(self):
        self.parts = []
        for part in sorted((ROOT / "include" / PARTS).glob("*.h")):
            self.parts.append(f"part_{part.stem}.o")
            if not (self.folder / self.parts[-1]).exists():
                print(f"part {part.stem}", flush=True)
                (self.folder / f"{part.stem}.cpp").write_text(f"#include <{PARTS}/{part.name}>\n")
                self.compile(f"{part.stem}.cpp", f"part_{part.stem}")

    def source_key(self, path):
        """A hash of a source and what it includes of the test folder."""
        text = path.read_text()
        included = [self.test / n for n in re.findall(r'#include "(\w+\.h)"', text)]
        return hashlib.sha256((text + "".join(self.source_key(p) for p in included)).encode()).hexdigest()

    def build(self, test, is_separate):
        """Compiles a test and runs it without a mutation, unless it is known."""
        key = self.source_key(self.test / f"{test}.cpp")
        if self.state["objects"].get(test) == key:
            return
        start = time.monotonic()
        self.compile(f"test/{test}.cpp", test, is_separate)
        self.run([self.compiler, f"{test}.o", "main.o", *(self.parts if is_separate else []), "-o", test, *self.libraries], check=True)
        built, before = time.monotonic(), resource.getrusage(resource.RUSAGE_CHILDREN)
        reached = self.folder / "reached"
        if not self.passes(test, {"GDP_REACHED": str(reached)}, 3600):
            sys.exit(f"mutate.py: {test} does not pass without a mutation")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.state["seconds"][test] = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        self.state["reached"][test] = [i for i, b in enumerate(reached.read_bytes()) if b]
        self.state["objects"][test] = key
        self.save()
        print(f"{test}: made in {built - start:.0f} s, runs {self.state['seconds'][test]:.1f} s, "
              f"reaches {len(self.state['reached'][test])}", flush=True)

    def passes(self, test, environment, seconds):
        """Time is that of the processor, for the machine may do other things; what waits for ever is killed after a while."""
        limits = [f"--as={8 << 30}", "--core=0", f"--cpu={seconds}"]  # loops without an end may allocate
        process = subprocess.Popen(["prlimit", *limits, self.folder / test], cwd=self.test, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, env={**os.environ, **environment})
        timer = threading.Timer(100 + 20 * seconds, process.kill)
        timer.start()
        try:
            for line in process.stderr:
                if b": check failed: " in line:  # there is no need to see the others
                    process.kill()
            return process.wait() == 0
        finally:
            timer.cancel()

    def judge(self, mutants, tests, most_seconds):
        killed, asked, seconds = self.verdicts["killed"], self.verdicts["asked"], self.state["seconds"]
        for test in sorted((t for t in tests or seconds if seconds[t] <= most_seconds), key=seconds.get):
            key = f"{test} {self.state['objects'][test]}"
            reached = set(self.state["reached"][test])
            todo = [i for i in mutants if i in reached and str(i) not in killed and key not in asked.get(str(i), [])]
            for i in todo:
                if self.passes(test, {"GDP_MUTANT": str(i)}, int(3 + 5 * seconds[test])):
                    asked.setdefault(str(i), []).append(key)
                else:
                    killed[str(i)] = test
                (self.folder / "verdicts.json").write_text(json.dumps(self.verdicts))
            if todo:
                print(f"{test}: asked about {len(todo)}, kills {sum(killed.get(str(i)) == test for i in todo)}, "
                      f"{sum(str(i) not in killed for i in mutants)} alive", flush=True)

    def sample(self, arguments):
        made = [i for i in range(len(self.held)) if str(i) not in self.state["dropped"]]
        return made[arguments.first:arguments.first + arguments.number if arguments.number else None]

    def described(self, i):
        m = self.held[i]
        text = self.originals[m.header]
        first, last = text.rfind("\n", 0, m.position) + 1, text.find("\n", m.position)
        return (f"{i} {m.header[len('CGAL/Gradient_domain_processing/'):]}:{text.count(chr(10), 0, m.position) + 1}: {m.kind} `{m.old}` -> "
                f"`{m.new}` in: {' '.join(text[first:last].split())}")


def report(workshop, mutants):
    state = workshop.state
    reached = {i for r in state["reached"].values() for i in r}
    verdict = {i: "killed" if str(i) in workshop.verdicts["killed"] else "survived" if i in reached else "not reached" for i in mutants}
    last = mutants[-1] + 1 if mutants else 0
    passed_over = [i for i in range(last) if str(i) in state["dropped"]]
    columns = ["killed", "survived", "not reached"]
    print(f"\n{'kind':12}" + "".join(f"{c:>14}" for c in columns) + "  cannot be made   share killed")
    for kind in sorted({m.kind for m in workshop.held}) + ["all"]:
        is_of = [i for i in mutants if kind in ("all", workshop.held[i].kind)]
        counts = [sum(verdict[i] == c for i in is_of) for c in columns]
        none = sum(kind in ("all", workshop.held[i].kind) for i in passed_over)
        print(f"{kind:12}" + "".join(f"{c:14}" for c in counts) + f"{none:16}" + (f"{100 * counts[0] / len(is_of):13.1f} %" if is_of else ""))
    print(f"{len(workshop.order)} changes in the headers; held {len(workshop.held) - len(state['dropped'])}\n\nAlive:")
    for i in mutants:
        if verdict[i] != "killed":
            print(f"  {verdict[i]}: {workshop.described(i)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("headers", nargs="*")
    parser.add_argument("--scratch", required=True, help="folder to work in, kept")
    parser.add_argument("--hold", type=int, default=600, help="mutants of the build, with those that cannot be made; 0: every change")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="pass over so many of those that can be made")
    parser.add_argument("--number", type=int, default=250, help="judge so many; 0: all that are held")
    parser.add_argument("--tests", nargs="+", help="ask these only")
    parser.add_argument("--most", type=float, default=1e9, help="do not ask tests that take more seconds")
    parser.add_argument("--no-build", dest="build", action="store_false", help="judge by what is built")
    parser.add_argument("--no-judge", dest="judge", action="store_false", help="only build")
    parser.add_argument("--compiler", default="g++")
    parser.add_argument("--eigen", default="/usr/include/eigen3")
    arguments = parser.parse_args()
    pathlib.Path(arguments.scratch).mkdir(parents=True, exist_ok=True)
    workshop = Workshop(arguments)
    if arguments.build:
        workshop.prepare()
        workshop.build_parts()
        header_only = re.search(r"HEADER_ONLY ([^)]*?)\n", (TESTS / "CMakeLists.txt").read_text())[1]
        for test in arguments.tests or sorted({p.stem for p in TESTS.glob("test_*.cpp")} - NEVER):
            workshop.build(test, f"{test}.cpp" not in header_only)
    if arguments.judge:
        workshop.judge(workshop.sample(arguments), arguments.tests, arguments.most)
        report(workshop, workshop.sample(arguments))


if __name__ == "__main__":
    main()
