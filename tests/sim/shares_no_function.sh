#!/bin/sh
# Kernels are compiled for instruction sets that a machine may lack. If one of their functions were defined in another object
# too, the linker might take theirs for all. So no symbol that the linker may choose (weak or unique) is in two of the objects
# that are given, which are those of the libraries and of their kernels: shares_no_function.sh KERNEL.o... -- OTHER.o...
# Nor do kernels call any function but those that fill and copy memory: the C library's exp has other bits elsewhere. A
# table of the linker's, in position-independent code, is no function.
set -eu
chosen() { nm -C "$1" | sed -n 's/^[0-9a-f]* [Wu] //p' | sort -u; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
kernels=0
for object; do
    if [ "$object" = -- ]; then break; fi
    kernels=$((kernels + 1))
    if nm -u "$object" | grep -vE ' (memset|memcpy|memmove|__gxx_personality_v0|_GLOBAL_OFFSET_TABLE_|_ZN3sim12check_failed.*)$'; then
        echo "^ called by $object"
        exit 1
    fi
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
