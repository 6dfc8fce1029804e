#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The program is as LOOPMEND_HARDEN makes it. Usage: check_hardening.sh PROGRAM COMPILER   (as CMake names it)
# Exit code: 0 it is, 1 something is missing, 77 there is no readelf.
set -euo pipefail

command -v readelf >/dev/null || { echo "skipped: there is no readelf" >&2; exit 77; }
program=$1
# has WHAT PATTERN TEXT
has() {
  grep -qE "$2" <<<"$3" || { echo "$program: no $1" >&2; exit 1; }
}
has "position-independent code" 'Type: +DYN' "$(readelf -hW "$program")"
has "read-only relocations" 'GNU_RELRO' "$(readelf -lW "$program")"
has "immediate binding" 'BIND_NOW|Flags:.* NOW' "$(readelf -dW "$program")"
symbols=$(readelf --dyn-syms -W "$program")
has "stack protector" '__stack_chk_fail' "$symbols"
# Of the checks in the headers of glibc 2.36, Clang 14 can use next to none.
[[ $2 == Clang ]] || has "checked calls of the C library (FORTIFY)" '__(memcpy|memmove|memset|fprintf|snprintf|read|vsnprintf)_chk' "$symbols"
