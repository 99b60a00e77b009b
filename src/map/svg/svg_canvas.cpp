#include "map/svg/svg_canvas.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "map/svg/xml_text.h"

namespace thiessen {
namespace {

/// A number with at most so many decimals, in every locale alike.
std::string number(double value, int decimals = 2) {
  std::array<char, 64> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::fixed, decimals);
  std::string text(digits.data(), end.ptr);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + xml_text(value) + "\"";
}

std::string attribute(std::string_view name, double value) {
  return attribute(name, number(value));
}

std::string attributes(const PixelBox& box) {
  return attribute("x", box.x) + attribute("y", box.y) + attribute("width", box.width) +
         attribute("height", box.height);
}

std::string attributes(const Mark& mark) {
  std::string text;
  if (!mark.kind.empty()) text += attribute("class", mark.kind);
  if (!mark.station.empty()) text += attribute("data-station", mark.station);
  if (!mark.level.empty()) text += attribute("data-level", mark.level);
  if (!mark.basin.empty()) text += attribute("data-basin", mark.basin);
  return text;
}

std::string opacity(std::string_view of, int alpha) {
  constexpr double whole = 255;
  return alpha < whole ? attribute(of, number(alpha / whole, 3)) : std::string();
}

/// The points as a path; those that are written like the one before are left out, but for the last.
void add_path(std::span<const Point> points, Point origin, std::string& path) {
  std::string last;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::string at = number(points[i].x + origin.x) + " " + number(points[i].y + origin.y);
    if (i > 0 && i + 1 < points.size() && at == last) continue;
    path += (i == 0 ? "M" : "L") + at;
    last = std::move(at);
  }
}

/// A pattern of the area's colour with stripes, to be filled with.
std::string pattern(const std::string& id, Colour ground, const Hatch& hatch) {
  const double across = std::sqrt(0.5);
  const double side = hatch.spacing * across;
  const std::string height = attribute("height", side);
  return "<pattern" + attribute("id", id) + " patternUnits=\"userSpaceOnUse\"" +
         attribute("width", side) + height + " patternTransform=\"rotate(45)\"><rect" +
         attribute("width", side) + height + attribute("fill", hexadecimal(ground)) + "/><rect" +
         attribute("width", hatch.width * across) + height +
         attribute("fill", hexadecimal(hatch.colour)) + "/></pattern>\n";
}

/// What stands in a text's element: the part that the mark is of is an element of its own.
std::string content(const SetText& text, const Mark& mark) {
  const std::size_t at = mark.part.empty() ? std::string::npos : text.text.find(mark.part);
  if (at == std::string::npos) return xml_text(text.text);
  return xml_text(text.text.substr(0, at)) + "<tspan" + attributes(mark) + ">" +
         xml_text(mark.part) + "</tspan>" + xml_text(text.text.substr(at + mark.part.size()));
}

}  // namespace

std::string SvgCanvas::document(std::string_view title, std::string_view description,
                                const PaperSize& paper) const {
  const auto side = [](double millimetres, int pixels) {
    return millimetres > 0 ? number(millimetres, 3) + "mm" : number(pixels);
  };
  const std::string box = "0 0 " + number(width()) + " " + number(height());
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\"" +
         attribute("width", side(paper.width, width())) +
         attribute("height", side(paper.height, height())) + attribute("viewBox", box) +
         attribute("font-family", "'DejaVu Sans', Verdana, sans-serif") + ">\n<title>" +
         xml_text(title) + "</title>\n<desc>" + xml_text(description) + "</desc>\n<rect" +
         attributes(PixelBox{0, 0, width(), height()}) + " fill=\"#ffffff\"/>\n" + body_ +
         "</svg>\n";
}

std::string SvgCanvas::clip_path(const PixelBox& box) {
  const std::string rectangle = "<rect" + attributes(box) + "/>";
  if (rectangle != clip_) {
    clip_ = rectangle;
    ++clips_;
    body_ += "<clipPath" + attribute("id", "c" + std::to_string(clips_)) + ">" + rectangle +
             "</clipPath>\n";
  }
  return attribute("clip-path", "url(#c" + std::to_string(clips_) + ")");
}

void SvgCanvas::fill(const PixelBox& box, Colour colour) {
  if (box.width <= 0 || box.height <= 0) return;
  body_ += "<rect" + attributes(box) + attribute("fill", hexadecimal(colour)) + "/>\n";
}

void SvgCanvas::border(const PixelBox& box, Colour colour, int thickness) {
  if (box.width <= thickness || box.height <= thickness) return;
  const double half = thickness / 2.0;
  body_ += "<rect" + attribute("x", box.x + half) + attribute("y", box.y + half) +
           attribute("width", box.width - thickness) + attribute("height", box.height - thickness) +
           " fill=\"none\"" + attribute("stroke", hexadecimal(colour)) +
           attribute("stroke-width", thickness) + "/>\n";
}

void SvgCanvas::draw_disc(Point centre, double radius, Colour colour, const PixelBox& clip,
                          const Mark& mark) {
  const bool whole = centre.x - radius >= clip.x && centre.x + radius <= clip.right() &&
                     centre.y - radius >= clip.y && centre.y + radius <= clip.bottom();
  const std::string cut = whole ? std::string() : clip_path(clip);
  body_ += "<circle" + attributes(mark) + attribute("cx", centre.x) + attribute("cy", centre.y) +
           attribute("r", radius) + attribute("fill", hexadecimal(colour)) + cut + "/>\n";
}

void SvgCanvas::areas(std::span<const Area> areas, const Hatch& hatch, const Window& window) {
  const std::string clip = clip_path(window.box);
  // Crisp edges leave no seam between neighbours.
  std::string group = "<g fill-rule=\"evenodd\" shape-rendering=\"crispEdges\"" + clip + ">\n";
  std::string patterns;
  std::string ground;
  for (const Area& area : areas) {
    std::string path;
    for (const std::span<const Ring> rings : area.parts) {
      for (const Ring& ring : rings) {
        if (ring.empty()) continue;
        add_path(ring, window.origin, path);
        path += "Z";
      }
    }
    if (path.empty()) continue;
    std::string paint = hexadecimal(area.colour);
    if (area.hatched) {
      if (paint != ground) {
        ground = paint;
        ++hatches_;
        patterns += pattern("h" + std::to_string(hatches_), area.colour, hatch);
      }
      paint = "url(#h" + std::to_string(hatches_) + ")";
    }
    group +=
        "<path" + attributes(area.mark) + attribute("fill", paint) + attribute("d", path) + "/>\n";
  }
  body_ += patterns + group + "</g>\n";
}

void SvgCanvas::lines(std::span<const Polyline> lines, const Stroke& stroke, const Window& window) {
  std::string path;
  for (const Polyline line : lines) {
    if (line.size() > 1) add_path(line, window.origin, path);
  }
  if (path.empty()) return;
  const std::string clip = clip_path(window.box);
  body_ += "<path fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\"" +
           attribute("stroke", hexadecimal(stroke.colour)) +
           attribute("stroke-width", stroke.width) + opacity("stroke-opacity", stroke.alpha);
  if (stroke.dash > 0) {
    body_ += attribute("stroke-dasharray", number(stroke.dash) + " " + number(stroke.gap));
  }
  body_ += clip + attribute("d", path) + "/>\n";
}

void SvgCanvas::text(const SetText& text, int x, int y, const Lettering& lettering) {
  if (text.width() == 0) return;
  body_ += "<text";
  if (lettering.mark.part.empty()) body_ += attributes(lettering.mark);
  body_ += attribute("x", x) + attribute("y", y + text.baseline) +
           attribute("font-size", text.size) + attribute("textLength", text.width()) +
           attribute("fill", hexadecimal(lettering.colour));
  if (text.weight == Weight::bold) body_ += " font-weight=\"bold\"";
  // A line from right to left begins at its right end.
  if (text.right_to_left) body_ += " direction=\"rtl\" text-anchor=\"end\"";
  if (lettering.halo > 0) {
    body_ += attribute("stroke", "#ffffff") + attribute("stroke-width", 2 * lettering.halo) +
             " stroke-opacity=\"0.88\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
  }
  body_ += " xml:space=\"preserve\">" + content(text, lettering.mark) + "</text>\n";
}

void SvgCanvas::begin(const Mark& mark) {
  body_ += "<g" + attributes(mark) + ">\n";
}

void SvgCanvas::end() {
  body_ += "</g>\n";
}

}  // namespace thiessen
