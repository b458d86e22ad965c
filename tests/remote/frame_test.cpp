// Frames of the remote control: cut from a stream, with limits.
#include <QtTest>

#include "remote/arguments.h"
#include "remote/frame.h"

using namespace trundle;

class FrameTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void areTheSameHoweverTheyArrive() {
        std::string stream;
        appendFrame(stream, R"({"op":"status"})");
        appendFrame(stream, "", std::string("\0\1\2", 3));
        appendFrame(stream, "{}", "x");
        for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
            FrameReader reader({100, 100});
            std::vector<Frame> frames;
            for (const std::string& part : {stream.substr(0, cut), stream.substr(cut)}) {
                reader.add(part);
                while (reader.hasNext()) frames.push_back(*reader.next().value());
            }
            QCOMPARE(frames.size(), std::size_t(3));
            QCOMPARE(frames[0].json, std::string(R"({"op":"status"})"));
            QCOMPARE(frames[1].bytes, std::string("\0\1\2", 3));
            QCOMPARE(frames[2].json + frames[2].bytes, std::string("{}x"));
            QCOMPARE(reader.waiting(), std::size_t(0));
            QVERIFY(!reader.next().value().has_value());
        }
    }

    void haveLimits() {
        for (const auto& [json, bytes, fits] : {std::tuple(10, 5, true), std::tuple(11, 0, false), std::tuple(0, 6, false)}) {
            std::string stream;
            appendFrame(stream, std::string(json, ' '), std::string(bytes, ' '));
            FrameReader reader({10, 5});
            reader.add(std::span(stream).first(8)); // refused before the rest is there
            QCOMPARE(reader.hasNext(), !fits);
            QCOMPARE(reader.next().ok(), fits);
            reader.add(std::span(stream).subspan(8));
            const auto frame = reader.next();
            QCOMPARE(frame.ok(), fits);
            if (!fits) QVERIFY(frame.error().message.find("at most 10 and 5") != std::string::npos);
        }
        FrameReader reader({4096, 0});
        reader.add(std::string_view("GET / HTTP/1.1\r\n"));
        QVERIFY(!reader.next().ok());
    }

    void argumentsAreChecked_data() {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<QByteArray>("problem");
        QTest::newRow("good") << QByteArray(R"({"op":"x","id":1,"n":2,"t":"a","f":true,"v":[1,2],"o":{"b":1,"a":false}})") << QByteArray();
        QTest::newRow("missing") << QByteArray(R"({"t":"a","f":true,"v":[1,2]})") << QByteArray("n is missing");
        QTest::newRow("negative") << QByteArray(R"({"n":-1,"t":"a","v":[1,2]})") << QByteArray("n must be a whole number from 0 to 9");
        QTest::newRow("fraction") << QByteArray(R"({"n":1.5,"t":"a","v":[1,2]})") << QByteArray("n must be a whole number from 0 to 9");
        QTest::newRow("large") << QByteArray(R"({"n":10,"t":"a","v":[1,2]})") << QByteArray("n must be a whole number from 0 to 9");
        QTest::newRow("text") << QByteArray(R"({"n":1,"t":3,"v":[1,2]})") << QByteArray("t must be a text");
        QTest::newRow("numbers") << QByteArray(R"({"n":1,"t":"","v":[1]})") << QByteArray("v must be an array of 2 finite numbers");
        QTest::newRow("overflow") << QByteArray(R"({"n":1,"t":"","v":[1,1e308],"o":{"a":[]}})") << QByteArray("the value of a must be a finite number, or an array of them");
        QTest::newRow("unknown") << QByteArray(R"({"n":1,"tt":"","t":"","v":[1,2]})") << QByteArray("unknown member tt; did you mean t?");
    }
    void argumentsAreChecked() {
        QFETCH(QByteArray, json);
        QFETCH(QByteArray, problem);
        const nlohmann::json request = nlohmann::json::parse(json.toStdString());
        Arguments arguments(request);
        const std::uint64_t n = arguments.count("n", 9);
        const std::string t = arguments.text("t");
        const bool f = arguments.flag("f", false);
        const std::vector<double> v = arguments.numbers("v", 2);
        const auto o = arguments.values("o");
        QCOMPARE(QByteArray::fromStdString(arguments.problem()), problem);
        QCOMPARE(v.size(), std::size_t(2));
        if (!problem.isEmpty()) return;
        QCOMPARE(std::tuple(n, t, f, v), std::tuple(2, std::string("a"), true, std::vector<double>{1, 2}));
        using Numbers = std::vector<double>;
        QCOMPARE(o, (std::vector<std::pair<std::string, Numbers>>{{"a", {0}}, {"b", {1}}}));
    }
};

QTEST_APPLESS_MAIN(FrameTest)
#include "frame_test.moc"
