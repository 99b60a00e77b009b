#include "cli/outputs/provenance_of.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "base/version.h"
#include "cli/outputs/given_inputs.h"

namespace thiessen::cli {
namespace {

using Items = std::vector<std::pair<std::string, std::string>>;

Items items(GivenFiles files, const GaugeReadings* readings = nullptr) {
  const GivenInputs given(std::move(files));
  Items all = items_of(provenance_of(given.inputs, given.options(), readings, "mm"));
  EXPECT_EQ(all.at(0), (std::pair<std::string, std::string>("software",
                                                            std::string("thiessen ") + version())));
  all.erase(all.begin());
  return all;
}

TEST(ProvenanceOf, a_geodesic_study_has_no_plane) {
  EXPECT_EQ(items(files_in_degrees()),
            (Items{{"metric", "geodesic"}, {"tolerance", "0.1"}, {"method", "thiessen"}}));
}

TEST(ProvenanceOf, a_plane_is_known_by_its_crs_if_it_has_one) {
  EXPECT_EQ(items({}), (Items{{"metric", "planar"}, {"tolerance", "0.1"}, {"method", "thiessen"}}));
  EXPECT_EQ(items(files_in_utm()).at(1),
            (std::pair<std::string, std::string>("plane", "EPSG:32633")));
}

TEST(ProvenanceOf, a_plane_that_was_made_is_known_by_its_definition) {
  GivenFiles files = files_in_utm();
  files.options = {"--plane", "auto", "--crs", "EPSG:32633", "--basins-crs", "EPSG:32633"};
  EXPECT_TRUE(items(files).at(1).second.starts_with("+proj="));
}

TEST(ProvenanceOf, rainfall_has_a_unit_and_says_what_it_is) {
  GivenFiles files;
  files.options.insert(files.options.end(), {"--tolerance", "2.5"});
  const GaugeReadings readings{{1, 2}, "mean over 12 months"};
  EXPECT_EQ(items(files, &readings), (Items{{"metric", "planar"},
                                            {"tolerance", "2.5"},
                                            {"method", "thiessen"},
                                            {"unit", "mm"},
                                            {"rainfall", "mean over 12 months"}}));
}

}  // namespace
}  // namespace thiessen::cli
