#include "cli/options/isohyet_options.h"

#include <string>
#include <utility>

#include "base/utf8.h"
#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {
namespace {

OptionValue surface_value(std::optional<SurfaceMethod>& target) {
  return choice<std::optional<SurfaceMethod>>(target, {{"thiessen", std::nullopt},
                                                       {"idw", SurfaceMethod::idw},
                                                       {"natural", SurfaceMethod::natural},
                                                       {"linear", SurfaceMethod::linear}});
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

void IsohyetOptions::declare_surface(OptionList& options) {
  options.group("Method", *this)
      .add("--method", surface_value(surface_),
           "the surface that a .tif shows: the cells (default), inverse distance squared of the 12 "
           "nearest gauges, natural neighbours, or linear in triangles of gauges; beyond the "
           "gauges' hull natural and linear take the nearest gauge");
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
                  "the step between levels, which are its multiples; default a rounded one that "
                  "makes about eight");
  breaks_option_ = &method.add("--breaks", rising_numbers(breaks), "the levels themselves");
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

}  // namespace thiessen::cli
