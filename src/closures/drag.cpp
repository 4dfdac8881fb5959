#include "scree/closures/drag.hpp"

#include "scree/closures/drag/beetstra.hpp"
#include "scree/closures/drag/drag_law.hpp"
#include "scree/closures/drag/ergun.hpp"
#include "scree/closures/drag/gidaspow.hpp"
#include "scree/closures/drag/syamlal_obrien.hpp"
#include "scree/closures/drag/wen_yu.hpp"

namespace scree {

const DragLaw* default_drag_law() { return &drag_law<WenYu>; }

Variants<DragLaw>& drag_laws() {
  static Variants<DragLaw> laws{&drag_law<WenYu>, &drag_law<Gidaspow>, &drag_law<SyamlalOBrien>, &drag_law<Beetstra>,
                                &drag_law<Ergun>};
  return laws;
}

}  // namespace scree
