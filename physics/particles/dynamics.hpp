// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The moving particles of one rank and the lists of who may touch whom: the parts of a sub-step, without messages.
#include "physics/particles/contact_measure.hpp"
#include "physics/particles/newton.hpp"
#include "physics/particles/surface_contacts.hpp"
#include "physics/particles/walls.hpp"

#include <limits>
#include <optional>
#include <variant>

namespace physics {

using Motion = std::variant<DryMotion, WetMotion>;

/// Sub-steps run in this order: start() once; then, for each sub-step, lists up to date (needs_check(), rebuild()), ghosts
/// up to date, advance(), account(). Lists never change a result, only its cost.
class ParticleDynamics {
public:
    /// @param step  Sub-step [s]. @throws core::ConfigError for parameters out of range.
    ParticleDynamics(const core::Domain& domain, const ParticleParameters& parameters, std::vector<Wall> walls, double step);

    /// Adds a surface to the walls. @pre before the first sub-step
    /// @param report  Which of the loads its own is; none if negative.
    void add_surface(WallSurface surface, const WallMotion& motion = {}, int report = -1);
    /// Says on which side of the surface that was added last particles are.
    void set_side(SurfaceSide side) { surfaces_.back().set_side(std::move(side)); }
    /// Which of the reported walls is a surface that a sphere touches; -1 if none is.
    [[nodiscard]] int surface_at(const core::Vec3& centre, double radius) const;
    /// Which of them is a closed surface that a place is on the wrong side of; -1 if none is.
    [[nodiscard]] int surface_around(const core::Vec3& centre) const;
    /// Moves the surfaces to where they are at a time, for these two.
    void place_surfaces(double time);
    [[nodiscard]] bool has_surfaces() const { return !surfaces_.empty(); }
    /// Makes room for the loads of `walls` walls that are reported.
    void report_walls(int walls) { reports_ = walls; }
    /// Loads of the walls that are reported by the particles of this rank, summed over load_steps() sub-steps: those of the last batch.
    [[nodiscard]] std::vector<WallLoad> loads() const;
    [[nodiscard]] int load_steps() const { return load_steps_; }

    core::ParticleSet particles;
    core::ContactHistory history; ///< Springs while no list is valid: before the first build, and during a rebuild.

    [[nodiscard]] const core::Domain& domain() const { return domain_; }
    [[nodiscard]] double step() const { return step_; }
    /// Where the energy of the particles goes, in scenes that keep a budget.
    [[nodiscard]] const EnergyColumns& energy() const { return energy_; }
    /// @pre no batch of sub-steps has been begun
    void set_step(double step);

    /// Says when the sub-steps of the next batch are. @param time  At its beginning [s]; without it walls stand as at t = 0.
    void begin(std::optional<double> time);
    /// Brings the walls to where they are when the forces of `sub_step` act.
    void move_walls(int sub_step);
    /// The longest sub-step in which a particle of this speed cannot jump through another, or a wall at rest: it moves by 0.15 of the
    /// smallest radius, within its octave [s]. @param speed2  Greatest square of speed of all ranks [m2/s2].
    [[nodiscard]] double longest_step(double speed2) const;

    /// First half drift of a batch of sub-steps. @returns the greatest square of speed of this rank [m2/s2].
    double start(const core::Team& team);
    /// One sub-step of all owned particles. Half a drift follows the kick, a whole one unless it is the `last` of the batch.
    /// @returns the greatest square of speed of this rank [m2/s2].
    double advance(const Motion& motion, const core::Team& team, int sub_step, int sub_steps);
    /// To be called when ghosts have moved.
    void ghosts_moved()
    {
        if (planned_threads_ > 0) records_.update_ghosts(particles);
    }
    /// Books the way that the fastest particle may have gone. @param speed2  Greatest square of speed of all ranks [m2/s2].
    void account(double speed2, double time);
    /// True when some pair outside the lists might touch, judged by speeds; the same answer on all ranks.
    [[nodiscard]] bool needs_check() const { return !built_ || 2.0 * (travelled_ + wall_way_) >= skin_; }
    /// A bound on the displacement of any owned particle since the last rebuild, true but for single precision [m].
    [[nodiscard]] double displacement(const core::Team& team) const;
    /// Goes on with the lists if the greatest displacement of all ranks allows. @returns false if a rebuild must follow.
    [[nodiscard]] bool keep_lists(double greatest_displacement);

    /// Moves all springs to `history`, drops ghosts and lists, and brings owned particles back into a periodic domain.
    void dissolve(const core::Team& team = core::SerialTeam{});
    /// Drops ghosts and lists with all their springs: to be followed by setting particles and history anew.
    void forget_lists();
    /// Bounds of the owned particles [m].
    [[nodiscard]] core::Bounds bounds() const;
    /// Chooses the reach of the lists and their bins, the same on all ranks, and sorts the owned particles into them. @pre dissolve()
    /// @param bounds, greatest, count  Of all ranks: where particles are, greatest radius [m] and number in each octave of radii.
    void sort(const core::Bounds& bounds, const core::Octaves& greatest, const core::Octaves& count);
    /// Makes all lists from owned particles and ghosts. @pre sort(), ghosts in place
    void build(const core::Team& team);

    [[nodiscard]] const core::LevelBins& bins() const { return bins_; }

    /// Keeps what contacts come to at the end of each batch in columns of the particles. @pre before the first sub-step
    void watch_contacts() { contact_columns_ = add_contact_columns(particles); }
    /// None unless contacts are watched.
    [[nodiscard]] const std::optional<ContactColumns>& contact_columns() const { return contact_columns_; }
    /// Sets the columns of watched contacts; nothing without. @pre the batch is finished, its lists are still there
    void measure_watched(const core::Team& team);
    /// All pairs that may touch before the next rebuild, for reports and tests.
    [[nodiscard]] const core::PairList& pairs() const { return pairs_; }

    /// Memory of particles, pairs and forces on this rank [bytes].
    [[nodiscard]] std::size_t bytes() const;

private:
    void set_reach(double radius);
    /// Gap at which two may act on each other when they have gone up to `skin` [m].
    [[nodiscard]] double reach(double skin) const { return parameters_.film.range + skin; }
    void refresh_near(const core::Team& team);
    void plan_chunks(int threads);
    /// What is summed beside forces.
    struct Account {
        EnergySums* energy; ///< Null where no budget is kept.
        WallShares* shares; ///< Null but in sub-steps whose contacts are measured.
    };
    void sum_chunk(int segment, int chunk, ForceSums& sums, const Account& account);
    template <class M>
    double advance_as(const M& motion, const core::Team& team, const DriftTimes& times);

    core::Domain domain_;
    ParticleParameters parameters_;
    double step_;
    ContactLaws pair_laws_, wall_laws_;
    WallContacts walls_;
    std::vector<SurfaceContacts> surfaces_;
    int reports_ = 0, load_steps_ = 0;
    std::vector<WallLoad> loads_; // of each segment, reports_ of them
    std::array<core::Vec3, 27> shifts_;
    EnergyColumns energy_;
    double least_radius_ = std::numeric_limits<double>::infinity(); // greatest radius of the octave of the smallest
    double skin_ = 0.0, near_skin_ = 0.0;
    core::LevelBins bins_;
    core::PairList pairs_;
    core::NearPairs near_;
    core::ChunkPlan chunks_;
    core::PairSlots slots_;
    PairForces forces_;
    MotionRecords records_;
    std::array<std::vector<float>, 3> reference_; // positions at the last rebuild, from the low corner of `extent_`
    bool built_ = false, near_built_ = false;
    double travelled_ = 0.0, near_travelled_ = 0.0;
    std::optional<double> begin_; // time at the beginning of the batch
    core::Bounds extent_;         // of all that can meet a wall before the next rebuild
    double wall_way_ = 0.0, near_wall_way_ = 0.0;
    int planned_threads_ = 0;
    std::optional<ContactColumns> contact_columns_;
};

} // namespace physics
