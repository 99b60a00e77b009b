#include "cli/progress.h"

#include <unistd.h>

#include <iostream>
#include <utility>

namespace thiessen::cli {

using Clock = std::chrono::steady_clock;

Progress::Progress(std::string what, bool quiet)
    : what_(std::move(what)),
      shows_(!quiet && isatty(STDERR_FILENO) == 1),
      next_(Clock::now() + std::chrono::seconds(1)) {}

Progress::~Progress() {
  if (shown_) std::cerr << "\r\x1b[K" << std::flush;
}

void Progress::advance(std::size_t count) {
  done_ += count;
  if (!shows_ || Clock::now() < next_) return;
  next_ = Clock::now() + std::chrono::milliseconds(200);
  shown_ = true;
  std::cerr << "\rthiessen: " << std::to_string(done_) << ' ' << what_ << "\x1b[K" << std::flush;
}

}  // namespace thiessen::cli
