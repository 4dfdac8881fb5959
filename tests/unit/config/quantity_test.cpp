#include "scree/config/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace scree {
namespace {

struct Row {
  const char* text;
  const char* unit;
  double expected;
};

const Definitions definitions = [](const std::string& name) -> const std::string* {
  static const std::map<std::string, std::string> texts{
      {"width", "1.4 cm"}, {"half", "${width}/2"}, {"count", "3"}, {"loop", "${loop} + 1"}};
  const auto found = texts.find(name);
  return found == texts.end() ? nullptr : &found->second;
};

TEST(Quantity, NumbersWithAndWithoutUnits) {
  const Row rows[] = {{"1.4", "m", 1.4},
                      {"1.4 cm", "m", 0.014},
                      {"1.4cm", "m", 0.014},
                      {"0 cm", "m", 0},
                      {"-2 cm", "m", -0.02},
                      {" 1e-3 ", "s", 1e-3},
                      {"1 ms", "s", 1e-3},
                      {"0.5 dyn/cm^2", "Pa", 0.05},
                      {"0.5 dyn/cm2", "Pa", 0.05},
                      {"2.9 g/cm3", "kg/m3", 2900},
                      {"2.9 g cm-3", "kg/m3", 2900},
                      {"2.9 g.cm^-3", "kg/m3", 2900},
                      {"1.8e-4 g/(cm s)", "Pa s", 1.8e-5},
                      {"981 cm/s2", "m/s2", 9.81},
                      {"981 cm/s^2", "m/s2", 9.81},
                      {"1 cm2/s2", "m2/s2", 1e-4},
                      {"28.5 deg", "rad", 28.5 * std::acos(-1.0) / 180},
                      {"0.5", "rad", 0.5},
                      {"40 %", "1", 0.4},
                      {"40%", "1", 0.4},
                      {"3/s", "1/s", 3},
                      {"100 um", "m", 1e-4}};
  for (const Row& row : rows)
    EXPECT_DOUBLE_EQ(quantity(row.text, row.unit), row.expected) << "'" << row.text << "' in " << row.unit;
}

TEST(Quantity, ConversionLeavesNoRoundingNoise) {
  EXPECT_EQ(quantity("1.4 cm", "m"), 0.014);
  EXPECT_EQ(quantity("0.5 dyn/cm^2", "Pa"), 0.05);
  EXPECT_EQ(quantity("2.9 g/cm3", "kg/m3"), 2900);
}

TEST(Quantity, Expressions) {
  const Row rows[] = {{"${width}", "m", 0.014},
                      {"${width}/2", "m", 0.007},
                      {"${half}", "m", 0.007},
                      {"2*${width}", "m", 0.028},
                      {"0.5 ${width}", "m", 0.007},
                      {"-${width}", "m", -0.014},
                      {"${width} + ${half}", "m", 0.021},
                      {"${width} - 4 mm", "m", 0.010},
                      {"1 cm - 4 mm - 1 mm", "m", 0.005},
                      {"${width} + 1", "m", 1.014},
                      {"(${width} + 6 mm) / 4", "m", 0.005},
                      {"8 cm/2", "m", 0.04},
                      {"${count} * 2", "1", 6},
                      {"${width}/${half}", "1", 2},
                      {"${width} * 2 cm", "m2", 0.00028},
                      {"${width}/(2 s)", "m/s", 0.007},
                      {"2 + 3 * 4", "1", 14}};
  for (const Row& row : rows)
    EXPECT_DOUBLE_EQ(quantity(row.text, row.unit, definitions), row.expected) << "'" << row.text << "' in " << row.unit;
}

TEST(Quantity, RefusesWhatItCannotRead) {
  const std::pair<const char*, const char*> rows[] = {{"", "a number is missing"},
                                                      {"cm", "as a number"},
                                                      {"nan", "as a number"},
                                                      {"inf", "as a number"},
                                                      {"-inf", "as a number"},
                                                      {"1e999", "not finite"},
                                                      {"1/0", "not finite"},
                                                      {"0x10", "as a number"},
                                                      {"1 kg", "another dimension"},
                                                      {"1 blob", "not a known unit"},
                                                      {"1.4 2", "cannot read '2'"},
                                                      {"1,4", "cannot read ',4'"},
                                                      {"(1 cm", "')' is missing"},
                                                      {"1 cm)", "cannot read ')'"},
                                                      {"2 *", "a number is missing"},
                                                      {"${depth}", "'depth' is not defined"},
                                                      {"${width", "malformed"},
                                                      {"${loop}", "refer to each other"},
                                                      {"${width} + 1 s", "another dimension"},
                                                      {"${width} * ${width}", "another dimension"}};
  for (const auto& [text, reason] : rows) {
    try {
      quantity(text, "m", definitions);
      ADD_FAILURE() << "'" << text << "' was accepted";
    } catch (const QuantityError& error) {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << "'" << text << "': " << error.what();
    }
  }
}

TEST(Quantity, DeepParenthesesAreRefusedNotFollowed) {
  EXPECT_THROW(quantity(std::string(100000, '('), "m"), QuantityError);
}

TEST(SplitList, TrimsAndKeepsEmptyEntries) {
  EXPECT_EQ(split_list("a, b ,c"), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(split_list("1,"), (std::vector<std::string>{"1", ""}));
  EXPECT_EQ(split_list(",1"), (std::vector<std::string>{"", "1"}));
  EXPECT_TRUE(split_list(" ").empty());
}

TEST(NumberText, ReadsBackExactly) {
  for (const double x : {0.014, 1.0 / 3, 1e-14, 6.02e23, -0.1, 0.0, 28.5 * std::acos(-1.0) / 180})
    EXPECT_EQ(std::stod(number_text(x)), x);
  EXPECT_EQ(number_text(0.014), "0.014");
}

}  // namespace
}  // namespace scree
