#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace thiessen {

/// How the readers of a message call what they set and what they hand in.
struct Names {
  /// A setting, with its value where the message gives one (else empty).
  std::string (*setting)(std::string_view name, std::string_view value);
  /// A file that the message names by what it is for.
  std::string (*input)(std::string_view name);
};

/// The words of a message. Settings and inputs stand in them by name, apart from the text around
/// them: a command line and a caller of the library call them differently, and no text that a file
/// holds can be taken for one.
class Wording {
 public:
  Wording() = default;
  Wording(std::string text);       // NOLINT(google-explicit-constructor): a text is a wording
  Wording(std::string_view text);  // NOLINT(google-explicit-constructor)
  Wording(const char* text);       // NOLINT(google-explicit-constructor)

  bool empty() const { return pieces_.empty(); }
  /// The whole text with these names in it.
  std::string text(const Names& names) const;
  /// The whole text as a caller of the library reads it: `'overwrite' replaces it`,
  /// `missing = -99 takes it for a gap`.
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
    std::string text;   // or the name
    std::string value;  // of a setting
    friend bool operator==(const Piece& a, const Piece& b) = default;
  };

  explicit Wording(Piece piece) : pieces_{std::move(piece)} {}

  std::vector<Piece> pieces_;  // no two texts in a row, and none that is empty
};

/// A setting's name, as the library's requests have it (`time_field`), and where it matters the
/// value that is meant.
Wording setting(std::string_view name, std::string_view value = {});

/// The name of a file that is handed in: `stations`.
Wording input(std::string_view name);

}  // namespace thiessen
