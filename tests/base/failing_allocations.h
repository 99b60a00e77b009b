#pragma once

#include <cstdlib>
#include <new>

/// \file
/// Replaces the program's operator new by one that fails when it is told to. A program may include
/// it in one source alone, which begins with `// Compiled alone`.

namespace {

// Allocations until one fails; none does while it is negative.
long left = -1;

void* allocate(std::size_t size) {
  if (left > 0 && --left == 0) {
    left = -1;
    throw std::bad_alloc();
  }
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
  return allocate(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return allocate(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}
