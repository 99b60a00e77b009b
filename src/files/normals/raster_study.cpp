#include "files/normals/raster_study.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "base/interrupt.h"
#include "base/number.h"
#include "base/utf8.h"
#include "gdal/crs/transformation.h"
#include "gdal/rasters/raster_source.h"
#include "rainfall/normals/raster_normals.h"

namespace thiessen {
namespace {

/// How many pixels a basin's box may hold.
constexpr double most_pixels = 2e9;
/// How far, in pixels, a smooth mapping may be from the true one; beyond the second it is none.
constexpr double wanted_error = 1e-6;
constexpr double worst_error = 1e-2;
/// Into how many pieces an edge of a basin is divided to see where it lies in the raster.
constexpr int pieces_of_edge = 8;

bool is_good(double normal) {
  return std::isfinite(normal) && normal > 0;
}

template <typename See>
void for_each_edge_point(const Basin& basin, const See& see) {
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      for (int piece = 0; piece < pieces_of_edge; ++piece) {
        const double along = static_cast<double>(piece) / pieces_of_edge;
        see(Point{a.x + along * (b.x - a.x), a.y + along * (b.y - a.y)});
      }
    }
  };
  for (const Polygon& part : basin.shape) {
    add(part.outer);
    for (const Ring& hole : part.holes) add(hole);
  }
}

Box box_of_basin(const Basin& basin) {
  Box box;
  for (const Polygon& part : basin.shape) {
    for (const Point p : part.outer) box.take_in(p);
  }
  return box;
}

/// Reads normals for one study.
class RasterReader {
 public:
  RasterReader(const std::string& file, const Study& study, const StudyFiles& files,
               Warnings& warnings)
      : source_(file), study_(study), files_(files), warnings_(warnings) {
    if (source_.bands() != 1 && source_.bands() != 12) {
      throw Error({file, 0,
                   "has " + std::to_string(source_.bands()) +
                       " bands, and normals have one, or twelve for the calendar months",
                   "gdal_translate -b N makes a raster of one"});
    }
    if (source_.bands() == 12) {
      warnings.add_notice(
          {file, 0, "its twelve bands are taken to be the months from January to December", ""});
    }
    settle_crs();
  }

  std::shared_ptr<const NormalField> read() {
    std::vector<std::vector<double>> gauges = at_gauges();
    const std::vector<double> references = gauges.front();
    std::vector<NormalWindow> windows;
    std::vector<double> areas;
    Complaints complaints;
    for (std::size_t b = 0; b < study_.basins().size(); ++b) {
      throw_if_interrupted();
      areas.push_back(study_.weighing().basin_area(b));
      auto window = window_of(b, references, complaints);
      if (window) windows.push_back(std::move(*window));
    }
    complaints.throw_if_any();
    auto normals = std::make_shared<const RasterNormals>(std::move(gauges), std::move(windows),
                                                         study_.basins(), areas);
    judge_cover(*normals);
    return normals;
  }

 private:
  using Exact = SmoothMapping::Exact;

  bool on_earth() const { return files_.metric == Metric::geodesic; }
  bool is_along_axes() const { return source_.transform()[2] == 0 && source_.transform()[4] == 0; }
  /// Whether the raster's coordinates are degrees, one way or another.
  bool in_degrees() const { return crs_ && crs_->geographic(); }

  void settle_crs() {
    crs_ = source_.crs();
    if (!crs_ && files_.output_crs()) {
      crs_ = files_.output_crs();
      warnings_.add({source_.file(), 0,
                     "names no CRS: its coordinates are taken to be in " + crs_->name() +
                         ", as those of " +
                         (files_.has_basins ? input("basins") : input("stations")),
                     ""});
    }
    if (crs_ && !files_.crs) {
      warnings_.add({source_.file(), 0,
                     "is in " + crs_->name() +
                         ", and the study names no CRS: its coordinates are taken to be the same",
                     ""});
    }
    const auto& t = source_.transform();
    const double determinant = t[1] * t[5] - t[2] * t[4];
    inverse_ = {t[5] / determinant, -t[2] / determinant, -t[4] / determinant, t[1] / determinant};
    keeps_turns_ = determinant < 0;
    is_same_ = !crs_ || !files_.crs || crs_->same_as(*files_.crs);
    if (is_same_) return;
    const Crs study = on_earth() ? files_.crs->over(extent()) : *files_.crs;
    forth_.emplace(study, *crs_);
    back_.emplace(*crs_, study);
  }

  /// Where the basins and the gauges lie, in degrees.
  Box extent() const {
    Box box;
    for (const Basin& basin : study_.basins()) box.take_in(box_of_basin(basin));
    for (const Station& station : study_.network().stations()) box.take_in(station.position);
    return box;
  }

  Point pixel_of(Point p) const {
    const auto& t = source_.transform();
    const Point from{p.x - t[0], p.y - t[3]};
    return {inverse_[0] * from.x + inverse_[1] * from.y,
            inverse_[2] * from.x + inverse_[3] * from.y};
  }

  /// A turn of longitude in columns, where the raster goes all round the Earth; else 0.
  double columns_of_turn() const {
    if (!in_degrees() || !is_along_axes()) return 0;
    return std::abs(360 / crs_->degrees_per_unit() / source_.transform()[1]);
  }
  bool goes_round() const {
    const double turn = columns_of_turn();
    return turn > 0 && std::abs(turn - static_cast<double>(source_.columns())) < 0.01;
  }

  /// Brings points of the study to pixels; longitudes run on as those of the study.
  std::vector<Point> to_pixels(std::vector<Point> points) const {
    if (!is_same_) {
      const std::vector<Point> before = points;
      forth_->apply_unproved(points);
      if (in_degrees() && on_earth()) {
        const double unit = crs_->degrees_per_unit();
        for (std::size_t i = 0; i < points.size(); ++i) {
          points[i].x += 360 / unit * std::round((before[i].x - points[i].x * unit) / 360);
        }
      }
    }
    for (Point& p : points) p = pixel_of(p);
    return points;
  }

  /// By how many turns a range of columns is to be moved to lie in the raster as far as it can.
  double turns_to(double first, double last) const {
    const double turn = columns_of_turn();
    if (turn == 0) return 0;
    const auto within = [&](double turns) {
      return std::min(last + turns * turn, static_cast<double>(source_.columns())) -
             std::max(first + turns * turn, 0.0);
    };
    double best = 0;
    for (const double turns : {-1.0, 1.0, -2.0, 2.0}) {
      if (within(turns) > within(best)) best = turns;
    }
    return best;
  }

  std::vector<std::vector<double>> at_gauges() const {
    const std::vector<Station>& stations = study_.network().stations();
    std::vector<Point> points;
    points.reserve(stations.size());
    for (const Station& station : stations) points.push_back(station.position);
    points = to_pixels(std::move(points));
    require_some_within(points);
    std::vector<std::vector<double>> normals;
    Complaints complaints;
    for (std::size_t s = 0; s < stations.size(); ++s) {
      const std::optional<RasterPart> pixel = pixel_that_holds(points[s]);
      normals.push_back(at_pixel(pixel));
      complain_of_gauge(stations[s], normals.back(), pixel.has_value(), complaints);
    }
    complaints.throw_if_any();
    return normals;
  }

  /// Throws Error where all stations lie elsewhere.
  void require_some_within(const std::vector<Point>& points) const {
    Box stations;
    for (const Point at : points) {
      if (pixel_that_holds(at)) return;
      const Point there = position_of(at);
      if (std::isfinite(there.x) && std::isfinite(there.y)) stations.take_in(there);
    }
    Box raster;
    const auto columns = static_cast<double>(source_.columns());
    const auto rows = static_cast<double>(source_.rows());
    for (const Point corner : {Point{0, 0}, {columns, 0}, {0, rows}, {columns, rows}})
      raster.take_in(position_of(corner));
    const std::string where = stations.empty() ? "" : ", and theirs are " + span_text(stations);
    throw Error({source_.file(), 0,
                 "none of the stations stands in it: its coordinates" +
                     (crs_ ? " (" + crs_->name() + ")" : std::string()) + " are " +
                     span_text(raster) + where,
                 "the raster is of another place, or in another CRS than it says, which "
                 "gdal_translate -a_srs puts right"});
  }

  static std::string span_text(const Box& box) {
    const auto text = [](double value) { return shortest_text(std::round(1e3 * value) / 1e3); };
    return "x from " + text(box.low.x) + " to " + text(box.high.x) + " and y from " +
           text(box.low.y) + " to " + text(box.high.y);
  }

  /// The raster's coordinates of a position in pixels.
  Point position_of(Point pixel) const {
    const auto& t = source_.transform();
    return {t[0] + pixel.x * t[1] + pixel.y * t[2], t[3] + pixel.x * t[4] + pixel.y * t[5]};
  }

  /// The pixel that holds a position; nothing where none does.
  std::optional<RasterPart> pixel_that_holds(Point at) const {
    const double turn = columns_of_turn();
    const auto columns = static_cast<double>(source_.columns());
    double column = at.x + turn * turns_to(at.x, at.x);
    if (goes_round()) column -= columns * std::floor(column / columns);
    // The far edges of the raster belong to its last pixels.
    if (column == columns) column -= 0.5;
    const double row = at.y == static_cast<double>(source_.rows()) ? at.y - 0.5 : at.y;
    if (!(column >= 0 && column < columns && row >= 0 && row < static_cast<double>(source_.rows())))
      return std::nullopt;
    return RasterPart{static_cast<std::size_t>(column), static_cast<std::size_t>(row), 1, 1};
  }

  /// The normals of a pixel, band by band; NaN where there are none.
  std::vector<double> at_pixel(const std::optional<RasterPart>& pixel) const {
    std::vector<double> normals(source_.bands(), std::numeric_limits<double>::quiet_NaN());
    if (!pixel) return normals;
    WindowValues values(1, 1, source_.bands(), true);
    source_.read(*pixel, values, 0);
    for (std::size_t b = 0; b < normals.size(); ++b) normals[b] = values.at(b, 0, 0);
    return normals;
  }

  void complain_of_gauge(const Station& station, const std::vector<double>& normals, bool is_within,
                         Complaints& complaints) const {
    const auto bad = std::find_if_not(normals.begin(), normals.end(), is_good);
    if (bad == normals.end()) return;
    const std::string in_month =
        normals.size() == 1 ? "" : " in month " + std::to_string(bad - normals.begin() + 1);
    const std::string what = !is_within         ? "lies outside of the raster"
                             : std::isnan(*bad) ? "has no normal" + in_month
                                                : "has the normal " + shortest_text(*bad) +
                                                      in_month + ", and normals are above 0";
    complaints.add({source_.file(), 0, "station " + quoted(station.id, 80) + " " + what,
                    setting("stations_where") + " leaves stations out of the network"});
  }

  std::string place_of(std::size_t basin) const {
    return files_.has_basins ? "basin " + quoted(study_.basins()[basin].id, 80) : "the study area";
  }

  /// The window of a basin; nothing where it has faults.
  std::optional<NormalWindow> window_of(std::size_t b, const std::vector<double>& references,
                                        Complaints& complaints) {
    const Basin& basin = study_.basins()[b];
    std::unique_ptr<const PixelMapping> whole = mapping_of(basin);
    if (!whole) {
      complaints.add({source_.file(), 0,
                      place_of(b) + " reaches beyond the area of the raster's projection (" +
                          crs_->name() + ")",
                      "gdalwarp -t_srs EPSG:4326 brings the raster to degrees"});
      return {};
    }
    Box box;
    for_each_edge_point(basin, [&](Point p) { box.take_in(whole->to_pixels(p)); });
    const double turns = turns_to(box.low.x, box.high.x);
    const double shift = turns * columns_of_turn();
    const Range columns =
        range_of(box.low.x + shift, box.high.x + shift, goes_round() ? 0 : source_.columns());
    const Range rows = range_of(box.low.y, box.high.y, source_.rows());
    if (columns.count() * rows.count() > most_pixels) {
      throw Error({source_.file(), 0, "has more than 2e9 pixels over " + place_of(b),
                   "gdal_translate -r average -tr makes larger pixels"});
    }
    if (columns.count() <= 0 || rows.count() <= 0) {
      complaints.add({source_.file(), 0, "does not reach " + place_of(b), ""});
      return {};
    }
    const bool holds_all = columns.is_whole && rows.is_whole;
    WindowValues values = values_of(columns, rows);
    complain_of_values(b, values, {columns, rows, shift, holds_all}, complaints);
    return NormalWindow{
        PixelIntegrals(std::move(values), references, areas_of(columns, rows, shift)),
        shifted(basin, {columns.first - shift, rows.first}), keeps_turns_, holds_all,
        box_of_basin(basin).centre().x};
  }

  /// Whole columns or rows, as far as the raster has them.
  struct Range {
    double first;
    double last;
    bool is_whole;
    double count() const { return last - first; }
  };
  /// The range that holds two positions; where `limit` is 0 there is none.
  static Range range_of(double low, double high, std::size_t limit) {
    Range range{std::floor(low - 1e-3), std::ceil(high + 1e-3), true};
    if (limit == 0) return range;
    const auto end = static_cast<double>(limit);
    range.is_whole = low >= -1e-6 && high <= end + 1e-6;
    range.first = std::max(range.first, 0.0);
    range.last = std::min(range.last, end);
    return range;
  }

  WindowValues values_of(const Range& columns, const Range& rows) const {
    WindowValues values(static_cast<std::size_t>(columns.count()),
                        static_cast<std::size_t>(rows.count()), source_.bands(), source_.is_wide());
    const auto all = static_cast<double>(source_.columns());
    for (double column = columns.first; column < columns.last;) {
      const double turned = goes_round() ? column - all * std::floor(column / all) : column;
      const double count = std::min(columns.last - column, all - turned);
      source_.read({static_cast<std::size_t>(turned), static_cast<std::size_t>(rows.first),
                    static_cast<std::size_t>(count), static_cast<std::size_t>(rows.count())},
                   values, static_cast<std::size_t>(column - columns.first));
      column += count;
    }
    return values;
  }

  /// The mapping to the raster's own pixels; null where the projection does not reach.
  std::unique_ptr<const PixelMapping> mapping_of(const Basin& basin) const {
    return shifted(basin, {0, 0});
  }

  /// The mapping to pixels counted from a corner.
  std::unique_ptr<const PixelMapping> shifted(const Basin& basin, Point corner) const {
    if (is_same_) {
      const Point origin = pixel_of({0, 0});
      const auto& i = inverse_;
      return std::make_unique<const AffineMapping>(Point{origin.x - corner.x, origin.y - corner.y},
                                                   Point{i[0], i[2]}, Point{i[1], i[3]});
    }
    Box frame = box_of_basin(basin);
    frame = frame.grown(1e-4 * std::max(frame.width(), frame.height()));
    auto smooth = std::make_unique<const SmoothMapping>(
        [&](std::vector<Point> points) {
          points = to_pixels(std::move(points));
          for (Point& p : points) p = {p.x - corner.x, p.y - corner.y};
          return points;
        },
        frame, wanted_error);
    if (!(smooth->error() <= worst_error)) return nullptr;
    return smooth;
  }

  std::unique_ptr<const PixelAreas> areas_of(const Range& columns, const Range& rows,
                                             double shift) const {
    const auto& t = source_.transform();
    const auto count = static_cast<std::size_t>(rows.count());
    if (on_earth() && in_degrees() && is_along_axes()) {
      const double unit = crs_->degrees_per_unit();
      return std::make_unique<const PixelsInDegrees>((t[3] + rows.first * t[5]) * unit, t[5] * unit,
                                                     t[1] * unit, count);
    }
    const Surface& surface = study_.weighing().surface();
    if (!on_earth() && is_same_) {
      // a pixel is a parallelogram of the plane
      const Point right{t[1], t[4]};
      const Point down{t[2], t[5]};
      return std::make_unique<const EqualPixels>(std::abs(
          area_of_ring({{0, 0}, right, {right.x + down.x, right.y + down.y}, down}, surface)));
    }
    const Point middle{(columns.first + columns.last) / 2 - shift, (rows.first + rows.last) / 2};
    const double side = std::sqrt(areas_at({middle}, surface).front());
    const double spacing = std::floor(PixelsOfPlane::farthest_nodes / side);
    const auto pixels = static_cast<std::size_t>(
        spacing > 1 ? std::min(spacing, static_cast<double>(PixelsOfPlane::most_spacing)) : 1);
    return std::make_unique<const PixelsOfPlane>(
        areas_at(nodes_of(columns, rows, shift, pixels), surface),
        static_cast<std::size_t>(columns.count()), pixels);
  }

  static double area_of_ring(const Ring& ring, const Surface& surface) {
    double area = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
      area -= surface.under(ring[i], ring[(i + 1) % ring.size()], ring.front().y);
    return area;
  }

  /// The nodes of PixelsOfPlane, in pixels of the raster.
  static std::vector<Point> nodes_of(const Range& columns, const Range& rows, double shift,
                                     std::size_t spacing) {
    std::vector<Point> nodes;
    const auto along = static_cast<std::size_t>(columns.count());
    const auto down = static_cast<std::size_t>(rows.count());
    for (std::size_t j = 0; j < PixelsOfPlane::nodes_along(down, spacing); ++j) {
      for (std::size_t i = 0; i < PixelsOfPlane::nodes_along(along, spacing); ++i) {
        nodes.push_back({columns.first - shift + static_cast<double>(spacing * i),
                         rows.first + static_cast<double>(spacing * j)});
      }
    }
    return nodes;
  }

  /// The areas of a pixel round each of these positions.
  std::vector<double> areas_at(const std::vector<Point>& positions, const Surface& surface) const {
    const auto& t = source_.transform();
    std::vector<Point> corners;
    for (const Point p : positions) {
      for (const Point d : {Point{-0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}}) {
        const double c = p.x + d.x;
        const double r = p.y + d.y;
        corners.push_back({t[0] + c * t[1] + r * t[2], t[3] + c * t[4] + r * t[5]});
      }
    }
    if (!is_same_) back_->apply_unproved(corners);
    std::vector<double> areas;
    for (std::size_t i = 0; i < corners.size(); i += 4) {
      Ring ring(corners.begin() + static_cast<std::ptrdiff_t>(i),
                corners.begin() + static_cast<std::ptrdiff_t>(i + 4));
      if (on_earth()) {
        for (Point& p : ring) p.x -= 360 * std::round((p.x - ring.front().x) / 360);
      }
      const double area = std::abs(area_of_ring(ring, surface));
      areas.push_back(std::isfinite(area) ? area : 0);
    }
    return areas;
  }

  /// Where a window lies.
  struct Framed {
    Range columns;
    Range rows;
    double shift;
    bool holds_all;
  };
  /// Complains of values in the basin that are not above 0.
  void complain_of_values(std::size_t b, const WindowValues& values, const Framed& window,
                          Complaints& complaints) const {
    if (values.least() > 0 && std::isfinite(values.largest())) return;
    std::optional<WindowValues> bad;
    for (std::size_t band = 0; band < values.bands(); ++band) {
      for (std::size_t r = 0; r < values.rows(); ++r) {
        for (std::size_t c = 0; c < values.columns(); ++c) {
          const double value = values.at(band, r, c);
          if (std::isnan(value) || is_good(value)) continue;
          if (!bad) bad.emplace(values.columns(), values.rows(), 1, false);
          if (std::isnan(bad->at(0, r, c))) bad->set(0, r, c, 1);
        }
      }
    }
    if (!bad) return;
    const Basin& basin = study_.basins()[b];
    NormalWindow of_bad{
        PixelIntegrals(std::move(*bad), {1}, areas_of(window.columns, window.rows, window.shift)),
        shifted(basin, {window.columns.first - window.shift, window.rows.first}), keeps_turns_,
        window.holds_all, box_of_basin(basin).centre().x};
    const double share =
        RasterBasinNormals(std::move(of_bad), basin, study_.weighing().basin_area(b))
            .whole(0)
            .covered;
    if (share == 0) return;
    complaints.add(
        {source_.file(), 0,
         "has normals that are not above 0 on " + percent_text(share) + " of " + place_of(b),
         "gdal_translate -a_nodata takes such a value for none"});
  }

  static std::string percent_text(double share) {
    return fixed_text(100 * share, share < 0.001 ? 3 : 1) + " %";
  }

  /// Warns of basins that are not covered whole; refuses those that are not at all.
  void judge_cover(const NormalField& normals) const {
    Complaints complaints;
    std::size_t lacking = 0;
    std::size_t worst = 0;
    double least = 1;
    for (std::size_t b = 0; b < study_.basins().size(); ++b) {
      double covered = 1;
      for (std::size_t m = 0; m < normals.months(); ++m)
        covered = std::min(covered, normals.in(b).whole(m).covered);
      if (covered == 0) complaints.add({source_.file(), 0, "has no normals in " + place_of(b), ""});
      if (covered < 1) ++lacking;
      if (covered < least) {
        least = covered;
        worst = b;
      }
    }
    complaints.throw_if_any();
    if (lacking == 0) return;
    const std::string of_worst =
        "no normals on " + percent_text(1 - least) + " of " + place_of(worst);
    warnings_.add({source_.file(), 0,
                   (lacking == 1 ? "has " + of_worst
                                 : "lacks normals in " + std::to_string(lacking) +
                                       " basins: it has " + of_worst) +
                       "; ground without them takes the mean of the rest of what its gauge has",
                   ""});
  }

  RasterSource source_;
  const Study& study_;
  const StudyFiles& files_;
  Warnings& warnings_;
  std::optional<Crs> crs_;
  std::array<double, 4> inverse_{};
  bool keeps_turns_ = true;
  bool is_same_ = true;
  std::optional<Transformation> forth_;
  std::optional<Transformation> back_;
};

}  // namespace

std::shared_ptr<const NormalField> normals_of_raster(const std::string& file, const Study& study,
                                                     const StudyFiles& files, Warnings& warnings) {
  return RasterReader(file, study, files, warnings).read();
}

}  // namespace thiessen
