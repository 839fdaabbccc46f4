#include "app/pages/picture_tools.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFileInfo>
#include <QKeySequence>
#include <QMenu>
#include <QMetaMethod>
#include <QPixmap>
#include <thread>
#include <utility>

#include "app/pages/terrain_picture.h"
#include "app/shell/file_dialog.h"
#include "app/shell/key_table.h"
#include "app/shell/window_picture.h"
#include "widgets/terrain/bin_inspector.h"
#include "widgets/terrain/readings/numbers_table.h"
#include "widgets/terrain/terrain_profile_view.h"

namespace terratact {
namespace {

constexpr double kMenuZoom = 1.25;

/// Writes a picture in another thread: its coding and a disk may take longer than a window may freeze. Reports the
/// result in the owner's thread, unless the owner is gone; its end waits for the file.
class PictureWriter final : public QObject {
public:
    PictureWriter(QObject& owner, std::function<QString()> write,
                  std::function<void(const QString& trouble)> done)
        : QObject(&owner), done_(std::move(done)), thread_([this, write = std::move(write)] {
              const QString trouble = write();
              QMetaObject::invokeMethod(
                  this, [this, trouble] { finish(trouble); }, Qt::QueuedConnection);
          })
    {
    }

private:
    void finish(const QString& trouble)
    {
        done_(trouble);
        deleteLater();
    }

    std::function<void(const QString& trouble)> done_;
    std::jthread thread_;
};

/// Returns a point in the picture for a menu that a key opens: at the bin shown in detail, else in the middle.
QPoint menuPlace(const TerrainProfileView& view)
{
    const int bin = view.inspector()->bin();
    const QRect canvas = view.canvas()->geometry();
    QPoint at = canvas.center();
    if (bin >= 0) at.setX(canvas.x() + static_cast<int>(view.pixelOf(binCentre(bin), 0.0).x()));
    return view.mapToGlobal(at);
}

}  // namespace

PictureTools::PictureTools(TerrainProfileView& view, std::function<double()> stepLimit)
    : QObject(&view), view_(view), stepLimit_(std::move(stepLimit))
{
    view.installEventFilter(this);
}

bool PictureTools::eventFilter(QObject* object, QEvent* event)
{
    if (object != &view_ || event->type() != QEvent::ContextMenu)
        return QObject::eventFilter(object, event);
    const auto& asked = static_cast<const QContextMenuEvent&>(*event);
    openMenu(asked.reason() == QContextMenuEvent::Mouse ? asked.globalPos() : menuPlace(view_));
    event->accept();
    return true;
}

void PictureTools::openMenu(const QPoint& at)
{
    if (!menu_) makeMenu();
    // The Menu key may come twice: as a key and as a request of the desktop.
    if (!menu_->isVisible()) menu_->popup(at);
}

void PictureTools::makeMenu()
{
    menu_ = new QMenu(&view_);
    menu_->setAccessibleName(tr("Terrain picture"));
    QAction* const picture = menu_->addAction(tr("Copy the picture"));
    connect(picture, &QAction::triggered, this, &PictureTools::copyPicture);
    QAction* const numbers = menu_->addAction(tr("Copy the numbers"));
    connect(numbers, &QAction::triggered, this, &PictureTools::copyNumbers);
    QAction* const exports = menu_->addAction(tr("Export …"));
    connect(exports, &QAction::triggered, this, &PictureTools::exportWanted);
    menu_->addSeparator();
    const QString tab = QStringLiteral("\t");
    QAction* const measures = menu_->addAction(tr("Measure height and slope") + tab + u'I');
    measures->setCheckable(true);
    connect(measures, &QAction::triggered, this, &PictureTools::measure);
    menu_->addSeparator();
    const auto middle = [this] {
        return view_.pointAt(QRectF(view_.canvas()->contentsRect()).center());
    };
    connect(menu_->addAction(tr("Closer") + tab + u'+'), &QAction::triggered, this,
            [this, middle] { view_.zoomAt(1.0 / kMenuZoom, middle()); });
    connect(menu_->addAction(tr("Farther away") + tab + QChar(0x2212)), &QAction::triggered, this,
            [this, middle] { view_.zoomAt(kMenuZoom, middle()); });
    QAction* const all = menu_->addAction(tr("The whole robot") + tab + u'0');
    connect(all, &QAction::triggered, &view_, &TerrainProfileView::resetZoom);
    connect(menu_, &QMenu::aboutToShow, this, [this, exports, numbers, measures, all] {
        exports->setVisible(
            isSignalConnected(QMetaMethod::fromSignal(&PictureTools::exportWanted)));
        numbers->setEnabled(view_.estimate().has_value() || view_.measures());
        measures->setChecked(view_.measures());
        all->setEnabled(view_.isZoomed());
    });
}

void PictureTools::copyPicture() const
{
    QApplication::clipboard()->setPixmap(pictureOf(view_));
}

void PictureTools::copyNumbers() const
{
    QString text;
    if (view_.estimate()) {
        NumbersTable table;
        table.setEstimate(*view_.estimate(), stepLimit_());
        if (!view_.note().isEmpty()) text = view_.note() + QLatin1Char('\n');
        text += table.text();
    }
    if (const QStringList lines = view_.measuredLines(); !lines.isEmpty())
        text += lines.join(QLatin1Char('\n')).replace(QChar(0x2212), QLatin1Char('-'))
              + QLatin1Char('\n');
    if (!text.isEmpty()) QApplication::clipboard()->setText(text);
}

void PictureTools::measure()
{
    view_.setMeasuring(!view_.measures());
    if (view_.measures()) view_.setFocus(Qt::ShortcutFocusReason);
}

void PictureTools::addKeys(KeyTable& keys)
{
    const auto isShown = [this] { return view_.isVisible(); };
    keys.add({.keys = {Qt::Key_I},
              .meaning = tr("measure height and slope between two points; again ends it"),
              .pressed = [this] { measure(); },
              .applies = isShown});
    keys.add({.keys = {Qt::Key_Menu, QKeyCombination(Qt::SHIFT, Qt::Key_F10)},
              .meaning = tr("menu of the picture: copy, export, measure, zoom"),
              .pressed = [this] { openMenu(menuPlace(view_)); },
              .applies = isShown});
    keys.add({{Qt::Key_Plus, Qt::Key_Minus, Qt::Key_0},
              tr("in the picture (Tab): closer, farther away, the whole robot"),
              {}});
}

void askAndSavePicture(TerrainProfileView& view, QWidget& parent,
                       std::function<void(const QString& path, const QString& trouble)> done)
{
    askForFile(parent,
               {.title = PictureTools::tr("Export the picture"),
                .start = QStringLiteral("terrain.png"),
                .filter = PictureTools::tr("Pictures (*.png *.svg *.pdf)"),
                .kind = FileWish::Kind::ToWrite},
               [&view, &parent, done = std::move(done)](const QString& path) {
                   const QString file =
                       QFileInfo(path).suffix().isEmpty() ? path + QStringLiteral(".png") : path;
                   const QString taken =
                       PictureTools::tr("%1 exists and was not replaced; choose another name");
                   if (QFileInfo::exists(file)) return done(file, taken.arg(file));
                   // The parent owns it.
                   new PictureWriter(parent, drawnPicture(view, file, PictureColours::AsShown),
                                     [done, file](const QString& trouble) { done(file, trouble); });
               });
}

}  // namespace terratact
