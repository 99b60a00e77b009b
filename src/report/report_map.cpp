#include "report/report_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/interrupt.h"
#include "map/sheet/study_view.h"
#include "map/svg/xml_text.h"

namespace thiessen {
namespace {

constexpr double longer_side = 10'000;
constexpr double margin = 150;
/// A map is at most so many times longer than wide: the sides of a narrower one stay empty.
constexpr double longest_shape = 2;
/// Where there are more gauges their dots are smaller, on a narrow screen or on all.
constexpr std::size_t some_gauges = 100;
constexpr std::size_t many_gauges = 1'000;

/// How cells without a reading are filled.
constexpr const char* silent_pattern =
    "<defs><pattern id=\"silent\" width=\"100\" height=\"100\" patternUnits=\"userSpaceOnUse\" "
    "patternTransform=\"rotate(45)\"><rect width=\"100\" height=\"100\"/><path d=\"M0 "
    "50h100\"/></pattern></defs>\n";

struct Dot {
  std::int64_t x;
  std::int64_t y;
  friend bool operator==(const Dot&, const Dot&) = default;
};

/// Where things stand on the map's whole numbers, y down.
class Sheet {
 public:
  explicit Sheet(const Extent& extent)
      : west_(extent.west),
        north_(extent.north),
        scale_((longer_side - 2 * margin) / std::max(extent.width(), extent.height())) {
    width_ = extent.width() * scale_ + 2 * margin;
    height_ = extent.height() * scale_ + 2 * margin;
  }

  Dot operator()(Point p) const {
    return {whole((p.x - west_) * scale_ + margin), whole((north_ - p.y) * scale_ + margin)};
  }
  /// Whether a place can be told in whole numbers: a gauge may be at the end of the world.
  bool holds(Point p) const {
    constexpr double farthest = 1e7;
    return std::abs((p.x - west_) * scale_) < farthest &&
           std::abs((north_ - p.y) * scale_) < farthest;
  }
  std::string view_box() const {
    const double width = std::max(width_, height_ / longest_shape);
    const double height = std::max(height_, width_ / longest_shape);
    return std::to_string(whole((width_ - width) / 2)) + " " +
           std::to_string(whole((height_ - height) / 2)) + " " + std::to_string(whole(width)) +
           " " + std::to_string(whole(height));
  }

 private:
  static std::int64_t whole(double value) { return std::llround(value); }

  double west_;
  double north_;
  double scale_;
  double width_;
  double height_;
};

void append_number(std::string& path, std::int64_t number, bool begins) {
  if (!begins && number >= 0) path += ' ';
  path += std::to_string(number);
}

/// A ring or line, in steps from dot to dot; dots that fall on the one before are left out.
void append_line(std::string& path, const std::vector<Point>& line, bool closed,
                 const Sheet& sheet) {
  std::optional<Dot> before;
  bool steps = false;
  for (const Point p : line) {
    const Dot dot = sheet(p);
    if (before == dot) continue;
    if (!before) {
      path += 'M';
      append_number(path, dot.x, true);
      append_number(path, dot.y, false);
    } else {
      if (!steps) path += 'l';
      append_number(path, dot.x - before->x, !steps);
      append_number(path, dot.y - before->y, false);
      steps = true;
    }
    before = dot;
  }
  if (before && !steps) path += "h0";
  if (before && closed) path += 'z';
}

std::string filled_path(const MapShape& shape, const Sheet& sheet) {
  std::string path;
  for (const MapPart& part : shape) {
    for (const Ring& ring : part.rings) append_line(path, ring, true, sheet);
  }
  return path;
}

std::string outline_path(const MapShape& shape, const Sheet& sheet) {
  std::string path;
  for (const MapPart& part : shape) {
    for (const std::vector<Point>& line : part.lines) append_line(path, line, false, sheet);
  }
  return path;
}

/// Whether some edges of its rings are no outline, but only cut the shape.
bool is_cut(const MapShape& shape) {
  return std::any_of(shape.begin(), shape.end(), [](const MapPart& part) {
    std::size_t edges = 0;
    for (const Ring& ring : part.rings) edges += ring.size();
    for (const std::vector<Point>& line : part.lines) edges -= line.size() - 1;
    return edges > 0;
  });
}

std::string fill_of(const RainfallClasses& classes, double rainfall) {
  if (std::isnan(rainfall) || classes.count() + (classes.has_dry() ? 1U : 0U) == 0) return "";
  return " fill=\"" + hexadecimal(classes.colour(rainfall)) + "\"";
}

/// A gauge as a point without length, whose round ends are the dot at every scale.
std::string dot_path(Point place, const Sheet& sheet) {
  const Dot dot = sheet(place);
  return "M" + std::to_string(dot.x) + " " + std::to_string(dot.y) + "h0";
}

}  // namespace

std::string report_map(const Picture& picture) {
  const StudyView view = view_study(picture);
  const Sheet sheet(view.extent);
  const RainfallClasses classes = classes_of(picture);
  const std::size_t gauges = picture.gauges.size();
  const char* crowd = gauges > many_gauges   ? " class=\"many\""
                      : gauges > some_gauges ? " class=\"some\""
                                             : "";
  std::string svg = std::string("<svg id=\"map\"") + crowd + " viewBox=\"" + sheet.view_box() +
                    "\" role=\"group\" tabindex=\"0\" aria-labelledby=\"map-title\" "
                    "aria-describedby=\"map-keys\"><title id=\"map-title\">Map of the cells, " +
                    "basins and gauges</title>\n" + silent_pattern + "<g id=\"cells\">\n";
  for (std::size_t i = 0; i < view.cells.size(); ++i) {
    throw_if_interrupted();
    const PictureCell& cell = picture.cells[i];
    svg += std::string("<path class=\"cell") + (is_cut(view.cells[i]) ? " cut" : "") +
           "\" role=\"img\" data-station=\"" + xml_text(picture.gauges[cell.gauge].station) +
           "\" data-basin=\"" + xml_text(picture.basins[cell.basin].name) + "\"" +
           fill_of(classes, cell.rainfall) + " d=\"" + filled_path(view.cells[i], sheet) + "\"/>\n";
  }
  svg += "</g>\n<g id=\"edges\">\n";
  for (std::size_t i = 0; i < view.cells.size(); ++i) {
    if (!is_cut(view.cells[i])) continue;
    svg += "<path data-cell=\"" + std::to_string(i) + "\" d=\"" +
           outline_path(view.cells[i], sheet) + "\"/>\n";
  }
  svg += "</g>\n<g id=\"basins\">\n";
  for (const MapShape& basin : view.basins)
    svg += "<path d=\"" + outline_path(basin, sheet) + "\"/>\n";
  std::string reporting;
  std::string never;
  for (std::size_t i = 0; i < view.gauges.size(); ++i) {
    if (!std::isfinite(view.gauges[i].x) || !std::isfinite(view.gauges[i].y)) continue;
    if (!sheet.holds(view.gauges[i])) continue;
    (picture.gauges[i].reports ? reporting : never) += dot_path(view.gauges[i], sheet);
  }
  svg += "</g>\n<path class=\"halo\" d=\"" + reporting + never +
         "\"/>\n<path class=\"gauges\" d=\"" + reporting + "\"/>\n<path class=\"never\" d=\"" +
         never + "\"/>\n<path id=\"chosen\"/>\n</svg>\n";
  return svg;
}

}  // namespace thiessen
