#include "python/keywords.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"
#include "base/utf8.h"
#include "cli/options/arguments.h"
#include "cli/options/name_lists.h"
#include "cli/options/option_values.h"
#include "cli/options/reading.h"
#include "cli/options/usage_error.h"

namespace thiessen::python {
namespace {

/// The option's name of a keyword. `from_` is --from, which is a word of Python's own.
std::string option_name(std::string keyword) {
  if (std::isupper(static_cast<unsigned char>(keyword.front())) != 0) return keyword;
  if (keyword.ends_with('_')) keyword.pop_back();
  std::replace(keyword.begin(), keyword.end(), '_', '-');
  return "--" + keyword;
}

[[noreturn]] void refuse(const cli::OptionList& list, const std::string& keyword) {
  std::vector<std::string> names;
  for (const cli::Option& option : list.options()) {
    if (!option.is_argument()) names.push_back(in_python(option.name));
  }
  const std::vector<std::string> near = cli::nearest_names(keyword, names);
  throw UnknownKeyword{"there is no keyword " + quoted(keyword, 40) +
                       (near.empty() ? "" : "; is " + cli::or_list(near) + " meant?")};
}

void read(cli::OptionList& list, const Keywords& keywords, Warnings& warnings) {
  cli::Arguments said;
  for (const auto& [keyword, texts] : keywords) {
    const std::string name = keyword.empty() ? keyword : option_name(keyword);
    if (keyword.empty() || list.find(name) == nullptr) refuse(list, keyword);
    said.options.push_back({name, name, texts});
  }
  cli::read_options(list, said, warnings);
}

}  // namespace

StudyKeywords::StudyKeywords(const Keywords& keywords, bool has_readings, Warnings& warnings) {
  study.declare(list, cli::Need::optional);
  study.declare_attributes(list);
  rainfall.declare(list, cli::Need::optional, study.stations);
  view.declare_margin(list);
  common.declare(list);
  read(list, keywords, warnings);
  if (has_readings && rainfall.first_given() != nullptr) {
    throw cli::UsageError{
        rainfall.first_given()->name + " is about readings in a file, and they are given in memory",
        "leave it out"};
  }
  study.check();
  rainfall.check();
  view.check(has_readings || rainfall.given(), study.has_basins());
}

SeriesKeywords::SeriesKeywords(const Keywords& keywords) {
  rainfall.declare(list, cli::Need::optional, no_stations);
  method.declare(list);
  gaps.declare(list);
  range.declare_range(list);
  list.group("Method").add("--error", cli::flag(errors), "standard errors beside the values");
  Warnings none;  // only a file of options is warned of, and a series has none
  read(list, keywords, none);
  rainfall.check();
  method.check();
  method.check(gaps);
  range.check();
  if (errors) method.check_errors();
}

std::string in_python(const std::string& text) {
  std::string changed;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins = text.compare(i, 2, "--") == 0 && i + 2 < text.size() &&
                        std::islower(static_cast<unsigned char>(text[i + 2])) != 0 &&
                        (i == 0 || text[i - 1] == ' ' || text[i - 1] == '(');
    if (!begins) {
      changed += text[i];
      continue;
    }
    for (i += 2; i < text.size(); ++i) {
      const auto c = static_cast<unsigned char>(text[i]);
      if (c != '-' && std::islower(c) == 0) break;
      changed += c == '-' ? '_' : text[i];
    }
    --i;
  }
  return changed;
}

}  // namespace thiessen::python
