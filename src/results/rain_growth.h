#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "basin/basin.h"
#include "results/earlier_rain.h"
#include "results/rain_file.h"

namespace thiessen {

/// The shape of the table that RainFile writes, or RainTotalsFile where it has totals.
RainShape rain_shape(const std::vector<Basin>& basins, const RainFormat& format, bool has_totals);

/// Decides which steps of a series a table lacks that an earlier run has written.
///
/// A step that is there stays as it is. Where its values are others than those of this run, by more
/// than one of the last decimal, that is a warning; and so are steps that lie before the last one
/// that was there, for they are added behind it.
class RainGrowth {
 public:
  /// `file` is the table's name. `noun` is what it has, a step or a period. No `earlier`: there is
  /// no table yet. It must outlive this object.
  RainGrowth(std::string file, std::string noun, EarlierRain* earlier, int decimals);

  /// Says that the readings are counters: the first step of a run has no rain, for nothing tells
  /// what they read before. Where the table has that step, its value counts; where it lacks it, the
  /// step is added empty, with a warning.
  void is_of_counters() { is_of_counters_ = true; }
  bool has_crlf() const { return earlier_ != nullptr && earlier_->has_crlf(); }
  /// Takes the next step, with its values row by row. Returns whether the table lacks it. Throws
  /// Error where its time is not of the kind that is there.
  bool lacks(const std::string& time, std::span<const double> values);
  bool has_added() const { return added_ > 0; }
  /// Whether the table is to be written: steps are added, or a cut one is taken off.
  bool changes() const;
  /// Says that a cut step is taken off, before it is known whether it comes again. Then `conclude`
  /// says no more of it.
  void tell_cut_taken_off(Warnings& warnings);
  /// Says, once, that there are steps with other values, or that one is added empty: of a series
  /// that may not end.
  void tell_so_far(Warnings& warnings);
  /// Says how many steps are added and how many were there, and what is odd. Throws Error where
  /// the last line lacks its end alone, and its step has not come: it would be lost.
  void conclude(Warnings& warnings);

 private:
  /// Steps of which something is to be said.
  struct Noted {
    std::size_t count = 0;
    std::string first;

    void note(const std::string& time) {
      if (count++ == 0) first = time;
    }
  };

  void require_alike(const StepKey& key, const std::string& time) const;
  bool are_same(std::span<const double> there, std::span<const double> now) const;
  std::string counted(std::size_t count) const;
  std::string cut_in_words() const;
  void tell_cut(Warnings& warnings) const;
  bool begins_counters(std::span<const double> values);
  void tell_others(Warnings& warnings);
  void tell_lost(Warnings& warnings);

  std::string file_;
  std::string noun_;
  EarlierRain* earlier_;
  double unit_;  ///< one of the last decimal
  std::size_t added_ = 0;
  Noted others_;  ///< steps that are there with other values
  Noted late_;    ///< steps added that lie before the last that was there
  bool is_of_counters_ = false;
  bool has_begun_ = false;
  std::string lost_;  ///< the time of a step added empty, as counters begin with it
  bool has_cut_come_ = false;
  bool has_told_cut_ = false;
  std::size_t others_told_ = 0;
};

}  // namespace thiessen
