#pragma once

#include <sys/stat.h>

#include <optional>
#include <string>
#include <vector>

#include "base/descriptor.h"

namespace thiessen {

/// Which files may be replaced.
struct OutputRules {
  bool overwrite = false;  ///< whether a file that exists may be replaced
  std::vector<std::string>
      inputs;  ///< files that no output may be, whatever it is called; others are passed over
};

/// What stands at a name that is to be written.
struct Destination {
  enum class Kind {
    nothing,  ///< a new file, with the mode that the umask leaves
    file,     ///< a plain file, whose mode the new one takes over
    link,     ///< a symbolic link to a file: the link itself is replaced
    stream,   ///< a pipe or a character device
  };
  Kind kind = Kind::nothing;
  struct stat status = {};  ///< of what is there, through links
};

/// Looks at a name before it is written. Throws Error where it is empty, a folder, a disk, a link
/// that leads nowhere, an input of the run, or a file that may not be replaced.
Destination examine_destination(const std::string& path, const OutputRules& rules);

/// The open file that names such as /dev/stdout and /dev/fd/3 stand for.
std::optional<int> standing_descriptor(const std::string& path);

/// The folder a name is in, "." where it has none; the name within it.
std::string folder_of(const std::string& path);
std::string name_in_folder(const std::string& path);

/// A name in the folder, hidden and random, that nobody else uses.
std::string fresh_name(const std::string& folder);

}  // namespace thiessen
