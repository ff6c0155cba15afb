#!/bin/sh
# Checks that kernels share no function with other objects: shares_no_function.sh KERNEL.o... -- OTHER.o...
# Kernels are compiled for instruction sets that a machine may lack. If another object defined one of their functions too, the
# linker might use the kernel's version everywhere. So no weak or unique symbol may be in two of the objects, which are those of
# the libraries and of their kernels.
set -eu
chosen() { nm -C "$1" | sed -n 's/^[0-9a-f]* [Wu] //p' | sort -u; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
kernels=0
for object; do
    if [ "$object" = -- ]; then break; fi
    kernels=$((kernels + 1))
    chosen "$object" >"$folder/kernel"
    for other; do
        if [ "$other" = "$object" ] || [ "$other" = -- ]; then continue; fi
        chosen "$other" | comm -12 - "$folder/kernel" >"$folder/shared"
        if [ -s "$folder/shared" ]; then
            cat "$folder/shared"
            echo "^ in $object and $other"
            exit 1
        fi
    done
done
[ $kernels -gt 1 ]
