// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/memory.h"

#include <algorithm>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#endif

#ifdef LOOPMEND_OPENBLAS
// The buffers that each thread works in. What is freed stays mapped for the next that asks.
extern "C" void* blas_memory_alloc(int kind);
extern "C" void blas_memory_free(void* buffer);
#endif

namespace loopmend {

namespace {

constexpr std::size_t megabyte = 1 << 20;
constexpr std::size_t buffer_size = 129 * megabyte;  // 128 MB, aligned
constexpr std::size_t buffers_per_thread = 2;        // a thread lets another do half of a factorisation
constexpr std::size_t spare = 64 * megabyte;         // for the work itself: stacks, and a small mesh

#if defined(__GLIBC__) && defined(LOOPMEND_OPENBLAS)
bool address_space_is_limited() {
  rlimit limit{};
  return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

bool can_be_had(std::size_t bytes) {
  void* probe = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (probe == MAP_FAILED) return false;
  munmap(probe, bytes);
  return true;
}
#endif

}  // namespace

const std::size_t least_work_memory = buffers_per_thread * buffer_size + spare;

int claim_work_memory(int threads) {
#if defined(__GLIBC__) && defined(LOOPMEND_OPENBLAS)
  if (!address_space_is_limited()) return threads;
  const auto wanted = buffers_per_thread * static_cast<std::size_t>(std::clamp(threads, 1, 32));
  std::vector<void*> buffers;
  while (buffers.size() < wanted && can_be_had(buffer_size + spare)) buffers.push_back(blas_memory_alloc(0));
  for (void* buffer : buffers) blas_memory_free(buffer);
  return static_cast<int>(buffers.size() / buffers_per_thread);
#else
  return threads;
#endif
}

void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int block = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * block);  // blocks from there on are always given back: glibc allows no more
  mallopt(M_TRIM_THRESHOLD, 256 * block);
#endif
}

void give_back_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

}  // namespace loopmend
