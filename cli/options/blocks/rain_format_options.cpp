#include "cli/options/blocks/rain_format_options.h"

#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

void RainFormatOptions::declare(OptionList& options) {
  OptionGroup output = options.group("Output", *this);
  output.add("--long", flag(long_),
             "rows time,basin,rainfall,gauges,coverage instead of a column a basin");
  output.add("--decimals", whole_number(decimals_, 0, 15), "decimals of rainfall; default 3");
  output.add("--iso-times", flag(iso_times_),
             "write times as ISO 8601 has them, instead of as they came");
}

void RainFormatOptions::check(bool has_totals) const {
  if (!iso_times_ || !has_totals) return;
  throw UsageError{"--iso-times is about the times of steps, and --every writes periods",
                   "these are of ISO 8601 anyway; leave it out"};
}

}  // namespace thiessen::cli
