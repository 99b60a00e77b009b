#include "gdal/rasters/raster_wholeness.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <rawdataset.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/interrupt.h"
#include "base/utf8.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/netcdf_length.h"

namespace thiessen {
namespace {

constexpr const char* get_it_anew = "a copy or a download was cut off: get it anew";

[[noreturn]] void refuse(const std::string& file, std::int64_t size, std::int64_t wanted) {
  throw Error(Message{file, 0,
                      "is cut off: " + std::to_string(size) + " of its " + std::to_string(wanted) +
                          " bytes are there",
                      get_it_anew});
}

std::optional<std::int64_t> size_of(const std::string& name) {
  VSIStatBufL status{};
  if (VSIStatL(name.c_str(), &status) != 0 || VSI_ISREG(status.st_mode) == 0) return std::nullopt;
  return static_cast<std::int64_t>(status.st_size);
}

/// The file in the name of a part of one, as FORMAT:"file":part or FORMAT:file:part; empty where
/// there is none.
std::string file_in_name(std::string name) {
  while (!name.empty() && !size_of(name)) {
    const std::size_t colon = name.find(':');
    std::string after = colon == std::string::npos ? std::string() : name.substr(colon + 1);
    if (after.starts_with('"')) after = after.substr(1, after.find('"', 1) - 1);
    for (std::string before = after; !before.empty() && colon != std::string::npos;) {
      if (size_of(before)) return before;
      const std::size_t last = before.rfind(':');
      before.resize(last == std::string::npos ? 0 : last);
    }
    name = std::move(after);
  }
  return name;
}

/// All files that a raster is made of, the one of its name first.
std::vector<std::string> files_of(GDALDataset& dataset) {
  std::vector<std::string> files;
  const std::string own = file_in_name(dataset.GetDescription());
  if (!own.empty()) files.push_back(own);
  const CPLStringList others(dataset.GetFileList());
  for (int i = 0; i < others.Count(); ++i) {
    if (std::find(files.begin(), files.end(), others[i]) == files.end())
      files.emplace_back(others[i]);
  }
  return files;
}

/// Where the last of a raw band's pixels ends in its file.
std::int64_t end_of_pixels(const RawRasterBand& band, int columns, int rows, int bytes) {
  const auto begin = static_cast<std::int64_t>(band.GetImgOffset());
  const std::int64_t along = static_cast<std::int64_t>(band.GetPixelOffset()) * (columns - 1);
  const std::int64_t down = static_cast<std::int64_t>(band.GetLineOffset()) * (rows - 1);
  return begin + std::max<std::int64_t>(along, 0) + std::max<std::int64_t>(down, 0) + bytes;
}

/// Pixels that lie bare in a file, of whatever format its header is.
void require_raw_pixels(const std::string& file, GDALDataset& dataset) {
  for (GDALRasterBand* const any : dataset.GetBands()) {
    const auto* const band = dynamic_cast<RawRasterBand*>(any);
    // Pixels of less than a byte have offsets of their own.
    if (band == nullptr || any->GetMetadataItem("NBITS", "IMAGE_STRUCTURE") != nullptr) continue;
    VSILFILE* const bytes = band->GetFPL();
    if (bytes == nullptr) continue;
    const vsi_l_offset at = VSIFTellL(bytes);
    VSIFSeekL(bytes, 0, SEEK_END);
    const auto size = static_cast<std::int64_t>(VSIFTellL(bytes));
    VSIFSeekL(bytes, at, SEEK_SET);
    const std::int64_t wanted = end_of_pixels(*band, any->GetXSize(), any->GetYSize(),
                                              GDALGetDataTypeSizeBytes(any->GetRasterDataType()));
    if (size < wanted) refuse(file, size, wanted);
  }
}

/// The number that GDAL tells of a block of a GeoTIFF; 0 where it tells none.
std::int64_t told_of_block(GDALRasterBand& band, const char* what, int across, int down) {
  const std::string item =
      std::string(what) + "_" + std::to_string(across) + "_" + std::to_string(down);
  const char* const told = band.GetMetadataItem(item.c_str(), "TIFF");
  return told == nullptr ? 0 : std::strtoll(told, nullptr, 10);
}

void require_blocks(const std::string& file, GDALDataset& dataset) {
  const std::vector<std::string> files = files_of(dataset);
  const std::optional<std::int64_t> size = files.empty() ? std::nullopt : size_of(files.front());
  if (!size) return;
  for (GDALRasterBand* const band : dataset.GetBands()) {
    int columns = 0;
    int rows = 0;
    band->GetBlockSize(&columns, &rows);
    for (int down = 0; down < (band->GetYSize() + rows - 1) / rows; ++down) {
      throw_if_interrupted();
      for (int across = 0; across < (band->GetXSize() + columns - 1) / columns; ++across) {
        const std::int64_t end = told_of_block(*band, "BLOCK_OFFSET", across, down) +
                                 told_of_block(*band, "BLOCK_SIZE", across, down);
        if (end > *size) refuse(file, *size, end);
      }
    }
  }
}

/// A PCRaster map has its pixels behind a header of 256 bytes.
void require_pixels_of_pcraster(const std::string& file, GDALDataset& dataset) {
  constexpr std::int64_t header = 256;
  GDALRasterBand& band = *dataset.GetRasterBand(1);
  const std::int64_t wanted = header + static_cast<std::int64_t>(band.GetXSize()) *
                                           band.GetYSize() *
                                           GDALGetDataTypeSizeBytes(band.GetRasterDataType());
  const std::optional<std::int64_t> size = size_of(dataset.GetDescription());
  if (size && *size < wanted) refuse(file, *size, wanted);
}

/// Reads a grid of text from its first line on. GDAL finds a line by those before it, and looks
/// for what is not there twice as long with each line that is lacking.
void require_lines(const std::string& file, GDALDataset& dataset) {
  GDALRasterBand& band = *dataset.GetRasterBand(1);
  int columns = 0;
  int rows = 0;
  band.GetBlockSize(&columns, &rows);
  if (columns != band.GetXSize() || rows != 1) return;
  const GdalErrors errors;
  for (int row = 0; row < band.GetYSize(); ++row) {
    throw_if_interrupted();
    GDALRasterBlock* const block =
        band.GetLockedBlockRef(0, row);  // remembered while there is room
    if (block != nullptr) {
      block->DropLock();
      continue;
    }
    throw Error(Message{file, 0,
                        "is cut off or no whole grid: row " + std::to_string(row + 1) + " of its " +
                            std::to_string(band.GetYSize()) + " cannot be read",
                        get_it_anew});
  }
}

bool is_one_of(std::string_view driver, std::span<const std::string_view> drivers) {
  return std::find(drivers.begin(), drivers.end(), driver) != drivers.end();
}

constexpr std::array<std::string_view, 3> grids_by_line = {"AAIGrid", "GRASSASCIIGrid", "ISG"};

/// The files of which a virtual raster is made.
void require_whole_sources(const std::string& file, GDALDataset& dataset) {
  CPLStringList drivers;
  for (const std::string& driver : local_raster_drivers()) drivers.AddString(driver.c_str());
  for (const std::string& source : files_of(dataset)) {
    throw_if_interrupted();
    if (source == file || source == dataset.GetDescription() || !size_of(source)) continue;
    const GdalErrors errors;
    const std::unique_ptr<GDALDataset> opened(GDALDataset::Open(
        source.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers.List(), nullptr, nullptr));
    if (opened) require_whole_raster(source, *opened);
  }
}

}  // namespace

void require_whole_raster(const std::string& file, GDALDataset& dataset) {
  const std::string driver = dataset.GetDriverName();
  if (driver == "VRT") return require_whole_sources(file, dataset);
  if (driver == "netCDF") {
    for (const std::string& part : files_of(dataset)) require_whole_netcdf(part);
  }
  if (driver == "PCRaster") require_pixels_of_pcraster(file, dataset);
  if (driver == "GTiff" || driver == "COG") require_blocks(file, dataset);
  if (is_one_of(driver, grids_by_line)) require_lines(file, dataset);
  require_raw_pixels(file, dataset);
}

std::vector<std::string> texts_of_raster(GDALDataset& dataset) {
  constexpr std::array<std::string_view, 7> grids = {"AAIGrid", "GRASSASCIIGrid", "ISG",    "XYZ",
                                                     "GSAG",    "ZMap",           "RRASTER"};
  constexpr std::array<std::string_view, 5> headers = {".hdr", ".rdc", ".rsc", ".sgrd", ".tfw"};
  std::vector<std::string> texts;
  const std::string_view driver = dataset.GetDriverName();
  for (const std::string& part : files_of(dataset)) {
    const std::string name = lower_case(part);
    const bool is_header = std::any_of(headers.begin(), headers.end(),
                                       [&](std::string_view end) { return name.ends_with(end); });
    const bool is_grid = part == dataset.GetDescription() && is_one_of(driver, grids);
    if (is_header || is_grid) texts.push_back(part);
  }
  return texts;
}

}  // namespace thiessen
