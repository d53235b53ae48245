// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The sums of a trace: work, longest path, overlap of the lanes, waiting that nothing hides, imbalance.
#include "tasks/plan.hpp"
#include "tasks/trace.hpp"

#include <algorithm>
#include <map>
#include <ostream>
#include <set>

namespace tasks {
namespace {

/// From `time` on, `change` more spans of a lane work (or wait, between two spans of a job).
struct Edge {
    double time;
    bool work;
    std::string lane;
    int change;
};

class StepDigest {
public:
    StepDigest(const Plan& plan, const std::vector<Span>& spans) : plan_(plan), spans_(spans) {}

    [[nodiscard]] bool complete() const
    {
        std::set<int> nodes;
        for (const Span& span : spans_) nodes.insert(span.node);
        return nodes.size() == plan_.nodes().size();
    }

    void add_to(Digest& digest, std::map<int, double>& busy) const
    {
        std::vector<double> duration(plan_.nodes().size(), 0.0);
        double end = spans_.front().end;
        for (const Span& span : spans_) {
            duration[std::size_t(span.node)] += span.end - span.start;
            busy[span.thread] += span.end - span.start;
            digest.work += span.end - span.start;
            digest.lanes[plan_.stage_of(plan_.nodes()[std::size_t(span.node)]).lane] += span.end - span.start;
            end = std::max(end, span.end);
        }
        ++digest.steps;
        digest.wall += end - spans_.front().start;
        digest.longest += longest_path(std::move(duration));
        add_overlap(digest);
    }

private:
    [[nodiscard]] double longest_path(std::vector<double> until) const
    {
        double longest = 0.0;
        for (std::size_t n = 0; n < until.size(); ++n) {
            double before = 0.0;
            for (const int p : plan_.nodes()[n].predecessors) before = std::max(before, until[std::size_t(p)]);
            until[n] += before;
            longest = std::max(longest, until[n]);
        }
        return longest;
    }

    [[nodiscard]] std::vector<Edge> edges() const
    {
        std::vector<Edge> edges;
        std::map<int, double> last_end; // of each node so far
        for (const Span& span : spans_) {
            const std::string& lane = plan_.stage_of(plan_.nodes()[std::size_t(span.node)]).lane;
            if (const auto last = last_end.find(span.node); last != last_end.end()) {
                edges.push_back({last->second, false, lane, 1});
                edges.push_back({span.start, false, lane, -1});
            }
            edges.push_back({span.start, true, lane, 1});
            edges.push_back({span.end, true, lane, -1});
            last_end[span.node] = span.end;
        }
        std::ranges::stable_sort(edges, {}, &Edge::time);
        return edges;
    }

    void add_overlap(Digest& digest) const
    {
        std::map<std::string, int> working, waiting;
        double time = spans_.front().start;
        for (const Edge& edge : edges()) {
            const double passed = edge.time - time;
            const auto is_active = [](const auto& lane) { return lane.second > 0; };
            const auto lanes_at_work = std::ranges::count_if(working, is_active);
            const bool hides_a_wait = std::ranges::any_of(
                waiting, [&](const auto& lane) { return is_active(lane) && working[lane.first] <= 0 && lanes_at_work > 0; });
            if (lanes_at_work > 1 || hides_a_wait) digest.overlap += passed;
            if (lanes_at_work == 0 && std::ranges::any_of(waiting, is_active)) digest.exposed += passed;
            (edge.work ? working : waiting)[edge.lane] += edge.change;
            time = edge.time;
        }
    }

    const Plan& plan_;
    const std::vector<Span>& spans_; ///< of one step, by start time
};

} // namespace

Digest Trace::digest(const Plan& plan) const
{
    std::map<std::int64_t, std::vector<Span>> steps;
    for (const Span& span : spans()) steps[span.step].push_back(span);
    Digest digest;
    std::map<int, double> busy; // of each thread
    for (const auto& [number, spans] : steps)
        if (const StepDigest step(plan, spans); step.complete()) step.add_to(digest, busy);
    double most = 0.0, sum = 0.0;
    for (const auto& [thread, time] : busy) {
        most = std::max(most, time);
        sum += time;
    }
    if (sum > 0.0) digest.imbalance = most / (sum / double(busy.size())) - 1.0;
    return digest;
}

std::ostream& operator<<(std::ostream& stream, const Digest& d)
{
    constexpr double milli = 1e3;
    const double per_step = milli / double(std::max<std::int64_t>(d.steps, 1));
    const auto share = [&](double time) { return d.wall > 0.0 ? 100.0 * time / d.wall : 0.0; };
    stream << d.steps << " steps; per step: wall " << d.wall * per_step << " ms, work " << d.work * per_step << " ms (";
    const char* between = "";
    for (const auto& [lane, work] : d.lanes) {
        stream << between << (lane.empty() ? "neither" : lane) << ' ' << work * per_step << " ms";
        between = ", ";
    }
    return stream << "), longest path " << d.longest * per_step << " ms, lanes overlap " << d.overlap * per_step << " ms ("
                  << share(d.overlap) << " % of the wall time), exposed wait " << d.exposed * per_step << " ms (" << share(d.exposed)
                  << " %); imbalance of threads " << 100.0 * d.imbalance << " %";
}

} // namespace tasks
