#!/bin/sh
# Kernels are compiled for instruction sets that a machine may lack, but what initialises an object runs on every machine:
# do_nothing_before_main.sh KERNEL.o...
set -eu
[ $# -gt 1 ]
for object; do
    if nm -C "$object" | grep -E '__cxx_global_var_init|_GLOBAL__sub_I|__static_initialization'; then
        echo "^ runs before main, from $object"
        exit 1
    fi
done
