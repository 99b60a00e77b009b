#include "readings/times/time_columns.h"

#include <gtest/gtest.h>

#include <string>
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
  EXPECT_EQ(TimeColumns::part_called("date"), Part::text);
}

}  // namespace
}  // namespace thiessen
