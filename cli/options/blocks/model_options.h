#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "cli/options/option_list.h"

namespace thiessen::cli {

/// The formats of series that models read.
enum class RainModel : std::uint8_t { netcdf, hype, swat, swmm, pi_xml };

/// The formats of weights that models read.
enum class WeightsModel : std::uint8_t { hms, raven };

/// The options that say in which model's format a series is written.
class RainModelOptions : public OptionBlock {
 public:
  std::string units = "mm";

  void declare(OptionList& options);
  /// The format; nothing for a table.
  const std::optional<RainModel>& model() const { return model_; }
  /// What the format is called. Requires one that is named.
  const std::string& name() const { return format_option_->texts.back(); }
  /// Whether a format is named, a table's too, so that the output may have any extension.
  bool is_named() const { return format_option_->is_given(); }
  bool are_units_given() const { return units_option_->is_given(); }
  /// Throws UsageError for options of the command that cannot act on what is written. `output` is
  /// where it goes, and `methods` how many values each basin has. Requires a command that declares
  /// --long, --iso-times, --append, --decimals and --error.
  void check(const OptionList& options, const std::string& output, std::size_t methods) const;

 private:
  void check_output(const std::string& output) const;

  std::optional<RainModel> model_;
  const Option* format_option_ = nullptr;
  const Option* units_option_ = nullptr;
};

/// The option that says in which model's format weights are written.
class WeightsModelOptions : public OptionBlock {
 public:
  void declare(OptionList& options);
  /// The format; nothing for a table.
  const std::optional<WeightsModel>& model() const { return model_; }
  /// Whether a format is named, a table's too, so that the output may have any extension.
  bool is_named() const { return format_option_->is_given(); }
  /// The option with what the format is called. Requires one that is named.
  std::string name() const { return "--format " + format_option_->texts.back(); }
  /// What the command line makes of the table of weights, which no model reads.
  struct OtherTable {
    bool is_influence = false;  ///< what gauges are worth
    bool is_change = false;     ///< the weights of two networks, compared
    bool is_database = false;
  };
  /// Throws UsageError where a format is named and the table is none of weights in a file.
  void check(const OtherTable& other) const;

 private:
  std::optional<WeightsModel> model_;
  const Option* format_option_ = nullptr;
};

}  // namespace thiessen::cli
