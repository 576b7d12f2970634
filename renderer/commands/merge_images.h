// `foveola merge-images`.
#pragma once

namespace CLI {
class App;
}

namespace foveola {

/// Adds the command, which makes an image of the films of a render's parts.
void add_merge_images(CLI::App& app);

}  // namespace foveola
