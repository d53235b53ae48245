// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Work that may wait for messages without holding a thread: a coroutine that returns Job.
#include <coroutine>
#include <exception>
#include <functional>
#include <utility>

namespace tasks {

/// Starts when awaited (or when the graph starts it), passes exceptions on to whoever awaits it.
///
///     Job exchange(Lane& lane, Buffers& buffers) {
///         core::Pending pending = post(lane, buffers);
///         co_await lane.arrive(pending);
///         unpack(buffers);
///     }
class [[nodiscard]] Job {
public:
    struct promise_type;
    using Handle = std::coroutine_handle<promise_type>;

    /// Continues whoever waits for the job that has just ended.
    struct HandOver {
        [[nodiscard]] bool await_ready() const noexcept { return false; }
        std::coroutine_handle<> await_suspend(Handle ended) const noexcept;
        void await_resume() const noexcept {}
    };

    struct promise_type {
        std::coroutine_handle<> awaiting;
        std::function<void(std::exception_ptr)> ended; ///< set for a job that nobody awaits
        std::exception_ptr error;

        Job get_return_object() { return Job(Handle::from_promise(*this)); }
        std::suspend_always initial_suspend() const noexcept { return {}; }
        HandOver final_suspend() const noexcept { return {}; }
        void return_void() const {}
        void unhandled_exception() { error = std::current_exception(); }
    };

    Job() = default;
    Job(Job&& other) noexcept : handle_(std::exchange(other.handle_, {})) {}
    Job& operator=(Job&& other) noexcept
    {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Job()
    {
        if (handle_) handle_.destroy();
    }

    [[nodiscard]] bool await_ready() const { return false; }
    std::coroutine_handle<> await_suspend(std::coroutine_handle<> awaiting)
    {
        handle_.promise().awaiting = awaiting;
        return handle_;
    }
    void await_resume() const
    {
        if (handle_.promise().error) std::rethrow_exception(handle_.promise().error);
    }

    /// Runs up to the first wait; `ended` is called once, with the exception or null, on whatever thread runs the end.
    void start(std::function<void(std::exception_ptr)> ended)
    {
        handle_.promise().ended = std::move(ended);
        handle_.resume();
    }

private:
    explicit Job(Handle handle) : handle_(handle) {}
    Handle handle_;
};

inline std::coroutine_handle<> Job::HandOver::await_suspend(Handle ended) const noexcept
{
    auto& promise = ended.promise();
    if (promise.awaiting) return promise.awaiting;
    if (promise.ended) promise.ended(promise.error);
    return std::noop_coroutine();
}

} // namespace tasks
