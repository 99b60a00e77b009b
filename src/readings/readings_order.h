#pragma once

#include <string>
#include <string_view>

namespace thiessen {

/// Watches the order in which the times of a table come. As long as they all ascend, or all
/// descend, no time can come twice, and nothing but the last one need be kept. Times are compared
/// as text, and also with the numbers in them as numbers (9 before 10, 2020-9-1 before 2020-10-1);
/// one of the two has to hold.
class TimeOrder {
 public:
  /// Takes the next time, and tells whether all times so far are known to be different. Once this
  /// is false it stays false.
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

/// Compares two texts with runs of digits taken as numbers. Gives less than 0 if `a` comes before
/// `b`, and more than 0 if after. Gives 0 if they are equal, and also if the runs of digits in
/// which they first differ are the same number (9 and 09): what follows these is not compared.
int compare_with_numbers(std::string_view a, std::string_view b);

}  // namespace thiessen
