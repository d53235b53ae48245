// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/study/study_orders.hpp"
#include <algorithm>
#include <cmath>

namespace io {
namespace {

constexpr double same_size = 1e-6; // relative: h and dt that differ less are the same

bool larger(double a, double b) { return a > b * (1 + same_size); }
bool same(double a, double b) { return !larger(a, b) && !larger(b, a); }

/// Do the two runs differ in one choice only?
bool neighbours(const StudyRun& a, const StudyRun& b)
{
    int differences = 0;
    for (std::size_t n = 0; n < a.choice.size(); ++n) differences += a.choice[n] != b.choice[n];
    return differences == 1;
}

/// The run that differs from `run` in one choice only and has the next larger size, all other sizes the same.
const StudyRun* next_coarser(const std::vector<StudyRun>& runs, const StudyRun& run, double StudyRun::*size, double StudyRun::*other)
{
    const StudyRun* best = nullptr;
    for (const StudyRun& r : runs)
        if (neighbours(r, run) && larger(r.*size, run.*size) && same(r.*other, run.*other) && (best == nullptr || r.*size < best->*size))
            best = &r;
    return best;
}

double distance(const StudyRun& a, const StudyRun& b, const core::Communicator& ranks)
{
    double squares = 0;
    for (std::size_t n = 0; n < a.trace.size(); ++n) squares += (a.trace[n] - b.trace[n]) * (a.trace[n] - b.trace[n]);
    ranks.sum(std::span(&squares, 1));
    return std::sqrt(squares);
}

} // namespace

std::optional<double> order_from_differences(const std::array<double, 3>& steps, double first, double second)
{
    if (!(first > 0 && second > 0)) return {};
    const auto ratio = [&](double p) {
        return (std::pow(steps[0], p) - std::pow(steps[1], p)) / (std::pow(steps[1], p) - std::pow(steps[2], p));
    };
    double low = 0.01, high = 12.0; // the ratio grows with the order
    const double wanted = first / second;
    if (wanted <= ratio(low) || wanted >= ratio(high)) return {};
    for (int n = 0; n < 60; ++n) {
        const double middle = 0.5 * (low + high);
        (ratio(middle) < wanted ? low : high) = middle;
    }
    return low;
}

std::vector<ObservedOrders> observed_orders(const std::vector<StudyRun>& runs, const core::Communicator& ranks)
{
    std::vector<ObservedOrders> orders(runs.size());
    for (std::size_t n = 0; n < runs.size(); ++n) {
        const StudyRun& run = runs[n];
        if (const StudyRun* coarse = next_coarser(runs, run, &StudyRun::h, &StudyRun::dt); coarse != nullptr && run.error.e_2 > 0)
            orders[n].h = std::log(coarse->error.e_2 / run.error.e_2) / std::log(coarse->h / run.h);
        const StudyRun* middle = next_coarser(runs, run, &StudyRun::dt, &StudyRun::h);
        const StudyRun* coarse = middle == nullptr ? nullptr : next_coarser(runs, *middle, &StudyRun::dt, &StudyRun::h);
        if (coarse != nullptr)
            orders[n].dt =
                order_from_differences({coarse->dt, middle->dt, run.dt}, distance(*coarse, *middle, ranks), distance(*middle, run, ranks));
    }
    return orders;
}

std::vector<bool> pareto_front(const std::vector<StudyRun>& runs)
{
    std::vector<bool> front(runs.size());
    for (std::size_t n = 0; n < runs.size(); ++n)
        front[n] = !runs[n].is_reference && std::none_of(runs.begin(), runs.end(), [&](const StudyRun& r) {
            return !r.is_reference && r.error.e_2 < runs[n].error.e_2 && r.core_seconds() < runs[n].core_seconds();
        });
    return front;
}

} // namespace io
