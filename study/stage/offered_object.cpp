#include "study/stage/offered_object.h"

#include <algorithm>

#include "renderer/base/error.h"

namespace foveola::study {

const OfferedObject& object_named(const std::vector<OfferedObject>& offered,
                                  const std::string& name) {
  const auto found = std::find_if(offered.begin(), offered.end(),
                                  [&](const OfferedObject& object) { return object.name == name; });
  if (found == offered.end()) {
    throw Error(name, "is no longer an object of the scene", "restore the scene as it was");
  }
  return *found;
}

}  // namespace foveola::study
