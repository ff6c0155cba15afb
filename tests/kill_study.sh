#!/usr/bin/env bash
# Kills a recording session again and again, at random moments within two seconds, and tells how much of each file is
# proven: tests/kill_study.sh [TIMES] [PROGRAM]. A line each: seconds until the kill, bytes left, ticks proven or what was
# said instead. Status 1 where a file is neither proven nor torn within its first line.
set -u

times=${1:-200}
program=${2:-build/release/bin/couloir}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
file=$folder/session.couloir
status=0

echo 'seconds,bytes,proven'
for ((i = 0; i < times; ++i)); do
    rm -f "$file"
    seconds=$(awk -v r=$RANDOM 'BEGIN { printf "%.3f", 0.01 + 2 * r / 32768 }')
    timeout -s KILL "$seconds" "$program" run landslide --seconds 3600 --record "$file" >/dev/null 2>&1
    said=$("$program" replay "$file" --verify 2>&1)
    proven=$(grep -oE 'proven up to tick [0-9]+' <<<"$said" | grep -oE '[0-9]+$')
    if [ -z "$proven" ]; then
        proven=$(grep -oE 'torn off within the header|empty|no such file' <<<"$said" | head -n 1)
        [ -n "$proven" ] || { proven="UNPROVEN: $said" status=1; }
    fi
    echo "$seconds,$(stat -c %s "$file" 2>/dev/null || echo 0),$proven"
done
exit $status
