#pragma once

#include <memory>
#include <string>

#include "text/byte_source.h"

namespace thiessen {

/// The bytes of a file under the name that GDAL gives it; the file may stand in an archive.
class VsiBytes final : public ByteSource {
 public:
  /// Opens a file. `name` is the file as GDAL is given it, `file` as messages name it. Throws Error
  /// where it cannot be opened.
  VsiBytes(const std::string& file, const std::string& name);
  ~VsiBytes() override;
  VsiBytes(const VsiBytes&) = delete;
  VsiBytes& operator=(const VsiBytes&) = delete;

  std::size_t read(char* buffer, std::size_t capacity) override;

 private:
  struct File;
  std::unique_ptr<File> opened_;
};

}  // namespace thiessen
