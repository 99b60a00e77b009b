#pragma once

#include "cli/options/option_list.h"
#include "map/sheet/rainfall_classes.h"

namespace thiessen::cli {

/// The options that say into which classes rainfall is sorted, and in which colours.
class ColourOptions : public OptionBlock {
 public:
  ClassRule rule;

  void declare(OptionList& options);
  /// Throws UsageError where an option cannot act: without RAINFALL, or where two say different
  /// things of the same classes.
  void check(bool has_rainfall) const;
};

}  // namespace thiessen::cli
