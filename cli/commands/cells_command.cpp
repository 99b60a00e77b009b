#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/outputs.h"
#include "cli/commands/commands.h"
#include "cli/inputs/gauges.h"
#include "cli/inputs/inputs.h"
#include "cli/options/common_options.h"
#include "cli/options/isohyet_options.h"
#include "cli/options/option_values.h"
#include "cli/options/output_options.h"
#include "cli/options/rainfall_options.h"
#include "cli/options/study_options.h"
#include "cli/options/usage_error.h"
#include "cli/options/view_options.h"
#include "cli/outputs/cell_features.h"
#include "cli/outputs/encoded_files.h"
#include "cli/outputs/shown_values.h"
#include "cli/outputs/study_package_of.h"
#include "gdal/output/cells_layer.h"
#include "gdal/output/layer_formats.h"

namespace thiessen::cli {
namespace {

class CellsCommand : public Command {
 public:
  CellsCommand() {
    study_.declare(options(), Need::optional);
    rainfall_.declare(options(), Need::optional, study_.stations);
    view_.declare_time(options());
    view_.declare_margin(options());
    isohyets_.declare_study(options());
    study_.declare_attributes(options());
    output_.declare(
        options(), Need::optional, "cells.geojson",
        "where the cells go; the extension tells the format, PG:... is a database; default GeoJSON "
        "on standard output");
    options().group("Output").add(
        "--study", flag(whole_study_),
        "the whole study in one .gpkg: layers cells, gauges, basins and, with --interval, "
        "isohyets, the table weights, and how QGIS shows them");
    output_.declare_table(options(), "cells");
    common_.declare(options());
  }

  const char* name() const override { return "cells"; }
  const char* description() const override {
    return "Thiessen cells clipped to the basins: GeoJSON, or any vector format by extension";
  }
  const char* example() const override {
    return "samples/colorado/stations.csv samples/colorado/counties.geojson -o "
           "cells.geojson";
  }
  void check() const override {
    study_.check();
    rainfall_.check();
    view_.check(rainfall_.given(), study_.has_basins());
    output_.check();
    if (whole_study_ && extension_of(output_.output) != "gpkg") {
      throw UsageError{"--study writes one GeoPackage, and the output is none",
                       "-o study.gpkg names one"};
    }
    if (!isohyets_.has_interval()) return;
    if (!whole_study_)
      throw UsageError{"--interval is the step between isohyets of --study", "give --study too"};
    if (!rainfall_.given())
      throw UsageError{"--interval is about rainfall, and there is no RAINFALL", ""};
  }

  void run(Warnings& warnings) override {
    Outputs outputs(output_.rules(rainfall_.files_beside({study_.stations, study_.basins})));
    const bool to_stream = output_.output == "-";
    std::optional<DatabaseTable> table;
    if (output_.is_database()) {
      table.emplace(output_.table());
    } else if (!to_stream) {
      require_cells_format(output_.output);
    }
    OutputFile& file = table ? table->rows() : outputs.add(output_.output);
    const std::unique_ptr<GeoPackageCopy> older = older_layers(output_.output);
    Inputs inputs(study_, view_.margin, common_.threads, warnings);
    if (!rainfall_.given()) note_whole_network(inputs, warnings);
    const auto readings = shown_readings(inputs, study_, rainfall_, view_.time(), warnings);
    const GaugeReadings* shown = readings ? &*readings : nullptr;
    if (shown != nullptr) view_.units = unit_shown(shown->unit, view_.units, false, "");
    const auto cells = cells_of(inputs, shown, static_cast<unsigned>(common_.threads));
    CellsOutput output = cells_output(inputs, cells, shown, study_, view_.units);
    if (shown != nullptr && holds_colours(output_.output))
      output.colours = colours_of(inputs, output, *shown);
    const std::string name = table ? table->name() : to_stream ? "standard output" : output_.output;
    if (table) {
      cells_table(output, *table, warnings);
    } else if (whole_study_) {
      file.append(packaged(inputs, output, shown, older ? older->bytes() : "", warnings));
    } else if (to_stream) {
      file.append(cells_geojson(output, "standard output", warnings));
    } else {
      append_files(outputs, file,
                   cells_files(output, output_.output, warnings, older ? older->bytes() : ""));
    }
    warn_of_new_names(output, name, warnings);
    warn_of_own_coordinates(inputs, table ? name : output_.output, warnings);
    outputs.commit();
  }
  bool quiet() const override { return common_.quiet; }

 private:
  std::string packaged(const Inputs& inputs, const CellsOutput& output,
                       const GaugeReadings* readings, const std::string& older,
                       Warnings& warnings) const {
    const auto threads = static_cast<unsigned>(common_.threads);
    PackageParts parts{.readings = readings,
                       .unit = readings == nullptr ? "" : view_.units,
                       .interval = isohyets_.interval,
                       .threads = threads};
    const std::vector<BasinWeights> weights = inputs.weighing().weights(
        readings == nullptr ? inputs.all_report() : readings->reports(), threads);
    parts.weights = &weights;
    if (readings != nullptr) parts.classes = classes_of(inputs, *readings);
    return study_package(study_package_of(inputs, output, parts), output_.output, older, warnings);
  }

  /// The classes that a picture of the same cells has.
  RainfallClasses classes_of(const Inputs& inputs, const GaugeReadings& readings) const {
    return {shown_values(inputs, readings, static_cast<unsigned>(common_.threads)), {}};
  }
  std::vector<Colour> colours_of(const Inputs& inputs, const CellsOutput& output,
                                 const GaugeReadings& readings) const {
    const RainfallClasses classes = classes_of(inputs, readings);
    std::vector<Colour> colours;
    for (const CellFeature& cell : output.cells) colours.push_back(classes.colour(cell.rainfall));
    return colours;
  }

  StudyOptions study_;
  RainfallOptions rainfall_;
  ViewOptions view_;
  IsohyetOptions isohyets_;
  bool whole_study_ = false;
  OutputOptions output_;
  CommonOptions common_;
};

}  // namespace

std::unique_ptr<Command> make_cells_command() {
  return std::make_unique<CellsCommand>();
}

}  // namespace thiessen::cli
