// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Filling the halos of cell fields, and what they keep behind them, from the blocks beyond: copies inside the rank, one
// message between each pair of ranks. start() and finish() enclose the waiting, so that a task can do other work meanwhile.
// The transpose adds what was deposited in halos to the cells that it belongs to. Vectors and tensors from beyond a seam that
// turns are turned on their way in; the transpose knows no such seams.
#include "core/comm/communicator.hpp"
#include "core/comm/strided_copies.hpp"
#include "core/field/field.hpp"
#include "core/grid/mesh.hpp"

namespace core {

/// A place in the arrays of the local blocks.
struct CellPlace {
    LocalBlock block;
    std::ptrdiff_t offset; ///< from cell (0, 0, 0)
};

class HaloExchange {
public:
    /// Buffers and messages of one exchange on its way. Must stay at its place until finished.
    struct Flight {
        Pending pending;
        std::vector<std::vector<double>> sent, received; ///< by rank
    };

    /// Which of the values that fields keep behind their halo are filled (sub_face_values.hpp).
    enum class Behind { cells, all };
    /// Plan for fields with `field_halo` layers of which `width` are filled. Collective.
    HaloExchange(const Mesh& mesh, const Communicator& communicator, int field_halo, int width, HaloShape shape,
                 Behind behind = Behind::all);

    /// Packs and sends in a space of messages where no other exchange is on its way.
    template <std::size_t N>
    void start(FieldStorage<N>& field, Flight& flight, const Communicator& space) const
    {
        start_arrays(arrays_of(field), flight, space);
    }
    template <std::size_t N>
    void start(FieldStorage<N>& field, Flight& flight) const
    {
        start(field, flight, communicator_);
    }
    /// Unpacks once flight.pending is done.
    template <std::size_t N>
    void finish(FieldStorage<N>& field, Flight& flight) const
    {
        finish_arrays(arrays_of(field), flight);
    }
    /// The transpose: halo values go home, to be added there in a fixed order; halos are left at zero.
    /// @pre No seam turns.
    template <std::size_t N>
    void start_transpose(FieldStorage<N>& field, Flight& flight, const Communicator& space) const
    {
        start_transpose_arrays(arrays_of(field), flight, space);
    }
    template <std::size_t N>
    void start_transpose(FieldStorage<N>& field, Flight& flight) const
    {
        start_transpose(field, flight, communicator_);
    }
    template <std::size_t N>
    void finish_transpose(FieldStorage<N>& field, Flight& flight) const
    {
        finish_transpose_arrays(arrays_of(field), flight);
    }
    /// start() and finish(), waiting in between: for set-up and tests.
    template <std::size_t N>
    void fill(FieldStorage<N>& field) const
    {
        Flight flight;
        start(field, flight);
        flight.pending.wait();
        finish(field, flight);
    }
    template <std::size_t N>
    void add_home(FieldStorage<N>& field) const
    {
        Flight flight;
        start_transpose(field, flight);
        flight.pending.wait();
        finish_transpose(field, flight);
    }

private:
    /// Pointers to cell (0, 0, 0) of the arrays, those of a block one after the other.
    struct Arrays {
        std::vector<double*> origins;
        std::size_t count = 0; ///< of a block
        Components components = Components::scalars;
        [[nodiscard]] double* const* of(LocalBlock b) const { return origins.data() + std::size_t(b) * count; }
    };
    /// One source of one halo cell; `slot` counts in the message of `rank`, or `place` on this rank (rank < 0).
    struct Source {
        int rank;
        int turn; ///< in turns_; -1: none
        std::ptrdiff_t slot;
        CellPlace place;
        double weight;
    };
    struct Row {
        CellPlace target;
        int first, last; ///< in sources_
    };
    /// Halo cells of one block that are copies of cells of another block of this rank.
    struct Copies {
        LocalBlock target, source;
        StridedCopies values;
    };

    template <std::size_t N>
    static Arrays arrays_of(FieldStorage<N>& field);
    void request(const Mesh& mesh, const Communicator& communicator, int field_halo, int width, HaloShape shape, Behind behind);
    [[nodiscard]] int turn_number(const Motion& motion);
    void find_copies();
    void start_arrays(const Arrays& arrays, Flight& flight, const Communicator& space) const;
    void finish_arrays(const Arrays& arrays, const Flight& flight) const;
    void finish_turned(const Arrays& arrays, const Flight& flight) const;
    [[nodiscard]] static double value(const Arrays& arrays, const Flight& flight, const Source& source, std::size_t array);
    void blend(const Arrays& arrays, const Flight& flight, const Row& row) const;
    void start_transpose_arrays(const Arrays& arrays, Flight& flight, const Communicator& space) const;
    void finish_transpose_arrays(const Arrays& arrays, const Flight& flight) const;
    void post(Flight& flight, const Communicator& space, bool transpose, std::size_t arrays) const;

    Communicator communicator_;
    std::vector<Row> rows_;
    std::vector<Copies> copies_; ///< rows_ with one source, on this rank, by target and source
    /// A source on this rank, small because there are many.
    struct BlendSource {
        LocalBlock block;
        int offset;
        double weight;
    };
    std::vector<Row> blends_; ///< rows_ with several sources, all on this rank; counted in blend_sources_
    std::vector<BlendSource> blend_sources_;
    std::vector<Row> arrivals_; ///< rows_ with a source on another rank
    std::vector<Row> turned_;   ///< rows_ with a source whose axes are turned, on whatever rank; in none of the others
    std::vector<Mat3> turns_;   ///< from the axes of sources to those here
    std::vector<Source> sources_;
    std::vector<std::vector<CellPlace>> wanted_from_here_; ///< [rank]: cells whose values that rank asks for
    std::vector<std::ptrdiff_t> wanted_there_;             ///< [rank]: number of values this rank asks for
    /// The transposed sum of each interior cell, in an order that no decomposition changes.
    struct Home {
        CellPlace target;
        int first, last; ///< in contributions_
    };
    struct Contribution {
        int rank; ///< -1: `place` on this rank
        std::ptrdiff_t slot;
        CellPlace place;
        double weight;
    };
    std::vector<Home> homes_;
    std::vector<Contribution> contributions_;
};

template <std::size_t N>
HaloExchange::Arrays HaloExchange::arrays_of(FieldStorage<N>& field)
{
    Arrays arrays{{}, N, field.components()};
    for (std::size_t b = 0; b < field.blocks(); ++b)
        for (std::size_t a = 0; a < N; ++a) arrays.origins.push_back(field.origin(LocalBlock(b), a));
    return arrays;
}

} // namespace core
