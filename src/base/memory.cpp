#include "base/memory.h"

#include <sys/mman.h>

#include <atomic>
#include <cerrno>

namespace thiessen {

namespace {

std::atomic<bool> has_lacked = false;

}  // namespace

bool can_have(std::size_t bytes) noexcept {
  if (bytes == 0) return true;
  const int before = errno;
  void* const place =
      ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  const bool is_had = place != MAP_FAILED;
  if (is_had) ::munmap(place, bytes);
  errno = before;
  return is_had;
}

void note_lack_of_memory() noexcept {
  has_lacked.store(true, std::memory_order_relaxed);
}

bool has_lacked_memory() noexcept {
  return has_lacked.load(std::memory_order_relaxed);
}

void forget_lack_of_memory() noexcept {
  has_lacked.store(false, std::memory_order_relaxed);
}

}  // namespace thiessen
