#include "results/models/swmm_series.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

#include "base/iso_time.h"
#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

bool ends_a_word(char c) {
  const auto code = static_cast<unsigned char>(c);
  return code <= ' ' || code == 0x7F || c == '"' || c == ';';
}

void check_ids(const ModelSubject& subject) {
  Complaints complaints;
  std::map<std::string, std::string> seen;
  for (const std::string& id : subject.basins) {
    if (id.empty() || std::any_of(id.begin(), id.end(), ends_a_word)) {
      complaints.add({subject.output, 0,
                      "the basin's id " + quoted(id, 80) +
                          " is no word, as a rain file of SWMM wants it (no blanks, no \" and ;)",
                      setting("basin_id") + " names a field of words"});
      continue;
    }
    const auto [at, is_new] = seen.emplace(lower_case(id), id);
    if (is_new) continue;
    complaints.add({subject.output, 0,
                    "the basins' ids " + quoted(at->second, 80) + " and " + quoted(id, 80) +
                        " are one to SWMM, which takes upper and lower case for the same",
                    setting("basin_id") + " names a field of different words"});
  }
  complaints.throw_if_any();
}

/// ` 2004 6 12 00 05 `, the moment between an id and a value.
std::string moment_words(std::int64_t seconds) {
  std::string text = time_text(seconds, TimePrecision::instant);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '-' || c == 'T' || c == ':'; }, ' ');
  return ' ' + text + ' ';
}

/// Whether the text is that of 0.
bool is_nothing(std::string_view text) {
  return text.find_first_not_of("0.") == std::string_view::npos;
}

/// An interval as SWMM has it: `1:00`, `0:05`.
std::string interval_text(std::int64_t seconds) {
  const std::string minutes = std::to_string(seconds / 60 % 60);
  return std::to_string(seconds / 3600) + (minutes.size() < 2 ? ":0" : ":") + minutes;
}

}  // namespace

SwmmSeries::SwmmSeries(OutputFile& file, ModelSubject subject)
    : SteppedSeries(std::move(subject), "a rain file of SWMM"), file_(file) {
  check_ids(this->subject());
  require_unit(std::array<std::string_view, 4>{"mm", "in", "mm/h", "in/h"});
}

void SwmmSeries::append_step(std::int64_t begin, std::span<const double> rainfall, bool is_first) {
  const std::string moment = moment_words(begin);
  std::string lines;
  std::string value;
  for (std::size_t b = 0; b < rainfall.size(); ++b) {
    if (std::isnan(rainfall[b])) {
      throw Error({subject().rainfall, 0,
                   "basin " + quoted(subject().basins[b], 80) + " has no rainfall at " +
                       time_text(begin, TimePrecision::instant) +
                       ", and a rain file of SWMM cannot say so: a step without a line is dry",
                   setting("from") + " and " + setting("to") + " choose steps that have values"});
    }
    value.clear();
    append_value(value, rainfall[b], "");
    if (is_nothing(value) && rainfall[b] > 0) {
      ++too_small_;
      lost_ += rainfall[b];
    }
    if (is_nothing(value) && !is_first) continue;
    lines += subject().basins[b] + moment + value + '\n';
  }
  file_.append(lines);
}

void SwmmSeries::write(const Steps& steps, Warnings& warnings) {
  require_parts_of_days(steps);
  tell_zone(warnings);
  bool is_first = true;
  by_step(steps, [&](std::int64_t begin, std::span<const double> rainfall) {
    append_step(begin, rainfall, std::exchange(is_first, false));
  });
  tell_gage(steps, warnings);
  warn_of_lost(warnings);
}

/// Warns of rain that is too little for the decimals: drizzle in inches is most of a year's hours.
void SwmmSeries::warn_of_lost(Warnings& warnings) const {
  if (too_small_ == 0) return;
  const int decimals = subject().decimals;
  std::string lost;
  append_fixed(lost, lost_, decimals + 2);
  warnings.add({subject().output, 0,
                std::to_string(too_small_) +
                    (too_small_ == 1 ? " value above 0 is" : " values above 0 are") + " 0 to " +
                    std::to_string(decimals) + " decimals and so dry in it, " + lost + " " +
                    subject().unit + " in all",
                setting("decimals", std::to_string(decimals + 2)) + " keeps more of them"});
}

/// Says what the project has to say of its gages, for the file cannot.
void SwmmSeries::tell_gage(const Steps& steps, Warnings& warnings) const {
  const bool is_rate = subject().unit.ends_with("/h");
  warnings.add_notice(
      {subject().output, 0,
       std::string("in [RAINGAGES] it is of ") + (is_rate ? "INTENSITY" : "VOLUME") +
           ", interval " + interval_text(steps.length) + ", units " +
           (subject().unit.starts_with("in") ? "IN" : "MM") + "; a step without a line is dry",
       ""});
}

}  // namespace thiessen
