#include "gdal/rasters/raster_wholeness.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/temporary_folder.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/rasters/raster_source.h"

namespace thiessen {
namespace {

constexpr int columns = 12;
constexpr int rows = 9;

struct Format {
  const char* driver;
  const char* name;   ///< of the file that is opened
  const char* bytes;  ///< the file that holds the pixels
  GDALDataType type;
  const char* option = nullptr;
};

/// Formats of pixels that lie bare, of blocks, of lines and of records.
constexpr Format formats[] = {
    {"ENVI", "f.envi", "f.envi", GDT_Float32},
    {"EHdr", "f.bil", "f.bil", GDT_Int16},
    {"EHdr", "f.flt", "f.flt", GDT_Float32},
    {"RRASTER", "f.grd", "f.gri", GDT_Float32},
    {"SAGA", "f.sdat", "f.sdat", GDT_Float32},
    {"RST", "f.rst", "f.rst", GDT_Float32},
    {"ROI_PAC", "f.dem", "f.dem", GDT_Int16},
    {"ISCE", "f.isce", "f.isce", GDT_Float32},
    {"BT", "f.bt", "f.bt", GDT_Float32},
    {"GTX", "f.gtx", "f.gtx", GDT_Float32},
    {"PCRaster", "f.map", "f.map", GDT_Float32},
    {"GSBG", "f.grd", "f.grd", GDT_Float32},
    {"GS7BG", "f.grd", "f.grd", GDT_Float64},
    {"AAIGrid", "f.asc", "f.asc", GDT_Int32},
    {"GTiff", "f.tif", "f.tif", GDT_Float32},
    {"GTiff", "f.tif", "f.tif", GDT_Float32, "TILED=YES"},
    {"GTiff", "f.tif", "f.tif", GDT_Float32, "COMPRESS=DEFLATE"},
    {"netCDF", "f.nc", "f.nc", GDT_Float32},
    {"netCDF", "f.nc", "f.nc", GDT_Float32, "FORMAT=NC2"},
    {"netCDF", "f.nc", "f.nc", GDT_Float32, "FORMAT=NC4"},
    {"HFA", "f.img", "f.img", GDT_Float32},
    {"PCIDSK", "f.pix", "f.pix", GDT_Float32},
};

/// Writes a raster whose pixels are 100 to 207; nothing where this GDAL cannot.
bool write(const Format& format, const std::string& file) {
  register_local_drivers();
  const GdalErrors errors;
  GDALDriverManager& drivers = *GetGDALDriverManager();
  GDALDriver* const driver = drivers.GetDriverByName(format.driver);
  if (driver == nullptr) return false;
  const GDALDatasetUniquePtr source(
      drivers.GetDriverByName("MEM")->Create("", columns, rows, 1, format.type, nullptr));
  double transform[] = {10, 0.5, 0, 50, 0, -0.5};
  source->SetGeoTransform(transform);
  OGRSpatialReference degrees;
  degrees.SetWellKnownGeogCS("WGS84");
  source->SetSpatialRef(&degrees);
  std::vector<double> pixels;
  for (int i = 0; i < columns * rows; ++i) pixels.push_back(100 + i);
  if (source->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, columns, rows, pixels.data(), columns,
                                         rows, GDT_Float64, 0, 0, nullptr) != CE_None)
    return false;
  CPLStringList options;
  if (format.option != nullptr) options.AddString(format.option);
  return GDALDatasetUniquePtr(driver->CreateCopy(file.c_str(), source.get(), FALSE, options.List(),
                                                 nullptr, nullptr)) != nullptr;
}

/// Its pixels; nothing where it is refused.
std::optional<std::vector<double>> read(const std::string& file) {
  try {
    const RasterSource source(file);
    WindowValues values(columns, rows, 1, true);
    source.read({0, 0, columns, rows}, values, 0);
    std::vector<double> pixels;
    for (std::size_t i = 0; i < static_cast<std::size_t>(columns * rows); ++i)
      pixels.push_back(values.at(0, i / columns, i % columns));
    return pixels;
  } catch (const Error&) {
    return std::nullopt;
  }
}

TEST(RasterWholeness, is_missed_wherever_the_pixels_are_cut_off) {
  std::size_t written = 0;
  for (const Format& format : formats) {
    const TemporaryFolder folder;
    const std::string file = folder.path(format.name);
    if (!write(format, file)) continue;
    const auto whole = read(file);
    if (!whole) continue;  // some drivers only write
    ++written;
    const std::string bytes = folder.read(format.bytes);
    constexpr std::size_t lengths = 12;  // evenly, and the last three
    for (std::size_t i = 0; i < lengths + 3; ++i) {
      const std::size_t length =
          i < lengths ? bytes.size() * i / lengths : bytes.size() - (lengths + 3 - i);
      folder.write(format.bytes, bytes.substr(0, length));
      const auto cut = read(file);
      // Digits of the last number may be lost, of which the notice is; bytes that fill up, too.
      const bool is_last = length + 4 >= bytes.size();
      if (cut && *cut != *whole && !(is_last && std::string_view(format.driver) == "AAIGrid")) {
        ADD_FAILURE() << format.driver << " " << (format.option == nullptr ? "" : format.option)
                      << " cut at " << length << " of " << bytes.size() << " is read in silence";
        break;
      }
    }
  }
  EXPECT_GE(written, 12u);
}

/// What is said of a file; empty where it is whole.
std::string fault_of(const std::string& file) {
  try {
    const RasterSource source(file);
  } catch (const Error& error) {
    return error.messages().front().sentence();
  }
  return {};
}

// A raster of which a study needs the upper part alone is refused all the same.
TEST(RasterWholeness, is_told_in_bytes_and_in_rows) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write({"ENVI", "f.envi", "f.envi", GDT_Float32}, folder.path("f.envi")));
  const std::string envi = folder.write("f.envi", folder.read("f.envi").substr(0, 431));
  EXPECT_EQ(fault_of(envi), envi + ": is cut off: 431 of its 432 bytes are there");
  ASSERT_TRUE(write({"GTiff", "f.tif", "f.tif", GDT_Float32}, folder.path("f.tif")));
  const std::string tiff = folder.read("f.tif");
  const std::string cut = folder.write("f.tif", tiff.substr(0, tiff.size() - 1));
  EXPECT_EQ(fault_of(cut), cut + ": is cut off: " + std::to_string(tiff.size() - 1) + " of its " +
                               std::to_string(tiff.size()) + " bytes are there");
  const std::string grid =
      folder.write("g.asc", "ncols 2\nnrows 4\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n5");
  EXPECT_EQ(fault_of(grid), grid + ": is cut off or no whole grid: row 3 of its 4 cannot be read");
}

// Line after line, for GDAL looks for one that lacks twice as long with each that is lacking.
TEST(RasterWholeness, of_a_grid_of_many_lines_is_missed_at_once) {
  const TemporaryFolder folder;
  std::string text = "ncols 3\nnrows 500\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int i = 0; i < 3 * 250; ++i) text += std::to_string(i) + (i % 3 == 2 ? "\n" : " ");
  const std::string grid = folder.write("g.asc", text);
  EXPECT_EQ(fault_of(grid),
            grid + ": is cut off or no whole grid: row 251 of its 500 cannot be read");
}

TEST(RasterWholeness, of_a_virtual_raster_is_that_of_its_files) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write({"ENVI", "f.envi", "f.envi", GDT_Float32}, folder.path("f.envi")));
  const std::string file = folder.write(
      "v.vrt",
      "<VRTDataset rasterXSize=\"12\" rasterYSize=\"9\"><GeoTransform>0,1,0,0,0,-1</GeoTransform>"
      "<VRTRasterBand dataType=\"Float32\" band=\"1\">"
      "<SimpleSource><SourceFilename relativeToVRT=\"1\">f.envi</SourceFilename>"
      "<SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>");
  EXPECT_EQ(fault_of(file), "");
  folder.write("f.envi", folder.read("f.envi").substr(0, 300));
  EXPECT_EQ(fault_of(file), folder.path("f.envi") + ": is cut off: 300 of its 432 bytes are there");
}

TEST(RasterWholeness, is_asked_of_the_file_in_the_name_of_a_part) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write({"netCDF", "f.nc", "f.nc", GDT_Float32}, folder.path("f.nc")));
  const std::string whole = folder.read("f.nc");
  const std::string name = "NETCDF:\"" + folder.path("f.nc") + "\":Band1";
  EXPECT_EQ(fault_of(name), "");
  folder.write("f.nc", whole.substr(0, whole.size() - 8));
  EXPECT_NE(fault_of(name).find("is cut off: "), std::string::npos) << fault_of(name);
}

TEST(RasterWholeness, texts_of_a_raster_are_its_header_and_a_grid_of_lines) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write({"ENVI", "f.envi", "f.envi", GDT_Float32}, folder.path("f.envi")));
  EXPECT_EQ(RasterSource(folder.path("f.envi")).texts(),
            std::vector<std::string>{folder.path("f.hdr")});
  ASSERT_TRUE(write({"GTiff", "f.tif", "f.tif", GDT_Float32}, folder.path("f.tif")));
  EXPECT_TRUE(RasterSource(folder.path("f.tif")).texts().empty());
  ASSERT_TRUE(write({"AAIGrid", "g.asc", "g.asc", GDT_Int32}, folder.path("g.asc")));
  EXPECT_EQ(RasterSource(folder.path("g.asc")).texts(),
            std::vector<std::string>{folder.path("g.asc")});
}

}  // namespace
}  // namespace thiessen
