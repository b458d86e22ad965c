#pragma once
// Includes QScintilla's headers, which need Qt's keyword macros; Trundle is compiled without them.

#include <QtCore/qobjectdefs.h>

#define signals Q_SIGNALS
#define slots Q_SLOTS
#include <Qsci/qscicommandset.h>
#include <Qsci/qsciscintilla.h>
#undef signals
#undef slots
