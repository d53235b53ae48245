// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/motion.hpp"

namespace core {

Motion Motion::inverse() const
{
    Motion back(turns ? Vec3(-(turn.transpose() * shift)) : Vec3(-shift));
    back.turn = turn.transpose();
    back.turns = turns;
    return back;
}

Motion Motion::then(const Motion& next) const
{
    Motion both(next.of_vector(shift) + next.shift);
    both.turns = turns || next.turns;
    if (both.turns) both.turn = next.turn * turn;
    return both;
}

bool Motion::is_same(const Motion& other) const
{
    constexpr double round_off = 1e-9;
    return (shift - other.shift).norm() < round_off * (1 + shift.norm()) && (turn - other.turn).norm() < round_off;
}

Motion PeriodicTurn::motion() const
{
    Motion m;
    m.turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    m.shift = point - m.turn * point;
    m.turns = true;
    return m;
}

} // namespace core
