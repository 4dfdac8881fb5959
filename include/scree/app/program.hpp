/// The program: a case, run. What it is made of can be more than what comes with Scree.
#pragma once

#include "scree/config/catalogue.hpp"
#include "scree/model/model.hpp"

namespace scree {

/// The parts that a case may choose from, and what makes its model of them. A program of its own adds to them:
///     int main(int argc, char** argv) {
///       scree::Parts parts;
///       parts.catalogue.further_kinds = {&screen};
///       return scree::run_program(argc, argv, parts);
///     }
struct Parts {
  Catalogue catalogue;
  ModelFactory models{make_model, {}};
};

/// main() of `scree CASE.yaml [options]`. Returns the exit code.
int run_program(int argc, char** argv, Parts parts = {});

}  // namespace scree
