#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "base/error.h"
#include "readings/readings_grammar.h"
#include "readings/readings_reader.h"
#include "readings/readings_stations.h"

namespace thiessen {

/// What is wrong or odd in a file of readings, gathered until its end.
class ReadingsFindings {
 public:
  ReadingsFindings(std::string file, const ReadingsStations& stations, bool ignore_unknown,
                   Warnings& warnings);

  /// Of the readings that follow, where they lie in several files: the lines are its.
  void now_in(const std::string& file) { file_ = file; }
  const std::string& file() const { return file_; }
  void warn(Wording text) { warnings_.add({file_, 0, std::move(text), ""}); }

  /// Where a field stands, for messages.
  struct Place {
    std::size_t line = 0;
    StationIndex station = {};
  };

  /// Takes note of a plain reading, and of a gap; whether it was one of these. Else: see
  /// note_oddity.
  bool note(const Reading& reading, StationIndex station) {
    if (!(reading.amount <= absurd_reading)) return reading.kind == ReadingKind::missing;
    heard_[index(station)] = Heard::yes;
    return true;
  }
  /// Takes note of what is wrong or odd about the field that was so read.
  void note_oddity(const Reading& reading, const Place& place, std::string_view field,
                   const ReadingGrammar& grammar);
  /// A station that is in no list; each is told once. `text` and `hint` are the complaint's.
  void note_unknown(std::string_view id, std::size_t line, const std::string& text,
                    const Wording& hint);
  void note_empty_time(std::size_t line);
  /// The complaint of a time that is given before.
  Message time_twice(std::string_view time, std::size_t line, std::size_t first_line) const;

  Complaints& complaints() { return complaints_; }
  const Complaints& complaints() const { return complaints_; }
  /// Throws the complaints, if there are any; else warns. `steps`: how many time steps there were.
  void conclude(std::size_t steps);

 private:
  void warn_of_unknown();
  void warn_of_silent();
  void warn_of_absurd();

  std::string file_;
  const ReadingsStations& stations_;
  bool ignore_unknown_;
  Warnings& warnings_;
  Complaints complaints_;
  /// Whether a station reads an amount at some time. No char, which could be a part of anything, so
  /// that all else would have to be loaded anew after each note.
  enum class Heard : std::uint8_t { no, yes };
  std::vector<Heard> heard_;  ///< by station
  std::unordered_set<std::string> unknown_;
  std::vector<std::string> first_unknown_;
  Message first_absurd_;
  std::size_t absurd_count_ = 0;
};

}  // namespace thiessen
