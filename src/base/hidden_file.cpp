#include "base/hidden_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstddef>
#include <memory>
#include <string_view>
#include <thread>
#include <utility>

#include "base/destination.h"
#include "base/interrupt.h"

namespace thiessen {
namespace {

/// The name by which the system finds an open file, whatever it is called.
std::string name_of_open(const Descriptor& file) {
  return "/proc/self/fd/" + std::to_string(file.number());
}

constexpr std::size_t longest_told = 200;

/// A file's name as a backup's tells it. A name may be no longer than 255 bytes.
std::string_view told_part(const std::string& path) {
  const std::string_view whole = path;
  return whole.substr(whole.rfind('/') + 1).substr(0, longest_told);  // npos + 1 is 0
}

/// Whether fresh_name or backup_name made up this name within a folder.
bool is_hidden(std::string_view name) {
  const std::size_t length = fresh_name_length();
  return is_fresh_name(name.substr(0, length)) && (name.size() == length || name[length] == '-');
}

/// Whether it is a backup of this file and no other: of a name that is cut nobody knows.
bool is_backup_of(const std::string& backup, const std::string& path) {
  const std::string name = name_in_folder(backup);
  return told_part(path).size() < longest_told &&
         std::string_view(name).substr(fresh_name_length() + 1) == told_part(path);
}

constexpr int folder_flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;

/// Calls `visit` with the name of everything in an open folder. Takes no memory. Returns whether
/// all could be read.
template <typename Visit>
bool for_each_in(int folder, Visit visit) {
  if (::lseek(folder, 0, SEEK_SET) != 0) return false;
  alignas(dirent64) char entries[4096];
  for (;;) {
    const long bytes = ::syscall(SYS_getdents64, folder, entries, sizeof entries);
    if (bytes <= 0) return bytes == 0;
    for (long at = 0; at < bytes;) {
      const auto* const entry = reinterpret_cast<const dirent64*>(entries + at);
      const std::string_view name = entry->d_name;
      if (name != "." && name != "..") visit(entry->d_name);
      at += entry->d_reclen;
    }
  }
}

enum class Left { nothing, only_copy };

/// Removes what lies under a hidden name, unless it is another user's, or an older file without
/// another name.
Left remove_leftover(const std::string& path) {
  struct stat status = {};
  if (::lstat(path.c_str(), &status) != 0 || status.st_uid != ::geteuid()) return Left::nothing;
  if (S_ISDIR(status.st_mode)) {
    remove_folder_of_files(path, {});
    return Left::nothing;
  }
  const bool is_backup = !is_fresh_name(name_in_folder(path));
  if (is_backup && status.st_nlink < 2) return Left::only_copy;
  ::unlink(path.c_str());
  return Left::nothing;
}

struct Close {
  void operator()(DIR* folder) const { ::closedir(folder); }
};

/// Removes all leftovers of a folder. Returns those that are kept. The system's own list is read,
/// as the standard library's ends the program where there is no memory for it.
std::vector<std::string> remove_leftovers(const std::string& folder) {
  std::vector<std::string> only_copies;
  const std::unique_ptr<DIR, Close> opened(::opendir(folder.c_str()));
  while (const dirent* const entry = opened ? ::readdir(opened.get()) : nullptr) {
    const std::string_view name = entry->d_name;
    if (!is_hidden(name)) continue;
    std::string path = folder + "/";
    path += name;
    if (remove_leftover(path) == Left::only_copy) only_copies.push_back(std::move(path));
  }
  return only_copies;
}

/// Sets the mark of a run that removes leftovers (F_RDLCK), or takes it away (F_UNLCK): a lock of
/// another kind on the same folder, which hinders nobody.
void mark(const Descriptor& folder, short type) {
  struct flock lock = {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  if (::fcntl(folder.number(), F_OFD_SETLK, &lock) != 0) errno = 0;  // not all file systems have it
}

/// Whether another run has set the mark.
bool is_marked(const Descriptor& folder) {
  struct flock lock = {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  return ::fcntl(folder.number(), F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

/// Waits for the lock that all runs can share; another run has the folder for itself only while it
/// removes leftovers, however long that takes. A program of another kind may hold it for ever, and
/// is not waited for.
void share_lock(const Descriptor& folder) {
  constexpr int looks = 50;
  constexpr std::chrono::milliseconds between_looks(20);
  for (int look = 0; look < looks;) {
    if (::flock(folder.number(), LOCK_SH | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    if (!is_marked(folder)) ++look;
    throw_if_interrupted();
    std::this_thread::sleep_for(between_looks);
  }
}

}  // namespace

Descriptor open_unnamed(const std::string& folder, unsigned mode) {
  Descriptor file = open_descriptor(folder, O_TMPFILE | O_RDWR, mode);
  if (file.is_open() && ::access(name_of_open(file).c_str(), F_OK) != 0) file = Descriptor();
  return file;
}

int give_name(const Descriptor& file, const std::string& name) {
  return ::linkat(AT_FDCWD, name_of_open(file).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW);
}

std::string backup_name(const std::string& path) {
  std::string name = fresh_name(folder_of(path));
  name += '-';
  name += told_part(path);
  return name;
}

FolderInUse::FolderInUse(const std::string& folder)
    : lock_(open_descriptor(folder, O_RDONLY | O_DIRECTORY)) {
  if (!lock_.is_open()) return;
  mark(lock_, F_RDLCK);
  // Where the file system has no locks, nothing tells what is left over.
  if (::flock(lock_.number(), LOCK_EX | LOCK_NB) == 0) only_copies_ = remove_leftovers(folder);
  mark(lock_, F_UNLCK);
  share_lock(lock_);
}

void FolderInUse::forget(const std::string& path) noexcept {
  for (const std::string& copy : only_copies_) {
    if (is_backup_of(copy, path)) ::unlink(copy.c_str());
  }
}

std::vector<std::string> names_in(const Descriptor& folder, const std::string& path) {
  std::vector<std::string> names;
  const bool is_read =
      for_each_in(folder.number(), [&](const char* name) { names.emplace_back(name); });
  if (!is_read) throw system_error(path, "cannot write", errno);
  return names;
}

void remove_folder_of_files(const std::string& folder, const Descriptor& opened) noexcept {
  const auto remove = [](int in) {
    for_each_in(in, [in](const char* name) {
      if (::unlinkat(in, name, 0) != 0 && errno == EISDIR) ::unlinkat(in, name, AT_REMOVEDIR);
    });
  };
  if (opened.is_open()) {
    remove(opened.number());
  } else if (const int own = ::open(folder.c_str(), folder_flags); own >= 0) {
    remove(own);
    ::close(own);
  }
  ::rmdir(folder.c_str());
}

}  // namespace thiessen
