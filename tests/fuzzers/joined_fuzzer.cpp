#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/iso_time.h"
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/memory_file.h"
#include "fuzzers/message_laws.h"
#include "fuzzers/plain_readings.h"
#include "fuzzers/reading_laws.h"
#include "readings/joined_readings.h"
#include "readings/readings_reader.h"
#include "readings/stations/station_in_name.h"
#include "text/csv_reader.h"

namespace thiessen::fuzzers {
namespace {

constexpr const char* name_of_all = "all";

using Files = std::vector<std::string>;  // their names

Steps join(const Files& files, const std::vector<Station>& stations, const ReadingsOptions& options,
           std::size_t memory) {
  Warnings warnings;
  std::vector<JoinedReadings::File> list;
  for (const std::string& file : files) {
    list.push_back({file, [&stations, &options, file](Warnings& of_file) {
                      return JoinedReadings::Opened(open_readings(std::make_unique<CsvReader>(file),
                                                                  stations, {}, options, of_file));
                    }});
  }
  JoinedReadings joined(std::move(list), name_of_all, stations, warnings, memory);
  Steps steps = steps_of(joined, stations.size());
  for (const Message& warning : warnings.messages()) require_sentences(Error(warning));
  return steps;
}

/// The same; nothing where the files are refused, with the place in one of them or that of all.
std::optional<Steps> joined_if_sound(const Files& files, const std::vector<Station>& stations,
                                     const ReadingsOptions& options, std::size_t memory) {
  try {
    return join(files, stations, options, memory);
  } catch (const Error& error) {
    require_sentences(error);
    for (const Message& message : error.messages()) {
      const bool is_one = std::ranges::find(files, message.file) != files.end();
      require(is_one || message.file == name_of_all || message.file.empty(),
              "a message of no file: " + message.sentence());
    }
    return std::nullopt;
  }
}

void require_order(const Steps& steps) {
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const ParsedTime before = parse_iso_time(steps[i - 1].time);
    const ParsedTime time = parse_iso_time(steps[i].time);
    if (!before || !time) continue;  // written in another form
    require(order_of_moments(before.time, time.time) <= 0, "joined steps out of order");
  }
}

/// Requires that the order of the files and the memory change nothing but how times are written.
void require_order_of_files_is_free(const Files& files, const std::vector<Station>& stations,
                                    const ReadingsOptions& options, std::size_t memory) {
  const auto steps = joined_if_sound(files, stations, options, memory);
  if (steps) require_order(*steps);
  const Files turned(files.rbegin(), files.rend());
  const auto other = joined_if_sound(turned, stations, options, std::size_t{1} << 20U);
  require(steps.has_value() == other.has_value(), "files that are refused in one order alone");
  if (!steps) return;
  require(steps->size() == other->size(), "other steps in another order of files");
  for (std::size_t i = 0; i < steps->size(); ++i)
    require((*steps)[i].amounts == (*other)[i].amounts, "other readings in another order of files");
}

/// Known readings, parted over files, some of them in two, are those of one file with all.
void join_known(Bytes& bytes) {
  const PlainReadings known(bytes);
  const std::vector<Station> stations = stations_called(known.ids());
  ReadingsOptions options;
  options.decimal_comma = known.decimal_comma();
  options.time_fields = {"t"};
  options.station_field = "s";
  options.value_field = "v";
  options.is_one_of_several = true;
  const std::size_t count = 2 + bytes.below(3);
  std::vector<std::vector<PlainReadings::Entry>> parts(count);
  for (const PlainReadings::Entry& entry : known.entries()) {
    const std::size_t part = bytes.below(count);
    parts[part].push_back(entry);
    if (bytes.below(8) == 0) parts[(part + 1) % count].push_back(entry);
  }
  std::vector<std::unique_ptr<MemoryFile>> held;
  Files files;
  for (const auto& part : parts) {
    held.push_back(std::make_unique<MemoryFile>(known.as_long(part)));
    files.push_back(held.back()->name());
  }
  const std::size_t memory = bytes.below(2) == 0 ? bytes.next() : std::size_t{1} << 20U;
  require_order_of_files_is_free(files, stations, options, memory);
  const auto steps = joined_if_sound(files, stations, options, memory);
  if (!steps) return;
  for (const Step& expected : known.steps(known.entries())) {
    const auto step = std::ranges::find(*steps, expected.time, &Step::time);
    if (step == steps->end()) continue;  // written otherwise in the file before
    for (std::size_t i = 0; i < expected.amounts.size(); ++i) {
      require(expected.amounts[i] == silent || step->amounts[i] == expected.amounts[i],
              "a reading that is lost");
    }
  }
}

/// Any texts as files.
void join_any(Bytes& bytes) {
  static const std::vector<Station> stations = stations_called({"A", "B", "C 1", "07"});
  ReadingsOptions options;
  options.is_one_of_several = true;
  options.ignore_unknown = bytes.below(2) == 0;
  const std::size_t memory = std::size_t{bytes.next()} << bytes.below(12);
  std::vector<std::unique_ptr<MemoryFile>> held;
  Files files;
  while (!bytes.empty() && files.size() < 4) {
    held.push_back(std::make_unique<MemoryFile>(bytes.until('\xFE')));
    files.push_back(held.back()->name());
  }
  if (!files.empty()) require_order_of_files_is_free(files, stations, options, memory);
}

/// Any text as a file's name tells no station but one that stands in it.
void look_for_station(Bytes& bytes) {
  const std::vector<Station> stations = stations_called({"A", "B_1", "1", "07", "dly"});
  const ReadingsStations known(stations, {}, IdJoin{bytes.below(2) == 0, {}});
  const std::string name(bytes.rest());
  try {
    const std::string id = station_in_name(name, known);
    require(id.empty() || name.find(id) != std::string::npos, "a station that the name has not");
    require(id.empty() || known.find(id).standing == ReadingsStations::Standing::known,
            "a station that is unknown");
  } catch (const Error& error) {
    require_sentences(error);
  }
}

}  // namespace

void fuzz_joined(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  switch (bytes.below(4)) {
    case 0:
      return look_for_station(bytes);
    case 1:
      return join_any(bytes);
    default:
      return join_known(bytes);
  }
}

}  // namespace thiessen::fuzzers
