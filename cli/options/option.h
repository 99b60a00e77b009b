#pragma once

#include <functional>
#include <string>
#include <vector>

namespace thiessen::cli {

/// What a shell completes where a value stands.
enum class Completion { nothing, file, folder };

/// What is wrong with a value, as it goes on after the option's name: "is empty".
struct WrongValue {
  std::string complaint;
};

/// The value of an option: what stands for it in the help, and how its text is read.
struct OptionValue {
  /// FIELD, or `a|b` where it is one of a list. It is empty for a flag, which takes no value, and
  /// for an argument, for which its own name stands.
  std::string kind;
  /// Takes the text of the command line. Throws WrongValue.
  std::function<void(const std::string& text)> read;
  /// What a shell offers; they are all there is where `kind` lists them.
  std::vector<std::string> choices;
  Completion completion = Completion::nothing;
  bool may_be_repeated = false;

  /// What it may be, in words: `FIELD`, or `geodesic or planar`.
  std::string in_words() const;
};

enum class Need { required, optional };

/// An option, or an argument: a value such as STATIONS, which its place tells and no name.
struct Option {
  std::string name;    ///< `--output`, or STATIONS
  char letter = '\0';  ///< of `-o`; zero: none
  std::string group;   ///< the heading under which it stands
  std::string help;    ///< what it is for, as it follows the name
  OptionValue value;
  Need need = Need::optional;
  /// What the command line says, a text each time that the option stands there.
  std::vector<std::string> texts;

  bool is_argument() const { return name.front() != '-'; }
  bool is_flag() const { return !is_argument() && value.kind.empty(); }
  bool is_given() const { return !texts.empty(); }
  /// `-o` where it has a letter, else its name.
  std::string short_name() const;
};

}  // namespace thiessen::cli
