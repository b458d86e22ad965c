extern "C" __attribute__((visibility("default"))) int trundleTestBeside() { return 42; }
