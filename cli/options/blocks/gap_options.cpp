#include "cli/options/blocks/gap_options.h"

#include <string>
#include <utility>
#include <vector>

#include "cli/options/option_values.h"
#include "rainfall/gaps/gap_policies.h"

namespace thiessen::cli {

void GapOptions::declare(OptionList& options) {
  OptionGroup method = options.group("Method", *this);
  std::vector<std::pair<std::string, Gaps>> policies;
  policies.reserve(all_gaps.size());
  for (const Gaps gaps : all_gaps) policies.emplace_back(name_of(gaps), gaps);
  method.add("--gaps", choice<Gaps>(settings_.gaps, std::move(policies)),
             "what a step with silent gauges gets: the cells of the gauges that report (default), "
             "the full network's weights scaled to them, or no value");
  method.add("--min-gauges", whole_number(settings_.min_gauges, 1, 1'000'000'000),
             "leave a value empty where fewer gauges weigh; default 1");
  declare_cache(options);
}

void GapOptions::declare_cache(OptionList& options) {
  options.group("Method", *this)
      .add("--cache", whole_number(cache_, 0, 1'000'000),
           "MB of memory for what silent gauges' neighbours take over; default 256. It changes "
           "no value");
}

}  // namespace thiessen::cli
