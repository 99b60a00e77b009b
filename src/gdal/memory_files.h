#pragma once

#include <string>
#include <vector>

#include "gdal/encoded_file.h"

namespace thiessen {

/// A folder of GDAL's in memory, for one dataset; it goes when this goes.
/// GDAL's writers do not notice a full disk, so that none of them is let near one.
class MemoryFolder {
 public:
  /// `path`: where the dataset is to lie in the end.
  explicit MemoryFolder(const std::string& path);
  ~MemoryFolder();
  MemoryFolder(const MemoryFolder&) = delete;
  MemoryFolder& operator=(const MemoryFolder&) = delete;

  /// Where GDAL is to write the dataset.
  const std::string& file() const { return file_; }
  /// Takes the files that GDAL wrote, the dataset's own first, side files by name; each gets the
  /// name that belongs to `path`. Throws Error where the dataset's own is missing or GDAL made a
  /// folder.
  std::vector<EncodedFile> take() const;

 private:
  std::string path_;
  std::string folder_;
  std::string file_;
};

}  // namespace thiessen
