/* Records two strokes as an application in C does: one with all fields, one of a mouse. Prints the texts of
 * refused calls. usage: record_in_c FILE.stroke [kill] */
#include <burin/host/recorder.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;
static char line[200];

static void expect(burin_status expected, burin_status status, const char* call) {
  if (status == expected) return;
  fprintf(stderr, "%s: status %d: %s\n", call, (int)status, line);
  ++failures;
}

int main(int argc, char** argv) {
  burin_text text = {sizeof text, sizeof line, line};
  const burin_recorder_options options = {sizeof options, BURIN_SPACE_OBJECT, argv[1], "Tablet of C", NULL};
  const burin_recorded_stroke all = {
      sizeof all,
      BURIN_PEN_TIME | BURIN_PEN_PRESSURE | BURIN_PEN_TILT | BURIN_PEN_TWIST | BURIN_PEN_BARREL,
      "{\"brush\": \"org.burin.groove\", \"radius\": 0.05, "
      "\"params\": {\"depth\": 0.25}}",
      "pen",
      1,
      0};
  const burin_recorded_stroke mouse = {.struct_size = sizeof mouse,
                                       .settings = "{\"brush\": \"org.burin.bead\", \"radius\": 0.1}"};
  burin_recorded_sample sample = {sizeof sample, 0.5F, 1.25, {1, 2, 3}, 0.1F, -0.2F, 0.3F, 0};
  burin_recorder* recorder = burin_recorder_open(&options, &text);
  if (argc < 2 || !recorder) return 1;

  expect(BURIN_OK, burin_recorder_begin(recorder, &all, &text), "begin");
  expect(BURIN_OK, burin_recorder_add(recorder, &sample, &text), "add");
  sample.time = 1.5;
  sample.barrel = 1;
  expect(BURIN_OK, burin_recorder_add(recorder, &sample, &text), "second add");
  if (argc > 2) raise(SIGKILL);
  sample.time = 1;
  expect(BURIN_INVALID_ARGUMENT, burin_recorder_add(recorder, &sample, &text), "time that falls");
  puts(line);
  expect(BURIN_INVALID_ARGUMENT, burin_recorder_begin(recorder, &mouse, &text), "begin within a stroke");
  puts(line);
  expect(BURIN_OK, burin_recorder_end(recorder, &text), "end");
  expect(BURIN_OK, burin_recorder_begin(recorder, &mouse, NULL), "begin of a mouse");
  expect(BURIN_OK, burin_recorder_add(recorder, &sample, NULL), "add of a mouse");
  expect(BURIN_OK, burin_recorder_end(recorder, NULL), "end of a mouse");
  burin_recorder_close(recorder);
  return failures;
}
