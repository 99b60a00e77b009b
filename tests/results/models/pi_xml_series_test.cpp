#include "results/models/pi_xml_series.h"

#include "results/models/model_subject.h"

namespace thiessen {
namespace {

TEST(PiXmlSeries, has_a_series_a_basin_with_events_at_the_end_of_steps) {
  EXPECT_EQ(
      series_text<PiXmlSeries>(subject_of({"a&\"b\"", "c"}),
                               {{"2020-01-01T00:00Z", {1, 2}}, {"2020-01-01T06:00Z", {none, 4}}}),
      R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- thiessen 9; tolerance: 0.1 -->
<TimeSeries xmlns="http://www.wldelft.nl/fews/PI" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:schemaLocation="http://www.wldelft.nl/fews/PI http://fews.wldelft.nl/schemas/version1.0/pi-schemas/pi_timeseries.xsd" version="1.2">
  <timeZone>0.0</timeZone>
  <series>
    <header>
      <type>accumulative</type>
      <locationId>a&amp;&quot;b&quot;</locationId>
      <parameterId>P</parameterId>
      <timeStep unit="second" multiplier="21600"/>
      <startDate date="2020-01-01" time="06:00:00"/>
      <endDate date="2020-01-01" time="12:00:00"/>
      <missVal>-999.0</missVal>
      <units>mm</units>
    </header>
    <event date="2020-01-01" time="06:00:00" value="1.000"/>
    <event date="2020-01-01" time="12:00:00" value="-999.0"/>
  </series>
  <series>
    <header>
      <type>accumulative</type>
      <locationId>c</locationId>
      <parameterId>P</parameterId>
      <timeStep unit="second" multiplier="21600"/>
      <startDate date="2020-01-01" time="06:00:00"/>
      <endDate date="2020-01-01" time="12:00:00"/>
      <missVal>-999.0</missVal>
      <units>mm</units>
    </header>
    <event date="2020-01-01" time="06:00:00" value="2.000"/>
    <event date="2020-01-01" time="12:00:00" value="4.000"/>
  </series>
</TimeSeries>
)");
}

std::string events(const ModelSubject& subject, const std::vector<GivenStep>& steps,
                   Warnings& told) {
  const std::string text = series_text<PiXmlSeries>(subject, steps, told);
  std::string found;
  for (std::size_t at = text.find("<event "); at != std::string::npos;
       at = text.find("<event ", at + 1)) {
    const std::string date = text.substr(text.find("date=\"", at) + 6, 10);
    found += date + ' ' + text.substr(text.find("time=\"", at) + 6, 8) + '\n';
  }
  return found + text.substr(text.find("<timeStep"),
                             text.find("/>", text.find("<timeStep")) - text.find("<timeStep"));
}

TEST(PiXmlSeries, of_times_that_end_their_steps_has_them_as_they_are) {
  Warnings told;
  ModelSubject subject = subject_of({"a"});
  subject.stamp = Stamp::end;
  EXPECT_EQ(events(subject, {{"2020-01-01T06:00", {1}}, {"2020-01-01T12:00", {1}}}, told),
            "2020-01-01 06:00:00\n2020-01-01 12:00:00\n<timeStep unit=\"second\" "
            "multiplier=\"21600\"");
  ASSERT_EQ(told.notices().size(), 1);
  EXPECT_EQ(told.notices()[0].sentence(),
            "out: the times have no zone, and PI-XML has one: timeZone is 0.0");
}

TEST(PiXmlSeries, of_months_is_not_equidistant_and_ends_with_them) {
  Warnings told;
  EXPECT_EQ(events(subject_of({"a"}), {{"2020-01", {1}}, {"2020-02", {1}}, {"2020-04", {1}}}, told),
            "2020-02-01 00:00:00\n2020-03-01 00:00:00\n2020-05-01 00:00:00\n"
            "<timeStep unit=\"nonequidistant\"");
}

TEST(PiXmlSeries, of_no_one_length_lasts_until_the_next_and_says_so) {
  Warnings told;
  EXPECT_EQ(
      events(subject_of({"a"}),
             {{"2020-01-01T00:00Z", {1}}, {"2020-01-01T02:00Z", {1}}, {"2020-01-01T05:00Z", {1}}},
             told),
      "2020-01-01 02:00:00\n2020-01-01 05:00:00\n2020-01-01 08:00:00\n"
      "<timeStep unit=\"nonequidistant\"");
  ASSERT_EQ(told.notices().size(), 1);
  EXPECT_TRUE(contains(told.notices()[0].sentence(), "each lasts until the next"));
}

TEST(PiXmlSeries, is_in_the_zone_of_its_first_time_and_fills_what_lacks) {
  Warnings told;
  const std::string text = series_text<PiXmlSeries>(subject_of({"a"}),
                                                    {{"2020-03-29T00:00+01:00", {1}},
                                                     {"2020-03-29T01:00+01:00", {2}},
                                                     {"2020-03-29T03:00+02:00", {3}},
                                                     {"2020-03-29T05:00+02:00", {4}}},
                                                    told);
  EXPECT_TRUE(contains(text, "<timeZone>1.0</timeZone>"));
  EXPECT_TRUE(contains(text, "time=\"03:00:00\" value=\"3.000\""));
  EXPECT_TRUE(contains(text, "time=\"04:00:00\" value=\"-999.0\""));
  EXPECT_TRUE(contains(text, "time=\"05:00:00\" value=\"4.000\""));
  EXPECT_TRUE(contains(sentences_of(told).at(0), "1 step lacks between others"));
}

TEST(PiXmlSeries, of_a_rate_is_a_mean) {
  ModelSubject subject = subject_of({"a"});
  subject.unit = "mm/h";
  subject.made_by.plane = "+proj=x --y";
  const std::string text = series_text<PiXmlSeries>(subject, {{"2020-01-01", {1}}});
  EXPECT_TRUE(contains(text, "<type>mean</type>"));
  EXPECT_TRUE(contains(text, "<units>mm/h</units>"));
  EXPECT_TRUE(contains(text, "+proj=x - -y"));
}

TEST(PiXmlSeries, refuses_ids_with_control_characters) {
  EXPECT_TRUE(
      contains(series_fault<PiXmlSeries>(subject_of({"a\tb"}), {}), "is no location of PI-XML"));
}

}  // namespace
}  // namespace thiessen
