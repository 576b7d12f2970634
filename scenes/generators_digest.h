// Which generators of built-in scenes a program was built with.
#pragma once

namespace foveola::scenes {

/// The digest of their sources and of what they compute with, in hexadecimal digits: generators of
/// another digest make other scenes. It is compiled into the program that makes scenes and into
/// the laboratory, which asks for them.
const char* generators_digest();

/// The exit code of the program that makes scenes when asked for those of other generators.
constexpr int refusal_exit_code = 2;

}  // namespace foveola::scenes
