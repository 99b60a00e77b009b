#include "files/tables/csv_file.h"

#include <utility>
#include <vector>

#include "files/tables/packed_file.h"
#include "gdal/layers/formats.h"
#include "gdal/layers/opening.h"
#include "text/last_line.h"

namespace thiessen {
namespace {

std::unique_ptr<CsvReader> open(const std::string& file, const CsvOptions& options) {
  const bool is_packed = file != "-" && find_opening(file).packing != Opening::Packing::none;
  if (is_packed) return std::make_unique<CsvReader>(open_text(file), options);
  return std::make_unique<CsvReader>(file, options);  // which can then be opened once more
}

std::string parted_by(char separator) {
  switch (separator) {
    case '\t':
      return "tabs";
    case ';':
      return "semicolons";
    case ' ':
      return "blanks";
    default:
      return std::string("'") + separator + "'";
  }
}

std::string lines(std::size_t count) {
  return count == 1 ? "a line" : std::to_string(count) + " lines";
}

/// Tells in one notice what was found out, where it is not what a CSV usually is.
void tell_form(const CsvReader& csv, const CsvDialect& said, Warnings& warnings) {
  const CsvForm& form = csv.form();
  std::vector<std::string> found;
  const InputFormat* const format = format_by_extension(csv.file());
  if (format != nullptr && is_spreadsheet(*format))
    found.emplace_back("it is a text under the name of a spreadsheet");
  if (said.encoding.empty() && !csv.encoding().empty())
    found.push_back("it is written in " + csv.encoding());
  if (said.separator == '\0' && form.separator != ',')
    found.push_back("its fields are parted by " + parted_by(form.separator));
  if (!said.decimal_comma && form.mark == DecimalMark::comma)
    found.emplace_back("its numbers have decimal commas");
  if (form.preamble > 0) {
    found.push_back("its header stands in line " + std::to_string(csv.header_line()) + ", below " +
                    lines(form.preamble) + " that " + (form.preamble == 1 ? "is" : "are") +
                    " passed over");
  }
  if (form.rows_passed > 0) {
    found.push_back("below its header " + lines(form.rows_passed) + " of " +
                    (form.units.empty() ? "formats" : "units (" + form.units + ")") + " " +
                    (form.rows_passed == 1 ? "is" : "are") + " passed over");
  }
  if (ends_within_line(csv.file())) found.emplace_back(last_line_has_no_end);
  if (found.empty()) return;
  std::string text;
  for (std::size_t i = 0; i < found.size(); ++i)
    text += (i == 0 ? "" : i + 1 == found.size() ? ", and " : ", ") + found[i];
  warnings.add_notice({csv.file(), 0, text, {}});
}

}  // namespace

std::unique_ptr<CsvReader> open_csv(const std::string& file, const CsvDialect& said,
                                    const CsvLimits& limits, Warnings& warnings) {
  CsvOptions options;
  options.separator = said.separator;
  options.limits = limits;
  options.encoding = said.encoding;
  options.finds_form = true;
  options.skip = said.skip;
  options.skip_is_of_all = said.skip_is_of_all;
  options.decimal_comma = said.decimal_comma;
  options.numbers = said.numbers;
  options.names = said.names;
  options.repeated = said.repeated;
  options.input = said.input;
  auto csv = open(file, options);
  tell_form(*csv, said, warnings);
  return csv;
}

}  // namespace thiessen
