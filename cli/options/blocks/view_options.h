#pragma once

#include <string>
#include <vector>

#include "cli/options/blocks/colour_options.h"
#include "cli/options/option_list.h"
#include "cli/options/picture_size.h"

namespace thiessen::cli {

/// The options that say which step a picture or the cells show, and how a picture looks.
class ViewOptions : public OptionBlock, public PictureSize {
 public:
  std::vector<std::string> times;
  double margin = 10;
  std::string units = "mm";
  std::string title;
  ColourOptions colours;

  /// Declares --time for what shows one step.
  void declare_time(OptionList& options);
  /// Declares --time for what may show several: each time adds one, and none may come twice.
  void declare_times(OptionList& options);
  void declare_margin(OptionList& options);
  void declare_look(OptionList& options);
  /// The only step that is shown, or the first of several; empty: means.
  std::string time() const { return times.empty() ? std::string() : times.front(); }
  bool are_units_given() const { return units_option_ != nullptr && units_option_->is_given(); }
  /// Throws UsageError for options that cannot act on what is shown: a time, units or colours where
  /// there is no RAINFALL, a margin where there are BASINS; and for a size in millimetres that
  /// takes too few or too many pixels.
  void check(bool has_rainfall, bool has_basins) const;
  /// Throws UsageError for options of a picture's look that a raster lacks; a NetCDF has no colours
  /// either.
  void check_raster(bool is_netcdf) const;

 private:
  const Option* margin_option_ = nullptr;
  const Option* units_option_ = nullptr;
  const Option* title_option_ = nullptr;
  const Option* size_option_ = nullptr;
  const Option* dpi_option_ = nullptr;
};

}  // namespace thiessen::cli
