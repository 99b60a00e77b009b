#include "results/models/swat_series.h"

#include <fcntl.h>

#include <deque>

#include "base/temporary_folder.h"
#include "results/models/model_subject.h"

namespace thiessen {
namespace {

ModelSubject places_of(std::vector<std::string> basins) {
  ModelSubject subject = subject_of(std::move(basins));
  for (std::size_t i = 0; i < subject.basins.size(); ++i)
    subject.centroids.push_back({10.5 + static_cast<double>(i), -50.25});
  return subject;
}

/// A folder of files as the series opens them.
class Folder {
 public:
  SwatSeries::OpenFile opener() {
    return [this](const std::string& name) -> OutputFile& {
      return files_.emplace_back(
          name, open_descriptor(folder_.path(name), O_WRONLY | O_CREAT | O_EXCL, 0600),
          OutputFile::Care::closed);
    };
  }
  std::string read(const std::string& name) const { return folder_.read(name); }

 private:
  TemporaryFolder folder_;
  std::deque<OutputFile> files_;
};

std::string fault(const ModelSubject& subject, const std::vector<GivenStep>& steps) {
  return complaint_of([&] {
    Folder folder;
    Warnings untold;
    SwatSeries series(folder.opener(), subject);
    add_all(series, steps);
    series.finish(untold);
  });
}

TEST(SwatSeries, has_a_file_a_basin_and_a_list_in_rising_order) {
  Folder folder;
  Warnings told;
  SwatSeries series(folder.opener(), places_of({"west", "east"}));
  add_all(series, {{"2019-12-30", {1, none}}, {"2020-01-01", {3, 4}}, {"2020-01-02", {5, 6}}});
  series.finish(told);
  EXPECT_EQ(folder.read("pcp.cli"),
            "pcp.cli: written by thiessen 9; tolerance: 0.1\nfilename\neast.pcp\nwest.pcp\n");
  EXPECT_EQ(folder.read("west.pcp"),
            "west.pcp: written by thiessen 9; tolerance: 0.1\nnbyr tstep lat lon elev\n"
            "2 0 -50.250000 10.500000 0.0\n"
            "2019 364 1.000\n2019 365 -99.0\n2020 1 3.000\n2020 2 5.000\n");
  EXPECT_EQ(folder.read("east.pcp"),
            "east.pcp: written by thiessen 9; tolerance: 0.1\nnbyr tstep lat lon elev\n"
            "2 0 -50.250000 11.500000 0.0\n"
            "2019 364 -99.0\n2019 365 -99.0\n2020 1 4.000\n2020 2 6.000\n");
  EXPECT_EQ(sentences_of(told),
            (std::vector<std::string>{
                "r.csv: 1 step lacks between others, at 2019-12-31: -99.0 stands there"}));
}

TEST(SwatSeries, knows_its_files_beforehand) {
  EXPECT_EQ(SwatSeries::files({"b", "a"}), (std::vector<std::string>{"pcp.cli", "b.pcp", "a.pcp"}));
}

TEST(SwatSeries, is_of_days_alone) {
  EXPECT_EQ(fault(places_of({"a"}), {{"2020-01-01T00:00", {1}}, {"2020-01-01T01:00", {1}}}),
            "r.csv: its steps are of 1 hour, and a .pcp of SWAT+ is written of days alone | every "
            "= day sums them by day");
}

TEST(SwatSeries, refuses_ids_that_are_no_names_of_files) {
  const auto complaints = complaints_of([] {
    SwatSeries({}, places_of({"a b", "a/b", std::string(47, 'x'), std::string(46, 'x'), "East",
                              "east", "na\xC3\xAFve", ".."}));
  });
  ASSERT_EQ(complaints.size(), 6);
  EXPECT_TRUE(contains(complaints[0], "'a b' cannot be the name of a file of SWAT+"));
  EXPECT_TRUE(contains(complaints[3], "'East' and 'east' are one file"));
}

TEST(SwatSeries, wants_to_know_where_the_basins_are) {
  EXPECT_TRUE(contains(complaint_of([] { SwatSeries({}, subject_of({"a"})); }),
                       "nothing tells where these basins are on the Earth | 'crs' names"));
}

}  // namespace
}  // namespace thiessen
