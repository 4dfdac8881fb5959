/// scree CASE.yaml [options]: runs a case. See README.md; `scree -help` lists the options.
#include "scree/app/program.hpp"

int main(int argc, char** argv) { return scree::run_program(argc, argv); }
