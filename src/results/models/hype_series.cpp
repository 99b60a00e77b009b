#include "results/models/hype_series.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "base/calendar_days.h"
#include "base/iso_time.h"
#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::string_view missing = "-9999";
/// The largest whole number of Fortran's usual kind.
constexpr std::size_t largest_id = std::numeric_limits<std::int32_t>::max();

void check_ids(const ModelSubject& subject) {
  Complaints complaints;
  std::map<std::size_t, std::string> seen;
  for (const std::string& id : subject.basins) {
    const auto number = parse_size(id);
    if (!number || number.value > largest_id) {
      complaints.add({subject.output, 0,
                      "the basin's id " + quoted(id, 80) +
                          " is no whole number up to 2147483647, as HYPE's Pobs.txt wants it",
                      setting("basin_id") + " names a field of such numbers"});
      continue;
    }
    const auto [at, is_new] = seen.emplace(number.value, id);
    if (is_new) continue;
    complaints.add({subject.output, 0,
                    "the basins' ids " + quoted(at->second, 80) + " and " + quoted(id, 80) +
                        " are one number in HYPE's Pobs.txt",
                    setting("basin_id") + " names a field of different numbers"});
  }
  complaints.throw_if_any();
}

/// 2013-08-31, or 2013-08-31 06:00.
std::string begin_text(std::int64_t begin, bool is_day) {
  std::string text = time_text(begin, is_day ? TimePrecision::day : TimePrecision::instant);
  if (!is_day) text[text.find('T')] = ' ';
  return text;
}

}  // namespace

HypeSeries::HypeSeries(OutputFile& file, ModelSubject subject)
    : SteppedSeries(std::move(subject), "HYPE's Pobs.txt"), file_(file) {
  check_ids(this->subject());
  require_unit(std::array<std::string_view, 1>{"mm"});
}

void HypeSeries::write(const Steps& steps, Warnings& warnings) {
  require_parts_of_days(steps);
  tell_zone(warnings);
  tell_lacking(steps, std::string(missing), warnings);
  std::string row = "date";
  for (const std::string& id : subject().basins) row += '\t' + id;
  file_.append(row + '\n');
  std::size_t none = 0;
  std::string first_none;
  by_step(steps, [&](std::int64_t begin, std::span<const double> rainfall) {
    row = begin_text(begin, steps.length == seconds_of_day);
    for (const double value : rainfall) {
      if (std::isnan(value) && none++ == 0) first_none = row.substr(0, row.find('\t'));
      row += '\t';
      append_value(row, value, missing);
    }
    file_.append(row + '\n');
  });
  if (none == 0) return;
  // By its documentation HYPE takes such a number for rain: a simulation has to stay clear of it.
  warnings.add({subject().output, 0,
                std::to_string(none) + (none == 1 ? " value is" : " values are") +
                    " missing and written as -9999, the first at " + first_none +
                    ", and HYPE wants a value in every step that it simulates",
                ""});
}

}  // namespace thiessen
