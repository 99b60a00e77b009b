#include <algorithm>
#include <cstdint>

#include "map/ink/unicode.h"

namespace thiessen {
namespace {

constexpr std::u32string_view joining = U".,:/-";

enum class Class : std::uint8_t { left, right, number, neutral };

bool is_arabic_digit(char32_t c) {
  return (c >= 0x0660 && c <= 0x0669) || (c >= 0x06F0 && c <= 0x06F9);
}

bool is_number(char32_t c) {
  return (c >= U'0' && c <= U'9') || is_arabic_digit(c);
}

bool is_right_to_left(char32_t c) {
  return (c >= 0x0590 && c <= 0x08FF) || (c >= 0xFB1D && c <= 0xFDFF) ||
         (c >= 0xFE70 && c <= 0xFEFC) || (c >= 0x10800 && c <= 0x10FFF) ||
         (c >= 0x1E800 && c <= 0x1EFFF);
}

bool is_neutral(char32_t c) {
  const bool ascii_letter = (c >= U'A' && c <= U'Z') || (c >= U'a' && c <= U'z');
  return (c < 0x80 && !ascii_letter) || (c >= 0xA0 && c <= 0xBF && c != 0xAA && c != 0xBA) ||
         (c >= 0x2000 && c <= 0x2BFF) || (c >= 0x3000 && c <= 0x3004) ||
         (c >= 0x3008 && c <= 0x3020);
}

std::vector<Class> classes(std::u32string_view text) {
  std::vector<Class> result;
  for (const char32_t c : text) {
    if (is_attached(c) && !result.empty()) {
      result.push_back(result.back());
    } else if (is_number(c)) {
      result.push_back(Class::number);
    } else if (is_right_to_left(c)) {
      result.push_back(Class::right);
    } else {
      result.push_back(is_neutral(c) ? Class::neutral : Class::left);
    }
  }
  // A sign between two digits belongs to the number: 12.5, 1/2, 12:30.
  for (std::size_t i = 1; i + 1 < result.size(); ++i) {
    const bool joins = joining.find(text[i]) != std::u32string_view::npos;
    if (joins && is_number(text[i - 1]) && is_number(text[i + 1])) result[i] = Class::number;
  }
  return result;
}

/// Makes numbers after left-to-right text a part of it, and gives neutral characters the direction
/// of their neighbours.
void resolve(std::vector<Class>& line, Class base) {
  Class strong = base;
  for (Class& c : line) {
    if (c == Class::left || c == Class::right) strong = c;
    if (c == Class::number && strong == Class::left) c = Class::left;
  }
  const auto side = [](Class c) { return c == Class::number ? Class::right : c; };
  for (std::size_t i = 0; i < line.size();) {
    std::size_t end = i;
    while (end < line.size() && line[end] == Class::neutral) ++end;
    if (end == i) {
      ++i;
      continue;
    }
    const Class before = i == 0 ? base : side(line[i - 1]);
    const Class after = end == line.size() ? base : side(line[end]);
    std::fill(line.begin() + static_cast<std::ptrdiff_t>(i),
              line.begin() + static_cast<std::ptrdiff_t>(end), before == after ? before : base);
    i = end;
  }
}

/// The embedding level of a character: even levels run left to right, odd ones right to left.
int level(Class c, Class base) {
  if (c == Class::right) return 1;
  if (c == Class::number) return 2;
  return base == Class::right ? 2 : 0;
}

}  // namespace

std::vector<DirectedRun> directed_runs(std::u32string_view text) {
  std::vector<Class> line = classes(text);
  const auto strong = std::find_if(line.begin(), line.end(),
                                   [](Class c) { return c == Class::left || c == Class::right; });
  const Class base = strong == line.end() ? Class::left : *strong;
  resolve(line, base);
  std::vector<DirectedRun> runs;
  std::vector<int> levels;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int depth = level(line[i], base);
    // Shapers take a run of nothing but Arabic digits for right-to-left text, so each of these
    // digits becomes a run of its own.
    const bool alone = is_arabic_digit(text[i]) || (i > 0 && is_arabic_digit(text[i - 1]));
    if (levels.empty() || levels.back() != depth || alone) {
      runs.push_back({{}, depth % 2 == 1});
      levels.push_back(depth);
    }
    runs.back().text.push_back(text[i]);
  }
  // Rule L2 of UAX 9: from the deepest level up, reverse every stretch at that level or deeper.
  for (int depth = 2; depth >= 1; --depth) {
    for (std::size_t i = 0; i < runs.size();) {
      std::size_t end = i;
      while (end < runs.size() && levels[end] >= depth) ++end;
      std::reverse(runs.begin() + static_cast<std::ptrdiff_t>(i),
                   runs.begin() + static_cast<std::ptrdiff_t>(end));
      std::reverse(levels.begin() + static_cast<std::ptrdiff_t>(i),
                   levels.begin() + static_cast<std::ptrdiff_t>(end));
      i = end + 1;
    }
  }
  return runs;
}

}  // namespace thiessen
