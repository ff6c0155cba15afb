#!/bin/sh
# Kernels are compiled for instruction sets that a machine may lack. A function that they shared with the rest of the program, the
# linker might take from them: each of theirs that the linker may choose among bears their lanes in its name. Arguments: object
# files, of which those of kernels are looked at.
looked_at=0
for object; do
    case $object in *_baseline.cpp.* | *_v[34].cpp.*) ;; *) continue ;; esac
    looked_at=$((looked_at + 1))
    if nm -C "$object" | grep ' [Wu] ' | grep -v 'simd<'; then
        echo "^ of $object"
        exit 1
    fi
done
[ $looked_at -gt 0 ] && [ $((looked_at % 3)) = 0 ]
