#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gdal/output/encoded_file.h"

namespace thiessen {

/// A dataset that GDAL writes to the disk by way of our own writing, because its own does not
/// always notice a full one. A folder of its own is needed, for its side files are told by lying
/// there.
class DiskFile {
 public:
  /// `file` is where it is written, `path` where it is to lie in the end, and its name in messages.
  DiskFile(std::string file, std::string path);
  ~DiskFile();
  DiskFile(const DiskFile&) = delete;
  DiskFile& operator=(const DiskFile&) = delete;

  /// The path to which GDAL is to write the dataset.
  const std::string& name_for_gdal() const { return name_for_gdal_; }
  /// Throws Error where something could not be written, with the system's reason.
  void check() const;
  /// Takes the side files from the disk, and gives them with the names that belong to `path`, after
  /// an entry for the dataset itself, without bytes. Throws Error where they cannot be read.
  std::vector<EncodedFile> take() const;

  /// What is kept of a dataset while GDAL writes it.
  struct Watched;

 private:
  std::string file_;
  std::string path_;
  std::string name_for_gdal_;
  std::shared_ptr<Watched> watched_;
};

}  // namespace thiessen
