#pragma once

#include <string>

#include "cli/options/option_list.h"
#include "readings/readings_reader.h"

namespace thiessen::cli {

/// The argument RAINFALL, and the options that say how to read it.
class RainfallOptions : public OptionBlock {
 public:
  std::string rainfall;

  void declare(OptionList& options, Need need);
  /// Declares RAINFALL as the value of an option under the given heading, and not as an argument.
  void declare_as_option(OptionList& options, const std::string& group, const std::string& name,
                         const std::string& help);
  /// The settings of the reader. `decimal_comma` is passed in because it is an option of the study.
  ReadingsOptions readings(bool decimal_comma) const;
  /// Throws UsageError for options that are about readings where there are none.
  void check() const;
  bool given() const { return !rainfall.empty(); }
  /// The name of RAINFALL in messages.
  std::string name() const { return rainfall == "-" ? "standard input" : rainfall; }

 private:
  void declare_meaning(OptionList& options);

  ReadingsOptions readings_;
};

}  // namespace thiessen::cli
