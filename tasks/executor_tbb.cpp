// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The oneTBB flow graph: built once, fired every step. A job that waits for messages holds no thread; when nothing is left to
// compute, the calling thread asks MPI, so one thread is enough.
#include "tasks/executors.hpp"
#include "tasks/node_runner.hpp"

#include <tbb/flow_graph.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <memory>
#include <optional>

namespace tasks {
namespace {

namespace flow = tbb::flow;
using Message = flow::continue_msg;

/// The nodes of a plan as nodes of a flow graph. A job begins in one node and ends in another.
class Network {
public:
    Network(NodeRunner& runner, std::atomic<int>& open_jobs)
        : start_(graph_),
          resume_(
              graph_, flow::unlimited, [&runner](const Arrived& a) { runner.resume(a); }, flow::node_priority_t(3))
    {
        const Plan& plan = runner.plan();
        const bool prioritise = plan.ranks().size() > 1; // without messages the order of arrival keeps caches warmer
        for (int n = 0; n < int(plan.nodes().size()); ++n) {
            const Node& node = plan.nodes()[std::size_t(n)];
            const Stage& stage = plan.stage_of(node);
            const bool is_job = stage.whole();
            const auto body = [&runner, &open_jobs, n, is_job](const Message&) {
                if (is_job) ++open_jobs;
                runner.start(n);
                return Message{};
            };
            const auto priority = prioritise ? flow::node_priority_t(node.priority) : flow::no_priority;
            begins_.push_back(std::make_unique<flow::continue_node<Message>>(graph_, body, priority));
            ends_.push_back(is_job ? std::make_unique<flow::broadcast_node<Message>>(graph_) : nullptr);
            if (node.predecessors.empty()) flow::make_edge(start_, *begins_.back());
            for (const int p : node.predecessors) connect(std::size_t(p), *begins_.back());
        }
    }

    void fire() { start_.try_put({}); }
    void wait() { graph_.wait_for_all(); }
    void resume(const Arrived& arrived) { resume_.try_put(arrived); }
    /// Lets the successors of a job start. @return False for a node that is no job.
    bool end_job(int n)
    {
        const auto& end = ends_[std::size_t(n)];
        if (end) end->try_put({});
        return bool(end);
    }

private:
    void connect(std::size_t before, flow::continue_node<Message>& after)
    {
        if (ends_[before]) flow::make_edge(*ends_[before], after);
        else flow::make_edge(*begins_[before], after);
    }

    flow::graph graph_;
    flow::broadcast_node<Message> start_;
    flow::function_node<Arrived> resume_;
    std::vector<std::unique_ptr<flow::continue_node<Message>>> begins_;
    std::vector<std::unique_ptr<flow::broadcast_node<Message>>> ends_;
};

class TbbExecutor final : public Executor {
public:
    TbbExecutor(const Plan& plan, Trace* trace, int threads)
        : arena_(threads, 1),
          team_(core::make_tbb_team(threads)),
          runner_(plan, *team_, trace,
                  {[this](int node) {
                       if (network_->end_job(node)) --open_jobs_;
                   },
                   [this](const Arrived& arrived) { network_->resume(arrived); }})
    {
        if (threads > tbb::info::default_concurrency())
            more_threads_.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
        // A flow graph runs in the arena in which it is made.
        arena_.execute([&] { network_ = std::make_unique<Network>(runner_, open_jobs_); });
    }

    void run_step(std::int64_t step) override
    {
        runner_.begin_step(step);
        arena_.execute([&] {
            network_->fire();
            network_->wait();
            for (core::Patience patience; open_jobs_ > 0;) // nothing left to compute until messages arrive
                if (runner_.plan().pump().poll_idle(patience)) network_->wait();
        });
        runner_.end_step();
    }
    [[nodiscard]] std::string name() const override { return "tbb"; }

private:
    std::optional<tbb::global_control> more_threads_;
    tbb::task_arena arena_;
    std::unique_ptr<core::Team> team_;
    std::atomic<int> open_jobs_ = 0;
    NodeRunner runner_;
    std::unique_ptr<Network> network_;
};

} // namespace

std::unique_ptr<Executor> make_tbb_executor(const Plan& plan, Trace* trace, int threads)
{
    return std::make_unique<TbbExecutor>(plan, trace, threads);
}

} // namespace tasks
