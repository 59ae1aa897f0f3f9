// User text in the languages of other programs.
#include "diag/encode.hpp"

#include <nlohmann/json.hpp>

#include "support/catch.hpp"

namespace symplant::test {
namespace {

const std::string kAll = "</script><img src=x onerror=\"a('&')\">]]>--\\N\\n;#35;%%\xE2\x80\xAE\x1B\n\t{}";

TEST_CASE("In HTML, SVG and XML no character of user text is markup") {
  CHECK(diag::markup_text("a<b & 'c' > \"d\"") == "a&lt;b &amp; &#39;c&#39; &gt; &quot;d&quot;");
  CHECK(diag::markup_text("\xEA\xB3\xB5 \xC3\x84") == "\xEA\xB3\xB5 \xC3\x84");
  CHECK(diag::markup_text("\x01\xE2\x80\xAE\xEF\xBF\xBE") == "&lt;U+0001&gt;&lt;U+202E&gt;&lt;U+FFFE&gt;");
  CHECK(diag::markup_text(kAll).find_first_of("<>\"'\n\t\x1B") == std::string::npos);
}

TEST_CASE("JSON in a script is the same document, and cannot end the element") {
  const nlohmann::json document{{kAll, {"<!--", "\xE2\x80\xA8\xE2\x80\xA9", "\xEA\xB3\xB5"}}};
  const std::string text = diag::script_json(document.dump());
  CHECK(nlohmann::json::parse(text) == document);
  CHECK(text.find_first_of("<>&") == std::string::npos);
  CHECK(text.find("\xE2\x80\xA8") == std::string::npos);
}

TEST_CASE("A Graphviz string ends correctly, and contains no escapes or entities of the user") {
  CHECK(diag::dot_string("a\"b\\N&lt;") == "\"a\\\"b\\\\N&amp;lt;\"");
  CHECK(diag::dot_string("a\nb") == "\"a<U+000A>b\"");
}

TEST_CASE("A Mermaid text is one description, whatever it contains") {
  CHECK(diag::mermaid_text("O_P2, takes 1.5 s") == "O_P2, takes 1.5 s");
  CHECK(diag::mermaid_text("a:b;\"c\"#d<e>{f}%[g]") == "a#58;b#59;#34;c#34;#35;d#60;e#62;#123;f#125;#37;#91;g#93;");
  CHECK(diag::mermaid_text("\xEA\xB3\xB5") == "\xEA\xB3\xB5");
  CHECK(diag::mermaid_text(kAll).find_first_of("<>\"\n\t\x1B{}%[]:") == std::string::npos);
}

}  // namespace
}  // namespace symplant::test
