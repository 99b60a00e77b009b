#include "map/sheet/qgis_layer_style.h"

#include "base/number.h"
#include "map/svg/xml_text.h"

namespace thiessen {
namespace {

constexpr Colour pale{223, 232, 238};
constexpr Colour line{90, 90, 90};
constexpr Colour dark{20, 20, 20};
constexpr Colour orange{217, 95, 2};

std::string property(const std::string& name, const std::string& value) {
  return "<prop k=\"" + name + "\" v=\"" + value + "\"/>";
}

std::string colour_text(Colour colour) {
  return std::to_string(colour.red) + "," + std::to_string(colour.green) + "," +
         std::to_string(colour.blue) + ",255";
}

std::string symbol(const std::string& type, std::size_t number, const std::string& layer_class,
                   const std::string& properties) {
  return "<symbol type=\"" + type + "\" name=\"" + std::to_string(number) +
         "\" alpha=\"1\" clip_to_extent=\"1\" force_rhr=\"0\"><layer class=\"" + layer_class +
         "\" enabled=\"1\" locked=\"0\" pass=\"0\">" + properties + "</layer></symbol>\n";
}

std::string filled(std::size_t number, Colour colour) {
  return symbol("fill", number, "SimpleFill",
                property("color", colour_text(colour)) + property("style", "solid") +
                    property("outline_color", colour_text(line)) +
                    property("outline_style", "solid") + property("outline_width", "0.1") +
                    property("outline_width_unit", "MM") + property("joinstyle", "round"));
}

std::string single(const std::string& symbol) {
  return "<renderer-v2 type=\"singleSymbol\" symbollevels=\"0\" enableorderby=\"0\" "
         "forceraster=\"0\">\n<symbols>\n" +
         symbol + "</symbols>\n</renderer-v2>\n";
}

/// Where a label stands, by QGIS's numbers.
enum class Placement { around_point = 0, along_line = 2, within_polygon = 4, beside_point = 6 };

std::string labels(const std::string& field, Placement placement, Colour colour, double size) {
  return "<labeling type=\"simple\">\n<settings calloutType=\"simple\">\n<text-style fieldName=\"" +
         field + "\" isExpression=\"0\" fontSize=\"" + shortest_text(size) +
         "\" fontSizeUnit=\"Point\" fontWeight=\"50\" namedStyle=\"Book\" textColor=\"" +
         colour_text(colour) +
         "\" textOpacity=\"1\"><text-buffer bufferDraw=\"1\" bufferSize=\"0.5\" "
         "bufferSizeUnits=\"MM\" bufferColor=\"255,255,255,255\" bufferOpacity=\"0.85\" "
         "bufferJoinStyle=\"128\"/></text-style>\n<placement placement=\"" +
         std::to_string(static_cast<int>(placement)) +
         "\" dist=\"0.6\" distUnits=\"MM\" placementFlags=\"10\" "
         "predefinedPositionOrder=\"TR,TL,BR,BL,R,L,TSR,BSR\"/>\n"
         "<rendering drawLabels=\"1\" obstacle=\"0\" scaleVisibility=\"0\"/>\n"
         "</settings>\n</labeling>\n";
}

std::string document(const std::string& renderer, const std::string& labeling) {
  return "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
         "<qgis version=\"3.22\" styleCategories=\"Symbology|Labeling\" labelsEnabled=\"" +
         std::string(labeling.empty() ? "0" : "1") + "\">\n" + renderer + labeling +
         "<blendMode>0</blendMode>\n<layerOpacity>1</layerOpacity>\n</qgis>\n";
}

std::string dot(std::size_t number, const std::string& fill, const std::string& outline,
                const std::string& width) {
  return symbol("marker", number, "SimpleMarker",
                property("name", "circle") + property("color", fill) +
                    property("outline_color", outline) + property("outline_width", width) +
                    property("outline_width_unit", "MM") + property("size", "1.8") +
                    property("size_unit", "MM"));
}

}  // namespace

std::vector<StyledClass> styled_classes(const RainfallClasses& classes, const std::string& unit) {
  const std::vector<double>& bounds = classes.bounds();
  const std::string suffix = unit.empty() ? "" : " " + unit;
  const std::string dry_apart = classes.has_dry() ? " AND \"rainfall\" <> 0" : "";
  std::vector<StyledClass> styled;
  if (classes.has_dry()) styled.push_back({"\"rainfall\" = 0", "dry", classes.colour(0)});
  for (std::size_t i = 0; i < classes.count(); ++i) {
    const bool has_low = i > 0 && i <= bounds.size();
    const bool has_high = i < bounds.size();
    const std::string low = has_low ? shortest_text(bounds[i - 1]) : "";
    const std::string high = has_high ? shortest_text(bounds[i]) : "";
    std::string filter = "\"rainfall\" IS NOT NULL";
    if (has_low) filter += " AND \"rainfall\" >= " + low;
    if (has_high) filter += " AND \"rainfall\" < " + high;
    std::string label = "rainfall";
    if (has_low && has_high)
      label = low + " to " + high + suffix;
    else if (has_high)
      label = "below " + high + suffix;
    else if (has_low)
      label = "from " + low + suffix;
    styled.push_back({filter + dry_apart, label, classes.class_colour(i)});
  }
  return styled;
}

// A rule a class: QGIS's classes of numbers give a value that is a bound to the lower of the two.
std::string style_of_cells(std::span<const StyledClass> classes) {
  if (classes.empty()) return document(single(filled(0, pale)), "");
  std::string rules;
  std::string symbols;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const std::string number = std::to_string(i);
    rules += "<rule key=\"class" + number + "\" symbol=\"" + number + "\" filter=\"" +
             xml_text(classes[i].filter) + "\" label=\"" + xml_text(classes[i].label) + "\"/>\n";
    symbols += filled(i, classes[i].colour);
  }
  return document(
      "<renderer-v2 type=\"RuleRenderer\" symbollevels=\"0\" enableorderby=\"0\" "
      "forceraster=\"0\">\n<rules key=\"rainfall\">\n" +
          rules + "</rules>\n<symbols>\n" + symbols + "</symbols>\n</renderer-v2>\n",
      "");
}

std::string style_of_basins() {
  return document(
      single(symbol("fill", 0, "SimpleFill",
                    property("color", "255,255,255,0") + property("style", "no") +
                        property("outline_color", colour_text(dark)) +
                        property("outline_style", "solid") + property("outline_width", "0.5") +
                        property("outline_width_unit", "MM") + property("joinstyle", "round"))),
      labels("basin", Placement::within_polygon, dark, 9));
}

std::string style_of_gauges(bool has_rainfall) {
  const std::string labelled = labels("station", Placement::beside_point, dark, 7);
  const std::string full = dot(0, colour_text(dark), "255,255,255,255", "0.2");
  if (!has_rainfall) return document(single(full), labelled);
  // As in the picture: a gauge without a reading is hollow.
  return document(
      "<renderer-v2 type=\"RuleRenderer\" symbollevels=\"0\" enableorderby=\"0\" "
      "forceraster=\"0\">\n<rules key=\"gauges\">\n"
      "<rule key=\"reading\" symbol=\"0\" filter=\"&quot;rainfall&quot; IS NOT NULL\" "
      "label=\"gauge\"/>\n"
      "<rule key=\"none\" symbol=\"1\" filter=\"&quot;rainfall&quot; IS NULL\" "
      "label=\"gauge without a reading\"/>\n</rules>\n<symbols>\n" +
          full + dot(1, "255,255,255,255", colour_text(dark), "0.4") +
          "</symbols>\n</renderer-v2>\n",
      labelled);
}

std::string style_of_isohyets() {
  return document(
      single(symbol("line", 0, "SimpleLine",
                    property("line_color", colour_text(orange)) + property("line_style", "solid") +
                        property("line_width", "0.35") + property("line_width_unit", "MM") +
                        property("joinstyle", "round"))),
      labels("rainfall", Placement::along_line, orange, 8));
}

}  // namespace thiessen
