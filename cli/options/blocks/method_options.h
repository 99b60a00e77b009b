#pragma once

#include <vector>

#include "cli/options/blocks/gap_options.h"
#include "cli/options/option_list.h"
#include "rainfall/methods/rain_methods.h"

namespace thiessen::cli {

/// Which method, or methods, and what they need to know.
class MethodOptions : public OptionBlock {
 public:
  void declare(OptionList& options);
  /// Throws UsageError for options that contradict each other.
  void check() const;
  /// Throws UsageError for a gap policy that a method cannot have.
  void check(const GapOptions& gaps) const;
  /// Throws UsageError for methods that have no standard errors, where these are wanted.
  void check_errors() const;
  /// The methods chosen, in the order of their columns.
  const std::vector<RainMethod>& methods() const { return methods_; }
  bool has_isohyets() const;
  const PointSettings& points() const { return points_; }

 private:
  std::vector<RainMethod> methods_{RainMethod::thiessen};
  PointSettings points_;
  const Option* points_option_ = nullptr;
  const Option* interval_option_ = nullptr;
};

}  // namespace thiessen::cli
