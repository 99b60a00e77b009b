#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/error.h"
#include "rainfall/series/readings.h"
#include "readings/readings_grammar.h"
#include "readings/readings_reader.h"
#include "readings/stations/readings_stations.h"
#include "readings/steps/mixed_steps.h"

namespace thiessen {

/// The readings are of counters, which say nothing of a step by themselves.
inline constexpr double of_a_counter = 0;

/// Gathers what is wrong or odd in a file of readings, and reports it at the end of the file.
class ReadingsFindings {
 public:
  ReadingsFindings(std::string file, const ReadingsStations& stations, bool ignore_unknown,
                   Warnings& warnings);

  /// Names the file of the readings that follow, where readings lie in several files. Line numbers
  /// count in this file.
  void now_in(const std::string& file) { file_ = file; }
  const std::string& file() const { return file_; }
  /// Says which table the readings are of, which must outlive this: it knows where its rows stand.
  void are_of(const Table& table) { table_ = &table; }
  /// A message about a row, with its place in the file.
  Message at(std::size_t row, Wording text, Wording hint) const;
  /// The same place within a sentence: `line 7`.
  std::string in_words(std::size_t row) const;
  /// The line of a row, 0 where none holds it.
  std::size_t line_of(std::size_t row) const {
    return table_ != nullptr && table_->numbers_rows() ? table_->place(row).line : row;
  }
  /// Whether readings of unknown stations are passed over.
  bool ignores_unknown() const { return ignore_unknown_; }
  void warn(Wording text) { warnings_.add({file_, 0, std::move(text), ""}); }

  /// Says how many millimetres a reading of 1 stands for, without which it is one. A number that is
  /// `of_a_counter` stands for none: no single one of a counter's readings is much or little.
  void amounts_are_in(double millimetres) { millimetres_ = millimetres; }

  /// Says what the user calls the file, whose settings are named so (rainfall), and whether the
  /// user says that its decimal marks are commas.
  void are_in(std::string input, bool commas_are_said) {
    input_ = std::move(input);
    commas_are_said_ = commas_are_said;
  }

  /// Says that the stations that are silent in this file may have readings in others.
  void are_of_one_file_of_several() { tells_silent_ = false; }
  /// Says that each reading tells the length of its own step, so that no two lengths are a fault.
  void steps_may_differ() { steps_may_differ_ = true; }

  /// The line and the station of a field, for messages.
  struct Place {
    std::size_t line = 0;
    StationIndex station = {};
  };

  /// Takes note of a reading that is plain or a gap, and returns true. Returns false for any other;
  /// that one has to be given to note_oddity.
  bool note(const Reading& reading, StationIndex station) {
    if (!(reading.amount <= plain_reading)) return reading.kind == ReadingKind::missing;
    heard_[index(station)] = Heard::yes;
    return true;
  }
  /// Takes note of a reading that is wrong (a complaint), or so large that it may be a code for a
  /// gap or more than falls (a warning). `field` is its text, and `grammar` is the one that it was
  /// read with.
  void note_oddity(const Reading& reading, const Place& place, std::string_view field,
                   const ReadingGrammar& grammar);
  /// Takes note of a large amount of rain, which stands as `field` in the file.
  void note_amount(double amount, const Place& place, std::string_view field);
  /// Takes note of a time step, once its readings are known, in the order of the file.
  void note_step(const TimeStep& step) {
    steps_.note(calendar_time(step.time, step.written), step.time, step.line, step.readings);
  }
  /// Complains of a time that is not written as those of its file are; of the first alone.
  void note_format(const TimeStep& step);
  /// Takes note of a station that is in no list; each is reported once. `text` and `hint` are those
  /// of the complaint; the hint gives way to what is known of a station that may be meant.
  void note_unknown(std::string_view id, std::size_t line, const std::string& text,
                    const Wording& hint);
  void note_empty_time(std::size_t line);
  /// Takes note of a row that has neither a time nor a reading, and is passed over.
  void note_passed(std::string_view text, std::size_t line);
  /// Makes the complaint that a time has been given before, in line `first_line`.
  Message time_twice(std::string_view time, std::size_t line, std::size_t first_line) const;

  Complaints& complaints() { return complaints_; }
  const Complaints& complaints() const { return complaints_; }
  /// Throws the complaints, if there are any; else gives the warnings. `steps` is the number of
  /// time steps in the file.
  void conclude(std::size_t steps);

 private:
  void tell_passed();
  void warn_of_unknown();
  void warn_of_silent();
  void warn_of_absurd();
  void warn_of_codes();
  Wording text_of(const Reading& reading, std::string_view field, const ReadingGrammar& grammar);
  Wording hint_for(const Reading& reading, std::string_view field, const ReadingGrammar& grammar);
  Wording hint_for(ReadingGrammar::Meant meant, std::string_view field) const;

  /// The largest reading that is looked at no further: less than any code for a gap.
  static constexpr double plain_reading = 99.9;
  /// A number that often stands for a gap, and where it stands.
  struct Code {
    double number;
    const char* text;
    std::size_t count = 0;
    StationIndex station = {};
    Message first = {};  ///< where it came first
  };
  /// Readings above a bound: the first of them, and how many.
  struct Absurd {
    Message first;
    std::size_t count = 0;
  };

  std::string file_;
  const Table* table_ = nullptr;  ///< null where row numbers are lines
  bool told_format_ = false;
  const ReadingsStations& stations_;
  bool ignore_unknown_;
  std::string input_ = "rainfall";
  bool commas_are_said_ = false;
  bool tells_silent_ = true;
  bool steps_may_differ_ = false;
  double millimetres_ = 1;  ///< that a reading of 1 stands for
  Warnings& warnings_;
  Complaints complaints_;
  /// Whether a station has an amount at some time. The type is no char, for the compiler must
  /// assume that a char may be part of any object, and would load everything else anew after each
  /// note.
  enum class Heard : std::uint8_t { no, yes };
  std::vector<Heard> heard_;  ///< by station
  std::unordered_set<std::string> unknown_;
  std::vector<std::string> first_unknown_;
  MixedSteps steps_;
  Absurd above_day_, above_year_;
  std::array<Code, 7> codes_ = {{{99.99, "99.99"},
                                 {999.9, "999.9"},
                                 {999.99, "999.99"},
                                 {9999, "9999"},
                                 {9999.9, "9999.9"},
                                 {9999.99, "9999.99"},
                                 {99999, "99999"}}};
  Message first_passed_ = {};
  std::size_t passed_ = 0;  ///< rows without a time and a reading
  std::set<std::pair<ReadingKind, ReadingGrammar::Meant>> told_hints_;
  std::set<ReadingsStations::Cause> told_causes_;
};

}  // namespace thiessen
