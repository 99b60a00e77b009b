#pragma once

#include <string>

#include "cli/options/option_list.h"
#include "readings/readings_reader.h"

namespace thiessen::cli {

/// RAINFALL and what says how to read it.
class RainfallOptions : public OptionBlock {
 public:
  std::string rainfall;

  void declare(OptionList& options, Need need);
  /// RAINFALL as the value of an option, which stands under the given heading.
  void declare_as_option(OptionList& options, const std::string& group, const std::string& name,
                         const std::string& help);
  /// `decimal_comma` is an option of the study.
  ReadingsOptions readings(bool decimal_comma) const;
  bool given() const { return !rainfall.empty(); }
  /// For messages.
  std::string name() const { return rainfall == "-" ? "standard input" : rainfall; }

 private:
  void declare_meaning(OptionList& options);

  ReadingsOptions readings_;
};

}  // namespace thiessen::cli
