// Tests the credits.
#include "app/shell/about.h"

#include <gtest/gtest.h>

#include <QFileInfo>
#include <QRegularExpression>

namespace terratact {
namespace {

TEST(About, namesNoFileThatIsNotThere)
{
    static const QRegularExpression kFile(QStringLiteral("(?<![:/])/[a-z][^ <]*"));
    for (auto file = kFile.globalMatch(aboutHtml().remove(QRegularExpression("</[a-z0-9]+>")));
         file.hasNext();) {
        const QString path = file.next().captured();
        EXPECT_TRUE(QFileInfo::exists(path)) << path.toStdString();
    }
}

}  // namespace
}  // namespace terratact
