/* c_host MESH.obj PEN.stroke KEY=VALUE...: draws the first stroke of a recording with these settings, as an
 * application in C with a pen and a renderer does, undoes it and makes it again, and prints the hash that
 * `burin replay --refine off` prints:
 *   c_host ewer.obj meander.stroke brush=org.burin.groove radius=0.18 */
#include <burin/host/c/burin.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char message[512];
static burin_text error = {sizeof error, sizeof message, message};

/* Ends the program if a call failed. */
static void check(burin_status status) {
  if (status == BURIN_OK) return;
  fprintf(stderr, "c_host: %s\n", message);
  exit(2);
}

static void* grow(void* array, size_t count, size_t size) {
  /* Twice as large whenever the count is a power of two. */
  if ((count & (count - 1)) == 0) array = realloc(array, (count ? 2 * count : 1) * size);
  if (!array) abort();
  return array;
}

/* The mesh of an OBJ file: polygons of any size. */
struct model {
  double* positions;
  uint32_t *corners, *face_sizes;
  size_t vertex_count, corner_count, face_count;
};

static void read_face(char* words, struct model* model) {
  uint32_t size = 0;
  for (char* word = strtok(words, " \t\r\n"); word; word = strtok(NULL, " \t\r\n"), ++size) {
    const long number = strtol(word, NULL, 10); /* ends at the '/' before other indices */
    model->corners = grow(model->corners, model->corner_count, sizeof *model->corners);
    model->corners[model->corner_count++] =
        (uint32_t)(number < 0 ? (long)model->vertex_count + number : number - 1);
  }
  model->face_sizes = grow(model->face_sizes, model->face_count, sizeof *model->face_sizes);
  model->face_sizes[model->face_count++] = size;
}

static struct model read_obj(const char* path) {
  struct model model = {0};
  char line[4096];
  FILE* file = fopen(path, "r");
  if (!file) perror(path), exit(2);
  while (fgets(line, sizeof line, file)) {
    if (strncmp(line, "v ", 2) == 0) {
      double p[3] = {0};
      sscanf(line + 2, "%lf %lf %lf", &p[0], &p[1], &p[2]);
      model.positions = grow(model.positions, model.vertex_count, sizeof p);
      memcpy(model.positions + 3 * model.vertex_count++, p, sizeof p);
    } else if (strncmp(line, "f ", 2) == 0) {
      read_face(line + 2, &model);
    }
  }
  fclose(file);
  return model;
}

/* What a renderer has on the GPU: here an array, to which ranges are copied. */
struct buffer {
  float* data;
  size_t uploads, bytes;
};

static void upload(burin_session* session, struct buffer* buffer) {
  burin_range ranges[32];
  uint64_t count = 0;
  check(burin_session_update(session, BURIN_POSITIONS, 256, ranges, 32, &count, &error));
  const float* values = burin_session_values(session, BURIN_POSITIONS);
  for (uint64_t i = 0; i < count; ++i) {
    const size_t bytes = (size_t)(ranges[i].end - ranges[i].begin) * 3 * sizeof(float);
    memcpy(buffer->data + 3 * ranges[i].begin, values + 3 * ranges[i].begin, bytes);
    buffer->uploads++;
    buffer->bytes += bytes;
  }
}

/* Draws the lines [time, x, y, z, pressure, tilt_x, tilt_y] of a recording, up to the end of its first
 * stroke. */
static void draw(burin_session* session, const char* path, const char* const* settings,
                 struct buffer* buffer) {
  const burin_stroke stroke = {.struct_size = sizeof stroke,
                               .fields = BURIN_PEN_TIME | BURIN_PEN_PRESSURE | BURIN_PEN_TILT,
                               .settings = settings};
  char line[4096];
  FILE* file = fopen(path, "r");
  if (!file) perror(path), exit(2);
  check(burin_session_begin(session, &stroke, &error));
  while (fgets(line, sizeof line, file) && strncmp(line, "{\"end\"", 6) != 0) {
    burin_sample sample = {.struct_size = sizeof sample};
    if (sscanf(line, "[%lf,%lf,%lf,%lf,%f,%f,%f", &sample.time, &sample.position[0], &sample.position[1],
               &sample.position[2], &sample.pressure, &sample.tilt_x, &sample.tilt_y) != 7)
      continue;
    check(burin_session_add(session, &sample, 1, NULL, &error));
    upload(session, buffer);
  }
  fclose(file);
  check(burin_session_end(session, &error));
  upload(session, buffer);
}

int main(int argc, char** argv) {
  if (argc < 4) return fprintf(stderr, "usage: c_host MESH.obj PEN.stroke KEY=VALUE...\n"), 2;
  burin_library* library = NULL;
  check(burin_library_create(NULL, &library, &error));
  check(burin_library_load(library, NULL, &error));
  for (uint64_t i = 0; i < burin_library_refused_count(library); ++i)
    fprintf(stderr, "c_host: %s\n", burin_library_refused(library, i));

  struct model model = read_obj(argv[1]);
  const burin_mesh mesh = {.struct_size = sizeof mesh,
                           .position_type = BURIN_FLOAT64,
                           .positions = model.positions,
                           .vertex_count = model.vertex_count,
                           .corners = model.corners,
                           .face_count = model.face_count,
                           .corner_type = BURIN_UINT32,
                           .face_sizes = model.face_sizes};
  burin_session* session = NULL;
  check(burin_session_create(library, &mesh, &session, &error));
  struct buffer buffer = {.data = calloc(model.vertex_count, 3 * sizeof(float))};
  upload(session, &buffer); /* the first time all of it */

  draw(session, argv[2], (const char* const*)argv + 3, &buffer);
  check(burin_session_undo(session, &error));
  upload(session, &buffer);
  check(burin_session_redo(session, &error));
  upload(session, &buffer);

  uint64_t hash = 0;
  check(burin_session_hash(session, &hash, &error));
  const float* values = burin_session_values(session, BURIN_POSITIONS);
  const int same = memcmp(buffer.data, values, model.vertex_count * 3 * sizeof(float)) == 0;
  fprintf(stderr, "%zu uploads of %zu bytes in all\n", buffer.uploads, buffer.bytes);
  printf("%016llx\n", (unsigned long long)hash);
  burin_session_destroy(session);
  burin_library_destroy(library);
  free(buffer.data), free(model.positions), free(model.corners), free(model.face_sizes);
  return same ? 0 : 1;
}
