#include "cli/options/blocks/csv_options.h"

#include "base/number.h"
#include "base/utf8.h"
#include "cli/options/option_values.h"

namespace thiessen::cli {

std::vector<std::string> numbers_in(const std::vector<std::string>& columns) {
  std::vector<std::string> numbers;
  for (const std::string& column : columns) {
    if (column.empty()) continue;
    if (!parse_size(column)) return {};
    numbers.push_back(column);
  }
  return numbers;
}

void CsvOptionsOf::declare(OptionGroup& group) {
  group.add(
      "--separator", separator(said_.separator),
      "what parts the fields of CSV files: a character, tab or blank; default found out, file "
      "by file");
  group.add("--decimal-comma", flag(said_.decimal_comma),
            "numbers of CSV files are written 1,5; else found out");
  group.add(
      "--encoding", encoding(said_.encoding),
      "in what CSV files are written, such as Latin-1 or cp932; default UTF-8, or UTF-16 with "
      "its mark");
  group.add("--skip", lines(said_.skip),
            "how many lines stand before the header of CSV files; else found out");
}

std::vector<const Option*> CsvOptionsOf::declare_for(OptionGroup& group, const std::string& which) {
  const std::string prefix = "--" + lower_case(which) + "-";
  return {&group.add(prefix + "separator", separator(said_.separator),
                     "--separator of " + which + " alone"),
          &group.add(prefix + "decimal-comma", flag(said_.decimal_comma),
                     "--decimal-comma of " + which + " alone"),
          &group.add(prefix + "encoding", encoding(said_.encoding),
                     "--encoding of " + which + " alone"),
          &group.add(prefix + "skip", lines(said_.skip), "--skip of " + which + " alone")};
}

CsvDialect CsvOptionsOf::or_else(const CsvDialect& all) const {
  CsvDialect said = said_;
  if (said.separator == '\0') said.separator = all.separator;
  said.decimal_comma = said.decimal_comma || all.decimal_comma;
  if (said.encoding.empty()) said.encoding = all.encoding;
  said.skip_is_of_all = !said.skip && all.skip;
  if (!said.skip) said.skip = all.skip;
  said.numbers = all.numbers;
  return said;
}

}  // namespace thiessen::cli
