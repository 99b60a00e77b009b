#include "gdal/rasters/geotiff_grid.h"

#include <algorithm>

#include "base/error.h"
#include "gdal/rasters/raster_tables.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace thiessen {
namespace {

/// Gives memory that is free back to the system. The C library keeps what GDAL has allocated for a
/// step's tiles and freed between things that last, 1.5 MB of a million pixels, step after step.
void give_back_memory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

constexpr std::size_t most_bands = 65'535;

int bands_for(const RasterOutput& output, std::span<const std::string> times) {
  if (times.size() <= most_bands) return static_cast<int>(times.size());
  throw Error(Message{
      output.path, 0,
      "a GeoTIFF has up to 65535 bands, and there are " + std::to_string(times.size()) +
          " time steps",
      "a .nc holds any number; " + setting("from") + " and " + setting("to") + " choose some"});
}

}  // namespace

GeoTiffGrid::GeoTiffGrid(const RasterOutput& output, std::span<const std::string> times)
    : output_(output), writer_(output, GeoTiffWriter::Pixels::rainfall, bands_for(output, times)) {
  int band = 0;
  for (const std::string& time : times) writer_.describe(++band, {time, time, output.made_by.unit});
}

void GeoTiffGrid::add(std::span<const float> pixels) {
  ++bands_;
  const PixelGrid& grid = output_.grid;
  const int step = writer_.rows_of_tiles();
  for (int row = 0; row < grid.rows; row += step) {
    const std::size_t before =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns);
    writer_.write(bands_, row, std::min(step, grid.rows - row), pixels.subspan(before).data());
  }
  constexpr int steps_between = 16;  // for the pages that it gives back are soon asked for again
  if (bands_ % steps_between == 0) give_back_memory();
}

void GeoTiffGrid::set_classes(std::span<const RasterClass> classes) {
  if (!classes.empty()) writer_.set_table(table_of(classes));
}

}  // namespace thiessen
