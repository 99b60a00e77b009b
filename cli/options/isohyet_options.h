#pragma once

#include <optional>
#include <vector>

#include "cli/options/option_list.h"
#include "rainfall/methods/rain_surface.h"

namespace thiessen::cli {

/// The options that say which surface is shown, and at which levels isohyets are drawn.
class IsohyetOptions : public OptionBlock {
 public:
  double interval = 0;         ///< 0: a rounded step
  std::vector<double> breaks;  ///< the levels themselves, where they are given

  /// Declares --method for a map: Thiessen's cells are the default.
  void declare_surface(OptionList& options);
  /// Declares --method for isohyets, and their levels.
  void declare(OptionList& options);
  /// Throws UsageError for Thiessen's cells, which have no isohyets, and for levels that are given
  /// in two ways.
  void check() const;
  /// The surface; nothing for Thiessen's cells.
  const std::optional<SurfaceMethod>& surface() const { return surface_; }

 private:
  std::optional<SurfaceMethod> surface_;
  const Option* interval_option_ = nullptr;
  const Option* breaks_option_ = nullptr;
};

}  // namespace thiessen::cli
