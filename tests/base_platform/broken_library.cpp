extern "C" int undefinedSymbol();
extern "C" int brokenAnswer() { return undefinedSymbol(); }
