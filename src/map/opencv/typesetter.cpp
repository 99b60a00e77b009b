#include "map/opencv/typesetter.h"

#include <algorithm>
#include <map>
#include <new>
#include <opencv2/core.hpp>
#include <opencv2/freetype.hpp>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "base/error.h"
#include "base/memory.h"
#include "map/ink/unicode.h"
#include "map/opencv/fonts.h"
#include "map/opencv/lone_thread.h"

namespace thiessen {

using Face = cv::Ptr<cv::freetype::FreeType2>;

constexpr std::size_t bytes_of_fonts = std::size_t{32} << 20;

/// The fonts of one weight. Each file is opened when it is first needed.
struct Typesetter::Fonts {
  explicit Fonts(bool bold) : list(bold) {}

  cv::freetype::FreeType2& face(std::size_t font) {
    Face& face = open[font];
    if (!face) {
      // One whose loading fails must not be kept: OpenCV would take it for whole.
      Face fresh = cv::freetype::createFreeType2();
      fresh->loadFontData(list.face(font).file, list.face(font).face);
      face = fresh;
    }
    return *face;
  }

  FontList list;
  std::map<std::size_t, Face> open;
};

/// A piece of text in one direction and one font, without spaces at its ends.
struct Typesetter::Piece {
  std::size_t font = 0;
  std::u32string text;
  std::size_t spaces_before = 0;
};

namespace {

constexpr std::size_t preferred = 0;

cv::Mat pixels_of(Coverage& coverage) {
  return {coverage.height, coverage.width, CV_8UC1, coverage.values.data()};
}

/// Cuts a mask, which has room for any text around its ink, down to the columns and rows of the
/// ink.
SetText cut_to_ink(const cv::Mat& drawn, int baseline) {
  cv::Mat mask;
  cv::extractChannel(drawn, mask, 0);
  const cv::Rect box = cv::boundingRect(mask);
  SetText text;
  if (box.empty()) return text;
  text.ink = Coverage(box.width, box.height);
  text.baseline = baseline - box.y;
  mask(box).copyTo(pixels_of(text.ink));
  return text;
}

SetText draw(cv::freetype::FreeType2& face, const std::u32string& text, int size) {
  constexpr int filled = -1;
  const std::string utf8 = to_utf8(text);
  int baseline = 0;
  const cv::Size box = face.getTextSize(utf8, size, filled, &baseline);
  const int margin = 2 * size;
  cv::Mat drawn(4 * size, std::max(box.width, 0) + 2 * margin, CV_8UC3, cv::Scalar::all(0));
  const int line = 5 * size / 2;
  face.putText(drawn, utf8, {margin, line}, size, cv::Scalar::all(255), filled, cv::LINE_AA, true);
  return cut_to_ink(drawn, line);
}

/// Takes note of characters that did not come before.
void note(std::u32string_view characters, std::u32string& seen) {
  for (const char32_t c : characters) {
    if (seen.find(c) == std::u32string::npos) seen.push_back(c);
  }
}

/// Puts a piece of text beside a line, with both on one baseline.
void append(SetText& piece, int gap, SetText& line) {
  const int ascent = std::max(line.baseline, piece.baseline);
  const int descent = std::max(line.height() - line.baseline, piece.height() - piece.baseline);
  Coverage ink(line.width() + gap + piece.width(), ascent + descent);
  const auto put = [&](SetText& part, int x) {
    if (part.width() == 0) return;
    const cv::Rect box(x, ascent - part.baseline, part.width(), part.height());
    pixels_of(part.ink).copyTo(pixels_of(ink)(box));
  };
  put(line, 0);
  put(piece, line.width() + gap);
  line.ink = std::move(ink);
  line.baseline = ascent;
}

std::size_t end_of_cluster(std::u32string_view text, std::size_t begin) {
  std::size_t end = begin + 1;
  while (end < text.size() && is_attached(text[end])) ++end;
  return end;
}

/// Finds the end of a word and of the spaces after it.
std::size_t end_of_word(std::u32string_view text, std::size_t begin) {
  const std::size_t space = text.find(U' ', begin);
  if (space == std::u32string_view::npos) return text.size();
  return std::min(text.find_first_not_of(U' ', space), text.size());
}

std::u32string_view trimmed(std::u32string_view text) {
  const std::size_t begin = text.find_first_not_of(U' ');
  if (begin == std::u32string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(U' ') - begin + 1);
}

/// The numbers of spaces to the left and to the right of a piece of text.
struct Spaces {
  std::size_t left = 0;
  std::size_t right = 0;
};

/// Takes the spaces off both ends of `text` and counts them; those of a text of nothing but spaces
/// all count as left.
Spaces take_spaces(std::u32string& text, bool right_to_left) {
  const std::u32string_view ink = trimmed(text);
  const std::size_t before = ink.empty() ? text.size() : text.find_first_not_of(U' ');
  const std::size_t after = text.size() - before - ink.size();
  text = std::u32string(ink);
  if (right_to_left && !text.empty()) return {after, before};
  return {before, after};
}

}  // namespace

Typesetter::Typesetter() : regular_(std::make_unique<Fonts>(false)) {
  draw_on_one_thread();
  // The libraries that read fonts crash where they get no memory, so it must be there before.
  if (!can_have(bytes_of_fonts)) throw std::bad_alloc();
}

Typesetter::~Typesetter() = default;

Typesetter::Fonts& Typesetter::fonts(Weight weight) {
  if (weight == Weight::regular) return *regular_;
  if (!bold_) bold_ = std::make_unique<Fonts>(true);
  return *bold_;
}

std::optional<std::size_t> Typesetter::font_for(std::u32string_view text, const FontList& fonts,
                                                const std::vector<Piece>& line) {
  if (fonts.covers(preferred, text)) return preferred;
  if (!line.empty() && fonts.covers(line.back().font, text)) return line.back().font;
  return fonts.first_to_cover(text);
}

void Typesetter::add_word(std::u32string_view word, const FontList& fonts,
                          std::vector<Piece>& line) {
  if (const auto font = font_for(word, fonts, line)) {
    line.push_back({*font, std::u32string(word), 0});
    return;
  }
  for (std::size_t i = 0; i < word.size();) {
    const std::size_t end = end_of_cluster(word, i);
    std::u32string cluster(word.substr(i, end - i));
    auto font = font_for(cluster, fonts, line);
    if (!font) {
      for (const char32_t c : cluster) {
        if (!is_invisible(c) && !fonts.first_to_cover({&c, 1})) note({&c, 1}, missing_);
      }
      cluster = fonts.covers(preferred, U"\uFFFD") ? U"\uFFFD" : U"?";
      font = preferred;
    }
    line.push_back({*font, std::move(cluster), 0});
    i = end;
  }
}

void Typesetter::note_coarse(std::u32string_view word, const std::vector<Piece>& line,
                             std::size_t first, const FontList& fonts) {
  constexpr std::size_t most = 3;
  bool is_coarse = false;
  for (std::size_t i = first; i < line.size(); ++i) {
    if (!fonts.has_pixels(line[i].font)) continue;
    is_coarse = true;
    note(line[i].text, coarse_);
  }
  const std::u32string text(word);
  const auto is_known = std::find(coarse_words_.begin(), coarse_words_.end(), text);
  if (is_coarse && coarse_words_.size() < most && is_known == coarse_words_.end())
    coarse_words_.push_back(text);
}

void Typesetter::add_run(std::u32string_view run, const FontList& fonts, std::vector<Piece>& out) {
  std::vector<Piece> words;
  if (fonts.covers(preferred, run)) {
    words.push_back({preferred, std::u32string(run), 0});
  } else {
    for (std::size_t i = 0; i < run.size();) {
      const std::size_t end = end_of_word(run, i);
      const std::size_t before = words.size();
      add_word(run.substr(i, end - i), fonts, words);
      note_coarse(trimmed(run.substr(i, end - i)), words, before, fonts);
      i = end;
    }
  }
  for (Piece& word : words) {
    if (!out.empty() && out.back().font == word.font) {
      out.back().text += word.text;
    } else {
      out.push_back(std::move(word));
    }
  }
}

std::vector<Typesetter::Piece> Typesetter::pieces(const std::vector<DirectedRun>& runs,
                                                  Weight weight) {
  std::vector<Piece> result;
  std::size_t spaces = 0;
  for (const DirectedRun& run : runs) {
    std::vector<Piece> added;
    add_run(run.text, fonts(weight).list, added);
    if (run.right_to_left) std::reverse(added.begin(), added.end());
    for (Piece& piece : added) {
      const Spaces around = take_spaces(piece.text, run.right_to_left);
      spaces += around.left;
      if (piece.text.empty()) continue;
      piece.text = for_shaper(piece.text, run.right_to_left);
      piece.spaces_before = spaces;
      result.push_back(std::move(piece));
      spaces = around.right;
    }
  }
  return result;
}

SetText Typesetter::set_line(std::u32string_view text, int size, Weight weight) {
  SetText line;
  line.text = to_utf8(text);
  line.size = size;
  line.weight = weight;
  const DirectedLine directed = directed_line(text);
  line.right_to_left = directed.right_to_left;
  for (const Piece& piece : pieces(directed.runs, weight)) {
    try {
      SetText drawn = draw(fonts(weight).face(piece.font), piece.text, size);
      const int space = static_cast<int>(std::min<std::size_t>(piece.spaces_before, 100)) * size;
      const int gap = line.width() == 0 ? 0 : (size + 8) / 16 + space * 3 / 10;
      append(drawn, gap, line);
    } catch (const cv::Exception&) {
      if (!can_have(bytes_of_fonts)) throw std::bad_alloc();
      note(piece.text, missing_);
    }
  }
  return line;
}

SetText Typesetter::set(std::string_view text, int size, Weight weight, std::size_t longest) {
  return set_line(shortened(trimmed(displayable(text)), longest), size, weight);
}

SetText Typesetter::fit(std::string_view text, int size, int smallest, int max_width,
                        Weight weight) {
  constexpr std::size_t longest = 200;
  const std::u32string characters = displayable(text);
  const std::u32string line = shortened(trimmed(characters), longest);
  SetText result = set_line(line, size, weight);
  while (result.width() > max_width && size > smallest) {
    size = std::max(smallest, std::min(size - 1, size * max_width / result.width()));
    result = set_line(line, size, weight);
  }
  std::size_t length = line.size();
  while (result.width() > max_width && length > 1) {
    length = std::min(length - 1, length * static_cast<std::size_t>(std::max(max_width, 0)) /
                                      static_cast<std::size_t>(result.width()));
    result = set_line(shortened(line, length), size, weight);
  }
  result.is_shortened = length < line.size() || line.size() < trimmed(characters).size();
  return result.width() > max_width ? SetText{} : result;
}

}  // namespace thiessen
