#include "python/keywords.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "base/error.h"
#include "base/utf8.h"
#include "cli/options/arguments.h"
#include "cli/options/name_lists.h"
#include "cli/options/option_values.h"
#include "cli/options/reading.h"
#include "cli/options/usage_error.h"

namespace thiessen::python {
namespace {

std::string name_of(Call call) {
  switch (call) {
    case Call::study:
      return "Study";
    case Call::weights:
      return "weights";
    case Call::cells:
      return "cells";
    case Call::rain:
      return "rain";
    case Call::influence:
      return "influence";
  }
  return {};
}

/// The option's name of a keyword.
std::string option_name(std::string keyword) {
  if (std::isupper(static_cast<unsigned char>(keyword.front())) != 0) return keyword;
  if (keyword.ends_with('_')) keyword.pop_back();
  std::replace(keyword.begin(), keyword.end(), '_', '-');
  return "--" + keyword;
}

std::vector<std::string> names_in(const cli::OptionList& list) {
  std::vector<std::string> names;
  for (const cli::Option& option : list.options()) {
    if (!option.is_argument()) names.push_back(keyword_name(option.name.substr(2)));
  }
  return names;
}

[[noreturn]] void refuse(const cli::OptionList& list, const std::string& keyword, Call call) {
  const std::vector<std::string> names = names_in(list);
  std::vector<std::string> others;
  for (const auto& [other, its_names] : keywords_of_calls()) {
    if (std::find(its_names.begin(), its_names.end(), keyword) != its_names.end())
      others.push_back(other);
  }
  const std::string here = name_of(call) + " has no keyword " + quoted(keyword, 40);
  if (!others.empty()) throw UnknownKeyword{here + "; it is one of " + cli::and_list(others)};
  const std::vector<std::string> near = cli::nearest_names(keyword, names);
  throw UnknownKeyword{here + (near.empty() ? "" : "; is " + cli::or_list(near) + " meant?")};
}

void read(cli::OptionList& list, const Keywords& keywords, Call call, Warnings& warnings) {
  cli::Arguments said;
  for (const auto& [keyword, texts] : keywords) {
    const std::string name = keyword.empty() ? keyword : option_name(keyword);
    const bool known = !keyword.empty() && list.find(name) != nullptr;
    // `from` alone can stand in a dictionary of keywords, and is none.
    if (!known || (name != keyword && keyword_name(name.substr(2)) != keyword))
      refuse(list, keyword, call);
    said.options.push_back({name, name, texts});
  }
  cli::read_options(list, said, warnings);
}

/// What an option of a study is about where that is one file alone; empty where it is not.
std::string file_of(const std::string& option) {
  for (const char* name : {"--id", "--x", "--y", "--skip-unplaced", "--attributes"}) {
    if (option == name) return "stations";
  }
  if (option == "--basin-id") return "basins";
  if (option == "--basins-crs") return {};  // which shapes in memory have too
  for (const char* file : {"stations", "basins"}) {
    if (option.starts_with("--" + std::string(file) + "-")) return file;
  }
  return {};
}

[[noreturn]] void refuse_in_memory(const std::string& option, const std::string& what) {
  throw cli::UsageError{option + " is about " + what + " in a file, and these are in memory",
                        "leave it out"};
}

/// The option that says of RAINFALL alone what another says of all CSV files.
std::string of_rainfall(const std::string& option) {
  return "--rainfall" + option.substr(1);
}

/// Refuses options that are about a file where the same is in memory.
void refuse_options_of_files(const StudyKeywords& said, HeldParts held) {
  const bool any_file =
      !held.stations || (said.study.has_basins() && !held.basins) || !said.rainfall.files().empty();
  for (const cli::Option& option : said.list.options()) {
    if (!option.is_given()) continue;
    const std::string file = file_of(option.name);
    if (held.stations && file == "stations") refuse_in_memory(option.name, file);
    if (held.basins && file == "basins") refuse_in_memory(option.name, file);
    for (const char* of_any : {"--separator", "--decimal-comma", "--encoding", "--skip"}) {
      if (!any_file && option.name == of_any)
        throw cli::UsageError{option.name + " is about CSV files, and there is none",
                              "leave it out; rain takes " + of_rainfall(of_any) + " for its own"};
    }
  }
  if (held.readings && said.rainfall.first_given() != nullptr)
    refuse_in_memory(said.rainfall.first_given()->name, "readings");
  if (held.stations && said.rainfall.is_event()) {
    throw cli::UsageError{
        "--value-field without RAINFALL names a field of STATIONS in a file, and these are in "
        "memory",
        "give the readings as RAINFALL: an array of one row"};
  }
}

}  // namespace

StudyKeywords::StudyKeywords(Call call) {
  study.declare(list, cli::Need::optional);
  study.declare_attributes(list);
  rainfall.declare(list, cli::Need::optional, study.stations);
  view.declare_margin(list);
  if (call == Call::weights) changes.declare(list);
  common.declare(list);
}

StudyKeywords::StudyKeywords(const Keywords& keywords, HeldParts held, Call call,
                             Warnings& warnings)
    : StudyKeywords(call) {
  read(list, keywords, call, warnings);
  refuse_options_of_files(*this, held);
  changes.check();
  study.opened = changes.opened();
  study.check();
  rainfall.check();
  view.check(held.readings || rainfall.given(), study.has_basins());
}

SeriesKeywords::SeriesKeywords(Call call) {
  rainfall.declare(list, cli::Need::optional, no_stations);
  if (call == Call::influence) {
    gaps.declare_cache(list);
    range.declare_range(list);
    range.declare_stamp(list,
                        "which month's normals count, and over which steps a total is spread");
    return;
  }
  method.declare(list);
  gaps.declare(list);
  range.declare(list);
  list.group("Method").add("--error", cli::flag(errors), "standard errors beside the values");
}

SeriesKeywords::SeriesKeywords(const Keywords& keywords, ReadingsAt readings, Call call,
                               bool stamp_acts)
    : SeriesKeywords(call) {
  Warnings none;  // only a file of options is warned of, and a series has none
  read(list, keywords, call, none);
  check_readings(readings);
  rainfall.check();
  range.check(stamp_acts || rainfall.totals().given());
  if (call == Call::influence) {
    if (range.stamp_option() == nullptr || stamp_acts || rainfall.totals().given()) return;
    throw cli::UsageError{
        "--stamp is about normals of months and totals beside RAINFALL, and there are none",
        "give normals or normal_field to Study, or totals, or leave it out"};
  }
  method.check();
  method.check(gaps);
  if (errors) method.check_errors();
}

void SeriesKeywords::check_readings(ReadingsAt readings) const {
  const cli::Option* const about_files = rainfall.first_given();
  const bool in_memory = readings == ReadingsAt::memory || readings == ReadingsAt::dated_memory;
  if (in_memory && about_files != nullptr) refuse_in_memory(about_files->name, "readings");
  if (!rainfall.given() && about_files != nullptr) {
    throw cli::UsageError{
        about_files->name + " is about readings in a file that is given with it, and there is none",
        "give it where the file is given, which may be to Study"};
  }
  const cli::Option* const about_times = range.first_given();
  if (readings != ReadingsAt::memory || about_times == nullptr) return;
  throw cli::UsageError{about_times->name + " is about times, and the readings in memory have none",
                        "a frame has them in its index"};
}

CellsKeywords::CellsKeywords() {
  view.declare_time(list);
}

CellsKeywords::CellsKeywords(const Keywords& keywords) : CellsKeywords() {
  Warnings none;  // as above
  read(list, keywords, Call::cells, none);
}

std::vector<std::pair<std::string, std::vector<std::string>>> keywords_of_calls() {
  const std::vector<std::string> of_study = names_in(StudyKeywords(Call::study).list);
  std::vector<std::string> of_weights = names_in(StudyKeywords(Call::weights).list);
  std::erase_if(of_weights, [&](const std::string& name) {
    return std::find(of_study.begin(), of_study.end(), name) != of_study.end();
  });
  return {{name_of(Call::study), of_study},
          {name_of(Call::weights), std::move(of_weights)},
          {name_of(Call::cells), names_in(CellsKeywords().list)},
          {name_of(Call::rain), names_in(SeriesKeywords(Call::rain).list)},
          {name_of(Call::influence), names_in(SeriesKeywords(Call::influence).list)}};
}

std::string keyword_name(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  if (name == "from" || name == "with") name += '_';
  return name;
}

std::string in_python(const std::string& text) {
  const auto is_letter = [&](std::size_t i) {
    return i < text.size() && std::isalnum(static_cast<unsigned char>(text[i])) != 0;
  };
  std::string changed;
  for (std::size_t i = 0; i < text.size();) {
    const bool begins = i == 0 || text[i - 1] == ' ' || text[i - 1] == '(';
    std::size_t end = i;
    if (begins && text.compare(i, 2, "--") == 0) {
      end = i + 2;
      while (end < text.size() && (text[end] == '-' || is_letter(end))) ++end;
    }
    if (end > i + 2) {
      changed += keyword_name(text.substr(i + 2, end - i - 2));
      i = end;
      continue;
    }
    for (const std::string_view argument : {"STATIONS", "BASINS", "RAINFALL"}) {
      if (!begins || text.compare(i, argument.size(), argument) != 0) continue;
      if (is_letter(i + argument.size())) continue;
      changed += lower_case(argument);
      end = i + argument.size();
    }
    if (end == i) changed += text[end++];
    i = end;
  }
  return changed;
}

}  // namespace thiessen::python
