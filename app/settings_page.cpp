#include "app/settings_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <numbers>

#include "app/letters.h"
#include "widgets/card.h"
#include "widgets/look.h"
#include "widgets/palette.h"
#include "widgets/words.h"

namespace terratact {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
const std::array<QString, 4> kLanguages{QString(), QStringLiteral("en"), QStringLiteral("cs"),
                                        QStringLiteral("de")};

/// The methods an operator chooses from; PAFAc is what PAFc becomes once the arm has measured.
std::vector<Method> offered()
{
    std::vector<Method> methods(kMethods.begin(), kMethods.end());
    std::erase(methods, Method::Pafac);
    return methods;
}

template <class Range, class Value>
int indexOf(const Range& range, const Value& value)
{
    const auto found = std::find(std::begin(range), std::end(range), value);
    return found == std::end(range) ? 0 : static_cast<int>(found - std::begin(range));
}

QString chooseTip()
{
    return SettingsPage::tr("Use this file from now on");
}

QString shippedTip()
{
    return SettingsPage::tr("Back to what came with the program; grey while that is in use");
}

QString defaultsTip()
{
    return SettingsPage::tr("Everything on this page, and the shipped model and robot");
}

}  // namespace

SettingsPage::SettingsPage(PreferenceStore& store, std::vector<PresetCost> presets, QWidget* parent)
    : Page(parent), store_(store), presets_(std::move(presets))
{
    const auto card = [this](const QString& title) {
        auto* made = new Card(title, this);
        auto* form = new QFormLayout;
        form->setHorizontalSpacing(16);
        form->setVerticalSpacing(8);
        form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
        made->body()->addLayout(form);
        made->body()->addStretch(1);
        return std::pair(made, form);
    };
    const auto [estimate, estimateForm] = card(tr("Estimate"));
    buildEstimate(estimateForm);
    const auto [look, lookForm] = card(tr("Look and sound"));
    buildLook(lookForm);
    defaults_ = new QPushButton(tr("All back to the defaults"), look);
    defaults_->setToolTip(defaultsTip());
    look->body()->addWidget(defaults_);
    connect(defaults_, &QPushButton::clicked, this, [this] {
        store_.change([](Preferences& p) {
            Preferences plain;
            plain.window = p.window;
            p = plain;
        });
    });

    const auto [recording, recordingForm] = card(tr("Recording"));
    buildRecording(recordingForm);

    auto* right = new QVBoxLayout;
    right->setSpacing(10);
    right->addWidget(look);
    right->addWidget(recording);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(10);
    columns->addWidget(estimate, 1);
    columns->addLayout(right, 1);
    auto* inside = new QWidget;
    auto* all = new QVBoxLayout(inside);
    all->setContentsMargins(12, 10, 12, 10);
    all->setSpacing(10);
    all->addLayout(columns);
    all->addWidget(buildFiles());
    all->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setAccessibleName(tr("Settings"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setWidget(inside);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(scroll);
    show();
    connect(&store_, &PreferenceStore::changed, this, &SettingsPage::show);
}

QComboBox* SettingsPage::choice(QFormLayout* form, const QString& label, const QStringList& names,
                                const QString& tip)
{
    auto* box = new QComboBox(this);
    box->addItems(names);
    box->setMinimumHeight(kTarget);
    box->setAccessibleName(label);
    box->setToolTip(tip);
    form->addRow(label, box);
    connect(box, &QComboBox::currentIndexChanged, this, &SettingsPage::take);
    return box;
}

QDoubleSpinBox* SettingsPage::number(QFormLayout* form, const QString& label, double least,
                                     double most, int decimals, const QString& unit,
                                     const QString& tip)
{
    auto* box = new QDoubleSpinBox(this);
    box->setDecimals(decimals);
    box->setRange(least, most);
    box->setSingleStep(decimals == 2 ? 0.01 : decimals == 1 ? 0.1 : 1.0);
    box->setSuffix(QLatin1Char(' ') + unit);
    box->setKeyboardTracking(false);  // a number is told when it is whole
    box->setMinimumHeight(kTarget);
    box->setAccessibleName(label);
    box->setToolTip(tip);
    form->addRow(label, box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &SettingsPage::take);
    return box;
}

void SettingsPage::buildEstimate(QFormLayout* form)
{
    QStringList methods, qualities;
    for (const Method method : offered()) methods << words::text(name(method));
    for (const Quality quality : kQualities) qualities << words::sentence(name(quality));
    method_ = choice(form, tr("Method"), methods,
                     tr("local and joint are closed formulas; the others draw chains of samples"));
    quality_ = choice(form, tr("Quality"), qualities,
                      tr("Time against accuracy, as terratact tradeoff has measured them"));
    obstacle_ = number(form, tr("An obstacle is a step of more than"), 0.02, 0.60, 2, tr("m"),
                       tr("The verdict's question (PgUp, PgDown)"));
    threshold_ = number(form, tr("An element is a contact above"), 0.1, 50.0, 1, tr("N"),
                        tr("Weaker forces are noise"));
    probeAbove_ = number(form, tr("The arm is offered above a sd of"), 0.01, 0.50, 2, tr("m"),
                         tr("A bin less certain than this asks for a probe"));
    roll_ = number(form, tr("The verdict is withheld above a roll of"), 1.0, 45.0, 1, tr("°"),
                   tr("Then left and right ground differ"));
    asymmetry_ = number(form, tr("… or left and right flippers apart by"), 1.0, 90.0, 1, tr("°"),
                        tr("Then left and right ground differ"));
}

void SettingsPage::buildLook(QFormLayout* form)
{
    theme_ = choice(form, tr("Theme"), {tr("day"), tr("night, red"), tr("high contrast")},
                    tr("Night, red: keeps the eyes used to the dark"));
    fontScale_ = new QSpinBox(this);
    fontScale_->setRange(kSmallestFont, kLargestFont);
    fontScale_->setSingleStep(10);
    fontScale_->setSuffix(QStringLiteral(" %"));
    fontScale_->setKeyboardTracking(false);
    fontScale_->setMinimumHeight(kTarget);
    fontScale_->setAccessibleName(tr("Size of text"));
    fontScale_->setToolTip(tr("Ctrl + and Ctrl −"));
    form->addRow(tr("Size of text"), fontScale_);
    connect(fontScale_, &QSpinBox::valueChanged, this, &SettingsPage::take);
    lettersNote_ = new QLabel(this);
    setTone(*lettersNote_, Tone::Doubt);
    lettersNote_->setWordWrap(true);
    lettersNote_->hide();
    form->addRow(QString(), lettersNote_);
    language_ = choice(form, tr("Language"),
                       {tr("the system's"), QStringLiteral("English"), QStringLiteral("Čeština"),
                        QStringLiteral("Deutsch")},
                       tr("Takes effect at the next start"));
    layout_ = choice(form, tr("Layout"), {tr("Drive"), tr("Probe"), tr("Review")},
                     tr("What the terrain page makes large"));
    sound_ = new QCheckBox(tr("Alarms may be heard"), this);
    sound_->setMinimumHeight(kTarget);
    sound_->setToolTip(tr("Off: alarms are only seen"));
    form->addRow(QString(), sound_);
    connect(sound_, &QCheckBox::toggled, this, &SettingsPage::take);
}

QSpinBox* SettingsPage::limit(QFormLayout* form, const QString& label, int most,
                              const QString& unit, const QString& tip)
{
    auto* box = new QSpinBox(this);
    box->setRange(0, most);
    box->setSpecialValueText(tr("never"));
    box->setSuffix(QLatin1Char(' ') + unit);
    box->setKeyboardTracking(false);
    box->setMinimumHeight(kTarget);
    box->setAccessibleName(label);
    box->setToolTip(tip);
    form->addRow(label, box);
    connect(box, &QSpinBox::valueChanged, this, &SettingsPage::take);
    return box;
}

void SettingsPage::buildRecording(QFormLayout* form)
{
    record_ = new QCheckBox(tr("Everything is recorded"), this);
    record_->setMinimumHeight(kTarget);
    record_->setToolTip(
        tr("Frames, scenes, estimates, what was shown and decided, in one file per session"));
    form->addRow(QString(), record_);
    connect(record_, &QCheckBox::toggled, this, &SettingsPage::take);
    keepDays_ = limit(form, tr("Delete a session after"), kMostDays, tr("days"),
                      tr("At the next start; never: nothing is deleted"));
    keepGigabytes_ = limit(form, tr("Delete the oldest beyond"), kMostGigabytes, tr("GB"),
                           tr("Of all sessions together, at the next start"));
}

QWidget* SettingsPage::buildFiles()
{
    auto* card = new Card(tr("Model and robot"), this);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(16);
    grid->setColumnStretch(0, 1);
    const auto file = [&](int row, const QString& name, QLabel*& text, QPushButton*& choose,
                          QPushButton*& shipped) {
        text = new QLabel(card);
        text->setAccessibleName(name);
        text->setWordWrap(true);
        text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        choose = new QPushButton(tr("Choose a file …"), card);
        choose->setAccessibleName(tr("Choose a file: %1").arg(name));
        choose->setToolTip(chooseTip());
        shipped = new QPushButton(tr("The shipped one"), card);
        shipped->setAccessibleName(tr("The shipped one: %1").arg(name));
        shipped->setToolTip(shippedTip());
        grid->addWidget(text, row, 0);
        grid->addWidget(choose, row, 1, Qt::AlignTop);
        grid->addWidget(shipped, row, 2, Qt::AlignTop);
    };
    file(0, tr("Model"), model_, chooseModel_, shippedModel_);
    file(1, tr("Robot"), robot_, chooseRobot_, shippedRobot_);
    card->body()->addLayout(grid);
    connect(chooseModel_, &QPushButton::clicked, this,
            [this] { chooseFile(&Preferences::model, tr("Model"), tr("Models (*.ttm)")); });
    connect(chooseRobot_, &QPushButton::clicked, this,
            [this] { chooseFile(&Preferences::robot, tr("Robot"), tr("Robots (*.toml)")); });
    const auto forget = [this](QString Preferences::*which) {
        store_.change([which](Preferences& p) { (p.*which).clear(); });
    };
    connect(shippedModel_, &QPushButton::clicked, this, [forget] { forget(&Preferences::model); });
    connect(shippedRobot_, &QPushButton::clicked, this, [forget] { forget(&Preferences::robot); });
    return card;
}

void SettingsPage::chooseFile(QString Preferences::*file, const QString& title,
                              const QString& filter)
{
    // Not the desktop's own dialog: F12 has to stop the robot from there, too.
    const QString path = QFileDialog::getOpenFileName(this, title, store_.current().*file, filter,
                                                      nullptr, QFileDialog::DontUseNativeDialog);
    if (path.isEmpty()) return;
    store_.change([file, path](Preferences& p) { p.*file = path; });
}

void SettingsPage::show()
{
    const Preferences& p = store_.current();
    showing_ = true;
    method_->setCurrentIndex(indexOf(offered(), p.method));
    quality_->setCurrentIndex(indexOf(kQualities, p.quality));
    obstacle_->setValue(p.obstacleLimit);
    threshold_->setValue(p.forceThreshold);
    probeAbove_->setValue(p.probeAbove);
    roll_->setValue(p.rollLimit / kDegree);
    asymmetry_->setValue(p.asymmetryLimit / kDegree);
    theme_->setCurrentIndex(static_cast<int>(p.theme));
    fontScale_->setValue(p.fontScale);
    language_->setCurrentIndex(indexOf(kLanguages, p.language));
    layout_->setCurrentIndex(static_cast<int>(p.layout));
    sound_->setChecked(p.sound);
    record_->setChecked(p.record);
    keepDays_->setValue(p.keepDays);
    keepGigabytes_->setValue(p.keepGigabytes);
    showing_ = false;
    showCosts();
}

void SettingsPage::take()
{
    if (showing_) return;
    const auto at = [](const QComboBox* box) {
        return static_cast<std::size_t>(std::max(0, box->currentIndex()));
    };
    store_.change([&](Preferences& p) {
        p.method = offered().at(at(method_));
        p.quality = kQualities.at(at(quality_));
        p.obstacleLimit = obstacle_->value();
        p.forceThreshold = threshold_->value();
        p.probeAbove = probeAbove_->value();
        p.rollLimit = roll_->value() * kDegree;
        p.asymmetryLimit = asymmetry_->value() * kDegree;
        p.theme = static_cast<ThemeName>(at(theme_));
        p.fontScale = fontScale_->value();
        p.language = kLanguages.at(at(language_));
        p.layout = static_cast<Layout>(at(layout_));
        p.sound = sound_->isChecked();
        p.record = record_->isChecked();
        p.keepDays = keepDays_->value();
        p.keepGigabytes = keepGigabytes_->value();
    });
}

void SettingsPage::showCosts()
{
    const QSignalBlocker quiet(quality_);
    for (int i = 0; i < quality_->count(); ++i) {
        const Quality quality = kQualities.at(static_cast<std::size_t>(i));
        const auto cost = std::find_if(presets_.begin(), presets_.end(), [&](const PresetCost& c) {
            return c.method == store_.current().method && c.quality == quality;
        });
        const QString word = words::sentence(name(quality));
        quality_->setItemText(i, cost == presets_.end()
                                     ? tr("%1: not measured").arg(word)
                                     : tr("%1: %2 ms, error %3 mm")
                                           .arg(word, words::number(cost->milliseconds, 1),
                                                words::number(cost->errorMm, 0)));
    }
}

void SettingsPage::setModelCard(const QString& card)
{
    if (model_->text() != card) model_->setText(card);
}

void SettingsPage::setRobotCard(const QString& card)
{
    if (robot_->text() != card) robot_->setText(card);
}

void SettingsPage::setReopenBlocked(const QString& why)
{
    const auto block = [&why](QWidget* control, const QString& tip, bool mayBe = true) {
        control->setEnabled(why.isEmpty() && mayBe);
        control->setToolTip(why.isEmpty() ? tip : why);
    };
    block(chooseRobot_, chooseTip());
    block(shippedRobot_, shippedTip(), !store_.current().robot.isEmpty());
    block(defaults_, defaultsTip());
}

QString SettingsPage::modelCard() const
{
    return model_->text();
}

void SettingsPage::refresh(double /*now*/)
{
    shippedModel_->setEnabled(!store_.current().model.isEmpty());
    lettersNote_->setText(terratact::lettersNote(store_.current().fontScale));
    lettersNote_->setVisible(!lettersNote_->text().isEmpty());
}

}  // namespace terratact
