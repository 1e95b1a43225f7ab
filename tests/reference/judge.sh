#!/usr/bin/env bash
# Runs every reference case through the program and judges its CSV with check.py (Python's standard library only).
# Torque-free: 10 floors of the inputs' rounding; with torques: 100 floors of a stepper's. Arguments go to cargo.
set -euo pipefail
cd "$(dirname "$0")/../.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
failed=0
for case in tests/reference/*.json; do
    name=$(basename "$case" .json)
    cargo run --quiet "$@" --example scene_from_reference "$case" > "$out/$name.toml"
    cargo run --quiet "$@" --bin polhode -- run "$out/$name.toml" --format csv --out "$out" --quiet
    if grep -q '"torques": \[\]' "$case"; then limit=(--factor 10 --floor input); else limit=(--factor 100); fi
    if python3 tests/reference/check.py "$out/$name.csv" "$case" "${limit[@]}" > "$out/judged"; then
        echo "ok      $name"
    else
        echo "FAILED  $name"
        cat "$out/judged"
        failed=1
    fi
done
exit $failed
