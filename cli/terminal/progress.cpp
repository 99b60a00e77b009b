#include "cli/terminal/progress.h"

#include <unistd.h>

#include <cmath>
#include <iostream>
#include <utility>

#include "base/number.h"

namespace thiessen::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// Writes a number with its digits in groups of three: 12,345.
std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
  return text;
}

/// Writes a duration, rounded up: 40 s, 3 min, 2 h 5 min.
std::string duration(double seconds) {
  const auto whole = [](double value) { return fixed_text(std::ceil(value), 0); };
  if (seconds <= 59) return whole(seconds) + " s";
  const double minutes = std::ceil(seconds / 60);
  if (minutes < 60) return whole(minutes) + " min";
  const double hours = std::floor(minutes / 60);
  return whole(hours) + " h " + whole(minutes - 60 * hours) + " min";
}

}  // namespace

Progress::Progress(std::string unit, bool quiet, Share share)
    : unit_(std::move(unit)),
      share_(std::move(share)),
      shows_(!quiet && isatty(STDERR_FILENO) == 1),
      begin_(Clock::now()),
      next_(begin_ + std::chrono::seconds(1)) {}

Progress::~Progress() {
  if (shown_) std::cerr << "\r\x1b[K" << std::flush;
}

void Progress::advance(std::size_t count) {
  done_ += count;
  if (!shows_ || Clock::now() < next_) return;
  next_ = Clock::now() + std::chrono::milliseconds(200);
  shown_ = true;
  std::cerr << '\r' << line() << "\x1b[K" << std::flush;
}

std::string Progress::line() const {
  std::string text = "thiessen: " + grouped(done_) + ' ' + unit_ + (done_ == 1 ? "" : "s");
  const double share = share_(done_);
  if (!(share > 0)) return text;
  text += ", " + fixed_text(std::floor(100 * share), 0) + " %";
  if (share >= 1) return text;
  const double passed = std::chrono::duration<double>(Clock::now() - begin_).count();
  return text + ", " + duration(passed * (1 - share) / share) + " left";
}

}  // namespace thiessen::cli
