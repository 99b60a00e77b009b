#include "cli/options/blocks/raster_options.h"

#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

void RasterOptions::declare(OptionList& options) {
  OptionGroup raster = options.group("Raster", *this);
  raster.add("--resolution", number(resolution, above_zero),
             "the raster's pixel in units of its CRS; default: the longer side in 2000 pixels");
  raster.add("--compress",
             choice<Compression>(compression, {{"deflate", Compression::deflate},
                                               {"zstd", Compression::zstd},
                                               {"none", Compression::none}}),
             "how a raster is made smaller; zstd is for programs that know it; default deflate");
  raster.add("--overviews", flag(has_overviews),
             "smaller copies within a .tif, by which viewers show large ones at once");
  raster.add("--steps", flag(of_steps),
             "a raster a time step, in the tessellation of the gauges that report then: the bands "
             "of a .tif, or of a .nc (NetCDF by CF-1.8) the dimension time");
}

void RasterOptions::check_netcdf() const {
  if (!of_steps) {
    throw UsageError{"a .nc is a grid of time steps", "--steps writes it; a .tif holds one raster"};
  }
  if (compression == Compression::zstd) {
    throw UsageError{"few programs read a NetCDF that is compressed by ZSTD",
                     "--compress deflate is read by all"};
  }
  if (has_overviews)
    throw UsageError{"--overviews are of a .tif, and a .nc is written", "leave it out"};
}

void RasterOptions::check_picture() const {
  const Option* const given = first_given();
  if (given == nullptr) return;
  throw UsageError{given->name + " is of a raster, and a picture is written",
                   given->name == "--resolution" ? "--size gives its pixels; a .tif is a raster"
                                                 : "a .tif is a raster"};
}

}  // namespace thiessen::cli
