#include "readings/joined_readings.h"

#include <cmath>
#include <utility>

#include "base/iso_time.h"
#include "base/number.h"
#include "base/utf8.h"
#include "readings/stations/named_stations.h"

namespace thiessen {
namespace {

constexpr std::uint64_t lines_in_a_file = std::uint64_t{1} << 40U;
constexpr std::size_t moment_bytes = 12;
constexpr std::size_t longest_time = 80;

void append_number(std::string& bytes, std::uint64_t number, unsigned size) {
  while (size-- > 0) bytes += static_cast<char>(number >> (8 * size) & 0xFFU);
}

/// The time of a step as bytes: first its moment, so that bytes are in the order of time; then what
/// it says, where its text is not of ISO 8601; then its text.
std::string time_bytes(const TimeStep& step, const IsoTime& time) {
  std::string bytes;
  constexpr std::uint64_t zero = std::uint64_t{1} << 63U;
  append_number(bytes, static_cast<std::uint64_t>(moment_seconds(time)) + zero, 8);
  append_number(bytes, static_cast<std::uint64_t>(time.nanosecond), 4);
  const std::string said = step.written ? iso_text(time) : "";
  bytes += static_cast<char>(said.size());
  return bytes + said + step.time;
}

/// Takes the time of a step from its bytes.
void read_time(std::string_view bytes, TimeStep& step) {
  const auto size = static_cast<unsigned char>(bytes[moment_bytes]);
  step.time = bytes.substr(moment_bytes + 1 + size);
  step.written.reset();
  if (size > 0) {
    step.written.emplace();
    step.written->parsed = parse_iso_time(bytes.substr(moment_bytes + 1, size));
  }
}

}  // namespace

JoinedReadings::JoinedReadings(std::vector<File> files, std::string name,
                               std::span<const Station> stations, Warnings& warnings,
                               std::size_t memory)
    : files_(std::move(files)),
      name_(std::move(name)),
      stations_(stations),
      warnings_(warnings),
      sorter_(PieceSorter::Order::by_time, memory),
      readings_(stations.size()),
      places_(stations.size()),
      heard_(stations.size()),
      steps_(stations.size()) {
  open();
  while (!now_.readings && files_read_ + 1 < files_.size()) {
    close();
    open();
  }
}

bool JoinedReadings::next(TimeStep& step) {
  if (done_) return false;
  done_ = true;  // if an exception comes, no step follows it
  if (!is_read_) read_all();
  while (has_piece_) {
    readings_.assign(readings_.size(), std::numeric_limits<double>::quiet_NaN());
    const std::string moment(piece_.time.substr(0, moment_bytes));
    std::uint64_t first = std::numeric_limits<std::uint64_t>::max();
    do {
      if (piece_.first_line < first) {
        first = piece_.first_line;
        read_time(piece_.time, step);
      }
      take(piece_);
      has_piece_ = sorter_.next(piece_);
    } while (has_piece_ && piece_.time.starts_with(moment));
    if (!disagreed_.empty()) continue;
    step.line = 0;
    step.readings = readings_;
    steps_.note(calendar_time(step.time, step.written), step.time, 0, readings_);
    done_ = false;
    return true;
  }
  conclude();
  return false;
}

double JoinedReadings::share_read() const {
  const double of_now = now_.readings ? now_.readings->share_read() : 0;
  return (static_cast<double>(files_read_) + (std::isnan(of_now) ? 0 : of_now)) /
         static_cast<double>(files_.size());
}

/// Opens the first file that is not read.
void JoinedReadings::open() {
  of_file_ = Warnings();
  now_ = files_[files_read_].open(of_file_);
  if (!now_.readings) return;
  require_unit();
  require_stamp();
}

void JoinedReadings::close() {
  now_ = {};
  said_.add(of_file_);
  ++files_read_;
}

/// Requires a unit that contradicts no other file's. That one file says it and another does not is
/// told.
void JoinedReadings::require_unit() {
  const std::string unit = now_.readings->unit();
  if (!tells_unit_) {
    unit_ = unit;
    tells_unit_ = files_read_;
  }
  if (unit == unit_) return;
  const auto words = [](const std::string& of) {
    return of.empty() ? std::string("no unit that is known") : of;
  };
  const std::string text = "its readings are in " + words(unit) + ", and those of " +
                           quoted(files_[*tells_unit_].name) + " in " + words(unit_);
  const Wording hint = setting("from_unit") + " says it of all files";
  if (!unit.empty() && !unit_.empty()) throw Error({files_[files_read_].name, 0, text, hint});
  of_file_.add({files_[files_read_].name, 0, text + ": they are taken for the same", hint});
}

/// Requires times that are of their steps what those of the other files are. That one file says it
/// and another does not is told.
void JoinedReadings::require_stamp() {
  const std::optional<Stamp> stamp = now_.readings->stamp();
  if (!tells_stamp_) {
    stamp_ = stamp;
    tells_stamp_ = files_read_;
  }
  if (stamp == stamp_) return;
  const auto words = [](std::optional<Stamp> of) {
    return !of                 ? std::string("say nothing of their steps")
           : *of == Stamp::end ? std::string("end their steps")
                               : std::string("begin their steps");
  };
  const std::string& first = files_[*tells_stamp_].name;
  const std::string text =
      "its times " + words(stamp) + ", and those of " + quoted(first) + " " + words(stamp_);
  if (stamp && stamp_)
    throw Error({files_[files_read_].name, 0, text, "read them apart from each other"});
  of_file_.add({files_[files_read_].name, 0, text + ": they are taken for the same", ""});
}

void JoinedReadings::read_all() {
  is_read_ = true;
  while (files_read_ < files_.size()) {
    if (!now_.readings) open();
    TimeStep step;
    while (now_.readings && now_.readings->next(step)) add(step, files_read_);
    close();
  }
  has_piece_ = sorter_.next(piece_);
}

void JoinedReadings::add(const TimeStep& step, std::size_t file) {
  const ParsedTime parsed = calendar_time(step.time, step.written);
  if (!parsed) {
    const bool has_words = step.written && !step.written->fault.empty();
    throw Error(
        {files_[file].name, step.line,
         "time " + quoted(step.time, longest_time) +
             (has_words ? step.written->fault : Wording(" is not one of the calendar")) +
             ", and several files are joined by their times",
         has_words ? step.written->hint : setting("time_format") + " says how times are written"});
  }
  found_.clear();
  for (std::uint32_t i = 0; i < step.readings.size(); ++i) {
    if (std::isnan(step.readings[i])) continue;
    const auto station = static_cast<std::uint32_t>(index(now_.first)) + i;
    found_.push_back({step.readings[i], StationIndex{station}, 0});
  }
  const std::string time = time_bytes(step, parsed.time);
  const std::uint64_t place = file * lines_in_a_file + step.line;
  sorter_.add({place, place, time, found_});
}

void JoinedReadings::take(const ReadingsPiece& piece) {
  for (const PieceReading& reading : piece.readings) {
    const std::size_t station = index(reading.station);
    double& known = readings_[station];
    if (std::isnan(known)) {
      known = reading.amount;
      places_[station] = piece.first_line;
      heard_[station] = true;
    } else if (known == reading.amount) {
      ++agreed_;
    } else {
      complain_of(station, reading.amount, piece.first_line, piece.time);
    }
  }
}

void JoinedReadings::complain_of(std::size_t station, double amount, std::uint64_t place,
                                 std::string_view time) {
  TimeStep step;
  read_time(time, step);
  disagreed_.add({files_[place / lines_in_a_file].name, place % lines_in_a_file,
                  "the reading of station " + quoted(stations_[station].id) + " at " +
                      quoted(step.time, longest_time) + " is " + shortest_text(amount) + ", and " +
                      shortest_text(readings_[station]) + " in " + place_text(places_[station]),
                  "keep the file, or the row, that is right"});
}

std::string JoinedReadings::place_text(std::uint64_t place) const {
  const std::uint64_t line = place % lines_in_a_file;
  return files_[place / lines_in_a_file].name + (line > 0 ? ":" + std::to_string(line) : "");
}

void JoinedReadings::conclude() {
  disagreed_.throw_if_any();
  if (!steps_may_differ_) {
    if (const auto fault = steps_.fault(name_, stations_)) throw Error(*fault);
  }
  said_.pass_on(warnings_);
  if (agreed_ > 0) {
    warnings_.add_notice({name_, 0,
                          agreed_ == 1 ? "a reading stands in two files alike, and counts once"
                                       : std::to_string(agreed_) +
                                             " readings stand in two files or more alike, and "
                                             "count once",
                          ""});
  }
  if (!tells_silent_) return;
  std::vector<std::string> first;
  std::size_t silent = 0;
  for (std::size_t i = 0; i < heard_.size(); ++i) {
    if (heard_[i]) continue;
    if (++silent <= stations_named) first.push_back(stations_[i].id);
  }
  if (silent > 0) warnings_.add({name_, 0, without_readings(first, silent, ""), ""});
}

}  // namespace thiessen
