#include "readings/readings_order.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace thiessen {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// The position at which the texts begin to differ; their common length if one begins with the
/// other.
std::size_t first_difference(std::string_view a, std::string_view b) {
  const std::size_t common = std::min(a.size(), b.size());
  std::size_t at = 0;
  for (std::uint64_t word_a = 0, word_b = 0; at + sizeof word_a <= common; at += sizeof word_a) {
    std::memcpy(&word_a, a.data() + at, sizeof word_a);
    std::memcpy(&word_b, b.data() + at, sizeof word_b);
    if (word_a != word_b) break;
  }
  while (at < common && a[at] == b[at]) ++at;
  return at;
}

std::string_view digits_from(std::string_view text, std::size_t begin) {
  std::size_t end = begin;
  while (end < text.size() && is_digit(text[end])) ++end;
  return text.substr(begin, end - begin);
}

std::string_view without_zeros(std::string_view digits) {
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size()));
}

}  // namespace

int compare_with_numbers(std::string_view a, std::string_view b) {
  std::size_t begin = first_difference(a, b);
  while (begin > 0 && is_digit(a[begin - 1])) --begin;
  const std::string_view digits_a = digits_from(a, begin);
  const std::string_view digits_b = digits_from(b, begin);
  if (digits_a.empty() || digits_b.empty()) return a.compare(b);
  const std::string_view number_a = without_zeros(digits_a);
  const std::string_view number_b = without_zeros(digits_b);
  if (number_a.size() != number_b.size()) return number_a.size() < number_b.size() ? -1 : 1;
  if (digits_a == digits_b) return a.compare(b);
  return number_a.compare(number_b);
}

bool TimeOrder::follows(std::string_view time) {
  if (!holds()) return false;
  if (any_) {
    text_.step(last_.compare(time));
    if (numbers_.holds()) numbers_.step(compare_with_numbers(last_, time));
  }
  any_ = true;
  last_ = time;
  return holds();
}

}  // namespace thiessen
