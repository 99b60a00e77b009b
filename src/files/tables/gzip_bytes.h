#pragma once

#include <memory>
#include <string>

#include "text/byte_source.h"

namespace thiessen {

/// The bytes that a gzip file packs, of one member or several.
class GzipBytes final : public ByteSource {
 public:
  /// Opens the file. Throws Error.
  explicit GzipBytes(const std::string& file);
  ~GzipBytes() override;
  GzipBytes(const GzipBytes&) = delete;
  GzipBytes& operator=(const GzipBytes&) = delete;

  /// Throws Error where the file is damaged or cut off.
  std::size_t read(char* buffer, std::size_t capacity) override;

 private:
  struct File;
  std::string file_;
  std::unique_ptr<File> opened_;
};

}  // namespace thiessen
