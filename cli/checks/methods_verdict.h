#pragma once

#include <string>
#include <vector>

#include "rainfall/leaving_out/method_errors.h"

namespace thiessen::cli {

/// What a method is called as it was tried: "idw", "idw with normals".
std::string tried_name(PointMethod method, bool with_normals);
/// So many decimals that the least of some errors, but for those that are next to nothing beside
/// the largest, has three digits that tell.
int decimals_for(const std::vector<double>& errors);
/// An error with so many decimals; "-" where there is none.
std::string error_text(double error, int decimals);

/// Says in one line which method is best at the steps, by how much, and whether that is more than
/// chance; `unit` may be empty.
std::string verdict_on(const MethodErrors& errors, const std::string& unit);

}  // namespace thiessen::cli
