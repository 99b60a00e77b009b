#pragma once

#include <optional>
#include <string>

#include "cli/options/option_list.h"
#include "files/rainfall/rainfall_file.h"
#include "rainfall/series/stamp.h"
#include "readings/readings_reader.h"
#include "readings/totals/total_periods.h"
#include "readings/units/rain_unit.h"

namespace thiessen::cli {

/// The options that name totals of other gauges beside RAINFALL, and say when they are read.
class TotalsOptions : public OptionBlock {
 public:
  void declare(OptionList& options);
  /// Declares --stamp, where totals alone need it.
  void declare_stamp(OptionList& options);
  Stamp stamp() const { return stamp_; }
  /// Throws UsageError for options that contradict each other, and where there is no RAINFALL for
  /// the totals.
  void check(bool has_rainfall, bool is_event) const;
  bool given() const { return !file_.empty(); }
  const std::string& file() const { return file_; }
  /// The files of totals, which are read as RAINFALL but for what is said of that alone.
  RainfallRequest request(const RainfallRequest& rainfall, const CsvDialect& all) const;
  /// The settings of their reader, where RAINFALL has these.
  ReadingsOptions readings(const ReadingsOptions& rainfall, const CsvDialect& all) const;
  /// When totals are read, of which times are such stamps.
  ObservationHour hour(Stamp stamp) const;

 private:
  std::string file_;
  std::optional<int> observed_at_;
  bool before_ = false;
  Stamp stamp_ = Stamp::begin;
  std::string time_format_;
  std::optional<RainUnit> unit_;
  const Option* observed_day_option_ = nullptr;
};

}  // namespace thiessen::cli
