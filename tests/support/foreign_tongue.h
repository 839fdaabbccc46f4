#pragma once

#include <QApplication>
#include <QTranslator>

namespace terratact {

/// A fake language while it exists: every translated text has Cyrillic letters for Latin ones. Text that stays in Latin
/// letters was not translatable.
class ForeignTongue final : public QTranslator {
public:
    ForeignTongue() { QApplication::installTranslator(this); }
    ~ForeignTongue() override { QApplication::removeTranslator(this); }
    ForeignTongue(const ForeignTongue&) = delete;
    ForeignTongue& operator=(const ForeignTongue&) = delete;

    bool isEmpty() const override { return false; }
    QString translate(const char* /*context*/, const char* english, const char* /*note*/,
                      int /*n*/) const override
    {
        QString text = QString::fromUtf8(english);
        for (QChar& c : text)
            if (c.isLetter()) c = QChar(0x0436);
        return text;
    }
};

}  // namespace terratact
