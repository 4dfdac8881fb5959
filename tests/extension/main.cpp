/// Scree with parts of one's own: a rheology, a drag law, a kind of boundary, and a balance with its unknown. Nothing
/// in src/ or include/ knows of them. See README.md beside this file.
#include "hindered.hpp"
#include "scree/app/program.hpp"
#include "scree/config/option_set.hpp"
#include "scree/model/assembled_model.hpp"
#include "screen.hpp"
#include "tracer.hpp"
#include "viscous.hpp"

namespace {

/// The one model that this program has: two dimensions, gas without inertia, transported T, upwind. choose_model<2,
/// GasModel::darcy, Tracer> would bring all choices of temperature, friction and advection.
std::unique_ptr<scree::Model> make_model_with_tracer(const scree::ModelSetup& setup) {
  using namespace scree;
  if (setup.lattice.dim != 2 || setup.solids.gas.model != GasModel::darcy || setup.solids.friction.model->has_unknown ||
      setup.model.temperature != TemperatureModel::transport || setup.model.advection != AdvectionScheme::upwind)
    throw std::runtime_error(
        "this program has the model of dimension 2, gas darcy, granular_temperature transport, a friction_model "
        "without "
        "an unknown and advection upwind, and no other");
  return std::make_unique<AssembledModel<Layout<2, true, false, GasModel::darcy, Tracer>, false>>(setup);
}

void declare_options(scree::OptionSet& o) {
  o.group("extension");
  o.real("viscous_time", Viscous::time, "s", scree::positive(), "viscosity over p_c of friction_model viscous");
  o.real("tracer_diffusivity", Tracer::diffusivity, "m2/s", scree::non_negative(), "D of the tracer");
  o.real("tracer_decay", Tracer::decay, "1/s", scree::non_negative(), "rate at which the tracer decays");
}

}  // namespace

int main(int argc, char** argv) {
  scree::friction_models().push_back(scree::FrictionModel(scree::rheology<Viscous>));
  scree::drag_laws().push_back(&scree::drag_law<Hindered>);
  scree::Parts parts;
  parts.catalogue.further_kinds = {&screen};
  parts.catalogue.further_options = declare_options;
  parts.models = {make_model_with_tracer, {&Tracer::unknown}};
  return scree::run_program(argc, argv, parts);
}
