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

void copy_spool(const Descriptor& spool, const std::function<void(std::string_view)>& take) {
  std::string piece(piece_bytes, '\0');
  for (off_t at = 0;;) {
    throw_if_interrupted();
    const ssize_t count = ::pread(spool.number(), piece.data(), piece.size(), at);
    if (count == 0) return;
    if (count < 0 && errno != EINTR) throw system_error(spool_name, "cannot read", errno);
    if (count < 0) continue;
    take(std::string_view(piece).substr(0, static_cast<std::size_t>(count)));
    at += count;
  }
}

}  // namespace thiessen
