// Which program measured on which machine, and when: what every benchmark's JSON begins with.
#pragma once

#include <nlohmann/json.hpp>

namespace foveola {

/// version, compiler, build_type, instruction_set, ray_tracer.
nlohmann::ordered_json program_facts();

/// The same, and processor, cores (those that this process may use), memory_gb (10^9 bytes), system
/// (the series of the kernel), distribution and date (UTC). No name of the machine, no paths.
nlohmann::ordered_json bench_facts();

/// A measured figure that was measured once, as `bench compare` reads it: {"value": 3, "low": null,
/// "high": null}.
nlohmann::ordered_json measured_once(double value);

}  // namespace foveola
