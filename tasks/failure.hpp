// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A failure inside a step: recorded where it happened, known to all ranks at the end of the step.
#include "core/base/error.hpp"
#include "core/comm/communicator.hpp"
#include "core/field/field.hpp"
#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>

namespace tasks {

struct Failure {
    std::string stage;
    core::LocalBlock block = -1; ///< block of that rank, -1 where the stage works on all of them
    std::int64_t step = 0;
    int rank = 0;
    std::string text;
};

/// Thrown by Executor::run_step on every rank, with the same content.
class StepFailure : public core::Error {
public:
    explicit StepFailure(Failure failure);
    [[nodiscard]] const Failure& failure() const { return failure_; }

private:
    Failure failure_;
};

/// Leaves a job because this or another rank has failed; never reported by itself.
struct Poisoned : std::exception {
    [[nodiscard]] const char* what() const noexcept override { return "a rank has failed in this step"; }
};

/// Set by the first failure of a step on this rank; what follows computes nothing, yet messages still flow.
class Poison {
public:
    [[nodiscard]] bool set() const { return set_.load(std::memory_order_relaxed); }
    /// Another rank has failed.
    void spread() { set_ = true; }
    /// Records `error` if it is the first. @return False for Poisoned, which is nobody's failure.
    bool record(const std::exception_ptr& error, const std::string& stage, core::LocalBlock block);
    /// The first failure of this rank, if any.
    [[nodiscard]] std::optional<Failure> first() const;
    void clear(std::int64_t step, int rank);
    /// The failure that all ranks report: that of the lowest rank that has one; none if no rank has failed. Collective.
    /// @param meanwhile  Called again and again until all ranks have come.
    [[nodiscard]] std::optional<Failure> agree(const core::Communicator& ranks, const std::function<void()>& meanwhile) const;

private:
    std::atomic<bool> set_ = false;
    mutable std::mutex mutex_;
    std::optional<Failure> first_;
    std::int64_t step_ = 0;
    int rank_ = 0;
};

} // namespace tasks
