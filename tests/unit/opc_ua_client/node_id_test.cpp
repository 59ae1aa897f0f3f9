// Node ids of OPC UA as texts, their templates, and the URI in a certificate.
#include "symplant/link/opc_ua/node_id.hpp"

#include "support/catch.hpp"
#include "symplant/link/opc_ua/application_uri.hpp"

using namespace symplant::link::opc_ua;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("A node id has a namespace by number or URI, a kind and an identifier") {
  CHECK(parse_node_id("ns=3;s=\"IO\".\"START\"") == NodeId{"", 3, 's', "\"IO\".\"START\""});
  CHECK(parse_node_id("i=2258") == NodeId{"", 0, 'i', "2258"});
  CHECK(parse_node_id("nsu=urn:a=b;i=7") == NodeId{"urn:a=b", 0, 'i', "7"});
  CHECK(parse_node_id("ns=1;g=01234567-89ab-cdef-0123-456789ABCDEF"));
  CHECK(parse_node_id("ns=1;b=AQID"));
  CHECK(parse_node_id("s=a;b=c") == NodeId{"", 0, 's', "a;b=c"});
}

TEST_CASE("A text that is not a node id is found out") {
  for (const char* text :
       {"", "START", "ns=3", "ns=3;", "ns=65536;s=a", "ns=;s=a", "nsu=;s=a", "ns=3;s=", "ns=3;x=1", "i=", "i=-1",
        "i=4294967296", "i=1a", "g=0123", "g=01234567-89ab-cdef-0123-456789ABCDEG", "b=AQI", "b=A===", "b=A*ID"}) {
    CAPTURE(text);
    CHECK(!parse_node_id(text));
  }
}

TEST_CASE("The text of a node id is read as the same one") {
  for (const char* text :
       {"ns=3;s=\"A\"", "i=85", "nsu=http://plc/tags;s=A", "ns=2;g=01234567-89ab-cdef-0123-456789abcdef"}) {
    CHECK(node_id_text(*parse_node_id(text)) == text);
  }
}

TEST_CASE("A template gets the symbol's name and address") {
  CHECK(fill_template("ns=3;s=\"{symbol}\"", "A", "%QX0") == "ns=3;s=\"A\"");
  CHECK(fill_template("s={address}.{symbol}.{symbol}", "A", "%QX0") == "s=%QX0.A.A");
  CHECK(fill_template("s={symbol}", "{address}", "%QX0") == "s={address}");
}

TEST_CASE("A template of node ids says what is wrong with it") {
  CHECK(template_problem("ns=3;s=\"{symbol}\"").empty());
  CHECK(template_problem("ns=2;i={address}").empty());
  CHECK_THAT(template_problem("{symbol}"), ContainsSubstring("write a node id, such as ns=3;s="));
  CHECK_THAT(template_problem("ns=3;s={adress}"),
             ContainsSubstring("`{adress}` is not known: use {symbol} and {address}"));
}

TEST_CASE("The URI of an application is found in its certificate, and a broken one has none") {
  using namespace std::string_literals;
  // ... 2.5.29.17, OCTET STRING { SEQUENCE { DNS "ab", URI "urn:x" } }
  const std::string names = "\x30\x0B\x82\x02"s + "ab" + "\x86\x05" + "urn:x";
  const std::string certificate = "\x30\x82\x01\x00\x06\x03\x55\x1D\x11\x04\x0D"s + names;
  CHECK(application_uri_of(certificate) == "urn:x");
  const std::string critical = "\x06\x03\x55\x1D\x11\x01\x01\xFF\x04\x0D"s + names;
  CHECK(application_uri_of(critical) == "urn:x");
  CHECK(application_uri_of("").empty());
  for (std::size_t length = 0; length < certificate.size(); ++length) {
    CAPTURE(length);
    CHECK(application_uri_of(certificate.substr(0, length)).empty());
  }
}
