#!/usr/bin/env bash
# Every public function under compilers, standards and versions of CGAL and Eigen other than this machine's, with warnings as errors.
#
#   run.sh            all entries; what this machine has no tool for is skipped and said so
#   run.sh --quick    those that continuous integration has time for
#   run.sh NAME...    entries by their first word: host, cgal60, cgal62, m32, mingw, trixie, sid
#
# Everything it fetches and writes lies in $PORTABILITY_DIR (build/portability). CGAL and Eigen of Debian trixie and sid come by
# fetch_headers.sh. Where debootstrap is and PORTABILITY_CHROOT=1 is set (root; 2 GB each), so do whole systems with their compilers.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
include=${PORTABILITY_INCLUDE:-$root/include}
work=${PORTABILITY_DIR:-$root/build/portability}
source=$here/every_verb.cpp
mkdir -p "$work/logs" "$work/programs"
rm -f "$work"/logs/*

quick=false
wanted=" "
for argument; do
  if [ "$argument" = --quick ]; then quick=true; else wanted+="$argument "; fi
done

# g++'s -Wconversion leaves the sign alone; clang's says int is no index, and here it is.
warnings=(-Werror -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
without_gmp=(-DCGAL_DISABLE_GMP=1 -DCGAL_DO_NOT_USE_MPZF=1)
accelerators=(-DCGAL_GRADIENT_DOMAIN_PROCESSING_USE_CHOLMOD -isystem /usr/include/suitesparse -DCGAL_LINKED_WITH_TBB)

# chroot_of SUITE PACKAGE...: a whole system in $work/SUITE
chroot_of() {
  local suite=$1
  shift
  [ -e "$work/$suite/ready" ] && return 0
  [ "${PORTABILITY_CHROOT:-0}" = 1 ] && command -v debootstrap > /dev/null && [ "$(id -u)" = 0 ] || return 1
  rm -rf "${work:?}/$suite"
  debootstrap --variant=minbase --include="$(IFS=,; echo "$*")" "$suite" "$work/$suite" \
    > "$work/logs/debootstrap-$suite" 2>&1 && touch "$work/$suite/ready"
}

# entry NAME COMMAND...: two at a time; the result is a line in a file of its own, so that the table keeps the order
number=0
skip() {
  number=$((number + 1))
  printf '%s\t%s\n' "$1" "skipped: $2" > "$work/logs/$(printf %03d $number).line"
}
entry() {
  local name=$1 file
  shift
  number=$((number + 1))
  file=$work/logs/$(printf %03d $number)
  while [ "$(jobs -rp | wc -l)" -ge 2 ]; do wait -n; done
  {
    printf '%s ' "$@" > "$file.log"
    echo >> "$file.log"
    start=$SECONDS
    if "$@" >> "$file.log" 2>&1; then
      printf '%s\tpasses\t%d s\n' "$name" $((SECONDS - start))
    else
      printf '%s\tFAILS\t%s\n' "$name" "$file.log"
    fi > "$file.line"
  } &
}
asked() { [ "$wanted" = " " ] || [[ "$wanted" == *" $1 "* ]]; }
has() { command -v "$1" > /dev/null; }
version() { "$1" -dumpfullversion -dumpversion; }
syntax() { # syntax NAME COMPILER FLAG...
  local name=$1 compiler=$2
  shift 2
  if has "$compiler"; then
    entry "$name" "$compiler" "${warnings[@]}" -I "$include" -fsyntax-only "$@" -DCGAL_EIGEN3_ENABLED "$source"
  else
    skip "$name" "no $compiler"
  fi
}
compile_and_run() { # compile_and_run PROGRAM RUNNER COMPILER FLAG...
  local program=$1 runner=$2
  shift 2
  "$@" -o "$program" && timeout 300 $runner "$program"
}
cgal_and_eigen() { echo "-isystem $work/$1-headers/usr/include -isystem $work/$1-headers/usr/include/eigen3"; }

host() {
  local eigen=(-isystem /usr/include/eigen3) standard
  for standard in 17 20 23; do
    $quick && continue
    syntax "g++ $(version g++), C++$standard, CHOLMOD, TBB" g++ -std=c++$standard "${eigen[@]}" "${accelerators[@]}"
    syntax "clang++ $(version clang++), C++$standard, CHOLMOD, TBB" clang++ -std=c++${standard/23/2b} "${eigen[@]}" "${accelerators[@]}"
  done
  if has clang++ && echo '#include <vector>' | clang++ -stdlib=libc++ -x c++ -fsyntax-only - 2> /dev/null; then
    syntax "clang++ $(version clang++), C++17, libc++" clang++ -std=c++17 -stdlib=libc++ "${eigen[@]}"
    $quick || syntax "clang++ $(version clang++), C++23, libc++" clang++ -std=c++2b -stdlib=libc++ "${eigen[@]}"
  else
    skip "clang++, libc++" "no clang++ with libc++"
  fi
  if echo '#include <curses.h>' | g++ -x c++ -fsyntax-only - 2> /dev/null; then
    entry "No name of ours is a macro of <curses.h>" "$here/check_macros.py" "$include" g++ curses.h
    $quick || syntax "g++ $(version g++), C++17, <curses.h> before" g++ -std=c++17 "${eigen[@]}" -DPORTABILITY_CURSES_H
  else
    skip "g++, <curses.h> before" "no curses.h"
  fi
}
other_cgal() { # other_cgal SUITE: with that suite's Eigen
  local versions
  if ! "$here/fetch_headers.sh" "$1" "$work/$1-headers" > "$work/logs/fetch-$1" 2>&1; then
    skip "CGAL and Eigen of Debian $1" "they could not be fetched: $work/logs/fetch-$1"
    return
  fi
  versions="CGAL $(sed -n 's/^#define CGAL_VERSION \(.*\)/\1/p' "$work/$1-headers/usr/include/CGAL/version.h"), Eigen $(
    cat "$work/$1-headers"/usr/include/eigen3/Eigen/{src/Core/util/Macros.h,Version} 2> /dev/null |
    sed -n 's/^#define EIGEN_\(WORLD\|MAJOR\|MINOR\|PATCH\)_VERSION \([0-9]*\).*/\1 \2/p' |
    awk '{ v[$1] = $2 } END { print ("WORLD" in v && v["WORLD"] == 3 && v["MAJOR"] < 5 ? "3." v["MAJOR"] "." v["MINOR"] : v["MAJOR"] "." v["MINOR"] "." v["PATCH"]) }')"
  syntax "g++ $(version g++), C++17, $versions" g++ -std=c++17 $(cgal_and_eigen "$1") "${accelerators[@]}"
  $quick || syntax "g++ $(version g++), C++23, $versions" g++ -std=c++23 $(cgal_and_eigen "$1")
  $quick || syntax "clang++ $(version clang++), C++20, $versions" clang++ -std=c++20 $(cgal_and_eigen "$1") "${accelerators[@]}"
}
m32() { # GMP's 32-bit headers and library are not part of g++-multilib: Boost's numbers take their place
  local flags=(-m32 -std=c++17 -isystem /usr/include/eigen3 "${without_gmp[@]}")
  if ! echo '#include <vector>' | g++ -m32 -x c++ -fsyntax-only - 2> /dev/null; then
    skip "g++ -m32" "no g++-multilib"
  elif $quick; then
    syntax "g++ $(version g++) -m32" g++ "${flags[@]}"
  else
    entry "g++ $(version g++) -m32, compiled and run" compile_and_run "$work/programs/m32" "" \
      g++ "${flags[@]}" "${warnings[@]}" -O1 -DNDEBUG -I "$include" -DCGAL_EIGEN3_ENABLED "$source"
  fi
}
# The compiler of Windows looks at /usr/include only where told to, and there would find the headers of glibc.
mingw() {
  local compiler=x86_64-w64-mingw32-g++-posix wine foreign=$work/mingw-headers header
  if ! has $compiler; then
    skip "mingw-w64" "no $compiler"
    return
  fi
  entry "No name of ours is a macro of <windows.h>" "$here/check_macros.py" "$include" $compiler windows.h
  mkdir -p "$foreign"
  for header in CGAL boost eigen3; do ln -sfn /usr/include/$header "$foreign/$header"; done
  local flags=(-std=c++17 -Wa,-mbig-obj -isystem "$foreign" -isystem "$foreign/eigen3" "${without_gmp[@]}")
  wine=$(command -v wine64 || command -v wine || ls /usr/lib/wine/wine64 2> /dev/null)
  if [ -z "$wine" ] || $quick; then
    syntax "mingw-w64 $(version $compiler), <windows.h> before" $compiler "${flags[@]}" -DPORTABILITY_WINDOWS_H
  else
    export WINEPREFIX=$work/wine WINEDEBUG=-all
    entry "mingw-w64 $(version $compiler), <windows.h> before, run under wine" compile_and_run "$work/programs/mingw.exe" "$wine" \
      $compiler "${flags[@]}" "${warnings[@]}" -O1 -DNDEBUG -static -I "$include" -DCGAL_EIGEN3_ENABLED -DPORTABILITY_WINDOWS_H "$source"
  fi
}
whole_system() { # whole_system SUITE GCC CLANG
  local suite=$1 gcc=$2 clang=$3 standard # the newest of each compiler, with that suite's CGAL and Eigen
  if ! chroot_of "$suite" g++-$gcc clang-$clang libc++-$clang-dev libc++abi-$clang-dev libcgal-dev libeigen3-dev libboost-dev \
      libsuitesparse-dev libopenblas-dev libtbb-dev; then
    skip "Debian $suite: g++-$gcc, clang++-$clang" "no system in $work/$suite (PORTABILITY_CHROOT=1 makes it)"
    return
  fi
  rm -rf "$work/$suite/gdp"
  mkdir "$work/$suite/gdp"
  cp -r "$include" "$work/$suite/gdp/include"
  cp "$source" "$work/$suite/gdp"
  local flags=("${warnings[@]}" -I /gdp/include -isystem /usr/include/eigen3 -DCGAL_EIGEN3_ENABLED -fsyntax-only "${accelerators[@]}" /gdp/every_verb.cpp)
  for standard in 20 23; do
    entry "Debian $suite: g++-$gcc, C++$standard" chroot "$work/$suite" g++-$gcc -std=c++$standard "${flags[@]}"
    entry "Debian $suite: clang++-$clang, C++$standard" chroot "$work/$suite" clang++-$clang -std=c++$standard "${flags[@]}"
  done
  entry "Debian $suite: clang++-$clang, C++23, libc++" chroot "$work/$suite" clang++-$clang -stdlib=libc++ -std=c++23 "${flags[@]}"
}

asked host && host
asked cgal60 && ! $quick && other_cgal trixie
asked cgal62 && other_cgal sid
asked m32 && ! $quick && m32
asked mingw && mingw
asked trixie && ! $quick && whole_system trixie 14 19
asked sid && ! $quick && whole_system sid 15 21
wait

failures=0
for line in "$work"/logs/*.line; do
  awk -F '\t' '{ printf "%-72s %s\n", $1, $2 " " $3 }' "$line"
  if grep -q FAILS "$line"; then
    failures=$((failures + 1))
    grep -E 'error|warning' "${line%.line}.log" | sort -u | head -20
  fi
done
exit $((failures > 0))
