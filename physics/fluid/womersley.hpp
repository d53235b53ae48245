// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The exact oscillating laminar flow in a round pipe.
#include <complex>

namespace physics {

/// I_0(w) exp(-w), the scaled modified Bessel function, to 1e-12 relative for Re w >= 0; J_0(i w) = I_0(w).
[[nodiscard]] std::complex<double> scaled_bessel_0(std::complex<double> w);
/// I_1(w) exp(-w), likewise; J_1(i w) = i I_1(w).
[[nodiscard]] std::complex<double> scaled_bessel_1(std::complex<double> w);

/// Periodic flow under the acceleration P cos(omega t) along the pipe:
/// u = Re { P / (i omega) [1 - J_0(i^{3/2} alpha r / R) / J_0(i^{3/2} alpha)] exp(i omega t) }, alpha = R sqrt(omega / nu).
/// @source  Sexl (1930), Z. Phys. 61, 349; Womersley (1955), J. Physiol. 127, 553.
class WomersleyFlow {
public:
    struct Parameters {
        double radius;            ///< [m]
        double viscosity;         ///< kinematic [m2/s]
        double acceleration;      ///< P [m/s2]
        double angular_frequency; ///< [rad/s]
    };
    /// @throws core::ConfigError unless radius, viscosity and angular frequency are positive.
    explicit WomersleyFlow(const Parameters& parameters);

    [[nodiscard]] double alpha() const { return alpha_; }
    /// u = Re(amplitude exp(i omega t)) at a distance r <= R from the axis [m/s].
    [[nodiscard]] std::complex<double> amplitude(double r) const;
    /// The same of the mean over the section.
    [[nodiscard]] std::complex<double> mean_amplitude() const;
    /// exp(i omega t)
    [[nodiscard]] std::complex<double> phase(double time) const { return std::polar(1.0, parameters_.angular_frequency * time); }
    [[nodiscard]] double velocity(double r, double time) const { return std::real(amplitude(r) * phase(time)); }

private:
    [[nodiscard]] std::complex<double> inviscid() const { return {0.0, -parameters_.acceleration / parameters_.angular_frequency}; }

    Parameters parameters_;
    double alpha_;
    std::complex<double> wall_; ///< sqrt(i) alpha
};

} // namespace physics
