#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "base/patience.h"
#include "rainfall/series/stamp.h"
#include "readings/readings_findings.h"
#include "readings/readings_grammar.h"
#include "readings/stations/readings_stations.h"
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
  /// Whether the next row is waited for: see Table::is_waiting.
  bool is_waiting(std::chrono::milliseconds at_most);
  /// Whether what is wrong in a pipe is to be told before its end, as nothing comes for a while.
  bool gives_up();

  bool steps_as_they_come = false;    ///< see ReadingsOptions
  bool steps_may_come_again = false;  ///< whoever reads the steps passes over them
  std::optional<Stamp> stamp = {};    ///< what times are of their steps, where the table says it
  bool has_failed = false;            ///< a row cannot be read, and none follows it
  Patience patience = {};             ///< with what may follow a row with a fault
};

}  // namespace thiessen
