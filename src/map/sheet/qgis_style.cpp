#include "map/sheet/qgis_style.h"

#include "base/number.h"
#include "map/sheet/palette.h"
#include "map/svg/xml_text.h"

namespace thiessen {
namespace {

std::string document(const std::string& renderer) {
  return "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
         "<qgis version=\"3.22\" styleCategories=\"Symbology\">\n<pipe>\n" +
         renderer +
         "<brightnesscontrast brightness=\"0\" contrast=\"0\" gamma=\"1\"/>\n"
         "<rasterresampler maxOversampling=\"2\"/>\n</pipe>\n<blendMode>0</blendMode>\n</qgis>\n";
}

std::string entry_text(const char* element, const std::string& value, const StyleEntry& entry) {
  return std::string("<") + element + " value=\"" + value + "\" label=\"" + xml_text(entry.label) +
         "\" color=\"" + hexadecimal(entry.colour) + "\"/>\n";
}

/// A colour as a ramp of QGIS's names it.
std::string ramp_colour(const char* name, const Colour& colour) {
  return std::string("<prop k=\"") + name + "\" v=\"" + std::to_string(colour.red) + "," +
         std::to_string(colour.green) + "," + std::to_string(colour.blue) + ",255\"/>\n";
}

}  // namespace

std::string style_of_values(std::span<const StyleEntry> entries) {
  std::string renderer =
      "<rasterrenderer type=\"paletted\" band=\"1\" opacity=\"1\" alphaBand=\"-1\">\n"
      "<colorPalette>\n";
  for (const StyleEntry& entry : entries)
    renderer += entry_text("paletteEntry", shortest_text(entry.value), entry);
  return document(renderer + "</colorPalette>\n</rasterrenderer>\n");
}

std::string style_of_classes(std::span<const StyleEntry> entries) {
  std::string renderer =
      "<rasterrenderer type=\"singlebandpseudocolor\" band=\"1\" opacity=\"1\" alphaBand=\"-1\">\n"
      "<rastershader>\n<colorrampshader colorRampType=\"DISCRETE\" clip=\"0\">\n";
  for (const StyleEntry& entry : entries) {
    const bool is_last = &entry == &entries.back();
    renderer += entry_text("item", is_last ? "inf" : shortest_text(entry.value), entry);
  }
  return document(renderer + "</colorrampshader>\n</rastershader>\n</rasterrenderer>\n");
}

std::string style_of_numbers(std::size_t last, std::size_t step) {
  const std::span<const Colour> colours = categorical_colours();
  const std::string end = std::to_string(last);
  // QGIS shows the ramp as one bar where it knows of one.
  std::string renderer =
      "<rasterrenderer type=\"singlebandpseudocolor\" band=\"1\" opacity=\"1\" alphaBand=\"-1\" "
      "classificationMin=\"1\" classificationMax=\"" +
      end +
      "\">\n<rastershader>\n<colorrampshader colorRampType=\"INTERPOLATED\" clip=\"0\" "
      "minimumValue=\"1\" maximumValue=\"" +
      end + "\">\n<colorramp type=\"gradient\" name=\"[source]\">\n" +
      ramp_colour("color1", colours.front()) + ramp_colour("color2", colours.back()) +
      "</colorramp>\n";
  for (std::size_t i = 0; i * step < last + step; ++i) {
    renderer += "<item value=\"" + std::to_string(1 + i * step) + "\" color=\"" +
                hexadecimal(colours[i % colours.size()]) + "\"/>\n";
  }
  return document(renderer + "</colorrampshader>\n</rastershader>\n</rasterrenderer>\n");
}

}  // namespace thiessen
