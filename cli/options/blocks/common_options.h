#pragma once

#include <cstddef>
#include <string>

#include "cli/options/option_list.h"

namespace thiessen::cli {

/// The options of every command that computes.
class CommonOptions : public OptionBlock {
 public:
  std::size_t threads;
  bool quiet = false;

  CommonOptions();
  void declare(OptionList& options);

 private:
  std::string study_file_;  ///< what it says stands in the options when they have been read
};

}  // namespace thiessen::cli
