// SPDX-License-Identifier: Apache-2.0
// A program that uses OpenVDB beside murk: both read and write grids in turn, whoever starts or
// ends OpenVDB's registry of types: host VOLUME.vdb
#include <murk/murk.h>

#include <openvdb/openvdb.h>

#include <cstdlib>
#include <iostream>

namespace
{
const char FILE_NAME[] = "package_host.vdb";

void check(bool holds, const char *what)
{
    if (holds)
        return;
    std::cerr << what << '\n';
    std::exit(1);
}

// murk solves and writes.
void solve(murk_context *context, const char *path)
{
    murk_volume *volume = nullptr;
    murk_medium *medium = nullptr;
    murk_solution *solution = nullptr;
    murk_scene scene{};
    murk_solve_options options = MURK_SOLVE_DEFAULT;
    options.tolerance = 0.1;
    scene.sky_radiance = 1;
    check(murk_volume_read(context, path, &volume) == MURK_OK, murk_context_message(context));
    check(murk_medium_from_volume(context, volume, nullptr, &medium) == MURK_OK,
          murk_context_message(context));
    scene.medium = medium;
    check(murk_solve(context, &scene, &options, &solution) == MURK_OK,
          murk_context_message(context));
    check(murk_solution_write(solution, FILE_NAME, nullptr) == MURK_OK,
          murk_context_message(context));
    murk_solution_release(solution);
    murk_medium_release(medium);
    murk_volume_release(volume);
}

// OpenVDB reads what murk wrote, and writes what murk will read.
void exchange()
{
    openvdb::io::File in(FILE_NAME);
    in.open(false);
    openvdb::GridBase::Ptr base = in.readGrid("radiosity");
    in.close();
    openvdb::FloatGrid::Ptr grid = openvdb::gridPtrCast<openvdb::FloatGrid>(base);
    check(grid && grid->activeVoxelCount() > 27785, "OpenVDB finds no radiosity of floats");
    check(dynamic_cast<openvdb::FloatGrid *>(base.get()) != nullptr, "the types differ");
    grid->tree().voxelizeActiveTiles();
    grid->setName("density");
    openvdb::io::File(FILE_NAME).write({grid});
}

void read(murk_context *context)
{
    murk_volume *volume = nullptr;
    check(murk_volume_read(context, FILE_NAME, &volume) == MURK_OK, murk_context_message(context));
    check(murk_volume_grid_count(volume) == 1, "murk does not find the grid");
    murk_volume_release(volume);
}
} // namespace

int main(int argc, char **argv)
{
    murk_context *context = nullptr;
    check(argc == 2, "usage: host VOLUME.vdb");
    check(murk_context_create(nullptr, &context) == MURK_OK, "no context");
    solve(context, argv[1]);
    openvdb::initialize();
    exchange();
    read(context);
    try {
        openvdb::io::File("not_there.vdb").open();
        check(false, "a missing file opens");
    } catch (const openvdb::IoError &) {
    }
    openvdb::uninitialize();
    read(context);
    solve(context, argv[1]);
    murk_context_release(context);
}
