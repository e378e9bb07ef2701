/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file murk.h
 * murk lights smoke, fog and clouds: it reads extinction and albedo from OpenVDB grids, solves
 * the multiple scattering between all the voxels and the ground by the zonal (volume radiosity)
 * method of [BG91], writes the volume radiosity back as VDB and renders the obscured scene.
 *
 * [BG91] C. C. Borel, S. A. W. Gerstl, "Simulation of Partially Obscured Scenes Using the
 * Radiosity Method", 1991. Misprints of that paper are listed in EQUATIONS.md of the sources.
 *
 * Conventions used throughout:
 *  - World units are those of the VDB transform and are called metres.
 *  - A zone is an active voxel whose extinction is positive; a patch is a rectangle of the ground.
 *  - Volume radiosity B [W/m^2] is pi times the isotropic source function: a zone emits the
 *    radiance B/pi per unit of optical depth. Surface radiosity is pi times the radiance.
 *  - In every zone B = albedo * G/4 + (1 - albedo) * E, with G [W/m^2] the incident radiation
 *    integrated over the sphere and E [W/m^2] the black-body emissive power ([BG91] eq. 2).
 *
 * Every function that can fail returns a murk_status and leaves its outputs untouched on failure;
 * the reason, as one line of text, is then in murk_context_message(). A *_create, *_read, *_build
 * or *_solve function gives the caller an object to be released with the matching *_release, which
 * takes NULL too. Objects keep what they need of one another alive, so they may be released in any
 * order, all before the context. One context serves one thread at a time.
 */
#ifndef MURK_MURK_H
#define MURK_MURK_H

#include "core.h"
#include "image.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------ */
/* Volumes: what a VDB file holds                                                              */
/* ------------------------------------------------------------------------------------------ */

/** The grids of one VDB file or stream, in memory. */
typedef struct murk_volume murk_volume;

/** One grid of a volume; strings live as long as the volume. Of a level set, whose inside can be
 *  taken as a medium where it is asked for by name, values are the part of each voxel that is
 *  inside; of a mask they are 1. */
typedef struct murk_grid_info {
    const char *name;       /**< unique: "density", "density[1]", ... */
    const char *type;       /**< OpenVDB's value type: "float", "half", "vec3s", ... */
    const char *grid_class; /**< "fog volume", "level set", ... */
    bool readable;          /**< murk can take it as a scalar field */
    const char *unreadable; /**< why not, or NULL */
    uint64_t active_voxels; /**< tiles counted by their voxels */
    uint64_t active_tiles;
    uint64_t nonzero_voxels;      /**< active voxels whose value is not 0 (scalar grids) */
    uint64_t invalid_voxels;      /**< NaN, infinite or negative values among the active voxels */
    int32_t box_min[3];           /**< index-space box of the active voxels, both ends included */
    int32_t box_max[3];           /**< smaller than box_min where nothing is active */
    double voxel_size[3];         /**< m; 0 where nothing of the grid could be read */
    double index_to_world[16];    /**< row-major; world = matrix * (i, j, k, 1) as a column */
    double value_min, value_max;  /**< over the active voxels; 0 where nothing is active */
    double mean_depth, max_depth; /**< integral of the value along the shortest axis of the box,
                                       mean and maximum over the columns that hold something */
} murk_grid_info;

/**
 * Reads a VDB file; "-" reads a VDB stream from standard input. The header, the grid offsets and
 * all nodes are checked against the file's size before OpenVDB sees it; nothing is loaded lazily.
 * Fails with MURK_ERROR_INPUT for a missing, truncated, damaged or foreign file.
 *
 * OpenVDB reads in a child process with limits of memory and processor time, which keeps the grids
 * until murk_volume_release(), so that no file can hurt the program. The child is made by fork()
 * and calls no exec(); it keeps no descriptor and no signal handler of the program and ends with
 * it. For a program this means:
 * - other threads may run, but none should be inside OpenVDB while a volume is read;
 * - a SIGCHLD may come when the child ends; murk waits for its child alone and leaves no zombie,
 *   also where the program ignores SIGCHLD or waits for any child;
 * - a volume belongs to the process that has read it, and not to a fork() of that.
 */
MURK_API murk_status murk_volume_read(murk_context *context, const char *path, murk_volume **out);
/** Releases a volume and the strings of its grids; NULL is nothing. */
MURK_API void murk_volume_release(murk_volume *volume);
/** Copies the command that a VDB of murk's records (murk_write_options), "" where there is none or
 *  it takes more than `size` bytes; the grids are not read. Fails as murk_volume_read(). */
MURK_API murk_status murk_volume_command(murk_context *context, const char *path, char *text,
                                         size_t size);
/** The number of grids. */
MURK_API size_t murk_volume_grid_count(const murk_volume *volume);
/** Fills *out for the grid at index (0 <= index < count). Fails with MURK_ERROR_INPUT beyond. */
MURK_API murk_status murk_volume_grid_info(const murk_volume *volume, size_t index,
                                           murk_grid_info *out);
/** The unique name of the grid that murk would take for the density, or NULL where none fits. */
MURK_API const char *murk_volume_density(const murk_volume *volume);

/* ------------------------------------------------------------------------------------------ */
/* Medium                                                                                      */
/* ------------------------------------------------------------------------------------------ */

/** From wavelength[0] to wavelength[1] [m]; see band.h. Where both are the same, all quantities of
 *  the band are those per micrometre at that wavelength. Both 0: no band is known. */
typedef struct murk_band {
    double wavelength[2];
} murk_band;

/** Extinction, albedo and emission of the zones. */
typedef struct murk_medium murk_medium;

/** A quantity of the medium: grid value times scale where grid is a name, else the value. */
typedef struct murk_quantity {
    const char *grid;
    double scale;
    double value;
} murk_quantity;

/** An extinction value that stands for the density-like grid itself. */
#define MURK_FROM_GRID (-1.0)

/** How the medium follows from the grids; texts are borrowed for the call. */
typedef struct murk_medium_options {
    /** kappa_t [1/m]; of a level set, its scale times the part of a voxel that is inside. With grid
     *  NULL and a value >= 0: that value wherever the density-like grid is
     *  positive; with MURK_FROM_GRID: the density-like grid times scale. Densities of simulations
     *  carry no unit: scale 0 chooses the one of ..., 1, 2, 5, 10, 20, ... that brings the deepest
     *  column of the grid nearest to 5 optical depths (murk_medium_info tells which). */
    murk_quantity extinction;
    murk_quantity albedo;   /**< single-scattering albedo kappa_s/kappa_t in [0, 1] */
    murk_quantity emission; /**< E [W/m^2] >= 0 */
    /** T [K]: E gets pi times Planck's radiance in the band on top. Grid values times scale plus
     *  temperature_offset; 0: none. */
    murk_quantity temperature;
    double temperature_offset;
    murk_band band; /**< that temperatures radiate in */
    /** g, the mean cosine of the angle by which light is scattered, in (-1, 1); the phase function
     *  is that of Henyey and Greenstein. 0: isotropic. Solutions of other g are those of the
     *  similar medium that scatters isotropically, with kappa_s (1 - g); pictures show sunlight
     *  that is scattered once by the phase function itself. */
    double asymmetry;
    bool corner;       /**< voxel (i,j,k) covers [i, i+1] x ... instead of [i - 1/2, i + 1/2] */
    bool strict;       /**< NaN, infinite, negative values are an error, not empty */
    double voxel_size; /**< > 0 overrides the file's voxel size [m] (all three axes by ratio) */
} murk_medium_options;

#define MURK_MEDIUM_DEFAULT                                                                        \
    {                                                                                              \
        .extinction = {NULL, 0.0, MURK_FROM_GRID}, .albedo = {NULL, 1.0, 0.9},                     \
        .emission = {NULL, 1.0, 0.0}, .temperature = {NULL, 1.0, 0.0}, .temperature_offset = 0.0,  \
        .band = {{0.0, 0.0}}, .asymmetry = 0.0, .corner = false, .strict = false,                  \
        .voxel_size = 0.0                                                                          \
    }

/**
 * Builds the medium from the grids of a volume. options may be NULL. Active voxels without
 * extinction are no zones. An empty grid gives a valid medium without zones.
 * Grids on another transform than the extinction are resampled onto its voxels: the trilinear
 * interpolant at the centre of the voxel, or its mean over the voxel where the grid is finer. Of
 * emission, the background counts where the grid is not active, so that the light as a whole stays
 * the same; of albedo and temperature active voxels alone count, and the background holds where
 * there is none.
 * Fails with MURK_ERROR_INPUT for an unknown or unreadable grid, a frustum or sheared transform,
 * an albedo outside [0, 1], a temperature without a band, or, when strict, bad values.
 */
MURK_API murk_status murk_medium_from_volume(murk_context *context, const murk_volume *volume,
                                             const murk_medium_options *options, murk_medium **out);

/** A dense box of voxels for murk_medium_from_array(). Arrays have size[0]*size[1]*size[2] values,
 *  the last index (z) running fastest, and are copied. */
typedef struct murk_array {
    int32_t size[3];
    double voxel_size[3];  /**< m */
    double origin[3];      /**< world position of the low corner of voxel (0, 0, 0) [m] */
    const float *kappa_t;  /**< 1/m; NULL: kappa_t_value everywhere */
    const float *albedo;   /**< NULL: albedo_value */
    const float *emission; /**< W/m^2; NULL: emission_value */
    double kappa_t_value, albedo_value, emission_value;
    double asymmetry; /**< as in murk_medium_options */
} murk_array;

/** Builds a medium from arrays in memory. Fails like murk_medium_from_volume(). */
MURK_API murk_status murk_medium_from_array(murk_context *context, const murk_array *array,
                                            murk_medium **out);

/** Bricks of 8 x 8 x 8 voxels for murk_medium_from_bricks(), in any order; what they do not cover
 *  is empty. Arrays are copied. Those of values have 512 a brick, the last index (z) fastest: the
 *  voxel (8*x + i, 8*y + j, 8*z + k) of the brick at (x, y, z) is value 64*i + 8*j + k of it. */
typedef struct murk_brick_array {
    size_t count;
    const int32_t *brick;  /**< 3 * count: x, y, z */
    double voxel_size[3];  /**< m */
    double origin[3];      /**< world position of the low corner of voxel (0, 0, 0) [m] */
    const float *kappa_t;  /**< 1/m; 0: not an active voxel */
    const float *albedo;   /**< NULL: albedo_value */
    const float *emission; /**< W/m^2; NULL: emission_value */
    double albedo_value, emission_value;
    double asymmetry; /**< as in murk_medium_options */
} murk_brick_array;

/** Builds a medium from bricks in memory: the way in for sparse media of other programs. Fails like
 *  murk_medium_from_volume(), and where a brick is there twice. */
MURK_API murk_status murk_medium_from_bricks(murk_context *context, const murk_brick_array *bricks,
                                             murk_medium **out);
/** Releases a medium; NULL is nothing. */
MURK_API void murk_medium_release(murk_medium *medium);

/** What a medium came to. */
typedef struct murk_medium_info {
    uint64_t zones;                /**< active voxels with kappa_t > 0 */
    uint64_t bricks;               /**< 8x8x8 bricks that hold them */
    uint64_t input_voxels;         /**< active voxels of the input grid */
    uint64_t invalid_voxels;       /**< treated as empty: NaN, infinite or negative */
    double voxel_size[3];          /**< m */
    double box_min[3], box_max[3]; /**< world-space box around the zones [m] */
    double extinction_scale; /**< kappa_t per unit of the grid; 0 where it is not from a grid */
    double kappa_t_max;      /**< 1/m */
    double mean_depth; /**< mean optical depth along the shortest index axis, over columns with
                          zones */
    double max_depth;
} murk_medium_info;
/** Fills *out. */
MURK_API murk_status murk_medium_info_get(const murk_medium *medium, murk_medium_info *out);

/* ------------------------------------------------------------------------------------------ */
/* Ground                                                                                      */
/* ------------------------------------------------------------------------------------------ */

/** The axis of the world that points up. */
typedef enum murk_up { MURK_UP_Z, MURK_UP_Y } murk_up;

/**
 * The plane up = height below the medium, with nx * ny patches over extent and, where horizon is
 * set, ever larger patches around them out to the horizon with the mean reflectance and emission.
 * Horizontal coordinates (a, b) are (x, y) for up = z and (x, z) for up = y.
 */
typedef struct murk_ground_options {
    murk_up up;
    double height;                       /**< m */
    double extent_min[2], extent_max[2]; /**< m, in (a, b) */
    int patches[2];                      /**< nx, ny >= 1 */
    double reflectance;                  /**< rho in [0, 1], used where reflectance_image is NULL */
    const float *reflectance_image;      /**< nx * ny values in image order (see below); copied */
    double emission;                     /**< W/m^2, used where emission_image is NULL */
    const float *emission_image;         /**< nx * ny values in image order; copied */
    bool horizon;                        /**< false: nothing outside extent (black, no emission) */
} murk_ground_options;
/* Image order: row 0 is at the largest y (up = z) or the smallest z (up = y), that is the far edge
   seen from above with x to the right; column 0 is at the smallest x. */

#define MURK_GROUND_DEFAULT                                                                        \
    {                                                                                              \
        .up = MURK_UP_Z, .height = 0.0, .extent_min = {0, 0}, .extent_max = {1, 1},                \
        .patches = {64, 64}, .reflectance = 0.3, .reflectance_image = NULL, .emission = 0.0,       \
        .emission_image = NULL, .horizon = true                                                    \
    }

/** The patches of the ground. */
typedef struct murk_ground murk_ground;

/** Makes a ground. options may be NULL. Fails with MURK_ERROR_INPUT for an extent or a number of
 *  patches that is none, a reflectance outside [0, 1] or a negative emission. */
MURK_API murk_status murk_ground_create(murk_context *context, const murk_ground_options *options,
                                        murk_ground **out);
/** Releases a ground; NULL is nothing. */
MURK_API void murk_ground_release(murk_ground *ground);
/** nx and ny, without what horizon adds. */
MURK_API void murk_ground_patches(const murk_ground *ground, int patches[2]);

/* ------------------------------------------------------------------------------------------ */
/* Scene                                                                                       */
/* ------------------------------------------------------------------------------------------ */

/** A point source at infinity. */
typedef struct murk_sun {
    double direction[3]; /**< direction of travel, any length > 0 */
    double irradiance;   /**< F [W/m^2] on a plane perpendicular to the beam; 0: no sun */
} murk_sun;

/** What is lit by what. The medium and the ground are borrowed for the call and kept alive by
 *  solutions made from them. */
typedef struct murk_scene {
    const murk_medium *medium; /**< required; may hold no zones */
    const murk_ground *ground; /**< NULL: none; the sky is then all around */
    murk_sun sun;
    double sky_radiance; /**< uniform sky [W/m^2/sr] */
} murk_scene;

/** A scene that gives a picture with no further thought: a sun from the upper left behind the
 *  camera, a uniform sky, and a ground under the medium (*ground, to be released by the caller)
 *  that holds the medium's shadow and carries a pattern of bright squares. */
MURK_API murk_status murk_scene_default(murk_context *context, const murk_medium *medium,
                                        murk_up up, murk_scene *scene, murk_ground **ground);

/** Puts a default ground under the medium for the sun of the scene, as murk_scene_default() does;
 *  what options leave open (extent_min == extent_max, patches 0) is chosen. */
MURK_API murk_status murk_ground_fit(murk_context *context, const murk_medium *medium,
                                     const murk_sun *sun, murk_ground_options *options);

/* ------------------------------------------------------------------------------------------ */
/* Solve                                                                                       */
/* ------------------------------------------------------------------------------------------ */

/** How light is exchanged between zones and patches. */
typedef enum murk_method {
    MURK_LINES,   /**< exchange over lattices of parallel lines, never stored: the default */
    MURK_PAIRWISE /**< all exchange factors of [BG91] eqs. (3)-(6): O(N^2), small media only */
} murk_method;

/** How the system of equations is solved. */
typedef enum murk_solver {
    MURK_CONJUGATE_GRADIENTS,
    MURK_GAUSS_SEIDEL /**< [BG91] eqs. (7)-(10), pairwise only */
} murk_solver;

/** A camera in right-handed world coordinates: a pinhole, or with parallel rays. */
typedef struct murk_camera {
    double eye[3], target[3], up[3];
    double fov;    /**< vertical field of view, degrees, in (0, 180) */
    int size[2];   /**< width, height in pixels, >= 1 */
    double height; /**< of the picture [m]: all rays are parallel to the line of sight, begin in the
                        plane of the eye, and there is no fov. 0: a pinhole */
} murk_camera;

/** The radiosities of the zones and patches of one scene. */
typedef struct murk_solution murk_solution;

/** How well, and by which method, to solve. */
typedef struct murk_solve_options {
    double tolerance; /**< relative error of B asked for, kappa_t-weighted L2 norm (0.01 = 1 %) */
    murk_method method;
    murk_solver solver;
    int directions;     /**< lines: 0 chooses by tolerance, and halves voxels where that needs it;
                             else rounded up to a multiple of 48, for the voxels as they are */
    int rays;           /**< lines: rays per voxel face and axis (1: one per face, 2: 2x2); 0: 1 */
    double epsilon;     /**< Gauss-Seidel: largest change of a radiosity at the end [W/m^2] */
    int max_iterations; /**< 0: 1000 */
    int window[3];      /**< pairwise: zones Mx, My, Mz of [BG91] eq. (19); 0: all */
    /** lines: where the iteration starts, such as the frame before: voxels with the same index take
     *  their light from it. It changes the time, not the result within the tolerance. NULL: none.
     *  Borrowed for the call. */
    const murk_solution *start;
    /** lines: the one camera that the solution is for, or NULL. What it cannot see is then solved
     *  coarsely where that saves time: such zones and their margin are not within the tolerance,
     * and the report has no energies (NaN). Borrowed for the call. */
    const murk_camera *camera;
} murk_solve_options;

#define MURK_SOLVE_DEFAULT                                                                         \
    {                                                                                              \
        .tolerance = 0.01, .method = MURK_LINES, .solver = MURK_CONJUGATE_GRADIENTS,               \
        .directions = 0, .rays = 0, .epsilon = 1e-9, .max_iterations = 0, .window = {0, 0, 0},     \
        .start = NULL, .camera = NULL                                                              \
    }

/** What a solve did; energies in W over the medium, times in s. */
typedef struct murk_report {
    uint64_t zones, patches, bricks;
    uint64_t memory; /**< estimated before solving: see murk_solve_memory() [bytes] */
    const char *method, *solver, *kernel;
    int threads;
    int directions;   /**< of the final quadrature; 0 for pairwise */
    int iterations;   /**< Gauss-Seidel or conjugate-gradient steps, all levels */
    int sweeps;       /**< applications of the exchange operator, in units of 48 directions on all
                           zones */
    double crossings; /**< lines: zones times directions that were traced, all applications */
    double crossings_dark;   /**< of them, those passed over because there was no light to carry */
    double crossings_unseen; /**< of them, those that the camera saved */
    double seconds_exchange; /**< lines: time in those applications */
    uint64_t lamps;          /**< lines: zones and patches that are so bright and compact that their
                                  light was followed to each zone and patch */
    int coarsening;          /**< lines: edge of the zones on which the scattering orders were
                                  iterated, in voxels; 1: none were merged */
    double residual;         /**< relative; lines: on the fine level, before the last correction */
    double tolerance;        /**< as asked */
    double estimate;         /**< relative error estimated: the sum of its parts */
    double estimate_angular; /**< of directions and the lines that stand for each */
    double
        estimate_lattice; /**< of it, what the lines bring in: its root of squares with the rest */
    double estimate_spatial; /**< of light that varies within a zone otherwise than was reckoned */
    double estimate_iteration;
    int subdivision;        /**< lines: voxels were cut into this many each way for solving */
    bool reached;           /**< estimate <= tolerance */
    double multiplications; /**< [BG91] eq. (18) for this scene: what all stored factors
                                 would cost per iteration */
    double multiplications_window; /**< [BG91] eq. (19); 0 without a window */
    /* With forward scattering the energies are those of the similar medium that scatters
       isotropically: light that is scattered forward is not extinguished there. */
    double energy_emitted;  /**< by the zones: sum of 4 kappa_a E V */
    double energy_sun;      /**< sunlight extinguished in the zones */
    double energy_diffuse;  /**< sky and ground light extinguished in the zones */
    double energy_absorbed; /**< in the zones: sum of kappa_a G V */
    double energy_escaped;  /**< left the zones for sky and ground */
    double energy_balance;  /**< |emitted + sun + diffuse - absorbed - escaped| / sources */
    double seconds_setup, seconds_light, seconds_solve, seconds_finish;
} murk_report;

/**
 * Solves [BG91] eqs. (1), (2) for the scene. options may be NULL. Returns MURK_NOT_REACHED, with
 * a solution, where the estimated error stays above the tolerance. Fails with MURK_ERROR_INPUT for
 * options out of their range, a sun without direction, negative light, or
 * Gauss-Seidel without pairwise; with MURK_ERROR_MEMORY when memory runs out.
 */
MURK_API murk_status murk_solve(murk_context *context, const murk_scene *scene,
                                const murk_solve_options *options, murk_solution **out);
/** Releases a solution; NULL is nothing. */
MURK_API void murk_solution_release(murk_solution *solution);
/** What the solve did; belongs to the solution. */
MURK_API const murk_report *murk_solution_report(const murk_solution *solution);

/** Radiosity B [W/m^2] of the voxel at an index; NaN outside the solution's voxels. */
MURK_API double murk_solution_radiosity(const murk_solution *solution, const int32_t index[3]);

/**
 * Copies the voxels of the solution (zones, other active input voxels, and the margin of two):
 * index[3*n] and radiosity[n] may be NULL; *count is the number there are in all. At most
 * capacity voxels are copied, in ascending order of bricks.
 */
MURK_API murk_status murk_solution_voxels(const murk_solution *solution, size_t capacity,
                                          int32_t *index, float *radiosity, size_t *count);

/** Copies the nx * ny patch radiosities [W/m^2] in image order. Fails when there is no ground. */
MURK_API murk_status murk_solution_ground(const murk_solution *solution, float *radiosity);

/** Which grids murk_solution_write() adds to the radiosity. */
typedef struct murk_write_options {
    /** The grid of it that the extinction came from, else its density, passes through untouched.
     *  May be NULL. */
    const murk_volume *source;
    bool emission_coefficient; /**< kappa_t * B / pi [W/m^3/sr] */
    bool extinction;           /**< kappa_t [1/m] */
    bool albedo;
    bool half;           /**< 16-bit floats */
    const char *command; /**< recorded in the file metadata; may be NULL */
} murk_write_options;

#define MURK_WRITE_DEFAULT                                                                         \
    {                                                                                              \
        .source = NULL, .emission_coefficient = false, .extinction = false, .albedo = false,       \
        .half = false, .command = NULL                                                             \
    }

/** Writes the solution as VDB: to a file beside the target that is then renamed, or, for "-", as a
 *  stream to standard output. Fails with MURK_ERROR_IO where that is impossible. */
MURK_API murk_status murk_solution_write(const murk_solution *solution, const char *path,
                                         const murk_write_options *options);

/** Takes a solution from the "radiosity" grid of a volume: the light on the ground follows from it
 *  by one application of the exchange operator; nothing is solved again. Fails where the file says
 *  that it was solved with another asymmetry. */
MURK_API murk_status murk_solution_from_volume(murk_context *context, const murk_scene *scene,
                                               const murk_volume *volume, murk_solution **out);

/* ------------------------------------------------------------------------------------------ */
/* Render                                                                                      */
/* ------------------------------------------------------------------------------------------ */

/** Fills *out with a camera of 512 x 512 pixels that frames the medium and its shadow on the
 * ground. */
MURK_API murk_status murk_camera_default(murk_context *context, const murk_scene *scene,
                                         murk_camera *out);

/** Whether a camera can take a picture of the scene; murk_render() fails in the same way, but only
 *  after the scene is solved. */
MURK_API murk_status murk_camera_check(murk_context *context, const murk_scene *scene,
                                       const murk_camera *camera);

/** How a picture is taken. */
typedef struct murk_render_options {
    int samples;        /**< per pixel and axis; 0: 2 (that is 4 a pixel) */
    bool no_background; /**< leave ground and sky out of the picture (they still light it) */
    /** Shown in place of the sky where a ray meets no ground: R, G, B in [W/m^2/sr], or its first
     *  channel for all three, stretched over the picture. NULL: the sky. Borrowed for the call. */
    const murk_image *background;
    bool parts; /**< add channels for what a sensor sees, see murk_render() */
} murk_render_options;

#define MURK_RENDER_DEFAULT                                                                        \
    {                                                                                              \
        .samples = 0, .no_background = false, .background = NULL, .parts = false                   \
    }

/**
 * Renders [BG91] eq. (11): channels R G B A (premultiplied by the medium's opacity,
 * A = 1 - transmittance), transmittance.Y, path.R path.G path.B (light from the medium),
 * surface.R surface.G surface.B (attenuated light of ground, sky or background; R = path.R +
 * surface.R) [W/m^2/sr] and Z, the distance [m] along the viewing axis at which half the ray's
 * optical depth is passed (infinite where the ray meets no medium). With options->parts also
 * scattered.Y and emitted.Y, which the path radiance consists of (light that zones scatter, and
 * what they radiate by themselves towards the camera), inherent.R inherent.G inherent.B (the
 * surface's light before it enters the medium) and depth.Y, the mean optical depth. Where the
 * medium scatters forward, the path radiance also holds what is scattered forward of the light of
 * ground and sky. options may be NULL. Fails with MURK_ERROR_INPUT for a camera
 * as murk_camera_check() does or a solution of another medium or ground; with MURK_ERROR_MEMORY
 * when memory runs out.
 */
MURK_API murk_status murk_render(murk_context *context, const murk_scene *scene,
                                 const murk_solution *solution, const murk_camera *camera,
                                 const murk_render_options *options, murk_image **out);

/** Fails as murk_image_write() or, for .vdb and "-", murk_solution_write() would for this path:
 *  unknown format, folder that is not there or cannot be written. To be asked before long work. */
MURK_API murk_status murk_output_check(murk_context *context, const char *path);

#ifdef __cplusplus
}
#endif
#endif
