#pragma once

#include <string>

#include "base/error.h"
#include "cli/options/arguments.h"
#include "cli/options/option_list.h"

namespace thiessen::cli {

/// The first option on the command line that the list lacks, as it is written there; empty where
/// there is none.
std::string unknown_option(const OptionList& options, const Arguments& said);

/// Has the options read their values from the command line. Its words go to the arguments in their
/// order, but for the first word, which names the command. What the command line does not give, a
/// file after --config may: see take_study_file. Requires that no option is unknown.
///
/// Throws UsageError for the first fault in this order: a value that is missing at the end; an
/// option that is given twice or has a wrong value, in the order of the list; arguments and options
/// that are required and missing; a word too many. The caller adds the hint.
void read_options(OptionList& options, const Arguments& said, Warnings& warnings);

/// Throws Error where the name of a file is empty. It is no UsageError, as the form of the command
/// line is right.
void require_file_names(const OptionList& options);

}  // namespace thiessen::cli
