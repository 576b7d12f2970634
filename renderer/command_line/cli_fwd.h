// CLI11's types by name alone, for headers: its own headers take seconds to compile.
#pragma once

namespace CLI {
class App;
class Option;
}  // namespace CLI
