#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace thiessen {

/// What the form of a spreadsheet's cell makes of its number.
struct CellForm {
  bool has_date = false;
  bool has_clock = false;

  bool is_number() const { return !has_date && !has_clock; }
};

/// The form that a number of Excel's built-in forms stands for.
CellForm built_in_form(int number);

/// The form that a code such as `DD/MM/YYYY\ hh:mm` or `[$-409]h:mm AM/PM;@` stands for.
CellForm form_of_code(std::string_view code);

/// A serial number of days as ISO 8601 writes its time, whatever of it the cell's form shows: a
/// date, with a clock where `with_clock` wants one or the number has one, to the millisecond; a
/// clock alone where the form has no date and the number is no more than a day. Nothing where the
/// number stands for no day: before March 1900, where Excel's own are a day off, and beyond the
/// year 9999.
std::optional<std::string> time_of_serial(double serial, CellForm form, bool with_clock,
                                          bool from_1904);

/// Whether a serial number has a clock other than midnight, to the millisecond.
bool has_clock(double serial);

}  // namespace thiessen
