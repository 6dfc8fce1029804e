// SPDX-License-Identifier: GPL-3.0-or-later
// What the programs tell libraries that begin before main().

#ifdef __linux__

extern "C" {
[[gnu::weak]] extern int blas_cpu_number, blas_num_threads;  // of OpenBLAS, where that is the BLAS
int blas_get_cpu_number();
}

/// OpenBLAS calls this function of its own when it is loaded, and finds that of the program in its place. By itself it would
/// start a thread for each core, of which the engine uses none. Each of them spins for a tenth of a second before it sleeps, asks
/// for 128 MB and, where `ulimit -v` withholds them, waits for ever; where `ulimit -u` allows no thread, OpenBLAS raises SIGINT.
int blas_get_cpu_number() { return blas_cpu_number = blas_num_threads = 1; }

#endif
