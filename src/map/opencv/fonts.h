#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace thiessen {

/// What is called where fontconfig breaks off for want of memory: it then goes to an address that
/// is none, and without this the process ends by that signal.
void when_fonts_break_off(void (*end)() noexcept);

/// One face of a font file, which may hold several.
struct FontFace {
  std::string file;
  int face = 0;
};

/// The outline fonts of this machine in order of preference: DejaVu Sans, then the fonts that
/// fontconfig holds nearest to a sans-serif, and last those whose outlines are made of bitmaps. The
/// order does not depend on the locale.
class FontList {
 public:
  /// Throws Error where no outline font is installed.
  explicit FontList(bool bold);
  ~FontList();
  FontList(FontList&&) noexcept;
  FontList& operator=(FontList&&) noexcept;

  std::size_t size() const;
  const FontFace& face(std::size_t font) const;
  /// Whether the font's outlines are made of bitmaps, which letters do not join in (Unifont).
  bool has_pixels(std::size_t font) const;
  /// Whether the font has a glyph for each visible character of the text.
  bool covers(std::size_t font, std::u32string_view text) const;
  /// The first font that covers the whole text. Cost: the fonts times the text.
  std::optional<std::size_t> first_to_cover(std::u32string_view text) const;

 private:
  struct Set;
  std::unique_ptr<Set> set_;
};

}  // namespace thiessen
