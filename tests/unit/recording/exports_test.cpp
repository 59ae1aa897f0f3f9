// Files as the documents of vendors show them.
#include "recording_support.hpp"

namespace symplant::test {
namespace {

// Beckhoff Infosys, TE13xx TC3 Scope View, "Export to csv", and the older page "Scope Settings" with an example.
TEST_CASE("A text export of TwinCAT Scope is read: a column of times for each group of channels") {
  const std::string head = "Name\tScope01\nFile\tC:\\scope.svdx\nStarttime of export\t133238090039920000\tMonday\n\n";
  const std::string channels =
      "Name\tbClosed\tfPressure\tName\tbOpen\nSymbolComment\t\t\tSymbolComment\t\nData-Type\tBIT\tREAL64\tData-"
      "Type\tBIT\n"
      "SampleTime[ms]\t1\t1\tSampleTime[ms]\t10\nSymbolName\tMAIN.bClosed\tMAIN.fPressure\tSymbolName\tMAIN.bOpen\n"
      "Offset\t0\t0\tOffset\t0\nScaleFactor\t1\t1\tScaleFactor\t1\n\n";
  CHECK(csv(head + channels + "0\t0\t-1,5\t0\t1\n1\t1\t-1,25\t10\t0\n2\t1\t-1\t\t\nEOF\n") ==
        "MAIN.bClosed bool 0=0 1=1\nMAIN.fPressure number 0=-1.5 1=-1.25 2=-1\nMAIN.bOpen bool 0=1 10=0\n"
        "end 10, resolution 10\n");
  CHECK(csv("Name,bClosed,bOpen\n133238090039920000,0,1\n133238090039930000,1,1\n") ==
        "bClosed bool 0=0 1=1\nbOpen bool 0=1\nend 1, resolution 1\n");
}

// TIA Portal help, "The structure of a *.CSV file with tags (Panels, Comfort Panels, RT Advanced)".
TEST_CASE("A tag log of a Siemens panel is read with its exact times, and invalid rows are left out") {
  CHECK(csv("\"VarName\";\"TimeString\";\"VarValue\";\"Validity\";\"Time_ms\"\n"
            "\"Clamp\";\"01.04.98 11:02:52\";0,00;1;35886460322,81\n"
            "\"Level\";\"01.04.98 11:02:52\";66,50;1;35886460323,81\n"
            "\"Clamp\";\"01.04.98 11:02:55\";1,00;1;35886460358,73\n"
            "\"Clamp\";\"01.04.98 11:02:57\";0,00;0;35886460381,22\n"
            "\"$RT_COUNT$\";4;;;;\n") ==
        "Clamp bool 0=0 3103.49=1\nLevel number 86.4=66.5\nend 3103.49, resolution 86.4\n"
        "t.csv: rows left out, since their validity is 0: 1\n");
}

// MELSEC-L Series User's Manual (Data Logging Function), 3.3 "CSV File Output Format"; iQ-R, appendix 9.
TEST_CASE("A logging file of a Mitsubishi PLC is read without its columns for the log") {
  const std::string text =
      "[LOGGING],L1,3,4,5,2\nLOGGING TEST\n"
      "DATETIME[YYYY/MM/DD hh:mm:ss.s],INTERVAL,BIT[1;0],LONG[DEC.0],STEP NO.,PROGRAM NAME,INDEX,TRIGGER[*]\n"
      "TIME,INTERVAL[us],M0,D100,STEP NO.,PROGRAM NAME,INDEX,Trigger\n"
      "2010/1/10 14:25:34.0,0,1,0,10,MAIN,1,\n2010/1/10 14:25:34.5,500000,0,2,10,MAIN1,2,\n";
  const std::string wanted = "M0 bool 0=1 500=0\nD100 number 0=0 500=2\nend 500, resolution 500\n";
  CHECK(csv(text) == wanted);
  std::string wide = "\xFF\xFE";  // the Unicode text file of iQ-R
  for (const char c : text) wide += {c == ',' ? '\t' : c, '\0'};
  CHECK(csv(wide) == wanted);
}

// AVEVA Historian, "History Table Format".
TEST_CASE("Rows of the history of AVEVA Historian are read") {
  CHECK(csv("DateTime,TagName,Value,vValue,Quality,QualityDetail\n"
            "2017-02-17 15:40:01.0000000,Pump,0,0,0,192\n2017-02-17 15:40:01.5000000,Pump,1,1,0,192\n") ==
        "Pump bool 0=0 500=1\nend 500, resolution 500\n");
}

// NX-series Safety Control Unit User's Manual (Z930), 11-5 "Log File Specifications".
TEST_CASE("A safety data log of Omron NX is read up to its footer") {
  CHECK(csv("index,time,condition,Var1,Var3\n0,2020-06-01 10:00:00.100,0,1,500\n1,2020-06-01 10:00:00.110,1,0,501\n\n"
            "condition,VarX\nStopType,condition\n") ==
        "index bool 0=0 10=1\ncondition bool 0=0 10=1\nVar1 bool 0=1 10=0\nVar3 number 0=500 10=501\n"
        "end 10, resolution 10\nt.csv:5: what follows the empty line is left out: it is no row with a time\n");
}

}  // namespace
}  // namespace symplant::test
