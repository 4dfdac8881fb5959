#include "scree/config/yaml_text.hpp"

#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>

#include "scree/config/input_error.hpp"

namespace scree {
namespace {

constexpr std::size_t deepest = 16;            // levels of keys: more are a mistake, or an alias of itself
constexpr std::size_t most_entries = 20000;    // aliases of aliases grow without bound
constexpr std::size_t longest_list = 1000000;  // bytes of one value
constexpr char byte_order_mark[] = "\xef\xbb\xbf";

std::string place_of(const std::string& file, int line, int column) {
  return file + ":" + std::to_string(line + 1) + ":" + std::to_string(column + 1);
}

/// The line of a text, counted from 0.
std::string line_of(const std::string& text, int number) {
  std::size_t begin = 0;
  for (int line = 0; line < number; ++line) {
    begin = text.find('\n', begin);
    if (begin == std::string::npos) return "";
    ++begin;
  }
  return text.substr(begin, text.find('\n', begin) - begin);
}

/// yaml-cpp decodes UTF-16 and ends at some control characters without a word.
void check_characters(const std::string& text, const std::string& file) {
  const std::string start = text.substr(0, 2);
  if (start == "\xff\xfe" || start == "\xfe\xff" || text.find('\0') != std::string::npos)
    throw InputError("", "", "a text file in UTF-8; this one is binary or in UTF-16 or UTF-32", place_of(file, 0, 0));
  int line = 0, column = 0;
  for (const char c : text) {
    const bool allowed = static_cast<unsigned char>(c) >= 0x20 || c == '\t' || c == '\n' || c == '\r';
    if (!allowed) throw InputError("", "", "no control characters", place_of(file, line, column));
    column = c == '\n' ? 0 : column + 1;
    line += c == '\n';
  }
}

/// What yaml-cpp says, in words that help.
std::string reason(const YAML::Exception& error, const std::string& text) {
  const std::string line = line_of(text, error.mark.line);
  const std::size_t first = line.find_first_not_of(" \t");
  if (line.substr(0, first).find('\t') != std::string::npos)
    return "valid YAML: blanks in place of the tab that indents this line";
  static const std::map<std::string, std::string> known{
      {"end of map flow not found", "a '}' or ',' here, for a '{' before it"},
      {"end of sequence flow not found", "a ']' or ',' here, for a '[' before it"},
      {"illegal flow end", "no ']' or '}' without a '[' or '{' before it"},
      {"illegal map value",
       "one 'key: value' a line, as far to the right as the keys beside it; a text with ': ' in quotes"},
      {"end of map not found", "a key as far to the right as those beside it, and nothing behind the value before it"},
      {"illegal EOF in scalar", "a quote that closes the text"}};
  const auto words = known.find(error.msg);
  return "valid YAML: " + (words == known.end() ? error.msg : words->second);
}

/// All documents of a text; InputError in place of yaml-cpp's exceptions.
std::vector<YAML::Node> documents(const std::string& text, const std::string& file) {
  try {
    return YAML::LoadAll(text);
  } catch (const YAML::DeepRecursion& error) {
    throw InputError("", "", "valid YAML: nested less deeply", place_of(file, error.mark.line, error.mark.column));
  } catch (const YAML::Exception& error) {
    throw InputError("", "", reason(error, text), place_of(file, error.mark.line, error.mark.column));
  }
}

/// Walks through the mappings of one text.
class Walk {
 public:
  Walk(const std::string& text, const std::string& file) : text_(text), file_(file) {}

  void mapping(const YAML::Node& node) {
    if (path_.size() >= deepest) throw wrong(node.Mark(), flat_key(path_), "at most 16 levels of keys");
    for (const auto& [key, pair] : pairs(node, 0)) {
      path_.push_back(key);
      if (pair.second.IsMap())
        mapping(pair.second);
      else
        value(pair.first, pair.second);
      path_.pop_back();
    }
  }

  InputError wrong(const YAML::Mark& mark, const std::string& key, const std::string& expected) const {
    return InputError(key, "", expected, place_of(file_, mark.line, mark.column));
  }

  std::vector<YamlEntry> entries;

 private:
  using Pairs = std::vector<std::pair<std::string, std::pair<YAML::Node, YAML::Node>>>;

  /// The keys of a mapping in their order, then those that `<<` adds.
  Pairs pairs(const YAML::Node& node, std::size_t merges) {
    if (merges > deepest) throw wrong(node.Mark(), "<<", "mappings that do not contain each other");
    Pairs own;
    std::map<std::string, int> lines;
    std::vector<YAML::Node> merged;
    for (const auto& item : node) {
      const std::string key = key_of(item.first);
      const auto [before, is_new] = lines.insert({key, item.first.Mark().line + 1});
      if (!is_new)
        throw wrong(item.first.Mark(), named(key),
                    "each key and each name once in a mapping, but it stands on line " +
                        std::to_string(before->second) + " too");
      if (key == "<<")
        merged.push_back(item.second);
      else
        own.push_back({key, {item.first, item.second}});
    }
    for (const YAML::Node& other : merged) add_merged(own, other, merges);
    return own;
  }

  void add_merged(Pairs& own, const YAML::Node& other, std::size_t merges) {
    if (other.IsSequence()) {
      for (const YAML::Node& one : other) add_merged(own, one, merges + 1);
      return;
    }
    if (!other.IsMap()) throw wrong(other.Mark(), "<<", "a mapping, as an alias '*name'");
    for (const auto& pair : pairs(other, merges + 1)) {
      const auto same = [&](const auto& mine) { return mine.first == pair.first; };
      if (std::none_of(own.begin(), own.end(), same)) own.push_back(pair);
    }
  }

  std::string key_of(const YAML::Node& node) const {
    if (!node.IsScalar() || node.Scalar().empty()) throw wrong(node.Mark(), flat_key(path_), "a word as key");
    check_quotes(node);
    return lower_case(node.Scalar());
  }

  void value(const YAML::Node& key, const YAML::Node& node) {
    if (entries.size() >= most_entries) throw wrong(key.Mark(), flat_key(path_), "at most 20000 values in a file");
    entries.push_back({path_, text_of(node), file_ + ":" + std::to_string(key.Mark().line + 1)});
  }

  std::string text_of(const YAML::Node& node) const {
    if (!node.IsSequence()) return scalar(node);
    std::string list;
    for (const YAML::Node& item : node) {
      if (!item.IsScalar() && !item.IsNull())
        throw wrong(item.Mark(), flat_key(path_), "a list of plain values, without lists or mappings in it");
      list += (list.empty() ? "" : ", ") + scalar(item);
      if (list.size() > longest_list) throw wrong(item.Mark(), flat_key(path_), "a shorter list");
    }
    return list;
  }

  std::string scalar(const YAML::Node& node) const {
    if (!node.IsScalar()) return "";
    check_quotes(node);
    return node.Scalar();
  }

  /// yaml-cpp takes the end of the file for the end of a quoted text.
  void check_quotes(const YAML::Node& node) const {
    const std::string line = line_of(text_, node.Mark().line);
    const std::size_t column = static_cast<std::size_t>(std::max(0, node.Mark().column));
    const char quote = column < line.size() ? line[column] : ' ';
    if (node.Tag() != "!" || (quote != '"' && quote != '\'') || !ends_open(node, quote, column)) return;
    throw wrong(node.Mark(), flat_key(path_), "valid YAML: a quote that closes this text");
  }

  bool ends_open(const YAML::Node& node, char quote, std::size_t column) const {
    std::size_t at = 0;
    for (int line = 0; line < node.Mark().line; ++line) at = text_.find('\n', at) + 1;
    for (at += column + 1; at < text_.size(); ++at) {
      const bool doubled = quote == '\'' && text_[at] == quote && at + 1 < text_.size() && text_[at + 1] == quote;
      if (doubled || (quote == '"' && text_[at] == '\\'))
        ++at;
      else if (text_[at] == quote)
        return false;
    }
    return true;
  }

  std::string named(const std::string& key) const { return path_.empty() ? key : flat_key(path_) + "_" + key; }

  const std::string& text_;
  const std::string& file_;
  std::vector<std::string> path_;
};

void check_once(const std::vector<YamlEntry>& entries) {
  std::map<std::string, std::string> places;
  for (const YamlEntry& entry : entries) {
    const auto [before, is_new] = places.insert({flat_key(entry.path), entry.place});
    if (!is_new)
      throw InputError(before->first, entry.text,
                       "each key once in a file, but it is given at " + before->second + " too", entry.place);
  }
}

}  // namespace

std::vector<YamlEntry> yaml_entries(const std::string& given, const std::string& name) {
  const std::string text = given.compare(0, 3, byte_order_mark) == 0 ? given.substr(3) : given;
  check_characters(text, name);
  const std::vector<YAML::Node> found = documents(text, name);
  Walk walk(text, name);
  if (found.size() > 1) throw walk.wrong(found[1].Mark(), "", "one document in a file, without a '---' in it");
  if (found.empty() || found[0].IsNull()) return {};
  if (!found[0].IsMap()) throw walk.wrong(found[0].Mark(), "", "'key: value' at the top of a case file");
  walk.mapping(found[0]);
  check_once(walk.entries);
  return walk.entries;
}

std::string flat_key(const std::vector<std::string>& path) {
  std::string key;
  for (const std::string& part : path) key += (key.empty() ? "" : "_") + part;
  return key;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

}  // namespace scree
