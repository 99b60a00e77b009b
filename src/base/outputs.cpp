#include "base/outputs.h"

#include <fcntl.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <utility>

#include "base/hidden_file.h"
#include "base/interrupt.h"

namespace thiessen {
namespace {

constexpr unsigned new_file_mode = 0666;  // before the umask is applied
constexpr mode_t permissions = 0777;      // a new file never takes over set-uid or set-gid
constexpr int name_trials = 100;

using Kind = Destination::Kind;

/// Calls `make` with fresh names beside the final one until the name is not taken. The name is put
/// into `hidden` before the file exists, so that its owner removes the file whatever happens; it is
/// empty on failure.
template <typename Make>
void make_hidden(const std::string& final_path, std::string& hidden, Make make) {
  for (int trial = 0; trial < name_trials; ++trial) {
    hidden = fresh_name(folder_of(final_path));
    if (make(hidden)) return;
    if (errno != EEXIST) break;
  }
  const int why = errno;
  hidden.clear();
  throw system_error(final_path, "cannot write", why);
}

/// Gives the new file the mode of the old one, and its owner as far as the system allows.
void take_over(int file, const Destination& old, const std::string& name) {
  if (old.kind != Kind::file) return;
  if (::fchown(file, old.status.st_uid, old.status.st_gid) != 0) errno = 0;
  if (::fchmod(file, old.status.st_mode & permissions) != 0) {
    throw system_error(name, "cannot write", errno);
  }
}

/// Copies a file, its mode and, as far as the system allows, its owner, to one that is new.
void copy_whole(const Descriptor& from, const Descriptor& to, const std::string& name) {
  constexpr std::size_t most_bytes_a_call = std::size_t{64} << 20;
  struct stat status = {};
  if (::fstat(from.number(), &status) != 0) throw system_error(name, "cannot write", errno);
  take_over(to.number(), {Kind::file, status}, name);
  off_t at = 0;
  for (ssize_t copied = 1; copied != 0;) {
    copied = ::sendfile(to.number(), from.number(), &at, most_bytes_a_call);
    if (copied < 0 && errno != EINTR) throw system_error(name, "cannot write", errno);
    throw_if_interrupted();
  }
  sync_to_disk(to.number(), name);
}

std::string without_slashes_behind(std::string folder) {
  while (folder.size() > 1 && folder.ends_with('/')) folder.pop_back();
  return folder;
}

Descriptor open_stream(const std::string& path) {
  const std::optional<int> standing = standing_descriptor(path);
  Descriptor stream = standing ? twin_of(*standing) : open_descriptor(path, O_WRONLY);
  if (!stream.is_open()) throw system_error(path, "cannot write", errno);
  return stream;
}

/// Renames a file, and fails with EEXIST where the new name is taken.
int rename_to_free_name(const std::string& from, const std::string& to) {
#ifdef RENAME_NOREPLACE
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return -1;  // otherwise the file system cannot do it
#endif
  struct stat status = {};
  if (::lstat(to.c_str(), &status) == 0) {
    errno = EEXIST;
    return -1;
  }
  return std::rename(from.c_str(), to.c_str());
}

void sync_folder(const std::string& folder) {
  const Descriptor opened = open_descriptor(folder, O_RDONLY | O_DIRECTORY);
  if (opened.is_open() && ::fsync(opened.number()) != 0) errno = 0;  // the files are safe already
}

std::mutex living_mutex;
Outputs* first_living = nullptr;  // each tells the next

}  // namespace

Outputs::Outputs(OutputRules rules) : rules_(std::move(rules)) {
  const std::lock_guard lock(living_mutex);
  next_ = std::exchange(first_living, this);
}

Outputs::~Outputs() {
  if (!committed_) {
    files_.clear();
    abandon();
  }
  const std::lock_guard lock(living_mutex);
  Outputs** link = &first_living;
  while (*link != this) link = &(*link)->next_;
  *link = next_;
}

void Outputs::abandon_all() noexcept {
  const std::unique_lock lock(living_mutex, std::try_to_lock);
  if (!lock.owns_lock()) return;  // then a later run takes away what is left
  for (Outputs* outputs = first_living; outputs != nullptr; outputs = outputs->next_) {
    if (!outputs->committed_) outputs->abandon();
  }
}

/// Opens the file without a name, else under a hidden one.
Descriptor Outputs::open_staged(Staged& staged) {
  const std::string folder = folder_of(staged.path);
  // A folder that is not made yet will lie on the file system of the one above it.
  std::string there = folder;
  while (is_new(there)) there = folder_of(there);
  Descriptor file = open_unnamed(there, new_file_mode);
  if (file.is_open()) return file;
  if (there != folder) make_folders();
  use_folder(folder);
  make_hidden(staged.path, staged.hidden, [&](const std::string& name) {
    file = open_descriptor(name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, new_file_mode);
    return file.is_open();
  });
  return file;
}

/// Gives a file that is whole a hidden name, if it has none yet; where the system cannot name it, a
/// copy has the name.
void Outputs::hide(std::size_t number, const Descriptor& file) {
  Staged& staged = staged_[number];
  if (!staged.hidden.empty()) return;
  make_folders();
  use_folder(folder_of(staged.path));
  Descriptor copy;
  make_hidden(staged.path, staged.hidden, [&](const std::string& name) {
    if (give_name(file, name) == 0) return true;
    if (errno == EEXIST) return false;
    copy = open_descriptor(name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, new_file_mode);
    return copy.is_open();
  });
  if (copy.is_open()) copy_whole(file, copy, staged.path);
}

OutputFile& Outputs::add(const std::string& path) {
  if (path == "-") {
    if (has_standard_output_)
      throw Error(Message{"", 0, "standard output would be written twice", ""});
    has_standard_output_ = true;
    return streams_.emplace_back(standard_output(stream_care_));
  }
  const bool standing = standing_descriptor(path).has_value();
  const Destination destination =
      standing ? Destination{Kind::stream} : examine_destination(path, rules_);
  if (destination.kind == Kind::stream) {
    return streams_.emplace_back(path, open_stream(path), stream_care_);
  }
  refuse_twice(path);
  Staged& staged = staged_.emplace_back();
  staged.path = path;
  Descriptor file = open_staged(staged);
  take_over(file.number(), destination, path);
  OutputFile& added = files_.emplace_back(path, std::move(file), OutputFile::Care::synced);
  added.before_closing(
      [this, number = staged_.size() - 1](const Descriptor& whole) { hide(number, whole); });
  return added;
}

bool Outputs::is_stream(const std::string& path) const {
  return path == "-" || standing_descriptor(path) ||
         examine_destination(path, rules_).kind == Kind::stream;
}

std::string Outputs::add_foreign(const std::string& path) {
  if (is_stream(path)) {
    throw Error(Message{"", 0, path + " is no file, and this format needs one", ""});
  }
  refuse_twice(path);
  make_folders();
  use_folder(folder_of(path));
  Foreign& foreign = foreign_.emplace_back();
  foreign.path = path;
  make_hidden(path, foreign.folder,
              [](const std::string& name) { return ::mkdir(name.c_str(), 0700) == 0; });
  foreign.opened = open_descriptor(foreign.folder, O_RDONLY | O_DIRECTORY | O_NOFOLLOW);
  if (!foreign.opened.is_open()) throw system_error(path, "cannot write", errno);
  return foreign.folder + "/" + name_in_folder(path);
}

void Outputs::remove(const std::string& path) {
  removed_.push_back({path, examine_destination(path, rules_).kind != Kind::nothing});
}

bool Outputs::is_new(const std::string& folder) const {
  const std::string path = without_slashes_behind(folder);
  return std::any_of(new_folders_.begin(), new_folders_.end(),
                     [&](const NewFolder& other) { return !other.is_made && other.path == path; });
}

void Outputs::make_folder(const std::string& path) {
  const std::string folder = without_slashes_behind(path);
  struct stat status = {};
  if (::stat(folder.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) return;
    throw system_error(path, "cannot use the folder", ENOTDIR);
  }
  const int why = errno;
  if (why != ENOENT || ::lstat(folder.c_str(), &status) == 0) {
    throw system_error(path, "cannot make the folder", why);
  }
  if (is_new(folder)) return;
  const std::string above = folder_of(folder);
  make_folder(above);
  if (!is_new(above) && ::access(above.c_str(), W_OK | X_OK) != 0) {
    throw system_error(path, "cannot make the folder", errno);
  }
  new_folders_.push_back({folder});
}

void Outputs::make_folders() {
  for (NewFolder& folder : new_folders_) {
    if (folder.is_made) continue;
    if (::mkdir(folder.path.c_str(), 0777) == 0) {
      folder.is_made = true;
      continue;
    }
    const int why = errno;
    struct stat status = {};
    const bool is_there = ::stat(folder.path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
    if (!is_there) throw system_error(folder.path, "cannot make the folder", why);
  }
  std::erase_if(new_folders_, [](const NewFolder& folder) { return !folder.is_made; });
}

void Outputs::use_folder(const std::string& folder) {
  if (!folders_.contains(folder)) folders_.emplace(folder, FolderInUse(folder));
}

/// What may wait for another run comes before any name is given. A folder that is not made yet has
/// no other run in it.
void Outputs::use_folders() {
  for (const Staged& staged : staged_) {
    const std::string folder = folder_of(staged.path);
    if (!is_new(folder)) use_folder(folder);
  }
}

void Outputs::refuse_twice(const std::string& path) const {
  const std::string folder = folder_of(path);
  const auto same = [&](const std::string& other) {
    if (name_in_folder(path) != name_in_folder(other)) return false;
    const std::string others = folder_of(other);
    if (is_new(folder)) return without_slashes_behind(folder) == without_slashes_behind(others);
    std::error_code ignored;
    return std::filesystem::equivalent(folder, others, ignored);
  };
  bool twice = false;
  for (const Staged& staged : staged_) twice = twice || same(staged.path);
  for (const Foreign& foreign : foreign_) twice = twice || same(foreign.path);
  if (twice) throw Error(Message{"", 0, path + " would be written twice", ""});
}

void Outputs::collect_foreign_files() {
  for (const Foreign& foreign : foreign_) {
    const std::size_t before = staged_.size();
    const std::string folder = folder_of(foreign.path);
    for (const std::string& name : names_in(foreign.opened, foreign.path)) {
      const bool whole = name == name_in_folder(foreign.path);
      staged_.push_back(
          {whole ? foreign.path : folder + "/" + name, foreign.folder + "/" + name, {}});
    }
    if (staged_.size() == before) throw system_error(foreign.path, "cannot write", ENOENT);
  }
}

void Outputs::prepare(Staged& staged) {
  const Destination old = examine_destination(staged.path, rules_);
  if (old.kind == Kind::stream) throw system_error(staged.path, "cannot write", EEXIST);
  staged.replaced = old.kind != Kind::nothing;
  if (!staged.replaced || staged_.size() == 1) return;
  staged.backup = backup_name(staged.path);
  if (::link(staged.path.c_str(), staged.backup.c_str()) != 0) staged.backup.clear();
}

void Outputs::commit() {
  for (OutputFile& file : files_) file.sync();
  const std::size_t own = staged_.size();
  collect_foreign_files();
  for (std::size_t i = own; i < staged_.size(); ++i) {
    const Descriptor file = open_descriptor(staged_[i].hidden, O_RDONLY | O_NOFOLLOW);
    if (!file.is_open()) throw system_error(staged_[i].path, "cannot write", errno);
    take_over(file.number(), examine_destination(staged_[i].path, rules_), staged_[i].path);
    sync_to_disk(file.number(), staged_[i].path);
  }
  use_folders();
  throw_if_interrupted();
  // From here on only names are given, unless the system cannot name a file and it is copied: a run
  // that is killed leaves none of them but within these few moments.
  for (OutputFile& file : files_) file.finish();
  for (Staged& staged : staged_) prepare(staged);
  throw_if_interrupted();
  for (OutputFile& stream : streams_) stream.finish();
  rename_all();
  committed_ = true;
  clear_up();
}

/// What is left to do where all has been renamed: whatever fails now, the outputs are there.
void Outputs::clear_up() noexcept {
  for (const Staged& staged : staged_) {
    if (!staged.backup.empty()) ::unlink(staged.backup.c_str());
  }
  for (const Removed& removed : removed_) {
    if (!removed.backup.empty()) ::unlink(removed.backup.c_str());
  }
  for (const Foreign& foreign : foreign_) ::rmdir(foreign.folder.c_str());
  try {
    const auto forget = [&](const std::string& path) {
      const auto used = folders_.find(folder_of(path));
      if (used != folders_.end()) used->second.forget(path);
    };
    for (const Staged& staged : staged_) forget(staged.path);
    for (const Removed& removed : removed_) forget(removed.path);
    for (const auto& [path, folder] : folders_) sync_folder(path);
  } catch (...) {  // no memory: the files are safe already, and older copies are for a later run
    errno = 0;
  }
  folders_.clear();
}

void Outputs::move_away(Removed& removed) {
  if (!removed.is_there) return;
  std::string backup = backup_name(removed.path);
  if (std::rename(removed.path.c_str(), backup.c_str()) == 0) {
    removed.backup = std::move(backup);
  } else if (const int why = errno; why != ENOENT) {
    take_back(system_error(removed.path, "cannot be removed", why));
  }
}

void Outputs::rename_all() {
  for (Removed& removed : removed_) move_away(removed);
  for (Staged& staged : staged_) {
    const int failed = staged.replaced ? std::rename(staged.hidden.c_str(), staged.path.c_str())
                                       : rename_to_free_name(staged.hidden, staged.path);
    if (failed != 0) take_back(system_error(staged.path, "cannot write", errno));
    staged.renamed = true;
  }
}

/// Undoes the renames and throws the error, which then names what cannot be brought back.
void Outputs::take_back(const Error& error) {
  std::string unsaved;
  for (const Staged& other : staged_) {
    if (other.renamed && other.replaced && other.backup.empty()) unsaved += " " + other.path;
  }
  roll_back();
  std::string hint;
  if (!unsaved.empty()) hint = "replaced already, and not to be brought back:" + unsaved;
  if (const std::string kept = kept_files(); !kept.empty()) {
    hint += (hint.empty() ? "" : "; ") + ("cannot be taken back: " + kept);
  }
  if (hint.empty()) throw error;
  Message message = error.messages().front();
  message.hint = hint;
  throw Error(std::move(message));
}

/// What roll_back could not undo, and where the older files are.
std::string Outputs::kept_files() const {
  std::string kept;
  const auto add = [&](const std::string& path, const std::string& backup) {
    kept += kept.empty() ? "" : ", ";
    kept += path;
    kept += backup.empty() ? ", which is new" : ", whose older file is kept as " + backup;
  };
  for (const Removed& removed : removed_) {
    if (removed.is_kept) add(removed.path, removed.backup);
  }
  for (const Staged& staged : staged_) {
    if (staged.is_kept) add(staged.path, staged.backup);
  }
  return kept;
}

void Outputs::roll_back() noexcept {
  for (Staged& staged : staged_) {
    if (!staged.renamed) continue;
    staged.renamed = false;
    staged.hidden.clear();
    if (!staged.replaced) {
      staged.is_kept = ::unlink(staged.path.c_str()) != 0;
    } else if (!staged.backup.empty()) {
      staged.is_kept = std::rename(staged.backup.c_str(), staged.path.c_str()) != 0;
      if (!staged.is_kept) staged.backup.clear();
    }
  }
  for (Removed& removed : removed_) {
    if (removed.backup.empty() || removed.is_kept) continue;
    removed.is_kept = std::rename(removed.backup.c_str(), removed.path.c_str()) != 0;
    if (!removed.is_kept) removed.backup.clear();
  }
}

void Outputs::abandon() noexcept {
  roll_back();  // what was thrown between two renames may have come from a lack of memory
  for (const Staged& staged : staged_) {
    if (!staged.hidden.empty()) ::unlink(staged.hidden.c_str());
    if (!staged.backup.empty() && !staged.is_kept) ::unlink(staged.backup.c_str());
  }
  for (const Foreign& foreign : foreign_) {
    if (!foreign.folder.empty()) remove_folder_of_files(foreign.folder, foreign.opened);
  }
  for (auto folder = new_folders_.rbegin(); folder != new_folders_.rend(); ++folder) {
    if (folder->is_made) ::rmdir(folder->path.c_str());
  }
}

}  // namespace thiessen
