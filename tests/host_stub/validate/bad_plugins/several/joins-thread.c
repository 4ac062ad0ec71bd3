/* Keeps to the ABI, with a thread that the last deinit joins. */
#include <pthread.h>
#include <semaphore.h>
#include <stddef.h>
static pthread_t worker;
static sem_t done;
static void* work(void* nothing) {
  sem_wait(&done);
  return nothing;
}
static void start(void) {
  sem_init(&done, 0, 0);
  pthread_create(&worker, NULL, work, NULL);
}
static void stop(void) {
  sem_post(&done);
  pthread_join(worker, NULL);
}
#define IN_INIT \
  if (users == 1) start()
#define IN_DEINIT stop()
#include "../good.h"
