#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {

enum class ReadingKind : std::uint8_t { amount, missing, negative, not_a_number, out_of_range };

/// What a field of rainfall says.
struct Reading {
  double amount = std::numeric_limits<double>::quiet_NaN();  ///< NaN but for an amount
  ReadingKind kind = ReadingKind::missing;
};

/// How the fields of rainfall are read: which texts and numbers mean a gap, which a trace (0).
///
/// A gap always: an empty field, NA, N/A, NaN, null, -, and the numbers -999, -9999, -99.9; further
/// ones, and the traces, come from the user and go before these. Blanks round a field do not count;
/// numbers compare as numbers (-999.0 is -999), texts without case.
class ReadingGrammar {
 public:
  ReadingGrammar(std::span<const std::string> missing, std::span<const std::string> trace,
                 DecimalMark mark);

  /// `padded`: see Row.
  Reading read(std::string_view field, bool padded) const {
    const Parsed<double> number =
        padded ? parse_padded_number(field, mark_) : parse_number(field, mark_);
    if (number && number.value >= 0 && only_negative_) {
      return {number.value + 0.0, ReadingKind::amount};  // + 0.0 makes -0 plain 0
    }
    return read_special(trimmed(field));
  }

  /// Whether the text would be a number with a decimal comma, and is none as things are.
  bool wants_decimal_comma(std::string_view text) const;

 private:
  struct SpecialText {
    std::string text;
    Reading meaning;
  };
  struct SpecialNumber {
    double number = 0;
    Reading meaning;
  };

  void add(std::string_view text, Reading meaning);
  Reading read_special(std::string_view text) const;

  DecimalMark mark_;
  bool only_negative_ = true;  ///< every special number is below 0
  std::vector<SpecialText> texts_;
  std::vector<SpecialNumber> numbers_;
};

}  // namespace thiessen
