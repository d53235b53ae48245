// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which coupling mode a scene can stand: stability numbers and the choice of `auto`, with its reason.
#include <cstdint>
#include <optional>
#include <string>

namespace physics {

/// What the fluid lane knows of the grains when it couples (see response.hpp).
enum class Mode {
    pipelined,  ///< the grains' real impulse and position: drag and projection wait for them
    coarse,     ///< those of a pass with longer sub-steps: nothing waits
    concurrent, ///< those of free flight held back by the last step's contacts: nothing waits
    iterated    ///< as pipelined, the interval repeated with what was found
};

/// Does the fluid lane wait for the real grains?
[[nodiscard]] inline bool waits_for_grains(Mode mode) { return mode == Mode::pipelined || mode == Mode::iterated; }

/// Extremes of a scene that decide stability.
struct StabilityNumbers {
    double stiffness = 0.0;      ///< b = K dt / m, the largest [-]
    double loading = 0.0;        ///< M = solid mass over fluid mass of a cell, the largest [-]
    double amplification = 0.0;  ///< A of naive lagging, added_mass_amplification() [-]
    double solid_fraction = 0.0; ///< C, the largest [-]
    double grain_work = 0.0;     ///< sub-steps of grains per cell of the fluid: what a fluid lane would wait for [-]
    double softness = 0.0;       ///< K / (k dt), the largest, k that of a bed as a whole per grain (bed_stiffness.hpp) [-]
};

struct ModeChoice {
    Mode mode = Mode::pipelined;
    std::string reason;
};

/// Growth per step of a compression mode if the grains used pressure gradient and Du/Dt of the last step (NUMERICS B5).
/// @param density_ratio  s = rho_p / rho.   @param added_mass_coefficient  C_m.
[[nodiscard]] double added_mass_amplification(double phi, double density_ratio, double added_mass_coefficient);

/// b M / (1 + M): how often the mixture could exchange its slip within a step.
[[nodiscard]] double coupling_number(const StabilityNumbers& numbers);

/// Does a bed go with its fluid through a step so that repeated passes must see how far it gives way? (response.hpp, soft springs)
/// @param exchange  b M.   @param softness  StabilityNumbers::softness.
[[nodiscard]] bool gives_way(double exchange, double softness);

/// Softness from which on that may be so.
inline constexpr double swaying_softness = 0.3;

[[nodiscard]] const char* name(Mode mode);

/// Is a mode stable for these numbers?
[[nodiscard]] bool holds(Mode mode, const StabilityNumbers& numbers);

/// The mode that is sure for these numbers, and why: `concurrent` only where grains are few and to wait for them is long.
[[nodiscard]] ModeChoice choose_mode(const StabilityNumbers& numbers);

/// The mode of one step, and why: the first of a run, and every step that the mode asked for could not stand, is `iterated`.
/// @param asked  None: by choose_mode().
[[nodiscard]] ModeChoice mode_of_step(std::optional<Mode> asked, const StabilityNumbers& numbers, std::int64_t step);

} // namespace physics
