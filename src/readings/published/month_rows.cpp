#include "readings/published/month_rows.h"

#include <optional>
#include <utility>

#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::string_view checked_level = "2";

std::string two_digits(std::size_t number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

std::string day_column(std::size_t day) {
  return "Chuva" + two_digits(day);
}

std::size_t days_of(int year, int month) {
  constexpr std::array<std::size_t, 12> days = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  const bool leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
  return month == 2 && leap ? 29 : days[static_cast<std::size_t>(month - 1)];
}

struct Month {
  int year;
  int month;
};

/// The month of a date such as 01/12/2020, with or without a clock behind it.
std::optional<Month> month_of(std::string_view date) {
  const auto parts = parted(date.substr(0, date.find(' ')), '/');
  if (parts.size() != 3) return std::nullopt;
  const auto month = parse_number(parts[1]);
  const auto year = parse_number(parts[2]);
  if (!month || !year || parts[1].size() > 2 || parts[2].size() != 4) return std::nullopt;
  if (month.value < 1 || month.value > 12 || year.value < 1) return std::nullopt;
  return Month{static_cast<int>(year.value), static_cast<int>(month.value)};
}

}  // namespace

const PublishedFormat& ana_format() {
  static constexpr PublishedFormat format = {.name = "ANA's rain, a row a month",
                                             .columns = "EstacaoCodigo, Data, Chuva",
                                             .station = "EstacaoCodigo",
                                             .time = "Data",
                                             .value = "Chuva",
                                             .unit = "mm",
                                             .ids_as_numbers = true};
  return format;
}

bool is_ana_header(const std::vector<std::string>& header) {
  for (const std::string_view name : {"EstacaoCodigo", "NivelConsistencia", "Data"}) {
    if (!published_column(header, name)) return false;
  }
  return published_column(header, day_column(1)) && published_column(header, day_column(31));
}

MonthRows::MonthRows(std::unique_ptr<Table> table, std::unique_ptr<Table> same)
    : table_(std::move(table)),
      station_(published_column(table_->header(), "EstacaoCodigo").value()),
      date_(published_column(table_->header(), "Data").value()),
      level_(published_column(table_->header(), "NivelConsistencia").value()) {
  for (std::size_t day = 0; day < most_days; ++day) {
    const auto column = published_column(table_->header(), day_column(day + 1));
    if (!column) {
      throw Error({file(), table_->header_line(), "there is no column " + day_column(day + 1), ""});
    }
    days_[day] = *column;
  }
  find_checked(std::move(same));
}

std::unique_ptr<Table> MonthRows::again() const {
  auto table = table_->again();
  return table ? std::make_unique<MonthRows>(std::move(table)) : nullptr;
}

void MonthRows::find_checked(std::unique_ptr<Table> same) {
  const auto table = same ? std::move(same) : table_->again();
  if (!table) return;
  try {
    for (Row row; table->next(row);) {
      if (is_checked(row)) checked_.insert(key(row));
    }
  } catch (const Error&) {
    // The error is met again, and reported, when the rows are read.
  }
}

std::string MonthRows::key(const Row& row) const {
  return std::string(row.fields[station_]) + ' ' + std::string(row.fields[date_]);
}

bool MonthRows::is_checked(const Row& row) const {
  return trimmed(row.fields[level_]) == checked_level;
}

bool MonthRows::next(Row& row) {
  while (day_ == day_count_) {
    if (!next_month()) return false;
  }
  time_ = month_text_ + two_digits(day_ + 1);
  row.line = month_.line * days_a_line + day_;
  row.padded = false;
  row.fields = {month_.fields[station_], time_, month_.fields[days_[day_]]};
  ++day_;
  return true;
}

/// Reads on to the next month that counts.
bool MonthRows::next_month() {
  while (table_->next(month_)) {
    if (!is_checked(month_) && checked_.contains(key(month_))) continue;
    if (read_month()) return true;
  }
  std::exchange(complaints_, {}).throw_if_any();
  return false;
}

bool MonthRows::read_month() {
  const auto month = month_of(month_.fields[date_]);
  if (!month) {
    complaints_.add({file(), month_.line,
                     "no date of a month such as 01/12/2020: " + quoted(month_.fields[date_], 40),
                     ""});
    return false;
  }
  std::string year = std::to_string(month->year);
  year.insert(0, 4 - year.size(), '0');
  month_text_ = year + "-" + two_digits(static_cast<std::size_t>(month->month)) + "-";
  day_ = 0;
  day_count_ = days_of(month->year, month->month);
  for (std::size_t day = 0; day < day_count_; ++day) check_day(day);
  return true;
}

void MonthRows::check_day(std::size_t day) {
  const std::string_view value = trimmed(month_.fields[days_[day]]);
  const auto number = parse_number(value, decimal_mark());
  if (value.empty() || (number && number.value >= 0)) return;
  complaints_.add({file(), month_.line,
                   "the rain of " + month_text_ + two_digits(day + 1) +
                       " is no number from 0 on: " + quoted(value, 40),
                   ""});
}

}  // namespace thiessen
