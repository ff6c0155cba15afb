#!/usr/bin/env bash
# Kills a recording session again and again, at random moments within a second of its first byte, and tells how much of
# each file is proven: tests/kill_study.sh [TIMES] [PROGRAM]. A line each: seconds until the kill, bytes left, up to which
# tick it is proven, or what was said instead. Status 1 where a file is neither proven nor torn within its first line.
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
    seconds=$(awk -v r=$RANDOM 'BEGIN { printf "%.3f", r / 32768 }')
    "$program" run landslide --seconds 3600 --record "$file" >/dev/null 2>&1 &
    until [ -e "$file" ]; do sleep 0.002; done
    sleep "$seconds"
    kill -KILL $!
    wait $! 2>/dev/null
    said=$("$program" replay "$file" --verify 2>&1)
    proven=$(grep -oE 'proven up to tick [0-9]+' <<<"$said" | grep -oE '[0-9]+$')
    if [ -z "$proven" ]; then
        proven=$(grep -oE 'cut off within the header|: empty' <<<"$said" | head -n 1)
        [ -n "$proven" ] || { proven="UNPROVEN: $said" status=1; }
    fi
    echo "$seconds,$(stat -c %s "$file"),$proven"
done
exit $status
