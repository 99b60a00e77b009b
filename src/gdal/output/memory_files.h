#pragma once

#include <string>
#include <vector>

#include "gdal/output/encoded_file.h"

namespace thiessen {

/// A folder in GDAL's memory for one dataset; it is removed with this object. GDAL's writers do not
/// notice a full disk, so none of them writes to one directly (see DiskFile for large rasters).
class MemoryFolder {
 public:
  /// `path` is where the dataset is to lie in the end.
  explicit MemoryFolder(const std::string& path);
  ~MemoryFolder();
  MemoryFolder(const MemoryFolder&) = delete;
  MemoryFolder& operator=(const MemoryFolder&) = delete;

  /// The path in memory to which GDAL is to write the dataset.
  const std::string& file() const { return file_; }
  /// Puts bytes there, for GDAL to go on with.
  void put(const std::string& bytes) const;
  /// Copies the files that GDAL wrote: the dataset's own first, then side files by name. Each gets
  /// the name that belongs to `path`. Throws Error where the dataset's own file is missing or GDAL
  /// made a folder.
  std::vector<EncodedFile> take() const;

 private:
  std::string path_;
  std::string folder_;
  std::string file_;
};

}  // namespace thiessen
