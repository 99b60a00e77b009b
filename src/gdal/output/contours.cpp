#include "gdal/output/contours.h"

#include <cpl_string.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <string>

#include "base/error.h"
#include "base/number.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"

namespace thiessen {
namespace {

std::unique_ptr<GDALDataset> created(const char* driver, int columns, int rows, int bands) {
  GDALDriver* const found = GetGDALDriverManager()->GetDriverByName(driver);
  if (found == nullptr) return nullptr;
  return std::unique_ptr<GDALDataset>(
      found->Create("", columns, rows, bands, bands == 0 ? GDT_Unknown : GDT_Float32, nullptr));
}

std::unique_ptr<GDALDataset> raster_of(const PixelGrid& grid, std::span<const float> values,
                                       const Drawing& drawn, const GdalErrors& errors) {
  auto raster = created("MEM", grid.columns, grid.rows, 1);
  require_drawn(raster != nullptr, drawn, errors);
  const Point corner = grid.at(0, 0);
  double transform[6] = {corner.x, grid.pixel, 0, corner.y, 0, -grid.pixel};
  require_drawn(raster->SetGeoTransform(transform) == CE_None, drawn, errors);
  // GDAL only reads from the buffer, but its interface asks for one that may be written to.
  require_drawn(raster->GetRasterBand(1)->RasterIO(
                    GF_Write, 0, 0, grid.columns, grid.rows, const_cast<float*>(values.data()),
                    grid.columns, grid.rows, GDT_Float32, 0, 0, nullptr) == CE_None,
                drawn, errors);
  return raster;
}

CPLStringList options_of(std::span<const double> levels) {
  std::string wanted;
  for (const double level : levels) wanted += (wanted.empty() ? "" : ",") + shortest_text(level);
  CPLStringList options;
  options.SetNameValue("FIXED_LEVELS", wanted.c_str());
  options.SetNameValue("ELEV_FIELD", "0");
  return options;
}

}  // namespace

void require_drawn(bool done, const Drawing& drawn, const GdalErrors& errors) {
  if (done && !errors.failed()) return;
  throw Error(Message{drawn.path, 0, "GDAL cannot draw " + drawn.noun + ": " + errors.text(), {}});
}

std::unique_ptr<GDALDataset> contours_of(const PixelGrid& grid, std::span<const float> values,
                                         std::span<const double> levels, const Drawing& drawn,
                                         const GdalErrors& errors) {
  start_gdal();
  GDALRegister_MEM();
  RegisterOGRMEM();
  const auto raster = raster_of(grid, values, drawn, errors);
  auto contours = created("Memory", 0, 0, 0);
  require_drawn(contours != nullptr, drawn, errors);
  OGRLayer* const layer = contours->CreateLayer("contours", nullptr, wkbLineString, nullptr);
  require_drawn(layer != nullptr, drawn, errors);
  OGRFieldDefn level("level", OFTReal);
  require_drawn(layer->CreateField(&level) == OGRERR_NONE, drawn, errors);
  require_drawn(GDALContourGenerateEx(GDALRasterBand::ToHandle(raster->GetRasterBand(1)),
                                      OGRLayer::ToHandle(layer), options_of(levels).List(), nullptr,
                                      nullptr) == CE_None,
                drawn, errors);
  return contours;
}

}  // namespace thiessen
