#pragma once

#include <string>

#include "cli/options/colour_options.h"
#include "cli/options/option_list.h"
#include "cli/options/option_values.h"

namespace thiessen::cli {

/// The options that say which step a picture or the cells show, and how a picture looks.
class ViewOptions : public OptionBlock {
 public:
  std::string time;
  double margin = 10;
  std::string units = "mm";
  std::string title;
  PixelSize size;
  std::size_t dpi = 0;  ///< 0: none is said
  ColourOptions colours;

  void declare_time(OptionList& options);
  void declare_margin(OptionList& options);
  void declare_look(OptionList& options);
  /// The picture's size in pixels: as given, or in millimetres by the density. A height of 0 is
  /// chosen by the study area's shape.
  int width() const;
  int height() const;
  /// What the picture tells a printer; 0: nothing. A size in millimetres has 300 unless told.
  int dots_to_the_inch() const;
  bool are_units_given() const { return units_option_ != nullptr && units_option_->is_given(); }
  /// Throws UsageError for options that cannot act on what is shown: a time, units or colours where
  /// there is no RAINFALL, a margin where there are BASINS; and for a size in millimetres that
  /// takes too few or too many pixels.
  void check(bool has_rainfall, bool has_basins) const;
  /// Throws UsageError for options of a picture's look: a raster has none.
  void check_raster() const;

 private:
  int pixels(std::size_t side) const;
  void check_size() const;

  const Option* margin_option_ = nullptr;
  const Option* units_option_ = nullptr;
  const Option* title_option_ = nullptr;
  const Option* size_option_ = nullptr;
  const Option* dpi_option_ = nullptr;
};

}  // namespace thiessen::cli
