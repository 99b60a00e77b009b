#include "cli/options/study_file.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>

#include "base/destination.h"
#include "base/number.h"
#include "base/secrets.h"
#include "base/utf8.h"
#include "base/version.h"
#include "cli/options/name_lists.h"
#include "cli/options/toml_file.h"
#include "cli/options/usage_error.h"
#include "files/database/postgres.h"
#include "text/last_line.h"
#include "text/similar_texts.h"

namespace thiessen::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* file_name = "study.toml";
/// Options that no file of options has.
const std::set<std::string> never = {"--config", "--help", "--version"};
/// Options that say where results go and how they are come by, and change nothing in them.
const std::set<std::string> not_of_study = {"--output", "--overwrite", "--threads", "--quiet"};

/// The name under which a file of options has the option or the argument.
std::string key_of(const Option& option) {
  return lower_case(option.is_argument() ? option.name : option.name.substr(2));
}

std::string as_key(std::string written) {
  std::replace(written.begin(), written.end(), '_', '-');
  return lower_case(written);
}

/// Finds the option of a key before the argument of the same name: one file after --rainfall is the
/// same as RAINFALL.
Option* option_of(OptionList& options, const std::string& key) {
  Option* option = options.find("--" + key);
  if (option != nullptr) return never.contains(option->name) ? nullptr : option;
  for (Option* argument : options.arguments()) {
    if (key_of(*argument) == key) return argument;
  }
  return nullptr;
}

UsageError unknown_key(const OptionList& options, const std::string& where,
                       const std::string& key) {
  std::vector<std::string> names;
  for (const Option& option : options.options()) {
    const std::string name = key_of(option);
    const bool is_there = std::find(names.begin(), names.end(), name) != names.end();
    if (!never.contains(option.name) && !is_there) names.push_back(name);
  }
  return {where + "unknown option '" + printable(key) + "'",
          did_you_mean(nearest_names(as_key(key), names))};
}

bool names_a_file(const Option& option) {
  return option.value.completion != Completion::nothing;
}

/// Whether the option is given, and one that a study's file has.
bool is_of_study(const Option& option) {
  return option.is_given() && !never.contains(option.name) && !not_of_study.contains(option.name);
}

bool is_relative_file(const std::string& name) {
  return !name.empty() && name != "-" && !is_database(name) && fs::path(name).is_relative();
}

/// The options that a study's file has, in its order. What an option and an argument of one key
/// give stands where the argument does: the file repeats itself, however it was given.
std::vector<const Option*> options_of_study(const OptionList& options) {
  std::set<std::string> keys;
  std::vector<const Option*> given;
  for (const Option& option : options.options()) {
    if (is_of_study(option) && keys.insert(key_of(option)).second) given.push_back(&option);
    if (!option.is_argument()) continue;
    const Option* same = options.find("--" + key_of(option));
    if (same != nullptr && is_of_study(*same) && keys.insert(key_of(option)).second)
      given.push_back(same);
  }
  return given;
}

/// Throws UsageError where the value is of a kind that the option cannot mean.
void require_kind(const Option& option, const TomlSetting& setting, const std::string& where) {
  const std::string text = setting.texts.empty() ? "" : setting.texts.front();
  const auto hint = [&] {
    return "a text stands in quotes: " + key_of(option) + " = \"" + text + '"';
  };
  if (setting.is_truth && !option.is_flag()) {
    throw UsageError{where + "'" + printable(setting.key) + "' is " + text + ", and wants a value",
                     hint()};
  }
  if (!setting.is_text && names_a_file(option)) {
    throw UsageError{where + "'" + printable(setting.key) + "' names a file, and " +
                         printable(text) + " is no text",
                     hint()};
  }
}

/// The options that the command line gives, by their keys.
std::set<std::string> given_keys(const OptionList& options) {
  std::set<std::string> keys;
  for (const Option& option : options.options()) {
    if (option.is_given()) keys.insert(key_of(option));
  }
  return keys;
}

/// The path without links in it, or as it is where the system does not tell.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  // A folder that is not made yet is seen from where it will lie.
  const fs::path whole = fs::current_path(error) / path;
  const fs::path found = error ? path : fs::weakly_canonical(whole, error);
  return error ? path.lexically_normal() : found;
}

/// The file's name as it is seen from the folder. Where the way to it is not one of plain folders,
/// links count as the system follows them.
std::string seen_from(const fs::path& folder, const std::string& name) {
  if (!is_relative_file(name)) return name;
  const bool goes_up = name.find("..") != std::string::npos;
  std::error_code error;
  const fs::path whole = fs::current_path(error) / name;
  const fs::path target = goes_up ? resolved(whole) : whole.lexically_normal();
  return target.lexically_relative(folder).string();
}

std::string without(std::string text, const std::string& part, const std::string& instead) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
    text.replace(at, part.size(), instead);
  return text;
}

/// A connection without its password, as libpq then looks for it elsewhere.
std::string connection_without_password(const std::string& name) {
  return without(without(without_password(name), "password=***", ""), ":***@", "@");
}

/// Whether a number of an option is written in TOML as it is on the command line.
bool is_plain_number(const Option& option, const std::string& text) {
  if (option.value.kind != "N" && option.value.kind != "NUMBER") return false;
  if (text.size() > 15) return false;
  if (const auto whole = parse_size(text)) return std::to_string(whole.value) == text;
  const auto number = parse_number(text);
  return number && text.find('.') != std::string::npos && shortest_text(number.value) == text;
}

/// The file's name without its folders; a database is none.
std::string without_folders(const std::string& name) {
  if (name == "-" || lower_case(name).starts_with("pg:")) return name;
  const fs::path path = fs::path(name).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

/// Writes the options of a study, one on each line: for the folder in which the text is to stand
/// or, where there is none, without the folders of files.
class StudyFileText {
 public:
  StudyFileText(std::string file, std::optional<fs::path> folder, Warnings& warnings)
      : file_(std::move(file)), folder_(std::move(folder)), warnings_(warnings) {}

  void add(const Option& option) {
    std::vector<std::string> values;
    for (const std::string& text : option.texts) values.push_back(value_of(option, text));
    if (std::find(values.begin(), values.end(), "") != values.end()) {
      leave_out(option, "is not UTF-8, as TOML has to be; give it on the command line");
      return;
    }
    text_ += key_of(option) + " = ";
    if (option.is_flag()) values.resize(1);
    for (std::size_t i = 0; i < values.size(); ++i)
      text_ += (i > 0 ? ", " : values.size() > 1 ? "[" : "") + values[i];
    text_ += values.size() > 1 ? "]\n" : "\n";
  }

  std::string text() && { return std::move(text_); }

 private:
  /// The value in TOML; empty where it cannot be written.
  std::string value_of(const Option& option, std::string text) {
    if (option.is_flag()) return "true";
    if (is_plain_number(option, text)) return text;
    if (names_a_file(option)) {
      if (without_password(text) != text) {
        warnings_.add({file_, 0, "the password of " + option.name + " is left out",
                       "PGPASSWORD or a .pgpass file gives it"});
        text = connection_without_password(text);
      }
      text = folder_ ? seen_from(*folder_, text) : without_folders(text);
    }
    return find_invalid_utf8(text) ? "" : toml_text(text);
  }

  void leave_out(const Option& option, const std::string& reason) {
    warnings_.add({file_, 0, option.name + " " + reason, ""});
    text_ += "# " + key_of(option) + " " + reason + "\n";
  }

  std::string file_;
  std::optional<fs::path> folder_;
  Warnings& warnings_;
  std::string text_;
};

}  // namespace

void take_study_file(OptionList& options, const std::string& path, Warnings& warnings) {
  tell_of_last_line(path, warnings);
  const std::set<std::string> given = given_keys(options);
  std::set<std::string> taken;
  std::vector<std::string> passed_over;
  for (TomlSetting& setting : read_toml(path)) {
    const std::string where = printable(path) + ":" + std::to_string(setting.line) + ": ";
    Option* option = option_of(options, as_key(setting.key));
    if (option == nullptr) throw unknown_key(options, where, setting.key);
    if (!taken.insert(key_of(*option)).second)
      throw UsageError{where + "'" + printable(setting.key) + "' is given twice", ""};
    if (given.contains(key_of(*option))) {
      passed_over.push_back(key_of(*option));
      continue;
    }
    require_kind(*option, setting, where);
    option->origin = where;
    option->texts = std::move(setting.texts);
    if (option->is_flag()) std::erase(option->texts, "false");
    if (!names_a_file(*option)) continue;
    for (std::string& name : option->texts) {
      if (is_relative_file(name)) name = (fs::path(path).parent_path() / name).string();
    }
  }
  if (passed_over.empty()) return;
  warnings.add_notice(
      {path, 0, "taken from the command line instead: " + and_list(passed_over), ""});
}

std::string study_file_text(const OptionList& options, const std::string& command,
                            const std::string& folder, Warnings& warnings) {
  StudyFileText text(folder + "/" + file_name, resolved(folder), warnings);
  for (const Option* option : options_of_study(options)) text.add(*option);
  return std::string("# thiessen ") + version() + "\n# Computed again by: thiessen " + command +
         " --config " + file_name +
         " -o FOLDER\n# Relative names of files count from this file's folder.\n" +
         std::move(text).text();
}

std::string study_options_text(const OptionList& options) {
  Warnings told;  // by the file that repeats the study
  StudyFileText text(file_name, std::nullopt, told);
  for (const Option* option : options_of_study(options)) text.add(*option);
  return std::move(text).text();
}

std::vector<GivenFile> given_files(const OptionList& options) {
  std::vector<GivenFile> files;
  for (const Option* option : options_of_study(options)) {
    if (!names_a_file(*option)) continue;
    for (const std::string& file : option->texts) files.push_back({key_of(*option), file});
  }
  return files;
}

}  // namespace thiessen::cli
