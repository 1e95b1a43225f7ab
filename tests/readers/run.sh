#!/usr/bin/env bash
# Records every scene and has readers that share no code with this crate read the recordings: each checksum, each
# message, and each value against the .csv of the same run, to the bit. Then once more with one number of a table altered,
# which each of them must notice.
#
# What they need is installed outside the clone, once, in the versions that requirements.txt and package-lock.json name.
# What cannot be installed is skipped, and said; with READERS_REQUIRED=1 that is a failure. Arguments go to cargo.
set -euo pipefail
cd "$(dirname "$0")"
cache=${XDG_CACHE_HOME:-$HOME/.cache}/polhode-readers
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
failed=0

skip() {
    echo "SKIPPED $1"
    if [ -n "${READERS_REQUIRED:-}" ]; then failed=1; fi
}

# A folder for what these files ask for; a change of them gets a new one.
folder_for() {
    local name=$1
    shift
    echo "$cache/$name-$(cat "$@" | cksum | tr -c '0-9\n' -)"
}

# Moved to its name when it is whole: an installation that was cut short is none.
install_python() {
    local fresh=$python.$$
    python3 -m venv "$fresh" && "$fresh/bin/pip" install --quiet --disable-pip-version-check --no-input \
        --retries 1 --timeout 20 --requirement requirements.txt || { rm -rf "$fresh"; return 1; }
    touch "$fresh/whole"
    rm -rf "$python"
    mv "$fresh" "$python"
}

install_node() {
    local fresh=$node.$$
    mkdir -p "$fresh" && cp package.json package-lock.json "$fresh" &&
        npm --prefix "$fresh" ci --silent --fetch-retries 1 || { rm -rf "$fresh"; return 1; }
    touch "$fresh/whole"
    rm -rf "$node"
    mv "$fresh" "$node"
}

have_python=
python=$(folder_for python requirements.txt)
if ! command -v python3 > /dev/null; then
    skip "Python's mcap, Rerun's RrdReader and command line: there is no python3"
elif [ -e "$python/whole" ] || install_python > "$out/installing" 2>&1; then
    have_python=1
else
    tail -n 3 "$out/installing"
    skip "Python's mcap, Rerun's RrdReader and command line: pip could not install them"
fi

have_node=
node=$(folder_for node package.json package-lock.json)
if ! command -v node > /dev/null || ! command -v npm > /dev/null; then
    skip "@mcap/core: there is no node or no npm"
elif [ -e "$node/whole" ] || install_node > "$out/installing" 2>&1; then
    have_node=1
else
    tail -n 3 "$out/installing"
    skip "@mcap/core: npm could not install it"
fi

if [ -z "$have_python$have_node" ]; then exit "$failed"; fi

# A command of the Python environment: its scripts name the folder in which it was made.
from_python() { "$python/bin/python" -B "$@"; }
rerun() { from_python -m rerun "$@" 2>&1; }

readers=()
if [ -n "$have_python" ]; then readers+=(python_mcap python_rrd); fi
if [ -n "$have_node" ]; then readers+=(node_mcap); fi
python_mcap() { from_python read_mcap.py "$1"; }
python_rrd() { from_python read_rrd.py "$1"; }
node_mcap() { node read_mcap.mjs "$1" "$node"; }

mkdir "$out/recordings" "$out/altered"
(cd ../.. && cargo run --quiet "$@" --bin polhode -- run --all --format mcap,rrd,csv --out "$out/recordings" --quiet)

for reader in "${readers[@]}"; do
    echo "$reader"
    "$reader" "$out/recordings" || failed=1
done

if [ -n "$have_python" ]; then
    echo "rerun rrd verify, rerun mcap check"
    for file in "$out"/recordings/*.rrd; do
        said=$(rerun rrd verify "$file") || { echo "FAILED  $(basename "$file"): $said"; failed=1; }
    done
    for file in "$out"/recordings/*.mcap; do
        # Exits with 0 whatever it finds: every topic's line must begin with ok.
        said=$(rerun mcap check --full "$file") || { echo "FAILED  $(basename "$file"): $said"; failed=1; }
        topics=$(grep -c ' /' <<< "$said") || true
        if [ "$topics" -lt 2 ] || grep ' /' <<< "$said" | grep -qv '^ok '; then
            echo "FAILED  $(basename "$file"): $said"
            failed=1
        fi
    done
fi

cp "$out"/recordings/lagrange_top.* "$out/altered"
sed -i.whole '$ s/,[^,]*$/,1.5/' "$out/altered/lagrange_top.csv"
for reader in "${readers[@]}"; do
    if "$reader" "$out/altered" > /dev/null 2>&1; then
        echo "FAILED  $reader does not notice an altered value"
        failed=1
    fi
done
if [ "$failed" = 0 ]; then echo "every value agrees, and an altered one was noticed"; fi
exit "$failed"
