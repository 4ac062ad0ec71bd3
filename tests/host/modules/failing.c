/* org.burin.test.failing: goes wrong where and as its parameter `text` says, "evaluate:crash", or at the
 * start, when there is no parameter yet, the environment variable BURIN_TEST_FAULT. Otherwise it is good; it
 * is as high as its state says, which counts strokes. */
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#define APART __attribute__((noinline, noclone))

/* What the host shares with this process. */
enum { host_socket = 3, shared_memory = 4 };

APART static void crash_here(void) {
  int* volatile nowhere = (int*)64;
  *nowhere = 1;
}
APART static void abort_here(void) { abort(); }
APART static void hang_here(void) {
  static volatile int forever = 1;
  while (forever) {
  }
}
APART static void exit_here(void) { exit(3); }
APART static void end_here(void) { _exit(4); }
APART static void kill_here(void) { kill(getpid(), SIGKILL); }
APART static int overflow_here(volatile int depth) {
  volatile char room[4096];
  room[0] = (char)depth;
  return overflow_here(depth + 1) + room[0];
}
APART static void allocate_here(void) {
  for (;;) {
    char* block = malloc(1 << 24);
    block[0] = 1;
    for (size_t i = 0; i < 1 << 24; i += 4096) ((volatile char*)block)[i] = 1;
  }
}
APART static void leak_here(void) {
  static void* volatile kept;
  for (size_t size = 1 << 24; size >= 16; size /= 2) do
      kept = malloc(size);
    while (kept);
}
/* All that is shared becomes bytes that follow from a seed. */
APART static void scribble_here(void) {
  const off_t size = lseek(shared_memory, 0, SEEK_END);
  unsigned char* bytes = mmap(NULL, (size_t)size, PROT_READ | PROT_WRITE, MAP_SHARED, shared_memory, 0);
  unsigned number = 5;
  for (off_t i = 0; i < size; ++i) {
    number = number * 1664525U + 1013904223U;
    bytes[i] = (unsigned char)(number >> 24);
  }
}
/* An answer that claims to be very long, and one that ends too early. */
APART static void lie_here(void) {
  const unsigned long long size = ~0ULL >> 20;
  if (write(host_socket, &size, sizeof size) < 0) abort();
}
APART static void stutter_here(void) {
  const unsigned long long size = 7;
  if (write(host_socket, &size, sizeof size) < 0 || write(host_socket, "abcdefg", 7) < 0) abort();
}
APART static void shrink_here(void) {
  if (ftruncate(shared_memory, 0) == 0) fputs("the shared memory can be taken away\n", stderr);
}

static void go_wrong(const char* fault, const char* place) {
  const size_t length = strlen(place);
  if (!fault || strncmp(fault, place, length) != 0 || fault[length] != ':') return;
  const char* kind = fault + length + 1;
  if (strcmp(kind, "crash") == 0) crash_here();
  if (strcmp(kind, "abort") == 0) abort_here();
  if (strcmp(kind, "hang") == 0) hang_here();
  if (strcmp(kind, "exit") == 0) exit_here();
  if (strcmp(kind, "end") == 0) end_here();
  if (strcmp(kind, "kill") == 0) kill_here();
  if (strcmp(kind, "overflow") == 0) overflow_here(0);
  if (strcmp(kind, "allocate") == 0) allocate_here();
  if (strcmp(kind, "scribble") == 0) scribble_here();
  if (strcmp(kind, "lie") == 0) lie_here();
  if (strcmp(kind, "stutter") == 0) stutter_here();
  if (strcmp(kind, "shrink") == 0) shrink_here();
}

__attribute__((constructor)) static void at_load(void) { go_wrong(getenv("BURIN_TEST_FAULT"), "load"); }

#define ID "org.burin.test.failing"
#define IN_INIT go_wrong(getenv("BURIN_TEST_FAULT"), "init")
#define IN_CREATE go_wrong(getenv("BURIN_TEST_FAULT"), "create")
#define IN_BEGIN                                \
  memset(*stroke, 0, 64);                       \
  strncpy(*stroke, values->values[4].text, 63); \
  go_wrong(*stroke, "begin");                   \
  if (strcmp(*stroke, "begin:passes") == 0) plan->passes = ~0U
#define AT_NODE AT(outputs->up, i) *= (float)((good_brush*)brush->self)->state / 7
#define IN_EVALUATE                                                                                       \
  go_wrong(stroke, "evaluate");                                                                           \
  if (strcmp(stroke, "evaluate:nan") == 0) AT(outputs->up, 0) = NAN;                                      \
  if (strcmp(stroke, "evaluate:leak") == 0) return leak_here(), say(error, "has no memory"), BURIN_ERROR; \
  if (strcmp(stroke, "evaluate:say") == 0) return say(error, "says no\n"), BURIN_ERROR
#define IN_DISTANCE go_wrong(stroke, "distance")
#define AT_POINT go_wrong(stroke, "filter")
#define IN_END             \
  go_wrong(stroke, "end"); \
  ++((good_brush*)brush->self)->state
#include "../../host_stub/validate/bad_plugins/good.h"
