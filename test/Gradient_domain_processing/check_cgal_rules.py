#!/usr/bin/env python3
# Copyright (c) 2026  The Gradient_domain_processing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks what can be checked of CGAL's rules for packages (developer manual: coding conventions, checks, portability).

Usage: check_cgal_rules.py [ROOT]; prints FILE:LINE: what is wrong, and exits with 1 if anything is.
"""

import pathlib
import re
import sys

PACKAGE = "Gradient_domain_processing"
PREAMBLE = """// Copyright (c) YEAR  The Gradient_domain_processing authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : """
LINE_LENGTH = 120
SOURCES = {".h", ".cpp"}
# In parentheses, so that the macros of Windows do not spell them.
BARE_MIN_MAX = re.compile(r"(?<!\()\bstd::(min|max)\s*\(|numeric_limits<[^;()]*>::(min|max)\(")
PACKAGE_INFO = ["copyright", "dependencies", "description.txt", "license.txt", "long_description.txt", "maintainer"]

problems = []


def report(path, line, what):
    problems.append(f"{path}:{line}: {what}")


def sources(root, *folders):
    for folder in folders:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix in SOURCES and "build" not in path.relative_to(root).parts:
                yield path


def check_text(path, name, text):
    if "\r" in text:
        report(name, 1, "lines end in CR LF")
    if text and not text.endswith("\n"):
        report(name, text.count("\n") + 1, "no end of the last line")
    for number, line in enumerate(text.split("\n"), 1):
        # arguments of Doxygen's aliases cannot be broken
        if len(line) > LINE_LENGTH and "\\cgalParam" not in line:
            report(name, number, f"{len(line)} characters, more than {LINE_LENGTH}")
        if line != line.rstrip():
            report(name, number, "blanks at the end of the line")
        if "\t" in line:
            report(name, number, "a tabulator")
        if not line.isascii():
            report(name, number, "a character beyond ASCII")
        if BARE_MIN_MAX.search(line):
            report(name, number, "min or max without parentheses around its name")


def check_header(path, name, text, include):
    expected = re.escape(PREAMBLE).replace("YEAR", r"\d{4}(-\d{4})?")
    if not re.match(expected, text):
        report(name, 1, "not CGAL's preamble (copyright, $URL$, $Id$, license, authors)")
    relative = path.relative_to(include).as_posix()
    guard = re.sub(r"[^A-Za-z0-9]", "_", relative).upper()
    guards = [guard, guard.replace("CGAL_GRADIENT_DOMAIN_PROCESSING_GRADIENT_DOMAIN_PROCESSING", "CGAL_GRADIENT_DOMAIN_PROCESSING")]
    if not any(f"#ifndef {g}\n#define {g}\n" in text and text.rstrip().endswith(f"#endif // {g}") for g in guards):
        report(name, 1, f"no include guard {guard}, or no comment with it at the end")
    is_public = "/internal/" not in relative and "/license/" not in relative
    if is_public and f"#include <CGAL/license/{PACKAGE}.h>" not in text:
        report(name, 1, "the license header is not included")
    for number, line in enumerate(text.split("\n"), 1):
        macro = re.match(r"\s*#\s*define\s+(\w+)", line)
        if macro and not macro.group(1).startswith("CGAL_"):
            report(name, number, f"the macro {macro.group(1)} does not begin with CGAL_")
        if re.search(r"\busing namespace\b", line) and not line.startswith("  "):
            report(name, number, "using namespace in a header")
        if re.search(r"\bassert\s*\(", line):
            report(name, number, "assert in place of CGAL_assertion")


def check_names(root):
    seen = {}
    for path in sorted((root / "include").rglob("*")):
        key = path.relative_to(root).as_posix().lower()
        if key in seen:
            report(path.relative_to(root), 1, f"differs from {seen[key]} in capitals only")
        seen[key] = path.relative_to(root)


def check_examples(root):
    listed = (root / f"doc/{PACKAGE}/examples.txt").read_text()
    folder = root / f"examples/{PACKAGE}"
    for path in sorted(folder.glob("*_example.cpp")):
        if f"\\example {PACKAGE}/{path.name}" not in listed:
            report(path.relative_to(root), 1, "not in examples.txt")
    for entry in re.findall(r"\\example (\S+)", listed):
        if not (root / "examples" / entry).exists():
            report(f"doc/{PACKAGE}/examples.txt", 1, f"{entry} does not exist")


def check_references(root):
    text = "".join(path.read_text() for path in sorted((root / f"doc/{PACKAGE}").rglob("*.txt")))
    headers = "".join(path.read_text() for path in sources(root, "include"))
    bib = root / f"doc/{PACKAGE}/{PACKAGE}.bib"
    entries = set(re.findall(r"^@\w+\{([^,\s]+)", bib.read_text(), re.M)) if bib.exists() else set()
    if not bib.exists():
        report(bib.relative_to(root), 1, "does not exist")
    for key in sorted(set(re.findall(r"\\cgalCite\{([^}]+)\}", text + headers))):
        if key not in entries:
            report(bib.relative_to(root), 1, f"no entry {key}")


def check_package_info(root):
    folder = root / f"package_info/{PACKAGE}"
    for name in PACKAGE_INFO:
        path = folder / name
        if not path.exists() or not path.read_text().strip():
            report(path.relative_to(root), 1, "missing or empty")
    path = folder / "dependencies"
    if path.exists():
        lines = path.read_text().split()
        if lines != sorted(lines):
            report(path.relative_to(root), 1, "not sorted")


def check_documentation(root):
    """Every documented function says what it returns, and documents each template parameter and parameter by name."""
    include = root / "include/CGAL" / PACKAGE
    for path in sorted(include.glob("*.h")):
        text = path.read_text()
        if "\\ingroup" not in text and "\\file" not in text and "CGAL_" in text:
            report(path.relative_to(root), 1, "a public header without documentation")
        for block in re.finditer(r"/\*!(.*?)\*/", text, re.S):
            number = text.count("\n", 0, block.start()) + 1
            begins, ends = block.group(1).count("\\cgalParamNBegin"), block.group(1).count("\\cgalParamNEnd")
            kinds = [block.group(1).count("\\cgalParam" + kind) for kind in ("Description", "Type", "Default")]
            if begins != ends or any(kind != begins for kind in kinds):
                report(path.relative_to(root), number, "a named parameter without description, type or default")


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "../..").resolve()
    for path in sources(root, "include", "examples", "test", "benchmark"):
        name = path.relative_to(root).as_posix()
        text = path.read_bytes().decode("utf-8")
        check_text(path, name, text)
        if name.startswith("include/"):
            check_header(path, name, text, root / "include")
    check_names(root)
    check_examples(root)
    check_references(root)
    check_package_info(root)
    check_documentation(root)
    print("\n".join(problems) if problems else "CGAL's rules hold")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
