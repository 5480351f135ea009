#pragma once
/// \file
/// Counts what is taken from the heap, below the C++ and the C allocator: libraries call malloc.
/// Included by one file of an executable. TLSPH_COUNTS_ALLOCATIONS is set where it can.

#include <atomic>
#include <cstddef>

// Includes what declares some of the names below once more, as clang wants it: before they are
// defined.
#include "tlsph/core/types.hpp"

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define TLSPH_COUNTS_ALLOCATIONS

namespace {
std::atomic<long> allocations{0};
}

// NOLINTBEGIN: the names are those of the C library.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);

void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) {
  ++allocations;
  return __libc_realloc(block, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
  ++allocations;
  *block = __libc_memalign(alignment, size);
  return *block == nullptr ? 12 : 0;  // ENOMEM
}
}
// NOLINTEND

#endif
