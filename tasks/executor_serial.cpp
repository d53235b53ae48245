// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The order of the text, one node after the other: the oracle for all other executors.
#include "tasks/executors.hpp"
#include "tasks/node_runner.hpp"

namespace tasks {
namespace {

class SerialExecutor final : public Executor {
public:
    SerialExecutor(const Plan& plan, Trace* trace) : runner_(plan, team_, trace) {}

    void run_step(std::int64_t step) override
    {
        runner_.begin_step(step);
        for (int n = 0; n < int(runner_.plan().nodes().size()); ++n) {
            runner_.start(n);
            runner_.wait_for(n);
        }
        runner_.end_step();
    }
    [[nodiscard]] std::string name() const override { return "serial"; }

private:
    core::SerialTeam team_;
    DrivenRunner runner_;
};

} // namespace

std::unique_ptr<Executor> make_serial_executor(const Plan& plan, Trace* trace) { return std::make_unique<SerialExecutor>(plan, trace); }

} // namespace tasks
