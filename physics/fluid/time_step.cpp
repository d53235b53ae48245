// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/time_step.hpp"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

/// Component m of the velocity in index space, along a row.
class IndexVelocityRow {
public:
    IndexVelocityRow(const core::BlockGeometry& geometry, core::VectorView<const double> u, int m, int j, int k)
        : ax_(geometry.inverse_jacobian[std::size_t(m)][0].view().row(j, k)), ay_(geometry.inverse_jacobian[std::size_t(m)][1].view().row(j, k)),
          az_(geometry.inverse_jacobian[std::size_t(m)][2].view().row(j, k)), x_(u.x.row(j, k)), y_(u.y.row(j, k)), z_(u.z.row(j, k))
    {
    }
    [[nodiscard]] double operator()(int i) const { return ax_[i] * x_[i] + ay_[i] * y_[i] + az_[i] * z_[i]; }

private:
    const double *ax_, *ay_, *az_, *x_, *y_, *z_;
};

} // namespace

TransportRates transport_rates(const core::BlockGeometry& geometry, core::VectorView<const double> velocity)
{
    const core::Extents n = geometry.cells;
    double displacement = 0, distortion = 0;
    for (int m = 0; m < 3; ++m)
        for (int k = 0; k < n.nk; ++k)
            for (int j = 0; j < n.nj; ++j) {
                const IndexVelocityRow here(geometry, velocity, m, j, k);
                const IndexVelocityRow next_j(geometry, velocity, m, std::min(j + 1, n.nj - 1), k);
                const IndexVelocityRow next_k(geometry, velocity, m, j, std::min(k + 1, n.nk - 1));
#pragma omp simd reduction(max : displacement, distortion)
                for (int i = 0; i < n.ni; ++i) {
                    const double u = here(i);
                    const double across = std::max(std::abs(next_j(i) - u), std::abs(next_k(i) - u));
                    displacement = std::max(displacement, std::abs(u));
                    distortion = std::max(distortion, std::max(across, std::abs(here(std::min(i + 1, n.ni - 1)) - u)));
                }
            }
    return {displacement, distortion};
}

TimeStepLimit time_step_limit(const TransportRates& rates, const TimeStepOptions& options)
{
    TimeStepLimit limit{options.largest, "largest"};
    const auto tighten = [&](double dt, std::string_view name) {
        if (dt < limit.dt) limit = {dt, name};
    };
    if (rates.displacement > 0) tighten(options.displacement / rates.displacement, "displacement");
    if (rates.distortion > 0) tighten(options.distortion / rates.distortion, "distortion");
    return limit;
}

} // namespace physics
