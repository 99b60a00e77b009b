#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/iso_time.h"
#include "base/number.h"
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/memory_file.h"
#include "fuzzers/message_laws.h"
#include "fuzzers/plain_readings.h"
#include "fuzzers/plain_steps.h"
#include "fuzzers/reading_laws.h"
#include "readings/dly_text.h"
#include "readings/readings_dly.h"
#include "readings/readings_reader.h"
#include "readings/stations/heard_stations.h"
#include "readings/stations/readings_stations.h"
#include "text/csv_reader.h"

namespace thiessen::fuzzers {
namespace {

/// What the files are called together: the file, or the folder.
std::string name_of(const std::vector<MemoryFile>& files) {
  return files.size() == 1 ? files.front().name() : "some";
}

const std::vector<Station>& stations() {
  static const std::vector<Station> all = stations_called({"USC00050848", "B", "C 1"});
  return all;
}

struct Settings {
  bool keep_flagged = false;
  std::size_t memory = 0;
};

Steps read_dly(const std::vector<MemoryFile>& files, const Settings& settings) {
  Warnings warnings;
  auto known = std::make_unique<const ReadingsStations>(stations(), std::span<const std::string>());
  const std::string name = name_of(files);
  ReadingsFindings findings(name, *known, false, warnings);
  DlySource source{name, {}, std::move(known), std::move(findings), settings.keep_flagged};
  for (const MemoryFile& file : files) source.files.push_back(file.name());
  DlyReadings readings(std::move(source), settings.memory);
  Steps steps = steps_of(readings, stations().size());
  for (const Message& warning : warnings.messages()) require_sentences(Error(warning));
  return steps;
}

Steps read_wide(const std::string& file) {
  Warnings warnings;
  const auto readings =
      open_readings(std::make_unique<CsvReader>(file), stations(), {}, {}, warnings);
  return steps_of(*readings, stations().size());
}

/// Requires that a look through the files hears the stations that report.
void require_heard(const std::vector<MemoryFile>& files, const Settings& settings,
                   const Steps& steps) {
  std::vector<std::string> names;
  for (const MemoryFile& file : files) names.push_back(file.name());
  const ReadingsStations known(stations(), {});
  HeardStations heard(known);
  heard.look_through_dly(names, settings.keep_flagged);
  require_heard(heard, steps);
}

/// Records of rain that bytes stand for, as they are and as lines of `.dly` files.
class PlainRecords {
 public:
  PlainRecords(Bytes& bytes, bool keep_flagged) : keep_flagged_(keep_flagged) {
    constexpr std::array<int, 4> years = {1999, 1899, 1700, 2023};
    const int first = 12 * bytes.one_of(years);
    const std::size_t span = 1 + bytes.below(5);
    for (std::size_t month = 0; month < span; ++month)
      for (std::size_t station = 0; station < stations().size(); ++station)
        if (bytes.below(4) > 0) add_record(bytes, first + static_cast<int>(month), station);
  }

  std::vector<std::string>& lines() { return lines_; }
  /// The days from the first month to the last, those without a value too.
  Steps steps() const {
    Steps steps;
    if (!any_value_) return steps;
    for (int month = amounts_.begin()->first; month <= amounts_.rbegin()->first; ++month) {
      const CalendarMonth calendar{month};
      const auto found = amounts_.find(month);
      for (int day = 1; day <= days_in(calendar); ++day) {
        std::vector<double> amounts(stations().size(), silent);
        if (found != amounts_.end()) amounts = found->second[static_cast<std::size_t>(day)];
        steps.push_back({text_of(calendar, day), amounts});
      }
    }
    return steps;
  }

 private:
  using Days = std::array<std::vector<double>, 32>;

  void add_record(Bytes& bytes, int month, std::size_t station) {
    std::string id = stations()[station].id;
    id.resize(11, ' ');
    Days& days = amounts_[month];
    for (std::vector<double>& amounts : days) amounts.resize(stations().size(), silent);
    std::map<int, DlyColumns> columns;
    for (std::size_t count = bytes.below(12); count > 0; --count) {
      const int day = 1 + static_cast<int>(
                              bytes.below(static_cast<std::size_t>(days_in(CalendarMonth{month}))));
      const int tenths = bytes.next() * bytes.next();
      const bool flagged = bytes.below(8) == 0;
      columns[day] = {std::to_string(tenths), flagged ? " X " : "P N"};
      any_value_ = true;
      days[static_cast<std::size_t>(day)][station] =
          flagged && !keep_flagged_ ? silent : tenths / 10.0;
    }
    lines_.push_back(dly_line(id, month / 12, month % 12 + 1, columns));
    if (bytes.below(4) == 0)
      lines_.push_back(dly_line(id, month / 12, month % 12 + 1, columns, "TMAX"));
  }

  bool keep_flagged_;
  bool any_value_ = false;
  std::map<int, Days> amounts_;  ///< by month, counted from year 0
  std::vector<std::string> lines_;
};

/// The days as a table with a column a station.
std::string wide(const Steps& steps) {
  std::string text = "date";
  for (const Station& station : stations()) text += "," + station.id;
  for (const Step& step : steps) {
    text += "\n" + step.time;
    for (const double amount : step.amounts)
      text += "," + (amount == silent ? "" : shortest_text(amount));
  }
  return text + "\n";
}

/// Records that are known, in any order and in several files, are read as what they are, and as a
/// table of the same readings is.
void write_records(Bytes& bytes) {
  Settings settings{bytes.below(2) == 0, bytes.below(2) * std::size_t{1000}};
  PlainRecords records(bytes, settings.keep_flagged);
  std::vector<std::string>& lines = records.lines();
  const bool shuffled = bytes.below(2) == 0;
  for (std::size_t i = lines.size(); shuffled && i > 1; --i)
    std::swap(lines[i - 1], lines[bytes.below(i)]);
  const std::string_view end = bytes.below(2) == 0 ? "\n" : "\r\n";
  std::array<std::string, 3> texts;
  std::vector<MemoryFile> files;
  for (const std::string& line : lines) {
    std::string& text = texts[bytes.below(3)];
    text += (text.empty() ? "" : std::string(end)) + line;
  }
  for (const std::string& text : texts)
    if (!text.empty()) files.emplace_back(text);
  const Steps expected = records.steps();
  const Steps steps =
      sound_steps_of([&] { return read_dly(files, settings); }, expected, name_of(files));
  require(steps == expected, "other readings of records");
  require_heard(files, settings, expected);
  if (expected.empty()) return;
  const MemoryFile table(wide(expected));
  const Steps in_table =
      sound_steps_of([&] { return read_wide(table.name()); }, expected, table.name());
  require(in_table == expected, "other readings when wide");
}

/// Any text as a file of records: days that follow each other, or complaints with a place.
void read_any_records(Bytes& bytes) {
  const Settings settings{bytes.below(2) == 0, bytes.below(2) * std::size_t{1000}};
  std::vector<MemoryFile> files;
  files.emplace_back(bytes.rest());
  try {
    const Steps steps = read_dly(files, settings);
    std::optional<IsoTime> before;
    for (const Step& step : steps) {
      const ParsedTime day = parse_iso_time(step.time);
      require(day && day.time.precision == TimePrecision::day, "a step that is no day");
      require(!before || order_of_moments(*before, day.time) < 0, "a day before the last");
      before = day.time;
    }
    if (steps.size() == most_steps) return;
    require_heard(files, settings, steps);
    require(!PlainSteps(steps).are_mixed(), "mixed steps that are not refused");
  } catch (const Error& error) {
    require_placed(error, files[0].name(), lines_of(bytes.rest()));
  }
}

}  // namespace

void fuzz_dly(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  if (bytes.below(2) == 0) {
    write_records(bytes);
  } else {
    read_any_records(bytes);
  }
}

}  // namespace thiessen::fuzzers
