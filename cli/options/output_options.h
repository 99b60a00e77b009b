#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/destination.h"
#include "cli/options/option_list.h"

namespace thiessen::cli {

/// Where results go.
class OutputOptions : public OptionBlock {
 public:
  std::string output = "-";

  /// `kind` is what the output is called in the help, such as `map.png`.
  void declare(OptionList& options, Need need, const std::string& kind, const std::string& help);
  /// The same where the output is a folder.
  void declare_folder(OptionList& options, const std::string& help);
  /// `inputs` are files that may not be written.
  OutputRules rules(std::vector<std::string> inputs) const {
    return {overwrite_, std::move(inputs)};
  }

 private:
  void declare_value(OptionList& options, Need need, OptionValue value, const std::string& help);

  bool overwrite_ = false;
};

}  // namespace thiessen::cli
