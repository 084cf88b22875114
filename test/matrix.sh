#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles the headers with all compilers, releases of CGAL and options that they are made for, runs
# test_properties with each compiler and CGAL, and prints a table: matrix.sh [WORK_DIR]
# Other releases of CGAL come from Debian's suites trixie and sid, from the mirror of this machine;
# they are unpacked below WORK_DIR and not installed. Takes about half an hour.
set -eu
cd "$(dirname "$0")/.."
work=${1:-build/matrix}
mkdir -p "$work"
work=$(cd "$work" && pwd)
newest_clang=$(apt-cache search --names-only '^clang-[0-9]+$' | sed 's/ .*//' | sort -t- -k2n | tail -n 1)
sh cmake/install_packages.sh g++ clang "$newest_clang" libcgal-dev libeigen3-dev libtbb-dev libboost-test-dev

unpack_cgal() { # suite
  [ ! -e "$work/$1/usr/include/CGAL/version.h" ] || return 0
  mirror=$(apt-cache policy libcgal-dev | awk '$2 ~ /^https?:/ { print $2; exit }')
  mkdir -p "$work/$1/lists/partial" "$work/$1/cache/archives/partial"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $1 main" > "$work/$1/sources.list"
  (
    cd "$work/$1"
    set -- -o "Dir::Etc::sourcelist=$PWD/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$PWD/lists" \
      -o "Dir::Cache=$PWD/cache" -o APT::Sandbox::User=root
    apt-get "$@" -qq update
    apt-get "$@" -qq download libcgal-dev
    dpkg -x libcgal-dev_*.deb .
    rm -r libcgal-dev_*.deb lists cache
  )
}

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

compiles_alone() { # compiler, include
  for header in include/CGAL/*.h include/CGAL/Balanced_flow/*.h; do
    # shellcheck disable=SC2086
    $1 -fsyntax-only -x c++ $common $warnings $2 "$header" -Wno-pragma-once-outside-header || return
  done
}

properties() { # name, compiler, include
  # shellcheck disable=SC2086
  $2 $common $3 -O1 -DCGAL_LINKED_WITH_TBB test/test_properties.cpp -o "$work/$1" -ltbb -pthread && "$work/$1"
}

for suite in trixie sid; do unpack_cgal $suite; done
rm -f "$work/failed"

echo "| compiler | CGAL | Debug | Release | Debug, no TBB | Release, no TBB | headers alone | -ffast-math refused | refused without Eigen | test_properties |"
echo "|---|---|---|---|---|---|---|---|---|---|"
for compiler in g++ clang++ "$(echo "$newest_clang" | sed 's/-/++-/')"; do
  for suite in installed trixie sid; do
    cgal=$(include_cgal $suite)
    name=$compiler-$suite
    printf '| %s %s | %s |' "$compiler" "$($compiler -dumpfullversion -dumpversion | head -n 1)" "$(cgal_version $suite)"
    for options in "-DCGAL_LINKED_WITH_TBB" "-DCGAL_LINKED_WITH_TBB -DNDEBUG -O2" "" "-DNDEBUG -O2"; do
      # shellcheck disable=SC2086
      result "$name$(echo "$options" | tr -d ' ')" $compiler -fsyntax-only $common $warnings $cgal $options \
        test/consumer/main.cpp
    done
    result "$name-alone" compiles_alone $compiler "$cgal"
    # shellcheck disable=SC2086
    result "$name-fast" refuses "must not be compiled with -ffast-math" $compiler -fsyntax-only $common $cgal \
      -ffast-math test/consumer/main.cpp
    # shellcheck disable=SC2086
    result "$name-eigen" refuses "needs Eigen" $compiler -fsyntax-only -std=c++17 -Iinclude $cgal test/consumer/main.cpp
    result "$name-properties" properties "$name" $compiler "$cgal"
    echo
  done
done
[ ! -e "$work/failed" ] || { echo "See" && cat "$work/failed" && exit 1; }
