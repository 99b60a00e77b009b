#include "gdal/output/raster_file.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <gdal_rat.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>

#include "base/error.h"
#include "base/interrupt.h"
#include "gdal/crs/crs_definition.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/output/memory_files.h"

namespace thiessen {
namespace {

/// Writes one band as a GeoTIFF.
class GeoTiffWriter {
 public:
  GeoTiffWriter(const PixelGrid& grid, const std::string& path, unsigned threads)
      : grid_(grid), path_(path), folder_(path), threads_(threads) {
    GDALRegister_GTiff();
  }

  // A file left half written is not completed on closing, because GDAL would first fill it with
  // empty tiles.
  ~GeoTiffWriter() {
    if (dataset_) dataset_->MarkSuppressOnClose();
  }
  GeoTiffWriter(const GeoTiffWriter&) = delete;
  GeoTiffWriter& operator=(const GeoTiffWriter&) = delete;

  GDALRasterBand& create(GDALDataType type, const std::optional<Crs>& crs,
                         const Provenance& made_by) {
    CPLStringList options;
    options.SetNameValue("COMPRESS", "DEFLATE");
    options.SetNameValue("NUM_THREADS", std::to_string(threads_).c_str());
    options.SetNameValue("TILED", "YES");
    options.SetNameValue("BIGTIFF", "IF_SAFER");
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    check(driver != nullptr);
    dataset_.reset(
        driver->Create(folder_.file().c_str(), grid_.columns, grid_.rows, 1, type, options.List()));
    check(dataset_ != nullptr);
    double transform[6] = {grid_.north_west.x, grid_.pixel, 0, grid_.north_west.y, 0, -grid_.pixel};
    check(dataset_->SetGeoTransform(transform) == CE_None);
    if (crs) check(dataset_->SetSpatialRef(&crs->definition().system) == CE_None);
    for (const auto& [name, value] : items_of(made_by)) {
      const char* item = name == "software" ? "TIFFTAG_SOFTWARE" : name.c_str();
      check(dataset_->SetMetadataItem(item, value.c_str()) == CE_None);
    }
    return *dataset_->GetRasterBand(1);
  }

  /// Writes a row of tiles at a time; `pixels(owners)` gives the pixels' values for their owners.
  template <typename Pixels>
  void write(GDALRasterBand& band, GDALDataType type, const OwnerRows& owners, Pixels&& pixels) {
    int tile_columns = 0;
    int tile_rows = 0;
    band.GetBlockSize(&tile_columns, &tile_rows);
    for (int row = 0; row < grid_.rows; row += tile_rows) {
      throw_if_interrupted();
      const int rows = std::min(tile_rows, grid_.rows - row);
      const std::span<const std::int32_t> some = owners(row, rows);
      if (some.size() != static_cast<std::size_t>(rows) * static_cast<std::size_t>(grid_.columns)) {
        throw std::logic_error("the pixels do not fill their rows");
      }
      const void* first = pixels(some);
      // GDAL only reads from the buffer, but its interface asks for one that may be written to.
      check(band.RasterIO(GF_Write, 0, row, grid_.columns, rows, const_cast<void*>(first),
                          grid_.columns, rows, type, 0, 0, nullptr) == CE_None);
      // Without this, GDAL would hold the tiles, up to a twentieth of the machine's memory.
      check(band.FlushCache(false) == CE_None);
    }
  }

  std::vector<EncodedFile> finish() {
    dataset_.reset();
    check(true);
    return folder_.take();
  }

  void check(bool done) const {
    if (!done || errors_.failed()) {
      throw Error(Message{path_, 0, "GDAL cannot write it: " + errors_.text(), {}});
    }
  }

 private:
  const PixelGrid& grid_;
  std::string path_;
  MemoryFolder folder_;
  unsigned threads_;
  GdalErrors errors_;
  std::unique_ptr<GDALDataset> dataset_;
};

std::unique_ptr<GDALRasterAttributeTable> table_of(const std::vector<std::string>& ids) {
  auto table = std::make_unique<GDALDefaultRasterAttributeTable>();
  table->CreateColumn("value", GFT_Integer, GFU_MinMax);
  table->CreateColumn("station", GFT_String, GFU_Name);
  table->SetRowCount(static_cast<int>(ids.size()));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const int row = static_cast<int>(i);
    table->SetValue(row, 0, row + 1);
    table->SetValue(row, 1, ids[i].c_str());
  }
  return table;
}

}  // namespace

std::vector<EncodedFile> owners_geotiff(const PixelGrid& grid, const OwnerRows& owners,
                                        const std::vector<std::string>& station_ids,
                                        const std::optional<Crs>& crs, const Provenance& made_by,
                                        const std::string& path, unsigned threads) {
  GeoTiffWriter writer(grid, path, threads);
  GDALRasterBand& band = writer.create(GDT_Int32, crs, made_by);
  writer.check(band.SetNoDataValue(0) == CE_None);
  writer.write(band, GDT_Int32, owners,
               [](std::span<const std::int32_t> some) { return some.data(); });
  writer.check(band.SetDefaultRAT(table_of(station_ids).get()) == CE_None);
  return writer.finish();
}

std::vector<EncodedFile> rainfall_geotiff(const PixelGrid& grid, const OwnerRows& owners,
                                          std::span<const double> rainfall,
                                          const std::optional<Crs>& crs, const Provenance& made_by,
                                          const std::string& path, unsigned threads) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<float> by_number{static_cast<float>(none)};
  for (const double reading : rainfall) by_number.push_back(static_cast<float>(reading));
  GeoTiffWriter writer(grid, path, threads);
  GDALRasterBand& band = writer.create(GDT_Float32, crs, made_by);
  writer.check(band.SetNoDataValue(none) == CE_None);
  std::vector<float> pixels;
  writer.write(band, GDT_Float32, owners, [&](std::span<const std::int32_t> some) {
    pixels.clear();
    for (const std::int32_t owner : some)
      pixels.push_back(by_number[static_cast<std::size_t>(owner)]);
    return pixels.data();
  });
  return writer.finish();
}

}  // namespace thiessen
