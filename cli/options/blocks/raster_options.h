#pragma once

#include "cli/options/option_list.h"
#include "gdal/rasters/raster_output.h"

namespace thiessen::cli {

/// The options of a raster: its pixels, and how they are stored.
class RasterOptions : public OptionBlock {
 public:
  double resolution = 0;
  Compression compression = Compression::deflate;
  bool has_overviews = false;
  bool of_steps = false;

  void declare(OptionList& options);
  /// Throws UsageError for any of them, because a picture is written.
  void check_picture() const;
  /// Throws UsageError for those that a NetCDF does not have.
  void check_netcdf() const;
};

}  // namespace thiessen::cli
