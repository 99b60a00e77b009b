#include "results/earlier_rain.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/interrupt.h"
#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::size_t steps_apart = 512;
constexpr std::size_t steps_loaded = 64;
constexpr std::size_t piece_bytes = std::size_t{64} << 10;
constexpr std::size_t longest_header = std::size_t{64} << 20;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

CsvOptions plain_csv() {
  CsvOptions options;
  options.has_names = false;
  return options;
}

InputFile text_file(std::string name, std::string text) {
  return {std::move(name),
          [text = std::move(text), at = std::size_t{0}](std::span<char> into) mutable {
            const std::size_t count = text.copy(into.data(), into.size(), at);
            at += count;
            return count;
          }};
}

/// The first difference of two headers, in words; empty where there is none.
std::string difference(const std::vector<std::string>& there,
                       const std::vector<std::string>& wanted) {
  const std::size_t both = std::min(there.size(), wanted.size());
  for (std::size_t i = 0; i < both; ++i) {
    if (there[i] == wanted[i]) continue;
    return "column " + std::to_string(i + 1) + " is " + quoted(there[i], 80) +
           ", and this run writes " + quoted(wanted[i], 80) + " there";
  }
  if (there.size() == wanted.size()) return {};
  const bool more = there.size() > both;
  return "this run writes " + std::to_string(wanted.size()) + ", " + (more ? "not " : "also ") +
         quoted(more ? there[both] : wanted[both], 80);
}

double value_of(std::string_view field) {
  const auto number = parse_number(trimmed(field));
  return number ? number.value : none;
}

}  // namespace

EarlierRain::EarlierRain(std::string file, std::size_t size, Read read, RainShape shape)
    : file_(std::move(file)), read_(std::move(read)), whole_(size), shape_(std::move(shape)) {
  read_header();
  find_cut_line();
  read_steps();
  if (!ascends_) hash_steps();
}

std::string EarlierRain::bytes(std::size_t from, std::size_t to) const {
  std::string text(to - from, '\0');
  std::size_t count = 0;
  while (count < text.size()) {
    const std::size_t more = read_(from + count, std::span<char>(text).subspan(count));
    if (more == 0) break;
    count += more;
  }
  text.resize(count);
  return text;
}

/// Compares the first line with the header that this run would write.
void EarlierRain::read_header() {
  while (header_.find('\n') == std::string::npos &&
         header_.size() < std::min(whole_, longest_header))
    header_ += bytes(header_.size(), std::min(whole_, header_.size() + piece_bytes));
  header_.resize(std::min(header_.size(), header_.find('\n') + 1));  // npos + 1 is 0
  if (header_.empty())
    throw Error({file_, 1, "its first line has no end, so that no row can follow", ""});
  const CsvReader there(text_file(file_, header_), plain_csv());
  const CsvReader wanted(text_file(file_, shape_.header), plain_csv());
  const std::string differs = difference(there.header(), wanted.header());
  if (differs.empty()) return;
  throw Error({file_, 1, "the table has other columns: " + differs,
               "steps are added to a table of the same basins and options alone"});
}

/// Looks for the last line end. What follows it does not count.
void EarlierRain::find_cut_line() {
  for (std::size_t end = whole_; end > 0;) {
    const std::size_t from = end - std::min(end, piece_bytes);
    const std::size_t found = bytes(from, end).rfind('\n');
    if (found == std::string::npos) {
      end = from;
      continue;
    }
    if (from + found + 1 < whole_) cut_at(from + found + 1);
    return;
  }
}

void EarlierRain::cut_at(std::size_t at) {
  constexpr std::size_t longest_shown = 200;
  const std::string text = bytes(at, std::min(whole_, at + piece_bytes));
  cut_.emplace();
  cut_->text = text.substr(0, longest_shown);
  const std::size_t comma = text.find(',');
  if (comma != std::string::npos && !text.starts_with('"'))
    cut_->key = step_key(std::string_view(text).substr(0, comma));
  cut_->may_be_whole = shape_.rows == 1 && has_all_fields(text);
  whole_ = at;
}

bool EarlierRain::has_all_fields(const std::string& row) const {
  try {
    const CsvReader header(text_file(file_, header_), plain_csv());
    const CsvReader fields(text_file(file_, row), plain_csv());
    return fields.header().size() == header.header().size();
  } catch (const Error&) {
    return false;
  }
}

/// The rows of the table from a place on, up to the end of what is whole.
std::unique_ptr<CsvReader> EarlierRain::rows_from(std::size_t at) const {
  InputFile input(file_, [this, at, in_header = std::size_t{0}](std::span<char> into) mutable {
    throw_if_interrupted();
    if (in_header < header_.size()) {
      const std::size_t count = header_.copy(into.data(), into.size(), in_header);
      in_header += count;
      return count;
    }
    const std::size_t count = read_(at, into.first(std::min(into.size(), whole_ - at)));
    at += count;
    return count;
  });
  return std::make_unique<CsvReader>(std::move(input), plain_csv());
}

void EarlierRain::read_steps() {
  const auto rows = rows_from(header_.size());
  Reached step;
  for (Row row; rows->next(row); ++step.rows) {
    const std::string_view time = row.fields[0];
    if (step.rows > 0 && time == step.time && step.rows < shape_.rows) continue;
    if (step.rows > 0) note(step);
    step = {std::string(time), rows->row_offset(), row.line, 0};
  }
  if (step.rows == 0) return;
  if (step.rows == shape_.rows) return note(step);
  cut_at(step.at);
  cut_->key = step_key(step.time);
}

/// Takes note of a step that others follow, or that is whole.
void EarlierRain::note(const Reached& step) {
  if (step.rows != shape_.rows) {
    throw Error({file_, step.line,
                 "the step " + quoted(step.time, 80) + " has " + std::to_string(step.rows) +
                     " of " + std::to_string(shape_.rows) + " rows",
                 "only a last step that was cut off is mended"});
  }
  StepKey key = step_key(step.time);
  if (steps_ == 0) {
    first_time_ = step.time;
    first_ = latest_ = key;
    ascends_ = key.is_moment;
  } else {
    ascends_ = ascends_ && are_alike(first_, key) && comes_before(latest_, key);
  }
  if (comes_before(latest_, key)) latest_ = key;
  if (ascends_ && steps_ % steps_apart == 0) places_.push_back({std::move(key), step.at});
  ++steps_;
}

void EarlierRain::hash_steps() {
  places_.clear();
  hashed_.reserve(steps_);
  const auto rows = rows_from(header_.size());
  std::size_t count = 0;
  for (Row row; rows->next(row); ++count) {
    if (count % shape_.rows == 0)
      hashed_.push_back({hash_of(step_key(row.fields[0])), rows->row_offset()});
  }
  std::ranges::stable_sort(hashed_, {}, &Hashed::hash);
}

void EarlierRain::load(std::size_t at, std::size_t steps) {
  loaded_.clear();
  next_ = 0;
  const auto rows = rows_from(at);
  Row row;
  for (std::size_t count = 0; count < steps * shape_.rows && rows->next(row); ++count) {
    if (count % shape_.rows == 0) loaded_.push_back({step_key(row.fields[0]), {}});
    for (const std::size_t column : shape_.values)
      loaded_.back().values.push_back(value_of(row.fields[column]));
  }
}

const std::vector<double>* EarlierRain::find_loaded(const StepKey& key) {
  for (std::size_t i = 0; i < loaded_.size(); ++i) {
    const std::size_t at = (next_ + i) % loaded_.size();
    if (loaded_[at].key != key) continue;
    next_ = at + 1;
    return &loaded_[at].values;
  }
  return nullptr;
}

const std::vector<double>* EarlierRain::find(const StepKey& key) {
  if (steps_ == 0) return nullptr;
  if (ascends_) {
    if (comes_before(latest_, key) || comes_before(key, first_)) return nullptr;
    const bool is_loaded = !loaded_.empty() && !comes_before(key, loaded_.front().key) &&
                           !comes_before(loaded_.back().key, key);
    if (!is_loaded) {
      const auto behind = std::ranges::upper_bound(
          places_, key, [](const StepKey& a, const StepKey& b) { return comes_before(a, b); },
          &Place::key);
      load(std::prev(behind)->at, steps_apart);
    }
    return find_loaded(key);
  }
  if (const auto* values = find_loaded(key)) return values;
  const std::uint64_t hash = hash_of(key);
  for (auto step = std::ranges::lower_bound(hashed_, hash, {}, &Hashed::hash);
       step != hashed_.end() && step->hash == hash; ++step) {
    load(step->at, steps_loaded);
    if (!loaded_.empty() && loaded_[0].key == key) {
      next_ = 1;
      return &loaded_[0].values;
    }
  }
  return nullptr;
}

}  // namespace thiessen
