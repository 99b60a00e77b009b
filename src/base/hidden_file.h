#pragma once

#include <string>
#include <vector>

#include "base/descriptor.h"

namespace thiessen {

/// Opens a new file to write and read in the folder, which has no name until give_name gives it
/// one, and of which nothing is left if it never gets one. Not open where the file system has no
/// such files, or where the system could not name one; `errno` tells why.
Descriptor open_unnamed(const std::string& folder, unsigned mode);
/// Gives a file of open_unnamed a name. Returns 0, or -1 with `errno`: EEXIST where it is taken.
int give_name(const Descriptor& file, const std::string& name);

/// A hidden name for an older file while it is being replaced. It tells the file's own name.
std::string backup_name(const std::string& path);

/// A folder in which this run has hidden files. As long as it lives, no other run takes them for
/// left over: it holds a lock, which the system takes away when the run ends, however it ends.
class FolderInUse {
 public:
  /// Removes what killed runs left under hidden names, unless another run is using the folder. An
  /// older file that has no other name any more is kept.
  explicit FolderInUse(const std::string& folder);

  /// Removes the copies of older files of this name that killed runs left: it was replaced once
  /// more. Those of a name too long for a copy to tell stay.
  void forget(const std::string& path) noexcept;

 private:
  Descriptor lock_;
  std::vector<std::string> only_copies_;
};

/// The names of what lies in an open folder, in the order in which the system tells them. Throws
/// Error where it cannot be read, in which `path` is the file that cannot be written for it.
std::vector<std::string> names_in(const Descriptor& folder, const std::string& path);

/// Removes a folder, which is open or not, and the files in it. Takes no memory, and where it is
/// open no other file: they may be what is lacking.
void remove_folder_of_files(const std::string& folder, const Descriptor& opened) noexcept;

}  // namespace thiessen
