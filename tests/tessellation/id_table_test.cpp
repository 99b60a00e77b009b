#include "tessellation/id_table.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace thiessen {
namespace {

TEST(IdTable, finds_what_was_inserted_until_it_is_cleared) {
  IdTable<2> table;
  EXPECT_EQ(table.find({1, 2}), nullptr);
  const auto [value, is_new] = table.insert({1, 2}, 30);
  EXPECT_TRUE(is_new);
  EXPECT_EQ(*value, 30u);
  const auto [again, is_new_again] = table.insert({1, 2}, 40);
  EXPECT_FALSE(is_new_again);
  EXPECT_EQ(*again, 30u);
  *again = 50;
  EXPECT_EQ(*table.find({1, 2}), 50u);
  EXPECT_EQ(table.find({2, 1}), nullptr);
  EXPECT_EQ(table.size(), 1u);
  table.clear();
  EXPECT_EQ(table.size(), 0u);
  EXPECT_EQ(table.find({1, 2}), nullptr);
}

TEST(IdTable, holds_any_number_of_keys_again_and_again) {
  IdTable<1> table;
  for (int round = 0; round < 5; ++round) {
    for (std::uint32_t i = 0; i < 10000; ++i) EXPECT_TRUE(table.insert({i * 64}, i).second);
    EXPECT_EQ(table.size(), 10000u);
    for (std::uint32_t i = 0; i < 10000; ++i) ASSERT_EQ(*table.find({i * 64}), i);
    EXPECT_EQ(table.find({1}), nullptr);
    table.clear();
  }
}

}  // namespace
}  // namespace thiessen
