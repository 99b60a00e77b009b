#pragma once

#include <memory>

#include "readings/readings_findings.h"
#include "readings/readings_grammar.h"
#include "readings/readings_stations.h"
#include "text/table.h"

namespace thiessen {

/// What both layouts read from and with.
struct ReadingsSource {
  std::unique_ptr<Table> table;
  std::unique_ptr<const ReadingsStations>
      stations;  ///< at a fixed address: `findings` refers to it
  ReadingGrammar grammar;
  ReadingsFindings findings;

  /// The next row; false at the end, where the table's own complaints join those found here.
  bool next(Row& row);
};

}  // namespace thiessen
