#include "scree/config/case_options.hpp"

namespace scree {

void declare_wall(OptionSet& o, WallParameters& wall) {
  o.group("wall");
  o.real("wall_friction_angle", wall.delta, "rad", angle_below_right(), "angle of wall friction, eq. (25)")
      .symbol("delta");
  o.real("wall_specularity", wall.specularity, "-", from_zero_to_one(), "specularity coefficient of (25), (26)")
      .symbol("phi'");
  o.real("wall_restitution", wall.e_w, "-", above_zero_to_one(), "restitution between particle and wall, eq. (26)")
      .symbol("e_w");
  o.real(
       "wall_particle_friction", wall.mu_w, "-", non_negative(),
       "coefficient of friction in collisions with the wall: the loss in (26) takes effective_restitution in place of "
       "e_w")
      .symbol("mu_w");
  o.real("wall_slip_regularisation", wall.slip_regularisation, "m/s", positive(),
         "v_e of v_sl/sqrt(v_sl^2 + v_e^2), the direction of slip in (25)");
}

}  // namespace scree
