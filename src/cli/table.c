/* SPDX-License-Identifier: Apache-2.0 */
#include "cases.h"
#include "options.h"
#include "values.h"

#include <float.h>

static const char *const METHODS[] = {"lines", "pairwise", NULL};
static const char *const SOLVERS[] = {"cg", "gauss-seidel", NULL};
static const char *const VOXELS[] = {"center", "corner", NULL};
static const char *const UPS[] = {"z", "y", NULL};
const char *const CLI_BENCH_PARTS[] = {"growth", "emptiness", "threads", "error", "paper", NULL};
const char *const CLI_AGAINST[] = {"frame", "transmittance", "depth", "cl", NULL};
const char *const CLI_KERNELS[] = {"avx512", "avx2", "portable", NULL};

enum {
    PICTURE = CLI_IMAGE | CLI_RENDER,
    AIMING = PICTURE | CLI_BAKE,
    SOLVING = CLI_IMAGE | CLI_SOLVE | CLI_BAKE,
    RESUMING = CLI_IMAGE | CLI_SOLVE | CLI_RENDER,
    WORKING = RESUMING | CLI_BAKE,
};

#define PICTURES "png jpg"

static const char OUTPUT[] = "Output";
static const char SEQUENCE[] = "Sequence (#### or %04d or $F4 in the names of files)";
static const char MEDIUM[] = "Medium (these go before what a scene file says)";
static const char SOLVE[] = "Solution";
static const char BENCH[] = "Benchmark";
static const char CAMERA[] = "Camera and picture";
static const char CONTRAST[] = "Target and background (X,Y,WxH is a rectangle of pixels from the "
                               "top left)";
static const char SENSOR[] = "Sensor";
static const char GRIDS[] = "Grids of the radiosity VDB";
static const char GENERAL[] = "General";

#define FIELD(name)            .offset = offsetof(struct cli_options, name)
#define FLAG(name)             .value = cli_value_flag, FIELD(name)
#define TEXT(name)             .value = cli_value_text, FIELD(name), .expected = "a name"
#define PATH(name, extensions) TEXT(name), .files = extensions
#define CHOICE(name, list)     .value = cli_value_choice, FIELD(name), .choices = list
#define POSITIVE               .min = DBL_MIN, .max = DBL_MAX, .expected = "a number > 0"
#define WHOLE(low, high, text) .min = low, .max = high, .expected = text

static const struct cli_option TABLE[] = {
    {"radiosity", 0, CLI_RENDER, "Input", "FILE", "the radiosity .vdb that murk solve wrote",
     PATH(radiosity, "vdb")},
    {"output", 'o', PICTURE, OUTPUT, "FILE",
     "the picture: .exr keeps everything; .tif holds R, G, B and A as linear floats; .png, .jpg "
     "and "
     "others are for looking at",
     PATH(output, "exr tif png jpg")},
    {"deep", 0, PICTURE, OUTPUT, "FILE",
     "the picture once more, deep: .exr with samples along the depth", PATH(deep, "exr")},
    {"output", 'o', CLI_SOLVE, OUTPUT, "FILE",
     "the radiosity as .vdb, or - for a VDB stream to standard output", PATH(output, "vdb")},
    {"preview", 0, PICTURE, OUTPUT, "FILE", "the picture once more, for looking at: .png",
     PATH(preview, PICTURES)},
    {"radiosity", 0, CLI_IMAGE, OUTPUT, "FILE", "keep the radiosity too, as .vdb",
     PATH(radiosity, "vdb")},
    {"output", 'o', CLI_BAKE, OUTPUT, "FILE",
     "the two textures, as .png, .tga or .exr: NAME.png makes NAME_positive.png (R, G, B: light "
     "from the right, the top, the back; A: opacity) and NAME_negative.png (from the left, the "
     "bottom, the front; A: what glows, 1 at most; 1 "
     "everywhere where nothing does). 1 is a white surface that faces the light; the "
     "values are linear",
     PATH(output, "png tga exr")},
    {"radiosity", 0, CLI_BAKE, OUTPUT, "FILE",
     "keep the radiosity under each light too, as .vdb: radiosity_right and so on",
     PATH(radiosity, "vdb")},
    {"flipbook", 0, CLI_BAKE, OUTPUT, "CxR",
     "all frames in one sheet of C cells across and R down, from the top left row by row",
     .value = cli_value_size, FIELD(flipbook),
     WHOLE(1, 256, "a number of cells across and down from 1 to 256, such as 8x8")},
    {"straight", 0, CLI_BAKE, OUTPUT, NULL,
     "R, G, B divided by the opacity, for particles that blend by alpha; without it premultiplied",
     FLAG(straight)},
    {"ground-radiosity", 0, CLI_IMAGE | CLI_SOLVE, OUTPUT, "FILE",
     "the radiosity of the ground patches [W/m^2] as .exr, one pixel a patch",
     PATH(ground_radiosity, "exr")},
    {"usd", 0, CLI_IMAGE | CLI_SOLVE, OUTPUT, "FILE",
     "a USD stage of the radiosity .vdb, the camera and the lights, as .usda; usdstitch joins "
     "those of a sequence",
     PATH(usd, "usda")},
    {"output", 'o', CLI_BENCH, OUTPUT, "FILE", "a plot of what was measured, such as .png",
     PATH(output, PICTURES)},
    {"curves", 0, CLI_BENCH, OUTPUT, "FILE",
     "further panels for the plot, from lines of text: PANEL,CURVE,SECONDS,ERROR,LABEL",
     TEXT(curves)},
    {"output", 'o', CLI_CONTRAST, OUTPUT, "FILE",
     "the table as .csv, a line for each frame and band; not given: to standard output",
     PATH(output, "csv")},
    {"plot", 0, CLI_CONTRAST, OUTPUT, "FILE",
     "curves of a sequence, one for each band, such as .png: contrast transmittance, apparent "
     "contrast, and from 3 um on the apparent temperature difference",
     PATH(plot, PICTURES)},
    {"against", 0, CLI_CONTRAST, OUTPUT, "WHAT",
     "what the curves are drawn against: frame (the default), or transmittance, depth (optical) or "
     "cl of the lines of sight to the target",
     CHOICE(against, CLI_AGAINST)},
    {"json", 0, CLI_ALL, OUTPUT, NULL, "print the report as JSON on standard output", FLAG(json),
     .aside = true},

    {"frames", 0, WORKING, SEQUENCE, "LIST",
     "the frames to run: 1-100, 1-100x2 or 1,3,10-20; not given: all that there are of the first "
     "input with a pattern; one that fails does not stop the others",
     TEXT(frames), .aside = true},
    {"frames", 0, CLI_INFO, SEQUENCE, "LIST",
     "the frames to tell about: 1-100, 1-100x2 or 1,3,10-20; not given: all that there are; one "
     "that fails does not stop the others",
     TEXT(frames)},
    {"frames", 0, CLI_CONTRAST, SEQUENCE, "LIST",
     "the frames to measure: 1-100, 1-100x2 or 1,3,10-20; not given: all that there are; one that "
     "fails does not stop the others",
     TEXT(frames)},
    {"resume", 0, RESUMING, SEQUENCE, NULL,
     "skip frames whose outputs are there, newer than their inputs, and made by this command with "
     "these options",
     FLAG(resume), .aside = true},
    {"jobs", 0, RESUMING, SEQUENCE, "N",
     "frames to run at once, each on its part of the threads; not given: what ends first and "
     "memory "
     "holds",
     .value = cli_value_count, FIELD(jobs), WHOLE(1, 4096, "a whole number from 1 to 4096"),
     .aside = true},

    {"grid", 0, CLI_VOLUME, MEDIUM, "NAME", "the grid to take the extinction from", TEXT(grid)},
    {"scale", 0, CLI_VOLUME, MEDIUM, "S",
     "extinction [1/m] = S times the grid's value; not given: such that the deepest column has "
     "about 5 optical depths",
     .value = cli_value_number, FIELD(scale), POSITIVE},
    {"obscurant", 0, WORKING, MEDIUM, "FILE",
     "mass extinction coefficient, albedo and asymmetry by wavelength, as .json",
     PATH(obscurant, "json")},
    {"concentration", 0, WORKING, MEDIUM, "G",
     "concentration [g/m^3] per unit of the grid, for scenes with mass extinction coefficients",
     .value = cli_value_number, FIELD(concentration), POSITIVE},
    {"albedo", 0, CLI_VOLUME, MEDIUM, "A", "single-scattering albedo: a number or a grid's name",
     TEXT(albedo)},
    {"bands", 0, WORKING, MEDIUM, "LIST",
     "the bands to work on, such as R,G,B,LWIR: of those in the scene; where it has none, by names "
     "of R, G, B, NIR, SWIR, MWIR and LWIR",
     TEXT(bands)},
    {"voxel-size", 0, CLI_VOLUME, MEDIUM, "D", "edge of a voxel [m], where the file's is wrong",
     .value = cli_value_number, FIELD(voxel_size), POSITIVE},
    {"voxels", 0, CLI_VOLUME, MEDIUM, "WHERE", "what a voxel's index is: its center or its corner",
     CHOICE(voxels, VOXELS)},
    {"up", 0, WORKING, MEDIUM, "AXIS", "the axis that points up: z or y", CHOICE(up, UPS)},
    {"strict", 0, CLI_VOLUME, MEDIUM, NULL, "NaN, infinite and negative values are an error",
     FLAG(strict)},

    {"parts", 0, CLI_BENCH, BENCH, "LIST",
     "what to measure, out of growth (with the number of voxels), emptiness (the same medium in a "
     "box 8 times as large), threads, error (after run time: lines, pairwise and a Monte Carlo on "
     "the paper's figure 1, the cloud, or what --cases and --volume name) and paper (the cases of "
     "1991); all of it",
     .value = cli_value_set, FIELD(parts), .choices = CLI_BENCH_PARTS},
    {"cases", 0, CLI_BENCH, BENCH, "LIST",
     "media, out of cloud, box, plume, checkerboard and filaments; emptiness and threads are "
     "measured on the first of them",
     .value = cli_value_set, FIELD(cases), .choices = BENCH_CASE_NAMES},
    {"volume", 0, CLI_BENCH, BENCH, "FILE", "error: a .vdb to be measured too",
     PATH(volume, "vdb")},
    {"sizes", 0, CLI_BENCH, BENCH, "LIST",
     "active voxels, such as 1e4,1e6,1e7; not given: 1e4 to 1e6 for the cloud, less for others and "
     "for errors",
     .value = cli_value_list, FIELD(sizes),
     WHOLE(100, 1e8, "numbers from 100 to 1e8 such as 1e4,1e6")},
    {"packets", 0, CLI_BENCH, BENCH, "LIST",
     "error: packets of light of the Monte Carlo (1e3,1e4,1e5,1e6,1e7)", .value = cli_value_list,
     FIELD(packets), WHOLE(100, 1e9, "numbers from 100 to 1e9 such as 1e4,1e6")},
    {"runs", 0, CLI_BENCH, BENCH, "N", "what is printed are medians of N runs (3)",
     .value = cli_value_count, FIELD(runs), WHOLE(1, 1000, "a whole number from 1 to 1000")},
    {"render", 0, CLI_BENCH, BENCH, NULL, "time the picture too, 1920x1080 pixels",
     FLAG(time_render)},

    {"tolerance", 0, SOLVING | CLI_BENCH, SOLVE, "T",
     "relative error asked for: 1% (the default) or 0.01", .value = cli_value_percent,
     FIELD(solve.tolerance), .expected = "between 0 and 100 %; write 1% or 0.01"},
    {"method", 0, SOLVING, SOLVE, "M", "lines (the default) or pairwise (small media)",
     CHOICE(method, METHODS)},
    {"solver", 0, SOLVING, SOLVE, "S", "cg (the default) or gauss-seidel (pairwise only)",
     CHOICE(solver, SOLVERS)},
    {"directions", 0, SOLVING, SOLVE, "N", "lines: directions, rounded up to a multiple of 48",
     .value = cli_value_count, FIELD(solve.directions),
     WHOLE(1, 1000000, "a whole number from 1 to 1000000")},
    {"rays", 0, SOLVING, SOLVE, "N", "lines: N x N rays for each voxel face",
     .value = cli_value_count, FIELD(solve.rays), WHOLE(1, 16, "a whole number from 1 to 16")},
    {"epsilon", 0, SOLVING, SOLVE, "E", "gauss-seidel: largest change at the end [W/m^2]",
     .value = cli_value_number, FIELD(solve.epsilon), POSITIVE},
    {"max-iterations", 0, SOLVING, SOLVE, "N", "stop after N iterations (1000)",
     .value = cli_value_count, FIELD(solve.max_iterations),
     WHOLE(1, 1000000000, "a whole number >= 1")},
    {"window", 0, SOLVING, SOLVE, "MxNxK", "pairwise: exchange within a window of zones only",
     .value = cli_value_window, FIELD(solve.window),
     WHOLE(1, 1000000, "three whole numbers such as 10x10x4")},

    {"size", 0, PICTURE, CAMERA, "WxH", "pixels", .value = cli_value_size, FIELD(size),
     WHOLE(1, 65536, "a width and height from 1 to 65536, such as 640x480")},
    {"size", 0, CLI_BAKE, CAMERA, "WxH", "pixels of a frame (256x256)", .value = cli_value_size,
     FIELD(size), WHOLE(4, 16384, "a width and height from 4 to 16384, such as 256x256")},
    {"samples", 0, AIMING, CAMERA, "N", "N x N rays for each pixel (2)", .value = cli_value_count,
     FIELD(samples), WHOLE(1, 64, "a whole number from 1 to 64")},
    {"eye", 0, CLI_BAKE, CAMERA, "X,Y,Z",
     "where one looks from [m], with --target; the picture is parallel and always frames all of "
     "the "
     "medium; not given: the scene's camera, or from the front",
     .value = cli_value_vector, FIELD(eye), .expected = "three numbers such as 2,-2,1.5"},
    {"eye", 0, PICTURE, CAMERA, "X,Y,Z", "where the camera is [m]", .value = cli_value_vector,
     FIELD(eye), .expected = "three numbers such as 2,-2,1.5"},
    {"target", 0, AIMING, CAMERA, "X,Y,Z", "what it looks at [m]", .value = cli_value_vector,
     FIELD(target), .expected = "three numbers such as 0.5,0.5,0.3"},
    {"fov", 0, PICTURE, CAMERA, "DEGREES", "vertical field of view", .value = cli_value_number,
     FIELD(fov), .min = 1e-3, .max = 179.999, .expected = "between 0 and 180 degrees"},
    {"no-background", 0, PICTURE, CAMERA, NULL,
     "leave ground and sky out of the picture; they still light the medium", FLAG(no_background)},
    {"exposure", 0, CLI_BAKE, CAMERA, "STOPS",
     "R, G, B of .png and .tga are 2^STOPS times what they are (0); above 1 they are clipped",
     .value = cli_value_number, FIELD(exposure), .min = -100, .max = 100,
     .expected = "a number of stops from -100 to 100"},
    {"exposure", 0, PICTURE, CAMERA, "STOPS",
     "for .png and the like; without it the 99th percentile of the luminance shows as 0.9",
     .value = cli_value_number, FIELD(exposure), .min = -100, .max = 100,
     .expected = "a number of stops from -100 to 100"},
    {"show", 0, PICTURE, CAMERA, "CHANNEL",
     "for .png and the like: a channel in false colour with a scale bar, such as Z, "
     "transmittance.Y or LWIR.temperature [K]",
     TEXT(show)},
    {"range", 0, PICTURE, CAMERA, "LOW:HIGH",
     "the ends of the scale bar; without it the 1st to the 99th percentile, for each frame anew",
     .value = cli_value_range, FIELD(range),
     .expected = "two numbers, the lower one first, such as 280:320"},

    {"target", 0, CLI_CONTRAST, CONTRAST, "REGION",
     "what is to be seen: X,Y,WxH, or an image of the picture's size that is above 0.5 there",
     TEXT(target_region)},
    {"background", 0, CLI_CONTRAST, CONTRAST, "REGION",
     "what it stands out from, likewise; pixels of the target are left out of it",
     TEXT(background_region)},
    {"bands", 0, CLI_CONTRAST, CONTRAST, "LIST", "bands of the picture; not given: all",
     TEXT(bands)},
    {"netd", 0, CLI_CONTRAST, SENSOR, "K",
     "noise-equivalent temperature difference, for cnr_thermal", .value = cli_value_number,
     FIELD(netd), POSITIVE},
    {"snr", 0, CLI_CONTRAST, SENSOR, "N",
     "signal-to-noise ratio at the background's radiance, for cnr_radiance",
     .value = cli_value_number, FIELD(snr), POSITIVE},

    {"half", 0, SOLVING, GRIDS, NULL, "store 16-bit floats", FLAG(half)},
    {"emission-coefficient", 0, SOLVING, GRIDS, NULL,
     "add emission_coefficient = kappa_t B / pi [W/m^3/sr]", FLAG(emission_coefficient)},
    {"extinction-grid", 0, SOLVING, GRIDS, NULL, "add extinction [1/m]", FLAG(extinction_grid)},
    {"albedo-grid", 0, SOLVING, GRIDS, NULL, "add albedo", FLAG(albedo_grid)},

    {"threads", 0, CLI_ALL, GENERAL, "N", "threads in all (OMP_NUM_THREADS, or all processors)",
     .value = cli_value_count, FIELD(threads), WHOLE(1, 4096, "a whole number from 1 to 4096"),
     .aside = true},
    {"max-memory", 0, CLI_VOLUME, GENERAL, "SIZE",
     "the memory that the work may take, such as 8G or 512M; what needs more is refused before it "
     "begins; not given: what the machine can give",
     .value = cli_value_bytes, FIELD(max_memory),
     .expected = "a number of bytes such as 8G, 512M or 2GiB", .aside = true},
    {"kernel", 0, CLI_ALL & ~(CLI_INFO | CLI_CONTRAST), GENERAL, "K",
     "avx512, avx2 or portable; the fastest that this processor has", CHOICE(kernel, CLI_KERNELS)},
    {"quiet", 'q', CLI_ALL, GENERAL, NULL, "print errors only", FLAG(quiet), .aside = true},
    {"verbose", 'v', CLI_ALL, GENERAL, NULL, "tell more", FLAG(verbose), .aside = true},
    {"help", 'h', CLI_ALL, GENERAL, NULL, "print this text", FLAG(help)},
};

const struct cli_option *cli_option_table(size_t *count)
{
    *count = sizeof TABLE / sizeof *TABLE;
    return TABLE;
}
