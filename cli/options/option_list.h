#pragma once

#include <deque>
#include <string>
#include <vector>

#include "cli/options/option.h"

namespace thiessen::cli {

class OptionBlock;
class OptionList;

/// The heading of options that have nothing to do with the command's own matter.
inline constexpr const char* general_group = "General";

/// A heading of the help, under which options are declared.
class OptionGroup {
 public:
  /// Declares an option (`--crs`, or `-o,--output`), or an argument (`STATIONS`). The reference
  /// lives as long as the list. Requires a name that the list does not have.
  Option& add(const std::string& names, OptionValue value, std::string help);

 private:
  friend class OptionList;
  OptionGroup(OptionList& list, std::string name, OptionBlock* block)
      : list_(list), name_(std::move(name)), block_(block) {}

  OptionList& list_;
  std::string name_;
  OptionBlock* block_;
};

/// The options and arguments that a command line may have, in the order of the help. Parsing, help,
/// manual and completion all come from this list.
class OptionList {
 public:
  OptionList() = default;
  OptionList(const OptionList&) = delete;
  OptionList& operator=(const OptionList&) = delete;

  /// A heading of the list. Options declared in it stand under the heading, and belong to the block
  /// if one is given.
  OptionGroup group(std::string name) { return {*this, std::move(name), nullptr}; }
  OptionGroup group(std::string name, OptionBlock& block) {
    return {*this, std::move(name), &block};
  }

  const std::deque<Option>& options() const { return options_; }
  /// The headings, in the order in which they first occur.
  std::vector<std::string> groups() const;
  std::vector<Option*> arguments();
  std::vector<const Option*> arguments() const;
  /// The option or argument with this name: `--output`, `-o` or STATIONS; nullptr where there is
  /// none.
  Option* find(const std::string& name);
  const Option* find(const std::string& name) const;
  /// The option or argument with this name. Throws logic_error where there is none: a check of an
  /// option that was renamed must not take it for one that is never given.
  const Option& at(const std::string& name) const;

 private:
  friend class OptionGroup;
  std::deque<Option> options_;  // a deque: references to its options stay valid
};

/// Options that are declared together and kept in one place: the classes that hold what the
/// command line says derive from it.
class OptionBlock {
 public:
  OptionBlock(const OptionBlock&) = delete;
  OptionBlock& operator=(const OptionBlock&) = delete;

  /// The first option of the block, in the order of the help, that the command line gives; nullptr
  /// where it gives none.
  const Option* first_given() const;

 protected:
  OptionBlock() = default;
  ~OptionBlock() = default;

 private:
  friend class OptionGroup;
  std::vector<const Option*> options_;
};

}  // namespace thiessen::cli
