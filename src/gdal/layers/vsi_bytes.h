#pragma once

#include <cstddef>
#include <cstdint>
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

  std::uint64_t size() const;
  /// Reads on. Throws Error where an archive turns out to be damaged, and at the end where less
  /// came than the file is long.
  std::size_t read(char* buffer, std::size_t capacity) override;
  /// Reads `count` bytes from a place on, or fewer at the end.
  std::string read_at(std::uint64_t place, std::size_t count);

 private:
  std::size_t read_or_throw(char* buffer, std::size_t capacity);

  struct File;
  std::string file_;
  std::unique_ptr<File> opened_;
};

/// Whether there is a file of this name, as GDAL is given it.
bool vsi_exists(const std::string& name);

}  // namespace thiessen
