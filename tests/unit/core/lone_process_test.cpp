// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/comm/lone_process.hpp"
#include <cstdlib>
#include <doctest/doctest.h>
#include <optional>
#include <string>

namespace {

/// A variable of the environment that is put back at the end.
class Variable {
public:
    Variable(const char* name, const char* value) : name_(name)
    {
        if (const char* old = std::getenv(name)) old_ = old;
        if (value) setenv(name, value, 1);
        else unsetenv(name);
    }
    ~Variable()
    {
        if (old_) setenv(name_, old_->c_str(), 1);
        else unsetenv(name_);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
    std::optional<std::string> old_;
};

std::string value_of(const char* name)
{
    const char* value = std::getenv(name);
    return value ? value : "";
}

} // namespace

TEST_CASE("a process that runs alone looks for no network, and leaves no trace of that in the environment")
{
    const Variable ranks("OMPI_COMM_WORLD_SIZE", nullptr), pmix("PMIX_RANK", nullptr), space("PMIX_NAMESPACE", nullptr);
    const Variable pmi("PMI_RANK", nullptr), channel("PMI_FD", nullptr), slurm("SLURM_PROCID", nullptr);
    const Variable layer("OMPI_MCA_pml", nullptr), transport("OMPI_MCA_btl", "self,vader"), devices("HWLOC_COMPONENTS", nullptr);
    {
        const core::LoneProcess alone;
        CHECK(value_of("OMPI_MCA_pml") == "ob1");
        CHECK(value_of("OMPI_MCA_btl") == "self,vader"); // what the user says stays
        CHECK(value_of("HWLOC_COMPONENTS") == "-pci,-linuxio");
    }
    CHECK(value_of("OMPI_MCA_pml").empty());
    CHECK(value_of("OMPI_MCA_btl") == "self,vader");
    CHECK(value_of("HWLOC_COMPONENTS").empty());
}

TEST_CASE("a process that mpirun or a batch system started is left alone")
{
    for (const char* sign : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "SLURM_PROCID"}) {
        const Variable started(sign, "0"), layer("OMPI_MCA_pml", nullptr);
        const core::LoneProcess process;
        CHECK(value_of("OMPI_MCA_pml").empty());
    }
}
