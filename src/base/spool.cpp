#include "base/spool.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <string>

#include "base/interrupt.h"

namespace thiessen {
namespace {

constexpr std::size_t piece_bytes = std::size_t{256} << 10;

}  // namespace

Descriptor open_spool() {
  const char* const wanted = std::getenv("TMPDIR");
  for (const char* folder : {wanted, "/tmp"}) {
    if (folder == nullptr || *folder == '\0') continue;
    Descriptor file = open_descriptor(folder, O_TMPFILE | O_RDWR | O_EXCL, 0600);
    if (file.is_open()) return file;
  }
  Descriptor memory(::memfd_create("thiessen", MFD_CLOEXEC));
  if (!memory.is_open()) throw system_error(spool_name, "cannot be made", errno);
  return memory;
}

std::size_t read_spool(const Descriptor& spool, std::uint64_t at, std::span<char> into) {
  std::size_t filled = 0;
  while (filled < into.size()) {
    const std::span<char> rest = into.subspan(filled);
    const ssize_t count =
        ::pread(spool.number(), rest.data(), rest.size(), static_cast<off_t>(at + filled));
    if (count == 0) break;
    if (count < 0 && errno != EINTR) throw system_error(spool_name, "cannot read", errno);
    if (count > 0) filled += static_cast<std::size_t>(count);
  }
  return filled;
}

void copy_spool(const Descriptor& spool, const std::function<void(std::string_view)>& take) {
  std::string piece(piece_bytes, '\0');
  for (std::uint64_t at = 0;;) {
    throw_if_interrupted();
    const std::size_t count = read_spool(spool, at, piece);
    if (count == 0) return;
    take(std::string_view(piece).substr(0, count));
    at += count;
  }
}

}  // namespace thiessen
