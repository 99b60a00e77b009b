#include "cli/outputs/raster_of.h"

#include <memory>

#include "gdal/crs/crs.h"
#include "gdal/crs/transformation.h"
#include "gdal/output/raster_file.h"
#include "map/raster/owners.h"
#include "map/raster/raster_grid.h"

namespace thiessen::cli {
namespace {

PointMapping mapping(const std::optional<Crs>& from, const std::optional<Crs>& to) {
  if (!from || !to || from->same_as(*to)) return [](std::vector<Point>&) {};
  const auto transformation = std::make_shared<Transformation>(*from, *to);
  return [transformation](std::vector<Point>& points) { transformation->apply_unproved(points); };
}

/// The shapes of the study area in the raster's coordinates.
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

}  // namespace

std::vector<EncodedFile> raster_of(const Inputs& inputs, const GaugeReadings* readings,
                                   double resolution, const Provenance& made_by,
                                   const std::string& path, unsigned threads) {
  const StudyFiles& study = inputs.study();
  const std::vector<MultiPolygon> areas = areas_of(inputs);
  const PixelGrid grid = grid_over(areas, resolution);
  const ReportingStations reports = readings == nullptr ? inputs.all_report() : readings->reports();
  Owners owners(
      grid, areas, inputs.network(), study.metric, reports,
      [&] { return mapping(study.output_crs(), study.crs); }, threads);
  const auto rows = [&](int row, int count) { return owners.rows(row, count); };
  if (readings != nullptr)
    return rainfall_geotiff(grid, rows, readings->readings, study.output_crs(), made_by, path,
                            threads);
  std::vector<std::string> ids;
  for (const Station& station : inputs.network().stations()) ids.push_back(station.id);
  return owners_geotiff(grid, rows, ids, study.output_crs(), made_by, path, threads);
}

}  // namespace thiessen::cli
