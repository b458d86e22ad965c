#include "house/words.h"

namespace trundle {
namespace {

WordRule word(const char* words, const char* instead, WordScope scope = WordScope::Everywhere) {
    return {wordPattern(words), instead, scope};
}
WordRule name(const char* pattern, const char* instead) { return {QRegularExpression(pattern), instead, WordScope::Everywhere}; }

/// The parts of one file. Line breaks are kept, so that a position has the same line number in each.
struct Parts {
    QString code;  ///< without comments
    QString texts; ///< string literals only
};

void blank(QString& text, qsizetype begin, qsizetype end) {
    for (qsizetype i = begin; i < end; ++i)
        if (text[i] != '\n') text[i] = ' ';
}

Parts partsOf(const QString& text) {
    static const QRegularExpression token(
        R"re(//[^\n]*|/\*.*?\*/|(R"([^()\\\s]{0,16})\(.*?\)\2"|"(?:\\.|[^"\\\n])*")|(?<!\w)'(?:\\.|[^'\\\n])+')re",
        QRegularExpression::DotMatchesEverythingOption);
    Parts parts{text, text};
    qsizetype last = 0;
    for (auto match = token.globalMatch(text); match.hasNext();) {
        const auto found = match.next();
        if (found.captured().startsWith('/')) blank(parts.code, found.capturedStart(), found.capturedEnd());
        blank(parts.texts, last, found.hasCaptured(1) ? found.capturedStart(1) : found.capturedEnd());
        last = found.capturedEnd();
    }
    blank(parts.texts, last, text.size());
    return parts;
}

/// Allowed uses, each with its reason. Keep this short.
bool isAllowed(const QString& path, const QString& found) {
    // A column of the radio log: users' programs read its name.
    if (found == "fate")
        return path == "core/run/logs/radio_rows.cpp" || path == "tests/flow/radio_logs_test.cpp" ||
               path == "resources/guide/radios.md";
    // A function of Assimp's IOStream.
    if (found == "Tell") return path == "app/meshreader/restricted_io_system.cpp";
    return false;
}

} // namespace

QRegularExpression wordPattern(const QString& words) {
    QString start, camel;
    for (const QString& each : words.split(' ')) {
        const QString any = QString("[%1%2]").arg(each[0].toLower()).arg(each[0].toUpper()) + each.mid(1);
        camel += camel.isEmpty() ? each[0].toUpper() + each.mid(1) : "[ _-]?" + any;
        start += start.isEmpty() ? any : "[ _-]?" + any;
    }
    return QRegularExpression("(?:(?<![A-Za-z])(?:" + start + ")|(?<=[a-z0-9])(?:" + camel + "))(?![a-z])");
}

const QList<WordRule>& wordRules() {
    using enum WordScope;
    static const QList<WordRule> rules = {
        // --- whole words, in names, texts and comments ---
        word("reckon(?:s|ed|ing|er|ers)?", "compute, worker"),
        word("mend(?:s|ed|ing)?", "fix"),
        word("fates?", "outcome, result"),
        word("deeds?", "action"),
        word("forgiv(?:e|es|en|ing)", "clear the error, ignore"),
        word("wish(?:es|ed)?", "options of an operation, request of a query"),
        word("be had", "is available"),
        word("came back", "returned"),
        word("coming back", "returning"),
        word("tend(?:s|ed)?", "update"),
        word("tells?", "report, show, print"),
        word("told", "informed, reported"),
        word("telling", "reporting"),
        word("judg(?:e|es|ed|ing)", "check, validate"),
        word("doorbell", "notifier"),
        word("studio", "render thread state"),
        word("desks?", "camera capture; of a test: fixture"),
        word("speck", "point impostor"),
        word("deafen", "abort the reception"),
        word("looker", "provider, parser"),
        word("teller", "hover provider, reporter"),
        word("lister", "index"),
        word("finder", "search"),
        word("taker", "what it is, such as screenshot runner"),
        word("outlet", "outputs"),
        word("fed process", "piped process"),
        word("unkept", "omitted"),
        word("culprit", "crash site"),
        word("shelf", "cache"),
        word("rubbish", "invalid data"),
        word("dice", "random numbers"),
        word("chauffeur", "driver"),
        word("shove", "push"),
        word("verdict", "access, result"),
        word("throw away", "discard"),
        word("only look", "open read-only"),
        word("capitals count", "match case"),
        word("wrong mark", "bad magic number"),
        word("fits no rule", "syntax error"),
        word("nothing carries", "unknown reference"),
        // --- names of types and functions ---
        word("joined parts", "TrundleApplication"),
        word("edit sheet", "EditBuilder"),
        word("fenced files", "RestrictedIOSystem"),
        word("shown world", "ViewportScene"),
        word("held objects", "TransformSelection"),
        word("mouse work", "ViewTool"),
        word("gizmo work", "GizmoTool"),
        word("select work", "SelectTool"),
        word("push work", "PushTool"),
        word("measure work", "MeasureTool"),
        name("\\bPlaced(?:Text|Assignment|Block|Param)\\b", "MovedBlock, SourceAssignment, SourceBlock, SourceParam"),
        name("\\b[kK]ept(?:Poses|Meshes|Mesh|Picture|HeightMap)\\b", "StartPoses, CachedMeshes, cachedMesh"),
        name("\\b(?:FrameSource|MeshLook|ViewStands?|SameRobots|MotorRow)\\b",
             "ImageSource, MeshAppearance, ViewState, RobotMatch, MotorConstraint"),
        name("\\b(?:mayEdit|mayWrite|mayBecome)\\b", "checkEditable, checkWritable, checkSaveTarget"),
        name("\\b(?:\\w+Plates?|PlateText|plateAt)\\b", "label"),
        word("world pen", "ScenePainter"),
        word("frame drawer", "CameraImageRenderer"),
        word("radio tap", "RadioTraceQueue"),
        word("look collector", "AppearanceCollector"),
        word("journal keeper", "JournalWriter"),
        word("window memory", "SavedWindowState"),
        word("users of", "dependentsOf"),
        word("look at disk", "checkExternalChanges"),
        word("note disk", "ExternalChanges::apply"),
        word("last good", "lastValid"),
        name("\\bsay[A-Z]\\w*\\(", "report..., add..., notify..."),
        name("\\bsaid[A-Z(]", "reported..., description()"),
        name("\\b(?:m_)?heldUp|HeldUp", "notRespondingText, unresponsiveController"),
        name("\\bstandIn[A-Z]\\w*", "missing asset, placeholder"),
        // --- names and texts ---
        word("comes? back", "return, restore; of a controller: respond", Code),
        word("bring(?:s)? back", "restore", Code),
        word("held up", "not responding", Code),
        word("mentions?", "reference", Code),
        word("complaints?", "warning", Code),
        word("carry out", "apply", Code),
        word("let go", "release", Code),
        word("withdrawn?", "discard", Code),
        word("patience", "timeout", Code),
        word("did not end well", "closed unexpectedly", Code),
        word("take away from here", "hide", Code),
        word("the one before", "previous", Code),
        // --- texts that a user reads ---
        word("stands?", "is, is located, is allowed, is written", Texts),
        word("nobody", "no radio, no one; say who", Texts),
        word("somebody", "another user, another program; say who", Texts),
        word("whoever", "regardless of who", Texts),
        word("knows", "has, contains", Texts),
        word("wants", "needs, requests", Texts),
        word("go(?:es)? on", "continue, resume", Texts),
        word("anew", "again", Texts),
        word("without a word", "without a message", Texts),
        word("leads? nowhere", "is unknown", Texts),
        word("forgot(?:ten)?", "missing, discarded", Texts),
    };
    return rules;
}

QList<WordHit> forbiddenWords(const SourceFile& file) {
    const bool guide = file.path.endsWith(".md");
    const bool read = guide || !file.path.startsWith("tests/");
    const Parts parts = guide ? Parts{file.text, file.text} : partsOf(file.text);
    QList<WordHit> hits;
    for (const WordRule& rule : wordRules()) {
        if (rule.scope == WordScope::Texts && !read) continue;
        const QString& text = rule.scope == WordScope::Everywhere ? file.text
                              : rule.scope == WordScope::Code     ? parts.code
                                                                  : parts.texts;
        for (auto match = rule.pattern.globalMatch(text); match.hasNext();) {
            const auto hit = match.next();
            if (isAllowed(file.path, hit.captured())) continue;
            hits.append({file.path, int(text.left(hit.capturedStart()).count('\n')) + 1, hit.captured(), rule.instead});
        }
    }
    return hits;
}

} // namespace trundle
