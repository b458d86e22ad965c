// The shipped texts in configs/: printed byte for byte, loaded without diagnostics, well formatted, and run.
#include "flow/cli.h"

namespace {

QList<double> numbersIn(const QByteArray& line) {
    QList<double> numbers;
    static const QRegularExpression number("-?[0-9][0-9.]*(e[-+]?[0-9]+)?");
    for (auto at = number.globalMatch(line); at.hasNext();) numbers << at.next().captured().toDouble();
    return numbers;
}

} // namespace

class ConfigsTest : public QObject {
    Q_OBJECT

    static void rows() {
        QTest::addColumn<QString>("path");
        for (const QString& path : allConfigs())
            QTest::newRow(qPrintable(QDir(TRUNDLE_SOURCE_DIR "/configs").relativeFilePath(path))) << path;
    }

private Q_SLOTS:
    void printsBackByteForByte_data() { rows(); }
    void printsBackByteForByte() {
        QFETCH(QString, path);
        const Outcome print = cli({"print", path});
        QCOMPARE(print.code, 0);
        QCOMPARE(print.out, contentOf(path));
    }
    void loadsAloneWithoutDiagnostics_data() { rows(); }
    void loadsAloneWithoutDiagnostics() {
        QFETCH(QString, path);
        const Outcome check = cli({"check", path, "--json"});
        QVERIFY2(check.code == 0, shown(check));
        QCOMPARE(QJsonDocument::fromJson(check.out).array(), QJsonArray());
        QCOMPARE(check.err, QByteArray());
    }
    void isInTheHouseStyle_data() { rows(); }
    void isInTheHouseStyle() {
        QFETCH(QString, path);
        const Outcome format = cli({"format", path, "--check"});
        QVERIFY2(format.code == 0, shown(format));
    }
    void everyExperimentRuns_data() {
        QTest::addColumn<QString>("path");
        for (const QString& path : allConfigs())
            if (contentOf(path).contains("#loadModule")) QTest::newRow(qPrintable(QFileInfo(path).fileName())) << path;
    }
    void everyExperimentRuns() {
        QFETCH(QString, path);
        QTemporaryDir logs;
        const Outcome run = cli({"run", path, "--duration", "1", "--log-dir", logs.path()});
        QVERIFY2(run.code == 0, shown(run));
        QVERIFY2(run.out.contains("x real time"), shown(run));
    }
    void checkReportsErrorsAsJson() {
        QTemporaryDir folder;
        const QString path = folder.filePath("wrong.sim");
        QVERIFY(writeFile(path, "Surface rubber { Frictoin=0.8 }\n"));
        const Outcome check = cli({"check", path, "--json"});
        QCOMPARE(check.code, 1);
        const QJsonObject entry = QJsonDocument::fromJson(check.out).array().first().toObject();
        QStringList keys = entry.keys();
        keys.sort();
        QCOMPARE(keys, (QStringList{"code", "column", "end_column", "end_line", "file", "fixes", "line", "message", "severity",
                                    "suggestions"}));
        QCOMPARE(entry["line"].toInt(), 1);
        QCOMPARE(entry["column"].toInt(), 18);
        QCOMPARE(entry["end_line"].toInt(), 1);
        QCOMPARE(entry["end_column"].toInt(), 26); // exclusive
        QCOMPARE(entry["code"].toString(), QString("E201"));
        QCOMPARE(entry["suggestions"].toArray().first().toString(), QString("Friction"));
    }
    void manualListsBuiltInAndModuleKinds() {
        for (const char* kind : {"RotaryMotor", "PoseLog", "Body", "LinearMotion"}) {
            const Outcome page = cli({"describe", kind});
            QVERIFY2(page.code == 0, shown(page));
            QVERIFY2(page.out.startsWith(kind), shown(page));
            QVERIFY(QJsonDocument::fromJson(cli({"describe", kind, "--json"}).out).object()["properties"].isArray());
            QVERIFY(cli({"describe"}).out.contains(kind));
        }
    }

    /// The page of each built-in kind has all that its JSON says of a property: unit, limits, need, choices, and whether it is live.
    void pagesOfTheManualAreWhole() {
        const QJsonArray kinds = QJsonDocument::fromJson(cli({"describe", "--json"}).out).array();
        QVERIFY(kinds.size() > 30);
        int limits = 0, whole = 0;
        for (const char* name : {"RotaryMotor", "Encoder", "Transceiver", "Camera", "TouchSensor", "Body", "Cylinder", "Hinge",
                                 "Grid", "Scatter", "Surface", "PoseLog", "Light"}) {
            const auto kind = std::ranges::find_if(kinds, [&](const QJsonValue& k) { return k["name"] == QString(name); });
            QVERIFY2(kind != kinds.end(), name);
            const Outcome page = cli({"describe", name});
            QVERIFY2(page.out.contains(QJsonValue(*kind)["help"].toString().toUtf8()), shown(page));
            for (const QJsonValue& property : QJsonValue(*kind)["properties"].toArray()) {
                const QByteArray start = "\n  " + property["name"].toString().toUtf8() + " ";
                const qsizetype at = page.out.indexOf(start);
                QVERIFY2(at > 0, start + page.out);
                const QByteArray line = page.out.mid(at + 1, page.out.indexOf('\n', at + 1) - at - 1);
                QCOMPARE(line.contains(", required"), property["required"].toBool());
                QCOMPARE(line.contains(", may change during a run"), property["live"].toBool());
                const QByteArray unit = property["unit"].toString().toUtf8();
                QVERIFY2(unit.isEmpty() || line.contains(" in " + unit), line);
                for (const QJsonValue& choice : property["choices"].toArray())
                    QVERIFY2(line.contains(choice.toString().toUtf8()), line);
                for (const char* limit : {"minimum", "maximum"}) {
                    if (property[limit].isNull()) continue;
                    QVERIFY2(numbersIn(line).contains(property[limit].toDouble()), line);
                    ++limits;
                    whole += property["type"] == QString("integer");
                }
                QVERIFY2(page.out.mid(at).contains(property["help"].toString().left(40).toUtf8()), line);
            }
        }
        QVERIFY(limits > 50 && whole > 5);
    }
};

QTEST_GUILESS_MAIN(ConfigsTest)
#include "configs_test.moc"
