#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles the headers with all compilers, releases of CGAL and options that they are made for, with all
# warnings as errors, links and runs the program of test/packaging/consumer, and prints a table:
# matrix.sh [WORK_DIR [properties]], where the last word also runs test_random_clouds in each row, with the lanes and the
# fused arithmetic of this machine.
# Other releases of CGAL come from Debian's suites trixie and sid, from the mirror of this machine;
# they are unpacked below WORK_DIR and not installed. Takes a quarter of an hour, with
# test_random_clouds half an hour.
set -eu
cd "$(dirname "$0")/.."
work=${1:-build/matrix}
properties=${2:-}
mkdir -p "$work"
work=$(cd "$work" && pwd)
newest_clang=$(apt-cache search --names-only '^clang-[0-9]+$' | sed 's/ .*//' | sort -t- -k2n | tail -n 1)
sh cmake/install_packages.sh g++ clang "$newest_clang" libcgal-dev libeigen3-dev libtbb-dev libboost-test-dev

include_cgal() { # suite
  [ "$1" = installed ] || echo "-isystem $work/$1/usr/include"
}

cgal_version() { # suite
  printf '#include <CGAL/version.h>\nCGAL_VERSION\n' |
    g++ -E -P $(include_cgal "$1") -x c++ - | tail -n 1
}

warnings="-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror"
common="-std=c++17 -Iinclude -isystem /usr/include/eigen3 -DCGAL_EIGEN3_ENABLED"
failed=0

result() { # log, command ...: prints a cell of the table
  log=$work/$1.log
  shift
  if "$@" > "$log" 2>&1; then
    printf ' yes |'
  else
    printf ' **no** |'
    echo "$log" >> "$work/failed"
  fi
}

refuses() { # message, command ...: whether the command fails with the message
  message=$1
  shift
  ! "$@" > "$work/refused" 2>&1 && grep -q "$message" "$work/refused"
}

compiles_alone() { # include
  for header in include/CGAL/*.h include/CGAL/Point_set_flow/*.h; do
    # shellcheck disable=SC2086
    g++ -fsyntax-only $common $warnings $1 -x c++ -include "$header" /dev/null || return
  done
}

runs() { # name, command ...: whether what the command makes runs
  program=$work/$1
  shift
  "$@" -o "$program" -ltbb -pthread && "$program"
}

for suite in trixie sid; do sh test/unpack_packages.sh "$work/$suite" $suite libcgal-dev; done
rm -f "$work/failed"

printf '| compiler | CGAL | Debug, TBB, run | Release, TBB | Debug | Release | -march=native | -ffast-math is refused | no Eigen is refused |'
[ -z "$properties" ] || printf ' test_random_clouds |'
printf '\n|---|---|---|---|---|---|---|---|---|'
[ -z "$properties" ] || printf -- '---|'
echo
tbb=-DCGAL_LINKED_WITH_TBB
for suite in sid trixie installed; do
  for compiler in g++ "$(echo "$newest_clang" | sed 's/-/++-/')" clang++; do
    name=$compiler-$suite
    printf '| %s %s | %s |' "$compiler" "$($compiler -dumpfullversion -dumpversion | head -n 1)" "$(cgal_version $suite)"
    # shellcheck disable=SC2046,SC2086
    {
      set -- $common $warnings $(include_cgal $suite) test/packaging/consumer/main.cpp
      result "$name-run" runs "$name" $compiler $tbb "$@" test/packaging/consumer/other.cpp
      result "$name-release" $compiler -fsyntax-only $tbb -DNDEBUG -O2 "$@"
      result "$name-without" $compiler -fsyntax-only "$@"
      result "$name-release-without" $compiler -fsyntax-only -DNDEBUG -O2 "$@"
      result "$name-native" $compiler -fsyntax-only -DNDEBUG -O2 -march=native "$@"
      result "$name-fast" refuses "must not be compiled with -ffast-math" $compiler -fsyntax-only -ffast-math "$@"
      result "$name-eigen" refuses "needs Eigen" $compiler -fsyntax-only -std=c++17 -Iinclude test/packaging/consumer/main.cpp
      [ -z "$properties" ] || result "$name-properties" runs "$name-properties" $compiler $tbb $common \
        $(include_cgal $suite) -O2 -march=native -DBOOST_TEST_DYN_LINK -Itest/support test/contract/random_clouds.cpp -lboost_unit_test_framework
    }
    echo
  done
done
printf '\nEach public header alone, g++, CGAL %s: |' "$(cgal_version sid)"
result alone compiles_alone "$(include_cgal sid)"
echo
[ ! -e "$work/failed" ] || { echo "See" && cat "$work/failed" && exit 1; }
