// What normals fitted by elevation are worth on real rain: each gauge of the sample is left out in
// turn, and its readings are told by the nearest other gauge.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "files/normals/elevation_study.h"
#include "files/rainfall/rainfall_file.h"
#include "files/study_files.h"
#include "rainfall/network/mean_reading.h"
#include "rainfall/series/step_months.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The sample's gauges and steps, and the normals that are fitted to them.
class ColoradoNormals : public testing::Test {
 protected:
  struct Step {
    std::vector<double> readings;
    NormalMonth month;
  };

  static void SetUpTestSuite() {
    const std::string samples = THIESSEN_SAMPLES;
    Warnings warnings;
    StudyRequest request;
    request.stations.source.file = samples + "/colorado/stations.csv";
    request.stations.elevation_field = "";
    files = std::make_shared<StudyFiles>(read_study(request, warnings));
    const std::string rainfall = samples + "/colorado/rainfall.csv";
    files->basins_file = "extent";
    files->basin_elevations["extent"] = 2000;
    study = std::make_unique<Study>(files, StudySettings{.margin = 0}, warnings);
    const Network& network = study->network();
    CalendarNormals gauges(network.places().size());
    const auto readings = open_rainfall({{rainfall}, {}}, network.stations(), {}, {}, warnings);
    for (TimeStep step; readings->next(step);) {
      const std::size_t month = *month_of(step.time, step.written, Stamp::begin);
      gauges.add(readings_by_place(network, step.readings),
                 MonthOfYear{calendar_time(step.time, step.written).time.year, month});
      steps.push_back({{step.readings.begin(), step.readings.end()}, month});
    }
    files->basin_elevations = {{study->basins().front().id, 2000}};
    for (const bool by_months : {false, true}) {
      const ElevationRequest fitting{"", true, by_months, rainfall, 2};
      (by_months ? of_months : of_year) =
          normals_by_elevation(fitting, *study, *files, gauges, warnings);
    }
  }
  static void TearDownTestSuite() {
    of_months = of_year = {};
    study.reset();
    files.reset();
    steps.clear();
  }

  /// The errors of the gauges from one elevation to another.
  static LeftOutReadings::Errors errors(const ElevationStudy& fitted, double low, double high) {
    std::vector<double> elevations = fitted.elevations;
    for (double& z : elevations) z = z >= low && z < high ? z : none;
    LeftOutReadings readings(study->network(), Metric::geodesic, fitted.normals.get(),
                             ElevationBands(elevations));
    const bool has_months = fitted.normals->months() > 1;
    for (const Step& step : steps)
      readings.add(step.readings, has_months ? step.month : NormalMonth());
    LeftOutReadings::Errors sum;
    for (std::size_t band = 0; band < readings.bands().size(); ++band) {
      const LeftOutReadings::Errors& of_band = readings.in_band(band);
      for (const auto member :
           {&LeftOutReadings::Errors::plain, &LeftOutReadings::Errors::with_normals}) {
        (sum.*member).count += (of_band.*member).count;
        (sum.*member).errors += (of_band.*member).errors;
        (sum.*member).squares += (of_band.*member).squares;
      }
    }
    return sum;
  }
  static double kept(const LeftOutReadings::Errors& errors) {
    return errors.with_normals.root_mean_square() / errors.plain.root_mean_square();
  }

  inline static std::shared_ptr<StudyFiles> files;
  inline static std::unique_ptr<Study> study;
  inline static std::vector<Step> steps;
  inline static ElevationStudy of_year;
  inline static ElevationStudy of_months;
};

constexpr double lowest = -1000;
constexpr double highest = 9000;

TEST_F(ColoradoNormals, lessen_the_nearest_gauges_error) {
  for (const ElevationStudy* fitted : {&of_year, &of_months}) {
    const auto all = errors(*fitted, lowest, highest);
    EXPECT_NEAR(all.plain.root_mean_square(), 28.9, 0.1) << "the figure of the prototype";
    EXPECT_LT(kept(all), 0.85);
    EXPECT_LT(kept(errors(*fitted, 2400, highest)), 0.88);
    EXPECT_LT(kept(errors(*fitted, lowest, 1800)), 1);
    EXPECT_LT(std::abs(errors(*fitted, 2400, highest).with_normals.bias()), 2.5);
  }
}

TEST_F(ColoradoNormals, of_calendar_months_are_worth_more) {
  EXPECT_EQ(of_year.normals->months(), 1u);
  ASSERT_EQ(of_months.normals->months(), 12u);
  EXPECT_LT(kept(errors(of_months, lowest, highest)), kept(errors(of_year, lowest, highest)));
}

}  // namespace
}  // namespace thiessen
