#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace thiessen {

/// The values of a raster's window, band by band, rows from the top; NaN where a pixel has none.
/// They take four bytes each, or eight where `is_wide` says that four do not hold the raster's.
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
    return at(first_of(band, row) + column);
  }
  /// The value of a pixel by its place among all of them.
  double at(std::size_t i) const {
    return wide_.empty() ? static_cast<double>(narrow_[i]) : wide_[i];
  }
  /// The place of a row's first pixel; those of its other columns follow.
  std::size_t first_of(std::size_t band, std::size_t row) const {
    return (band * rows_ + row) * columns_;
  }
  /// Gives a pixel its value; each is to be given one once at most.
  void set(std::size_t band, std::size_t row, std::size_t column, double value) {
    set(band, row, column, std::span<const double>(&value, 1));
  }
  /// Gives pixels of a row from a column on their values; NaN is none.
  void set(std::size_t band, std::size_t row, std::size_t column, std::span<const double> values) {
    const std::size_t first = first_of(band, row) + column;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double value = values[i];
      if (std::isnan(value)) continue;
      ++given_;
      least_ = std::min(least_, value);
      largest_ = std::max(largest_, value);
      if (wide_.empty()) {
        narrow_[first + i] = static_cast<float>(value);
      } else {
        wide_[first + i] = value;
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
