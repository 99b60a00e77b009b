#include "cli/options/blocks/rainfall_options.h"

#include "cli/options/given_options.h"

namespace thiessen::cli {
namespace {

struct Rainfall : Given<RainfallOptions> {
  std::string stations = "s.csv";
  explicit Rainfall(Need need = Need::optional) { block.declare(options, need, stations); }
};

TEST(RainfallOptions, are_an_argument_that_may_be_required) {
  EXPECT_EQ(Rainfall(Need::required).refusal({}), "RAINFALL is missing");
  Rainfall given;
  given.read({"r.csv"});
  EXPECT_TRUE(given.block.given());
  EXPECT_EQ(given.block.name(), "r.csv");
  Rainfall none;
  none.read({});
  EXPECT_FALSE(none.block.given());
}

TEST(RainfallOptions, call_the_standard_input_by_its_name) {
  Rainfall given;
  given.read({"-"});
  EXPECT_TRUE(given.block.is_standard_input());
  EXPECT_EQ(given.block.name(), "standard input");
}

TEST(RainfallOptions, may_be_several_files_in_place_of_the_argument) {
  Rainfall given(Need::required);
  given.read({"--rainfall", "2019.csv", "--rainfall", "2020.csv"});
  EXPECT_EQ(given.block.files(), (std::vector<std::string>{"2019.csv", "2020.csv"}));
  EXPECT_EQ(given.block.files_beside({"s.csv"}),
            (std::vector<std::string>{"s.csv", "2019.csv", "2020.csv"}));
  EXPECT_EQ(given.block.name(), "2019.csv and 1 more file");
  Rainfall both;
  both.read({"r.csv", "--rainfall", "2020.csv"});
  EXPECT_EQ(both.contradiction(), "--rainfall stands in place of RAINFALL, and both are given");
  Rainfall piped;
  piped.read({"--rainfall", "-", "--rainfall", "2020.csv"});
  EXPECT_EQ(piped.contradiction(), "--rainfall - is standard input, which stands alone");
}

TEST(RainfallOptions, say_which_layer_and_rows_are_meant) {
  Rainfall given;
  given.read({"r.xlsx", "--rainfall-layer", "rain", "--rainfall-where", "ELEMENT='PRCP'"});
  const RainfallRequest request = given.block.request({});
  EXPECT_EQ(request.said.layer, "rain");
  EXPECT_EQ(request.said.where, "ELEMENT='PRCP'");
  EXPECT_EQ(request.said.where_setting, "rainfall_where");
}

TEST(RainfallOptions, may_be_an_option_under_another_heading) {
  Given<RainfallOptions> influence;
  influence.block.declare_as_option(influence.options, "What if", "--influence", "help");
  influence.read({"--influence", "r.csv", "--trace", "T"});
  EXPECT_EQ(influence.block.files(), std::vector<std::string>{"r.csv"});
  EXPECT_EQ(influence.options.find("--influence")->group, "What if");
  EXPECT_EQ(influence.options.find("--influence")->value.completion, Completion::file);
  EXPECT_TRUE(influence.options.arguments().empty());
}

TEST(RainfallOptions, may_name_a_field_of_the_stations_in_place_of_a_file) {
  Rainfall event(Need::required);
  event.read({"--value-field", "rain"});
  EXPECT_TRUE(event.block.given());
  EXPECT_TRUE(event.block.is_event());
  EXPECT_EQ(event.block.name(), "s.csv");
  Rainfall table;
  table.read({"r.csv", "--value-field", "rain"});
  EXPECT_FALSE(table.block.is_event());
}

TEST(RainfallOptions, of_tables_have_no_use_beside_an_event) {
  Rainfall event;
  event.read({"--value-field", "rain", "--cumulative"});
  EXPECT_EQ(event.contradiction(),
            "--cumulative is about RAINFALL, and with --value-field alone the readings stand in "
            "STATIONS");
}

TEST(RainfallOptions, multiply_or_convert) {
  Rainfall scaled;
  scaled.read({"r.csv", "--scale", "0.1"});
  EXPECT_EQ(scaled.block.readings({}).scale, 0.1);
  Rainfall converted;
  converted.read({"r.csv", "--from-unit", "0.01in", "--to-unit", "in"});
  EXPECT_FALSE(converted.block.readings({}).scale);
  EXPECT_EQ(converted.block.readings({}).from_unit->name(), "0.01in");
  EXPECT_EQ(converted.block.readings({}).to_unit->name(), "in");
  Rainfall both;
  both.read({"r.csv", "--scale", "2", "--to-unit", "in"});
  EXPECT_EQ(both.contradiction(),
            "--scale multiplies whatever the unit is, and --to-unit names one");
  EXPECT_EQ(Rainfall().refusal({"r.csv", "--scale", "0"}),
            "--scale wants a number above 0, to 1e9, not '0'");
}

TEST(RainfallOptions, say_how_readings_are_read) {
  Rainfall given;
  given.read({"r.csv", "--missing", "M", "--missing", "-77", "--trace", "T", "--time-field", "When",
              "--station-field", "Where", "--value-field", "What", "--ignore-unknown",
              "--keep-flagged"});
  CsvDialect all;
  all.decimal_comma = true;
  const ReadingsOptions readings = given.block.readings(all);
  EXPECT_EQ(readings.missing, (std::vector<std::string>{"M", "-77"}));
  EXPECT_EQ(readings.trace, std::vector<std::string>{"T"});
  EXPECT_EQ(readings.time_fields, std::vector<std::string>{"When"});
  EXPECT_EQ(readings.station_field, "Where");
  EXPECT_EQ(readings.value_field, "What");
  EXPECT_TRUE(readings.ignore_unknown);
  EXPECT_TRUE(readings.keep_flagged);
  EXPECT_TRUE(readings.decimal_comma);
}

TEST(RainfallOptions, say_how_their_file_is_written_before_what_is_said_of_all) {
  Rainfall given;
  given.read({"r.csv", "--rainfall-separator", ";", "--rainfall-encoding", "Latin-1"});
  CsvDialect all;
  all.separator = ',';
  all.skip = 2;
  EXPECT_EQ(given.block.csv(all).separator, ';');
  EXPECT_EQ(given.block.csv(all).encoding, "Latin-1");
  EXPECT_EQ(given.block.csv(all).skip, 2U);
}

TEST(RainfallOptions, say_how_times_are_written) {
  Rainfall given;
  given.read({"r.csv", "--time-field", "2", "--time-field", "1", "--time-format", "%d/%m/%Y",
              "--value-field", "4"});
  const ReadingsOptions readings = given.block.readings({});
  EXPECT_EQ(readings.time_fields, (std::vector<std::string>{"2", "1"}));
  EXPECT_EQ(readings.time_format, "%d/%m/%Y");
  EXPECT_EQ(given.block.csv({}).numbers, (std::vector<std::string>{"2", "1", "4"}));
  Rainfall named;
  named.read({"r.csv", "--time-field", "2", "--value-field", "rain"});
  EXPECT_TRUE(named.block.csv({}).numbers.empty()) << "not all are numbers";
}

TEST(RainfallOptions, are_about_readings_that_are_given) {
  Rainfall none;
  none.read({"--trace", "T"});
  EXPECT_EQ(none.contradiction(), "--trace is about readings, and there is no RAINFALL");
  Rainfall given;
  given.read({"r.csv", "--trace", "T"});
  EXPECT_EQ(given.contradiction(), "");
  EXPECT_EQ(Rainfall().contradiction(), "");
}

TEST(RainfallOptions, are_the_readers_own_unless_told) {
  Rainfall given;
  given.read({"r.csv"});
  const ReadingsOptions readings = given.block.readings({});
  EXPECT_TRUE(readings.missing.empty() && readings.trace.empty());
  EXPECT_TRUE(readings.time_fields.empty() && readings.station_field.empty());
  EXPECT_FALSE(readings.ignore_unknown || readings.keep_flagged || readings.decimal_comma);
}

}  // namespace
}  // namespace thiessen::cli
