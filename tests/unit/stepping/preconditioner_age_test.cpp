#include "scree/stepping/preconditioner_age.hpp"

#include <gtest/gtest.h>

namespace scree::test {
namespace {

TEST(PreconditionerAge, IsComparedWithTheFirstSystem) {
  PreconditionerAge age;
  EXPECT_FALSE(age.has_aged(11)) << "the first, whatever it takes";
  EXPECT_FALSE(age.has_aged(32));
  EXPECT_TRUE(age.has_aged(33));
  EXPECT_FALSE(age.has_aged(12)) << "an easy system";
}

TEST(PreconditionerAge, BeginsAnewWithEachPreconditioner) {
  PreconditionerAge age;
  EXPECT_FALSE(age.has_aged(1));
  EXPECT_TRUE(age.has_aged(100));
  age.renewed();
  EXPECT_FALSE(age.has_aged(100));
  EXPECT_FALSE(age.has_aged(210));
  EXPECT_TRUE(age.has_aged(211));
}

}  // namespace
}  // namespace scree::test
