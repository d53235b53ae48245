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
        : ax_(geometry.inverse_jacobian[std::size_t(m)][0].view().row(j, k)),
          ay_(geometry.inverse_jacobian[std::size_t(m)][1].view().row(j, k)),
          az_(geometry.inverse_jacobian[std::size_t(m)][2].view().row(j, k)),
          x_(u.x.row(j, k)),
          y_(u.y.row(j, k)),
          z_(u.z.row(j, k))
    {
    }
    [[nodiscard]] double operator()(int i) const { return ax_[i] * x_[i] + ay_[i] * y_[i] + az_[i] * z_[i]; }

private:
    const double *ax_, *ay_, *az_, *x_, *y_, *z_;
};

/// Largest acceleration in index space that one of given magnitudes may mean [cells/s2].
struct IndexAcceleration {
    double along_axis = 0; ///< along one axis
    double of_all = 0;     ///< summed over the axes
};

IndexAcceleration index_acceleration(const core::BlockGeometry& geometry, const core::Vec3& pull)
{
    IndexAcceleration largest;
    if (pull.isZero()) return largest;
    core::for_each_cell(geometry.cells, [&](int i, int j, int k) {
        double sum = 0;
        for (const auto& row : geometry.inverse_jacobian) {
            double a = 0;
            for (std::size_t n = 0; n < 3; ++n) a += std::abs(row[n](i, j, k) * pull[int(n)]);
            largest.along_axis = std::max(largest.along_axis, a);
            sum += a;
        }
        largest.of_all = std::max(largest.of_all, sum);
    });
    return largest;
}

} // namespace

TransportRates transport_rates(const core::BlockGeometry& geometry, core::VectorView<const double> velocity, const core::Vec3& pull)
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
    const IndexAcceleration growth = index_acceleration(geometry, pull);
    return {displacement, distortion, growth.along_axis, 0, growth.of_all};
}

double time_to_reach(double bound, double rate, double growth)
{
    if (growth <= 0) return rate > 0 ? bound / rate : std::numeric_limits<double>::infinity();
    return 2 * bound / (rate + std::sqrt(rate * rate + 4 * growth * bound));
}

TimeStepLimit time_step_limit(const TransportRates& rates, const TimeStepOptions& options)
{
    TimeStepLimit limit{options.largest, "largest"};
    limit.tighten(time_to_reach(options.displacement, rates.displacement, rates.growth), "displacement");
    limit.tighten(time_to_reach(options.distortion, rates.distortion, 0), "distortion");
    return limit;
}

TimeStepLimit outflow_step_limit(const TransportRates& rates, const TimeStepOptions& options)
{
    TimeStepLimit limit{options.largest, "largest"};
    limit.tighten(time_to_reach(options.outflow, rates.outflow, rates.outflow_growth), "outflow of cells");
    return limit;
}

} // namespace physics
