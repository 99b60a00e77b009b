#include "gdal/output/image_file.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "base/error.h"
#include "base/interrupt.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/output/memory_files.h"

namespace thiessen {
namespace {

[[noreturn]] void refuse(const GdalErrors& errors) {
  throw_if_interrupted();
  throw Error(Message{{}, 0, "the picture could not be encoded: " + errors.text(), {}});
}

GDALDriver& driver_of(const char* name, const GdalErrors& errors) {
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName(name);
  if (driver == nullptr) refuse(errors);
  return *driver;
}

int goes_on(double, const char*, void*) {
  return interrupt_signal() == 0 ? TRUE : FALSE;
}

/// A dataset of three bands, red first, that lie where the pixels are.
std::unique_ptr<GDALDataset> dataset_of(const Pixels& pixels, const GdalErrors& errors) {
  constexpr int channels = 3;
  std::unique_ptr<GDALDataset> dataset(
      driver_of("MEM", errors).Create("", pixels.width, pixels.height, 0, GDT_Byte, nullptr));
  if (dataset == nullptr) refuse(errors);
  for (int channel = channels - 1; channel >= 0; --channel) {
    std::array<char, 32> address{};
    // GDAL only reads from there, but its interface asks for what may be written to.
    const auto* const first = pixels.bytes.data() + channel;
    CPLPrintPointer(address.data(), const_cast<std::uint8_t*>(first),
                    static_cast<int>(address.size()) - 1);
    CPLStringList options;
    options.SetNameValue("DATAPOINTER", address.data());
    options.SetNameValue("PIXELOFFSET", std::to_string(channels).c_str());
    options.SetNameValue("LINEOFFSET", std::to_string(channels * pixels.width).c_str());
    if (dataset->AddBand(GDT_Byte, options.List()) != CE_None) refuse(errors);
  }
  return dataset;
}

}  // namespace

std::vector<unsigned char> image_file(const Pixels& pixels, ImageFormat format) {
  start_gdal();
  GDALRegister_MEM();
  const bool png = format == ImageFormat::png;
  png ? GDALRegister_PNG() : GDALRegister_JPEG();
  const GdalErrors errors;
  const MemoryFolder folder(png ? "picture.png" : "picture.jpg");
  CPLStringList options;
  png ? options.SetNameValue("ZLEVEL", "6") : options.SetNameValue("QUALITY", "93");
  const std::unique_ptr<GDALDataset> from = dataset_of(pixels, errors);
  const std::unique_ptr<GDALDataset> written(
      driver_of(png ? "PNG" : "JPEG", errors)
          .CreateCopy(folder.file().c_str(), from.get(), FALSE, options.List(), goes_on, nullptr));
  if (written == nullptr || errors.failed()) refuse(errors);
  const std::string bytes = folder.take().front().bytes;
  return {bytes.begin(), bytes.end()};
}

}  // namespace thiessen
