#pragma once

#include <string>
#include <vector>

#include "base/destination.h"
#include "cli/options/option_list.h"

namespace thiessen::cli {

/// The options that say where results are written.
class OutputOptions : public OptionBlock {
 public:
  std::string output = "-";

  /// `kind` is the word for the output in the help, such as `map.png`.
  void declare(OptionList& options, Need need, const std::string& kind, const std::string& help);
  /// Declares the options of an output that is a folder.
  void declare_folder(OptionList& options, const std::string& help);
  bool overwrites() const { return overwrite_; }
  /// The rules by which the output is written. `inputs` are files that may not be overwritten.
  /// Throws Error where the output is a connection to a database.
  OutputRules rules(std::vector<std::string> inputs) const;

 private:
  void declare_value(OptionList& options, Need need, OptionValue value, const std::string& help);

  bool overwrite_ = false;
};

/// Requires the name of a table: .csv, .txt or no extension, so that no table stands under the name
/// of another format. Throws Error, with the list.
void require_table_name(const std::string& path);

}  // namespace thiessen::cli
