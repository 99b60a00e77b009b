#include "base/outputs.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "cli/session.h"
#include "io/rain_file.h"

namespace thiessen::cli {
namespace {

class RainCommand : public Command {
 public:
  const char* name() const override { return "rain"; }
  const char* description() const override { return "areal rainfall, one row a time step"; }
  const char* example() const override {
    return "samples/textbook/stations.csv samples/textbook/basin.csv "
           "samples/textbook/rainfall.csv";
  }
  void set_up(CLI::App& app) override {
    study_.add_to(app, Need::required);
    rainfall_.add_to(app, Need::required);
    gaps_.add_to(app);
    format_.add_to(app);
    output_.add_to(app, Need::optional, "rain.csv",
                   "where the series goes; default standard output");
    common_.add_to(app);
  }

  void run(Warnings& warnings) override {
    Outputs outputs(output_.rules({study_.stations, study_.basins, rainfall_.rainfall}));
    OutputFile& file = outputs.add(output_.output);
    Session session(study_, 0, warnings);
    const auto readings = session.open_readings(study_, rainfall_, warnings);
    ArealRainfallSettings settings = gaps_.settings();
    settings.accounts = format_.format().rows_for_basins;
    const ArealRainfall rainfall(session.weighing(), settings,
                                 static_cast<unsigned>(common_.threads));
    RainFile series(file, session.basins(), format_.format());
    Progress progress("time steps", common_.quiet);
    for_each_step(*readings, rainfall, static_cast<unsigned>(common_.threads),
                  [&](const RainStep& step) {
                    series.add(step);
                    progress.advance();
                  });
    outputs.commit();
  }
  bool quiet() const override { return common_.quiet; }

 private:
  StudyOptions study_;
  RainfallOptions rainfall_;
  GapOptions gaps_;
  RainFormatOptions format_;
  OutputOptions output_;
  CommonOptions common_;
};

}  // namespace

std::unique_ptr<Command> make_rain_command() {
  return std::make_unique<RainCommand>();
}

}  // namespace thiessen::cli
