// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/region_keys.hpp"
#include "io/scene/schema.hpp"

namespace io {

void describe(Schema& s, CylinderKeys& p)
{
    s.required("from", p.from, "m", "Point on the axis where the cylinder begins");
    s.required("to", p.to, "m", "Point on the axis where it ends");
    s.required("radius", p.radius, "m", "Its radius", positive);
}

void describe(Schema& s, SphereKeys& p)
{
    s.required("centre", p.centre, "m", "Its centre");
    s.required("radius", p.radius, "m", "Its radius", positive);
}

void describe(Schema& s, RegionKeys& p)
{
    s.value("low", p.low, "m", "Low corner of the region of their centres; without it, that of the domain");
    s.value("high", p.high, "m", "High corner of the region of their centres; without it, that of the domain");
    s.group("cylinder", p.cylinder, "Instead of a box, a cylinder as the region of their centres");
    s.group("sphere", p.sphere, "Instead of a box, a sphere as the region of their centres");
}

physics::Region RegionKeys::region(const core::Domain& domain) const
{
    if (cylinder) return physics::CylinderRegion{cylinder->from - domain.origin, cylinder->to - domain.origin, cylinder->radius};
    if (sphere) return physics::SphereRegion{sphere->centre - domain.origin, sphere->radius};
    return physics::BoxRegion{low ? core::Vec3(*low - domain.origin) : core::Vec3(core::Vec3::Zero()),
                              high ? core::Vec3(*high - domain.origin) : domain.size};
}

} // namespace io
