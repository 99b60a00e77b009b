#include "cli/options/method_options.h"

#include <algorithm>
#include <string>
#include <utility>

#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

void MethodOptions::declare(OptionList& options) {
  using Methods = std::vector<RainMethod>;
  std::vector<std::pair<std::string, Methods>> choices;
  choices.reserve(all_methods.size() + 1);
  for (const RainMethod method : all_methods)
    choices.emplace_back(name_of(method), Methods{method});
  choices.emplace_back("all", Methods{all_methods.begin(), all_methods.end()});
  OptionGroup group = options.group("Method", *this);
  group.add("--method", choice<Methods>(methods_, std::move(choices)),
            "the cells (default), the mean of the gauges inside, inverse distance squared of the "
            "12 nearest, natural neighbours (outside the gauges' hull the nearest gauge), or a "
            "column for each, BASIN_thiessen and so on; with --long rows with a column method");
  points_option_ = &group.add(
      "--grid", whole_number(points_, 1, 100'000),
      "over how many points of a basin idw and natural are averaged, to 100000; default 2000");
}

void MethodOptions::check() const {
  if (points_option_->is_given() &&
      std::none_of(methods_.begin(), methods_.end(), averages_points)) {
    throw UsageError{"--grid is about --method idw, natural or all", "leave it out"};
  }
}

}  // namespace thiessen::cli
