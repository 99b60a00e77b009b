#include "cli/options/blocks/model_options.h"

#include <stdexcept>

#include "cli/options/blocks/output_options.h"
#include "cli/options/blocks/rain_format_options.h"
#include "cli/options/given_options.h"
#include "cli/options/option_values.h"

namespace thiessen::cli {
namespace {

struct Model : Given<RainModelOptions> {
  Model() {
    block.declare(options);
    table.declare(options);
    output.declare(options, Need::optional, "rain.csv", "");
    output.declare_append(options);
    options.group("Method").add("--error", flag(errors), "");
  }
  std::string refused(std::vector<std::string> words, const std::string& path,
                      std::size_t methods = 1) {
    read(std::move(words));
    return contradiction<const OptionList&, const std::string&, std::size_t>(options, path,
                                                                             methods);
  }
  RainFormatOptions table;
  OutputOptions output;
  bool errors = false;
};

TEST(RainModelOptions, are_a_table_unless_told) {
  Model model;
  EXPECT_EQ(model.refused({}, "-"), "");
  EXPECT_FALSE(model.block.model());
  EXPECT_FALSE(model.block.is_named());
  Model csv;
  EXPECT_EQ(csv.refused({"--format", "csv"}, "-"), "");
  EXPECT_FALSE(csv.block.model());
  EXPECT_TRUE(csv.block.is_named());
}

TEST(RainModelOptions, take_a_format_and_a_unit) {
  Model model;
  EXPECT_EQ(model.refused({"--format", "pi-xml", "--units", "in", "--decimals", "1"}, "-"), "");
  EXPECT_EQ(model.block.model(), RainModel::pi_xml);
  EXPECT_EQ(model.block.units, "in");
  EXPECT_EQ(model.block.name(), "pi-xml");
}

TEST(RainModelOptions, name_a_unit_to_a_database) {
  EXPECT_EQ(Model().refused({"--units", "in"}, "PG:dbname=x"), "");
}

TEST(RainModelOptions, refuse_what_cannot_act) {
  EXPECT_EQ(Model().refused({"--units", "in"}, "-"),
            "--units is about what a model reads, and a CSV names no unit");
  EXPECT_EQ(Model().refused({"--format", "hype", "--long"}, "-"),
            "--long is about the rows of a CSV, and --format hype has its own");
  EXPECT_EQ(Model().refused({"--format", "hype", "--iso-times"}, "-"),
            "--iso-times is about the times of a CSV, and --format hype has its own");
  EXPECT_EQ(Model().refused({"--format", "hype", "--append"}, "-"),
            "--append adds to a CSV, and --format hype is written anew");
  EXPECT_EQ(Model().refused({"--format", "netcdf", "--decimals", "1"}, "-"),
            "--decimals is about values as text, and a NetCDF holds all digits");
  EXPECT_EQ(Model().refused({"--format", "hype", "--error"}, "-"),
            "--error is beside the values, and --format hype has no place for it");
  EXPECT_EQ(Model().refused({"--format", "netcdf"}, "-"),
            "--format netcdf cannot go to the standard output");
  EXPECT_EQ(Model().refused({"--format", "swmm"}, "x", 2),
            "--method says several, and --format swmm holds one series a basin");
  EXPECT_EQ(Model().refused({"--format", "swmm"}, "PG:dbname=x"),
            "--format swmm is a file, and the output is a database");
}

// Such a command would write what the option forbids, for nobody would have looked at it.
TEST(RainModelOptions, are_of_commands_that_have_all_options_that_they_ask_about) {
  Given<RainModelOptions> alone;
  alone.block.declare(alone.options);
  alone.read({"--format", "hype"});
  EXPECT_THROW(alone.block.check(alone.options, "-", 1), std::logic_error);
}

TEST(WeightsModelOptions, are_of_weights_alone) {
  using Other = WeightsModelOptions::OtherTable;
  Given<WeightsModelOptions> model;
  model.block.declare(model.options);
  model.read({"--format", "hms"});
  EXPECT_EQ(model.block.model(), WeightsModel::hms);
  EXPECT_EQ(model.contradiction(Other{}), "");
  EXPECT_EQ(model.contradiction(Other{.is_influence = true}),
            "--influence is a table of its own, and --format hms holds weights");
  EXPECT_EQ(model.contradiction(Other{.is_change = true}),
            "--with and --without compare two networks, and --format hms holds one");
  EXPECT_EQ(model.contradiction(Other{.is_database = true}),
            "--format hms is a file, and the output is a database");
}

}  // namespace
}  // namespace thiessen::cli
