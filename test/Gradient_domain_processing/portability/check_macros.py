#!/usr/bin/env python3
"""check_macros.py INCLUDE_FOLDER COMPILER HEADER...: no identifier of our headers is a macro of those headers.

<windows.h> defines `near`, `OK` comes from <curses.h>, and both may be included before ours. A name may be guarded:
#ifndef NAME just before the line that has it.
"""

import pathlib
import re
import subprocess
import sys


def macros_of(compiler, text):
    output = subprocess.run([compiler, "-x", "c++", "-dM", "-E", "-"], input=text, text=True, check=True, capture_output=True).stdout
    return set(re.findall(r"^#define (\w+)", output, re.MULTILINE))


def main():
    folder, compiler, headers = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
    macros = macros_of(compiler, "".join(f"#include <{h}>\n" for h in headers)) - macros_of(compiler, "")
    failures = 0
    for path in sorted(folder.rglob("*.h")):
        # without comments and strings, each line where it was
        text = re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', lambda m: "\n" * m.group().count("\n"), path.read_text(), flags=re.DOTALL)
        guarded = None
        for number, line in enumerate(text.split("\n"), 1):
            if line.lstrip().startswith("#"):
                guarded = re.match(r"\s*#\s*ifndef\s+(\w+)", line)
                continue
            for name in re.findall(r"[A-Za-z_]\w*", line):
                if name in macros and not (guarded and guarded.group(1) == name):
                    failures += 1
                    print(f"{path}:{number}: error: {name} is a macro of <{'> or <'.join(headers)}>")
    sys.exit(failures > 0)


if __name__ == "__main__":
    main()
