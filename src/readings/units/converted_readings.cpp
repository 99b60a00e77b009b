#include "readings/units/converted_readings.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr RainUnit millimetre = {"mm", "", 1, 1};

bool is_same(const RainUnit& a, const RainUnit& b) {
  return a.depth == b.depth && a.rate == b.rate;
}

/// The unit that the lines above a header say.
std::optional<RainUnit> unit_above(const ValueColumn& column) {
  std::optional<RainUnit> found;
  for (const std::string& line : column.lines_above) {
    const auto unit = unit_in_line(line);
    if (!unit) continue;
    if (found && !is_same(*found, *unit)) {
      throw Error({column.file, column.line,
                   "the lines above the header say that it is in " + found->name() + " and in " +
                       unit->name(),
                   setting("from_unit") + " says what the readings are in"});
    }
    found = unit;
  }
  return found;
}

}  // namespace

AmountConversion conversion_from(const RainUnit& unit, const ReadingsOptions& options) {
  AmountConversion conversion;
  conversion.millimetres = factor_between(unit, millimetre).of(1);
  if (options.scale) {
    conversion.factor.multiply = *options.scale;
    return conversion;
  }
  RainUnit to = options.to_unit.value_or(millimetre);
  // What falls in a second has no digits in a table of three decimals.
  to.rate = unit.rate == "/s" ? "/h" : unit.rate;
  conversion.factor = factor_between(unit, to);
  conversion.unit = to.name();
  return conversion;
}

AmountConversion conversion_of(const ReadingsOptions& options, const ValueColumn& column,
                               Warnings& warnings) {
  const std::optional<RainUnit> below = rain_unit(column.unit);
  std::optional<RainUnit> named = below ? below : unit_in_name(column.name);
  const bool is_told_above = !named && !options.from_unit && !options.scale;
  if (is_told_above) named = unit_above(column);
  const std::string called =
      column.name.empty() ? "the table" : "column " + quoted(column.name, 60);
  if (options.scale) {
    if (named && !is_same(*named, millimetre)) {
      warnings.add_notice({column.file, column.line,
                           "the readings of " + called + " are multiplied by " + setting("scale") +
                               " alone, and not taken from " + named->name() + " to another unit",
                           ""});
    }
    return {{*options.scale, 1}, "", *options.scale};
  }
  if (options.from_unit) {
    if (named && !is_same(*named, *options.from_unit)) {
      warnings.add({column.file, column.line,
                    "the readings of " + called + " are taken to be in " +
                        options.from_unit->name() + ", as " + setting("from_unit") +
                        " says, against its own " + named->name(),
                    ""});
    }
    return conversion_from(*options.from_unit, options);
  }
  if (!named) {
    if (!options.to_unit) return {};
    throw Error({column.file, column.line,
                 "nothing says what the readings are in, so that they cannot be brought to " +
                     options.to_unit->name(),
                 setting("from_unit") + " says it"});
  }
  AmountConversion conversion = conversion_from(*named, options);
  if (!conversion.factor.is_one()) {
    warnings.add_notice({column.file, column.line,
                         "the readings of " + called + " are converted from " + named->name() +
                             " to " + conversion.unit +
                             (is_told_above ? ", as a line above the header says" : ""),
                         ""});
  }
  return conversion;
}

bool ConvertedReadings::next(TimeStep& step) {
  if (!all_->next(step)) return false;
  if (conversion_.factor.is_one()) return true;
  amounts_.resize(step.readings.size());
  std::transform(step.readings.begin(), step.readings.end(), amounts_.begin(),
                 [&](double amount) { return conversion_.factor.of(amount); });
  step.readings = amounts_;
  return true;
}

std::unique_ptr<Readings> converted(std::unique_ptr<Readings> readings,
                                    const AmountConversion& conversion) {
  if (conversion.factor.is_one() && conversion.unit.empty()) return readings;
  return std::make_unique<ConvertedReadings>(std::move(readings), conversion);
}

}  // namespace thiessen
