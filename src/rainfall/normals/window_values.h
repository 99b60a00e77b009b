#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace thiessen {

/// The values of a raster's window, pixel by pixel, rows from the top; NaN where a pixel has none.
/// Those of a pixel's bands lie side by side, for who follows an edge wants all of them. They take
/// four bytes each, or eight where `is_wide` says that four do not hold the raster's.
class WindowValues {
 public:
  WindowValues(std::size_t columns, std::size_t rows, std::size_t bands, bool is_wide)
      : columns_(columns),
        rows_(rows),
        bands_(bands),
        narrow_(is_wide ? 0 : columns * rows * bands, std::numeric_limits<float>::quiet_NaN()),
        wide_(is_wide ? columns * rows * bands : 0, std::numeric_limits<double>::quiet_NaN()) {}

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  std::size_t bands() const { return bands_; }
  /// Whether every pixel has a value in every band.
  bool is_complete() const { return given_ == columns_ * rows_ * bands_; }
  /// The least of all values, and the largest; the one is infinite where there are none, and the
  /// other below all.
  double least() const { return least_; }
  double largest() const { return largest_; }
  double at(std::size_t band, std::size_t row, std::size_t column) const {
    const std::size_t i = place_of(row, column) + band;
    return wide_.empty() ? static_cast<double>(narrow_[i]) : wide_[i];
  }
  /// Where the first band of a pixel stands among all values; its others follow, and then those of
  /// the next column.
  std::size_t place_of(std::size_t row, std::size_t column) const {
    return (row * columns_ + column) * bands_;
  }
  /// Calls back with all values, which are floats or doubles.
  template <typename Take>
  void visit(const Take& take) const {
    wide_.empty() ? take(narrow_.data()) : take(wide_.data());
  }
  /// Gives a pixel its value; each is to be given one once at most.
  void set(std::size_t band, std::size_t row, std::size_t column, double value) {
    set(band, row, column, std::span<const double>(&value, 1));
  }
  /// Gives pixels of a row from a column on their values; NaN is none.
  void set(std::size_t band, std::size_t row, std::size_t column, std::span<const double> values) {
    std::size_t at = place_of(row, column) + band;
    for (std::size_t i = 0; i < values.size(); ++i, at += bands_) {
      const double value = values[i];
      if (std::isnan(value)) continue;
      ++given_;
      least_ = std::min(least_, value);
      largest_ = std::max(largest_, value);
      if (wide_.empty()) {
        narrow_[at] = static_cast<float>(value);
      } else {
        wide_[at] = value;
      }
    }
  }

 private:
  std::size_t columns_;
  std::size_t rows_;
  std::size_t bands_;
  std::size_t given_ = 0;
  double least_ = std::numeric_limits<double>::infinity();
  double largest_ = -std::numeric_limits<double>::infinity();
  std::vector<float> narrow_;
  std::vector<double> wide_;
};

}  // namespace thiessen
