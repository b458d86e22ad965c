// The Save As dialog: adds a missing suffix, and asks before it overwrites a file.

#include <QtTest>
#include <QtWidgets>

#include "editor/widgets/save_question.h"

using namespace trundle;

class SaveQuestionTest : public QObject {
    Q_OBJECT

    /// Performs `act` on the dialog once it is open.
    template <class Act> static QString asked(const QString& start, const Act& act) {
        QTimer::singleShot(0, [&act] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            QVERIFY(dialog);
            act(*dialog);
            if (dialog->isVisible()) dialog->reject();
        });
        return askWhereToSave(nullptr, QStringLiteral("Save As"), start, QStringLiteral("Experiments (*.sim)"),
                              QStringLiteral("sim"));
    }
    static void enter(QFileDialog& dialog, const QString& name) {
        auto* line = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        QVERIFY(line);
        line->setFocus();
        line->selectAll();
        QTest::keyClicks(line, name);
        QTest::keyClick(line, Qt::Key_Return);
    }

private Q_SLOTS:
    void init() {
        QVERIFY(m_folder.isValid());
        QFile there(path("mine.sim"));
        QVERIFY(there.open(QIODevice::WriteOnly));
    }

    void itStartsWithTheNameGiven() {
        QString name;
        QCOMPARE(asked(path("fresh.sim"), [&](QFileDialog& dialog) { name = dialog.selectedFiles().value(0); }), QString());
        QCOMPARE(name, path("fresh.sim"));
    }

    void cleansForeignName() {
        QString name;
        QCOMPARE(
            asked(path("evil\x1b[2J\n\xe2\x80\xae.sim"), [&](QFileDialog& dialog) { name = dialog.selectedFiles().value(0); }),
            QString());
        QCOMPARE(name, path("evil_[2J _.sim"));
    }

    void aNameWithoutAnEndingGetsOne() {
        QCOMPARE(asked(path("a.sim"), [](QFileDialog& dialog) { enter(dialog, QStringLiteral("other")); }), path("other.sim"));
        QCOMPARE(asked(path("a.sim"), [](QFileDialog& dialog) { enter(dialog, QStringLiteral("other.txt")); }),
                 path("other.txt"));
    }

    void asksBeforeOverwriting() {
        bool wasAsked = false;
        const QString chosen = asked(path("a.sim"), [&](QFileDialog& dialog) {
            QTimer::singleShot(0, [&] {
                auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
                wasAsked = question != nullptr;
                if (question) QTest::mouseClick(question->button(QMessageBox::No), Qt::LeftButton);
            });
            enter(dialog, QStringLiteral("mine")); // becomes mine.sim
        });
        QVERIFY(wasAsked);
        QCOMPARE(chosen, QString());
    }

private:
    QString path(const char* name) const { return m_folder.filePath(QString::fromUtf8(name)); }

    QTemporaryDir m_folder;
};

QTEST_MAIN(SaveQuestionTest)
#include "save_question_test.moc"
