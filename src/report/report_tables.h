#pragma once

#include <string>

#include "report/report.h"

namespace thiessen {

/// The parts of the page that are tables and lists, as HTML. Columns of a table can be sorted:
/// their headings are buttons. A table of more than 5,000 rows is cut there, and says so.
std::string basins_table(const Report& report);
std::string weights_table(const Report& report);
std::string influence_table(const Report& report);
std::string gaps_table(const Report& report);
/// Says which cells and weights are shown, and what silent gauges change of them.
std::string network_text(const Report& report);
std::string findings_list(const Report& report);
std::string made_by_table(const Report& report);
std::string inputs_table(const Report& report);

}  // namespace thiessen
