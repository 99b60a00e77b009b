#include "text/similar_texts.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

std::vector<std::string> similar(const std::string& wanted, const std::vector<std::string>& texts) {
  SimilarTexts similar(wanted);
  for (const std::string& text : texts) similar.offer(text);
  return similar.found();
}

TEST(TextDistance, CountsInsertionsDeletionsAndChanges) {
  EXPECT_EQ(text_distance("", ""), 0u);
  EXPECT_EQ(text_distance("", "abc"), 3u);
  EXPECT_EQ(text_distance("kitten", "sitting"), 3u);  // Levenshtein's own pair of the textbooks
}

TEST(TextDistance, CountsAnExchangeOfNeighboursOnce) {
  EXPECT_EQ(text_distance("ab", "ba"), 1u);
  EXPECT_EQ(text_distance("wieghts", "weights"), 1u);
  EXPECT_EQ(text_distance("ca", "abc"), 3u);  // 2 where what was exchanged may be changed again
}

TEST(TextDistance, law_1_DoesNotDependOnTheOrderOfTheTwo) {
  EXPECT_EQ(text_distance("station", "stat"), text_distance("stat", "station"));
  EXPECT_EQ(text_distance("metrik", "metric"), text_distance("metric", "metrik"));
}

TEST(SimilarTexts, FindsThoseOfFewestChanges) {
  EXPECT_EQ(similar("statoin", {"stations", "station", "ration"}),
            std::vector<std::string>{"station"});
}

TEST(SimilarTexts, TakesOneChangeForEachThreeCharacters) {
  EXPECT_EQ(similar("ab", {"ax"}), std::vector<std::string>{"ax"});
  EXPECT_TRUE(similar("a", {"b"}).empty());
  EXPECT_TRUE(similar("abcd", {"abxy"}).empty());
  EXPECT_EQ(similar("abcde", {"abcxy"}), std::vector<std::string>{"abcxy"});
}

TEST(SimilarTexts, FindsThreeAtMostInTheirOrder) {
  const std::vector<std::string> three{"A-04", "A-01", "A-03"};
  EXPECT_EQ(similar("A-0", {"A-04", "A-01", "A-03", "A-02"}), three);
}

TEST(SimilarTexts, PassesOverCaseAndBlanks) {
  EXPECT_EQ(similar(" BOULDER ", {"boulder"}), std::vector<std::string>{"boulder"});
  EXPECT_EQ(similar("ab", {"    ab    "}), std::vector<std::string>{"    ab    "});
}

TEST(SimilarTexts, FindsNothingLikeALongText) {
  const std::string longest(64, 'x');
  EXPECT_EQ(similar(longest, {longest}), std::vector<std::string>{longest});
  EXPECT_TRUE(similar(longest + "x", {longest + "x"}).empty());
}

TEST(DidYouMean, AsksInOneSentence) {
  EXPECT_EQ(did_you_mean({}), "");
  EXPECT_EQ(did_you_mean({"a"}), "did you mean 'a'?");
  EXPECT_EQ(did_you_mean({"a", "b", "c"}), "did you mean 'a' or 'b' or 'c'?");
}

}  // namespace
}  // namespace thiessen
