#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "rainfall/network/reporting.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/stamp.h"
#include "readings/stations/readings_stations.h"

namespace thiessen {

/// A list of readings that are to count as missing, as its file names them.
struct ExclusionList {
  struct Row {
    std::string station;
    std::string time;  ///< empty: all readings of the station
    std::size_t line = 0;
  };
  std::string file;
  std::vector<Row> rows;
};

/// Which readings of a network's gauges count as missing. A time is compared as text, blanks round
/// it left out, and as a moment by the calendar where both are such.
class Exclusions {
 public:
  /// Throws Error naming each station that is not there, unless these are passed over: then
  /// there is a warning. Those that are passed over in silence may be named.
  Exclusions(const ExclusionList& list, const ReadingsStations& stations, bool ignore_unknown,
             Warnings& warnings);

  const std::string& file() const { return file_; }
  /// The gauges all of whose readings are excluded.
  const ReportingStations& whole() const { return whole_; }
  /// The gauges some of whose readings are excluded, by their times.
  const ReportingStations& partly() const { return partly_; }
  /// How many gauges are excluded wholly, in the network or not.
  std::size_t whole_gauges() const { return whole_gauges_; }
  /// How many readings are named by their times, of gauges that are in the network.
  std::size_t named() const { return named_; }
  /// How many rows with a time are of stations that have no part in the network.
  std::size_t elsewhere() const { return elsewhere_; }
  /// The gauges whose readings at a step are excluded by its time.
  const std::vector<StationIndex>& at(const TimeStep& step) const;

 private:
  void add(const ExclusionList::Row& row, StationIndex station);

  std::string file_;
  ReportingStations whole_;
  ReportingStations partly_;
  std::size_t whole_gauges_ = 0;
  std::size_t named_ = 0;
  std::size_t elsewhere_ = 0;
  std::vector<std::vector<StationIndex>> steps_;
  std::unordered_map<std::string, std::size_t> by_time_;  ///< by text, and by moment
};

/// Readings of which some count as missing. At the end a notice says how many.
class ExcludedReadings : public Readings {
 public:
  /// `warnings` must outlive this object.
  ExcludedReadings(std::unique_ptr<Readings> all, Exclusions excluded, Warnings& warnings);

  /// Has what these readings take out of others, which lie beneath, be told together.
  void tell_for(ExcludedReadings& beneath) {
    beneath.told_ = true;
    beneath_ = &beneath;
  }

  bool next(TimeStep& step) override;
  bool is_waiting(std::chrono::milliseconds patience) override {
    return all_->is_waiting(patience);
  }
  std::string unit() const override { return all_->unit(); }
  std::optional<Stamp> stamp() const override { return all_->stamp(); }
  double share_read() const override { return all_->share_read(); }

 private:
  void tell();

  std::unique_ptr<Readings> all_;
  Exclusions excluded_;
  std::vector<StationIndex> whole_;
  Warnings& warnings_;
  std::vector<double> readings_;
  std::size_t taken_out_ = 0;  ///< readings by their times
  const ExcludedReadings* beneath_ = nullptr;
  bool told_ = false;
};

/// The gauges that report, but for those all of whose readings are excluded without times.
ReportingStations without(const Exclusions& excluded, ReportingStations reports);

/// The same, but for those, too, all of whose readings are excluded by their times. `readings` are
/// those of all steps, none excluded yet; they are read until each gauge is heard of which some
/// are excluded.
ReportingStations reporting_beside(const Exclusions& excluded, ReportingStations reports,
                                   Readings& readings);

}  // namespace thiessen
