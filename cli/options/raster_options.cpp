#include "cli/options/raster_options.h"

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
}

void RasterOptions::check_picture() const {
  const Option* const given = first_given();
  if (given == nullptr) return;
  throw UsageError{given->name + " is of a raster, and a picture is written",
                   given->name == "--resolution" ? "--size gives its pixels; a .tif is a raster"
                                                 : "a .tif is a raster"};
}

}  // namespace thiessen::cli
