#include "cli/options/output_options.h"

#include "cli/options/option_values.h"

namespace thiessen::cli {

void OutputOptions::declare(OptionList& options, Need need, const std::string& kind,
                            const std::string& help) {
  declare_value(options, need, file(output, kind), help);
}

void OutputOptions::declare_folder(OptionList& options, const std::string& help) {
  declare_value(options, Need::required, folder(output, "DIR"), help);
}

void OutputOptions::declare_value(OptionList& options, Need need, OptionValue value,
                                  const std::string& help) {
  OptionGroup group = options.group("Output", *this);
  group.add("-o,--output", std::move(value), help).need = need;
  group.add("--overwrite", flag(overwrite_),
            "replace an output that exists; else that is an error");
}

}  // namespace thiessen::cli
