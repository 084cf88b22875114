#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the core tests under the sanitizers, one program under valgrind, and the headers through
# clang-tidy and cppcheck. Takes about half an hour: sanitize.sh [address thread valgrind tidy cppcheck]
set -eu
cd "$(dirname "$0")/.."
sh cmake/install_packages.sh g++ clang clang-tidy cppcheck valgrind make cmake binutils libcgal-dev libcgal-demo \
  libeigen3-dev libtbb-dev libboost-test-dev libboost-program-options-dev nlohmann-json3-dev

tests=${TESTS:-core_tests} # only some of them: TESTS="test_exceptions test_thread_safety" sh test/sanitize.sh thread

build_and_test() { # name, flags
  cmake -S . -B "build/$1" -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG="-O1 -g1 -D_GLIBCXX_ASSERTIONS $2" \
    -D CMAKE_CXX_COMPILER=g++ -D POINT_SET_FLOW_BUILD_EXAMPLES=OFF
  # shellcheck disable=SC2086
  cmake --build "build/$1" --parallel 2 --target $tests
  ctest --test-dir "build/$1" --output-on-failure -L core -R "$(echo "$tests" | sed 's/core_tests/./; s/ /|/g')"
}

for tool in "${@:-all}"; do
  case $tool in address|all)
    # frame pointers: for the stacks of what was lost
    build_and_test sanitize-address "-fno-omit-frame-pointer -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all" ;;
  esac
  case $tool in thread|all)
    # Debian's TBB is not built for the sanitizer, which does not see how TBB synchronises
    export TSAN_OPTIONS="suppressions=$PWD/test/support/thread_sanitizer.supp"
    build_and_test sanitize-thread "-fsanitize=thread" ;;
  esac
  case $tool in valgrind|all)
    # valgrind rounds to nearest only, which CGAL finds out when the program starts; nothing of ours needs another way
    cmake -S . -B build/valgrind -D CMAKE_BUILD_TYPE=Debug \
      -D CMAKE_CXX_FLAGS_DEBUG="-O1 -g1 -D CGAL_DISABLE_ROUNDING_MATH_CHECK"
    cmake --build build/valgrind --parallel 2 --target test_exceptions
    valgrind --error-exitcode=1 --leak-check=full --errors-for-leak-kinds=definite,indirect \
      build/valgrind/test/contract/test_exceptions ;;
  esac
  case $tool in tidy|all)
    cmake -S . -B build/tidy -D CMAKE_EXPORT_COMPILE_COMMANDS=ON -D CMAKE_CXX_COMPILER=clang++
    clang-tidy -p build/tidy --quiet --warnings-as-errors='*' test/contract/random_clouds.cpp ;;
  esac
  case $tool in cppcheck|all)
    # Eigen is there, but empty: cppcheck looks at our headers only
    mkdir -p build/cppcheck/Eigen
    for header in Core Dense; do : > "build/cppcheck/Eigen/$header"; done
    cppcheck --std=c++17 --language=c++ --enable=warning,performance,portability --inline-suppr --error-exitcode=1 \
      --quiet -I include -I build/cppcheck -D CGAL_LINKED_WITH_TBB test/packaging/consumer/main.cpp ;;
  esac
done
