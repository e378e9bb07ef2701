/* SPDX-License-Identifier: Apache-2.0 */
/* Writes the odd VDB files that pyopenvdb cannot: make_typed_vdbs FOLDER */
#include <fstream>
#include <iterator>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <string>

using namespace openvdb;

template <class Grid> typename Grid::Ptr box(const char *name, double value)
{
    auto grid = Grid::create();
    grid->setName(name);
    for (int i = 0; i < 64; i++)
        grid->tree().setValue(Coord(i / 16, i / 4 % 4, i % 4),
                              typename Grid::ValueType(value * (i + 1)));
    return grid;
}

static void write(const std::string &path, const GridCPtrVec &grids)
{
    io::File(path).write(grids);
}

/* Copies a file with all Tree_int32 made a type that no one knows. */
static void write_unknown(const std::string &from, const std::string &to)
{
    std::ifstream input(from, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(input), {}};
    const std::string known = "Tree_int32", unknown = "Tree_point";
    for (size_t at; (at = bytes.find(known)) != std::string::npos;)
        bytes.replace(at, known.size(), unknown);
    std::ofstream(to, std::ios::binary) << bytes;
}

int main(int argc, char **argv)
{
    if (argc != 2)
        return 1;
    const std::string folder = std::string(argv[1]) + "/";
    initialize();
    auto density = box<FloatGrid>("density", 1.0 / 64);
    auto precise = box<DoubleGrid>("density", 1e-3);
    precise->tree().setValue(Coord(0, 0, 0), 1e300);
    auto shared = GridBase::Ptr(density->copyGrid());
    shared->setName("shared");
    shared->setTransform(math::Transform::createLinearTransform(0.5));
    const GridCPtrVec several = {density, box<FloatGrid>("density", 2.0), shared,
                                 box<Int32Grid>("cells", 1.0)};
    write(folder + "double.vdb", {precise});
    write(folder + "int32.vdb", {box<Int32Grid>("density", 1.0), box<Int64Grid>("long", 1.0)});
    write(folder + "instance.vdb", several);
    std::ofstream stream(folder + "stream.vdb", std::ios::binary);
    io::Stream(stream).write(several);
    stream.close();

    const GridCPtrVec beside = {density, box<Int32Grid>("points", 1.0),
                                box<FloatGrid>("smoke", 2.0), box<FloatGrid>("steam", 2.0)};
    write(folder + "points.vdb", beside);
    write_unknown(folder + "points.vdb", folder + "points.vdb");
    std::ofstream behind(folder + "points_stream.vdb", std::ios::binary);
    io::Stream(behind).write(beside);
    behind.close();
    write_unknown(folder + "points_stream.vdb", folder + "points_stream.vdb");

    write(folder + "precise_colours.vdb", {density, box<Vec3DGrid>("radiosity", 1.0)});
    auto velocity = box<Vec3SGrid>("velocity", 0.5);
    for (bool half : {false, true}) {
        auto coloured = box<Vec3SGrid>("radiosity", 0.25);
        coloured->tree().fill(CoordBBox(Coord(-8), Coord(-1)), Vec3s(1, 2, 3), true);
        coloured->setSaveFloatAsHalf(half);
        const GridCPtrVec grids = {coloured, velocity, density};
        const std::string name = folder + (half ? "half_colours" : "colours");
        write(name + ".vdb", grids);
        std::ofstream output(name + "_stream.vdb", std::ios::binary);
        io::Stream plain(output);
        plain.setCompression(io::COMPRESS_ACTIVE_MASK);
        plain.write(grids);
    }
    return 0;
}
