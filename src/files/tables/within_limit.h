#pragma once

#include <string_view>

#include "base/number.h"

namespace thiessen {

/// Whether a text is a number from -limit to limit, by which lists of stations know a latitude (90)
/// and a longitude (180).
inline bool is_within(std::string_view text, double limit) {
  const auto number = parse_number(text);
  return number && number.value >= -limit && number.value <= limit;
}

}  // namespace thiessen
