#include "io/raster_file.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <gdal_rat.h>

#include <limits>
#include <memory>
#include <stdexcept>

#include "base/error.h"
#include "io/crs_definition.h"
#include "io/drivers.h"
#include "io/gdal_errors.h"
#include "io/memory_files.h"

namespace thiessen {
namespace {

/// Writes one band as a GeoTIFF.
class GeoTiffWriter {
 public:
  GeoTiffWriter(const PixelGrid& grid, const std::string& path)
      : grid_(grid), path_(path), folder_(path) {
    GDALRegister_GTiff();
  }

  GDALRasterBand& create(GDALDataType type, const char* predictor, const std::optional<Crs>& crs) {
    CPLStringList options;
    options.SetNameValue("COMPRESS", "DEFLATE");
    options.SetNameValue("PREDICTOR", predictor);
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
    return *dataset_->GetRasterBand(1);
  }

  void write(GDALRasterBand& band, const void* pixels, std::size_t count, GDALDataType type) {
    if (count != static_cast<std::size_t>(grid_.columns) * static_cast<std::size_t>(grid_.rows)) {
      throw std::logic_error("the pixels do not fill their grid");
    }
    // GDAL reads from the buffer, but asks for one that it may write.
    check(band.RasterIO(GF_Write, 0, 0, grid_.columns, grid_.rows, const_cast<void*>(pixels),
                        grid_.columns, grid_.rows, type, 0, 0, nullptr) == CE_None);
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

std::vector<EncodedFile> owners_geotiff(const PixelGrid& grid,
                                        const std::vector<std::int32_t>& owners,
                                        const std::vector<std::string>& station_ids,
                                        const std::optional<Crs>& crs, const std::string& path) {
  GeoTiffWriter writer(grid, path);
  GDALRasterBand& band = writer.create(GDT_Int32, "2", crs);
  writer.write(band, owners.data(), owners.size(), GDT_Int32);
  writer.check(band.SetNoDataValue(0) == CE_None);
  writer.check(band.SetDefaultRAT(table_of(station_ids).get()) == CE_None);
  return writer.finish();
}

std::vector<EncodedFile> rainfall_geotiff(const PixelGrid& grid, const std::vector<float>& rainfall,
                                          const std::optional<Crs>& crs, const std::string& path) {
  GeoTiffWriter writer(grid, path);
  GDALRasterBand& band = writer.create(GDT_Float32, "3", crs);
  writer.check(band.SetNoDataValue(std::numeric_limits<double>::quiet_NaN()) == CE_None);
  writer.write(band, rainfall.data(), rainfall.size(), GDT_Float32);
  return writer.finish();
}

}  // namespace thiessen
