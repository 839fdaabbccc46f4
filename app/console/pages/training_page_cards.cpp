#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QRegularExpressionValidator>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>
#include <limits>

#include "app/console/pages/training_page.h"
#include "app/display/format.h"
#include "app/mission/text/comparison_text.h"
#include "widgets/base/card.h"
#include "widgets/base/held_button.h"
#include "widgets/base/palette.h"
#include "widgets/base/plain_label.h"
#include "widgets/base/plain_table.h"
#include "widgets/base/theme.h"
#include "widgets/base/tips.h"

// The cards of the training page and their fields.

namespace terratact {
namespace {

QTableWidget* makeTable(int rows, const QStringList& columns, const QString& name, QWidget* parent)
{
    auto* table = new HeadedTable(rows, static_cast<int>(columns.size()), parent);
    table->setAccessibleName(name);
    table->setHorizontalHeaderLabels(columns);
    table->verticalHeader()->hide();
    table->verticalHeader()->setMinimumSectionSize(20);
    table->verticalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table->horizontalHeader()->setHighlightSections(false);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setTabKeyNavigation(false);
    table->setWordWrap(false);
    table->setAlternatingRowColors(true);
    table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < table->columnCount(); ++column) {
            auto* item = new QTableWidgetItem;
            item->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight)
                                   | Qt::AlignVCenter);
            table->setItem(row, column, item);
        }
    return table;
}

QPushButton* makeButton(const QString& text, const QString& tip, QWidget* parent)
{
    auto* button = new QPushButton(text, parent);
    button->setAccessibleName(text);
    button->setFocusPolicy(Qt::TabFocus);
    setTip(*button, tip);
    return button;
}

QLabel* makeSentence(const QString& name, QWidget* parent)
{
    auto* label = new PlainLabel(parent);
    label->setWordWrap(true);
    label->setAccessibleName(name);
    return label;
}

}  // namespace

QPushButton* TrainingPage::addFile(QBoxLayout* column, const QString& what, const QString& title,
                                   QLineEdit*& field)
{
    field = new QLineEdit(this);
    field->setAccessibleName(title);
    field->setMinimumHeight(kTarget);
    field->setPlaceholderText(tr("scenes as CSV, with heights"));
    auto* label = new PlainLabel(what, this);
    label->setBuddy(field);
    auto* button = makeButton(tr("Choose …"), title, this);
    button->setAccessibleName(title);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(label);
    row->addWidget(field, 1);
    row->addWidget(button);
    column->addLayout(row);
    connect(button, &QPushButton::clicked, this, [this, field, title] { choose(field, title); });
    return button;
}

QWidget* TrainingPage::trainCard()
{
    auto* card = new Card(tr("1  Train a new model"), this);
    card->note()->setText(tr("robot: the one in use"));
    chooseScenes_ =
        addFile(card->body(), tr("Train on"), tr("Choose the training scenes"), scenes_);
    name_ = new QLineEdit(card);
    name_->setAccessibleName(tr("Name of the new model"));
    name_->setMinimumHeight(kTarget);
    name_->setMaxLength(60);
    name_->setValidator(new QRegularExpressionValidator(
        QRegularExpression(QStringLiteral("[A-Za-z0-9_][A-Za-z0-9_.-]*")), name_));
    setTip(*name_,
           tr("Letters, digits, - _ and .; the file is %1/NAME.ttm").arg(options_.directory));
    seed_ = new QSpinBox(card);
    seed_->setRange(0, std::numeric_limits<int>::max());
    seed_->setValue(1);
    seed_->setMinimumHeight(kTarget);
    seed_->setAccessibleName(tr("Seed of the search"));
    setTip(*seed_, tr("Same scenes and seed: the same model"));
    start_ = makeButton(tr("Start"), {}, card);  // showButtons() sets the tips
    start_->setProperty("role", "primary");
    cancel_ = makeButton(tr("Cancel"), {}, card);
    auto* what = new QHBoxLayout;
    what->setSpacing(8);
    auto* nameLabel = new PlainLabel(tr("Name"), card);
    nameLabel->setBuddy(name_);
    auto* seedLabel = new PlainLabel(tr("Seed"), card);
    seedLabel->setBuddy(seed_);
    what->addWidget(nameLabel);
    what->addWidget(name_, 1);
    what->addWidget(seedLabel);
    what->addWidget(seed_);
    what->addWidget(start_);
    what->addWidget(cancel_);
    card->body()->addLayout(what);

    bar_ = new QProgressBar(card);
    bar_->setRange(0, kPerMille);
    bar_->setAccessibleName(tr("Progress"));
    status_ = makeSentence(tr("State of the training"), card);
    status_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    keepRoomForStatus();
    card->body()->addWidget(bar_);
    card->body()->addWidget(status_);

    bins_ =
        makeTable(kBins,
                  {tr("bin"), tr("with\nforces"), tr("without\nforces"), tr("surface\nbelow robot"),
                   tr("surface\nahead"), tr("clearance\nbelow robot"), tr("clearance\nahead")},
                  tr("Training, bin by bin"), card);
    const QStringList tips{
        tr("Centre of the bin"),
        tr("Gaussian process given pose, currents and forces, and its log likelihood"),
        tr("Gaussian process given the pose alone, and its log likelihood"),
        tr("Surface where the robot is above the bin"),
        tr("Surface elsewhere"),
        tr("Clearance given the other bins, where the robot is above the bin; log likelihood"),
        tr("The same elsewhere"),
    };
    for (int column = 0; column < tips.size(); ++column)
        setTip(*bins_->horizontalHeaderItem(column), tips[column]);
    for (int bin = 0; bin < kBins; ++bin) bins_->item(bin, 0)->setText(format::binName(bin));
    for (const int wide : {0, 3, 5, 6})  // columns with names
        bins_->horizontalHeader()->setSectionResizeMode(wide, QHeaderView::ResizeToContents);
    card->body()->addWidget(bins_, 1);
    return card;
}

/// Reserves the status's height, so that the table does not move.
void TrainingPage::keepRoomForStatus()
{
    status_->setMinimumHeight(2 * fontMetrics().lineSpacing());
}

QWidget* TrainingPage::compareCard()
{
    auto* card = new Card(tr("2  Compare it with the model in use, then adopt it"), this);
    card->note()->hide();
    newModel_ = makeSentence(tr("Models"), card);
    card->body()->addWidget(newModel_);
    chooseTest_ = addFile(card->body(), tr("Test on"), tr("Choose the test scenes"), test_);
    compare_ = makeButton(tr("Compare"), {}, card);
    card->body()->addWidget(compare_);
    const auto rows = ComparisonWords::rows({});
    comparison_ = makeTable(static_cast<int>(rows.size()),
                            {tr("error"), tr("old"), tr("new"), tr("new − old")},
                            tr("Old and new model"), card);
    for (int number = 1; number <= kColumnDifference; ++number)
        comparison_->horizontalHeader()->setSectionResizeMode(number,
                                                              QHeaderView::ResizeToContents);
    for (int row = 0; row < rows.size(); ++row) {
        comparison_->item(row, 0)->setText(rows[row].what);
        setTip(*comparison_->item(row, 0), rows[row].what);
    }
    card->body()->addWidget(comparison_, 1);
    verdict_ = makeSentence(tr("Outcome"), card);
    setTone(*verdict_, Tone::Strong);
    caution_ = makeSentence(tr("What to keep in mind"), card);
    setTone(*caution_, Tone::Warning);
    reason_ = makeSentence(tr("Why not"), card);
    setTone(*reason_, Tone::Muted);
    adopt_ = new HoldToConfirmButton(tr("Adopt (hold)"), &Theme::decide, card);
    adopt_->setAccessibleName(tr("Use the new model from now on"));
    adopt_->setFocusPolicy(Qt::TabFocus);
    discard_ = new HoldToConfirmButton(tr("Discard (hold)"), &Theme::caution, card);
    discard_->setAccessibleName(tr("Discard the new model"));
    discard_->setFocusPolicy(Qt::TabFocus);
    auto* decide = new QHBoxLayout;
    decide->setSpacing(8);
    decide->addWidget(adopt_, 1);
    decide->addWidget(discard_, 1);
    for (QWidget* widget : {verdict_, caution_, reason_}) card->body()->addWidget(widget);
    card->body()->addLayout(decide);
    clearComparison();
    return card;
}

}  // namespace terratact
