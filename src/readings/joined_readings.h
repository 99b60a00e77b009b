#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "rainfall/network/network.h"
#include "rainfall/series/readings.h"
#include "rainfall/series/stamp.h"
#include "readings/folded_warnings.h"
#include "readings/readings_sorter.h"
#include "readings/steps/mixed_steps.h"

namespace thiessen {

/// The readings of several files as one series, joined in time and by station.
///
/// Files are read one after the other, each of them in its own layout and way to write times, and
/// their steps are sorted by the calendar in some 32 MB of memory and in a temporary file (see
/// spool.h) of about 16 bytes a reading and 60 a step of a file: neither memory nor the number of
/// open files grows with their number. Times that are one moment are one step, written as in the
/// file that was named first.
///
/// Where a station has a reading in one file and none in another, the reading counts. Readings that
/// stand in several files are passed over where they agree, and said with their count; where they
/// differ, that is an error with both places.
class JoinedReadings : public Readings {
 public:
  /// The readings of a file; null where all of it is passed over. They may be of some of the
  /// stations alone, from `first` on: a file of one station then costs nothing for all others.
  struct Opened {
    Opened() = default;
    Opened(std::unique_ptr<Readings> readings,  // NOLINT(google-explicit-constructor)
           StationIndex first = {})
        : readings(std::move(readings)), first(first) {}

    std::unique_ptr<Readings> readings;
    StationIndex first = {};
  };
  /// One of the files, and how its readings are opened. What it warns of goes to the warnings,
  /// which live as long as the readings.
  struct File {
    std::string name;
    std::function<Opened(Warnings&)> open;
  };

  /// Opens the first file, which tells the unit of all. `name` is that of all files in messages.
  /// The stations and `warnings` must outlive this object. Requires a file. Throws Error.
  JoinedReadings(std::vector<File> files, std::string name, std::span<const Station> stations,
                 Warnings& warnings, std::size_t memory = std::size_t{32} << 20U);

  /// Says that stations that are silent in all files may report in another input.
  void is_beside_others() { tells_silent_ = false; }
  /// Says that each reading tells the length of its own step, so that no two lengths are a fault.
  void steps_may_differ() { steps_may_differ_ = true; }

  /// Reads all files before the first step. Throws Error as their readers do; where a time is not
  /// one of the calendar; where units differ, or what times are of their steps; and at the end
  /// where readings disagree, or steps as MixedSteps has it.
  bool next(TimeStep& step) override;
  std::string unit() const override { return unit_; }
  std::optional<Stamp> stamp() const override { return stamp_; }
  double share_read() const override;

 private:
  void open();
  void close();
  void read_all();
  void require_unit();
  void require_stamp();
  void add(const TimeStep& step, std::size_t file);
  void take(const ReadingsPiece& piece);
  void complain_of(std::size_t station, double amount, std::uint64_t place, std::string_view time);
  std::string place_text(std::uint64_t place) const;
  void conclude();

  std::vector<File> files_;
  std::string name_;
  std::span<const Station> stations_;
  Warnings& warnings_;
  Warnings of_file_;  ///< what is said of the file that is being read
  FoldedWarnings said_;
  Opened now_;  ///< of that file
  std::string unit_;
  std::optional<std::size_t> tells_unit_;  ///< the file that told it
  std::optional<Stamp> stamp_;
  std::optional<std::size_t> tells_stamp_;  ///< the first file that was opened
  PieceSorter sorter_;
  bool is_read_ = false;
  std::size_t files_read_ = 0;

  ReadingsPiece piece_;
  bool has_piece_ = false;
  std::vector<PieceReading> found_;
  std::vector<double> readings_;
  std::vector<std::uint64_t> places_;  ///< by station: where its reading stands
  std::vector<bool> heard_;
  std::size_t agreed_ = 0;
  Complaints disagreed_;
  MixedSteps steps_;
  bool done_ = false;
  bool tells_silent_ = true;
  bool steps_may_differ_ = false;
};

}  // namespace thiessen
