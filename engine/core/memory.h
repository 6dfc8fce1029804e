// SPDX-License-Identifier: GPL-3.0-or-later
// How a program that evolves patches treats memory.
#pragma once

#include <cstddef>

namespace loopmend {

/// For programs, once at their start; the engine itself does not touch such things. What is freed is kept, up to 256 MB, for
/// what is asked for next: each step of a flow needs the same blocks again, and to give them back to the system and get
/// them again, page by page, takes a fifth of its time at some thousand vertices. Does nothing where the C library is not
/// glibc.
void keep_freed_memory();

/// For programs, once before patches are evolved. Where the address space is limited (`ulimit -v`), takes what the linear
/// algebra of so many threads at once will ask for, and holds it to the end: OpenBLAS has no way to fail, it would ask
/// for ever. Does nothing where there is no limit, with another C library than glibc, or another BLAS than OpenBLAS.
/// @returns for how many threads there is enough, at most `threads`; 0: `least_work_memory` is missing.
int claim_work_memory(int threads);

/// Bytes of address space that one thread needs for its work.
extern const std::size_t least_work_memory;

/// What was kept goes back to the system: for a program at leisure. Takes some milliseconds.
void give_back_freed_memory();

}  // namespace loopmend
