#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the package that can be submitted to CGAL, puts it and the changed lists of CGAL into the headers of the
# newest CGAL that Debian has, and builds and runs its programs there. Nothing is installed.
#   cgal_package.sh work_directory [program ...]     (all programs if none is given)
# Ends with 77 if that CGAL cannot be had, or is not of the release that $CGAL_RELEASE asks for.
set -eu
work=$(mkdir -p "$1" && cd "$1" && pwd)
shift
root=$(cd "$(dirname "$0")/../.." && pwd)

if [ ! -d "$work/cgal.orig" ]; then # apt with a list and a state of its own
  mkdir -p "$work/apt/lists/partial" "$work/apt/cache/archives/partial"
  echo 'deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian sid main' >"$work/apt/sid.list"
  cat >"$work/apt/apt.conf" <<END
Dir::Etc::sourcelist "$work/apt/sid.list";
Dir::Etc::sourceparts "-";
Dir::State::Lists "$work/apt/lists";
Dir::Cache "$work/apt/cache";
END
  export APT_CONFIG="$work/apt/apt.conf"
  if ! (apt-get update && cd "$work/apt" && apt-get download libcgal-dev) >"$work/apt/log" 2>&1; then
    cat "$work/apt/log" >&2
    echo "skipped: the newest CGAL of Debian cannot be had" >&2
    exit 77
  fi
  dpkg -x "$work"/apt/libcgal-dev_*.deb "$work/cgal.new"
  mv "$work/cgal.new" "$work/cgal.orig"
fi
version=$(sed -n 's/^#define CGAL_VERSION \([0-9]\)/\1/p' "$work/cgal.orig/usr/include/CGAL/version.h")
echo "== CGAL $version"
case $version in "${CGAL_RELEASE:-}"*) ;; *) echo "skipped: not CGAL $CGAL_RELEASE" >&2; exit 77 ;; esac

rm -rf "$work/package" "$work/cgal"
cmake -D OUT="$work/package" -D CGAL_INCLUDE_DIR="$work/cgal.orig/usr/include" -P "$root/cmake/make_cgal_package.cmake"

# Into CGAL: packages of its tree have folders of their own, an installed CGAL has one for all
cp -r "$work/cgal.orig" "$work/cgal"
include=$work/cgal/usr/include
cp -r "$work/package/Point_set_flow/include/CGAL" "$work/package/lists/CGAL" "$include"
# CGAL's generator of these headers is in its repository only
cp "$root/include/CGAL/license/Point_set_flow.h" "$include/CGAL/license"

# Each header on its own; and the packages whose headers they include, which package_info lists
flags="-std=c++17 -I $include -I /usr/include/eigen3 -D CGAL_EIGEN3_ENABLED"
(cd "$work/package/Point_set_flow/include" && find . -name '*.h' | sort) | sed 's,^\./\(.*\),#include <\1>,' >"$work/all.cpp"
# shellcheck disable=SC2086
${CXX:-c++} $flags -M "$work/all.cpp" | tr -d '\\' | tr ' ' '\n' | grep "^$include/CGAL/" |
  xargs sed -n 's,^// $URL: .*/cgal/blob/[^/]*/\([^/]*\)/.*,\1,p; s,^// $URL\$,Point_set_flow,p' |
  LC_ALL=C sort -u >"$work/dependencies"
diff "$work/package/Point_set_flow/package_info/Point_set_flow/dependencies" "$work/dependencies" ||
  { echo "cmake/cgal_package/dependencies.txt has to be as the right side says" >&2; exit 1; }

cgal_dir=$(dirname "$(find "$work/cgal/usr/lib" -name CGALConfig.cmake)")
for kind in examples test; do
  cmake -S "$work/package/Point_set_flow/$kind/Point_set_flow" -B "$work/build/$kind" -D CGAL_DIR="$cgal_dir" \
    -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_FLAGS_RELEASE=-O1 -D CGAL_DATA_DIR="${CGAL_DATA_DIR:-}" \
    -D CMAKE_CXX_COMPILER="${CXX:-c++}" -D CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON
done
for source in "$work"/package/Point_set_flow/*/Point_set_flow/*.cpp; do
  name=$(basename "$source" .cpp)
  kind=$(basename "$(dirname "$(dirname "$source")")")
  case " ${*:-$name} " in *" $name "*) ;; *) continue ;; esac
  echo "== $kind/$name"
  cmake --build "$work/build/$kind" --target "$name"
  (cd "$work/build/$kind" && "./$name")
done
echo "== compiled and ran inside CGAL $version"
