#pragma once

#include <cstddef>

#include "cli/options/option_list.h"
#include "results/rain_file.h"

namespace thiessen::cli {

/// The options of the format of rain.csv.
class RainFormatOptions : public OptionBlock {
 public:
  void declare(OptionList& options);
  RainFormat format() const {
    return {long_, static_cast<int>(decimals_), {}, false, false, iso_times_};
  }
  /// Throws UsageError where there are totals of periods, whose times are none of the file's.
  void check(bool has_totals) const;

 private:
  bool long_ = false;
  bool iso_times_ = false;
  std::size_t decimals_ = 3;
};

}  // namespace thiessen::cli
