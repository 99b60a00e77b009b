#pragma once

#include <cstddef>

#include "cli/options/option_list.h"

namespace thiessen::cli {

/// The options of every command that computes.
class CommonOptions : public OptionBlock {
 public:
  std::size_t threads;
  bool quiet = false;

  CommonOptions();
  void declare(OptionList& options);
};

}  // namespace thiessen::cli
