#include "scree/closures/correlation_length/jenkins.hpp"
#include "scree/config/case_options.hpp"
#include "scree/config/variant_choices.hpp"

namespace scree {
namespace {

/// Densest packing of equal spheres, pi/sqrt(18), rounded up.
constexpr double densest_packing = 0.7405;

}  // namespace

void declare_particles(OptionSet& o, KineticParameters& kinetic, FrictionParameters& friction, WallParameters& wall) {
  o.group("particles");
  o.real("particle_density", kinetic.rho_s, "kg/m3", positive(), "density of the particles' material").symbol("rho_s");
  o.real("particle_diameter", kinetic.d, "m", positive(), "diameter of the particles").symbol("d");
  o.real("particle_restitution", kinetic.e_p, "-", above_zero_to_one(),
         "restitution between particles, eta = (1 + e_p)/2 in (1.1)-(1.6)")
      .symbol("e_p");
  o.real("solids_fraction_max", kinetic.nu_max, "-", {0, densest_packing, false, true, "in (0, 0.7405]"},
         "solids fraction at which (1.7) and (18) diverge; a bed stays below it")
      .symbol("nu_max");
  o.choice(
       "radial_distribution", kinetic.g0, variant_choices(radial_distributions()),
       variant_text("radial distribution at contact, in all kinetic closures and wall laws", radial_distributions()))
      .symbol("g0");
  o.real("particle_friction", kinetic.mu_p, "-", non_negative(),
         "coefficient of friction in collisions of particles: the dissipation (1.4) takes effective_restitution in "
         "place of e_p, stress and conduction do not. 0: (1.4) as it is")
      .symbol("mu_p");
  o.choice("effective_restitution", kinetic.e_eff, variant_choices(effective_restitutions()),
           variant_text("restitution with friction, where particle_friction or that of a wall is not 0",
                        effective_restitutions()))
      .symbol("e_eff");
  auto lengths = variant_choices(correlation_lengths());
  lengths.insert(lengths.begin(), {"none", nullptr});
  o.choice("correlation_length", kinetic.length, lengths,
           variant_text("L of extended kinetic theory, by which J_coll of (1.4) is divided as L/d. none: L = d",
                        correlation_lengths()))
      .symbol("L");
  o.real("correlation_length_constant", kinetic.length_constant, "-", positive(), "c of correlation_length jenkins")
      .symbol("c")
      .used_if(kinetic.length == &correlation_length_entry<JenkinsLength>, "correlation_length is not jenkins");
  friction.rho_s = kinetic.rho_s;
  friction.d = kinetic.d;
  friction.nu_max = kinetic.nu_max;
  wall.nu_max = kinetic.nu_max;
}

}  // namespace scree
