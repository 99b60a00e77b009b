#pragma once

#include <functional>
#include <string>
#include <vector>

namespace thiessen::cli {

/// The kinds of names that a shell completes where a value stands.
enum class Completion { nothing, file, folder };

/// Thrown for a wrong value. The complaint goes on after the option's name: "is empty".
struct WrongValue {
  std::string complaint;
};

/// The value of an option: the word for it in the help, and how its text is read.
struct OptionValue {
  /// The word that stands for the value in the help: FIELD, or `a|b` for a choice. It is empty for
  /// a flag, which takes no value, and for an argument, whose own name stands there.
  std::string kind;
  /// Reads the text of the command line into its target. Throws WrongValue.
  std::function<void(const std::string& text)> read;
  /// The values that a shell offers; where `kind` lists them there are no others.
  std::vector<std::string> choices;
  Completion completion = Completion::nothing;
  bool may_be_repeated = false;
  /// The text that stands for a value that is left out, because nothing or another option follows
  /// the name; empty where a value has to follow.
  std::string when_left_out = {};

  /// Says in words what the value may be: `FIELD`, or `geodesic or planar`.
  std::string in_words() const;
};

enum class Need { required, optional };

/// An option, or an argument such as STATIONS: a value that is known by its place and not by a
/// name.
struct Option {
  std::string name;    ///< `--output`, or STATIONS
  char letter = '\0';  ///< the letter of `-o`; zero: none
  std::string group;   ///< the heading under which it stands
  std::string help;    ///< its purpose, in words that follow the name
  OptionValue value;
  Need need = Need::optional;
  /// Options of which one may stand in the place of an argument that is required.
  std::vector<const Option*> instead = {};
  /// The texts that the command line gives, one for each time that the option stands there.
  std::vector<std::string> texts;
  /// The place in a file of options that gives the texts, as messages begin: `study.toml:3: `. It
  /// is empty where the command line gives them.
  std::string origin = {};

  bool is_argument() const { return name.front() != '-'; }
  bool is_flag() const { return !is_argument() && value.kind.empty(); }
  bool is_given() const { return !texts.empty(); }
  /// The shortest way to give the option: `-o` where it has a letter, else its name.
  std::string short_name() const;
};

}  // namespace thiessen::cli
