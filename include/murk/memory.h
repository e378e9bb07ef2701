/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file memory.h
 * How much memory the library's arrays take, how much they may, and what a solve or a picture is
 * going to need. Memory belongs to the process, so these are the same for all contexts. Counted are
 * the arrays of murk itself; not what OpenVDB and OpenImageIO take while they read and write.
 */
#ifndef MURK_MEMORY_H
#define MURK_MEMORY_H

#include "murk.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The bytes that all arrays of this process together may take; 0: as many as there are. What would
 *  need more then fails with MURK_ERROR_MEMORY, and murk_solve() and murk_render() do so before
 *  they begin where their estimates tell. */
MURK_API void murk_memory_limit(uint64_t bytes);

/** The bytes that the arrays take now. */
MURK_API uint64_t murk_memory_used(void);

/** The most that they took at any time. */
MURK_API uint64_t murk_memory_peak(void);

/** What this process can get from the machine: the smallest of its physical memory, the limits of
 *  its control groups (version 1 or 2), and RLIMIT_AS. */
MURK_API uint64_t murk_memory_machine(void);

/** The most bytes that murk_solve_many() is going to add to murk_memory_used() for these scenes.
 *  options may be NULL. Voxels are only halved where that fits too, so that is not part of it; 0
 *  for scenes without a medium. */
MURK_API uint64_t murk_solve_memory(murk_context *context, const murk_scene scene[], size_t count,
                                    const murk_solve_options *options);

/** The same of murk_render(), or, for `bands` >= 1, of murk_render_bands(), and of what writing the
 *  picture takes. */
MURK_API uint64_t murk_render_memory(const murk_scene *scene, const murk_camera *camera,
                                     size_t bands);

/** The same of murk_render_deep(), for smoke that fills a part of the picture: 10 samples a pixel
 * on average. Only rendering tells how many there are; a camera inside of smoke takes up to three
 *  times as much. */
MURK_API uint64_t murk_render_deep_memory(const murk_scene *scene, const murk_camera *camera,
                                          size_t bands);

#ifdef __cplusplus
}
#endif
#endif
