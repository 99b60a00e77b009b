#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "rainfall/series/readings.h"
#include "readings/dly_record.h"
#include "readings/readings_findings.h"
#include "readings/readings_reader.h"
#include "readings/readings_stations.h"
#include "readings/seekable_lines.h"

namespace thiessen {

/// Where `.dly` files lie, and what is to be done with what failed a check of quality.
struct DlySource {
  std::string name;                ///< as the user named it: a file or a folder
  std::vector<std::string> files;  ///< in the order in which messages name them
  std::unique_ptr<const ReadingsStations> stations;
  ReadingsFindings findings;
  bool keep_flagged = false;
};

/// Rain (PRCP) in the `.dly` files of GHCN-Daily: see open_dly_readings.
///
/// The files are read twice: once to check them, and to find where in them the months ascend; then
/// a block of months at a time, from each such stretch that has some of them. So one file is open
/// at a time, and memory holds a block, and 40 bytes a stretch: one for a file as NOAA writes it.
class DlyReadings : public Readings {
 public:
  static constexpr std::size_t usual_memory = std::size_t{32} << 20;

  explicit DlyReadings(DlySource source, std::size_t memory = usual_memory);

  bool next(TimeStep& step) override;
  double share_read() const override;

 private:
  /// PRCP records of stations of the study whose months do not descend.
  struct Stretch {
    std::uint32_t file;
    CalendarMonth first;
    CalendarMonth last;
    LinePlace next;  ///< what is not yet in a block
  };
  struct Day {
    CalendarMonth month = {};
    int day = 0;  ///< from 1; 0: none

    bool operator<(const Day& other) const {
      return month < other.month || (month == other.month && day < other.day);
    }
  };
  /// A station's month in the block.
  struct MonthOfStation {
    std::uint32_t file;
    std::size_t line = 0;  ///< 0: no record
    std::int32_t tenths[31];
  };

  void scan();
  void scan_file(std::uint32_t file);
  void scan_record(const DlyRecord& record, std::uint32_t file);
  void scan_days(const DlyRecord& record, StationIndex station);
  void check_day(const DlyRecord& record, int day, const DlyDay& read, StationIndex station);
  ReadingsStations::Found station_of(const DlyRecord& record);
  void complain(std::string text);

  void begin_blocks();
  void load_block();
  void load(Stretch& stretch);
  void load(const DlyRecord& record, StationIndex station, std::uint32_t file);
  void refuse_change() const;
  MonthOfStation& in_block(CalendarMonth month, StationIndex station);
  bool next_day(TimeStep& step);
  void conclude();

  DlySource source_;
  std::size_t memory_;
  SeekableLines lines_;
  std::vector<Stretch> stretches_;
  std::string last_id_;
  ReadingsStations::Found last_found_;
  Day first_;
  Day last_;
  bool any_value_ = false;

  std::vector<std::uint32_t> slots_;  ///< by station: which of the block's; none: it has no record
  std::vector<StationIndex> stations_;  ///< by slot
  std::vector<MonthOfStation> block_;   ///< by month, then slot
  CalendarMonth block_begin_ = {};
  std::int32_t block_months_ = 0;
  Day today_;
  std::vector<double> readings_;
  std::size_t steps_ = 0;
  bool scanned_ = false;
  bool done_ = false;
};

/// The rain (PRCP) of a `.dly` file of GHCN-Daily, or of all `.dly` files of a folder, in
/// millimetres. A step is a day, YYYY-MM-DD: every day of the months from the first to the last for
/// which a station of the study has a record; a day without any value is a step of silent gauges,
/// and where there is no value at all there is no step. A value that
/// failed a check of quality is missing, unless the options keep it.
///
/// Throws Error here where there is no such file, or an option is given that is for tables; from
/// `next` where a line is cut, or has a bad number, a wrong month, a value on a day that the month
/// lacks, a station's month twice, or an unknown station. See open_readings for the rest.
std::unique_ptr<Readings> open_dly_readings(const std::string& rainfall,
                                            std::span<const Station> stations,
                                            std::span<const std::string> passed_over,
                                            const ReadingsOptions& options, Warnings& warnings);

}  // namespace thiessen
