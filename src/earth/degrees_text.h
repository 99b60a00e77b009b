#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace thiessen {

/// An angle that is written in degrees, minutes and seconds.
struct DegreesText {
  enum class Axis : std::uint8_t { unsaid, latitude, longitude };
  double degrees = 0;        ///< negative in the south and in the west
  Axis axis = Axis::unsaid;  ///< by N, S, E or W, where it is written
};

/// Reads 47°30'15"N, 47d30.25', -0:05:30, W 5 30 15 and 47-30-15: see GeographicLib's DMS, whose
/// sums (47-30 for 17) are not read. Nothing where the text is anything else. A small letter,
/// and one of a language other than English (O for west), is not known.
std::optional<DegreesText> degrees_text(std::string_view text);

}  // namespace thiessen
