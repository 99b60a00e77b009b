#pragma once

#include <cstddef>
#include <vector>

#include "cli/options/option_list.h"
#include "rainfall/methods/rain_methods.h"

namespace thiessen::cli {

/// Which method, or methods, and what they need to know.
class MethodOptions : public OptionBlock {
 public:
  void declare(OptionList& options);
  /// Throws UsageError for options that contradict each other.
  void check() const;
  /// The methods chosen, in the order of their columns.
  const std::vector<RainMethod>& methods() const { return methods_; }
  /// The number of points in a basin over which a method averages.
  std::size_t points() const { return points_; }

 private:
  std::vector<RainMethod> methods_{RainMethod::thiessen};
  std::size_t points_ = 2000;
  const Option* points_option_ = nullptr;
};

}  // namespace thiessen::cli
