// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The small values of an HDF5 file: numbers and texts attached to groups.
#include "core/base/error.hpp"
#include "io/files/hdf5.hpp"

#include <algorithm>

namespace io::hdf5 {

void File::set_attribute(const std::string& object, const std::string& name, std::pair<hid_t, hid_t> type_and_space, const void* value)
{
    make_group(object);
    const auto [type, space] = type_and_space;
    const Handle attribute(H5Acreate_by_name(file_.get(), object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
    check(attribute.valid() && H5Awrite(attribute.get(), type, value) >= 0, "write attribute", object + ":" + name);
}

void File::set_attribute(const std::string& object, const std::string& name, double value)
{
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    set_attribute(object, name, {H5T_NATIVE_DOUBLE, space.get()}, &value);
}

void File::set_attribute(const std::string& object, const std::string& name, std::span<const std::int64_t> values)
{
    const hsize_t size = values.size();
    const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    set_attribute(object, name, {H5T_NATIVE_INT64, space.get()}, values.data());
}

void File::set_attribute(const std::string& object, const std::string& name, const std::string& value)
{
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose), type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.get(), std::max<std::size_t>(1, value.size()));
    H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
    set_attribute(object, name, {type.get(), space.get()}, value.c_str());
}

std::vector<std::string> File::attributes(const std::string& object) const
{
    std::vector<std::string> names;
    if (object != "/" && !has(object)) return names;
    const auto add = [](hid_t, const char* name, const H5A_info_t*, void* out) -> herr_t {
        static_cast<std::vector<std::string>*>(out)->emplace_back(name);
        return 0;
    };
    const herr_t status = H5Aiterate_by_name(file_.get(), object.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names, H5P_DEFAULT);
    check(status >= 0, "list the attributes of", object);
    std::sort(names.begin(), names.end());
    return names;
}

Handle File::attribute(const std::string& object, const std::string& name) const
{
    Handle found(H5Aopen_by_name(file_.get(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    check(found.valid(), "find attribute", object + ":" + name);
    return found;
}

double File::number_attribute(const std::string& object, const std::string& name) const
{
    const Handle found = attribute(object, name), space(H5Aget_space(found.get()), H5Sclose);
    double value = 0.0;
    check(H5Sget_simple_extent_npoints(space.get()) == 1 && H5Aread(found.get(), H5T_NATIVE_DOUBLE, &value) >= 0, "read attribute",
          object + ":" + name);
    return value;
}

std::string File::text_attribute(const std::string& object, const std::string& name) const
{
    const Handle found = attribute(object, name), space(H5Aget_space(found.get()), H5Sclose), type(H5Aget_type(found.get()), H5Tclose);
    const bool text = H5Tget_class(type.get()) == H5T_STRING && H5Sget_simple_extent_npoints(space.get()) == 1;
    check(text && H5Tis_variable_str(type.get()) == 0, "understand attribute", object + ":" + name);
    std::string value(H5Tget_size(type.get()), '\0');
    check(H5Aread(found.get(), type.get(), value.data()) >= 0, "read attribute", object + ":" + name);
    value.resize(std::min(value.size(), value.find('\0')));
    return value;
}

} // namespace io::hdf5
