/* SPDX-License-Identifier: Apache-2.0 */
/* The media of the stress suite. Each sets the voxels of a scene, of the size that it has; tau is
   the optical depth of a voxel along x. A tenth of the voxels emit 1 W/m^2. */
#ifndef STRESS_MEDIA_H
#define STRESS_MEDIA_H

#include "stress.h"

/* A box of which a third is empty and the rest has any extinction up to tau a voxel. */
void stress_porous(struct stress_scene *scene, double tau);
void stress_of_albedo(struct stress_scene *scene, double albedo);
/* Of albedos 0, 1 and all between. */
void stress_of_any_albedo(struct stress_scene *scene, double tau);
void stress_thin(struct stress_scene *scene, double tau);
/* Albedo 1 - 1e-6. */
void stress_thick(struct stress_scene *scene, double tau);
/* 32^3: enough zones for coarse ones. */
void stress_large(struct stress_scene *scene, double tau);
/* Every other voxel has 1e-6 of its neighbours' extinction. */
void stress_neighbours(struct stress_scene *scene, double tau);
/* Any extinction over six decades. */
void stress_wild(struct stress_scene *scene, double tau);
void stress_voxel_checkers(struct stress_scene *scene, double tau);
void stress_brick_checkers(struct stress_scene *scene, double tau);
/* Voxels that touch in corners alone. */
void stress_diagonal(struct stress_scene *scene, double tau);
void stress_single(struct stress_scene *scene, double tau);
/* One voxel thick along the axis. */
void stress_sheet(struct stress_scene *scene, double axis);
void stress_clouds(struct stress_scene *scene, double distance);
/* z edges ratio times the others; 1 optical depth along the longest. */
void stress_stretched(struct stress_scene *scene, double ratio);
void stress_of_size(struct stress_scene *scene, double metres);

#endif
