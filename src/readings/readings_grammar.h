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

/// The meaning of a field of rainfall.
struct Reading {
  double amount = std::numeric_limits<double>::quiet_NaN();  ///< NaN unless the kind is an amount
  ReadingKind kind = ReadingKind::missing;
};

/// Tells how the fields of rainfall are read: which texts and numbers mean a gap, and which a trace
/// (0).
///
/// An empty field, NA, N/A, NaN, null, - and the numbers -999, -9999 and -99.9 always mean a gap.
/// Further texts for gaps, and those for traces, come from the user and are looked at first. Blanks
/// round a field do not count. Numbers compare as numbers (-999.0 equals -999), texts without
/// regard to case.
class ReadingGrammar {
 public:
  ReadingGrammar(std::span<const std::string> missing, std::span<const std::string> trace,
                 DecimalMark mark);

  /// Reads a field; see Row for `padded`.
  Reading read(std::string_view field, bool padded) const {
    const Parsed<double> number =
        padded ? parse_padded_number(field, mark_) : parse_number(field, mark_);
    if (number && number.value >= 0 && only_negative_) {
      return {number.value + 0.0, ReadingKind::amount};  // + 0.0 makes -0 plain 0
    }
    return read_special(trimmed(field));
  }

  /// What a text may be meant for that is no number, nor a gap or a trace.
  enum class Meant : std::uint8_t {
    decimal_comma,  ///< a number where decimal commas are read, as they are not
    decimal_point,  ///< the other way round
    thousands,      ///< a number whose thousands are parted: 1,234.5, 1 234
    more,           ///< a number and something else: 0.2E, 4 mm
    code,           ///< a gap or a trace: M, <0.2
  };
  Meant meant_by(std::string_view text) const;

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
  bool only_negative_ = true;  ///< whether every special number is below 0
  std::vector<SpecialText> texts_;
  std::vector<SpecialNumber> numbers_;
};

}  // namespace thiessen
