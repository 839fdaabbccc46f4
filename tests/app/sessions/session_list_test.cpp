// Tests the rows of the browser of recordings: their texts, their order and the search.
#include "app/sessions/session_list.h"

#include <gtest/gtest.h>

#include "tests/support/estimates.h"

namespace terratact {
namespace {

ListedSession drive(const char* path, std::int64_t hours, SessionVerdicts verdicts)
{
    ListedSession listed{.path = path, .bytes = hours * 1'500'000};
    SessionSummary summary;
    summary.wallTime = (1'793'000'000 + hours * 3600) * 1'000'000'000;
    summary.end = hours * 61'000'000'000;
    summary.robot = "Absolem";
    summary.source = "can0";
    summary.probes = hours;
    summary.marks = 1;
    summary.notes = {"at the <b>door</b>\n" + std::to_string(hours)};
    summary.verdicts = verdicts;
    listed.summary = std::move(summary);
    return listed;
}

struct SessionRows : testing::Test {
    SessionRows()
    {
        ListedSession broken{.path = "/x/broken.tts", .bytes = 12, .written = 1};
        broken.trouble = Message::verbatim("is not an SQLite file");
        ListedSession running{.path = "/x/now.tts", .isRecorded = true};
        list.add({drive("/x/a.tts", 1, {.clear = 2}), broken});
        list.add({drive("/x/b.tts", 3, {.blocked = 1, .cannotTell = 4}),
                  drive("/x/c.tts", 2, {.clear = 1, .notRead = 5}), running});
    }
    QStringList shown(int column = SessionList::Begins) const
    {
        QStringList texts;
        for (int row = 0; row < searched.rowCount(); ++row)
            texts << searched.index(row, column).data().toString();
        return texts;
    }
    QStringList files() const
    {
        QStringList names;
        for (int row = 0; row < searched.rowCount(); ++row)
            names << QString::fromStdString(searched.at(row).path).mid(3);
        return names;
    }
    SessionList list;
    SearchedSessions searched{list, nullptr};
};

TEST_F(SessionRows, haveTheTextsOfTheirRecordings)
{
    EXPECT_EQ(shown(SessionList::Verdicts), (QStringList{"2 CLEAR", "", "1 BLOCKED · 4 CANNOT TELL",
                                                         "1 CLEAR · 5 not read", ""}));
    EXPECT_EQ(shown(SessionList::Lasts)[0], "1:01");
    EXPECT_EQ(shown(SessionList::Size)[2], "4.5 MB");
    EXPECT_EQ(shown(SessionList::Robot)[0], "Absolem");
    EXPECT_EQ(shown(SessionList::Notes)[0], "1: at the <b>door</b>?1") << "one line";
    EXPECT_EQ(shown(SessionList::Robot)[1], "is not an SQLite file") << "the reason, in its row";
    EXPECT_EQ(shown(SessionList::State), (QStringList{"✓ sealed", "✕ cannot be read", "✓ sealed",
                                                      "✓ sealed", "● being recorded"}));
    EXPECT_EQ(durationText(3723.4), "1:02:03");
    EXPECT_EQ(sizeText(12'340), "12.3 kB");
    EXPECT_EQ(sizeText(2'345'000'000), "2.35 GB");
    EXPECT_EQ(beginText(list.at(0)).size(), 19);
    const QString begin = shown()[0], written = shown()[4];
    EXPECT_EQ(begin, beginText(list.at(0)).left(16)) << "to the minute";
    EXPECT_TRUE(beginText(list.at(4)).startsWith("before ")) << "its begin was not read";
    EXPECT_EQ(written, "≤ " + beginText(list.at(4)).mid(7).left(16));
}

TEST_F(SessionRows, stateNamesWhatIsNotWhole)
{
    ListedSession session = drive("/x/d.tts", 1, {});
    session.summary->closing = SessionClosing::Open;
    EXPECT_EQ(stateText(session), "○ not closed");
    session.summary->closing = SessionClosing::Torn;
    EXPECT_EQ(stateText(session), "✕ torn");
    session.summary->closing = SessionClosing::Sealed;
    session.summary->damage = Message::verbatim("a row");
    EXPECT_EQ(stateText(session), "✕ damaged");
}

TEST_F(SessionRows, areSortedByNumbersAndNotByTexts)
{
    searched.sort(SessionList::Begins, Qt::DescendingOrder);
    EXPECT_EQ(files().mid(0, 3), (QStringList{"b.tts", "c.tts", "a.tts"}));
    searched.sort(SessionList::Verdicts, Qt::DescendingOrder);
    EXPECT_EQ(files().mid(0, 3), (QStringList{"b.tts", "a.tts", "c.tts"})) << "BLOCKED first";
    searched.sort(SessionList::Size, Qt::AscendingOrder);
    EXPECT_EQ(files().mid(1), (QStringList{"broken.tts", "a.tts", "c.tts", "b.tts"}));
    searched.sort(SessionList::Robot, Qt::DescendingOrder);
    EXPECT_EQ(searched.rowCount(), 5);
}

TEST_F(SessionRows, searchFindsEveryWordInAnyColumn)
{
    searched.search("door BLOCKED");
    EXPECT_EQ(files(), QStringList{"b.tts"});
    searched.search("clear absolem");
    EXPECT_EQ(files(), (QStringList{"a.tts", "c.tts"}));
    searched.search("sqlite");
    EXPECT_EQ(files(), QStringList{"broken.tts"});
    searched.search(beginText(list.at(2)).left(16));
    EXPECT_EQ(files(), QStringList{"b.tts"}) << "the minute of its begin";
    searched.search("can0 nowhere");
    EXPECT_TRUE(files().empty());
    searched.search("  ");
    EXPECT_EQ(files().size(), 5);
}

}  // namespace
}  // namespace terratact
