#include "readings/stations/heard_stations.h"

#include <algorithm>

#include "base/interrupt.h"
#include "readings/dly/dly_record.h"
#include "readings/dly/seekable_lines.h"

namespace thiessen {
namespace {

using Standing = ReadingsStations::Standing;

bool has_value(const DlyRecord& record, bool keep_flagged) {
  for (int day = 1; day <= 31; ++day) {
    const DlyDay read = read_dly_day(record, day);
    const bool counts = !read.is_flagged || keep_flagged || day > days_in(record.month);
    if (!read.is_number || (read.value != dly_missing && counts)) return true;
  }
  return false;
}

}  // namespace

void HeardStations::hear(StationIndex station) {
  if (heard_[station]) return;
  heard_.set(station, true);
  --silent_;
}

void HeardStations::look_through(Table& table, const ReadingsOptions& options) {
  const ReadingsLayout layout = find_layout(table, stations_, options);
  const ReadingGrammar grammar = grammar_of(options, table);
  if (layout.is_long) {
    look_through_long(table, layout, grammar);
  } else {
    look_through_wide(table, layout, grammar);
  }
}

void HeardStations::look_through_wide(Table& table, const ReadingsLayout& layout,
                                      const ReadingGrammar& grammar) {
  struct Column {
    std::size_t field;
    StationIndex station;
  };
  std::vector<Column> silent;
  for (std::size_t i = 0; i < table.header().size(); ++i) {
    if (layout.time.has(i) || i == layout.index) continue;
    const ReadingsStations::Found found = stations_.find(table.header()[i]);
    if (found.standing == Standing::known) silent.push_back({i, found.station});
  }
  Row row;
  while (!silent.empty() && table.next(row)) {
    throw_if_interrupted();
    std::erase_if(silent, [&](const Column& column) {
      const Reading reading = grammar.read(row.fields[column.field], row.padded);
      if (reading.kind == ReadingKind::missing) return false;
      hear(column.station);
      return true;
    });
  }
}

void HeardStations::look_through_long(Table& table, const ReadingsLayout& layout,
                                      const ReadingGrammar& grammar) {
  Row row;
  std::string last_id;
  ReadingsStations::Found found;
  while (!all() && table.next(row)) {
    throw_if_interrupted();
    const std::string_view id = row.fields[layout.station];
    if (id != last_id || id.empty()) {
      last_id = id;
      found = stations_.find(id);
    }
    if (found.standing != Standing::known || heard_[found.station]) continue;
    const Reading reading = grammar.read(row.fields[layout.value], row.padded);
    if (reading.kind != ReadingKind::missing) hear(found.station);
  }
}

void HeardStations::look_through_dly(const std::vector<std::string>& files, bool keep_flagged,
                                     std::string_view element) {
  SeekableLines lines;
  std::string fault;
  for (const std::string& file : files) {
    lines.go(file, {});
    while (const auto line = lines.next()) {
      if (all()) return;
      const auto record = read_dly_record(*line, lines.ends(), fault);
      if (!record || record->element != element) continue;
      const ReadingsStations::Found found = stations_.find(record->id);
      if (found.standing != Standing::known || heard_[found.station]) continue;
      if (has_value(*record, keep_flagged)) hear(found.station);
    }
  }
}

}  // namespace thiessen
