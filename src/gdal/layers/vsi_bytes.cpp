#include "gdal/layers/vsi_bytes.h"

#include <cpl_vsi.h>

#include "base/error.h"
#include "gdal/gdal_errors.h"

namespace thiessen {

struct VsiBytes::File {
  VSILFILE* handle;
  std::uint64_t size = 0;
  std::uint64_t read = 0;
};

VsiBytes::VsiBytes(const std::string& file, const std::string& name)
    : file_(file), opened_(std::make_unique<File>()) {
  const GdalErrors errors;
  opened_->handle = VSIFOpenL(name.c_str(), "rb");
  if (opened_->handle == nullptr) throw Error(Message{file, 0, "cannot be opened", {}});
  VSIStatBufL status;
  if (VSIStatExL(name.c_str(), &status, VSI_STAT_EXISTS_FLAG | VSI_STAT_SIZE_FLAG) == 0)
    opened_->size = static_cast<std::uint64_t>(status.st_size);
}

VsiBytes::~VsiBytes() {
  const GdalErrors errors;
  if (opened_->handle != nullptr) VSIFCloseL(opened_->handle);
}

std::uint64_t VsiBytes::size() const {
  return opened_->size;
}

std::size_t VsiBytes::read_or_throw(char* buffer, std::size_t capacity) {
  const GdalErrors errors;
  const std::size_t count = VSIFReadL(buffer, 1, capacity, opened_->handle);
  if (errors.failed()) throw Error(Message{file_, 0, "cannot be read: " + errors.text(), {}});
  return count;
}

std::size_t VsiBytes::read(char* buffer, std::size_t capacity) {
  const std::size_t count = read_or_throw(buffer, capacity);
  opened_->read += count;
  if (count == 0 && capacity > 0 && opened_->read < opened_->size) {
    throw Error(Message{file_,
                        0,
                        "is cut off: " + std::to_string(opened_->read) + " of its " +
                            std::to_string(opened_->size) + " bytes are there",
                        {}});
  }
  return count;
}

std::string VsiBytes::read_at(std::uint64_t place, std::size_t count) {
  std::string bytes(count, '\0');
  if (place > opened_->size || VSIFSeekL(opened_->handle, place, SEEK_SET) != 0) return {};
  bytes.resize(read_or_throw(bytes.data(), count));
  return bytes;
}

bool vsi_exists(const std::string& name) {
  const GdalErrors errors;
  VSIStatBufL status;
  return VSIStatExL(name.c_str(), &status, VSI_STAT_EXISTS_FLAG) == 0;
}

}  // namespace thiessen
