#pragma once

#include <CLI/CLI.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/iso_time.h"
#include "geometry/point.h"

namespace thiessen::cli {

/// Numbers that an option takes.
struct NumberRange {
  double low;
  double high;
  const char* text;  ///< as in "a number above 0"
};

inline constexpr NumberRange above_zero{std::numeric_limits<double>::min(), 1e9,
                                        "a number above 0, to 1e9"};

/// Options whose values are read by our own grammar, whatever the locale; a wrong one is a usage
/// error that names the option and the range.
CLI::Option* add_number(CLI::App& app, const std::string& name, double& target, NumberRange range,
                        const std::string& help);
CLI::Option* add_count(CLI::App& app, const std::string& name, std::size_t& target, std::size_t low,
                       std::size_t high, const std::string& help);
/// A text that may not be empty.
CLI::Option* add_text(CLI::App& app, const std::string& name, std::string& target,
                      const std::string& kind, const std::string& help);

/// A time of ISO 8601.
CLI::Option* add_time(CLI::App& app, const std::string& name, std::optional<IsoTime>& target,
                      const std::string& help);

/// Two numbers and a comma between them: a point. May be given again.
CLI::Option* add_points(CLI::App& app, const std::string& name, std::vector<Point>& target,
                        const std::string& help);

/// WIDTH or WIDTHxHEIGHT in pixels; the height is 0 where it is not given.
struct PixelSize {
  std::size_t width = 1600;
  std::size_t height = 0;
};
CLI::Option* add_size(CLI::App& app, PixelSize& target);

/// One character, or `tab`.
CLI::Option* add_separator(CLI::App& app, char& target);

}  // namespace thiessen::cli
