/* burin/host/recorder.h - records what a user draws as a `.stroke` file (docs/stroke_format.md), from C11.
 *
 *   burin_recorder* recorder = burin_recorder_open(&options, &error);
 *   burin_recorder_begin(recorder, &stroke, &error);
 *   burin_recorder_add(recorder, &sample, &error);  // for every sample of the pen
 *   burin_recorder_end(recorder, &error);
 *   burin_recorder_close(recorder);
 *
 * The rules of burin/abi/base.h hold: sized structs, a status and a text for each call. Every call passes its
 * line to the operating system before it returns, in a few microseconds: a process that is killed loses at
 * most the line that it is writing. A recorder belongs to one thread. C++ has StrokeRecorder, which tells how
 * a replay comes to the same result.
 */
#ifndef BURIN_HOST_RECORDER_H
#define BURIN_HOST_RECORDER_H

#include <burin/abi/base.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A function that libburin.so has (burin/host/c/burin.h). */
#if defined(__GNUC__) && !defined(_WIN32)
#define BURIN_API __attribute__((visibility("default")))
#else
#define BURIN_API
#endif

typedef int32_t burin_stroke_space;
enum {
  BURIN_SPACE_UNKNOWN = 0,
  BURIN_SPACE_OBJECT = 1, /* positions near the surface, object units */
  BURIN_SPACE_SCREEN = 2  /* pixels from the top left corner of the camera's viewport; z is not used */
};

/* What a pen reports beside its position. */
enum {
  BURIN_PEN_TIME = 1,
  BURIN_PEN_PRESSURE = 2,
  BURIN_PEN_TILT = 4,
  BURIN_PEN_TWIST = 8,
  BURIN_PEN_BARREL =
      16 /* whether a button at its side is held, which recordings keep and strokes do not use */
};

typedef struct burin_recorder burin_recorder;

/* FROZEN. Matrices stored by columns, with OpenGL's conventions: clip = projection * view * position. */
typedef struct burin_recorder_camera {
  double view[16], projection[16];
  int32_t width, height; /* viewport, pixels */
} burin_recorder_camera;

/* What a recorder writes, and where. */
typedef struct burin_recorder_options {
  uint32_t struct_size;
  burin_stroke_space space;
  const char* path;                    /* UTF-8; the file is created or replaced */
  const char* device;                  /* name of the tablet or the like, UTF-8; may be null */
  const burin_recorder_camera* camera; /* may be null in object space */
} burin_recorder_options;

/* What holds for a whole stroke. */
typedef struct burin_recorded_stroke {
  uint32_t struct_size;
  uint32_t fields;      /* BURIN_PEN_* that the pen reports */
  const char* settings; /* a JSON object of the settings of "begin" in docs/stroke_format.md, among them brush
                           and radius: {"brush": "org.burin.groove", "radius": 0.05} */
  const char* tool;     /* "pen", "touch", "mouse" or the like, UTF-8; may be null: unknown */
  uint32_t eraser;      /* 1: drawn with the pen's eraser, or an eraser tool; 0: not */
  uint32_t reserved;
} burin_recorded_stroke;

/* What the pen does not report is not read. */
typedef struct burin_recorded_sample {
  uint32_t struct_size;
  float pressure;       /* 0..1 */
  double time;          /* seconds; must not fall within a stroke */
  double position[3];   /* of the space */
  float tilt_x, tilt_y; /* radians from upright, towards +x and +y */
  float twist;          /* radians */
  uint32_t barrel;      /* 1: a button at the pen's side is held; 0: none is */
} burin_recorded_sample;

/* Creates a recording. Returns null and writes a text on failure. */
BURIN_API burin_recorder* BURIN_CALL burin_recorder_open(const burin_recorder_options* options,
                                                         burin_text* error);

/* Begins a stroke. BURIN_INVALID_ARGUMENT, and nothing is written, within a stroke and for settings that the
 * format would refuse. */
BURIN_API burin_status BURIN_CALL burin_recorder_begin(burin_recorder* recorder,
                                                       const burin_recorded_stroke* stroke,
                                                       burin_text* error);

/* Adds a sample of the open stroke, whether or not it hits the surface. BURIN_INVALID_ARGUMENT, and nothing
 * is written, outside a stroke, for values that are not finite or out of range, and for time that falls. */
BURIN_API burin_status BURIN_CALL burin_recorder_add(burin_recorder* recorder,
                                                     const burin_recorded_sample* sample, burin_text* error);

/* Ends the open stroke. */
BURIN_API burin_status BURIN_CALL burin_recorder_end(burin_recorder* recorder, burin_text* error);

/* Closes the file and frees the recorder, which may be null. A stroke that is open stays without an end, as
 * after a crash; it is read nevertheless. */
BURIN_API void BURIN_CALL burin_recorder_close(burin_recorder* recorder);

#ifdef __cplusplus
}
#endif
#endif
