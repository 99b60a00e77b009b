#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// A file that was read, and the SHA-256 of its bytes.
struct FileDigest {
  std::string name;    ///< without its folder
  std::string sha256;  ///< 64 hexadecimal digits, or why there are none
};

/// The digests of an input: of a file; of a shapefile's parts; of the files of a folder, in the
/// order of their names. What is no plain file, as a pipe or a database, has none: it is not
/// opened. Throws Error where a file cannot be read. Cost: the bytes.
std::vector<FileDigest> digests_of(const std::string& input);

}  // namespace thiessen
