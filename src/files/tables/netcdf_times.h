#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/calendar_days.h"
#include "base/wording.h"
#include "files/tables/netcdf_stations.h"
#include "rainfall/series/stamp.h"

namespace thiessen {

/// How the times of a NetCDF are counted: in what, and from when.
struct NetcdfTimeUnit {
  double seconds = 1;       ///< of what they are counted in
  std::int64_t origin = 0;  ///< seconds from the beginning of 1970, by the clock of its zone
  std::optional<int> ahead_of_utc;  ///< the zone's offset in minutes, where that is not 0

  bool is_in_days() const { return seconds == seconds_of_day; }
};

/// A unit of times that was read, or what is wrong with it.
struct ParsedTimeUnit {
  std::optional<NetcdfTimeUnit> unit;
  std::string fault;
  Wording hint;
};

/// Reads a unit of times as UDUNITS writes it: `hours since 2020-01-01 00:00:00 +01:00`, `days
/// since 1990-1-1 0:0:0`. Months and years are refused, for they are not all of one length.
ParsedTimeUnit parse_time_unit(std::string_view text);

/// The times of a NetCDF of stations, and what their bounds say of them.
///
/// Where all times are the beginning, or all the end, of their bounds, they stay as they are. Else,
/// as where they are the middle, the beginning stands for each. All times are looked through once
/// when this object is made. Memory: a block of times.
class NetcdfTimes {
 public:
  /// Throws Error where there are no times, their unit is not known, or they are of a calendar that
  /// has other days than ours. `stations` must outlive this object.
  explicit NetcdfTimes(const NetcdfStations& stations);

  /// What the times are of their steps, where their bounds say it.
  std::optional<Stamp> stamp() const { return stamp_; }
  /// The same in words, with the name of the bounds; empty where there are none.
  const std::string& bounds_in_words() const { return bounds_in_words_; }
  /// Times from a place on, which has as many numbers as times have dimensions; NaN where one is
  /// not filled.
  std::vector<double> read(std::span<const std::size_t> begin,
                           std::span<const std::size_t> size) const;
  /// A time as ISO 8601 has it: a date where all times are midnights that are counted in days and
  /// do not end their steps.
  std::string text_of(double time) const;

 private:
  /// How many of the times that have bounds stand where in them.
  struct Places {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t all = 0;
  };

  void find_bounds();
  void look_through();
  void look_at(std::span<const double> times, std::span<const double> bounds, Places& places);
  void settle(const Places& places);
  bool is_midnight(double time) const;
  std::vector<double> values_of(int variable, std::span<const std::size_t> begin,
                                std::span<const std::size_t> size) const;

  const NetcdfStations& stations_;
  NetcdfTimeUnit unit_;
  std::optional<double> fill_;
  const NetcdfStations::Variable* bounds_ = nullptr;
  std::string bounds_in_words_;
  std::optional<Stamp> stamp_;
  bool reads_bounds_ = false;  ///< the beginning of its bounds stands for each time
  bool are_midnights_ = true;
  bool begin_at_midnight_ = true;  ///< the bounds do
};

}  // namespace thiessen
