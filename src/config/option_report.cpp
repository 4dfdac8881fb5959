#include <sstream>

#include "scree/config/case_options.hpp"
#include "scree/config/read_case.hpp"

namespace scree {

namespace {

std::string without_bars(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, "\\");
  return text;
}

const char* const introduction = R"(scree [case.yaml] [-option value ...]

A case file is YAML; nested keys join with '_', so `friction: {tau: 1 ms}` is -friction_tau "1 ms". The command line wins.
A number without a unit is SI; numbers with units are converted ("1.4 cm", "28.5 deg", "0.5 dyn/cm^2", "40 %").
Names under `define:` stand for values anywhere: `define: {width: 1.4 cm}`, then "${width}/2"; -width "2 cm" overrides.
Lists are YAML lists or comma lists. <name> is any name you choose. PETSc's own options (-ts_..., -snes_...) pass; in
a case file they stand under `petsc:`. Files of overrides follow the case file: -options_file_yaml MORE.yaml.
)";

}  // namespace

std::string help_text(const Catalogue& catalogue) {
  std::ostringstream out;
  out << introduction;
  std::string group;
  const OptionSet options = declared(OptionSet(), catalogue);
  for (const OptionEntry& entry : options.entries()) {
    if (entry.group != group) out << "\n" << entry.group << "\n";
    group = entry.group;
    out << "  -" << entry.key << " <" << entry.default_value << ">"
        << (entry.unit == "-" ? "" : " [" + entry.unit + "]") << " (" << entry.allowed << ")\n      "
        << (entry.symbol_.empty() ? "" : entry.symbol_ + ": ") << entry.text << "\n";
  }
  return out.str();
}

std::string option_table_markdown(const Catalogue& catalogue) {
  std::ostringstream out;
  out << "| symbol | option | unit | default | allowed | meaning |\n|---|---|---|---|---|---|\n";
  const OptionSet options = declared(OptionSet(), catalogue);
  for (const OptionEntry& entry : options.entries()) {
    out << "| " << entry.symbol_ << " | `" << entry.key << "` | " << entry.unit << " | "
        << without_bars(entry.default_value) << " | " << without_bars(entry.allowed) << " | "
        << without_bars(entry.text) << " |\n";
  }
  return out.str();
}

}  // namespace scree
