#pragma once

#include <cstddef>

#include "cli/options/option_list.h"
#include "rainfall/weighed_rainfall.h"

namespace thiessen::cli {

/// The options that say how steps with silent gauges are treated.
class GapOptions : public OptionBlock {
 public:
  void declare(OptionList& options);
  /// Declares only the option that says how much may be remembered.
  void declare_cache(OptionList& options);
  ArealRainfallSettings settings() const {
    ArealRainfallSettings settings = settings_;
    settings.remembered_bytes = cache_ << 20U;
    return settings;
  }

 private:
  ArealRainfallSettings settings_;
  std::size_t cache_ = 256;  // MB
};

}  // namespace thiessen::cli
