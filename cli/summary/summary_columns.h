#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/summary/fitted_table.h"
#include "results/summary_file.h"

namespace thiessen::cli {

/// The summary of a run as columns for a reader. Rainfall and its standard errors share their
/// decimals: two digits of the middle error and at least one of the smallest are shown or, where
/// there are no errors, three digits of the middle mean; six decimals at most. `area` heads the
/// areas, and `unit`, which is empty or begins with a blank, ends the headings of rainfall, and
/// `depth_unit` those of the largest depths in lengths of time.
std::vector<TableColumn> summary_columns(std::span<const BasinSummary> basins,
                                         const std::string& area, const std::string& unit,
                                         const std::string& depth_unit);

}  // namespace thiessen::cli
