#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"
#include "basin/basin.h"
#include "rainfall/series/rain_totals.h"
#include "results/rain_file.h"

namespace thiessen {

/// Writes totals of areal rainfall, a period at a time: CSV `time,<basin id>,<basin
/// id>_missing,...[,<basin id>_se,...]` or `time[,last],basin[,method],rainfall,missing[,se]`. The
/// field of a missing total is empty.
class RainTotalsFile {
 public:
  /// Writes the header, where there is to be one. The file and the basins must outlive it. Throws
  /// Error where two columns would have one name.
  RainTotalsFile(OutputFile& file, const std::vector<Basin>& basins, RainFormat format);
  /// The rows of one period as text, not yet written.
  std::string text_of(const RainPeriod& period) const;
  void append(std::string_view text) { file_.append(text); }
  void add(const RainPeriod& period) { append(text_of(period)); }

 private:
  void append_total(std::string& row, const BasinTotal& total) const;
  void append_error(std::string& row, const BasinTotal& total) const;

  OutputFile& file_;
  const std::vector<Basin>& basins_;
  RainFormat format_;
};

/// The header of the totals, with its line end.
std::string totals_header(const std::vector<Basin>& basins, const RainFormat& format);

}  // namespace thiessen
