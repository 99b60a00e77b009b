#include "map/opencv/fonts.h"

#include <fontconfig/fontconfig.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>
#include <vector>

#include "base/error.h"
#include "map/ink/unicode.h"

namespace thiessen {
namespace {

struct Release {
  void operator()(FcConfig* config) const { FcConfigDestroy(config); }
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
  void operator()(FcFontSet* fonts) const { FcFontSetDestroy(fonts); }
};

template <typename T>
using Held = std::unique_ptr<T, Release>;

const FcChar8* name(const char* text) {
  return reinterpret_cast<const FcChar8*>(text);
}

/// Makes the pattern that fontconfig is to match. It names a language, as fontconfig would
/// otherwise take that of the locale.
Held<FcPattern> wanted(FcConfig* config, bool bold) {
  Held<FcPattern> pattern(FcPatternCreate());
  if (!pattern) throw std::bad_alloc();
  FcPatternAddString(pattern.get(), FC_FAMILY, name("DejaVu Sans"));
  FcPatternAddString(pattern.get(), FC_FAMILY, name("sans-serif"));
  FcPatternAddString(pattern.get(), FC_LANG, name("en"));
  FcPatternAddInteger(pattern.get(), FC_WEIGHT, bold ? FC_WEIGHT_BOLD : FC_WEIGHT_REGULAR);
  FcPatternAddInteger(pattern.get(), FC_SLANT, FC_SLANT_ROMAN);
  FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
  FcConfigSubstitute(config, pattern.get(), FcMatchPattern);
  FcDefaultSubstitute(pattern.get());
  return pattern;
}

std::atomic<void (*)() noexcept> end_of_program = nullptr;

extern "C" {
static void end_at_once(int) {
  end_of_program.load()();
}
}

std::mutex only_watch;

/// As long as it lives, a wrong address is fontconfig's. There is one at a time: each brings back
/// what it found, and of two that overlap the later would bring back the earlier.
class Watch {
 public:
  Watch() : is_only_(only_watch), is_watching_(end_of_program.load() != nullptr) {
    if (!is_watching_) return;
    struct sigaction action = {};
    action.sa_handler = end_at_once;
    sigemptyset(&action.sa_mask);
    is_watching_ = ::sigaction(SIGSEGV, &action, &before_) == 0;
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;
  ~Watch() {
    if (is_watching_) ::sigaction(SIGSEGV, &before_, nullptr);
  }

 private:
  const std::lock_guard<std::mutex> is_only_;
  bool is_watching_;
  struct sigaction before_ = {};
};

bool is_true(const FcPattern* font, const char* property) {
  FcBool value = FcFalse;
  return FcPatternGetBool(font, property, 0, &value) == FcResultMatch && value == FcTrue;
}

bool is_unifont(const FcPattern* font) {
  FcChar8* family = nullptr;
  return FcPatternGetString(font, FC_FAMILY, 0, &family) == FcResultMatch &&
         std::string_view(reinterpret_cast<const char*>(family)).starts_with("Unifont");
}

bool can_draw(const FcPattern* font) {
  return is_true(font, FC_OUTLINE) && !is_true(font, FC_COLOR) && !is_true(font, FC_VARIABLE);
}

}  // namespace

void when_fonts_break_off(void (*end)() noexcept) {
  end_of_program = end;
}

struct FontList::Set {
  struct Font {
    FontFace face;
    const FcCharSet* characters;
    bool has_pixels = false;
  };
  Held<FcConfig> config;
  Held<FcFontSet> found;
  std::vector<Font> fonts;
};

FontList::FontList(bool bold) : set_(std::make_unique<Set>()) {
  const Watch watch;
  set_->config.reset(FcInitLoadConfigAndFonts());
  if (!set_->config) throw std::bad_alloc();
  FcResult result = FcResultNoMatch;
  const Held<FcPattern> pattern = wanted(set_->config.get(), bold);
  set_->found.reset(FcFontSort(set_->config.get(), pattern.get(), FcFalse, nullptr, &result));
  if (result == FcResultOutOfMemory) throw std::bad_alloc();
  for (int i = 0; set_->found && i < set_->found->nfont; ++i) {
    FcPattern* const font = set_->found->fonts[i];
    FcChar8* file = nullptr;
    FcCharSet* characters = nullptr;
    int face = 0;
    if (!can_draw(font) || FcPatternGetString(font, FC_FILE, 0, &file) != FcResultMatch ||
        FcPatternGetCharSet(font, FC_CHARSET, 0, &characters) != FcResultMatch) {
      continue;
    }
    FcPatternGetInteger(font, FC_INDEX, 0, &face);
    set_->fonts.push_back(
        {{reinterpret_cast<const char*>(file), face}, characters, is_unifont(font)});
  }
  std::stable_partition(set_->fonts.begin(), set_->fonts.end(),
                        [](const Set::Font& font) { return !font.has_pixels; });
  if (set_->fonts.empty()) {
    throw Error(Message{{}, 0, "no font to draw with", "install a font such as DejaVu Sans"});
  }
}

FontList::~FontList() = default;
FontList::FontList(FontList&&) noexcept = default;
FontList& FontList::operator=(FontList&&) noexcept = default;

std::size_t FontList::size() const {
  return set_->fonts.size();
}

const FontFace& FontList::face(std::size_t font) const {
  return set_->fonts[font].face;
}

bool FontList::has_pixels(std::size_t font) const {
  return set_->fonts[font].has_pixels;
}

bool FontList::covers(std::size_t font, std::u32string_view text) const {
  return std::all_of(text.begin(), text.end(), [&](char32_t c) {
    return is_invisible(c) || FcCharSetHasChar(set_->fonts[font].characters, c);
  });
}

std::optional<std::size_t> FontList::first_to_cover(std::u32string_view text) const {
  for (std::size_t font = 0; font < size(); ++font) {
    if (covers(font, text)) return font;
  }
  return std::nullopt;
}

}  // namespace thiessen
