#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "readings/readings_layout.h"
#include "readings/readings_source.h"
#include "readings/stations/readings_stations.h"

namespace thiessen {

/// A row of a long table whose time is not empty.
struct LongRow {
  std::size_t line = 0;
  std::string_view time;      ///< valid until the next row
  bool has_station = false;   ///< whether its station is of the study
  StationIndex station = {};  ///< only if has_station
  double amount = 0;          ///< NaN where it is silent
};

/// Reads the rows of a long table. What is wrong or odd about them goes to the findings of the
/// source.
class LongRows {
 public:
  LongRows(ReadingsSource source, const ReadingsLayout& layout);

  bool next(LongRow& row);
  ReadingsSource& source() { return source_; }
  const ReadingsSource& source() const { return source_; }
  /// The table once more, or null where it cannot be read twice: see Table::again.
  std::unique_ptr<Table> again() const { return source_.table->again(); }
  const TimeColumns& time() const { return layout_.time; }

 private:
  bool is_below_table(std::string_view time);
  ReadingsStations::Found station_of(const Row& row);

  ReadingsSource source_;
  ReadingsLayout layout_;
  Row row_;
  std::string last_id_;                 ///< the station field that was read last
  ReadingsStations::Found last_found_;  ///< what that field was found to be
};

}  // namespace thiessen
