#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "rainfall/network/network.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/stamp.h"
#include "readings/readings_grammar.h"
#include "readings/units/rain_unit.h"
#include "text/table.h"

namespace thiessen {

/// What is read of a file: readings of a step each or, where it is one of totals, one of what
/// totals are made of.
enum class AmountsRead : std::uint8_t {
  of_steps,
  totals,        ///< readings, and beside them sums of days that a column of days tells
  days,          ///< of how many days each of these is
  sums,          ///< GHCN-Daily's sums of several days (MDPR)
  days_of_sums,  ///< of how many days each of these is (DAPR)
};

/// What the user says about RAINFALL. Where the name of a field is empty, its column is found by
/// the usual names.
struct ReadingsOptions {
  std::vector<std::string> time_fields;  ///< one, or several whose texts together are the time
  std::string time_format;               ///< see TimeFormat; empty: see TimeReader
  bool day_first = false;                ///< of dates without a format, see TimeReader
  std::string station_field;
  std::string value_field;
  std::vector<std::string> missing;  ///< further texts and numbers that mean "no reading"
  std::vector<std::string> trace;    ///< texts and numbers that mean 0
  bool decimal_comma = false;
  std::string input = "rainfall";  ///< what the user calls the file: names its settings in messages
  std::optional<double> scale;     ///< readings are multiplied by it, whatever they are in
  std::optional<RainUnit> from_unit;  ///< what they are in; else as their column's name says
  std::optional<RainUnit> to_unit;    ///< what they are brought to, where their unit is known;
                                      ///< else millimetres
  bool cumulative = false;            ///< readings are counters: see CounterReadings
  bool keep_flagged = false;          ///< GHCN-Daily: readings that failed a check of quality count
  bool ignore_unknown = false;        ///< unknown stations are passed over, with a warning
  bool is_one_of_several = false;     ///< further files tell of stations that are silent in this
                                      ///< one, and counters go on from file to file
  /// What the file itself says that its times are of their steps, where it does.
  std::optional<Stamp> stamp;
  /// RAINFALL is a pipe whose steps are wanted as they come: see FedPieces. Else a long table that
  /// cannot be read again is read to its end, and sorted.
  bool steps_as_they_come = false;
  /// Steps of such a pipe may come again, and what came first stays: see FreshReadings.
  bool steps_may_come_again = false;
  AmountsRead read = AmountsRead::of_steps;
  bool is_beside_others = false;   ///< stations that are silent in it may report in another input
  bool steps_may_differ = false;   ///< it tells itself how long each reading's step is
  bool steps_by_calendar = false;  ///< they are wanted in the order of time: see JoinedReadings
  bool ids_as_numbers = false;     ///< ids of digits that differ by leading zeros are one
  /// Finds another column of the stations' source that holds this id, for a hint; may be empty.
  std::function<std::string(const std::string& id)> column_of;
};

struct ReadingsLayout;

/// The grammar of the fields of readings that the options ask for, with the decimal mark of the
/// table where they ask for none.
ReadingGrammar grammar_of(const ReadingsOptions& options, const Table& table);

/// More rain than any gauge has caught in a year (26,470 mm). A reading above it gets a warning.
constexpr double more_than_a_year = 30'000;
/// More rain, in millimetres, than any gauge has caught in a day (1,825 mm on Reunion in 1966). A
/// reading above it gets a warning where steps are a day or less.
constexpr double more_than_a_day = 1'825;

/// Opens the readings in a table, wide or long. `passed_over` holds the ids of the stations that
/// the user's filter left out. The stations, the ids and `warnings` must outlive the result.
///
/// A wide table has the time in its first column (or in `time_fields`) and a station in each other
/// column. It is read a row at a time.
///
/// A table is long if a station column and a value column are found and neither header is a
/// station's id, or if `station_field` or `value_field` is given. If it is a file in the order of
/// time (ascending or descending, as text or with its numbers as numbers), it is looked through
/// once and then read one time after the other. Any other is sorted, in some 100 MB of memory and
/// in temporary files (see spool.h) of about 40 bytes a reading; its steps come in the order in
/// which the times first came. Memory does not grow with the number of steps.
///
/// Throws Error here for a header that cannot be read so, and for unknown stations of a wide table.
/// All else that is wrong is thrown from `next`, all bad rows together: in place of the steps that
/// follow the first bad row, or, for a long table that is sorted, before the first step. Times that
/// are given twice may be found only at the end, and so are steps of two lengths in one table and
/// times with and without a zone (see MixedSteps). Warnings come when the last step has been read:
/// of stations without readings, unknown stations passed over, absurd readings, and readings that
/// look like codes for a gap.
std::unique_ptr<Readings> open_readings(std::unique_ptr<Table> table,
                                        std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        const ReadingsOptions& options, Warnings& warnings);
/// The same of a long table whose columns are known.
std::unique_ptr<Readings> open_long_readings(std::unique_ptr<Table> table,
                                             const ReadingsLayout& layout,
                                             std::span<const Station> stations,
                                             std::span<const std::string> passed_over,
                                             const ReadingsOptions& options, Warnings& warnings);

}  // namespace thiessen
