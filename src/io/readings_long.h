#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "io/readings_layout.h"
#include "io/readings_source.h"
#include "io/readings_times.h"
#include "rainfall/readings.h"

namespace thiessen {

/// Readings with a row for each time and station, in any order: see open_readings.
///
/// All rows are read before the first step, 16 bytes each; the readings of one time are chained
/// through the file, the last first. (A file sorted by time could be read a time after the other;
/// it is not yet.)
class LongReadings : public Readings {
 public:
  LongReadings(ReadingsSource source, const ReadingsLayout& layout)
      : source_(std::move(source)), layout_(layout) {}

  bool next(TimeStep& step) override;

 private:
  static constexpr std::uint32_t no_entry = 0xFFFFFFFF;

  struct Entry {
    double amount;
    StationIndex station;
    std::uint32_t previous;  ///< the entry before of the same time
  };
  /// From this entry on, the entries' lines are `entry + ahead`, up to the next stretch.
  struct Stretch {
    std::uint32_t entry;
    std::size_t ahead;
  };

  void load();
  void read_row(const Row& row);
  std::uint32_t step_of(const Row& row);
  ReadingsStations::Found station_of(const Row& row);
  void keep(std::uint32_t step, StationIndex station, double amount, std::size_t line);
  /// A reading whose station has one at the same time before.
  struct Twice {
    std::uint32_t entry;
    std::uint32_t before;
    std::size_t step;
  };
  std::vector<Twice> twice_given() const;
  void complain(std::vector<Twice> twice);
  std::size_t line_of(std::uint32_t entry) const;

  ReadingsSource source_;
  ReadingsLayout layout_;
  ReadingsTimes times_;
  std::deque<Entry> entries_;
  std::vector<std::uint32_t> last_entry_;  ///< of each time
  std::vector<Stretch> stretches_;
  std::string last_id_;  ///< the station field read last, and what it was found to be
  ReadingsStations::Found last_found_;
  std::vector<double> readings_;
  std::size_t step_ = 0;
  bool loaded_ = false;
  bool done_ = false;
};

}  // namespace thiessen
