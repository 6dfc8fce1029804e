// SPDX-License-Identifier: GPL-3.0-or-later
#include "faults/failing_memory.h"

#include <link.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>

// Of glibc: malloc and its like, unless they were replaced.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
}

namespace loopmend::test {
namespace {

struct Range {
  std::uintptr_t begin = 0, end = 0;
};

/// Nothing here may allocate.
struct {
  std::array<Range, 64> granted;  ///< code of the libraries that have no way to fail
  std::size_t granted_count = 0;
  std::atomic<bool> on = false;
  std::atomic<long> requests = 0;
  std::atomic<long> in_use = 0;
  const MemoryPlan* plan = nullptr;
} memory;

int note_library(dl_phdr_info* library, std::size_t, void*) {
  constexpr std::array names = {"/libc.so", "/ld-linux",    "/libtbb", "/libopenblas", "/libblas", "/liblapack",
                                "/libgomp", "/libgfortran", "/libgmp", "/libgcc_s",    "vdso"};
  const bool noted = std::any_of(names.begin(), names.end(),
                                 [&](const char* name) { return std::strstr(library->dlpi_name, name) != nullptr; });
  for (int k = 0; noted && k < library->dlpi_phnum; ++k) {
    const auto& part = library->dlpi_phdr[k];
    if (part.p_type != PT_LOAD || memory.granted_count == memory.granted.size()) continue;
    const std::uintptr_t begin = library->dlpi_addr + part.p_vaddr;
    memory.granted[memory.granted_count++] = {begin, begin + part.p_memsz};
  }
  return 0;
}

bool refuses(const void* caller) {
  if (!memory.on.load(std::memory_order_acquire)) return false;
  const auto at = reinterpret_cast<std::uintptr_t>(caller);
  for (std::size_t k = 0; k < memory.granted_count; ++k)
    if (at >= memory.granted[k].begin && at < memory.granted[k].end) return false;
  const MemoryPlan& plan = *memory.plan;
  const long number = memory.requests++;
  if (number == plan.cancel_at) plan.token.cancel();
  return plan.after == MemoryPlan::After::refused ? number >= plan.first_refused : number == plan.first_refused;
}

void* counted(void* block) {
  if (block) memory.in_use.fetch_add(1, std::memory_order_relaxed);
  return block;
}

void* get(std::size_t size, const void* caller) {
  if (!refuses(caller)) return counted(__libc_malloc(size));
  errno = ENOMEM;
  return nullptr;
}

void* get_aligned(std::size_t alignment, std::size_t size, const void* caller) {
  if (!refuses(caller)) return counted(__libc_memalign(alignment, size));
  errno = ENOMEM;
  return nullptr;
}

void put_back(void* block) {
  if (block) memory.in_use.fetch_sub(1, std::memory_order_relaxed);
  __libc_free(block);
}

void* or_throw(void* block) {
  if (!block) throw std::bad_alloc();
  return block;
}

}  // namespace

WithPlan::WithPlan(const MemoryPlan& plan) {
  memory.granted_count = 0;
  dl_iterate_phdr(note_library, nullptr);
  memory.plan = &plan;
  memory.requests = 0;
  memory.on = true;
}

WithPlan::~WithPlan() { memory.on = false; }

long WithPlan::requests() { return memory.requests; }

long blocks_in_use() { return memory.in_use; }

}  // namespace loopmend::test

using loopmend::test::get;
using loopmend::test::get_aligned;
using loopmend::test::or_throw;
using loopmend::test::put_back;

#define CALLER __builtin_return_address(0)

extern "C" {
void* malloc(std::size_t size) { return get(size, CALLER); }
void* calloc(std::size_t count, std::size_t size) {
  if (!loopmend::test::refuses(CALLER)) return loopmend::test::counted(__libc_calloc(count, size));
  errno = ENOMEM;
  return nullptr;
}
void* realloc(void* block, std::size_t size) {
  if (!block) return get(size, CALLER);
  if (size == 0) {
    put_back(block);
    return nullptr;
  }
  if (!loopmend::test::refuses(CALLER)) return __libc_realloc(block, size);
  errno = ENOMEM;
  return nullptr;
}
void* memalign(std::size_t alignment, std::size_t size) { return get_aligned(alignment, size, CALLER); }
void* aligned_alloc(std::size_t alignment, std::size_t size) { return get_aligned(alignment, size, CALLER); }
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  *block = get_aligned(alignment, size, CALLER);
  return *block ? 0 : ENOMEM;
}
void free(void* block) { put_back(block); }
}

// The standard library's own would call malloc from within that library: the caller would be lost.
void* operator new(std::size_t size) { return or_throw(get(std::max<std::size_t>(size, 1), CALLER)); }
void* operator new[](std::size_t size) { return or_throw(get(std::max<std::size_t>(size, 1), CALLER)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return get(size, CALLER); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return get(size, CALLER); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return or_throw(get_aligned(static_cast<std::size_t>(alignment), size, CALLER));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return or_throw(get_aligned(static_cast<std::size_t>(alignment), size, CALLER));
}
void operator delete(void* block) noexcept { put_back(block); }
void operator delete[](void* block) noexcept { put_back(block); }
void operator delete(void* block, std::size_t) noexcept { put_back(block); }
void operator delete[](void* block, std::size_t) noexcept { put_back(block); }
void operator delete(void* block, std::align_val_t) noexcept { put_back(block); }
void operator delete[](void* block, std::align_val_t) noexcept { put_back(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { put_back(block); }
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept { put_back(block); }
