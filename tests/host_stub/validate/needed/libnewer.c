/* A library with a symbol of a version of glibc that there is not. */
__attribute__((visibility("default"))) int burin_test_newer(void);
int burin_test_newer(void) { return 1; }
