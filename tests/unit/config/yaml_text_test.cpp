#include "scree/config/yaml_text.hpp"

#include <gtest/gtest.h>

#include "scree/config/input_error.hpp"

namespace scree {
namespace {

/// Keys, texts and places as "key=text@place" in their order.
std::string read(const std::string& text) {
  std::string all;
  for (const YamlEntry& entry : yaml_entries(text, "f"))
    all += (all.empty() ? "" : "; ") + flat_key(entry.path) + "=" + entry.text + "@" + entry.place;
  return all;
}

std::string complaint(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(YamlText, NestedKeysListsAndFlags) {
  EXPECT_EQ(read("a: {B: 1, c: [1 cm, '2']}\nd:\ne: ~\nf: \"x, y\"  # z\n"),
            "a_b=1@f:1; a_c=1 cm, 2@f:1; d=@f:2; e=@f:3; f=x, y@f:4");
  EXPECT_EQ(read("a:\n  b:\n    c: 1\n  d: 2\n"), "a_b_c=1@f:3; a_d=2@f:4");
  EXPECT_EQ(read(""), "");
  EXPECT_EQ(read("# nothing\n---\n"), "");
  EXPECT_EQ(read("\xef\xbb\xbf"
                 "a: 1\r\nb: 2\r\n"),
            "a=1@f:1; b=2@f:2");
}

TEST(YamlText, AliasesAndMerges) {
  EXPECT_EQ(read("a: &w {x: 1, y: 2}\nb: {<<: *w, y: 3}\n"), "a_x=1@f:1; a_y=2@f:1; b_y=3@f:2; b_x=1@f:1");
  EXPECT_EQ(read("a: &one 1\nb: *one\n"), "a=1@f:1; b=1@f:2");
}

TEST(YamlText, NamesAndKeysUsedTwiceAreRefusedWithBothLines) {
  const std::string twice = complaint("i:\n  bed: {box: 1}\n  top: 1\n  Bed: {nu: 2}\n");
  EXPECT_EQ(twice.find("f:4:3: i_bed: expected each key and each name once"), 0u) << twice;
  EXPECT_NE(twice.find("line 2"), std::string::npos) << twice;
  EXPECT_EQ(complaint("a: 1\nb: 2\na: 3\n").find("f:3:1: a: expected each key"), 0u);
  EXPECT_EQ(complaint("output: {dir: x}\noutput: {mirror: 2}\n").find("f:2:1: output"), 0u);
  const std::string spelt = complaint("a: {b: 1}\na_b: 2\n");
  EXPECT_EQ(spelt.find("f:2: a_b = '2': expected each key once in a file, but it is given at f:1 too"), 0u) << spelt;
}

TEST(YamlText, WhatIsNoYamlIsRefusedWithPlaceAndReason) {
  const std::pair<const char*, const char*> rows[] = {
      {"a:\n\tb: 1\n\tc: 2\n", "f:2:3: expected valid YAML: blanks in place of the tab"},
      {"a: {b: 1\nc: 2\n", "f:2:2: expected valid YAML: a '}' or ','"},
      {"a: [1, 2\nc: 2\n", "f:2:2: expected valid YAML: a ']' or ','"},
      {"a: 1\n b: 2\n", "f:2:3: expected valid YAML: one 'key: value' a line"},
      {"a: 1\n- b\n", "f:2:1: expected valid YAML: a key as far"},
      {"x: 1\na: \"no end\nb: 1\n", "f:2:4: a: expected valid YAML: a quote that closes"},
      {"a: 'it''s\nb: 1\n", "f:1:4: a: expected valid YAML: a quote that closes"},
      {"a: 'no end", "expected valid YAML: a quote that closes"},
      {"]: 1\n", "f:1:1: expected valid YAML"},
      {"a: *none\n", "f:1:4: expected valid YAML"},
      {"? [a, b]\n: 1\n", "expected a word as key"},
      {": 1\n", "expected a word as key"},
      {"'': 1\n", "expected a word as key"},
      {"a: [1, {b: 2}]\n", "f:1:8: a: expected a list of plain values"},
      {"a: [[1, 2]]\n", "f:1:5: a: expected a list of plain values"},
      {"- 1\n- 2\n", "f:1:1: expected 'key: value'"},
      {"just text\n", "f:1:1: expected 'key: value'"},
      {"a: 1\n---\nb: 2\n", "f:3:1: expected one document"},
      {"a: 1\nb: \x04\n", "f:2:4: expected no control characters"},
      {"\xff\xfe"
       "a",
       "f:1:1: expected a text file in UTF-8"},
      {"q: &q {r: *q}\n", "at most 16 levels"},
      {"a: {<<: 1}\n", "expected a mapping"}};
  for (const auto& [text, expected] : rows) {
    const std::string line = complaint(text);
    EXPECT_NE(line.find(expected), std::string::npos) << text << ": " << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
}

TEST(YamlText, DepthAndNumberOfValuesAreLimited) {
  EXPECT_NE(complaint("x: " + std::string(3000, '[') + std::string(3000, ']')).find("nested less deeply"),
            std::string::npos);
  std::string bomb = "a: &a {x: 1, y: 1}\n";
  for (char c = 'b'; c < 'p'; ++c) {
    const std::string before(1, static_cast<char>(c - 1)), name(1, c);
    bomb += name + ": &" + name + " {x: *" + before + ", y: *" + before + "}\n";
  }
  EXPECT_NE(complaint(bomb).find("at most 20000 values"), std::string::npos);
}

TEST(YamlText, LongPathsKeepTheirLine) {
  const std::string name(5000, 'd');
  try {
    yaml_entries("a: [", name);
    FAIL();
  } catch (const InputError& error) {
    const std::string line = error.what();
    EXPECT_LT(line.size(), 1000u);
    EXPECT_NE(line.find("d:1:1: expected"), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace scree
