#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "rainfall/series/readings.h"

namespace thiessen {

/// The steps that a series has given so far, by the moment of their times, and what was read in
/// each. Memory: 24 bytes a step as long as times ascend, else some 100 bytes.
class GivenSteps {
 public:
  enum class Came : std::uint8_t {
    first,
    again,            ///< with the readings that it had
    again_otherwise,  ///< with others
  };

  /// Takes the next step, and says whether it was given before. It is kept as it came first.
  Came take(const TimeStep& step);

 private:
  struct Moment {
    std::int64_t seconds;
    int nanosecond;
    std::uint64_t readings;  ///< hashed
  };

  Came take_moment(const Moment& moment);
  Came take_text(const std::string& time, std::uint64_t readings);

  std::vector<Moment> ascending_;
  /// Of all others; a moment is written as its text.
  std::unordered_map<std::string, std::uint64_t> others_;
};

}  // namespace thiessen
