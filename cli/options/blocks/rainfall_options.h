#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/blocks/csv_options.h"
#include "cli/options/blocks/totals_options.h"
#include "cli/options/option_list.h"
#include "files/rainfall/rainfall_file.h"
#include "rainfall/series/stamp.h"
#include "readings/readings_reader.h"

namespace thiessen::cli {

class PeriodOptions;

/// The argument RAINFALL, or a field of STATIONS in its place, and the options that say how to read
/// it.
class RainfallOptions : public OptionBlock {
 public:
  /// `stations` is the argument STATIONS, where the readings of one event may stand.
  void declare(OptionList& options, Need need, const std::string& stations);
  /// Declares RAINFALL as the value of an option under the given heading, and not as an argument.
  void declare_as_option(OptionList& options, const std::string& group, const std::string& name,
                         const std::string& help);
  /// The settings of the reader, where the study says `all` of all CSV files.
  ReadingsOptions readings(const CsvDialect& all) const;
  /// The files of RAINFALL; none where it is not given.
  std::vector<std::string> files() const;
  /// These files, and RAINFALL's: all that a command reads.
  std::vector<std::string> files_beside(std::vector<std::string> others) const;
  bool is_standard_input() const { return files() == std::vector<std::string>{"-"}; }
  /// RAINFALL with what is said of it, where the study says `all` of all CSV files.
  RainfallRequest request(const CsvDialect& all) const;
  /// What is said of how RAINFALL is written, where it is a CSV.
  CsvDialect csv(const CsvDialect& all) const;
  /// Throws UsageError for options that are about readings where there are none.
  void check() const;
  /// Throws UsageError for files that cannot be read together.
  void check_files() const;
  /// Throws UsageError for a factor beside a unit.
  void check_units() const;
  bool given() const { return !files().empty() || is_event(); }
  /// Whether RAINFALL is a pipe, whose end may be far.
  bool is_fed() const { return !files().empty() && thiessen::is_fed(request({})); }
  /// Has steps of a pipe be read as they come.
  void want_steps_as_they_come() { readings_.steps_as_they_come = true; }
  /// Has steps of such a pipe be passed over that come again.
  void want_steps_once() { readings_.steps_may_come_again = true; }
  /// Whether the readings are those of one event, in a field of STATIONS.
  bool is_event() const {
    return files().empty() && stations_ != nullptr && !readings_.value_field.empty();
  }
  /// Whether readings are counters.
  bool is_cumulative() const { return readings_.cumulative; }
  /// The first option about readings or totals that is given; nullptr where none is.
  const Option* first_given() const;
  /// Declares --stamp, which commands without periods have for totals alone.
  void declare_stamp(OptionList& options) { totals_.declare_stamp(options); }
  /// Has the stamp be that of the periods, which must outlive this.
  void times_are_of(const PeriodOptions& periods) { periods_ = &periods; }
  /// What times are of their steps, as far as options say it.
  Stamp stamp() const;
  /// The totals of other gauges beside RAINFALL.
  const TotalsOptions& totals() const { return totals_; }
  /// The file of readings that count as missing; nothing where none is given.
  std::optional<std::string> exclude() const {
    return exclude_option_->is_given() ? std::optional(exclude_) : std::nullopt;
  }
  /// What the readings of an event are called: their field.
  const std::string& event() const { return readings_.value_field; }
  /// The name of the file of readings in messages.
  std::string name() const;

 private:
  void declare_rows(OptionGroup& readings);
  void declare_meaning(OptionList& options);
  void declare_amounts(OptionGroup& readings);

  void check_event() const;

  ReadingsOptions readings_;
  TotalsOptions totals_;
  std::string rainfall_;
  std::vector<std::string> repeated_;
  CsvOptionsOf csv_;
  std::string layer_;
  std::string where_;
  std::string exclude_;
  double scale_ = 1;
  const std::string* stations_ = nullptr;
  const PeriodOptions* periods_ = nullptr;
  const Option* scale_option_ = nullptr;
  const Option* exclude_option_ = nullptr;
  std::vector<const Option*> of_tables_;  ///< what an event in STATIONS has no use for
};

}  // namespace thiessen::cli
