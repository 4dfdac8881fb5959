#include "scree/config/case_options.hpp"

namespace scree {
namespace {

/// What the options of a phase are called: in full, and by themselves.
struct Names {
  std::string key, prefix;

  std::string own(const std::string& name) const { return prefix + name; }
  std::string full(const std::string& name) const { return key + prefix + name; }
};

void declare_shape(OptionSet& o, const Names& name, const OptionUse& use, InletVariation& variation) {
  o.choice(name.full("profile_shape"), variation.shape,
           {{"uniform", InletShape::uniform}, {"parabolic", InletShape::parabolic}, {"power", InletShape::power}},
           "shape of " + name.own("velocity") + " over the patch, from edge to edge; " + name.own("velocity") +
               " is its mean. parabolic: 3/2 (1 - s^2); power: (1 + 1/n) (1 - |s|)^(1/n), s from -1 to 1")
      .used_if(use.used, use.otherwise);
  o.real(name.full("profile_exponent"), variation.exponent, "-", positive(), "n of the shape power")
      .symbol("n")
      .used_if(use.used, use.otherwise)
      .used_if(o.describing() || variation.shape == InletShape::power, name.own("profile_shape") + " is not power");
}

void declare_profile(OptionSet& o, const Names& name, int dim, const OptionUse& use, int normal,
                     InletVariation& variation) {
  const OptionEntry& at =
      o.reals(name.full("profile_at"), variation.profile.at, {0, false, "ascending"}, "m", any_number(),
              "coordinates along the side at which " + name.own("profile_factor") + " holds")
          .unset_by_default("none: uniform")
          .used_if(use.used, use.otherwise);
  if (at.given && dim == 1) throw InputError(at.key, at.value, "no coordinates: a side is a point in one dimension");
  o.reals(name.full("profile_factor"), variation.profile.factor, {0, false, "one per " + name.own("profile_at")}, "-",
          any_number(), "factors on " + name.own("velocity") + " there, linear in between and constant beyond")
      .unset_by_default("none: 1")
      .used_if(use.used, use.otherwise);
  variation.axis = normal == 0 && dim > 1 ? 1 : 0;
  o.choice(name.full("profile_axis"), variation.axis, axis_choices(o, dim),
           "axis of the coordinates " + name.own("profile_at") + ", along the side")
      .default_from("the first axis along the side")
      .used_if(o.describing() || !variation.profile.at.empty(), "there is no " + name.own("profile_at"))
      .used_if(use.used, use.otherwise);
}

void declare_history(OptionSet& o, const Names& name, const OptionUse& use, InletVariation& variation) {
  o.reals(name.full("history_at"), variation.history.at, {0, false, "ascending"}, "s", any_number(),
          "times at which " + name.own("history_factor") + " holds")
      .unset_by_default("none: steady")
      .used_if(use.used, use.otherwise);
  o.reals(name.full("history_factor"), variation.history.factor, {0, false, "one per " + name.own("history_at")}, "-",
          any_number(), "factors on " + name.own("velocity") + " then, linear in between and constant beyond")
      .unset_by_default("none: 1")
      .used_if(use.used, use.otherwise);
  o.real(name.full("rise_time"), variation.rise_time, "s", non_negative(),
         "time in which " + name.own("velocity") +
             " rises smoothly from 0, from the start of the time window or of the run; 0: at once")
      .used_if(use.used, use.otherwise);
}

}  // namespace

void declare_variation(OptionSet& o, const std::string& key, const std::string& prefix, int dim, const OptionUse& use,
                       int normal, InletVariation& variation) {
  const Names name{key, prefix};
  declare_shape(o, name, use, variation);
  declare_profile(o, name, dim, use, normal, variation);
  declare_history(o, name, use, variation);
}

}  // namespace scree
