#include "cli/outputs/rasters/raster_of.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "cli/outputs/rasters/raster_style.h"
#include "cli/outputs/shown_values.h"
#include "gdal/crs/crs.h"
#include "gdal/crs/transformation.h"
#include "gdal/rasters/raster_file.h"
#include "map/raster/owners.h"
#include "map/raster/raster_grid.h"
#include "map/raster/surface_rows.h"
#include "map/sheet/picture.h"
#include "rainfall/methods/normal_surface.h"
#include "rainfall/normals/relative_readings.h"
#include "rainfall/series/value_sample.h"

namespace thiessen::cli {
namespace {

PointMapping mapping(const std::optional<Crs>& from, const std::optional<Crs>& to) {
  if (!from || !to || from->same_as(*to)) return [](std::vector<Point>&) {};
  const auto transformation = std::make_shared<Transformation>(*from, *to);
  return [transformation](std::vector<Point>& points) { transformation->apply_unproved(points); };
}

/// The values by a station's number; 0 stands for a pixel outside.
std::vector<float> values_by_number(std::span<const double> readings) {
  std::vector<float> values{std::numeric_limits<float>::quiet_NaN()};
  for (const double reading : readings) values.push_back(static_cast<float>(reading));
  return values;
}

using OwnerRows = std::function<std::span<const std::int32_t>(int row, int count)>;

std::vector<EncodedFile> raster_of_stations(const Inputs& inputs, const RasterOutput& output,
                                            const OwnerRows& rows, Warnings& warnings) {
  std::vector<std::string> ids;
  for (const Station& station : inputs.network().stations()) ids.push_back(station.id);
  StationStyle style(std::move(ids), output.grid.columns);
  const auto noted_rows = [&](int row, int count) {
    const std::span<const std::int32_t> some = rows(row, count);
    style.note(some);
    return some;
  };
  std::vector<EncodedFile> files =
      owners_geotiff(output, noted_rows, style.ids(), [&] { return style.colours(); });
  files.push_back(style.file(output.path));
  if (style.owners() > StationStyle::most_chosen) {
    warnings.add_notice(
        {output.path, 0,
         "its attribute table has the ids of its " + std::to_string(style.owners()) +
             " gauges without colours, and in QGIS colours follow their numbers, so "
             "that neighbours may look alike",
         ""});
  }
  return files;
}

}  // namespace

std::vector<MultiPolygon> areas_of(const Inputs& inputs) {
  const StudyFiles& study = inputs.study();
  if (inputs.has_basins()) return study.native_basins;
  const auto& to = study.output_crs();
  const bool same = !study.crs || !to || study.crs->same_as(*to);
  std::vector<MultiPolygon> areas;
  for (const Basin& basin : study.basins)
    areas.push_back(same ? basin.shape : mapped_extent(basin.shape, mapping(study.crs, to)));
  return areas;
}

PointMapping to_study(const Inputs& inputs) {
  return mapping(inputs.study().output_crs(), inputs.study().crs);
}

PointMapping from_study(const Inputs& inputs) {
  return mapping(inputs.study().crs, inputs.study().output_crs());
}

std::unique_ptr<RainSurface> surface_in(const Inputs& inputs, std::span<const double> readings,
                                        SurfaceMethod method, const NormalMonth& month) {
  const NormalField* const normals = inputs.weighing().normals();
  auto surface = surface_of(method, inputs.network(), inputs.study().metric,
                            relative_readings(normals, readings, month));
  if (normals == nullptr) return surface;
  return std::make_unique<NormalSurface>(std::move(surface), normals_in(inputs, month));
}

std::shared_ptr<const NormalsAtPoints> normals_in(const Inputs& inputs, const NormalMonth& month) {
  const NormalField* const normals = inputs.weighing().normals();
  if (normals == nullptr) return nullptr;
  const double period = inputs.study().metric == Metric::geodesic ? 360 : 0;
  return std::make_shared<const NormalsAtPoints>(*normals, inputs.basins(), month, period);
}

std::vector<double> normals_in_row(const NormalsAtPoints& normals, const PixelGrid& grid, int row,
                                   const PointMapping& to_study) {
  std::vector<Point> centres;
  centres.reserve(static_cast<std::size_t>(grid.columns));
  for (int column = 0; column < grid.columns; ++column) centres.push_back(grid.centre(column, row));
  to_study(centres);
  std::vector<double> found;
  found.reserve(centres.size());
  for (const Point p : centres) {
    found.push_back(std::isfinite(p.x) && std::isfinite(p.y)
                        ? normals.at(p)
                        : std::numeric_limits<double>::quiet_NaN());
  }
  return found;
}

NormalMonth month_among(const Inputs& inputs, const std::optional<std::size_t>& month) {
  const NormalField* const normals = inputs.weighing().normals();
  return normals != nullptr && normals->months() > 1 ? month : NormalMonth();
}

std::function<bool(Point)> among_gauges_of(RainSurface& surface, PointMapping to_study) {
  return [&surface, to_study = std::move(to_study), one = std::vector<Point>(1)](Point p) mutable {
    one.front() = p;
    to_study(one);
    const Point at = one.front();
    return std::isfinite(at.x) && std::isfinite(at.y) && surface.at(at).is_among_gauges;
  };
}

SurfaceRows surface_rows(const Inputs& inputs, std::span<const double> readings,
                         SurfaceMethod method, const NormalMonth& month, SurfaceRows::Beyond beyond,
                         const PixelGrid& grid, unsigned threads) {
  return {
      grid, beyond,
      [&inputs, readings, method, month] { return surface_in(inputs, readings, method, month); },
      [&inputs] { return to_study(inputs); }, threads};
}

PixelGrid raster_grid(const Inputs& inputs, double resolution) {
  return grid_over(areas_of(inputs), resolution);
}

std::vector<EncodedFile> raster_of(const Inputs& inputs, const ShownRaster& shown,
                                   const RasterOutput& output, Warnings& warnings) {
  const StudyFiles& study = inputs.study();
  const GaugeReadings* const readings = shown.readings;
  const ReportingStations reports = readings == nullptr ? inputs.all_report() : readings->reports();
  Owners owners(
      output.grid, areas_of(inputs), inputs.network(), study.metric, reports,
      [&] { return to_study(inputs); }, output.threads);
  const auto rows = [&](int row, int count) { return owners.rows(row, count); };
  if (readings == nullptr) return raster_of_stations(inputs, output, rows, warnings);
  const NormalMonth month = month_among(inputs, readings->month);
  const BandText text{readings->label, shown.time, output.made_by.unit};
  if (shown.surface && reports.any()) {
    ValueSample sample;
    SurfaceRows values = surface_rows(inputs, readings->readings, *shown.surface, month,
                                      SurfaceRows::Beyond::nearest, output.grid, output.threads);
    const auto sampled_rows = [&](int row, int count) {
      const std::span<const float> some = values.rows(row, count, rows(row, count));
      for (const float value : some) sample.add(value);
      return some;
    };
    std::optional<RainfallStyle> style;
    const auto classes_of_sample = [&] {
      const RainfallClasses classes(sample.values(), shown.classes);
      warn_of_outside(classes, false, warnings);
      style.emplace(classes, sample.values(), output.made_by.unit);
      return style->classes();
    };
    std::vector<EncodedFile> files =
        rainfall_geotiff(output, sampled_rows, text, classes_of_sample);
    files.push_back(style.value().file(output.path));
    return files;
  }
  const std::vector<double> values_shown = shown_values(inputs, *readings, output.threads);
  const RainfallClasses classes(values_shown, shown.classes);
  warn_of_outside(classes, true, warnings);
  const RainfallStyle style(classes, values_shown, output.made_by.unit);
  const auto normals = normals_in(inputs, month);
  const std::vector<float> by_number =
      values_by_number(relative_readings(inputs.weighing().normals(), readings->readings, month));
  const PointMapping mapping = to_study(inputs);
  std::vector<float> values;
  const auto value_rows = [&](int row, int count) -> std::span<const float> {
    values.clear();
    for (const std::int32_t owner : rows(row, count))
      values.push_back(by_number[static_cast<std::size_t>(owner)]);
    for (int r = 0; normals && r < count; ++r) {
      const auto in_row = normals_in_row(*normals, output.grid, row + r, mapping);
      float* const value = &values[static_cast<std::size_t>(r) * in_row.size()];
      for (std::size_t c = 0; c < in_row.size(); ++c)
        value[c] = static_cast<float>(static_cast<double>(value[c]) * in_row[c]);
    }
    return values;
  };
  std::vector<EncodedFile> files =
      rainfall_geotiff(output, value_rows, text, [&] { return style.classes(); });
  files.push_back(style.file(output.path));
  return files;
}

}  // namespace thiessen::cli
