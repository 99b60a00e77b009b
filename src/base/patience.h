#pragma once

#include <chrono>
#include <optional>

namespace thiessen {

/// How long something that is known of a feed is held back for what may still come with it: until
/// nothing has come for a quarter of a second, or, once half a second has passed, for a twentieth.
/// A pipe from a program that reads a file makes no such pause, however long the file is; a gauge
/// that reports does, and what it says is heard within a second.
class Patience {
 public:
  /// The time in which nothing must come from now on, for the source to count as resting. It is
  /// reckoned from the first call.
  std::chrono::milliseconds left() {
    const auto now = std::chrono::steady_clock::now();
    if (!since_) since_ = now;
    return now - *since_ < std::chrono::milliseconds(500) ? std::chrono::milliseconds(250)
                                                          : std::chrono::milliseconds(50);
  }
  /// Makes the next call of left() the first again.
  void renew() { since_.reset(); }

 private:
  std::optional<std::chrono::steady_clock::time_point> since_;
};

}  // namespace thiessen
