#include "loaders/xml/xml_text.h"

#include <algorithm>
#include <charconv>
#include <sstream>

namespace f1tenth_sim2d
{
namespace
{
/// Copies an XML text and repairs what is between "<" and ">".
class XmlRepair
{
public:
  explicit XmlRepair(const std::string & text) : text_(text) {}

  std::string result()
  {
    while (at_ < text_.size()) {
      if (startsWith("<!--")) {
        copyThrough("-->");
      } else if (startsWith("<![CDATA[")) {
        copyThrough("]]>");
      } else if (startsWith("<?")) {
        blankThrough("?>");
      } else if (text_[at_] == '<') {
        copyTag();
      } else {
        copyOne();
      }
    }
    return std::move(result_);
  }

private:
  bool startsWith(const char * mark) const
  {
    return text_.compare(at_, std::char_traits<char>::length(mark), mark) == 0;
  }

  void copyOne() { result_ += text_[at_++]; }

  std::size_t endOf(const char * mark) const
  {
    const std::size_t found = text_.find(mark, at_);
    return found == std::string::npos ? text_.size() : found + std::char_traits<char>::length(mark);
  }

  void copyThrough(const char * mark)
  {
    const std::size_t end = endOf(mark);
    result_.append(text_, at_, end - at_);
    at_ = end;
  }

  void blankThrough(const char * mark)
  {
    for (const std::size_t end = endOf(mark); at_ < end; ++at_) {
      result_ += text_[at_] == '\n' ? '\n' : ' ';
    }
  }

  void copyTag()
  {
    while (at_ < text_.size() && text_[at_] != '>') {
      const bool is_assignment = text_[at_] == '=';
      copyOne();
      if (is_assignment) {
        copyValue();
      }
    }
  }

  void copyValue()
  {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
      copyOne();
    }
    if (at_ < text_.size() && (text_[at_] == '"' || text_[at_] == '\'')) {
      const char quote[] = {text_[at_], '\0'};
      copyOne();
      copyThrough(quote);
      return;
    }
    result_ += '"';
    while (at_ < text_.size() && text_.find_first_of(" \t\r\n>", at_) != at_ && !startsWith("/>")) {
      copyOne();
    }
    result_ += '"';
  }

  const std::string & text_;
  std::size_t at_{0};
  std::string result_;
};
}  // namespace

std::vector<std::string> wordsIn(const std::string & text)
{
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.push_back(word);
  }
  return words;
}

std::optional<double> numberIn(const std::string & text)
{
  const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char * const end = text.data() + text.size();
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data() + (has_plus ? 1 : 0), end, value);
  return error == std::errc() && stop == end ? std::optional<double>(value) : std::nullopt;
}

std::optional<std::vector<double>> numbersIn(const std::string & text)
{
  std::vector<double> numbers;
  for (const std::string & word : wordsIn(text)) {
    const std::optional<double> number = numberIn(word);
    if (!number) {
      return std::nullopt;
    }
    numbers.push_back(*number);
  }
  return numbers;
}

std::string repairedXml(const std::string & text)
{
  return XmlRepair(text).result();
}
}  // namespace f1tenth_sim2d
