#pragma once

#include <string>

#include "cli/options/arguments.h"
#include "cli/options/option_list.h"

namespace thiessen::cli {

/// The first option that the command line says and the list lacks, as it is written there; empty
/// where there is none.
std::string unknown_option(const OptionList& options, const Arguments& said);

/// Has the options read what the command line says of them; its words but the first, which names
/// the command, go to the arguments in their order. Throws UsageError, whose hint it leaves to the
/// caller, for the first that is found of: a value that is missing at the end; an option that is
/// given twice or has a wrong value, in the order of the list; arguments and options that are
/// required and missing; a word too many. Requires that no option is unknown.
void read_options(OptionList& options, const Arguments& said);

/// Throws Error where the name of a file is empty: that is no fault of the command line's form.
void require_file_names(const OptionList& options);

}  // namespace thiessen::cli
