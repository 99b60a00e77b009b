#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace thiessen {

/// How the readers of a message call the settings they make and the files they hand in.
struct Names {
  /// Names a setting, with its value where the message gives one (otherwise empty).
  std::string (*setting)(std::string_view name, std::string_view value);
  /// Names a file that the message refers to by its purpose.
  std::string (*input)(std::string_view name);
};

/// The words of a message. Settings and inputs are kept in it by name, apart from the text around
/// them, for two reasons: a command line and a caller of the library call them differently, and no
/// text from a file can be mistaken for one.
class Wording {
 public:
  Wording() = default;
  Wording(std::string text);       // NOLINT(google-explicit-constructor): a text is a wording
  Wording(std::string_view text);  // NOLINT(google-explicit-constructor)
  Wording(const char* text);       // NOLINT(google-explicit-constructor)

  bool empty() const { return pieces_.empty(); }
  /// The whole text with these names in it.
  std::string text(const Names& names) const;
  /// The whole text as a caller of the library reads it: `'overwrite' replaces it`, `missing = -99
  /// takes it for a gap`.
  std::string plain() const;

  Wording& operator+=(const Wording& more);
  friend Wording operator+(Wording a, const Wording& b) {
    a += b;
    return a;
  }
  friend bool operator==(const Wording& a, const Wording& b) = default;

  friend Wording setting(std::string_view name, std::string_view value);
  friend Wording input(std::string_view name);

 private:
  enum class Kind : std::uint8_t { text, setting, input };
  struct Piece {
    Kind kind;
    std::string text;   // the text, or the name
    std::string value;  // the value of a setting
    friend bool operator==(const Piece& a, const Piece& b) = default;
  };

  explicit Wording(Piece piece) : pieces_{std::move(piece)} {}

  std::vector<Piece> pieces_;  // never two texts in a row, and never an empty text
};

/// Refers to a setting by its name in the library's requests (`time_field`), and where it matters
/// with the value that is meant.
Wording setting(std::string_view name, std::string_view value = {});

/// Refers to a file that is handed in, such as `stations`.
Wording input(std::string_view name);

}  // namespace thiessen
