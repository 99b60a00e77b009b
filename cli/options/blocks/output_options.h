#pragma once

#include <string>
#include <vector>

#include "base/destination.h"
#include "cli/options/option_list.h"
#include "files/database/database_table.h"
#include "files/database/postgres.h"

namespace thiessen::cli {

/// The options that say where results are written.
class OutputOptions : public OptionBlock {
 public:
  std::string output = "-";

  /// `kind` is the word for the output in the help, such as `map.png`.
  void declare(OptionList& options, Need need, const std::string& kind, const std::string& help);
  /// Declares the option that names the table, where the output may be a database; `table` is what
  /// it is called else.
  void declare_table(OptionList& options, const std::string& table);
  /// Declares the options of an output that is a folder.
  void declare_folder(OptionList& options, const std::string& help);
  /// Declares the option that adds to a table that is there.
  void declare_append(OptionList& options);
  /// Throws UsageError where nothing can be added to the output, and where a table is named and the
  /// output is none.
  void check() const;
  /// Whether the command line says where the results go.
  bool is_given() const { return output_option_->is_given(); }
  /// Whether the output is a table in a database.
  bool is_database() const { return table_option_ != nullptr && thiessen::is_database(output); }
  DatabaseTarget table() const { return {output, table_, overwrite_}; }
  bool appends() const { return append_; }
  /// The rules by which the output is written. `inputs` are files that may not be overwritten.
  /// Throws Error where the output is a connection to a database, and may be none.
  OutputRules rules(std::vector<std::string> inputs) const;

 private:
  void declare_value(OptionList& options, Need need, OptionValue value, const std::string& help);

  bool overwrite_ = false;
  std::string table_;
  const Option* output_option_ = nullptr;
  const Option* table_option_ = nullptr;
  bool append_ = false;
};

/// Requires an output that is a file, and no database. Throws Error, with a hint.
void require_output_file(const std::string& path);

/// Requires the name of a table: .csv, .txt or no extension, so that no table stands under the name
/// of another format. Throws Error, with the list.
void require_table_name(const std::string& path);

}  // namespace thiessen::cli
