#include "scree/config/command_line.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scree/config/input_error.hpp"

namespace scree {
namespace {

namespace fs = std::filesystem;

using Options = std::vector<std::pair<std::string, std::string>>;

TEST(CommandLine, CaseFileAndOptions) {
  const CommandLine line = read_command_line({"a.yaml", "-check", "-friction_tau", "-1", "-gravity", "-.5, 2",
                                              "--mat_view", "-x", "-inf", "-info", "-y", "w"});
  EXPECT_EQ(line.case_file, "a.yaml");
  EXPECT_EQ(line.options, (Options{{"check", ""},
                                   {"friction_tau", "-1"},
                                   {"gravity", "-.5, 2"},
                                   {"mat_view", ""},
                                   {"x", "-inf"},
                                   {"info", ""},
                                   {"y", "w"}}));
  EXPECT_TRUE(line.has("mat_view"));
  EXPECT_FALSE(line.has("a.yaml"));
}

TEST(CommandLine, NoCaseFile) {
  EXPECT_EQ(read_command_line({}).case_file, "");
  EXPECT_EQ(read_command_line({"-restart", "out"}).case_file, "");
  EXPECT_THROW(case_input(read_command_line({"-check"})), InputError);
}

TEST(CommandLine, StrayWordsAreRefused) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"a.yaml", "b.yaml"},
                                                {"a.yaml", "-extent", "1", "2"},
                                                {"a.yaml", "-"},
                                                {"a.yaml", "--"}}) {
    try {
      read_command_line(words);
      ADD_FAILURE() << words.back() << " was accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(error.key, "command line");
      EXPECT_EQ(error.value, words.back());
    }
  }
}

class CaseInputOfLine : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(directory); }
  void TearDown() override { fs::remove_all(directory); }
  std::string put(const std::string& name, const std::string& text) const {
    std::ofstream(directory / name) << text;
    return directory / name;
  }
  const fs::path directory = fs::path(testing::TempDir()) / ("scree_command_line_" + std::to_string(getpid()));
};

TEST_F(CaseInputOfLine, BaseThenCaseThenOverridesThenOptions) {
  put("base.yaml", "a: base\nb: base\nc: base\nd: base\ne: base\n");
  const std::string file = put("case.yaml", "based_on: base.yaml\nb: case\nc: case\nd: case\ne: case\n");
  const std::string one = put("one.yaml", "c: one\nd: one\ne: one\n"), two = put("two.yaml", "d: two\ne: two\n");
  const CaseInput input = case_input(
      read_command_line({file, "-e", "line", "-options_file_yaml", one, "-options_file_yaml", two, "-F", "line"}));
  const char* const expected[][2] = {{"a", "base"}, {"b", "case"}, {"c", "one"},
                                     {"d", "two"},  {"e", "line"}, {"f", "line"}};
  for (const auto& [key, text] : expected) {
    ASSERT_TRUE(input.find(key)) << key;
    EXPECT_EQ(*input.find(key), text);
  }
  EXPECT_EQ(input.place_of("a"), (directory / "base.yaml").string() + ":1");
  EXPECT_EQ(input.place_of("d"), two + ":1");
  EXPECT_EQ(input.place_of("e"), "");
}

TEST_F(CaseInputOfLine, RestartAloneTakesTheCaseOfThatRun) {
  put("case.yaml", "a: 1\n");
  const CaseInput input = case_input(read_command_line({"-restart", directory.string()}));
  EXPECT_EQ(*input.find("a"), "1");
  EXPECT_EQ(*input.find("restart"), directory.string());
}

TEST_F(CaseInputOfLine, KeysDoNotDependOnCase) {
  put("case.yaml", "a: 1\n");
  const std::string more = put("more.yaml", "b: 2\n");
  const CaseInput input = case_input(read_command_line({"-Restart", directory.string(), "-Options_File_Yaml", more}));
  EXPECT_EQ(*input.find("a"), "1");
  EXPECT_EQ(*input.find("b"), "2");
  EXPECT_EQ(*input.find("restart"), directory.string());
  EXPECT_TRUE(read_command_line({"-Help"}).has("help"));
}

TEST_F(CaseInputOfLine, OverridesThatCannotBeReadAreNamed) {
  const std::string file = put("case.yaml", "a: 1\n");
  for (const std::string name : {"", "no.yaml"}) {
    try {
      case_input(read_command_line({file, "-options_file_yaml", name}));
      FAIL();
    } catch (const InputError& error) {
      EXPECT_EQ(error.value, name);
      EXPECT_NE(error.expected.find("overrides"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace scree
