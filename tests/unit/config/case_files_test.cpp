#include "scree/config/case_files.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "scree/config/input_error.hpp"

namespace scree {
namespace {

namespace fs = std::filesystem;

/// A directory of small files.
class CaseFiles : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(directory / "base"); }
  void TearDown() override { fs::remove_all(directory); }
  std::string put(const std::string& name, const std::string& text) const {
    std::ofstream(directory / name) << text;
    return directory / name;
  }
  static std::string complaint_on(const std::string& file) {
    try {
      case_files(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  const fs::path directory = fs::path(testing::TempDir()) / ("scree_case_files_" + std::to_string(getpid()));
};

TEST_F(CaseFiles, BaseComesFirst) {
  put("base/case.yaml", "dimension: 2\n");
  put("variant.yaml", "# more\nbased_on: \"base/case.yaml\"  # the base\ndimension: 3\n");
  const std::string last = put("last.yaml", "based_on: variant.yaml\n");
  std::vector<std::string> names;
  for (const CaseFile& file : case_files(last)) names.push_back(file.name);
  EXPECT_EQ(names, (std::vector<std::string>{directory / "base/case.yaml", directory / "variant.yaml",
                                             directory / "last.yaml"}));
}

TEST_F(CaseFiles, CirclesAndMissingFilesAreRefused) {
  const std::string a = put("a.yaml", "based_on: base/b.yaml\n");
  put("base/b.yaml", "based_on: ../a.yaml\n");
  EXPECT_NE(complaint_on(a).find("circle"), std::string::npos);
  EXPECT_NE(complaint_on(put("self.yaml", "based_on: ./self.yaml\n")).find("circle"), std::string::npos);
  EXPECT_NE(complaint_on(put("lost.yaml", "based_on: none.yaml\n")).find("none.yaml"), std::string::npos);
  EXPECT_NE(complaint_on(directory / "nowhere.yaml").find("readable YAML file"), std::string::npos);
  EXPECT_NE(complaint_on(directory).find("readable YAML file"), std::string::npos);
}

}  // namespace
}  // namespace scree
