extern "C" __attribute__((visibility("default"))) int trundle_modules(void) { return 1; }
