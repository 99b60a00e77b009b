#include "cli/options/blocks/study_options.h"

#include <algorithm>

#include "base/complaints.h"
#include "cli/options/given_options.h"

namespace thiessen::cli {
namespace {

struct Study : Given<StudyOptions> {
  explicit Study(Need basins = Need::optional) { block.declare(options, basins); }
};

TEST(StudyOptions, are_stations_and_basins_which_may_be_required) {
  EXPECT_EQ(Study().refusal({}), "STATIONS is missing");
  EXPECT_EQ(Study(Need::required).refusal({"s"}), "BASINS is missing");
  Study both;
  both.read({"s.csv", "b.json"});
  EXPECT_EQ(both.block.stations, "s.csv");
  EXPECT_EQ(both.block.basins, "b.json");
}

TEST(StudyOptions, ask_for_a_study_of_stations_alone_where_there_are_no_basins) {
  Study given;
  given.read({"s.csv"});
  const StudyRequest request = given.block.request();
  EXPECT_EQ(request.stations.source.file, "s.csv");
  EXPECT_FALSE(request.basins);
  EXPECT_FALSE(request.metric);
  EXPECT_EQ(request.plane, "");
  EXPECT_EQ(request.tolerance, 0.1);
  EXPECT_EQ(request.stations.source.csv.separator, '\0');
}

TEST(StudyOptions, tell_stations_and_basins_apart) {
  Study given;
  given.read({"s.csv",
              "b.json",
              "--id",
              "I",
              "--x",
              "X",
              "--y",
              "Y",
              "--basin-id",
              "B",
              "--crs",
              "EPSG:1",
              "--basins-crs",
              "EPSG:2",
              "--stations-layer",
              "SL",
              "--basins-layer",
              "BL",
              "--stations-where",
              "SW",
              "--basins-where",
              "BW"});
  const StudyRequest request = given.block.request();
  EXPECT_EQ(request.stations.id, "I");
  EXPECT_EQ(request.stations.x, "X");
  EXPECT_EQ(request.stations.y, "Y");
  EXPECT_EQ(request.stations.source.crs, "EPSG:1");
  EXPECT_EQ(request.stations.source.layer, "SL");
  EXPECT_EQ(request.stations.source.where, "SW");
  EXPECT_EQ(request.basins->id, "B");
  EXPECT_EQ(request.basins->source.file, "b.json");
  EXPECT_EQ(request.basins->source.crs, "EPSG:2");
  EXPECT_EQ(request.basins->source.layer, "BL");
  EXPECT_EQ(request.basins->source.where, "BW");
}

TEST(StudyOptions, messages_call_each_setting_by_the_option_that_makes_it) {
  Study given;
  given.read({"s.csv", "b.json"});
  const StudyRequest request = given.block.request();
  const Source* sources[] = {&request.stations.source, &request.basins->source};
  for (const Source* source : sources) {
    for (std::string name : {source->crs_setting, source->layer_setting, source->where_setting}) {
      std::replace(name.begin(), name.end(), '_', '-');
      EXPECT_NE(given.options.find("--" + name), nullptr) << name;
    }
  }
  EXPECT_NE(sources[0]->crs_setting, sources[1]->crs_setting);
  EXPECT_NE(sources[0]->layer_setting, sources[1]->layer_setting);
  EXPECT_NE(sources[0]->where_setting, sources[1]->where_setting);
}

TEST(StudyOptions, how_numbers_and_fields_are_written_holds_for_both_files) {
  Study given;
  given.read({"s.csv", "b.csv", "--separator", ";", "--decimal-comma"});
  const StudyRequest request = given.block.request();
  for (const Source& source : {request.stations.source, request.basins->source}) {
    EXPECT_EQ(source.csv.separator, ';');
    EXPECT_TRUE(source.csv.decimal_comma);
  }
  EXPECT_EQ(given.block.csv().separator, ';');
}

TEST(StudyOptions, say_how_one_file_is_written_before_what_they_say_of_all) {
  Study given;
  given.read({"s.csv", "b.csv", "--separator", "tab", "--basins-separator", "blank", "--encoding",
              "cp932", "--stations-encoding", "Latin-1", "--stations-skip", "3",
              "--basins-decimal-comma"});
  const StudyRequest request = given.block.request();
  const CsvDialect& stations = request.stations.source.csv;
  const CsvDialect& basins = request.basins->source.csv;
  EXPECT_EQ(stations.separator, '\t');
  EXPECT_EQ(basins.separator, ' ');
  EXPECT_EQ(stations.encoding, "Latin-1");
  EXPECT_EQ(basins.encoding, "cp932");
  EXPECT_EQ(stations.skip, 3U);
  EXPECT_EQ(basins.skip, std::nullopt);
  EXPECT_FALSE(stations.decimal_comma);
  EXPECT_TRUE(basins.decimal_comma);
}

TEST(StudyOptions, choose_the_metric_and_the_tolerance) {
  Study planar;
  planar.read({"s", "--metric", "planar", "--tolerance", "0.001"});
  EXPECT_EQ(planar.block.request().metric, Metric::planar);
  EXPECT_EQ(planar.block.request().tolerance, 0.001);
  Study geodesic;
  geodesic.read({"s", "--metric", "geodesic"});
  EXPECT_EQ(geodesic.block.request().metric, Metric::geodesic);
  EXPECT_EQ(Study().refusal({"s", "--tolerance", "0.0009"}),
            "--tolerance wants metres from 0.001 to 1e6, not '0.0009'");
}

TEST(StudyOptions, refuse_a_plane_that_is_geodesic) {
  Study both;
  both.read({"s", "--plane", "EPSG:3035", "--metric", "geodesic"});
  EXPECT_EQ(both.contradiction(), "--plane is planar, and --metric says geodesic");
  Study fine;
  fine.read({"s", "--plane", "EPSG:3035", "--metric", "planar"});
  EXPECT_EQ(fine.contradiction(), "");
  EXPECT_EQ(fine.block.request().plane, "EPSG:3035");
}

TEST(StudyOptions, are_about_basins_where_there_are_any) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"--basin-id", "B"},
                                                {"--basins-crs", "EPSG:1"},
                                                {"--basins-layer", "L"},
                                                {"--basins-where", "W"},
                                                {"--mend"}}) {
    std::vector<std::string> line = {"s"};
    line.insert(line.end(), words.begin(), words.end());
    Study without;
    without.read(line);
    EXPECT_TRUE(without.contradiction().starts_with(words[0] + " ")) << words[0];
    line.insert(line.begin() + 1, "b");
    Study given;
    given.read(line);
    EXPECT_EQ(given.contradiction(), "") << words[0];
  }
}

TEST(StudyOptions, the_name_of_a_crs_is_not_empty) {
  for (const char* option : {"--crs", "--basins-crs", "--plane"}) {
    Study given;
    given.read({"s", option, ""});
    EXPECT_EQ(complaint_of([&] { given.block.request(); }),
              std::string(option) + " is empty | give a CRS such as EPSG:32633");
  }
}

TEST(StudyOptions, attributes_are_read_where_the_command_has_the_option) {
  Study given;
  given.block.declare_attributes(given.options);
  given.read({"s", "--attributes"});
  EXPECT_TRUE(given.block.request().stations.attributes);
  EXPECT_EQ(Study().refusal({"s", "--attributes"}), "unknown option '--attributes'");
}

}  // namespace
}  // namespace thiessen::cli
