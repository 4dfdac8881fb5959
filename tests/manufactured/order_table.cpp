#include "order_table.hpp"

#include <petscsys.h>

#include <cmath>
#include <cstdio>

namespace scree::test {

namespace {

std::vector<double> orders(const std::vector<double>& errors) {
  std::vector<double> result;
  for (std::size_t k = 1; k < errors.size(); ++k) result.push_back(std::log2(errors[k - 1] / errors[k]));
  return result;
}

std::string list(const std::vector<double>& values, const char* format) {
  std::string text;
  for (const double value : values) {
    char number[40];
    std::snprintf(number, sizeof number, format, value);
    text += (text.empty() ? "" : ", ") + std::string(std::isfinite(value) ? number : "null");
  }
  return "[" + text + "]";
}

/// All rows so far, as a list of JSON; the file is written anew with each, so that it is whole whenever a run ends.
std::string entries;

void keep(const OrderRow& row, const char* norm, const std::vector<double>& errors) {
  const std::vector<double> p = orders(errors);
  entries += (entries.empty() ? "" : ",\n") + std::string(" {\"case\": \"") + row.name + "\", \"unknown\": \"" +
             row.unknown + "\", \"norm\": \"" + norm + "\", \"" + row.what + "\": " + list(row.steps, "%g") +
             ", \"errors\": " + list(errors, "%.4e") + ", \"orders\": " + list(p, "%.3f") +
             ", \"bound\": " + list({row.bound}, "%g").substr(1, std::string::npos);
  entries.pop_back();
  entries += std::string(", \"good\": ") + (norm[0] != 'L' || p.back() >= row.bound ? "true" : "false") + "}";
}

}  // namespace

double OrderTable::add(const OrderRow& row) {
  const std::vector<double> mean = orders(row.mean), greatest = orders(row.greatest);
  int rank;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  if (rank == 0) {
    std::printf("%-60s %-4s error %.2e  L2 %s  max %s\n", row.name.c_str(), row.unknown.c_str(), row.mean.back(),
                list(mean, "%.2f").c_str(), list(greatest, "%.2f").c_str());
    std::fflush(stdout);
    keep(row, "L2", row.mean);
    keep(row, "maximum", row.greatest);
    char name[PETSC_MAX_PATH_LEN] = "";
    PetscBool given;
    PetscCallAbort(PETSC_COMM_SELF, PetscOptionsGetString(nullptr, nullptr, "-order_file", name, sizeof name, &given));
    if (given) {
      std::FILE* file = std::fopen(name, "w");
      if (file) {
        std::fprintf(file, "[\n%s\n]\n", entries.c_str());
        std::fclose(file);
      }
    }
  }
  return mean.back();
}

}  // namespace scree::test
