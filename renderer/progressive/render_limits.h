// The ranges of a render's settings, for the command line and for Python.
#pragma once

#include <cstdint>
#include <optional>

#include "renderer/progressive/headless_render.h"

namespace foveola {

/// What settings are called where a person gives them; messages begin with these.
struct SettingNames {
  const char* camera = "--camera";
  const char* head = "--head";
  const char* gaze = "--gaze";
  const char* size = "--size";
  const char* samples_per_pixel = "--spp";
  const char* samples = "--samples";
  const char* seconds = "--seconds";
  const char* max_depth = "--max-depth";
  const char* threads = "--threads";
  const char* remedy = "see foveola render --help";
};

/// How much is to be rendered: one of them.
struct BudgetChoices {
  std::optional<double> samples_per_pixel;
  std::optional<std::int64_t> samples;
  std::optional<double> seconds;
  double default_samples_per_pixel = 16.0;
};

/// Throws UsageError for more than one choice, and for a number out of its range.
RenderBudget budget_of(const BudgetChoices& choices, const SettingNames& names = {});

/// Throws UsageError for the first setting, but for the budget, that no render can have.
void require_possible(const RenderSettings& settings, const SettingNames& names = {});

}  // namespace foveola
