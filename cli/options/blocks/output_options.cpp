#include "cli/options/blocks/output_options.h"

#include <utility>

#include "base/error.h"
#include "base/secrets.h"
#include "base/utf8.h"
#include "cli/options/option_values.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

void OutputOptions::declare(OptionList& options, Need need, const std::string& kind,
                            const std::string& help) {
  declare_value(options, need, file(output, kind), help);
}

void OutputOptions::declare_table(OptionList& options, const std::string& table) {
  table_ = table;
  table_option_ =
      &options.group("Output", *this)
           .add(
               "--output-layer", text(table_, "NAME"),
               "the table, NAME or SCHEMA.NAME, where the output is a database (PG:...); default " +
                   table);
}

void OutputOptions::declare_folder(OptionList& options, const std::string& help) {
  declare_value(options, Need::required, folder(output, "DIR"), help);
}

void OutputOptions::declare_value(OptionList& options, Need need, OptionValue value,
                                  const std::string& help) {
  OptionGroup group = options.group("Output", *this);
  Option& option = group.add("-o,--output", std::move(value), help);
  option.need = need;
  output_option_ = &option;
  group.add("--overwrite", flag(overwrite_),
            "replace an output that exists; else that is an error");
}

void OutputOptions::declare_append(OptionList& options) {
  options.group("Output", *this)
      .add("--append", flag(append_),
           "add the steps that FILE lacks, and say how many; those that are there stay. FILE has "
           "the same columns, or does not exist yet. From a pipe each step is added as it comes");
}

void OutputOptions::check() const {
  if (table_option_ != nullptr && table_option_->is_given() && !is_database()) {
    throw UsageError{"--output-layer names a table, and the output is no database",
                     "-o PG:... writes into one"};
  }
  if (!append_) return;
  if (is_database()) {
    throw UsageError{"--append adds to a file, and the output is a database",
                     "write into a table of another name, and INSERT what is new"};
  }
  if (overwrite_) {
    throw UsageError{"--append adds to the output, and --overwrite replaces it",
                     "leave one of them out"};
  }
  if (output == "-") {
    throw UsageError{"--append adds to a file, and the output is the standard output",
                     "-o FILE names one"};
  }
}

OutputRules OutputOptions::rules(std::vector<std::string> inputs) const {
  if (!is_database()) require_output_file(output);
  return {overwrite_, std::move(inputs)};
}

void require_output_file(const std::string& path) {
  if (!is_database(path)) return;
  throw Error(
      {without_password(path), 0, "this output is a file, and that is a database",
       "cells, weights and rain write into a database; a .gpkg or a .sql can be brought into "
       "one"});
}

void require_table_name(const std::string& path) {
  require_output_file(path);
  const std::string name = name_in_folder(path);
  const std::size_t dot = name.rfind('.');
  const std::string extension =
      dot == std::string::npos || dot == 0 ? "" : lower_case(name.substr(dot));
  if (extension.empty() || extension == "." || extension == ".csv" || extension == ".txt") return;
  throw Error({path, 0, "no format of tables has the extension " + extension,
               "a table is CSV, and written to .csv, .txt or a name without an extension"});
}

}  // namespace thiessen::cli
