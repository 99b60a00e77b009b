#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace thiessen {

/// How large the pixels of a raster's window are, and parts of them. Positions are in pixels:
/// columns from the window's left edge, rows downwards from its top. The area of what lies between
/// two rows in one pixel's column is the difference of their ordinates times the pixel's scale.
class PixelAreas {
 public:
  /// The ordinates within one row: a parabola through its upper edge, its middle and its lower
  /// edge.
  struct InRow {
    double upper;
    double whole;     ///< by which they rise over the row
    double bend = 0;  ///< 0 where they are a straight line
    /// The ordinate a part of the row, from 0 to 1, below its upper edge.
    double at(double along) const { return upper + along * (whole + bend * (1 - along)); }
  };
  /// The scales of some pixels of a row that follow each other: a straight line.
  struct Scales {
    std::size_t first;  ///< the first column
    std::size_t end;    ///< the column behind the last
    double of_first = 1;
    double step = 0;
    double at(std::size_t column) const {
      return of_first + step * static_cast<double>(column - first);
    }
  };

  virtual ~PixelAreas() = default;
  /// The area of a column one pixel wide from the window's top down to `row`, which need not be a
  /// whole number. It rises.
  virtual double ordinate(double row) const = 0;
  /// All ordinates of a row at once, which `ordinate` agrees with but for rounding; nothing where
  /// they are no parabola.
  virtual std::optional<InRow> in_row(std::size_t row) const = 0;
  /// Whether pixels of one row differ; else every scale is 1.
  virtual bool vary_along_rows() const { return false; }
  /// The scales of a row from a column on, as far as they are one straight line.
  virtual Scales scales(std::size_t /*row*/, std::size_t column) const {
    return {column, std::numeric_limits<std::size_t>::max()};
  }
  double scale(std::size_t row, std::size_t column) const { return scales(row, column).at(column); }
};

/// Pixels that all have one area, those of a plane.
class EqualPixels final : public PixelAreas {
 public:
  explicit EqualPixels(double area) : area_(area) {}
  double ordinate(double row) const override { return area_ * row; }
  std::optional<InRow> in_row(std::size_t row) const override {
    return InRow{area_ * static_cast<double>(row), area_};
  }

 private:
  double area_;
};

/// Pixels between parallels and meridians, by their areas on the WGS 84 ellipsoid in square metres.
/// Accuracy: 1e-8 of a part of a pixel, and 1e-13 of whole rows.
class PixelsInDegrees final : public PixelAreas {
 public:
  /// The window's top lies at the latitude `top`; a row is `height` degrees high, below 0 where
  /// latitudes fall downwards; a column is `width` degrees wide. Requires latitudes within 90.
  PixelsInDegrees(double top, double height, double width, std::size_t rows);
  // The ordinate is a parabola through the edges of a row and its middle: the fourth term of its
  // series is 6e-9 of a row that is as high as they may be.
  double ordinate(double row) const override {
    if (middles_.empty() || row < 0 || row > static_cast<double>(middles_.size()))
      return exactly(row);
    const std::size_t r = std::min(static_cast<std::size_t>(row), middles_.size() - 1);
    return in_row(r)->at(row - static_cast<double>(r));
  }
  std::optional<InRow> in_row(std::size_t row) const override {
    if (middles_.empty()) return std::nullopt;
    const double whole = edges_[row + 1] - edges_[row];
    return InRow{edges_[row], whole, 4 * (middles_[row] - edges_[row] - whole / 2)};
  }

 private:
  double exactly(double row) const;

  double top_;
  double height_;
  double width_;
  std::vector<double> edges_;    // by row: of its upper edge, and the last one's lower
  std::vector<double> middles_;  // by row
};

/// Pixels of any projection. Their scales are known at nodes a few pixels apart and taken to be
/// linear between these; within a pixel the scale is one. Accuracy: a mean over a cell is right to
/// 3e-7 where pixels are 5 km wide, and to 7e-6 where the cell is smaller than a pixel (against
/// pixels a tenth as large, in UTM).
class PixelsOfPlane final : public PixelAreas {
 public:
  /// The most pixels that are to lie between two nodes, and how far apart nodes are to be, in
  /// metres.
  static constexpr std::size_t most_spacing = 16;
  static constexpr double farthest_nodes = 16e3;
  /// `nodes` has the areas of a pixel at the nodes, row by row: one for each `spacing` pixels and
  /// one more, each way.
  PixelsOfPlane(std::vector<double> nodes, std::size_t columns, std::size_t spacing);
  static std::size_t nodes_along(std::size_t pixels, std::size_t spacing) {
    return pixels / spacing + 2;
  }

  double ordinate(double row) const override { return row; }
  std::optional<InRow> in_row(std::size_t row) const override {
    return InRow{static_cast<double>(row), 1};
  }
  bool vary_along_rows() const override { return true; }
  Scales scales(std::size_t row, std::size_t column) const override {
    // A number that the compiler knows makes shifts of divisions.
    return spacing_ == most_spacing ? scales(row, column, most_spacing)
                                    : scales(row, column, spacing_);
  }

 private:
  Scales scales(std::size_t row, std::size_t column, std::size_t spacing) const {
    const std::size_t node = column / spacing;
    const double* const upper = &nodes_[row / spacing * nodes_in_row_ + node];
    const double* const lower = upper + nodes_in_row_;
    const auto pixels = static_cast<double>(spacing);
    const double down = (static_cast<double>(row % spacing) + 0.5) / pixels;
    const double left = upper[0] + down * (lower[0] - upper[0]);
    const double right = upper[1] + down * (lower[1] - upper[1]);
    const double step = (right - left) / pixels;
    return {node * spacing, (node + 1) * spacing, left + step / 2, step};
  }

  std::vector<double> nodes_;
  std::size_t spacing_;
  std::size_t nodes_in_row_;
};

}  // namespace thiessen
