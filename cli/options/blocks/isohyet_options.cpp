#include "cli/options/blocks/isohyet_options.h"

#include <string>
#include <utility>

#include "base/utf8.h"
#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"
#include "rainfall/methods/rain_methods.h"

namespace thiessen::cli {
namespace {

OptionValue surface_value(std::optional<SurfaceMethod>& target) {
  std::vector<std::pair<std::string, std::optional<SurfaceMethod>>> surfaces{
      {name_of(RainMethod::thiessen), std::nullopt}};
  for (const SurfaceMethod method :
       {SurfaceMethod::idw, SurfaceMethod::natural, SurfaceMethod::linear})
    surfaces.emplace_back(name_of(method), method);
  return choice<std::optional<SurfaceMethod>>(target, std::move(surfaces));
}

/// Numbers with commas between them, each larger than the one before.
OptionValue rising_numbers(std::vector<double>& target) {
  OptionValue value;
  value.kind = "A,B,...";
  value.read = [&target](const std::string& text) {
    auto numbers = rising_numbers_in(text);
    if (!numbers) {
      throw WrongValue{"is not a list of rising numbers such as 10,20,50, but " + quoted(text, 80)};
    }
    target = *std::move(numbers);
  };
  return value;
}

}  // namespace

void IsohyetOptions::declare_map(OptionList& options) {
  OptionGroup method = options.group("Method", *this);
  method_option_ = &method.add(
      "--method", surface_value(surface_),
      "the surface that is shown: the cells (default), inverse distance squared of the 12 "
      "nearest gauges, natural neighbours, or linear in triangles of gauges; beyond the "
      "gauges' hull natural and linear take the nearest gauge");
  OptionGroup picture = options.group("Picture", *this);
  isohyets_option_ =
      &picture.add("--isohyets", flag(on_map),
                   "draw lines of equal rainfall over the picture, of natural neighbours or of "
                   "--method's surface, where the classes of colour meet or at --interval");
  interval_option_ = &picture.add("--interval", number(interval, above_zero),
                                  "the step between isohyets' levels, which are its multiples; "
                                  "default the bounds of the classes");
}

void IsohyetOptions::declare(OptionList& options) {
  surface_ = SurfaceMethod::natural;
  OptionGroup method = options.group("Method", *this);
  method.add("--method", surface_value(surface_),
             "the surface whose lines they are: natural neighbours (default), linear in triangles "
             "of gauges, or inverse distance squared of the 12 nearest; the first two have none "
             "beyond the gauges' hull, and cells have none at all");
  interval_option_ =
      &method.add("--interval", number(interval, above_zero),
                  "the step between levels, which are its multiples; default the bounds of the "
                  "classes that a picture of the surface has");
  breaks_option_ = &method.add("--breaks", rising_numbers(breaks), "the levels themselves");
}

void IsohyetOptions::declare_study(OptionList& options) {
  interval_option_ = &options.group("Method", *this)
                          .add("--interval", number(interval, above_zero),
                               "the study in one file has isohyets too, of natural neighbours, at "
                               "the multiples of this");
}

void IsohyetOptions::check() const {
  if (!surface_) {
    throw UsageError{"cells have no isohyets: rainfall jumps from one to the next",
                     "--method natural, linear or idw has some"};
  }
  if (interval_option_->is_given() && breaks_option_->is_given()) {
    throw UsageError{"--interval and --breaks both say the levels", "leave one of them out"};
  }
}

void IsohyetOptions::check_map(bool has_rainfall, bool is_picture) const {
  if (surface_ && !has_rainfall)
    throw UsageError{"--method is about rainfall between gauges, and there is no RAINFALL", ""};
  for (const Option* const option : {isohyets_option_, interval_option_}) {
    if (!option->is_given()) continue;
    if (!is_picture) {
      throw UsageError{option->name + " is about pictures, and a raster is written",
                       "thiessen isohyets writes the lines"};
    }
    if (!has_rainfall)
      throw UsageError{option->name + " is about rainfall, and there is no RAINFALL", ""};
  }
  if (interval_option_->is_given() && !on_map)
    throw UsageError{"--interval is the step between isohyets, and none are drawn",
                     "--isohyets draws them"};
}

}  // namespace thiessen::cli
