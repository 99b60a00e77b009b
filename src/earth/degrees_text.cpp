#include "earth/degrees_text.h"

#include <GeographicLib/DMS.hpp>
#include <cmath>
#include <string>

namespace thiessen {
namespace {

constexpr std::string_view blanks = " \t";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// The text with colons where only blanks or hyphens part its numbers, and without its other
/// blanks.
std::string with_colons(std::string_view text) {
  std::string joined;
  for (std::size_t i = 0; i < text.size();) {
    if (blanks.find(text[i]) == std::string_view::npos && text[i] != '-') {
      joined += text[i++];
      continue;
    }
    std::size_t end = text.find_first_not_of(" \t-", i);
    if (end == std::string_view::npos) end = text.size();
    const bool parts =
        !joined.empty() && is_digit(joined.back()) && end < text.size() && is_digit(text[end]);
    if (parts) {
      joined += ':';
    } else if (text.substr(i, end - i).find('-') != std::string_view::npos) {
      joined += '-';
    }
    i = end;
  }
  return joined;
}

}  // namespace

std::optional<DegreesText> degrees_text(std::string_view text) {
  constexpr std::size_t longest = 60;
  if (text.empty() || text.size() > longest) return std::nullopt;
  const std::string angle = with_colons(text);
  // A sign within the text would make a sum of it.
  if (angle.find_first_of("+-", 1) != std::string::npos) return std::nullopt;
  if (angle.find_first_of("0123456789") == std::string::npos) return std::nullopt;
  // A small e may be the beginning of an exponent.
  if (angle.find_first_of("nsew") != std::string::npos) return std::nullopt;
  using GeographicLib::DMS;
  try {
    DMS::flag flag = DMS::NONE;
    const double degrees = DMS::Decode(angle, flag);
    if (!std::isfinite(degrees)) return std::nullopt;
    using Axis = DegreesText::Axis;
    return DegreesText{degrees, flag == DMS::LATITUDE    ? Axis::latitude
                                : flag == DMS::LONGITUDE ? Axis::longitude
                                                         : Axis::unsaid};
  } catch (const GeographicLib::GeographicErr&) {
    return std::nullopt;
  }
}

}  // namespace thiessen
