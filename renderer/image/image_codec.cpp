#include "renderer/image/image_codec.h"

#include <dlfcn.h>

#include "renderer/base/error.h"

namespace foveola {
namespace {

using CodecOfModule = const ImageCodec* (*)();

/// The program's RUNPATH leads to it. It stays loaded, since its images may outlive any owner.
const ImageCodec& load_codec() {
  void* const module = dlopen(FOVEOLA_IMAGE_MODULE, RTLD_NOW | RTLD_LOCAL);
  void* const function = module == nullptr ? nullptr : dlsym(module, "foveola_image_codec");
  if (function == nullptr) {
    const char* const fault = dlerror();
    throw Error(FOVEOLA_IMAGE_MODULE,
                std::string("cannot be loaded, and is needed for every image: ") +
                    (fault == nullptr ? "no reason is known" : fault),
                "build or install Foveola anew");
  }
  return *reinterpret_cast<CodecOfModule>(function)();
}

}  // namespace

const ImageCodec& image_codec() {
  static const ImageCodec& codec = load_codec();
  return codec;
}

}  // namespace foveola
