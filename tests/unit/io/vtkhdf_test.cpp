// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/vtkhdf.hpp"
#include "tests/support/sample_state.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>

using support::Folder, support::State;

namespace {

/// Opens a file as VTK's reader does and compares shapes, indices and a value; independent of our own HDF5 code.
constexpr const char* look = R"(
import h5py, sys
folder = sys.argv[1]
with h5py.File(folder + "/fluid_000001.hdf") as f:
    g = f["VTKHDF"]
    assert list(g.attrs["Version"]) == [1, 0] and g.attrs["Type"] == b"UnstructuredGrid", dict(g.attrs)
    points, cells, corners = (g[n][:] for n in ("NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"))
    assert len(cells) == 5 and (corners == 8 * cells).all()
    assert g["Points"].shape == (points.sum(), 3) and g["Types"].shape == (cells.sum(),) and (g["Types"][:] == 12).all()
    assert g["Offsets"].shape == (cells.sum() + 5,) and g["Connectivity"].shape == (corners.sum(),)
    block = 4  # all cells are unit cubes: the volume from the eight corners must be 1
    p = g["Points"][points[:block].sum():points[:block + 1].sum()]
    c = g["Connectivity"][corners[:block].sum():corners[:block + 1].sum()].reshape(-1, 8)
    import numpy
    a = [p[c[:, n]] - p[c[:, 0]] for n in (1, 3, 4)]
    assert numpy.allclose(numpy.einsum("ij,ij->i", a[0], numpy.cross(a[1], a[2])), 1.0)
    assert numpy.allclose(p[c[:, 6]] - p[c[:, 0]], [1, 1, 1])
    nk, nj, ni = f["meta/extents"][block][::-1]
    u = g["CellData/velocity"][cells[:block].sum():].reshape(nk, nj, ni, 3)
    v = numpy.sin(11.0 + 1.7 * block + 0.3 * 2 + 0.11 * 1 + 0.013 * 2 + 0.0017 * 0)
    assert abs(u[0, 2, 1, 2] - v) < 1e-15, (u[0, 2, 1, 2], v)
    assert g["CellData/pressure"].shape == (cells.sum(),) and f["meta"].attrs["unit of pressure"] == b"Pa"
with h5py.File(folder + "/particles_000001.hdf") as f:
    g = f["VTKHDF"]
    n = g["NumberOfPoints"][0]
    assert g["Points"].shape == (n, 3) and (g["Types"][:] == 1).all() and (g["Offsets"][:] == range(n + 1)).all()
    assert (g["Connectivity"][:] == range(n)).all() and (g["PointData/id"][:] == range(n)).all()
)";

} // namespace

TEST_CASE("h5py finds hexahedra, vertices and data where VTKHDF 1.0 wants them")
{
    const Folder folder;
    const auto self = core::Communicator::self();
    const State state = support::whole_state(1.0);
    io::FluidResults fluid(folder.path(), self, state.blocks, support::nodes_of(state));
    io::ParticleResults particles(folder.path(), self);
    const io::RowOrder rows = state.order(self);
    const auto id = rows.apply(std::span(state.ids), 1);
    const auto position = rows.apply(std::span(state.position), 3);
    const io::ParticleRows columns{position, {{"velocity", 3, position}}, {{"id", 1, id}}, rows.first_row(), rows.total_rows()};
    for (const int number : {0, 1}) {
        (void)fluid.write({number, 0.1 * number}, {io::views(state.pressure), io::views(state.velocity)});
        (void)particles.write({number, 0.1 * number}, columns);
    }
    std::ofstream(folder.path() + "/look.py") << look;
    CHECK(std::system(("/usr/bin/python3 " + folder.path() + "/look.py " + folder.path()).c_str()) == 0);
}

TEST_CASE("a series goes on after a restart and forgets what lay ahead")
{
    const Folder folder;
    const std::string path = folder.path() + "/fluid.hdf.series";
    {
        io::Series series(path);
        for (int n = 0; n < 4; ++n) series.add("fluid_" + std::to_string(n) + ".hdf", 0.5 * n);
    }
    io::Series(path).add("fluid_2.hdf", 1.0);
    const auto list = nlohmann::json::parse(std::ifstream(path));
    CHECK(list["file-series-version"] == "1.0");
    REQUIRE(list["files"].size() == 3);
    CHECK(list["files"][2]["name"] == "fluid_2.hdf");
    CHECK(list["files"][2]["time"] == 1.0);
}
