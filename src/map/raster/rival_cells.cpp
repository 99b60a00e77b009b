#include "map/raster/rival_cells.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/box.h"

namespace thiessen {
namespace {

/// By how much a linear number changes from the middle of a box to its sides, at most.
double change_within(const RivalCells::Linear& linear, double half_width, double half_height) {
  return half_width * std::abs(linear.east) + half_height * std::abs(linear.south);
}

Box box_round(std::span<const Point> polygon) {
  Box box;
  for (const Point p : polygon) box.take_in(p);
  return box;
}

}  // namespace

double RivalCells::Cell::doubled_area() const {
  double area = 0;
  for (std::size_t i = 0; i < count; ++i)
    area += corners[i].x * next(i).y - corners[i].y * next(i).x;
  return area;
}

bool RivalCells::lay(const PixelPlane& plane, const PixelBlock& block, const NearestPlaces& places,
                     std::span<const PlaceIndex> rivals) {
  // The squares' rounding is less than 40 times 2^-53 of the square of the longest way.
  constexpr double relative_rounding = 0x1p-47;
  forms_.clear();
  const Direction first = places.place(rivals.front()) - plane.first;
  double nearest = HUGE_VAL;
  double farthest = 0;
  double farthest_apart = 0;
  for (const PlaceIndex rival : rivals) {
    const Direction way = places.place(rival) - plane.first;
    const Direction apart = way - first;
    const Linear square{dot(apart, way + first), -2 * dot(apart, plane.east),
                        -2 * dot(apart, plane.south)};
    forms_.push_back({square, way, static_cast<std::uint8_t>(forms_.size())});
    nearest = std::min(nearest, dot(way, way));
    farthest = std::max(farthest, dot(way, way));
    farthest_apart = std::max(farthest_apart, dot(apart, apart));
  }
  const double across =
      (block.columns - 1) * length(plane.east) + (block.rows - 1) * length(plane.south) + plane.off;
  const double longest = std::sqrt(farthest) + across;
  certain_ = places.certain_difference((1 + relative_rounding) * (std::sqrt(nearest) + across),
                                       plane.off + relative_rounding * longest);
  rounding_ = relative_rounding * longest * longest;
  largest_certain_ = certain_.at(4 * farthest_apart) + rounding_;
  leave_out_beaten(block);
  cells_.clear();
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    if (!lay_cell(i, block)) return false;
    cells_.push_back(*cell_);
    cells_.back().rival = forms_[i].rival;
  }
  return true;
}

// A rival that another beats by what is certain at the block's corners is beaten throughout. As no
// two beat each other, the nearest to a centre always stays.
void RivalCells::leave_out_beaten(const PixelBlock& block) {
  const Point middle{(block.columns - 1) / 2.0, (block.rows - 1) / 2.0};
  const auto beats = [&](const Form& form, const Form& other) {
    const Linear lead = difference(other, form);
    return lead.value(middle) > change_within(lead, middle.x, middle.y) + largest_certain_;
  };
  // Most are beaten by the nearest to the block's middle.
  const auto at_middle = [&](const Form& a, const Form& b) {
    return a.square.value(middle) < b.square.value(middle);
  };
  const auto winner = std::min_element(forms_.begin(), forms_.end(), at_middle);
  std::array<bool, most> is_beaten{};
  for (std::size_t i = 0; i < forms_.size(); ++i) is_beaten[i] = beats(*winner, forms_[i]);
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    for (std::size_t j = 0; j < forms_.size() && !is_beaten[i]; ++j)
      is_beaten[i] = !is_beaten[j] && beats(forms_[j], forms_[i]);
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    if (!is_beaten[i]) forms_[kept++] = forms_[i];
  }
  forms_.resize(kept);
}

bool RivalCells::lay_cell(std::size_t rival, const PixelBlock& block) {
  constexpr double margin = 1;
  const double east_side = block.columns - 1 + margin;
  const double south_side = block.rows - 1 + margin;
  cell_->corners = {
      {{-margin, -margin}, {east_side, -margin}, {east_side, south_side}, {-margin, south_side}}};
  cell_->beyond.fill(nobody);
  cell_->count = 4;
  Box box = box_round(cell_->polygon());
  for (std::size_t i = 0; i < forms_.size() && cell_->count > 0; ++i) {
    if (i == rival) continue;
    const Linear lead = difference(forms_[i], forms_[rival]);
    const double within = change_within(lead, untold_within, untold_within);
    if (!(largest_certain_ <= within) && !(certain_between(forms_[i], forms_[rival]) <= within))
      return false;
    const double least =
        lead.value(box.centre()) - change_within(lead, box.width() / 2, box.height() / 2);
    if (least >= 0) continue;
    if (!cut(static_cast<std::uint8_t>(i), lead)) return false;
    box = box_round(cell_->polygon());
  }
  return true;
}

// Cuts off where the lead over another is negative. False where there are too many corners.
bool RivalCells::cut(std::uint8_t other, const Linear& lead) {
  std::array<double, most_corners> leads;
  bool all = true;
  for (std::size_t i = 0; i < cell_->count; ++i) {
    leads[i] = lead.value(cell_->corners[i]);
    all = all && leads[i] >= 0;
  }
  if (all) return true;
  kept_->count = 0;
  const auto keep = [&](Point p, std::uint8_t beyond) {
    kept_->corners[kept_->count] = p;
    kept_->beyond[kept_->count++] = beyond;
  };
  for (std::size_t i = 0; i < cell_->count; ++i) {
    if (kept_->count + 2 > most_corners) return false;
    const std::size_t j = i + 1 < cell_->count ? i + 1 : 0;
    const bool here = leads[i] >= 0;
    const bool there = leads[j] >= 0;
    if (here) keep(cell_->corners[i], cell_->beyond[i]);
    if (here == there) continue;
    const double share = leads[i] / (leads[i] - leads[j]);
    const Point a = cell_->corners[i];
    const Point b = cell_->corners[j];
    keep({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)}, here ? other : cell_->beyond[i]);
  }
  std::swap(cell_, kept_);
  return true;
}

RivalCells::Edge::Edge(const RivalCells& cells, std::size_t cell, std::size_t beyond, Point from,
                       Point to, double reach) {
  const Form& own = cells.forms_[cell];
  const Form& across = cells.forms_[beyond];
  std::array<const Form*, most> added;
  // Any two of them may be the nearest and the second.
  const auto add = [&](const Form& form) {
    for (std::size_t i = 0; i < count_; ++i)
      certain_ = std::max(certain_, cells.certain_between(*added[i], form));
    forms_[count_] = difference(form, own);
    rivals_[count_] = form.rival;
    added[count_++] = &form;
  };
  add(own);
  add(across);
  for (std::size_t i = 0; i < cells.forms_.size(); ++i) {
    if (i == cell || i == beyond) continue;
    const Form& other = cells.forms_[i];
    const Linear lead = difference(other, own);
    const double least =
        std::min(lead.value(from), lead.value(to)) - change_within(lead, reach, reach);
    if (least <= cells.largest_certain_) add(other);
  }
}

}  // namespace thiessen
