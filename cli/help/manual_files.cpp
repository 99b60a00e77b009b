#include "cli/help/manual_files.h"

#include <span>
#include <string_view>

#include "cli/help/roff.h"
#include "readings/published/known_formats.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen::cli {
namespace {

std::string names_entry(const std::string& of_what, std::span<const std::string_view> names) {
  return ".TP\n" + roff_bold(of_what) + "\n" + roff_paragraph(listed(names) + ".");
}

std::string names_section() {
  return ".SH NAMES AND MISSING VALUES\n" +
         roff_paragraph(
             "Fields that no option names are found by these names, the first that is there. Case "
             "does not count, nor whether words are parted by a blank, a point, - or _.") +
         names_entry("station's id", known::station_ids) +
         names_entry("longitude or easting", known::eastings) +
         names_entry("latitude or northing", known::northings) +
         names_entry("basin's id (whose values are all there and all different)",
                     known::basin_ids) +
         names_entry("elevation of a station or a basin", known::elevations) +
         names_entry("time of a table of one reading a row", known::times) +
         names_entry("its value, with or without a unit behind it", known::values) + ".PP\n" +
         roff_paragraph(
             "Without a name of a station's id the first field is taken, without one of a basin's "
             "the feature's number. Coordinates in fields that are called as longitude and "
             "latitude "
             "are degrees on WGS 84; those in x and y, easting and northing and the like are in "
             "the "
             "CRS that an option or the file of basins names. A table without a station and a "
             "value field is wide: "
             "the first column is the time, and the name of every other one a station's id.") +
         names_entry("parts of a time: year", known::years) + names_entry("month", known::months) +
         names_entry("day", known::days) + names_entry("day of the year", known::days_of_year) +
         names_entry("hour", known::hours) +
         names_entry("hour and minute in one number", known::hours_with_minutes) +
         names_entry("minute", known::minutes) + names_entry("second", known::seconds) +
         names_entry("no reading, beside an empty field", known::gaps) + ".PP\n" +
         roff_paragraph(
             "What means no reading means no coordinate, too (--skip-unplaced): such a text, a "
             "number where no degree can be it, and -999 or -9999 of both coordinates of a plane.");
}

std::string csv_section() {
  return ".SH CSV FILES\n" +
         roff_paragraph(
             "How a CSV is written is found out file by file, from its first 64 kB (from a pipe: "
             "from what comes up to the end of its first row of data), and said in one notice "
             "where that is not with commas, decimal points and in UTF-8. The separator is a "
             "comma, "
             "a semicolon, a tab, a bar, or blanks; a first line such as sep=; names it. Numbers "
             "have decimal commas where one of them cannot be anything else and none has a point; "
             "1,234 alone may be 1.234 or 1234, and is an error. UTF-16 is known by its mark; "
             "other "
             "encodings are named, by --encoding. What contradicts later is an error.") +
         ".PP\n" +
         roff_paragraph(
             "Passed over are lines before the header that begin with # (unless the last names the "
             "columns below it); a preamble, where the first line looks like no header and a later "
             "one has a known name; below the header rows of units, and of formats such as 5s 15s; "
             "blanks round fields; rows without any value; columns at the end that have neither a "
             "name nor values, or are called eor; empty fields behind the last column; a first "
             "column without a name where another one "
             "is the time. Where --time-field, or --id, --x and --y, are numbers that the first "
             "row "
             "does not have as names, the file has no header, and columns are counted from 1.");
}

std::string files_section() {
  return ".SH SEVERAL FILES OF READINGS\n" +
         roff_paragraph(
             "--rainfall, repeated, stands in place of RAINFALL, and a folder stands for its files "
             "of a format that is read (.csv, .txt, .xlsx, .zip, .csv.gz and the like; or .dly "
             "alone, where it has any). Each is read by itself, wide or long and with times in its "
             "own form, and all are joined by the calendar and by station: a file a year, a file a "
             "station. A file that has no column of stations, and none that is called as one, is "
             "of the station that its name tells: the whole name without its extension, or a part "
             "of it between _, -, . and blanks. Readings that stand in several files alike count "
             "once, and a notice says how many; where they differ, the error names both places. "
             "Steps come in the order of time, after all files have been read. What else lies in a "
             "folder is passed over with a notice that names it: folders, other kinds of files, an "
             "agency's list of stations, and texts without any row of as many fields as their "
             "first, such as a readme.txt. So are the files that are given as STATIONS and BASINS, "
             "unless they are surely tables of readings too, and, of several files however they "
             "are named, those of a known format that hold no rain. Where SWAT+'s pcp.cli or "
             "ArcSWAT's list of gauges lies in a folder, the files that it names are read by it.") +
         roff_paragraph(
             "A .zip may hold several tables, as agencies ship readings with what tells of them: "
             "the one of a known format is read, or the only one that is a table at all, and a "
             "notice names it as /vsizip/FILE.zip/NAME. Any other can be named so.");
}

std::string database_section() {
  return ".SH TABLES IN POSTGIS\n" +
         roff_paragraph(
             "STATIONS, BASINS and RAINFALL may be PG:... (what libpq takes: dbname=rain host=db, "
             "or "
             "a URI), with the table named by --stations-layer, --basins-layer and "
             "--rainfall-layer. cells, weights and rain write into a database where their output "
             "is "
             "PG:...: into the table cells, weights or rain, or the one that --output-layer names "
             "(NAME, or SCHEMA.NAME). A table appears whole, in one transaction, or not at all. "
             "Cells have a column geom, in the basins' CRS by its EPSG code, with an index; rain "
             "has the rows of --long. A table that is there is replaced only with --overwrite, and "
             "only where its comment begins with the name of this program, which every table that "
             "it makes has; all others are never dropped.");
}

std::string feed_section() {
  return ".SH READINGS FROM A PIPE\n" +
         roff_paragraph(
             "Where rain reads a pipe (- or a named pipe) and writes to standard output or a pipe, "
             "each row is written as its step comes, within a second, and messages are told as "
             "they arise. A wide step is there with its row; a long one once each station "
             "has a row of it, or a row of another time has come, and the pipe has rested for a "
             "quarter of a second (a twentieth, once it is held for half a second); so that a last "
             "long step in which a station lacks is written when the pipe ends. A pipe without "
             "such a rest, as from a file, is sorted at its end, in whatever "
             "order its rows are; so is one whose times come back before anything was written, and "
             "a warning says so. Once rows were written, a time that does not go on in their order "
             "is an error (but with --append, see there); in a wide table one that comes twice in "
             "a row is one at once, others "
             "are when the pipe ends. What is wrong ends the run as soon as nothing more comes "
             "for a quarter of a second; the rows before it are written. With --every a period is "
             "written when another begins; what it lacks is counted by the step that the times so "
             "far tell, and so are rates, such as mm/h, for which a later time that is not whole "
             "steps from the one before is an error. Outputs that are files appear in the end, "
             "whole.") +
         ".SH ADDING TO A TABLE\n" +
         roff_paragraph(
             "rain --append adds to the table that -o names the steps that it lacks, behind those "
             "that it has and in the order of RAINFALL, and a notice says how many were added and "
             "how many were there. Steps are told by their moment where times are of ISO 8601, "
             "else by their text; the columns have to be the same. A step that is there stays as "
             "it is: a warning says where its values are others by more than one of the last "
             "decimal, and another where a step is added that lies before the last one. A last "
             "line that is cut off, as where a writer was ended, is taken off and written anew; "
             "one that lacks nothing but its line end, and whose step RAINFALL does not have, is "
             "an error. With --every the last period is added once it is whole: when it lacks no "
             "step, or another has begun. The table is replaced whole or not at all, and locked "
             "meanwhile: another run waits five seconds for it. From a pipe each row is added in "
             "place as it comes, and what was added before a failure stays; a step that the pipe "
             "brings again, as a logger does that sends anew, is passed over, and so is a row of a "
             "long table whose step is written: a warning says where its readings are others. With "
             "--cumulative the first step of a run has no value, so let each run begin with the "
             "last step of the one before, which is there; else that step is added without one, "
             "and a warning says so. The gauges that make "
             "the network are those of RAINFALL: where that is of a day, renormalised and strict "
             "values may differ from those of the whole series.");
}

std::string models_section() {
  const auto entry = [](const char* name, const char* text) {
    return ".TP\n" + roff_bold(name) + "\n" + roff_paragraph(text);
  };
  return ".SH FILES FOR MODELS\n" +
         roff_paragraph(
             "--format writes weights or a series as the next model reads it, under any name. "
             "What a format cannot hold is an error: times that are none of the calendar, steps of "
             "no "
             "one length or of months (but in NetCDF and PI-XML), times that go back (but in "
             "NetCDF), ids that the model cannot read. What has to be assumed is said. "
             "Steps that lack between others are written as missing, with a warning; --decimals "
             "counts for values as text. A series is written when all of RAINFALL has been read, "
             "from a pipe too; steps wait in a temporary file, or are in the NetCDF already.") +
         entry("weights --format hms",
               "A whole .met of HEC-HMS of Weighted Gages: gages are called as the stations, "
               "subbasins as the basins, and a gage's weight counts for depth and for time. It "
               "goes into a project as a further meteorologic model; its basin model is chosen "
               "there. The weights are those of all stations, as HEC-HMS has one set of them, "
               "whatever gauges are silent.") +
         entry(
             "weights --format raven",
             "Raven's :GaugeWeightTable, a row a basin with the weight of every station, 0 too, "
             "in the order of the files: so have the HRUs and the gauges of the model to stand.") +
         entry("rain --format netcdf",
               "Time series by CF 1.8 (featureType = timeSeries): rainfall(basin, time), "
               "basin_id, lat and lon of the basins' centroids (x and y in a plane without a "
               "CRS), time with time_bnds by --stamp, and with --error standard_error beside it. "
               "--units says what readings of no known unit are in.") +
         entry("rain --format hype",
               "HYPE's Pobs.txt in mm a step, dated by its beginning; ids are whole numbers, "
               "missing values -9999.") +
         entry("rain --format swat",
               "SWAT+: -o is a folder with pcp.cli and BASIN.pcp, in mm a day, with latitude and "
               "longitude of the basin's centroid and an elevation of 0, for it is not known; "
               "missing values are -99.0. Shorter steps are summed with --every day.") +
         entry("rain --format swmm",
               "A rain file of SWMM, ID year month day hour minute value, dated by the step's "
               "beginning; a step without a line is dry, so that a missing value is an error. "
               "What [RAINGAGES] has to say of it is told in a notice.") +
         entry("rain --format pi-xml",
               "Delft-FEWS's PI-XML: a series a basin, location the basin's id, parameter P, with "
               "events at the end of each step, timeZone that of the times, else 0, and missVal "
               "-999.0. Times in several zones are brought to the first one's.") +
         ".PP\n" +
         roff_paragraph(
             "Not written are HEC-DSS, .xlsx and MIKE's dfs0, whose libraries are no part of this "
             "program. HEC-DSSVue imports rain.csv; ogr2ogr -f XLSX rain.xlsx rain.csv makes a "
             "spreadsheet, which opens rain.csv too; MIKE Zero's time series editor imports text, "
             "and the Python package mikeio makes a dfs0 of what --format netcdf writes, read by "
             "xarray.");
}

std::string times_section() {
  return ".SH TIMES\n" +
         roff_paragraph(
             "Times of ISO 8601 are read, and those that can be read in one way only: 2010/12/31, "
             "31.12.2010, 12/31/2010 6:00 PM, 31-Dec-2010, 01JAN2000, Dec 31, 2010, 2010123109, "
             "201012310930, the day of a year 2010-365, each with a clock (06:00, "
             "0600, 24:00, 2400) and a zone (UTC, GMT, Z, "
             "+0100) or without; and the months Dec 2010 and 2010 December. Whether the day or the "
             "month stands first is told by a day above "
             "12 in the first 64 kB; where there is none, 01/02/2010 is an error that shows both "
             "readings where a calendar is needed, and a label elsewhere; what contradicts later "
             "is "
             "an error. --time-format tells any other form, as strptime(3) has it: %d %m %Y %y %b "
             "%j %H %M %S %I %p %z %Z and the like, with English names of months; excel reads the "
             "serial numbers of spreadsheets from 1 March 1900 on.") +
         ".PP\n" +
         roff_paragraph(
             "A time may stand in several columns: year, month and day, or year and day of the "
             "year (doy), with hour, minute and second or a clock behind them or without, and year "
             "and month alone, are found by these names, and so are a date and, in a column called "
             "time, hour or the like, its clock, where the first row has these; that is said. "
             "--time-field, repeated, names any, whose texts are put together with blanks between. "
             "Where a column seems to be of the time (week, dekad), or holds something else than "
             "its name says, the error names the options that read it, and --ignore-unknown does "
             "not pass over it.") +
         ".PP\n" +
         roff_paragraph(
             "A time with a clock begins its step, or with --stamp end ends it: then midnight "
             "belongs to the day before it, and the bounds in a .nc lie before their times. A date "
             "without a clock is the whole day either way. --from and --to are about times as they "
             "are written.") +
         ".PP\n" +
         roff_paragraph(
             "Any other text is a label, whose step has no place in the calendar. But where the "
             "file begins with times and most of its first ones are such, a text among them (Total "
             "below the last row) is an error; a row that has neither a time nor a reading is "
             "passed over with a notice.");
}

std::string units_section() {
  return ".SH UNITS AND RATES\n" +
         roff_paragraph(
             "A unit is believed that stands below the name of the column of values, in it, in a "
             "column called unit, uom or the like, behind the ids in the header of a wide table "
             "where all "
             "have the same (A (in), A_in), or else in a line above the header (Units: "
             "inches; Daily rainfall in mm); rows of several units are an error. Rates are depths "
             "by a time: mm/h, mm h-1, inches per day, mm/15min, kg m-2 s-1; those by the second "
             "are taken to the hour.") +
         ".PP\n" +
         roff_paragraph(
             "Totals (--every) of rates count each value times the length of its step, which is "
             "that of the file's regular steps, months and years as the calendar has them, and a "
             "notice says so. Where there is none, or RAINFALL is a pipe, that is an error: "
             "--scale "
             "makes depths of rates, and --from-unit mm says that they are depths.");
}

/// What is known of a published format, as the manual says it.
std::string format_entry(const PublishedFormat& format) {
  std::string text = "rain is " + std::string(format.kept.empty() ? format.value : format.kept);
  if (format.unit_is_ordered) text += ", whose unit --from-unit has to say";
  if (!format.unit.empty()) text += ", in " + std::string(format.unit);
  text += format.station.empty() ? std::string("; a file is of one station, which ") +
                                       (format.label.empty() ? "" : "it or ") + "its name tells"
                                 : "; stations are in " + std::string(format.station);
  if (format.ids_as_numbers) text += ", compared as numbers";
  if (!format.missing.empty()) text += "; missing: " + std::string(format.missing);
  if (!format.trace.empty()) text += "; " + std::string(format.trace) + " is a trace";
  if (!format.flags.empty()) text += "; a flag in " + std::string(format.flags) + " means missing";
  if (!format.encoding.empty()) text += "; in " + std::string(format.encoding) + " or UTF-8";
  if (format.is_of_basins) text += "; means over the basins of river gauges, with a warning";
  if (!format.marks.empty())
    text += "; values whose " + std::string(format.marks) + " is not 0 are counted, and told by " +
            "the publisher's key";
  if (!format.trace_marks.empty())
    text += ", those of " + std::string(format.trace_marks) + " are traces";
  if (!format.models.empty()) text += "; values of weather models are counted, with a warning";
  if (format.times_end_steps)
    text +=
        "; times end their steps, and hours without a row are dry, but in periods that its "
        "flags say are missing or summed";
  if (!format.period.empty()) text += "; amounts of several days are missing";
  return ".TP\n" + roff_bold(std::string(format.name)) + "\n" + roff_paragraph(as_sentence(text));
}

std::string formats_section() {
  std::string text =
      ".SH PUBLISHED FORMATS\n" +
      roff_paragraph(
          "These are known by their content and read without an option; a notice says what a file "
          "was taken for. Where --value-field names another column of values than the format's "
          "own, "
          "what is known of the format does not count, with a warning. As STATIONS "
          "GHCN-Daily's and DWD's lists of stations and SWAT's files are known, and USGS's sites "
          "by the names of their columns. Where a file is of one station that no column tells, the "
          "lines above its header or its name do, of a single file too.");
  for (const PublishedFormat& format : known_formats()) text += format_entry(format);
  return text + ".TP\n" + roff_bold("NetCDF of stations") + "\n" +
         roff_paragraph(
             "By CF, with featureType = timeSeries: rain is the variable whose standard name or "
             "name is rain's, or that --value-field names, in the unit that it says; as STATIONS "
             "too. Arrays may be of one time for all stations, of one a station, or ragged. Where "
             "times have bounds, these say whether they begin or end their steps, and --stamp may "
             "not say otherwise; where they do neither, as in the middle, the beginning of its "
             "bounds stands for each. Times are counted in days, hours, minutes or seconds; a "
             "zone behind their origin other than UTC is written with each. What lies outside "
             "valid_range, valid_min or valid_max is missing, with a warning.");
}

}  // namespace

std::string files_sections() {
  return csv_section() + files_section() + feed_section() + database_section() + models_section() +
         times_section() + units_section() + names_section() + formats_section();
}

}  // namespace thiessen::cli
