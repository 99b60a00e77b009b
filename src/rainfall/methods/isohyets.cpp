#include "rainfall/methods/isohyets.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace thiessen {
namespace {

double rounded_step(double span) {
  constexpr double levels_wanted = 8;
  const double step = span / levels_wanted;
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= step) return factor * power;
  }
  return 10 * power;
}

void lengthen(std::vector<Point>& line, Point p) {
  if (line.empty() || line.back() != p) line.push_back(p);
}

/// The last point, as far as doubles tell, from one at which something holds to one where it does
/// not.
Point last_where(Point is, Point is_not, const std::function<bool(Point)>& holds) {
  for (;;) {
    const Point middle{is.x + (is_not.x - is.x) / 2, is.y + (is_not.y - is.y) / 2};
    if (middle == is || middle == is_not) return is;
    (holds(middle) ? is : is_not) = middle;
  }
}

}  // namespace

std::vector<double> isohyet_levels(double least, double largest, double interval) {
  std::vector<double> levels;
  if (!(largest > least)) return levels;
  const double step = interval > 0 ? interval : rounded_step(largest - least);
  if ((largest - least) / step > most_levels) {
    throw Error({"", 0, "there would be more than 10000 isohyets",
                 "a larger " + setting("interval") + " makes fewer"});
  }
  for (double k = std::floor(least / step); k * step < largest; ++k) {
    if (k * step > least) levels.push_back(k * step);
  }
  return levels;
}

std::vector<std::vector<Point>> parts_where(const std::vector<Point>& line,
                                            const std::function<bool(Point)>& holds) {
  std::vector<std::vector<Point>> parts;
  bool held = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool holds_here = holds(line[i]);
    if (holds_here && !held) {
      parts.emplace_back();
      if (i > 0) lengthen(parts.back(), last_where(line[i], line[i - 1], holds));
    }
    if (!holds_here && held) lengthen(parts.back(), last_where(line[i - 1], line[i], holds));
    if (holds_here) lengthen(parts.back(), line[i]);
    held = holds_here;
  }
  const bool goes_on = parts.size() > 1 && line.front() == line.back() && held;
  if (goes_on) {  // over the point at which a closed line begins
    parts.back().insert(parts.back().end(), parts.front().begin() + 1, parts.front().end());
    parts.erase(parts.begin());
  }
  std::erase_if(parts, [](const std::vector<Point>& part) { return part.size() < 2; });
  return parts;
}

double isohyetal_mean(std::span<const double> values, const ValueRange& range, double interval) {
  std::vector<double> bounds = isohyet_levels(range.least, range.largest, interval);
  bounds.insert(bounds.begin(), range.least);
  bounds.push_back(range.largest);
  std::vector<std::size_t> counts(bounds.size() - 1, 0);
  for (const double value : values) {
    const auto above = std::upper_bound(bounds.begin() + 1, bounds.end() - 1, value);
    ++counts[static_cast<std::size_t>(above - bounds.begin()) - 1];
  }
  double sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    sum += static_cast<double>(counts[i]) * ((bounds[i] + bounds[i + 1]) / 2);
  return sum / static_cast<double>(values.size());
}

}  // namespace thiessen
