#include "app/start/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

// Q_INIT_RESOURCE must be used outside any namespace; it loads the resources of a static library.
static void initTranslations()
{
    Q_INIT_RESOURCE(translations);
}

namespace terratact {
namespace {

/// Installs a translator; replaces the one installed earlier under this name.
bool install(QCoreApplication& application, const QString& name, const QString& file)
{
    delete application.findChild<QTranslator*>(name);
    auto* translator = new QTranslator(&application);
    translator->setObjectName(name);
    return translator->load(file) && QCoreApplication::installTranslator(translator);
}

}  // namespace

QString installLanguage(QCoreApplication& application, const QString& language)
{
    initTranslations();
    QLocale numbers = QLocale::c();
    numbers.setNumberOptions(QLocale::OmitGroupSeparator);
    QLocale::setDefault(numbers);
    const QString wanted =
        language.isEmpty() ? QLocale::system().name().section(QLatin1Char('_'), 0, 0) : language;
    const bool found = install(application, QStringLiteral("terratact"),
                               QStringLiteral(":/translations/terratact_%1.qm").arg(wanted));
    // Qt's own texts, such as those of file dialogs.
    install(application, QStringLiteral("qt"),
            QStringLiteral("%1/qtbase_%2.qm")
                .arg(QLibraryInfo::path(QLibraryInfo::TranslationsPath), found ? wanted : "en"));
    return found ? wanted : QStringLiteral("en");
}

}  // namespace terratact
