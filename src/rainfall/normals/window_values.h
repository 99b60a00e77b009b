#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
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
  double at(std::size_t band, std::size_t row, std::size_t column) const {
    const std::size_t i = (band * rows_ + row) * columns_ + column;
    return wide_.empty() ? static_cast<double>(narrow_[i]) : wide_[i];
  }
  void set(std::size_t band, std::size_t row, std::size_t column, double value) {
    const std::size_t i = (band * rows_ + row) * columns_ + column;
    if (wide_.empty()) {
      narrow_[i] = static_cast<float>(value);
    } else {
      wide_[i] = value;
    }
  }

 private:
  std::size_t columns_;
  std::size_t rows_;
  std::size_t bands_;
  std::vector<float> narrow_;
  std::vector<double> wide_;
};

}  // namespace thiessen
