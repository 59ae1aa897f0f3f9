// Splits texts of the table into words and bytes.
#include "words.hpp"

#include <sstream>
#include <stdexcept>

namespace symplant::conformance {

namespace {

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == text.npos ? "" : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

std::uint8_t byte_of(const std::string& digits) {
  std::size_t used = 0;
  const int value = std::stoi(digits, &used, 16);
  if (used != 2) throw std::runtime_error("`" + digits + "` is no byte");
  return static_cast<std::uint8_t>(value);
}

/// Whether objects (number, length, text) fill the PDU from `begin` on; the byte before them gives their count.
bool are_objects(const Bytes& pdu, std::size_t begin) {
  std::size_t at = begin;
  std::size_t count = 0;
  for (int last = -1; at + 2 <= pdu.size(); at += 2U + pdu[at + 1], ++count) {
    if (pdu[at] <= last || pdu[at + 1] == 0) return false;
    last = pdu[at];
  }
  return at == pdu.size() && begin > 0 && pdu[begin - 1] == count;
}

}  // namespace

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> result;
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

std::vector<std::string> split(const std::string& text, std::string_view separator) {
  std::vector<std::string> result;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != text.npos; begin = end + separator.size()) {
    end = text.find(separator, begin);
    result.push_back(trimmed(text.substr(begin, end == text.npos ? end : end - begin)));
  }
  return result;
}

std::uint32_t address_of(const std::string& word, const Sizes& sizes) {
  if (word.front() != '{') return static_cast<std::uint32_t>(std::stoul(word));
  const std::size_t table = std::string("CDHI").find(word.at(1));
  if (table == std::string::npos) throw std::runtime_error("`" + word + "` names no table");
  const int less = word.size() > 3 ? std::stoi(word.substr(2)) : 0;
  return sizes[table] + static_cast<std::uint32_t>(less);
}

Pattern pattern(const std::string& text, const Sizes& sizes) {
  Pattern result;
  for (const std::string& word : words(text)) {
    if (result.objects) throw std::runtime_error("objects end a pattern");
    if (word == "any") {
      result.bytes.emplace_back();
    } else if (word == "objects") {
      result.objects = true;
    } else if (word.front() == '{') {
      const std::uint32_t number = address_of(word, sizes);
      result.bytes.emplace_back(static_cast<std::uint8_t>(number >> 8));
      result.bytes.emplace_back(static_cast<std::uint8_t>(number & 0xFF));
    } else if (const std::size_t star = word.find('*'); star != word.npos) {
      result.bytes.insert(result.bytes.end(), std::stoul(word.substr(star + 1)), byte_of(word.substr(0, star)));
    } else {
      for (std::size_t i = 0; i < word.size(); i += 2) result.bytes.emplace_back(byte_of(word.substr(i, 2)));
    }
  }
  return result;
}

bool Pattern::matches(const Bytes& pdu) const {
  if (objects ? pdu.size() < bytes.size() : pdu.size() != bytes.size()) return false;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] && *bytes[i] != pdu[i]) return false;
  }
  return !objects || are_objects(pdu, bytes.size());
}

Bytes Pattern::plain() const {
  Bytes result;
  for (const auto& byte : bytes) {
    if (!byte || objects) throw std::runtime_error("bytes to send must be given");
    result.push_back(*byte);
  }
  return result;
}

std::string hex(const Bytes& bytes) {
  constexpr std::size_t kShown = 12;
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text;
  for (std::size_t i = 0; i < bytes.size() && i < kShown; ++i) {
    if (i != 0) text += ' ';
    text += kDigits[bytes[i] >> 4];
    text += kDigits[bytes[i] & 15];
  }
  if (bytes.size() > kShown) text += " ...";
  return text;
}

}  // namespace symplant::conformance
