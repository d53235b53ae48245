// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/node_runner.hpp"

#include <algorithm>
#include <utility>

namespace tasks {
namespace {

/// Effects are seen outside: they happen on all ranks or on none.
Job after_agreement(const Stage& stage, Lane& lane)
{
    co_await lane.agree();
    if (stage.job) co_await stage.job(lane);
    else stage.on_rank(lane);
}

} // namespace

NodeRunner::NodeRunner(const Plan& plan, const core::Team& team, Trace* trace, RunnerEvents events)
    : plan_(plan), trace_(trace), events_(std::move(events)), lanes_(plan.nodes().size()), jobs_(plan.nodes().size())
{
    for (std::size_t n = 0; n < lanes_.size(); ++n) {
        const Stage& stage = plan.stage_of(plan.nodes()[n]);
        if (!stage.whole()) continue;
        const auto resume = [this, node = int(n)](std::coroutine_handle<> job, Outcome outcome) {
            if (outcome == Outcome::arrived) events_.arrived({node, job});
            else abandon(node);
        };
        lanes_[n] = std::make_unique<Lane>(stage.name, LaneContext{team, plan.pump(), poison_, resume}, *stage.communicator);
    }
}

void NodeRunner::begin_step(std::int64_t step)
{
    step_ = step;
    poison_.clear(step, plan_.ranks().rank());
}

template <class Body>
void NodeRunner::guarded(const Stage& stage, LocalBlock block, Body body)
{
    if (poison_.set()) return;
    try {
        body();
    } catch (...) {
        poison_.record(std::current_exception(), stage.name, block);
    }
}

void NodeRunner::start(int n)
{
    const Node& node = plan_.nodes()[std::size_t(n)];
    const Stage& stage = plan_.stage_of(node);
    const double begin = trace_ ? trace_->now() : 0.0;
    if (stage.job || (stage.whole() && stage.effect)) {
        start_job(n, stage, *lanes_[std::size_t(n)]);
        trace(n, begin);
    } else {
        if (stage.whole()) guarded(stage, -1, [&] { stage.on_rank(*lanes_[std::size_t(n)]); });
        else
            for (LocalBlock b = node.begin; b < node.end; ++b) guarded(stage, b, [&] { stage.on_block(b); });
        trace(n, begin);
        events_.ended(n);
    }
    plan_.pump().poll();
}

void NodeRunner::resume(Arrived arrived)
{
    const double begin = trace_ ? trace_->now() : 0.0;
    arrived.job.resume();
    trace(arrived.node, begin);
    plan_.pump().poll();
}

void NodeRunner::end_step()
{
    MessagePump& pump = plan_.pump();
    const auto failure = poison_.agree(plan_.ranks(), [&] { pump.listen(); });
    if (!failure) return;
    if (pump.end_alarm()) plan_.renew_communicators();
    throw StepFailure(*failure);
}

void NodeRunner::abandon(int n)
{
    poison_.spread();
    plan_.give_up(plan_.nodes()[std::size_t(n)].stage, std::move(jobs_[std::size_t(n)]));
    events_.ended(n);
}

void NodeRunner::start_job(int n, const Stage& stage, Lane& lane)
{
    const bool others_wait = plan_.ranks().size() > 1;
    const bool others_left = plan_.pump().alarmed();
    if (others_left) poison_.spread();
    if (others_left || (poison_.set() && !others_wait)) return events_.ended(n);
    Job& job = jobs_[std::size_t(n)];
    job = stage.effect ? after_agreement(stage, lane) : stage.job(lane);
    job.start([this, n, &stage](const std::exception_ptr& error) {
        if (error && poison_.record(error, stage.name, -1)) {
            plan_.give_up(plan_.nodes()[std::size_t(n)].stage, {});
            plan_.pump().raise_alarm();
        }
        events_.ended(n);
    });
}

void NodeRunner::trace(int node, double start)
{
    if (trace_) trace_->add({node, 0, step_, start, trace_->now()});
}

DrivenRunner::DrivenRunner(const Plan& plan, const core::Team& team, Trace* trace)
    : has_ended_(plan.nodes().size()),
      runner_(plan, team, trace,
              {[this](int node) {
                   const std::lock_guard lock(mutex_);
                   has_ended_[std::size_t(node)] = 1;
                   ended_.push_back(node);
               },
               [this](Arrived arrived) {
                   const std::lock_guard lock(mutex_);
                   arrived_.push_back(arrived);
               }})
{
}

void DrivenRunner::begin_step(std::int64_t step)
{
    ended_.clear();
    std::ranges::fill(has_ended_, 0);
    runner_.begin_step(step);
}

void DrivenRunner::continue_arrived()
{
    std::deque<Arrived> now;
    {
        const std::lock_guard lock(mutex_);
        now.swap(arrived_);
    }
    for (const Arrived& arrived : now) runner_.resume(arrived);
}

void DrivenRunner::advance()
{
    plan().pump().poll();
    continue_arrived();
}

void DrivenRunner::wait(core::Patience& patience)
{
    plan().pump().poll_idle(patience);
    continue_arrived();
}

void DrivenRunner::wait_for(int node)
{
    for (core::Patience patience; !has_ended_[std::size_t(node)];) wait(patience);
}

std::vector<int> DrivenRunner::take_ended()
{
    const std::lock_guard lock(mutex_);
    return std::exchange(ended_, {});
}

} // namespace tasks
