#include "app/shell/about.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QStringList>

#include "app/runtime/resources.h"

namespace terratact {
namespace {

QString programName()
{
    return QStringLiteral("Terratact ") + QApplication::applicationVersion();
}

/// Returns the package's licence file; empty if it is not installed.
QString licencesFile()
{
    const QFileInfo file(
        QDir::cleanPath(QString::fromStdString(resourcePath("../doc/terratact/copyright"))));
    return file.isFile() ? file.filePath() : QString();
}

}  // namespace

QString aboutLine()
{
    return programName() + QStringLiteral(". ") + QCoreApplication::translate("About", kQwtCredit);
}

QString aboutHtml()
{
    QStringList paragraphs{
        QCoreApplication::translate(
            "About", "The operator's console of a tracked rescue robot. Where cameras see nothing, "
                     "it estimates the terrain from what body, flippers and arm feel. Bands show "
                     "how certain each height is."),
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
            "(LGPL 2.1), libgpiod (LGPL 2.1), ALSA (LGPL 2.1), {fmt} (MIT), CLI11 (BSD), toml++ "
            "(MIT), Boost (BSL 1.0)."),
    };
    if (const QString file = licencesFile(); !file.isEmpty())
        paragraphs << QCoreApplication::translate("About", "All licences in full: %1").arg(file);
    QString html = QStringLiteral("<h3>%1</h3>").arg(programName().toHtmlEscaped());
    for (const QString& paragraph : paragraphs)
        html += QStringLiteral("<p>%1</p>").arg(paragraph.toHtmlEscaped());
    return html;
}

}  // namespace terratact
