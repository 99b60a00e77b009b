#include "base/outputs.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/session.h"
#include "io/weights_file.h"

namespace thiessen::cli {
namespace {

class WeightsCommand : public Command {
 public:
  const char* name() const override { return "weights"; }
  const char* description() const override {
    return "the weights table: each station's share of each basin";
  }
  const char* example() const override {
    return "samples/textbook/stations.csv samples/textbook/basin.csv";
  }
  void set_up(CLI::App& app) override {
    study_.add_to(app, Need::required);
    output_.add_to(app, Need::optional, "weights.csv",
                   "where the table goes; default standard output");
    common_.add_to(app);
  }

  void run(Warnings& warnings) override {
    Outputs outputs(output_.rules({study_.stations, study_.basins}));
    OutputFile& file = outputs.add(output_.output);
    const Session session(study_, 0, warnings);
    const auto weights =
        session.weighing().weights(session.all_report(), static_cast<unsigned>(common_.threads));
    write_weights(file, session.weighing(), weights, session.area_unit());
    outputs.commit();
  }
  bool quiet() const override { return common_.quiet; }

 private:
  StudyOptions study_;
  OutputOptions output_;
  CommonOptions common_;
};

}  // namespace

std::unique_ptr<Command> make_weights_command() {
  return std::make_unique<WeightsCommand>();
}

}  // namespace thiessen::cli
