// Tests the table of keys.
#include "app/shell/key_table.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/benches/look_bench.h"

namespace terratact {
namespace {

TEST_F(Look, theKeySheetListsEveryKeyAndEveryKeyActs)
{
    const QString sheet = window->keys().html();
    std::set<int> seen;
    for (const KeyTable::Entry& entry : window->keys().entries()) {
        EXPECT_FALSE(entry.meaning.isEmpty());
        EXPECT_TRUE(sheet.contains(entry.meaning.toHtmlEscaped()));
        for (const QKeyCombination key : entry.keys) {
            EXPECT_TRUE(seen.insert(key.toCombined()).second) << "a key with two meanings";
            const QKeyEvent event(QEvent::KeyPress, key.key(), key.keyboardModifiers());
            EXPECT_EQ(window->keys().entryOf(event), &entry);
            EXPECT_TRUE(sheet.contains(
                QKeySequence(key).toString(QKeySequence::NativeText).toHtmlEscaped()));
        }
    }
    KeyTable twice;
    twice.add({{Qt::Key_A}, "one", {}});
    EXPECT_THROW(twice.add({{Qt::Key_B, Qt::Key_A}, "two", {}}), std::logic_error);
    const QKeyEvent withAlt(QEvent::KeyPress, Qt::Key_A, Qt::AltModifier);
    EXPECT_EQ(twice.entryOf(withAlt), nullptr);
}

TEST_F(Look, theKeySheetHasNoRowWithoutText)
{
    KeyTable table;
    table.addGroup("Go");
    table.add({{Qt::Key_1}, "to the next (with Alt: previous)", {}});
    table.add({{QKeyCombination(Qt::ALT, Qt::Key_1)}, {}, {}});
    EXPECT_TRUE(table.html().contains("<b>1</b>"));
    EXPECT_FALSE(table.html().contains("Alt+1"));
}

}  // namespace
}  // namespace terratact
