#include "io/readings_order.h"

#include <algorithm>
#include <cstddef>

namespace thiessen {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
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
  const auto [in_a, in_b] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  auto begin = static_cast<std::size_t>(in_a - a.begin());
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
