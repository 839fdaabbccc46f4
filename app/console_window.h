#pragma once

#include <QWidget>

#include "app/key_table.h"

class QBoxLayout;
class QLabel;
class QPushButton;
class QStackedWidget;

namespace terratact {

class NavigationRail;
class PreferenceStore;
class StatusHeader;

/// The frame of the program's windows: the header, strips below it, and the rail beside the pages, of which one
/// is seen.  Keys do what the table of the window says, which F1 shows.
class ConsoleWindow : public QWidget {
    Q_OBJECT
public:
    StatusHeader* header() const { return header_; }
    NavigationRail* rail() const { return rail_; }
    const KeyTable& keys() const { return keys_; }

protected:
    ConsoleWindow();

    /// A line over the whole width, below those added before.  look: its name in the style sheet.
    QLabel* addStrip(const QString& look);
    void addPage(QWidget* page, const QString& name, Qt::Key key, const QString& tip);
    QPushButton* addTool(const QString& text, const QString& tip);  ///< to the rail
    void addViewTool(PreferenceStore& preferences);
    void addHelpTool();
    void addBelowPages(QWidget* widget);
    QStackedWidget* pages() const { return pages_; }

    KeyTable& keyTable() { return keys_; }
    void addPageKeys();  ///< of the pages there are
    /// F1 and ? show the sheet of the keys, with this below; HTML.
    void addHelpKey(const QString& footer = {});

    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void showHelp();

    KeyTable keys_;
    QString footer_;

    // Qt's parents own the widgets.
    StatusHeader* header_ = nullptr;
    NavigationRail* rail_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    QBoxLayout* strips_ = nullptr;
    QBoxLayout* right_ = nullptr;
    QLabel* help_ = nullptr;
};

}  // namespace terratact
