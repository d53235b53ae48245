// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The viscosity that turbulence adds: a factor on every face, or none in a scene without turbulence.
#include "core/field/field.hpp"
#include <optional>

namespace physics {

/// A resource of stages; without allocate() there are no factors, and no memory.
class ViscosityRatio {
public:
    explicit ViscosityRatio(std::span<const core::Extents> cells) : faces_({"viscosity ratio", "1", 0, false}, cells) {}

    /// Named apart from what graphs call for fields they touch: only turbulence needs it. All factors are 0 then.
    void begin() { faces_.allocate(), used_ = true; }
    [[nodiscard]] bool used() const { return used_; }
    [[nodiscard]] std::string_view name() const { return faces_.name(); }
    [[nodiscard]] std::size_t bytes() const { return used_ ? faces_.bytes() : 0; }

    /// Viscosity over that of the fluid; none: 1 everywhere.
    [[nodiscard]] std::optional<core::FaceView<const double>> on(core::LocalBlock b) const
    {
        return used_ ? std::optional<core::FaceView<const double>>(faces_.on(b)) : std::nullopt;
    }
    /// @pre used()
    [[nodiscard]] core::FaceView<double> on(core::LocalBlock b) { return faces_.on(b); }

private:
    core::FaceField faces_;
    bool used_ = false;
};

} // namespace physics
