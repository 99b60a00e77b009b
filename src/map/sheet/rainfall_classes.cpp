#include "map/sheet/rainfall_classes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "map/ink/ink.h"

namespace thiessen {
namespace {

constexpr int most_classes = 9;
constexpr int most_where_one_is_crowded = 14;

/// The value below which this share of the readings lies, between readings by a straight line.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 == sorted.size()) return sorted.back();
  return std::lerp(sorted[below], sorted[below + 1], place - std::floor(place));
}

/// Whether one class would hold most readings if all classes were equally wide.
bool is_skewed(const std::vector<double>& sorted) {
  constexpr double far = 4;  // times the median
  return sorted.back() > far * quantile(sorted, 0.5);
}

/// Equal rounded steps, finer where half of the readings would fall into one of them.
std::vector<RoundValue> equal_ticks(const std::vector<double>& sorted) {
  std::vector<RoundValue> ticks = round_scale(sorted.front(), sorted.back(), most_classes);
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    const auto begin = std::lower_bound(sorted.begin(), sorted.end(), ticks[i - 1].value());
    const auto end = std::lower_bound(begin, sorted.end(), ticks[i].value());
    if (2 * (end - begin) > std::ssize(sorted))
      return round_scale(sorted.front(), sorted.back(), most_where_one_is_crowded);
  }
  return ticks;
}

std::vector<double> above_zero(const std::vector<double>& sorted) {
  return {std::upper_bound(sorted.begin(), sorted.end(), 0.0), sorted.end()};
}

/// The bounds of five classes of about as many readings each. A bound may be moved by a twentieth
/// of the readings to a rounder value.
std::vector<RoundValue> rounded_quantiles(const std::vector<double>& sorted, RoundValue low,
                                          RoundValue high) {
  constexpr double leeway = 0.05;
  std::vector<RoundValue> bounds;
  for (const double share : {0.2, 0.4, 0.6, 0.8}) {
    const RoundValue bound = roundest(quantile(sorted, share - leeway), quantile(sorted, share),
                                      quantile(sorted, share + leeway));
    const double before = bounds.empty() ? low.value() : bounds.back().value();
    if (bound.value() > before && bound.value() < high.value()) bounds.push_back(bound);
  }
  return bounds;
}

}  // namespace

RainfallClasses::RainfallClasses(std::vector<double> readings, const ClassRule& rule)
    : palette_(rule.palette) {
  std::erase_if(readings, [](double reading) { return !std::isfinite(reading); });
  std::sort(readings.begin(), readings.end());
  no_negative_ = readings.empty() || readings.front() >= 0;
  has_dry_ = no_negative_ && !readings.empty() && readings.front() == 0;
  lay_over(std::move(readings), rule);
}

void RainfallClasses::lay_over(std::vector<double> readings, const ClassRule& rule) {
  if (rule.kind == ClassRule::Kind::breaks) return lay_breaks(rule.breaks);
  if (no_negative_) readings = above_zero(readings);
  if (rule.range) return lay_range(*rule.range, readings);
  if (readings.empty()) return;
  const bool by_quantiles =
      rule.kind == ClassRule::Kind::quantiles ||
      (rule.kind == ClassRule::Kind::chosen && no_negative_ && is_skewed(readings));
  if (by_quantiles) return lay_quantiles(std::move(readings));
  lay_between_ticks(equal_ticks(readings));
}

void RainfallClasses::lay(std::vector<RoundValue> bounds, const Ends& ends) {
  count_ = bounds.size() + 1;
  for (const RoundValue& bound : bounds) bounds_.push_back(bound.value());
  if (ends.low) {
    low_end_ = ends.low->value();
    bounds.insert(bounds.begin(), *ends.low);
  }
  if (ends.high) {
    high_end_ = ends.high->value();
    bounds.push_back(*ends.high);
  }
  ticks_ = texts_of(bounds);
  if (!ends.low) ticks_.insert(ticks_.begin(), "");
  if (!ends.high) ticks_.emplace_back();
}

void RainfallClasses::lay_between_ticks(const std::vector<RoundValue>& ticks) {
  if (ticks.size() == 1) {
    // One text stands for the class, so that it has no ends to be opened.
    count_ = 1;
    ticks_ = texts_of({few_digits(ticks.front().value())});
    return;
  }
  lay({ticks.begin() + 1, ticks.end() - 1}, {ticks.front(), ticks.back()});
}

void RainfallClasses::lay_quantiles(std::vector<double> sorted) {
  if (round_scale(sorted.front(), sorted.back(), most_classes).size() == 1)
    return lay_between_ticks({nine_digits(sorted.back())});
  Ends ends{round_down(sorted.front(), 1), round_up(sorted.back(), 2)};
  // A trace, as a surface has beside dry ground, would give all bounds its many decimals.
  constexpr double hardly_any = 0.01;
  if (no_negative_ && sorted.front() < hardly_any * quantile(sorted, 0.2)) ends.low = RoundValue{};
  std::vector<RoundValue> bounds = rounded_quantiles(sorted, *ends.low, *ends.high);
  if (bounds.empty()) {
    // Most readings are the same: the others have to tell.
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    bounds = rounded_quantiles(sorted, *ends.low, *ends.high);
  }
  lay(std::move(bounds), ends);
}

void RainfallClasses::lay_range(const ClassRule::Range& range, const std::vector<double>& sorted) {
  const RoundValue low = nine_digits(range.low);
  const RoundValue high = nine_digits(range.high);
  std::vector<RoundValue> bounds = round_scale(range.low, range.high, most_classes);
  std::erase_if(bounds, [&](const RoundValue& bound) {
    return !(bound.value() > range.low && bound.value() < range.high);
  });
  lay(std::move(bounds), {low, high});
  const auto below = std::lower_bound(sorted.begin(), sorted.end(), range.low) - sorted.begin();
  const auto above = sorted.end() - std::upper_bound(sorted.begin(), sorted.end(), range.high);
  open_ends(below > 0, above > 0);
  outside_ = static_cast<std::size_t>(below + above);
}

void RainfallClasses::open_ends(bool below, bool above) {
  if (below && !ticks_.front().starts_with("\u2264")) ticks_.front().insert(0, "\u2264 ");
  if (above && !ticks_.back().starts_with("\u2265")) ticks_.back().insert(0, "\u2265 ");
}

// The classes do not depend on the readings, so that those of a series are the same.
void RainfallClasses::lay_breaks(const std::vector<double>& breaks) {
  std::vector<double> own = breaks;
  Ends ends;
  if (no_negative_) {
    ends.low = RoundValue{};
    std::erase(own, 0.0);
  }
  std::vector<RoundValue> bounds;
  bounds.reserve(own.size());
  for (const double value : own) bounds.push_back(nine_digits(value));
  lay(std::move(bounds), ends);
  bounds_ = std::move(own);  // of all digits that were given
}

Colour RainfallClasses::class_colour(std::size_t index) const {
  return sequential_colour(palette_, index, count_);
}

Colour RainfallClasses::colour(double rainfall) const {
  if (rainfall == 0 && no_negative_) return ink::dry;
  const auto above = std::upper_bound(bounds_.begin(), bounds_.end(), rainfall);
  return class_colour(static_cast<std::size_t>(above - bounds_.begin()));
}

}  // namespace thiessen
