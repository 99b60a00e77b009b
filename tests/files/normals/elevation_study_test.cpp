#include "files/normals/elevation_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "files/normals/mountain_study.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// So many years of months in which each gauge has its normal times the month's number.
template <typename Normal>
CalendarNormals series(const MountainStudy& given, int years, const Normal& normal) {
  CalendarNormals gauges(given.study->network().places().size());
  for (int year = 0; year < years; ++year) {
    for (std::size_t month = 0; month < 12; ++month) {
      std::vector<double> readings;
      for (std::size_t s = 0; s < gauges.places(); ++s)
        readings.push_back(static_cast<double>(month + 1) * normal(s, month));
      gauges.add(readings, MonthOfYear{1990 + year, month});
    }
  }
  return gauges;
}

double elevation_of(const MountainStudy& given, std::size_t station) {
  return given.files->station_elevations.at(given.files->stations.empty()
                                                ? given.study->network().stations()[station].id
                                                : given.files->stations[station].id);
}

ElevationRequest request() {
  return {"", true, true, "r.csv", 1};
}

TEST(ElevationStudies, of_a_short_series_are_of_the_year) {
  MountainStudy given;
  const Study& study = given.made();
  const auto gauges = series(given, 9, [&](std::size_t s, std::size_t) {
    return 50 * std::exp(4e-4 * elevation_of(given, s));
  });
  const ElevationStudy found =
      normals_by_elevation(request(), study, *given.files, gauges, given.warnings);
  EXPECT_EQ(found.normals->months(), 1u);
  // Readings are 6.5 times the normal in the mean of the months.
  EXPECT_NEAR(found.normals->in(0).whole(0).mean, 6.5 * 50 * std::exp(0.4), 1e-3);
  EXPECT_NEAR(found.normals->at_gauge(StationIndex{0}, 0),
              6.5 * 50 * std::exp(4e-4 * elevation_of(given, 0)), 1e-6);
  EXPECT_EQ(found.elevations[0], elevation_of(given, 0));
  EXPECT_TRUE(given.warnings.messages().empty());
  ASSERT_EQ(given.notices().size(), 1u);
  EXPECT_TRUE(
      given.notices()[0].starts_with("leaving each gauge out: its normal of the year is told to "
                                     "0.0 % by elevation and the gauges around, to "))
      << given.notices()[0];
}

TEST(ElevationStudies, of_ten_years_are_of_the_calendar_months) {
  MountainStudy given;
  const Study& study = given.made();
  const auto of_months = [&](std::size_t s, std::size_t month) {
    return 50 * std::exp((month < 6 ? 4e-4 : 2e-4) * elevation_of(given, s));
  };
  const CalendarNormals gauges = series(given, 10, of_months);
  const ElevationStudy found =
      normals_by_elevation(request(), study, *given.files, gauges, given.warnings);
  ASSERT_EQ(found.normals->months(), 12u);
  EXPECT_NEAR(found.normals->in(0).whole(2).mean, 3 * 50 * std::exp(0.4), 1e-3);
  EXPECT_NEAR(found.normals->in(0).whole(9).mean, 10 * 50 * std::exp(0.2), 1e-3);
  ElevationRequest of_year = request();
  of_year.may_have_months = false;
  EXPECT_EQ(
      normals_by_elevation(of_year, study, *given.files, gauges, given.warnings).normals->months(),
      1u);
}

TEST(ElevationStudies, take_what_others_tell_of_a_gauge_without_rain) {
  MountainStudy given;
  const Study& study = given.made();
  const auto gauges = series(given, 1, [&](std::size_t s, std::size_t) {
    return s == 3 ? none : s == 7 ? 0 : 50 * std::exp(4e-4 * elevation_of(given, s));
  });
  const ElevationStudy found =
      normals_by_elevation(request(), study, *given.files, gauges, given.warnings);
  const double sevenfold =
      found.normals->at_gauge(StationIndex{0}, 0) / (50 * std::exp(4e-4 * elevation_of(given, 0)));
  for (const std::uint32_t s : {3u, 7u}) {
    EXPECT_NEAR(found.normals->at_gauge(StationIndex{s}, 0),
                sevenfold * 50 * std::exp(4e-4 * elevation_of(given, s)), 1e-2);
  }
}

TEST(ElevationStudies, warn_where_the_gauges_around_tell_as_much_without_elevation) {
  // Rain grows from one corner of the square to the other; elevations are those of other gauges.
  MountainStudy given;
  for (std::size_t i = 0; i < 16; ++i)
    given.files->station_elevations["g" + std::to_string(i)] =
        100 * static_cast<double>((7 * i) % 16);
  const Study& study = given.made();
  const CalendarNormals gauges = series(given, 1, [&](std::size_t s, std::size_t) {
    const Point at = study.network().stations()[s].position;
    return 50 * std::exp(0.1 * (at.x + at.y));
  });
  normals_by_elevation(request(), study, *given.files, gauges, given.warnings);
  ASSERT_EQ(given.warnings.messages().size(), 1u);
  EXPECT_EQ(given.warnings.messages()[0].text.plain(),
            "elevation adds nothing here: the gauges around tell a normal as well without it");
  EXPECT_FALSE(given.warnings.messages()[0].hint.empty());
}

TEST(ElevationStudies, are_refused_where_nothing_can_be_told) {
  const auto fault = [](MountainStudy& given, const auto& normal) {
    const Study& study = given.made();
    const CalendarNormals gauges = series(given, 1, normal);
    const auto faults = MountainStudy::faults_of(
        [&] { normals_by_elevation(request(), study, *given.files, gauges, given.warnings); });
    return faults.empty() ? "" : faults.front();
  };
  MountainStudy few;
  EXPECT_EQ(fault(few, [](std::size_t s, std::size_t) { return s < 9 ? 100 : none; }),
            "9 gauges have rain, and normals are fitted by elevation to ten at least");
  MountainStudy dry;
  EXPECT_EQ(fault(dry, [](std::size_t, std::size_t) { return 0; }),
            "no gauge has rain, and normals are fitted by elevation to ten at least");
  MountainStudy level;
  for (auto& [id, elevation] : level.files->station_elevations) elevation = 250;
  EXPECT_EQ(fault(level, [](std::size_t s, std::size_t) { return 10.0 + static_cast<double>(s); }),
            "all gauges lie at one height, 250, and nothing tells how rain changes with elevation");
  MountainStudy alike;
  EXPECT_EQ(
      fault(alike, [](std::size_t, std::size_t) { return 100; }),
      "elevation does not tell rain here: leaving each gauge out, its normal is told to 0.0 % "
      "by elevation and the gauges around, to 0.0 % by the nearest gauge's (root mean square of ln "
      "N), and a tenth "
      "less is needed");
}

}  // namespace
}  // namespace thiessen
