// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Checks of what a scene says of its contacts.
#include "io/build/contact_builder.hpp"
#include "io/build/wall_materials.hpp"
#include "io/scene/scene_reader.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace io {
namespace {

class ContactChecker {
public:
    ContactChecker(const Scene& scene, const Locations& locations, Problems& problems)
        : contact_(*scene.contact), scene_(scene), locations_(locations), problems_(problems)
    {
        const auto add = [&](const std::string& name) {
            if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
        };
        for (const Species& species : scene.particles) add(material_of(species));
        of_species_ = names_.size();
        const WallMaterials walls(scene);
        for (const std::string& wall : walls.names()) add(wall);
    }

    void check()
    {
        check_contact_sides(scene_, locations_, problems_);
        check_materials();
        check_pairs();
        if (!locations_.good("contact")) return;
        const bool any_linear = uses(ContactLaw::linear), any_hertz = uses(ContactLaw::hertz);
        if (any_linear) check_linear();
        else {
            refuse("contact.stiffness", contact_.stiffness.has_value(), "hertz");
            refuse("contact.collision_time", contact_.collision_time.has_value(), "hertz");
        }
        if (any_hertz) check_hertz();
        else {
            refuse("contact.young_modulus", contact_.young_modulus.has_value(), "linear");
            refuse("contact.poisson_ratio", contact_.poisson_ratio.has_value(), "linear");
            refuse("contact.impact_speed", contact_.impact_speed.has_value(), "linear");
        }
    }

private:
    void complain(const std::string& path, const std::string& message, const std::string& hint)
    {
        problems_.add(locations_.at(path), message, hint);
    }

    void refuse(const std::string& path, bool given, std::string_view law)
    {
        const std::string key = path.substr(path.find('.') + 1);
        if (given) complain(path, fmt::format("'{}' means nothing for law: {}", key, law), "remove it, or change the law");
    }

    bool check_name(const std::string& path, const std::string& name)
    {
        if (std::find(names_.begin(), names_.end(), name) != names_.end()) return true;
        for (const Species& species : scene_.particles)
            if (species.name == name) {
                complain(path, fmt::format("'{}' is of the material '{}'", name, species.material), "name the material");
                return false;
            }
        const auto named = [&](const WallKeys& wall) { return wall.name == name; };
        const bool is_wall = std::any_of(scene_.walls.begin(), scene_.walls.end(), named);
        complain(path, fmt::format("nothing is made of '{}'", name), is_wall ? "give that wall a 'material'" : suggestion(name, names_));
        return false;
    }

    void check_materials()
    {
        std::set<std::string> seen;
        for (std::size_t n = 0; n < contact_.materials.size(); ++n) {
            const std::string path = fmt::format("contact.materials.{}.of", n), &name = contact_.materials[n].of;
            if (!locations_.good(path) || !check_name(path, name)) continue;
            if (!seen.insert(name).second) complain(path, fmt::format("the material of '{}' is given twice", name), "keep one of them");
        }
    }

    void check_pairs()
    {
        std::set<std::set<std::string>> seen;
        for (std::size_t n = 0; n < contact_.pairs.size(); ++n) {
            const std::string path = fmt::format("contact.pairs.{}.between", n);
            const auto& [one, other] = contact_.pairs[n].between;
            if (!locations_.good(path) || !check_name(path, one) || !check_name(path, other)) continue;
            if (is_of_walls_alone(one) && is_of_walls_alone(other))
                complain(path, "walls do not meet each other", "name what particles are made of");
            else if (!seen.insert({one, other}).second)
                complain(path, fmt::format("the pair of '{}' and '{}' is given twice", one, other), "keep one of them");
        }
    }

    [[nodiscard]] bool is_of_walls_alone(const std::string& name) const
    {
        const auto end = names_.begin() + std::ptrdiff_t(of_species_);
        return std::find(names_.begin(), end, name) == end;
    }

    [[nodiscard]] const ContactPair* pair_of(const std::string& a, const std::string& b) const
    {
        for (const ContactPair& pair : contact_.pairs)
            if ((pair.between[0] == a && pair.between[1] == b) || (pair.between[0] == b && pair.between[1] == a)) return &pair;
        return nullptr;
    }

    /// Calls visit(a, b, law, pair) for all that may meet; pair is null where nothing is different.
    template <class Visit>
    void for_each_pair(Visit visit) const
    {
        for (std::size_t a = 0; a < of_species_; ++a)
            for (std::size_t b = a; b < names_.size(); ++b) {
                const ContactPair* pair = pair_of(names_[a], names_[b]);
                visit(names_[a], names_[b], pair && pair->law ? *pair->law : contact_.law, pair);
            }
    }

    [[nodiscard]] bool uses(ContactLaw law) const
    {
        bool found = false;
        for_each_pair([&](const auto&, const auto&, ContactLaw its, const ContactPair*) { found = found || its == law; });
        return found;
    }

    void check_linear()
    {
        if (contact_.stiffness && contact_.collision_time)
            return complain("contact.collision_time", "'collision_time' excludes 'stiffness'", "keep one of the two");
        for (const Species& species : scene_.particles)
            if (contact_.collision_time && !has_sizes(species))
                complain("contact.collision_time", fmt::format("'collision_time' needs the sizes of '{}'", species.name),
                         "give the stiffness instead");
        if (contact_.stiffness || contact_.collision_time) return;
        std::string missing;
        bool some = false;
        for_each_pair([&](const std::string& a, const std::string& b, ContactLaw law, const ContactPair* pair) {
            const bool has = pair && pair->stiffness;
            some = some || has;
            if (law == ContactLaw::linear && !has && missing.empty()) missing = fmt::format(" between '{}' and '{}'", a, b);
        });
        if (!missing.empty())
            complain("contact", "law: linear needs 'stiffness'" + (some ? missing : ""),
                     "add stiffness: 5 kN/m, or collision_time: 0.1 ms");
    }

    void check_hertz()
    {
        const auto has_material = [&](const std::string& name) {
            return std::any_of(contact_.materials.begin(), contact_.materials.end(), [&](const auto& m) { return m.of == name; });
        };
        const bool for_all = contact_.young_modulus && contact_.poisson_ratio;
        std::set<std::string> missing;
        for_each_pair([&](const std::string& a, const std::string& b, ContactLaw law, const ContactPair*) {
            for (const auto& name : {a, b})
                if (law == ContactLaw::hertz && !for_all && !has_material(name)) missing.insert(name);
        });
        if (!missing.empty())
            complain("contact", fmt::format("law: hertz needs 'young_modulus' and 'poisson_ratio' of '{}'", *missing.begin()),
                     "add young_modulus: 10 MPa, poisson_ratio: 0.25");
        if (locations_.good("grid") && locations_.good("particles") && locations_.good("fluid") && impact_speed(scene_) == 0.0)
            complain("contact", "law: hertz needs 'impact_speed' where nothing moves and nothing falls",
                     "add impact_speed: 1 m/s, that of the fastest impacts");
    }

    const Contact& contact_;
    const Scene& scene_;
    const Locations& locations_;
    Problems& problems_;
    std::vector<std::string> names_; ///< Materials: of all species, then those of walls alone.
    std::size_t of_species_ = 0;     ///< How many are of species.
};

} // namespace

void check_contact(const Scene& scene, const Locations& locations, Problems& problems)
{
    if (scene.contact && !scene.particles.empty()) ContactChecker(scene, locations, problems).check();
}

} // namespace io
