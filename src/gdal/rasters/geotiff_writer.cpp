#include "gdal/rasters/geotiff_writer.h"

#include <cpl_string.h>
#include <gdal_priv.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>

#include "base/error.h"
#include "base/interrupt.h"
#include "base/parallel.h"
#include "gdal/crs/crs_definition.h"
#include "gdal/output/compact_xml.h"

namespace thiessen {
namespace {

GDALDriver& geotiff_driver() {
  GDALRegister_GTiff();
  return *GetGDALDriverManager()->GetDriverByName("GTiff");
}

void set_compression(CPLStringList& options, const RasterOutput& output, GDALDriver& driver) {
  switch (output.compression) {
    case Compression::none:
      return;
    case Compression::deflate:
      options.SetNameValue("COMPRESS", "DEFLATE");
      options.SetNameValue("ZLEVEL", "1");
      return;
    case Compression::zstd: {
      const char* known = driver.GetMetadataItem(GDAL_DMD_CREATIONOPTIONLIST);
      if (known == nullptr || std::string(known).find("<Value>ZSTD</Value>") == std::string::npos) {
        throw Error(Message{output.path, 0, "the GDAL of this machine has no ZSTD",
                            setting("compress", "deflate") + " does without it"});
      }
      options.SetNameValue("COMPRESS", "ZSTD");
      options.SetNameValue("ZSTD_LEVEL", "1");
      return;
    }
  }
}

GDALDataType type_of(GeoTiffWriter::Pixels pixels) {
  return pixels == GeoTiffWriter::Pixels::numbers ? GDT_Int32 : GDT_Float32;
}

double no_data_of(GeoTiffWriter::Pixels pixels) {
  return pixels == GeoTiffWriter::Pixels::numbers ? 0 : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

GeoTiffWriter::GeoTiffWriter(const RasterOutput& output, Pixels pixels, int bands)
    : output_(output), pixels_(pixels) {
  if (output.file_on_disk.empty()) {
    in_memory_.emplace(output.path);
  } else {
    on_disk_.emplace(output.file_on_disk, output.path);
  }
  create(bands);
}

// A file left half written is not completed on closing, because GDAL would first fill it with
// empty tiles.
GeoTiffWriter::~GeoTiffWriter() {
  if (dataset_) dataset_->MarkSuppressOnClose();
}

const std::string& GeoTiffWriter::name_for_gdal() const {
  return on_disk_ ? on_disk_->name_for_gdal() : in_memory_->file();
}

void GeoTiffWriter::create(int bands) {
  GDALDriver& driver = geotiff_driver();
  CPLStringList options;
  set_compression(options, output_, driver);
  // GDAL waits for ever for what a thread should compress that could not start.
  if (output_.threads > 1 && can_start_threads(output_.threads))
    options.SetNameValue("NUM_THREADS", std::to_string(output_.threads).c_str());
  options.SetNameValue("TILED", "YES");
  options.SetNameValue("INTERLEAVE", "BAND");
  options.SetNameValue("BIGTIFF", "IF_SAFER");
  const PixelGrid& grid = output_.grid;
  dataset_.reset(driver.Create(name_for_gdal().c_str(), grid.columns, grid.rows, bands,
                               type_of(pixels_), options.List()));
  check(dataset_ != nullptr);
  double transform[6] = {grid.north_west.x, grid.pixel, 0, grid.north_west.y, 0, -grid.pixel};
  check(dataset_->SetGeoTransform(transform) == CE_None);
  if (output_.crs) check(dataset_->SetSpatialRef(&output_.crs->definition().system) == CE_None);
  for (const auto& [name, value] : items_of(output_.made_by)) {
    const char* item = name == "software" ? "TIFFTAG_SOFTWARE" : name.c_str();
    check(dataset_->SetMetadataItem(item, value.c_str()) == CE_None);
  }
  // The format has one "no data" for all bands.
  check(band(1).SetNoDataValue(no_data_of(pixels_)) == CE_None);
}

GDALRasterBand& GeoTiffWriter::band(int number) const {
  return *dataset_->GetRasterBand(number);
}

void GeoTiffWriter::describe(int number, const BandText& text) {
  GDALRasterBand& one = band(number);
  one.SetDescription(text.description.c_str());
  if (!text.time.empty()) check(one.SetMetadataItem("time", text.time.c_str()) == CE_None);
  if (text.unit.empty()) return;
  check(one.SetMetadataItem("units", text.unit.c_str()) == CE_None);
  check(one.SetUnitType(text.unit.c_str()) == CE_None);
}

int GeoTiffWriter::rows_of_tiles() const {
  int columns = 0;
  int rows = 0;
  band(1).GetBlockSize(&columns, &rows);
  return rows;
}

void GeoTiffWriter::write(int number, int row, int rows, const void* pixels) {
  throw_if_interrupted();
  const int columns = output_.grid.columns;
  // GDAL only reads from the buffer, but its interface asks for one that may be written to.
  check(band(number).RasterIO(GF_Write, 0, row, columns, rows, const_cast<void*>(pixels), columns,
                              rows, type_of(pixels_), 0, 0, nullptr) == CE_None);
  // Without this, GDAL would hold the tiles, up to a twentieth of the machine's memory.
  check(band(number).FlushCache(false) == CE_None);
}

void GeoTiffWriter::set_table(const GDALRasterAttributeTable& table) {
  check(band(1).SetDefaultRAT(&table) == CE_None);
}

// Each overview is half as large as the one before, down to one that a tile holds.
void GeoTiffWriter::make_overviews() {
  std::vector<int> factors;
  const int side = std::max(output_.grid.columns, output_.grid.rows);
  for (int factor = 2; (side - 1) / (factor / 2) + 1 > 256; factor *= 2) factors.push_back(factor);
  if (factors.empty()) return;
  dataset_.reset(GDALDataset::Open(name_for_gdal().c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE));
  check(dataset_ != nullptr);
  check(dataset_->BuildOverviews("NEAREST", static_cast<int>(factors.size()), factors.data(), 0,
                                 nullptr, nullptr, nullptr) == CE_None);
  dataset_.reset();
}

std::vector<EncodedFile> GeoTiffWriter::finish() {
  dataset_.reset();
  check(true);
  if (output_.has_overviews) make_overviews();
  check(true);
  std::vector<EncodedFile> files = on_disk_ ? on_disk_->take() : in_memory_->take();
  // GDAL's layout, for readers of a few lines, makes a table of many stations twice as large.
  constexpr std::size_t large = std::size_t{1} << 18;
  for (EncodedFile& file : files) {
    if (file.bytes.size() > large && file.name.ends_with(".aux.xml"))
      file.bytes = compact_xml(file.bytes);
  }
  return files;
}

void GeoTiffWriter::check(bool done) const {
  if (on_disk_) on_disk_->check();
  if (done && !errors_.failed()) return;
  throw Error(Message{output_.path, 0, "GDAL cannot write it: " + errors_.text(), {}});
}

}  // namespace thiessen
