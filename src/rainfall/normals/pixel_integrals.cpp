#include "rainfall/normals/pixel_integrals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace thiessen {
namespace {

/// How many columns have one sum together. A row's sum up to some column is that of its block and
/// of less than so many pixels.
constexpr std::size_t block_columns = 8;

}  // namespace

PixelIntegrals::PixelIntegrals(WindowValues values, std::vector<double> references,
                               std::unique_ptr<const PixelAreas> areas)
    : values_(std::move(values)),
      references_(std::move(references)),
      areas_(std::move(areas)),
      blocks_(values_.columns() / block_columns + 1),
      is_complete_(values_.is_complete()),
      vary_(areas_->vary_along_rows()),
      sums_(std::size_t{1} + (is_complete_ ? 0u : 1u) + (vary_ ? 1u : 0u)) {
  sum_up();
}

void PixelIntegrals::sum_up() {
  const std::size_t rows = values_.rows();
  before_.reserve(bands() * rows * blocks_ * sums_);
  for (std::size_t band = 0; band < bands(); ++band) {
    for (std::size_t row = 0; row < rows; ++row) sum_up_row(band, row);
  }
}

void PixelIntegrals::sum_up_row(std::size_t band, std::size_t row) {
  double excess = 0;
  double covered = 0;
  double whole = 0;
  PixelAreas::Scales scales{0, 0};
  const std::size_t first = values_.first_of(band, row);
  for (std::size_t block = 0; block < blocks_; ++block) {
    before_.push_back(excess);
    if (!is_complete_) before_.push_back(covered);
    if (vary_) before_.push_back(whole);
    const std::size_t end = std::min(values_.columns(), (block + 1) * block_columns);
    for (std::size_t column = block * block_columns; column < end; ++column) {
      if (column == scales.end) scales = areas_->scales(row, column);
      const double scale = scales.at(column);
      const double value = values_.at(first + column);
      whole += scale;
      if (std::isnan(value)) continue;
      excess += scale * (value - references_[band]);
      covered += scale;
    }
  }
}

/// The sums over a row from its first column up to one column, which moves along, and what pieces
/// of an edge add to a band's figures.
class PixelIntegrals::Running {
 public:
  Running(const PixelIntegrals& all, std::size_t band, std::size_t row, std::size_t column)
      : all_(all),
        row_(row),
        column_(column / block_columns * block_columns),
        first_(all.values_.first_of(band, row)),
        reference_(all.references_[band]) {
    const std::size_t block = column / block_columns;
    const std::size_t entry = (band * all.values_.rows() + row) * all.blocks_ + block;
    const double* const before = &all.before_[entry * all.sums_];
    excess_ = before[0];
    whole_ = all.vary_ ? before[all.sums_ - 1] : static_cast<double>(column_);
    covered_ = all.is_complete_ ? whole_ : before[1];
    scales_ = all.vary_ ? PixelAreas::Scales{0, 0}
                        : PixelAreas::Scales{0, std::numeric_limits<std::size_t>::max()};
    while (column_ < column) {
      look();
      take();
    }
    if (column_ < all.values_.columns()) look();
  }

  /// Adds what lies to the left of a piece of an edge that rises by `rise` in the pixel's column,
  /// and has `beside` to its left in the pixel itself, both without the pixel's scale.
  void add(const Piece& piece) {
    const double part = scale_ * piece.beside;
    sum_of_whole_ += whole_ * piece.rise + part;
    sum_of_excess_ += excess_ * piece.rise + (has_value_ ? value_ * part : 0);
    sum_of_covered_ += covered_ * piece.rise + (has_value_ ? part : 0);
  }
  /// Goes to the next column; beyond the last one the sums are the row's.
  void step_on() {
    take();
    if (column_ < all_.values_.columns()) look();
  }
  /// Adds the sums of the pieces to the figures.
  void finish(std::size_t band, double sign, std::span<double> figures) const {
    if (band == 0) figures[0] += sign * sum_of_whole_;
    figures[excess_of(band)] += sign * sum_of_excess_;
    figures[covered_of(band)] += sign * sum_of_covered_;
  }

 private:
  void look() {
    const double value = all_.values_.at(first_ + column_);
    has_value_ = !std::isnan(value);
    value_ = value - reference_;
    if (column_ >= scales_.end || column_ < scales_.first)
      scales_ = all_.areas_->scales(row_, column_);
    scale_ = scales_.at(column_);
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
  std::size_t row_;
  std::size_t column_;
  std::size_t first_;
  double reference_;
  PixelAreas::Scales scales_{0, 0};
  double excess_ = 0;
  double covered_ = 0;
  double whole_ = 0;
  double value_ = 0;
  double scale_ = 0;
  bool has_value_ = false;
  double sum_of_whole_ = 0;
  double sum_of_excess_ = 0;
  double sum_of_covered_ = 0;
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
  Stretch stretch{row, {}, at(begin), 0, areas_->ordinate(begin)};
  for (; static_cast<double>(row) < end; ++row) {
    stretch.row = row;
    stretch.from = stretch.to;
    stretch.from_ordinate = stretch.to_ordinate;
    stretch.to = at(std::min(end, static_cast<double>(row + 1)));
    stretch.to_ordinate = areas_->ordinate(stretch.to.y);
    if (stretch.from.y < stretch.to.y) add_stretch(stretch, sign, figures);
  }
}

// Goes through the pieces of the stretch in rising columns. The area beside a piece within its
// pixel is the integral of the way from the pixel's left edge over the ordinate, by Simpson's rule.
template <typename Take>
void PixelIntegrals::for_each_piece(const Stretch& stretch, const Take& take) const {
  const bool eastwards = stretch.from.x <= stretch.to.x;
  const Point west = eastwards ? stretch.from : stretch.to;
  const Point east = eastwards ? stretch.to : stretch.from;
  const auto columns = static_cast<double>(values_.columns());
  const std::optional<PixelAreas::InRow> in_row = areas_->in_row(stretch.row);
  const auto top = static_cast<double>(stretch.row);
  const auto ordinate = [&](double row) {
    return in_row ? in_row->at(row - top) : areas_->ordinate(row);
  };
  struct Break {
    double column;
    double row;
    double ordinate;
  };
  const double slope = (east.y - west.y) / (east.x - west.x);
  const auto at = [&](double column) -> Break {
    const double row = std::clamp(west.y + (column - west.x) * slope, stretch.from.y, stretch.to.y);
    return {column, row, ordinate(row)};
  };
  const Break last{east.x, east.y, eastwards ? stretch.to_ordinate : stretch.from_ordinate};
  Break from{west.x, west.y, eastwards ? stretch.from_ordinate : stretch.to_ordinate};
  if (west.x < 0) from = at(0);
  const bool is_straight = in_row && in_row->bend == 0;
  for (double left = std::floor(std::min(from.column, columns)); left < columns; ++left) {
    const Break to = east.x <= left + 1 ? last : at(left + 1);
    const double rise = to.ordinate - from.ordinate;
    const double middle =
        is_straight ? rise / 2 : ordinate(from.row + (to.row - from.row) / 2) - from.ordinate;
    take(Piece{rise,
               (to.column - left) * rise - (to.column - from.column) * (4 * middle + rise) / 6});
    from = to;
    if (east.x <= left + 1) break;
  }
  if (east.x >= columns && last.ordinate != from.ordinate)
    take(Piece{last.ordinate - from.ordinate, 0});
}

void PixelIntegrals::add_stretch(const Stretch& stretch, double sign,
                                 std::span<double> figures) const {
  const bool eastwards = stretch.from.x <= stretch.to.x;
  const double west = std::min(stretch.from.x, stretch.to.x);
  if (std::max(stretch.from.x, stretch.to.x) <= 0) return;
  const auto columns = static_cast<double>(values_.columns());
  const auto first = static_cast<std::size_t>(std::clamp(west, 0.0, columns));
  // The ordinate falls where the stretch goes west.
  const double turn = eastwards ? sign : -sign;
  if (bands() == 1) {
    Running running(*this, 0, stretch.row, first);
    for_each_piece(stretch, [&](const Piece& piece) {
      running.add(piece);
      running.step_on();
    });
    return running.finish(0, turn, figures);
  }
  std::vector<Piece> pieces;
  for_each_piece(stretch, [&](const Piece& piece) { pieces.push_back(piece); });
  for (std::size_t band = 0; band < bands(); ++band) {
    Running running(*this, band, stretch.row, first);
    for (const Piece& piece : pieces) {
      running.add(piece);
      running.step_on();
    }
    running.finish(band, turn, figures);
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
  const auto r = static_cast<std::size_t>(row);
  const std::optional<PixelAreas::InRow> in_row = areas_->in_row(r);
  return (in_row ? in_row->whole : areas_->ordinate(row + 1) - areas_->ordinate(row)) *
         areas_->scale(r, static_cast<std::size_t>(column));
}

double PixelIntegrals::value_at(Point at, std::size_t band) const {
  const bool is_within = at.x >= 0 && at.y >= 0 && at.x < static_cast<double>(values_.columns()) &&
                         at.y < static_cast<double>(values_.rows());
  if (!is_within) return std::numeric_limits<double>::quiet_NaN();
  return values_.at(band, static_cast<std::size_t>(at.y), static_cast<std::size_t>(at.x));
}

}  // namespace thiessen
