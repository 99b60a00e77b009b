#pragma once

#include <span>
#include <string>
#include <vector>

#include "gdal/output/encoded_file.h"
#include "gdal/rasters/geotiff_writer.h"
#include "gdal/rasters/grid_file.h"
#include "gdal/rasters/raster_colours.h"

namespace thiessen {

/// A GeoTIFF with a band a step. The format holds up to 65,535 of them. Memory: that of a step and
/// of what the bands say of themselves; in memory (see RasterOutput) the file's size.
class GeoTiffGrid : public GridFile {
 public:
  /// `times` are those of the steps, as RAINFALL writes them. `output` must outlive the grid.
  /// Throws Error where there are more than the format holds.
  GeoTiffGrid(const RasterOutput& output, std::span<const std::string> times);

  void add(std::span<const float> pixels) override;
  /// Sets what the values of the first band mean, as a table of its classes.
  void set_classes(std::span<const RasterClass> classes);
  /// Ends the file, and gives it with its side files. Requires a band for each time.
  std::vector<EncodedFile> finish() { return writer_.finish(); }

 private:
  const RasterOutput& output_;
  GeoTiffWriter writer_;
  int bands_ = 0;
};

}  // namespace thiessen
