#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "gdal/crs/crs.h"
#include "geometry/pixel_grid.h"
#include "results/provenance.h"

namespace thiessen {

/// How the bytes of a raster are made smaller.
enum class Compression : std::uint8_t { deflate, zstd, none };

/// What a raster is, but for its pixels: where it lies, what it says of itself, how it is stored.
struct RasterOutput {
  PixelGrid grid;
  std::optional<Crs> crs;
  Provenance made_by;
  std::string path;  ///< where it is to lie in the end
  /// The file in which a GeoTIFF is written on the disk meanwhile, in a folder of its own. It is
  /// empty where the GeoTIFF is made in memory, for a pipe or a device.
  std::string file_on_disk{};
  Compression compression = Compression::deflate;
  bool has_overviews = false;  ///< whether it holds smaller copies of itself, for viewers
  unsigned threads = 1;
};

/// What a band of rainfall says of itself.
struct BandText {
  std::string description;  ///< the time as RAINFALL writes it, or which means the values are
  std::string time;         ///< the time once more; empty where the values are not of one time
  std::string unit;         ///< of the values
};

}  // namespace thiessen
