#include "base/wording.h"

#include <utility>

namespace thiessen {
namespace {

std::string in_quotes(std::string_view name) {
  return "'" + std::string(name) + "'";
}

std::string plain_setting(std::string_view name, std::string_view value) {
  if (value.empty()) return in_quotes(name);
  const bool is_word = value.find(' ') == std::string_view::npos;
  return std::string(name) + " = " + (is_word ? std::string(value) : in_quotes(value));
}

}  // namespace

Wording::Wording(std::string text) {
  if (!text.empty()) pieces_.push_back({Kind::text, std::move(text), {}});
}

Wording::Wording(std::string_view text) : Wording(std::string(text)) {}

Wording::Wording(const char* text) : Wording(std::string(text)) {}

std::string Wording::text(const Names& names) const {
  std::string all;
  for (const Piece& piece : pieces_) {
    switch (piece.kind) {
      case Kind::text:
        all += piece.text;
        break;
      case Kind::setting:
        all += names.setting(piece.text, piece.value);
        break;
      case Kind::input:
        all += names.input(piece.text);
        break;
    }
  }
  return all;
}

std::string Wording::plain() const {
  return text({plain_setting, in_quotes});
}

Wording& Wording::operator+=(const Wording& more) {
  for (const Piece& piece : std::vector(more.pieces_)) {
    if (piece.kind == Kind::text && !empty() && pieces_.back().kind == Kind::text) {
      pieces_.back().text += piece.text;
    } else {
      pieces_.push_back(piece);
    }
  }
  return *this;
}

Wording setting(std::string_view name, std::string_view value) {
  return Wording({Wording::Kind::setting, std::string(name), std::string(value)});
}

Wording input(std::string_view name) {
  return Wording({Wording::Kind::input, std::string(name), {}});
}

}  // namespace thiessen
