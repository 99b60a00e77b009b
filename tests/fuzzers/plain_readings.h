#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzzers/bytes.h"
#include "text/csv_writer.h"

namespace thiessen::fuzzers {

constexpr double silent = -1;  // stands for NaN, which equals nothing

/// A time and its amounts, by station.
struct Step {
  std::string time;
  std::vector<double> amounts;
  friend bool operator==(const Step& a, const Step& b) = default;
};
using Steps = std::vector<Step>;

/// Readings that bytes stand for, as they are and as tables that hold them.
class PlainReadings {
 public:
  /// A reading as it is written, and what it is.
  struct Entry {
    std::size_t time = 0;
    std::size_t station = 0;
    std::string field;
    double amount = silent;
  };

  explicit PlainReadings(Bytes& bytes) : decimal_comma_(bytes.below(4) == 0) {
    constexpr std::array<std::string_view, 9> ids = {"A",   "b c", " A",      "1",    "-9999",
                                                     "C,1", "\"",  "station", "value"};
    choose(bytes, ids, 1 + bytes.below(4), ids_);
    choose_times(bytes);
    entries_.resize(times_.size() * ids_.size());
    for (std::size_t i = 0; i < entries_.size(); ++i)
      entries_[i] = any_entry(bytes, i / ids_.size(), i % ids_.size());
  }

  bool decimal_comma() const { return decimal_comma_; }
  const std::vector<std::string>& ids() const { return ids_; }
  /// The readings in the order of times, but for some of the silent ones. No time is left out.
  std::vector<Entry> entries() const {
    std::vector<Entry> kept = entries_;
    std::erase_if(kept,
                  [](const Entry& entry) { return entry.station > 0 && entry.field.empty(); });
    return kept;
  }

  /// A table with a column a station.
  std::string wide() const {
    std::string text = "t";
    for (const std::string& id : ids_) append_csv_field(text += ',', id);
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (i % ids_.size() == 0) append_csv_field(text += '\n', times_[i / ids_.size()]);
      append_csv_field(text += ',', entries_[i].field);
    }
    return text + '\n';
  }
  /// A table with a row a reading, in this order: t is the time, s the station, v the value.
  std::string as_long(const std::vector<Entry>& entries) const {
    std::string text = "s,x,v,t\n";
    for (const Entry& entry : entries) {
      append_csv_field(text, ids_[entry.station]);
      append_csv_field(text += ",x,", entry.field);
      append_csv_field(text += ',', times_[entry.time]);
      text += '\n';
    }
    return text;
  }

  Steps steps() const { return steps(entries_); }
  /// The steps in the order in which the times first come.
  Steps steps(const std::vector<Entry>& entries) const {
    Steps steps;
    for (const Entry& entry : entries) {
      const std::string& time = times_[entry.time];
      auto step = std::find_if(steps.begin(), steps.end(),
                               [&](const Step& candidate) { return candidate.time == time; });
      if (step == steps.end())
        step = steps.insert(step, {time, std::vector<double>(ids_.size(), silent)});
      step->amounts[entry.station] = entry.amount;
    }
    return steps;
  }

 private:
  /// Some of a pool, each once, in any order.
  template <typename Pool>
  static void choose(Bytes& bytes, const Pool& pool, std::size_t count,
                     std::vector<std::string>& chosen) {
    while (count-- > 0) {
      const std::string next(bytes.one_of(pool));
      if (std::find(chosen.begin(), chosen.end(), next) == chosen.end()) chosen.push_back(next);
    }
  }
  void choose_times(Bytes& bytes) {
    constexpr std::array<std::string_view, 8> days = {"2019-12-31", "2020-01-01", "2020-01-02",
                                                      "2020-01-10", "2020-1-3",   "2020-02-01",
                                                      "2020-02",    "2021"};
    constexpr std::array<std::string_view, 8> numbers = {"8", "9",  "10",  "11",
                                                         "0", "09", "100", "10.5"};
    constexpr std::array<std::string_view, 8> texts = {"a,b", "\"", " x", "x ",
                                                       "x",   "\r", "é",  "\n1"};
    constexpr std::array<std::string_view, 8> hours = {
        "2020-01-01T00:00", "2020-01-01T06", "2020-01-01 12:00", "20200101T1800",
        "2020-01-02T00:00", "2020-01-02",    "2020-01-03T12:00", "2020-01-04T00:00"};
    constexpr std::array<std::string_view, 8> zones = {
        "2020-01-01T00:00Z",      "2020-01-01T01:00Z", "2020-01-01T03:00+01:00",
        "2020-01-01T05:00+02:00", "2020-01-01T04:00Z", "2020-01-01T06:00Z",
        "2020-01-01T03:00-05",    "2020-01-01T05:00"};
    const std::array<std::array<std::string_view, 8>, 5> pools = {days, numbers, texts, hours,
                                                                  zones};
    choose(bytes, bytes.one_of(pools), 1 + bytes.below(8), times_);
    if (bytes.below(2) == 0) std::sort(times_.begin(), times_.end());
  }
  Entry any_entry(Bytes& bytes, std::size_t time, std::size_t station) const {
    constexpr std::array<std::string_view, 8> gaps = {"",        "NA",    "-",     "-999",
                                                      "-9999.0", "-99.9", " nan ", "-099.90"};
    const std::size_t kind = bytes.below(8);
    Entry entry = {time, station, {}, silent};
    if (kind == 0) return entry;
    if (kind == 1) {
      entry.field = bytes.one_of(gaps);
    } else {
      entry.field = any_number(bytes);
      entry.amount = std::strtod(entry.field.c_str(), nullptr);
    }
    if (decimal_comma_) std::replace(entry.field.begin(), entry.field.end(), '.', ',');
    if (kind == 2) entry.field = " " + entry.field + "\t";
    return entry;
  }
  static std::string any_number(Bytes& bytes) {
    constexpr std::array<std::string_view, 6> beginnings = {"", "", "", "+", "00", "1234567890"};
    constexpr std::array<std::string_view, 6> ends = {"", "", "", "e0", "E-3", "00000000000000000"};
    std::string text(bytes.one_of(beginnings));
    text += std::to_string(bytes.next());
    if (bytes.below(2) == 0) text += "." + std::to_string(bytes.next());
    const std::string_view end = bytes.one_of(ends);
    return text.find('.') == std::string::npos && end.size() > 4 ? text : text + std::string(end);
  }

  bool decimal_comma_;
  std::vector<std::string> ids_;
  std::vector<std::string> times_;
  std::vector<Entry> entries_;  ///< by time, then by station
};

}  // namespace thiessen::fuzzers
