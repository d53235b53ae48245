// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/world.hpp"
#include "core/base/error.hpp"
#include "io/build/coupling_builder.hpp"
#include "io/build/grid_builder.hpp"
#include "io/build/physics_builder.hpp"
#include "io/run/finite_check.hpp"
#include "io/run/initial_grains.hpp"
#include "io/run/world_grains.hpp"
#include "io/run/world_walls.hpp"
#include "physics/particles/advance.hpp"
#include "physics/steps/grain_job.hpp"
#include <algorithm>
#include <cmath>

namespace io {
namespace {

/// The cell that holds the middle of the low end of the drive's axis.
std::optional<core::Location> axis_cell(const core::Locator& locator, const Grid& grid, const core::Vec3& direction)
{
    const core::Vec3 middle = 0.5 * (grid.low() + grid.high());
    const core::Vec3 end = middle - 0.5 * (grid.high() - grid.low()).cwiseProduct(direction.cwiseAbs()) * (1 - 1e-9);
    return locator.find(end);
}

/// Grains alone, each in the end on the rank that owns its place.
void settle_grains(physics::ParticleStepper& stepper, const core::Vec3& gravity, int sub_steps, const core::Team& team,
                   const core::Communicator& ranks)
{
    const core::Communicator messages = ranks.duplicate();
    physics::settle(stepper, physics::DryMotion{gravity}, sub_steps, team, messages);
    physics::hand_over(stepper, team, messages);
}

} // namespace

World::World(const Scene& scene, const core::Communicator& ranks) : World(scene, make_blocks(scene.grid), ranks) {}

World::World(const Scene& scene, core::MultiBlock blocks, const core::Communicator& ranks)
    : scene_(scene),
      ranks_(ranks),
      mesh_(std::move(blocks), ranks.rank(), ranks.size()),
      locator_(mesh_),
      halos_(mesh_, ranks_),
      graph_(layout(), ranks_)
{
    graph_.fill_halos_with(halos_);
    if (scene_.fluid) {
        fluid_.emplace(mesh_, ranks_, halos_, fluid_parameters(scene_));
        const core::Vec3 direction = physics::drive_direction(fluid_->parameters().drive);
        if (direction.norm() > 0) axis_ = axis_cell(locator_, scene_.grid, direction);
    }
    if (!scene_.particles.empty()) make_grains();
    if (fluid_ && grains_) make_coupling();
    if (fluid_) make_company();
}

void World::make_grains()
{
    const core::Domain domain = make_domain(scene_.grid);
    const std::vector<core::Sphere> of_files = grains_of_files(scene_, domain, ranks_);
    census_ = census_of(scene_);
    for (const core::Sphere& grain : of_files) census_.add(grain);
    grains_.emplace(make_dynamics(scene_, census_, mesh_));
    const std::vector<core::Sphere> grains = initial_grains(scene_, of_files, *grains_);
    traffic_.emplace(scene_, domain, std::int64_t(grains.size()));
    if (!scene_.grid.is_primitive()) require_inside(locator_, domain, grains);
    require_clear_of_walls(scene_.walls, grains, *grains_);
    bed_contact_ = bed_contact(scene_, census_, particle_parameters(scene_));
    contact_step_ = grains_->step();
    if (const auto speed = impact_speed(scene_); scene_.contact->law == ContactLaw::hertz && !scene_.contact->impact_speed)
        notes_.push_back(
            core::text("sub-steps of the grains are made for impacts of up to ", speed, " m/s: contact.impact_speed changes it"));
    const physics::OwnerOf owner_of = [this](const core::Vec3& x) { return this->owner_of(x); };
    if (scene_.measures(GrainMeasure::contacts)) grains_->watch_contacts();
    add_grains(grains, owner_of, ranks_.rank(), *grains_);
    stepper_.emplace(*grains_, owner_of, ranks_.rank(), ranks_.size());
}

tasks::Layout World::layout() const
{
    tasks::Layout layout;
    for (const core::Extents e : mesh_.own_cells()) layout.cells.push_back(e.size());
    return layout;
}

std::optional<core::Location> World::location_of(const core::Vec3& position) const
{
    core::Vec3 inside = position;
    for (int a = 0; a < 3; ++a) inside[a] = grains_->domain().wrapped(a, position[a]);
    return locator_.find(inside + grains_->domain().origin);
}

int World::owner_of(const core::Vec3& position) const { return locator_.owner(position + grains_->domain().origin); }

void World::make_coupling()
{
    const physics::CouplingParameters parameters = coupling_parameters(scene_, census_);
    if (is_one_way(scene_)) {
        one_way_.emplace(locator_, ranks_, halos_, *fluid_, *grains_, *stepper_, parameters);
        return;
    }
    coupling_.emplace(locator_, ranks_, halos_, *fluid_, *grains_, *stepper_, parameters);
    asked_mode_ = asked_mode(scene_);
}

/// What the fluid has beside its momentum.
void World::make_company()
{
    if (scene_.fluid->is_turbulent()) turbulence_.emplace(mesh_, *fluid_, turbulence_parameters(scene_), coupling());
    if (!scene_.fluid->scalars.empty()) scalars_.emplace(mesh_, *fluid_, scalar_parameters(scene_), coupling(), ranks_);
    if (turbulence_ && one_way_) turbulence_->act_on_grains();
    if (turbulence_ && exchange() && exchange()->disperses())
        (one_way_ ? one_way_->views() : coupling_->views()).see_turbulence(turbulence_->k(), turbulence_->epsilon());
    if (coupling_) coupling_->keep_company(company());
}

physics::StepCompany World::company()
{
    return {[this](tasks::StageGraph& graph) {
                if (turbulence_) turbulence_->declare_before(graph);
                if (scalars_) scalars_->declare_before(graph);
            },
            [this](tasks::StageGraph& graph) {
                if (turbulence_) turbulence_->declare(graph);
            }};
}

double World::settling_left() const { return grains_ ? std::max(0.0, std::ceil(scene_.run.settle / contact_step_) - settled_) : 0.0; }

void World::settle_batch(const core::Team& team)
{
    // About a second of one core, yet enough sub-steps to make up for bringing every grain to its rank after them.
    const double batch = std::max(20.0, std::floor(1e7 / double(std::max<std::int64_t>(census_.count, 1))));
    const int sub_steps = int(std::min(settling_left(), batch));
    if (sub_steps == 0) return;
    set_sub_step(contact_step_);
    settle_grains(*stepper_, settling_gravity(scene_, census_), sub_steps, team, ranks_);
    settled_ += sub_steps;
    require_finite(*this);
}

void World::settle(const core::Team& team)
{
    if (settling_left() > 0) set_sub_step(contact_step_);
    while (settling_left() > 0) {
        const int sub_steps = int(std::min(settling_left(), 1e9));
        settle_grains(*stepper_, settling_gravity(scene_, census_), sub_steps, team, ranks_);
        settled_ += sub_steps;
    }
}

void World::declare()
{
    if (coupling_) {
        coupling_->declare(graph_, planned_mode_);
        if (scalars_) scalars_->declare(graph_);
    } else if (one_way_) {
        one_way_->declare(graph_, company());
        if (scalars_) scalars_->declare(graph_);
    } else if (fluid_) {
        const physics::StepCompany others = company();
        others.before(graph_);
        fluid_->declare(graph_);
        others.after(graph_);
        if (scalars_) scalars_->declare(graph_);
    } else if (grains_) {
        dry_grains_.emplace("grains", *grains_);
        graph_.whole(
            "move grains",
            [this](tasks::Lane& lane, physics::ParticleDynamics&) {
                return physics::move_grains(lane, *stepper_, physics::DryMotion{gravity_of(scene_)}, sub_steps_, time());
            },
            tasks::updates(*dry_grains_));
        graph_.sink(*dry_grains_);
    }
}

const tasks::Plan& World::compile()
{
    if (coupling_) plan_mode();
    declare();
    plan_.emplace(graph_.compile());
    if (coupling_ && planned_mode_ != physics::Mode::iterated) add_mode(physics::Mode::iterated);
    initialise();
    return *plan_;
}

void World::step(tasks::Executor& executor)
{
    constexpr int most_attempts = 3;
    if (traffic_ && traffic_->is_open()) pass_grains();
    before_.take(*this);
    for (int attempt = 1;; ++attempt) {
        try {
            try_step(executor);
            shortening_ = 1.0;
            return;
        } catch (const core::Error& error) { // on all ranks alike
            put_back();
            if (scene_.run.time_step || attempt == most_attempts) throw;
            shortening_ *= 0.5;
            warnings_.push_back(core::text(error.what(), "; tried again with half the time step"));
        }
    }
}

void World::put_back()
{
    if (stepper_) stepper_->give_up();
    before_.put_back(*this);
    initialise();
}

void World::initialise()
{
    if (!coupling_ && !one_way_) return;
    fluid_->begin_step();
    if (turbulence_) tasks::run(ranks_, core::SerialTeam(), [&](tasks::Lane& lane) { return turbulence_->find_viscosity(lane); });
    tasks::run(ranks_, core::SerialTeam(),
               [&](tasks::Lane& lane) { return coupling_ ? coupling_->initialise(lane) : one_way_->initialise(lane); });
    if (coupling_ && scalars_ && clock().step == 0) scalars_->begin(coupling_->fields().fraction);
}

void World::try_step(tasks::Executor& executor)
{
    auto& now = clock();
    now.dt = next_step();
    if (fluid_) fluid_->begin_step();
    if (coupling_) coupling_->sub_steps = sub_steps_;
    if (one_way_) one_way_->sub_steps = sub_steps_;
    const physics::Mode mode = coupling_ ? choose_mode() : planned_mode_;
    (mode == planned_mode_ ? executor : executor_of(mode)).run_step(now.step);
    now.advance();
    require_finite(*this);
    if (grains_) traffic_->check(grains_->particles, before_.particles(), ranks_);
    if (coupling_) ++steps_of_mode_[mode];
    if (fluid_ && axis_ && physics::turn_if_due(fluid_->parameters().drive, axis_speed(), now.time, now.drive)) now.steps_since_jump = 0;
}

/// Each takes the place of fluid, or leaves it to fluid, that moves as its neighbours do.
void World::pass_grains()
{
    const auto owner = [this](const core::Vec3& x) { return owner_of(x); };
    if (!traffic_->pass(clock().time, owner, *grains_, ranks_)) return;
    initialise();
    if (coupling_ && scalars_) scalars_->begin(coupling_->fields().fraction);
    if (after_traffic_) after_traffic_();
}

double World::axis_speed() const
{
    if (!axis_) return 0.0;
    const core::Vec3 direction = physics::drive_direction(fluid_->parameters().drive);
    double speed = 0.0;
    if (const core::LocalBlock b = mesh_.local(axis_->block); b >= 0) {
        const auto u = fluid_->state().velocity.on(b);
        speed = direction.dot(core::Vec3(u.x[axis_->cell], u.y[axis_->cell], u.z[axis_->cell]));
    }
    ranks_.sum(std::span(&speed, 1));
    return speed;
}

} // namespace io
