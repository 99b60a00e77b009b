#include "study/basin_placing.h"

#include <optional>
#include <string>
#include <utility>

#include "outlines/area_words.h"
#include "outlines/common_turn.h"
#include "outlines/longitudes.h"

namespace thiessen {
namespace {

void bring_together(std::vector<CurvedShape>& shapes) {
  std::vector<CurvedShape*> all;
  all.reserve(shapes.size());
  for (CurvedShape& shape : shapes) all.push_back(&shape);
  bring_to_common_turn(all);
}

Wording hint_for(const WideEdges& wide) {
  if (!wide.unclear.empty()) return "add a vertex to the edge, so that its way is known";
  return "a ring may wind round the Earth once; one that runs up the antimeridian and along a pole "
         "holds that pole";
}

/// Tells of a basin what was assumed of its wide edges, and the area that comes of it.
void tell_assumptions(const RawBasin& basin, const WideEdges& wide, const MultiPolygon& shape,
                      const std::string& file, Warnings& warnings) {
  std::string text;
  for (const std::string& assumption : wide.assumptions())
    text += (text.empty() ? "" : "; ") + assumption;
  if (text.empty()) return;
  text += ": its area is " + area_words(shape, std::nullopt, /*on_earth=*/true);
  warnings.add({file, basin.line, basin.place + ": " + text, {}});
}

}  // namespace

std::vector<MultiPolygon> mend_basins(BasinList& basins, const MendingRules& rules,
                                      Warnings& warnings) {
  std::vector<MultiPolygon> shapes;
  shapes.reserve(basins.basins.size());
  Complaints complaints;
  for (RawBasin& basin : basins.basins) {
    WideEdges wide;
    const std::string fault = rules.round_the_earth ? unwrap_longitudes(basin.polygons, wide) : "";
    if (!fault.empty()) {
      complaints.add({basins.file, basin.line, basin.place + ": " + fault, hint_for(wide)});
      continue;
    }
    auto mended = mend(basin, rules, basins.file, warnings, complaints);
    if (mended) {
      tell_assumptions(basin, wide, *mended, basins.file, warnings);
      shapes.push_back(*std::move(mended));
    }
    basin.polygons.clear();
  }
  complaints.throw_if_any();
  return shapes;
}

void bring_basins_together(std::vector<Basin>& basins) {
  std::vector<CurvedShape> shapes;
  shapes.reserve(basins.size());
  for (Basin& basin : basins) shapes.push_back({std::move(basin.shape), std::move(basin.bulges)});
  bring_together(shapes);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    basins[i].shape = std::move(shapes[i].shape);
    basins[i].bulges = std::move(shapes[i].bulges);
  }
}

void bring_basins_together(std::vector<MultiPolygon>& shapes) {
  std::vector<CurvedShape> straight;
  straight.reserve(shapes.size());
  for (MultiPolygon& shape : shapes) straight.push_back({std::move(shape), {}});
  bring_together(straight);
  for (std::size_t i = 0; i < straight.size(); ++i) shapes[i] = std::move(straight[i].shape);
}

}  // namespace thiessen
