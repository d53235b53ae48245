// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a study.yaml says: a scene, what is varied in it, and what its error is measured against.
#include "io/scene/scene_source.hpp"

namespace io {

enum class StudyError { womersley, self, ensemble };
inline constexpr std::array<std::string_view, 3> study_error_words{"womersley", "self", "ensemble"};

/// Cells over the diameter and along the axis of a pipe.
struct CellPair {
    int across = 0, along = 0;
};
[[nodiscard]] Value value_of(CellPair& place, std::string_view unit, Range range);

/// Something else that is varied.
struct StudyKnob {
    std::string name;
    std::vector<std::string> set; ///< "key.path=value", one for each choice
};

struct StudyVariation {
    std::vector<CellPair> cells;
    std::vector<int> steps_per_period;
    std::vector<StudyKnob> knobs;
    int seeds = 0; ///< of an ensemble: runs that differ in run.random_seed alone
};

struct Study {
    std::string name;
    SceneSource scene;
    StudyError error = StudyError::womersley;
    int periods = 2; ///< The error is that of the last one.
    int repeats = 1; ///< The fastest of them counts.
    StudyVariation vary;
};

void describe(Schema& s, Study& study);

/// Name of the axis along which the runs of an ensemble lie.
inline constexpr std::string_view seed_axis = "seed";

/// One combination of choices.
struct StudyCase {
    std::vector<int> choice;         ///< of each axis
    std::vector<std::string> labels; ///< of each choice
    Scene scene;
};

/// All combinations, the last axis fastest.
struct StudyPlan {
    Study study;
    std::vector<std::string> axes;
    std::vector<StudyCase> cases;
};

/// Reads a study and the scenes of all its cases.
/// @throws core::ConfigError with all problems, each with its place.
[[nodiscard]] StudyPlan read_study(const std::filesystem::path& file);

} // namespace io
