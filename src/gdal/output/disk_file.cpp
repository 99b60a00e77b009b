#include "gdal/output/disk_file.h"

#include <cpl_vsi.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <map>
#include <mutex>
#include <new>
#include <string_view>
#include <utility>

#include "base/descriptor.h"
#include "base/destination.h"
#include "base/error.h"
#include "base/hidden_file.h"
#include "base/last_words.h"
#include "base/memory.h"
#include "gdal/drivers.h"

namespace thiessen {

struct DiskFile::Watched {
  explicit Watched(std::string path) : path(std::move(path)) {}

  std::string path;                 ///< where it is to lie in the end
  std::atomic<int> why_failed = 0;  ///< errno of the first failure

  /// What GDAL cannot read of what it has just written it crashes over.
  void note_failure(int why) noexcept {
    int none = 0;
    why_failed.compare_exchange_strong(none, why == 0 ? EIO : why);
    try {
      note_last_words(failure().messages().front().sentence());
    } catch (const std::bad_alloc&) {
      note_lack_of_memory();
    }
  }
  Error failure() const { return system_error(path, "cannot write", why_failed); }
};

namespace {

using Watched = DiskFile::Watched;

constexpr const char* prefix = "/thiessen-disk/";

/// The folders in which datasets are being written. GDAL's threads may ask.
class WatchedFolders {
 public:
  void add(const std::string& folder, std::shared_ptr<Watched> watched) {
    const std::lock_guard lock(mutex_);
    folders_[folder] = std::move(watched);
  }
  void remove(const std::string& folder) {
    const std::lock_guard lock(mutex_);
    folders_.erase(folder);
  }
  std::shared_ptr<Watched> of(const std::string& folder) {
    const std::lock_guard lock(mutex_);
    const auto found = folders_.find(folder);
    return found == folders_.end() ? nullptr : found->second;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Watched>> folders_;
};

WatchedFolders& watched_folders() {
  static WatchedFolders folders;
  return folders;
}

std::string folder_of_file(const std::string& file) {
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos ? "" : file.substr(0, slash);
}

/// A file that GDAL has open.
struct OpenFile {
  Descriptor file;
  off_t at = 0;
  bool is_at_end = false;
  std::shared_ptr<Watched> watched;
};

OpenFile& opened(void* file) {
  return *static_cast<OpenFile*>(file);
}

/// Calls `work`, which returns how many bytes it moved, again after signals; 0 where it fails.
template <typename Work>
std::size_t moved_by(Work&& work) {
  for (;;) {
    const ssize_t moved = work();
    if (moved >= 0) return static_cast<std::size_t>(moved);
    if (errno != EINTR) return 0;
  }
}

int flags_of(std::string_view access) {
  const bool updates = access.find('+') != std::string_view::npos;
  if (access.starts_with('w')) return O_CREAT | O_TRUNC | (updates ? O_RDWR : O_WRONLY);
  return updates ? O_RDWR : O_RDONLY;
}

void* open_file(void*, const char* name, const char* access) {
  constexpr unsigned new_file_mode = 0666;  // before the umask is applied
  const std::shared_ptr<Watched> watched = watched_folders().of(folder_of_file(name));
  const int flags = flags_of(access) | O_CLOEXEC | O_NOFOLLOW;
  Descriptor file(::open(name, flags, new_file_mode));
  if (!file.is_open()) {
    if (watched && (flags & O_CREAT) != 0) watched->note_failure(errno);
    return nullptr;
  }
  return new OpenFile{std::move(file), 0, false, watched};
}

int stat_file(void*, const char* name, VSIStatBufL* status, int) {
  return VSIStatL(name, status);
}

int unlink_file(void*, const char* name) {
  return ::unlink(name);
}

vsi_l_offset tell(void* file) {
  return static_cast<vsi_l_offset>(opened(file).at);
}

int seek(void* handle, vsi_l_offset offset, int whence) {
  OpenFile& file = opened(handle);
  file.is_at_end = false;
  struct stat status = {};
  if (whence == SEEK_END && ::fstat(file.file.number(), &status) != 0) return -1;
  const off_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? file.at : status.st_size;
  file.at = base + static_cast<off_t>(offset);
  return 0;
}

std::size_t read_bytes(void* handle, void* buffer, std::size_t size, std::size_t count) {
  OpenFile& file = opened(handle);
  std::size_t done = 0;
  while (done < size * count) {
    errno = 0;
    const std::size_t moved = moved_by([&] {
      return ::pread(file.file.number(), static_cast<char*>(buffer) + done, size * count - done,
                     file.at);
    });
    if (moved == 0) {
      if (errno != 0 && file.watched) file.watched->note_failure(errno);
      file.is_at_end = true;
      break;
    }
    done += moved;
    file.at += static_cast<off_t>(moved);
  }
  return size == 0 ? 0 : done / size;
}

std::size_t write_bytes(void* handle, const void* buffer, std::size_t size, std::size_t count) {
  OpenFile& file = opened(handle);
  std::size_t done = 0;
  while (done < size * count) {
    errno = 0;
    const std::size_t moved = moved_by([&] {
      return ::pwrite(file.file.number(), static_cast<const char*>(buffer) + done,
                      size * count - done, file.at);
    });
    if (moved == 0) {
      if (file.watched) file.watched->note_failure(errno);
      break;
    }
    done += moved;
    file.at += static_cast<off_t>(moved);
  }
  return size == 0 ? 0 : done / size;
}

int is_at_end(void* file) {
  return opened(file).is_at_end ? 1 : 0;
}

int truncate_file(void* handle, vsi_l_offset size) {
  OpenFile& file = opened(handle);
  const int failed = ::ftruncate(file.file.number(), static_cast<off_t>(size));
  if (failed != 0 && file.watched) file.watched->note_failure(errno);
  return failed;
}

int flush(void*) {
  return 0;
}

int close_file(void* handle) {
  const std::unique_ptr<OpenFile> file(&opened(handle));
  if (file->file.close()) return 0;
  if (file->watched) file->watched->note_failure(errno);
  return -1;
}

bool install_handler() {
  VSIFilesystemPluginCallbacksStruct* const callbacks = VSIAllocFilesystemPluginCallbacksStruct();
  callbacks->stat = stat_file;
  callbacks->unlink = unlink_file;
  callbacks->open = open_file;
  callbacks->tell = tell;
  callbacks->seek = seek;
  callbacks->read = read_bytes;
  callbacks->eof = is_at_end;
  callbacks->write = write_bytes;
  callbacks->flush = flush;
  callbacks->truncate = truncate_file;
  callbacks->close = close_file;
  const bool done = VSIInstallPluginHandler(prefix, callbacks) == 0;
  VSIFreeFilesystemPluginCallbacksStruct(callbacks);
  return done;
}

/// The bytes of a file. `path` is the output in whose Error they are missed.
std::string content_of(const std::string& file, const std::string& path) {
  const Descriptor opened = open_descriptor(file, O_RDONLY | O_NOFOLLOW);
  struct stat status = {};
  if (!opened.is_open() || ::fstat(opened.number(), &status) != 0)
    throw system_error(path, "cannot write", errno);
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  for (std::size_t done = 0; done < bytes.size();) {
    errno = 0;
    const std::size_t moved =
        moved_by([&] { return ::read(opened.number(), bytes.data() + done, bytes.size() - done); });
    if (moved == 0) throw system_error(path, "cannot write", errno == 0 ? EIO : errno);
    done += moved;
  }
  return bytes;
}

}  // namespace

DiskFile::DiskFile(std::string file, std::string path)
    : file_(std::move(file)),
      path_(std::move(path)),
      name_for_gdal_(prefix + file_),
      watched_(std::make_shared<Watched>(path_)) {
  start_gdal();
  static const bool installed = install_handler();
  if (!installed) throw Error(Message{path_, 0, "GDAL takes no way to write files", {}});
  watched_folders().add(folder_of_file(file_), watched_);
}

DiskFile::~DiskFile() {
  watched_folders().remove(folder_of_file(file_));
}

void DiskFile::check() const {
  if (watched_->why_failed != 0) throw watched_->failure();
}

std::vector<EncodedFile> DiskFile::take() const {
  check();
  std::vector<EncodedFile> files{{path_, {}}};
  const std::string folder = folder_of(file_);
  const Descriptor opened = open_descriptor(folder, O_RDONLY | O_DIRECTORY);
  if (!opened.is_open()) throw system_error(path_, "cannot write", errno);
  std::vector<std::string> names = names_in(opened, path_);
  std::sort(names.begin(), names.end());
  const std::string own = name_in_folder(file_);
  for (const std::string& name : names) {
    if (name == own) continue;
    if (!name.starts_with(own))
      throw Error(Message{path_, 0, "GDAL wrote a file that is not expected: " + name, {}});
    const std::string side = folder + "/" + name;
    files.push_back({path_ + name.substr(own.size()), content_of(side, path_)});
    if (::unlink(side.c_str()) != 0) throw system_error(path_, "cannot write", errno);
  }
  return files;
}

}  // namespace thiessen
