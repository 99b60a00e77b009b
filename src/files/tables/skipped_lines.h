#pragma once

#include "base/error.h"
#include "files/tables/source.h"

namespace thiessen {

/// An error about the head of a CSV, with the hint that the lines to skip were said of all CSV
/// files, where they were: then it may be those of another file that should be skipped. Any other
/// error stays as it is.
Error told_of_skip(const Error& error, const Source& source);

}  // namespace thiessen
