#include "report/report.h"

#include <functional>
#include <map>
#include <optional>
#include <string_view>

#include "map/svg/xml_text.h"
#include "report/page_resources.h"
#include "report/report_legend.h"
#include "report/report_map.h"
#include "report/report_series.h"
#include "report/report_tables.h"

namespace thiessen {
namespace {

using Parts = std::map<std::string_view, std::function<std::string()>>;

/// The template with its parts in their places, `{{name}}`. What a part holds is not looked at, so
/// that no text of an input can name another part.
std::string filled(std::string_view page, const Parts& parts) {
  constexpr std::size_t mark = 2;  // letters
  std::string text;
  for (;;) {
    const std::size_t begin = page.find("{{");
    text += page.substr(0, begin);
    if (begin == std::string_view::npos) return text;
    const std::size_t end = page.find("}}", begin);
    text += parts.at(page.substr(begin + mark, end - begin - mark))();
    page.remove_prefix(end + mark);
  }
}

/// What the rainfall is in, behind what it is.
std::string rate_of(const Report& report) {
  const Picture& picture = *report.picture;
  if (picture.units.empty()) return "";
  return xml_text((picture.subtitle.empty() ? "" : ", ") + picture.units);
}

}  // namespace

std::string report_page(const Report& report) {
  const std::optional<RainfallClasses> of_steps = classes_of_steps(report);
  return filled(page_html, {{"title", [&] { return xml_text(report.picture->title); }},
                            {"what", [&] { return xml_text(report.picture->subtitle); }},
                            {"rate", [&] { return rate_of(report); }},
                            {"css", [] { return std::string(page_css); }},
                            {"map", [&] { return report_map(*report.picture); }},
                            {"network", [&] { return network_text(report); }},
                            {"legend", [&] { return report_legend(report, of_steps); }},
                            {"thinned", [&] { return thinning_text(report); }},
                            {"basins", [&] { return basins_table(report); }},
                            {"weights", [&] { return weights_table(report); }},
                            {"influence", [&] { return influence_table(report); }},
                            {"gaps", [&] { return gaps_table(report); }},
                            {"findings", [&] { return findings_list(report); }},
                            {"made-by", [&] { return made_by_table(report); }},
                            {"inputs", [&] { return inputs_table(report); }},
                            {"options", [&] { return xml_text(report.options); }},
                            {"data", [&] { return report_json(report, of_steps); }},
                            {"script", [] { return std::string(page_script); }}});
}

}  // namespace thiessen
