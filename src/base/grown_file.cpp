#include "base/grown_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

#include "base/interrupt.h"

namespace thiessen {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds longest_wait(5);
constexpr std::chrono::milliseconds between_looks(20);
constexpr unsigned new_file_mode = 0666;  // before the umask is applied

bool are_same(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

}  // namespace

GrownFile::GrownFile(std::string path, OutputRules rules)
    : path_(std::move(path)), rules_(std::move(rules)) {
  rules_.overwrite = true;
  const auto until = Clock::now() + longest_wait;
  for (open(); exists_ && !lock(); open()) {
    throw_if_interrupted();
    if (Clock::now() > until) {
      throw Error(Message{path_, 0, "another run is adding to it",
                          "what that run adds is passed over by a later one"});
    }
    std::this_thread::sleep_for(between_looks);
  }
}

GrownFile::~GrownFile() {
  if (!grows_) return;
  output_.reset();
  if (kept_ == 0 && !exists_) {
    ::unlink(path_.c_str());
  } else if (::ftruncate(file_.number(), static_cast<off_t>(kept_)) != 0) {
    errno = 0;  // what is cut off then, the next run finds
  }
}

void GrownFile::open() {
  using Kind = Destination::Kind;
  if (path_ == "-" || standing_descriptor(path_))
    throw Error(Message{path_, 0, "is no plain file, and rows are added to one", ""});
  const Destination there = examine_destination(path_, rules_);
  exists_ = there.kind != Kind::nothing;
  if (there.kind == Kind::stream)
    throw Error(Message{path_, 0, "is no plain file, and rows are added to one", ""});
  if (there.kind == Kind::link) {
    throw Error(
        Message{path_, 0, "is a symbolic link, which is not followed", "name the file itself"});
  }
  if (!exists_) return;
  file_ = open_descriptor(path_, O_RDWR | O_NOFOLLOW);
  if (!file_.is_open() && errno == EACCES) file_ = open_descriptor(path_, O_RDONLY | O_NOFOLLOW);
  if (!file_.is_open()) throw system_error(path_, "cannot open", errno);
  if (::fstat(file_.number(), &status_) != 0) throw system_error(path_, "cannot open", errno);
}

/// Whether no other run adds to the file, nor has replaced it since it was opened.
bool GrownFile::lock() {
  if (::flock(file_.number(), LOCK_EX | LOCK_NB) != 0 && (errno == EWOULDBLOCK || errno == EINTR))
    return false;
  if (::fstat(file_.number(), &status_) != 0) throw system_error(path_, "cannot open", errno);
  return is_at_path();
}

bool GrownFile::is_at_path() const {
  struct stat now = {};
  return ::stat(path_.c_str(), &now) == 0 && are_same(now, status_);
}

std::size_t GrownFile::read(std::size_t at, std::span<char> into) const {
  for (;;) {
    throw_if_interrupted();
    const ssize_t count = ::pread(file_.number(), into.data(), into.size(), static_cast<off_t>(at));
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) throw system_error(path_, "cannot read", errno);
  }
}

void GrownFile::require_unchanged() const {
  if (!exists_) return;
  struct stat now = {};
  const bool is_same = ::fstat(file_.number(), &now) == 0 && now.st_size == status_.st_size &&
                       now.st_mtim.tv_sec == status_.st_mtim.tv_sec &&
                       now.st_mtim.tv_nsec == status_.st_mtim.tv_nsec;
  if (is_same && is_at_path()) return;
  throw Error(Message{path_, 0, "has changed while steps were to be added to it",
                      "nothing was added; try again"});
}

OutputFile& GrownFile::grow(std::size_t from) {
  if (exists_) {
    shorten(from);
  } else {
    make();
  }
  kept_ = from;
  grows_ = true;
  if (::lseek(file_.number(), 0, SEEK_END) < 0) throw system_error(path_, "cannot write", errno);
  return output_.emplace(path_, file_.twin(path_), OutputFile::Care::closed);
}

void GrownFile::make() {
  file_ = open_descriptor(path_, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW, new_file_mode);
  if (!file_.is_open()) throw system_error(path_, "cannot write", errno);
  if (::flock(file_.number(), LOCK_EX | LOCK_NB) != 0) errno = 0;  // nobody else has it yet
}

void GrownFile::shorten(std::size_t to) const {
  if (to == size()) return;
  if (::ftruncate(file_.number(), static_cast<off_t>(to)) != 0)
    throw system_error(path_, "cannot write", errno);
}

void GrownFile::keep() {
  output_->flush();
  const off_t end = ::lseek(file_.number(), 0, SEEK_CUR);
  if (end < 0) throw system_error(path_, "cannot write", errno);
  if (static_cast<std::size_t>(end) == kept_) return;
  sync_to_disk(file_.number(), path_);
  kept_ = static_cast<std::size_t>(end);
}

}  // namespace thiessen
