#include "readings/times/time_columns.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace thiessen {
namespace {

using Part = TimeColumns::Part;

std::string text(const std::vector<Part>& parts, const std::vector<std::string_view>& fields) {
  std::vector<TimeColumns::Column> columns;
  for (std::size_t i = 0; i < parts.size(); ++i) columns.push_back({i, parts[i]});
  return std::string(TimeColumns(columns).text({1, fields, false}));
}

TEST(TimeColumns, have_the_text_of_one_column_as_it_is) {
  EXPECT_EQ(text({Part::text}, {" 1/2/2010 "}), " 1/2/2010 ");
  EXPECT_EQ(text({Part::year}, {"2010"}), "2010");
}

TEST(TimeColumns, put_parts_together_as_iso_8601_has_them) {
  EXPECT_EQ(text({Part::year, Part::month, Part::day}, {"2010", "1", "5"}), "2010-01-05");
  EXPECT_EQ(text({Part::day, Part::month, Part::year}, {"5", "12", "2010"}), "2010-12-05");
  EXPECT_EQ(text({Part::year, Part::month, Part::day, Part::hour}, {"2010", "1", "5", "9"}),
            "2010-01-05 09:00");
  EXPECT_EQ(text({Part::year, Part::month, Part::day, Part::hour, Part::minute},
                 {"2010", "01", "05", "09", "5"}),
            "2010-01-05 09:05");
  EXPECT_EQ(text({Part::year, Part::month, Part::day}, {"", " ", ""}), "");
}

TEST(TimeColumns, know_days_of_the_year_months_by_name_seconds_and_hours_with_their_minutes) {
  EXPECT_EQ(text({Part::year, Part::day_of_year}, {"2010", "60"}), "2010-03-01");
  EXPECT_EQ(text({Part::year, Part::day_of_year}, {"2012", "366"}), "2012-12-31");
  EXPECT_EQ(text({Part::year, Part::day_of_year, Part::hour}, {"2010", "1", "0"}),
            "2010-01-01 00:00");
  EXPECT_EQ(text({Part::year, Part::month}, {"2010", "Feb"}), "2010-02");
  EXPECT_EQ(text({Part::year, Part::month}, {"2010", "2"}), "2010-02");
  EXPECT_EQ(text({Part::year, Part::month, Part::day, Part::hour, Part::minute, Part::second},
                 {"2010", "1", "5", "9", "5", "7.5"}),
            "2010-01-05 09:05:07.5");
  EXPECT_EQ(text({Part::year, Part::month, Part::day, Part::hour}, {"2010", "1", "5", "100"}),
            "2010-01-05 0100");
  for (const auto& [number, clock] : {std::pair("0", "0000"), std::pair("30", "0030"),
                                      std::pair("100", "0100"), std::pair("2400", "2400")})
    EXPECT_EQ(text({Part::text, Part::hour_minute}, {"2010-01-05", number}),
              std::string("2010-01-05 ") + clock);
  EXPECT_EQ(text({Part::year, Part::month, Part::day}, {"2010.0", "1.0", "5.0"}), "2010-01-05")
      << "as tables have it that hold gaps, too";
}

TEST(TimeColumns, have_no_text_of_a_time_where_the_day_of_the_year_is_none_or_another) {
  for (const char* day : {"366", "0", "x", "1.5"})
    EXPECT_EQ(text({Part::year, Part::day_of_year}, {"2010", day}), "2010 day " + std::string(day));
  const std::vector<Part> both = {Part::year, Part::month, Part::day, Part::day_of_year};
  EXPECT_EQ(text(both, {"2010", "3", "1", "60"}), "2010-03-01");
  EXPECT_EQ(text(both, {"2010", "3", "1", "61"}), "2010-03-01 day 61");
  EXPECT_EQ(text({Part::year, Part::day_of_year}, {"", ""}), "");
}

TEST(TimeColumns, put_a_date_and_a_clock_together) {
  EXPECT_EQ(text({Part::text, Part::text}, {"31/12/2010", "06:00"}), "31/12/2010 06:00");
  EXPECT_EQ(text({Part::text, Part::hour}, {"2010-12-31", "6"}), "2010-12-31 06:00");
  EXPECT_EQ(text({Part::text, Part::hour}, {"2010-12-31", "0600"}), "2010-12-31 0600");
}

TEST(TimeColumns, are_called_by_what_they_hold) {
  EXPECT_EQ(TimeColumns::part_called("YEAR"), Part::year);
  EXPECT_EQ(TimeColumns::part_called("Monat"), Part::month);
  EXPECT_EQ(TimeColumns::part_called("dia"), Part::day);
  EXPECT_EQ(TimeColumns::part_called("hora"), Part::hour);
  EXPECT_EQ(TimeColumns::part_called("yy"), Part::year);
  EXPECT_EQ(TimeColumns::part_called("MO"), Part::month);
  EXPECT_EQ(TimeColumns::part_called("DY"), Part::day);
  EXPECT_EQ(TimeColumns::part_called("DOY"), Part::day_of_year);
  EXPECT_EQ(TimeColumns::part_called("date"), Part::text);
}

}  // namespace
}  // namespace thiessen
