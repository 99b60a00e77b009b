#include "map/sheet/picture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "map/ink/canvas.h"
#include "map/ink/ink.h"
#include "map/ink/unicode.h"
#include "map/opencv/drawing_errors.h"
#include "map/opencv/encoding.h"
#include "map/opencv/label_image.h"
#include "map/opencv/pixel_canvas.h"
#include "map/opencv/typesetter.h"
#include "map/sheet/annotation.h"
#include "map/sheet/footer.h"
#include "map/sheet/graticule.h"
#include "map/sheet/legend.h"
#include "map/sheet/map_panel.h"
#include "map/sheet/page.h"
#include "map/sheet/study_view.h"
#include "map/svg/svg_canvas.h"

namespace thiessen {
namespace {

[[noreturn]] void fail(std::string text) {
  throw Error(Message{{}, 0, std::move(text), {}});
}

void draw_map(Canvas& canvas, const Page& page, const Picture& picture, StudyView view,
              const RainfallClasses& classes, Typesetter& type) {
  const PanelTransform transform(view.extent, page.panel);
  to_pixels(view, transform);
  const PixelBox sight = sight_box(view, transform, page.panel);
  const LabelImage basins = basin_labels(view, page.panel);
  Annotation annotation(canvas, page, picture, view, type);
  const LabelImage cells = cell_labels(view, page.panel, sight);
  draw_cells(canvas, page.panel, sight, picture, view, cells, classes, page.style.em);
  draw_outlines(canvas, page, view, sight);
  annotation.draw_gauges();
  if (!page.style.bare) {
    constexpr std::size_t few = 40;
    const bool names_first = picture.basins.size() <= few;
    if (names_first && picture.basins.size() > 1) annotation.draw_basin_names(basins);
    annotation.draw_labels(pixels_of_gauges(picture, cells));
    if (!names_first) annotation.draw_basin_names(basins);
  }
  canvas.border(page.panel, ink::border, page.style.hairline);
  if (!page.style.bare) draw_graticule(canvas, page, view, transform, type);
  draw_footer(canvas, page, view, transform.scale(), picture.north_is_up, annotation.note(), type);
}

std::string some_of(const std::set<char32_t>& characters) {
  constexpr std::size_t listed = 5;
  std::u32string some;
  for (const char32_t c : characters) {
    if (some.size() < listed && c != U' ' && !is_attached(c)) some.push_back(c);
  }
  return to_utf8(some);
}

/// Debian's packages of fonts with the outlines of these characters.
std::string packages_for(const std::set<char32_t>& characters) {
  const auto is_east_asian = [](char32_t c) {
    return (c >= 0x1100 && c <= 0x11FF) || (c >= 0x2E80 && c <= 0xA4CF) ||
           (c >= 0xAC00 && c <= 0xD7FF) || (c >= 0xF900 && c <= 0xFAFF) ||
           (c >= 0xFF00 && c <= 0xFFEF) || (c >= 0x20000 && c <= 0x3FFFF);
  };
  const auto is_other = [&](char32_t c) { return c != U' ' && !is_east_asian(c); };
  const bool east_asian = std::any_of(characters.begin(), characters.end(), is_east_asian);
  const bool other = std::any_of(characters.begin(), characters.end(), is_other);
  if (east_asian && other) return "fonts-noto-cjk and fonts-noto-core";
  return east_asian ? "fonts-noto-cjk" : "fonts-noto-core";
}

void warn_of_fonts(const Typesetter& type, Warnings& warnings) {
  if (!type.missing().empty()) {
    warnings.add({{},
                  0,
                  "no installed font shows " + std::to_string(type.missing().size()) +
                      " of the picture's characters, such as " + some_of(type.missing()),
                  "install fonts for their script, such as fonts-noto-core, fonts-noto-cjk or "
                  "fonts-unifont"});
  }
  const std::string coarse = some_of(type.coarse());
  if (coarse.empty()) return;
  warnings.add_notice({{},
                       0,
                       "some of the picture's characters, such as " + coarse +
                           ", are drawn from bitmaps, whose letters do not join",
                       "install a font with their outlines: " + packages_for(type.coarse())});
}

/// All that is known of the page before it is drawn.
struct Sheet {
  explicit Sheet(const Picture& picture)
      : view(view_study(picture)),
        classes(classes_of(picture)),
        legend(picture, classes,
               page_style(picture.width, picture.height, picture.dots_to_the_inch), type),
        page(lay_out(picture, view.extent, legend, type)) {}

  StudyView view;
  Typesetter type;
  RainfallClasses classes;
  Legend legend;
  Page page;
};

void draw(Canvas& canvas, const Picture& picture, Sheet& sheet) {
  const Page& page = sheet.page;
  draw_map(canvas, page, picture, std::move(sheet.view), sheet.classes, sheet.type);
  for (const TitleLine& line : page.title) {
    canvas.text(line.text, page.style.em, line.baseline - line.text.baseline,
                {ink::text, 0, {"title"}});
  }
  canvas.text(page.subtitle, page.style.em, page.subtitle_baseline - page.subtitle.baseline,
              {ink::quiet_text, 0, {"subtitle"}});
  if (sheet.legend.width() > 0) sheet.legend.draw(canvas, page, sheet.classes);
}

/// What the picture's tags say, on one line.
std::string description_of(const Picture& picture) {
  std::string text;
  for (const auto& [name, value] : picture.tags) {
    text += (text.empty() ? "" : "; ") + (name == "software" ? value : name + ": " + value);
  }
  return text;
}

void warn_of_outside(const RainfallClasses& classes, Warnings& warnings) {
  if (classes.outside() == 0) return;
  const bool one = classes.outside() == 1;
  warnings.add({{},
                0,
                std::to_string(classes.outside()) + (one ? " gauge's" : " gauges'") +
                    " rainfall lies outside the range of the colours, and takes the colour at its "
                    "end",
                ""});
}

std::string drawn(const Picture& picture, PictureFormat format, Warnings& warnings) {
  Sheet sheet(picture);
  std::string bytes;
  if (format == PictureFormat::svg) {
    SvgCanvas canvas(sheet.page.width, sheet.page.height);
    draw(canvas, picture, sheet);
    bytes = canvas.document(picture.title, description_of(picture), picture.dots_to_the_inch);
  } else {
    PixelCanvas canvas(sheet.page.width, sheet.page.height);
    draw(canvas, picture, sheet);
    const bool png = format == PictureFormat::png;
    const auto file = encoded(canvas, png ? PixelFormat::png : PixelFormat::jpeg, picture.tags,
                              picture.dots_to_the_inch);
    bytes.assign(file.begin(), file.end());
  }
  warn_of_fonts(sheet.type, warnings);
  warn_of_outside(sheet.classes, warnings);
  return bytes;
}

}  // namespace

RainfallClasses classes_of(const Picture& picture) {
  std::map<std::size_t, double> readings;
  if (picture.by_rainfall) {
    for (const PictureCell& cell : picture.cells) readings[cell.gauge] = cell.rainfall;
  }
  std::vector<double> values;
  values.reserve(readings.size());
  for (const auto& [gauge, rainfall] : readings) values.push_back(rainfall);
  ClassRule rule;
  if (picture.by_rainfall) rule = picture.classes;
  return RainfallClasses(std::move(values), rule);
}

void check_picture_size(int width, int height) {
  const auto outside = [](int side) { return side < min_picture_side || side > max_picture_side; };
  const std::string limits = std::to_string(min_picture_side) + " to " +
                             std::to_string(max_picture_side) + " pixels a side";
  if (outside(width)) {
    fail("a picture " + std::to_string(width) + " pixels wide is outside the limits of " + limits);
  }
  if (height == 0) return;
  if (outside(height)) {
    fail("a picture " + std::to_string(height) + " pixels high is outside the limits of " + limits);
  }
  if (static_cast<long long>(width) * height > max_picture_pixels) {
    fail("a picture of " + std::to_string(width) + " x " + std::to_string(height) +
         " pixels is larger than the limit of " + std::to_string(max_picture_pixels) + " pixels");
  }
}

std::string encode_picture(const Picture& picture, PictureFormat format, Warnings& warnings) {
  check_picture_size(picture.width, picture.height);
  try {
    return drawn(picture, format, warnings);
  } catch (...) {
    throw_drawing_error("choose a smaller " + setting("size"));
  }
}

}  // namespace thiessen
