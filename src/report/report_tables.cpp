#include "report/report_tables.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "base/number.h"
#include "map/svg/xml_text.h"
#include "rainfall/gaps/gap_policies.h"

namespace thiessen {
namespace {

constexpr std::size_t most_rows = 5'000;

struct Column {
  std::string heading;
  bool is_number = false;
};

/// The lines that a heading's words make where none is longer than `width`, if its words are not.
std::size_t lines_at(const std::string& heading, std::size_t width) {
  std::size_t lines = 1;
  std::size_t filled = 0;
  for (std::size_t begin = 0; begin < heading.size();) {
    const std::size_t end = std::min(heading.find(' ', begin), heading.size());
    const std::size_t word = end - begin;
    const bool fits = filled == 0 || filled + 1 + word <= width;
    lines += fits ? 0 : 1;
    filled = fits && filled > 0 ? filled + 1 + word : word;
    begin = end + 1;
  }
  return lines;
}

/// The characters that a column is wide at least, so that its heading takes so many lines at most.
std::size_t least_width(const std::string& heading, std::size_t most_lines) {
  std::size_t width = 1;
  while (lines_at(heading, width) > most_lines) ++width;
  return width;
}

/// A table in HTML: a caption, headings that sort it, and rows of texts.
class HtmlTable {
 public:
  HtmlTable(const std::string& caption, const std::vector<Column>& columns)
      : columns_(columns),
        html_("<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" +
              xml_text(caption) + "\"><table class=\"sortable\"><caption>" + xml_text(caption) +
              "</caption>\n<thead><tr>") {
    // A telephone shows four columns; of a table that is moved sideways no heading may stand high
    // that is out of sight.
    const std::size_t lines = columns_.size() > 4 ? 2 : 3;
    for (const Column& column : columns_) {
      html_ += std::string("<th scope=\"col\"") + (column.is_number ? " class=\"n\"" : "") +
               "><button type=\"button\" style=\"min-width:" +
               std::to_string(least_width(column.heading, lines) + 2) + "ch\">" +
               xml_text(column.heading) + "</button></th>";
    }
    html_ += "</tr></thead>\n<tbody>\n";
  }

  void add(const std::vector<std::string>& row) {
    if (++rows_ > most_rows) return;
    html_ += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string name = i == 0 ? "th" : "td";
      html_ += "<" + name + (i == 0 ? " scope=\"row\"" : "") +
               (columns_[i].is_number ? " class=\"n\"" : "") + ">" + xml_text(row[i]) + "</" +
               name + ">";
    }
    html_ += "</tr>\n";
  }

  /// The table; `whole` is the file that has all its rows.
  std::string text(const std::string& whole) && {
    html_ += "</tbody></table></div>\n";
    if (rows_ > most_rows) {
      html_ += "<p>The first " + std::to_string(most_rows) + " of " + std::to_string(rows_) +
               " rows" + (whole.empty() ? "" : "; " + whole + " has all") + ".</p>\n";
    }
    return std::move(html_);
  }

 private:
  std::vector<Column> columns_;
  std::string html_;
  std::size_t rows_ = 0;
};

std::string rain_text(const std::optional<double>& value) {
  return value ? significant_text(*value, 4) : "";
}

std::string with_unit(const std::string& heading, const std::string& unit) {
  return unit.empty() ? heading : heading + " (" + unit + ")";
}

std::string area_heading(const Report& report) {
  return report.is_area_known ? "area (km\xC2\xB2)" : "area";
}

std::string bar_text(const BasinSummary& basin) {
  if (!basin.mean || !basin.standard_error) return "";
  constexpr double quantile = 1.96;
  const double half = quantile * *basin.standard_error;
  return significant_text(std::max(0.0, *basin.mean - half), 4) + " to " +
         significant_text(*basin.mean + half, 4);
}

/// The columns of the largest depths, the same in all basins, and of the times when they began.
void add_depths(const Report& report, std::vector<Column>& columns) {
  if (report.basins.empty()) return;
  for (const BasinDepth& depth : report.basins.front().depths) {
    columns.push_back({with_unit("most in " + depth.length, report.depth_unit), true});
    columns.push_back({"from"});
  }
}

/// A table of names and values.
std::string pairs_table(const std::string& caption,
                        const std::vector<std::pair<std::string, std::string>>& pairs) {
  std::string html = "<table><caption>" + xml_text(caption) + "</caption>\n<tbody>\n";
  for (const auto& [name, value] : pairs) {
    html +=
        "<tr><th scope=\"row\">" + xml_text(name) + "</th><td>" + xml_text(value) + "</td></tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string paragraphs(const std::string& lines) {
  std::string html;
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    html += "<p>" + xml_text(lines.substr(begin, end - begin)) + "</p>\n";
    begin = end + 1;
  }
  return html;
}

}  // namespace

std::string basins_table(const Report& report) {
  std::vector<Column> columns{{"basin"},
                              {area_heading(report), true},
                              {"gauges inside", true},
                              {"weighing", true},
                              {"largest weight", true},
                              {with_unit("mean", report.unit), true},
                              {with_unit("95 % bar of the mean", report.unit), true},
                              {with_unit("largest", report.unit), true},
                              {"empty steps", true}};
  add_depths(report, columns);
  HtmlTable table("Gauges, weights and rainfall of each basin", columns);
  for (const BasinSummary& basin : report.basins) {
    std::vector<std::string> row{basin.basin,
                                 significant_text(basin.area, 4),
                                 std::to_string(basin.gauges_inside),
                                 std::to_string(basin.gauges_weighing),
                                 fixed_text(basin.largest_weight, 3),
                                 rain_text(basin.mean),
                                 bar_text(basin),
                                 rain_text(basin.largest),
                                 std::to_string(basin.empty_steps)};
    for (const BasinDepth& depth : basin.depths) {
      row.push_back(rain_text(depth.depth));
      row.push_back(depth.time);
    }
    table.add(row);
  }
  return std::move(table).text("summary.csv") + paragraphs(report.remarks);
}

std::string weights_table(const Report& report) {
  std::vector<Column> columns{{"basin"}, {"gauge"}, {area_heading(report), true}, {"weight", true}};
  if (report.has_factors) columns.push_back({"factor", true});
  HtmlTable table("Weights of the full network", columns);
  for (const WeightRow& weight : report.weights) {
    std::vector<std::string> row{weight.basin, weight.station, significant_text(weight.area, 4),
                                 significant_text(weight.weight, 4)};
    if (report.has_factors) row.push_back(significant_text(weight.factor, 4));
    table.add(row);
  }
  return std::move(table).text("weights.csv");
}

std::string influence_table(const Report& report) {
  const bool any = std::any_of(report.basins.begin(), report.basins.end(),
                               [](const auto& basin) { return !basin.most_influential.empty(); });
  if (!any) return "<p>No gauge is known to change the rainfall of a basin by leaving.</p>\n";
  HtmlTable table("The gauge of each basin without which its rainfall changes most",
                  {{"basin"},
                   {"most influential gauge"},
                   {with_unit("change, root mean square", report.unit), true}});
  for (const BasinSummary& basin : report.basins) {
    if (basin.most_influential.empty()) continue;
    table.add({basin.basin, basin.most_influential, significant_text(basin.influence, 3)});
  }
  return std::move(table).text("summary.csv");
}

std::string gaps_table(const Report& report) {
  const ThinnedSeries& series = *report.series;
  const std::vector<PictureGauge>& gauges = report.picture->gauges;
  HtmlTable table(
      "Silent gauges",
      {{"gauge"}, {"silent steps", true}, {"share (%)", true}, {"longest silence (steps)", true}});
  std::size_t without = 0;
  const auto add = [&](std::size_t gauge, std::size_t silent, std::size_t longest) {
    const double share = 100.0 * static_cast<double>(silent) /
                         static_cast<double>(std::max<std::size_t>(series.steps(), 1));
    table.add({gauges[gauge].station, std::to_string(silent), fixed_text(share, 1),
               std::to_string(longest)});
  };
  for (std::size_t g = 0; g < report.network; ++g) {
    if (series.silent_steps()[g] == 0)
      ++without;
    else
      add(g, series.silent_steps()[g], series.longest_silences()[g]);
  }
  for (std::size_t g = report.network; g < gauges.size(); ++g)
    add(g, series.steps(), series.steps());
  if (without == gauges.size()) return "<p>Every gauge reports in every step.</p>\n";
  return std::move(table).text("") + "<p>" + std::to_string(without) + " of " +
         std::to_string(gauges.size()) +
         " gauges report in every step; the others are listed.</p>\n";
}

std::string network_text(const Report& report) {
  const auto after = [&]() -> std::string {
    switch (report.gaps) {
      case Gaps::retessellate:
        return "their ground goes to those around them that report";
      case Gaps::renormalise:
        return "the weights of the others are scaled up to 1";
      case Gaps::strict:
        return "the basins in which they weigh have no value";
    }
    return "";
  };
  return "Cells and weights are those of the full network. Where gauges are silent at a step, " +
         after() + " (" + name_of(report.gaps) + ").";
}

std::string findings_list(const Report& report) {
  if (report.findings.empty()) return "<p>Nothing odd was found.</p>\n";
  std::string html = "<ul>\n";
  std::string tables;
  for (const std::string& finding : report.findings) {
    const std::size_t end = finding.find('\n');
    if (end == std::string::npos || end + 1 == finding.size())
      html += "<li>" + xml_text(finding) + "</li>\n";
    else
      tables += "<pre class=\"wide\" tabindex=\"0\">" + xml_text(finding) + "</pre>\n";
  }
  return html + "</ul>\n" + tables;
}

std::string made_by_table(const Report& report) {
  return pairs_table("How it was made", report.made_by);
}

std::string inputs_table(const Report& report) {
  std::string html =
      "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Inputs\"><table>"
      "<caption>Inputs</caption>\n<thead><tr><th "
      "scope=\"col\">input</th><th scope=\"col\">file</th><th scope=\"col\">SHA-256</th></tr>"
      "</thead>\n<tbody>\n";
  for (const Report::Input& input : report.inputs) {
    html += "<tr><th scope=\"row\">" + xml_text(input.role) + "</th><td>" + xml_text(input.name) +
            "</td><td><code>" + xml_text(input.sha256) + "</code></td></tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace thiessen
