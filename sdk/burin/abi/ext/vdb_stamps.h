/* burin/abi/ext/vdb_stamps.h - host service: grids of .vdb files sampled at (x, y, z).
 *
 * A stamp is the box of a grid's active voxels: x, y and z of the file run along a stroke, across it and
 * outward, from 0 at the box's least corner. A box of n voxels is n voxels long: the middle of the first is
 * at half a voxel, and along a periodic axis place x + n voxels is place x. So the period along x is exactly
 * the number of voxels that the active ones reach over, whatever the grid's name or transform say. The caller
 * tells how long a voxel is; of the file's transform only the ratio of its distances to its voxels is used.
 *
 * Hosts without OpenVDB do not offer this service.
 */
#ifndef BURIN_ABI_EXT_VDB_STAMPS_H
#define BURIN_ABI_EXT_VDB_STAMPS_H

#include "../host.h"

#ifdef __cplusplus
extern "C" {
#endif

#define BURIN_EXT_VDB_STAMPS "burin.vdb-stamps/1"

/* FROZEN. A handle of an open grid. */
typedef struct burin_vdb_stamp {
  uint64_t handle; /* 0 = none */
} burin_vdb_stamp;

/* What the values of a grid are. */
typedef int32_t burin_vdb_kind;
enum {
  BURIN_VDB_UNKNOWN = 0,
  BURIN_VDB_LEVEL_SET = 1, /* signed distances to a surface, negative inside */
  BURIN_VDB_FOG = 2        /* densities; 0 where there is none */
};

/* Bits of burin_vdb_options.periodic. */
#define BURIN_VDB_PERIODIC_X 1U
#define BURIN_VDB_PERIODIC_Y 2U
#define BURIN_VDB_PERIODIC_Z 4U

/* Options for opening a grid. */
typedef struct burin_vdb_options {
  uint32_t struct_size;
  uint32_t periodic; /* BURIN_VDB_PERIODIC_*: the axes along which the box repeats without an end */
  const char* grid;  /* its name; null or empty: the first grid of floats in the file */
  double surface_at; /* above 0: a fog volume is opened as the level set of this density */
} burin_vdb_options;

/* Facts about an open grid. The caller sets struct_size; open fills the rest. */
typedef struct burin_vdb_info {
  uint32_t struct_size;
  burin_vdb_kind kind;
  uint32_t size[3];       /* of the box, voxels */
  float minimum, maximum; /* over the box: distances in voxels, or densities */
  uint32_t reserved;
} burin_vdb_info;

/* The service; burin_host.get_extension returns it. */
typedef struct burin_vdb_stamps {
  uint32_t struct_size;
  uint32_t reserved;

  /* Opens a grid of a file. The same grid may be opened many times and is held in memory once. info may be
   * null. [stroke-thread] */
  burin_status(BURIN_CALL* open)(const burin_host* host, const char* path, const burin_vdb_options* options,
                                 burin_vdb_stamp* stamp, burin_vdb_info* info, burin_text* error);

  /* [stroke-thread, no sample call running] */
  void(BURIN_CALL* close)(const burin_host* host, burin_vdb_stamp stamp);

  /* Writes trilinear samples at `count` places, at which a voxel is `voxel` long (above 0); all lengths in
   * one unit. Values of a level set are distances in that unit. Beyond the box there is nothing: there they
   * are lower bounds of the distance to what is in it, and densities are 0. [any thread, concurrent, between
   * open and close] */
  burin_status(BURIN_CALL* sample)(const burin_host* host, burin_vdb_stamp stamp, uint32_t count,
                                   burin_floats voxel, burin_floats x, burin_floats y, burin_floats z,
                                   burin_floats_out values);
} burin_vdb_stamps;

#ifdef __cplusplus
}
#endif
#endif
