#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rainfall/network/reporting.h"
#include "readings/readings_grammar.h"
#include "readings/readings_layout.h"
#include "readings/readings_reader.h"
#include "readings/stations/readings_stations.h"
#include "text/table.h"

namespace thiessen {

/// Finds out which stations have at least one reading in RAINFALL, ahead of reading it for its
/// steps: these are the full network, which has to be known before the first step is computed.
///
/// A look through RAINFALL ends as soon as every station has been heard, and of a station that has
/// been heard no field is read any more. So a file whose gauges all report costs a few rows, and
/// any other is split into fields once: 0.04 seconds for 2,000 gauges and 3,000 steps, 0.43 where
/// these are six million rows. Faults in
/// the file are nobody's business here: they are met again, and told, when the steps are read. So a
/// field that is wrong counts as a reading, or its station would be passed over with it.
class HeardStations {
 public:
  /// The stations must outlive this object.
  explicit HeardStations(const ReadingsStations& stations)
      : stations_(stations), heard_(stations.all().size(), false), silent_(stations.all().size()) {}

  /// Looks through a table, wide or long, as open_readings reads it. Throws Error where it cannot
  /// be read so, or not to its end; what has been heard until then counts.
  void look_through(Table& table, const ReadingsOptions& options);
  /// The same of a long table whose columns are known.
  void look_through(Table& table, const ReadingsLayout& layout, const ReadingsOptions& options) {
    look_through_long(table, layout, grammar_of(options, table));
  }
  /// Looks through `.dly` files of GHCN-Daily, as open_dly_readings reads this element of them.
  /// Throws as above.
  void look_through_dly(const std::vector<std::string>& files, bool keep_flagged,
                        std::string_view element = "PRCP");

  const ReportingStations& heard() const { return heard_; }
  bool all() const { return silent_ == 0; }

 private:
  void look_through_wide(Table& table, const ReadingsLayout& layout, const ReadingGrammar& grammar);
  void look_through_long(Table& table, const ReadingsLayout& layout, const ReadingGrammar& grammar);
  void hear(StationIndex station);

  const ReadingsStations& stations_;
  ReportingStations heard_;
  std::size_t silent_;  // how many have not been heard
};

}  // namespace thiessen
