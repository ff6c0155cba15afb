#!/bin/sh
# What `cmake --install` puts under a prefix works from there, with nothing around it. Arguments: the build folder, and Python.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$1" --prefix "$folder/prefix" >"$folder/log"
cd /
couloir() { env -i "$folder/prefix/bin/couloir" "$@"; }
couloir list | grep -q snow-avalanche
# Python's module finds its assets there too.
module=$(find "$folder/prefix/lib/couloir/python" -name 'couloir.*.so' 2>"$folder/log" || true)
if [ -n "$module" ]; then
    env -i PYTHONPATH="${module%/*}" "$2" -B -c 'import couloir; couloir.World("snow-avalanche", grid=16).step(9)'
fi
# One file by way of each part that is loaded late.
couloir compare landslide landslide-bcre --tick 1 --out "$folder/out" >"$folder/log"
for file in difference.tif difference.png; do
    [ -s "$folder/out/$file" ] || { echo "$file was not written"; exit 1; }
done
