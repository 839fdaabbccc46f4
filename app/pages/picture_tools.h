#pragma once

#include <QMenu>
#include <QObject>
#include <QPointer>
#include <functional>

class QPoint;

namespace terratact {

class KeyTable;
class TerrainProfileView;

/// The context menu of the terrain's picture: copy it or its numbers, export it, measure, zoom. A right click, the Menu
/// key and Shift+F10 open it. The menu is made at its first use. It commands nothing.
class PictureTools final : public QObject {
    Q_OBJECT
public:
    /// stepLimit: returns the step limit of the copied numbers [m].
    PictureTools(TerrainProfileView& view, std::function<double()> stepLimit);

    void addKeys(KeyTable& keys);
    void openMenu(const QPoint& at);       ///< in coordinates of the screen
    QMenu* menu() const { return menu_; }  ///< null before its first use

    void copyPicture() const;
    /// Copies the numbers of the estimate, below the picture's note on it, and of a measurement.
    void copyNumbers() const;
    void measure();  ///< begins to measure in the picture, which gets the focus, or ends it

signals:
    void exportWanted();  ///< the menu offers it where something is connected

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void makeMenu();

    TerrainProfileView& view_;
    std::function<double()> stepLimit_;
    QPointer<QMenu> menu_;
};

/// Asks for a file and saves the picture in its colours (savePicture()). A name without ending gets .png. An existing
/// file is not replaced. done: gets the path and an error text, once the other thread has written the file; empty: it
/// was written.
void askAndSavePicture(TerrainProfileView& view, QWidget& parent,
                       std::function<void(const QString& path, const QString& trouble)> done);

}  // namespace terratact
