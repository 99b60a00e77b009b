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
  if (!picture.cells.empty() && picture.bands.empty()) signs.push_back(Sign::cell);
  if (!picture.basins.empty()) signs.push_back(picture.has_basins ? Sign::basin : Sign::study_area);
  return signs;
}

/// The signs of all maps, each once, in the order of the enumeration.
std::set<Legend::Sign> signs_of(std::span<const Picture> maps, const RainfallClasses& classes) {
  std::set<Legend::Sign> signs;
  if (classes.has_dry()) signs.insert(Legend::Sign::dry);
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

Legend::Legend(std::span<const Picture> maps, bool has_gauges, const RainfallClasses& classes,
               const PageStyle& style, Typesetter& type)
    : em_(style.em), units_(maps.front().units) {
  if (style.bare) return;
  const Picture& picture = maps.front();
  const int size = style.ems(0.85);
  const int most = std::max(style.ems(7), picture.width / 5);
  const int sign = style.ems(2);
  if (picture.by_rainfall) {
    const std::string units = picture.units.empty() ? "" : " (" + picture.units + ")";
    heading_ = type.fit("Rainfall" + units, size, style.ems(0.65), most, Weight::bold);
    width_ = heading_.width();
  }
  for (const std::string& tick : classes.ticks()) {
    ticks_.push_back(type.fit(tick, size, size, most - sign));
    width_ = std::max(width_, sign + ticks_.back().width());
  }
  for (const Sign kind : signs_of(maps, classes)) {
    if (!has_gauges && is_of_gauges(kind)) continue;
    entries_.push_back({kind, type.set(meaning(kind), size)});
    width_ = std::max(width_, sign + entries_.back().text.width());
  }
}

Legend::Legend(const Picture& picture, const RainfallClasses& classes, const PageStyle& style,
               Typesetter& type)
    : Legend(std::span<const Picture>(&picture, 1), true, classes, style, type) {}

int Legend::bar_height(std::size_t classes, int step) const {
  return classes == 0 ? 0 : static_cast<int>(classes) * step + em_ * 3 / 2;
}

int Legend::height() const {
  const int heading = heading_.width() > 0 ? em_ * 7 / 4 : 0;
  const std::size_t classes = ticks_.size() < 2 ? ticks_.size() : ticks_.size() - 1;
  return heading + bar_height(classes, em_ * 5 / 4) +
         static_cast<int>(entries_.size()) * em_ * 3 / 2;
}

int Legend::draw_bar(Canvas& canvas, const PixelBox& box, const RainfallClasses& classes) const {
  const std::size_t count = classes.count();
  if (count == 0) return box.y;
  const int n = static_cast<int>(count);
  const int step = std::clamp((box.height - em_ * 3 / 2) / n, 2, em_ * 7 / 4);
  const int bar_width = em_ * 5 / 4;
  const int top = box.y + em_ / 2;
  for (int i = 0; i < n; ++i) {
    const Colour colour = classes.class_colour(count - 1 - static_cast<std::size_t>(i));
    canvas.fill({box.x, top + i * step, bar_width, step}, colour);
  }
  canvas.border({box.x, top, bar_width, n * step}, ink::border, std::max(1, em_ / 16));
  const int every = std::max(1, (em_ + step - 1) / step);
  for (int i = 0; i < static_cast<int>(ticks_.size()); i += every) {
    const SetText& text = ticks_[static_cast<std::size_t>(i)];
    const int y = ticks_.size() == 1 ? top + step / 2 : top + (n - i) * step;
    if (text.width() == 0) continue;  // the class has no end
    if (ticks_.size() > 1) {
      canvas.fill({box.x + bar_width, y, em_ / 4, std::max(1, em_ / 16)}, ink::border);
    }
    canvas.text(text, box.x + em_ * 2, y - text.height() / 2, {ink::text});
  }
  return top + n * step + em_;
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
  const PixelBox& box = page.legend;
  const int line = em_ * 3 / 2;
  int y = box.y;
  if (heading_.width() > 0 && box.height >= line) {
    canvas.text(heading_, box.x, y + em_ * 3 / 4 - heading_.height() / 2,
                {ink::text, 0, {.kind = "unit", .part = units_}});
    y += line;
  }
  const int below = static_cast<int>(entries_.size()) * line;
  y = draw_bar(canvas, {box.x, y, box.width, box.bottom() - y - below}, classes);
  for (const Entry& entry : entries_) {
    if (y + line > box.bottom() + em_ / 2) break;
    draw_entry(canvas, {box.x, y + (line - em_) / 2, em_ * 5 / 4, em_}, entry.sign);
    const int middle = y + line / 2;
    canvas.text(entry.text, box.x + em_ * 2, middle - entry.text.height() / 2, {ink::text});
    y += line;
  }
}

}  // namespace thiessen
