#include <memory>
#include <optional>
#include <string>

#include "base/outputs.h"
#include "cli/commands/commands.h"
#include "cli/inputs/gauges.h"
#include "cli/inputs/inputs.h"
#include "cli/options/common_options.h"
#include "cli/options/output_options.h"
#include "cli/options/rainfall_options.h"
#include "cli/options/study_options.h"
#include "cli/options/view_options.h"
#include "cli/outputs/cell_features.h"
#include "cli/outputs/encoded_files.h"

namespace thiessen::cli {
namespace {

class CellsCommand : public Command {
 public:
  CellsCommand() {
    study_.declare(options(), Need::optional);
    rainfall_.declare(options(), Need::optional, study_.stations);
    view_.declare_time(options());
    view_.declare_margin(options());
    study_.declare_attributes(options());
    output_.declare(
        options(), Need::optional, "cells.geojson",
        "where the cells go; the extension tells the format, PG:... is a database; default GeoJSON "
        "on standard output");
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
    const CellsOutput output = cells_output(inputs, cells, shown, study_, view_.units);
    const std::string name = table ? table->name() : to_stream ? "standard output" : output_.output;
    if (table) {
      cells_table(output, *table, warnings);
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
  StudyOptions study_;
  RainfallOptions rainfall_;
  ViewOptions view_;
  OutputOptions output_;
  CommonOptions common_;
};

}  // namespace

std::unique_ptr<Command> make_cells_command() {
  return std::make_unique<CellsCommand>();
}

}  // namespace thiessen::cli
