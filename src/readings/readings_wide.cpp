#include "readings/readings_wide.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "base/utf8.h"
#include "readings/dly/dly_record.h"
#include "text/field_names.h"

namespace thiessen {

using Standing = ReadingsStations::Standing;

namespace {

/// Whether all columns of a row but the first are called as stations, each as another.
bool names_stations(const Row& row, const ReadingsStations& stations) {
  std::set<std::string_view> named;
  for (std::size_t i = 1; i < row.fields.size(); ++i) {
    const std::string_view name = trimmed(row.fields[i]);
    if (name.empty()) continue;
    const bool is_station = stations.find(name).standing != Standing::unknown;
    if (!is_station || !named.insert(name).second) return false;
  }
  return !named.empty();
}

/// The line of a row near the beginning that looks like the header; nothing where none does, or the
/// rows have no lines.
std::optional<std::size_t> line_of_names(const Table& table, const ReadingsStations& stations) {
  constexpr std::size_t rows_looked_at = 100;
  if (table.header_line() == 0 || table.numbers_rows()) return std::nullopt;
  try {
    const std::unique_ptr<Table> rows = table.first_rows();
    Row row;
    for (std::size_t i = 0; rows && i < rows_looked_at && rows->next(row); ++i)
      if (names_stations(row, stations)) return row.line;
  } catch (const Error&) {
    // A row that has a fault is none of names.
  }
  return std::nullopt;
}

}  // namespace

WideReadings::WideReadings(ReadingsSource source, const ReadingsLayout& layout)
    : source_(std::move(source)),
      time_(layout.time),
      index_(layout.index),
      time_meant_(layout.time_meant),
      readings_(source_.stations->all().size(), std::numeric_limits<double>::quiet_NaN()),
      repeated_(source_.table->again(), time_) {
  match_columns();
  source_.findings.complaints().throw_if_any();
}

void WideReadings::match_columns() {
  const std::vector<std::string>& header = source_.table->header();
  const std::size_t line = source_.table->header_line();
  if (header.size() < 2) {
    std::string fault;
    const bool is_dly_record = header.size() == 1 && read_dly_record(header[0], true, fault);
    const Wording skipping = line == 0 ? Wording()
                                       : "where lines stand above its header, " +
                                             setting("rainfall_skip") + " says how many";
    throw Error(
        {source_.table->file(), line,
         "has the one column " + quoted(header.empty() ? "" : header[0], 80) +
             ", and none of readings",
         is_dly_record ? "files of GHCN-Daily are known by names that end in .dly" : skipping});
  }
  require_a_station();
  require_whole_time();
  constexpr std::size_t none = 0;  // a column's number counts from 1
  std::vector<std::size_t> column_of(readings_.size(), none);
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (!is_of_stations(i)) continue;
    const ReadingsStations::Found found = source_.stations->find(header[i]);
    if (found.standing == Standing::unknown) note_unknown_column(i);
    if (found.standing != Standing::known) continue;
    std::size_t& column = column_of[index(found.station)];
    if (column != none) {
      source_.findings.complaints().add({source_.table->file(), line,
                                         "columns " + std::to_string(column) + " and " +
                                             std::to_string(i + 1) + " are both of station " +
                                             quoted(source_.stations->id(found.station)),
                                         ""});
    }
    column = i + 1;
    columns_.push_back({i, found.station});
  }
}

/// A table whose header names no station at all is more likely of another layout than of twenty
/// unknown stations.
void WideReadings::require_a_station() const {
  const std::vector<std::string>& header = source_.table->header();
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (!is_of_stations(i)) continue;
    if (source_.stations->find(header[i]).standing != Standing::unknown) return;
  }
  Wording hint;
  if (const auto names = line_of_names(*source_.table, *source_.stations)) {
    hint = "line " + std::to_string(*names) +
           " names stations: " + setting("rainfall_skip", std::to_string(*names - 1)) +
           " takes it for the header";
  }
  for (std::size_t i = 0; i < header.size() && hint.empty(); ++i) {
    if (is_of_stations(i)) hint = source_.stations->meant_by(header[i]).hint;
  }
  if (hint.empty()) {
    hint = "where a row is one reading, " + setting("station_field") + " and " +
           setting("value_field") + " name its columns";
  }
  throw Error({source_.table->file(), source_.table->header_line(),
               "no column is called as a station of " + input("stations") + ", such as " +
                   quoted(source_.stations->all().front().id, 80) + "; the columns are " +
                   listed(header),
               hint});
}

void WideReadings::note_unknown_column(std::size_t field) {
  const std::string& id = source_.table->header()[field];
  const std::string text = id.empty() ? "column " + std::to_string(field + 1) + " has no name"
                                      : "unknown station " + quoted(id);
  const Wording hint = setting("ignore_unknown") +
                       " passes over it; a table of one reading a row is told by " +
                       setting("station_field") + " and " + setting("value_field");
  source_.findings.note_unknown(id, source_.table->header_line(), text,
                                time_meant_.empty() ? hint : time_meant_);
}

/// Refuses a table in which the time seems to stand in more columns than it is read from: to pass
/// over these would make one time of several.
void WideReadings::require_whole_time() const {
  if (time_meant_.empty() || !source_.findings.ignores_unknown()) return;
  throw time_in_more_columns(*source_.table, time_.columns().front().field, time_meant_);
}

bool WideReadings::next(TimeStep& step) {
  if (done_) return false;
  while (read_row()) {
    step.time = time_.text(row_);
    step.line = row_.line;
    step.written = source_.times.read(step.time, step.line);
    if (step.written && step.written->is_no_time() && is_silent()) {
      source_.findings.note_passed(step.time, step.line);
      continue;
    }
    ++steps_;
    source_.findings.note_format(step);
    if (!source_.findings.complaints().empty()) continue;
    step.readings = readings_;
    source_.findings.note_step(step);
    return true;
  }
  done_ = true;
  conclude();
  return false;
}

bool WideReadings::is_waiting(std::chrono::milliseconds patience) {
  const bool reports_faults = !source_.findings.complaints().empty();
  return !done_ && !last_came_again_ && !reports_faults && source_.is_waiting(patience);
}

/// Whether no gauge reports in the row.
bool WideReadings::is_silent() const {
  return std::ranges::all_of(readings_, [](double reading) { return std::isnan(reading); });
}

void WideReadings::conclude() {
  Complaints twice;
  for (RepeatedTimes::Repeat repeat; repeated_.next(repeat);) {
    twice.add_by_line(source_.findings.time_twice(repeat.time, repeat.line, repeat.first_line));
  }
  source_.findings.complaints().add(twice);
  source_.findings.conclude(steps_);
  if (steps_ == 0) source_.findings.warn("there is no time step");
}

/// Reads the next row. Returns false at the end, and where a pipe with a fault is read no further.
bool WideReadings::read_row() {
  if (last_came_again_ || source_.gives_up() || !source_.next(row_)) return false;
  note_time(time_.text(row_));
  if (last_came_again_) return false;
  for (const Column& column : columns_) {
    const std::string_view field = row_.fields[column.field];
    const Reading reading = source_.grammar.read(field, row_.padded);
    readings_[index(column.station)] = reading.amount;
    if (source_.findings.note(reading, column.station)) continue;
    source_.findings.note_oddity(reading, {row_.line, column.station}, field, source_.grammar);
  }
  return true;
}

/// Takes note of the time of a row. A step that a pipe brings again is told at once, for its end
/// may never come; times that lie farther apart are compared at the end.
void WideReadings::note_time(std::string_view time) {
  if (trimmed(time).empty()) {
    source_.findings.note_empty_time(row_.line);
    return;
  }
  if (source_.steps_may_come_again) return;
  repeated_.note(time, row_.line);
  if (!source_.steps_as_they_come) return;
  last_came_again_ = time == last_time_;
  last_time_ = time;
}

}  // namespace thiessen
