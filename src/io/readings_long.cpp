#include "io/readings_long.h"

#include <algorithm>
#include <limits>

#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint32_t no_step = 0xFFFFFFFF;

using Standing = ReadingsStations::Standing;

}  // namespace

bool LongReadings::next(TimeStep& step) {
  if (done_) return false;
  if (!loaded_) load();
  if (step_ == times_.size()) {
    done_ = true;
    source_.findings.conclude(times_.size());
    return false;
  }
  readings_.assign(source_.stations->all().size(), silent);
  for (std::uint32_t i = last_entry_[step_]; i != no_entry; i = entries_[i].previous) {
    readings_[index(entries_[i].station)] = entries_[i].amount;
  }
  step.time = times_.text(step_++);
  step.readings = readings_;
  return true;
}

void LongReadings::load() {
  loaded_ = done_ = true;  // unless all goes well, there is no step
  Row row;
  while (source_.next(row)) read_row(row);
  complain(twice_given());
  source_.findings.complaints().throw_if_any();
  done_ = false;
}

void LongReadings::read_row(const Row& row) {
  const std::uint32_t step = step_of(row);
  const ReadingsStations::Found found = station_of(row);
  if (found.standing != Standing::known) return;
  const std::string_view field = row.fields[layout_.value];
  const Reading reading = source_.grammar.read(field);
  if (!source_.findings.note(reading, found.station)) {
    source_.findings.note_oddity(reading, {row.line, found.station}, field, source_.grammar);
  }
  if (step != no_step) keep(step, found.station, reading.amount, row.line);
}

std::uint32_t LongReadings::step_of(const Row& row) {
  const std::string_view time = row.fields[layout_.time];
  if (trimmed(time).empty()) {
    source_.findings.note_empty_time(row.line);
    return no_step;
  }
  const ReadingsTimes::Entered entered = times_.enter(time, row.line);
  if (entered.fresh) last_entry_.push_back(no_entry);
  return entered.step;
}

ReadingsStations::Found LongReadings::station_of(const Row& row) {
  const std::string_view id = row.fields[layout_.station];
  if (id != last_id_ || id.empty()) {
    last_id_ = id;
    last_found_ = source_.stations->find(id);
  }
  if (last_found_.standing == Standing::unknown) {
    source_.findings.note_unknown(id, row.line, "unknown station " + quoted(id),
                                  "--ignore-unknown passes over its readings");
  }
  return last_found_;
}

void LongReadings::keep(std::uint32_t step, StationIndex station, double amount, std::size_t line) {
  const auto entry = static_cast<std::uint32_t>(entries_.size());
  if (entry == no_entry) {
    throw Error({source_.table->file(), line, "more readings than can be numbered", ""});
  }
  if (stretches_.empty() || entry + stretches_.back().ahead != line) {
    stretches_.push_back({entry, line - entry});
  }
  entries_.push_back({amount, station, last_entry_[step]});
  last_entry_[step] = entry;
}

std::vector<LongReadings::Twice> LongReadings::twice_given() const {
  std::vector<Twice> found;
  std::vector<std::uint32_t> later(source_.stations->all().size(), no_entry);
  std::vector<std::size_t> met_in_step(later.size(), times_.size());
  for (std::size_t step = 0; step < times_.size(); ++step) {
    for (std::uint32_t i = last_entry_[step]; i != no_entry; i = entries_[i].previous) {
      const std::size_t station = index(entries_[i].station);
      if (met_in_step[station] == step) found.push_back({later[station], i, step});
      met_in_step[station] = step;
      later[station] = i;
    }
  }
  return found;
}

void LongReadings::complain(std::vector<Twice> twice) {
  std::sort(twice.begin(), twice.end(),
            [](const Twice& a, const Twice& b) { return a.entry < b.entry; });
  Complaints complaints;
  for (const Twice& one : twice) {
    const std::string& id = source_.stations->id(entries_[one.entry].station);
    complaints.add({source_.table->file(), line_of(one.entry),
                    "the reading of station " + quoted(id) + " at " +
                        quoted(times_.text(one.step), 80) + " is already in line " +
                        std::to_string(line_of(one.before)),
                    ""});
  }
  source_.findings.complaints().add(complaints);
}

std::size_t LongReadings::line_of(std::uint32_t entry) const {
  const auto after =
      std::upper_bound(stretches_.begin(), stretches_.end(), entry,
                       [](std::uint32_t i, const Stretch& stretch) { return i < stretch.entry; });
  return entry + std::prev(after)->ahead;
}

}  // namespace thiessen
