#!/usr/bin/env bash
# Kernels hand the linker nothing but their table: a function it could share would run instructions others lack.
set -euo pipefail
checked=0
for object in "$@"; do
    [[ $object == *kernels_*.o ]] || continue
    exported=$(nm --defined-only --extern-only -C "$object" | cut -d' ' -f3-)
    if ! [[ $exported =~ ^fieldwright::field::[a-z0-9]+::table$ ]]; then
        echo "$object exports more than its table:"
        echo "$exported"
        exit 1
    fi
    checked=$((checked + 1))
done
[ "$checked" -gt 0 ] || { echo "no kernels among: $*"; exit 1; }
