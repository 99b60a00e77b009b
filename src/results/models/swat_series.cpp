#include "results/models/swat_series.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <utility>

#include "base/calendar_days.h"
#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr const char* list_name = "pcp.cli";
constexpr const char* extension = ".pcp";
constexpr std::string_view missing = "-99.0";
/// What SWAT+ keeps of a file's name.
constexpr std::size_t longest_name = 50;

/// Whether a character may stand in a name: Fortran's list-directed input, by which names are read,
/// ends at blanks, commas and slashes, and has its own meaning for quotes and asterisks.
bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '.';
}

void check_ids(const ModelSubject& subject) {
  Complaints complaints;
  std::map<std::string, std::string> seen;
  for (const std::string& id : subject.basins) {
    const bool is_name = !id.empty() && id.front() != '.' && id.front() != '-' &&
                         std::all_of(id.begin(), id.end(), is_plain) &&
                         id.size() + std::string_view(extension).size() <= longest_name;
    if (!is_name) {
      complaints.add({subject.output, 0,
                      "the basin's id " + quoted(id, 80) +
                          " cannot be the name of a file of SWAT+ (up to 46 of A to Z, a to z, "
                          "0 to 9, _, - and .)",
                      setting("basin_id") + " names a field of such names"});
      continue;
    }
    const auto [at, is_new] = seen.emplace(lower_case(id), id);
    if (is_new) continue;
    complaints.add({subject.output, 0,
                    "the basins' ids " + quoted(at->second, 80) + " and " + quoted(id, 80) +
                        " are one file where names differ by case alone",
                    setting("basin_id") + " names a field of different names"});
  }
  complaints.throw_if_any();
}

std::chrono::year_month_day date_of(std::int64_t seconds) {
  return std::chrono::floor<std::chrono::days>(
      std::chrono::sys_seconds(std::chrono::seconds(seconds)));
}

/// The days from the first of January, from 1.
std::int64_t day_of_year(const std::chrono::year_month_day& date) {
  const std::chrono::sys_days first(date.year() / std::chrono::January / 1);
  return (std::chrono::sys_days(date) - first).count() + 1;
}

}  // namespace

std::vector<std::string> SwatSeries::files(const std::vector<std::string>& basins) {
  std::vector<std::string> names{list_name};
  for (const std::string& basin : basins) names.push_back(basin + extension);
  return names;
}

SwatSeries::SwatSeries(OpenFile open, ModelSubject subject)
    : SteppedSeries(std::move(subject), "a .pcp of SWAT+"), open_(std::move(open)) {
  check_ids(this->subject());
  require_unit(std::array<std::string_view, 1>{"mm"});
  if (!this->subject().centroids.empty()) return;
  throw Error({this->subject().output, 0,
               "a .pcp of SWAT+ has the basin's latitude and longitude, and nothing tells where "
               "these basins are on the Earth",
               setting("crs") + " names the CRS of their coordinates"});
}

void SwatSeries::write_list() {
  std::vector<std::string> names = files(subject().basins);
  names.erase(names.begin());
  std::sort(names.begin(), names.end());
  OutputFile& list = open_(list_name);
  list.append(std::string(list_name) + ": written by " + sentence_of(subject().made_by) +
              "\nfilename\n");
  for (const std::string& name : names) list.append(name + '\n');
  list.finish();
}

void SwatSeries::write(const Steps& steps, Warnings& warnings) {
  require_parts_of_days(steps);
  if (steps.length != seconds_of_day) {
    throw Error({subject().rainfall, 0,
                 "its steps are of " + text_of(StepLength{0, steps.length}) +
                     ", and a .pcp of SWAT+ is written of days alone",
                 setting("every", "day") + " sums them by day"});
  }
  tell_zone(warnings);
  tell_lacking(steps, std::string(missing), warnings);
  write_list();
  by_basin(steps, [&](std::size_t basin, std::span<const double> values) {
    write_basin(steps, basin, values);
  });
}

void SwatSeries::write_basin(const Steps& steps, std::size_t basin,
                             std::span<const double> values) {
  const std::string name = subject().basins[basin] + extension;
  OutputFile& file = open_(name);
  const int first_year = static_cast<int>(date_of(steps.begin).year());
  const std::int64_t last =
      steps.begin + static_cast<std::int64_t>(steps.count - 1) * seconds_of_day;
  const int years = static_cast<int>(date_of(last).year()) - first_year + 1;
  const Point& centroid = subject().centroids[basin];
  file.append(name + ": written by " + sentence_of(subject().made_by) +
              "\nnbyr tstep lat lon elev\n" + std::to_string(years) + " 0 " +
              fixed_text(centroid.y, 6) + ' ' + fixed_text(centroid.x, 6) + " 0.0\n");
  std::string row;
  std::int64_t begin = steps.begin;
  for (const double value : values) {
    const std::chrono::year_month_day date = date_of(begin);
    row = std::to_string(static_cast<int>(date.year())) + ' ' + std::to_string(day_of_year(date)) +
          ' ';
    append_value(row, value, missing);
    file.append(row + '\n');
    begin += seconds_of_day;
  }
  file.finish();
}

}  // namespace thiessen
