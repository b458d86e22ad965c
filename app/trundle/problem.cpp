#include "trundle/problem.h"

#include <cstdio>

#include "base/clean_text.h"

namespace trundle {

QString forTerminal(const QString& text) { return QString::fromStdString(cleanLine(text.toStdString())); }

void printProblem(const QString& text) { std::fprintf(stderr, "trundle: %s\n", qPrintable(forTerminal(text))); }

} // namespace trundle
