// CSV output of logs.
#include <cmath>

#include <QtTest>

#include "run/logs/csv.h"

using namespace trundle;

class CsvTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void rowsEndInLfAndCellsAreQuotedWhereTheyMustBe() {
        std::string csv;
        CsvWriter out(csv);
        out.cell("plain").cell("a,b").cell("say \"hi\"").cell("two\nlines").cell("").endRow();
        out.cell("next").endRow();
        QCOMPARE(csv, std::string("plain,\"a,b\",\"say \"\"hi\"\"\",\"two\nlines\",\nnext\n"));
    }
    void numbersAreTheShortestThatReadBack() {
        std::string csv;
        CsvWriter(csv).cell(0.1).cell(12.0).cell(-0.0).cell(1.0 / 3).cell(1e-7).cell(-std::nan("")).endRow();
        QCOMPARE(csv, std::string("0.1,12,0,0.3333333333333333,1e-07,nan\n"));
    }
};

QTEST_APPLESS_MAIN(CsvTest)
#include "csv_test.moc"
