/* A library with a name as that of one that keeps threads. */
__attribute__((visibility("default"))) int burin_test_threads(void);
int burin_test_threads(void) { return 1; }
