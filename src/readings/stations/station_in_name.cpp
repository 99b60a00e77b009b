#include "readings/stations/station_in_name.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "base/utf8.h"
#include "text/field_names.h"
#include "text/known_names.h"
#include "text/table_over.h"

namespace thiessen {
namespace {

using Standing = ReadingsStations::Standing;

/// A part of a name that is the id of a station.
struct Part {
  std::size_t begin;
  std::size_t end;
};

bool parts_words(char c) {
  return c == '_' || c == '-' || c == '.' || c == ' ';
}

/// All parts of a name from the beginning of a word to the end of one.
std::vector<Part> parts_of(std::string_view name) {
  std::vector<std::size_t> begins, ends;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (parts_words(name[i])) continue;
    if (i == 0 || parts_words(name[i - 1])) begins.push_back(i);
    if (i + 1 == name.size() || parts_words(name[i + 1])) ends.push_back(i + 1);
  }
  std::vector<Part> parts;
  for (const std::size_t begin : begins) {
    for (const std::size_t end : ends) {
      if (begin < end) parts.push_back({begin, end});
    }
  }
  return parts;
}

bool lies_in(const Part& inner, const Part& outer) {
  return outer.begin <= inner.begin && inner.end <= outer.end &&
         inner.end - inner.begin < outer.end - outer.begin;
}

/// A table with one more column, which holds the same text in each row.
class TableOfStation : public TableOver {
 public:
  TableOfStation(std::unique_ptr<Table> table, const std::string& id)
      : TableOver(std::move(table)), header_(table_->header()), id_(id) {
    header_.emplace_back(station_of_name);
    padded_ = id_ + std::string(number_padding, '\0');
  }

  const std::vector<std::string>& header() const override { return header_; }
  std::size_t columns_in_file() const override { return table_->columns_in_file(); }
  bool next(Row& row) override {
    if (!table_->next(row)) return false;
    row.fields.push_back(std::string_view(padded_).substr(0, id_.size()));
    return true;
  }

 private:
  std::unique_ptr<Table> over(std::unique_ptr<Table> table) const override {
    return std::make_unique<TableOfStation>(std::move(table), id_);
  }

  std::vector<std::string> header_;
  std::string id_;
  std::string padded_;  ///< the id, with bytes behind it as Row::padded wants them
};

}  // namespace

bool names_no_station(const Table& table, const ReadingsStations& stations) {
  if (find_field(table.header(), known::station_ids)) return false;
  return std::none_of(table.header().begin(), table.header().end(), [&](const std::string& name) {
    return stations.find(name).standing != Standing::unknown;
  });
}

std::string station_in_name(const std::string& file, const ReadingsStations& stations) {
  const std::string name = file.substr(file.rfind('/') + 1);
  std::vector<Part> found;
  for (const Part& part : parts_of(name)) {
    if (stations.find(name.substr(part.begin, part.end - part.begin)).standing != Standing::unknown)
      found.push_back(part);
  }
  std::vector<std::string> ids;
  for (const Part& part : found) {
    if (std::any_of(found.begin(), found.end(),
                    [&](const Part& other) { return lies_in(part, other); })) {
      continue;
    }
    std::string id = name.substr(part.begin, part.end - part.begin);
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(std::move(id));
  }
  if (ids.size() > 1) {
    throw Error(Message{file, 0, "its name tells several stations: " + listed(ids),
                        "rename it, or add a column of stations"});
  }
  return ids.empty() ? "" : ids.front();
}

std::unique_ptr<Table> of_station(std::unique_ptr<Table> table, const std::string& id) {
  return std::make_unique<TableOfStation>(std::move(table), id);
}

}  // namespace thiessen
