// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A step as data: its stages in the order of the algorithm, each with what it reads and writes. The order in the text is
// the meaning; the graph keeps only that part of it which data require.
#include "tasks/plan.hpp"
#include "tasks/stage.hpp"
#include <deque>
#include <map>
#include <string>
#include <vector>

namespace tasks {

/// Fills halos from the neighbouring blocks; what lies behind it knows the topology and the messages.
class HaloFiller {
public:
    virtual ~HaloFiller() = default;
    /// Called while compiling, for every fill that is kept, in the order of the text. Collective.
    virtual void prepare(FieldRef, core::HaloReach) {}
    /// Fills what `reach` says or more around every block of this rank.
    [[nodiscard]] virtual Job fill(Lane& lane, FieldRef field, core::HaloReach reach) = 0;
};

class StageGraph {
public:
    /// @param ranks  All ranks that run the same stages; the graph makes message spaces of its own from it.
    StageGraph(Layout layout, const core::Communicator& ranks);
    StageGraph(const StageGraph&) = delete;
    StageGraph& operator=(const StageGraph&) = delete;

    /// A stage that was just declared.
    class Declared {
    public:
        Declared(StageGraph& graph, std::size_t index) : graph_(graph), index_(index) {}
        /// The stage acts outside the graph (files, pictures): kept whenever `label` is due, always if it is empty.
        void effect(std::string label = {}) { graph_.stages_[index_].effect = std::move(label); }

    private:
        StageGraph& graph_;
        std::size_t index_;
    };

    /// kernel(block, parts...) for every block of this rank, on any thread.
    template <class Kernel, class... Groups>
    requires BlockKernel<Kernel, Groups...> Declared each_block(std::string name, Kernel kernel, Groups... groups)
    {
        const auto accesses = std::tuple_cat(groups...);
        Stage stage = declare(std::move(name), accesses);
        stage.on_block = [kernel, accesses](LocalBlock b) {
            std::apply([&](const auto&... access) { kernel(b, access.on(b)...); }, accesses);
        };
        return add(std::move(stage));
    }

    /// kernel(lane, resources...) once on each rank; may use the team of its lane and, if it returns Job, messages.
    template <class Kernel, class... Groups>
    requires WholeKernel<Kernel, Groups...> Declared whole(std::string name, Kernel kernel, Groups... groups)
    {
        const auto accesses = std::tuple_cat(groups...);
        Stage stage = declare(std::move(name), accesses);
        const auto call = [kernel, accesses](Lane& lane) {
            return std::apply([&](const auto&... access) { return kernel(lane, access.whole()...); }, accesses);
        };
        if constexpr (std::is_void_v<decltype(call(std::declval<Lane&>()))>) stage.on_rank = call;
        else stage.job = call;
        return add(std::move(stage));
    }

    /// Who fills halos; it must outlive the graph.
    void fill_halos_with(HaloFiller& filler) { filler_ = &filler; }

    /// Whenever the halo of `field` has been filled, kernel(block, part of field, parts...) sets it at the walls.
    template <class Field, class Kernel, class... Groups>
    requires BlockKernel<Kernel, decltype(updates_halo(std::declval<Field&>())), Groups...>
    void boundary(Field& field, std::string name, Kernel kernel, Groups... groups)
    {
        halos_[&field].boundary.push_back(
            [this, &field, name = std::move(name), kernel, groups...] { each_block(name, kernel, updates_halo(field), groups...); });
    }

    /// Stages declared while the scope lives belong to the lane `label`; only reports depend on it.
    class LaneScope {
    public:
        LaneScope(StageGraph& graph, std::string label);
        ~LaneScope() { graph_.lane_ = before_; }
        LaneScope(const LaneScope&) = delete;
        LaneScope& operator=(const LaneScope&) = delete;

    private:
        StageGraph& graph_;
        std::string before_;
    };
    [[nodiscard]] LaneScope lane(std::string label) { return {*this, std::move(label)}; }

    /// `resource` is needed after a step in which `label` is due; after every step if it is empty. What the next step reads
    /// before writing it is found without being named.
    template <Resource R>
    void sink(R& resource, std::string label = {})
    {
        remember(record_of(resource));
        sinks_.push_back({&resource, std::move(label)});
    }

    /// Leaves out what neither the sinks nor the effects that are due need, allocates the fields of the rest and gives every
    /// whole stage its message space. Collective. The plan refers to the graph, which must outlive it.
    [[nodiscard]] Plan compile(const std::vector<std::string>& due = {});

    [[nodiscard]] const std::deque<Stage>& stages() const { return stages_; }
    [[nodiscard]] const Layout& layout() const { return layout_; }
    /// Whoever calls MPI while a step runs holds this.
    [[nodiscard]] std::mutex& token() { return pump_.token(); }

private:
    friend class Plan;
    struct Halo {
        bool fresh = false;
        std::size_t stage = 0; ///< the last one that fills it
        std::vector<std::function<void()>> boundary;
    };

    template <class... A>
    [[nodiscard]] Stage declare(std::string name, const std::tuple<A...>& accesses)
    {
        Stage stage;
        stage.name = std::move(name);
        stage.lane = lane_;
        std::apply([&](const A&... access) { (declare(stage, access), ...); }, accesses);
        return stage;
    }
    template <Resource R, Mode M>
    void declare(Stage& stage, const Access<R, M>& access)
    {
        remember(record_of(*access.resource));
        if constexpr (has_halo<R>)
            if (access.halo.width > 0) refresh_halo(*access.resource, access.halo);
        add_touches(access, stage.touches);
    }
    template <class Field>
    void refresh_halo(Field& field, core::HaloReach reach)
    {
        check_halo(field.info(), reach.width);
        refresh_halo(&field, FieldRef(&field), std::string(field.name()), reach);
    }
    static void check_halo(const core::FieldInfo& field, int width);
    void refresh_halo(const void* id, FieldRef field, const std::string& name, core::HaloReach reach);
    void remember(ResourceRecord record);
    void renew_communicators();
    void give_up(int stage, Job job);
    Declared add(Stage stage);

    Layout layout_;
    core::Communicator ranks_;
    MessagePump pump_;
    std::deque<Stage> stages_; // a deque: plans refer to stages while more are declared
    std::vector<ResourceRecord> resources_;
    std::vector<Sink> sinks_;
    std::map<const void*, Halo> halos_;
    HaloFiller* filler_ = nullptr;
    std::string lane_;
    struct GivenUp {
        int stage;
        Job job; ///< never continued: MPI may still know its buffers
    };
    std::mutex given_up_mutex_;
    std::vector<GivenUp> given_up_;
    std::size_t renewed_ = 0;              ///< of given_up_
    std::vector<core::Communicator> left_; ///< with messages that nobody receives
};

} // namespace tasks
