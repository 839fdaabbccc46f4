#include "app/about.h"

#include <QApplication>
#include <QStringList>

namespace terratact {
namespace {

QString programName()
{
    return QStringLiteral("Terratact ") + QApplication::applicationVersion();
}

}  // namespace

QString aboutLine()
{
    return programName() + QStringLiteral(". ") + QCoreApplication::translate("About", kQwtCredit);
}

QString aboutHtml()
{
    const QStringList paragraphs{
        QCoreApplication::translate(
            "About",
            "The operator's console of a tracked rescue robot. Where cameras see nothing, it "
            "estimates the terrain from what body, flippers and arm feel, and says how sure that "
            "is."),
        QCoreApplication::translate("About",
                                    "Copyright %1 Terratact contributors. MIT licence: free to "
                                    "use, to change and to pass on; without any warranty.")
            .arg(QStringLiteral("2026")),
        QCoreApplication::translate("About", kQwtCredit),
        QCoreApplication::translate("About",
                                    "It uses Qt %1 (https://www.qt.io), a library of its own "
                                    "under the GNU LGPL, version 3, which may be replaced by "
                                    "another version of it.")
            .arg(QString::fromLatin1(qVersion())),
        QCoreApplication::translate(
            "About",
            "Other libraries: Eigen (MPL 2.0), OpenBLAS (BSD), SQLite (public domain), cairo "
            "(LGPL 2.1), libgpiod (LGPL 2.1), {fmt} (MIT), CLI11 (BSD), toml++ (MIT), Boost "
            "(BSL 1.0)."),
        QCoreApplication::translate("About", "All licences in full: %1")
            .arg(QStringLiteral("/usr/share/doc/terratact/copyright")),
    };
    QString html = QStringLiteral("<h3>%1</h3>").arg(programName().toHtmlEscaped());
    for (const QString& paragraph : paragraphs)
        html += QStringLiteral("<p>%1</p>").arg(paragraph.toHtmlEscaped());
    return html;
}

}  // namespace terratact
