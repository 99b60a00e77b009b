#pragma once

#include <string>

namespace thiessen::cli {

/// What `--version` prints: the name and the version, and a line each for the commit and for the
/// libraries on whose version a result or a fault may depend.
std::string versions();

}  // namespace thiessen::cli
