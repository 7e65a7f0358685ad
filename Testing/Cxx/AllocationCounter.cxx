// SPDX-FileCopyrightText: Copyright (c) The Bravais authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AllocationCounter.h"

#include <atomic>
#include <cerrno>
#include <malloc.h>

namespace
{

std::atomic<std::size_t> Allocated{ 0 };
std::atomic<std::size_t> Peak{ 0 };

void Add(std::size_t bytes)
{
  const std::size_t now = Allocated.fetch_add(bytes) + bytes;
  std::size_t peak = Peak.load();
  while (now > peak && !Peak.compare_exchange_weak(peak, now))
  {
  }
}

} // namespace

std::size_t GetAllocatedBytes()
{
  return Allocated;
}

std::size_t GetAllocationPeak()
{
  return Peak;
}

void ResetAllocationPeak()
{
  Peak = Allocated.load();
}

#ifdef __SANITIZE_ADDRESS__

// The sanitizer has a malloc of its own, which calls these two.
// g++ has no header of them.
extern "C"
{
  std::size_t __sanitizer_get_allocated_size(const volatile void* pointer);
  void __sanitizer_malloc_hook(const volatile void* pointer, std::size_t size);
  void __sanitizer_free_hook(const volatile void* pointer);

  void __sanitizer_malloc_hook(const volatile void*, std::size_t size)
  {
    Add(size);
  }
  void __sanitizer_free_hook(const volatile void* pointer)
  {
    Allocated -= __sanitizer_get_allocated_size(pointer);
  }
}

#else

// glibc's functions, under the names that are kept when a program replaces them.
extern "C"
{
  void* __libc_malloc(std::size_t size);
  void* __libc_calloc(std::size_t count, std::size_t size);
  void* __libc_realloc(void* pointer, std::size_t size);
  void* __libc_memalign(std::size_t alignment, std::size_t size);
  void __libc_free(void* pointer);

  static void* Count(void* pointer)
  {
    Add(malloc_usable_size(pointer));
    return pointer;
  }

  void* malloc(std::size_t size)
  {
    return Count(__libc_malloc(size));
  }
  void* calloc(std::size_t count, std::size_t size)
  {
    return Count(__libc_calloc(count, size));
  }
  void* memalign(std::size_t alignment, std::size_t size)
  {
    return Count(__libc_memalign(alignment, size));
  }
  void* aligned_alloc(std::size_t alignment, std::size_t size)
  {
    return memalign(alignment, size);
  }
  int posix_memalign(void** pointer, std::size_t alignment, std::size_t size)
  {
    *pointer = memalign(alignment, size);
    return *pointer ? 0 : ENOMEM;
  }
  void* realloc(void* pointer, std::size_t size)
  {
    // Both blocks exist for a while, unless the C library can stretch or move pages.
    const std::size_t before = malloc_usable_size(pointer);
    void* moved = __libc_realloc(pointer, size);
    if (moved || size == 0)
    {
      Allocated -= before;
      Count(moved);
    }
    return moved;
  }
  void free(void* pointer)
  {
    Allocated -= malloc_usable_size(pointer);
    __libc_free(pointer);
  }
}

#endif
