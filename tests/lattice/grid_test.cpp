#include "lattice/grid.hpp"

#include <catch2/catch.hpp>

#include <set>

using namespace vesica;

namespace {

const Vec3<int> odd_boxes[] = {{1, 1, 1}, {3, 1, 7},  {7, 3, 1},  {8, 8, 8},
                               {9, 7, 3}, {17, 9, 8}, {16, 1, 17}};

} // namespace

TEST_CASE("a cell's index leads back to the cell through its tile, ghosts included", "[lattice]") {
    for (const Vec3<int>& size : odd_boxes) {
        const Grid grid(size);
        std::set<std::int64_t> indices;
        bool returns = true;
        for (int z = -1; z <= size.z; ++z)
            for (int y = -1; y <= size.y; ++y)
                for (int x = -1; x <= size.x; ++x) {
                    const std::int64_t index = grid.index(x, y, z);
                    const Vec3<int> origin = grid.tile_origin(index / Grid::tile);
                    const Vec3<int> back{origin.x + static_cast<int>(index % Grid::tile), origin.y, origin.z};
                    returns = returns && back == Vec3<int>{x, y, z} && index >= 0 && index < grid.cells();
                    indices.insert(index);
                }
        INFO("box " << size.x << " x " << size.y << " x " << size.z);
        CHECK(returns);
        CHECK(indices.size() == static_cast<std::size_t>((size.x + 2) * (size.y + 2) * (size.z + 2)));
    }
}

TEST_CASE("steps in index and in tiles lead to the neighbour", "[lattice]") {
    for (const Vec3<int>& size : odd_boxes) {
        const Grid grid(size);
        const Vec3<int> cell{size.x / 2, size.y / 2, size.z / 2};
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy) {
                for (int dx = -1; dx <= 1; ++dx)
                    CHECK(grid.index(cell) + grid.offset(dx, dy, dz) ==
                          grid.index(cell.x + dx, cell.y + dy, cell.z + dz));
                CHECK(grid.index(cell) / Grid::tile + grid.tile_offset(dy, dz) ==
                      grid.index(cell.x, cell.y + dy, cell.z + dz) / Grid::tile);
            }
    }
}

TEST_CASE("the interior bits of all tiles are the cells of the box, each once", "[lattice]") {
    for (const Vec3<int>& size : odd_boxes) {
        const Grid grid(size);
        std::int64_t count = 0;
        bool right = true;
        for (std::int64_t t = 0; t < grid.tiles(); ++t) {
            const Vec3<int> origin = grid.tile_origin(t);
            const std::uint8_t bits = grid.interior_bits(origin);
            for (int k = 0; k < Grid::tile; ++k) {
                const int x = origin.x + k;
                const bool inside = x >= 0 && x < size.x && origin.y >= 0 && origin.y < size.y &&
                                    origin.z >= 0 && origin.z < size.z;
                right = right && inside == ((bits >> k & 1) != 0);
                count += bits >> k & 1;
            }
        }
        CHECK(right);
        CHECK(count == grid.volume());
    }
}

TEST_CASE("a whole tile at any cell of the box, shifted by any link, stays inside the allocation",
          "[lattice]") {
    for (const Vec3<int>& size : odd_boxes) {
        const Grid grid(size);
        const int last_tile = (size.x - 1) / Grid::tile * Grid::tile;
        CHECK(grid.index(0, 0, 0) % Grid::tile == 0);
        CHECK(grid.index(0, 0, 0) + grid.offset(-1, -1, -1) >= 0);
        CHECK(grid.index(last_tile, size.y - 1, size.z - 1) + grid.offset(1, 1, 1) + Grid::tile <=
              grid.cells());
        // Along x alone as well: the shifted tile ends within its own row.
        const std::int64_t row_end = grid.index(-Grid::tile, size.y - 1, size.z - 1) + grid.row_stride();
        CHECK(grid.index(last_tile + 1, size.y - 1, size.z - 1) + Grid::tile <= row_end);
    }
}
