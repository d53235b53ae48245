// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How fluid and particles of a scene act on each other, as the user describes it.
#include "io/scene/value.hpp"
#include <array>
#include <optional>
#include <string_view>

namespace io {

class Schema;

// Enumerations stand with their words, in the same order.

enum class CouplingMode { automatic, pipelined, coarse, concurrent, iterated };
inline constexpr std::array<std::string_view, 5> coupling_mode_words{"auto", "pipelined", "coarse", "concurrent", "iterated"};

enum class DragLaw { smooth, seed, gidaspow, beetstra, rong, tenneti, schiller_naumann, wen_yu, ergun };
inline constexpr std::array<std::string_view, 9> drag_law_words{"smooth",           "seed",   "gidaspow", "beetstra", "rong", "tenneti",
                                                                "schiller_naumann", "wen_yu", "ergun"};

enum class MagnusLaw { lun_liu, rubinow_keller, seed };
inline constexpr std::array<std::string_view, 3> magnus_law_words{"lun_liu", "rubinow_keller", "seed"};

enum class CouplingPreset { standard, seed };
inline constexpr std::array<std::string_view, 2> coupling_preset_words{"standard", "seed"};

enum class Switch { automatic, on, off };
inline constexpr std::array<std::string_view, 3> switch_words{"auto", "on", "off"};

enum class AddedMass { automatic, on, off, zuber };
inline constexpr std::array<std::string_view, 4> added_mass_words{"auto", "on", "off", "zuber"};

enum class Feedback { two_way, one_way };
inline constexpr std::array<std::string_view, 2> feedback_words{"two_way", "one_way"};

/// Films of fluid between surfaces that are near.
struct Lubrication {
    Width roughness{0.001, true}, range{0.1, true};
    bool operator==(const Lubrication&) const = default;
};

struct Coupling {
    Feedback feedback = Feedback::two_way;
    CouplingMode mode = CouplingMode::automatic;
    Width filter{2.0, true};
    CouplingPreset preset = CouplingPreset::standard;
    std::optional<DragLaw> drag;     ///< Without it, the preset's.
    std::optional<MagnusLaw> magnus; ///< Without it, the preset's.
    AddedMass added_mass = AddedMass::automatic;
    Switch size_mixture = Switch::automatic, lift = Switch::automatic, shear_lift = Switch::automatic, torque = Switch::automatic,
           history = Switch::automatic, dispersion = Switch::automatic, own_disturbance = Switch::automatic;
    std::optional<Lubrication> lubrication;
    bool operator==(const Coupling&) const = default;

    [[nodiscard]] DragLaw chosen_drag() const;
    [[nodiscard]] MagnusLaw chosen_magnus() const;
};

void describe(Schema& s, Lubrication& p);
void describe(Schema& s, Coupling& p);

} // namespace io
