#include "readings/first_row.h"

#include <memory>

#include "base/error.h"

namespace thiessen {

std::vector<std::string> first_row(const Table& table) {
  try {
    const std::unique_ptr<Table> rows = table.first_rows();
    Row row;
    if (!rows) return table.row_seen();
    if (!rows->next(row)) return {};
    return {row.fields.begin(), row.fields.end()};
  } catch (const Error&) {
    return {};  // the error is met again, and reported, when the rows are read
  }
}

}  // namespace thiessen
