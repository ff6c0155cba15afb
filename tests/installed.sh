#!/bin/sh
# What `cmake --install` puts under a prefix works from there, with nothing around it. Argument: the build folder.
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$1" --prefix "$folder/prefix" >"$folder/log"
cd /
couloir() { env -i "$folder/prefix/bin/couloir" "$@"; }
couloir list | grep -q snow-avalanche
# One file by way of each part that is loaded late.
couloir compare landslide landslide-bcre --tick 1 --out "$folder/out" >"$folder/log"
for file in difference.tif difference.png; do
    [ -s "$folder/out/$file" ] || { echo "$file was not written"; exit 1; }
done
