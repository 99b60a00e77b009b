#include "study/basin_placing.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "base/parallel.h"
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

/// What has become of a basin, and what is to be said of it.
struct Placed {
  MultiPolygon shape;
  Warnings warnings;
  std::optional<Error> fault;  ///< why it has no shape
};

MultiPolygon mended_or_thrown(RawBasin& basin, const MendingRules& rules, const std::string& file,
                              Warnings& warnings) {
  WideEdges wide;
  const std::string fault = rules.round_the_earth ? unwrap_longitudes(basin.polygons, wide) : "";
  if (!fault.empty()) throw Error({file, basin.line, basin.place + ": " + fault, hint_for(wide)});
  Complaints complaints;
  std::optional<MultiPolygon> mended = mend(basin, rules, file, warnings, complaints);
  complaints.throw_if_any();
  tell_assumptions(basin, wide, *mended, file, warnings);
  return *std::move(mended);
}

Placed place(RawBasin& basin, const MendingRules& rules, const std::string& file) {
  Placed placed;
  try {
    placed.shape = mended_or_thrown(basin, rules, file, placed.warnings);
  } catch (const Error& error) {
    placed.fault = error;
  }
  basin.polygons.clear();
  return placed;
}

}  // namespace

std::vector<MultiPolygon> mend_basins(BasinList& basins, const MendingRules& rules,
                                      Warnings& warnings, unsigned threads) {
  std::vector<Placed> placed(basins.basins.size());
  in_parallel(placed.size(), threads, [&](std::size_t, std::size_t i) {
    placed[i] = place(basins.basins[i], rules, basins.file);
  });
  std::vector<MultiPolygon> shapes;
  shapes.reserve(placed.size());
  Complaints complaints;
  for (Placed& basin : placed) {
    for (const Message& message : basin.warnings.messages()) warnings.add(message);
    if (basin.fault) {
      for (const Message& message : basin.fault->messages()) complaints.add(message);
    } else {
      shapes.push_back(std::move(basin.shape));
    }
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
