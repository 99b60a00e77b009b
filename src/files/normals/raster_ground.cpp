#include "files/normals/raster_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"
#include "text/last_line.h"

namespace thiessen {
namespace {

/// How many pixels a basin's box may hold.
constexpr double most_pixels = 2e9;
/// How far, in pixels, a smooth mapping may be from the true one; beyond the second it is none.
constexpr double wanted_error = 1e-6;
constexpr double worst_error = 1e-2;
/// Into how many pieces an edge of a basin is divided to see where it lies in the raster.
constexpr int pieces_of_edge = 8;

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

double area_of_ring(const Ring& ring, const Surface& surface) {
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    area -= surface.under(ring[i], ring[(i + 1) % ring.size()], ring.front().y);
  return area;
}

/// The range of pixels that holds two positions; where `limit` is 0 there is none.
RasterFrame::Range range_of(double low, double high, std::size_t limit) {
  RasterFrame::Range range{std::floor(low - 1e-3), std::ceil(high + 1e-3), true};
  if (limit == 0) return range;
  const auto end = static_cast<double>(limit);
  range.is_whole = low >= -1e-6 && high <= end + 1e-6;
  range.first = std::max(range.first, 0.0);
  range.last = std::min(range.last, end);
  return range;
}

/// The nodes of PixelsOfPlane, in pixels of the raster.
std::vector<Point> nodes_of(const RasterFrame& frame, std::size_t spacing) {
  std::vector<Point> nodes;
  const std::size_t along = frame.window_columns();
  const std::size_t down = frame.window_rows();
  for (std::size_t j = 0; j < PixelsOfPlane::nodes_along(down, spacing); ++j) {
    for (std::size_t i = 0; i < PixelsOfPlane::nodes_along(along, spacing); ++i) {
      nodes.push_back({frame.columns.first - frame.shift +
                           static_cast<double>(spacing * i * frame.block_columns),
                       frame.rows.first + static_cast<double>(spacing * j * frame.block_rows)});
    }
  }
  return nodes;
}

std::string span_text(const Box& box) {
  const auto text = [](double value) { return shortest_text(std::round(1e3 * value) / 1e3); };
  return "x from " + text(box.low.x) + " to " + text(box.high.x) + " and y from " +
         text(box.low.y) + " to " + text(box.high.y);
}

Point block_of(const RasterFrame& frame) {
  return {static_cast<double>(frame.block_columns), static_cast<double>(frame.block_rows)};
}

}  // namespace

RasterGround::RasterGround(const std::string& file, const Study& study, const StudyFiles& files,
                           Warnings& warnings)
    : source_(file), study_(study), files_(files) {
  for (const std::string& text : source_.texts()) tell_of_last_line(text, warnings);
  settle_crs(warnings);
}

void RasterGround::settle_crs(Warnings& warnings) {
  crs_ = source_.crs();
  if (!crs_ && files_.output_crs()) {
    crs_ = files_.output_crs();
    warnings.add({source_.file(), 0,
                  "names no CRS: its coordinates are taken to be in " + crs_->name() +
                      ", as those of " + (files_.has_basins ? input("basins") : input("stations")),
                  ""});
  }
  if (crs_ && !files_.crs) {
    warnings.add({source_.file(), 0,
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

Box RasterGround::extent() const {
  Box box;
  for (const Basin& basin : study_.basins()) box.take_in(box_of_basin(basin));
  for (const Station& station : study_.network().stations()) box.take_in(station.position);
  return box;
}

Point RasterGround::pixel_of(Point p) const {
  const auto& t = source_.transform();
  const Point from{p.x - t[0], p.y - t[3]};
  return {inverse_[0] * from.x + inverse_[1] * from.y, inverse_[2] * from.x + inverse_[3] * from.y};
}

double RasterGround::columns_of_turn() const {
  if (!in_degrees() || !is_along_axes()) return 0;
  return std::abs(360 / crs_->degrees_per_unit() / source_.transform()[1]);
}

bool RasterGround::goes_round() const {
  const double turn = columns_of_turn();
  return turn > 0 && std::abs(turn - static_cast<double>(source_.columns())) < 0.01;
}

std::vector<Point> RasterGround::to_pixels(std::vector<Point> points) const {
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

std::vector<Point> RasterGround::to_study(std::vector<Point> positions) const {
  for (Point& p : positions) p = position_of(p);
  if (!is_same_) back_->apply_unproved(positions);
  return positions;
}

double RasterGround::turns_to(double first, double last) const {
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

std::vector<Point> RasterGround::stations_in_pixels() const {
  const std::vector<Station>& stations = study_.network().stations();
  std::vector<Point> points;
  points.reserve(stations.size());
  for (const Station& station : stations) points.push_back(station.position);
  return to_pixels(std::move(points));
}

std::vector<std::optional<RasterPart>> RasterGround::pixels_of_stations() const {
  const std::vector<Point> points = stations_in_pixels();
  std::vector<std::optional<RasterPart>> pixels;
  pixels.reserve(points.size());
  for (const Point p : points) pixels.push_back(pixel_that_holds(p));
  if (std::none_of(pixels.begin(), pixels.end(), [](const auto& pixel) { return pixel; }))
    throw_elsewhere(points);
  return pixels;
}

std::vector<std::vector<double>> RasterGround::at_stations() const {
  const std::vector<Point> points = stations_in_pixels();
  std::vector<std::vector<double>> values;
  values.reserve(points.size());
  for (const Point p : points) values.push_back(at_pixel(pixel_that_holds(p)));
  return values;
}

void RasterGround::throw_elsewhere(const std::vector<Point>& stations) const {
  Box theirs;
  for (const Point at : stations) {
    const Point there = position_of(at);
    if (std::isfinite(there.x) && std::isfinite(there.y)) theirs.take_in(there);
  }
  Box raster;
  const auto columns = static_cast<double>(source_.columns());
  const auto rows = static_cast<double>(source_.rows());
  for (const Point corner : {Point{0, 0}, {columns, 0}, {0, rows}, {columns, rows}})
    raster.take_in(position_of(corner));
  const std::string where = theirs.empty() ? "" : ", and theirs are " + span_text(theirs);
  throw Error({source_.file(), 0,
               "none of the stations stands in it: its coordinates" +
                   (crs_ ? " (" + crs_->name() + ")" : std::string()) + " are " +
                   span_text(raster) + where,
               "the raster is of another place, or in another CRS than it says, which "
               "gdal_translate -a_srs puts right"});
}

Point RasterGround::position_of(Point pixel) const {
  const auto& t = source_.transform();
  return {t[0] + pixel.x * t[1] + pixel.y * t[2], t[3] + pixel.x * t[4] + pixel.y * t[5]};
}

std::optional<RasterPart> RasterGround::pixel_that_holds(Point at) const {
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

std::vector<double> RasterGround::at_pixel(const std::optional<RasterPart>& pixel) const {
  std::vector<double> found(source_.bands(), std::numeric_limits<double>::quiet_NaN());
  if (!pixel) return found;
  WindowValues values(1, 1, source_.bands(), true);
  source_.read(*pixel, values, 0);
  for (std::size_t b = 0; b < found.size(); ++b) found[b] = values.at(b, 0, 0);
  return found;
}

std::string RasterGround::place_of(std::size_t basin) const {
  return files_.has_basins ? "basin " + quoted(study_.basins()[basin].id, 80) : "the study area";
}

std::optional<RasterFrame> RasterGround::frame_of(std::size_t b, Complaints& complaints) const {
  const Basin& basin = study_.basins()[b];
  const std::unique_ptr<const PixelMapping> whole = mapping_of(basin);
  if (!whole) {
    complaints.add(
        {source_.file(), 0,
         place_of(b) + " reaches beyond the area of the raster's projection (" + crs_->name() + ")",
         "gdalwarp -t_srs EPSG:4326 brings the raster to degrees"});
    return {};
  }
  Box box;
  for_each_edge_point(basin, [&](Point p) { box.take_in(whole->to_pixels(p)); });
  RasterFrame frame;
  frame.shift = turns_to(box.low.x, box.high.x) * columns_of_turn();
  frame.columns = range_of(box.low.x + frame.shift, box.high.x + frame.shift,
                           goes_round() ? 0 : source_.columns());
  frame.rows = range_of(box.low.y, box.high.y, source_.rows());
  if (frame.columns.count() * frame.rows.count() > most_pixels) {
    throw Error({source_.file(), 0, "has more than 2e9 pixels over " + place_of(b),
                 "gdal_translate -r average -tr makes larger pixels"});
  }
  if (frame.columns.count() <= 0 || frame.rows.count() <= 0) {
    complaints.add({source_.file(), 0, "does not reach " + place_of(b), ""});
    return {};
  }
  return frame;
}

void RasterGround::set_blocks(RasterFrame& frame, double most_columns, double most_rows) const {
  const auto pixels = [](const RasterFrame::Range& range, double most) {
    const double wanted = std::min(most, range.count() / enough_blocks);
    return wanted > 1 ? static_cast<std::size_t>(wanted) : 1;
  };
  frame.block_columns = pixels(frame.columns, most_columns);
  frame.block_rows = pixels(frame.rows, most_rows);
  if (!on_earth() || !in_degrees() || !is_along_axes()) return;
  // No block reaches beyond a pole.
  const auto& t = source_.transform();
  const auto rows = static_cast<double>(frame.window_rows() * frame.block_rows);
  const double end = (t[3] + (frame.rows.first + rows) * t[5]) * crs_->degrees_per_unit();
  if (std::abs(end) > 90) frame.block_rows = 1;
}

NormalWindow RasterGround::window(std::size_t b, const RasterFrame& frame, WindowValues values,
                                  const std::vector<double>& references) const {
  const Basin& basin = study_.basins()[b];
  return {PixelIntegrals(std::move(values), references, areas_of(frame)), mapping_of(basin, frame),
          keeps_turns_, frame.holds_all(), box_of_basin(basin).centre().x};
}

double RasterGround::share_of(std::size_t b, const RasterFrame& frame, WindowValues marks) const {
  return RasterBasinNormals(window(b, frame, std::move(marks), {1}), study_.basins()[b],
                            study_.weighing().basin_area(b))
      .whole(0)
      .covered;
}

WindowValues RasterGround::values_of(const RasterFrame& frame) const {
  WindowValues values(static_cast<std::size_t>(frame.columns.count()),
                      static_cast<std::size_t>(frame.rows.count()), source_.bands(),
                      source_.is_wide());
  read(frame, 0, values);
  return values;
}

void RasterGround::read(const RasterFrame& frame, std::size_t row, WindowValues& values) const {
  const auto all = static_cast<double>(source_.columns());
  for (double column = frame.columns.first; column < frame.columns.last;) {
    const double turned = goes_round() ? column - all * std::floor(column / all) : column;
    const double count = std::min(frame.columns.last - column, all - turned);
    source_.read(
        {static_cast<std::size_t>(turned), static_cast<std::size_t>(frame.rows.first) + row,
         static_cast<std::size_t>(count), values.rows()},
        values, static_cast<std::size_t>(column - frame.columns.first));
    column += count;
  }
}

std::unique_ptr<const PixelMapping> RasterGround::mapping_of(const Basin& basin) const {
  return shifted(basin, {0, 0}, {1, 1});
}

std::unique_ptr<const PixelMapping> RasterGround::mapping_of(const Basin& basin,
                                                             const RasterFrame& frame) const {
  return shifted(basin, {frame.columns.first - frame.shift, frame.rows.first}, block_of(frame));
}

std::unique_ptr<const PixelMapping> RasterGround::shifted(const Basin& basin, Point corner,
                                                          Point block) const {
  if (is_same_) {
    const Point origin = pixel_of({0, 0});
    const auto& i = inverse_;
    return std::make_unique<const AffineMapping>(
        Point{(origin.x - corner.x) / block.x, (origin.y - corner.y) / block.y},
        Point{i[0] / block.x, i[2] / block.y}, Point{i[1] / block.x, i[3] / block.y});
  }
  Box frame = box_of_basin(basin);
  frame = frame.grown(1e-4 * std::max(frame.width(), frame.height()));
  auto smooth = std::make_unique<const SmoothMapping>(
      [&](std::vector<Point> points) {
        points = to_pixels(std::move(points));
        for (Point& p : points) p = {(p.x - corner.x) / block.x, (p.y - corner.y) / block.y};
        return points;
      },
      frame, wanted_error);
  if (!(smooth->error() <= worst_error)) return nullptr;
  return smooth;
}

std::unique_ptr<const PixelAreas> RasterGround::areas_of(const RasterFrame& frame) const {
  const auto& t = source_.transform();
  const std::size_t count = frame.window_rows();
  const Point block = block_of(frame);
  if (on_earth() && in_degrees() && is_along_axes()) {
    const double unit = crs_->degrees_per_unit();
    return std::make_unique<const PixelsInDegrees>((t[3] + frame.rows.first * t[5]) * unit,
                                                   t[5] * unit * block.y, t[1] * unit * block.x,
                                                   count);
  }
  const Surface& surface = study_.weighing().surface();
  if (!on_earth() && is_same_) {
    // a pixel is a parallelogram of the plane
    const Point right{t[1], t[4]};
    const Point down{t[2], t[5]};
    return std::make_unique<const EqualPixels>(
        block.x * block.y *
        std::abs(
            area_of_ring({{0, 0}, right, {right.x + down.x, right.y + down.y}, down}, surface)));
  }
  const Point middle{(frame.columns.first + frame.columns.last) / 2 - frame.shift,
                     (frame.rows.first + frame.rows.last) / 2};
  const double side = std::sqrt(areas_at({middle}, block, surface).front());
  const double spacing = std::floor(PixelsOfPlane::farthest_nodes / side);
  const auto pixels = static_cast<std::size_t>(
      spacing > 1 ? std::min(spacing, static_cast<double>(PixelsOfPlane::most_spacing)) : 1);
  return std::make_unique<const PixelsOfPlane>(areas_at(nodes_of(frame, pixels), block, surface),
                                               frame.window_columns(), pixels);
}

std::vector<double> RasterGround::areas_at(const std::vector<Point>& positions, Point block,
                                           const Surface& surface) const {
  std::vector<Point> corners;
  for (const Point p : positions) {
    for (const Point d : {Point{-0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}}) {
      corners.push_back({p.x + d.x * block.x, p.y + d.y * block.y});
    }
  }
  corners = to_study(std::move(corners));
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

std::string percent_of_ground(double share) {
  return fixed_text(100 * share, share < 0.001 ? 3 : 1) + " %";
}

void RasterGround::judge_cover(const NormalField& normals, const std::string& what,
                               Warnings& warnings) const {
  Complaints complaints;
  std::size_t lacking = 0;
  std::size_t worst = 0;
  double least = 1;
  for (std::size_t b = 0; b < study_.basins().size(); ++b) {
    double covered = 1;
    for (std::size_t m = 0; m < normals.months(); ++m)
      covered = std::min(covered, normals.in(b).whole(m).covered);
    if (covered == 0)
      complaints.add({source_.file(), 0, "has no " + what + " in " + place_of(b), ""});
    if (covered < 1) ++lacking;
    if (covered < least) {
      least = covered;
      worst = b;
    }
  }
  complaints.throw_if_any();
  if (lacking == 0) return;
  const std::string of_worst =
      "no " + what + " on " + percent_of_ground(1 - least) + " of " + place_of(worst);
  warnings.add({source_.file(), 0,
                (lacking == 1 ? "has " + of_worst
                              : "lacks " + what + " in " + std::to_string(lacking) +
                                    " basins: it has " + of_worst) +
                    "; ground without them takes the mean of the rest of what its gauge has",
                ""});
}

}  // namespace thiessen
