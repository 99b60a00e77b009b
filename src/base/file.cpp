#include "base/file.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "base/interrupt.h"
#include "base/spool.h"

namespace thiessen {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{256} << 10;
constexpr int writer_patience_ms = 3000;
/// A signal that comes between two calls is heard after the second, so that no call waits longer.
constexpr std::chrono::milliseconds longest_call(200);
constexpr std::size_t most_bytes_a_call = std::size_t{1} << 30;

/// Waits until a descriptor that someone made non-blocking is ready.
void wait_for(int descriptor, short event) {
  pollfd wanted = {descriptor, event, 0};
  if (::poll(&wanted, 1, -1) < 0) throw_if_interrupted();
}

/// Whether a call that failed with this errno should be tried again.
bool may_go_on(int error_number, int descriptor, short event) {
  if (error_number == EINTR) {
    throw_if_interrupted();
    return true;
  }
  if (error_number != EAGAIN && error_number != EWOULDBLOCK) return false;
  wait_for(descriptor, event);
  return true;
}

void write_whole(int descriptor, std::string_view text, const std::string& name) {
  while (!text.empty()) {
    const std::string_view piece = text.substr(0, most_bytes_a_call);
    const ssize_t written = ::write(descriptor, piece.data(), piece.size());
    if (written > 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (const int why = written == 0 ? EIO : errno; !may_go_on(why, descriptor, POLLOUT)) {
      if (why == EPIPE) throw ReaderGone(system_error(name, "cannot write", why));
      throw system_error(name, "cannot write", why);
    }
  }
}

std::size_t plain_size(int descriptor) {
  struct stat status = {};
  const bool plain = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
  return plain ? static_cast<std::size_t>(status.st_size) : 0;
}

}  // namespace

InputFile::InputFile(const std::string& name) : name_(name) {
  throw_if_interrupted();
  if (name == "-") {
    name_ = "standard input";
    file_ = twin_of(STDIN_FILENO);
    if (!file_.is_open()) throw system_error(name_, "cannot read", errno);
    size_ = plain_size(file_.number());
    return;
  }
  if (name.empty()) throw Error(Message{"", 0, "the name of an input is empty", ""});
  open(name);
}

void InputFile::open(const std::string& path) {
  // Without O_NONBLOCK, opening a pipe to which nobody writes would never return.
  file_ = open_descriptor(path, O_RDONLY | O_NONBLOCK);
  if (!file_.is_open()) throw system_error(name_, "cannot open", errno);
  struct stat status = {};
  if (::fstat(file_.number(), &status) != 0) throw system_error(name_, "cannot open", errno);
  if (S_ISDIR(status.st_mode)) throw system_error(name_, "cannot read", EISDIR);
  if (S_ISFIFO(status.st_mode)) await_writer();
  const int flags = ::fcntl(file_.number(), F_GETFL);
  if (flags >= 0 && ::fcntl(file_.number(), F_SETFL, flags & ~O_NONBLOCK) != 0) {
    throw system_error(name_, "cannot open", errno);
  }
  size_ = plain_size(file_.number());
}

void InputFile::await_writer() {
  pollfd pipe = {file_.number(), POLLIN, 0};
  const int ready = ::poll(&pipe, 1, writer_patience_ms);
  throw_if_interrupted();
  if (ready > 0) return;  // there are bytes, or a writer has come and gone
  char byte = 0;
  const ssize_t count = ::read(file_.number(), &byte, 1);
  if (count > 0) first_ = byte;
  if (count == 0) {
    throw Error(Message{name_, 0, "cannot read: nobody writes to this pipe", ""});
  }
}

std::size_t InputFile::read(std::span<char> into) {
  throw_if_interrupted();
  if (source_) return source_(into);
  if (first_ && !into.empty()) {
    into[0] = *first_;
    first_.reset();
    return 1;
  }
  while (may_wait() && !has_bytes(longest_call)) {
  }
  const std::size_t wanted = std::min(into.size(), most_bytes_a_call);
  for (;;) {
    const ssize_t count = ::read(file_.number(), into.data(), wanted);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (const int why = errno; !may_go_on(why, file_.number(), POLLIN)) {
      throw system_error(name_, "cannot read", why);
    }
  }
}

bool InputFile::has_bytes(std::chrono::milliseconds patience) {
  using Clock = std::chrono::steady_clock;
  if (!may_wait() || first_) return true;
  const auto until = Clock::now() + patience;
  for (;;) {
    throw_if_interrupted();
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
    const auto wait = std::clamp(left, std::chrono::milliseconds(0), longest_call);
    pollfd pipe = {file_.number(), POLLIN, 0};
    const int ready = ::poll(&pipe, 1, static_cast<int>(wait.count()));
    if (ready > 0 || (ready < 0 && errno != EINTR)) return true;  // reading says what is wrong
    if (left <= longest_call && Clock::now() >= until) return false;
  }
}

OutputFile::OutputFile(std::string name, Descriptor file, Care care)
    : name_(std::move(name)), file_(std::move(file)), care_(care) {
  buffer_.reserve(buffer_bytes);
}

void OutputFile::append(std::string_view text) {
  is_synced_ = false;
  if (buffer_.size() + text.size() > buffer_bytes) flush();
  if (text.size() >= buffer_bytes) {
    write(text);
  } else {
    buffer_ += text;
  }
}

void OutputFile::flush() {
  throw_if_interrupted();
  write(buffer_);
  buffer_.clear();
}

void OutputFile::write(std::string_view text) {
  if (care_ == Care::held && !spool_.is_open()) spool_ = open_spool();
  const bool spools = spool_.is_open();
  write_whole(spools ? spool_.number() : file_.number(), text, spools ? spool_name : name_);
}

void OutputFile::sync() {
  if (!file_.is_open() || is_synced_) return;
  // Where nothing was spooled, everything is still in the buffer and can be written now.
  if (care_ == Care::held && !spool_.is_open()) care_ = Care::closed;
  flush();
  if (spool_.is_open())
    copy_spool(spool_, [&](std::string_view text) { write_whole(file_.number(), text, name_); });
  if (care_ == Care::synced) sync_to_disk(file_.number(), name_);
  is_synced_ = true;
}

void OutputFile::finish() {
  if (!file_.is_open()) return;
  sync();
  if (before_closing_) before_closing_(file_);
  if (!file_.close()) throw system_error(name_, "cannot close", errno);
  buffer_ = {};  // who writes ten thousand files has all of them until the end
}

void OutputFile::discard() {
  buffer_.clear();
}

void OutputFile::start_over() {
  buffer_.clear();
  spool_ = {};
  if (care_ != Care::synced) return;
  if (::ftruncate(file_.number(), 0) != 0 || ::lseek(file_.number(), 0, SEEK_SET) != 0)
    throw system_error(name_, "cannot write", errno);
}

bool OutputFile::is_reader_gone() const {
  if (!file_.is_open()) return false;
  pollfd pipe = {file_.number(), 0, 0};
  return ::poll(&pipe, 1, 0) > 0 && (pipe.revents & POLLERR) != 0;
}

OutputFile OutputFile::held() const {
  return {name_, file_.twin(name_), Care::held};
}

OutputFile standard_output(OutputFile::Care care) {
  Descriptor stream = twin_of(STDOUT_FILENO);
  if (!stream.is_open()) throw system_error("standard output", "cannot write", errno);
  return {"standard output", std::move(stream), care};
}

void sync_to_disk(int descriptor, const std::string& name) {
  while (::fsync(descriptor) != 0) {
    if (errno == EINVAL || errno == ENOSYS || errno == ENOTSUP) return;  // nothing there to sync
    if (const int why = errno; why != EINTR) throw system_error(name, "cannot write", why);
    throw_if_interrupted();
  }
}

}  // namespace thiessen
