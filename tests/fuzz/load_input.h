// One input of the loaders' fuzzer: the bytes of an untrusted scene or environment file.
#pragma once

#include <filesystem>
#include <string_view>

namespace foveola::test {

/// Writes `input` to files in `folder` and returns the one to load: scene.glb if it begins with
/// "glTF", scene.gltf if with a brace, the environment if as an image, else scene.obj. An OBJ input
/// may go on, after record separators (byte 0x1E), with the content of its library m.mtl and of the
/// image t.png.
std::filesystem::path write_input(const std::filesystem::path& folder, std::string_view input);

/// Writes what inputs can refer to: the image t.png, red and half transparent, and the buffer b.bin
/// of the floats 0, 1, ... 15.
void write_surroundings(const std::filesystem::path& folder);

/// Loads what write_input returned, as it is half a second into its animations, and checks of what
/// comes out that every index is in range and every vertex finite, or every pixel light; throws
/// std::logic_error if not. Returns false if it was refused with an Error.
bool load_input(const std::filesystem::path& file);

}  // namespace foveola::test
