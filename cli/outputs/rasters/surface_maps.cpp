#include "cli/outputs/rasters/surface_maps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/interrupt.h"
#include "cli/outputs/rasters/isohyets_in.h"
#include "cli/outputs/rasters/raster_of.h"
#include "gdal/output/surface_bands.h"
#include "map/raster/area_rows.h"
#include "map/sheet/ticks.h"
#include "rainfall/series/value_sample.h"

namespace thiessen::cli {
namespace {

constexpr int coarsest = 1000;
constexpr int finest = 2000;

/// Takes places from the raster's coordinates to the study's.
class ToStudy {
 public:
  explicit ToStudy(const Inputs& inputs) : mapping_(to_study(inputs)) {}

  Point point(Point p) {
    one_.front() = p;
    mapping_(one_);
    return one_.front();
  }
  std::vector<Point> line(std::vector<Point> points) {
    mapping_(points);
    return points;
  }
  MultiPolygon shape(MultiPolygon shape) {
    for (Polygon& part : shape) {
      mapping_(part.outer);
      for (Ring& hole : part.holes) mapping_(hole);
    }
    return shape;
  }

 private:
  PointMapping mapping_;
  std::vector<Point> one_ = std::vector<Point>(1);
};

/// The levels between a surface's bands: where classes meet, and where dry ground ends.
std::vector<double> band_levels(const RainfallClasses& classes) {
  constexpr double hardly_any = 1e-4;  // share of the first class
  std::vector<double> levels = classes.bounds();
  if (classes.has_dry() && !levels.empty())
    levels.insert(levels.begin(), hardly_any * levels.front());
  return levels;
}

/// The surface of one map, for drawing.
struct ShownSurface {
  SurfaceRaster raster;
  std::unique_ptr<RainSurface> surface;

  bool is_all_among_gauges() const {
    const auto& among = raster.is_among_gauges;
    return std::find(among.begin(), among.end(), 0) == among.end();
  }
};

/// A sample of the surface's values at the pixels whose centres lie in the areas: of the nearest
/// gauge's, where they lie beyond the gauges.
std::vector<double> values_within(const ShownSurface& shown, const std::vector<MultiPolygon>& areas,
                                  ToStudy& to_study) {
  const SurfaceRaster& raster = shown.raster;
  const AreaSpans spans = AreaRows(raster.grid, areas).rows(0, raster.grid.rows);
  const auto columns = static_cast<std::size_t>(raster.grid.columns);
  ValueSample sample;
  for (int row = 0; row < raster.grid.rows; ++row) {
    throw_if_interrupted();
    const std::size_t before = static_cast<std::size_t>(row) * columns;
    for (const PixelSpan& span : spans.row(row)) {
      for (int column = span.first; column < span.end; ++column) {
        const std::size_t i = before + static_cast<std::size_t>(column);
        const bool has_own = raster.is_among_gauges[i] != 0 || std::isnan(raster.values[i]);
        sample.add(
            has_own ? raster.values[i]
                    : shown.surface->at(to_study.point(raster.grid.centre(column, row))).rainfall);
      }
    }
  }
  return sample.values();
}

/// The cells that reach beyond the gauges, for the nearest gauge's value is the surface's there: a
/// band for each class. What of them lies among the gauges is covered by the other bands.
std::vector<PictureBand> bands_beyond(const Picture& map, const RainfallClasses& classes,
                                      RainSurface& surface) {
  const auto reaches_beyond = [&](const Polygon& part) {
    return std::any_of(part.outer.begin(), part.outer.end(),
                       [&](Point p) { return !surface.at(p).is_among_gauges; });
  };
  std::map<std::ptrdiff_t, PictureBand> by_class;
  for (const PictureCell& cell : map.cells) {
    throw_if_interrupted();
    if (std::isnan(cell.rainfall)) continue;
    if (std::none_of(cell.shape.begin(), cell.shape.end(), reaches_beyond)) continue;
    const auto& bounds = classes.bounds();
    const bool dry = classes.has_dry() && cell.rainfall == 0;
    const auto above = std::upper_bound(bounds.begin(), bounds.end(), cell.rainfall);
    PictureBand& band = by_class[dry ? -1 : above - bounds.begin()];
    band.rainfall = cell.rainfall;
    band.shape.insert(band.shape.end(), cell.shape.begin(), cell.shape.end());
  }
  std::vector<PictureBand> bands;
  bands.reserve(by_class.size());
  for (auto& [number, band] : by_class) bands.push_back(std::move(band));
  return bands;
}

std::vector<PictureBand> picture_bands(const ShownSurface& shown, const RainfallClasses& classes,
                                       const MultiPolygon& area, const Picture& map,
                                       const Inputs& inputs, ToStudy& to_study) {
  constexpr double pixels_to_an_edge = 20;
  const SurfaceRaster& raster = shown.raster;
  const std::vector<double> levels = band_levels(classes);
  PixelValues values{raster.grid, raster.values};
  std::vector<PictureBand> bands;
  if (!shown.is_all_among_gauges()) {
    bands = bands_beyond(map, classes, *shown.surface);
    values.is_within = raster.is_among_gauges;
    values.holds = among_gauges_of(*shown.surface, thiessen::cli::to_study(inputs));
  }
  for (SurfaceBand& band : bands_of(values, levels, area, pixels_to_an_edge * raster.grid.pixel)) {
    const bool dry = classes.has_dry() && !levels.empty() && band.largest <= levels.front();
    bands.push_back({to_study.shape(std::move(band.shape)), dry ? 0 : band.least});
  }
  return bands;
}

std::vector<PictureIsohyet> picture_isohyets(std::vector<Isohyet> found, ToStudy& to_study) {
  std::vector<RoundValue> levels;
  levels.reserve(found.size());
  for (const Isohyet& isohyet : found) levels.push_back(nine_digits(isohyet.level));
  const std::vector<std::string> texts = texts_of(levels);
  std::vector<PictureIsohyet> isohyets;
  for (std::size_t i = 0; i < found.size(); ++i) {
    PictureIsohyet& isohyet = isohyets.emplace_back();
    isohyet.level = texts[i];
    for (auto& line : found[i].lines) isohyet.lines.push_back(to_study.line(std::move(line)));
  }
  return isohyets;
}

/// How a title names a surface.
std::string words_of(SurfaceMethod method) {
  switch (method) {
    case SurfaceMethod::idw:
      return "by inverse distance squared";
    case SurfaceMethod::natural:
      return "by natural neighbours";
    case SurfaceMethod::linear:
      return "linear between gauges";
  }
  return "";
}

ShownSurface shown_surface(const Inputs& inputs, const GaugeReadings& readings,
                           SurfaceMethod method, const RasterSize& size, unsigned threads) {
  return {surface_raster(inputs, readings, method, SurfaceRows::Beyond::continued, size, threads),
          surface_in(inputs, readings.readings, method, month_among(inputs, readings.month))};
}

/// The raster behind a picture so wide.
RasterSize raster_behind(int width) {
  return {0, std::clamp(width, coarsest, finest)};
}

}  // namespace

std::vector<Isohyet> pictured_isohyets(const Inputs& inputs, const GaugeReadings& readings,
                                       SurfaceMethod method, double resolution,
                                       std::span<const MultiPolygon> shapes, unsigned threads) {
  if (!readings.reports().any()) return {};
  ToStudy to_study(inputs);
  const ShownSurface shown =
      shown_surface(inputs, readings, method, raster_behind(Picture{}.width), threads);
  const RainfallClasses classes(values_within(shown, areas_of(inputs), to_study), {});
  const IsohyetLevels levels{0, classes.bounds()};
  if (resolution > 0)
    return isohyets_in(inputs, readings, method, {.resolution = resolution}, levels, shapes,
                       threads);
  return isohyets_on(shown.raster, inputs, readings, method, levels, shapes);
}

std::string title_of(const IsohyetOptions& options) {
  if (options.surface()) return "Rainfall " + words_of(*options.surface());
  return "Rainfall by Thiessen cells, isohyets " + words_of(options.drawn());
}

void add_surfaces(const Inputs& inputs, std::span<const GaugeReadings> steps,
                  const IsohyetOptions& options, std::vector<Picture>& maps, unsigned threads) {
  if (!options.shows_any()) return;
  const RasterSize size = raster_behind(maps.size() == 1 ? maps.front().width : coarsest);
  const std::vector<MultiPolygon> areas = areas_of(inputs);
  ToStudy to_study(inputs);
  std::vector<std::optional<ShownSurface>> shown(maps.size());
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (!options.surface() || !steps[i].reports().any()) continue;
    shown[i] = shown_surface(inputs, steps[i], *options.surface(), size, threads);
    maps[i].surface = values_within(*shown[i], areas, to_study);
  }
  for (auto& [name, value] : maps.front().tags) {
    if (name == "method" && options.surface()) value = name_of(*options.surface());
  }
  const RainfallClasses classes = classes_of(maps);
  const MultiPolygon area = union_of(areas);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (shown[i])
      maps[i].bands = picture_bands(*shown[i], classes, area, maps[i], inputs, to_study);
    shown[i].reset();
    if (!options.on_map || !steps[i].reports().any()) continue;
    maps[i].isohyets =
        picture_isohyets(isohyets_in(inputs, steps[i], options.drawn(), size,
                                     {options.interval, classes.bounds()}, {&area, 1}, threads),
                         to_study);
  }
}

}  // namespace thiessen::cli
