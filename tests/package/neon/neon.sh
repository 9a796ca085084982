#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# neon.sh ROOT FOLDER: ensembles in lanes compiled for NEON from the same source, and run by an emulator. Exit code 77:
# no compiler or emulator for it (Debian: g++-aarch64-linux-gnu, qemu-user).
set -eu
root=$1 folder=$2
for program in aarch64-linux-gnu-g++ aarch64-linux-gnu-objdump qemu-aarch64; do
  if ! command -v $program > /dev/null; then
    echo "$program is missing (Debian: g++-aarch64-linux-gnu, qemu-user)" >&2
    exit 77
  fi
done
mkdir -p "$folder"
aarch64-linux-gnu-g++ -std=c++20 -O2 -ftree-vectorize -ffp-contract=off -static -I"$root/src" -I"$root/tests" \
  "$root/tests/package/neon/neon.cpp" -o "$folder/neon"
qemu-aarch64 "$folder/neon"
# Products of both numbers of a register.
count=$(aarch64-linux-gnu-objdump -d "$folder/neon" | grep -c 'fmul.*\.2d' || true)
echo "$count products in vector registers"
[ "$count" -gt 100 ]
