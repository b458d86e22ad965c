#pragma once
// Included before everything else in each test: `signals` is a word of this program, not of Qt's language here. A test that includes
// the signal block defines QT_NO_KEYWORDS as well and says Q_SLOTS.
#include <QtCore/qtmetamacros.h>
#undef signals
