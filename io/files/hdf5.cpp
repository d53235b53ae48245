// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/hdf5.hpp"
#include "core/base/error.hpp"
#include "io/files/durable.hpp"

#include <algorithm>
#include <array>

namespace io::hdf5 {
namespace {

template <class T>
hid_t type_of()
{
    if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
    if constexpr (std::is_same_v<T, float>) return H5T_NATIVE_FLOAT;
    if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
    if constexpr (std::is_same_v<T, std::uint64_t>) return H5T_NATIVE_UINT64;
    if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_NATIVE_UINT8;
}

/// The innermost entry of HDF5's error stack, which it then clears.
std::string reason()
{
    std::string text;
    const auto keep_last = [](unsigned, const H5E_error2_t* entry, void* out) -> herr_t {
        if (entry->desc) *static_cast<std::string*>(out) = entry->desc;
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_last, &text);
    H5Eclear2(H5E_DEFAULT);
    return text.empty() ? text : " (HDF5: " + text + ")";
}

Handle file_access(const core::Communicator* ranks)
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_fclose_degree(access.get(), H5F_CLOSE_STRONG);
    H5Pset_file_locking(access.get(), false, true); // shared file systems often have no locks
    if (ranks && ranks->size() > 1) H5Pset_fapl_mpio(access.get(), *static_cast<const MPI_Comm*>(ranks->native()), MPI_INFO_NULL);
    return access;
}

Handle space_of(const Rows& rows)
{
    const std::array<hsize_t, 2> size{hsize_t(rows.total), hsize_t(rows.components)};
    return {H5Screate_simple(rows.components > 1 ? 2 : 1, size.data(), nullptr), H5Sclose};
}

/// Selects the ranges in `space` and returns a memory space of as many elements.
Handle select(hid_t space, std::span<const Range> ranges, int components)
{
    H5Sselect_none(space);
    hsize_t count = 0;
    for (const Range& range : ranges) {
        const std::array<hsize_t, 2> start{hsize_t(range.first), 0}, size{hsize_t(range.count), hsize_t(components)};
        if (range.count > 0) H5Sselect_hyperslab(space, H5S_SELECT_OR, start.data(), nullptr, size.data(), nullptr);
        count += hsize_t(range.count * components);
    }
    Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
    if (count == 0) H5Sselect_none(memory.get());
    return memory;
}

Handle creation(const Rows& rows, Packing packing)
{
    Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    if (packing == Packing::plain || rows.total == 0) return list;
    constexpr hsize_t chunk_rows = 16384;
    const std::array<hsize_t, 2> chunk{std::min(hsize_t(rows.total), chunk_rows), hsize_t(rows.components)};
    H5Pset_chunk(list.get(), rows.components > 1 ? 2 : 1, chunk.data());
    H5Pset_shuffle(list.get());
    H5Pset_deflate(list.get(), 1);
    return list;
}

Handle link_creation()
{
    Handle list(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(list.get(), 1);
    return list;
}

} // namespace

File::File(std::string path, Handle file, std::optional<core::Communicator> writers)
    : path_(std::move(path)), writers_(std::move(writers)), file_(std::move(file))
{
    check(file_.valid(), "open the file", "");
}

File File::create(const std::string& path, const core::Communicator& ranks, Format format)
{
    const Handle access = file_access(&ranks);
    if (format == Format::checked) H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110);
    else H5Pset_libver_bounds(access.get(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V18);
    return {path, {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose}, ranks};
}

File File::open(const std::string& path)
{
    const Handle access = file_access(nullptr);
    return {path, {H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose}, std::nullopt};
}

void File::check(bool good, const std::string& action, const std::string& name) const
{
    if (good) return;
    const std::string what = name.empty() ? "" : " '" + name + "'";
    throw core::FileError(core::text(path_, ": cannot ", action, what, reason()));
}

void File::reserve(std::size_t bytes)
{
    constexpr std::size_t metadata = 65536; // far more than one dataset and its groups need
    reserved_ += bytes + metadata;
    together(*writers_, [&] {
        if (writers_->rank() == 0) reserve_room(path_, reserved_);
    });
}

template <class T>
void File::write(const std::string& name, std::span<const T> values, const Rows& rows, Packing packing)
{
    reserve(std::size_t(rows.total) * std::size_t(rows.components) * sizeof(T));
    const Handle space = space_of(rows), list = creation(rows, packing), links = link_creation();
    Handle data(H5Dcreate2(file_.get(), name.c_str(), type_of<T>(), space.get(), links.get(), list.get(), H5P_DEFAULT), H5Dclose);
    check(data.valid(), "create dataset", name);
    const Handle memory = select(space.get(), rows.mine, rows.components);
    if (hsize_t(H5Sget_select_npoints(space.get())) != values.size())
        throw core::FileError(core::text(path_, ": dataset '", name, "' got ", values.size(), " numbers for ",
                                         H5Sget_select_npoints(space.get()), " places"));
    const Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
    if (writers_->size() > 1) H5Pset_dxpl_mpio(transfer.get(), H5FD_MPIO_COLLECTIVE);
    const T none{};
    const T* source = values.empty() ? &none : values.data();
    if (rows.total > 0)
        check(H5Dwrite(data.get(), type_of<T>(), memory.get(), space.get(), transfer.get(), source) >= 0, "write dataset", name);
    check(data.reset(), "close dataset", name);
}

Handle File::dataset(const std::string& name) const
{
    Handle data(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose);
    check(data.valid(), "find dataset", name);
    return data;
}

Rows File::shape(const std::string& name) const
{
    const Handle data = dataset(name), space(H5Dget_space(data.get()), H5Sclose);
    std::array<hsize_t, 2> size{0, 1};
    const int dimensions = H5Sget_simple_extent_ndims(space.get());
    check(dimensions == 1 || dimensions == 2, "understand the shape of dataset", name);
    H5Sget_simple_extent_dims(space.get(), size.data(), nullptr);
    return {std::int64_t(size[0]), int(size[1]), {}};
}

bool File::integers(const std::string& name) const
{
    const Handle data = dataset(name), type(H5Dget_type(data.get()), H5Tclose);
    return H5Tget_class(type.get()) == H5T_INTEGER;
}

template <class T>
std::vector<T> File::read(const std::string& name, Range range) const
{
    const Rows rows = shape(name);
    const bool inside = range.first >= 0 && range.count >= 0 && range.first + range.count <= rows.total;
    check(inside, core::text("read rows ", range.first, " to ", range.first + range.count, " of dataset"), name);
    const Handle data = dataset(name), space(H5Dget_space(data.get()), H5Sclose);
    const Handle memory = select(space.get(), {&range, 1}, rows.components);
    std::vector<T> values(std::size_t(range.count * rows.components));
    if (values.empty()) return values;
    const herr_t status = H5Dread(data.get(), type_of<T>(), memory.get(), space.get(), H5P_DEFAULT, values.data());
    check(status >= 0, "read dataset", name);
    return values;
}

bool File::has(const std::string& name) const
{
    for (std::size_t slash = name.find('/', 1); slash != std::string::npos; slash = name.find('/', slash + 1))
        if (H5Lexists(file_.get(), name.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
    return H5Lexists(file_.get(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> File::datasets() const
{
    std::vector<std::string> names;
    const auto add = [](hid_t, const char* name, const H5O_info_t* info, void* out) -> herr_t {
        if (info->type == H5O_TYPE_DATASET) static_cast<std::vector<std::string>*>(out)->emplace_back(name);
        return 0;
    };
    check(H5Ovisit2(file_.get(), H5_INDEX_NAME, H5_ITER_INC, add, &names, H5O_INFO_BASIC) >= 0, "list the datasets", "");
    std::sort(names.begin(), names.end());
    return names;
}

void File::make_group(const std::string& name)
{
    if (name == "/" || has(name)) return;
    const Handle links = link_creation();
    const Handle group(H5Gcreate2(file_.get(), name.c_str(), links.get(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
    check(group.valid(), "create group", name);
}

void File::link(const std::string& name, const std::string& file, const std::string& target)
{
    const Handle links = link_creation();
    const herr_t status = H5Lcreate_external(file.c_str(), target.c_str(), file_.get(), name.c_str(), links.get(), H5P_DEFAULT);
    check(status >= 0, "create link", name);
}

void File::flush() { check(H5Fflush(file_.get(), H5F_SCOPE_GLOBAL) >= 0, "write the file", ""); }

void File::close()
{
    check(file_.reset(), "close the file", "");
    if (!writers_ || writers_->rank() != 0) return;
    const File again = open(path_);
    haddr_t end = 0;
    check(H5Fget_eoa(again.file_.get(), &end) >= 0, "find the end of the file", "");
    cut_file(path_, end);
}

void agree(const core::Communicator& ranks, const std::string& message)
{
    if (ranks.size() > 1) {
        std::int64_t failed = message.empty() ? 0 : 1;
        ranks.max({&failed, 1});
        if (failed == 0) return;
        for (const auto& bytes : ranks.gather_all(std::as_bytes(std::span(message))))
            if (!bytes.empty()) throw core::FileError({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    if (!message.empty()) throw core::FileError(message);
}

template void File::write<double>(const std::string&, std::span<const double>, const Rows&, Packing);
template void File::write<float>(const std::string&, std::span<const float>, const Rows&, Packing);
template void File::write<std::int64_t>(const std::string&, std::span<const std::int64_t>, const Rows&, Packing);
template void File::write<std::uint64_t>(const std::string&, std::span<const std::uint64_t>, const Rows&, Packing);
template void File::write<std::uint8_t>(const std::string&, std::span<const std::uint8_t>, const Rows&, Packing);
template std::vector<double> File::read<double>(const std::string&, Range) const;
template std::vector<float> File::read<float>(const std::string&, Range) const;
template std::vector<std::int64_t> File::read<std::int64_t>(const std::string&, Range) const;
template std::vector<std::uint64_t> File::read<std::uint64_t>(const std::string&, Range) const;
template std::vector<std::uint8_t> File::read<std::uint8_t>(const std::string&, Range) const;

} // namespace io::hdf5
