#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/iso_time.h"
#include "cli/options/option.h"
#include "geometry/point.h"
#include "readings/units/rain_unit.h"

namespace thiessen::cli {

// \file
// The kinds of values that options take. Each is read by our own grammar, whatever the locale, into
// a target that has to outlive the option. A wrong text throws WrongValue with what was wanted.

/// A range of numbers that an option takes.
struct NumberRange {
  double low;
  double high;
  const char* text;  ///< as in "a number above 0"
};

inline constexpr NumberRange above_zero{std::numeric_limits<double>::min(), 1e9,
                                        "a number above 0, to 1e9"};

/// The value of a flag: it takes none, sets the target where it is given, and may be given twice.
OptionValue flag(bool& target);
/// The value of a flag that has no target: whether it is given is asked of the option itself.
OptionValue sign();
OptionValue number(double& target, NumberRange range);
OptionValue whole_number(std::size_t& target, std::size_t low, std::size_t high);
/// A text that may not be empty.
OptionValue text(std::string& target, const std::string& kind);
/// A text that may be empty.
OptionValue any_text(std::string& target, const std::string& kind);
/// Texts of an option that may be repeated: each time adds one, which may be empty.
OptionValue texts(std::vector<std::string>& target, const std::string& kind);
/// The name of a file, or of a folder; `kind` is empty for an argument. An empty name is accepted
/// here, and refused after all options are read, as it is no usage error but a file that cannot be
/// opened.
OptionValue file(std::string& target, const std::string& kind = {});
OptionValue folder(std::string& target, const std::string& kind);
/// A time in the form of ISO 8601.
OptionValue iso_time(std::optional<IsoTime>& target);
/// A clock such as 09:00, to 24:00; in minutes after midnight.
OptionValue clock_time(std::optional<int>& target);
/// A unit of rain, by its name.
OptionValue rain_unit_of(std::optional<RainUnit>& target);
/// Points of an option that may be repeated: each is two numbers with a comma between them.
OptionValue points(std::vector<Point>& target);
/// Numbers with commas between them, each larger than the one before, as A,B,... is read; nothing
/// where the text is anything else.
std::optional<std::vector<double>> rising_numbers_in(const std::string& text);

/// One character, or `tab`.
OptionValue separator(char& target);
/// A format of times (see TimeFormat).
OptionValue time_format(std::string& target);
/// An encoding of texts that can be read.
OptionValue encoding(std::string& target);
/// A number of lines.
OptionValue lines(std::optional<std::size_t>& target);

/// WIDTH or WIDTHxHEIGHT in pixels or, with mm behind it, in millimetres; the height is 0 where it
/// is not given.
struct PixelSize {
  std::size_t width = 1600;
  std::size_t height = 0;
  bool millimetres = false;
};
OptionValue pixel_size(PixelSize& target);

/// The names of the choices as the help lists them: `a|b|c`.
std::string listed_choices(const std::vector<std::string>& names);
/// Throws WrongValue, because `text` is none of the choices.
[[noreturn]] void refuse_choice(const std::vector<std::string>& names, const std::string& text);

/// A value chosen by name out of a list.
template <typename Value>
OptionValue choice(Value& target, std::vector<std::pair<std::string, Value>> choices) {
  OptionValue value;
  for (const auto& [name, meant] : choices) value.choices.push_back(name);
  value.kind = listed_choices(value.choices);
  value.read = [&target, choices = std::move(choices),
                names = value.choices](const std::string& text) {
    for (const auto& [name, meant] : choices) {
      if (name != text) continue;
      target = meant;
      return;
    }
    refuse_choice(names, text);
  };
  return value;
}

}  // namespace thiessen::cli
