#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/step_key.h"
#include "text/csv_reader.h"

namespace thiessen {

/// What the rows of a table of rain hold.
struct RainShape {
  std::string header;               ///< as it is written, with its line end
  std::size_t rows = 1;             ///< that a step has
  std::vector<std::size_t> values;  ///< the columns of a row that hold rainfall, from 0
};

/// A step of a table that is cut off.
struct CutStep {
  std::string text;            ///< what there is of it, or the beginning
  std::optional<StepKey> key;  ///< nothing where its time is cut off itself
  bool may_be_whole = false;   ///< it lacks nothing but a line end
};

/// A table of rain that an earlier run has written: which steps it has, and their values.
///
/// It is read once. Where its times are moments that ascend, the place of every 512th step is kept,
/// and whoever asks for a step has the steps round it read again; else it is read twice, and 16
/// bytes a step are kept. A line at the end without a line end is cut off, and so is a last step
/// without all its rows: the writer was ended. It does not count.
class EarlierRain {
 public:
  /// Reads the bytes from a place on into a span, and returns how many they are; 0 at the end.
  using Read = std::function<std::size_t(std::size_t at, std::span<char> into)>;

  /// Throws Error where the columns are others than those of `shape`, with the first difference,
  /// where a row cannot be read, and where a step but the last has not all its rows.
  EarlierRain(std::string file, std::size_t size, Read read, RainShape shape);

  std::size_t steps() const { return steps_; }
  /// How many bytes of it are whole.
  std::size_t whole_bytes() const { return whole_; }
  bool has_crlf() const { return header_.ends_with("\r\n"); }
  const std::string& first_time() const { return first_time_; }
  const StepKey& first() const { return first_; }
  /// The latest of its steps, where they are moments.
  const StepKey& latest() const { return latest_; }
  const std::optional<CutStep>& cut() const { return cut_; }

  /// The values of a step, row by row, NaN where there is none; null where it has no such step.
  /// Valid until the next call.
  const std::vector<double>* find(const StepKey& key);

 private:
  struct Place {
    StepKey key;
    std::size_t at;
  };
  struct Hashed {
    std::uint64_t hash;
    std::size_t at;
  };
  struct Step {
    StepKey key;
    std::vector<double> values;
  };
  /// A step as it is read, by its first row.
  struct Reached {
    std::string time;
    std::size_t at = 0;
    std::size_t line = 0;
    std::size_t rows = 0;
  };

  void read_header();
  void find_cut_line();
  void cut_at(std::size_t at);
  bool has_all_fields(const std::string& row) const;
  void read_steps();
  void note(const Reached& step);
  void hash_steps();
  std::unique_ptr<CsvReader> rows_from(std::size_t at) const;
  std::string bytes(std::size_t from, std::size_t to) const;
  void load(std::size_t at, std::size_t steps);
  const std::vector<double>* find_loaded(const StepKey& key);

  std::string file_;
  Read read_;
  std::size_t whole_;  ///< first the size of the file
  RainShape shape_;
  std::string header_;
  std::size_t steps_ = 0;
  std::string first_time_;
  StepKey first_;
  StepKey latest_;
  bool ascends_ = true;
  std::optional<CutStep> cut_;
  std::vector<Place> places_;   ///< where times ascend
  std::vector<Hashed> hashed_;  ///< where they do not, by hash
  std::vector<Step> loaded_;    ///< the steps round the one that was asked for last
  std::size_t next_ = 0;        ///< of these, the one behind it
};

}  // namespace thiessen
