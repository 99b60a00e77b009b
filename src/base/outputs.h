#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/descriptor.h"
#include "base/destination.h"
#include "base/file.h"
#include "base/hidden_file.h"

namespace thiessen {

/// The files that a run writes: either all of them appear, whole, or none does.
///
/// Each file is written and synced without a name, or, where the file system has no such files and
/// where a library writes, under a hidden one (`.thiessen-` and random letters), in the folder of
/// its final name. `commit` names them when all are on the disk. Until then, and where anything
/// fails or the object is destroyed first, the folder looks as before; what a killed run left under
/// hidden names is removed by the next that writes there (base/hidden_file). A file that is
/// replaced passes its mode (and, where the system allows it, its owner) on to the new one. A
/// symbolic link is itself replaced, not followed. What goes to a pipe, a device or the standard
/// output waits (see OutputFile::Care::held) until all files are on the disk, and is handed over
/// before the first is renamed: so a run that fails has printed nothing, unless the pipe or device
/// itself failed.
///
/// Laws: (1) Another process that opens a final name sees the old file or the new one, whole. (2)
/// Where a later rename fails, the earlier ones are undone. Where that fails too, the Error names
/// the hidden files that the older ones are kept as; and a file that was replaced on a file system
/// without hard links. (3) Without `overwrite` no file is replaced, not even one that appears
/// during the run.
class Outputs {
 public:
  explicit Outputs(OutputRules rules);
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;
  ~Outputs();

  /// Has what goes to a pipe, a device or the standard output go there as it is flushed, and not
  /// wait: for a series that comes by a pipe and may have no end. Of outputs added from now on.
  void pass_on_at_once() { stream_care_ = OutputFile::Care::closed; }

  /// Opens a file to append to; `-` is the standard output, as /dev/stdout is. The reference lasts
  /// as long as this object. Throws Error where the name cannot or may not be written; after that,
  /// this object can only be destroyed.
  OutputFile& add(const std::string& path);

  /// Makes a name at which a library may write a file of its own, with any side files beside it: it
  /// has the same last part as `path`, in a hidden folder. `commit` moves everything that it finds
  /// there. Throws Error as `add` does, and where the path is no plain file.
  std::string add_foreign(const std::string& path);

  /// Whether the path is a pipe, a device or a standard stream, of which there can be no hidden
  /// one. Throws Error as `add` does.
  bool is_stream(const std::string& path) const;

  /// Has `commit` remove a file, if there is one: a side file of an older output, which would be
  /// taken for one of the new. Throws Error where it may not be replaced.
  void remove(const std::string& path);

  /// Has `commit` make the folder if it does not exist; it is made at once where a file in it needs
  /// a hidden name. It is removed again unless `commit` succeeds. Throws Error where there can be
  /// no such folder.
  void make_folder(const std::string& path);

  /// Finishes, syncs and renames all files. Throws Error where anything fails, and Interrupted only
  /// before the first rename. Nothing can be added afterwards.
  void commit();

  /// Takes away what all objects that live have put under hidden names and not yet committed, and
  /// what they have renamed. For a program that ends at once, whatever it is at: takes no memory.
  static void abandon_all() noexcept;

 private:
  struct Staged {
    std::string path;
    std::string hidden;  ///< the hidden name; empty while it has none, and once it is renamed
    std::string backup;  ///< another name of the file that was replaced, until all is done
    bool renamed = false;
    bool replaced = false;
    bool is_kept = false;  ///< whether the older file could not be brought back from its backup
  };
  struct Removed {
    std::string path;
    bool is_there = false;
    std::string backup = {};  ///< its name until all is done; empty while it has its own
    bool is_kept = false;
  };
  struct Foreign {
    std::string path;
    std::string folder;
    Descriptor opened = {};  ///< the folder: it can be read where no more files can be opened
  };
  struct NewFolder {
    std::string path;
    bool is_made = false;
  };

  void refuse_twice(const std::string& path) const;
  bool is_new(const std::string& folder) const;
  void use_folder(const std::string& folder);
  void make_folders();
  Descriptor open_staged(Staged& staged);
  void use_folders();
  void hide(std::size_t number, const Descriptor& file);
  void collect_foreign_files();
  void prepare(Staged& staged);
  void rename_all();
  void move_away(Removed& removed);
  [[noreturn]] void take_back(const Error& error);
  std::string kept_files() const;
  void clear_up() noexcept;
  void roll_back() noexcept;
  void abandon() noexcept;

  OutputRules rules_;
  OutputFile::Care stream_care_ = OutputFile::Care::held;
  std::deque<OutputFile> files_;
  std::deque<OutputFile> streams_;
  std::vector<Staged> staged_;
  std::vector<Removed> removed_;
  std::vector<Foreign> foreign_;
  std::vector<NewFolder> new_folders_;
  std::map<std::string, FolderInUse> folders_;
  bool has_standard_output_ = false;
  bool committed_ = false;
  Outputs* next_ = nullptr;  ///< among those that live
};

}  // namespace thiessen
