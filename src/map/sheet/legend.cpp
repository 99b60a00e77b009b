#include "map/sheet/legend.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "map/ink/ink.h"
#include "map/ink/signs.h"
#include "map/sheet/page.h"
#include "map/sheet/picture.h"

namespace thiessen {
namespace {

const char* meaning(Legend::Sign sign) {
  switch (sign) {
    case Legend::Sign::dry:
      return "dry";
    case Legend::Sign::isohyet:
      return "isohyet";
    case Legend::Sign::point:
      return "point";
    case Legend::Sign::study_area:
      return "study area";
    case Legend::Sign::gauge:
      return "rain gauge";
    case Legend::Sign::silent_gauge:
      return "silent gauge";
    case Legend::Sign::no_reading:
      return "no reading";
    case Legend::Sign::cell:
      return "cell";
    case Legend::Sign::basin:
      return "basin";
  }
  return "";
}

/// The height of a sign's line where there is little room.
int narrow_line(int em) {
  return em * 23 / 20;
}

/// The line by which a sign is shown.
Stroke stroke_of(Legend::Sign sign, int em) {
  if (sign == Legend::Sign::isohyet) return {ink::isohyet, isohyet_line_width(em)};
  if (sign == Legend::Sign::cell) return {ink::cell_edge, cell_line_width(em)};
  return {ink::basin_edge, basin_line_width(em)};
}

bool is_of_gauges(Legend::Sign sign) {
  using Sign = Legend::Sign;
  return sign == Sign::gauge || sign == Sign::silent_gauge || sign == Sign::point;
}

/// Whether the map shows what the sign is of.
bool is_drawn(Legend::Sign sign, const MapDetail& detail) {
  if (is_of_gauges(sign)) return detail.has_gauges;
  if (sign == Legend::Sign::cell) return detail.has_cell_outlines;
  if (sign == Legend::Sign::basin || sign == Legend::Sign::study_area)
    return detail.has_basin_outlines && detail.has_basin_edges;
  return true;
}

/// The signs of one map, beside that of dry ground.
std::vector<Legend::Sign> signs_of(const Picture& picture) {
  using Sign = Legend::Sign;
  const auto has_reading = [](const PictureCell& c) { return std::isfinite(c.rainfall); };
  const bool all_read = !picture.cells.empty() &&
                        std::all_of(picture.cells.begin(), picture.cells.end(), has_reading);
  const auto reports = [](const PictureGauge& g) { return g.reports; };
  const auto& gauges = picture.gauges;
  std::vector<Sign> signs;
  if (picture.by_rainfall && !all_read) signs.push_back(Sign::no_reading);
  if (std::any_of(gauges.begin(), gauges.end(), reports))
    signs.push_back(picture.by_rainfall ? Sign::gauge : Sign::point);
  if (!std::all_of(gauges.begin(), gauges.end(), reports)) signs.push_back(Sign::silent_gauge);
  if (!picture.isohyets.empty()) signs.push_back(Sign::isohyet);
  // The edges of one cell alone are those of its basin, which cover them.
  if (picture.cells.size() > picture.basins.size() && picture.bands.empty())
    signs.push_back(Sign::cell);
  if (!picture.basins.empty()) signs.push_back(picture.has_basins ? Sign::basin : Sign::study_area);
  return signs;
}

/// Whether the map shows ground of 0, which is of the dry class where there is one.
bool shows_zero(const Picture& picture) {
  if (!picture.bands.empty()) {
    return std::any_of(picture.bands.begin(), picture.bands.end(),
                       [](const PictureBand& band) { return band.rainfall == 0; });
  }
  return std::any_of(picture.cells.begin(), picture.cells.end(),
                     [](const PictureCell& cell) { return cell.rainfall == 0; });
}

/// The signs of all maps, each once, in the order of the enumeration.
std::set<Legend::Sign> signs_of(std::span<const Picture> maps, const RainfallClasses& classes) {
  std::set<Legend::Sign> signs;
  if (classes.has_dry() && std::any_of(maps.begin(), maps.end(), shows_zero))
    signs.insert(Legend::Sign::dry);
  for (const Picture& map : maps) {
    const std::vector<Legend::Sign> more = signs_of(map);
    signs.insert(more.begin(), more.end());
  }
  return signs;
}

}  // namespace

Hatch hatching(int em) {
  return {ink::hatch, static_cast<double>(std::max(5, em / 2)),
          static_cast<double>(std::max(1, em / 16))};
}

Legend::Legend(std::span<const Picture> maps, const MapDetail& detail,
               const RainfallClasses& classes, const PageStyle& style, Typesetter& type)
    : em_(style.em), units_(maps.front().units) {
  if (style.bare) return;
  const Picture& picture = maps.front();
  const int size = style.ems(0.85);
  const int most = std::max(style.ems(7), picture.width / 5);
  const int sign = style.ems(2);
  if (picture.by_rainfall) set_heading(picture, style, most, type);
  const int small = std::max(style.least_type, style.ems(0.5));
  small_step_ = small + (small + 15) / 16;
  for (const std::string& tick : classes.ticks()) {
    ticks_.push_back(type.fit(tick, size, size, most - sign));
    small_ticks_.push_back(type.fit(tick, small, small, most - sign));
    width_ = std::max(width_, sign + ticks_.back().width());
  }
  for (const Sign kind : signs_of(maps, classes)) {
    if (!is_drawn(kind, detail)) continue;
    entries_.push_back({kind, type.set(meaning(kind), size)});
    width_ = std::max(width_, sign + entries_.back().text.width());
  }
}

Legend::Legend(const Picture& picture, const RainfallClasses& classes, const PageStyle& style,
               Typesetter& type)
    : Legend(std::span<const Picture>(&picture, 1), MapDetail(), classes, style, type) {}

void Legend::set_heading(const Picture& picture, const PageStyle& style, int most,
                         Typesetter& type) {
  const std::string unit = picture.units.empty() ? "" : "(" + picture.units + ")";
  const auto fit = [&](const std::string& text) {
    return type.fit(text, style.ems(0.85), style.ems(0.65), most, Weight::bold);
  };
  heading_ = {fit(unit.empty() ? "Rainfall" : "Rainfall " + unit)};
  if (heading_.front().is_shortened && !unit.empty()) heading_ = {fit("Rainfall"), fit(unit)};
  for (const SetText& line : heading_) width_ = std::max(width_, line.width());
}

int Legend::heading_height() const {
  return heading_.empty() ? 0 : em_ * 3 / 2 + static_cast<int>(heading_.size() - 1) * em_ * 5 / 4;
}

int Legend::least_step() const {
  return (em_ * 9 + 9) / 10;
}

int Legend::round_bar() const {
  return ticks_.empty() ? 0 : em_ * 3 / 2;
}

int Legend::height() const {
  const int heading = heading_.empty() ? 0 : heading_height() + em_ / 4;
  return heading + static_cast<int>(class_count()) * em_ * 5 / 4 + round_bar() +
         static_cast<int>(entries_.size()) * em_ * 3 / 2;
}

int Legend::least_height() const {
  return heading_height() + static_cast<int>(class_count()) * least_step() + round_bar() +
         static_cast<int>(entries_.size()) * narrow_line(em_);
}

Legend::Layout Legend::layout(const PixelBox& column) const {
  const int n = static_cast<int>(class_count());
  Layout result;
  result.top = column.y + (column.height < em_ * 3 / 2 ? 0 : heading_height());
  const int room = column.bottom() - result.top - round_bar();
  const int beside_bar = room - n * least_step();
  const int wide_line = em_ * 3 / 2;
  result.line = wide_line;
  if (!entries_.empty()) {
    result.line =
        std::clamp(beside_bar / static_cast<int>(entries_.size()), narrow_line(em_), wide_line);
  }
  // The last line needs none of the distance to a next one.
  const int lines = (beside_bar + result.line / 4) / result.line;
  result.signs = std::min(entries_.size(), static_cast<std::size_t>(std::max(lines, 0)));
  if (n > 0) {
    // Signs find room beside a bar with all of its texts only.
    const int least = result.signs > 0 ? n * least_step() : 0;
    const int for_bar = std::max(least, room - static_cast<int>(result.signs) * result.line);
    result.step = std::clamp(for_bar / n, 2, em_ * 7 / 4);
    result.every = (least_step() + result.step - 1) / result.step;
    // Where classes are not equally wide, no bound can be told from the others.
    if (result.every > 1 && result.step >= small_step_) {
      result.has_small_ticks = true;
      result.every = 1;
    }
  }
  result.signs_top = result.top + n * result.step + round_bar();
  return result;
}

std::string Legend::left_out(const Page& page) const {
  const Layout places = layout(page.legend);
  std::vector<std::string> things;
  const auto share = [](std::size_t some, std::size_t all) {
    return std::to_string(some) + " of the legend's " + std::to_string(all);
  };
  if (std::any_of(heading_.begin(), heading_.end(),
                  [](const SetText& line) { return line.is_shortened; })) {
    things.emplace_back("the end of the legend's heading");
  }
  std::size_t bounds = 0;
  std::size_t written = 0;
  for (std::size_t i = 0; i < ticks_.size(); ++i) {
    if (ticks_[i].width() == 0) continue;
    ++bounds;
    if (i % static_cast<std::size_t>(places.every) == 0) ++written;
  }
  if (written < bounds) things.push_back(share(bounds - written, bounds) + " bounds of classes");
  if (places.signs < entries_.size())
    things.push_back(share(entries_.size() - places.signs, entries_.size()) + " signs");
  std::string text;
  for (const std::string& thing : things) text += (text.empty() ? "" : ", ") + thing;
  return text;
}

void Legend::draw_bar(Canvas& canvas, const PixelBox& column, const Layout& places,
                      const RainfallClasses& classes) const {
  const std::size_t count = classes.count();
  if (count == 0) return;
  const int n = static_cast<int>(count);
  const int step = places.step;
  const int bar_width = em_ * 5 / 4;
  const int top = places.top + em_ / 2;
  for (int i = 0; i < n; ++i) {
    const Colour colour = classes.class_colour(count - 1 - static_cast<std::size_t>(i));
    canvas.fill({column.x, top + i * step, bar_width, step}, colour);
  }
  canvas.border({column.x, top, bar_width, n * step}, ink::border, std::max(1, em_ / 16));
  const std::vector<SetText>& ticks = places.has_small_ticks ? small_ticks_ : ticks_;
  for (int i = 0; i < static_cast<int>(ticks.size()); i += places.every) {
    const SetText& text = ticks[static_cast<std::size_t>(i)];
    const int y = ticks.size() == 1 ? top + step / 2 : top + (n - i) * step;
    if (text.width() == 0) continue;  // the class has no end
    if (ticks.size() > 1) {
      canvas.fill({column.x + bar_width, y, em_ / 4, std::max(1, em_ / 16)}, ink::border);
    }
    canvas.text(text, column.x + em_ * 2, y - text.height() / 2, {ink::text});
  }
}

void Legend::draw_entry(Canvas& canvas, const PixelBox& sign, Sign kind) const {
  const Point middle{sign.x + sign.width / 2.0, sign.y + sign.height / 2.0};
  if (is_of_gauges(kind)) {
    draw_gauge(canvas, middle, gauge_radius(em_, 1, 1e9), kind != Sign::silent_gauge, sign);
    return;
  }
  if (kind == Sign::dry) {
    canvas.fill(sign, ink::dry);
    canvas.border(sign, ink::border, std::max(1, em_ / 16));
    return;
  }
  const Window window{sign, {static_cast<double>(sign.x), static_cast<double>(sign.y)}};
  const double width = sign.width;
  const double height = sign.height;
  if (kind == Sign::no_reading) {
    const Ring box{{0, 0}, {width, 0}, {width, height}, {0, height}};
    const Area area{{{&box, 1}}, ink::no_reading, true};
    canvas.areas({&area, 1}, hatching(em_), window);
    canvas.border(sign, ink::border, std::max(1, em_ / 16));
    return;
  }
  const Stroke stroke = stroke_of(kind, em_);
  const std::vector<Point> ends{{stroke.width, height / 2}, {width - stroke.width, height / 2}};
  const Polyline line(ends);
  canvas.lines({&line, 1}, stroke, window);
}

void Legend::draw(Canvas& canvas, const Page& page, const RainfallClasses& classes) const {
  const Group group(canvas, {"legend"});
  const PixelBox& column = page.legend;
  const int line = em_ * 3 / 2;
  int y = column.y;
  for (std::size_t i = 0; i < heading_.size() && column.height >= line; ++i) {
    const bool has_unit = i + 1 == heading_.size() && !units_.empty();
    const Mark mark = has_unit ? Mark{.kind = "unit", .part = units_} : Mark();
    canvas.text(heading_[i], column.x, y + em_ * 3 / 4 - heading_[i].height() / 2,
                {ink::text, 0, mark});
    y += em_ * 5 / 4;
  }
  const Layout places = layout(column);
  draw_bar(canvas, column, places, classes);
  y = places.signs_top;
  for (std::size_t i = 0; i < places.signs; ++i) {
    draw_entry(canvas, {column.x, y + (places.line - em_) / 2, em_ * 5 / 4, em_}, entries_[i].sign);
    const SetText& text = entries_[i].text;
    canvas.text(text, column.x + em_ * 2, y + places.line / 2 - text.height() / 2, {ink::text});
    y += places.line;
  }
}

}  // namespace thiessen
