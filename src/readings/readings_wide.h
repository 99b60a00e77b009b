#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rainfall/series/readings.h"
#include "readings/readings_layout.h"
#include "readings/readings_repeats.h"
#include "readings/readings_source.h"

namespace thiessen {

/// Reads a wide table, which has a row for each time and a column for each station, a row at a
/// time: see open_readings.
class WideReadings : public Readings {
 public:
  /// Throws Error if a column is of an unknown station and these are not ignored, if two columns
  /// are of the same station, or if no column is of a station.
  WideReadings(ReadingsSource source, const ReadingsLayout& layout);

  bool next(TimeStep& step) override;
  bool is_waiting(std::chrono::milliseconds patience) override;
  double share_read() const override { return source_.table->share_read(); }

 private:
  struct Column {
    std::size_t field;
    StationIndex station;
  };

  bool is_of_stations(std::size_t field) const { return !time_.has(field) && field != index_; }
  void match_columns();
  void require_a_station() const;
  void note_unknown_column(std::size_t field);
  void require_whole_time() const;
  bool read_row();
  void note_time(std::string_view time);
  bool is_silent() const;
  void conclude();

  ReadingsSource source_;
  TimeColumns time_;
  std::optional<std::size_t> index_;
  Wording time_meant_;           ///< see ReadingsLayout
  std::vector<Column> columns_;  ///< the columns of known stations
  std::vector<double> readings_;
  RepeatedTimes repeated_;
  // Of a pipe whose steps are wanted as they come.
  std::string last_time_;
  bool last_came_again_ = false;
  std::size_t steps_ = 0;
  Row row_;
  bool done_ = false;
};

}  // namespace thiessen
