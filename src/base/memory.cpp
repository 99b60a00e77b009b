#include "base/memory.h"

#include <sys/mman.h>

#include <cerrno>

namespace thiessen {

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

}  // namespace thiessen
