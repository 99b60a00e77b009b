#include "cli/outputs/dual_files.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/complaints.h"
#include "cli/outputs/given_inputs.h"

namespace thiessen::cli {
namespace {

/// The files of a triangle of gauges, in the plane of UTM's zone 33.
class Triangle {
 public:
  explicit Triangle(const std::vector<std::string>& words) {
    GivenFiles files = files_in_utm();
    files.stations += "C,500000,5502000\n";
    const GivenInputs given(files);
    options_.block.declare(options_.options);
    options_.read(words);
    Outputs outputs({false, {}});
    DualFiles dual(outputs, options_.block, folder.path("in_place.geojson"));
    dual.write(given.inputs, given.options(), nullptr, "", 1, warnings);
    outputs.commit();
  }

  TemporaryFolder folder;
  Warnings warnings;

 private:
  Given<DualOptions> options_;
};

TEST(DualFiles, are_what_is_asked_for) {
  const TemporaryFolder folder;
  const Triangle both(
      {"--delaunay", folder.path("t.geojson"), "--neighbours", folder.path("n.csv")});
  const std::string triangles = folder.read("t.geojson");
  EXPECT_TRUE(contains(triangles, R"({"a":"A","b":"B","c":"C"})")) << triangles;
  EXPECT_TRUE(contains(triangles, R"("metric":"planar")"));
  EXPECT_EQ(folder.read("n.csv"), "station,neighbour,length\nA,B,inf\nA,C,inf\nB,C,inf\n");
  EXPECT_TRUE(both.warnings.messages().empty());
  EXPECT_TRUE(both.warnings.notices().empty());
}

TEST(DualFiles, stand_in_the_place_of_the_cells) {
  const Triangle in_place({"--delaunay"});
  EXPECT_TRUE(contains(in_place.folder.read("in_place.geojson"), R"("c":"C")"));
}

TEST(DualFiles, must_be_files_with_a_known_extension) {
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(complaint_of([&] {
                         Triangle({"--delaunay", folder.path("t.abc")});
                       }),
                       "abc"));
  EXPECT_TRUE(contains(complaint_of([&] {
                         Triangle({"--delaunay", "PG:dbname=x"});
                       }),
                       "a database"));
  EXPECT_TRUE(contains(complaint_of([&] {
                         Triangle({"--neighbours", "PG:dbname=x"});
                       }),
                       "a database"));
}

}  // namespace
}  // namespace thiessen::cli
