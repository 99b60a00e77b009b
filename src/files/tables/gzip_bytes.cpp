#include "files/tables/gzip_bytes.h"

#include <fcntl.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>

#include "base/descriptor.h"
#include "base/error.h"

namespace thiessen {

struct GzipBytes::File {
  gzFile handle = nullptr;
};

GzipBytes::GzipBytes(const std::string& file) : file_(file), opened_(std::make_unique<File>()) {
  Descriptor opened = open_descriptor(file, O_RDONLY);
  if (!opened.is_open()) throw system_error(file, "cannot open", errno);
  opened_->handle = gzdopen(opened.number(), "rb");
  if (opened_->handle == nullptr)
    throw Error(Message{file, 0, "cannot be unpacked: not enough memory", {}});
  opened.release();  // zlib closes the file
}

GzipBytes::~GzipBytes() {
  if (opened_->handle != nullptr) gzclose_r(opened_->handle);
}

std::size_t GzipBytes::read(char* buffer, std::size_t capacity) {
  constexpr std::size_t most = std::size_t{1} << 30U;
  const int count =
      gzread(opened_->handle, buffer, static_cast<unsigned>(std::min(capacity, most)));
  int fault = Z_OK;
  std::string reason = gzerror(opened_->handle, &fault);
  // zlib begins with what it takes for the file's name.
  if (const std::size_t name = reason.find(": "); name != std::string::npos)
    reason.erase(0, name + 2);
  // At the end of a file that is cut off, gzread gives what there is and leaves this fault behind.
  if (fault == Z_BUF_ERROR && count <= 0)
    throw Error(Message{file_, 0, "is cut off: the gzip archive has no end", {}});
  if (count < 0) throw Error(Message{file_, 0, "cannot be unpacked: " + reason, {}});
  return static_cast<std::size_t>(count);
}

}  // namespace thiessen
