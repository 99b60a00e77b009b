#include "map/sheet/picture.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "base/memory.h"
#include "map/opencv/drawing_errors.h"
#include "map/opencv/typesetter.h"
#include "map/sheet/font_warnings.h"
#include "map/sheet/footer.h"
#include "map/sheet/graticule.h"
#include "map/sheet/left_out.h"
#include "map/sheet/legend.h"
#include "map/sheet/map_drawing.h"
#include "map/sheet/page.h"
#include "map/sheet/page_file.h"
#include "map/sheet/study_view.h"

namespace thiessen {
namespace {

[[noreturn]] void fail(std::string text) {
  throw Error(Message{{}, 0, std::move(text), {}});
}

/// All that is known of the page before it is drawn.
struct Sheet {
  explicit Sheet(const Picture& picture)
      : view(view_study(picture)),
        classes(classes_of(picture)),
        legend(picture, classes,
               page_style(picture.width, picture.height, picture.dots_to_the_inch), type),
        page(lay_out(picture, view.extent, legend, type)),
        detail{true, !page.style.bare} {
    const double pixels = static_cast<double>(page.panel.width) * page.panel.height;
    if (dots_would_cover(gauges_within(view), pixels)) detail = {false, false};
    thin_out(detail, view.bands.empty() ? view.cells.size() : 0, view.basins.size(), pixels);
    detail.has_basin_edges = has_lines(view.basins);
    if (!page.style.bare) legend = Legend({&picture, 1}, detail, classes, page.style, type);
  }

  StudyView view;
  Typesetter type;
  RainfallClasses classes;
  Legend legend;
  Page page;
  MapDetail detail;
};

/// Draws the page, and returns what has no room on it.
LeftOut draw(Canvas& canvas, const Picture& picture, Sheet& sheet) {
  const Page& page = sheet.page;
  StudyView& view = sheet.view;
  const PanelTransform transform(view.extent, page.panel);
  const LabelCount count =
      draw_map(canvas, page, picture, view, sheet.classes, sheet.detail, sheet.type);
  const std::string note =
      sheet.detail.has_gauges ? note_of(count) : note_of_crowd(picture.gauges.size());
  LeftOut left_out(page, count, sheet.detail);
  if (!page.style.bare) draw_graticule(canvas, page, view, transform, FrameEdges(), sheet.type);
  draw_head(canvas, page);
  if (sheet.legend.width() > 0) {
    sheet.legend.draw(canvas, page, sheet.classes);
    left_out.add(sheet.legend.left_out(page));
  }
  for (const std::string& lost :
       draw_footer(canvas, page, view, transform.scale(), picture.north_is_up, note, sheet.type))
    left_out.add_note(lost);
  return left_out;
}

std::string drawn(const Picture& picture, PictureFormat format, ImageEncoder encoder,
                  Warnings& warnings) {
  Sheet sheet(picture);
  std::string bytes = page_file(sheet.page, picture, format, encoder, [&](Canvas& canvas) {
    draw(canvas, picture, sheet).tell(warnings);
  });
  if (sheet.page.style.bare) {
    warnings.add_notice(
        {{}, 0, "the picture is too small for a title and a legend, and is the map alone", ""});
  }
  warn_of_fonts(sheet.type, warnings);
  warn_of_outside(sheet.classes, picture.surface.empty(), warnings);
  return bytes;
}

}  // namespace

RainfallClasses classes_of(std::span<const Picture> maps) {
  std::vector<double> values;
  ClassRule rule;
  for (const Picture& map : maps) {
    if (!map.by_rainfall) continue;
    rule = map.classes;
    values.insert(values.end(), map.surface.begin(), map.surface.end());
    if (!map.surface.empty()) continue;
    std::map<std::size_t, double> readings;
    for (const PictureCell& cell : map.cells) readings[cell.gauge] = cell.rainfall;
    for (const auto& [gauge, rainfall] : readings) values.push_back(rainfall);
  }
  return {std::move(values), rule};
}

RainfallClasses classes_of(const Picture& picture) {
  return classes_of({&picture, 1});
}

void warn_of_outside(const RainfallClasses& classes, bool is_of_gauges, Warnings& warnings) {
  const std::size_t count = classes.outside();
  if (count == 0) return;
  const std::string some =
      is_of_gauges ? std::to_string(count) + (count == 1 ? " gauge's" : " gauges'") : "some of the";
  warnings.add({{},
                0,
                some + " rainfall lies outside the range of the colours, and takes the colour at "
                       "its end",
                ""});
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

void check_picture_memory(int width, int height, PictureFormat format) {
  if (format == PictureFormat::svg) return;
  // Pixels, what is laid over them, and the file, which can be as large as the pixels.
  constexpr long long bytes_a_pixel = 9;
  const long long bytes = bytes_a_pixel * width * height;
  if (can_have(static_cast<std::size_t>(bytes))) return;
  throw Error(Message{{},
                      0,
                      "not enough memory to draw the picture: one of " + std::to_string(width) +
                          " x " + std::to_string(height) + " pixels takes about " +
                          std::to_string(1 + bytes / 1'000'000) + " MB",
                      "choose a smaller " + setting("size")});
}

std::string encode_picture(const Picture& picture, PictureFormat format, ImageEncoder encoder,
                           Warnings& warnings) {
  check_picture_size(picture.width, picture.height);
  check_picture_memory(picture.width, picture.height, format);
  try {
    return drawn(picture, format, encoder, warnings);
  } catch (...) {
    throw_drawing_error("choose a smaller " + setting("size"));
  }
}

}  // namespace thiessen
