#include "base/descriptor.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "base/interrupt.h"

namespace thiessen {

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this != &other) {
    close();
    number_ = std::exchange(other.number_, -1);
  }
  return *this;
}

Descriptor::~Descriptor() {
  close();
}

bool Descriptor::close() {
  // After EINTR the number is free again on Linux, and may already belong to another file, so it
  // must never be closed twice.
  return !is_open() || ::close(std::exchange(number_, -1)) == 0 || errno == EINTR;
}

Descriptor Descriptor::twin(const std::string& file) const {
  Descriptor other = twin_of(number_);
  if (!other.is_open()) throw system_error(file, "cannot write", errno);
  return other;
}

Descriptor open_descriptor(const std::string& path, int flags, unsigned mode) {
  for (;;) {
    const int number = ::open(path.c_str(), flags | O_CLOEXEC | O_NOCTTY, mode);
    if (number >= 0 || errno != EINTR) return Descriptor(number);
    throw_if_interrupted();
  }
}

Descriptor twin_of(int number) {
  return Descriptor(::fcntl(number, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
}

Error system_error(const std::string& file, const std::string& what, int error_number) {
  return Error(Message{file, 0, what + ": " + std::generic_category().message(error_number), ""});
}

void hold_standard_streams() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(number, F_GETFD) >= 0 || errno != EBADF) continue;
    // The file gets this number, because it is the lowest free one. It is opened in the wrong
    // direction, so that using it still fails.
    const int way = number == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    if (::open("/dev/null", way) < 0) return;
  }
}

}  // namespace thiessen
