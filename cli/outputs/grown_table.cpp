#include "cli/outputs/grown_table.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>

namespace thiessen::cli {
namespace {

OutputRules replacing(OutputRules rules, bool exists) {
  rules.overwrite = exists;  // a table that appears meanwhile is another run's
  return rules;
}

}  // namespace

GrownTable::GrownTable(const std::string& path, const OutputRules& rules, bool in_place)
    : path_(path),
      in_place_(in_place),
      file_(path, rules),
      outputs_(replacing(rules, file_.exists())) {
  if (!in_place_) replacement_ = &outputs_.add(path_);
}

OutputFile& GrownTable::begin(const std::vector<Basin>& basins, RainFormat& format, bool has_totals,
                              Warnings& warnings) {
  const bool has_table = file_.exists() && file_.size() > 0;
  format.continues = has_table;
  if (has_table) {
    earlier_.emplace(
        path_, file_.size(),
        [this](std::size_t at, std::span<char> into) { return file_.read(at, into); },
        rain_shape(basins, format, has_totals));
  }
  growth_.emplace(path_, has_totals ? "period" : "step", earlier_ ? &*earlier_ : nullptr,
                  format.decimals);
  const std::size_t whole = earlier_ ? earlier_->whole_bytes() : 0;
  if (in_place_) {
    growth_->tell_cut_taken_off(warnings);
    return file_.grow(whole);
  }
  copy(whole, *replacement_);
  return *replacement_;
}

void GrownTable::copy(std::size_t bytes, OutputFile& to) const {
  std::vector<char> piece(std::size_t{256} << 10);
  for (std::size_t at = 0; at < bytes;) {
    const std::size_t wanted = std::min(piece.size(), bytes - at);
    const std::size_t count = file_.read(at, std::span(piece).first(wanted));
    if (count == 0) throw Error(Message{path_, 0, "has become shorter while it was read", ""});
    to.append({piece.data(), count});
    at += count;
  }
}

void GrownTable::pass_on(Warnings& warnings) {
  growth_->tell_so_far(warnings);
  if (in_place_ && growth_->has_added()) file_.keep();
}

void GrownTable::finish(Warnings& warnings) {
  growth_->conclude(warnings);
  if (in_place_) {
    file_.keep();
  } else if (growth_->changes()) {
    file_.require_unchanged();
    outputs_.commit();
  }
}

}  // namespace thiessen::cli
