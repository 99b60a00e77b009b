#include "rainfall/normals/pixel_integrals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace thiessen {
namespace {

/// How many columns have one sum together. A row's sum up to some column is that of its block and
/// of less than so many pixels, which lie in one or two lines of the machine's cache.
constexpr std::size_t block_columns = 16;

}  // namespace

PixelIntegrals::PixelIntegrals(WindowValues values, std::vector<double> references,
                               std::unique_ptr<const PixelAreas> areas)
    : values_(std::move(values)),
      references_(std::move(references)),
      areas_(std::move(areas)),
      blocks_(values_.columns() / block_columns + 1),
      is_complete_(values_.is_complete()) {
  sum_up();
}

void PixelIntegrals::sum_up() {
  const std::size_t rows = values_.rows();
  excess_before_.resize(bands() * rows * blocks_);
  if (!is_complete_) covered_before_.resize(excess_before_.size());
  if (areas_->vary_along_rows()) whole_before_.resize(rows * blocks_);
  const bool vary = areas_->vary_along_rows();
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t band = 0; band < bands(); ++band) {
      double excess = 0;
      double covered = 0;
      double whole = 0;
      for (std::size_t block = 0; block < blocks_; ++block) {
        const std::size_t here = (band * rows + row) * blocks_ + block;
        excess_before_[here] = excess;
        if (!is_complete_) covered_before_[here] = covered;
        if (vary) whole_before_[row * blocks_ + block] = whole;
        const std::size_t end = std::min(values_.columns(), (block + 1) * block_columns);
        for (std::size_t column = block * block_columns; column < end; ++column) {
          const double scale = vary ? areas_->scale(row, column) : 1;
          const double value = values_.at(band, row, column);
          whole += scale;
          if (std::isnan(value)) continue;
          excess += scale * (value - references_[band]);
          covered += scale;
        }
      }
    }
  }
}

/// The sums over a row from its first column up to one column, which moves along.
class PixelIntegrals::Running {
 public:
  Running(const PixelIntegrals& all, std::size_t band, std::size_t row, std::size_t column)
      : all_(all), band_(band), row_(row), column_(column / block_columns * block_columns) {
    const std::size_t block = column / block_columns;
    const std::size_t here = (band * all.values_.rows() + row) * all.blocks_ + block;
    excess_ = all.excess_before_[here];
    const double columns = static_cast<double>(column_);
    whole_ = all.whole_before_.empty() ? columns : all.whole_before_[row * all.blocks_ + block];
    covered_ = all.is_complete_ ? whole_ : all.covered_before_[here];
    while (column_ < column) {
      look();
      take();
    }
    if (column_ < all.values_.columns()) look();
  }

  /// Adds what lies to the left of a piece of an edge that rises by `rise` in the pixel's column,
  /// and has `beside` to its left in the pixel itself, both without the pixel's scale.
  void add(const Piece& piece, double sign, std::span<double> figures) const {
    const double part = scale_ * piece.beside;
    if (band_ == 0) figures[0] += sign * (whole_ * piece.rise + part);
    figures[excess_of(band_)] += sign * (excess_ * piece.rise + (has_value_ ? value_ * part : 0));
    figures[covered_of(band_)] += sign * (covered_ * piece.rise + (has_value_ ? part : 0));
  }
  /// Goes to the next column; beyond the last one the sums are the row's.
  void step_on() {
    take();
    if (column_ < all_.values_.columns()) look();
  }

 private:
  void look() {
    const double value = all_.values_.at(band_, row_, column_);
    has_value_ = !std::isnan(value);
    value_ = value - all_.references_[band_];
    scale_ = all_.whole_before_.empty() ? 1 : all_.areas_->scale(row_, column_);
  }
  void take() {
    whole_ += scale_;
    if (has_value_) {
      excess_ += scale_ * value_;
      covered_ += scale_;
    }
    ++column_;
    has_value_ = false;
    scale_ = 0;
  }

  const PixelIntegrals& all_;
  std::size_t band_;
  std::size_t row_;
  std::size_t column_;
  double excess_ = 0;
  double covered_ = 0;
  double whole_ = 0;
  double value_ = 0;
  double scale_ = 0;
  bool has_value_ = false;
};

void PixelIntegrals::add_edge(Point from, Point to, std::span<double> figures) const {
  if (from.y == to.y) return;
  const double sign = from.y > to.y ? 1 : -1;
  const Point upper = sign > 0 ? to : from;
  const Point lower = sign > 0 ? from : to;
  const double begin = std::max(upper.y, 0.0);
  const double end = std::min(lower.y, static_cast<double>(values_.rows()));
  if (!(begin < end)) return;
  const double slope = (lower.x - upper.x) / (lower.y - upper.y);
  const double west = std::min(upper.x, lower.x);
  const double east = std::max(upper.x, lower.x);
  const auto at = [&](double row) {
    if (row == upper.y) return upper;
    if (row == lower.y) return lower;
    return Point{std::clamp(upper.x + (row - upper.y) * slope, west, east), row};
  };
  auto row = static_cast<std::size_t>(begin);
  Pieces pieces;
  Stretch stretch{row, {}, at(begin), 0, areas_->ordinate(begin)};
  for (; static_cast<double>(row) < end; ++row) {
    stretch.row = row;
    stretch.from = stretch.to;
    stretch.from_ordinate = stretch.to_ordinate;
    stretch.to = at(std::min(end, static_cast<double>(row + 1)));
    stretch.to_ordinate = areas_->ordinate(stretch.to.y);
    if (stretch.from.y < stretch.to.y) add_stretch(stretch, sign, pieces, figures);
  }
}

// Goes through the pieces of the stretch in rising columns. The area beside a piece within its
// pixel is the integral of the way from the pixel's left edge over the ordinate, by Simpson's rule.
void PixelIntegrals::add_stretch(const Stretch& stretch, double sign, Pieces& pieces,
                                 std::span<double> figures) const {
  const bool eastwards = stretch.from.x <= stretch.to.x;
  const Point west = eastwards ? stretch.from : stretch.to;
  const Point east = eastwards ? stretch.to : stretch.from;
  const auto columns = static_cast<double>(values_.columns());
  if (east.x <= 0) return;
  struct Break {
    double column;
    double row;
    double ordinate;
  };
  const auto at = [&](double column) -> Break {
    const double row =
        std::clamp(west.y + (column - west.x) / (east.x - west.x) * (east.y - west.y),
                   stretch.from.y, stretch.to.y);
    return {column, row, areas_->ordinate(row)};
  };
  const Break last{east.x, east.y, eastwards ? stretch.to_ordinate : stretch.from_ordinate};
  Break from{west.x, west.y, eastwards ? stretch.from_ordinate : stretch.to_ordinate};
  if (west.x < 0) from = at(0);
  const auto first = static_cast<std::size_t>(std::min(from.column, columns));
  pieces.clear();
  for (std::size_t column = first; column < values_.columns(); ++column) {
    const auto right = static_cast<double>(column + 1);
    const Break to = east.x <= right ? last : at(right);
    const double rise = to.ordinate - from.ordinate;
    const double middle = areas_->ordinate(from.row + (to.row - from.row) / 2) - from.ordinate;
    const double beside = (to.column - static_cast<double>(column)) * rise -
                          (to.column - from.column) * (4 * middle + rise) / 6;
    pieces.push_back({rise, beside});
    from = to;
    if (east.x <= right) break;
  }
  // The ordinate falls where the stretch goes west.
  const double turn = eastwards ? sign : -sign;
  const double beyond = east.x >= columns ? last.ordinate - from.ordinate : 0;
  for (std::size_t band = 0; band < bands(); ++band) {
    Running running(*this, band, stretch.row, first);
    for (const Piece& piece : pieces) {
      running.add(piece, turn, figures);
      running.step_on();
    }
    if (beyond != 0) running.add({beyond, 0}, turn, figures);
  }
}

void PixelIntegrals::add_at(Point at, double area, std::span<double> figures) const {
  figures[0] += area;
  for (std::size_t band = 0; band < bands(); ++band) {
    const double value = value_at(at, band);
    if (std::isnan(value)) continue;
    figures[excess_of(band)] += area * (value - references_[band]);
    figures[covered_of(band)] += area;
  }
}

double PixelIntegrals::pixel_area(Point at) const {
  const double row = std::clamp(std::floor(at.y), 0.0, static_cast<double>(values_.rows() - 1));
  const double column =
      std::clamp(std::floor(at.x), 0.0, static_cast<double>(values_.columns() - 1));
  return (areas_->ordinate(row + 1) - areas_->ordinate(row)) *
         areas_->scale(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
}

double PixelIntegrals::value_at(Point at, std::size_t band) const {
  const bool is_within = at.x >= 0 && at.y >= 0 && at.x < static_cast<double>(values_.columns()) &&
                         at.y < static_cast<double>(values_.rows());
  if (!is_within) return std::numeric_limits<double>::quiet_NaN();
  return values_.at(band, static_cast<std::size_t>(at.y), static_cast<std::size_t>(at.x));
}

}  // namespace thiessen
