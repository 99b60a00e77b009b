#include "cli/outputs/rasters/raster_style.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace thiessen::cli {
namespace {

/// The place at which QGIS looks for the style of a raster.
std::string style_path(const std::string& path) {
  return path.substr(0, path.rfind('.')) + ".qml";
}

/// A value in few digits, for a legend.
std::string short_text(double value) {
  constexpr int digits = 6;
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

/// A value as a raster of floats holds it.
double held(double value) {
  return static_cast<double>(static_cast<float>(value));
}

/// The ends of a class that begins or ends at a value, which the raster may hold as a little less
/// or more. GDAL writes 16 digits of them, and one in the last must not leave the value out.
constexpr double sixteenth_digit = 1e-15;

double beginning_at(double value) {
  const double in_raster = held(value);
  return in_raster < value ? in_raster - std::abs(in_raster) * sixteenth_digit : value;
}

double ending_at(double value) {
  const double in_raster = held(value);
  return in_raster > value ? in_raster + std::abs(in_raster) * sixteenth_digit : value;
}

/// The largest value of a raster of floats below a bound: QGIS and GDAL have a class reach up to
/// its value, and one that equals the bound is of the class above, as the raster holds either.
double just_below(double bound) {
  return static_cast<double>(std::nextafter(static_cast<float>(bound), -HUGE_VALF));
}

}  // namespace

StationStyle::StationStyle(std::vector<std::string> ids, int columns)
    : ids_(std::move(ids)),
      columns_(static_cast<std::size_t>(columns)),
      last_row_(columns_, 0),
      owns_(ids_.size() + 1, false) {}

void StationStyle::note(std::span<const std::int32_t> rows) {
  for (std::size_t begin = 0; begin < rows.size(); begin += columns_) {
    const auto row = rows.subspan(begin, columns_);
    for (std::size_t x = 0; x < columns_; ++x) {
      owns_[static_cast<std::size_t>(row[x])] = true;
      touch(row[x], last_row_[x]);
      if (x > 0) touch(row[x], row[x - 1]);
    }
    std::copy(row.begin(), row.end(), last_row_.begin());
  }
}

void StationStyle::touch(std::int32_t a, std::int32_t b) {
  if (a == b || a == 0 || b == 0) return;
  pairs_.add(static_cast<std::uint32_t>(a - 1), static_cast<std::uint32_t>(b - 1));
}

std::size_t StationStyle::owners() const {
  return static_cast<std::size_t>(std::count(owns_.begin() + 1, owns_.end(), true));
}

const std::vector<Colour>& StationStyle::colours() {
  const auto palette = categorical_colours();
  colours_.clear();
  if (owners() > most_chosen) return colours_;
  for (const std::uint8_t chosen : colour_neighbours(ids_.size(), pairs_.pairs(), palette.size())) {
    colours_.push_back(palette[chosen]);
  }
  return colours_;
}

EncodedFile StationStyle::file(const std::string& path) const {
  constexpr std::size_t numbers_to_a_colour = 3;
  if (owners() > most_chosen)
    return {style_path(path), style_of_numbers(ids_.size(), numbers_to_a_colour)};
  std::vector<StyleEntry> entries;
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (owns_[i + 1]) entries.push_back({static_cast<double>(i + 1), ids_[i], colours_[i]});
  }
  return {style_path(path), style_of_values(entries)};
}

RainfallStyle::RainfallStyle(const RainfallClasses& classes, std::span<const double> values,
                             std::string unit)
    : unit_(std::move(unit)) {
  double least = HUGE_VAL;
  double largest = -HUGE_VAL;
  bool any = false;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    any = true;
    if (classes.has_dry() && value == 0) continue;
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
  if (any) lay_classes(classes, least, largest);
  lay_entries(classes);
}

void RainfallStyle::lay_classes(const RainfallClasses& classes, double least, double largest) {
  const std::vector<double>& bounds = classes.bounds();
  if (classes.has_dry()) classes_.push_back({0, 0, classes.colour(0)});
  for (std::size_t i = 0; i < classes.count(); ++i) {
    const double low =
        beginning_at(i > 0 ? bounds[i - 1] : std::min(least, classes.low_end().value_or(least)));
    const double high = i < bounds.size()
                            ? just_below(bounds[i])
                            : ending_at(std::max(largest, classes.high_end().value_or(largest)));
    classes_.push_back({low, high, classes.class_colour(i)});
  }
}

std::string RainfallStyle::label_of(const RainfallClasses& classes, std::size_t index) const {
  const std::vector<double>& bounds = classes.bounds();
  if (bounds.empty()) return classes.ticks().front();
  if (index == 0) return "below " + short_text(bounds.front());
  if (index == bounds.size()) return "from " + short_text(bounds.back());
  return short_text(bounds[index - 1]) + " to " + short_text(bounds[index]);
}

void RainfallStyle::lay_entries(const RainfallClasses& classes) {
  const std::vector<double>& bounds = classes.bounds();
  if (classes.has_dry()) entries_.push_back({0, "dry", classes.colour(0)});
  for (std::size_t i = 0; i < classes.count(); ++i) {
    const std::string text = label_of(classes, i);
    const double value = i < bounds.size() ? just_below(bounds[i]) : HUGE_VAL;
    entries_.push_back({value, unit_.empty() ? text : text + " " + unit_, classes.class_colour(i)});
  }
}

EncodedFile RainfallStyle::file(const std::string& path) const {
  return {style_path(path), style_of_classes(entries_)};
}

}  // namespace thiessen::cli
