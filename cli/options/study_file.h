#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "cli/options/option_list.h"

namespace thiessen::cli {

/// The option that names a file of further options.
inline constexpr const char* study_file_option = "--config";

/// Gives options and arguments the texts that a file of options (TOML) has for them, unless the
/// command line gives them already; a notice says of which. A key is an option's name without its
/// dashes, or an argument's; case does not count, and `_` is `-`. Names of files are relative to
/// the folder of the file. Options that are given by the file remember it as their origin.
///
/// Throws UsageError, with file, line and the nearest name, for a key that is no option, or one
/// that is given twice; and Error where the file cannot be read or is not TOML.
void take_study_file(OptionList& options, const std::string& path, Warnings& warnings);

/// The file of options that repeats a command: its options as they are given, but for those that
/// are about the output or change nothing in it. It is to stand in the folder, from which its
/// relative names are then counted. What it cannot hold, a password or a name that is not UTF-8, is
/// left out, with a warning. Requires that the folder exists.
std::string study_file_text(const OptionList& options, const std::string& command,
                            const std::string& folder, Warnings& warnings);

/// The options that study_file_text writes, a line each, for a reader: files are named without
/// their folders, so that the text does not depend on where things lie.
std::string study_options_text(const OptionList& options);

/// A file that an option or argument names.
struct GivenFile {
  std::string option;  ///< as its key in a file of options: stations
  std::string file;
};

/// The files that the options of the study name, in the options' order.
std::vector<GivenFile> given_files(const OptionList& options);

}  // namespace thiessen::cli
