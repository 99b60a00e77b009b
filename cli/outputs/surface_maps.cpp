#include "cli/outputs/surface_maps.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "base/interrupt.h"
#include "cli/outputs/isohyets_in.h"
#include "cli/outputs/raster_of.h"
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
};

/// The levels between a surface's bands: where classes meet, and where dry ground ends.
std::vector<double> band_levels(const RainfallClasses& classes) {
  constexpr double hardly_any = 1e-4;  // share of the first class
  std::vector<double> levels = classes.bounds();
  if (classes.has_dry() && !levels.empty())
    levels.insert(levels.begin(), hardly_any * levels.front());
  return levels;
}

/// A sample of the surface's values at the pixels whose centres lie in the areas.
std::vector<double> values_within(const SurfaceRaster& raster,
                                  const std::vector<MultiPolygon>& areas) {
  const AreaSpans spans = AreaRows(raster.grid, areas).rows(0, raster.grid.rows);
  const auto columns = static_cast<std::size_t>(raster.grid.columns);
  ValueSample sample;
  for (int row = 0; row < raster.grid.rows; ++row) {
    throw_if_interrupted();
    const auto values = std::span(raster.values).subspan(static_cast<std::size_t>(row) * columns);
    for (const PixelSpan& span : spans.row(row)) {
      for (int column = span.first; column < span.end; ++column)
        sample.add(values[static_cast<std::size_t>(column)]);
    }
  }
  return sample.values();
}

std::vector<PictureBand> picture_bands(const SurfaceRaster& raster, const RainfallClasses& classes,
                                       const MultiPolygon& area, ToStudy& to_study) {
  constexpr double pixels_to_an_edge = 20;
  const std::vector<double> levels = band_levels(classes);
  std::vector<PictureBand> bands;
  for (SurfaceBand& band :
       bands_of(raster.grid, raster.values, levels, area, pixels_to_an_edge * raster.grid.pixel)) {
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

}  // namespace

std::string title_of(const IsohyetOptions& options) {
  if (options.surface()) return "Rainfall " + words_of(*options.surface());
  return "Rainfall by Thiessen cells, isohyets " + words_of(options.drawn());
}

void add_surfaces(const Inputs& inputs, std::span<const GaugeReadings> steps,
                  const IsohyetOptions& options, std::vector<Picture>& maps, unsigned threads) {
  if (!options.shows_any()) return;
  const int wanted = maps.size() == 1 ? maps.front().width : coarsest;
  const RasterSize size{0, std::clamp(wanted, coarsest, finest)};
  const std::vector<MultiPolygon> areas = areas_of(inputs);
  std::vector<std::optional<SurfaceRaster>> shown(maps.size());
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (!options.surface() || !steps[i].reports().any()) continue;
    shown[i] = surface_raster(inputs, steps[i], *options.surface(), SurfaceRows::Beyond::nearest,
                              size, threads);
    maps[i].surface = values_within(*shown[i], areas);
  }
  for (auto& [name, value] : maps.front().tags) {
    if (name == "method" && options.surface()) value = name_of(*options.surface());
  }
  const RainfallClasses classes = classes_of(maps);
  const MultiPolygon area = union_of(areas);
  ToStudy to_study(inputs);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (shown[i]) maps[i].bands = picture_bands(*shown[i], classes, area, to_study);
    shown[i].reset();
    if (!options.on_map || !steps[i].reports().any()) continue;
    maps[i].isohyets =
        picture_isohyets(isohyets_in(inputs, steps[i], options.drawn(), size,
                                     {options.interval, classes.bounds()}, {&area, 1}, threads),
                         to_study);
  }
}

}  // namespace thiessen::cli
