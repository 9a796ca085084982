#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# sh check.sh <source>: scripts/check fails where the sanitized tests are not through in time, where one of them
# fails, and where a command under valgrind ends otherwise than it should. Its last line sums what all steps counted. Builds are replaced by nothing.
set -eu
at=$(mktemp -d)
trap 'rm -rf "$at"' EXIT
mkdir -p "$at/scripts" "$at/build/asan/tests" "$at/bin"
cp "$1/scripts/check" "$1/scripts/usage" "$at/scripts/"
fake() { printf '#!/bin/sh\n%s\n' "$2" >"$1" && chmod +x "$1"; }
fails() {
  if output=$("$@" 2>&1); then echo "$*: passed: $output" && exit 1; fi
}
PATH=$at/bin:$PATH

fake "$at/scripts/bootstrap" 'sleep 30'
mkdir -p "$at/tests"
cp "$1/tests/sanitized.txt" "$at/tests/"
ODEUM_CHECK_SECONDS=1 fails "$at/scripts/check" --quick sanitize
case $output in *"not through within 1 s"*) ;; *) echo "no word on the time: $output" && exit 1 ;; esac

tests=$at/build/asan/tests/odeum_adapter_tests
for program in formula readers; do fake "$at/build/asan/tests/odeum_${program}_tests" 'exit 0'; done
fake "$at/scripts/bootstrap" 'exit 0'
fake "$tests" 'case $* in *-Watched*) ;; *) exit 1 ;; esac'
"$at/scripts/check" --quick sanitize >/dev/null
fake "$tests" 'test $GTEST_SHARD_INDEX = 0'
fails "$at/scripts/check" --quick sanitize
fake "$at/bin/valgrind" 'case $* in *rk5*|*gauss4*) exit 2 ;; *third_order*) exit 99 ;; esac'
fails "$at/scripts/check" memory
case $output in *third_order.yaml*"exit code 99, expected 0"*) ;; *) echo "no word on the command: $output" && exit 1 ;; esac
fake "$at/bin/valgrind" 'case $* in *rk5*|*gauss4*) exit 2 ;; esac'
"$at/scripts/check" memory >/dev/null
fake "$at/scripts/test" 'echo "1/3 Test #1: a ....   Passed"; echo "2/3 Test #2: b ....***Skipped"
echo "67% tests passed, 1 tests failed out of 3"; exit 1'
fails "$at/scripts/check" suite memory
case $output in *"== 1 skipped"*"
1 passed, 1 failed") ;; *) echo "the sums of a failed step: $output" && exit 1 ;; esac
fake "$at/scripts/test" 'echo "2/3 Test #2: b ....***Skipped"; echo "100% tests passed, 0 tests failed out of 3"'
output=$("$at/scripts/check" suite memory)
case $output in *"
4 passed, 0 failed") ;; *) echo "the sums of two steps: $output" && exit 1 ;; esac
