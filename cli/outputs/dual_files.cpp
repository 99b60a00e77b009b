#include "cli/outputs/dual_files.h"

#include <array>
#include <cstddef>
#include <utility>

#include "base/interrupt.h"
#include "cli/options/blocks/output_options.h"
#include "cli/outputs/cell_features.h"
#include "cli/outputs/encoded_files.h"
#include "cli/outputs/provenance_of.h"
#include "files/cells_file.h"
#include "files/triangles_file.h"
#include "outlines/geodesic_triangle.h"
#include "rainfall/network/network_dual.h"
#include "results/borders_file.h"

namespace thiessen::cli {
namespace {

/// The triangles with their outlines in the study's coordinates. Those that have no inside there,
/// because their corners are on one geodesic to within rounding, are none.
TrianglesOutput triangles_output(const Inputs& inputs, const NetworkDual& dual, double tolerance) {
  TrianglesOutput output;
  const auto& stations = inputs.network().stations();
  const Metric metric = inputs.weighing().yardstick().metric;
  for (const auto& corners : dual.triangles) {
    throw_if_interrupted();
    TriangleFeature triangle;
    std::array<Point, 3> at{};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      triangle.stations.at(i) = stations[index(corners.at(i))].id;
      at.at(i) = inputs.network().places()[index(inputs.network().place_of(corners.at(i)))];
    }
    if (metric == Metric::planar) {
      triangle.shape = {{{at.begin(), at.end()}, {}}};
    } else {
      // Half of the tolerance is for rounding when the triangles are written.
      triangle.shape = geodesic_triangle(at, tolerance / 2);
    }
    if (!triangle.shape.empty()) output.triangles.push_back(std::move(triangle));
  }
  return output;
}

}  // namespace

DualFiles::DualFiles(Outputs& outputs, const DualOptions& options, const std::string& output)
    : outputs_(outputs),
      triangles_name_(options.takes_place_of_cells() ? output : options.delaunay) {
  const std::string& triangles = triangles_name_;
  const std::string& borders = options.neighbours;
  if (!triangles.empty()) {
    require_output_file(triangles);
    if (triangles != "-") require_cells_format(triangles);
    triangles_ = &outputs.add(triangles);
    older_ = older_layers(triangles);
  }
  if (!borders.empty()) {
    require_table_name(borders);
    borders_ = &outputs.add(borders);
  }
}

void DualFiles::write(const Inputs& inputs, const StudyOptions& study,
                      const GaugeReadings* readings, const std::string& unit, unsigned threads,
                      Warnings& warnings) {
  if (triangles_ == nullptr && borders_ == nullptr) return;
  const NetworkDual dual = network_dual(
      inputs.network(), readings == nullptr ? inputs.all_report() : readings->reports(),
      inputs.weighing().yardstick(), threads);
  if (dual.left_out > 0) {
    const std::string share =
        dual.left_out == 1
            ? "1 station shares a place with one before it in the file, which stands for both"
            : std::to_string(dual.left_out) +
                  " stations share a place with one before them in the file, which stands for all";
    warnings.add_notice({"", 0, share + " in triangles and among neighbours", {}});
  }
  if (borders_ != nullptr) write_borders(*borders_, inputs.network(), dual);
  if (triangles_ == nullptr) return;
  const bool to_stream = triangles_name_ == "-";
  const std::string name = to_stream ? "standard output" : triangles_name_;
  TrianglesOutput output = triangles_output(inputs, dual, study.tolerance());
  output.study_crs = inputs.study().crs;
  output.file_crs = inputs.study().output_crs();
  output.tolerance = study.tolerance();
  output.made_by = provenance_of(inputs, study, readings, unit);
  if (output.triangles.empty()) {
    warnings.add_notice({name,
                         0,
                         dual.places < 3 ? "there are no triangles, for there are fewer than three "
                                           "places"
                                         : "there are no triangles, for all places are on one line",
                         {}});
  }
  if (!inputs.study().crs) {
    warnings.add(
        {name, 0, "the triangles are in the plane's own coordinates: no CRS is known", ""});
  }
  if (to_stream) {
    triangles_->append(triangles_geojson(output, name, warnings));
  } else {
    append_files(outputs_, *triangles_,
                 triangles_files(output, name, warnings, older_ ? older_->bytes() : ""));
  }
}

}  // namespace thiessen::cli
