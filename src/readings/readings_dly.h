#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rainfall/series/readings.h"
#include "readings/dly/dly_record.h"
#include "readings/dly/seekable_lines.h"
#include "readings/readings_findings.h"
#include "readings/readings_reader.h"
#include "readings/stations/readings_stations.h"

namespace thiessen {

/// Where `.dly` files lie, and whether values that failed a check of quality are kept.
struct DlySource {
  std::string name;                ///< as the user named it: a file or a folder
  std::vector<std::string> files;  ///< in the order in which messages name them
  std::unique_ptr<const ReadingsStations> stations;
  ReadingsFindings findings;
  bool keep_flagged = false;
  /// The element that is read: PRCP or, of sums of several days, MDPR and its days DAPR.
  std::string element = "PRCP";
};

/// Reads rain (PRCP, or another element) from the `.dly` files of GHCN-Daily: see
/// open_dly_readings.
///
/// The files are read twice. The first pass checks them and finds the stretches in which the months
/// ascend. The second reads a block of months at a time, from each stretch that has some of them.
/// So only one file is open at a time. Memory: a block, and 40 bytes a stretch; a file as NOAA
/// writes it is one stretch.
class DlyReadings : public Readings {
 public:
  static constexpr std::size_t usual_memory = std::size_t{32} << 20;

  explicit DlyReadings(DlySource source, std::size_t memory = usual_memory);

  bool next(TimeStep& step) override;
  double share_read() const override;

 private:
  /// A stretch of a file whose PRCP records, of the study's stations, have months that do not
  /// descend.
  struct Stretch {
    std::uint32_t file;
    CalendarMonth first;
    CalendarMonth last;
    LinePlace next;  ///< where the part begins that is not yet in a block
  };
  struct Day {
    CalendarMonth month = {};
    int day = 0;  ///< from 1; 0: none

    bool operator<(const Day& other) const {
      return month < other.month || (month == other.month && day < other.day);
    }
  };
  /// The values of one station in one month of the block.
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

  std::vector<std::uint32_t> slots_;    ///< by station: its slot in the block, or none
  std::vector<StationIndex> stations_;  ///< by slot
  std::vector<MonthOfStation> block_;   ///< by month, then by slot
  CalendarMonth block_begin_ = {};
  std::int32_t block_months_ = 0;
  Day today_;
  std::vector<double> readings_;
  std::size_t steps_ = 0;
  bool scanned_ = false;
  bool done_ = false;
};

/// The element of GHCN-Daily that is read; empty where its files have none such: of how many days
/// values of PRCP are.
std::string_view dly_element(AmountsRead read);

/// Opens the rain (PRCP) of a `.dly` file of GHCN-Daily, or of all `.dly` files of a folder, in
/// millimetres.
///
/// A step is a day, YYYY-MM-DD. There is a step for every day from the first to the last of the
/// months for which a station of the study has a record. A day without any value is a step of
/// silent gauges; if there is no value at all, there are no steps. A value that failed a check of
/// quality is missing, unless the options keep it.
///
/// Throws Error here if there is no such file, or if an option is given that is for tables. Throws
/// Error from `next` if a line is cut, has a bad number or a wrong month, has a value on a day that
/// the month lacks, gives a station's month twice, or is of an unknown station. See open_readings
/// for the rest. Null where an element is wanted that there is none of: see dly_element.
std::unique_ptr<Readings> open_dly_readings(const std::string& rainfall,
                                            std::span<const Station> stations,
                                            std::span<const std::string> passed_over,
                                            const ReadingsOptions& options, Warnings& warnings);

}  // namespace thiessen
