#include "readings/readings_rows.h"

#include <utility>

#include "base/utf8.h"

namespace thiessen {

using Standing = ReadingsStations::Standing;

LongRows::LongRows(ReadingsSource source, const ReadingsLayout& layout)
    : source_(std::move(source)), layout_(layout) {}

bool LongRows::next(LongRow& row) {
  while (!source_.gives_up() && source_.next(row_)) {
    row.line = row_.line;
    row.time = layout_.time.text(row_);
    const bool has_time = !trimmed(row.time).empty();
    if (has_time && is_below_table(row.time)) {
      source_.findings.note_passed(row.time, row.line);
      continue;
    }
    if (!has_time) source_.findings.note_empty_time(row.line);
    const ReadingsStations::Found found = station_of(row_);
    row.has_station = found.standing == Standing::known;
    row.station = found.station;
    if (row.has_station) {
      const std::string_view field = row_.fields[layout_.value];
      const Reading reading = source_.grammar.read(field, row_.padded);
      row.amount = reading.amount;
      if (!source_.findings.note(reading, row.station)) {
        source_.findings.note_oddity(reading, {row.line, row.station}, field, source_.grammar);
      }
    }
    if (has_time) return true;
  }
  return false;
}

/// Whether a row has neither a time nor a station nor a reading: a line of text below a table.
bool LongRows::is_below_table(std::string_view time) {
  return trimmed(row_.fields[layout_.station]).empty() &&
         trimmed(row_.fields[layout_.value]).empty() && source_.times.is_no_time(time, row_.line);
}

ReadingsStations::Found LongRows::station_of(const Row& row) {
  const std::string_view id = row.fields[layout_.station];
  if (id != last_id_ || id.empty()) {
    last_id_ = id;
    last_found_ = source_.stations->find(id);
  }
  if (last_found_.standing == Standing::unknown) {
    source_.findings.note_unknown(id, row.line, "unknown station " + quoted(id),
                                  setting("ignore_unknown") + " passes over its readings");
  }
  return last_found_;
}

}  // namespace thiessen
