/* A shared module that is no plugin. */
int burin_no_symbol(void);
int burin_no_symbol(void) { return 0; }
