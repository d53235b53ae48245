// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/size_keys.hpp"
#include "io/scene/schema.hpp"

namespace io {
namespace {

std::vector<physics::SizePoint> points_of(const std::vector<std::array<double, 2>>& rows)
{
    std::vector<physics::SizePoint> points;
    for (const auto& [diameter, share] : rows) points.push_back({diameter, share});
    return points;
}

} // namespace

void describe(Schema& s, LognormalKeys& p)
{
    s.required("median", p.median, "m", "Diameter that half of them (of the number, or of the mass) do not exceed", positive);
    s.required("deviation", p.deviation, "1", "Geometric standard deviation: that of the logarithm of the diameter, as a factor",
               Range{1.0, 10.0, true});
    s.required("smallest", p.smallest, "m", "Diameter below which there are none", positive);
    s.required("largest", p.largest, "m", "Diameter above which there are none", positive);
}

void describe(Schema& s, SizeKeys& p)
{
    s.exactly_one({"list", "lognormal", "sieve"});
    s.required("share_of", "What shares are shares of, and a median is a median of: the number of the particles, or their mass",
               choice_of(p.share_of, share_of_words));
    s.value("list", p.list, "m", "Diameters, each with its share; the shares need not sum to 1");
    s.group("lognormal", p.lognormal, "A lognormal distribution between two ends");
    s.value("sieve", p.sieve, "m",
            "A sieve curve: diameters, each with the share that passes, from 0 to 1; in between it is straight over "
            "the logarithm of the diameter");
}

physics::SizeDistribution SizeKeys::distribution() const
{
    if (lognormal)
        return physics::lognormal_sizes({lognormal->median, lognormal->deviation, lognormal->smallest, lognormal->largest}, share_of);
    return sieve.empty() ? physics::listed_sizes(points_of(list), share_of) : physics::sieved_sizes(points_of(sieve), share_of);
}

} // namespace io
