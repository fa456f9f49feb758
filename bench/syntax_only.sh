#!/bin/sh
# A launcher for a compiler that is to check a file and make nothing of it: the object file is left empty.
"$@" -fsyntax-only || exit
while [ "$1" != -o ]; do shift; done
: >"$2"
