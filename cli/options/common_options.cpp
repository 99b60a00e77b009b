#include "cli/options/common_options.h"

#include "base/parallel.h"
#include "cli/options/option_values.h"

namespace thiessen::cli {

CommonOptions::CommonOptions() : threads(available_threads()) {}

void CommonOptions::declare(OptionList& options) {
  OptionGroup general = options.group(general_group, *this);
  general.add("--threads", whole_number(threads, 1, 1024),
              "on how many cores; default all; the output does not depend on it");
  general.add("-q,--quiet", flag(quiet), "no warnings, no summary");
}

}  // namespace thiessen::cli
