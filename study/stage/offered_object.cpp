#include "study/stage/offered_object.h"

#include <algorithm>

#include "renderer/base/error.h"

namespace foveola::study {

const OfferedObject& object_named(const std::vector<OfferedObject>& offered,
                                  const std::string& name) {
  const auto found = std::ranges::find(offered, name, &OfferedObject::name);
  if (found == offered.end()) {
    throw Error(name, "is no longer an object of the scene", "restore the scene as it was");
  }
  return *found;
}

}  // namespace foveola::study
