#pragma once

#include <string_view>

namespace thiessen {

/// The words with which a message refuses a coordinate for which in_exact_range is false.
inline constexpr std::string_view outside_exact_range =
    "outside the supported range: 0, or 1.8e-43 to 3.2e60 in magnitude";

}  // namespace thiessen
