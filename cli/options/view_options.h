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
  /// Throws UsageError for a time where there is no RAINFALL.
  void check(bool has_rainfall) const;
};

}  // namespace thiessen::cli
