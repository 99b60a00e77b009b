#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/number.h"
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/memory_file.h"
#include "fuzzers/memory_pipe.h"
#include "fuzzers/message_laws.h"
#include "fuzzers/plain_readings.h"
#include "fuzzers/plain_steps.h"
#include "fuzzers/reading_laws.h"
#include "readings/readings_layout.h"
#include "readings/readings_reader.h"
#include "readings/readings_scattered.h"
#include "readings/stations/heard_stations.h"
#include "readings/stations/readings_stations.h"
#include "text/csv_reader.h"

namespace thiessen::fuzzers {
namespace {

Steps read_table(const std::string& file, const std::vector<Station>& stations,
                 const ReadingsOptions& options, char separator = ',') {
  Warnings warnings;
  const auto readings = open_readings(std::make_unique<CsvReader>(file, CsvOptions{separator}),
                                      stations, {}, options, warnings);
  Steps steps = steps_of(*readings, stations.size());
  for (const Message& warning : warnings.messages()) require_sentences(Error(warning));
  return steps;
}

/// The same from the pieces of a long table that does not fit in memory.
Steps read_scattered(const std::string& file, const std::vector<Station>& stations,
                     const ReadingsOptions& options, std::size_t memory) {
  Warnings warnings;
  auto table = std::make_unique<CsvReader>(file);
  auto known = std::make_unique<const ReadingsStations>(stations, std::span<const std::string>());
  const ReadingsLayout layout = find_layout(*table, *known, options);
  ReadingsFindings findings(file, *known, false, warnings);
  const DecimalMark mark = options.decimal_comma ? DecimalMark::comma : DecimalMark::point;
  LongRows rows(
      {std::move(table), std::move(known), ReadingGrammar({}, {}, mark), std::move(findings)},
      layout);
  ScatteredPieces pieces(rows, memory);
  Steps steps;
  std::uint64_t first_line = 0;
  for (ReadingsPiece piece; pieces.next(piece); first_line = piece.first_line) {
    if (piece.first_line != first_line)
      steps.push_back({std::string(piece.time), std::vector<double>(stations.size(), silent)});
    require(steps.back().time == piece.time, "a piece of another time");
    for (const PieceReading& reading : piece.readings)
      if (!std::isnan(reading.amount))
        steps.back().amounts[index(reading.station)] = reading.amount;
  }
  return steps;
}

/// Requires that a table is read as these steps, or refused where they are mixed, and that a look
/// through it hears the stations that report.
void require_read(const std::string& file, const std::vector<Station>& stations,
                  const ReadingsOptions& options, const Steps& expected, const std::string& how) {
  const Steps steps =
      sound_steps_of([&] { return read_table(file, stations, options); }, expected, file);
  require(steps == expected, "other readings " + how);
  const ReadingsStations known(stations, {});
  HeardStations heard(known);
  CsvReader table(file);
  heard.look_through(table, options);
  require_heard(heard, expected);
}

/// Readings that are known, written wide, long in order and long in any order, are read the same.
void write_tables(Bytes& bytes) {
  const PlainReadings known(bytes);
  const std::vector<Station> stations = stations_called(known.ids());
  ReadingsOptions options;
  options.decimal_comma = known.decimal_comma();
  const MemoryFile wide(known.wide());
  require_read(wide.name(), stations, options, known.steps(), "when wide");

  options.time_fields = {"t"};
  options.station_field = "s";
  options.value_field = "v";
  std::vector<PlainReadings::Entry> entries = known.entries();
  const MemoryFile ordered(known.as_long(entries));
  require_read(ordered.name(), stations, options, known.steps(entries), "when long");
  for (std::size_t i = entries.size(); i > 1; --i)
    std::swap(entries[i - 1], entries[bytes.below(i)]);
  const std::string text = known.as_long(entries);
  const MemoryFile scattered(text);
  const Steps expected = known.steps(entries);
  require_read(scattered.name(), stations, options, expected, "when scattered");
  if (bytes.below(4) == 0)
    require(read_scattered(scattered.name(), stations, options, bytes.next()) == expected,
            "other readings when scattered in little memory");
  if (text.size() > MemoryPipe::longest_text || bytes.below(4) > 0) return;
  const MemoryPipe pipe(text, 1 + bytes.below(9));
  const Steps in_pieces = sound_steps_of([&] { return read_table(pipe.name(), stations, options); },
                                         expected, pipe.name());
  require(in_pieces == expected, "other readings from a pipe");
}

/// Any text as a table: readings or complaints with a place, and the same from a pipe.
void read_any_table(Bytes& bytes) {
  static const std::vector<Station> stations = stations_called({"A", "B", "C 1", "07"});
  const std::size_t flags = bytes.next();
  ReadingsOptions options;
  options.decimal_comma = flags % 2 == 1;
  options.ignore_unknown = flags / 2 % 2 == 1;
  options.ids_as_numbers = flags / 4 % 2 == 1;
  if (flags / 4 % 4 == 1) options.station_field = "s";
  if (flags / 16 % 4 == 1) options.missing = {"x", "5"};
  const char separator = flags / 64 == 1 ? ';' : ',';
  const std::size_t piece = 1 + bytes.below(9);
  const std::string_view text = bytes.rest();
  const auto read = [&](const std::string& file) -> std::optional<Steps> {
    try {
      Steps steps = read_table(file, stations, options, separator);
      const PlainSteps judge(steps);
      require(!judge.are_mixed() || judge.has_other_forms(), "mixed steps that are not refused");
      return steps;
    } catch (const Error& error) {
      require_placed(error, file, lines_of(text));
      return std::nullopt;
    }
  };
  const MemoryFile file(text);
  const std::optional<Steps> steps = read(file.name());
  if (steps) {
    const ReadingsStations known(stations, {}, IdJoin{options.ids_as_numbers, {}});
    HeardStations heard(known);
    CsvReader table(file.name(), CsvOptions{separator});
    heard.look_through(table, options);
    require_heard(heard, *steps);
  }
  if (text.empty() || text.size() > MemoryPipe::longest_text) return;
  require(read(MemoryPipe(text, piece).name()) == steps, "other readings from a pipe");
}

}  // namespace

void fuzz_readings(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  if (bytes.below(2) == 0) {
    write_tables(bytes);
  } else {
    read_any_table(bytes);
  }
}

}  // namespace thiessen::fuzzers
