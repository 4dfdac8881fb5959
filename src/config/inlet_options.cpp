#include "scree/config/case_options.hpp"

namespace scree {
namespace {

void declare_shape(OptionSet& o, const std::string& key, const std::string& velocity, const OptionUse& use,
                   InletVariation& variation) {
  o.choice(key + "profile_shape", variation.shape,
           {{"uniform", InletShape::uniform}, {"parabolic", InletShape::parabolic}, {"power", InletShape::power}},
           "shape of " + velocity + " over the patch, from edge to edge; " + velocity +
               " is its mean. parabolic: 3/2 (1 - s^2); power: (1 + 1/n) (1 - |s|)^(1/n), s from -1 to 1")
      .used_if(use.used, use.otherwise);
  o.real(key + "profile_exponent", variation.exponent, "-", positive(), "n of the shape power")
      .symbol("n")
      .used_if(use.used, use.otherwise)
      .used_if(o.describing() || variation.shape == InletShape::power, key + "profile_shape is not power");
}

void declare_profile(OptionSet& o, const std::string& key, const std::string& velocity, int dim, const OptionUse& use,
                     int normal, InletVariation& variation) {
  const OptionEntry& at = o.reals(key + "profile_at", variation.profile.at, {0, false, "ascending"}, "m", any_number(),
                                  "coordinates along the side at which " + key + "profile_factor holds")
                              .unset_by_default("none: uniform")
                              .used_if(use.used, use.otherwise);
  if (at.given && dim == 1) throw InputError(at.key, at.value, "no coordinates: a side is a point in one dimension");
  o.reals(key + "profile_factor", variation.profile.factor, {0, false, "one per " + key + "profile_at"}, "-",
          any_number(), "factors on " + velocity + " there, linear in between and constant beyond")
      .unset_by_default("none: 1")
      .used_if(use.used, use.otherwise);
  variation.axis = normal == 0 && dim > 1 ? 1 : 0;
  o.choice(key + "profile_axis", variation.axis, axis_choices(o, dim),
           "axis of the coordinates " + key + "profile_at, along the side")
      .default_from("the first axis along the side")
      .used_if(o.describing() || !variation.profile.at.empty(), "there is no " + key + "profile_at")
      .used_if(use.used, use.otherwise);
}

void declare_history(OptionSet& o, const std::string& key, const std::string& velocity, const OptionUse& use,
                     InletVariation& variation) {
  o.reals(key + "history_at", variation.history.at, {0, false, "ascending"}, "s", any_number(),
          "times at which " + key + "history_factor holds")
      .unset_by_default("none: steady")
      .used_if(use.used, use.otherwise);
  o.reals(key + "history_factor", variation.history.factor, {0, false, "one per " + key + "history_at"}, "-",
          any_number(), "factors on " + velocity + " then, linear in between and constant beyond")
      .unset_by_default("none: 1")
      .used_if(use.used, use.otherwise);
  o.real(key + "rise_time", variation.rise_time, "s", non_negative(),
         "time in which " + velocity +
             " rises smoothly from 0, from the start of the time window or of the run; 0: at once")
      .used_if(use.used, use.otherwise);
}

}  // namespace

void declare_variation(OptionSet& o, const std::string& key, const std::string& velocity, int dim, const OptionUse& use,
                       int normal, InletVariation& variation) {
  declare_shape(o, key, velocity, use, variation);
  declare_profile(o, key, velocity, dim, use, normal, variation);
  declare_history(o, key, velocity, use, variation);
}

}  // namespace scree
