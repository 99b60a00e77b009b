#pragma once

#include <string>

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

  void declare_time(OptionList& options);
  void declare_margin(OptionList& options);
  void declare_look(OptionList& options);
  /// Throws UsageError for options that cannot act on what is shown: a time or units where there is
  /// no RAINFALL, a margin where there are BASINS.
  void check(bool has_rainfall, bool has_basins) const;
  /// Throws UsageError for options of a picture's look: a raster has none.
  void check_raster() const;

 private:
  const Option* margin_option_ = nullptr;
  const Option* units_option_ = nullptr;
  const Option* title_option_ = nullptr;
  const Option* size_option_ = nullptr;
};

}  // namespace thiessen::cli
