#include "base/outputs.h"
#include "cli/cell_features.h"
#include "cli/commands/commands.h"
#include "cli/gauges.h"
#include "cli/inputs.h"
#include "cli/options/options.h"

namespace thiessen::cli {
namespace {

class CellsCommand : public Command {
 public:
  const char* name() const override { return "cells"; }
  const char* description() const override {
    return "Thiessen cells clipped to the basins: GeoJSON, or any vector format by extension";
  }
  const char* example() const override {
    return "samples/colorado/stations.csv samples/colorado/counties.geojson -o "
           "cells.geojson";
  }
  void set_up(CLI::App& app) override {
    study_.add_to(app, Need::optional);
    rainfall_.add_to(app, Need::optional);
    view_.add_time_to(app);
    view_.add_margin_to(app);
    study_.add_attributes_to(app);
    output_.add_to(
        app, Need::optional, "cells.geojson",
        "where the cells go; the extension tells the format; default GeoJSON on standard output");
    common_.add_to(app);
  }

  void run(Warnings& warnings) override {
    Outputs outputs(output_.rules({study_.stations, study_.basins, rainfall_.rainfall}));
    const bool to_stream = output_.output == "-";
    if (!to_stream) require_cells_format(output_.output);
    OutputFile& file = outputs.add(output_.output);
    Inputs inputs(study_, view_.margin, warnings);
    const auto readings = shown_readings(inputs, study_, rainfall_, view_.time, warnings);
    const GaugeReadings* shown = readings ? &*readings : nullptr;
    const auto cells = cells_of(inputs, shown, static_cast<unsigned>(common_.threads));
    const CellsOutput output = cells_output(inputs, cells, shown, study_);
    if (to_stream) {
      file.append(cells_geojson(output));
    } else {
      const auto encoded = cells_files(output, output_.output);
      file.append(encoded.front().bytes);
      for (std::size_t i = 1; i < encoded.size(); ++i)
        outputs.add(encoded[i].name).append(encoded[i].bytes);
    }
    warn_of_own_coordinates(inputs, output_.output, warnings);
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
