#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gdal/gdal_errors.h"
#include "gdal/output/disk_file.h"
#include "gdal/output/encoded_file.h"
#include "gdal/output/memory_files.h"
#include "gdal/rasters/raster_output.h"

class GDALDataset;
class GDALRasterAttributeTable;
class GDALRasterBand;

namespace thiessen {

/// Writes a GeoTIFF, whose bands hold station numbers or rainfall, to the disk or into memory (see
/// RasterOutput). What is written is on its way to the disk, so that memory does not grow with
/// pixels and bands. It is tiled, and
/// deflated at level 1, which gives up a fifth of what level 6 would save for half of its time.
/// Bytes do not depend on the threads. Every function throws Error where GDAL cannot write.
class GeoTiffWriter {
 public:
  enum class Pixels : std::uint8_t { numbers, rainfall };

  /// Begins the file. Numbers have 0 for "no data", rainfall NaN. `output` must outlive the writer.
  GeoTiffWriter(const RasterOutput& output, Pixels pixels, int bands);
  ~GeoTiffWriter();
  GeoTiffWriter(const GeoTiffWriter&) = delete;
  GeoTiffWriter& operator=(const GeoTiffWriter&) = delete;

  /// Says of a band, counted from 1, what it holds. To be called before any pixel is written, for
  /// it stands in the file before them.
  void describe(int band, const BandText& text);
  /// How many rows are best written at once.
  int rows_of_tiles() const;
  /// Writes `rows` rows of a band from `row` on: floats of rainfall, or numbers of 32 bits.
  void write(int band, int row, int rows, const void* pixels);
  /// Sets the table of what the first band's values mean.
  void set_table(const GDALRasterAttributeTable& table);
  /// Ends the file, makes its overviews, and gives it with its side files: the GeoTIFF first.
  std::vector<EncodedFile> finish();

 private:
  const std::string& name_for_gdal() const;
  void create(int bands);
  void make_overviews();
  GDALRasterBand& band(int number) const;
  void check(bool done) const;

  const RasterOutput& output_;
  Pixels pixels_;
  std::optional<MemoryFolder> in_memory_;
  std::optional<DiskFile> on_disk_;
  GdalErrors errors_;
  std::unique_ptr<GDALDataset> dataset_;
};

}  // namespace thiessen
