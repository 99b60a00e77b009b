#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "map/ink/set_text.h"

namespace thiessen {

class FontList;
struct DirectedRun;

/// Sets lines of text of any script in the fonts of this machine: in DejaVu Sans where it has the
/// characters, else each word in the first font that has them all. Sizes are in pixels to the em.
/// Texts are UTF-8, see displayable().
class Typesetter {
 public:
  /// Throws Error where no font is installed.
  Typesetter();
  ~Typesetter();

  /// Sets at most the first `longest` code points of the text. Cost: the pixels.
  SetText set(std::string_view text, int size, Weight weight = Weight::regular,
              std::size_t longest = 200);
  /// Sets the text in the largest size from `size` down to `smallest` in which it is at most
  /// `max_width` pixels wide. A text that is too wide even in the smallest is shortened, with an
  /// ellipsis.
  SetText fit(std::string_view text, int size, int smallest, int max_width,
              Weight weight = Weight::regular);

  /// The characters set so far that no font shows, each once, in the order in which they came.
  const std::u32string& missing() const { return missing_; }
  /// The characters set so far that only a font of bitmaps shows, likewise; blanks may be among
  /// them.
  const std::u32string& coarse() const { return coarse_; }
  /// The first few words with such characters, whole and as they are read.
  const std::vector<std::u32string>& coarse_words() const { return coarse_words_; }

 private:
  struct Fonts;
  struct Piece;

  Fonts& fonts(Weight weight);
  std::vector<Piece> pieces(const std::vector<DirectedRun>& runs, Weight weight);
  /// The preferred font, else the font of the text before it, else the first in the list, whichever
  /// first has all the characters.
  static std::optional<std::size_t> font_for(std::u32string_view text, const FontList& fonts,
                                             const std::vector<Piece>& line);
  void add_word(std::u32string_view word, const FontList& fonts, std::vector<Piece>& line);
  /// Takes note of a word whose pieces are those from `first` on, where one is of bitmaps.
  void note_coarse(std::u32string_view word, const std::vector<Piece>& line, std::size_t first,
                   const FontList& fonts);
  void add_run(std::u32string_view run, const FontList& fonts, std::vector<Piece>& out);
  SetText set_line(std::u32string_view text, int size, Weight weight);

  std::unique_ptr<Fonts> regular_;
  std::unique_ptr<Fonts> bold_;
  std::u32string missing_;
  std::u32string coarse_;
  std::vector<std::u32string> coarse_words_;
};

}  // namespace thiessen
