#pragma once

#include <memory>

#include "readings/readings_findings.h"
#include "readings/readings_grammar.h"
#include "readings/readings_stations.h"
#include "readings/times/time_reader.h"
#include "text/table.h"

namespace thiessen {

/// What tables of both layouts, wide and long, are read from and with.
struct ReadingsSource {
  std::unique_ptr<Table> table;
  std::unique_ptr<const ReadingsStations>
      stations;  ///< at a fixed address: `findings` refers to it
  ReadingGrammar grammar;
  ReadingsFindings findings;
  TimeReader times{};

  /// Reads the next row; returns false at the end. There the complaints of the table join those
  /// found here.
  bool next(Row& row);
};

}  // namespace thiessen
