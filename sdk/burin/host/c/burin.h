/* burin/host/c/burin.h - Burin for applications in C, and in every language that calls C: libburin.so.
 *
 *   burin_library_create(&options, &library, &error);
 *   burin_library_load(library, NULL, &error);                  // the brushes
 *   burin_session_create(library, &mesh, &session, &error);     // a surface, from the caller's arrays
 *   burin_session_begin(session, &stroke, &error);
 *   burin_session_add(session, &sample, 1, NULL, &error);       // for every sample of the pen
 *   burin_session_update(session, BURIN_POSITIONS, 64, ranges, 32, &count, &error);  // what to upload
 *   burin_session_end(session, &error);
 *   burin_session_destroy(session);
 *   burin_library_destroy(library);
 *
 * The rules of burin/abi/base.h hold: sized structs, which the caller zeroes before it sets struct_size and
 * members; a status and a text for every call that may fail; buffers of the caller's. Besides:
 *  - BURIN_INVALID_ARGUMENT is what breaks a rule of this header: an argument that is null where its comment
 * does not allow it, a struct that is too small, a number out of range. Such a call changes nothing, nor does
 * one that gives BURIN_NOT_FOUND. Any other failure within a stroke drops it: the surface is as before the
 *    stroke, which the next update tells. Functions without a status return 0 or null.
 *  - Vertices are numbers from 0, those of the arrays that the caller gave unless it chose
 * BURIN_ORDER_SURFACE.
 *  - Libraries are for one thread, on which brushes are loaded, created and destroyed: the main thread, if
 *    brushes are to find what the plugin ABI promises. A session belongs to one thread at a time and, while
 *    a stroke is open, to one thread; its first stroke with a brush and its destruction belong on the main
 *    thread. Different sessions may be used at once. Inside, sessions use all threads of oneTBB, or those
 * that burin_library_options.run lends.
 *  - There is no global state: libraries and sessions know nothing of others. Nothing is written to standard
 *    streams.
 */
#ifndef BURIN_HOST_C_BURIN_H
#define BURIN_HOST_C_BURIN_H

#include <burin/abi/ext/log.h>
#include <burin/abi/plugin.h>
#include <burin/host/recorder.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Functions and structs are added with a new minor version, never changed: a program that was built with this
 * header runs with every later library of the same major version, which is that of libburin.so.0. */
#define BURIN_C_MAJOR 0u
#define BURIN_C_MINOR 6u

/* What a library is. */
typedef struct burin_version_info {
  uint32_t struct_size;
  uint32_t major, minor;         /* of this header when the library was built: BURIN_C_MAJOR, BURIN_C_MINOR */
  uint32_t abi_major, abi_minor; /* of the plugins that it loads */
  uint32_t reserved;
  const char* text; /* version of Burin, "0.1.0"; lives as long as the library is loaded */
} burin_version_info;

/* Fills the members that info->struct_size covers. [any thread, concurrent] */
BURIN_API burin_status BURIN_CALL burin_get_version(burin_version_info* info, burin_text* error);

/* ---- Brushes ---- */

typedef struct burin_library burin_library;

/* Receives a line of a brush or of the library. It must not call Burin; it is called on any thread, also on
 * several at once. `line` is valid during the call. */
typedef void(BURIN_CALL* burin_log_function)(void* user, burin_log_severity severity, const char* line);

/* A task of Burin's. */
typedef void(BURIN_CALL* burin_task)(void* tasks, uint64_t number);

/* Calls task(tasks, number) once for each number below `count`, on any threads, several at once, in any
 * order, and returns when all calls have returned. It must not throw or call Burin otherwise. */
typedef void(BURIN_CALL* burin_run_tasks)(void* user, burin_task task, void* tasks, uint64_t count);

/* How a library is made. With `isolate` no code of plugins runs in the caller's process: every brush has a
 * process of its own, with results of the same bits. One that crashes, hangs or takes too much memory makes
 * its stroke fail with BURIN_ERROR and a text that tells where; the next stroke starts another process. Linux
 * only; elsewhere burin_library_create fails. */
typedef struct burin_library_options {
  uint32_t struct_size;
  uint32_t isolate;       /* since 0.2: 1: brushes run in processes of their own; 0: in the caller's */
  burin_log_function log; /* null: lines are discarded */
  void* user;             /* is given to log */
  /* Since 0.2, with `isolate`. Seconds are of wall-clock time; infinity waits for ever. */
  const char* brush_process; /* the program that brushes run in, UTF-8; null: burin-brush-process beside
                                libburin.so, or in lib/burin beside its folder, where it is installed */
  double load_seconds;       /* for starting it, loading a module and creating a brush; 0: 20 */
  double call_seconds;       /* for begin and end of a stroke and other calls but batches; 0: 20 */
  double batch_seconds;      /* for the evaluation of one batch, at most 1024 nodes; 0: 5 */
  uint64_t memory; /* bytes of address space that a brush may take; 0: 4 GiB; UINT64_MAX: no bound */
  /* Since 0.3. Threads that the application lends: the sessions of the library run their loops by this, on
   * the thread of a call and those of the application, instead of those of oneTBB, and start no threads.
   * Calls come from threads that use sessions, one call within another never. Results have the same bits. */
  burin_run_tasks run;  /* null: oneTBB, whose arena is that of the thread that calls */
  void* run_user;       /* is given to run */
  uint32_t run_threads; /* how many of them work at once; a hint for how finely work is divided */
  uint32_t reserved;
} burin_library_options;

/* Makes a library without brushes. `options` may be null. */
BURIN_API burin_status BURIN_CALL burin_library_create(const burin_library_options* options,
                                                       burin_library** library, burin_text* error);

/* Frees the library, which may be null. Its brushes live on until the last session of it is destroyed. */
BURIN_API void BURIN_CALL burin_library_destroy(burin_library* library);

/* Loads brushes from `path`, UTF-8: a module, or all modules NAME.burin of a folder, in the order of their
 * names. Null: from the folders of the environment variable BURIN_PLUGIN_PATH, then the stock brushes that
 * are installed with libburin.so, if they are. A module of a folder that cannot be loaded is passed over: a
 * warning in the log tells why, and so does burin_library_refused. A module by itself that cannot be loaded,
 * or a folder that cannot be read, fails. Modules that are there already are skipped. */
BURIN_API burin_status BURIN_CALL burin_library_load(burin_library* library, const char* path,
                                                     burin_text* error);

/* Loads a module that is there anew, from its file as it is now. The next stroke of every session draws with
 * the new brushes, which take over the state of the old ones. Descriptors of the module are no longer valid.
 * If the call fails the old module stays. Whoever writes a new file must not write over the old one before
 * the first time, but remove it or rename another over it. */
BURIN_API burin_status BURIN_CALL burin_library_reload(burin_library* library, const char* path,
                                                       burin_text* error);

/* Adds brushes that the application has itself, without a module: for languages that make no modules, and for
 * brushes that are part of the application. They are called as those of modules are, by the rules of
 * burin/abi/plugin.h and brush.h: `evaluate` on any thread, on several at once, while a call of the session
 * waits for them. `name`, UTF-8, stands in error messages where others have the path of their module. If
 * there are brushes of this name the new ones take their place, as in burin_library_reload; their descriptors
 * must have other addresses. The factories and descriptors must live until the library and all its sessions
 * are destroyed. If the call fails nothing changes. */
BURIN_API burin_status BURIN_CALL burin_library_add(burin_library* library, const char* name,
                                                    const burin_brush_factory* factory, burin_text* error);

/* The number of brushes. */
BURIN_API uint64_t BURIN_CALL burin_library_brush_count(const burin_library* library);

/* The descriptor of a brush with all its parameters, as burin/abi/brush.h and param.h define them: a panel is
 * made of it. Members that BURIN_HAS denies, since the plugin is older, have the defaults of their comments.
 * Brushes are in the order of loading; null beyond the last. Valid as long as the library, or until its
 * module is loaded anew. */
BURIN_API const burin_brush_descriptor* BURIN_CALL burin_library_brush(const burin_library* library,
                                                                       uint64_t index);

/* The number of modules that were passed over. */
BURIN_API uint64_t BURIN_CALL burin_library_refused_count(const burin_library* library);

/* Why a module was passed over: one line that names it; null beyond the last. Valid until the library loads
 * again. */
BURIN_API const char* BURIN_CALL burin_library_refused(const burin_library* library, uint64_t index);

/* ---- Surfaces ---- */

typedef struct burin_session burin_session;

/* The type of the numbers of an array. */
typedef int32_t burin_number;
enum {
  BURIN_NUMBER_UNKNOWN = 0,
  BURIN_FLOAT32 = 1,
  BURIN_FLOAT64 = 2,
  BURIN_UINT32 = 3, /* also for int32_t: negative numbers are refused */
  BURIN_UINT64 = 4  /* also for int64_t */
};

/* The numbers that vertices have in all calls. Burin sorts them along a curve through space, so that a stroke
 * changes few ranges; a caller that can hold its buffers in that order uploads least. */
typedef int32_t burin_order;
enum {
  BURIN_ORDER_UNKNOWN = 0, /* BURIN_ORDER_CALLER */
  BURIN_ORDER_CALLER = 1,  /* as in burin_mesh.positions */
  BURIN_ORDER_SURFACE = 2  /* Burin's own; see burin_session_read_map and burin_session_read_triangles */
};

/* A mesh in arrays of the caller's, which are read during the call only: up to 2^32 - 1 vertices, triangles
 * and polygons, open, of several parts and not manifold if need be. Larger faces are cut into triangles
 * without new vertices. Vertices that are there several times, as along seams of texture coordinates, end
 * strokes: they must be joined. Positions become floats: those far from the origin lose digits unless the
 * caller moves them. */
typedef struct burin_mesh {
  uint32_t struct_size;
  burin_number position_type; /* BURIN_FLOAT32 or BURIN_FLOAT64 */
  const void* positions;      /* x, y and z of a vertex next to each other; finite, object units */
  uint64_t vertex_count;
  uint64_t position_stride; /* bytes from one vertex to the next; 0: 3 numbers */
  const void* corners;      /* vertices of the faces, counter-clockwise seen from outside */
  uint64_t face_count;
  uint64_t face_stride; /* bytes from one face to the next; 0: the corners of a face; without face_sizes */
  burin_number corner_type; /* BURIN_UINT32 or BURIN_UINT64, of corners and face_sizes */
  uint32_t face_size;       /* corners of every face, 3 or more; 0: face_sizes */
  const void* face_sizes; /* corners of each face, which lie face by face in `corners`; null with face_size */
  burin_order order;
  uint32_t refines; /* since 0.3, of burin_session_create only: 1: strokes with the setting "refine" may split
                       triangles, and such with "solid" merge solids with the surface, see
                       burin_session_take_patch; wants BURIN_ORDER_CALLER */
  /* Since 0.3, of burin_session_create only, null elsewhere. */
  const double* transform; /* 4 x 4 by columns, from the object to the world; affine, with an inverse; null:
                              the object's space is the world */
  const uint8_t* hidden;   /* a byte for each face, not 0: hidden, see burin_session_hide; null: faces are
                              never hidden */
} burin_mesh;

/* Makes a session that sculpts this mesh with the brushes of a library.
 *
 * With a transform, also one that scales axes differently, strokes are drawn in the world: samples, radii and
 * other settings, charts and what is snapped are the world's, and brushes are round there. Positions and
 * normals that are given, read and updated are the object's; those of vertices that are where they were given
 * have the bits that they were given with. Transforms that mirror are allowed: faces and normals are outward
 * in both spaces. The hash is that of positions in the world. An object that is moved or turned between
 * strokes may keep its session if its samples are moved back. Costs 12 bytes a vertex. */
BURIN_API burin_status BURIN_CALL burin_session_create(burin_library* library, const burin_mesh* mesh,
                                                       burin_session** session, burin_text* error);

/* Hides faces, or shows them again: from now on the surface is what the others make. Pens do not meet hidden
 * faces, charts end where they begin as at a border, vertices all of whose faces are hidden keep their bits
 * but for undo and redo, and normals are those of what is shown. `hidden`: a byte for each of face_count
 * faces, those of the mesh that the session was made of, which must have had such an array, if only of zeros;
 * null: none. Fails, and changes nothing, if no face with an area would be left. It is no step of undo, and
 * undo goes on. Costs as much as a new session. Not within a stroke. */
BURIN_API burin_status BURIN_CALL burin_session_hide(burin_session* session, const uint8_t* hidden,
                                                     uint64_t face_count, burin_text* error);

/* Frees the session, which may be null. */
BURIN_API void BURIN_CALL burin_session_destroy(burin_session* session);

/* What a session holds. */
typedef struct burin_session_info {
  uint32_t struct_size;
  uint32_t stroke_open; /* 1: a stroke is open */
  uint64_t vertex_count;
  uint64_t triangle_count; /* without those that have a vertex twice, and without those of hidden faces */
  uint64_t undo_count;     /* strokes that can be undone */
  uint64_t redo_count;     /* strokes that can be made again */
  uint64_t undo_bytes;     /* what both hold */
  uint64_t undo_dropped;   /* since 0.3: strokes that can no longer be undone for burin_session_limit_undo */
  uint64_t generation;     /* since 0.3: another number whenever strokes changed triangles */
  uint32_t has_colours;    /* since 0.4: 1: vertices have colours, which were written or painted; 0: there are
                              none, or none are left after strokes were undone, and a file needs none */
  uint32_t has_masks;      /* since 0.4: the same of masks */
  uint64_t solid_count; /* since 0.4: of what strokes made beside the surface, see burin_session_read_solid */
  uint64_t bent_mesh_count;
} burin_session_info;

/* Fills the members that info->struct_size covers. */
BURIN_API burin_status BURIN_CALL burin_session_get_info(const burin_session* session,
                                                         burin_session_info* info, burin_text* error);

/* Which numbers a map gives, and for which. */
typedef int32_t burin_map;
enum {
  BURIN_MAP_UNKNOWN = 0,
  BURIN_MAP_CALLER_TO_SURFACE = 1, /* element i: the number in Burin's order of vertex i of the caller's */
  BURIN_MAP_SURFACE_TO_CALLER = 2
};

/* Writes a map between the caller's order of vertices and Burin's, vertex_count numbers, whatever the order
 * that the session was made with. `capacity`: numbers that fit, at least vertex_count. */
BURIN_API burin_status BURIN_CALL burin_session_read_map(const burin_session* session, burin_map map,
                                                         uint32_t* numbers, uint64_t capacity,
                                                         burin_text* error);

/* Writes the triangles that are shown, three of the session's vertices each, counter-clockwise seen from
 * outside in the object, in the order of the surface, or with burin_mesh.refines the list as the next patch
 * will leave it. `capacity`: triangles that fit, at least triangle_count. */
BURIN_API burin_status BURIN_CALL burin_session_read_triangles(const burin_session* session,
                                                               uint32_t* corners, uint64_t capacity,
                                                               burin_text* error);

/* How triangles and vertices changed. Arrays belong to the session and are valid until its next call. */
typedef struct burin_patch {
  uint32_t struct_size;
  uint32_t reserved;
  uint64_t kept_vertices; /* the vertices below are those that they were */
  uint64_t vertex_count;  /* now: those kept, then new ones */
  uint64_t removed_count;
  const uint32_t* removed; /* places in the caller's list of triangles, ascending */
  uint64_t added_count;    /* triangles */
  const uint32_t* added;   /* three vertices each, counter-clockwise seen from outside in the object */
} burin_patch;

/* Tells how triangles and vertices changed since the call before, of a session whose burin_mesh.refines is 1:
 * within strokes that refine the surface, when these fail or are cancelled, by undo and redo, and by hiding
 * faces. The caller's list of triangles, at first that of burin_session_read_triangles, loses those that are
 * removed, keeps the order of the rest, and gets those that are added at its end; arrays of vertices get the
 * new count. A merged solid gives all vertices new numbers: none is kept then. burin_session_update tells the
 * values of new vertices as of all that change. A call without news gives an empty patch. Costs O(n log n)
 * where there are news, as the refining did. Whenever the count of vertices changes the arrays of
 * burin_session_values move. */
BURIN_API burin_status BURIN_CALL burin_session_take_patch(burin_session* session, burin_patch* patch,
                                                           burin_text* error);

/* ---- Strokes ---- */

/* A sample of the pen. What the pen does not report (burin_stroke.fields) is not read. */
typedef struct burin_sample {
  uint32_t struct_size;
  float pressure;       /* 0..1 */
  double time;          /* seconds; must not fall within a stroke. Samples of one time stamp slow the pen down
                           and speed it up: give those of a packet times of their own */
  double position[3];   /* near the surface, within a radius; with a direction where its ray starts */
  double direction[3];  /* zero: none; else the sample is the first place of the surface along this ray */
  float tilt_x, tilt_y; /* radians from upright, towards +x and +y */
  float twist;          /* radians */
  uint32_t barrel;      /* 1: a button at the pen's side is held, as a recording told; not used */
} burin_sample;

/* How a stroke is drawn. */
typedef struct burin_stroke {
  uint32_t struct_size;
  uint32_t fields; /* BURIN_PEN_* that the pen reports */
  /* Texts "KEY=VALUE", UTF-8, ended by a null pointer; at least brush and radius. The keys are those of
   * docs/stroke_format.md and docs/bench.md, the values as `burin replay` takes them: "radius=0.1",
   * "closed=auto", "clamp=true", "symmetry_centre=0,0,1". Two may be there several times: "params=NAME=VALUE"
   * and "dynamics=TARGET=SOURCE:X0,Y0,X1,Y1,...". */
  const char* const* settings;
  uint64_t seed; /* of random numbers */
  /* Since 0.4, with the setting "refine": the samples that the stroke will have, as far as they are known,
   * whose places or rays are read. The surface is refined there at once, which costs less than to refine it
   * again and again as the pen comes, and gives a recording's samples the bits of `burin replay`. Null: the
   * pen decides. */
  const burin_sample* path;
  uint64_t path_count;
} burin_stroke;

/* Whether a sample was drawn. */
typedef int32_t burin_outcome;
enum {
  BURIN_OUTCOME_UNKNOWN = 0,
  BURIN_OUTCOME_DRAWN = 1,
  BURIN_OUTCOME_OFF_SURFACE = 2 /* the ray misses, or no surface is near: the next sample on the surface
                                   begins another piece of the stroke */
};

/* What became of the samples of a call. */
typedef struct burin_event {
  uint32_t struct_size;
  burin_outcome outcome; /* of the last sample */
  uint64_t drawn;        /* how many of the samples were drawn */
} burin_event;

/* Opens a stroke. BURIN_NOT_FOUND if there is no such brush. */
BURIN_API burin_status BURIN_CALL burin_session_begin(burin_session* session, const burin_stroke* stroke,
                                                      burin_text* error);

/* Adds samples to the open stroke, one struct after the other. The surface is brought up to date once, after
 * the last: the result is that of one by one, at less cost. `event` may be null. */
BURIN_API burin_status BURIN_CALL burin_session_add(burin_session* session, const burin_sample* samples,
                                                    uint64_t count, burin_event* event, burin_text* error);

/* Ends the open stroke, which then can be undone unless it has no sample on the surface. */
BURIN_API burin_status BURIN_CALL burin_session_end(burin_session* session, burin_text* error);

/* Drops the open stroke, if there is one. */
BURIN_API burin_status BURIN_CALL burin_session_cancel(burin_session* session, burin_text* error);

/* Undoes the last stroke to the bit, or makes the one that was undone last again. BURIN_NOT_FOUND, and
 * nothing changes, if there is none. After another stroke there is nothing to redo. */
BURIN_API burin_status BURIN_CALL burin_session_undo(burin_session* session, burin_text* error);
BURIN_API burin_status BURIN_CALL burin_session_redo(burin_session* session, burin_text* error);

/* Bounds what undo and redo may hold, now and whenever a stroke ends: while it is more, the oldest stroke can
 * no longer be undone; burin_session_info.undo_dropped tells how many. Without a bound all can. */
BURIN_API burin_status BURIN_CALL burin_session_limit_undo(burin_session* session, uint64_t bytes,
                                                           burin_text* error);

/* What a stroke changed, for an undo stack of the application's own. */
typedef struct burin_step burin_step;

/* What a step holds. */
typedef struct burin_step_info {
  uint32_t struct_size;
  uint32_t reserved;
  uint64_t bytes;         /* of memory */
  uint64_t saved_bytes;   /* that burin_step_save writes */
  uint64_t vertex_count;  /* of vertices that move */
  uint64_t painted_count; /* of vertices whose colour or mask changes */
} burin_step_info;

/* Takes the step of the last stroke out of the session, whose burin_session_undo knows nothing of that stroke
 * any more. The step lives until it is destroyed, also without the session. BURIN_NOT_FOUND, if there is no
 * stroke to undo. Fails for a stroke that made a solid or a mesh beside the surface, or split triangles: its
 * step stays. The first call costs time in proportion to the surface, others to the stroke. */
BURIN_API burin_status BURIN_CALL burin_session_take_step(burin_session* session, burin_step** step,
                                                          burin_text* error);

/* Undoes the stroke of a step to the bit, the next time makes it again, and so on: vertices and step exchange
 * their values. Updates tell what changed. The session may be another one than that of the stroke, if it is
 * of the same mesh. BURIN_INVALID_ARGUMENT, and nothing changes, unless all positions, colours and masks are
 * as they were when the step was taken or applied last. Steps that the session itself holds do not look:
 * applications take all or none. Not within a stroke. */
BURIN_API burin_status BURIN_CALL burin_session_apply_step(burin_session* session, burin_step* step,
                                                           burin_text* error);

/* Frees the step, which may be null. [any thread] */
BURIN_API void BURIN_CALL burin_step_destroy(burin_step* step);

/* Fills the members that info->struct_size covers. [any thread, concurrent] */
BURIN_API burin_status BURIN_CALL burin_step_get_info(const burin_step* step, burin_step_info* info,
                                                      burin_text* error);

/* Writes a step to memory, for a document of the application's; with a checksum. `capacity`: bytes that fit,
 * at least saved_bytes. Vertices are numbers of the original mesh, whatever the session's order. [any thread,
 * concurrent] */
BURIN_API burin_status BURIN_CALL burin_step_save(const burin_step* step, void* bytes, uint64_t capacity,
                                                  burin_text* error);

/* Makes a step of what burin_step_save wrote. Fails for bytes that are damaged, cut off or something else.
 * Positions are the world's where the session has a transform: one that is made anew of positions that were
 * read differs in the last bits, so that steps are of that session only. [any thread, concurrent] */
BURIN_API burin_status BURIN_CALL burin_step_load(const void* bytes, uint64_t size, burin_step** step,
                                                  burin_text* error);

/* Is told what a call does that may take seconds, on the thread of the call: the name of the step, valid
 * during the call, and the share of it that is done, 0..1. Any return but 0 ends the call with BURIN_ERROR
 * and the text "cancelled". It must not call Burin with this session. */
typedef int32_t(BURIN_CALL* burin_progress_function)(void* user, const char* stage, double done);

/* Sets what burin_session_end tells while it makes solids, and burin_session_replay of all strokes; null:
 * none. `user` is given to it. */
BURIN_API burin_status BURIN_CALL burin_session_set_progress(burin_session* session,
                                                             burin_progress_function progress, void* user,
                                                             burin_text* error);

/* Draws all strokes of a recording, as `burin replay --refine off` does, or with "refine=auto" as
 * `burin replay`. `settings` are as those of burin_stroke, hold before the recording's own, and may be null.
 * If a stroke fails, those before it stay. */
BURIN_API burin_status BURIN_CALL burin_session_replay(burin_session* session, const char* path,
                                                       const char* const* settings, burin_text* error);

/* The number that `burin replay` prints as the result's hash: of positions, and of colours and masks if there
 * are any, in the order of the caller's vertices. */
BURIN_API burin_status BURIN_CALL burin_session_hash(const burin_session* session, uint64_t* hash,
                                                     burin_text* error);

/* ---- Strokes over several objects ---- */

/* Sessions that one pen draws on: each sample goes to the surface that its ray meets first, or which is
 * closest to its position. Where that changes a piece of the stroke ends on one surface, and the next begins
 * on the other, as where a pen leaves a surface and comes back. What the sessions show is updated in each of
 * them as always. */
typedef struct burin_group burin_group;

/* What became of the samples of a call. */
typedef struct burin_group_event {
  uint32_t struct_size;
  burin_outcome outcome; /* of the last sample */
  uint64_t drawn;        /* how many of the samples were drawn */
  uint64_t session;      /* on which of the sessions the pen is, from 0; the last one if it is on none */
} burin_group_event;

/* Makes a group of `count` different sessions, in the world with their transforms. They must outlive it, and
 * are used on its thread. */
BURIN_API burin_status BURIN_CALL burin_group_create(burin_session* const* sessions, uint64_t count,
                                                     burin_group** group, burin_text* error);

/* Frees the group, which may be null, not its sessions. An open stroke is dropped. */
BURIN_API void BURIN_CALL burin_group_destroy(burin_group* group);

/* Begins a stroke as burin_session_begin does. It is open in all sessions meanwhile, to which their own
 * burin_session_begin, _add, _end and _cancel are refused; if it fails in one it is dropped in all. Symmetric
 * images are drawn on the surface of the sample only. */
BURIN_API burin_status BURIN_CALL burin_group_begin(burin_group* group, const burin_stroke* stroke,
                                                    burin_text* error);

/* Adds samples as burin_session_add does, each to the session whose surface it is on. */
BURIN_API burin_status BURIN_CALL burin_group_add(burin_group* group, const burin_sample* samples,
                                                  uint64_t count, burin_group_event* event,
                                                  burin_text* error);

/* Ends the stroke in all sessions. */
BURIN_API burin_status BURIN_CALL burin_group_end(burin_group* group, burin_text* error);

/* Drops the stroke in all sessions. */
BURIN_API burin_status BURIN_CALL burin_group_cancel(burin_group* group, burin_text* error);

/* Undoes the group's last stroke in all sessions that it changed, as one step. BURIN_NOT_FOUND if there is
 * none, or if a session's bound has dropped its part. BURIN_INVALID_ARGUMENT while one of these sessions has
 * drawn or undone a stroke by itself since. Nothing changes then. */
BURIN_API burin_status BURIN_CALL burin_group_undo(burin_group* group, burin_text* error);

/* Makes the stroke again that was undone last, as one step; fails as burin_group_undo does. */
BURIN_API burin_status BURIN_CALL burin_group_redo(burin_group* group, burin_text* error);

/* ---- What to show ---- */

/* Values that each vertex has, floats next to each other. */
typedef int32_t burin_attribute;
enum {
  BURIN_ATTRIBUTE_UNKNOWN = 0,
  BURIN_POSITIONS = 1, /* x, y, z, object units */
  BURIN_NORMALS = 2,   /* x, y, z, unit, outward */
  BURIN_COLOURS = 3,   /* linear red, green, blue and coverage, 0..1; 1, 1, 1, 0 where nothing is painted */
  BURIN_MASKS = 4      /* 0 = protected .. 1 = free */
};

/* FROZEN. The vertices begin, begin + 1, .. end - 1. */
typedef struct burin_range {
  uint64_t begin, end;
} burin_range;

/* Brings burin_session_values of an attribute up to date, and tells where that changed a bit: in all that
 * happened since the last update of this attribute, be it samples, ends, undo, redo, cancelled strokes or
 * strokes that failed. The first update is of all vertices. Ranges are not empty, ascending and more than
 * `gap` vertices apart: fewer, larger ones for a larger gap. Where they would be more than `capacity`, which
 * is at least 1, those closest to each other become one. Costs what changed. */
BURIN_API burin_status BURIN_CALL burin_session_update(burin_session* session, burin_attribute attribute,
                                                       uint64_t gap, burin_range* ranges, uint64_t capacity,
                                                       uint64_t* count, burin_text* error);

/* The values of all vertices as of the last update; null before the first. The address stays the same until
 * the session is destroyed or its vertices become more or fewer. Other threads may read it while no call
 * updates. */
BURIN_API const float* BURIN_CALL burin_session_values(const burin_session* session,
                                                       burin_attribute attribute);

/* Where numbers are to be written. */
typedef struct burin_target {
  uint32_t struct_size;
  burin_number type; /* BURIN_FLOAT32 or BURIN_FLOAT64 */
  void* data;        /* of the first vertex of the range */
  uint64_t stride;   /* bytes from one vertex to the next; 0: the values of a vertex */
} burin_target;

/* Where numbers are to be read. */
typedef struct burin_source {
  uint32_t struct_size;
  burin_number type; /* BURIN_FLOAT32 or BURIN_FLOAT64 */
  const void* data;  /* of the first vertex of the range */
  uint64_t stride;   /* bytes from one vertex to the next; 0: the values of a vertex */
} burin_source;

/* Takes values of a range of vertices that other tools of the caller changed: positions, finite, or colours
 * or masks, 0..1; normals follow from positions. It is no step of undo, whose steps hold values of their own:
 * a caller that undoes its own moves by this call, in turn with strokes, gets every state again. Positions
 * cost what really moved, colours and masks a copy of all. The next update tells what changed. Not within a
 * stroke. */
BURIN_API burin_status BURIN_CALL burin_session_write(burin_session* session, burin_attribute attribute,
                                                      const burin_range* range, const burin_source* source,
                                                      burin_text* error);

/* Writes the current values of a range of vertices, whether or not there was an update. */
BURIN_API burin_status BURIN_CALL burin_session_read(const burin_session* session, burin_attribute attribute,
                                                     const burin_range* range, const burin_target* target,
                                                     burin_text* error);

/* The coordinates (t, d) of the vertices around the last piece of the open stroke, or of the last stroke. A
 * vertex that the stroke visits several times is there once for each visit, its sheets. Arrays have `count`
 * elements, belong to the session and are valid until its next call. */
typedef struct burin_chart {
  uint32_t struct_size;
  uint32_t closed; /* 1: t is periodic with `length` */
  uint64_t count;
  double length;          /* of the stroke, object units */
  const uint32_t* vertex; /* the session's numbers; in Burin's order */
  const uint32_t* sheet;  /* 0, 1, ... at each vertex, in the order of t */
  const double* t;        /* arc length along the stroke, object units */
  const float* d;         /* signed distance to the stroke, object units; positive on its left */
} burin_chart;

/* Fills the members that chart->struct_size covers. */
BURIN_API burin_status BURIN_CALL burin_session_chart(burin_session* session, burin_chart* chart,
                                                      burin_text* error);

/* ---- Snapping ---- */

/* Lines of a surface that strokes are moved to (docs/snapping.md). */
typedef int32_t burin_line;
enum {
  BURIN_LINE_UNKNOWN = 0,
  BURIN_LINE_RIDGE = 1,      /* where the surface is most convex across the stroke */
  BURIN_LINE_VALLEY = 2,     /* where it is most concave */
  BURIN_LINE_SILHOUETTE = 3, /* where it turns away from `view` */
  BURIN_LINE_BORDER = 4,     /* its open border */
  BURIN_LINE_HIGH = 5,       /* where `values` are greatest across the stroke */
  BURIN_LINE_LOW = 6,        /* where they are least */
  BURIN_LINE_CREASE = 7,     /* edges at which triangles meet at `least_angle` or more */
  BURIN_LINE_SUGGESTIVE = 8  /* where it would turn away from a `view` that moved a little */
};

/* How a stroke is snapped. */
typedef struct burin_snap {
  uint32_t struct_size;
  burin_line line;
  double radius; /* how far from the stroke lines are searched for, object units, > 0 */
  double scale;  /* how far the surface is smoothed across the stroke, object units: half the line's width is
                    best; 0: as `burin snap` chooses */
  double significance; /* least contrast that counts, in units of the noise; 0: 4 */
  double view[3]; /* of silhouettes and suggestive contours: the direction of sight, not zero, or the eye */
  uint32_t view_is_eye; /* 1: `view` is a place, object units */
  uint32_t fixed_ends;  /* 1: the ends of the stroke stay */
  const float* values;  /* of BURIN_LINE_HIGH and _LOW: one for each of the session's vertices, finite */
  double least_angle;   /* of creases, between the normals of triangles, degrees below 180; 0: 30 */
} burin_snap;

/* A snapped stroke. Samples belong to the session and are valid until its next call. */
typedef struct burin_snapped {
  uint32_t struct_size;
  uint32_t reserved;
  const burin_sample* samples; /* positions on the surface, half an edge apart */
  uint64_t sample_count;
  double share; /* of the stroke's length that was snapped; 0: nothing stands out, it stays as it was */
  double significance; /* contrast of the line, mean; if nothing was snapped the greatest anywhere */
  double mean_move;    /* of what was snapped, object units */
} burin_snapped;

/* Moves a stroke, whose samples all lie on the surface in one piece, to a line of the surface as it is after
 * the last stroke. Nothing is drawn: the samples of the result may be. Costs time and memory in proportion to
 * the surface. Not within a stroke. */
BURIN_API burin_status BURIN_CALL burin_session_snap(burin_session* session, const burin_snap* how,
                                                     const burin_sample* samples, uint64_t count,
                                                     uint32_t fields, burin_snapped* snapped,
                                                     burin_text* error);

/* ---- Files ---- */

typedef struct burin_recording burin_recording;

/* A stroke of a recording, ready for burin_session_begin and burin_session_add: drawn so it has the bits that
 * `burin replay` gives it. */
typedef struct burin_recording_stroke {
  uint32_t struct_size;
  uint32_t fields; /* BURIN_PEN_* that the pen reported */
  const char* const*
      settings; /* those that were recorded, as of burin_stroke; brush and radius may be missing */
  uint64_t seed;
  const burin_sample* samples; /* of a recording on a screen the rays through the camera */
  uint64_t sample_count;
  const char* tool; /* "pen", "touch", "mouse" or the like; "" if unknown */
  uint32_t eraser;  /* 1: drawn with the pen's eraser, or an eraser tool; else 0 */
  uint32_t reserved;
} burin_recording_stroke;

/* Reads a recording, docs/stroke_format.md. Fails for one that was cut off. [any thread, concurrent] */
BURIN_API burin_status BURIN_CALL burin_recording_read(const char* path, burin_recording** recording,
                                                       burin_text* error);

/* Frees the recording, which may be null. */
BURIN_API void BURIN_CALL burin_recording_destroy(burin_recording* recording);

/* The number of strokes. */
BURIN_API uint64_t BURIN_CALL burin_recording_stroke_count(const burin_recording* recording);

/* What was drawn with; "" if the file does not say. Lives as long as the recording. */
BURIN_API const char* BURIN_CALL burin_recording_device(const burin_recording* recording);

/* Fills the members that stroke->struct_size covers; what they point to lives as long as the recording.
 * BURIN_NOT_FOUND if there is no such stroke. */
BURIN_API burin_status BURIN_CALL burin_recording_get_stroke(const burin_recording* recording, uint64_t index,
                                                             burin_recording_stroke* stroke,
                                                             burin_text* error);

/* A mesh of triangles that the library has read or refined. */
typedef struct burin_triangles burin_triangles;

/* How a mesh is read and refined. */
typedef struct burin_refinement {
  uint32_t struct_size;
  uint32_t levels; /* of refinement, 0..15: by Loop if all faces are triangles, else Catmull-Clark */
  uint64_t target_triangles; /* instead, if not 0: refine to at least so many */
  double weld; /* of files: edges that lie on each other no farther apart are joined, object units, > 0; 0:
                  what rounding has separated */
} burin_refinement;

/* What a mesh has besides its arrays. */
typedef struct burin_mesh_values {
  uint32_t struct_size;
  uint32_t reserved;
  const float* colours; /* as BURIN_COLOURS, of all vertices; null: none */
  const float* masks;   /* as BURIN_MASKS; null: none */
  double origin[3];     /* is added to all positions, which are floats near it, object units */
  const float* uv; /* since 0.5: texture coordinates, u and v from the lower left corner of the picture, of
                      the three corners of each triangle, 6 numbers; null: none. Only with
                           burin_mesh.face_size 3; OFF has none */
} burin_mesh_values;

/* Reads and refines a mesh as `burin replay` does: OBJ, PLY, STL, OFF, glTF or GLB, which the extension
 * selects (docs/files.md). `options` may be null. Refined meshes have neither colours nor masks. [any thread,
 * concurrent] */
BURIN_API burin_status BURIN_CALL burin_triangles_read(const char* path, const burin_refinement* options,
                                                       burin_triangles** triangles, burin_text* error);

/* Refines a mesh in arrays of the caller's, without creases, whose faces must be a manifold of one
 * orientation; without levels it is cut into triangles. `options` may be null. [any thread, concurrent] */
BURIN_API burin_status BURIN_CALL burin_triangles_refine(const burin_mesh* mesh,
                                                         const burin_refinement* options,
                                                         burin_triangles** triangles, burin_text* error);

/* Frees the mesh, which may be null. */
BURIN_API void BURIN_CALL burin_triangles_destroy(burin_triangles* triangles);

/* Fills the members that the sizes cover: arrays of triangles, for burin_session_create. They belong to the
 * mesh. `values` may be null. */
BURIN_API burin_status BURIN_CALL burin_triangles_get(const burin_triangles* triangles, burin_mesh* mesh,
                                                      burin_mesh_values* values, burin_text* error);

/* Makes a mesh of a solid that a stroke made beside the surface ("solid=separate", which is what brushes of
 * solids do by themselves), closed, where the object has it; in the order of the strokes. BURIN_NOT_FOUND if
 * there is none of this number: undo takes them back. The first solid loads the module burin-solids.so, which
 * stands beside libburin.so or in lib/burin beside its folder, and OpenVDB; fails if these are not there. So
 * does merging. Both use oneTBB, whatever threads are lent. */
BURIN_API burin_status BURIN_CALL burin_session_read_solid(const burin_session* session, uint64_t solid,
                                                           burin_triangles** triangles, burin_text* error);

/* Copies a mesh that a stroke with the setting "along" laid beside the surface, likewise. */
BURIN_API burin_status BURIN_CALL burin_session_read_bent_mesh(const burin_session* session, uint64_t mesh,
                                                               burin_triangles** triangles,
                                                               burin_text* error);

/* Writes a mesh of triangles, wholly or not at all: PLY, GLB, OBJ or OFF, which the extension selects. Larger
 * faces are cut into triangles. `values` may be null. [any thread, concurrent] */
BURIN_API burin_status BURIN_CALL burin_mesh_write(const char* path, const burin_mesh* mesh,
                                                   const burin_mesh_values* values, burin_text* error);

#ifdef __cplusplus
}
#endif
#endif
