#include "map/sheet/multiples.h"

#include <algorithm>

#include "map/ink/ink.h"
#include "map/ink/signs.h"
#include "map/opencv/drawing_errors.h"
#include "map/opencv/typesetter.h"
#include "map/sheet/font_warnings.h"
#include "map/sheet/footer.h"
#include "map/sheet/graticule.h"
#include "map/sheet/left_out.h"
#include "map/sheet/legend.h"
#include "map/sheet/map_drawing.h"
#include "map/sheet/multiples_page.h"
#include "map/sheet/page_file.h"
#include "map/sheet/study_view.h"

namespace thiessen {
namespace {

/// The extent that all maps have in common, so that a place is at one spot of each.
Extent common_extent(std::span<const Picture> maps, const StudyView& first) {
  Extent extent = first.extent;
  for (const Picture& map : maps.subspan(1)) {
    const Extent more = view_study(map, first).extent;
    extent.add({more.west, more.south});
    extent.add({more.east, more.north});
  }
  return extent;
}

/// What has room on a map: small ones with hundreds of gauges show the cells alone.
MapDetail detail_of(const MultiplesPage& layout, const StudyView& view) {
  constexpr double smallest_dot = 2;    // pixels
  constexpr double room_of_label = 20;  // ems squared
  const MapGrid& grid = layout.grid;
  const double pixels = static_cast<double>(grid.width) * grid.height;
  const int em = layout.style.em;
  // Labels are 0.6 of an em at least, and never smaller than the page's least type.
  const double label_em = std::max<double>(em, layout.style.least_type / 0.6);
  const std::size_t gauges = gauges_within(view);
  const auto labels = static_cast<double>(std::max(gauges, view.basins.size()));
  MapDetail detail{gauge_radius(em, gauges, pixels) >= smallest_dot,
                   labels * room_of_label * label_em * label_em <= pixels};
  thin_out(detail, view.bands.empty() ? view.cells.size() : 0, view.basins.size(), pixels);
  detail.has_basin_edges = has_lines(view.basins);
  return detail;
}

/// All that is known of the page before it is drawn.
struct Sheet {
  explicit Sheet(std::span<const Picture> all)
      : maps(all),
        view(view_study(all.front())),
        classes(classes_of(all)),
        legend(all, detail, classes, style(), type) {
    view.extent = common_extent(all, view);
    layout = lay_out_multiples(all.front(), all.size(), view.extent, legend, type);
    detail = detail_of(layout, view);
    legend = Legend(all, detail, classes, style(), type);
  }
  PageStyle style() const {
    const Picture& first = maps.front();
    return page_style(first.width, first.height, first.dots_to_the_inch);
  }

  std::span<const Picture> maps;
  StudyView view;  ///< of the first map
  Typesetter type;
  RainfallClasses classes;
  MapDetail detail;
  Legend legend;
  MultiplesPage layout;
};

void draw_heading(Canvas& canvas, Sheet& sheet, std::size_t map) {
  const PageStyle& style = sheet.layout.page.style;
  const PixelBox& box = sheet.layout.maps[map];
  const SetText text =
      sheet.type.fit(sheet.maps[map].subtitle, style.ems(0.85),
                     std::max(style.least_type, style.ems(0.5)), box.width, Weight::bold);
  canvas.text(text, box.x, box.y - style.ems(0.45) - text.baseline, {ink::text, 0, {"heading"}});
}

LabelCount draw_one(Canvas& canvas, Sheet& sheet, std::size_t map) {
  const MultiplesPage& layout = sheet.layout;
  const Group group(canvas, {"map"});
  draw_heading(canvas, sheet, map);
  Page page;
  page.width = layout.page.width;
  page.height = layout.page.height;
  page.style = layout.style;
  page.panel = layout.maps[map];
  StudyView view = view_study(sheet.maps[map], sheet.view);
  view.extent = sheet.view.extent;
  const LabelCount count =
      draw_map(canvas, page, sheet.maps[map], view, sheet.classes, sheet.detail, sheet.type);
  const FrameEdges edges{is_lowest(layout.grid, sheet.maps.size(), map),
                         map % static_cast<std::size_t>(layout.grid.columns) == 0};
  page.style.em = std::max(page.style.em, layout.page.style.ems(0.75));
  draw_graticule(canvas, page, view, PanelTransform(view.extent, page.panel), edges, sheet.type);
  return count;
}

/// Words what every map lacks, and what some do.
std::string note_of_all(const LabelCount& each, const LabelCount& all, const MapDetail& detail) {
  if (!detail.has_gauges)
    return "not drawn: the " + std::to_string(each.gauges) + " gauges, too many for small maps";
  const std::string in_sight = note_of({each.gauges, each.in_sight, 0, 0});
  const std::string parted = in_sight.empty() ? "" : in_sight + ", ";
  if (!detail.has_labels) return parted + "not labelled: too many for small maps";
  const std::string labelled = note_of({0, 0, all.to_label, all.labelled});
  return labelled.empty() ? in_sight : parted + labelled + " on all maps";
}

/// Draws the page, and returns what has no room on it.
LeftOut draw(Canvas& canvas, Sheet& sheet) {
  Page page = sheet.layout.page;
  LabelCount each;
  LabelCount all;
  for (std::size_t i = 0; i < sheet.maps.size(); ++i) {
    each = draw_one(canvas, sheet, i);
    all += each;
  }
  // Basins are the same on all maps, isohyets are not.
  LabelCount told = all;
  told.to_name = each.to_name;
  told.named = each.named;
  LeftOut left_out(page, told, sheet.detail);
  page.panel = sheet.layout.maps.front();
  draw_head(canvas, page);
  if (sheet.legend.width() > 0) {
    sheet.legend.draw(canvas, page, sheet.classes);
    left_out.add(sheet.legend.left_out(page));
  }
  const double scale = PanelTransform(sheet.view.extent, page.panel).scale();
  for (const std::string& lost :
       draw_footer(canvas, page, sheet.view, scale, sheet.maps.front().north_is_up,
                   note_of_all(each, all, sheet.detail), sheet.type))
    left_out.add_note(lost);
  return left_out;
}

}  // namespace

std::string encode_multiples(std::span<const Picture> maps, PictureFormat format,
                             ImageEncoder encoder, Warnings& warnings) {
  if (maps.size() == 1) return encode_picture(maps.front(), format, encoder, warnings);
  check_picture_size(maps.front().width, maps.front().height);
  check_picture_memory(maps.front().width, maps.front().height, format);
  try {
    Sheet sheet(maps);
    std::string bytes = page_file(sheet.layout.page, maps.front(), format, encoder,
                                  [&](Canvas& canvas) { draw(canvas, sheet).tell(warnings); });
    warn_of_fonts(sheet.type, warnings);
    warn_of_outside(sheet.classes, maps.front().surface.empty(), warnings);
    return bytes;
  } catch (...) {
    throw_drawing_error("choose a smaller " + setting("size"));
  }
}

}  // namespace thiessen
