#include "files/tables/skipped_lines.h"

#include <vector>

#include "gdal/layers/formats.h"

namespace thiessen {

Error told_of_skip(const Error& error, const Source& source) {
  const std::size_t skip = source.csv.skip_is_of_all ? source.csv.skip.value_or(0) : 0;
  const InputFormat* format = format_by_extension(source.file);
  const bool may_be_csv = format == nullptr || format->drivers.empty();
  if (skip == 0 || !may_be_csv) return error;
  std::vector<Message> messages = error.messages();
  Message& first = messages.front();
  const bool is_of_head = first.line > 0 && first.line <= skip + 1;
  if (!is_of_head) return error;
  first.hint = first.hint.empty() ? hint_of_skip() : hint_of_skip() + "; else " + first.hint;
  return {std::move(messages), error.unlisted()};
}

}  // namespace thiessen
