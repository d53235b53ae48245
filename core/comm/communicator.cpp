// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/comm/communicator.hpp"
#include "core/base/error.hpp"
#include "core/base/patience.hpp"
#include "core/comm/lone_process.hpp"

#include <mpi.h>

#include <limits>

namespace core {

MpiSession::MpiSession(int& argc, char**& argv)
{
    int provided = MPI_THREAD_SINGLE;
    const LoneProcess alone;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &provided);
    require<Error>(provided >= MPI_THREAD_SERIALIZED, "this MPI does not provide MPI_THREAD_SERIALIZED");
}

MpiSession::~MpiSession() { MPI_Finalize(); }

struct Pending::Requests {
    std::vector<MPI_Request> list;
};

Pending::Pending() : requests_(std::make_unique<Requests>()) {}
Pending::~Pending() = default;
Pending::Pending(Pending&&) noexcept = default;
Pending& Pending::operator=(Pending&&) noexcept = default;

bool Pending::empty() const { return requests_->list.empty(); }

bool Pending::done()
{
    if (empty()) return true;
    int flag = 0;
    MPI_Testall(int(requests_->list.size()), requests_->list.data(), &flag, MPI_STATUSES_IGNORE);
    if (flag) requests_->list.clear();
    return flag != 0;
}

void Pending::wait()
{
    for (Patience patience; !done(); patience.pause()) {}
}

namespace {

int count_of(std::size_t n)
{
    if (n > std::size_t(std::numeric_limits<int>::max())) throw Error(text("message of ", n, " elements is too long for MPI"));
    return int(n);
}

/// Waits as Pending does. MPI's own waits keep the core, also from the rank that they wait for.
void wait_for(MPI_Request request)
{
    int done = 0;
    for (Patience patience; MPI_Test(&request, &done, MPI_STATUS_IGNORE), !done; patience.pause()) {}
}

template <class Value>
void reduce(std::span<Value> v, MPI_Datatype type, MPI_Op operation, MPI_Comm comm)
{
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Iallreduce(MPI_IN_PLACE, v.data(), count_of(v.size()), type, operation, comm, &request);
    wait_for(request);
}

} // namespace

struct Communicator::Handle {
    MPI_Comm comm = MPI_COMM_NULL;
    explicit Handle(MPI_Comm parent)
    {
        MPI_Request request = MPI_REQUEST_NULL;
        MPI_Comm_idup(parent, &comm, &request);
        wait_for(request);
    }
    ~Handle()
    {
        int finalized = 0;
        MPI_Finalized(&finalized);
        if (!finalized) MPI_Comm_free(&comm);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
};

Communicator::Communicator(std::shared_ptr<const Handle> handle) : handle_(std::move(handle))
{
    MPI_Comm_rank(handle_->comm, &rank_);
    MPI_Comm_size(handle_->comm, &size_);
}

Communicator Communicator::world() { return Communicator(std::make_shared<const Handle>(MPI_COMM_WORLD)); }
Communicator Communicator::self() { return Communicator(std::make_shared<const Handle>(MPI_COMM_SELF)); }
Communicator Communicator::duplicate() const { return Communicator(std::make_shared<const Handle>(handle_->comm)); }
const void* Communicator::native() const { return &handle_->comm; }

void Communicator::send(std::span<const std::byte> data, int to, int tag, Pending& pending) const
{
    auto& request = pending.requests_->list.emplace_back();
    MPI_Isend(data.data(), count_of(data.size()), MPI_BYTE, to, tag, handle_->comm, &request);
}

void Communicator::receive(std::span<std::byte> data, int from, int tag, Pending& pending) const
{
    auto& request = pending.requests_->list.emplace_back();
    MPI_Irecv(data.data(), count_of(data.size()), MPI_BYTE, from, tag, handle_->comm, &request);
}

bool Communicator::has_message(int from, int tag) const
{
    int flag = 0;
    MPI_Iprobe(from, tag, handle_->comm, &flag, MPI_STATUS_IGNORE);
    return flag != 0;
}

void Communicator::sum(std::span<double> v) const { reduce(v, MPI_DOUBLE, MPI_SUM, handle_->comm); }
void Communicator::sum(std::span<std::int64_t> v) const { reduce(v, MPI_INT64_T, MPI_SUM, handle_->comm); }
void Communicator::max(std::span<double> v) const { reduce(v, MPI_DOUBLE, MPI_MAX, handle_->comm); }
void Communicator::max(std::span<std::int64_t> v) const { reduce(v, MPI_INT64_T, MPI_MAX, handle_->comm); }
void Communicator::start_sum(std::span<double> v, Pending& pending) const
{
    auto& request = pending.requests_->list.emplace_back();
    MPI_Iallreduce(MPI_IN_PLACE, v.data(), count_of(v.size()), MPI_DOUBLE, MPI_SUM, handle_->comm, &request);
}

void Communicator::start_max(std::span<double> v, Pending& pending) const
{
    auto& request = pending.requests_->list.emplace_back();
    MPI_Iallreduce(MPI_IN_PLACE, v.data(), count_of(v.size()), MPI_DOUBLE, MPI_MAX, handle_->comm, &request);
}

std::vector<std::vector<std::byte>> Communicator::gather_all(std::span<const std::byte> mine) const
{
    return exchange_all(std::vector<std::vector<std::byte>>(std::size_t(size_), {mine.begin(), mine.end()}));
}

std::vector<std::vector<std::byte>> Communicator::exchange_all(const std::vector<std::vector<std::byte>>& to) const
{
    std::vector<std::int64_t> out(to.size()), in(to.size());
    for (std::size_t r = 0; r < to.size(); ++r) out[r] = std::int64_t(to[r].size());
    MPI_Request lengths = MPI_REQUEST_NULL;
    MPI_Ialltoall(out.data(), 1, MPI_INT64_T, in.data(), 1, MPI_INT64_T, handle_->comm, &lengths);
    wait_for(lengths);
    std::vector<std::vector<std::byte>> from(to.size());
    Pending pending;
    for (std::size_t r = 0; r < to.size(); ++r) {
        from[r].resize(std::size_t(in[r]));
        if (!from[r].empty()) receive(from[r], int(r), 0, pending);
    }
    for (std::size_t r = 0; r < to.size(); ++r)
        if (!to[r].empty()) send(to[r], int(r), 0, pending);
    pending.wait();
    return from;
}

void Communicator::broadcast(std::vector<std::byte>& data, int root) const
{
    std::int64_t size = std::int64_t(data.size());
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibcast(&size, 1, MPI_INT64_T, root, handle_->comm, &request);
    wait_for(request);
    data.resize(std::size_t(size));
    MPI_Ibcast(data.data(), count_of(data.size()), MPI_BYTE, root, handle_->comm, &request);
    wait_for(request);
}

void Communicator::barrier() const
{
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(handle_->comm, &request);
    wait_for(request);
}

} // namespace core
