extern "C" int nobodyDefinesThis();
extern "C" int brokenAnswer() { return nobodyDefinesThis(); }
