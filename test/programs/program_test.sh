# SPDX-License-Identifier: GPL-3.0-or-later
# What the tests of programs share. Each is called as
#   TEST.sh <program> <directory of CGAL's sample data> <work directory>
# and goes on in an empty work directory.
set -u
program=$1 data=$2 work=$3
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1

check() { # check "what" command...
  local what=$1
  shift
  if "$@"; then echo "ok: $what"; else echo "FAILED: $what"; exit 1; fi
}

fails_with() { # fails_with code "part of the message" command...
  local code=$1 message=$2 out status
  shift 2
  out=$("$@" 2>&1)
  status=$?
  [ "$status" = "$code" ] && [[ $out == *"$message"* ]] && return
  echo "exit code $status (expected $code), output: $out (expected: $message)"
  return 1
}
