#pragma once

#include <sys/stat.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/descriptor.h"

namespace thiessen {

/// The rules for which files a run may replace.
struct OutputRules {
  bool overwrite = false;  ///< whether a file that exists may be replaced
  /// Files that no output may be, by whatever name. Those that do not exist are passed over.
  std::vector<std::string> inputs;
};

/// What is found at a name that is to be written.
struct Destination {
  enum class Kind {
    nothing,  ///< a new file, with the mode that the umask leaves
    file,     ///< a plain file, whose mode the new one takes over
    link,     ///< a symbolic link to a file: the link itself is replaced
    stream,   ///< a pipe or a character device
  };
  Kind kind = Kind::nothing;
  struct stat status = {};  ///< the status of what is there, after following links
};

/// Looks at a name before it is written. Throws Error where the name is empty, a folder, a disk, a
/// link that leads nowhere, an input of the run, or a file that may not be replaced.
Destination examine_destination(const std::string& path, const OutputRules& rules);

/// Whether what is written to this name goes to the standard output or another open file, a pipe or
/// a device, and not into a file of its own.
bool goes_to_stream(const std::string& path);

/// The number of the open file that names such as /dev/stdout and /dev/fd/3 stand for, or nothing
/// for other names.
std::optional<int> standing_descriptor(const std::string& path);

/// The folder that a path is in, or "." where it names none.
std::string folder_of(const std::string& path);
/// The last part of a path: the name within its folder.
std::string name_in_folder(const std::string& path);

/// Makes up a hidden, random name in the folder that nobody else uses.
std::string fresh_name(const std::string& folder);
/// Whether fresh_name may have made up this name within a folder.
bool is_fresh_name(std::string_view name);
/// How long the names are that fresh_name makes up, without their folder.
std::size_t fresh_name_length();

}  // namespace thiessen
