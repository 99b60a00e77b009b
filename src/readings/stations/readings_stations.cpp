#include "readings/stations/readings_stations.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_id = 80;

bool all_of_it_is(std::string_view text, std::string_view characters) {
  return text.find_first_not_of(characters) == std::string_view::npos;
}

/// The digits by which an id is compared as a number: without leading zeros, and without a fraction
/// of zeros, as a spreadsheet appends it. Empty where the id is no such number.
std::string_view number_in(std::string_view id) {
  id = trimmed(id);
  const std::size_t point = id.find('.');
  if (point != std::string_view::npos) {
    if (!all_of_it_is(id.substr(point + 1), "0")) return {};
    id = id.substr(0, point);
  }
  if (id.empty() || !all_of_it_is(id, "0123456789")) return {};
  id.remove_prefix(std::min(id.find_first_not_of('0'), id.size() - 1));
  return id;
}

}  // namespace

ReadingsStations::ReadingsStations(std::span<const Station> stations,
                                   std::span<const std::string> passed_over, IdJoin join)
    : stations_(stations), passed_over_(passed_over), join_(std::move(join)) {
  by_id_.reserve(stations.size() + passed_over.size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    by_id_.emplace(stations[i].id,
                   Found{Standing::known, StationIndex{static_cast<std::uint32_t>(i)}});
  }
  for (const std::string& id : passed_over) by_id_.emplace(id, Found{Standing::passed_over, {}});
  if (join_.as_numbers) enter_numbers(passed_over);
}

void ReadingsStations::enter_numbers(std::span<const std::string> passed_over) {
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    const std::string_view number = number_in(stations_[i].id);
    if (number.empty()) continue;
    const Found found{Standing::known, StationIndex{static_cast<std::uint32_t>(i)}};
    const auto [at, fresh] = by_number_.emplace(number, found);
    if (fresh) continue;
    throw Error({"", 0,
                 "stations " + quoted(id(at->second.station), longest_id) + " and " +
                     quoted(stations_[i].id, longest_id) + " are one as numbers",
                 "leave out " + setting("ids_as_numbers")});
  }
  for (const std::string& id : passed_over) {
    const std::string_view number = number_in(id);
    if (!number.empty()) by_number_.emplace(number, Found{Standing::passed_over, {}});
  }
}

ReadingsStations::Found ReadingsStations::find(std::string_view text) const {
  auto found = by_id_.find(text);
  if (found == by_id_.end()) found = by_id_.find(trimmed(text));
  if (found != by_id_.end()) return found->second;
  if (!join_.as_numbers) return {};
  const std::string_view number = number_in(text);
  found = number.empty() ? by_number_.end() : by_number_.find(number);
  return found == by_number_.end() ? Found{} : found->second;
}

ReadingsStations::Meant ReadingsStations::spelt_as(std::string_view text, const std::string& id) {
  const std::string_view number = number_in(text);
  const std::string there = "there is a station " + quoted(id, longest_id) + ": ";
  if (!number.empty() && number == number_in(id))
    return {Cause::zeros,
            there + setting("ids_as_numbers") + " takes ids that differ by zeros for one"};
  if (equal_ignoring_case(trimmed(text), trimmed(id)))
    return {Cause::spelling, there + "ids are compared letter by letter, with case and blanks"};
  return {};
}

ReadingsStations::Meant ReadingsStations::meant_by(std::string_view text) const {
  for (const Station& station : stations_) {
    Meant meant = spelt_as(text, station.id);
    if (meant.cause != Cause::none) return meant;
  }
  for (const std::string& id : passed_over_) {
    Meant meant = spelt_as(text, id);
    if (meant.cause != Cause::none) return meant;
  }
  const std::string column = join_.column_of ? join_.column_of(std::string(trimmed(text))) : "";
  if (column.empty()) return {};
  return {Cause::column, "the column " + quoted(column, longest_id) + " of " + input("stations") +
                             " has it: " + setting("id", column) + " takes that for the id"};
}

}  // namespace thiessen
