#include "gdal/layers/vsi_bytes.h"

#include <cpl_vsi.h>

#include "base/error.h"

namespace thiessen {

struct VsiBytes::File {
  VSILFILE* handle;
};

VsiBytes::VsiBytes(const std::string& file, const std::string& name)
    : opened_(std::make_unique<File>(File{VSIFOpenL(name.c_str(), "rb")})) {
  if (opened_->handle == nullptr) throw Error(Message{file, 0, "cannot be opened", {}});
}

VsiBytes::~VsiBytes() {
  if (opened_->handle != nullptr) VSIFCloseL(opened_->handle);
}

std::size_t VsiBytes::read(char* buffer, std::size_t capacity) {
  return VSIFReadL(buffer, 1, capacity, opened_->handle);
}

}  // namespace thiessen
