#include "rainfall/normals/pixel_integrals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace thiessen {
namespace {

/// How many columns have one sum together. A row's sum up to some column is that of its block and
/// of less than so many pixels.
constexpr std::size_t block_columns = 8;

/// What std::floor gives for a position that is not below 0, without a call.
double whole(double position) {
  return static_cast<double>(static_cast<std::int64_t>(position));
}

/// A stretch of an edge that lies in one row of pixels.
struct Stretch {
  std::size_t row;
  Point from;
  Point to;
  double from_ordinate;
  double to_ordinate;
};

/// A piece of a stretch in one pixel.
struct Piece {
  double rise;    ///< of the ordinate from its western to its eastern end
  double beside;  ///< what lies between it and the pixel's left edge, without the pixel's scale
};

/// The scales of a row's pixels, one after the other.
template <typename Areas>
class ScalesInRow {
 public:
  ScalesInRow(const Areas& areas, std::size_t row) : areas_(areas), row_(row) {}
  double at(std::size_t column) {
    if constexpr (!std::is_same_v<Areas, PixelsOfPlane>) {
      return 1;
    } else {
      if (column >= scales_.end) scales_ = areas_.scales(row_, column);
      return scales_.at(column);
    }
  }

 private:
  const Areas& areas_;
  std::size_t row_;
  PixelAreas::Scales scales_{0, 0};
};

}  // namespace

PixelIntegrals::PixelIntegrals(WindowValues values, std::vector<double> references,
                               std::unique_ptr<const PixelAreas> areas)
    : values_(std::move(values)),
      references_(std::move(references)),
      areas_(std::move(areas)),
      known_areas_(known(*areas_)),
      blocks_(values_.columns() / block_columns + 1),
      is_complete_(values_.is_complete()),
      vary_(areas_->vary_along_rows()),
      sums_(bands() * (is_complete_ ? 1u : 2u) + (vary_ ? 1u : 0u)) {
  sum_up();
}

PixelIntegrals::AnyAreas PixelIntegrals::known(const PixelAreas& areas) {
  if (const auto* equal = dynamic_cast<const EqualPixels*>(&areas)) return equal;
  if (const auto* in_degrees = dynamic_cast<const PixelsInDegrees*>(&areas)) return in_degrees;
  return &dynamic_cast<const PixelsOfPlane&>(areas);
}

void PixelIntegrals::sum_up() {
  before_.reserve(values_.rows() * blocks_ * sums_);
  std::vector<double> sums;
  values_.visit([&](const auto* values) {
    for (std::size_t row = 0; row < values_.rows(); ++row) {
      sums.assign(2 * bands() + 1, 0);
      sum_up_row(row, values + values_.place_of(row, 0), sums);
    }
  });
}

/// `sums` has a place for what before_ has of each block, and for the areas of complete bands.
template <typename Value>
void PixelIntegrals::sum_up_row(std::size_t row, const Value* values, std::vector<double>& sums) {
  double* const excess = sums.data();
  double* const covered = excess + bands();
  double& whole = sums.back();
  PixelAreas::Scales scales{0, 0};
  for (std::size_t block = 0; block < blocks_; ++block) {
    before_.insert(before_.end(), excess, is_complete_ ? covered : covered + bands());
    if (vary_) before_.push_back(whole);
    const std::size_t end = std::min(values_.columns(), (block + 1) * block_columns);
    for (std::size_t column = block * block_columns; column < end; ++column) {
      if (column == scales.end) scales = areas_->scales(row, column);
      const double scale = scales.at(column);
      whole += scale;
      for (std::size_t band = 0; band < bands(); ++band) {
        const auto value = static_cast<double>(values[band]);
        const bool has_value = !std::isnan(value);
        excess[band] += has_value ? scale * (value - references_[band]) : 0;
        covered[band] += has_value ? scale : 0;
      }
      values += bands();
    }
  }
}

/// The sums over a row from its first column up to one column, which moves along, and what pieces
/// of an edge add to the figures of the one band that there is.
template <typename Areas, typename Value>
class PixelIntegrals::OneBand {
 public:
  OneBand(const PixelIntegrals& all, const Areas& areas, const Value* values, std::size_t row,
          std::size_t column)
      : values_(values + all.values_.place_of(row, 0)),
        columns_(all.values_.columns()),
        column_(column / block_columns * block_columns),
        reference_(all.references_.front()),
        is_complete_(all.is_complete_),
        scales_(areas, row) {
    const double* const before = all.before(row, column / block_columns);
    excess_ = before[0];
    whole_ = all.vary_ ? before[all.sums_ - 1] : static_cast<double>(column_);
    covered_ = is_complete_ ? whole_ : before[1];
    while (column_ < column) {
      look();
      take();
    }
    if (column_ < columns_) look();
  }

  void add(const Piece& piece) {
    const double part = scale_ * piece.beside;
    sum_of_whole_ += whole_ * piece.rise + part;
    sum_of_excess_ += excess_ * piece.rise + (has_value_ ? value_ * part : 0);
    sum_of_covered_ += covered_ * piece.rise + (has_value_ ? part : 0);
    take();
    if (column_ < columns_) look();
  }
  /// Adds the sums of the pieces to the figures.
  void finish(double sign, std::span<double> figures) const {
    figures[0] += sign * sum_of_whole_;
    figures[excess_of(0)] += sign * sum_of_excess_;
    figures[covered_of(0)] += sign * sum_of_covered_;
  }

 private:
  void look() {
    const auto value = static_cast<double>(values_[column_]);
    has_value_ = is_complete_ || !std::isnan(value);
    value_ = value - reference_;
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

  const Value* values_;  // of the row
  std::size_t columns_;
  std::size_t column_;
  double reference_;
  bool is_complete_;
  ScalesInRow<Areas> scales_;
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

/// The same for some of several bands, from one on, whose sums are one loop at every pixel.
template <typename Areas, typename Value>
class PixelIntegrals::ManyBands {
 public:
  static constexpr std::size_t most = 12;

  ManyBands(const PixelIntegrals& all, const Areas& areas, const Value* values, std::size_t row,
            std::size_t column, std::size_t first)
      : values_(values + all.values_.place_of(row, 0) + first),
        bands_(all.bands()),
        first_(first),
        count_(std::min(most, bands_ - first)),
        columns_(all.values_.columns()),
        column_(column / block_columns * block_columns),
        is_complete_(all.is_complete_),
        scales_(areas, row) {
    const double* const before = all.before(row, column / block_columns);
    whole_ = all.vary_ ? before[all.sums_ - 1] : static_cast<double>(column_);
    for (std::size_t b = 0; b < count_; ++b) {
      references_[b] = all.references_[first + b];
      excess_[b] = before[first + b];
    }
    if (!is_complete_) std::copy_n(before + bands_ + first, count_, covered_.begin());
    while (column_ < column) take(scales_.at(column_));
  }

  void add(const Piece& piece) {
    const bool is_within = column_ < columns_;
    const double scale = is_within ? scales_.at(column_) : 0;
    const double part = scale * piece.beside;
    sum_of_whole_ += whole_ * piece.rise + part;
    if (!is_within) {
      for (std::size_t b = 0; b < count_; ++b) sum_of_excess_[b] += excess_[b] * piece.rise;
      for (std::size_t b = 0; b < count_; ++b) sum_of_covered_[b] += covered_[b] * piece.rise;
      return;
    }
    const Value* const here = values_ + column_ * bands_;
    if (is_complete_) {
      for (std::size_t b = 0; b < count_; ++b) {
        const double value = static_cast<double>(here[b]) - references_[b];
        sum_of_excess_[b] += excess_[b] * piece.rise + value * part;
      }
    } else {
      for (std::size_t b = 0; b < count_; ++b) {
        const auto value = static_cast<double>(here[b]);
        const bool has_value = !std::isnan(value);
        sum_of_excess_[b] +=
            excess_[b] * piece.rise + (has_value ? (value - references_[b]) * part : 0);
        sum_of_covered_[b] += covered_[b] * piece.rise + (has_value ? part : 0);
      }
    }
    take(scale);
  }
  void finish(double sign, std::span<double> figures) const {
    if (first_ == 0) figures[0] += sign * sum_of_whole_;
    for (std::size_t b = 0; b < count_; ++b) {
      figures[excess_of(first_ + b)] += sign * sum_of_excess_[b];
      figures[covered_of(first_ + b)] += sign * (is_complete_ ? sum_of_whole_ : sum_of_covered_[b]);
    }
  }

 private:
  using Sums = std::array<double, most>;

  void take(double scale) {
    const Value* const here = values_ + column_ * bands_;
    whole_ += scale;
    ++column_;
    if (is_complete_) {
      for (std::size_t b = 0; b < count_; ++b)
        excess_[b] += scale * (static_cast<double>(here[b]) - references_[b]);
      return;
    }
    for (std::size_t b = 0; b < count_; ++b) {
      const auto value = static_cast<double>(here[b]);
      const bool has_value = !std::isnan(value);
      excess_[b] += has_value ? scale * (value - references_[b]) : 0;
      covered_[b] += has_value ? scale : 0;
    }
  }

  const Value* values_;  // of the row, from the first band on
  std::size_t bands_;
  std::size_t first_;
  std::size_t count_;
  std::size_t columns_;
  std::size_t column_;
  bool is_complete_;
  ScalesInRow<Areas> scales_;
  double whole_ = 0;
  double sum_of_whole_ = 0;
  Sums references_;
  Sums excess_;
  Sums covered_{};
  Sums sum_of_excess_{};
  Sums sum_of_covered_{};
};

/// Follows an edge from row to row and from pixel to pixel.
template <typename Areas, typename Value>
class PixelIntegrals::EdgeWalk {
 public:
  EdgeWalk(const PixelIntegrals& all, const Areas& areas, const Value* values,
           std::span<double> figures)
      : all_(all), areas_(areas), values_(values), figures_(figures) {}

  /// Requires ends in two rows, or at two heights in one.
  void add(Point from, Point to) const {
    const double sign = from.y > to.y ? 1 : -1;
    const Point upper = sign > 0 ? to : from;
    const Point lower = sign > 0 ? from : to;
    const double begin = std::max(upper.y, 0.0);
    const double end = std::min(lower.y, static_cast<double>(all_.values_.rows()));
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
    Stretch stretch{row, {}, at(begin), 0, areas_.ordinate(begin)};
    for (; static_cast<double>(row) < end; ++row) {
      stretch.row = row;
      stretch.from = stretch.to;
      stretch.from_ordinate = stretch.to_ordinate;
      stretch.to = at(std::min(end, static_cast<double>(row + 1)));
      stretch.to_ordinate = areas_.ordinate(stretch.to.y);
      if (stretch.from.y < stretch.to.y) add_stretch(stretch, sign);
    }
  }

 private:
  void add_stretch(const Stretch& stretch, double sign) const {
    const bool eastwards = stretch.from.x <= stretch.to.x;
    const double west = std::min(stretch.from.x, stretch.to.x);
    if (std::max(stretch.from.x, stretch.to.x) <= 0) return;
    const auto columns = static_cast<double>(all_.values_.columns());
    const auto first = static_cast<std::size_t>(std::clamp(west, 0.0, columns));
    // The ordinate falls where the stretch goes west.
    const double turn = eastwards ? sign : -sign;
    if (all_.bands() == 1) {
      OneBand<Areas, Value> running(all_, areas_, values_, stretch.row, first);
      for_each_piece(stretch, [&](const Piece& piece) { running.add(piece); });
      return running.finish(turn, figures_);
    }
    for (std::size_t band = 0; band < all_.bands(); band += ManyBands<Areas, Value>::most) {
      ManyBands<Areas, Value> running(all_, areas_, values_, stretch.row, first, band);
      for_each_piece(stretch, [&](const Piece& piece) { running.add(piece); });
      running.finish(turn, figures_);
    }
  }

  // Goes through the pieces of the stretch in rising columns. The area beside a piece within its
  // pixel is the integral of the way from the pixel's left edge over the ordinate, by Simpson's
  // rule.
  template <typename Take>
  void for_each_piece(const Stretch& stretch, const Take& take) const {
    const bool eastwards = stretch.from.x <= stretch.to.x;
    const Point west = eastwards ? stretch.from : stretch.to;
    const Point east = eastwards ? stretch.to : stretch.from;
    const auto columns = static_cast<double>(all_.values_.columns());
    const std::optional<PixelAreas::InRow> in_row = areas_.in_row(stretch.row);
    const auto top = static_cast<double>(stretch.row);
    const auto ordinate = [&](double row) {
      return in_row ? in_row->at(row - top) : areas_.ordinate(row);
    };
    struct Break {
      double column;
      double row;
      double ordinate;
    };
    // Most stretches lie in one pixel, and need no slope.
    const auto at = [&](double column) -> Break {
      const double slope = (east.y - west.y) / (east.x - west.x);
      const double row =
          std::clamp(west.y + (column - west.x) * slope, stretch.from.y, stretch.to.y);
      return {column, row, ordinate(row)};
    };
    const Break last{east.x, east.y, eastwards ? stretch.to_ordinate : stretch.from_ordinate};
    Break from{west.x, west.y, eastwards ? stretch.from_ordinate : stretch.to_ordinate};
    if (west.x < 0) from = at(0);
    const bool is_straight = in_row && in_row->bend == 0;
    for (double left = whole(std::min(from.column, columns)); left < columns; ++left) {
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

  const PixelIntegrals& all_;
  const Areas& areas_;
  const Value* values_;
  std::span<double> figures_;
};

void PixelIntegrals::add_edge(Point from, Point to, std::span<double> figures) const {
  if (from.y == to.y) return;
  values_.visit([&](const auto* values) {
    std::visit([&](const auto* areas) { EdgeWalk(*this, *areas, values, figures).add(from, to); },
               known_areas_);
  });
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
  const double row = whole(std::clamp(at.y, 0.0, static_cast<double>(values_.rows() - 1)));
  const double column = whole(std::clamp(at.x, 0.0, static_cast<double>(values_.columns() - 1)));
  const auto r = static_cast<std::size_t>(row);
  const auto c = static_cast<std::size_t>(column);
  return std::visit(
      [&](const auto* areas) {
        const std::optional<PixelAreas::InRow> in_row = areas->in_row(r);
        return (in_row ? in_row->whole : areas->ordinate(row + 1) - areas->ordinate(row)) *
               areas->scales(r, c).at(c);
      },
      known_areas_);
}

double PixelIntegrals::value_at(Point at, std::size_t band) const {
  const bool is_within = at.x >= 0 && at.y >= 0 && at.x < static_cast<double>(values_.columns()) &&
                         at.y < static_cast<double>(values_.rows());
  if (!is_within) return std::numeric_limits<double>::quiet_NaN();
  return values_.at(band, static_cast<std::size_t>(at.y), static_cast<std::size_t>(at.x));
}

}  // namespace thiessen
