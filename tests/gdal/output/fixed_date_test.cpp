#include "gdal/output/fixed_date.h"

#include <cpl_conv.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <string>
#include <thread>

#include "base/program_output.h"
#include "base/temporary_folder.h"
#include "gdal/drivers.h"

namespace thiessen {
namespace {

/// The date that GDAL would write on this thread; empty where it is that of the day.
std::string date() {
  return CPLGetConfigOption("OGR_CURRENT_DATE", "");
}

TEST(FixedDate, holds_for_as_long_as_it_lives_and_on_its_thread) {
  EXPECT_EQ(date(), "");
  {
    const FixedDate fixed;
    EXPECT_EQ(date(), "1970-01-01T00:00:00.000Z");
    std::string elsewhere = "?";
    std::thread([&] { elsewhere = date(); }).join();
    EXPECT_EQ(elsewhere, "");
  }
  EXPECT_EQ(date(), "");
}

TEST(FixedDate, is_what_a_geopackage_says_of_its_last_change) {
  start_gdal();
  const TemporaryFolder folder;
  const auto last_change = [&](const std::string& name) {
    const std::string file = folder.path(name);
    GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    std::unique_ptr<GDALDataset> dataset(
        driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    dataset->CreateLayer("points", nullptr, wkbPoint, nullptr);
    dataset.reset();
    return program_output("sqlite3 '" + file + "' 'SELECT last_change FROM gpkg_contents'");
  };
  {
    const FixedDate fixed;
    EXPECT_EQ(last_change("a.gpkg"), "1970-01-01T00:00:00.000Z\n");
  }
  EXPECT_GT(last_change("b.gpkg"), "2020");
}

}  // namespace
}  // namespace thiessen
