#include "cli/options/rain_format_options.h"

#include "cli/options/option_values.h"

namespace thiessen::cli {

void RainFormatOptions::declare(OptionList& options) {
  OptionGroup output = options.group("Output", *this);
  output.add("--long", flag(long_),
             "rows time,basin,rainfall,gauges,coverage instead of a column a basin");
  output.add("--decimals", whole_number(decimals_, 0, 15), "decimals of rainfall; default 3");
}

}  // namespace thiessen::cli
