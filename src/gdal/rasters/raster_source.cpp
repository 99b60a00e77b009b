#include "gdal/rasters/raster_source.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal_priv.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/interrupt.h"
#include "gdal/crs/crs_definition.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/rasters/raster_wholeness.h"

namespace thiessen {
namespace {

void register_rasters() {
  static std::once_flag once;
  std::call_once(once, [] {
    // Nothing is fetched, whatever a file of virtual pixels names.
    CPLSetConfigOption("CPL_VSIL_CURL_ALLOWED_FILENAME", "/vsicurl/none");
    register_local_drivers();
  });
}

[[noreturn]] void refuse(const std::string& file, std::string text, Wording hint = {}) {
  throw Error(Message{file, 0, std::move(text), std::move(hint)});
}

bool is_on_disk(const std::string& file) {
  struct stat status {};
  return stat(file.c_str(), &status) == 0;
}

/// The name by which GDAL opens a file: not to be taken for a connection.
std::string name_for_gdal(const std::string& file) {
  if (is_on_disk(file)) return file.starts_with('/') ? file : "./" + file;
  const bool is_archive =
      file.starts_with("/vsizip/") || file.starts_with("/vsigzip/") || file.starts_with("/vsitar/");
  const bool is_part = file.find(':') != std::string::npos && file.find("://") == std::string::npos;
  if (is_archive || (is_part && !file.starts_with("/vsi"))) return file;
  refuse(file, file.empty() ? "the file's name is empty" : std::strerror(ENOENT));
}

/// Refuses a file of several rasters, and names them.
[[noreturn]] void refuse_parts(const std::string& file, GDALDataset& dataset) {
  std::string names;
  char** const parts = dataset.GetMetadata("SUBDATASETS");
  for (char** part = parts; part != nullptr && *part != nullptr; ++part) {
    const std::string_view item = *part;
    const std::size_t equals = item.find("_NAME=");
    if (equals == std::string_view::npos) continue;
    names += (names.empty() ? "" : ", ") + std::string(item.substr(equals + 6));
  }
  if (names.empty()) refuse(file, "is no raster: it has no bands");
  refuse(file, "holds several rasters", "name one of them: " + names);
}

/// Whether the last band only tells which pixels count.
bool has_alpha(GDALDataset& dataset) {
  const int bands = dataset.GetRasterCount();
  return bands > 1 && dataset.GetRasterBand(bands)->GetColorInterpretation() == GCI_AlphaBand;
}

/// A band, and what its stored numbers stand for.
struct Band {
  GDALRasterBand* band = nullptr;
  double scale = 1;
  double offset = 0;
  double no_value = 0;
  bool has_no_value = false;
  bool has_mask = false;
};

Band band_of(GDALDataset& dataset, int number) {
  Band found;
  found.band = dataset.GetRasterBand(number);
  int is_set = FALSE;
  found.scale = found.band->GetScale(&is_set);
  if (is_set == FALSE) found.scale = 1;
  found.offset = found.band->GetOffset(&is_set);
  if (is_set == FALSE) found.offset = 0;
  found.no_value = found.band->GetNoDataValue(&is_set);
  found.has_no_value = is_set != FALSE;
  const int flags = found.band->GetMaskFlags();
  found.has_mask = (flags & (GMF_ALL_VALID | GMF_NODATA)) == 0;
  return found;
}

/// How many pixels of a band are read at once, where blocks are not larger.
constexpr std::size_t chunk_pixels = std::size_t{1} << 16;

/// Some rows of a band.
struct Chunk {
  RasterPart part;
  std::vector<double> values;  ///< row by row; NaN where there is none
  std::vector<unsigned char> mask;
};

/// Reads the values of a chunk's part. Throws Error where GDAL cannot.
void read_chunk(const Band& band, const std::string& file, Chunk& chunk) {
  const GdalErrors errors;
  const int column = static_cast<int>(chunk.part.column);
  const int line = static_cast<int>(chunk.part.row);
  const int columns = static_cast<int>(chunk.part.columns);
  const int rows = static_cast<int>(chunk.part.rows);
  const auto read = [&](GDALRasterBand* from, void* to, GDALDataType type) {
    if (from->RasterIO(GF_Read, column, line, columns, rows, to, columns, rows, type, 0, 0,
                       nullptr) != CE_None)
      refuse(file, "cannot be read: " + errors.text());
  };
  chunk.values.resize(chunk.part.columns * chunk.part.rows);
  read(band.band, chunk.values.data(), GDT_Float64);
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (band.has_no_value) {
    const bool is_narrow = band.band->GetRasterDataType() == GDT_Float32;
    const double no_value =
        is_narrow ? static_cast<double>(static_cast<float>(band.no_value)) : band.no_value;
    for (double& value : chunk.values) value = value == no_value ? none : value;
  }
  if (band.has_mask) {
    chunk.mask.resize(chunk.values.size());
    read(band.band->GetMaskBand(), chunk.mask.data(), GDT_Byte);
    for (std::size_t i = 0; i < chunk.values.size(); ++i) {
      if (chunk.mask[i] == 0) chunk.values[i] = none;
    }
  }
  if (band.scale == 1 && band.offset == 0) return;
  for (double& value : chunk.values) value = band.scale * value + band.offset;
}

/// Refuses numbers that stand for colours, and not for values.
void refuse_colours(const std::string& file, GDALRasterBand& band, int number) {
  const GDALColorInterp colour = band.GetColorInterpretation();
  const bool is_part = colour == GCI_RedBand || colour == GCI_GreenBand || colour == GCI_BlueBand;
  const bool is_small = band.GetRasterDataType() == GDT_Byte;
  if (colour != GCI_PaletteIndex && !(is_part && is_small)) return;
  refuse(file,
         "is a picture: the numbers of its band " + std::to_string(number) + " stand for " +
             (is_part ? "a part of colours" : "colours of a palette"),
         "where they are values all the same, gdal_translate -b " + std::to_string(number) +
             " -colorinterp gray makes a raster of them");
}

}  // namespace

struct RasterSource::Held {
  std::unique_ptr<GDALDataset> dataset;
  std::vector<Band> bands;
};

RasterSource::~RasterSource() = default;
RasterSource::RasterSource(RasterSource&&) noexcept = default;
RasterSource& RasterSource::operator=(RasterSource&&) noexcept = default;

RasterSource::RasterSource(const std::string& file) : file_(file), held_(std::make_unique<Held>()) {
  register_rasters();
  const std::string name = name_for_gdal(file);
  const GdalErrors errors;
  // Another part of the process may have registered drivers that ask other machines.
  CPLStringList drivers;
  for (const std::string& driver : local_raster_drivers()) drivers.AddString(driver.c_str());
  held_->dataset.reset(GDALDataset::Open(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY,
                                         drivers.List(), nullptr, nullptr));
  if (!held_->dataset) {
    refuse(file, "is no raster that GDAL reads" + (errors.failed() ? ": " + errors.text() : ""));
  }
  GDALDataset& dataset = *held_->dataset;
  if (dataset.GetRasterCount() == 0) refuse_parts(file, dataset);
  const int bands = dataset.GetRasterCount() - (has_alpha(dataset) ? 1 : 0);
  for (int b = 1; b <= bands; ++b) {
    held_->bands.push_back(band_of(dataset, b));
    if (GDALDataTypeIsComplex(held_->bands.back().band->GetRasterDataType()) != FALSE)
      refuse(file, "holds complex numbers");
    refuse_colours(file, *held_->bands.back().band, b);
  }
  if (dataset.GetGeoTransform(transform_.data()) != CE_None) {
    refuse(file, "does not tell where its pixels lie: it has no geotransform",
           "gdal_translate -a_ullr gives it one, and gdalwarp makes one of control points");
  }
  if (transform_[1] * transform_[5] - transform_[2] * transform_[4] == 0)
    refuse(file, "has pixels without area");
  require_whole_raster(file, dataset);
  if (errors.failed_to_read()) {
    refuse(file, "cannot be read whole: " + errors.text(),
           "a copy or a download was cut off: get it anew");
  }
  const OGRSpatialReference* const system = dataset.GetSpatialRef();
  if (system == nullptr || system->IsEmpty()) return;
  OGRSpatialReference flat = *system;
  flat.StripVertical();
  flat.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  crs_ = crs_from_system(flat, file);
}

std::size_t RasterSource::columns() const {
  return static_cast<std::size_t>(held_->dataset->GetRasterXSize());
}

std::size_t RasterSource::rows() const {
  return static_cast<std::size_t>(held_->dataset->GetRasterYSize());
}

std::size_t RasterSource::bands() const {
  return held_->bands.size();
}

std::vector<std::string> RasterSource::texts() const {
  return texts_of_raster(*held_->dataset);
}

std::string RasterSource::unit() const {
  const char* const unit = held_->bands.front().band->GetUnitType();
  return unit == nullptr ? "" : unit;
}

bool RasterSource::is_wide() const {
  return std::any_of(held_->bands.begin(), held_->bands.end(), [](const Band& band) {
    switch (band.band->GetRasterDataType()) {
      case GDT_Byte:
      case GDT_UInt16:
      case GDT_Int16:
      case GDT_Float32:
        return band.scale != 1 || band.offset != 0;
      default:
        return true;
    }
  });
}

void RasterSource::read(const RasterPart& part, WindowValues& values, std::size_t at) const {
  int across = 0;
  int down = 0;
  held_->bands.front().band->GetBlockSize(&across, &down);
  const auto block = static_cast<std::size_t>(std::max(down, 1));
  const std::size_t most = std::max<std::size_t>(1, chunk_pixels / part.columns);
  Chunk chunk;
  // Whole blocks are read at once, and of all bands: a file may hold a pixel's bands side by side.
  for (std::size_t row = 0; row < part.rows; row += chunk.part.rows) {
    throw_if_interrupted();
    const std::size_t first = part.row + row;
    const std::size_t blocks_end = (first + std::max(most, block)) / block * block;
    const std::size_t end = blocks_end > first && most >= block ? blocks_end : first + most;
    chunk.part = {part.column, first, part.columns, std::min(end - first, part.rows - row)};
    for (std::size_t b = 0; b < held_->bands.size(); ++b) {
      read_chunk(held_->bands[b], file_, chunk);
      for (std::size_t r = 0; r < chunk.part.rows; ++r) {
        values.set(b, row + r, at,
                   std::span<const double>(chunk.values).subspan(r * part.columns, part.columns));
      }
    }
  }
}

}  // namespace thiessen
