#include "cli/options/blocks/view_options.h"

#include <algorithm>
#include <utility>

#include "base/utf8.h"
#include "cli/options/usage_error.h"
#include "map/sheet/picture.h"
#include "study/study.h"

namespace thiessen::cli {
namespace {

/// The time of a step, as RAINFALL writes it.
OptionValue step_time(std::vector<std::string>& times) {
  OptionValue value;
  value.kind = "TIME";
  value.read = [&times](const std::string& text) {
    if (text.empty()) throw WrongValue{"is empty"};
    if (std::find(times.begin(), times.end(), text) != times.end())
      throw WrongValue{"names " + quoted(text, 80) + " twice"};
    times.push_back(text);
  };
  return value;
}

}  // namespace

void ViewOptions::declare_time(OptionList& options) {
  options.group("Readings", *this)
      .add("--time", step_time(times),
           "show this step; default each gauge's mean over the steps it reports");
}

void ViewOptions::declare_times(OptionList& options) {
  OptionValue value = step_time(times);
  value.may_be_repeated = true;
  options.group("Readings", *this)
      .add("--time", std::move(value),
           "show this step; default each gauge's mean over the steps it reports. Repeated: a "
           "picture of several steps, one map each, with one scale and one legend");
}

void ViewOptions::declare_margin(OptionList& options) {
  margin_option_ =
      &options.group("Method", *this)
           .add("--margin", number(margin, {margins.low, margins.high, "percent from 0 to 1000"}),
                "without BASINS: how far the study area reaches beyond the stations, in percent of "
                "their extent's larger side; default 10");
}

void ViewOptions::declare_look(OptionList& options) {
  OptionGroup picture = options.group("Picture", *this);
  units_option_ = &picture.add("--units", any_text(units, "U"),
                               "what the readings are in where nothing else says it; default mm");
  title_option_ = &picture.add("--title", any_text(title, "T"), "what stands over the picture");
  size_option_ =
      &picture.add("--size", pixel_size(size),
                   "the picture's pixels, or its size on paper (297x210mm); default 1600 wide");
  dpi_option_ =
      &picture.add("--dpi", whole_number(dpi, 1, max_dots_to_the_inch),
                   "dots to the inch, which the picture tells a printer; default: none, or 300 for "
                   "a size in mm");
  colours.declare(options);
}

void ViewOptions::check(bool has_rainfall, bool has_basins) const {
  check_size();
  const auto is_given = [](const Option* option) {
    return option != nullptr && option->is_given();
  };
  if (!has_rainfall && !times.empty()) throw UsageError{"--time needs RAINFALL", ""};
  if (!has_rainfall && is_given(units_option_)) {
    throw UsageError{"--units is about readings, and there is no RAINFALL",
                     "give RAINFALL, or leave it out"};
  }
  colours.check(has_rainfall);
  if (has_basins && is_given(margin_option_)) {
    throw UsageError{"--margin is of a study area without BASINS, and they are given",
                     "leave one of them out"};
  }
}

void ViewOptions::check_raster(bool is_netcdf) const {
  const Option* const colour = colours.first_given();
  if (is_netcdf && colour != nullptr) {
    throw UsageError{colour->name + " is about colours, and a .nc has none",
                     "a .tif has its colours beside it"};
  }
  for (const Option* option : {title_option_, size_option_, dpi_option_}) {
    if (option == nullptr || !option->is_given()) continue;
    throw UsageError{
        option->name + " is about pictures, and a .tif is a raster",
        option == size_option_ ? "--resolution gives the size of its pixels" : "leave it out"};
  }
}

}  // namespace thiessen::cli
