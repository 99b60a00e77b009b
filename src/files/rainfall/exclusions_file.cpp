#include "files/rainfall/exclusions_file.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "base/interrupt.h"
#include "base/utf8.h"
#include "files/rainfall/rainfall_file.h"
#include "files/tables/source.h"
#include "files/tables/table_file.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

constexpr std::array<std::string_view, 3> times = {"time", "date", "datetime"};

std::size_t column(const Table& table, std::span<const std::string_view> names, const char* what) {
  const std::optional<std::size_t> found = find_field(table.header(), names);
  if (found) return *found;
  throw Error({table.file(), table.header_line(),
               std::string("there is no column of ") + what + " among " + listed(table.header()),
               "wanted are columns station and time, as check -o writes them; a row without a "
               "time means the whole gauge"});
}

}  // namespace

ExclusionList read_exclusions(const std::string& file, Warnings& warnings) {
  if (!can_be_read_again({{file}, {}})) {
    throw Error({file == "-" ? "standard input" : file, 0,
                 "what is to be excluded is read several times, and this can be read only once",
                 "give a file"});
  }
  Source source;
  source.file = file;
  const std::unique_ptr<Table> table = open_table(source, warnings);
  const std::size_t station = column(*table, known::station_ids, "stations");
  const std::size_t time = column(*table, times, "times");
  ExclusionList list{table->file(), {}};
  Complaints complaints;
  for (Row row; table->next(row);) {
    throw_if_interrupted();
    const std::string id(row.fields[station]);
    if (trimmed(id).empty()) {
      complaints.add({list.file, row.line, "it names no station", ""});
      continue;
    }
    list.rows.push_back({id, std::string(row.fields[time]), row.line});
  }
  complaints.throw_if_any();
  return list;
}

}  // namespace thiessen
