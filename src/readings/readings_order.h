#pragma once

#include <string>
#include <string_view>

namespace thiessen {

/// The order in which the times of a table come. As long as they all ascend, or all descend, either
/// as text or with the numbers in them compared as numbers (9 before 10, 2020-9-1 before
/// 2020-10-1), none can come twice, and nothing but the last is kept.
class TimeOrder {
 public:
  /// Takes the next time. Whether all so far are known to be different; once false, always false.
  bool follows(std::string_view time);
  /// Whether this is the time that came last.
  bool is_last(std::string_view time) const { return any_ && time == last_; }
  bool holds() const { return text_.holds() || numbers_.holds(); }

 private:
  struct Direction {
    bool ascends = true;
    bool descends = true;

    bool holds() const { return ascends || descends; }
    void step(int comparison) {
      ascends = ascends && comparison < 0;
      descends = descends && comparison > 0;
    }
  };

  std::string last_;
  bool any_ = false;
  Direction text_;
  Direction numbers_;
};

/// Below 0 where the text `a` comes before `b` with runs of digits compared as numbers, above 0
/// where after, 0 where they are the same but for leading zeros up to the first of these.
int compare_with_numbers(std::string_view a, std::string_view b);

}  // namespace thiessen
