#pragma once

#include <string>

namespace thiessen {

/// A file as it is to be written to disk.
struct EncodedFile {
  std::string name;   ///< its path: as asked for, or a side file's beside it
  std::string bytes;  ///< empty where it stands on the disk already (RasterOutput::file_on_disk)
};

}  // namespace thiessen
