// The fuzzer's short form: hundreds of random inputs, without libFuzzer.

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzzers/fuzzers.h"
#include "fuzzers/random_inputs.h"

namespace thiessen::fuzzers {
namespace {

using namespace std::literals;

constexpr std::array sound = {
    "# "
    "remark\nagency_cd\tsite_no\tdatetime\ttz_cd\t2_00045\t2_00045_cd\n5s\t15s\t20d\t6s\t14n\t10s\n"
    "USGS\t0214\t2024-03-10 01:45\tEST\t0.10\tP\nUSGS\t0214\t2024-03-10 03:00\tEDT\tEqp\tP\n"sv,
    "Station  a,b,\nLati    35.0 35.0\nLong   -81.5-81.0\nElev     200  250\n"
    "2000059000.5012.0\n2000060-99.0003.0\n"sv,
    "a.pcp\nnbyr tstep lat long elev\n1 0 35.0 -81.5 200.0\n2001 365 0.5\n2002 1 -99.0\n"sv,
    "ID,DATE,ELEMENT,DATA_VALUE,M_FLAG,Q_FLAG,S_FLAG,OBS_TIME\nA,20200101,PRCP,254,,,7,\n"
    "A,20200102,PRCP,99,,G,7,0700\nA,20200102,TMAX,99,,,7,\n"sv,
    "STATIONS_ID;MESS_DATUM;QN_8;  R1;RS_IND;WRTR;eor\n  164;2024060107; 3; 0.4; 1;-999;eor\n"
    "  164;2024060108; 3; -999; 1;-999;eor\n"sv,
    "EstacaoCodigo;NivelConsistencia;Data;Chuva01;Chuva02;Chuva03;Chuva04;Chuva05;Chuva06;Chuva07;"
    "Chuva08;Chuva09;Chuva10;Chuva11;Chuva12;Chuva13;Chuva14;Chuva15;Chuva16;Chuva17;Chuva18;"
    "Chuva19;Chuva20;Chuva21;Chuva22;Chuva23;Chuva24;Chuva25;Chuva26;Chuva27;Chuva28;Chuva29;"
    "Chuva30;Chuva31\n7;1;01/02/2020;1;2;3;4;5;6;7;8;9;10;11;12;13;14;15;16;17;18;19;20;21;22;23;"
    "24;25;26;27;28;29;;\n"sv,
    "20000228\n0.5\n-99\n10.0\n"sv,
    "REGIAO:;CO\nUF:;DF\nESTA\xC7\xC3O:;OESTE\nCODIGO (WMO):;A901\nData;Hora "
    "UTC;PRECIPITA\xC7\xC3O "
    "TOTAL, HOR\xC1RIO (mm);VENTO;\n2019/01/01;0000 UTC;,8;1,8;\n2019/01/01;0100 UTC;-9999;1;\n"sv,
    "Station Name: WEST\nStation Height: 71 M \n\ndate:  -  00 to 00 "
    "utc\n\ndate,ind,maxtp,ind,rain\n"
    "30-dec-2019,0,9.7,0,1.2\n01-jan-2020,0,10.0,8, \n"sv,
    "2019-12-30,4.1,1.0,7.2,2.4,,180,12.1,30.2,1010.1,\n2019-12-31,5.0,2.0,8.0,,,190,12.0,,1009.0,1\n"sv,
    "year,month,day,temp,temp_source,prcp,prcp_source\n2024,1,1,4.1,dwd_daily,2.4,dwd_mosmix\n"sv,
    "STATION,DATE,HPCP,Measurement Flag,Quality Flag\nA,20100101 01:00,0,g,\nA,20100101 "
    "05:00,99999,[,\nA,20100101 07:00,99999,],\nA,20100101 09:00,20,A,Q\n"sv,
    "45.00\n250.31\n2303950000\nYear Mnth Day Hr\tDayl(s)\tPRCP(mm/day)\tSRAD(W/m2)\n1999 12 31 "
    "12\t30172.51\t4.20\t153.40\n"sv,
    "Station  a,b,\nLati    35.0 35.0\nLong   -81.5-81.0\nElev     200  250\n"
    "200005900:00000.5012.0\n200005912:00-99.0003.0\n2000060     000.0000.0\n"sv};

TEST(PublishedFuzzer, finds_nothing_in_damaged_files) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(1200); ++round) {
    const std::string text = damaged(seeded, std::string(sound[round % sound.size()]), 4);
    const std::uint64_t wanted = round % sound.size() < 3     ? round % sound.size()
                                 : round % sound.size() == 6  ? 3
                                 : round % sound.size() == 12 ? 1  // SWAT's once more
                                                              : 4;
    expect_no_complaint(fuzz_published, input_of({wanted}, text));
    if (HasFailure()) return;
  }
}

TEST(PublishedFuzzer, finds_nothing_in_random_bytes) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(200); ++round) {
    expect_no_complaint(fuzz_published, any_bytes(seeded, 300));
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thiessen::fuzzers
