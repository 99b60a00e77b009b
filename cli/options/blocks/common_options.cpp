#include "cli/options/blocks/common_options.h"

#include "base/parallel.h"
#include "cli/options/option_values.h"
#include "cli/options/study_file.h"

namespace thiessen::cli {

CommonOptions::CommonOptions() : threads(available_threads()) {}

void CommonOptions::declare(OptionList& options) {
  OptionGroup general = options.group(general_group, *this);
  general.add("--threads", whole_number(threads, 1, 1024),
              "on how many cores; default all; the output does not depend on it");
  general.add(study_file_option, file(study_file_, "FILE"),
              "further options from this file (TOML, name = value; run writes one, study.toml); "
              "those on the command line win, and its relative names of files count from its "
              "folder");
  general.add("-q,--quiet", flag(quiet), "no warnings, no summary");
}

}  // namespace thiessen::cli
