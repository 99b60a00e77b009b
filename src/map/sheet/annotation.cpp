#include "map/sheet/annotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "base/interrupt.h"
#include "map/ink/ink.h"
#include "map/ink/line_places.h"
#include "map/ink/signs.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_label = 24;

/// The rows in which a basin has pixels, from `top` to `bottom`.
struct Rows {
  int top = 0;
  int bottom = -1;
};

std::vector<Rows> rows_of_basins(const LabelImage& basins, std::size_t count) {
  std::vector<Rows> rows(count, Rows{basins.height(), -1});
  for (int y = 0; y < basins.height(); ++y) {
    for (int x = 0; x < basins.width(); ++x) {
      const std::int32_t owner = basins.at(x, y);
      if (owner < 0) continue;
      Rows& r = rows[static_cast<std::size_t>(owner)];
      r.top = std::min(r.top, y);
      r.bottom = y;
    }
  }
  return rows;
}

/// A run of a basin's pixels in one row.
struct Run {
  int begin = 0;
  int end = 0;
};

Run longest_run(const LabelImage& basins, std::int32_t basin, int row) {
  Run longest;
  Run run;
  for (int x = 0; x < basins.width(); ++x) {
    if (basins.at(x, row) != basin) {
      run = {x + 1, x + 1};
      continue;
    }
    run.end = x + 1;
    if (run.end - run.begin > longest.end - longest.begin) longest = run;
  }
  return longest;
}

/// The size of labels in ems: they are smaller where there are many gauges.
double label_size(std::size_t gauges) {
  if (gauges <= 40) return 0.85;
  return gauges <= 150 ? 0.72 : 0.6;
}

/// A lower bound of the label's width in pixels, as the narrowest letters take a quarter of an em.
int least_width(const std::string& label, int size) {
  const auto is_graphic = [](char c) { return c > ' ' && c < 127; };
  const bool ascii = std::all_of(label.begin(), label.end(), is_graphic);
  const auto letters = static_cast<int>(std::min(label.size(), longest_label));
  return std::max(1, size * (ascii ? letters : 1) / 4);
}

std::vector<const std::vector<Point>*> longest_first(const std::vector<std::vector<Point>>& lines) {
  const auto length = [](const std::vector<Point>& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
      sum += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    return sum;
  };
  std::vector<std::pair<double, const std::vector<Point>*>> found;
  found.reserve(lines.size());
  for (const std::vector<Point>& line : lines) found.emplace_back(length(line), &line);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const std::vector<Point>*> sorted;
  sorted.reserve(found.size());
  for (const auto& [sum, line] : found) sorted.push_back(line);
  return sorted;
}

bool holds(const LabelImage& basins, std::int32_t basin, const PixelBox& box) {
  if (box.x < 0 || box.y < 0 || box.right() > basins.width() || box.bottom() > basins.height()) {
    return false;
  }
  for (int y = box.y; y < box.bottom(); ++y) {
    for (int x = box.x; x < box.right(); ++x) {
      if (basins.at(x, y) != basin) return false;
    }
  }
  return true;
}

}  // namespace

Annotation::Annotation(Canvas& canvas, const Page& page, const Picture& picture,
                       const StudyView& view, Typesetter& type)
    : canvas_(canvas),
      page_(page),
      picture_(picture),
      view_(view),
      type_(type),
      taken_(page.panel.width, page.panel.height) {
  count_.gauges = view.gauges.size();
  count_.in_sight = dots_in_sight().size();
  const double pixels = static_cast<double>(page.panel.width) * page.panel.height;
  radius_ = gauge_radius(page.style.em, count_.in_sight, pixels);
  count_.in_sight = dots_in_sight().size();
}

bool Annotation::in_sight(Point p) const {
  const double rim = gauge_reach(radius_);  // a dot is shown whole or not at all
  return p.x >= rim && p.y >= rim && p.x <= page_.panel.width - rim &&
         p.y <= page_.panel.height - rim;
}

std::vector<Point> Annotation::dots_in_sight() const {
  std::vector<Point> dots;
  std::copy_if(view_.gauges.begin(), view_.gauges.end(), std::back_inserter(dots),
               [&](Point p) { return in_sight(p); });
  return dots;
}

void Annotation::draw_gauges() {
  const Group group(canvas_, {"gauges"});
  const int reach = static_cast<int>(std::ceil(gauge_reach(radius_)));
  for (const bool reporting : {false, true}) {
    for (std::size_t i = 0; i < view_.gauges.size(); ++i) {
      throw_if_interrupted();
      const Point p = view_.gauges[i];
      if (picture_.gauges[i].reports != reporting || !in_sight(p)) continue;
      const Point on_page{p.x + page_.panel.x, p.y + page_.panel.y};
      const Mark mark{reporting ? "gauge" : "gauge silent", picture_.gauges[i].station};
      draw_gauge(canvas_, on_page, radius_, reporting, page_.panel, mark);
      const int x = static_cast<int>(std::floor(p.x));
      const int y = static_cast<int>(std::floor(p.y));
      taken_.occupy({x - reach, y - reach, 2 * reach + 1, 2 * reach + 1});
    }
  }
}

void Annotation::put(const SetText& text, const PixelBox& box, Colour colour, const Mark& mark) {
  const int rim = (box.width - text.width()) / 2;
  canvas_.text(text, page_.panel.x + box.x + rim, page_.panel.y + box.y + rim, {colour, rim, mark});
  taken_.occupy(box);
}

int Annotation::halo_width() const {
  constexpr int least = 2;  // pixels: one leaves the ground of a letter's inside as it is
  return std::max(least, page_.style.ems(0.13));
}

void Annotation::draw_levels() {
  const int size = std::max({9, page_.style.least_type, page_.style.ems(0.72)});
  for (std::size_t i = 0; i < view_.isohyets.size(); ++i) draw_level(i, size);
}

void Annotation::draw_level(std::size_t isohyet, int size) {
  const SetText text = type_.set(picture_.isohyets[isohyet].level, size, Weight::bold);
  const int rim = halo_width();
  const int width = text.width() + 2 * rim;
  const int height = text.height() + 2 * rim;
  const double apart = page_.style.ems(20);
  const int clear = size / 2;  // between two levels, so that their figures are not read as one
  std::vector<Point> written;
  const auto is_near = [&](Point p) {
    return std::any_of(written.begin(), written.end(), [&](Point other) {
      return std::hypot(p.x - other.x, p.y - other.y) < apart;
    });
  };
  for (const std::vector<Point>* line : longest_first(view_.isohyets[isohyet])) {
    for (const Point p : text_places(*line, width)) {
      const PixelBox box{static_cast<int>(std::lround(p.x)) - width / 2,
                         static_cast<int>(std::lround(p.y)) - height / 2, width, height};
      const PixelBox around{box.x - clear, box.y - clear, width + 2 * clear, height + 2 * clear};
      if (is_near(p) || !taken_.is_free(around)) continue;
      put(text, box, ink::isohyet,
          {.kind = "isohyet-label", .level = picture_.isohyets[isohyet].level});
      written.push_back(p);
    }
  }
  if (!view_.isohyets[isohyet].empty()) ++count_.isohyets;
  if (!written.empty()) ++count_.levelled;
}

void Annotation::draw_basin_names(const LabelImage& basins) {
  constexpr std::array<int, 7> shares{
      50, 40, 60, 30, 70, 20, 80};  // places to try, in percent of the height, the middle first
  const std::vector<Rows> rows = rows_of_basins(basins, picture_.basins.size());
  const int rim = halo_width();
  const int size = std::max(page_.style.least_type, page_.style.ems(0.85));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (picture_.basins[i].name.empty()) continue;
    ++count_.to_name;
    const int height = rows[i].bottom - rows[i].top + 1;
    if (height < page_.style.em) continue;
    const auto basin = static_cast<std::int32_t>(i);
    const SetText text = type_.set(picture_.basins[i].name, size, Weight::bold, 40);
    if (text.width() == 0) continue;
    for (const int share : shares) {
      const int row = rows[i].top + height * share / 100;
      const Run run = longest_run(basins, basin, row);
      const int middle = (run.begin + run.end) / 2;
      const PixelBox box{middle - text.width() / 2 - rim, row - text.height() / 2 - rim,
                         text.width() + 2 * rim, text.height() + 2 * rim};
      if (!taken_.is_free(box) || !holds(basins, basin, box)) continue;
      put(text, box, ink::basin_edge, {"basin-name", {}, picture_.basins[i].name});
      ++count_.named;
      break;
    }
  }
}

void Annotation::draw_labels(const std::vector<std::size_t>& pixels) {
  std::vector<std::size_t> order(picture_.gauges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return pixels[a] > pixels[b]; });
  const int size =
      std::max({9, page_.style.least_type, page_.style.ems(label_size(count_.in_sight))});
  const int rim = halo_width();
  const double outer = gauge_reach(radius_);
  // Half a letter between a label and another gauge's dot, so that it is not read as that gauge's.
  const DotIndex dots(page_.panel.width, page_.panel.height, dots_in_sight(), outer + 0.5 * size);
  for (const std::size_t i : order) {
    const Point dot = view_.gauges[i];
    if (picture_.gauges[i].label.empty() || !in_sight(dot)) continue;
    ++count_.to_label;
    // A label need not be set to know that it does not fit where even its least width is not free.
    const int least = least_width(picture_.gauges[i].label, size);
    if (!place_beside(taken_, dots, dot, outer, 1, least, size / 2)) continue;
    const SetText text = type_.set(picture_.gauges[i].label, size, Weight::regular, longest_label);
    if (text.width() == 0) continue;
    const auto box = place_beside(taken_, dots, dot, outer, 1, text.width() + 2 * rim,
                                  text.height() + 2 * rim, rim);
    if (!box) continue;
    put(text, *box, ink::text, {"label", picture_.gauges[i].station});
    ++count_.labelled;
  }
}

LabelCount& LabelCount::operator+=(const LabelCount& other) {
  gauges += other.gauges;
  in_sight += other.in_sight;
  to_label += other.to_label;
  labelled += other.labelled;
  to_name += other.to_name;
  named += other.named;
  isohyets += other.isohyets;
  levelled += other.levelled;
  cells += other.cells;
  outlined += other.outlined;
  return *this;
}

std::string note_of(const LabelCount& count) {
  const auto share = [](std::size_t some, std::size_t all) {
    return std::to_string(some) + " of " + std::to_string(all);
  };
  std::string text;
  if (count.in_sight < count.gauges)
    text = "gauges in sight: " + share(count.in_sight, count.gauges);
  if (count.labelled < count.to_label) {
    if (!text.empty()) text += ", ";
    text += "labelled: " + share(count.labelled, count.to_label);
  }
  return text;
}

}  // namespace thiessen
