#include "readings/readings_dly.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"
#include "readings/dly/dly_files.h"
#include "readings/units/converted_readings.h"

namespace thiessen {
namespace {

using Standing = ReadingsStations::Standing;

constexpr double silent = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint32_t no_slot = 0xFFFFFFFF;
constexpr std::int32_t most_months = 1200;

CalendarMonth after(CalendarMonth month, std::int32_t months) {
  return CalendarMonth{number_of(month) + months};
}

void refuse_table_options(const std::string& rainfall, const ReadingsOptions& options) {
  const std::pair<const char*, bool> given[] = {{"time_field", !options.time_fields.empty()},
                                                {"time_format", !options.time_format.empty()},
                                                {"station_field", !options.station_field.empty()},
                                                {"value_field", !options.value_field.empty()},
                                                {"missing", !options.missing.empty()},
                                                {"trace", !options.trace.empty()},
                                                {"from_unit", options.from_unit.has_value()},
                                                {"cumulative", options.cumulative}};
  for (const auto& [name, is_given] : given) {
    if (is_given) {
      throw Error({rainfall, 0, setting(name) + " is for tables, not for .dly files", ""});
    }
  }
}

}  // namespace

DlyReadings::DlyReadings(DlySource source, std::size_t memory)
    : source_(std::move(source)),
      memory_(memory),
      slots_(source_.stations->all().size(), no_slot),
      readings_(slots_.size()) {}

bool DlyReadings::next(TimeStep& step) {
  if (done_) return false;
  if (!scanned_) {
    done_ = true;  // if an exception comes, no step follows it
    scan();
    begin_blocks();
    done_ = false;
  }
  while (next_day(step)) {
    source_.findings.note_step(step);
    if (source_.findings.complaints().empty()) return true;
  }
  done_ = true;
  conclude();
  return false;
}

double DlyReadings::share_read() const {
  if (!scanned_ || today_.day == 0) return std::numeric_limits<double>::quiet_NaN();
  const auto months = [&](CalendarMonth end) {
    return static_cast<double>(number_of(end) - number_of(first_.month));
  };
  return months(today_.month) / (months(last_.month) + 1);
}

void DlyReadings::scan() {
  scanned_ = true;
  for (std::uint32_t file = 0; file < source_.files.size(); ++file) {
    source_.findings.now_in(source_.files[file]);
    try {
      scan_file(file);
    } catch (const Error& error) {
      for (const Message& message : error.messages()) source_.findings.complaints().add(message);
    }
  }
}

void DlyReadings::scan_file(std::uint32_t file) {
  lines_.go(source_.files[file], {});
  bool empty = true;
  std::string fault;
  while (const auto line = lines_.next()) {
    if (trimmed(*line).empty()) continue;
    empty = false;
    const auto record = read_dly_record(*line, lines_.ends(), fault);
    if (!record) {
      complain(fault);
    } else if (record->element == source_.element) {
      scan_record(*record, file);
    }
  }
  if (empty) source_.findings.complaints().add({source_.files[file], 0, "is empty", ""});
}

void DlyReadings::scan_record(const DlyRecord& record, std::uint32_t file) {
  const ReadingsStations::Found found = station_of(record);
  if (found.standing != Standing::known) return;
  std::uint32_t& slot = slots_[index(found.station)];
  if (slot == no_slot) {
    slot = static_cast<std::uint32_t>(stations_.size());
    stations_.push_back(found.station);
  }
  scan_days(record, found.station);
  const Day begin = {record.month, 1};
  const Day end = {record.month, days_in(record.month)};
  if (first_.day == 0 || begin < first_) first_ = begin;
  if (last_ < end) last_ = end;
  if (stretches_.empty() || stretches_.back().file != file ||
      stretches_.back().last > record.month) {
    stretches_.push_back({file, record.month, record.month, lines_.place()});
  }
  stretches_.back().last = record.month;
}

ReadingsStations::Found DlyReadings::station_of(const DlyRecord& record) {
  if (record.id == last_id_) return last_found_;
  last_id_ = record.id;
  last_found_ = source_.stations->find(record.id);
  if (last_found_.standing == Standing::unknown) {
    source_.findings.note_unknown(
        record.id, lines_.place().line, "unknown station " + quoted(record.id),
        setting("ignore_unknown") + " reads the stations of " + input("stations") + " alone");
  }
  return last_found_;
}

void DlyReadings::scan_days(const DlyRecord& record, StationIndex station) {
  for (int day = 1; day <= 31; ++day) {
    const DlyDay read = read_dly_day(record, day);
    check_day(record, day, read, station);
    if (!read.is_number || read.value == dly_missing) continue;
    any_value_ = true;
    if (read.is_flagged && !source_.keep_flagged) continue;
    const Reading reading{read.value / 10.0, ReadingKind::amount};
    if (!source_.findings.note(reading, station))
      source_.findings.note_amount(reading.amount, {lines_.place().line, station},
                                   shortest_text(reading.amount));
  }
}

void DlyReadings::check_day(const DlyRecord& record, int day, const DlyDay& read,
                            StationIndex station) {
  const bool counts = !read.is_flagged || source_.keep_flagged;
  if (read.is_number && (read.value >= 0 || read.value == dly_missing || !counts)) {
    if (read.value == dly_missing || day <= days_in(record.month)) return;
    complain(text_of(record.month) + " has no day " + std::to_string(day) +
             ", but there is a value: " + quoted(trimmed(read.field)));
    return;
  }
  complain("value " + quoted(trimmed(read.field)) + " of station " +
           quoted(source_.stations->id(station)) + " on " + text_of(record.month, day) +
           (read.is_number ? " is negative" : " is no number"));
}

void DlyReadings::complain(std::string text) {
  const std::string& file = source_.findings.file();
  source_.findings.complaints().add({file, lines_.place().line, std::move(text), ""});
}

void DlyReadings::begin_blocks() {
  if (any_value_) today_ = first_;
  const std::size_t month = stations_.size() * sizeof(MonthOfStation) + 1;
  block_months_ =
      static_cast<std::int32_t>(std::clamp<std::size_t>(memory_ / month, 1, most_months));
  block_begin_ = after(first_.month, -block_months_);
}

bool DlyReadings::next_day(TimeStep& step) {
  if (today_.day == 0 || last_ < today_) return false;
  if (today_.month >= after(block_begin_, block_months_)) load_block();
  const std::size_t begin =
      static_cast<std::size_t>(number_of(today_.month) - number_of(block_begin_)) *
      stations_.size();
  readings_.assign(readings_.size(), silent);
  for (std::size_t slot = 0; slot < stations_.size(); ++slot) {
    const MonthOfStation& month = block_[begin + slot];
    const std::int32_t tenths = month.tenths[today_.day - 1];
    if (month.line == 0 || tenths == dly_missing) continue;
    readings_[index(stations_[slot])] = tenths / 10.0;
  }
  step.time = text_of(today_.month, today_.day);
  step.readings = readings_;
  step.line = 0;
  ++steps_;
  if (++today_.day > days_in(today_.month)) today_ = {after(today_.month, 1), 1};
  return true;
}

void DlyReadings::load_block() {
  block_begin_ = after(block_begin_, block_months_);
  block_.assign(static_cast<std::size_t>(block_months_) * stations_.size(), MonthOfStation{});
  for (Stretch& stretch : stretches_) {
    if (stretch.first < after(block_begin_, block_months_) && stretch.last >= block_begin_) {
      load(stretch);
    }
  }
}

void DlyReadings::load(Stretch& stretch) {
  lines_.go(source_.files[stretch.file], stretch.next);
  source_.findings.now_in(source_.files[stretch.file]);
  CalendarMonth before = stretch.first;
  std::string fault;
  while (const auto line = lines_.next()) {
    const auto record = read_dly_record(*line, lines_.ends(), fault);
    if (!record && !trimmed(*line).empty()) refuse_change();
    if (!record || record->element != source_.element) continue;
    const ReadingsStations::Found found = station_of(*record);
    if (found.standing != Standing::known) continue;
    stretch.next = lines_.place();
    if (record->month < before || record->month >= after(block_begin_, block_months_)) return;
    before = record->month;
    load(*record, found.station, stretch.file);
  }
}

void DlyReadings::load(const DlyRecord& record, StationIndex station, std::uint32_t file) {
  const std::uint32_t slot = slots_[index(station)];
  if (slot == no_slot || record.month < block_begin_) {
    refuse_change();
    return;
  }
  MonthOfStation& month = in_block(record.month, station);
  if (month.line != 0) {
    complain("station " + quoted(source_.stations->id(station)) + " has " + text_of(record.month) +
             " already in " + source_.files[month.file] + ":" + std::to_string(month.line));
    return;
  }
  month.file = file;
  month.line = lines_.place().line;
  for (int day = 1; day <= 31; ++day) {
    const DlyDay read = read_dly_day(record, day);
    const bool kept = read.is_number && (!read.is_flagged || source_.keep_flagged);
    month.tenths[day - 1] = kept ? read.value : dly_missing;
  }
}

void DlyReadings::refuse_change() const {
  if (!source_.findings.complaints().empty()) return;  // the scan found it and it will be reported
  throw Error(
      {source_.findings.file(), lines_.place().line, "the file changes while it is read", ""});
}

DlyReadings::MonthOfStation& DlyReadings::in_block(CalendarMonth month, StationIndex station) {
  const auto number = static_cast<std::size_t>(number_of(month) - number_of(block_begin_));
  return block_[number * stations_.size() + slots_[index(station)]];
}

void DlyReadings::conclude() {
  source_.findings.now_in(source_.name);
  source_.findings.conclude(steps_);
  if (steps_ == 0 && source_.element == "PRCP")
    source_.findings.warn("there is no value of PRCP of any station of " + input("stations"));
}

std::string_view dly_element(AmountsRead read) {
  switch (read) {
    case AmountsRead::of_steps:
    case AmountsRead::totals:
      return "PRCP";
    case AmountsRead::days:
      return "";
    case AmountsRead::sums:
      return "MDPR";
    case AmountsRead::days_of_sums:
      return "DAPR";
  }
  return "";
}

std::unique_ptr<Readings> open_dly_readings(const std::string& rainfall,
                                            std::span<const Station> stations,
                                            std::span<const std::string> passed_over,
                                            const ReadingsOptions& options, Warnings& warnings) {
  refuse_table_options(rainfall, options);
  const std::string element(dly_element(options.read));
  if (element.empty()) return nullptr;
  auto known = std::make_unique<const ReadingsStations>(
      stations, passed_over, IdJoin{options.ids_as_numbers, options.column_of});
  ReadingsFindings findings(rainfall, *known, options.ignore_unknown, warnings);
  if (options.is_one_of_several || options.is_beside_others) findings.are_of_one_file_of_several();
  if (options.steps_may_differ) findings.steps_may_differ();
  auto readings =
      std::make_unique<DlyReadings>(DlySource{rainfall, dly_files(rainfall), std::move(known),
                                              std::move(findings), options.keep_flagged, element});
  if (options.read != AmountsRead::days_of_sums)
    return converted(std::move(readings), conversion_from(*rain_unit("mm"), options));
  // What is taken for tenths of a millimetre are days.
  return converted(std::move(readings), {{10, 1}, "", 1});
}

}  // namespace thiessen
