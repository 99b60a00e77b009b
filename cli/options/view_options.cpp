#include "cli/options/view_options.h"

#include "cli/options/usage_error.h"
#include "study/study.h"

namespace thiessen::cli {

void ViewOptions::declare_time(OptionList& options) {
  options.group("Readings", *this)
      .add("--time", text(time, "TIME"),
           "show this step; default each gauge's mean over the steps it reports");
}

void ViewOptions::declare_margin(OptionList& options) {
  options.group("Method", *this)
      .add("--margin", number(margin, {margins.low, margins.high, "percent from 0 to 1000"}),
           "without BASINS: how far the study area reaches beyond the stations, in percent of "
           "their extent's larger side; default 10");
}

void ViewOptions::declare_look(OptionList& options) {
  OptionGroup picture = options.group("Picture", *this);
  picture.add("--units", any_text(units, "U"), "what the readings are in; default mm");
  picture.add("--title", any_text(title, "T"), "what stands over the picture");
  picture.add("--size", pixel_size(size), "the picture's pixels; default 1600 wide");
}

void ViewOptions::check(bool has_rainfall) const {
  if (!has_rainfall && !time.empty()) throw UsageError{"--time needs RAINFALL", ""};
}

}  // namespace thiessen::cli
