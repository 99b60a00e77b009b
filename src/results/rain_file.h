#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"
#include "basin/basin.h"
#include "rainfall/series/rain_series.h"

namespace thiessen {

/// The columns and rows in which areal rainfall is written.
struct RainFormat {
  bool rows_for_basins = false;  ///< a row for each basin and step (the setting `long`), and not a
                                 ///< column for each basin
  int decimals = 3;
  /// The methods by which each basin has a value. They stand next to each other, in columns `<basin
  /// id>_<method>`, or in rows for basins that have a column `method`. Empty where there is only
  /// one method, which is then not named.
  std::vector<std::string> methods = {};
  bool patterns = false;  ///< rows for basins have a column `pattern` that refers to WeightsLog
  /// Whether standard errors are written too, in columns `<basin id>_se` or a column `se`.
  bool errors = false;
  bool iso_times = false;  ///< times are written as ISO 8601, and not as they came
  bool storms = false;     ///< totals in rows for basins have a column `last`, for each its own end
  bool continues = false;  ///< the rows go on in a file that has its header
};

/// Writes the series of areal rainfall, a step at a time: CSV `time,<basin id>,...[,<basin
/// id>_se,...]`, or `time,basin[,method],rainfall,gauges,coverage[,se][,pattern]`. The field of a
/// missing value is empty.
class RainFile {
 public:
  /// Writes the header, where there is to be one. The file and the basins must outlive it. Throws
  /// Error where two columns would have one name.
  RainFile(OutputFile& file, const std::vector<Basin>& basins, RainFormat format);
  /// The rows of one step as text, not yet written. Safe for several threads at once.
  std::string text_of(const RainStep& step, std::size_t pattern = 0) const;
  void append(std::string_view text) { file_.append(text); }

 private:
  void append_value(std::string& row, double value) const;
  std::string row_for_each_basin(const RainStep& step, std::size_t pattern) const;

  OutputFile& file_;
  const std::vector<Basin>& basins_;
  RainFormat format_;
  std::vector<std::string> keys_;  // by series, where basins have rows: what follows the time
};

/// The header of the series, with its line end.
std::string rain_header(const std::vector<Basin>& basins, const RainFormat& format);
/// The names of the columns that hold values, in their order.
std::vector<std::string> rain_columns(const std::vector<Basin>& basins, const RainFormat& format);
/// Appends the beginning of a value's row where basins have rows: `time,basin[,method]`. `time` is
/// text already.
void append_rain_key(std::string& row, std::string_view time, std::size_t series,
                     const std::vector<Basin>& basins, const RainFormat& format);

}  // namespace thiessen
