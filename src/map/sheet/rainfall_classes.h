#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "map/ink/canvas.h"
#include "map/sheet/palette.h"
#include "map/sheet/ticks.h"

namespace thiessen {

/// How rainfall is sorted into classes.
struct ClassRule {
  enum class Kind {
    chosen,     ///< quantiles where the largest value is over four times the median, else equal
    quantiles,  ///< five classes of about as many gauges each, between rounded values
    equal,      ///< equal steps between rounded values
    breaks,     ///< between the values of `breaks`
  };
  /// The ends of equal classes that are laid whatever the readings are.
  struct Range {
    double low;
    double high;
  };

  Kind kind = Kind::chosen;
  std::vector<double> breaks;  ///< in ascending order
  std::optional<Range> range;  ///< of equal classes only
  Palette palette = Palette::viridis;
};

/// The classes into which rainfall is sorted, each of one colour. A value that equals the bound of
/// two classes belongs to the upper one. Where no reading is negative, 0 has a class of its own,
/// outside of the others: dry.
class RainfallClasses {
 public:
  /// Lays classes over the readings, of which NaN are left out. Quantiles and the choice of a rule
  /// are of the values above 0. Cost: sorting the readings.
  RainfallClasses(std::vector<double> readings, const ClassRule& rule);

  /// The number of classes beside the dry one; 0 where no reading is above 0 and no rule lays them
  /// without readings.
  std::size_t count() const { return count_; }
  bool has_dry() const { return has_dry_; }
  /// Counts the readings outside of a range that was asked for. They take the class at its end.
  std::size_t outside() const { return outside_; }
  /// The values at which classes meet, ascending; 0, where it is a class of its own, is none.
  const std::vector<double>& bounds() const { return bounds_; }
  /// Where the lowest class begins and the highest ends; none where they have no end.
  std::optional<double> low_end() const { return low_end_; }
  std::optional<double> high_end() const { return high_end_; }
  /// The texts at the ends of classes, from the lowest to the highest, one more than classes, with
  /// equal decimals; empty where a class has no end. Where all readings are equal there is one
  /// class and one text.
  const std::vector<std::string>& ticks() const { return ticks_; }
  /// The colour of class `index`, counted from the lowest.
  Colour class_colour(std::size_t index) const;
  /// The colour of a reading.
  Colour colour(double rainfall) const;

 private:
  struct Ends {
    std::optional<RoundValue> low;
    std::optional<RoundValue> high;
  };

  void open_ends(bool below, bool above);
  void lay_over(std::vector<double> readings, const ClassRule& rule);
  void lay(std::vector<RoundValue> bounds, const Ends& ends);
  void lay_between_ticks(const std::vector<RoundValue>& ticks);
  void lay_quantiles(std::vector<double> sorted);
  void lay_range(const ClassRule::Range& range, const std::vector<double>& sorted);
  void lay_breaks(const std::vector<double>& breaks);

  Palette palette_;
  std::size_t count_ = 0;
  std::size_t outside_ = 0;
  bool has_dry_ = false;
  bool no_negative_ = true;
  std::vector<double> bounds_;  ///< between the classes
  std::optional<double> low_end_;
  std::optional<double> high_end_;
  std::vector<std::string> ticks_;
};

}  // namespace thiessen
