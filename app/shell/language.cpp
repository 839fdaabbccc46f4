#include "app/shell/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

#if TERRATACT_TRANSLATIONS
// Outside of any namespace, as the macro asks; a static library's resources are not found otherwise.
static void initTranslations()
{
    Q_INIT_RESOURCE(translations);
}
#else
static void initTranslations() {}
#endif

namespace terratact {
namespace {

/// Replaces the translator that an earlier call installed under this name.
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
    // Qt's own words, such as those of a file dialog.
    install(application, QStringLiteral("qt"),
            QStringLiteral("%1/qtbase_%2.qm")
                .arg(QLibraryInfo::path(QLibraryInfo::TranslationsPath), found ? wanted : "en"));
    return found ? wanted : QStringLiteral("en");
}

}  // namespace terratact
