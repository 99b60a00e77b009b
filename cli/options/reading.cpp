#include "cli/options/reading.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/error.h"
#include "base/secrets.h"
#include "cli/options/name_lists.h"
#include "cli/options/study_file.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {
namespace {

constexpr const char* flag_text = "true";

void read(const Option& option) {
  if (option.texts.size() > 1 && !option.value.may_be_repeated)
    throw UsageError{option.origin + option.short_name() + " is given more than once", ""};
  for (const std::string& text : option.texts) {
    if (option.is_flag() && text != flag_text)
      throw UsageError{option.origin + option.name + " takes no value", ""};
    try {
      option.value.read(text);
    } catch (const WrongValue& wrong) {
      throw UsageError{option.origin + printable(option.short_name() + " " + wrong.complaint), ""};
    }
  }
}

void take_study_file(OptionList& options, Warnings& warnings) {
  const Option* file = options.find(study_file_option);
  if (file == nullptr || file->texts.size() != 1) return;
  take_study_file(options, file->texts.front(), warnings);
}

void refuse_missing(const OptionList& options) {
  std::vector<std::string> names;
  std::string hint;
  for (const Option& option : options.options()) {
    if (option.need == Need::optional || option.is_given()) continue;
    if (!option.instead.empty()) {
      const auto given = [](const Option* other) { return other->is_given(); };
      if (std::any_of(option.instead.begin(), option.instead.end(), given)) continue;
      std::string others;
      for (const Option* other : option.instead)
        others += (others.empty() ? "" : " or ") + other->name;
      hint = others + " may stand in place of " + option.name;
    }
    names.push_back(option.short_name() +
                    (option.value.kind.empty() ? "" : " " + option.value.kind));
  }
  if (names.empty()) return;
  throw UsageError{and_list(names) + (names.size() == 1 ? " is missing" : " are missing"),
                   names.size() == 1 ? hint : ""};
}

}  // namespace

std::string unknown_option(const OptionList& options, const Arguments& said) {
  if (!said.unknown.empty()) return said.unknown.front();
  for (const Arguments::Given& given : said.options) {
    if (options.find(given.name) == nullptr) return given.spelling;
  }
  if (said.incomplete && options.find(*said.incomplete) == nullptr) return *said.incomplete;
  return {};
}

void read_options(OptionList& options, const Arguments& said, Warnings& warnings) {
  if (said.incomplete) {
    const Option& option = *options.find(*said.incomplete);
    throw UsageError{option.short_name() + " needs a value: " + option.value.in_words(), ""};
  }
  for (const Arguments::Given& given : said.options) options.find(given.name)->texts = given.texts;
  const std::vector<Option*> arguments = options.arguments();
  const std::size_t words = said.words.empty() ? 0 : said.words.size() - 1;
  for (std::size_t i = 0; i < std::min(words, arguments.size()); ++i)
    arguments[i]->texts = {said.words[i + 1]};
  take_study_file(options, warnings);
  for (const Option& option : options.options()) read(option);
  refuse_missing(options);
  if (words > arguments.size()) {
    throw UsageError{"one file too many: '" +
                         printable(without_password(said.words[arguments.size() + 1])) + "'",
                     ""};
  }
}

void require_file_names(const OptionList& options) {
  for (const Option& option : options.options()) {
    const bool is_name = option.value.completion != Completion::nothing;
    if (!is_name || !option.is_given() || !option.texts.front().empty()) continue;
    const std::string name = option.short_name();
    throw Error({"", 0, (option.is_argument() ? "the name of " : "") + name + " is empty", ""});
  }
}

}  // namespace thiessen::cli
