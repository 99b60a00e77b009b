#include "cli/options/option_list.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "cli/options/name_lists.h"

namespace thiessen::cli {
namespace {

bool is_called(const Option& option, const std::string& name) {
  const bool is_letter = name.size() == 2 && name[0] == '-' && name[1] == option.letter;
  return option.name == name || is_letter;
}

}  // namespace

std::string Option::short_name() const {
  return letter == '\0' ? name : std::string("-") + letter;
}

std::string OptionValue::in_words() const {
  return choices.empty() ? kind : or_list(choices);
}

Option& OptionGroup::add(const std::string& names, OptionValue value, std::string help) {
  Option option;
  const std::size_t comma = names.find(',');
  option.name = comma == std::string::npos ? names : names.substr(comma + 1);
  if (comma != std::string::npos) option.letter = names.at(1);
  if (list_.find(option.name) != nullptr) throw std::logic_error(names + " is declared twice");
  option.group = name_;
  option.help = std::move(help);
  option.value = std::move(value);
  Option& added = list_.options_.emplace_back(std::move(option));
  if (block_ != nullptr) block_->options_.push_back(&added);
  return added;
}

std::vector<std::string> OptionList::groups() const {
  std::vector<std::string> names;
  for (const Option& option : options_) {
    if (std::find(names.begin(), names.end(), option.group) == names.end())
      names.push_back(option.group);
  }
  return names;
}

std::vector<Option*> OptionList::arguments() {
  std::vector<Option*> found;
  for (Option& option : options_) {
    if (option.is_argument()) found.push_back(&option);
  }
  return found;
}

std::vector<const Option*> OptionList::arguments() const {
  std::vector<const Option*> found;
  for (const Option& option : options_) {
    if (option.is_argument()) found.push_back(&option);
  }
  return found;
}

Option* OptionList::find(const std::string& name) {
  const auto found = std::find_if(options_.begin(), options_.end(),
                                  [&](const Option& option) { return is_called(option, name); });
  return found == options_.end() ? nullptr : &*found;
}

const Option* OptionList::find(const std::string& name) const {
  const auto found = std::find_if(options_.begin(), options_.end(),
                                  [&](const Option& option) { return is_called(option, name); });
  return found == options_.end() ? nullptr : &*found;
}

const Option& OptionList::at(const std::string& name) const {
  const Option* const found = find(name);
  if (found == nullptr) throw std::logic_error("there is no option " + name);
  return *found;
}

const Option* OptionBlock::first_given() const {
  const auto found = std::find_if(options_.begin(), options_.end(),
                                  [](const Option* option) { return option->is_given(); });
  return found == options_.end() ? nullptr : *found;
}

}  // namespace thiessen::cli
