// Tests sheets of text.
#include "app/shell/text_sheet.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include "tests/support/temporary_directory.h"

namespace terratact {
namespace {

TEST(TextSheet, opensNoFileThatItsTextNames)
{
    const TemporaryDirectory directory;
    const std::string pipe = directory.file("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    TextSheet sheet("test", {}, nullptr);
    const QString image = QStringLiteral("<IMG src=\"%1\">").arg(QString::fromStdString(pipe));
    sheet.setText(QStringLiteral("<h3>a</h3>%1<p style=\"background:url(%2)\">b</p>")
                      .arg(image, QString::fromStdString(pipe)),
                  QSize(800, 600));  // reading the pipe would block forever
    EXPECT_TRUE(sheet.plainText().contains(image)) << sheet.plainText().toStdString();
}

}  // namespace
}  // namespace terratact
