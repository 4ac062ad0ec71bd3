/* Refuses to be in a process twice. */
#include <string.h>
#include <sys/prctl.h>
#define IN_INIT                                                       \
  if (users == 1) {                                                   \
    char name[16] = "";                                               \
    prctl(PR_GET_NAME, name);                                         \
    if (strcmp(name, "good-brush") == 0) return --users, BURIN_ERROR; \
    prctl(PR_SET_NAME, "good-brush");                                 \
  }
#define IN_DEINIT prctl(PR_SET_NAME, "burin")
#include "../good.h"
