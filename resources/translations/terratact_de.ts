<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>About</name>
    <message>
        <source>Based in part on the work of the Qwt project (http://qwt.sf.net).</source>
        <translation>Beruht zum Teil auf der Arbeit des Qwt-Projekts (http://qwt.sf.net).</translation>
    </message>
    <message>
        <source>The operator&apos;s console of a tracked rescue robot. Where cameras see nothing, it estimates the terrain from what body, flippers and arm feel. Bands show how certain each height is.</source>
        <translation>Die Bedienkonsole eines Rettungsroboters auf Ketten. Wo Kameras nichts sehen, schätzt sie das Gelände aus dem, was Rumpf, Flipper und Arm spüren. Bänder zeigen, wie sicher jede Höhe ist.</translation>
    </message>
    <message>
        <source>Copyright %1 Terratact contributors. MIT licence: free to use, to change and to pass on; without any warranty.</source>
        <translation>Copyright %1 die Mitwirkenden an Terratact. MIT-Lizenz: frei zu benutzen, zu ändern und weiterzugeben; ohne jede Gewährleistung.</translation>
    </message>
    <message>
        <source>It uses Qt %1 (https://www.qt.io), a library of its own under the GNU LGPL, version 3, which may be replaced by another version of it.</source>
        <translation>Benutzt Qt %1 (https://www.qt.io), eine eigenständige Bibliothek unter der GNU LGPL, Version 3, die durch eine andere Version von ihr ersetzt werden darf.</translation>
    </message>
    <message>
        <source>Other libraries: Eigen (MPL 2.0), OpenBLAS (BSD), SQLite (public domain), cairo (LGPL 2.1), libgpiod (LGPL 2.1), ALSA (LGPL 2.1), {fmt} (MIT), CLI11 (BSD), toml++ (MIT), Boost (BSL 1.0).</source>
        <translation>Weitere Bibliotheken: Eigen (MPL 2.0), OpenBLAS (BSD), SQLite (gemeinfrei), cairo (LGPL 2.1), libgpiod (LGPL 2.1), ALSA (LGPL 2.1), {fmt} (MIT), CLI11 (BSD), toml++ (MIT), Boost (BSL 1.0).</translation>
    </message>
    <message>
        <source>All licences in full: %1</source>
        <translation>Alle Lizenzen im Wortlaut: %1</translation>
    </message>
</context>
<context>
    <name>Application</name>
    <message>
        <source>Terratact could not open this</source>
        <translation>Terratact konnte das nicht öffnen</translation>
    </message>
    <message>
        <source>Terratact could not start</source>
        <translation>Terratact konnte nicht starten</translation>
    </message>
    <message>
        <source>no font is installed, so no text could be read: install one, such as fonts-dejavu-core</source>
        <translation>es ist keine Schrift installiert, also wäre kein Text lesbar: installieren Sie eine, etwa fonts-dejavu-core</translation>
    </message>
</context>
<context>
    <name>BusWords</name>
    <message>
        <source>%1 does not take frames: no node acknowledges them, or the bus is full. Check the robot&apos;s power, the wires and the bit rate</source>
        <translation>%1 nimmt keine Rahmen an: niemand bestätigt sie oder der Bus ist voll; ist der Roboter an, stimmen Kabel und Bitrate?</translation>
    </message>
    <message>
        <source>%1 has many errors: check wires, terminators and bit rate</source>
        <translation>%1 hat viele Fehler: Kabel, Abschlüsse und Bitrate prüfen</translation>
    </message>
    <message>
        <source>%1 is bus-off after too many errors: check the wires, then restart it</source>
        <translation>%1 ist bus-off: Kabel prüfen, dann neu starten</translation>
    </message>
    <message>
        <source>%1 is down: bring it up</source>
        <translation>%1 ist aus: einschalten</translation>
    </message>
    <message>
        <source>%1 does not exist: plug the adapter in, or make the interface</source>
        <translation>%1 gibt es nicht: Adapter anstecken oder die Schnittstelle anlegen</translation>
    </message>
    <message>
        <source>%1 has ended</source>
        <translation>%1 ist zu Ende</translation>
    </message>
    <message>
        <source>%1 is receive-only: start the console with --transmit</source>
        <translation>%1 wird nur abgehört: die Konsole mit --transmit starten</translation>
    </message>
    <message>
        <source>%1 takes no commands</source>
        <translation>%1 nimmt keine Befehle an</translation>
    </message>
    <message>
        <source>frames still come, heartbeat %1 old</source>
        <translation>Rahmen kommen noch, Herzschlag %1 alt</translation>
    </message>
    <message>
        <source>frames still come, status %1 old</source>
        <translation>Rahmen kommen noch, Zustand %1 alt</translation>
    </message>
    <message>
        <source>frames still come</source>
        <translation>Rahmen kommen noch</translation>
    </message>
    <message>
        <source>ACTIVE</source>
        <translation>AKTIV</translation>
    </message>
    <message>
        <source>STALLED</source>
        <translation>STEHT</translation>
    </message>
    <message>
        <source>PASSIVE</source>
        <translation>PASSIV</translation>
    </message>
    <message>
        <source>BUS-OFF</source>
        <translation>BUS-AUS</translation>
    </message>
    <message>
        <source>DOWN</source>
        <translation>AUS</translation>
    </message>
    <message>
        <source>ABSENT</source>
        <translation>FEHLT</translation>
    </message>
    <message>
        <source>ENDED</source>
        <translation>ENDE</translation>
    </message>
    <message>
        <source>%1 has errors: check wires, terminators and bit rate</source>
        <translation>%1 hat Fehler: Kabel, Abschlüsse und Bitrate prüfen</translation>
    </message>
    <message>
        <source>WARNING</source>
        <translation>WARNUNG</translation>
    </message>
    <message>
        <source>%1: working</source>
        <translation>%1: in Betrieb</translation>
    </message>
    <message>
        <source>internal bus</source>
        <translation>interner Bus</translation>
    </message>
</context>
<context>
    <name>ComparisonWords</name>
    <message>
        <source>median error near [mm]</source>
        <translation>Medianfehler nah [mm]</translation>
    </message>
    <message>
        <source>mean error near [mm]</source>
        <translation>mittlerer Fehler nah [mm]</translation>
    </message>
    <message>
        <source>CRPS near [mm]</source>
        <translation>CRPS nah [mm]</translation>
    </message>
    <message>
        <source>80 % band near holds [%]</source>
        <translation>im 80-%-Band nah [%]</translation>
    </message>
    <message>
        <source>median error, all bins [mm]</source>
        <translation>Medianfehler, alle [mm]</translation>
    </message>
    <message>
        <source>mean error, all bins [mm]</source>
        <translation>mittlerer Fehler, alle [mm]</translation>
    </message>
    <message>
        <source>CRPS, all bins [mm]</source>
        <translation>CRPS, alle [mm]</translation>
    </message>
    <message>
        <source>80 % band, all bins holds [%]</source>
        <translation>im 80-%-Band, alle [%]</translation>
    </message>
    <message>
        <source>Near the robot the new model has the same mean error as the old one on %1 scenes</source>
        <translation>Das neue Modell irrt nahe am Roboter so stark wie das alte (%1 Szenen)</translation>
    </message>
    <message>
        <source>Near the robot the new model&apos;s mean error is %1 % smaller on %2 scenes</source>
        <translation>Das neue Modell irrt nahe am Roboter %1 % weniger (%2 Szenen)</translation>
    </message>
    <message>
        <source>Near the robot the new model&apos;s mean error is %1 % larger on %2 scenes</source>
        <translation>Das neue Modell irrt nahe am Roboter %1 % mehr (%2 Szenen)</translation>
    </message>
    <message>
        <source>%1; its 80 % bands there cover %2 % of the true heights, the old model&apos;s %3 %.</source>
        <translation>%1; seine 80-%-Bänder enthalten dort %2 % der wahren Höhen, die des alten %3 %.</translation>
    </message>
    <message>
        <source>Too few drives: the difference may be chance.</source>
        <translation>Zu wenige Fahrten, um zu sagen, ob der Unterschied Zufall ist.</translation>
    </message>
    <message>
        <source>The difference may be chance: 95 % interval %1 … %2 mm.</source>
        <translation>Der Unterschied kann Zufall sein: 95-%-Intervall %1 … %2 mm.</translation>
    </message>
    <message>
        <source>%1 of the file&apos;s %2 scenes, evenly picked.</source>
        <translation>%1 von %2 Szenen der Datei, gleichmäßig gewählt.</translation>
    </message>
    <message>
        <source>%1 scenes left out that only one model or none could estimate (only the old %2, only the new %3): %4.</source>
        <translation>%1 Szenen ausgelassen, die nur ein Modell oder keines schätzen konnte (nur das alte %2, nur das neue %3): %4.</translation>
    </message>
    <message>
        <source>The new model was trained on %1 of these %2 scenes or near copies, so its error looks too small. Choose scenes it has not seen.</source>
        <translation>Das neue Modell hat %1 dieser %2 Szenen oder Beinahe-Kopien davon gelernt, daher wirkt sein Fehler zu klein. Szenen wählen, die es nicht kennt.</translation>
    </message>
    <message>
        <source>The old model was trained on %1 of these %2 scenes or near copies, so its error looks too small.</source>
        <translation>Das alte Modell hat %1 dieser %2 Szenen oder Beinahe-Kopien davon gelernt, daher wirkt sein Fehler zu klein.</translation>
    </message>
</context>
<context>
    <name>DriveText</name>
    <message>
        <source>! STEEP</source>
        <translation>! STEIL</translation>
    </message>
    <message>
        <source>✘ DANGER</source>
        <translation>✘ GEFAHR</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>rear %1</source>
        <translation>hinten %1</translation>
    </message>
    <message>
        <source>rear %1 %2: %3 N</source>
        <translation>hinten %1 %2: %3 N</translation>
    </message>
    <message>
        <source>%1 %2: %3 N</source>
        <translation>%1 %2: %3 N</translation>
    </message>
    <message>
        <source>front %1: %2 N</source>
        <translation>vorn %1: %2 N</translation>
    </message>
</context>
<context>
    <name>FileDialog</name>
    <message>
        <source>There is no file:</source>
        <translation>Keine Datei:</translation>
    </message>
</context>
<context>
    <name>FileHeader</name>
    <message>
        <source>no link: a file</source>
        <translation>keine Verbindung: eine Datei</translation>
    </message>
    <message>
        <source>robot: --</source>
        <translation>Roboter: --</translation>
    </message>
    <message>
        <source>model: --</source>
        <translation>Modell: --</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>more than %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>unter %1</translation>
    </message>
</context>
<context>
    <name>Gamepad</name>
    <message>
        <source>no gamepad is read, because SDL cannot start: %1</source>
        <translation>kein Gamepad wird gelesen, weil SDL nicht startet: %1</translation>
    </message>
    <message>
        <source>“%1” is not used, because SDL knows no layout of it: set SDL_GAMECONTROLLERCONFIG, or use another gamepad</source>
        <translation>„%1“ wird nicht verwendet, weil SDL seine Belegung nicht kennt: SDL_GAMECONTROLLERCONFIG setzen oder ein anderes Gamepad verwenden</translation>
    </message>
</context>
<context>
    <name>KeyTable</name>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>%1, held</source>
        <translation>%1, halten</translation>
    </message>
</context>
<context>
    <name>Letters</name>
    <message>
        <source>%1 % wanted, %2 % fits this screen</source>
        <translation>%1 % gewählt, %2 % passt auf diesen Bildschirm</translation>
    </message>
</context>
<context>
    <name>LinkStatus</name>
    <message>
        <source>link %1 Hz · ≤ %2</source>
        <translation>Link %1 Hz · ≤ %2</translation>
    </message>
    <message>
        <source> · %1 dropped</source>
        <translation> · %1 verloren</translation>
    </message>
    <message>
        <source>%1
%2 frames/s, %3
%4 frames dropped by this computer, %5 error frames</source>
        <translation>%1
%2 Rahmen/s, %3
%4 Rahmen von diesem Rechner verloren, %5 Fehlerrahmen</translation>
    </message>
    <message>
        <source>robot: --</source>
        <translation>Roboter: --</translation>
    </message>
    <message>
        <source>the robot is armed</source>
        <translation>der Roboter ist freigegeben</translation>
    </message>
    <message>
        <source>not armed: %1</source>
        <translation>nicht freigegeben: %1</translation>
    </message>
    <message>
        <source>log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>! %1 dropped</source>
        <translation>! %1 verloren</translation>
    </message>
    <message>
        <source>! %1 errors</source>
        <translation>! %1 Fehler</translation>
    </message>
    <message>
        <source>%1 dropped</source>
        <translation>%1 verloren</translation>
    </message>
    <message>
        <source>%1 errors</source>
        <translation>%1 Fehler</translation>
    </message>
    <message>
        <source>back, not steady yet</source>
        <translation>wieder da, noch nicht stetig</translation>
    </message>
    <message>
        <source>%1 — gaps: %2, the longest %3; values read -- during a gap</source>
        <translation>%1 — Lücken: %2, die längste %3; in jeder stehen Werte auf --</translation>
    </message>
    <message>
        <source>%1 for %2 — %3; no measured value is live%4</source>
        <translation>%1 seit %2 — %3; kein Messwert ist aktuell%4</translation>
    </message>
    <message>
        <source>%1 for %2 — nothing on this screen is live%3</source>
        <translation>%1 seit %2 — nichts auf diesem Schirm ist aktuell%3</translation>
    </message>
    <message>
        <source>%1; gaps before: %2, the longest %3</source>
        <translation>%1; Lücken davor: %2, die längste %3</translation>
    </message>
    <message>
        <source>disarmed: %1</source>
        <translation>nicht mehr freigegeben: %1</translation>
    </message>
    <message>
        <source>link ≤ %1</source>
        <translation>Link ≤ %1</translation>
    </message>
    <message>
        <source>LINK RESTORED after %1 — values are live; the terrain predates the gap</source>
        <translation>WIEDER DA nach %1 — Messwerte sind aktuell, das Gelände ist das von vorher</translation>
    </message>
</context>
<context>
    <name>LiveViewState</name>
    <message>
        <source>The operator&apos;s panel does not answer: STOP is asserted</source>
        <translation>Das Bedienpult antwortet nicht, das heißt STOP</translation>
    </message>
    <message>
        <source>The operator&apos;s panel does not answer</source>
        <translation>Das Bedienpult antwortet nicht</translation>
    </message>
</context>
<context>
    <name>MeasuredLine</name>
    <message>
        <source>%1 apart · rise and slope unknown: not felt</source>
        <translation>Abstand %1 · Anstieg und Neigung unbekannt: nicht ertastet</translation>
    </message>
    <message>
        <source>%1 apart · rise %2 · slope %3</source>
        <translation>Abstand %1 · Anstieg %2 · Neigung %3</translation>
    </message>
    <message>
        <source>rear</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
</context>
<context>
    <name>MethodText</name>
    <message>
        <source>uses pitch and flipper angles; Markov chains</source>
        <translation>nutzt Nickwinkel und Flipperwinkel; Markow-Ketten</translation>
    </message>
    <message>
        <source>uses pitch, flipper angles and body; Markov chains</source>
        <translation>nutzt Nickwinkel, Flipperwinkel und Rumpf; Markow-Ketten</translation>
    </message>
    <message>
        <source>uses what pac uses, forces and currents; Markov chains</source>
        <translation>nutzt, was pac nutzt, dazu Kräfte und Ströme; Markow-Ketten</translation>
    </message>
    <message>
        <source>uses what pafc uses, and the arm; Markov chains</source>
        <translation>nutzt, was pafc nutzt, dazu den Arm; Markow-Ketten</translation>
    </message>
    <message>
        <source>uses what pafc uses, and models the clearance; Markov chains</source>
        <translation>nutzt, was pafc nutzt, und modelliert den Abstand; Markow-Ketten</translation>
    </message>
    <message>
        <source>uses pose, forces, currents and clearance; closed form</source>
        <translation>nutzt Pose, Kräfte, Ströme und Abstand; geschlossene Formel</translation>
    </message>
    <message>
        <source>uses what joint uses, and the most similar scenes; closed form</source>
        <translation>nutzt, was joint nutzt, dazu die ähnlichsten Szenen; geschlossene Formel</translation>
    </message>
    <message>
        <source>uses what local uses, and the way before; closed form</source>
        <translation>nutzt, was local nutzt, dazu den Weg davor; geschlossene Formel</translation>
    </message>
</context>
<context>
    <name>ModelWords</name>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>trained %1; ground: %2</source>
        <translation>gelernt %1; Gelände: %2</translation>
    </message>
    <message>
        <source>%1 scenes, %2 % with a step above %3; median relief %4</source>
        <translation>%1 Szenen, davon %2 % mit einer Stufe über %3; Höhenunterschied im Median %4</translation>
    </message>
    <message>
        <source>%1: mean error %2 mm, the 80 % band holds %3 % – %4 scenes of %5, %6</source>
        <translation>%1: mittlerer Fehler %2 mm, das 80-%-Band enthält %3 % – %4 Szenen aus %5, %6</translation>
    </message>
    <message>
        <source> – the scenes it was trained on</source>
        <translation> – die Szenen, aus denen es gelernt hat</translation>
    </message>
    <message>
        <source>never evaluated: its errors are unknown</source>
        <translation>nie bewertet: seine Fehler sind unbekannt</translation>
    </message>
    <message>
        <source>its card is not used: %1</source>
        <translation>seine Karte wird nicht benutzt: %1</translation>
    </message>
    <message>
        <source>content %1; scenes %2</source>
        <translation>Inhalt %1; Szenen %2</translation>
    </message>
    <message>
        <source>made by: %1</source>
        <translation>gemacht mit: %1</translation>
    </message>
    <message>
        <source> – %1 of them are training scenes or near copies</source>
        <translation> – %1 davon sind Trainingsszenen oder Beinahe-Kopien</translation>
    </message>
</context>
<context>
    <name>OpenConsole</name>
    <message>
        <source>not connected: %1</source>
        <translation>nicht verbunden: %1</translation>
    </message>
    <message>
        <source>%1. The former connection failed, too: %2. This is the simulated robot</source>
        <translation>%1. Auch die vorige Verbindung scheiterte: %2. Dies ist der simulierte Roboter</translation>
    </message>
</context>
<context>
    <name>OpenFile</name>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>%1 could not be opened: a second window could not be started</source>
        <translation>%1 ließ sich nicht öffnen: das Programm ließ sich nicht noch einmal starten</translation>
    </message>
    <message>
        <source>Sessions, logs, scenes, truth files and recordings of other programs (*.tts *.log *.asc *.trc *.csv *.gz *.truth *.mcap *.bag *.db3);;All files (*)</source>
        <translation>Sitzungen, Logs, Szenen, Wahrheitsdateien und Aufzeichnungen anderer Programme (*.tts *.log *.asc *.trc *.csv *.gz *.truth *.mcap *.bag *.db3);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>PadText</name>
    <message>
        <source>A (lower)</source>
        <translation>A (unten)</translation>
    </message>
    <message>
        <source>B (right)</source>
        <translation>B (rechts)</translation>
    </message>
    <message>
        <source>X (left)</source>
        <translation>X (links)</translation>
    </message>
    <message>
        <source>Y (upper)</source>
        <translation>Y (oben)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Taste Back</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Taste Guide</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Taste Start</translation>
    </message>
    <message>
        <source>left stick, pressed</source>
        <translation>linker Stick, gedrückt</translation>
    </message>
    <message>
        <source>right stick, pressed</source>
        <translation>rechter Stick, gedrückt</translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation>linke Schultertaste</translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation>rechte Schultertaste</translation>
    </message>
    <message>
        <source>cross, up</source>
        <translation>Kreuz, oben</translation>
    </message>
    <message>
        <source>cross, down</source>
        <translation>Kreuz, unten</translation>
    </message>
    <message>
        <source>cross, left</source>
        <translation>Kreuz, links</translation>
    </message>
    <message>
        <source>cross, right</source>
        <translation>Kreuz, rechts</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>STOP, second control</source>
        <translation>STOP, zweites Element</translation>
    </message>
    <message>
        <source>dead-man control (hold)</source>
        <translation>Totmannschalter (halten)</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>fahren</translation>
    </message>
    <message>
        <source>feel forward (hold)</source>
        <translation>vorwärts tasten (halten)</translation>
    </message>
    <message>
        <source>explore</source>
        <translation>erkunden</translation>
    </message>
    <message>
        <source>approve the probe (hold)</source>
        <translation>Sonde genehmigen (halten)</translation>
    </message>
    <message>
        <source>refuse the probe</source>
        <translation>Sonde ablehnen</translation>
    </message>
    <message>
        <source>raise the step limit</source>
        <translation>Stufengrenze erhöhen</translation>
    </message>
    <message>
        <source>lower the step limit</source>
        <translation>Stufengrenze senken</translation>
    </message>
    <message>
        <source>dead-man</source>
        <translation>Totmann</translation>
    </message>
    <message>
        <source>feel forward</source>
        <translation>vorwärts tasten</translation>
    </message>
    <message>
        <source>approve</source>
        <translation>genehmigen</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>ablehnen</translation>
    </message>
    <message>
        <source>limit up</source>
        <translation>Grenze höher</translation>
    </message>
    <message>
        <source>limit down</source>
        <translation>Grenze tiefer</translation>
    </message>
    <message>
        <source>left stick, sideways</source>
        <translation>linker Stick, seitwärts</translation>
    </message>
    <message>
        <source>left stick, up and down</source>
        <translation>linker Stick, auf und ab</translation>
    </message>
    <message>
        <source>right stick, sideways</source>
        <translation>rechter Stick, seitwärts</translation>
    </message>
    <message>
        <source>right stick, up and down</source>
        <translation>rechter Stick, auf und ab</translation>
    </message>
    <message>
        <source>left trigger</source>
        <translation>linker Trigger</translation>
    </message>
    <message>
        <source>right trigger</source>
        <translation>rechter Trigger</translation>
    </message>
</context>
<context>
    <name>PastText</name>
    <message>
        <source>no verdict</source>
        <translation>kein Urteil</translation>
    </message>
    <message>
        <source>%1 for steps above %2</source>
        <translation>%1 für Stufen über %2</translation>
    </message>
    <message>
        <source>%1 for steps above %2 (left %3, right %4)</source>
        <translation>%1 für Stufen über %2 (links %3, rechts %4)</translation>
    </message>
    <message>
        <source>press and probe, method %1</source>
        <translation>Andrücken und Sondieren, Methode %1</translation>
    </message>
    <message>
        <source>press, method %1</source>
        <translation>Andrücken, Methode %1</translation>
    </message>
    <message>
        <source>error %1 against the truth</source>
        <translation>Fehler %1 gegen die Wahrheit</translation>
    </message>
    <message>
        <source>error left %1, right %2 against the truth</source>
        <translation>Fehler links %1, rechts %2 gegen die Wahrheit</translation>
    </message>
    <message>
        <source>error %1 %2, measured later by the arm</source>
        <translation>Fehler %1 %2, später vom Arm gemessen</translation>
    </message>
    <message>
        <source>error not known</source>
        <translation>Fehler nicht bekannt</translation>
    </message>
    <message>
        <source>shown: estimate of %1, not the present one</source>
        <translation>gezeigt: Schätzung von %1, nicht die jetzige</translation>
    </message>
</context>
<context>
    <name>Place</name>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>left at %1</source>
        <translation>links bei %1</translation>
    </message>
    <message>
        <source>right at %1</source>
        <translation>rechts bei %1</translation>
    </message>
    <message>
        <source>bin %1</source>
        <translation>Feld %1</translation>
    </message>
    <message>
        <source>left bin %1</source>
        <translation>linkes Feld %1</translation>
    </message>
    <message>
        <source>right bin %1</source>
        <translation>rechtes Feld %1</translation>
    </message>
</context>
<context>
    <name>PlanarGround</name>
    <message>
        <source>roll %1: left and right ground differ</source>
        <translation>Rollen %1: Boden links und rechts verschieden</translation>
    </message>
    <message>
        <source>left and right flippers differ by %1</source>
        <translation>linker und rechter Flipper weichen um %1 ab</translation>
    </message>
    <message>
        <source>left and right agree, roll is small</source>
        <translation>links und rechts gleich, Rollen klein</translation>
    </message>
    <message>
        <source>the roll is small again</source>
        <translation>das Rollen ist wieder klein</translation>
    </message>
    <message>
        <source>left and right flippers agree again</source>
        <translation>linke und rechte Flipper stimmen wieder überein</translation>
    </message>
    <message>
        <source>%1, more than what was overridden</source>
        <translation>%1, mehr als übergangen wurde</translation>
    </message>
    <message>
        <source>the track differential has turned by %1</source>
        <translation>das Kettendifferential ist um %1 verdreht</translation>
    </message>
    <message>
        <source>the track differential is back</source>
        <translation>das Kettendifferential ist zurückgedreht</translation>
    </message>
</context>
<context>
    <name>Preconditions</name>
    <message>
        <source>telemetry is live</source>
        <translation>Telemetrie läuft</translation>
    </message>
    <message>
        <source>the log has ended</source>
        <translation>das Log ist zu Ende</translation>
    </message>
    <message>
        <source>no telemetry from the robot</source>
        <translation>keine Telemetrie vom Roboter</translation>
    </message>
    <message>
        <source>STOP is not latched</source>
        <translation>STOP ist nicht eingerastet</translation>
    </message>
    <message>
        <source>STOP: release sent, not yet confirmed by the robot</source>
        <translation>STOP: Lösen gesendet, vom Roboter noch nicht bestätigt</translation>
    </message>
    <message>
        <source>STOP is latched</source>
        <translation>STOP ist eingerastet</translation>
    </message>
    <message>
        <source>the robot is armed</source>
        <translation>der Roboter ist freigegeben</translation>
    </message>
    <message>
        <source>no model: %1</source>
        <translation>kein Modell: %1</translation>
    </message>
    <message>
        <source>the model is being loaded</source>
        <translation>das Modell wird geladen</translation>
    </message>
    <message>
        <source>model %1 is ready</source>
        <translation>Modell %1 ist bereit</translation>
    </message>
    <message>
        <source>STOP is latched: release it first</source>
        <translation>STOP ist eingerastet: erst lösen</translation>
    </message>
    <message>
        <source>An exploration is running: end it with Esc first</source>
        <translation>Eine Erkundung läuft: erst mit Esc beenden</translation>
    </message>
    <message>
        <source>nothing is being explored</source>
        <translation>keine Erkundung läuft</translation>
    </message>
    <message>
        <source>scene, settings and model are unchanged since the question</source>
        <translation>Szene, Einstellungen und Modell sind die der Frage</translation>
    </message>
    <message>
        <source>scene, settings or model have changed since the question</source>
        <translation>Szene, Einstellungen oder Modell haben sich seit der Frage geändert</translation>
    </message>
    <message>
        <source>the robot reports stopped</source>
        <translation>der Roboter meldet, dass er gestoppt ist</translation>
    </message>
    <message>
        <source>the robot has not confirmed STOP</source>
        <translation>der Roboter hat STOP nicht bestätigt</translation>
    </message>
    <message>
        <source>there is no STOP to release</source>
        <translation>es gibt kein STOP zu lösen</translation>
    </message>
    <message>
        <source>STOP: not known, no telemetry</source>
        <translation>STOP: nicht bekannt, keine Telemetrie</translation>
    </message>
    <message>
        <source>left, right: not known, no telemetry</source>
        <translation>links, rechts: nicht bekannt, keine Telemetrie</translation>
    </message>
    <message>
        <source>the robot reported stopped, then telemetry ended</source>
        <translation>der Roboter meldete, dass er steht, dann keine Telemetrie</translation>
    </message>
    <message>
        <source>the link was lost, the robot may have moved: explore again</source>
        <translation>die Verbindung war verloren, der Roboter kann sich bewegt haben: neu erkunden</translation>
    </message>
    <message>
        <source>No probe: the pitch may be wrong, and the arm would touch another place</source>
        <translation>Keine Sonde: der Nickwinkel ist vielleicht falsch, und der Arm würde eine andere Stelle berühren</translation>
    </message>
    <message>
        <source>the arm is still out: wait until it is back, or press STOP</source>
        <translation>der Arm ist noch draußen: warten, bis er zurück ist, oder STOP drücken</translation>
    </message>
    <message>
        <source>pitch or roll is beyond the tip-over angle: bring the robot back onto its tracks first</source>
        <translation>Nick- oder Rollwinkel liegt jenseits des Kippwinkels: erst den Roboter wieder auf seine Ketten bringen</translation>
    </message>
    <message>
        <source>left and right are estimated separately</source>
        <translation>links und rechts werden getrennt geschätzt</translation>
    </message>
    <message>
        <source>the robot reports odometry</source>
        <translation>der Roboter meldet Odometrie</translation>
    </message>
    <message>
        <source>the robot reports no odometry</source>
        <translation>der Roboter meldet keinen zurückgelegten Weg</translation>
    </message>
    <message>
        <source>no open question</source>
        <translation>keine offene Frage</translation>
    </message>
</context>
<context>
    <name>PreferenceText</name>
    <message>
        <source>theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>size of text</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>alarms may be heard</source>
        <translation>Alarme dürfen ertönen</translation>
    </message>
    <message>
        <source>sound of contacts</source>
        <translation>Ton der Kontakte</translation>
    </message>
    <message>
        <source>step limit</source>
        <translation>Stufengrenze</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>time limit of an estimate</source>
        <translation>Zeitgrenze einer Schätzung</translation>
    </message>
    <message>
        <source>contact force</source>
        <translation>Kontaktkraft</translation>
    </message>
    <message>
        <source>the arm is offered</source>
        <translation>Arm wird angeboten</translation>
    </message>
    <message>
        <source>the arm is offered above a sd of</source>
        <translation>Arm wird angeboten ab einer Std.-Abw. von</translation>
    </message>
    <message>
        <source>roll limit of the verdict</source>
        <translation>Rollgrenze des Urteils</translation>
    </message>
    <message>
        <source>rate of hazards</source>
        <translation>Häufigkeit von Gefahren</translation>
    </message>
    <message>
        <source>flipper difference limit of the verdict</source>
        <translation>Grenze der Flipperdifferenz des Urteils</translation>
    </message>
    <message>
        <source>tilt limit, amber</source>
        <translation>Neigungsgrenze, gelb</translation>
    </message>
    <message>
        <source>tilt limit, red</source>
        <translation>Neigungsgrenze, rot</translation>
    </message>
    <message>
        <source>everything is recorded</source>
        <translation>alles wird aufgezeichnet</translation>
    </message>
    <message>
        <source>delete a session after</source>
        <translation>Sitzung löschen nach</translation>
    </message>
    <message>
        <source>delete the oldest beyond</source>
        <translation>älteste löschen über</translation>
    </message>
    <message>
        <source>sessions may be deleted</source>
        <translation>Sitzungen dürfen gelöscht werden</translation>
    </message>
    <message>
        <source>model file</source>
        <translation>Modelldatei</translation>
    </message>
    <message>
        <source>robot file, with its torques</source>
        <translation>Roboterdatei mit ihren Drehmomenten</translation>
    </message>
    <message>
        <source>DBC files</source>
        <translation>DBC-Dateien</translation>
    </message>
    <message>
        <source>controls of the gamepad</source>
        <translation>Bedienelemente des Gamepads</translation>
    </message>
    <message>
        <source>dead zone of the gamepad</source>
        <translation>Totzone des Gamepads</translation>
    </message>
    <message>
        <source>speed limit of the gamepad</source>
        <translation>Geschwindigkeitsgrenze des Gamepads</translation>
    </message>
    <message>
        <source>saved sets of plots</source>
        <translation>gespeicherte Diagrammsätze</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>%1, forward −</source>
        <translation>%1, vorwärts −</translation>
    </message>
    <message>
        <source>%1, forward +</source>
        <translation>%1, vorwärts +</translation>
    </message>
    <message>
        <source>gamepad: %1</source>
        <translation>Gamepad: %1</translation>
    </message>
    <message>
        <source>unit of lengths</source>
        <translation>Einheit der Längen</translation>
    </message>
    <message>
        <source>unit of angles</source>
        <translation>Einheit der Winkel</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>Preferences: %1; the shipped robot is used</source>
        <translation>Einstellungen: %1; der mitgelieferte Roboter wird verwendet</translation>
    </message>
    <message>
        <source>Preferences: “%1” is no valid %2, its default is used</source>
        <translation>Einstellungen: „%1“ ist kein gültiger Wert für %2, der Standard gilt</translation>
    </message>
    <message>
        <source>Preferences: %1; the file is set aside as %2, defaults are used</source>
        <translation>Einstellungen: %1; die Datei liegt nun als %2, es gelten die Standardwerte</translation>
    </message>
    <message>
        <source>Preferences: %1; defaults are used and nothing is saved</source>
        <translation>Einstellungen: %1; es gelten die Standardwerte, nichts wird gespeichert</translation>
    </message>
    <message>
        <source>Preferences: %1 is no file; defaults are used and nothing is saved</source>
        <translation>Einstellungen: %1 ist keine Datei; es gelten die Standardwerte, nichts wird gespeichert</translation>
    </message>
    <message>
        <source>Preferences: %1 cannot be read; defaults are used and nothing is saved</source>
        <translation>Einstellungen: %1 ist nicht lesbar; es gelten die Standardwerte, nichts wird gespeichert</translation>
    </message>
    <message>
        <source>%1 is too large</source>
        <translation>%1 ist zu groß</translation>
    </message>
    <message>
        <source>%1 is not understood</source>
        <translation>%1 ist nicht verständlich</translation>
    </message>
    <message>
        <source>Preferences: %1 was written by a newer version; defaults are used and nothing is saved</source>
        <translation>Einstellungen: %1 stammt von einer neueren Version; es gelten die Standardwerte, nichts wird gespeichert</translation>
    </message>
    <message>
        <source>Preferences: %1 cannot be written</source>
        <translation>Einstellungen: %1 kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Preferences: %1 cannot be read; the shipped model is used</source>
        <translation>Einstellungen: %1 ist nicht lesbar; das mitgelieferte Modell wird verwendet</translation>
    </message>
    <message>
        <source>Preferences: %1; nothing is saved</source>
        <translation>Einstellungen: %1; nichts wird gespeichert</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>en, cs, de or nothing</source>
        <translation>en, cs, de oder nichts</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>der Pfad einer Datei</translation>
    </message>
    <message>
        <source>paths of at most %1 files</source>
        <translation>Pfade von höchstens %1 Dateien</translation>
    </message>
    <message>
        <source>controls of a gamepad as this program writes them</source>
        <translation>Bedienelemente eines Gamepads, wie dieses Programm sie schreibt</translation>
    </message>
    <message>
        <source>at most %1 lines</source>
        <translation>höchstens %1 Zeilen</translation>
    </message>
    <message>
        <source>a window geometry in base64</source>
        <translation>eine Fenstergeometrie in Base64</translation>
    </message>
    <message>
        <source>a setting of this version</source>
        <translation>eine Einstellung dieser Version</translation>
    </message>
    <message>
        <source>Preferences: method is now %1, the default; before, it was %2</source>
        <translation>Einstellungen: Die Methode ist nun %1, der Standard; vorher war es %2</translation>
    </message>
    <message>
        <source>Preferences: there is no home folder to save them in: set HOME or XDG_CONFIG_HOME</source>
        <translation>Einstellungen: es gibt keinen Benutzerordner, um sie zu speichern: HOME oder XDG_CONFIG_HOME setzen</translation>
    </message>
</context>
<context>
    <name>PresetWords</name>
    <message>
        <source>%1: not measured (terratact tradeoff)</source>
        <translation>%1: nicht gemessen (terratact tradeoff)</translation>
    </message>
    <message>
        <source>%1: %2 ms, exact quantiles by a formula, mean error %3 mm</source>
        <translation>%1: %2 ms, exakte Quantile aus einer Formel, mittlerer Fehler %3 mm</translation>
    </message>
    <message>
        <source>%1: %2 ms, quantiles ± %3 mm from a long run, mean error %4 mm; chains converge in %5 % of scenes, and only these have a verdict</source>
        <translation>%1: %2 ms, Quantile ± %3 mm von einem langen Lauf, mittlerer Fehler %4 mm; die Ketten konvergieren in %5 % der Szenen, sonst gibt es kein Urteil</translation>
    </message>
    <message>
        <source>%1: not measured</source>
        <translation>%1: nicht gemessen</translation>
    </message>
    <message>
        <source>%1: %2 ms, %3 mm (exact)</source>
        <translation>%1: %2 ms, %3 mm (exakt)</translation>
    </message>
    <message>
        <source>%1: %2 ms, %3 mm (± %4 mm), %5 % converge</source>
        <translation>%1: %2 ms, %3 mm (± %4 mm), %5 % konvergieren</translation>
    </message>
</context>
<context>
    <name>ProbeNotice</name>
    <message>
        <source>arm? %1</source>
        <translation>Sonde? %1</translation>
    </message>
    <message>
        <source>PROBE at %1? Refused in %2 unless approved: F2 shows the question</source>
        <translation>SONDIERUNG bei %1? Noch %2, dann nein: F2 zeigt die Frage</translation>
    </message>
    <message>
        <source>The probe was not answered in time and counts as refused: F2 shows the result</source>
        <translation>Die Sondierung wurde nicht rechtzeitig beantwortet, das heißt nein: F2 zeigt das Ergebnis</translation>
    </message>
    <message>
        <source>PROBE at %1? Refused in %2 unless approved: close the window that covers it</source>
        <translation>SONDIERUNG bei %1? Noch %2, dann nein: das Fenster schließen, das die Frage verdeckt</translation>
    </message>
    <message>
        <source>The probe was not answered in time and counts as refused: close the window that covers the result</source>
        <translation>Die Sondierung wurde nicht rechtzeitig beantwortet, das heißt nein: das Fenster schließen, das das Ergebnis verdeckt</translation>
    </message>
    <message>
        <source>halting</source>
        <translation>hält an</translation>
    </message>
    <message>
        <source>pressing</source>
        <translation>drückt an</translation>
    </message>
    <message>
        <source>estimating</source>
        <translation>schätzt</translation>
    </message>
    <message>
        <source>probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>misslungen</translation>
    </message>
    <message>
        <source>arm: void</source>
        <translation>Arm: ungültig</translation>
    </message>
    <message>
        <source>The proposed probe is void: F2 shows the reason</source>
        <translation>Die vorgeschlagene Sondierung ist ungültig: F2 zeigt den Grund</translation>
    </message>
    <message>
        <source>advancing</source>
        <translation>rückt vor</translation>
    </message>
</context>
<context>
    <name>ProbeProposals</name>
    <message>
        <source>no probe: the arm measures no height</source>
        <translation>keine Sonde: der Arm misst keine Höhe</translation>
    </message>
    <message>
        <source>the gain of a probe is being computed</source>
        <translation>der Gewinn einer Sondierung wird berechnet</translation>
    </message>
    <message>
        <source>no probe: no bin in reach is left</source>
        <translation>keine Sonde: kein Feld in Reichweite ist übrig</translation>
    </message>
</context>
<context>
    <name>RecordingDisplay</name>
    <message>
        <source>NOT RECORDED: %1</source>
        <translation>NICHT AUFGEZEICHNET: %1</translation>
    </message>
    <message>
        <source>Recorded: %1
%2 frames, %3 MB; %4 frames dropped
A click marks this moment (K)</source>
        <translation>Aufgezeichnet: %1
%2 Rahmen, %3 MB; für %4 Rahmen war kein Platz
Ein Klick markiert diesen Augenblick (K)</translation>
    </message>
    <message>
        <source>Nothing is recorded</source>
        <translation>Es wird nichts aufgezeichnet</translation>
    </message>
    <message>
        <source>✕ NOT
RECORDED</source>
        <translation>✕ OHNE
AUFZEICHN.</translation>
    </message>
    <message>
        <source>○ not
recorded</source>
        <translation>○ ohne
Aufzeichn.</translation>
    </message>
    <message>
        <source>● REC
mark K</source>
        <translation>● REC
Marke K</translation>
    </message>
    <message>
        <source>Not recorded</source>
        <translation>Nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>Recording; mark this moment</source>
        <translation>Aufzeichnung läuft; diesen Augenblick markieren</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>en</source>
        <translation>de</translation>
    </message>
    <message>
        <source>error against the truth: %1 m rms, %2 m at %3 m, %4 of %5 bins in their band</source>
        <translation>Fehler gegen die Wahrheit: %1 m (quadratisches Mittel), %2 m bei %3 m, %4 von %5 Feldern in ihrem Band</translation>
    </message>
    <message>
        <source>%1. Left: %2. Right: %3. Either side: %4 %. Cross slope: %5</source>
        <translation>%1. Links: %2. Rechts: %3. Eine der Seiten: %4 %. Quergefälle: %5</translation>
    </message>
    <message>
        <source>estimate %1 of scene %2 (second method)</source>
        <translation>Schätzung %1 der Szene %2 (zweite Methode)</translation>
    </message>
    <message>
        <source>estimate %1 of scene %2 (with the reading of the arm)</source>
        <translation>Schätzung %1 der Szene %2 (mit der Messung des Arms)</translation>
    </message>
    <message>
        <source>estimate %1 of scene %2</source>
        <translation>Schätzung %1 der Szene %2</translation>
    </message>
    <message>
        <source>no verdict: its scene is damaged</source>
        <translation>kein Urteil: die Szene ist beschädigt</translation>
    </message>
    <message>
        <source>method %1, %2 s</source>
        <translation>Methode %1, %2 s</translation>
    </message>
    <message>
        <source>arm: %1</source>
        <translation>Arm: %1</translation>
    </message>
    <message>
        <source>bin %1 m left</source>
        <translation>Feld %1 m links</translation>
    </message>
    <message>
        <source>bin %1 m right</source>
        <translation>Feld %1 m rechts</translation>
    </message>
    <message>
        <source>bin %1 m</source>
        <translation>Feld %1 m</translation>
    </message>
    <message>
        <source>%1: height %2 m, %3 m … %4 m, sd %5 m above the threshold %6 m</source>
        <translation>%1: Höhe %2 m, %3 m … %4 m, Standardabw. %5 m über der Schwelle %6 m</translation>
    </message>
    <message>
        <source>arm sd %1 m</source>
        <translation>Standardabw. des Arms %1 m</translation>
    </message>
    <message>
        <source>takes %1 s</source>
        <translation>dauert %1 s</translation>
    </message>
    <message>
        <source>step above %1 m: %2 bit open, %3 bit after it</source>
        <translation>Stufe über %1 m: %2 bit offen, danach %3 bit</translation>
    </message>
    <message>
        <source>step above %1 m: %2 bit open</source>
        <translation>Stufe über %1 m: %2 bit offen</translation>
    </message>
    <message>
        <source>probe proposed on estimate %1</source>
        <translation>Sondierung vorgeschlagen zu Schätzung %1</translation>
    </message>
    <message>
        <source>message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>exploration</source>
        <translation>Erkundung</translation>
    </message>
    <message>
        <source>arming</source>
        <translation>Freigabe</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>estimate void</source>
        <translation>Schätzung verfallen</translation>
    </message>
    <message>
        <source>telemetry gap</source>
        <translation>Telemetrielücke</translation>
    </message>
    <message>
        <source>override</source>
        <translation>Übergehen</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>Pult</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>contact closed</source>
        <translation>Kontakt geschlossen</translation>
    </message>
    <message>
        <source>contact open</source>
        <translation>Kontakt offen</translation>
    </message>
    <message>
        <source>longest gap %1 s</source>
        <translation>längste Lücke %1 s</translation>
    </message>
    <message>
        <source>proposal %1</source>
        <translation>Vorschlag %1</translation>
    </message>
    <message>
        <source>on the screen: %1</source>
        <translation>auf dem Schirm: %1</translation>
    </message>
    <message>
        <source>… and %1 more in the session</source>
        <translation>… und %1 weitere in der Sitzung</translation>
    </message>
    <message>
        <source>Decisions and their numbers</source>
        <translation>Entscheidungen und ihre Zahlen</translation>
    </message>
    <message>
        <source>Nothing was estimated and nobody decided anything.</source>
        <translation>Nichts wurde geschätzt und niemand hat etwas entschieden.</translation>
    </message>
    <message>
        <source>since start</source>
        <translation>seit Beginn</translation>
    </message>
    <message>
        <source>what</source>
        <translation>was</translation>
    </message>
    <message>
        <source>numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>No alarm was raised.</source>
        <translation>Es gab keinen Alarm.</translation>
    </message>
    <message>
        <source>raised</source>
        <translation>ausgelöst</translation>
    </message>
    <message>
        <source>acknowledged</source>
        <translation>quittiert</translation>
    </message>
    <message>
        <source>cause gone</source>
        <translation>Ursache weg</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>before the session</source>
        <translation>vor der Sitzung</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Active settings</source>
        <translation>Geltende Einstellungen</translation>
    </message>
    <message>
        <source>Settings of the estimates, from each change on. Other settings are recorded as decisions.</source>
        <translation>Einstellungen der Schätzungen, jeweils ab ihrer Änderung. Andere Einstellungen sind als Entscheidungen aufgezeichnet.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>ab</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>Schätzung</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>%1, step limit %2 m</source>
        <translation>%1, Stufengrenze %2 m</translation>
    </message>
    <message>
        <source>%1 (second)</source>
        <translation>%1 (zweite)</translation>
    </message>
    <message>
        <source>Nothing was estimated, so no settings are recorded.</source>
        <translation>Nichts wurde geschätzt, also sind keine Einstellungen aufgezeichnet.</translation>
    </message>
    <message>
        <source>nothing was estimated</source>
        <translation>nichts wurde geschätzt</translation>
    </message>
    <message>
        <source>%1 %2 (median %3 s)</source>
        <translation>%1 %2 (Median %3 s)</translation>
    </message>
    <message>
        <source>%1, bus %2, commands could be sent</source>
        <translation>%1, Bus %2, Befehle konnten gesendet werden</translation>
    </message>
    <message>
        <source>%1, bus %2, listened only</source>
        <translation>%1, Bus %2, nur mitgehört</translation>
    </message>
    <message>
        <source>decisions %1, of these stop %2, halt %3, abort %4; markers %5</source>
        <translation>Entscheidungen %1, davon Stop %2, Anhalten %3, Abbruch %4; Marken %5</translation>
    </message>
    <message>
        <source>The session</source>
        <translation>Die Sitzung</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>begins</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>ends</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>lasts</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>recorded by</source>
        <translation>aufgezeichnet von</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>yes, sealed</source>
        <translation>ja, versiegelt</translation>
    </message>
    <message>
        <source>NO: still being recorded, or its program died</source>
        <translation>NEIN: wird noch aufgezeichnet, oder ihr Programm brach ab</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>estimates</source>
        <translation>Schätzungen</translation>
    </message>
    <message>
        <source>%1 (scenes: %2); by method: %3</source>
        <translation>%1 (Szenen: %2); nach Methode: %3</translation>
    </message>
    <message>
        <source>probes</source>
        <translation>Sondierungen</translation>
    </message>
    <message>
        <source>proposed %1, approved %2, refused %3</source>
        <translation>vorgeschlagen %1, genehmigt %2, abgelehnt %3</translation>
    </message>
    <message>
        <source>Hashes</source>
        <translation>Hashes</translation>
    </message>
    <message>
        <source>Each hash is SHA-256. The last link of the chain proves the session if it is known from elsewhere.</source>
        <translation>Jeder Hash ist SHA-256. Das letzte Glied der Kette beweist die Sitzung, wenn es anderswoher bekannt ist.</translation>
    </message>
    <message>
        <source>result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>every hash holds: %1 batches, %2 frames, %3 events</source>
        <translation>alle Hashes stimmen: %1 Blöcke, %2 Rahmen, %3 Ereignisse</translation>
    </message>
    <message>
        <source>PARTS ARE NOT WHAT WAS RECORDED</source>
        <translation>TEILE SIND NICHT, WAS AUFGEZEICHNET WURDE</translation>
    </message>
    <message>
        <source>last link</source>
        <translation>letztes Glied</translation>
    </message>
    <message>
        <source>robot file</source>
        <translation>Roboterdatei</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>%1, %2, from %3 on</source>
        <translation>%1, %2, ab %3</translation>
    </message>
    <message>
        <source>networks</source>
        <translation>Netze</translation>
    </message>
    <message>
        <source>broken</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>nothing is proven from %1</source>
        <translation>nichts ist bewiesen ab %1</translation>
    </message>
    <message>
        <source>damage</source>
        <translation>Schaden</translation>
    </message>
    <message>
        <source>Every hash holds.</source>
        <translation>Alle Hashes stimmen.</translation>
    </message>
    <message>
        <source>PARTS ARE NOT WHAT WAS RECORDED: see Hashes. They are left out.</source>
        <translation>TEILE SIND NICHT, WAS AUFGEZEICHNET WURDE: siehe Hashes. Sie sind ausgelassen.</translation>
    </message>
    <message>
        <source>The session was not closed.</source>
        <translation>Die Sitzung wurde nicht geschlossen.</translation>
    </message>
    <message>
        <source>Mission report of %1</source>
        <translation>Einsatzbericht zu %1</translation>
    </message>
    <message>
        <source>%1 %2: %3, %4 s before</source>
        <translation>%1 %2: %3, %4 s davor</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>Nutzlast</translation>
    </message>
    <message>
        <source>method %1, %2 draws in %3 chains</source>
        <translation>Methode %1, %2 Ziehungen in %3 Ketten</translation>
    </message>
    <message>
        <source>! not converged</source>
        <translation>! nicht konvergiert</translation>
    </message>
    <message>
        <source>! (+%1 more) %2</source>
        <translation>! (+%1 weitere) %2</translation>
    </message>
    <message>
        <source>forward from the IMU [m]</source>
        <translation>vorwärts von der IMU [m]</translation>
    </message>
    <message>
        <source>height above the IMU [m]</source>
        <translation>Höhe über der IMU [m]</translation>
    </message>
    <message>
        <source>probe here</source>
        <translation>hier sondieren</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>0.1 to 0.9 quantile</source>
        <translation>Quantile 0.1 bis 0.9</translation>
    </message>
    <message>
        <source>ceiling by the body</source>
        <translation>Obergrenze durch den Rumpf</translation>
    </message>
    <message>
        <source>estimate before</source>
        <translation>Schätzung davor</translation>
    </message>
    <message>
        <source>truth</source>
        <translation>Wahrheit</translation>
    </message>
    <message>
        <source>%1 m at %2 m left (sd %3 mm)</source>
        <translation>%1 m bei %2 m links (Standardabw. %3 mm)</translation>
    </message>
    <message>
        <source>%1 m at %2 m right (sd %3 mm)</source>
        <translation>%1 m bei %2 m rechts (Standardabw. %3 mm)</translation>
    </message>
    <message>
        <source>%1 m at %2 m (sd %3 mm)</source>
        <translation>%1 m bei %2 m (Standardabw. %3 mm)</translation>
    </message>
    <message>
        <source>method %1</source>
        <translation>Methode %1</translation>
    </message>
    <message>
        <source>ceiling %1</source>
        <translation>Obergrenze %1</translation>
    </message>
    <message>
        <source>contacts %1</source>
        <translation>Kontakte %1</translation>
    </message>
    <message>
        <source>contact above %1 N</source>
        <translation>Kontakt ab %1 N</translation>
    </message>
    <message>
        <source>contact sd %1 m</source>
        <translation>Standardabw. eines Kontakts %1 m</translation>
    </message>
    <message>
        <source>at most %1 draws</source>
        <translation>höchstens %1 Ziehungen</translation>
    </message>
    <message>
        <source>at most %1 draws (all)</source>
        <translation>höchstens %1 Ziehungen (alle)</translation>
    </message>
    <message>
        <source>%1 chains</source>
        <translation>%1 Ketten</translation>
    </message>
    <message>
        <source>burn-in %1</source>
        <translation>Einschwingen %1</translation>
    </message>
    <message>
        <source>scan %1</source>
        <translation>Durchlauf %1</translation>
    </message>
    <message>
        <source>precision %1</source>
        <translation>Genauigkeit %1</translation>
    </message>
    <message>
        <source>inducing %1</source>
        <translation>Stützzeilen %1</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>Startwert %1</translation>
    </message>
    <message>
        <source>probe above %1 m</source>
        <translation>Sondierung ab %1 m</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1: a step ahead of more than %2 m has probability %3 %</source>
        <translation>%1: eine Stufe über %2 m voraus hat die Wahrscheinlichkeit %3 %</translation>
    </message>
    <message>
        <source>%1° (left higher) at %2 m; more than %3° to a side has probability %4 %</source>
        <translation>%1° (links höher) bei %2 m; mehr als %3° zu einer Seite hat die Wahrscheinlichkeit %4 %</translation>
    </message>
    <message>
        <source>left %1, right %2</source>
        <translation>links %1, rechts %2</translation>
    </message>
    <message>
        <source>pitch %1°, roll %2°; flippers front %3° %4°, rear %5° %6°; forces %7 N</source>
        <translation>Nickwinkel %1°, Rollwinkel %2°; Flipper vorn %3° %4°, hinten %5° %6°; Kräfte %7 N</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>either side</source>
        <translation>eine der Seiten</translation>
    </message>
    <message>
        <source>a step ahead of more than %1 m has probability %2 %</source>
        <translation>eine Stufe über %1 m voraus hat die Wahrscheinlichkeit %2 %</translation>
    </message>
    <message>
        <source>cross slope</source>
        <translation>Quergefälle</translation>
    </message>
    <message>
        <source>bin [m]</source>
        <translation>Feld [m]</translation>
    </message>
    <message>
        <source>height [m]</source>
        <translation>Höhe [m]</translation>
    </message>
    <message>
        <source>ceiling [m]</source>
        <translation>max. [m]</translation>
    </message>
    <message>
        <source>known by</source>
        <translation>bekannt durch</translation>
    </message>
    <message>
        <source>touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>truth [m]</source>
        <translation>wahr [m]</translation>
    </message>
    <message>
        <source>Scene %1 of %2</source>
        <translation>Szene %1 von %2</translation>
    </message>
    <message>
        <source>Estimate %1, %2</source>
        <translation>Schätzung %1, %2</translation>
    </message>
    <message>
        <source>%1, bus %2, recorded by %3</source>
        <translation>%1, Bus %2, aufgezeichnet von %3</translation>
    </message>
    <message>
        <source>captured</source>
        <translation>aufgenommen</translation>
    </message>
    <message>
        <source>%1, %2 after the session&apos;s start</source>
        <translation>%1, %2 nach Beginn der Sitzung</translation>
    </message>
    <message>
        <source>estimated</source>
        <translation>geschätzt</translation>
    </message>
    <message>
        <source>%1, in %2 s</source>
        <translation>%1, in %2 s</translation>
    </message>
    <message>
        <source>%1, in %2 s, sampling ended: %3</source>
        <translation>%1, in %2 s, Ziehen endete: %3</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschädigt</translation>
    </message>
    <message>
        <source>%1; last link of its chain %2</source>
        <translation>%1; letztes Glied der Kette %2</translation>
    </message>
    <message>
        <source>every hash holds</source>
        <translation>alle Hashes stimmen</translation>
    </message>
    <message>
        <source>warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>The operator decided nothing here</source>
        <translation>Der Bediener hat hier nichts entschieden</translation>
    </message>
    <message>
        <source>The operator</source>
        <translation>Der Bediener</translation>
    </message>
    <message>
        <source>Section %1 (%2), %3 to %4 m along the way</source>
        <translation>Abschnitt %1 (%2), %3 bis %4 m des Weges</translation>
    </message>
    <message>
        <source>newest estimate; all else is remembered</source>
        <translation>neueste Schätzung; alles andere ist gemerkt</translation>
    </message>
    <message>
        <source>along the way [m]</source>
        <translation>entlang des Weges [m]</translation>
    </message>
    <message>
        <source>left, with its 80 % band</source>
        <translation>links, mit dem 80-%-Band</translation>
    </message>
    <message>
        <source>right, with its 80 % band</source>
        <translation>rechts, mit dem 80-%-Band</translation>
    </message>
    <message>
        <source>both sides alike, with the 80 % band</source>
        <translation>beide Seiten gleich, mit dem 80-%-Band</translation>
    </message>
    <message>
        <source>touched by the arm</source>
        <translation>vom Arm berührt</translation>
    </message>
    <message>
        <source>felt by flipper or track</source>
        <translation>von Flipper oder Kette ertastet</translation>
    </message>
    <message>
        <source>felt in part</source>
        <translation>teils ertastet</translation>
    </message>
    <message>
        <source>bounded</source>
        <translation>begrenzt</translation>
    </message>
    <message>
        <source>not felt</source>
        <translation>nicht ertastet</translation>
    </message>
    <message>
        <source>not recorded how</source>
        <translation>nicht aufgezeichnet, wie</translation>
    </message>
    <message>
        <source>Ground of section %1 from %2 to %3 m along the way</source>
        <translation>Boden des Abschnitts %1 von %2 bis %3 m des Weges</translation>
    </message>
    <message>
        <source>Strip of felt ground</source>
        <translation>Streifen ertasteten Bodens</translation>
    </message>
    <message>
        <source>No ground is shown: nothing was estimated, or the robot reports no odometry.</source>
        <translation>Kein Boden gezeigt: nichts wurde geschätzt, oder der Roboter meldet keine Odometrie.</translation>
    </message>
    <message>
        <source>Ground: %1 m. Sections: %2. Heights are from the IMU at the first scene of a section; both axes have one scale. Bars reach from the 0.1 to the 0.9 quantile. At most the last %3 m are kept.</source>
        <translation>Boden: %1 m. Abschnitte: %2. Höhen gelten ab der IMU bei der ersten Szene eines Abschnitts; beide Achsen haben einen Maßstab. Balken reichen vom 0.1- zum 0.9-Quantil. Höchstens die letzten %3 m bleiben erhalten.</translation>
    </message>
    <message>
        <source>Strip of felt ground of a running drive</source>
        <translation>Streifen ertasteten Bodens einer laufenden Fahrt</translation>
    </message>
    <message>
        <source>Strip of felt ground of %1</source>
        <translation>Streifen ertasteten Bodens von %1</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>constrained</source>
        <translation>eingeschränkt</translation>
    </message>
    <message>
        <source>sampled</source>
        <translation>gezogen</translation>
    </message>
    <message>
        <source>prior only</source>
        <translation>nur Vorwissen</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>ertastet</translation>
    </message>
    <message>
        <source>remembered</source>
        <translation>gemerkt</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>converged</source>
        <translation>konvergiert</translation>
    </message>
    <message>
        <source>sweeps</source>
        <translation>Durchläufe</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>%1 (%2) to %3: %4</source>
        <translation>%1 (%2) bis %3: %4</translation>
    </message>
    <message>
        <source>%1: a step of more than %2 m up to there has probability %3 %</source>
        <translation>%1: eine Stufe über %2 m bis dorthin hat die Wahrscheinlichkeit %3 %</translation>
    </message>
    <message>
        <source>a step of more than %1 m up to each horizon has probability %2 %</source>
        <translation>eine Stufe über %1 m bis zum jeweiligen Horizont hat die Wahrscheinlichkeit %2 %</translation>
    </message>
    <message>
        <source>80 % bands held at later contacts</source>
        <translation>80-%-Bänder hielten bei späteren Kontakten</translation>
    </message>
    <message>
        <source>80 % bands held at later probes</source>
        <translation>80-%-Bänder hielten bei späteren Sondierungen</translation>
    </message>
    <message>
        <source>80 % bands held at later passes</source>
        <translation>80-%-Bänder hielten bei späteren Überfahrten</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>open: not felt</source>
        <translation>offen: nicht ertastet</translation>
    </message>
</context>
<context>
    <name>ReviewDifference</name>
    <message>
        <source>B − A: %1 s, pitch %2, front %3, rear %4, forces %5 N</source>
        <translation>B − A: %1 s, Nicken %2, vorn %3, hinten %4, Kräfte %5 N</translation>
    </message>
    <message>
        <source>B − A: %1 s, pitch %2, roll %3, front left %4 right %5, rear left %6 right %7, forces left %8 right %9 N</source>
        <translation>B − A: %1 s, Nicken %2, Rollen %3, vorn links %4 rechts %5, hinten links %6 rechts %7, Kräfte links %8 rechts %9 N</translation>
    </message>
</context>
<context>
    <name>ReviewDisplay</name>
    <message>
        <source>link %1 Hz</source>
        <translation>Verbindung %1 Hz</translation>
    </message>
    <message>
        <source>no telemetry</source>
        <translation>keine Telemetrie</translation>
    </message>
    <message>
        <source>robot: --</source>
        <translation>Roboter: --</translation>
    </message>
    <message>
        <source>model %1</source>
        <translation>Modell %1</translation>
    </message>
    <message>
        <source>no model</source>
        <translation>kein Modell</translation>
    </message>
    <message>
        <source>DAMAGED from %1 to %2; this part is not shown: %3</source>
        <translation>BESCHÄDIGT von %1 bis %2, nichts davon wird gezeigt: %3</translation>
    </message>
</context>
<context>
    <name>ReviewExport</name>
    <message>
        <source>%1: a picture is a .png, .svg or .pdf</source>
        <translation>%1: ein Bild ist .png, .svg oder .pdf</translation>
    </message>
    <message>
        <source>%1 could not be written</source>
        <translation>%1 ließ sich nicht schreiben</translation>
    </message>
    <message>
        <source>Picture of the terrain</source>
        <translation>Bild des Geländes</translation>
    </message>
    <message>
        <source>Numbers of this time</source>
        <translation>Zahlen dieser Zeit</translation>
    </message>
    <message>
        <source>Report of the scene, one page</source>
        <translation>Bericht der Szene, eine Seite</translation>
    </message>
    <message>
        <source>CAN frames</source>
        <translation>CAN-Rahmen</translation>
    </message>
    <message>
        <source>Signals, a column for each</source>
        <translation>Signale, eine Spalte für jedes</translation>
    </message>
    <message>
        <source>Estimates, a row for each bin</source>
        <translation>Schätzungen, eine Zeile je Feld</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Frames, signals, estimates and events</source>
        <translation>Rahmen, Signale, Schätzungen und Ereignisse</translation>
    </message>
    <message>
        <source>Mission report, the whole session</source>
        <translation>Einsatzbericht, ganze Sitzung</translation>
    </message>
    <message>
        <source>Strip of felt ground, the whole session</source>
        <translation>Streifen ertasteten Bodens, ganze Sitzung</translation>
    </message>
</context>
<context>
    <name>ReviewTimeline</name>
    <message>
        <source>scene %1</source>
        <translation>Szene %1</translation>
    </message>
    <message>
        <source>estimate %1 of scene %2, %3</source>
        <translation>Schätzung %1 der Szene %2, %3</translation>
    </message>
    <message>
        <source>probe proposed at %1</source>
        <translation>Sondierung vorgeschlagen bei %1</translation>
    </message>
    <message>
        <source>an estimate stands</source>
        <translation>eine Schätzung gilt</translation>
    </message>
    <message>
        <source>a force element is in contact</source>
        <translation>ein Kraftelement hat Kontakt</translation>
    </message>
    <message>
        <source>no telemetry came</source>
        <translation>es kam keine Telemetrie</translation>
    </message>
    <message>
        <source>DAMAGED, not shown: %1</source>
        <translation>BESCHÄDIGT, nicht gezeigt: %1</translation>
    </message>
    <message>
        <source>alarm: %1</source>
        <translation>Alarm: %1</translation>
    </message>
    <message>
        <source>alarm seen: %1</source>
        <translation>Alarm gesehen: %1</translation>
    </message>
    <message>
        <source>alarm returned: %1</source>
        <translation>Alarm vorbei, ungesehen: %1</translation>
    </message>
    <message>
        <source>alarm gone: %1</source>
        <translation>Alarm beendet: %1</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 Verbindung</translation>
    </message>
    <message>
        <source>2 contact</source>
        <translation>2 Kontakt</translation>
    </message>
    <message>
        <source>3 scenes</source>
        <translation>3 Szenen</translation>
    </message>
    <message>
        <source>4 estimates</source>
        <translation>4 Schätzung</translation>
    </message>
    <message>
        <source>5 probes</source>
        <translation>5 Sonden</translation>
    </message>
    <message>
        <source>6 operator</source>
        <translation>6 Bediener</translation>
    </message>
    <message>
        <source>7 alarms</source>
        <translation>7 Alarme</translation>
    </message>
    <message>
        <source>8 markers</source>
        <translation>8 Marken</translation>
    </message>
    <message>
        <source>message</source>
        <translation>Meldung</translation>
    </message>
    <message>
        <source>decision</source>
        <translation>Entscheidung</translation>
    </message>
    <message>
        <source>exploration</source>
        <translation>Erkundung</translation>
    </message>
    <message>
        <source>arming</source>
        <translation>Freigabe</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>estimate void</source>
        <translation>Schätzung verfallen</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>Pult</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>Lücke</translation>
    </message>
    <message>
        <source>session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>contact closed: %1</source>
        <translation>Kontakt geschlossen: %1</translation>
    </message>
    <message>
        <source>contact open: %1</source>
        <translation>Kontakt offen: %1</translation>
    </message>
    <message>
        <source>telemetry gap</source>
        <translation>Telemetrielücke</translation>
    </message>
    <message>
        <source>override</source>
        <translation>Übergehen</translation>
    </message>
    <message>
        <source>telemetry was missing for a while since the scene</source>
        <translation>seit der Szene fehlte eine Weile die Telemetrie</translation>
    </message>
    <message>
        <source>nothing is overridden</source>
        <translation>nichts wird übergangen</translation>
    </message>
    <message>
        <source>overridden: %1</source>
        <translation>übergangen: %1</translation>
    </message>
</context>
<context>
    <name>ReviewViewState</name>
    <message>
        <source>A review commands no robot</source>
        <translation>Eine Rückschau befiehlt keinem Roboter</translation>
    </message>
    <message>
        <source>what if: %1</source>
        <translation>was wäre: %1</translation>
    </message>
    <message>
        <source>No estimate at this time</source>
        <translation>Zu dieser Zeit galt keine Schätzung</translation>
    </message>
</context>
<context>
    <name>RobotCard</name>
    <message>
        <source>%1: %2
file of %3, %4 bytes; content %5</source>
        <translation>%1: %2
Datei vom %3, %4 Bytes; Inhalt %5</translation>
    </message>
</context>
<context>
    <name>RobotWords</name>
    <message>
        <source>halted</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>driving</source>
        <translation>fährt</translation>
    </message>
    <message>
        <source>pressing down</source>
        <translation>drückt an</translation>
    </message>
    <message>
        <source>flippers pressed</source>
        <translation>Flipper angedrückt</translation>
    </message>
    <message>
        <source>arm is probing</source>
        <translation>Arm sondiert</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
</context>
<context>
    <name>SettingsFile</name>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>“%1” is no valid %2; expected: %3</source>
        <translation>„%1“ ist kein gültiger Wert für %2; erwartet: %3</translation>
    </message>
    <message>
        <source>a number in %1</source>
        <translation>eine Zahl in %1</translation>
    </message>
    <message>
        <source>“%1” is no setting; expected: key = value</source>
        <translation>„%1“ ist keine Einstellung; erwartet: Schlüssel = Wert</translation>
    </message>
    <message>
        <source>this is no file of settings; expected first: %1 = %2</source>
        <translation>das ist keine Datei mit Einstellungen; erwartet zuerst: %1 = %2</translation>
    </message>
    <message>
        <source>version %1 is of a newer Terratact; expected: version %2. Update this program, or export the settings from its version</source>
        <translation>Version %1 ist von einem neueren Terratact; erwartet: Version %2. Dieses Programm aktualisieren, oder die Einstellungen aus seiner Version exportieren</translation>
    </message>
    <message>
        <source>“%1” is no setting; expected: a setting of this version</source>
        <translation>„%1“ ist keine Einstellung; erwartet: eine Einstellung dieser Version</translation>
    </message>
    <message>
        <source>%1 appears twice; expected: once</source>
        <translation>%1 kommt zweimal vor; erwartet: einmal</translation>
    </message>
    <message>
        <source>a file of this computer</source>
        <translation>eine Datei dieses Rechners</translation>
    </message>
    <message>
        <source>this is no text; expected: UTF-8</source>
        <translation>das ist kein Text; erwartet: UTF-8</translation>
    </message>
    <message>
        <source>is no file</source>
        <translation>ist keine Datei</translation>
    </message>
    <message>
        <source>the file exists and was not replaced; choose another name</source>
        <translation>die Datei gibt es und sie wurde nicht ersetzt; anderen Namen wählen</translation>
    </message>
    <message>
        <source>a profile needs a name</source>
        <translation>ein Profil braucht einen Namen</translation>
    </message>
    <message>
        <source>a profile&apos;s name has at most %1 letters</source>
        <translation>ein Profilname hat höchstens %1 Buchstaben</translation>
    </message>
    <message>
        <source>a profile&apos;s name is one line of plain text</source>
        <translation>ein Profilname ist eine Zeile einfacher Text</translation>
    </message>
</context>
<context>
    <name>SideKeys</name>
    <message>
        <source>show the left side, and probe there</source>
        <translation>die linke Seite zeigen und dort sondieren</translation>
    </message>
    <message>
        <source>show the right side, and probe there</source>
        <translation>die rechte Seite zeigen und dort sondieren</translation>
    </message>
    <message>
        <source>show both sides, and probe the side in full</source>
        <translation>beide Seiten zeigen, die ganz gezeichnete sondieren</translation>
    </message>
    <message>
        <source>show the left side</source>
        <translation>die linke Seite zeigen</translation>
    </message>
    <message>
        <source>show the right side</source>
        <translation>die rechte Seite zeigen</translation>
    </message>
    <message>
        <source>show both sides</source>
        <translation>beide Seiten zeigen</translation>
    </message>
</context>
<context>
    <name>StopDisplay</name>
    <message>
        <source>STOP SENT, NOT CONFIRMED for %1: the robot may still move; STOP is sent again</source>
        <translation>STOP GESENDET, NICHT BESTÄTIGT seit %1: der Roboter fährt womöglich noch; STOP wird erneut gesendet</translation>
    </message>
    <message>
        <source>STOP NOT SENT for %1, trying again: use the robot&apos;s own switch — %2</source>
        <translation>STOP NICHT GESENDET seit %1, es wird weiter versucht: den Schalter am Roboter benutzen — %2</translation>
    </message>
</context>
<context>
    <name>TwoTrackVerdict</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>the cross slope ahead may tip the robot over</source>
        <translation>das Quergefälle voraus kann den Roboter umkippen</translation>
    </message>
    <message>
        <source>the cross slope ahead is not decided</source>
        <translation>das Quergefälle voraus ist nicht entschieden</translation>
    </message>
    <message>
        <source>a step on one of the sides is almost certain</source>
        <translation>eine Stufe auf einer der Seiten ist fast sicher</translation>
    </message>
    <message>
        <source>each side alone is clear, both together are not</source>
        <translation>jede Seite allein ist frei, beide zusammen nicht</translation>
    </message>
    <message>
        <source>each side %1</source>
        <translation>jede Seite %1</translation>
    </message>
    <message>
        <source>L %1 · R %2</source>
        <translation>L %1 · R %2</translation>
    </message>
    <message>
        <source>left %1 · right %2</source>
        <translation>links %1 · rechts %2</translation>
    </message>
    <message>
        <source>P(step &gt; %1) L %2, R %3</source>
        <translation>P(Stufe &gt; %1) L %2, R %3</translation>
    </message>
    <message>
        <source>P(step &gt; %1, L or R) = %2</source>
        <translation>P(Stufe &gt; %1, L oder R) = %2</translation>
    </message>
    <message>
        <source>cross slope %1 of %2, %3 up</source>
        <translation>Quergefälle %1 von %2, %3 höher</translation>
    </message>
    <message>
        <source>P(step &gt; %1, L or R): %2</source>
        <translation>P(Stufe &gt; %1, L oder R): %2</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>fast</source>
        <translation>schnell</translation>
    </message>
    <message>
        <source>balanced</source>
        <translation>ausgewogen</translation>
    </message>
    <message>
        <source>accurate</source>
        <translation>genau</translation>
    </message>
    <message>
        <source>the chains have not converged</source>
        <translation>die Ketten sind nicht konvergiert</translation>
    </message>
    <message>
        <source>roll %1°: the ground is not the same left and right</source>
        <translation>Rollen %1°: der Boden ist links und rechts nicht gleich</translation>
    </message>
    <message>
        <source>left and right flippers differ by %1°: the ground is not the same left and right</source>
        <translation>linker und rechter Flipper weichen um %1° ab: der Boden ist links und rechts nicht gleich</translation>
    </message>
    <message>
        <source>contact and arm disagree about bin %1 m by %2 mm</source>
        <translation>Kontakt und Arm weichen bei Feld %1 m um %2 mm ab</translation>
    </message>
    <message>
        <source>the arm found bin %1 m %2 mm above the robot&apos;s own lower edge</source>
        <translation>der Arm fand Feld %1 m um %2 mm über der Unterkante des Roboters</translation>
    </message>
    <message>
        <source>two heights are likely at %1 m: %2 m (%3 %) or %4 m (%5 %)</source>
        <translation>bei %1 m sind zwei Höhen wahrscheinlich: %2 m (%3 %) oder %4 m (%5 %)</translation>
    </message>
    <message>
        <source>the scene is unlike all training</source>
        <translation>die Szene gleicht nichts aus dem Training</translation>
    </message>
    <message>
        <source>STOP is latched: release it first</source>
        <translation>STOP ist eingerastet: erst lösen</translation>
    </message>
    <message>
        <source>The link must be good for a second</source>
        <translation>Die Verbindung muss eine Sekunde lang gut sein</translation>
    </message>
    <message>
        <source>CLEAR</source>
        <translation>FREI</translation>
    </message>
    <message>
        <source>BLOCKED</source>
        <translation>VERSPERRT</translation>
    </message>
    <message>
        <source>CANNOT TELL</source>
        <translation>UNKLAR</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>halting the robot</source>
        <translation>hält den Roboter an</translation>
    </message>
    <message>
        <source>pressing the front flippers down</source>
        <translation>drückt die vorderen Flipper an</translation>
    </message>
    <message>
        <source>estimating the terrain</source>
        <translation>schätzt das Gelände</translation>
    </message>
    <message>
        <source>arm probe proposed</source>
        <translation>Sondierung vorgeschlagen</translation>
    </message>
    <message>
        <source>arm is probing</source>
        <translation>Arm sondiert</translation>
    </message>
    <message>
        <source>estimating again with the arm&apos;s height</source>
        <translation>schätzt neu mit der Höhe des Arms</translation>
    </message>
    <message>
        <source>estimate stands</source>
        <translation>Schätzung steht</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>STOP AKTIV</translation>
    </message>
    <message>
        <source>exploration failed</source>
        <translation>Erkundung fehlgeschlagen</translation>
    </message>
    <message>
        <source>no failure</source>
        <translation>kein Fehler</translation>
    </message>
    <message>
        <source>the robot did not halt in time</source>
        <translation>der Roboter hielt nicht rechtzeitig an</translation>
    </message>
    <message>
        <source>the flippers found nothing to press against in time</source>
        <translation>die Flipper fanden nicht rechtzeitig Widerstand</translation>
    </message>
    <message>
        <source>the estimate took too long</source>
        <translation>die Schätzung dauerte zu lange</translation>
    </message>
    <message>
        <source>the estimate could not be computed</source>
        <translation>die Schätzung war nicht zu berechnen</translation>
    </message>
    <message>
        <source>the arm did not finish in time</source>
        <translation>der Arm wurde nicht rechtzeitig fertig</translation>
    </message>
    <message>
        <source>the robot refused the probe</source>
        <translation>der Roboter lehnte die Sondierung ab</translation>
    </message>
    <message>
        <source>the robot refused to press</source>
        <translation>der Roboter lehnte das Andrücken ab</translation>
    </message>
    <message>
        <source>the link to the robot was lost</source>
        <translation>die Verbindung zum Roboter ging verloren</translation>
    </message>
    <message>
        <source>the robot moved, so what it felt no longer holds</source>
        <translation>der Roboter bewegte sich, das Ertastete gilt nicht mehr</translation>
    </message>
    <message>
        <source>the approval was of another scene, settings or model</source>
        <translation>die Genehmigung galt einer anderen Szene, Einstellung oder einem anderen Modell</translation>
    </message>
    <message>
        <source>the robot is not armed</source>
        <translation>der Roboter ist nicht freigegeben</translation>
    </message>
    <message>
        <source>not armed yet</source>
        <translation>noch nicht freigegeben</translation>
    </message>
    <message>
        <source>disarmed by the operator</source>
        <translation>vom Bediener gesperrt</translation>
    </message>
    <message>
        <source>window or panel does not answer</source>
        <translation>Fenster oder Pult antwortet nicht</translation>
    </message>
    <message>
        <source>somebody else sends this console&apos;s frames</source>
        <translation>jemand anders sendet die Rahmen dieser Konsole</translation>
    </message>
    <message>
        <source>the link is not good</source>
        <translation>die Verbindung ist nicht gut</translation>
    </message>
    <message>
        <source>the robot is armed, but not by this console</source>
        <translation>der Roboter ist freigegeben, aber nicht von dieser Konsole</translation>
    </message>
    <message>
        <source>not confirmed in time</source>
        <translation>nicht rechtzeitig bestätigt</translation>
    </message>
    <message>
        <source>the robot did not arm in time</source>
        <translation>der Roboter gab nicht rechtzeitig frei</translation>
    </message>
    <message>
        <source>the robot has disarmed</source>
        <translation>der Roboter hat sich gesperrt</translation>
    </message>
    <message>
        <source>the robot has begun anew</source>
        <translation>der Roboter ist neu gestartet</translation>
    </message>
    <message>
        <source>may be sent</source>
        <translation>darf gesendet werden</translation>
    </message>
    <message>
        <source>not a frame that a console sends</source>
        <translation>kein Rahmen, den eine Konsole sendet</translation>
    </message>
    <message>
        <source>the frame is damaged</source>
        <translation>der Rahmen ist beschädigt</translation>
    </message>
    <message>
        <source>the link to the robot is not good</source>
        <translation>die Verbindung zum Roboter ist nicht gut</translation>
    </message>
    <message>
        <source>the robot does not answer: what arrives may be a recording</source>
        <translation>der Roboter antwortet nicht: was ankommt, kann eine Aufzeichnung sein</translation>
    </message>
    <message>
        <source>the robot has begun a new arming</source>
        <translation>der Roboter hat eine neue Freigabe begonnen</translation>
    </message>
    <message>
        <source>the robot is not stopped</source>
        <translation>der Roboter ist nicht gestoppt</translation>
    </message>
    <message>
        <source>not armed</source>
        <translation>nicht freigegeben</translation>
    </message>
    <message>
        <source>arming is not confirmed</source>
        <translation>die Freigabe ist nicht bestätigt</translation>
    </message>
    <message>
        <source>an exploration is running</source>
        <translation>eine Erkundung läuft</translation>
    </message>
    <message>
        <source>no exploration is running</source>
        <translation>es läuft keine Erkundung</translation>
    </message>
    <message>
        <source>the robot is busy</source>
        <translation>der Roboter ist beschäftigt</translation>
    </message>
    <message>
        <source>the front flippers are not pressed to the ground</source>
        <translation>die vorderen Flipper sind nicht an den Boden gedrückt</translation>
    </message>
    <message>
        <source>the value is over its limit</source>
        <translation>der Wert liegt über seiner Grenze</translation>
    </message>
    <message>
        <source>the probe is not approved</source>
        <translation>die Sondierung ist nicht genehmigt</translation>
    </message>
    <message>
        <source>the approval is too old</source>
        <translation>die Genehmigung ist zu alt</translation>
    </message>
    <message>
        <source>another bin was approved</source>
        <translation>ein anderes Feld wurde genehmigt</translation>
    </message>
    <message>
        <source>chains not converged: R-hat %1 (limit %2), effective draws %3 (limit %4)</source>
        <translation>Ketten nicht konvergiert: R-hat %1 (Grenze %2), wirksame Ziehungen %3 (Grenze %4)</translation>
    </message>
    <message>
        <source>chains not converged when time was out: R-hat %1 (limit %2), effective draws %3 (limit %4)</source>
        <translation>Ketten bei Ablauf der Zeit nicht konvergiert: R-hat %1 (Grenze %2), wirksame Ziehungen %3 (Grenze %4)</translation>
    </message>
    <message>
        <source>the model of bin %1 m is singular: %2 of its variance was added as noise</source>
        <translation>das Modell von Feld %1 m ist singulär: %2 seiner Varianz wurde als Rauschen hinzugefügt</translation>
    </message>
    <message>
        <source>following: nothing is explored</source>
        <translation>mitverfolgt: keine Erkundung</translation>
    </message>
    <message>
        <source>following: flippers go down</source>
        <translation>mitverfolgt: Flipper gehen nach unten</translation>
    </message>
    <message>
        <source>following: flippers pressed, estimating the terrain</source>
        <translation>mitverfolgt: Flipper angedrückt, schätzt das Gelände</translation>
    </message>
    <message>
        <source>following: flippers pressed, arm is probing</source>
        <translation>mitverfolgt: Flipper angedrückt, Arm sondiert</translation>
    </message>
    <message>
        <source>following: estimating again with the arm&apos;s height</source>
        <translation>mitverfolgt: schätzt neu mit der Höhe des Arms</translation>
    </message>
    <message>
        <source>following: estimate stands</source>
        <translation>mitverfolgt: Schätzung steht</translation>
    </message>
    <message>
        <source>following: the robot is stopped</source>
        <translation>mitverfolgt: der Roboter ist gestoppt</translation>
    </message>
    <message>
        <source>following: no estimate</source>
        <translation>mitverfolgt: keine Schätzung</translation>
    </message>
    <message>
        <source>wire broken</source>
        <translation>Drahtbruch</translation>
    </message>
    <message>
        <source>short circuit</source>
        <translation>Kurzschluss</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>gesättigt</translation>
    </message>
    <message>
        <source>the robot reports no odometry</source>
        <translation>der Roboter meldet keinen zurückgelegten Weg</translation>
    </message>
    <message>
        <source>halted</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>driving</source>
        <translation>fährt</translation>
    </message>
    <message>
        <source>front flippers pressed to the ground</source>
        <translation>vordere Flipper an den Boden gedrückt</translation>
    </message>
    <message>
        <source>probing with the arm</source>
        <translation>sondiert mit dem Arm</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>nothing refused</source>
        <translation>nichts abgelehnt</translation>
    </message>
    <message>
        <source>the arm does not reach that bin</source>
        <translation>der Arm erreicht dieses Feld nicht</translation>
    </message>
    <message>
        <source>the robot finds no pose to rest in there</source>
        <translation>der Roboter findet dort keine Lage, in der er ruht</translation>
    </message>
    <message>
        <source>the command is late or not of this arming</source>
        <translation>der Befehl kam zu spät oder ist nicht von dieser Freigabe</translation>
    </message>
    <message>
        <source>the command is beyond the robot&apos;s limits</source>
        <translation>der Befehl liegt jenseits der Grenzen des Roboters</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>contact at x %1 m lies %2 mm above the robot&apos;s own lower edge</source>
        <translation>der Kontakt bei x %1 m liegt %2 mm über der Unterkante des Roboters</translation>
    </message>
    <message>
        <source>no live telemetry, the robot may have moved</source>
        <translation>keine aktuelle Telemetrie, der Roboter kann sich bewegt haben</translation>
    </message>
    <message>
        <source>the robot rolls, left and right ground differ</source>
        <translation>der Rollwinkel ist groß, Boden links und rechts verschieden</translation>
    </message>
    <message>
        <source>the flippers differ, left and right ground differ</source>
        <translation>die Flipper weichen ab, Boden links und rechts verschieden</translation>
    </message>
    <message>
        <source>commands can leave</source>
        <translation>Befehle können gesendet werden</translation>
    </message>
    <message>
        <source>no other console sends commands</source>
        <translation>keine andere Konsole sendet Befehle</translation>
    </message>
    <message>
        <source>STOP is not latched</source>
        <translation>STOP ist nicht eingerastet</translation>
    </message>
    <message>
        <source>the link is good</source>
        <translation>die Verbindung ist gut</translation>
    </message>
    <message>
        <source>no other console has armed the robot</source>
        <translation>keine andere Konsole hat den Roboter freigegeben</translation>
    </message>
    <message>
        <source>telemetry was missing for a while, in which the robot may have moved</source>
        <translation>eine Weile fehlte die Telemetrie, der Roboter kann sich bewegt haben</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>ist nicht lesbar</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>es ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>is a directory</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>is not an SQLite file</source>
        <translation>ist keine SQLite-Datei</translation>
    </message>
    <message>
        <source>is larger than the %1 bytes allowed</source>
        <translation>ist größer als die erlaubten %1 Bytes</translation>
    </message>
    <message>
        <source>has %1 bytes where its header says %2</source>
        <translation>hat %1 Bytes, laut Kopf %2</translation>
    </message>
    <message>
        <source>is larger than the %1 bytes allowed here</source>
        <translation>ist größer als die hier erlaubten %1 Bytes</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>is an SQLite file of another application, not a Terratact model</source>
        <translation>ist die SQLite-Datei eines anderen Programms, kein Modell von Terratact</translation>
    </message>
    <message>
        <source>is a part of a model; `terratact merge` makes a model of all parts</source>
        <translation>ist ein Teil eines Modells; `terratact merge` macht aus allen Teilen ein Modell</translation>
    </message>
    <message>
        <source>its tables are not those of a Terratact model</source>
        <translation>ihre Tabellen sind nicht die eines Modells von Terratact</translation>
    </message>
    <message>
        <source>its content was altered: it does not have the hash that was stored with it</source>
        <translation>ihr Inhalt wurde verändert: er hat nicht den mit ihm gespeicherten Hash</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>%1: the disk is slow, it has been writing for %2 s; %3 frames wait</source>
        <translation>%1: der Datenträger ist langsam, er schreibt seit %2 s; %3 Rahmen warten</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Datei oder Ordner nicht gefunden</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>Vorgang nicht erlaubt</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>ist kein Ordner</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Dateisystem nur lesbar</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz mehr auf dem Gerät</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>Network is down</source>
        <translation>das Netz ist abgeschaltet</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>Gerät nicht vorhanden</translation>
    </message>
    <message>
        <source>No such device or address</source>
        <translation>Gerät oder Adresse nicht vorhanden</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>Gerät ist belegt</translation>
    </message>
    <message>
        <source>No buffer space available</source>
        <translation>kein Platz im Puffer</translation>
    </message>
    <message>
        <source>another program, or the kernel,</source>
        <translation>ein anderes Programm oder der Kernel</translation>
    </message>
    <message>
        <source>reading an edge</source>
        <translation>Lesen einer Flanke</translation>
    </message>
    <message>
        <source>reading a level</source>
        <translation>Lesen eines Pegels</translation>
    </message>
    <message>
        <source>reading the levels</source>
        <translation>Lesen der Pegel</translation>
    </message>
    <message>
        <source>waiting for an edge</source>
        <translation>Warten auf eine Flanke</translation>
    </message>
    <message>
        <source>setting an output</source>
        <translation>Setzen eines Ausgangs</translation>
    </message>
    <message>
        <source>no GPIO chip named %1: this computer has none (no /dev/gpiochip*); plug it in, or load its driver</source>
        <translation>kein GPIO-Chip namens %1: dieser Rechner hat keinen (kein /dev/gpiochip*); bitte anstecken oder seinen Treiber laden</translation>
    </message>
    <message>
        <source>no GPIO chip labelled %1: this computer has none (no /dev/gpiochip*); plug it in, or load its driver</source>
        <translation>kein GPIO-Chip mit der Bezeichnung %1: dieser Rechner hat keinen (kein /dev/gpiochip*); bitte anstecken oder seinen Treiber laden</translation>
    </message>
    <message>
        <source>no GPIO chip named %1: there is %2</source>
        <translation>kein GPIO-Chip namens %1: es gibt %2</translation>
    </message>
    <message>
        <source>no GPIO chip labelled %1: there is %2</source>
        <translation>kein GPIO-Chip mit der Bezeichnung %1: es gibt %2</translation>
    </message>
    <message>
        <source>several GPIO chips named %1: there is %2; give the chip&apos;s name instead</source>
        <translation>mehrere GPIO-Chips namens %1: es gibt %2; bitte statt dessen den Namen des Chips angeben</translation>
    </message>
    <message>
        <source>several GPIO chips labelled %1: there is %2; give the chip&apos;s name instead</source>
        <translation>mehrere GPIO-Chips mit der Bezeichnung %1: es gibt %2; bitte statt dessen den Namen des Chips angeben</translation>
    </message>
    <message>
        <source>%1 has several lines named %2: give offset instead</source>
        <translation>%1 hat mehrere Leitungen namens %2: bitte statt dessen offset angeben</translation>
    </message>
    <message>
        <source>the panel&apos;s %1 does not obey: %2</source>
        <translation>%1 des Pults gehorcht nicht: %2</translation>
    </message>
    <message>
        <source>the panel&apos;s button %1 was held when the panel came up. It counts as not pressed until it is released. If it is not held, its contact sticks or its wires touch</source>
        <translation>der Knopf %1 des Pults war gedrückt, als das Pult hochkam. Er gilt als nicht gedrückt, bis er losgelassen wird. Ist er nicht gedrückt, klemmt sein Kontakt oder seine Drähte berühren sich</translation>
    </message>
    <message>
        <source>the panel&apos;s button %1 has been held for too long. It counts as not pressed until it is released. If it is not held, its contact sticks or its wires touch</source>
        <translation>der Knopf %1 des Pults ist zu lange gedrückt. Er gilt als nicht gedrückt, bis er losgelassen wird. Ist er nicht gedrückt, klemmt sein Kontakt oder seine Drähte berühren sich</translation>
    </message>
    <message>
        <source>line %1 of %2 is requested twice</source>
        <translation>Leitung %1 von %2 wird zweimal verlangt</translation>
    </message>
    <message>
        <source>line %1 of %2 is in use: %3 holds it; end that program, or wire the panel to another line</source>
        <translation>Leitung %1 von %2 ist in Gebrauch: %3 hält sie; jenes Programm beenden oder das Pult an eine andere Leitung anschließen</translation>
    </message>
    <message>
        <source>the link was lost, the robot may have moved</source>
        <translation>die Verbindung war verloren, der Roboter kann sich bewegt haben</translation>
    </message>
    <message>
        <source>STOP is latched</source>
        <translation>STOP ist eingerastet</translation>
    </message>
    <message>
        <source>nests deeper than %1 levels</source>
        <translation>ist tiefer als %1 Ebenen verschachtelt</translation>
    </message>
    <message>
        <source>is a whole model, expected a part of one</source>
        <translation>ist ein ganzes Modell, erwartet wird ein Teil davon</translation>
    </message>
    <message>
        <source>its table meta describes another kind of model</source>
        <translation>seine Tabelle meta beschreibt eine andere Art von Modell</translation>
    </message>
    <message>
        <source>its training rows have the wrong number of columns</source>
        <translation>seine Trainingszeilen haben die falsche Zahl von Spalten</translation>
    </message>
    <message>
        <source>its list of bins is empty</source>
        <translation>seine Liste der Felder ist leer</translation>
    </message>
    <message>
        <source>its texts are too long</source>
        <translation>seine Texte sind zu lang</translation>
    </message>
    <message>
        <source>a row covers a bin that does not exist</source>
        <translation>eine Zeile gilt für ein Feld, das es nicht gibt</translation>
    </message>
    <message>
        <source>%1 scenes without any known height left out</source>
        <translation>ausgelassene Szenen ohne jede bekannte Höhe: %1</translation>
    </message>
    <message>
        <source>Address already in use</source>
        <translation>Adresse wird schon verwendet</translation>
    </message>
    <message>
        <source>the key %1 is missing</source>
        <translation>der Schlüssel %1 fehlt</translation>
    </message>
    <message>
        <source>is a model of other features: it has %1 where %2 is expected</source>
        <translation>ist ein Modell anderer Merkmale: hier steht %1, erwartet wird %2</translation>
    </message>
    <message>
        <source>is a model of other bins: it has %1 where %2 is expected</source>
        <translation>ist ein Modell anderer Felder: hier steht %1, erwartet wird %2</translation>
    </message>
    <message>
        <source>its table %1 ends too early</source>
        <translation>seine Tabelle %1 endet zu früh</translation>
    </message>
    <message>
        <source>its table %1 has too many rows</source>
        <translation>seine Tabelle %1 hat zu viele Zeilen</translation>
    </message>
    <message>
        <source>Address family not supported by protocol</source>
        <translation>Adressfamilie wird nicht unterstützt</translation>
    </message>
    <message>
        <source>Protocol not supported</source>
        <translation>Protokoll wird nicht unterstützt</translation>
    </message>
    <message>
        <source>sudo modprobe can_raw   (where that fails: a kernel with CONFIG_CAN_RAW)</source>
        <translation>sudo modprobe can_raw   (wo das scheitert: ein Kernel mit CONFIG_CAN_RAW)</translation>
    </message>
    <message>
        <source>run it outside of the sandbox or container that forbids it, or as another user</source>
        <translation>außerhalb der Sandbox oder des Containers starten, der es verbietet, oder als anderer Benutzer</translation>
    </message>
    <message>
        <source>no telemetry yet</source>
        <translation>noch keine Telemetrie</translation>
    </message>
    <message>
        <source>link is up</source>
        <translation>Verbindung steht</translation>
    </message>
    <message>
        <source>link lost</source>
        <translation>Verbindung weg</translation>
    </message>
    <message>
        <source>telemetry lost</source>
        <translation>Telemetrie weg</translation>
    </message>
    <message>
        <source>link unsteady</source>
        <translation>Verbindung unstetig</translation>
    </message>
    <message>
        <source>telemetry unsteady</source>
        <translation>Telemetrie unstetig</translation>
    </message>
    <message>
        <source>end of the log</source>
        <translation>Ende des Logs</translation>
    </message>
    <message>
        <source>gaps before: %1, the longest %2 s</source>
        <translation>Lücken davor: %1, die längste %2 s</translation>
    </message>
    <message>
        <source>the kernel has no CAN sockets (%1)</source>
        <translation>der Kernel hat keine CAN-Sockets (%1)</translation>
    </message>
    <message>
        <source>this user may not open CAN sockets (%1)</source>
        <translation>dieser Benutzer darf keine CAN-Sockets öffnen (%1)</translation>
    </message>
    <message>
        <source>a CAN socket cannot be opened (%1)</source>
        <translation>ein CAN-Socket lässt sich nicht öffnen (%1)</translation>
    </message>
    <message>
        <source>is it in degrees?</source>
        <translation>etwa in Grad?</translation>
    </message>
    <message>
        <source>is it in mA?</source>
        <translation>etwa in mA?</translation>
    </message>
    <message>
        <source>is it in mm?</source>
        <translation>etwa in mm?</translation>
    </message>
    <message>
        <source>is it raw or without its bias taken off?</source>
        <translation>etwa roh oder ohne Abzug des Nullwerts?</translation>
    </message>
    <message>
        <source>a standard deviation of clearances</source>
        <translation>eine Standardabweichung der Abstände</translation>
    </message>
    <message>
        <source>the surface of bin %1</source>
        <translation>die Fläche von Feld %1</translation>
    </message>
    <message>
        <source>the clearance conditional of bin %1</source>
        <translation>die bedingte Verteilung der Abstände von Feld %1</translation>
    </message>
    <message>
        <source>its clearances lack the features&apos; standardisation</source>
        <translation>seinen Abständen fehlt die Normierung der Merkmale</translation>
    </message>
    <message>
        <source>it has not one residual per training row and bin</source>
        <translation>es hat nicht ein Residuum je Trainingszeile und Feld</translation>
    </message>
    <message>
        <source>its scanned rows do not fit its training rows</source>
        <translation>seine gescannten Zeilen passen nicht zu seinen Trainingszeilen</translation>
    </message>
    <message>
        <source>its number of inducing rows is out of range</source>
        <translation>seine Zahl der Stützzeilen liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>its table length_scale is not in the order of the inputs</source>
        <translation>seine Tabelle length_scale hat nicht die Reihenfolge der Eingänge</translation>
    </message>
    <message>
        <source>chip must have a label or a name, not both</source>
        <translation>chip muss label oder name haben, nicht beides</translation>
    </message>
    <message>
        <source>has more than %1 fields</source>
        <translation>hat mehr als %1 Felder</translation>
    </message>
    <message>
        <source>has a field of more than %1 bytes</source>
        <translation>hat ein Feld von mehr als %1 Bytes</translation>
    </message>
    <message>
        <source>has more than %1 columns</source>
        <translation>hat mehr als %1 Spalten</translation>
    </message>
    <message>
        <source>has %1 fields where the header has %2</source>
        <translation>hat %1 Felder, die Kopfzeile %2</translation>
    </message>
    <message>
        <source>is one scene more than the %1 allowed in a file</source>
        <translation>ist eine Szene mehr als die %1, die in einer Datei erlaubt sind</translation>
    </message>
    <message>
        <source>is the header, and no scene follows it</source>
        <translation>ist die Kopfzeile, und keine Szene folgt ihr</translation>
    </message>
    <message>
        <source>too many notes</source>
        <translation>zu viele Notizen</translation>
    </message>
    <message>
        <source>its robot</source>
        <translation>ihr Roboter</translation>
    </message>
    <message>
        <source>is an SQLite file of another application, not a session</source>
        <translation>ist die SQLite-Datei eines anderen Programms, keine Sitzung</translation>
    </message>
    <message>
        <source>its tables are not those of a session</source>
        <translation>ihre Tabellen sind nicht die einer Sitzung</translation>
    </message>
    <message>
        <source>has unknown entries about its start</source>
        <translation>hat unbekannte Einträge über ihren Beginn</translation>
    </message>
    <message>
        <source>lacks the entry whether it could transmit</source>
        <translation>ihr fehlt der Eintrag, ob sie senden konnte</translation>
    </message>
    <message>
        <source>has draws that are not whole</source>
        <translation>hat unvollständige Ziehungen</translation>
    </message>
    <message>
        <source>has a draw that is not finite</source>
        <translation>hat eine Ziehung, die nicht endlich ist</translation>
    </message>
    <message>
        <source>the draws of an estimate are missing</source>
        <translation>die Ziehungen einer Schätzung fehlen</translation>
    </message>
    <message>
        <source>the draws of an estimate were changed</source>
        <translation>die Ziehungen einer Schätzung wurden verändert</translation>
    </message>
    <message>
        <source>has more batches than a session can have</source>
        <translation>hat mehr Blöcke, als eine Sitzung haben kann</translation>
    </message>
    <message>
        <source>a table has more rows than a session can have</source>
        <translation>eine Tabelle hat mehr Zeilen, als eine Sitzung haben kann</translation>
    </message>
    <message>
        <source>the chain of hashes is broken here</source>
        <translation>die Kette der Hashes ist hier unterbrochen</translation>
    </message>
    <message>
        <source>rows were changed, lost or added</source>
        <translation>Zeilen wurden verändert, verloren oder hinzugefügt</translation>
    </message>
    <message>
        <source>%1 rows belong to no batch</source>
        <translation>Zeilen, die zu keinem Block gehören: %1</translation>
    </message>
    <message>
        <source>frames belong to no batch</source>
        <translation>Rahmen gehören zu keinem Block</translation>
    </message>
    <message>
        <source>frames were changed, lost or added</source>
        <translation>Rahmen wurden verändert, verloren oder hinzugefügt</translation>
    </message>
    <message>
        <source>more than %1 places are damaged</source>
        <translation>mehr als %1 Stellen sind beschädigt</translation>
    </message>
    <message>
        <source>a number is out of range</source>
        <translation>eine Zahl liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>a seed is no number</source>
        <translation>ein Startwert ist keine Zahl</translation>
    </message>
    <message>
        <source>a frame is too long</source>
        <translation>ein Rahmen ist zu lang</translation>
    </message>
    <message>
        <source>a frame has the wrong length</source>
        <translation>ein Rahmen hat die falsche Länge</translation>
    </message>
    <message>
        <source>an identifier is too large</source>
        <translation>eine Kennung ist zu groß</translation>
    </message>
    <message>
        <source>truth of no scene</source>
        <translation>Wahrheit zu keiner Szene</translation>
    </message>
    <message>
        <source>a reading of no estimate</source>
        <translation>eine Messung zu keiner Schätzung</translation>
    </message>
    <message>
        <source>an offer of no proposal</source>
        <translation>ein Angebot zu keinem Vorschlag</translation>
    </message>
    <message>
        <source>an estimate of no scene</source>
        <translation>eine Schätzung zu keiner Szene</translation>
    </message>
    <message>
        <source>an estimate without settings</source>
        <translation>eine Schätzung ohne Einstellungen</translation>
    </message>
    <message>
        <source>an estimate without a model</source>
        <translation>eine Schätzung ohne Modell</translation>
    </message>
    <message>
        <source>a bin of no estimate</source>
        <translation>ein Feld zu keiner Schätzung</translation>
    </message>
    <message>
        <source>a proposal without an estimate</source>
        <translation>ein Vorschlag ohne Schätzung</translation>
    </message>
    <message>
        <source>a batch ends before it begins</source>
        <translation>ein Block endet, bevor er beginnt</translation>
    </message>
    <message>
        <source>a hash has the wrong length</source>
        <translation>ein Hash hat die falsche Länge</translation>
    </message>
    <message>
        <source>an unknown name</source>
        <translation>ein unbekannter Name</translation>
    </message>
    <message>
        <source>the model gives no finite estimate of this scene</source>
        <translation>das Modell gibt für diese Szene keine endliche Schätzung</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>kein Speicher mehr</translation>
    </message>
    <message>
        <source>its structure cannot be checked</source>
        <translation>ihr Aufbau lässt sich nicht prüfen</translation>
    </message>
    <message>
        <source>a number is missing</source>
        <translation>eine Zahl fehlt</translation>
    </message>
    <message>
        <source>its file system keeps no write-ahead journal</source>
        <translation>ihr Dateisystem führt kein Write-ahead-Journal</translation>
    </message>
    <message>
        <source>database disk image is malformed</source>
        <translation>der Inhalt der Datenbank ist beschädigt</translation>
    </message>
    <message>
        <source>file is not a database</source>
        <translation>die Datei ist keine Datenbank</translation>
    </message>
    <message>
        <source>database is locked</source>
        <translation>die Datenbank ist gesperrt</translation>
    </message>
    <message>
        <source>disk I/O error</source>
        <translation>Fehler beim Lesen oder Schreiben des Datenträgers</translation>
    </message>
    <message>
        <source>unable to open database file</source>
        <translation>die Datenbankdatei lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>attempt to write a readonly database</source>
        <translation>Schreibversuch auf eine Datenbank nur zum Lesen</translation>
    </message>
    <message>
        <source>string or blob too big</source>
        <translation>ein zu großer Wert</translation>
    </message>
    <message>
        <source>SQL logic error</source>
        <translation>Fehler in SQL</translation>
    </message>
    <message>
        <source>describes no message: expected lines that begin with BO_; is it a DBC file?</source>
        <translation>beschreibt keine Nachricht: erwartet werden Zeilen, die mit BO_ beginnen; ist es eine DBC-Datei?</translation>
    </message>
    <message>
        <source>the name of a table of words (VAL_TABLE_) is passed over</source>
        <translation>der Name einer Worttabelle (VAL_TABLE_) wird übergangen</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>das Ende der Datei</translation>
    </message>
    <message>
        <source>a message (BO_) before its signals</source>
        <translation>eine Nachricht (BO_) vor ihren Signalen</translation>
    </message>
    <message>
        <source>the keyword of a section (BO_, CM_ …)</source>
        <translation>das Schlüsselwort eines Abschnitts (BO_, CM_ …)</translation>
    </message>
    <message>
        <source>the keyword of a section, such as BO_ or CM_</source>
        <translation>das Schlüsselwort eines Abschnitts wie BO_ oder CM_</translation>
    </message>
    <message>
        <source>the version</source>
        <translation>die Version</translation>
    </message>
    <message>
        <source>what the comment is about</source>
        <translation>der Gegenstand des Kommentars</translation>
    </message>
    <message>
        <source>a comment</source>
        <translation>ein Kommentar</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a raw value</source>
        <translation>ein Rohwert</translation>
    </message>
    <message>
        <source>the word of a raw value</source>
        <translation>das Wort eines Rohwerts</translation>
    </message>
    <message>
        <source>the name of a multiplexor</source>
        <translation>der Name eines Multiplexors</translation>
    </message>
    <message>
        <source>the first value of a multiplexor</source>
        <translation>der erste Wert eines Multiplexors</translation>
    </message>
    <message>
        <source>the last value of a multiplexor</source>
        <translation>der letzte Wert eines Multiplexors</translation>
    </message>
    <message>
        <source>an attribute&apos;s name</source>
        <translation>der Name eines Attributs</translation>
    </message>
    <message>
        <source>the attribute&apos;s value</source>
        <translation>der Wert des Attributs</translation>
    </message>
    <message>
        <source>the attribute&apos;s default</source>
        <translation>der Vorgabewert des Attributs</translation>
    </message>
    <message>
        <source>the message&apos;s identifier</source>
        <translation>die Kennung der Nachricht</translation>
    </message>
    <message>
        <source>the message&apos;s name</source>
        <translation>der Name der Nachricht</translation>
    </message>
    <message>
        <source>the message&apos;s length in bytes</source>
        <translation>die Länge der Nachricht in Bytes</translation>
    </message>
    <message>
        <source>the message&apos;s sender</source>
        <translation>der Sender der Nachricht</translation>
    </message>
    <message>
        <source>a message&apos;s identifier</source>
        <translation>die Kennung einer Nachricht</translation>
    </message>
    <message>
        <source>the signal&apos;s name</source>
        <translation>der Name des Signals</translation>
    </message>
    <message>
        <source>a signal&apos;s name</source>
        <translation>der Name eines Signals</translation>
    </message>
    <message>
        <source>the signal&apos;s first bit</source>
        <translation>das erste Bit des Signals</translation>
    </message>
    <message>
        <source>the signal&apos;s length in bits</source>
        <translation>die Länge des Signals in Bits</translation>
    </message>
    <message>
        <source>the signal&apos;s scale</source>
        <translation>die Skalierung des Signals</translation>
    </message>
    <message>
        <source>the signal&apos;s offset</source>
        <translation>der Offset des Signals</translation>
    </message>
    <message>
        <source>the signal&apos;s unit</source>
        <translation>die Einheit des Signals</translation>
    </message>
    <message>
        <source>closed with the console</source>
        <translation>mit der Konsole geschlossen</translation>
    </message>
    <message>
        <source>the program that recorded ended without closing the session</source>
        <translation>das aufzeichnende Programm endete, ohne die Sitzung zu schließen</translation>
    </message>
    <message>
        <source>from a log of CAN frames</source>
        <translation>aus einem Log von CAN-Rahmen</translation>
    </message>
    <message>
        <source>frames that were lost when the log was recorded</source>
        <translation>Rahmen, die beim Aufzeichnen des Logs verloren gingen</translation>
    </message>
    <message>
        <source>%1 frames and %2 other rows were dropped: the disk was slow or full, or they could not be written</source>
        <translation>%1 Rahmen und %2 andere Zeilen gingen verloren: der Datenträger war langsam oder voll, oder sie ließen sich nicht schreiben</translation>
    </message>
    <message>
        <source>no scene has a known height (columns h_-0.3_m … h_+0.7_m)</source>
        <translation>keine Szene hat eine bekannte Höhe (Spalten h_-0.3_m … h_+0.7_m)</translation>
    </message>
    <message>
        <source>%1 is %2, expected 1e-9 to 1e9</source>
        <translation>%1 ist %2, erwartet wird 1e-9 bis 1e9</translation>
    </message>
    <message>
        <source>%1 is %2, beyond the range from %3 to %4 %5 (%6)</source>
        <translation>%1 ist %2, außerhalb des Bereichs von %3 bis %4 %5 (%6)</translation>
    </message>
    <message>
        <source>%1 must have the line&apos;s name or its offset, not both</source>
        <translation>%1 muss den Namen der Leitung oder ihr offset haben, nicht beides</translation>
    </message>
    <message>
        <source>%1 names a line that the file has used before</source>
        <translation>%1 nennt eine Leitung, die die Datei schon benutzt hat</translation>
    </message>
    <message>
        <source>is the card of another model: of content %1, and the model&apos;s is %2</source>
        <translation>ist die Karte eines anderen Modells: mit Inhalt %1, der des Modells ist %2</translation>
    </message>
    <message>
        <source>%1 is not a height column, expected %2</source>
        <translation>%1 ist keine Höhenspalte, erwartet wird %2</translation>
    </message>
    <message>
        <source>the column %1 appears twice</source>
        <translation>die Spalte %1 kommt zweimal vor</translation>
    </message>
    <message>
        <source>the column %1 is missing; not known: %2</source>
        <translation>die Spalte %1 fehlt; unbekannt: %2</translation>
    </message>
    <message>
        <source>the column %1 is missing</source>
        <translation>die Spalte %1 fehlt</translation>
    </message>
    <message>
        <source>its table meta lacks %1</source>
        <translation>seiner Tabelle meta fehlt %1</translation>
    </message>
    <message>
        <source>the rows of its table %1 are not numbered from 0</source>
        <translation>die Zeilen seiner Tabelle %1 sind nicht ab 0 nummeriert</translation>
    </message>
    <message>
        <source>its table %1 is not numbered from 0</source>
        <translation>seine Tabelle %1 ist nicht ab 0 nummeriert</translation>
    </message>
    <message>
        <source>its table %1 holds a bin that does not exist</source>
        <translation>seine Tabelle %1 enthält ein Feld, das es nicht gibt</translation>
    </message>
    <message>
        <source>its table %1 holds a feature set other than pa and paf</source>
        <translation>seine Tabelle %1 enthält einen anderen Merkmalssatz als pa und paf</translation>
    </message>
    <message>
        <source>a value of the wrong type in %1</source>
        <translation>ein Wert vom falschen Typ in %1</translation>
    </message>
    <message>
        <source>lacks the entry %1</source>
        <translation>ihr fehlt der Eintrag %1</translation>
    </message>
    <message>
        <source>the session&apos;s model %1 (%2…) is not there</source>
        <translation>das Modell der Sitzung %1 (%2…) ist nicht da</translation>
    </message>
    <message>
        <source>%1 is %2…</source>
        <translation>%1 ist %2…</translation>
    </message>
    <message>
        <source>%1 has the wrong number of length scales</source>
        <translation>%1 hat die falsche Zahl von Längenskalen</translation>
    </message>
    <message>
        <source>%1 has the wrong number of inputs</source>
        <translation>%1 hat die falsche Zahl von Eingängen</translation>
    </message>
    <message>
        <source>%1 has not one weight per inducing row</source>
        <translation>%1 hat nicht ein Gewicht je Stützzeile</translation>
    </message>
    <message>
        <source>%1 is not finite</source>
        <translation>%1 ist nicht endlich</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 ist leer</translation>
    </message>
    <message>
        <source>a length scale of %1</source>
        <translation>eine Längenskala (%1)</translation>
    </message>
    <message>
        <source>a standard deviation of %1</source>
        <translation>eine Standardabweichung (%1)</translation>
    </message>
    <message>
        <source>residual_sd of %1</source>
        <translation>residual_sd (%1)</translation>
    </message>
    <message>
        <source>signal_sd of %1</source>
        <translation>signal_sd (%1)</translation>
    </message>
    <message>
        <source>noise_sd of %1</source>
        <translation>noise_sd (%1)</translation>
    </message>
    <message>
        <source>feature set %1, bin %2</source>
        <translation>Merkmalssatz %1, Feld %2</translation>
    </message>
    <message>
        <source>feature set %1</source>
        <translation>Merkmalssatz %1</translation>
    </message>
    <message>
        <source>the message %1 is left out: it has %2 bytes, no frame more than %3</source>
        <translation>die Nachricht %1 ist ausgelassen: sie hat %2 Bytes, kein Rahmen mehr als %3</translation>
    </message>
    <message>
        <source>the message %1 is left out: %2 has its identifier</source>
        <translation>die Nachricht %1 ist ausgelassen: %2 hat ihre Kennung</translation>
    </message>
    <message>
        <source>the signal %1 is left out: its scale is 0</source>
        <translation>das Signal %1 ist ausgelassen: seine Skalierung ist 0</translation>
    </message>
    <message>
        <source>the signal %1 is left out: %2 has another of that name</source>
        <translation>das Signal %1 ist ausgelassen: %2 hat ein anderes dieses Namens</translation>
    </message>
    <message>
        <source>is not of this program: %1 is another or missing; install the file that came with the program</source>
        <translation>ist nicht von diesem Programm: %1 ist anders oder fehlt; die Datei installieren, die zum Programm gehört</translation>
    </message>
    <message>
        <source>%1 frames (%2)</source>
        <translation>%1 Rahmen (%2)</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Rahmen %1</translation>
    </message>
    <message>
        <source>%1, a whole number of at most %2</source>
        <translation>%1, eine ganze Zahl bis %2</translation>
    </message>
    <message>
        <source>%1, a number</source>
        <translation>%1, eine Zahl</translation>
    </message>
    <message>
        <source>a quotation mark at the end of %1</source>
        <translation>ein Anführungszeichen am Ende (%1)</translation>
    </message>
    <message>
        <source>%1 of at most %2 letters, digits and _</source>
        <translation>%1 aus höchstens %2 Buchstaben, Ziffern und _</translation>
    </message>
    <message>
        <source>%1 in quotation marks</source>
        <translation>%1 in Anführungszeichen</translation>
    </message>
    <message>
        <source>%1 behind the message&apos;s name</source>
        <translation>%1 hinter dem Namen der Nachricht</translation>
    </message>
    <message>
        <source>%1 between two values of a multiplexor</source>
        <translation>%1 zwischen zwei Werten eines Multiplexors</translation>
    </message>
    <message>
        <source>%1 behind the signal&apos;s name</source>
        <translation>%1 hinter dem Namen des Signals</translation>
    </message>
    <message>
        <source>%1 behind the signal&apos;s first bit</source>
        <translation>%1 hinter dem ersten Bit des Signals</translation>
    </message>
    <message>
        <source>%1 behind the signal&apos;s length</source>
        <translation>%1 hinter der Länge des Signals</translation>
    </message>
    <message>
        <source>%1 before the signal&apos;s scale</source>
        <translation>%1 vor der Skalierung des Signals</translation>
    </message>
    <message>
        <source>%1 between scale and offset</source>
        <translation>%1 zwischen Skalierung und Offset</translation>
    </message>
    <message>
        <source>%1 behind the signal&apos;s offset</source>
        <translation>%1 hinter dem Offset des Signals</translation>
    </message>
    <message>
        <source>%1 before the signal&apos;s range</source>
        <translation>%1 vor dem Bereich des Signals</translation>
    </message>
    <message>
        <source>%1 behind the signal&apos;s range</source>
        <translation>%1 hinter dem Bereich des Signals</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>nach %1</translation>
    </message>
    <message>
        <source>from %1, %2 frames, last link %3, %4 batches of which are not what was recorded and left out</source>
        <translation>aus %1, %2 Rahmen, letztes Glied %3, davon %4 Blöcke nicht wie aufgezeichnet und ausgelassen</translation>
    </message>
    <message>
        <source>from %1, %2 frames, last link %3</source>
        <translation>aus %1, %2 Rahmen, letztes Glied %3</translation>
    </message>
    <message>
        <source>is longer than %1 bytes</source>
        <translation>ist länger als %1 Bytes</translation>
    </message>
    <message>
        <source>has no time; record with candump -L</source>
        <translation>hat keine Zeit; mit candump -L aufzeichnen</translation>
    </message>
    <message>
        <source>an error frame cannot be a remote frame</source>
        <translation>ein Fehlerrahmen kann keine Anforderung sein</translation>
    </message>
    <message>
        <source>an error frame cannot be a CAN FD frame</source>
        <translation>ein Fehlerrahmen kann kein Rahmen von CAN FD sein</translation>
    </message>
    <message>
        <source>only a classic data frame can be requested</source>
        <translation>nur ein klassischer Datenrahmen kann angefordert werden</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>das Ende der Zeile</translation>
    </message>
    <message>
        <source>the name of an interface</source>
        <translation>der Name einer Schnittstelle</translation>
    </message>
    <message>
        <source>as many bytes as CAN FD can have</source>
        <translation>so viele Bytes, wie CAN FD haben kann</translation>
    </message>
    <message>
        <source>a byte of two hexadecimal digits</source>
        <translation>ein Byte aus zwei hexadezimalen Ziffern</translation>
    </message>
    <message>
        <source>an even number of hexadecimal digits</source>
        <translation>eine gerade Zahl hexadezimaler Ziffern</translation>
    </message>
    <message>
        <source>a digit of flags after ##</source>
        <translation>eine Ziffer mit Merkmalen nach ##</translation>
    </message>
    <message>
        <source>no more than the bytes</source>
        <translation>nichts außer den Bytes</translation>
    </message>
    <message>
        <source>a direction R or T</source>
        <translation>eine Richtung R oder T</translation>
    </message>
    <message>
        <source>the words remote request</source>
        <translation>die Wörter remote request</translation>
    </message>
    <message>
        <source>the word ERRORFRAME</source>
        <translation>das Wort ERRORFRAME</translation>
    </message>
    <message>
        <source>holds no frame</source>
        <translation>enthält keinen Rahmen</translation>
    </message>
    <message>
        <source>holds no frame of %1, only of %2</source>
        <translation>enthält keinen Rahmen von %1, nur von %2</translation>
    </message>
    <message>
        <source>holds frames of %1: name the one to replay with --interface</source>
        <translation>enthält Rahmen von %1: mit --interface nennen, welche wiedergegeben werden soll</translation>
    </message>
    <message>
        <source>a long name</source>
        <translation>ein langer Name</translation>
    </message>
    <message>
        <source>the protocol</source>
        <translation>das Protokoll</translation>
    </message>
    <message>
        <source>a frame format</source>
        <translation>ein Rahmenformat</translation>
    </message>
    <message>
        <source>the number of a frame format</source>
        <translation>die Nummer eines Rahmenformats</translation>
    </message>
    <message>
        <source>is a folder, no log of CAN traffic</source>
        <translation>ist ein Ordner, kein Log von CAN-Verkehr</translation>
    </message>
    <message>
        <source>cannot be unpacked from here on: its packed bytes are damaged</source>
        <translation>lässt sich von hier an nicht entpacken: die gepackten Bytes sind beschädigt</translation>
    </message>
    <message>
        <source>cannot be unpacked: there is no memory</source>
        <translation>lässt sich nicht entpacken: der Speicher reicht nicht</translation>
    </message>
    <message>
        <source>a time, a number that is not negative</source>
        <translation>eine Zeit, eine Zahl, die nicht negativ ist</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>eine Zeit</translation>
    </message>
    <message>
        <source>the number of a channel</source>
        <translation>die Nummer eines Kanals</translation>
    </message>
    <message>
        <source>the number of a bus</source>
        <translation>die Nummer eines Busses</translation>
    </message>
    <message>
        <source>a length code</source>
        <translation>ein Längencode</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>eine Länge</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a line with the columns of the heading</source>
        <translation>eine Zeile mit den Spalten der Kopfzeile</translation>
    </message>
    <message>
        <source>Rx or Tx</source>
        <translation>Rx oder Tx</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>as many bytes as the length says</source>
        <translation>so viele Bytes, wie die Länge sagt</translation>
    </message>
    <message>
        <source>an error frame cannot be of another kind, too</source>
        <translation>ein Fehlerrahmen kann nicht zugleich von anderer Art sein</translation>
    </message>
    <message>
        <source>a CAN FD frame cannot be a remote frame</source>
        <translation>ein Rahmen von CAN FD kann keine Anforderung sein</translation>
    </message>
    <message>
        <source>a binary log of Vector (.blf)</source>
        <translation>ein binäres Log von Vector (.blf)</translation>
    </message>
    <message>
        <source>a measurement file (.mf4, .mdf)</source>
        <translation>eine Messdatei (.mf4, .mdf)</translation>
    </message>
    <message>
        <source>an MCAP file</source>
        <translation>eine MCAP-Datei</translation>
    </message>
    <message>
        <source>a capture of Wireshark (.pcapng)</source>
        <translation>ein Mitschnitt von Wireshark (.pcapng)</translation>
    </message>
    <message>
        <source>a capture of tcpdump (.pcap)</source>
        <translation>ein Mitschnitt von tcpdump (.pcap)</translation>
    </message>
    <message>
        <source>a log of BusMaster</source>
        <translation>ein Log von BusMaster</translation>
    </message>
    <message>
        <source>a log of CRTD</source>
        <translation>ein Log von CRTD</translation>
    </message>
    <message>
        <source>a table, no known log</source>
        <translation>eine Tabelle, kein bekanntes Log</translation>
    </message>
    <message>
        <source>JSON or XML, no known log</source>
        <translation>JSON oder XML, kein bekanntes Log</translation>
    </message>
    <message>
        <source>is a session or another SQLite file; expected a log of CAN frames: session export makes one of a session</source>
        <translation>ist eine Sitzung oder eine andere SQLite-Datei; erwartet wird ein Log von CAN-Rahmen: session export macht eines aus einer Sitzung</translation>
    </message>
    <message>
        <source>is a ZIP archive: unpack it</source>
        <translation>ist ein ZIP-Archiv: es entpacken</translation>
    </message>
    <message>
        <source>is packed by xz: unpack it (xz -d)</source>
        <translation>ist mit xz gepackt: es entpacken (xz -d)</translation>
    </message>
    <message>
        <source>is packed by zstd: unpack it (zstd -d)</source>
        <translation>ist mit zstd gepackt: es entpacken (zstd -d)</translation>
    </message>
    <message>
        <source>is packed by bzip2: unpack it (bzip2 -d)</source>
        <translation>ist mit bzip2 gepackt: es entpacken (bzip2 -d)</translation>
    </message>
    <message>
        <source>is a DBC file, which --dbc reads; expected a log of CAN traffic</source>
        <translation>ist eine DBC-Datei, die --dbc liest; erwartet wird ein Log von CAN-Verkehr</translation>
    </message>
    <message>
        <source>at line %1 the log&apos;s clock was set back by %2 s; the session continues evenly</source>
        <translation>in Zeile %1 wurde die Uhr des Logs um %2 s zurückgestellt; die Sitzung geht gleichmäßig weiter</translation>
    </message>
    <message>
        <source>at line %1 the log&apos;s clock was set forward by %2 s; the session continues evenly</source>
        <translation>in Zeile %1 wurde die Uhr des Logs um %2 s vorgestellt; die Sitzung geht gleichmäßig weiter</translation>
    </message>
    <message>
        <source>its journal %1 cannot be read: %2; both files belong together</source>
        <translation>ihr Journal %1 ist nicht lesbar: %2; beide Dateien gehören zusammen</translation>
    </message>
    <message>
        <source>its journal %1 is not a file; both files belong together</source>
        <translation>ihr Journal %1 ist keine Datei; beide Dateien gehören zusammen</translation>
    </message>
    <message>
        <source>its journal %1 is damaged from its beginning: what was recorded after that was in there</source>
        <translation>ihr Journal %1 ist von Anfang an beschädigt: was danach aufgezeichnet wurde, stand darin</translation>
    </message>
    <message>
        <source>is packed by gzip twice: unpack it once (gzip -d)</source>
        <translation>ist zweimal mit gzip gepackt: einmal entpacken (gzip -d)</translation>
    </message>
    <message>
        <source>is a tar archive: unpack it (tar -xf)</source>
        <translation>ist ein tar-Archiv: entpacken (tar -xf)</translation>
    </message>
    <message>
        <source>the log&apos;s clock was set back %1 more times</source>
        <translation>die Uhr des Logs wurde noch %1 Mal zurückgestellt</translation>
    </message>
    <message>
        <source>the end of the log is torn</source>
        <translation>das Ende des Logs ist abgerissen</translation>
    </message>
    <message>
        <source>is no text in UTF-8 or Windows code page 1252: expected a DBC file; save it again as one</source>
        <translation>ist kein Text in UTF-8 oder der Windows-Codepage 1252: erwartet wird eine DBC-Datei; noch einmal als solche speichern</translation>
    </message>
    <message>
        <source>describes no message: expected lines that begin with BO_; is it a DBC file? First fault: %1</source>
        <translation>beschreibt keine Nachricht: erwartet werden Zeilen, die mit BO_ beginnen; ist es eine DBC-Datei? Erster Fehler: %1</translation>
    </message>
    <message>
        <source>the signal %1 is left out: expected &apos;:&apos; behind its name, or M or a multiplexor&apos;s value such as m1, found %2</source>
        <translation>das Signal %1 entfällt: erwartet wird &apos;:&apos; hinter seinem Namen, oder M oder der Wert eines Multiplexors wie m1, gefunden %2</translation>
    </message>
    <message>
        <source>the message %1 is left out: its identifier %2 is none of CAN; expected at most 2047, or 2147483648 and 29 bits</source>
        <translation>die Nachricht %1 entfällt: ihre Kennung %2 gibt es auf CAN nicht; erwartet wird höchstens 2047, oder 2147483648 und 29 Bits</translation>
    </message>
    <message>
        <source>the signal %1 is left out: it has %2 bits, expected 1 to 64</source>
        <translation>das Signal %1 entfällt: es hat %2 Bits, erwartet werden 1 bis 64</translation>
    </message>
    <message>
        <source>the signal %1 is left out: it does not fit its message %2, it ends with bit %3 of %4</source>
        <translation>das Signal %1 entfällt: es passt nicht in seine Nachricht %2, es endet mit Bit %3 von %4</translation>
    </message>
    <message>
        <source>the signal %1 is left out: it is no %2 of IEEE 754, it has %3 bits, expected %4</source>
        <translation>das Signal %1 entfällt: es ist kein %2 nach IEEE 754, es hat %3 Bits, erwartet werden %4</translation>
    </message>
    <message>
        <source>%1 multiplexed signals of %2 are left out: expected one signal marked M, or what selects them (SG_MUL_VAL_), at most %3 below each other</source>
        <translation>%1 gemultiplexte Signale von %2 entfallen: erwartet wird ein mit M bezeichnetes Signal, oder was sie auswählt (SG_MUL_VAL_), höchstens %3 untereinander</translation>
    </message>
    <message>
        <source>what selects %1 is passed over: its message has no signal %2</source>
        <translation>was %1 auswählt, wird übergangen: seine Nachricht hat kein Signal %2</translation>
    </message>
    <message>
        <source>is %1; expected a log of candump, .asc, .trc, or CSV of GVRET or python-can: export it as one of them</source>
        <translation>ist %1; erwartet wird ein Log von candump, .asc, .trc, oder CSV von GVRET oder python-can: als eines davon exportieren</translation>
    </message>
    <message>
        <source>is %1; expected a log as text: can_logconvert of python-can makes one</source>
        <translation>ist %1; erwartet wird ein Log als Text: can_logconvert von python-can macht eines daraus</translation>
    </message>
    <message>
        <source>%1 sessions (%2 MB) exceed your limits. None is deleted until you allow it on page Settings</source>
        <translation>%1 Sitzungen (%2 MB) überschreiten Ihre Grenzen. Keine wird gelöscht, bis Sie es auf der Seite Einstellungen erlauben</translation>
    </message>
    <message>
        <source>there is no home folder to record in: --sessions names another</source>
        <translation>es gibt keinen Benutzerordner für die Aufzeichnung: --sessions nennt einen anderen</translation>
    </message>
    <message>
        <source>a text is too long</source>
        <translation>ein Text ist zu lang</translation>
    </message>
    <message>
        <source>its rows hold more bytes than the file has: they share pages</source>
        <translation>ihre Zeilen haben mehr Bytes als die Datei: sie teilen sich Seiten</translation>
    </message>
    <message>
        <source>the batches are not in the order of their numbers</source>
        <translation>die Blöcke stehen nicht in der Reihenfolge ihrer Nummern</translation>
    </message>
    <message>
        <source>the rows of a table are not in the order of their numbers</source>
        <translation>die Zeilen einer Tabelle stehen nicht in der Reihenfolge ihrer Nummern</translation>
    </message>
    <message>
        <source>is a symbolic link: name the file itself</source>
        <translation>ist ein symbolischer Link: die Datei selbst nennen</translation>
    </message>
    <message>
        <source>its journal is a symbolic link, which is not followed</source>
        <translation>ihr Journal ist ein symbolischer Link, dem nicht gefolgt wird</translation>
    </message>
    <message>
        <source>its journal is not beside it: both files belong together</source>
        <translation>ihr Journal liegt nicht daneben: beide Dateien gehören zusammen</translation>
    </message>
    <message>
        <source>its settings need %1 chains; the limit is %2</source>
        <translation>ihre Einstellungen verlangen %1 Ketten; die Grenze ist %2</translation>
    </message>
    <message>
        <source>its settings need %1 kept and %2 discarded sweeps; the limit is %3 in total</source>
        <translation>ihre Einstellungen verlangen %1 behaltene und %2 verworfene Durchläufe; die Grenze ist zusammen %3</translation>
    </message>
    <message>
        <source>has too long an entry %1</source>
        <translation>hat einen zu langen Eintrag %1</translation>
    </message>
    <message>
        <source>its journal %1 is not beside it: what was recorded after that is in there; both files belong together</source>
        <translation>ihr Journal %1 liegt nicht daneben: was danach aufgezeichnet wurde, steht darin; beide Dateien gehören zusammen</translation>
    </message>
    <message>
        <source>is empty without its journal %1, which is missing: copy both files</source>
        <translation>ist leer ohne ihr Journal %1, das fehlt: beide Dateien kopieren</translation>
    </message>
    <message>
        <source>is not made: the name of the bus %1 has control characters</source>
        <translation>wird nicht angelegt: der Name des Busses %1 enthält Steuerzeichen</translation>
    </message>
    <message>
        <source>a log of Microchip</source>
        <translation>ein Log von Microchip</translation>
    </message>
    <message>
        <source>the front flippers press on nothing</source>
        <translation>die vorderen Flipper drücken auf nichts</translation>
    </message>
    <message>
        <source>the front flippers reach further than they press</source>
        <translation>die vorderen Flipper reichen weiter, als sie aufdrücken</translation>
    </message>
    <message>
        <source>the front flippers span ground that they do not press</source>
        <translation>die vorderen Flipper überspannen Boden, auf den sie nicht drücken</translation>
    </message>
    <message>
        <source>lay the front flippers flatter</source>
        <translation>die vorderen Flipper flacher legen</translation>
    </message>
    <message>
        <source>is an SQLite file, not text</source>
        <translation>ist eine SQLite-Datei, kein Text</translation>
    </message>
    <message>
        <source>the fields are separated by |</source>
        <translation>die Felder sind durch | getrennt</translation>
    </message>
    <message>
        <source>the fields are separated by blanks</source>
        <translation>die Felder sind durch Leerzeichen getrennt</translation>
    </message>
    <message>
        <source>the fields are separated in more than one way</source>
        <translation>die Felder sind auf mehr als eine Art getrennt</translation>
    </message>
    <message>
        <source>has text behind a closing quote</source>
        <translation>hat Text hinter einem schließenden Anführungszeichen</translation>
    </message>
    <message>
        <source>nothing was recorded</source>
        <translation>nichts wurde aufgezeichnet</translation>
    </message>
    <message>
        <source>nothing was recorded from %1 s to %2 s</source>
        <translation>von %1 s bis %2 s wurde nichts aufgezeichnet</translation>
    </message>
    <message>
        <source>nothing was recorded from %1 s on</source>
        <translation>ab %1 s wurde nichts aufgezeichnet</translation>
    </message>
    <message>
        <source>nothing was recorded until %1 s</source>
        <translation>bis %1 s wurde nichts aufgezeichnet</translation>
    </message>
    <message>
        <source>no frames</source>
        <translation>keine Rahmen</translation>
    </message>
    <message>
        <source>no signals</source>
        <translation>keine Signale</translation>
    </message>
    <message>
        <source>no estimates</source>
        <translation>keine Schätzungen</translation>
    </message>
    <message>
        <source>no events</source>
        <translation>keine Ereignisse</translation>
    </message>
    <message>
        <source>the session lasts %1 s</source>
        <translation>die Sitzung dauert %1 s</translation>
    </message>
    <message>
        <source>%1 is %2, expected a number, or its unit %3</source>
        <translation>%1 ist %2, erwartet wurde eine Zahl oder ihre Einheit %3</translation>
    </message>
    <message>
        <source>pitch angle</source>
        <translation>Nickwinkel</translation>
    </message>
    <message>
        <source>roll angle</source>
        <translation>Rollwinkel</translation>
    </message>
    <message>
        <source>front left flipper angle</source>
        <translation>Winkel des Flippers vorn links</translation>
    </message>
    <message>
        <source>front right flipper angle</source>
        <translation>Winkel des Flippers vorn rechts</translation>
    </message>
    <message>
        <source>rear left flipper angle</source>
        <translation>Winkel des Flippers hinten links</translation>
    </message>
    <message>
        <source>rear right flipper angle</source>
        <translation>Winkel des Flippers hinten rechts</translation>
    </message>
    <message>
        <source>front left flipper current</source>
        <translation>Strom des Flippers vorn links</translation>
    </message>
    <message>
        <source>front right flipper current</source>
        <translation>Strom des Flippers vorn rechts</translation>
    </message>
    <message>
        <source>rear left flipper current</source>
        <translation>Strom des Flippers hinten links</translation>
    </message>
    <message>
        <source>rear right flipper current</source>
        <translation>Strom des Flippers hinten rechts</translation>
    </message>
    <message>
        <source>track odometry</source>
        <translation>Odometrie der Ketten</translation>
    </message>
    <message>
        <source>not changed for %1 s while the robot drove %2 m, stuck?</source>
        <translation>unverändert seit %1 s, während der Roboter %2 m fuhr, hängt er?</translation>
    </message>
    <message>
        <source>not changed for %1 s, not even by noise, stuck?</source>
        <translation>unverändert seit %1 s, auch ohne Rauschen, hängt er?</translation>
    </message>
    <message>
        <source>jumps away and comes back, loose contact?</source>
        <translation>springt weg und zurück, Wackelkontakt?</translation>
    </message>
    <message>
        <source>reads what the robot cannot do</source>
        <translation>zeigt, was der Roboter nicht kann</translation>
    </message>
    <message>
        <source>changes the wrong way, sign flipped?</source>
        <translation>ändert sich falsch herum, Vorzeichen vertauscht?</translation>
    </message>
    <message>
        <source>moves with the other axle, front and rear swapped?</source>
        <translation>bewegt sich mit der anderen Achse, vorn und hinten vertauscht?</translation>
    </message>
    <message>
        <source>still changes when the robot stands still, late?</source>
        <translation>ändert sich noch, wenn der Roboter steht, verspätet?</translation>
    </message>
    <message>
        <source>no load while the flippers press, disconnected?</source>
        <translation>keine Last, während die Flipper drücken, nicht verbunden?</translation>
    </message>
    <message>
        <source>loaded while nothing presses, drifted?</source>
        <translation>belastet, obwohl nichts drückt, weggedriftet?</translation>
    </message>
    <message>
        <source>left and right differ by the same at every press</source>
        <translation>links und rechts unterscheiden sich bei jedem Andrücken gleich</translation>
    </message>
    <message>
        <source>does not fit the ground driven over, offset or sign flipped?</source>
        <translation>passt nicht zum überfahrenen Boden, verschoben oder Vorzeichen vertauscht?</translation>
    </message>
    <message>
        <source>load where no ground was, order reversed?</source>
        <translation>Last, wo kein Boden war, Reihenfolge umgekehrt?</translation>
    </message>
    <message>
        <source>does not fit the same ground driven in both directions, zero shifted?</source>
        <translation>passt nicht zum selben Boden in beiden Richtungen, Nullpunkt verschoben?</translation>
    </message>
    <message>
        <source>a sensor may be wrong, see the alarms</source>
        <translation>ein Sensor misst vielleicht falsch, siehe Alarme</translation>
    </message>
    <message>
        <source>the estimate contradicts the readings</source>
        <translation>die Schätzung widerspricht den Messwerten</translation>
    </message>
    <message>
        <source>the estimate contradicts the readings: pitch %1° measured, %2° on its ground; front flippers %3° measured, %4° on its ground</source>
        <translation>die Schätzung widerspricht den Messwerten: Nickwinkel gemessen %1°, auf ihrem Boden %2°; vordere Flipper gemessen %3°, auf ihrem Boden %4°</translation>
    </message>
    <message>
        <source>no force was measured: the bands are wider</source>
        <translation>es wurde keine Kraft gemessen: die Bänder sind breiter</translation>
    </message>
    <message>
        <source>the force of element %1 was not measured: the bands are wider</source>
        <translation>die Kraft von Element %1 wurde nicht gemessen: die Bänder sind breiter</translation>
    </message>
    <message>
        <source>no flipper current was measured: the bands are wider</source>
        <translation>es wurde kein Flipperstrom gemessen: die Bänder sind breiter</translation>
    </message>
    <message>
        <source>the front flippers&apos; current was not measured: the bands are wider</source>
        <translation>der Strom der vorderen Flipper wurde nicht gemessen: die Bänder sind breiter</translation>
    </message>
    <message>
        <source>the rear flippers&apos; current was not measured: the bands are wider</source>
        <translation>der Strom der hinteren Flipper wurde nicht gemessen: die Bänder sind breiter</translation>
    </message>
    <message>
        <source>method clearance needs every current and force: local estimates</source>
        <translation>die Methode clearance braucht alle Ströme und Kräfte: local schätzt</translation>
    </message>
    <message>
        <source>the processes use pitch and flipper angles alone</source>
        <translation>die Prozesse nutzen nur Nicken und Flipperwinkel</translation>
    </message>
    <message>
        <source>is longer than %1 bytes: this is no log of CAN frames as text</source>
        <translation>ist länger als %1 Bytes: das ist kein Log von CAN-Rahmen als Text</translation>
    </message>
    <message>
        <source>%1: %2 is not a whole number</source>
        <translation>%1: %2 ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>%1: the column %2 is not known and was left out</source>
        <translation>%1: die Spalte %2 ist nicht bekannt und wurde ausgelassen</translation>
    </message>
    <message>
        <source>run is longer than %1 bytes: %2</source>
        <translation>run ist länger als %1 Bytes: %2</translation>
    </message>
    <message>
        <source>run is not text in UTF-8: %1: save the file as CSV in UTF-8</source>
        <translation>run ist kein Text in UTF-8: %1: die Datei als CSV in UTF-8 speichern</translation>
    </message>
    <message>
        <source>run is not a name: %1: it holds a comma, a quote or a control character</source>
        <translation>run ist kein Name: %1: er enthält ein Komma, ein Anführungszeichen oder ein Steuerzeichen</translation>
    </message>
    <message>
        <source>%1: the last line has no line end; it was read as it is</source>
        <translation>%1: die letzte Zeile hat kein Zeilenende; sie wurde gelesen, wie sie ist</translation>
    </message>
    <message>
        <source>%1: %2 is not the name of a method: %3</source>
        <translation>%1: %2 ist nicht der Name einer Methode: %3</translation>
    </message>
    <message>
        <source>%1: %2 is not a date such as 2026-11-22T07:05:00Z: %3</source>
        <translation>%1: %2 ist kein Datum wie 2026-11-22T07:05:00Z: %3</translation>
    </message>
    <message>
        <source>%1: %2 is not a SHA-256: %3</source>
        <translation>%1: %2 ist kein SHA-256: %3</translation>
    </message>
    <message>
        <source>%1: %2 is not a table</source>
        <translation>%1: %2 ist keine Tabelle</translation>
    </message>
    <message>
        <source>has %1 training rows, expected 1 to %2</source>
        <translation>hat %1 Trainingszeilen, erwartet werden 1 bis %2</translation>
    </message>
    <message>
        <source>training row %1: %2</source>
        <translation>Trainingszeile %1: %2</translation>
    </message>
    <message>
        <source>mean of %1 is out of range</source>
        <translation>der Mittelwert (%1) liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>a weight of %1 is out of range</source>
        <translation>ein Gewicht (%1) liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>contact_bias is out of range</source>
        <translation>contact_bias liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>scanned row: %1</source>
        <translation>gescannte Zeile: %1</translation>
    </message>
    <message>
        <source>noise_sd of %1 is out of range</source>
        <translation>noise_sd (%1) liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>log_likelihood of %1 is not finite</source>
        <translation>log_likelihood (%1) ist nicht endlich</translation>
    </message>
    <message>
        <source>a mean of %1 is out of range</source>
        <translation>ein Mittelwert (%1) liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>holds a bin that is not in its list of bins</source>
        <translation>enthält ein Feld, das nicht in seiner Liste der Felder steht</translation>
    </message>
    <message>
        <source>holds residuals of a bin that is not in its list of bins</source>
        <translation>enthält Residuen eines Feldes, das nicht in seiner Liste der Felder steht</translation>
    </message>
    <message>
        <source>holds what only a whole model has</source>
        <translation>enthält, was nur ein ganzes Modell hat</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>kann nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>its seed is not a number: %1</source>
        <translation>sein Startwert ist keine Zahl: %1</translation>
    </message>
    <message>
        <source>its list of bins is wrong: %1</source>
        <translation>seine Liste der Felder ist falsch: %1</translation>
    </message>
    <message>
        <source>has %1 rows in its table %2, expected 1 to %3</source>
        <translation>hat %1 Zeilen in seiner Tabelle %2, erwartet werden 1 bis %3</translation>
    </message>
    <message>
        <source>its structure is damaged: %1</source>
        <translation>ihr Aufbau ist beschädigt: %1</translation>
    </message>
    <message>
        <source>a message is no JSON</source>
        <translation>eine Nachricht ist kein JSON</translation>
    </message>
    <message>
        <source>nothing of a session is whole in it</source>
        <translation>nichts von einer Sitzung ist darin ganz</translation>
    </message>
    <message>
        <source>its start is no time: %1</source>
        <translation>ihr Beginn ist keine Zeit: %1</translation>
    </message>
    <message>
        <source>is a session of format version %1, and this program reads versions %2 to %3</source>
        <translation>ist eine Sitzung der Formatversion %1, und dieses Programm liest die Versionen %2 bis %3</translation>
    </message>
    <message>
        <source>it has as many batches as a session can have</source>
        <translation>sie hat so viele Blöcke, wie eine Sitzung haben kann</translation>
    </message>
    <message>
        <source>recording into it has ended</source>
        <translation>die Aufzeichnung darin ist beendet</translation>
    </message>
    <message>
        <source>is open in another program, so its journal stays beside it</source>
        <translation>ist in einem anderen Programm geöffnet, daher bleibt ihr Journal daneben</translation>
    </message>
    <message>
        <source>%1: %2 holds a polygon that is not convex</source>
        <translation>%1: %2 enthält ein Vieleck, das nicht konvex ist</translation>
    </message>
    <message>
        <source>%1: %2 must rise in force and fall in resistance from point to point</source>
        <translation>%1: %2 muss von Punkt zu Punkt in der Kraft steigen und im Widerstand fallen</translation>
    </message>
    <message>
        <source>%1: %2 does not increase from pivot to tip</source>
        <translation>%1: %2 wächst nicht vom Drehpunkt zur Spitze</translation>
    </message>
    <message>
        <source>%1: %2 holds %3, expected whole numbers</source>
        <translation>%1: %2 enthält %3, erwartet werden ganze Zahlen</translation>
    </message>
    <message>
        <source>%1: %2 names element %3 of that side again, expected one array for each</source>
        <translation>%1: %2 nennt Element %3 dieser Seite noch einmal, erwartet wird für jedes ein force_array</translation>
    </message>
    <message>
        <source>%1: %2 is %3, expected at most %4 bytes</source>
        <translation>%1: %2 ist %3, erwartet werden höchstens %4 Bytes</translation>
    </message>
    <message>
        <source>%1: no force_array has element %2, expected each of 1 to 6 left, right or on both sides</source>
        <translation>%1: kein force_array hat das Element %2, erwartet wird jedes von 1 bis 6 links, rechts oder auf beiden Seiten</translation>
    </message>
    <message>
        <source>%1: force_array is no list of tables, expected [[force_array]]</source>
        <translation>%1: force_array ist keine Liste von Tabellen, erwartet wird [[force_array]]</translation>
    </message>
    <message>
        <source>%1: one [[force_array]] more than the %2 expected at most</source>
        <translation>%1: ein [[force_array]] mehr als die höchstens erwarteten %2</translation>
    </message>
    <message>
        <source>%1: force_array holds no table</source>
        <translation>%1: force_array enthält keine Tabelle</translation>
    </message>
    <message>
        <source>%1: %2 is %3 again, expected a name of its own for each array</source>
        <translation>%1: %2 ist noch einmal %3, erwartet wird für jedes force_array ein eigener Name</translation>
    </message>
    <message>
        <source>%1: %2 is not a number, expected a number from %3 to %4</source>
        <translation>%1: %2 ist keine Zahl, erwartet wird eine Zahl von %3 bis %4</translation>
    </message>
    <message>
        <source>%1: %2 is %3, expected a number from %4 to %5</source>
        <translation>%1: %2 ist %3, erwartet wird eine Zahl von %4 bis %5</translation>
    </message>
    <message>
        <source>%1: %2 is not an array of %3 elements</source>
        <translation>%1: %2 ist keine Liste von %3 Elementen</translation>
    </message>
    <message>
        <source>%1: %2 is not an array of %3 to %4 elements</source>
        <translation>%1: %2 ist keine Liste von %3 bis %4 Elementen</translation>
    </message>
    <message>
        <source>%1: %2 is not a text of 1 to 100 characters, none of them a control character</source>
        <translation>%1: %2 ist kein Text von 1 bis 100 Zeichen ohne Steuerzeichen</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>%1: %2 is %3, expected %4</source>
        <translation>%1: %2 ist %3, erwartet wird %4</translation>
    </message>
    <message>
        <source>%1: %2 is not a known key</source>
        <translation>%1: %2 ist kein bekannter Schlüssel</translation>
    </message>
    <message>
        <source>line %1: is not TOML: %2</source>
        <translation>Zeile %1: ist kein TOML: %2</translation>
    </message>
    <message>
        <source>is text in UTF-16: save it as CSV in UTF-8</source>
        <translation>ist Text in UTF-16: speichern Sie ihn als CSV in UTF-8</translation>
    </message>
    <message>
        <source>is text in UTF-32: save it as CSV in UTF-8</source>
        <translation>ist Text in UTF-32: speichern Sie ihn als CSV in UTF-8</translation>
    </message>
    <message>
        <source>is a workbook or an archive, not text: save the sheet as CSV in UTF-8</source>
        <translation>ist eine Arbeitsmappe oder ein Archiv, kein Text: speichern Sie das Blatt als CSV in UTF-8</translation>
    </message>
    <message>
        <source>is a workbook of an office program, not text: save the sheet as CSV in UTF-8</source>
        <translation>ist eine Arbeitsmappe eines Büroprogramms, kein Text: speichern Sie das Blatt als CSV in UTF-8</translation>
    </message>
    <message>
        <source>is compressed by gzip, not text: unpack it first</source>
        <translation>ist mit gzip komprimiert, kein Text: entpacken Sie sie zuerst</translation>
    </message>
    <message>
        <source>is a PDF, not text: export the numbers as CSV</source>
        <translation>ist ein PDF, kein Text: exportieren Sie die Zahlen als CSV</translation>
    </message>
    <message>
        <source>is a recorded session, not text: terratact session scenes writes its scenes as CSV</source>
        <translation>ist eine aufgezeichnete Sitzung, kein Text: terratact session scenes schreibt ihre Szenen als CSV</translation>
    </message>
    <message>
        <source>holds bytes of value 0, which no text in UTF-8 does: save it as CSV in UTF-8</source>
        <translation>enthält Bytes mit dem Wert 0, wie kein Text in UTF-8: speichern Sie ihn als CSV in UTF-8</translation>
    </message>
    <message>
        <source>line 1: names a separator that is no comma, semicolon or tab</source>
        <translation>Zeile 1: nennt ein Trennzeichen, das weder Komma, Semikolon noch Tabulator ist</translation>
    </message>
    <message>
        <source>line %1: %2: save them separated by commas, numbers with a point</source>
        <translation>Zeile %1: %2: speichern Sie sie durch Kommas getrennt, Zahlen mit Punkt</translation>
    </message>
    <message>
        <source>%1: are there decimal commas? save numbers with a point</source>
        <translation>%1: gibt es Dezimalkommas? Speichern Sie Zahlen mit Punkt</translation>
    </message>
    <message>
        <source>%1 is not measured: %2</source>
        <translation>%1 ist nicht gemessen: %2</translation>
    </message>
    <message>
        <source>%1 is not a number: %2: save numbers with a point, and nothing between thousands</source>
        <translation>%1 ist keine Zahl: %2: speichern Sie Zahlen mit Punkt und ohne Tausendertrennung</translation>
    </message>
    <message>
        <source>%1 is %2, and line %3 has a decimal comma: save all numbers with a decimal point</source>
        <translation>%1 ist %2, und Zeile %3 hat ein Dezimalkomma: speichern Sie alle Zahlen mit Dezimalpunkt</translation>
    </message>
    <message>
        <source>%1 is %2, and line %3 has a decimal point: save all numbers with a decimal point</source>
        <translation>%1 ist %2, und Zeile %3 hat einen Dezimalpunkt: speichern Sie alle Zahlen mit Dezimalpunkt</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2</source>
        <translation>%1: lässt sich nicht schreiben: %2</translation>
    </message>
    <message>
        <source>a recorded session is there, which is never replaced: name another file</source>
        <translation>dort ist eine aufgezeichnete Sitzung, die nie ersetzt wird: nennen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>it is write-protected: name another file</source>
        <translation>sie ist schreibgeschützt: nennen Sie eine andere Datei</translation>
    </message>
    <message>
        <source>%1: the directory cannot be made: %2</source>
        <translation>%1: der Ordner lässt sich nicht anlegen: %2</translation>
    </message>
    <message>
        <source>is a pipe or a device, which is read only once, and this is read twice: save it as a file first</source>
        <translation>ist eine Pipe oder ein Gerät, das nur einmal gelesen wird, und dies wird zweimal gelesen: speichern Sie es zuerst als Datei</translation>
    </message>
    <message>
        <source>malformed database schema %1</source>
        <translation>fehlerhaftes Datenbankschema %1</translation>
    </message>
    <message>
        <source>it is not a regular file, and an SQLite file is read back and forth: save it as a file first</source>
        <translation>ist keine gewöhnliche Datei, und eine SQLite-Datei wird vor und zurück gelesen: speichern Sie es zuerst als Datei</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>lässt sich nicht öffnen: %1</translation>
    </message>
    <message>
        <source>has no size: %1</source>
        <translation>hat keine Größe: %1</translation>
    </message>
    <message>
        <source>cannot be created: %1</source>
        <translation>lässt sich nicht anlegen: %1</translation>
    </message>
    <message>
        <source>the date is not understood: times count from 0</source>
        <translation>das Datum ist nicht verständlich: die Zeiten zählen ab 0</translation>
    </message>
    <message>
        <source>a length from 0 to 8</source>
        <translation>eine Länge von 0 bis 8</translation>
    </message>
    <message>
        <source>0 or 1 for the flags BRS and ESI</source>
        <translation>0 oder 1 für die Bits BRS und ESI</translation>
    </message>
    <message>
        <source>a time like (1436509052.249713)</source>
        <translation>eine Zeit wie (1436509052.249713)</translation>
    </message>
    <message>
        <source>a time like (2025-01-10 12:34:56.249713)</source>
        <translation>eine Zeit wie (2025-01-10 12:34:56.249713)</translation>
    </message>
    <message>
        <source>an identifier of 3 or 8 hexadecimal digits</source>
        <translation>eine Kennung aus 3 oder 8 hexadezimalen Ziffern</translation>
    </message>
    <message>
        <source>a standard identifier up to 7FF</source>
        <translation>eine Standardkennung bis 7FF</translation>
    </message>
    <message>
        <source>an identifier up to 3FFFFFFF</source>
        <translation>eine Kennung bis 3FFFFFFF</translation>
    </message>
    <message>
        <source>a length from 0 to 8 after R</source>
        <translation>eine Länge von 0 bis 8 nach R</translation>
    </message>
    <message>
        <source>a length like [5]</source>
        <translation>eine Länge wie [5]</translation>
    </message>
    <message>
        <source>as many bytes in base 64 as dlc says</source>
        <translation>so viele Bytes in Base 64, wie dlc sagt</translation>
    </message>
    <message>
        <source>%1; this entry is left out</source>
        <translation>%1; dieser Eintrag ist ausgelassen</translation>
    </message>
    <message>
        <source>line %1: expected %2, found %3</source>
        <translation>Zeile %1: erwartet: %2, gefunden: %3</translation>
    </message>
    <message>
        <source>0 (integer), 1 (float) or 2 (double)</source>
        <translation>0 (ganze Zahl), 1 (float) oder 2 (double)</translation>
    </message>
    <message>
        <source>is not UTF-8: read as Windows code page 1252; if characters look wrong, save it as UTF-8</source>
        <translation>ist kein UTF-8: nach Windows-Codepage 1252 gelesen; wenn Zeichen falsch aussehen, als UTF-8 speichern</translation>
    </message>
    <message>
        <source>the byte order, 1 (little-endian) or 0</source>
        <translation>die Bytereihenfolge, 1 (little-endian) oder 0</translation>
    </message>
    <message>
        <source>%1 or &apos;-&apos; behind the byte order</source>
        <translation>%1 oder &apos;-&apos; hinter der Bytereihenfolge</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>ist nicht lesbar: %1</translation>
    </message>
    <message>
        <source>a log of NMEA 2000 of canboat</source>
        <translation>ein Log von NMEA 2000 von canboat</translation>
    </message>
    <message>
        <source>a bag of ROS</source>
        <translation>eine Aufzeichnung von ROS (bag)</translation>
    </message>
    <message>
        <source>the packed log is torn behind it: what came before is read</source>
        <translation>das gepackte Log ist dahinter abgerissen: gelesen wird, was davor kam</translation>
    </message>
    <message>
        <source>the packed log is torn before its first line</source>
        <translation>das gepackte Log ist vor seiner ersten Zeile abgerissen</translation>
    </message>
    <message>
        <source>bytes behind the packed log are not gzip and are left out</source>
        <translation>hinter dem gepackten Log stehen Bytes, die kein gzip sind; sie sind ausgelassen</translation>
    </message>
    <message>
        <source>the clock is set %1 more times</source>
        <translation>die Uhr wird noch %1-mal gestellt</translation>
    </message>
    <message>
        <source>%1 of %2 times are no later than the one before, from 0 on: is this a log of candump -td, whose times are wrong here? Record with candump -L</source>
        <translation>%1 von %2 Zeiten sind nicht später als die vorige, ab 0: ist das ein Log von candump -td, dessen Zeiten hier falsch sind? Mit candump -L aufzeichnen</translation>
    </message>
    <message>
        <source>line %1 holds no frame and is passed over</source>
        <translation>Zeile %1 enthält keinen Rahmen und wird übergangen</translation>
    </message>
    <message>
        <source>%1 lines hold no frame and are passed over, the first is line %2</source>
        <translation>%1 Zeilen enthalten keinen Rahmen und werden übergangen, die erste ist Zeile %2</translation>
    </message>
    <message>
        <source>%1 s later than the line before: was the clock set? The silence is left out</source>
        <translation>%1 s später als die Zeile davor: wurde die Uhr gestellt? Die Stille ist ausgelassen</translation>
    </message>
    <message>
        <source>%1 s earlier than the line before: was the clock set, or is this a log of candump -td?</source>
        <translation>%1 s früher als die Zeile davor: wurde die Uhr gestellt, oder ist das ein Log von candump -td?</translation>
    </message>
    <message>
        <source>%1 s earlier than the line before: was the clock set?</source>
        <translation>%1 s früher als die Zeile davor: wurde die Uhr gestellt?</translation>
    </message>
    <message>
        <source>has no line end: it is read, but may be truncated</source>
        <translation>hat kein Zeilenende: sie wird gelesen, ist aber vielleicht abgeschnitten</translation>
    </message>
    <message>
        <source>has no line end and holds no frame: it may be torn</source>
        <translation>hat kein Zeilenende und keinen Rahmen: sie ist vielleicht abgerissen</translation>
    </message>
    <message>
        <source>is torn: the log ends within it; what came before is read</source>
        <translation>ist abgerissen: das Log endet darin; gelesen wird, was davor kam</translation>
    </message>
    <message>
        <source>at most 8 bytes</source>
        <translation>höchstens 8 Bytes</translation>
    </message>
    <message>
        <source>a byte from 0 to 255</source>
        <translation>ein Byte von 0 bis 255</translation>
    </message>
    <message>
        <source>an identifier up to 1FFFFFFF</source>
        <translation>eine Kennung bis 1FFFFFFF</translation>
    </message>
    <message>
        <source>the start time is not understood: times count from 0</source>
        <translation>die Startzeit ist nicht verständlich: die Zeiten zählen ab 0</translation>
    </message>
    <message>
        <source>the number of a frame, such as 1)</source>
        <translation>die Nummer eines Rahmens, etwa 1)</translation>
    </message>
    <message>
        <source>is no file, and too long to be kept: copy it to one</source>
        <translation>ist keine Datei, und zu lang, um behalten zu werden: in eine Datei kopieren</translation>
    </message>
    <message>
        <source>follows %1 s of silence, which the replay shortens to %2 s</source>
        <translation>folgt auf %1 s Stille, die die Wiedergabe auf %2 s verkürzt</translation>
    </message>
    <message>
        <source>has lost its time: the log has changed</source>
        <translation>hat ihre Zeit verloren: das Log hat sich geändert</translation>
    </message>
    <message>
        <source>%1: a replay takes no commands</source>
        <translation>%1: eine Wiedergabe nimmt keine Befehle an</translation>
    </message>
    <message>
        <source>is no regular file, which would be waited for: copy it to one</source>
        <translation>ist keine gewöhnliche Datei, auf sie würde gewartet: in eine Datei kopieren</translation>
    </message>
    <message>
        <source>%1: ignored; the robot&apos;s protocol already uses this identifier</source>
        <translation>%1: ignoriert; das Protokoll des Roboters hat diese Kennung schon</translation>
    </message>
    <message>
        <source>%1: ignored; %2 already describes it</source>
        <translation>%1: ignoriert; %2 beschreibt das schon</translation>
    </message>
    <message>
        <source>%1 scenes with unknown values left out</source>
        <translation>ausgelassene Szenen mit unbekannten Werten: %1</translation>
    </message>
    <message>
        <source>%1 scenes are there twice: their copies were left out</source>
        <translation>%1 Szenen sind doppelt vorhanden: ihre Kopien wurden ausgelassen</translation>
    </message>
    <message>
        <source>%1 scenes for each conditional, whose training grows with their cube: --inducing 1200 predicts nearly as well and trains in a fraction of the time</source>
        <translation>%1 Szenen für jede bedingte Vorhersage, deren Training mit ihrer dritten Potenz wächst: --inducing 1200 sagt fast so gut vorher und trainiert in einem Bruchteil der Zeit</translation>
    </message>
    <message>
        <source>none of the frames can be written in this format: %1 left out</source>
        <translation>keiner der Rahmen kann in diesem Format geschrieben werden: %1 ausgelassen</translation>
    </message>
    <message>
        <source>a log of CAN frames holds nothing else; csv and mcap do</source>
        <translation>ein Log von CAN-Rahmen enthält nichts anderes; csv und mcap schon</translation>
    </message>
    <message>
        <source>not written: ended before it was whole</source>
        <translation>nicht geschrieben: endete, bevor es ganz war</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>estimate %1: its scene is not there</source>
        <translation>Schätzung %1: ihre Szene ist nicht da</translation>
    </message>
    <message>
        <source>estimate %1: %2</source>
        <translation>Schätzung %1: %2</translation>
    </message>
    <message>
        <source>is no file of notes: expected the columns t_s,note</source>
        <translation>ist keine Datei mit Notizen: erwartet werden die Spalten t_s,note</translation>
    </message>
    <message>
        <source>drive on 0.1 m and explore again</source>
        <translation>0.1 m weiterfahren und erneut erkunden</translation>
    </message>
    <message>
        <source>force 1</source>
        <translation>Kraft 1</translation>
    </message>
    <message>
        <source>force 2</source>
        <translation>Kraft 2</translation>
    </message>
    <message>
        <source>force 3</source>
        <translation>Kraft 3</translation>
    </message>
    <message>
        <source>force 4</source>
        <translation>Kraft 4</translation>
    </message>
    <message>
        <source>force 5</source>
        <translation>Kraft 5</translation>
    </message>
    <message>
        <source>force 6</source>
        <translation>Kraft 6</translation>
    </message>
    <message>
        <source>left force 1</source>
        <translation>linke Kraft 1</translation>
    </message>
    <message>
        <source>left force 2</source>
        <translation>linke Kraft 2</translation>
    </message>
    <message>
        <source>left force 3</source>
        <translation>linke Kraft 3</translation>
    </message>
    <message>
        <source>left force 4</source>
        <translation>linke Kraft 4</translation>
    </message>
    <message>
        <source>left force 5</source>
        <translation>linke Kraft 5</translation>
    </message>
    <message>
        <source>left force 6</source>
        <translation>linke Kraft 6</translation>
    </message>
    <message>
        <source>right force 1</source>
        <translation>rechte Kraft 1</translation>
    </message>
    <message>
        <source>right force 2</source>
        <translation>rechte Kraft 2</translation>
    </message>
    <message>
        <source>right force 3</source>
        <translation>rechte Kraft 3</translation>
    </message>
    <message>
        <source>right force 4</source>
        <translation>rechte Kraft 4</translation>
    </message>
    <message>
        <source>right force 5</source>
        <translation>rechte Kraft 5</translation>
    </message>
    <message>
        <source>right force 6</source>
        <translation>rechte Kraft 6</translation>
    </message>
    <message>
        <source>%1: the disk is full; recording continues when there is space</source>
        <translation>%1: der Datenträger ist voll; die Aufnahme geht weiter, sobald Platz ist</translation>
    </message>
    <message>
        <source>its number of repeated rows is out of range</source>
        <translation>seine Zahl wiederholter Zeilen liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>%1 scenes repeat a place within the sensors&apos; noise; training counts each place once (runs %2)</source>
        <translation>%1 Szenen wiederholen einen Ort innerhalb des Rauschens der Sensoren; das Training zählt jeden Ort einmal (Fahrten %2)</translation>
    </message>
    <message>
        <source>unlike the training scenes: %1 times the distance that 1 % of them exceed</source>
        <translation>anders als die Trainingsszenen: das %1-Fache des Abstands, den 1 % davon überschreiten</translation>
    </message>
    <message>
        <source>time was out %1 sweeps before the burn-in&apos;s end: the draws depend on where the chains started</source>
        <translation>die Zeit war %1 Durchläufe vor dem Ende der Einlaufphase um: die Ziehungen hängen vom Start der Ketten ab</translation>
    </message>
    <message>
        <source>bin %1 m under the robot was seen in %2 training scenes, and %3 are needed</source>
        <translation>das Feld %1 m unter dem Roboter kam in %2 Trainingsszenen vor, und %3 sind nötig</translation>
    </message>
    <message>
        <source>bin %1 m with no robot above it was seen in %2 training scenes, and %3 are needed</source>
        <translation>das Feld %1 m ohne Roboter darüber kam in %2 Trainingsszenen vor, und %3 sind nötig</translation>
    </message>
    <message>
        <source>the frame was cut short</source>
        <translation>der Rahmen wurde abgeschnitten</translation>
    </message>
    <message>
        <source>the kernel has no CAN here: load it (sudo modprobe can_raw), or use another kernel</source>
        <translation>der Kernel hat hier kein CAN: laden (sudo modprobe can_raw), oder einen anderen Kernel benutzen</translation>
    </message>
    <message>
        <source>this process may not open CAN sockets: a sandbox or container forbids it, start it outside (or: sudo setcap cap_net_raw+ep PROGRAM)</source>
        <translation>dieser Prozess darf keine CAN-Sockets öffnen: eine Sandbox oder ein Container verbietet es, außerhalb starten (oder: sudo setcap cap_net_raw+ep PROGRAM)</translation>
    </message>
    <message>
        <source>no socket: %1</source>
        <translation>kein Socket: %1</translation>
    </message>
    <message>
        <source>is no CAN interface (ip -brief link show type can lists those)</source>
        <translation>ist keine CAN-Schnittstelle (ip -brief link show type can zeigt diese)</translation>
    </message>
    <message>
        <source>the kernel&apos;s CAN is too old: %1</source>
        <translation>das CAN des Kernels ist zu alt: %1</translation>
    </message>
    <message>
        <source>not bound: %1</source>
        <translation>nicht gebunden: %1</translation>
    </message>
    <message>
        <source>its lines have no names: give offset instead</source>
        <translation>seine Leitungen haben keine Namen: bitte statt dessen offset angeben</translation>
    </message>
    <message>
        <source>it has %1 and more</source>
        <translation>er hat %1 und weitere</translation>
    </message>
    <message>
        <source>it has %1</source>
        <translation>er hat %1</translation>
    </message>
    <message>
        <source>%1 has no line named %2: %3</source>
        <translation>%1 hat keine Leitung namens %2: %3</translation>
    </message>
    <message>
        <source>%1 has no line %2: it has 0 to %3</source>
        <translation>%1 hat keine Leitung %2: er hat 0 bis %3</translation>
    </message>
    <message>
        <source>%1: the lines were refused: %2</source>
        <translation>%1: die Leitungen wurden verweigert: %2</translation>
    </message>
    <message>
        <source>%1: a line is in use by another program, or by the kernel; gpioinfo shows which</source>
        <translation>%1: eine Leitung wird von einem anderen Programm oder vom Kernel benutzt; gpioinfo zeigt welche</translation>
    </message>
    <message>
        <source>%1: it is open to the group %2; run: %3 (and log in again)</source>
        <translation>%1: offen für die Gruppe %2; ausführen: %3 (und neu anmelden)</translation>
    </message>
    <message>
        <source>%1: it is open to root only; run: %2 (and restart)</source>
        <translation>%1: offen nur für root; ausführen: %2 (und neu starten)</translation>
    </message>
    <message>
        <source>%1: the chip is gone: unplugged, or its driver was removed</source>
        <translation>%1: der Chip ist weg: abgezogen, oder sein Treiber wurde entfernt</translation>
    </message>
    <message>
        <source>the panel is absent: %1</source>
        <translation>das Bedienpult fehlt: %1</translation>
    </message>
    <message>
        <source>%1: not readable: %2</source>
        <translation>%1: nicht lesbar: %2</translation>
    </message>
    <message>
        <source>%1: not sent, the kernel&apos;s queue is full</source>
        <translation>%1: nicht gesendet, die Warteschlange des Kernels ist voll</translation>
    </message>
    <message>
        <source>%1: not sent: %2</source>
        <translation>%1: nicht gesendet: %2</translation>
    </message>
    <message>
        <source>%1 was opened to receive only: nothing is sent</source>
        <translation>%1 wurde nur zum Empfangen geöffnet: nichts wird gesendet</translation>
    </message>
    <message>
        <source>%1: not sent, %2 frames before it have not left yet</source>
        <translation>%1: nicht gesendet, %2 Rahmen davor sind noch nicht weg</translation>
    </message>
    <message>
        <source>a stop line needs a name of 1 to 100 characters</source>
        <translation>eine Leitung zum Anhalten braucht einen Namen von 1 bis 100 Zeichen</translation>
    </message>
    <message>
        <source>there is no interface %1, but %2</source>
        <translation>die Schnittstelle %1 gibt es nicht, wohl aber %2</translation>
    </message>
    <message>
        <source>there is no interface %1, nor any CAN interface</source>
        <translation>es gibt weder die Schnittstelle %1 noch irgendeine CAN-Schnittstelle</translation>
    </message>
    <message>
        <source>plug the adapter in and load its driver; for a virtual one: sudo ip link add dev vcan0 type vcan</source>
        <translation>den Adapter anstecken und seinen Treiber laden; virtuell: sudo ip link add dev vcan0 type vcan</translation>
    </message>
    <message>
        <source>it is virtual: no bit rate, no controller</source>
        <translation>sie ist virtuell: keine Bitrate, kein Controller</translation>
    </message>
    <message>
        <source>its bit rate and its controller&apos;s state are not known</source>
        <translation>ihre Bitrate und der Zustand ihres Controllers sind nicht bekannt</translation>
    </message>
    <message>
        <source>it has no bit rate</source>
        <translation>sie hat keine Bitrate</translation>
    </message>
    <message>
        <source>%1   (as on the robot&apos;s bus)</source>
        <translation>%1   (wie auf dem Bus des Roboters)</translation>
    </message>
    <message>
        <source>bit rate %1 bit/s</source>
        <translation>Bitrate %1 bit/s</translation>
    </message>
    <message>
        <source>its controller has given up (bus-off): wrong bit rate, no terminators or crossed wires</source>
        <translation>ihr Controller hat aufgegeben (bus-off): falsche Bitrate, keine Abschlusswiderstände oder vertauschte Drähte</translation>
    </message>
    <message>
        <source>its controller sees many errors (%1): wrong bit rate, no terminators or loose wires</source>
        <translation>ihr Controller sieht viele Fehler (%1): falsche Bitrate, keine Abschlusswiderstände oder lose Drähte</translation>
    </message>
    <message>
        <source>it is up</source>
        <translation>sie ist aktiv</translation>
    </message>
    <message>
        <source>it is down</source>
        <translation>sie ist abgeschaltet</translation>
    </message>
    <message>
        <source>its send queue holds %1 frames: without acknowledgement, other programs&apos; frames wait in it too long</source>
        <translation>ihre Sendewarteschlange fasst %1 Rahmen: ohne Bestätigung warten darin die Rahmen anderer Programme zu lange</translation>
    </message>
    <message>
        <source>the receive buffer may be as large as it has to</source>
        <translation>der Empfangspuffer darf so groß sein wie nötig</translation>
    </message>
    <message>
        <source>the receive buffer is limited to %1 of %2 bytes: frames are lost when this computer is busy</source>
        <translation>der Empfangspuffer ist auf %1 von %2 Bytes begrenzt: Rahmen gehen verloren, wenn dieser Rechner ausgelastet ist</translation>
    </message>
    <message>
        <source>the kernel has CAN and this user may use it</source>
        <translation>der Kernel hat CAN, und dieser Benutzer darf es benutzen</translation>
    </message>
    <message>
        <source>%1 is no CAN interface</source>
        <translation>%1 ist keine CAN-Schnittstelle</translation>
    </message>
    <message>
        <source>ip -brief link   (lists all there are)</source>
        <translation>ip -brief link   (zeigt alle)</translation>
    </message>
    <message>
        <source>it is a CAN interface</source>
        <translation>sie ist eine CAN-Schnittstelle</translation>
    </message>
    <message>
        <source>unknown error</source>
        <translation>unbekannter Fehler</translation>
    </message>
    <message>
        <source>no scene that both models can estimate: %1; choose another file of scenes</source>
        <translation>keine Szene, die beide Modelle schätzen können: %1; bitte eine andere Szenendatei wählen</translation>
    </message>
    <message>
        <source>arm not simulated: the truth of bin %1 m is unknown</source>
        <translation>Arm nicht simuliert: die wahre Höhe des Feldes %1 m ist unbekannt</translation>
    </message>
    <message>
        <source>session not recovered: %1</source>
        <translation>Sitzung nicht wiederhergestellt: %1</translation>
    </message>
    <message>
        <source>session recovered, whose program had ended without closing it: %1</source>
        <translation>Sitzung wiederhergestellt, deren Programm geendet hatte, ohne sie zu schließen: %1</translation>
    </message>
    <message>
        <source>session deleted, since it is older than you have set: %1</source>
        <translation>Sitzung gelöscht, da sie älter ist als eingestellt: %1</translation>
    </message>
    <message>
        <source>session deleted, since all together are larger than you have set: %1</source>
        <translation>Sitzung gelöscht, da alle zusammen größer sind als eingestellt: %1</translation>
    </message>
    <message>
        <source>recording was switched off</source>
        <translation>die Aufzeichnung wurde abgeschaltet</translation>
    </message>
    <message>
        <source>%1: the disk is full: only %2 MB are free, %3 MB are kept free; recording continues when there is space</source>
        <translation>%1: die Platte ist voll: nur %2 MB sind frei, %3 MB bleiben frei; aufgezeichnet wird wieder, sobald Platz ist</translation>
    </message>
    <message>
        <source>the file is large enough</source>
        <translation>die Datei ist groß genug</translation>
    </message>
    <message>
        <source>the bus is down</source>
        <translation>der Bus ist abgeschaltet</translation>
    </message>
    <message>
        <source>the controller is off the bus</source>
        <translation>der Controller ist vom Bus getrennt</translation>
    </message>
    <message>
        <source>what was sent before has not left yet</source>
        <translation>was vorher gesendet wurde, ist noch nicht weg</translation>
    </message>
    <message>
        <source>has no scenes</source>
        <translation>hat keine Szenen</translation>
    </message>
    <message>
        <source>%1: nothing is written here: %2 is a symbolic link of another user; name the folder itself</source>
        <translation>%1: hierher wird nichts geschrieben: %2 ist ein symbolischer Link eines anderen Benutzers; nennen Sie den Ordner selbst</translation>
    </message>
    <message>
        <source>it is a symbolic link to %1, and nothing is written through a link: name the file itself</source>
        <translation>es ist ein symbolischer Link auf %1, und durch einen Link wird nichts geschrieben: nennen Sie die Datei selbst</translation>
    </message>
    <message>
        <source>%1: %2 is %3, expected at least %4 m from track_y_m: flipper and track overlap</source>
        <translation>%1: %2 ist %3, erwartet werden mindestens %4 m Abstand von track_y_m: Flipper und Kette überlappen sich</translation>
    </message>
    <message>
        <source>unpacks to more than %1 times its size: if it is a log, unpack it first (gzip -d)</source>
        <translation>wird beim Entpacken mehr als %1-mal so groß: wenn es ein Log ist, zuerst entpacken (gzip -d)</translation>
    </message>
    <message>
        <source>the window&apos;s picture could not be made: end other programs</source>
        <translation>das Bild des Fensters konnte nicht erstellt werden: andere Programme beenden</translation>
    </message>
    <message>
        <source>the model has learnt one plane only: `terratact train --tracks` makes one for two tracks</source>
        <translation>das Modell hat nur eine Ebene gelernt: `terratact train --tracks` macht eines für zwei Ketten</translation>
    </message>
    <message>
        <source>the track differential has turned: estimates of both sides need it locked</source>
        <translation>das Kettendifferential hat sich gedreht: Schätzungen beider Seiten brauchen es gesperrt</translation>
    </message>
    <message>
        <source>row %1 of two tracks: %2</source>
        <translation>Zeile %1 der zwei Ketten: %2</translation>
    </message>
    <message>
        <source>a value of its two tracks is not a multiple of its step</source>
        <translation>eine Zahl seiner zwei Ketten ist kein Vielfaches ihrer Schrittweite</translation>
    </message>
    <message>
        <source>the two sides of a scene have other readings</source>
        <translation>die beiden Seiten einer Szene haben verschiedene Messwerte</translation>
    </message>
    <message>
        <source>its rows of two tracks have the wrong size</source>
        <translation>seine Zeilen der zwei Ketten haben die falsche Größe</translation>
    </message>
    <message>
        <source>is a part of a model of two tracks</source>
        <translation>ist ein Teil eines Modells für zwei Ketten</translation>
    </message>
    <message>
        <source>is a model of format version %1, and this program reads versions %2 and %3: `terratact train` makes a new one</source>
        <translation>ist ein Modell der Formatversion %1, dieses Programm liest die Versionen %2 und %3: `terratact train` macht ein neues</translation>
    </message>
    <message>
        <source>row %1 of its table %2: %3</source>
        <translation>Zeile %1 ihrer Tabelle %2: %3</translation>
    </message>
    <message>
        <source>columns of the right side are expected for two sides, and none for one plane</source>
        <translation>bei zwei Seiten werden Spalten der rechten Seite erwartet, bei einer Ebene keine</translation>
    </message>
    <message>
        <source>bins of one plane are expected to be of both sides, and others of one</source>
        <translation>bei einer Ebene werden Felder beider Seiten erwartet, sonst Felder einer Seite</translation>
    </message>
    <message>
        <source>the track differential has turned: left and right are estimated as one plane</source>
        <translation>das Kettendifferential ist verdreht: links und rechts werden als eine Ebene geschätzt</translation>
    </message>
    <message>
        <source>method %1 estimates left and right as one plane, although they differ</source>
        <translation>Methode %1 schätzt links und rechts als eine Ebene, obwohl sie verschieden sind</translation>
    </message>
    <message>
        <source>the arm&apos;s reading at %1 m lies in the middle and counts for neither side</source>
        <translation>die Messung des Arms bei %1 m liegt in der Mitte und zählt für keine Seite</translation>
    </message>
    <message>
        <source>left: %1</source>
        <translation>links: %1</translation>
    </message>
    <message>
        <source>right: %1</source>
        <translation>rechts: %1</translation>
    </message>
    <message>
        <source>the estimate contradicts the readings: pitch %1°, roll %2°, front flippers %3° left, %4° right measured; %5°, %6°, %7°, %8° on its ground</source>
        <translation>die Schätzung widerspricht den Messwerten: gemessen Nickwinkel %1°, Rollwinkel %2°, vordere Flipper links %3°, rechts %4°; auf ihrem Boden %5°, %6°, %7°, %8°</translation>
    </message>
    <message>
        <source>from a recording by the mapping %1</source>
        <translation>aus einer Aufzeichnung nach der Zuordnung %1</translation>
    </message>
    <message>
        <source>the recording does not say what the robot did: pressing, driving and halting follow from its movement and currents</source>
        <translation>die Aufzeichnung sagt nicht, was der Roboter tat: Drücken, Fahren und Halten folgen aus seiner Bewegung und den Strömen</translation>
    </message>
    <message>
        <source>advancing</source>
        <translation>rückt vor</translation>
    </message>
    <message>
        <source>the robot did not finish the advance in time</source>
        <translation>der Roboter ist nicht rechtzeitig vorgerückt</translation>
    </message>
    <message>
        <source>the advance was refused</source>
        <translation>das Vorrücken wurde abgelehnt</translation>
    </message>
    <message>
        <source>the tracks moved less than the commanded advance</source>
        <translation>die Ketten fuhren weniger weit als befohlen</translation>
    </message>
    <message>
        <source>the tracks moved further than the commanded advance</source>
        <translation>die Ketten fuhren weiter als befohlen</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>the control was let go</source>
        <translation>die Taste wurde losgelassen</translation>
    </message>
    <message>
        <source>the operator ended it</source>
        <translation>vom Bediener beendet</translation>
    </message>
    <message>
        <source>STOP was pressed</source>
        <translation>STOP wurde gedrückt</translation>
    </message>
    <message>
        <source>a fault</source>
        <translation>eine Störung</translation>
    </message>
    <message>
        <source>a probe would decide</source>
        <translation>eine Sondierung würde entscheiden</translation>
    </message>
    <message>
        <source>telemetry is stale or was interrupted</source>
        <translation>die Telemetrie ist veraltet oder war unterbrochen</translation>
    </message>
    <message>
        <source>there is no verdict</source>
        <translation>es gibt kein Urteil</translation>
    </message>
    <message>
        <source>a sensor is suspected</source>
        <translation>ein Sensor ist verdächtig</translation>
    </message>
    <message>
        <source>the readings contradict the estimate</source>
        <translation>die Messwerte widersprechen der Schätzung</translation>
    </message>
    <message>
        <source>the verdict is withheld</source>
        <translation>das Urteil wird zurückgehalten</translation>
    </message>
    <message>
        <source>BLOCKED: there is a step ahead</source>
        <translation>VERSPERRT: voraus ist eine Stufe</translation>
    </message>
    <message>
        <source>the ground ahead is not felt</source>
        <translation>der Boden voraus ist nicht ertastet</translation>
    </message>
    <message>
        <source>the ground is felt less far than the flippers reach</source>
        <translation>der Boden ist weniger weit ertastet, als die Flipper reichen</translation>
    </message>
    <message>
        <source>ground before the horizon is only bounded</source>
        <translation>Boden vor dem Horizont ist nur begrenzt</translation>
    </message>
    <message>
        <source>CANNOT TELL: what was felt does not decide</source>
        <translation>UNKLAR: das Ertastete entscheidet nicht</translation>
    </message>
    <message>
        <source>the ground is felt no further than the advance</source>
        <translation>der Boden ist nicht weiter ertastet als das Vorrücken</translation>
    </message>
    <message>
        <source>pitch or roll is near its limit</source>
        <translation>Nick- oder Rollwinkel ist nahe der Grenze</translation>
    </message>
    <message>
        <source>the first felt ground</source>
        <translation>der erste ertastete Boden</translation>
    </message>
    <message>
        <source>the robot has turned</source>
        <translation>der Roboter hat sich gedreht</translation>
    </message>
    <message>
        <source>the reported way has jumped</source>
        <translation>der gemeldete Weg ist gesprungen</translation>
    </message>
    <message>
        <source>the remembered ground was cleared</source>
        <translation>der gemerkte Boden wurde gelöscht</translation>
    </message>
    <message>
        <source>nothing of the way is remembered: this scene alone counts</source>
        <translation>vom Weg ist nichts gemerkt: nur diese Szene zählt</translation>
    </message>
    <message>
        <source>a table holds numbers of another size</source>
        <translation>eine Tabelle enthält Zahlen anderer Größe</translation>
    </message>
    <message>
        <source>its inputs are not those of this program</source>
        <translation>ihre Eingänge sind nicht die dieses Programms</translation>
    </message>
    <message>
        <source>a bin&apos;s scale is missing</source>
        <translation>der Maßstab eines Feldes fehlt</translation>
    </message>
    <message>
        <source>a bin has two scales</source>
        <translation>ein Feld hat zwei Maßstäbe</translation>
    </message>
    <message>
        <source>a layer of a network is too wide</source>
        <translation>eine Schicht eines Netzes ist zu breit</translation>
    </message>
    <message>
        <source>a layer of a network is missing</source>
        <translation>eine Schicht eines Netzes fehlt</translation>
    </message>
    <message>
        <source>covered bins are out of range</source>
        <translation>verdeckte Felder liegen außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>a scene of the errors is missing, or there are too many</source>
        <translation>eine Szene der Fehler fehlt, oder es sind zu viele</translation>
    </message>
    <message>
        <source>is an SQLite file of another application, not trail networks</source>
        <translation>ist eine SQLite-Datei eines anderen Programms, keine Netze der Methode trail</translation>
    </message>
    <message>
        <source>is of another format version: `terratact train --drives` makes new networks</source>
        <translation>hat eine andere Formatversion: `terratact train --drives` erzeugt neue Netze</translation>
    </message>
    <message>
        <source>its tables are not those of trail networks</source>
        <translation>ihre Tabellen sind nicht die von Netzen der Methode trail</translation>
    </message>
    <message>
        <source>its seed is not a number</source>
        <translation>ihr Startwert ist keine Zahl</translation>
    </message>
    <message>
        <source>it holds no network</source>
        <translation>sie enthält kein Netz</translation>
    </message>
    <message>
        <source>its content does not match its hash: it was changed or damaged</source>
        <translation>ihr Inhalt passt nicht zu ihrer Prüfsumme: sie wurde geändert oder beschädigt</translation>
    </message>
    <message>
        <source>it has rows of networks without layers</source>
        <translation>sie hat Zeilen von Netzen ohne Schichten</translation>
    </message>
    <message>
        <source>it has rows of an unknown kind of networks</source>
        <translation>sie hat Zeilen einer unbekannten Art von Netzen</translation>
    </message>
    <message>
        <source>the networks of method trail give no finite number</source>
        <translation>die Netze der Methode trail ergeben keine endliche Zahl</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>P(step)</source>
        <translation>P(Stufe)</translation>
    </message>
    <message>
        <source>computing time</source>
        <translation>Rechenzeit</translation>
    </message>
    <message>
        <source>P(step), %1</source>
        <translation>P(Stufe), %1</translation>
    </message>
    <message>
        <source>mean sd ahead, %1</source>
        <translation>mittlere sd voraus, %1</translation>
    </message>
    <message>
        <source>largest sd ahead, %1</source>
        <translation>größte sd voraus, %1</translation>
    </message>
    <message>
        <source>mean absolute error, %1</source>
        <translation>mittlerer absoluter Fehler, %1</translation>
    </message>
    <message>
        <source>largest absolute error, %1</source>
        <translation>größter absoluter Fehler, %1</translation>
    </message>
    <message>
        <source>height at %1 m, %2</source>
        <translation>Höhe bei %1 m, %2</translation>
    </message>
    <message>
        <source>sd at %1 m, %2</source>
        <translation>sd bei %1 m, %2</translation>
    </message>
    <message>
        <source>error at %1 m, %2</source>
        <translation>Fehler bei %1 m, %2</translation>
    </message>
    <message>
        <source>frames per second</source>
        <translation>Rahmen je Sekunde</translation>
    </message>
    <message>
        <source>telemetry</source>
        <translation>Telemetrie</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>Schätzung</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>Nutzlast</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>front flipper left</source>
        <translation>Flipper vorn links</translation>
    </message>
    <message>
        <source>front flipper right</source>
        <translation>Flipper vorn rechts</translation>
    </message>
    <message>
        <source>rear flipper left</source>
        <translation>Flipper hinten links</translation>
    </message>
    <message>
        <source>rear flipper right</source>
        <translation>Flipper hinten rechts</translation>
    </message>
    <message>
        <source>front current left</source>
        <translation>Strom vorn links</translation>
    </message>
    <message>
        <source>front current right</source>
        <translation>Strom vorn rechts</translation>
    </message>
    <message>
        <source>rear current left</source>
        <translation>Strom hinten links</translation>
    </message>
    <message>
        <source>rear current right</source>
        <translation>Strom hinten rechts</translation>
    </message>
    <message>
        <source>way of the tracks</source>
        <translation>Weg der Ketten</translation>
    </message>
    <message>
        <source>turn of the tracks</source>
        <translation>Drehung der Ketten</translation>
    </message>
    <message>
        <source>differential</source>
        <translation>Differential</translation>
    </message>
    <message>
        <source>force %1, front left</source>
        <translation>Kraft %1, vorn links</translation>
    </message>
    <message>
        <source>force %1, front right</source>
        <translation>Kraft %1, vorn rechts</translation>
    </message>
    <message>
        <source>force %1, rear left</source>
        <translation>Kraft %1, hinten links</translation>
    </message>
    <message>
        <source>force %1, rear right</source>
        <translation>Kraft %1, hinten rechts</translation>
    </message>
    <message>
        <source>force %1</source>
        <translation>Kraft %1</translation>
    </message>
    <message>
        <source>reading was cancelled</source>
        <translation>das Lesen wurde abgebrochen</translation>
    </message>
    <message>
        <source>the folder cannot be read: %1</source>
        <translation>der Ordner kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>a memory of the way is expected to hold 103 or 202 numbers in their ranges</source>
        <translation>ein Gedächtnis des Weges muss 103 oder 202 Zahlen in ihren Bereichen enthalten</translation>
    </message>
    <message>
        <source>its inducing row count is not a positive whole number: %1</source>
        <translation>die Zahl seiner Stützzeilen ist keine ganze Zahl größer als 0: %1</translation>
    </message>
    <message>
        <source>its repeated row count is not a positive whole number: %1</source>
        <translation>die Zahl seiner wiederholten Zeilen ist keine ganze Zahl größer als 0: %1</translation>
    </message>
    <message>
        <source>the recording&apos;s clock was set forward by %1 s; the session continues evenly</source>
        <translation>die Uhr der Aufzeichnung wurde um %1 s vorgestellt; die Sitzung geht gleichmäßig weiter</translation>
    </message>
    <message>
        <source>the recording&apos;s clock was set back by %1 s; the session continues evenly</source>
        <translation>die Uhr der Aufzeichnung wurde um %1 s zurückgestellt; die Sitzung geht gleichmäßig weiter</translation>
    </message>
    <message>
        <source>a CAN XL frame is not read; expected CAN or CAN FD</source>
        <translation>ein CAN-XL-Rahmen wird nicht gelesen; erwartet wird CAN oder CAN FD</translation>
    </message>
    <message>
        <source>%1 frames have more bytes than their length says, which are left out; the first is in line %2</source>
        <translation>%1 Rahmen haben mehr Bytes, als ihre Länge angibt; diese Bytes sind ausgelassen, zuerst in Zeile %2</translation>
    </message>
    <message>
        <source>the sd of its heights do not fit its training rows</source>
        <translation>die Standardabweichungen der Höhen passen nicht zu den Trainingszeilen</translation>
    </message>
    <message>
        <source>sd of a height: %1</source>
        <translation>Standardabweichung einer Höhe: %1</translation>
    </message>
    <message>
        <source>its unknown heights do not fit its training rows</source>
        <translation>seine unbekannten Höhen passen nicht zu seinen Trainingszeilen</translation>
    </message>
    <message>
        <source>its table of unknown heights names none</source>
        <translation>seine Tabelle unbekannter Höhen nennt keine</translation>
    </message>
    <message>
        <source>an unknown height is of a bin that does not exist</source>
        <translation>eine unbekannte Höhe gehört zu einem Feld, das es nicht gibt</translation>
    </message>
    <message>
        <source>it has a number for a height that is unknown</source>
        <translation>es hat eine Zahl für eine Höhe, die unbekannt ist</translation>
    </message>
    <message>
        <source>a scanned row has an unknown height</source>
        <translation>eine gescannte Zeile hat eine unbekannte Höhe</translation>
    </message>
    <message>
        <source>%1 scenes have unknown heights: the surfaces learn their known bins, the conditionals leave them out</source>
        <translation>%1 Szenen haben unbekannte Höhen: die Flächen lernen ihre bekannten Felder, die bedingten Modelle lassen sie aus</translation>
    </message>
    <message>
        <source>%1 scenes of two tracks left out: a reading or all heights are unknown, or there are more than %2</source>
        <translation>%1 Szenen zweier Ketten ausgelassen: ein Messwert oder alle Höhen sind unbekannt, oder es sind mehr als %2</translation>
    </message>
    <message>
        <source>%1 scenes of two tracks have unknown heights: their known bins are learnt</source>
        <translation>%1 Szenen zweier Ketten haben unbekannte Höhen: ihre bekannten Felder werden gelernt</translation>
    </message>
    <message>
        <source>%1 is %2, expected %3 to %4</source>
        <translation>%1 ist %2, erwartet: %3 bis %4</translation>
    </message>
    <message>
        <source>row is %1, expected the number of a scene, from 1</source>
        <translation>row ist %1, erwartet: Nummer einer Szene, ab 1</translation>
    </message>
    <message>
        <source>decision is %1, expected accept or exclude</source>
        <translation>decision ist %1, erwartet: accept oder exclude</translation>
    </message>
    <message>
        <source>is not the header %1</source>
        <translation>ist nicht die Kopfzeile %1</translation>
    </message>
    <message>
        <source>row %1 already has a decision above, expected one for each row</source>
        <translation>Zeile %1 hat weiter oben schon eine Entscheidung, erwartet: eine je Zeile</translation>
    </message>
    <message>
        <source>line %1: row %2 does not exist, the scenes have %3 rows; were they made again?</source>
        <translation>Zeile %1: Szene %2 gibt es nicht, die Datei hat %3 Szenen; wurde sie neu erzeugt?</translation>
    </message>
    <message>
        <source>line %1: row %2 belongs to the run %3, not %4: take the decisions on these scenes</source>
        <translation>Zeile %1: Szene %2 gehört zur Fahrt %3, nicht %4: die Entscheidungen zu diesen Szenen nehmen</translation>
    </message>
    <message>
        <source>the slice of a scene is damaged: write the file again</source>
        <translation>der Schnitt einer Szene ist beschädigt: Datei neu schreiben</translation>
    </message>
    <message>
        <source>scene %1 is not one line of a scenes file</source>
        <translation>Szene %1 ist keine Zeile einer Szenendatei</translation>
    </message>
    <message>
        <source>scene %1 is missing: write the file again</source>
        <translation>Szene %1 fehlt: Datei neu schreiben</translation>
    </message>
    <message>
        <source>has more than %1 scenes</source>
        <translation>hat mehr als %1 Szenen</translation>
    </message>
    <message>
        <source>scene %1: why it has no heights is unknown</source>
        <translation>Szene %1: warum sie keine Höhen hat, ist unbekannt</translation>
    </message>
    <message>
        <source>scene %1: its distance to the cloud is not a number</source>
        <translation>Szene %1: ihr Abstand zur Wolke ist keine Zahl</translation>
    </message>
    <message>
        <source>would hold %1 scenes; expected at most %2: take fewer scenes, or leave out --review</source>
        <translation>enthielte %1 Szenen; erwartet: höchstens %2: weniger Szenen nehmen oder --review weglassen</translation>
    </message>
    <message>
        <source>is not a truth file: terratact truth --review writes one</source>
        <translation>ist keine Wahrheitsdatei: terratact truth --review schreibt eine</translation>
    </message>
    <message>
        <source>is a truth file of another version: write it again by terratact truth --review</source>
        <translation>ist eine Wahrheitsdatei einer anderen Version: mit terratact truth --review neu schreiben</translation>
    </message>
    <message>
        <source>is a damaged truth file: write it again</source>
        <translation>ist eine beschädigte Wahrheitsdatei: neu schreiben</translation>
    </message>
    <message>
        <source>holds numbers, expected the names of the columns: add that line at the top, as docs/files.md shows it</source>
        <translation>enthält Zahlen, erwartet werden die Namen der Spalten: diese Zeile oben ergänzen, wie docs/files.md sie zeigt</translation>
    </message>
    <message>
        <source>is text in UTF-32: save it in UTF-8</source>
        <translation>ist Text in UTF-32: in UTF-8 speichern</translation>
    </message>
    <message>
        <source>a quote does not end: close it, or delete the line</source>
        <translation>ein Anführungszeichen wird nicht geschlossen: schließen Sie es, oder löschen Sie die Zeile</translation>
    </message>
    <message>
        <source>is torn: has %1 fields where the header has %2, and the file does not end with a line end: delete the line</source>
        <translation>ist abgerissen: hat %1 Felder, wo die Kopfzeile %2 hat, und die Datei endet ohne Zeilenende: löschen Sie die Zeile</translation>
    </message>
    <message>
        <source>%1: correct or delete the line</source>
        <translation>%1: berichtigen oder löschen Sie die Zeile</translation>
    </message>
    <message>
        <source>%1 is not a number: %2: write a number there</source>
        <translation>%1 ist keine Zahl: %2: schreiben Sie dort eine Zahl</translation>
    </message>
    <message>
        <source>%1 is not finite: %2: write a finite number there</source>
        <translation>%1 ist nicht endlich: %2: schreiben Sie dort eine endliche Zahl</translation>
    </message>
    <message>
        <source>is text in UTF-16: save it as UTF-8</source>
        <translation>ist Text in UTF-16: speichern Sie ihn als UTF-8</translation>
    </message>
    <message>
        <source>zero bytes, as after a power loss, are left out</source>
        <translation>Null-Bytes wie nach einem Stromausfall sind ausgelassen</translation>
    </message>
    <message>
        <source>zero bytes, as after a power loss, are left out, and the text that they cut</source>
        <translation>Null-Bytes wie nach einem Stromausfall sind ausgelassen, und der Text, den sie abschneiden</translation>
    </message>
    <message>
        <source>expected %1, found %2: correct or delete the line</source>
        <translation>erwartet: %1, gefunden: %2: berichtigen oder löschen Sie die Zeile</translation>
    </message>
    <message>
        <source>is of version %1 of the format: export it as version 1.0 to 2.1</source>
        <translation>hat die Version %1 des Formats: exportieren Sie es als Version 1.0 bis 2.1</translation>
    </message>
    <message>
        <source>a step ahead of more than %1 mm: probability %2 ± %3, most likely at %4 m … %5 m (%6)</source>
        <translation>eine Stufe über %1 mm: Wahrscheinlichkeit %2 ± %3, am ehesten bei %4 m … %5 m (%6)</translation>
    </message>
    <message>
        <source>%1 at %2 m</source>
        <translation>%1 bei %2 m</translation>
    </message>
    <message>
        <source>%1 for the robot</source>
        <translation>%1 für den Roboter</translation>
    </message>
    <message>
        <source>both %1</source>
        <translation>beide %1</translation>
    </message>
    <message>
        <source>each side %1</source>
        <translation>jede Seite %1</translation>
    </message>
    <message>
        <source>left %1 · right %2</source>
        <translation>links %1 · rechts %2</translation>
    </message>
    <message>
        <source>cross slope %1° of %2°</source>
        <translation>Quergefälle %1° von %2°</translation>
    </message>
    <message>
        <source>%1 to %2 m</source>
        <translation>%1 bis %2 m</translation>
    </message>
    <message>
        <source>not felt: %1</source>
        <translation>nicht ertastet: %1</translation>
    </message>
    <message>
        <source>%1 to %2 m, felt to %3 m</source>
        <translation>%1 bis %2 m, ertastet bis %3 m</translation>
    </message>
    <message>
        <source>a step ahead of more than %1 mm: probability %2 ± %3, likeliest between %4 and %5 m (%6)</source>
        <translation>eine Stufe über %1 mm: Wahrscheinlichkeit %2 ± %3, am ehesten zwischen %4 und %5 m (%6)</translation>
    </message>
    <message>
        <source>the disk is full: free space on it, or name a file on another disk</source>
        <translation>der Datenträger ist voll: Platz schaffen oder eine Datei auf einem anderen Datenträger nennen</translation>
    </message>
    <message>
        <source>line %1: along_m moves the cloud, but the truth file was written by an earlier version and does not hold its cells: write it again by terratact truth --review</source>
        <translation>Zeile %1: along_m verschiebt die Punktwolke, aber die Wahrheitsdatei stammt von einer früheren Version und enthält ihre Zellen nicht: mit terratact truth --review neu schreiben</translation>
    </message>
    <message>
        <source>along_m is %1, expected a multiple of %2: the cells of the cloud</source>
        <translation>along_m ist %1, erwartet ist ein Vielfaches von %2: die Zellen der Punktwolke</translation>
    </message>
    <message>
        <source>was written by an earlier version and holds no cells of the cloud: write it again by terratact truth --review to nudge along the way</source>
        <translation>stammt von einer früheren Version und enthält keine Zellen der Punktwolke: mit terratact truth --review neu schreiben, um längs des Weges zu verschieben</translation>
    </message>
    <message>
        <source>the cells of scene %1 are damaged: write the file again</source>
        <translation>die Zellen der Szene %1 sind beschädigt: die Datei neu schreiben</translation>
    </message>
    <message>
        <source>%1: the column %2 was read as %3</source>
        <translation>%1: die Spalte %2 wurde als %3 gelesen</translation>
    </message>
    <message>
        <source>its journal %1 was written for another session: move it away</source>
        <translation>ihr Journal %1 gehört zu einer anderen Sitzung: legen Sie es anderswohin</translation>
    </message>
    <message>
        <source>%1 to %2 m, nothing felt ahead</source>
        <translation>%1 bis %2 m, voraus nichts ertastet</translation>
    </message>
    <message>
        <source>bounded: %1</source>
        <translation>begrenzt: %1</translation>
    </message>
    <message>
        <source>the number of a drive is out of range</source>
        <translation>die Nummer einer Fahrt ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>a step of more than %1 m anywhere ahead, felt or not: P %2 ± %3, most likely at %4 … %5 m (P %6)</source>
        <translation>eine Stufe über %1 m irgendwo voraus, ertastet oder nicht: P %2 ± %3, am ehesten bei %4 … %5 m (P %6)</translation>
    </message>
    <message>
        <source>is empty: expected a line with the names of its columns</source>
        <translation>ist leer: erwartet wird eine Zeile mit den Namen der Spalten</translation>
    </message>
    <message>
        <source>is empty: copy it again</source>
        <translation>ist leer: bitte erneut kopieren</translation>
    </message>
    <message>
        <source>has %1 bytes where its header says %2: it is truncated, copy it again</source>
        <translation>hat %1 Bytes, laut Kopf %2: sie ist abgeschnitten, bitte erneut kopieren</translation>
    </message>
    <message>
        <source>a row is more than 36 years from the session&apos;s begin, which no reader accepts: split the recording, or correct its clock</source>
        <translation>eine Zeile liegt mehr als 36 Jahre vom Beginn der Sitzung entfernt, was kein Leser annimmt: die Aufnahme teilen oder ihre Uhr berichtigen</translation>
    </message>
    <message>
        <source>it has the name of a session&apos;s journal: name another file</source>
        <translation>sie hat den Namen des Journals einer Sitzung: eine andere Datei nennen</translation>
    </message>
    <message>
        <source>is there already: name another file</source>
        <translation>gibt es schon: eine andere Datei nennen</translation>
    </message>
    <message>
        <source>the file system refuses it: %1</source>
        <translation>das Dateisystem verweigert es: %1</translation>
    </message>
    <message>
        <source>%1 is there already and would be taken for its journal: name another file</source>
        <translation>%1 gibt es schon und würde für ihr Journal gehalten: eine andere Datei nennen</translation>
    </message>
    <message>
        <source>cannot be written: is the disk full, or the file larger than ulimit -f allows?</source>
        <translation>kann nicht geschrieben werden: ist das Laufwerk voll, oder die Datei größer, als ulimit -f erlaubt?</translation>
    </message>
    <message>
        <source>a command could not be sent</source>
        <translation>ein Befehl konnte nicht gesendet werden</translation>
    </message>
    <message>
        <source>the robot did not begin the exploration in time</source>
        <translation>der Roboter hat die Erkundung nicht rechtzeitig begonnen</translation>
    </message>
    <message>
        <source>the memory of the way needs every current and force: only the arm&apos;s earlier readings are used</source>
        <translation>das Gedächtnis des Wegs braucht alle Ströme und Kräfte: nur frühere Messungen des Arms werden benutzt</translation>
    </message>
    <message>
        <source>the memory of the way needs every current and force: this scene alone counts</source>
        <translation>das Gedächtnis des Wegs braucht alle Ströme und Kräfte: nur diese Szene zählt</translation>
    </message>
    <message>
        <source>of the way, only the arm&apos;s earlier readings are used</source>
        <translation>vom Weg werden nur frühere Messungen des Arms benutzt</translation>
    </message>
    <message>
        <source>the track differential has turned, left and right ground differ</source>
        <translation>das Kettendifferential ist verdreht, der Boden links und rechts ist verschieden</translation>
    </message>
    <message>
        <source>the odometry or the pitch is suspected</source>
        <translation>die Odometrie oder der Nickwinkel ist verdächtig</translation>
    </message>
    <message>
        <source>a training drive is missing</source>
        <translation>eine Trainingsfahrt fehlt</translation>
    </message>
    <message>
        <source>%1 more things are left out, in lines %2</source>
        <translation>weitere ausgelassene Dinge: %1, in den Zeilen %2</translation>
    </message>
    <message>
        <source>the signal %1 is left out: its message %2 has more than %3 signals</source>
        <translation>das Signal %1 wird ausgelassen: seine Nachricht %2 hat mehr als %3 Signale</translation>
    </message>
    <message>
        <source>there is no home folder that may hold recordings: name a folder, or set HOME or XDG_STATE_HOME</source>
        <translation>es gibt keinen Benutzerordner für Aufzeichnungen: einen Ordner nennen, oder HOME oder XDG_STATE_HOME setzen</translation>
    </message>
    <message>
        <source>%1: the key %2 is missing</source>
        <translation>%1: der Schlüssel %2 fehlt</translation>
    </message>
    <message>
        <source>its tables take more steps to read than a file of its size needs</source>
        <translation>seine Tabellen zu lesen dauert länger, als eine Datei dieser Größe braucht</translation>
    </message>
    <message>
        <source>%1 is longer than %2 bytes: the rest is left out</source>
        <translation>%1: länger als %2 Bytes, der Rest wird weggelassen</translation>
    </message>
    <message>
        <source>the message %1 describes up to %2 signals in a frame of %3 bytes: only the first %4 of a frame are read</source>
        <translation>die Nachricht %1 beschreibt bis zu %2 Signale in einem Rahmen von %3 Bytes: nur die ersten %4 eines Rahmens werden gelesen</translation>
    </message>
    <message>
        <source>its journal %1 is damaged from byte %2: %3 pages in it are not read</source>
        <translation>ihr Journal %1 ist ab Byte %2 beschädigt: %3 Seiten darin werden nicht gelesen</translation>
    </message>
    <message>
        <source>has zero bytes, which are read as blanks</source>
        <translation>enthält Nullbytes, die als Leerzeichen gelesen werden</translation>
    </message>
    <message>
        <source>the word %1 is left out: expected its raw value in at most 64 bits, with all its digits</source>
        <translation>das Wort %1 ist ausgelassen: erwartet wird sein Rohwert in höchstens 64 Bit, mit allen Ziffern</translation>
    </message>
    <message>
        <source>the long name %1 of the signal %2 is left out: %3 has another signal of that name</source>
        <translation>der lange Name %1 des Signals %2 ist ausgelassen: %3 hat ein anderes Signal dieses Namens</translation>
    </message>
    <message>
        <source>%1 has lost its digits in a spreadsheet: export the log again, and keep this column as text</source>
        <translation>%1 hat in einer Tabellenkalkulation Ziffern verloren: das Log erneut exportieren und diese Spalte als Text belassen</translation>
    </message>
    <message>
        <source>a workbook of an office program</source>
        <translation>eine Arbeitsmappe eines Büroprogramms</translation>
    </message>
    <message>
        <source>a PDF file</source>
        <translation>eine PDF-Datei</translation>
    </message>
    <message>
        <source>is a log of slcan, which is not read: record the bus with candump -l</source>
        <translation>ist ein Log von slcan, das nicht gelesen wird: den Bus mit candump -l aufzeichnen</translation>
    </message>
    <message>
        <source>no text in UTF-8</source>
        <translation>kein Text in UTF-8</translation>
    </message>
    <message>
        <source>no force was measured: the other side&apos;s forces count for both</source>
        <translation>es wurde keine Kraft gemessen: die Kräfte der anderen Seite gelten für beide</translation>
    </message>
    <message>
        <source>the force of element %1 was not measured: the other side&apos;s counts for both</source>
        <translation>die Kraft von Element %1 wurde nicht gemessen: die der anderen Seite gilt für beide</translation>
    </message>
    <message>
        <source>the %1 was not measured: the other side counts for both</source>
        <translation>%1 nicht gemessen: die andere Seite gilt für beide</translation>
    </message>
    <message>
        <source>repeats the header: a second table begins here: save each table as a file of its own</source>
        <translation>wiederholt die Kopfzeile: hier beginnt eine zweite Tabelle: speichern Sie jede Tabelle als eigene Datei</translation>
    </message>
    <message>
        <source>%1, and no number: does a second table begin here? save it as a file of its own, or correct the line</source>
        <translation>%1, und keine Zahl: beginnt hier eine zweite Tabelle? speichern Sie sie als eigene Datei, oder berichtigen Sie die Zeile</translation>
    </message>
    <message>
        <source>%1 is not a number: %2, and its line holds none: does a second table begin here? save it as a file of its own, or write a number there</source>
        <translation>%1 ist keine Zahl: %2, und die Zeile enthält keine: beginnt hier eine zweite Tabelle? speichern Sie sie als eigene Datei, oder schreiben Sie dort eine Zahl</translation>
    </message>
</context>
<context>
    <name>event</name>
    <message>
        <source>up</source>
        <translation>steht</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>telemetry lost</source>
        <translation>Telemetrie weg</translation>
    </message>
    <message>
        <source>approve</source>
        <translation>genehmigen</translation>
    </message>
    <message>
        <source>choose</source>
        <translation>wählen</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>fahren</translation>
    </message>
    <message>
        <source>explore</source>
        <translation>erkunden</translation>
    </message>
    <message>
        <source>abort</source>
        <translation>abbrechen</translation>
    </message>
    <message>
        <source>halt</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>override</source>
        <translation>Übergehen</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>ablehnen</translation>
    </message>
    <message>
        <source>release stop</source>
        <translation>STOP lösen</translation>
    </message>
    <message>
        <source>second method</source>
        <translation>zweite Methode</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>back</source>
        <translation>zurück</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>begun</source>
        <translation>begonnen</translation>
    </message>
    <message>
        <source>continued</source>
        <translation>fortgesetzt</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>recovered</source>
        <translation>wiederhergestellt</translation>
    </message>
    <message>
        <source>merged</source>
        <translation>zusammengeführt</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>log</source>
        <translation>Log</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>Bediener</translation>
    </message>
    <message>
        <source>silence</source>
        <translation>keine Telemetrie</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>foreign</source>
        <translation>andere Konsole</translation>
    </message>
    <message>
        <source>dropped</source>
        <translation>verlorene Rahmen</translation>
    </message>
    <message>
        <source>checksum</source>
        <translation>Prüfsumme</translation>
    </message>
    <message>
        <source>disarmed</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>sensors</source>
        <translation>Sensoren</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>Bedienpult</translation>
    </message>
    <message>
        <source>exploration</source>
        <translation>Erkundung</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>atem</source>
        <translation>ATEM</translation>
    </message>
    <message>
        <source>confirm to arm</source>
        <translation>Freigabe ist zu bestätigen</translation>
    </message>
    <message>
        <source>waiting for the robot to arm</source>
        <translation>wartet auf die Freigabe durch den Roboter</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>freigegeben</translation>
    </message>
    <message>
        <source>clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>forget</source>
        <translation>vergessen</translation>
    </message>
    <message>
        <source>restore</source>
        <translation>zurückholen</translation>
    </message>
    <message>
        <source>sensor-fault</source>
        <translation>Sensorfehler</translation>
    </message>
    <message>
        <source>attitude</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>feel forward</source>
        <translation>vortasten</translation>
    </message>
    <message>
        <source>let go</source>
        <translation>losgelassen</translation>
    </message>
    <message>
        <source>snapshot</source>
        <translation>Schnappschuss</translation>
    </message>
    <message>
        <source>snapshot note</source>
        <translation>Notiz zum Schnappschuss</translation>
    </message>
</context>
<context>
    <name>source</name>
    <message>
        <source>SIMULATED ROBOT</source>
        <translation>SIMULATION</translation>
    </message>
    <message>
        <source>REPLAY %1</source>
        <translation>WIEDERGABE %1</translation>
    </message>
</context>
<context>
    <name>terratact::AlarmTable</name>
    <message>
        <source>▲ CRITICAL, new</source>
        <translation>▲ KRITISCH, neu</translation>
    </message>
    <message>
        <source>◆ caution, new</source>
        <translation>◆ Vorsicht, neu</translation>
    </message>
    <message>
        <source>▽ over, not seen</source>
        <translation>▽ vorbei, nicht gesehen</translation>
    </message>
    <message>
        <source>■ critical, seen</source>
        <translation>■ kritisch, gesehen</translation>
    </message>
    <message>
        <source>■ caution, seen</source>
        <translation>■ Vorsicht, gesehen</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>seit %1</translation>
    </message>
    <message>
        <source>over for %1</source>
        <translation>vorbei seit %1</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Alarms, most urgent first</source>
        <translation>Alarme, dringendste zuerst</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Seit</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>✔ No alarms.</source>
        <translation>✔ Keine Alarme.</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Quittieren</translation>
    </message>
    <message>
        <source>Acknowledges the selected alarm</source>
        <translation>Quittiert den gewählten Alarm</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>Alle quittieren</translation>
    </message>
    <message>
        <source>Acknowledges all alarms</source>
        <translation>Quittiert alle Alarme</translation>
    </message>
    <message>
        <source>Mute 60 s</source>
        <translation>Stumm 60 s</translation>
    </message>
    <message>
        <source>Mutes alarms for 60 s; new alarms still sound</source>
        <translation>Eine Minute kein Ton; ein neuer Alarm ertönt dennoch</translation>
    </message>
    <message>
        <source>Mute 120 s</source>
        <translation>Stumm 120 s</translation>
    </message>
    <message>
        <source>Mutes alarms for 120 s; new alarms still sound</source>
        <translation>Zwei Minuten kein Ton; ein neuer Alarm ertönt dennoch</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Critical alarms beep until they are acknowledged: at once, then every 10 s</source>
        <translation>Kritische Alarme piepen bis zur Quittierung: sofort, dann alle 10 s</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>Stumm</translation>
    </message>
    <message>
        <source>muted for %1</source>
        <translation>stumm für %1</translation>
    </message>
    <message>
        <source>No alarm is active</source>
        <translation>Es gibt keinen Alarm</translation>
    </message>
    <message>
        <source>No alarm is selected in the list</source>
        <translation>In der Liste ist kein Alarm gewählt</translation>
    </message>
    <message>
        <source>Test the sound</source>
        <translation>Ton prüfen</translation>
    </message>
    <message>
        <source>Plays the alarm sound once</source>
        <translation>Spielt den Alarmton einmal</translation>
    </message>
    <message>
        <source>✘ Only the desktop&apos;s bell can sound: %1</source>
        <translation>✘ Kein Ton außer der Glocke der Arbeitsfläche: %1</translation>
    </message>
</context>
<context>
    <name>terratact::AlarmsPage</name>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
</context>
<context>
    <name>terratact::ArmingControl</name>
    <message>
        <source>Arming</source>
        <translation>Freigabe</translation>
    </message>
    <message>
        <source>hold to arm (M)</source>
        <translation>halten: freigeben (M)</translation>
    </message>
    <message>
        <source>Hold to arm the robot</source>
        <translation>Halten, um den Roboter freizugeben</translation>
    </message>
    <message>
        <source>Hold within 5 s; then commands from this console move the robot</source>
        <translation>Innerhalb von 5 s; danach bewegen Befehle von hier den Roboter</translation>
    </message>
    <message>
        <source>Commands from this console move the robot. A click halts and disarms it</source>
        <translation>Befehle von hier bewegen den Roboter. Ein Klick hält ihn an und sperrt ihn</translation>
    </message>
    <message>
        <source>Asks for a second action within 5 s</source>
        <translation>Verlangt innerhalb von 5 s eine zweite Handlung</translation>
    </message>
    <message>
        <source>
Last disarmed: %1</source>
        <translation>
Zuletzt gesperrt: %1</translation>
    </message>
    <message>
        <source>DISARMED · arm (M)</source>
        <translation>GESPERRT · freigeben (M)</translation>
    </message>
    <message>
        <source>ARMED · disarm (M)</source>
        <translation>FREIGEGEBEN · sperren (M)</translation>
    </message>
    <message>
        <source>arming … cancel (M)</source>
        <translation>Freigabe … abbrechen (M)</translation>
    </message>
    <message>
        <source>NO COMMANDS</source>
        <translation>KEINE BEFEHLE</translation>
    </message>
    <message>
        <source>Not possible now:</source>
        <translation>Jetzt nicht möglich:</translation>
    </message>
</context>
<context>
    <name>terratact::AtemPanel</name>
    <message>
        <source>Exploration (ATEM)</source>
        <translation>Erkundung (ATEM)</translation>
    </message>
    <message>
        <source>State of the exploration</source>
        <translation>Stand der Erkundung</translation>
    </message>
    <message>
        <source>Explore the terrain (A)</source>
        <translation>Erkunden (A)</translation>
    </message>
    <message>
        <source>Abort (Esc)</source>
        <translation>Abbruch (Esc)</translation>
    </message>
    <message>
        <source>hold to release STOP (R)</source>
        <translation>halten: STOP lösen (R)</translation>
    </message>
    <message>
        <source>Hold to release STOP</source>
        <translation>Halten, um STOP zu lösen</translation>
    </message>
    <message>
        <source>Allows commands again; the robot does not move by itself</source>
        <translation>Lässt Befehle wieder durch; der Roboter bewegt sich nicht von selbst</translation>
    </message>
    <message>
        <source>; no answer in time counts as refused</source>
        <translation>; ohne Antwort in der Zeit gilt sie als abgelehnt</translation>
    </message>
    <message>
        <source>, arm included</source>
        <translation>, Arm eingerechnet</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>An exploration is running: end it with Esc first</source>
        <translation>Eine Erkundung läuft: erst mit Esc beenden</translation>
    </message>
    <message>
        <source>Halts the robot, presses the front flippers down and estimates the terrain</source>
        <translation>Hält den Roboter an, drückt die vorderen Flipper an und schätzt das Gelände</translation>
    </message>
    <message>
        <source>Halts the robot and ends the exploration</source>
        <translation>Hält den Roboter an und beendet die Erkundung</translation>
    </message>
    <message>
        <source>No exploration is running</source>
        <translation>Es läuft keine Erkundung</translation>
    </message>
    <message>
        <source>Override (O)</source>
        <translation>Trotzdem (O)</translation>
    </message>
    <message>
        <source>Explores in spite of the doubtful requirement. The override is recorded and stays on the screen</source>
        <translation>Erkundet trotz der zweifelhaften Voraussetzung. Das Übergehen wird aufgezeichnet und bleibt auf dem Bildschirm</translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation>noch etwa %1</translation>
    </message>
    <message>
        <source>gives up in %1</source>
        <translation>gibt auf in %1</translation>
    </message>
    <message>
        <source>Not possible now:</source>
        <translation>Jetzt nicht möglich:</translation>
    </message>
    <message>
        <source>Doubtful, override it first (O):</source>
        <translation>Zweifelhaft, erst übergehen (O):</translation>
    </message>
    <message>
        <source>exploring</source>
        <translation>Erkunden</translation>
    </message>
    <message>
        <source>driving</source>
        <translation>Fahren</translation>
    </message>
    <message>
        <source>arming</source>
        <translation>Freigabe</translation>
    </message>
    <message>
        <source>approving a probe</source>
        <translation>Genehmigen einer Sondierung</translation>
    </message>
    <message>
        <source>releasing STOP</source>
        <translation>Lösen von STOP</translation>
    </message>
    <message>
        <source>needs (P)</source>
        <translation>Bedarf (P)</translation>
    </message>
    <message>
        <source>Requirements of a command</source>
        <translation>Was ein Befehl braucht</translation>
    </message>
    <message>
        <source>Requirements of each command, and which are missing (P)</source>
        <translation>Was jeder Befehl braucht, und was davon fehlt (P)</translation>
    </message>
    <message>
        <source>%1 needs:</source>
        <translation>%1 braucht:</translation>
    </message>
    <message>
        <source>nothing is explored</source>
        <translation>keine Erkundung</translation>
    </message>
    <message>
        <source>not ready</source>
        <translation>nicht bereit</translation>
    </message>
    <message>
        <source>not ready: doubtful</source>
        <translation>nicht bereit: zweifelhaft</translation>
    </message>
    <message>
        <source>Exploration</source>
        <translation>Erkundung</translation>
    </message>
    <message>
        <source>Forget (Del)</source>
        <translation>Vergessen (Entf)</translation>
    </message>
    <message>
        <source>The robot presses again, then the probe is proposed. The arm moves only after your approval</source>
        <translation>Der Roboter drückt erneut an, dann wird die Sondierung vorgeschlagen. Der Arm bewegt sich erst nach Ihrer Genehmigung</translation>
    </message>
    <message>
        <source>Hides the result; Ctrl+Z restores it</source>
        <translation>Nimmt das Ergebnis vom Schirm; Strg+Z bringt es zurück</translation>
    </message>
    <message>
        <source>Probe %1 (B)</source>
        <translation>Sonde %1 (B)</translation>
    </message>
    <message>
        <source>Explore (A)</source>
        <translation>Erkunden (A)</translation>
    </message>
    <message>
        <source>Probe (B)</source>
        <translation>Sonde (B)</translation>
    </message>
</context>
<context>
    <name>terratact::BinInspector</name>
    <message>
        <source>Selected bin</source>
        <translation>Gewähltes Feld</translation>
    </message>
</context>
<context>
    <name>terratact::ConnectWindow</name>
    <message>
        <source>can be used</source>
        <translation>kann benutzt werden</translation>
    </message>
    <message>
        <source>can be used, see below</source>
        <translation>kann benutzt werden, siehe unten</translation>
    </message>
    <message>
        <source>cannot be used, see below</source>
        <translation>kann nicht benutzt werden, siehe unten</translation>
    </message>
    <message>
        <source>repair: %1</source>
        <translation>Abhilfe: %1</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>In use: %1</source>
        <translation>In Gebrauch: %1</translation>
    </message>
    <message>
        <source>What to work with</source>
        <translation>Womit gearbeitet wird</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>This console may send commands on that bus</source>
        <translation>Diese Konsole darf auf dem Bus Befehle senden</translation>
    </message>
    <message>
        <source>Without it, the console only listens; like --transmit at the start</source>
        <translation>Sonst hört die Konsole nur zu; wie --transmit beim Start</translation>
    </message>
    <message>
        <source>Why it is not connected</source>
        <translation>Warum nicht verbunden wird</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Neu prüfen</translation>
    </message>
    <message>
        <source>Looks at the CAN interfaces of this computer again</source>
        <translation>Prüft die CAN-Schnittstellen dieses Rechners neu</translation>
    </message>
    <message>
        <source>Simulated robot in this program</source>
        <translation>Simulierter Roboter in diesem Programm</translation>
    </message>
    <message>
        <source>CAN bus %1 — %2</source>
        <translation>CAN-Bus %1 — %2</translation>
    </message>
    <message>
        <source>Log to replay, in another window</source>
        <translation>Log zum Abspielen, in einem anderen Fenster</translation>
    </message>
    <message>
        <source>Session to review, in another window</source>
        <translation>Sitzung zum Ansehen, in einem anderen Fenster</translation>
    </message>
    <message>
        <source>This interface cannot be used: repair it first, then look again</source>
        <translation>Diese Schnittstelle kann nicht benutzt werden: erst den Fehler beheben, dann neu prüfen</translation>
    </message>
    <message>
        <source>✔ Needs no hardware. Its ground is the one that the console was started with</source>
        <translation>✔ Braucht keine Hardware. Sein Gelände ist das vom Start der Konsole</translation>
    </message>
    <message>
        <source>Logs of candump, Vector (.asc), PEAK (.trc), GVRET and python-can, also packed by gzip</source>
        <translation>Logs von candump, Vector (.asc), PEAK (.trc), GVRET und python-can, auch mit gzip gepackt</translation>
    </message>
    <message>
        <source>Choose a log …</source>
        <translation>Log wählen …</translation>
    </message>
    <message>
        <source>Recordings of this console (.tts), in %1</source>
        <translation>Aufzeichnungen dieser Konsole (.tts), in %1</translation>
    </message>
    <message>
        <source>Choose a session …</source>
        <translation>Sitzung wählen …</translation>
    </message>
    <message>
        <source>Restarts the console with it (Return)</source>
        <translation>Startet die Konsole damit neu (Return)</translation>
    </message>
    <message>
        <source>Session to review</source>
        <translation>Sitzung zum Ansehen</translation>
    </message>
    <message>
        <source>Log to replay</source>
        <translation>Log zum Abspielen</translation>
    </message>
    <message>
        <source>Sessions (*.tts)</source>
        <translation>Sitzungen (*.tts)</translation>
    </message>
    <message>
        <source>%1 is no session; choose a recording of this console, or replay it as a log</source>
        <translation>%1 ist keine Sitzung; eine Aufzeichnung dieser Konsole wählen, oder als Log abspielen</translation>
    </message>
    <message>
        <source>%1 is a session; choose it as a session</source>
        <translation>%1 ist eine Sitzung; als Sitzung wählen</translation>
    </message>
    <message>
        <source>Looking for CAN buses …</source>
        <translation>Die CAN-Busse werden gesucht …</translation>
    </message>
    <message>
        <source>Choose what to work with</source>
        <translation>Wählen, womit gearbeitet wird</translation>
    </message>
    <message>
        <source>CAN bus %1 is no longer there</source>
        <translation>Den CAN-Bus %1 gibt es nicht mehr</translation>
    </message>
    <message>
        <source>Logs and recordings of other programs (*.log *.asc *.trc *.csv *.gz *.mcap *.bag *.db3);;All files (*)</source>
        <translation>Logs und Aufzeichnungen anderer Programme (*.log *.asc *.trc *.csv *.gz *.mcap *.bag *.db3);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Recordings of this console (.tts)</source>
        <translation>Aufzeichnungen dieser Konsole (.tts)</translation>
    </message>
</context>
<context>
    <name>terratact::ConsoleAlarms</name>
    <message>
        <source>No model, so nothing can be estimated: %1</source>
        <translation>Kein Modell, also keine Schätzung: %1</translation>
    </message>
    <message>
        <source>Exploration failed: %1</source>
        <translation>Erkundung fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>The robot is stopped and moves only after a release</source>
        <translation>Der Roboter ist gestoppt und bewegt sich erst nach dem Lösen</translation>
    </message>
    <message>
        <source>Another console sends commands on this bus: find it and turn it off</source>
        <translation>Eine andere Konsole sendet Befehle auf diesem Bus: suchen und abschalten</translation>
    </message>
    <message>
        <source>This computer was too slow for the bus: %1 frames lost since the start</source>
        <translation>Dieser Rechner war zu langsam für den Bus: %1 Rahmen seit dem Start verloren</translation>
    </message>
    <message>
        <source>Damaged frames: %1 with a wrong checksum since the start</source>
        <translation>Beschädigte Rahmen: seit dem Start %1 mit falscher Prüfsumme</translation>
    </message>
    <message>
        <source>Force sensors not usable: %1</source>
        <translation>Kraftsensoren unbrauchbar: %1</translation>
    </message>
    <message>
        <source>Not recorded: %1</source>
        <translation>Nicht aufgezeichnet: %1</translation>
    </message>
    <message>
        <source>%1; gaps: %2, the longest %3</source>
        <translation>%1; Lücken: %2, die längste %3</translation>
    </message>
    <message>
        <source>Disarmed: %1</source>
        <translation>Nicht mehr freigegeben: %1</translation>
    </message>
    <message>
        <source>pitch %1, tips over at %2</source>
        <translation>Nickwinkel %1, kippt bei %2</translation>
    </message>
    <message>
        <source>roll %1, tips over at %2</source>
        <translation>Rollwinkel %1, kippt bei %2</translation>
    </message>
    <message>
        <source>Danger of tipping over: %1</source>
        <translation>Kippgefahr: %1</translation>
    </message>
    <message>
        <source>Steep: %1</source>
        <translation>Steil: %1</translation>
    </message>
    <message>
        <source>Do not trust this sensor: %1</source>
        <translation>Diesem Sensor nicht trauen: %1</translation>
    </message>
    <message>
        <source>The robot has halted by itself: %1</source>
        <translation>Der Roboter hat von selbst angehalten: %1</translation>
    </message>
    <message>
        <source>left %1 %2</source>
        <translation>links %1 %2</translation>
    </message>
    <message>
        <source>right %1 %2</source>
        <translation>rechts %1 %2</translation>
    </message>
    <message>
        <source>Telemetry unsteady</source>
        <translation>Telemetrie unstetig</translation>
    </message>
    <message>
        <source>Link unsteady</source>
        <translation>Verbindung unstetig</translation>
    </message>
    <message>
        <source>Telemetry lost</source>
        <translation>Telemetrie weg</translation>
    </message>
    <message>
        <source>Link lost</source>
        <translation>Verbindung weg</translation>
    </message>
    <message>
        <source>No telemetry since the start</source>
        <translation>Seit dem Start keine Telemetrie</translation>
    </message>
</context>
<context>
    <name>terratact::ConsoleWindow</name>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Layout, colours and font size</source>
        <translation>Anordnung, Farben und Schriftgröße</translation>
    </message>
    <message>
        <source>this sheet</source>
        <translation>diese Übersicht</translation>
    </message>
    <message>
        <source>STOP HAS NO EFFECT HERE: this window has no robot. Use the console&apos;s own window</source>
        <translation>STOP WIRKT HIER NICHT: dieses Fenster hat keinen Roboter. Zum Fenster der Konsole wechseln</translation>
    </message>
    <message>
        <source>no STOP: this window has no robot</source>
        <translation>kein STOP: dieses Fenster hat keinen Roboter</translation>
    </message>
    <message>
        <source>Sends STOP through the console that opened this window</source>
        <translation>Sendet STOP über die Konsole, die dieses Fenster geöffnet hat</translation>
    </message>
    <message>
        <source>SAFE MODE: default settings; none are read or saved · start without --safe-mode to leave it</source>
        <translation>SICHERER MODUS: Standardeinstellungen, nichts wird gelesen oder gespeichert · zum Verlassen ohne --safe-mode starten</translation>
    </message>
    <message>
        <source>Help
F1</source>
        <translation>Hilfe
F1</translation>
    </message>
    <message>
        <source>All keys, and about this program</source>
        <translation>Alle Tasten, und was dieses Programm ist</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>About Terratact</source>
        <translation>Über Terratact</translation>
    </message>
    <message>
        <source>what this program is</source>
        <translation>was dieses Programm ist</translation>
    </message>
    <message>
        <source>Recorded demonstration</source>
        <translation>Aufgezeichnete Vorführung</translation>
    </message>
    <message>
        <source>Recorded demonstration, two tracks</source>
        <translation>Aufgezeichnete Vorführung, zwei Ketten</translation>
    </message>
    <message>
        <source>full screen, and back</source>
        <translation>Vollbild und zurück</translation>
    </message>
</context>
<context>
    <name>terratact::ContactMarks</name>
    <message>
        <source>CONTACT %1</source>
        <translation>KONTAKT %1</translation>
    </message>
</context>
<context>
    <name>terratact::DiagnosticsPage</name>
    <message>
        <source>Versions</source>
        <translation>Versionen</translation>
    </message>
    <message>
        <source>kernel</source>
        <translation>Kernel</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Prozessor</translation>
    </message>
    <message>
        <source>cores</source>
        <translation>Kerne</translation>
    </message>
    <message>
        <source>estimator uses</source>
        <translation>Schätzer nutzt</translation>
    </message>
    <message>
        <source>training uses</source>
        <translation>Training nutzt</translation>
    </message>
    <message>
        <source>✔ possible</source>
        <translation>✔ möglich</translation>
    </message>
    <message>
        <source>✘ not possible: %1</source>
        <translation>✘ nicht möglich: %1</translation>
    </message>
    <message>
        <source>none here</source>
        <translation>hier keine</translation>
    </message>
    <message>
        <source>✔ %1</source>
        <translation>✔ %1</translation>
    </message>
    <message>
        <source>✘ %1: no permission (join the group gpio)</source>
        <translation>✘ %1: keine Rechte (in die Gruppe gpio eintreten)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Permissions</source>
        <translation>Rechte</translation>
    </message>
    <message>
        <source>CAN socket</source>
        <translation>CAN-Socket</translation>
    </message>
    <message>
        <source>CAN interfaces</source>
        <translation>CAN-Schnittstellen</translation>
    </message>
    <message>
        <source>GPIO chips</source>
        <translation>GPIO-Chips</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Last minute</source>
        <translation>Letzte Minute</translation>
    </message>
    <message>
        <source>a frame takes</source>
        <translation>ein Bild braucht</translation>
    </message>
    <message>
        <source>an event waits</source>
        <translation>ein Ereignis wartet</translation>
    </message>
    <message>
        <source>telemetry to screen</source>
        <translation>Telemetrie bis Schirm</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnose</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Als Text kopieren</translation>
    </message>
    <message>
        <source>Copies this page, for a report</source>
        <translation>Kopiert diese Seite, für einen Bericht</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>age of the telemetry</source>
        <translation>Alter der Telemetrie</translation>
    </message>
    <message>
        <source>telemetry</source>
        <translation>Telemetrie</translation>
    </message>
    <message>
        <source>CAN frames waiting</source>
        <translation>wartende CAN-Rahmen</translation>
    </message>
    <message>
        <source>%1 now, %2 at most</source>
        <translation>%1 jetzt, höchstens %2</translation>
    </message>
    <message>
        <source>estimator</source>
        <translation>Schätzer</translation>
    </message>
    <message>
        <source>one estimate under way</source>
        <translation>eine Schätzung läuft</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>untätig</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>What it works with</source>
        <translation>Womit sie arbeitet</translation>
    </message>
    <message>
        <source>source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>facts of the robot</source>
        <translation>Angaben zum Roboter</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>facts of the model</source>
        <translation>Angaben zum Modell</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>geschlossen</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>%1 · edges %2</source>
        <translation>%1 · Flanken %2</translation>
    </message>
    <message>
        <source>%1 · edges %2 · presses %3</source>
        <translation>%1 · Flanken %2 · Betätigungen %3</translation>
    </message>
    <message>
        <source>newest %1 · worst %2 of %3</source>
        <translation>letzte %1 · schlechteste %2 von %3</translation>
    </message>
    <message>
        <source>Operator&apos;s panel</source>
        <translation>Bedienpult</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>Pult</translation>
    </message>
    <message>
        <source>✘ does not answer: %1</source>
        <translation>✘ antwortet nicht: %1</translation>
    </message>
    <message>
        <source>✔ answers</source>
        <translation>✔ antwortet</translation>
    </message>
    <message>
        <source>contact %1</source>
        <translation>Kontakt %1</translation>
    </message>
    <message>
        <source>events lost</source>
        <translation>verlorene Ereignisse</translation>
    </message>
    <message>
        <source>%1 by the kernel · panel gone %2 times</source>
        <translation>%1 im Kernel · Pult %2-mal verschwunden</translation>
    </message>
    <message>
        <source>STOP to the bus</source>
        <translation>STOP bis auf den Bus</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>estimates</source>
        <translation>Schätzungen</translation>
    </message>
    <message>
        <source>%1 of %2 contradicted the readings</source>
        <translation>%1 von %2 widersprachen den Messwerten</translation>
    </message>
    <message>
        <source>median %1 · 99 % below %2 · longest %3</source>
        <translation>Median %1 · 99 % unter %2 · längste %3</translation>
    </message>
</context>
<context>
    <name>terratact::DrivePad</name>
    <message>
        <source>Drive</source>
        <translation>Fahren</translation>
    </message>
    <message>
        <source>◀ hold: back (S)</source>
        <translation>◀ halten: zurück (S)</translation>
    </message>
    <message>
        <source>Hold to drive back</source>
        <translation>Halten, um zurückzufahren</translation>
    </message>
    <message>
        <source>hold: forward (W) ▶</source>
        <translation>halten: vor (W) ▶</translation>
    </message>
    <message>
        <source>Hold to drive forward</source>
        <translation>Halten, um vorwärtszufahren</translation>
    </message>
    <message>
        <source>Dead-man key: drives while held; also the arrow keys Up and Down</source>
        <translation>Totmanntaste: fährt, solange gehalten; auch mit den Pfeiltasten auf und ab</translation>
    </message>
    <message>
        <source>Hold to feel forward</source>
        <translation>Halten zum Vortasten</translation>
    </message>
    <message>
        <source>Dead-man key: while held, the robot presses, estimates and advances, as long as the verdict is CLEAR</source>
        <translation>Totmanntaste: solange gehalten, drückt der Roboter an, schätzt und rückt vor, wenn das Urteil FREI ist</translation>
    </message>
    <message>
        <source>hold: feel (F)</source>
        <translation>halten: tasten (F)</translation>
    </message>
    <message>
        <source>◀ S</source>
        <translation>◀ S</translation>
    </message>
    <message>
        <source>feel F</source>
        <translation>tasten F</translation>
    </message>
    <message>
        <source>W ▶</source>
        <translation>W ▶</translation>
    </message>
</context>
<context>
    <name>terratact::DriveStrip</name>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>since estimate</source>
        <translation>seit Schätzung</translation>
    </message>
    <message>
        <source>felt to</source>
        <translation>ertastet bis</translation>
    </message>
    <message>
        <source>The element of each flipper that touches the ground hardest: its side and its number, 1 (pivot) to 6 (tip)</source>
        <translation>Das Element jedes Flippers, das den Boden am stärksten berührt: Seite und Nummer, 1 (Drehachse) bis 6 (Spitze)</translation>
    </message>
    <message>
        <source>Distance rolled since the last estimate</source>
        <translation>Gefahrene Strecke seit der letzten Schätzung</translation>
    </message>
    <message>
        <source>● CONTACT</source>
        <translation>● KONTAKT</translation>
    </message>
    <message>
        <source>Driving</source>
        <translation>Fahren</translation>
    </message>
    <message>
        <source>STEEP at %1, DANGER at %2, tips over at %3</source>
        <translation>STEIL ab %1, GEFAHR ab %2, kippt bei %3</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Along the tracks, over the last 0.3 s</source>
        <translation>Entlang der Ketten, über die letzten 0,3 s</translation>
    </message>
    <message>
        <source>The ground is felt up to here, forward from the IMU, on both sides. &quot;!&quot;: the tracks are about to leave felt ground. &quot;none&quot;: nothing ahead is felt</source>
        <translation>Der Boden ist bis hier ertastet, vorwärts ab der IMU, auf beiden Seiten. „!“: die Ketten verlassen gleich ertasteten Boden. „nichts“: voraus ist nichts ertastet</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nichts</translation>
    </message>
</context>
<context>
    <name>terratact::EstimateStrip</name>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Warnings about the result</source>
        <translation>Warnungen zum Ergebnis</translation>
    </message>
    <message>
        <source>Progress of the estimate</source>
        <translation>Fortschritt der Schätzung</translation>
    </message>
    <message>
        <source>Cancel (Esc)</source>
        <translation>Abbruch (Esc)</translation>
    </message>
    <message>
        <source>Ends the estimate and the exploration</source>
        <translation>Beendet Schätzung und Erkundung</translation>
    </message>
    <message>
        <source>Known to ± %1, widest at %2</source>
        <translation>Bekannt auf ± %1, am weitesten bei %2</translation>
    </message>
    <message>
        <source>%1 · %2 draws · %3</source>
        <translation>%1 · %2 Ziehungen · %3</translation>
    </message>
    <message>
        <source>the chains have not converged</source>
        <translation>die Ketten sind nicht konvergiert</translation>
    </message>
    <message>
        <source>estimating %p %</source>
        <translation>schätzt %p %</translation>
    </message>
    <message>
        <source>Uncertain at %1: ± %2</source>
        <translation>Unsicher bei %1: ± %2</translation>
    </message>
    <message>
        <source>ended: converged</source>
        <translation>Ende: konvergiert</translation>
    </message>
    <message>
        <source>ended: all draws made</source>
        <translation>Ende: alle Ziehungen gemacht</translation>
    </message>
    <message>
        <source>ended: time limit</source>
        <translation>Ende: Zeit war um</translation>
    </message>
</context>
<context>
    <name>terratact::Estimation</name>
    <message>
        <source>model %1 loaded</source>
        <translation>Modell %1 geladen</translation>
    </message>
    <message>
        <source>model %1 stays in use: %2</source>
        <translation>Modell %1 bleibt in Gebrauch: %2</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innerhalb</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>außerhalb</translation>
    </message>
    <message>
        <source>No live estimate: %1</source>
        <translation>Keine laufende Schätzung: %1</translation>
    </message>
    <message>
        <source>no second estimate: %1</source>
        <translation>keine zweite Schätzung: %1</translation>
    </message>
    <message>
        <source>estimate failed: %1</source>
        <translation>Schätzung fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>estimate in %1</source>
        <translation>Schätzung in %1</translation>
    </message>
    <message>
        <source>arm %1: %2 m, between the sides that are estimated</source>
        <translation>Arm %1: %2 m, zwischen den geschätzten Seiten</translation>
    </message>
    <message>
        <source>arm %1: %2 m, %3 the band shown before</source>
        <translation>Arm %1: %2 m, %3 des zuvor gezeigten Bandes</translation>
    </message>
    <message>
        <source>Nothing is remembered here: %1</source>
        <translation>Hier ist nichts gemerkt: %1</translation>
    </message>
    <message>
        <source>No remembered ground while telemetry is missing</source>
        <translation>Kein gemerkter Boden, solange Telemetrie fehlt</translation>
    </message>
    <message>
        <source>no memory: %1</source>
        <translation>kein Gedächtnis: %1</translation>
    </message>
    <message>
        <source>a current or a force was not measured</source>
        <translation>ein Strom oder eine Kraft wurde nicht gemessen</translation>
    </message>
    <message>
        <source>the networks do not know such a pose</source>
        <translation>die Netze kennen eine solche Lage nicht</translation>
    </message>
    <message>
        <source>the model has no networks for it (%1 is not beside it)</source>
        <translation>das Modell hat keine Netze dafür (%1 liegt nicht daneben)</translation>
    </message>
    <message>
        <source>the networks %1 learnt from another robot</source>
        <translation>die Netze %1 haben von einem anderen Roboter gelernt</translation>
    </message>
    <message>
        <source>the way begins here</source>
        <translation>der Weg beginnt hier</translation>
    </message>
    <message>
        <source>memory cleared: %1</source>
        <translation>Gedächtnis gelöscht: %1</translation>
    </message>
    <message>
        <source>the model has no networks for it</source>
        <translation>das Modell hat keine Netze dafür</translation>
    </message>
    <message>
        <source>memory: %1 m</source>
        <translation>Gedächtnis: %1 m</translation>
    </message>
    <message>
        <source>memory: %1 m · earlier presses: %2</source>
        <translation>Gedächtnis: %1 m · früher angedrückt: %2</translation>
    </message>
    <message>
        <source>bands held: %1 of %2</source>
        <translation>Bänder hielten: %1 von %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>no memory but of the arm: %1</source>
        <translation>kein Gedächtnis außer dem des Arms: %1</translation>
    </message>
</context>
<context>
    <name>terratact::EventList</name>
    <message>
        <source>Last minutes</source>
        <translation>Letzte Minuten</translation>
    </message>
</context>
<context>
    <name>terratact::Exploration</name>
    <message>
        <source>No estimate yet: explore the terrain (A)</source>
        <translation>Noch keine Schätzung: Gelände erkunden (A)</translation>
    </message>
    <message>
        <source>STOP not sent: %1</source>
        <translation>STOP nicht gesendet: %1</translation>
    </message>
    <message>
        <source>STOP released by the operator</source>
        <translation>STOP vom Bediener gelöst</translation>
    </message>
    <message>
        <source>command not sent: %1</source>
        <translation>Befehl nicht gesendet: %1</translation>
    </message>
    <message>
        <source>the robot did not release STOP: hold R again</source>
        <translation>der Roboter hat STOP nicht gelöst: R noch einmal halten</translation>
    </message>
    <message>
        <source>No estimate: explore the terrain (A)</source>
        <translation>Keine Schätzung: Gelände erkunden (A)</translation>
    </message>
    <message>
        <source>The robot has moved: explore again (A)</source>
        <translation>Der Roboter hat sich bewegt: neu erkunden (A)</translation>
    </message>
    <message>
        <source>Exploring: the robot halts</source>
        <translation>Erkundung: der Roboter hält an</translation>
    </message>
    <message>
        <source>exploration requested</source>
        <translation>Erkundung angefordert</translation>
    </message>
    <message>
        <source>Exploring: the front flippers press down</source>
        <translation>Erkundung: die vorderen Flipper drücken an</translation>
    </message>
    <message>
        <source>Estimating …</source>
        <translation>Schätzt …</translation>
    </message>
    <message>
        <source>no answer in time: refused</source>
        <translation>keine Antwort in der Zeit: keine Sondierung</translation>
    </message>
    <message>
        <source>probe refused</source>
        <translation>Sondierung abgelehnt</translation>
    </message>
    <message>
        <source>exploration ended by the operator</source>
        <translation>Erkundung vom Bediener beendet</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>exploration failed: %1</source>
        <translation>Erkundung fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>No estimate: %1</source>
        <translation>Keine Schätzung: %1</translation>
    </message>
    <message>
        <source>No estimate yet: one is made when the robot presses its flippers</source>
        <translation>Noch keine Schätzung: sie kommt, wenn der Roboter die Flipper andrückt</translation>
    </message>
    <message>
        <source>No estimate yet: press M, then hold M to arm; then explore (A)</source>
        <translation>Noch keine Schätzung: M drücken, dann M halten zum Freigeben; dann erkunden (A)</translation>
    </message>
    <message>
        <source>not armed: press M, then hold M</source>
        <translation>nicht freigegeben: M drücken, dann M halten</translation>
    </message>
    <message>
        <source>the next estimate: %1, %2 draws, contacts above %3 N</source>
        <translation>nächste Schätzung: %1, %2 Ziehungen, Kontakte über %3 N</translation>
    </message>
    <message>
        <source>overridden by the operator: %1</source>
        <translation>vom Bediener übergangen: %1</translation>
    </message>
    <message>
        <source>No estimate: there is no model</source>
        <translation>Keine Schätzung: es gibt kein Modell</translation>
    </message>
    <message>
        <source>No estimate yet: the model is being loaded</source>
        <translation>Noch keine Schätzung: das Modell wird geladen</translation>
    </message>
    <message>
        <source>the robot reports stopped</source>
        <translation>der Roboter meldet, dass er gestoppt ist</translation>
    </message>
    <message>
        <source>STOP sent, not confirmed by the robot</source>
        <translation>STOP gesendet, vom Roboter nicht bestätigt</translation>
    </message>
    <message>
        <source>the override has ended: %1</source>
        <translation>das Übergehen ist beendet: %1</translation>
    </message>
    <message>
        <source>No probe offered: every bin in reach is known to ± %1 m or better</source>
        <translation>Nicht angeboten: jedes Feld in Reichweite ist auf ± %1 m oder besser bekannt</translation>
    </message>
    <message>
        <source>No probe offered, by the settings: %1 is decided without the arm</source>
        <translation>Nach den Einstellungen nicht angeboten: %1 ist ohne den Arm entschieden</translation>
    </message>
    <message>
        <source>No probe offered, by the settings: no bin in reach informs about the step</source>
        <translation>Nach den Einstellungen nicht angeboten: kein Feld in Reichweite sagt etwas über die Stufe</translation>
    </message>
    <message>
        <source>No probe was offered with this estimate: explore again</source>
        <translation>Nicht angeboten, als die Schätzung kam: erneut erkunden, um gefragt zu werden</translation>
    </message>
    <message>
        <source>No estimate yet: no telemetry from the robot</source>
        <translation>Noch keine Schätzung: keine Telemetrie vom Roboter</translation>
    </message>
    <message>
        <source>No estimate: STOP is latched</source>
        <translation>Keine Schätzung: STOP ist eingerastet</translation>
    </message>
    <message>
        <source>an exploration is running</source>
        <translation>eine Erkundung läuft</translation>
    </message>
    <message>
        <source>no probe requested: %1</source>
        <translation>keine Sondierung angefordert: %1</translation>
    </message>
    <message>
        <source>the estimate is hidden: Ctrl+Z restores it</source>
        <translation>die Schätzung ist vom Schirm: Strg+Z bringt sie zurück</translation>
    </message>
    <message>
        <source>the estimate is back</source>
        <translation>die Schätzung ist zurück</translation>
    </message>
    <message>
        <source>no estimate can be brought back</source>
        <translation>keine Schätzung kann zurückgeholt werden</translation>
    </message>
    <message>
        <source>the robot drives no further: the built-in ground ends here, or is too steep. Drive back, or start with another --terrain</source>
        <translation>der Roboter fährt nicht weiter: der eingebaute Boden endet hier oder ist zu steil. Zurückfahren, oder mit anderem --terrain starten</translation>
    </message>
    <message>
        <source>the robot drives no further: the ground of the file %1 ends here, or is too steep. Drive back, or start with another --terrain</source>
        <translation>der Roboter fährt nicht weiter: der Boden der Datei %1 endet hier oder ist zu steil. Zurückfahren, oder mit anderem --terrain starten</translation>
    </message>
    <message>
        <source>the robot reports driving, but its tracks do not move</source>
        <translation>der Roboter meldet, dass er fährt, aber seine Ketten bewegen sich nicht</translation>
    </message>
    <message>
        <source>probe proposed %1</source>
        <translation>Sondierung vorgeschlagen %1</translation>
    </message>
    <message>
        <source>probe %1 approved</source>
        <translation>Sondierung %1 genehmigt</translation>
    </message>
    <message>
        <source>a probe %1 is requested: the robot presses again, then asks for approval</source>
        <translation>eine Sondierung %1 ist gewünscht: der Roboter drückt erneut, dann wird gefragt</translation>
    </message>
    <message>
        <source>probe %1 requested instead</source>
        <translation>stattdessen Sondierung %1 angefordert</translation>
    </message>
    <message>
        <source>the arm does not reach the ground %1</source>
        <translation>der Arm erreicht den Boden %1 nicht</translation>
    </message>
    <message>
        <source>advancing %1 m: CLEAR for %2 m ahead of the tracks</source>
        <translation>rückt %1 m vor: FREI für %2 m vor den Ketten</translation>
    </message>
    <message>
        <source>feeling forward while the control is held</source>
        <translation>tastet sich vor, solange die Taste gehalten wird</translation>
    </message>
    <message>
        <source>feel forward has ended after %1 m, %2 m/min: %3</source>
        <translation>Vortasten nach %1 m beendet, %2 m/min: %3</translation>
    </message>
    <message>
        <source>feel forward: %1 · %2 m · %3 m/min</source>
        <translation>Vortasten: %1 · %2 m · %3 m/min</translation>
    </message>
    <message>
        <source>feel forward has ended after %1 m: %2</source>
        <translation>Vortasten nach %1 m beendet: %2</translation>
    </message>
    <message>
        <source>no answer in time: no probe</source>
        <translation>keine Antwort in der Zeit: keine Sondierung</translation>
    </message>
    <message>
        <source>the robot says that it is stopped</source>
        <translation>der Roboter meldet, dass er gestoppt ist</translation>
    </message>
    <message>
        <source>The probe was refused</source>
        <translation>Die Sondierung wurde abgelehnt</translation>
    </message>
    <message>
        <source>it still reports the exploration before</source>
        <translation>er meldet noch die Erkundung davor</translation>
    </message>
</context>
<context>
    <name>terratact::ForceArrays</name>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
</context>
<context>
    <name>terratact::ForceBars</name>
    <message>
        <source>1 pivot</source>
        <translation>1 Achse</translation>
    </message>
    <message>
        <source>%1 tip</source>
        <translation>%1 Spitze</translation>
    </message>
    <message>
        <source>Forces on the front flippers</source>
        <translation>Kräfte an den vorderen Flippern</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>bias %1 N</source>
        <translation>Versatz %1 N</translation>
    </message>
    <message>
        <source>▲ sat.</source>
        <translation>▲ ges.</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>gesättigt</translation>
    </message>
    <message>
        <source>element %1: %2</source>
        <translation>Element %1: %2</translation>
    </message>
    <message>
        <source>Thin lines: highest of the last 3 s</source>
        <translation>Dünne Linien: Höchstwert der letzten 3 s</translation>
    </message>
</context>
<context>
    <name>terratact::GamepadControl</name>
    <message>
        <source>gamepad lost: all its controls are released</source>
        <translation>Gamepad verloren: alle seine Bedienelemente sind losgelassen</translation>
    </message>
    <message>
        <source>STOP pressed on the gamepad</source>
        <translation>STOP am Gamepad gedrückt</translation>
    </message>
    <message>
        <source>the gamepad “%1” is not connected any more</source>
        <translation>das Gamepad „%1“ ist nicht mehr angeschlossen</translation>
    </message>
    <message>
        <source>gamepad connected: %1</source>
        <translation>Gamepad angeschlossen: %1</translation>
    </message>
    <message>
        <source>the gamepad is connected by radio, whose loss is noticed late: connect it by cable</source>
        <translation>das Gamepad ist per Funk verbunden, dessen Ausfall spät bemerkt wird: über Kabel anschließen</translation>
    </message>
    <message>
        <source>not driven: hold the dead-man control first, then push the stick from its centre</source>
        <translation>nicht gefahren: zuerst den Totmannschalter halten, dann den Stick aus der Mitte bewegen</translation>
    </message>
</context>
<context>
    <name>terratact::GamepadPage</name>
    <message>
        <source>Gamepad</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>Assignment</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>Nothing was assigned: no control was moved for 10 s.</source>
        <translation>Nichts wurde zugeordnet: 10 s lang wurde kein Element bewegt.</translation>
    </message>
    <message>
        <source>Actions and their controls</source>
        <translation>Aktionen und ihre Elemente</translation>
    </message>
    <message>
        <source>Actions that work now</source>
        <translation>Aktionen, die jetzt wirken</translation>
    </message>
    <message>
        <source>Action to assign</source>
        <translation>Zuzuordnende Aktion</translation>
    </message>
    <message>
        <source>The action that gets another control</source>
        <translation>Die Aktion, die ein anderes Element bekommt</translation>
    </message>
    <message>
        <source>What arrives</source>
        <translation>Was ankommt</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Pressed buttons</source>
        <translation>Gedrückte Tasten</translation>
    </message>
    <message>
        <source>Driving</source>
        <translation>Fahren</translation>
    </message>
    <message>
        <source>Dead zone of the stick</source>
        <translation>Totzone des Sticks</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Share of the stick&apos;s way around its centre that drives nothing</source>
        <translation>Anteil des Stickwegs um die Mitte, der nichts fährt</translation>
    </message>
    <message>
        <source>Speed at full deflection</source>
        <translation>Geschwindigkeit bei vollem Ausschlag</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>The command gate accepts at most 0.6 m/s</source>
        <translation>Das Befehlstor nimmt höchstens 0.6 m/s an</translation>
    </message>
    <message>
        <source>Gamepad back to the defaults</source>
        <translation>Gamepad auf Standard zurücksetzen</translation>
    </message>
    <message>
        <source>Resets controls, dead zone and speed</source>
        <translation>Setzt Elemente, Totzone und Geschwindigkeit zurück</translation>
    </message>
    <message>
        <source>Press again to reset the gamepad</source>
        <translation>Noch einmal drücken, um das Gamepad zurückzusetzen</translation>
    </message>
    <message>
        <source>Nothing was assigned.</source>
        <translation>Nichts wurde zugeordnet.</translation>
    </message>
    <message>
        <source>Push the stick that drives in the direction of forward, for at most 10 s.</source>
        <translation>Den Stick, der fährt, in Richtung vorwärts drücken; gewartet wird 10 s.</translation>
    </message>
    <message>
        <source>Press the button or trigger for: %1. It waits 10 s.</source>
        <translation>Taste oder Trigger drücken für: %1. Gewartet wird 10 s.</translation>
    </message>
    <message>
        <source>On this page the gamepad moves nothing; STOP acts.</source>
        <translation>Auf dieser Seite bewegt das Gamepad nichts; STOP wirkt.</translation>
    </message>
    <message>
        <source>Not assigned: “%1” is a control of STOP. Give STOP another one first.</source>
        <translation>Nicht zugeordnet: „%1“ ist ein Element von STOP. Zuerst STOP ein anderes geben.</translation>
    </message>
    <message>
        <source>“%1” is now: %2.</source>
        <translation>„%1“ ist jetzt: %2.</translation>
    </message>
    <message>
        <source>Without a control now: %1.</source>
        <translation>Jetzt ohne Element: %1.</translation>
    </message>
    <message>
        <source>Nothing was assigned: the gamepad is not connected any more.</source>
        <translation>Nichts wurde zugeordnet: das Gamepad ist nicht mehr angeschlossen.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>no control</source>
        <translation>kein Element</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Zuordnen</translation>
    </message>
    <message>
        <source>Connected: %1</source>
        <translation>Angeschlossen: %1</translation>
    </message>
    <message>
        <source>By radio: its loss is noticed late. Connect it by cable.</source>
        <translation>Per Funk: ein Ausfall wird spät bemerkt. Über Kabel anschließen.</translation>
    </message>
    <message>
        <source>No gamepad is connected. Plug one in at any time.</source>
        <translation>Kein Gamepad ist angeschlossen. Es kann jederzeit angesteckt werden.</translation>
    </message>
    <message>
        <source>Then move the control that shall do this</source>
        <translation>Dann das Element bewegen, das dies tun soll</translation>
    </message>
    <message>
        <source>No gamepad is connected</source>
        <translation>Kein Gamepad ist angeschlossen</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>release it first</source>
        <translation>zuerst loslassen</translation>
    </message>
</context>
<context>
    <name>terratact::HistoryControl</name>
    <message>
        <source>the picture shows the estimate of %1, not the present one</source>
        <translation>das Bild zeigt die Schätzung von %1, nicht die jetzige</translation>
    </message>
    <message>
        <source>the picture shows the present estimate again</source>
        <translation>das Bild zeigt wieder die jetzige Schätzung</translation>
    </message>
    <message>
        <source>The picture shows the estimate of %1, not the present one. Backspace: the present</source>
        <translation>Das Bild zeigt die Schätzung von %1, nicht die jetzige. Rücktaste: die jetzige</translation>
    </message>
    <message>
        <source>past: estimate of %1</source>
        <translation>früher: Schätzung von %1</translation>
    </message>
    <message>
        <source>Dashed in the picture: the past estimate of %1%2. Backspace takes it away</source>
        <translation>Gestrichelt im Bild: die frühere Schätzung von %1%2. Rücktaste nimmt sie weg</translation>
    </message>
    <message>
        <source>, not moved by what was driven since</source>
        <translation>, nicht um die Fahrt seither verschoben</translation>
    </message>
    <message>
        <source>, not moved by the %1 driven since</source>
        <translation>, nicht um die seither gefahrenen %1 verschoben</translation>
    </message>
</context>
<context>
    <name>terratact::HistoryWindow</name>
    <message>
        <source>Present estimate (Backspace)</source>
        <translation>Jetzige Schätzung (Rücktaste)</translation>
    </message>
    <message>
        <source>Restore (Ctrl+Z)</source>
        <translation>Zurückholen (Strg+Z)</translation>
    </message>
    <message>
        <source>Estimates of this run</source>
        <translation>Schätzungen dieses Laufs</translation>
    </message>
    <message>
        <source>Estimates, newest first</source>
        <translation>Schätzungen, neueste zuerst</translation>
    </message>
    <message>
        <source>The picture shows the present estimate again</source>
        <translation>Das Bild zeigt wieder die jetzige Schätzung</translation>
    </message>
    <message>
        <source>Brings the hidden estimate back while the robot has not moved</source>
        <translation>Holt die ausgeblendete Schätzung zurück, solange der Roboter sich nicht bewegt hat</translation>
    </message>
    <message>
        <source>%1 · number %2</source>
        <translation>%1 · Nummer %2</translation>
    </message>
    <message>
        <source>present</source>
        <translation>jetzige</translation>
    </message>
    <message>
        <source>hidden by the operator</source>
        <translation>vom Bediener ausgeblendet</translation>
    </message>
    <message>
        <source>restored, from before</source>
        <translation>zurückgeholt, von vorher</translation>
    </message>
    <message>
        <source>No estimate yet. The last %1 of this run are kept.</source>
        <translation>Noch keine Schätzung. Die letzten %1 dieses Laufs werden behalten.</translation>
    </message>
    <message>
        <source>The estimate of %1 lies over the present one, in the robot&apos;s frame of that time.</source>
        <translation>Die Schätzung von %1 liegt über der jetzigen, im Bezugssystem des Roboters von damals.</translation>
    </message>
    <message>
        <source>The picture shows the present. Choose an estimate to see it; the verdict stays that of the present.</source>
        <translation>Das Bild zeigt die Gegenwart. Wählen Sie eine Schätzung, um sie zu sehen; das Urteil bleibt das jetzige.</translation>
    </message>
    <message>
        <source>Take it away (L)</source>
        <translation>Wegnehmen (L)</translation>
    </message>
    <message>
        <source>Lay over the present (L)</source>
        <translation>Über die jetzige legen (L)</translation>
    </message>
    <message>
        <source>Draws it as a lighter profile over the present one</source>
        <translation>Zeichnet sie als helleres Profil über die jetzige</translation>
    </message>
    <message>
        <source>Choose an estimate first</source>
        <translation>Wählen Sie zuerst eine Schätzung</translation>
    </message>
</context>
<context>
    <name>terratact::ImportPage</name>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>What the recording holds</source>
        <translation>Was die Aufzeichnung enthält</translation>
    </message>
    <message>
        <source>Mapping: which topic and field is which sensor</source>
        <translation>Zuordnung: welches Topic und Feld welcher Sensor ist</translation>
    </message>
    <message>
        <source>What is missing or doubtful</source>
        <translation>Was fehlt oder zweifelhaft ist</translation>
    </message>
    <message>
        <source>The recording h&amp;olds</source>
        <translation>Die A&amp;ufzeichnung enthält</translation>
    </message>
    <message>
        <source>&amp;Mapping: correct it where it is wrong</source>
        <translation>&amp;Zuordnung: korrigieren, wo sie falsch ist</translation>
    </message>
    <message>
        <source>Where the mapping comes from</source>
        <translation>Woher die Zuordnung kommt</translation>
    </message>
    <message>
        <source>proposed mapping</source>
        <translation>vorgeschlagene Zuordnung</translation>
    </message>
    <message>
        <source>shipped: %1</source>
        <translation>mitgeliefert: %1</translation>
    </message>
    <message>
        <source>from a file …</source>
        <translation>aus einer Datei …</translation>
    </message>
    <message>
        <source>&amp;Check</source>
        <translation>&amp;Prüfen</translation>
    </message>
    <message>
        <source>Read the recording by this mapping and list gaps, doubtful units and signs</source>
        <translation>Liest die Aufzeichnung nach dieser Zuordnung und nennt Lücken, zweifelhafte Einheiten und Vorzeichen</translation>
    </message>
    <message>
        <source>&amp;Import …</source>
        <translation>&amp;Importieren …</translation>
    </message>
    <message>
        <source>Write a session by this mapping and open it</source>
        <translation>Schreibt eine Sitzung nach dieser Zuordnung und öffnet sie</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>Abbreche&amp;n</translation>
    </message>
    <message>
        <source>Stop reading; nothing is written</source>
        <translation>Beendet das Lesen; nichts wird geschrieben</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Missing or &amp;doubtful</source>
        <translation>&amp;Fehlt oder ist zweifelhaft</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Prüfung läuft …</translation>
    </message>
    <message>
        <source>%1 messages read</source>
        <translation>%1 Nachrichten gelesen</translation>
    </message>
    <message>
        <source>Look at each table of the mapping, above all at signs and units; then check it.</source>
        <translation>Sehen Sie jede Tabelle der Zuordnung an, vor allem Vorzeichen und Einheiten; dann prüfen Sie sie.</translation>
    </message>
    <message>
        <source>Nothing is doubtful.</source>
        <translation>Nichts ist zweifelhaft.</translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s), see below.</source>
        <translation>
            <numerusform>%n Warnung, siehe unten.</numerusform>
            <numerusform>%n Warnungen, siehe unten.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 lines of telemetry in %2 s and %3 scenes written to %4</source>
        <translation>%1 Telemetriezeilen in %2 s und %3 Szenen in %4 geschrieben</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Abgebrochen; nichts wurde geschrieben.</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>Mapping files (*.toml);;All files (*)</source>
        <translation>Zuordnungsdateien (*.toml);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Mapping of %1</source>
        <translation>Zuordnung aus %1</translation>
    </message>
    <message>
        <source>Session to write</source>
        <translation>Zu schreibende Sitzung</translation>
    </message>
    <message>
        <source>Sessions (*.tts)</source>
        <translation>Sitzungen (*.tts)</translation>
    </message>
    <message>
        <source>Importing …</source>
        <translation>Import läuft …</translation>
    </message>
</context>
<context>
    <name>terratact::ImportWindow</name>
    <message>
        <source>IMPORT — %1 — Terratact</source>
        <translation>IMPORT — %1 — Terratact</translation>
    </message>
    <message>
        <source>IMPORT OF A RECORDING</source>
        <translation>IMPORT EINER AUFZEICHNUNG</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Import</translation>
    </message>
    <message>
        <source>What the recording holds, and its mapping</source>
        <translation>Was die Aufzeichnung enthält, und ihre Zuordnung</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
</context>
<context>
    <name>terratact::MainWindow</name>
    <message>
        <source>model loading …</source>
        <translation>Modell lädt …</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Gelände</translation>
    </message>
    <message>
        <source>Terrain, exploration and arm</source>
        <translation>Das Gelände unter dem Roboter, die Erkundung und der Arm</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>model %1</source>
        <translation>Modell %1</translation>
    </message>
    <message>
        <source>no model</source>
        <translation>kein Modell</translation>
    </message>
    <message>
        <source>STOP, in every window</source>
        <translation>STOP, in jedem Fenster</translation>
    </message>
    <message>
        <source>release STOP</source>
        <translation>STOP lösen</translation>
    </message>
    <message>
        <source>drive forward</source>
        <translation>vorwärtsfahren</translation>
    </message>
    <message>
        <source>drive back</source>
        <translation>zurückfahren</translation>
    </message>
    <message>
        <source>arm the robot: press, then hold; again disarms it</source>
        <translation>Roboter freigeben: drücken, dann halten; noch einmal sperrt ihn</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Exploration</source>
        <translation>Erkundung</translation>
    </message>
    <message>
        <source>explore the terrain</source>
        <translation>Gelände erkunden</translation>
    </message>
    <message>
        <source>approve the proposed probe, or press the button that has the focus</source>
        <translation>vorgeschlagene Sondierung genehmigen, oder den gewählten Knopf drücken</translation>
    </message>
    <message>
        <source>refuse it</source>
        <translation>sie ablehnen</translation>
    </message>
    <message>
        <source>to the next control, to the previous one</source>
        <translation>zum nächsten Element, zum vorigen</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>The same scene as a table</source>
        <translation>Dieselbe Szene als Tabelle</translation>
    </message>
    <message>
        <source>ask for another bin instead: the %1. offered</source>
        <translation>ein anderes Feld verlangen: das %1. angebotene</translation>
    </message>
    <message>
        <source>raise the step limit</source>
        <translation>Stufengrenze anheben</translation>
    </message>
    <message>
        <source>lower it</source>
        <translation>sie senken</translation>
    </message>
    <message>
        <source>show some draws as thin lines</source>
        <translation>einige Ziehungen als dünne Linien</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>Active alarms, and past alarms not yet acknowledged</source>
        <translation>Anstehende Alarme und vergangene, die noch nicht quittiert sind</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Every signal on the bus, and its newest frames</source>
        <translation>Jedes Signal auf dem Bus und die neuesten Rahmen</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnose</translation>
    </message>
    <message>
        <source>Versions, permissions and how fast the console is</source>
        <translation>Versionen, Rechte und wie schnell die Konsole ist</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Method, limits, look, model and robot</source>
        <translation>Methode, Grenzen, Aussehen, Modell und Roboter</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>Train a model, compare it with the one in use, adopt it</source>
        <translation>Modell trainieren, mit dem aktuellen vergleichen, übernehmen</translation>
    </message>
    <message>
        <source>no model: %1</source>
        <translation>kein Modell: %1</translation>
    </message>
    <message>
        <source>An exploration is running: end it with Esc first</source>
        <translation>Eine Erkundung läuft: erst mit Esc beenden</translation>
    </message>
    <message>
        <source>The robot is armed: disarm it first (M)</source>
        <translation>Der Roboter ist freigegeben: erst sperren (M)</translation>
    </message>
    <message>
        <source>explore in spite of a doubtful requirement (override)</source>
        <translation>trotz einer zweifelhaften Voraussetzung erkunden (übergehen)</translation>
    </message>
    <message>
        <source>marked in the recording</source>
        <translation>in der Aufzeichnung markiert</translation>
    </message>
    <message>
        <source>mark this moment in the recording</source>
        <translation>diesen Augenblick in der Aufzeichnung markieren</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Review a session, a log or scenes in a separate window (Ctrl+O)</source>
        <translation>Eine Sitzung, ein Log oder Szenen in einem eigenen Fenster ansehen; dieses läuft weiter (Strg+O)</translation>
    </message>
    <message>
        <source>open a session, a log or scenes in another window</source>
        <translation>eine Sitzung, ein Log oder Szenen in einem anderen Fenster öffnen</translation>
    </message>
    <message>
        <source>Forces, attitude and the last events</source>
        <translation>Kräfte, Lage und die letzten Ereignisse</translation>
    </message>
    <message>
        <source>restarts the console</source>
        <translation>startet die Konsole neu</translation>
    </message>
    <message>
        <source>not marked: nothing is recorded</source>
        <translation>nicht markiert: nichts wird aufgezeichnet</translation>
    </message>
    <message>
        <source>requirements of each command, one after the other</source>
        <translation>was jeder Befehl braucht, einer nach dem anderen</translation>
    </message>
    <message>
        <source>PANEL LOST: connect the operator&apos;s panel</source>
        <translation>PULT VERLOREN: das Bedienpult anschließen</translation>
    </message>
    <message>
        <source>PANEL LOST, STOP is asserted: connect the operator&apos;s panel, then hold R; or start without --panel</source>
        <translation>PULT VERLOREN, das heißt STOP: das Bedienpult anschließen, dann R halten; oder ohne --panel starten</translation>
    </message>
    <message>
        <source>the robot stays: %1</source>
        <translation>der Roboter bleibt: %1</translation>
    </message>
    <message>
        <source>PANEL LOST: connect the operator&apos;s panel, or start without --panel</source>
        <translation>PULT VERLOREN: das Bedienpult anschließen oder ohne --panel starten</translation>
    </message>
    <message>
        <source>THE ROBOT IS ARMED: close the window again within %1 s to halt and disarm it; or disarm it first (M)</source>
        <translation>DER ROBOTER IST FREIGEGEBEN: das Fenster binnen %1 s noch einmal schließen, dann wird er angehalten und gesperrt; oder ihn erst sperren (M)</translation>
    </message>
    <message>
        <source>not driven: %1</source>
        <translation>keine Fahrt: %1</translation>
    </message>
    <message>
        <source>it is done on the page Terrain (F2)</source>
        <translation>gefahren wird auf der Seite Gelände (F2)</translation>
    </message>
    <message>
        <source>ask for a probe: of the selected bin, else of the best one</source>
        <translation>nach einer Sondierung fragen: des gewählten Feldes, sonst des besten</translation>
    </message>
    <message>
        <source>abort the exploration; its result stays</source>
        <translation>die Erkundung abbrechen; ihr Ergebnis bleibt</translation>
    </message>
    <message>
        <source>forget the estimate</source>
        <translation>die Schätzung vergessen</translation>
    </message>
    <message>
        <source>restore the hidden estimate</source>
        <translation>die vergessene Schätzung zurückholen</translation>
    </message>
    <message>
        <source>this window froze for %1 ms: no command could leave</source>
        <translation>dieses Fenster stand %1 ms still: kein Befehl konnte hinaus</translation>
    </message>
    <message>
        <source>no bin is selected: point at a bin first</source>
        <translation>kein Feld ist gewählt: zuerst auf ein Feld zeigen</translation>
    </message>
    <message>
        <source>In a review, these keys move in time and no robot: A, B, F, M, P, K, 1 to 8, Space, Page Up and Down, Up and Down.</source>
        <translation>In einer Rückschau bewegen diese Tasten die Zeit und keinen Roboter: A, B, F, M, P, K, 1 bis 8, Leertaste, Bild auf und ab, Pfeil auf und ab.</translation>
    </message>
    <message>
        <source>feel forward: press, estimate and advance while CLEAR</source>
        <translation>vortasten: andrücken, schätzen und vorrücken, solange FREI</translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>What arrives from the gamepad, and what its controls do</source>
        <translation>Was vom Gamepad ankommt, und was seine Elemente tun</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Any signal over time</source>
        <translation>Jedes Signal über der Zeit</translation>
    </message>
    <message>
        <source>picture written: %1</source>
        <translation>Bild geschrieben: %1</translation>
    </message>
    <message>
        <source>%1 — Terratact</source>
        <translation>%1 — Terratact</translation>
    </message>
    <message>
        <source>profiles, export and import of settings</source>
        <translation>Profile, Export und Import der Einstellungen</translation>
    </message>
    <message>
        <source>The robot is moving: wait until it stands</source>
        <translation>Der Roboter bewegt sich: warten, bis er steht</translation>
    </message>
    <message>
        <source>list the estimates of this run</source>
        <translation>Schätzungen dieses Laufs auflisten</translation>
    </message>
    <message>
        <source>show the present estimate in the picture again</source>
        <translation>wieder die jetzige Schätzung im Bild zeigen</translation>
    </message>
    <message>
        <source>no probe requested: the picture shows an earlier estimate</source>
        <translation>keine Sondierung angefordert: das Bild zeigt eine frühere Schätzung</translation>
    </message>
    <message>
        <source>connect to a bus, the simulated robot, a log or a session</source>
        <translation>mit einem Bus, dem simulierten Roboter, einem Log oder einer Sitzung verbinden</translation>
    </message>
    <message>
        <source>save a snapshot: picture and numbers, with a note</source>
        <translation>Schnappschuss sichern: Bild und Zahlen, mit Notiz</translation>
    </message>
    <message>
        <source>open or close a second window with terrain and verdict, view only</source>
        <translation>zweites Fenster mit Gelände und Urteil öffnen oder schließen, nur Anzeige</translation>
    </message>
    <message>
        <source>Second window, view only (Ctrl+D)</source>
        <translation>Zweites Fenster, nur Anzeige (Strg+D)</translation>
    </message>
    <message>
        <source>Snapshot with a note (C)</source>
        <translation>Schnappschuss mit Notiz (C)</translation>
    </message>
    <message>
        <source>SNAPSHOT NOT SAVED: %1</source>
        <translation>SCHNAPPSCHUSS NICHT GESICHERT: %1</translation>
    </message>
    <message>
        <source>snapshot %1, beside the session</source>
        <translation>Schnappschuss %1, neben der Sitzung</translation>
    </message>
    <message>
        <source>no session records; the snapshot is in %1</source>
        <translation>keine Aufzeichnung läuft; der Schnappschuss liegt in %1</translation>
    </message>
    <message>
        <source>a snapshot is still being written: try again</source>
        <translation>ein Schnappschuss wird noch geschrieben: erneut versuchen</translation>
    </message>
    <message>
        <source>snapshot %1 is being written</source>
        <translation>Schnappschuss %1 wird geschrieben</translation>
    </message>
    <message>
        <source>Export the strip of felt ground …</source>
        <translation>Streifen ertasteten Bodens exportieren …</translation>
    </message>
    <message>
        <source>robot, language and units change at the next start: %1</source>
        <translation>Roboter, Sprache und Einheiten wechseln beim nächsten Start: %1</translation>
    </message>
    <message>
        <source>not armed: %1</source>
        <translation>nicht freigegeben: %1</translation>
    </message>
    <message>
        <source>colours and font change once the robot has stopped</source>
        <translation>Farben und Schrift ändern sich, sobald der Roboter angehalten hat</translation>
    </message>
    <message>
        <source>not explored: %1</source>
        <translation>keine Erkundung: %1</translation>
    </message>
</context>
<context>
    <name>terratact::NavigationRail</name>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
</context>
<context>
    <name>terratact::NumbersPage</name>
    <message>
        <source>The scene as numbers</source>
        <translation>Die Szene in Zahlen</translation>
    </message>
    <message>
        <source>Copy (Ctrl+C)</source>
        <translation>Kopieren (Strg+C)</translation>
    </message>
    <message>
        <source>Copies the whole table, columns separated by tabs</source>
        <translation>Kopiert die ganze Tabelle, Spalten durch Tabulatoren getrennt</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Schätzung</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>last telemetry %1 ago</source>
        <translation>letzte Telemetrie vor %1</translation>
    </message>
    <message>
        <source>copy the numbers, on their page</source>
        <translation>die Zahlen kopieren, auf ihrer Seite</translation>
    </message>
    <message>
        <source>%1, %2 draws, seed %3; heights above the IMU, steps of more than %4. The verdict&apos;s P counts steps over two bins (%5) anywhere ahead, the column those to the next bin alone</source>
        <translation>%1, %2 Ziehungen, Startwert %3; Höhen über der IMU, Stufen über %4. Das P des Urteils zählt Stufen über zwei Felder (%5) irgendwo voraus, die Spalte nur die zum nächsten Feld</translation>
    </message>
</context>
<context>
    <name>terratact::NumbersTable</name>
    <message>
        <source>The scene as numbers</source>
        <translation>Die Szene in Zahlen</translation>
    </message>
    <message>
        <source>bin [%1]</source>
        <translation>Feld [%1]</translation>
    </message>
    <message>
        <source>height [%1]</source>
        <translation>Höhe [%1]</translation>
    </message>
    <message>
        <source>sd [%1]</source>
        <translation>sd [%1]</translation>
    </message>
    <message>
        <source>10 % [%1]</source>
        <translation>10 % [%1]</translation>
    </message>
    <message>
        <source>90 % [%1]</source>
        <translation>90 % [%1]</translation>
    </message>
    <message>
        <source>ceiling [%1]</source>
        <translation>max. [%1]</translation>
    </message>
    <message>
        <source>from</source>
        <translation>woher</translation>
    </message>
    <message>
        <source>step to next</source>
        <translation>Stufe danach</translation>
    </message>
    <message>
        <source>R-hat</source>
        <translation>R-hat</translation>
    </message>
    <message>
        <source>ESS</source>
        <translation>ESS</translation>
    </message>
    <message>
        <source>two heights</source>
        <translation>zwei Höhen</translation>
    </message>
    <message>
        <source>%1 (%2 %) or %3 (%4 %)</source>
        <translation>%1 (%2 %) oder %3 (%4 %)</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>in part</source>
        <translation>teils</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>ertastet</translation>
    </message>
    <message>
        <source>side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>P of a step to the next bin alone. The verdict&apos;s P counts steps over two bins (%1), anywhere ahead</source>
        <translation>P einer Stufe nur zum nächsten Feld. Das P des Urteils zählt Stufen über zwei Felder (%1), irgendwo voraus</translation>
    </message>
</context>
<context>
    <name>terratact::PanelControl</name>
    <message>
        <source>STOP pressed on the panel</source>
        <translation>STOP am Pult gedrückt</translation>
    </message>
    <message>
        <source>the panel is lost: STOP is asserted</source>
        <translation>das Pult ist weg, das heißt STOP</translation>
    </message>
    <message>
        <source>the operator&apos;s panel does not answer</source>
        <translation>das Bedienpult antwortet nicht</translation>
    </message>
    <message>
        <source>STOP is pressed on the panel</source>
        <translation>STOP ist am Pult gedrückt</translation>
    </message>
    <message>
        <source>the operator&apos;s panel answers</source>
        <translation>das Bedienpult antwortet</translation>
    </message>
    <message>
        <source>not approved: the question is not on the screen (Terrain, F2)</source>
        <translation>nicht genehmigt: die Frage ist nicht auf dem Bildschirm (Gelände, F2)</translation>
    </message>
    <message>
        <source>not approved: the panel&apos;s button has to be held for 1.5 s</source>
        <translation>nicht genehmigt: der Knopf am Pult muss 1.5 s gehalten werden</translation>
    </message>
    <message>
        <source>STOP is pressed on the panel: release it there first</source>
        <translation>STOP ist am Pult gedrückt: erst dort lösen</translation>
    </message>
    <message>
        <source>the panel is lost: connect it first, or start the console without --panel</source>
        <translation>das Pult ist verloren: erst anschließen, oder die Konsole ohne --panel starten</translation>
    </message>
    <message>
        <source>not approved: close the window that covers the question</source>
        <translation>nicht genehmigt: das Fenster schließen, das die Frage verdeckt</translation>
    </message>
    <message>
        <source>the panel is lost</source>
        <translation>das Pult ist weg</translation>
    </message>
</context>
<context>
    <name>terratact::PassiveExploration</name>
    <message>
        <source>Following: the front flippers press down</source>
        <translation>Mitverfolgt: die vorderen Flipper drücken an</translation>
    </message>
    <message>
        <source>Estimating …</source>
        <translation>Schätzt …</translation>
    </message>
    <message>
        <source>following: the robot has pressed its flippers down</source>
        <translation>mitverfolgt: der Roboter hat die Flipper angedrückt</translation>
    </message>
    <message>
        <source>following: the arm is probing</source>
        <translation>mitverfolgt: der Arm sondiert</translation>
    </message>
    <message>
        <source>following: the robot is stopped</source>
        <translation>mitverfolgt: der Roboter ist gestoppt</translation>
    </message>
    <message>
        <source>No estimate: the robot is stopped</source>
        <translation>Keine Schätzung: der Roboter ist gestoppt</translation>
    </message>
    <message>
        <source>following: no estimate: %1</source>
        <translation>mitverfolgt: keine Schätzung: %1</translation>
    </message>
    <message>
        <source>No estimate: %1</source>
        <translation>Keine Schätzung: %1</translation>
    </message>
    <message>
        <source>The robot has moved: the next press gives the next estimate</source>
        <translation>Der Roboter hat sich bewegt: das nächste Andrücken bringt die nächste Schätzung</translation>
    </message>
</context>
<context>
    <name>terratact::PictureTools</name>
    <message>
        <source>Terrain picture</source>
        <translation>Geländebild</translation>
    </message>
    <message>
        <source>Copy the picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Copy the numbers</source>
        <translation>Zahlen kopieren</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Exportieren …</translation>
    </message>
    <message>
        <source>Measure height and slope</source>
        <translation>Höhe und Neigung messen</translation>
    </message>
    <message>
        <source>Closer</source>
        <translation>Näher</translation>
    </message>
    <message>
        <source>Farther away</source>
        <translation>Weiter weg</translation>
    </message>
    <message>
        <source>The whole robot</source>
        <translation>Der ganze Roboter</translation>
    </message>
    <message>
        <source>measure height and slope between two points; again ends it</source>
        <translation>Höhe und Neigung zwischen zwei Punkten messen; erneut beendet es</translation>
    </message>
    <message>
        <source>menu of the picture: copy, export, measure, zoom</source>
        <translation>Menü des Bildes: kopieren, exportieren, messen, zoomen</translation>
    </message>
    <message>
        <source>in the picture (Tab): closer, farther away, the whole robot</source>
        <translation>im Bild (Tab): näher, weiter weg, der ganze Roboter</translation>
    </message>
    <message>
        <source>Export the picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg *.pdf)</source>
        <translation>Bilder (*.png *.svg *.pdf)</translation>
    </message>
    <message>
        <source>%1 exists and was not replaced; choose another name</source>
        <translation>%1 gibt es und wurde nicht ersetzt; anderen Namen wählen</translation>
    </message>
</context>
<context>
    <name>terratact::Place</name>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>left at %1</source>
        <translation>links bei %1</translation>
    </message>
    <message>
        <source>right at %1</source>
        <translation>rechts bei %1</translation>
    </message>
</context>
<context>
    <name>terratact::PlotValues</name>
    <message>
        <source>Plot</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Cursor</source>
        <translation>Zeiger</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Min</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>sd</source>
        <translation>sd</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Values in sight</source>
        <translation>Werte im Bild</translation>
    </message>
</context>
<context>
    <name>terratact::PlotsPage</name>
    <message>
        <source>plots below every page, and back</source>
        <translation>Kurven unter jeder Seite, und zurück</translation>
    </message>
</context>
<context>
    <name>terratact::PlotsPanel</name>
    <message>
        <source>State of the plots</source>
        <translation>Zustand der Kurven</translation>
    </message>
    <message>
        <source>Saved set of plots</source>
        <translation>Gespeicherter Satz von Kurven</translation>
    </message>
    <message>
        <source>name of a set</source>
        <translation>Name eines Satzes</translation>
    </message>
    <message>
        <source>Name of a set</source>
        <translation>Name eines Satzes</translation>
    </message>
    <message>
        <source>Save set</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Saves these plots under the name above</source>
        <translation>Speichert diese Kurven unter dem Namen darüber</translation>
    </message>
    <message>
        <source>Delete set</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Deletes the saved set of this name</source>
        <translation>Löscht den gespeicherten Satz dieses Namens</translation>
    </message>
    <message>
        <source>New plot</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Plots the chosen signal in a new row</source>
        <translation>Zeichnet das gewählte Signal in einer neuen Zeile</translation>
    </message>
    <message>
        <source>Add to plot</source>
        <translation>Dazu</translation>
    </message>
    <message>
        <source>Adds the chosen signal to the chosen plot, which has a frame</source>
        <translation>Fügt das gewählte Signal zur gewählten Kurve, die einen Rahmen hat</translation>
    </message>
    <message>
        <source>Remove plot</source>
        <translation>Kurve entfernen</translation>
    </message>
    <message>
        <source>Removes the chosen plot</source>
        <translation>Entfernt die gewählte Kurve</translation>
    </message>
    <message>
        <source>Closer</source>
        <translation>Näher</translation>
    </message>
    <message>
        <source>Shows a shorter time; also the wheel, or a box drawn with the mouse</source>
        <translation>Zeigt eine kürzere Zeit; auch mit dem Rad oder einem Kasten, mit der Maus gezogen</translation>
    </message>
    <message>
        <source>Wider</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Shows a longer time</source>
        <translation>Zeigt eine längere Zeit</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Früher</translation>
    </message>
    <message>
        <source>Moves to earlier times; also a drag with the right button, or the wheel with Shift</source>
        <translation>Geht zu früheren Zeiten; auch mit der rechten Taste gezogen oder mit dem Rad und Umschalt</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
    <message>
        <source>Moves to later times</source>
        <translation>Geht zu späteren Zeiten</translation>
    </message>
    <message>
        <source>Cursor earlier</source>
        <translation>Zeiger früher</translation>
    </message>
    <message>
        <source>Moves the cursor by a hundredth of the time in sight</source>
        <translation>Bewegt den Zeiger um ein Hundertstel der Zeit im Bild</translation>
    </message>
    <message>
        <source>Cursor later</source>
        <translation>Zeiger später</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Shows everything</source>
        <translation>Zeigt alles</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Follows the newest values</source>
        <translation>Folgt den neuesten Werten</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassen</translation>
    </message>
    <message>
        <source>Fits the scales to the values in sight</source>
        <translation>Passt die Skalen den Werten im Bild an</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>Shows the values at the cursor and the statistics of the time in sight</source>
        <translation>Zeigt die Werte am Zeiger und die Statistik der Zeit im Bild</translation>
    </message>
    <message>
        <source>Dock</source>
        <translation>Leiste</translation>
    </message>
    <message>
        <source>Keeps the plots below every page, where the window is high enough</source>
        <translation>Behält die Kurven unter jeder Seite, wenn das Fenster hoch genug ist</translation>
    </message>
    <message>
        <source>No room: at most %1 plots, %2 signals in each, %3 in all</source>
        <translation>Kein Platz: höchstens %1 Kurven, in jeder %2 Signale, zusammen %3</translation>
    </message>
    <message>
        <source>the session is read: %1 %</source>
        <translation>die Sitzung wird gelesen: %1 %</translation>
    </message>
    <message>
        <source>Enter a name for the set first</source>
        <translation>Zuerst einen Namen für den Satz eingeben</translation>
    </message>
    <message>
        <source>There is no plot to save</source>
        <translation>Es gibt keine Kurve zum Speichern</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gespeichert: %1</translation>
    </message>
    <message>
        <source>Deleted: %1</source>
        <translation>Gelöscht: %1</translation>
    </message>
</context>
<context>
    <name>terratact::PreconditionGrid</name>
    <message>
        <source>met</source>
        <translation>erfüllt</translation>
    </message>
    <message>
        <source>overridden</source>
        <translation>übergangen</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>zweifelhaft</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>%1 (overridden)</source>
        <translation>%1 (übergangen)</translation>
    </message>
</context>
<context>
    <name>terratact::ProbeCard</name>
    <message>
        <source>Arm probe</source>
        <translation>Armsonde</translation>
    </message>
    <message>
        <source>where</source>
        <translation>wo</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>erwartet</translation>
    </message>
    <message>
        <source>80 % band</source>
        <translation>80-%-Band</translation>
    </message>
    <message>
        <source>costs</source>
        <translation>kostet</translation>
    </message>
    <message>
        <source>Hold the mouse button or Space for 1.5 s; releasing early has no effect</source>
        <translation>Maustaste oder Leertaste 1.5 s halten; früheres Loslassen bewirkt nichts</translation>
    </message>
    <message>
        <source>Progress of the probe</source>
        <translation>Fortschritt der Sondierung</translation>
    </message>
    <message>
        <source>%1 ± %2 (sd)</source>
        <translation>%1 ± %2 (sd)</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>this bin to ± %1</source>
        <translation>dieses Feld auf ± %1</translation>
    </message>
    <message>
        <source>≈ %1 s, arm out in smoke</source>
        <translation>≈ %1 s, Arm im Rauch</translation>
    </message>
    <message>
        <source>%1 left, then refused</source>
        <translation>noch %1, dann nein</translation>
    </message>
    <message>
        <source>%1 of about %2</source>
        <translation>%1 von etwa %2</translation>
    </message>
    <message>
        <source>all bins</source>
        <translation>alle Felder</translation>
    </message>
    <message>
        <source>step ahead</source>
        <translation>Stufe voraus</translation>
    </message>
    <message>
        <source>Do not probe: 0 s, the estimate stays (N)</source>
        <translation>Nicht sondieren: 0 s, Schätzung bleibt (N)</translation>
    </message>
    <message>
        <source>Refuses the probe; the estimate stays as it is</source>
        <translation>Lehnt die Sondierung ab; die Schätzung bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>step &gt; %1</source>
        <translation>Stufe &gt; %1</translation>
    </message>
    <message>
        <source>total variance %1 %</source>
        <translation>Gesamtvarianz %1 %</translation>
    </message>
    <message>
        <source>not known for this method</source>
        <translation>bei dieser Methode unbekannt</translation>
    </message>
    <message>
        <source>%1: %2, %3 %</source>
        <translation>%1: %2, %3 %</translation>
    </message>
    <message>
        <source>Expected gain of the probe</source>
        <translation>Erwarteter Gewinn der Sondierung</translation>
    </message>
    <message>
        <source>Do not probe (N)</source>
        <translation>Nicht sondieren (N)</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>Need for a probe</source>
        <translation>Ob eine Sondierung nötig ist</translation>
    </message>
    <message>
        <source>80 % in %1 … %2</source>
        <translation>80 % in %1 … %2</translation>
    </message>
    <message>
        <source>%1 for %2 s</source>
        <translation>%1 für %2 s</translation>
    </message>
    <message>
        <source>step: not known for this method</source>
        <translation>Stufe: bei dieser Methode unbekannt</translation>
    </message>
    <message>
        <source>%1 bit, no gain</source>
        <translation>%1 bit, kein Gewinn</translation>
    </message>
    <message>
        <source>step: %1 bit, no gain</source>
        <translation>Stufe: %1 bit, kein Gewinn</translation>
    </message>
    <message>
        <source>Already %1; no gain</source>
        <translation>%1 steht: kein Gewinn</translation>
    </message>
    <message>
        <source>step: %1 → %2 bit, %3/min</source>
        <translation>Stufe: %1 → %2 bit, %3/min</translation>
    </message>
    <message>
        <source>Already %1; a probe makes it more certain.</source>
        <translation>%1 steht: eine Sonde macht es sicherer.</translation>
    </message>
    <message>
        <source>Do not probe: 0 s, keep %1 (N)</source>
        <translation>Nicht sondieren: 0 s, %1 bleibt (N)</translation>
    </message>
    <message>
        <source>Already %1; a probe only refines the profile.</source>
        <translation>%1 steht: nur das Profil gewänne.</translation>
    </message>
    <message>
        <source>%1 → %2 bit: %3/min</source>
        <translation>%1 → %2 bit: %3/min</translation>
    </message>
    <message>
        <source>The other bins, the best first</source>
        <translation>Die anderen Felder, das beste zuerst</translation>
    </message>
    <message>
        <source>Cannot be approved: %1</source>
        <translation>Kann nicht genehmigt werden: %1</translation>
    </message>
    <message>
        <source>void</source>
        <translation>ungültig</translation>
    </message>
    <message>
        <source>%1: %2 ± %3</source>
        <translation>%1: %2 ± %3</translation>
    </message>
    <message>
        <source>Ask for %1 instead: total variance %2 %, step ahead to %3 bit</source>
        <translation>Stattdessen %1: Gesamtvarianz %2 %, Stufe voraus auf %3 bit</translation>
    </message>
    <message>
        <source>or %1: %2 %, %3 bit</source>
        <translation>oder %1: %2 %, %3 bit</translation>
    </message>
    <message>
        <source>approval void: probe %1</source>
        <translation>Genehmigung ungültig: Sondierung %1</translation>
    </message>
    <message>
        <source>hold to approve probe %1 (Space)</source>
        <translation>halten: Sondierung %1 (Leertaste)</translation>
    </message>
    <message>
        <source>The probe of %1 cannot be approved</source>
        <translation>Die Sondierung kann nicht genehmigt werden: %1</translation>
    </message>
    <message>
        <source>Hold to approve the probe of %1</source>
        <translation>Halten, um die Sondierung zu genehmigen: %1</translation>
    </message>
    <message>
        <source>The arm is probing %1</source>
        <translation>Der Arm sondiert: %1</translation>
    </message>
    <message>
        <source>no probe is proposed</source>
        <translation>keine Sonde vorgeschlagen</translation>
    </message>
</context>
<context>
    <name>terratact::ProfileMenu</name>
    <message>
        <source>Some of the draws as thin lines (D)</source>
        <translation>Einige Ziehungen als dünne Linien (D)</translation>
    </message>
    <message>
        <source>A second method beside it</source>
        <translation>Eine zweite Methode daneben</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Estimates of this run … (Ctrl+H)</source>
        <translation>Schätzungen dieses Laufs … (Strg+H)</translation>
    </message>
    <message>
        <source>Restore the hidden estimate (Ctrl+Z)</source>
        <translation>Ausgeblendete Schätzung zurückholen (Strg+Z)</translation>
    </message>
</context>
<context>
    <name>terratact::Provenance</name>
    <message>
        <source>arm</source>
        <translation>Arm</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>constrained</source>
        <translation>eingeschränkt</translation>
    </message>
    <message>
        <source>sampled</source>
        <translation>geschätzt</translation>
    </message>
    <message>
        <source>prior only</source>
        <translation>nur Vorwissen</translation>
    </message>
    <message>
        <source>A</source>
        <comment>letter of a mark</comment>
        <translation>A</translation>
    </message>
    <message>
        <source>C</source>
        <comment>letter of a mark</comment>
        <translation>K</translation>
    </message>
    <message>
        <source>E</source>
        <comment>letter of a mark</comment>
        <translation>E</translation>
    </message>
    <message>
        <source>S</source>
        <comment>letter of a mark</comment>
        <translation>G</translation>
    </message>
    <message>
        <source>P</source>
        <comment>letter of a mark</comment>
        <translation>V</translation>
    </message>
</context>
<context>
    <name>terratact::RawTrace</name>
    <message>
        <source>after a gap</source>
        <translation>nach einer Lücke</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>falsche Prüfsumme</translation>
    </message>
    <message>
        <source>repeated or out of sequence</source>
        <translation>wiederholt oder außer der Reihe</translation>
    </message>
    <message>
        <source>not usable</source>
        <translation>unbrauchbar</translation>
    </message>
    <message>
        <source>not in the DBC</source>
        <translation>nicht in der DBC</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>%1 (from here)</source>
        <translation>%1 (von hier)</translation>
    </message>
    <message>
        <source>id (hexadecimal) or a part of the name</source>
        <translation>Id (hexadezimal) oder Teil des Namens</translation>
    </message>
    <message>
        <source>Filter of the frames</source>
        <translation>Filter der Rahmen</translation>
    </message>
    <message>
        <source>Pause display</source>
        <translation>Bild anhalten</translation>
    </message>
    <message>
        <source>Display paused; recording and counting continue</source>
        <translation>Die Liste steht; alles wird dennoch empfangen und gezählt</translation>
    </message>
    <message>
        <source>Newest frames</source>
        <translation>Neueste Rahmen</translation>
    </message>
    <message>
        <source>Paused: continue</source>
        <translation>Angehalten: weiter</translation>
    </message>
    <message>
        <source>%1 of the newest %2 frames</source>
        <translation>%1 der neuesten %2 Rahmen</translation>
    </message>
</context>
<context>
    <name>terratact::RearView</name>
    <message>
        <source>%1 L up</source>
        <translation>%1, L höher</translation>
    </message>
    <message>
        <source>%1 R up</source>
        <translation>%1, R höher</translation>
    </message>
    <message>
        <source>roll %1</source>
        <translation>Rollen %1</translation>
    </message>
    <message>
        <source>From behind: %1; front flippers L %2, R %3</source>
        <translation>Von hinten: %1; Flipper vorn L %2, R %3</translation>
    </message>
    <message>
        <source>View from behind</source>
        <translation>Ansicht von hinten</translation>
    </message>
    <message>
        <source>From behind: not known</source>
        <translation>Von hinten: nicht bekannt</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>cross %1</source>
        <translation>quer %1</translation>
    </message>
    <message>
        <source>cross slope %1</source>
        <translation>Quergefälle %1</translation>
    </message>
</context>
<context>
    <name>terratact::RemoteStop</name>
    <message>
        <source>STOP SENT to the console that opened this window …</source>
        <translation>STOP GESENDET an die Konsole, die dieses Fenster geöffnet hat …</translation>
    </message>
    <message>
        <source>STOP HAS NO EFFECT HERE: the console that opened this window is gone</source>
        <translation>STOP WIRKT HIER NICHT: die Konsole, die dieses Fenster geöffnet hat, läuft nicht mehr</translation>
    </message>
    <message>
        <source>STOP NOT SENT: the console&apos;s stop line was not found at %1; press STOP in the console, or use the robot&apos;s own switch</source>
        <translation>STOP NICHT GESENDET: unter %1 fehlt die Verbindung zur Konsole; STOP in der Konsole drücken oder den Schalter am Roboter benutzen</translation>
    </message>
    <message>
        <source>STOP NOT SENT: %1</source>
        <translation>STOP NICHT GESENDET: %1</translation>
    </message>
    <message>
        <source>STOP: the console that opened this window has received it; look there whether the robot confirms it</source>
        <translation>STOP: die Konsole, die dieses Fenster geöffnet hat, hat es übernommen; dort steht, ob der Roboter es bestätigt</translation>
    </message>
    <message>
        <source>STOP NOT RECEIVED: the console that opened this window does not answer; use the robot&apos;s own switch</source>
        <translation>STOP NICHT ÜBERNOMMEN: die Konsole, die dieses Fenster geöffnet hat, antwortet nicht; den Schalter am Roboter benutzen</translation>
    </message>
</context>
<context>
    <name>terratact::ReplayBar</name>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>◀ %1 s</source>
        <translation>◀ %1 s</translation>
    </message>
    <message>
        <source>Steps back in the log (Ctrl+Left)</source>
        <translation>Geht im Log zurück (Strg+Links)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Pauses or continues the log (Ctrl+Space)</source>
        <translation>Hält das Log an, oder lässt es weiterlaufen (Strg+Leertaste)</translation>
    </message>
    <message>
        <source>%1 s ▶</source>
        <translation>%1 s ▶</translation>
    </message>
    <message>
        <source>Steps forward in the log (Ctrl+Right)</source>
        <translation>Geht im Log weiter (Strg+Rechts)</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Repeats the log from its end (Ctrl+R)</source>
        <translation>Beginnt am Ende des Logs von vorn (Strg+R)</translation>
    </message>
    <message>
        <source>How far the log is</source>
        <translation>Wie weit das Log ist</translation>
    </message>
    <message>
        <source>pause or continue the log</source>
        <translation>das Log anhalten, oder weiterlaufen lassen</translation>
    </message>
    <message>
        <source>back in the log</source>
        <translation>zurück im Log</translation>
    </message>
    <message>
        <source>forward in the log</source>
        <translation>weiter im Log</translation>
    </message>
    <message>
        <source>repeat the log, on or off</source>
        <translation>am Ende des Logs von vorn beginnen, oder nicht</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 von %2 s</translation>
    </message>
    <message>
        <source>paused at %1</source>
        <translation>angehalten bei %1</translation>
    </message>
</context>
<context>
    <name>terratact::ReviewEventsPage</name>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>what</source>
        <translation>was</translation>
    </message>
    <message>
        <source>on the screen</source>
        <translation>auf dem Bildschirm</translation>
    </message>
    <message>
        <source>Events of the session</source>
        <translation>Ereignisse der Sitzung</translation>
    </message>
    <message>
        <source>Active alarms</source>
        <translation>Anstehende Alarme</translation>
    </message>
    <message>
        <source>Kind of the events</source>
        <translation>Art der Ereignisse</translation>
    </message>
    <message>
        <source>Which events are listed</source>
        <translation>Welche Ereignisse aufgelistet werden</translation>
    </message>
    <message>
        <source>all kinds</source>
        <translation>alle Arten</translation>
    </message>
    <message>
        <source>Enter or a double click goes to that time</source>
        <translation>Enter oder ein Doppelklick geht dorthin</translation>
    </message>
    <message>
        <source>No alarm was active at this time.</source>
        <translation>Zu dieser Zeit stand kein Alarm an.</translation>
    </message>
    <message>
        <source>Alarms at this time: %1</source>
        <translation>Alarme zu dieser Zeit: %1</translation>
    </message>
</context>
<context>
    <name>terratact::ReviewExportDialog</name>
    <message>
        <source>.log, candump</source>
        <translation>.log, candump</translation>
    </message>
    <message>
        <source>.asc, Vector</source>
        <translation>.asc, Vector</translation>
    </message>
    <message>
        <source>.mcap, Foxglove</source>
        <translation>.mcap, Foxglove</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Export — %1</source>
        <translation>Export — %1</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Fortschritt des Exports</translation>
    </message>
    <message>
        <source>Result of the export</source>
        <translation>Ergebnis des Exports</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Part of the session to export</source>
        <translation>Zu exportierender Teil der Sitzung</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Which programs can read it</source>
        <translation>Welche Programme sie lesen können</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Umfang</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>From A to B, else the visible part of the timeline: zoom with Z and X</source>
        <translation>Von A bis B, sonst was die Zeitleiste zeigt: Z und X zoomen</translation>
    </message>
    <message>
        <source>Where it is written</source>
        <translation>Wohin geschrieben wird</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Die Datei wählen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbruch</translation>
    </message>
    <message>
        <source>Cancels the export and leaves no file (Esc)</source>
        <translation>Beendet den Export und hinterlässt keine Datei (Esc)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>from A to B, %1</source>
        <translation>von A bis B, %1</translation>
    </message>
    <message>
        <source>what is visible: all, %1</source>
        <translation>das Sichtbare: alles, %1</translation>
    </message>
    <message>
        <source>what is visible, %1</source>
        <translation>das Sichtbare, %1</translation>
    </message>
    <message>
        <source>everything, %1</source>
        <translation>alles, %1</translation>
    </message>
    <message>
        <source>this time, %1</source>
        <translation>diese Zeit, %1</translation>
    </message>
    <message>
        <source>scene %1</source>
        <translation>Szene %1</translation>
    </message>
    <message>
        <source>there is no estimate at this time</source>
        <translation>zu dieser Zeit gibt es keine Schätzung</translation>
    </message>
    <message>
        <source>Replace the file</source>
        <translation>Datei ersetzen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>Exportieren nach</translation>
    </message>
    <message>
        <source>Cancelled: no file was written</source>
        <translation>Abgebrochen: keine Datei geschrieben</translation>
    </message>
    <message>
        <source>NOT WRITTEN: %1</source>
        <translation>NICHT GESCHRIEBEN: %1</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>frames left out because the format cannot hold them: %1</source>
        <translation>ausgelassene Rahmen, die das Format nicht fasst: %1</translation>
    </message>
    <message>
        <source>damaged and left out, places: %1</source>
        <translation>beschädigt und ausgelassen, Stellen: %1</translation>
    </message>
    <message>
        <source>A file is being written</source>
        <translation>Eine Datei wird geschrieben</translation>
    </message>
    <message>
        <source>There is no estimate at this time</source>
        <translation>Zu dieser Zeit gibt es keine Schätzung</translation>
    </message>
    <message>
        <source>Name the file first</source>
        <translation>Erst die Datei benennen</translation>
    </message>
    <message>
        <source>Writes the file</source>
        <translation>Schreibt die Datei</translation>
    </message>
    <message>
        <source>The whole session</source>
        <translation>Die ganze Sitzung</translation>
    </message>
    <message>
        <source>Nothing is being written</source>
        <translation>Es wird nichts geschrieben</translation>
    </message>
    <message>
        <source>Other devices</source>
        <translation>Andere Geräte</translation>
    </message>
    <message>
        <source>with the signals of %1</source>
        <translation>mit den Signalen aus %1</translation>
    </message>
    <message>
        <source>no DBC file describes them</source>
        <translation>keine DBC-Datei beschreibt sie</translation>
    </message>
    <message>
        <source>The page Signals (F7) adds DBC files</source>
        <translation>Die Seite Signale (F7) fügt DBC-Dateien hinzu</translation>
    </message>
    <message>
        <source>Only the kind Signals holds the values of DBC files</source>
        <translation>Nur Signale enthalten, was DBC-Dateien beschreiben</translation>
    </message>
    <message>
        <source>messages of DBC files left out for lack of room: %1</source>
        <translation>ausgelassene Nachrichten aus DBC-Dateien, für die kein Platz war: %1</translation>
    </message>
    <message>
        <source>the whole session, %1</source>
        <translation>die ganze Sitzung, %1</translation>
    </message>
</context>
<context>
    <name>terratact::ReviewNoteField</name>
    <message>
        <source>note (M)</source>
        <translation>Notiz (M)</translation>
    </message>
    <message>
        <source>Note at this time</source>
        <translation>Notiz zu dieser Zeit</translation>
    </message>
    <message>
        <source>Kept beside the session, in %1; Enter saves it</source>
        <translation>Steht neben der Sitzung, in %1; Enter speichert sie</translation>
    </message>
    <message>
        <source>NOTE NOT SAVED: %1</source>
        <translation>NOTIZ NICHT GESPEICHERT: %1</translation>
    </message>
</context>
<context>
    <name>terratact::ReviewPlayerBar</name>
    <message>
        <source>From A to B</source>
        <translation>Von A bis B</translation>
    </message>
    <message>
        <source>To the beginning</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>To the beginning (Home)</source>
        <translation>Zum Anfang (Pos1)</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>Rahmen zurück</translation>
    </message>
    <message>
        <source>Previous frame (,)</source>
        <translation>Einen Rahmen zurück (,)</translation>
    </message>
    <message>
        <source>Play backwards</source>
        <translation>Rückwärts abspielen</translation>
    </message>
    <message>
        <source>Play backwards (J)</source>
        <translation>Rückwärts abspielen (J)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play, pause (Space)</source>
        <translation>Abspielen, anhalten (Leertaste)</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Rahmen vor</translation>
    </message>
    <message>
        <source>Next frame (.)</source>
        <translation>Einen Rahmen vor (.)</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Zum Ende</translation>
    </message>
    <message>
        <source>To the end (End)</source>
        <translation>Zum Ende (Ende)</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Langsamer</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Schneller</translation>
    </message>
    <message>
        <source>Twice as fast (F)</source>
        <translation>Doppelt so schnell (F)</translation>
    </message>
    <message>
        <source>Cursor A here</source>
        <translation>Marke A hierher</translation>
    </message>
    <message>
        <source>Cursor A here (A); again removes it</source>
        <translation>Marke A hierher (A); noch einmal entfernt sie</translation>
    </message>
    <message>
        <source>Cursor B here</source>
        <translation>Marke B hierher</translation>
    </message>
    <message>
        <source>Cursor B here (B); again removes it</source>
        <translation>Marke B hierher (B); noch einmal entfernt sie</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Loop between A and B</source>
        <translation>Schleife zwischen A und B</translation>
    </message>
    <message>
        <source>Play from A to B again and again (P)</source>
        <translation>Von A bis B immer wieder abspielen (P)</translation>
    </message>
    <message>
        <source>follow</source>
        <translation>folgen</translation>
    </message>
    <message>
        <source>Follow the end</source>
        <translation>Dem Ende folgen</translation>
    </message>
    <message>
        <source>Stay at the end of a session that is still recorded (T)</source>
        <translation>Am Ende einer Sitzung bleiben, die noch aufgezeichnet wird (T)</translation>
    </message>
    <message>
        <source>Time in the session</source>
        <translation>Zeit in der Sitzung</translation>
    </message>
    <message>
        <source>Go to a time (G): seconds, or hours:minutes:seconds</source>
        <translation>Zu einer Zeit gehen (G): Sekunden, oder Stunden:Minuten:Sekunden</translation>
    </message>
    <message>
        <source>of %1 · %2%3</source>
        <translation>von %1 · %2%3</translation>
    </message>
    <message>
        <source>END</source>
        <translation>ENDE</translation>
    </message>
    <message>
        <source>BEGIN</source>
        <translation>ANFANG</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>The session is closed: it does not grow any more</source>
        <translation>Die Sitzung ist geschlossen: es kommt nichts mehr</translation>
    </message>
    <message>
        <source>play, pause</source>
        <translation>abspielen, anhalten</translation>
    </message>
    <message>
        <source>play backwards</source>
        <translation>rückwärts abspielen</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>anhalten</translation>
    </message>
    <message>
        <source>play</source>
        <translation>abspielen</translation>
    </message>
    <message>
        <source>twice as fast</source>
        <translation>doppelt so schnell</translation>
    </message>
    <message>
        <source>half as fast</source>
        <translation>halb so schnell</translation>
    </message>
    <message>
        <source>cursor A here; again removes it</source>
        <translation>Marke A hierher; noch einmal entfernt sie</translation>
    </message>
    <message>
        <source>cursor B here; again removes it</source>
        <translation>Marke B hierher; noch einmal entfernt sie</translation>
    </message>
    <message>
        <source>loop from A to B</source>
        <translation>Schleife von A bis B</translation>
    </message>
    <message>
        <source>follow a session that is still recorded</source>
        <translation>einer Sitzung folgen, die noch aufgezeichnet wird</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Gehen</translation>
    </message>
    <message>
        <source>previous frame</source>
        <translation>einen Rahmen zurück</translation>
    </message>
    <message>
        <source>next frame</source>
        <translation>einen Rahmen vor</translation>
    </message>
    <message>
        <source>a second back</source>
        <translation>eine Sekunde zurück</translation>
    </message>
    <message>
        <source>a second on</source>
        <translation>eine Sekunde vor</translation>
    </message>
    <message>
        <source>to the next event</source>
        <translation>zum nächsten Ereignis</translation>
    </message>
    <message>
        <source>to the next: %1 (with Alt: previous)</source>
        <translation>zum nächsten: %1 (mit Alt: davor)</translation>
    </message>
    <message>
        <source>to the beginning</source>
        <translation>zum Anfang</translation>
    </message>
    <message>
        <source>to the end</source>
        <translation>zum Ende</translation>
    </message>
    <message>
        <source>to a time</source>
        <translation>zu einer Zeit</translation>
    </message>
    <message>
        <source>Half as fast (H)</source>
        <translation>Halb so schnell (H)</translation>
    </message>
    <message>
        <source>to the previous scene, with its estimate</source>
        <translation>zur Szene davor, mit ihrer Schätzung</translation>
    </message>
    <message>
        <source>to the next scene, with its estimate</source>
        <translation>zur nächsten Szene, mit ihrer Schätzung</translation>
    </message>
    <message>
        <source>to the previous event</source>
        <translation>zum vorigen Ereignis</translation>
    </message>
</context>
<context>
    <name>terratact::ReviewSignalsPage</name>
    <message>
        <source>Signals of other devices</source>
        <translation>Signale anderer Geräte</translation>
    </message>
    <message>
        <source>Which signals these are</source>
        <translation>Welche Signale dies sind</translation>
    </message>
    <message>
        <source>No other device had sent a frame in the %1 s before this time</source>
        <translation>Kein anderes Gerät hatte in den %1 s vor dieser Zeit einen Rahmen gesendet</translation>
    </message>
    <message>
        <source>The newest values of the %1 s before this time; minimum and maximum are of those seconds</source>
        <translation>Die neuesten Werte der %1 s vor dieser Zeit; kleinste und größte stammen aus diesen Sekunden</translation>
    </message>
</context>
<context>
    <name>terratact::ReviewWindow</name>
    <message>
        <source>REVIEW — %1 — Terratact</source>
        <translation>RÜCKSCHAU — %1 — Terratact</translation>
    </message>
    <message>
        <source>REVIEW · %1</source>
        <translation>RÜCKSCHAU · %1</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Gelände</translation>
    </message>
    <message>
        <source>What the operator saw at this time</source>
        <translation>Was der Bediener zu dieser Zeit sah</translation>
    </message>
    <message>
        <source>No estimate at this time</source>
        <translation>Zu dieser Zeit galt keine Schätzung</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Zahlen</translation>
    </message>
    <message>
        <source>The scene of this time as a table</source>
        <translation>Die Szene dieser Zeit als Tabelle</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>All events of the session</source>
        <translation>Alle Ereignisse der Sitzung</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Forces, attitude and the last events</source>
        <translation>Kräfte, Lage und die letzten Ereignisse</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>Was wäre</translation>
    </message>
    <message>
        <source>Estimate the recorded scene with other settings</source>
        <translation>Die aufgezeichnete Szene mit anderen Einstellungen schätzen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open a file in another window (Ctrl+O)</source>
        <translation>Eine Datei in einem anderen Fenster öffnen (Strg+O)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>recorded %1</source>
        <translation>aufgezeichnet %1</translation>
    </message>
    <message>
        <source>closed and sealed</source>
        <translation>geschlossen und versiegelt</translation>
    </message>
    <message>
        <source>BEING RECORDED</source>
        <translation>WIRD AUFGEZEICHNET</translation>
    </message>
    <message>
        <source>NOT SEALED: the recording program did not close it</source>
        <translation>NICHT VERSIEGELT: ihr Programm hat sie nicht geschlossen</translation>
    </message>
    <message>
        <source>DAMAGED, places: %1</source>
        <translation>BESCHÄDIGT, Stellen: %1</translation>
    </message>
    <message>
        <source>frames are looked through …</source>
        <translation>Rahmen werden durchgesehen …</translation>
    </message>
    <message>
        <source>no command can be sent</source>
        <translation>kein Befehl kann gesendet werden</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>estimate the recorded scene again on the page What if</source>
        <translation>die aufgezeichnete Szene noch einmal schätzen, auf der Seite Was wäre</translation>
    </message>
    <message>
        <source>a note at this time</source>
        <translation>eine Notiz zu dieser Zeit</translation>
    </message>
    <message>
        <source>open another file</source>
        <translation>eine andere Datei öffnen</translation>
    </message>
    <message>
        <source>timeline closer</source>
        <translation>Zeitleiste näher</translation>
    </message>
    <message>
        <source>timeline wider</source>
        <translation>Zeitleiste weiter</translation>
    </message>
    <message>
        <source>all of the timeline</source>
        <translation>die ganze Zeitleiste</translation>
    </message>
    <message>
        <source>show some draws as thin lines</source>
        <translation>einige Ziehungen als dünne Linien</translation>
    </message>
    <message>
        <source>back from a field to the keys</source>
        <translation>aus einem Feld zurück zu den Tasten</translation>
    </message>
    <message>
        <source>to the next control, to the previous one</source>
        <translation>zum nächsten Element, zum vorigen</translation>
    </message>
    <message>
        <source>Exports the visible part or the whole session to a file (Ctrl+E)</source>
        <translation>Exportiert den sichtbaren Teil oder die ganze Sitzung in eine Datei (Strg+E)</translation>
    </message>
    <message>
        <source>export to a file</source>
        <translation>in eine Datei exportieren</translation>
    </message>
    <message>
        <source>at the next start</source>
        <translation>ab dem nächsten Start</translation>
    </message>
    <message>
        <source>In the console the same keys send commands. A explores, B asks for a probe, F feels forward and drives, M arms, Space approves a probe. Up and Down drive, Page Up and Down change the limit. P shows what a command needs, K marks, 1 to 3 ask for another bin.</source>
        <translation>In der Konsole senden dieselben Tasten Befehle. A erkundet, B fragt nach einer Sondierung, F tastet sich vor und fährt, M gibt frei, Leertaste genehmigt eine Sondierung. Pfeil auf und ab fahren, Bild auf und ab ändern die Grenze. P zeigt, was ein Befehl braucht, K markiert, 1 bis 3 fragen nach einem anderen Feld.</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>What other devices had sent: gas sensors, batteries</source>
        <translation>Was andere Geräte gesendet hatten: Gassensoren, Batterien</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Any signal over the session</source>
        <translation>Jedes Signal über die Sitzung</translation>
    </message>
</context>
<context>
    <name>terratact::RobotReadout</name>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>front flippers</source>
        <translation>Flipper vorn</translation>
    </message>
    <message>
        <source>rear flippers</source>
        <translation>Flipper hinten</translation>
    </message>
    <message>
        <source>front currents</source>
        <translation>Ströme vorn</translation>
    </message>
    <message>
        <source>rear currents</source>
        <translation>Ströme hinten</translation>
    </message>
    <message>
        <source>L %1   R %2</source>
        <translation>L %1   R %2</translation>
    </message>
    <message>
        <source>%1   captured %2</source>
        <translation>%1   erfasst %2</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>%1 alt</translation>
    </message>
    <message>
        <source>; beside it the value of the captured scene, at which the robot is drawn</source>
        <translation>; daneben die der erfassten Szene: gezeichnet ist der Roboter, wie er damals stand</translation>
    </message>
    <message>
        <source>%1 DANGER</source>
        <translation>%1 GEFAHR</translation>
    </message>
    <message>
        <source>%1 STEEP</source>
        <translation>%1 STEIL</translation>
    </message>
</context>
<context>
    <name>terratact::SceneRows</name>
    <message>
        <source>scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>Fahrt</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>truth</source>
        <translation>Wahrheit</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>error, median</source>
        <translation>Fehler, Median</translation>
    </message>
    <message>
        <source>error, mean</source>
        <translation>Fehler, Mittel</translation>
    </message>
    <message>
        <source>%1 bins</source>
        <translation>%1 Felder</translation>
    </message>
</context>
<context>
    <name>terratact::ScenesPage</name>
    <message>
        <source>Scenes of the file</source>
        <translation>Szenen der Datei</translation>
    </message>
    <message>
        <source>Summary of the scenes</source>
        <translation>Zusammenfassung der Szenen</translation>
    </message>
    <message>
        <source>Enter or a double click shows the scene; typing a number goes to it</source>
        <translation>Enter oder ein Doppelklick zeigt die Szene; eine getippte Nummer springt zu ihr</translation>
    </message>
    <message>
        <source>%1 CLEAR, %2 BLOCKED, %3 CANNOT TELL</source>
        <translation>%1 FREI, %2 VERSPERRT, %3 UNKLAR</translation>
    </message>
    <message>
        <source>%1 of %2 scenes estimated now · %3 · %4</source>
        <translation>%1 von %2 Szenen jetzt geschätzt · %3 · %4</translation>
    </message>
    <message>
        <source>no truth is known</source>
        <translation>keine Wahrheit ist bekannt</translation>
    </message>
    <message>
        <source>median error of the median scene: %1</source>
        <translation>Median des Fehlers der mittleren Szene: %1</translation>
    </message>
</context>
<context>
    <name>terratact::ScenesWindow</name>
    <message>
        <source>SCENES — %1 — Terratact</source>
        <translation>SZENEN — %1 — Terratact</translation>
    </message>
    <message>
        <source>SCENES OF A FILE</source>
        <translation>SZENEN EINER DATEI</translation>
    </message>
    <message>
        <source>model loading …</source>
        <translation>Modell lädt …</translation>
    </message>
    <message>
        <source>model %1</source>
        <translation>Modell %1</translation>
    </message>
    <message>
        <source>no model</source>
        <translation>kein Modell</translation>
    </message>
    <message>
        <source>Estimating …</source>
        <translation>Schätzt …</translation>
    </message>
    <message>
        <source>A scene of a file commands no robot</source>
        <translation>Eine Szene einer Datei befiehlt keinem Roboter</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>next scene</source>
        <translation>nächste Szene</translation>
    </message>
    <message>
        <source>previous scene</source>
        <translation>Szene davor</translation>
    </message>
    <message>
        <source>first scene</source>
        <translation>erste Szene</translation>
    </message>
    <message>
        <source>last scene</source>
        <translation>letzte Szene</translation>
    </message>
    <message>
        <source>no link: a file</source>
        <translation>keine Verbindung: eine Datei</translation>
    </message>
    <message>
        <source>robot: --</source>
        <translation>Roboter: --</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Gelände</translation>
    </message>
    <message>
        <source>The scene and its estimate</source>
        <translation>Die Szene und ihre Schätzung</translation>
    </message>
    <message>
        <source>next
.</source>
        <translation>weiter
.</translation>
    </message>
    <message>
        <source>Next scene (.)</source>
        <translation>Nächste Szene (.)</translation>
    </message>
    <message>
        <source>Previous scene (,)</source>
        <translation>Szene davor (,)</translation>
    </message>
    <message>
        <source>All scenes, their verdicts and errors</source>
        <translation>Alle Szenen, ihre Urteile und Fehler</translation>
    </message>
    <message>
        <source>the truth is unknown</source>
        <translation>die Wahrheit ist unbekannt</translation>
    </message>
    <message>
        <source>no error yet</source>
        <translation>noch kein Fehler</translation>
    </message>
    <message>
        <source>error: median %1 mm, mean %2 mm</source>
        <translation>Fehler: Median %1 mm, Mittel %2 mm</translation>
    </message>
    <message>
        <source>SCENE %1 of %2 in %3 · drive %4 at %5 s · estimated now, not recorded · %6</source>
        <translation>SZENE %1 von %2 in %3 · Fahrt %4 bei %5 s · jetzt geschätzt, nicht aufgezeichnet · %6</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>previous
,</source>
        <translation>vorige
,</translation>
    </message>
</context>
<context>
    <name>terratact::ScreenshotDemo</name>
    <message>
        <source>the demonstration took too long</source>
        <translation>die Vorführung dauerte zu lange</translation>
    </message>
    <message>
        <source>%1 shows the window at that time</source>
        <translation>%1 zeigt das Fenster zu dieser Zeit</translation>
    </message>
</context>
<context>
    <name>terratact::SecondView</name>
    <message>
        <source>%1 — view only — Terratact</source>
        <translation>%1 — nur Anzeige — Terratact</translation>
    </message>
</context>
<context>
    <name>terratact::SessionBrowser</name>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Enter or a double click opens a recording; Alt+1 to Alt+0 sort by a column</source>
        <translation>Enter oder ein Doppelklick öffnet eine Aufzeichnung; Alt+1 bis Alt+0 sortieren nach einer Spalte</translation>
    </message>
    <message>
        <source>Search the recordings</source>
        <translation>Aufzeichnungen durchsuchen</translation>
    </message>
    <message>
        <source>Search (/): date, robot, verdict, notes, state</source>
        <translation>Suchen (/): Datum, Roboter, Urteil, Notizen, Zustand</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Ordner…</translation>
    </message>
    <message>
        <source>Shows the recordings of another folder, also at the next start</source>
        <translation>Zeigt die Aufzeichnungen eines anderen Ordners, auch beim nächsten Start</translation>
    </message>
    <message>
        <source>State of the list</source>
        <translation>Zustand der Liste</translation>
    </message>
    <message>
        <source>O&amp;ther file…</source>
        <translation>&amp;Andere Datei…</translation>
    </message>
    <message>
        <source>Asks for a session, a log or scenes anywhere</source>
        <translation>Fragt nach einer Sitzung, einem Log oder Szenen an beliebigem Ort</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Reviews the chosen recording in another window (Enter)</source>
        <translation>Öffnet die gewählte Aufzeichnung zur Durchsicht in einem anderen Fenster (Enter)</translation>
    </message>
    <message>
        <source>reading: %1 of %2 recordings</source>
        <translation>es wird gelesen: %1 von %2 Aufzeichnungen</translation>
    </message>
    <message>
        <source>%1 of %2 recordings match</source>
        <translation>%1 von %2 Aufzeichnungen passen</translation>
    </message>
    <message>
        <source>recordings: %1</source>
        <translation>Aufzeichnungen: %1</translation>
    </message>
    <message>
        <source>%1 older ones are not listed</source>
        <translation>%1 ältere sind nicht aufgeführt</translation>
    </message>
    <message>
        <source>The folder is being read …</source>
        <translation>Der Ordner wird gelesen …</translation>
    </message>
    <message>
        <source>No recording matches the search.</source>
        <translation>Keine Aufzeichnung passt zur Suche.</translation>
    </message>
    <message>
        <source>The folder holds no recording.</source>
        <translation>Der Ordner enthält keine Aufzeichnung.</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Ordner der Aufzeichnungen</translation>
    </message>
</context>
<context>
    <name>terratact::SessionDetails</name>
    <message>
        <source>This console is recording it. It can be reviewed meanwhile.</source>
        <translation>Diese Konsole zeichnet sie gerade auf. Sie kann schon durchgesehen werden.</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 frames, %4 scenes, %5 estimates</source>
        <translation>%1 · %2 · %3 Rahmen, %4 Szenen, %5 Schätzungen</translation>
    </message>
    <message>
        <source>last verdicts of the scenes: %1</source>
        <translation>letzte Urteile der Szenen: %1</translation>
    </message>
    <message>
        <source>probes: %1 approved of %2 proposed; alarms raised: %3</source>
        <translation>Sondierungen: %1 von %2 vorgeschlagenen genehmigt; Alarme: %3</translation>
    </message>
    <message>
        <source>It is still being recorded, or its program died.</source>
        <translation>Sie wird noch aufgezeichnet, oder ihr Programm ist abgestürzt.</translation>
    </message>
    <message>
        <source>Its journal is missing or damaged: the end is not in the file.</source>
        <translation>Ihr Journal fehlt oder ist beschädigt: Das Ende ist nicht in der Datei.</translation>
    </message>
    <message>
        <source>notes: %1</source>
        <translation>Notizen: %1</translation>
    </message>
    <message>
        <source>Ground of the last estimate</source>
        <translation>Boden der letzten Schätzung</translation>
    </message>
    <message>
        <source>No estimate</source>
        <translation>Keine Schätzung</translation>
    </message>
    <message>
        <source>The chosen recording</source>
        <translation>Die gewählte Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>terratact::SessionEventLogger</name>
    <message>
        <source>P(step &gt; %1 m) = %2 % ± %3</source>
        <translation>P(Stufe &gt; %1 m) = %2 % ± %3</translation>
    </message>
    <message>
        <source>P(step &gt; %1 m to %2 m) = %3 % ± %4</source>
        <translation>P(Stufe &gt; %1 m bis %2 m) = %3 % ± %4</translation>
    </message>
    <message>
        <source>not felt: %1</source>
        <translation>nicht ertastet: %1</translation>
    </message>
    <message>
        <source>either side: %1</source>
        <translation>eine der Seiten: %1</translation>
    </message>
    <message>
        <source>left: %1</source>
        <translation>links: %1</translation>
    </message>
    <message>
        <source>right: %1</source>
        <translation>rechts: %1</translation>
    </message>
    <message>
        <source>probe proposed %1: %2 m, %3 … %4 m, sd %5 m</source>
        <translation>Sondierung vorgeschlagen %1: %2 m, %3 … %4 m, Standardabw. %5 m</translation>
    </message>
    <message>
        <source>exploration: %1</source>
        <translation>Erkundung: %1</translation>
    </message>
    <message>
        <source>no estimate</source>
        <translation>keine Schätzung</translation>
    </message>
    <message>
        <source>probing %1</source>
        <translation>Arm sondiert %1</translation>
    </message>
    <message>
        <source>P(step &gt; %1 m up to each horizon) = %2 % ± %3</source>
        <translation>P(Stufe &gt; %1 m bis zum jeweiligen Horizont) = %2 % ± %3</translation>
    </message>
    <message>
        <source>bounded: %1</source>
        <translation>begrenzt: %1</translation>
    </message>
</context>
<context>
    <name>terratact::SessionList</name>
    <message>
        <source>%1 not read</source>
        <translation>%1 nicht gelesen</translation>
    </message>
    <message>
        <source>● being recorded</source>
        <translation>● läuft</translation>
    </message>
    <message>
        <source>✕ cannot be read</source>
        <translation>✕ unlesbar</translation>
    </message>
    <message>
        <source>○ not closed</source>
        <translation>○ nicht geschlossen</translation>
    </message>
    <message>
        <source>✕ torn</source>
        <translation>✕ abgerissen</translation>
    </message>
    <message>
        <source>✕ damaged</source>
        <translation>✕ beschädigt</translation>
    </message>
    <message>
        <source>✓ sealed</source>
        <translation>✓ versiegelt</translation>
    </message>
    <message>
        <source>%1 kB</source>
        <translation>%1 kB</translation>
    </message>
    <message>
        <source>%1 MB</source>
        <translation>%1 MB</translation>
    </message>
    <message>
        <source>%1 GB</source>
        <translation>%1 GB</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>begins</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>lasts</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>verdicts</source>
        <translation>Urteile</translation>
    </message>
    <message>
        <source>probes</source>
        <translation>Sonden</translation>
    </message>
    <message>
        <source>alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>picture of the last estimate</source>
        <translation>Bild der letzten Schätzung</translation>
    </message>
    <message>
        <source>no estimate</source>
        <translation>keine Schätzung</translation>
    </message>
    <message>
        <source>before %1</source>
        <translation>vor %1</translation>
    </message>
</context>
<context>
    <name>terratact::SessionListView</name>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
</context>
<context>
    <name>terratact::SessionTimeline</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>%1 – %2  %3</source>
        <translation>%1 – %2  %3</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>terratact::SettingsFilesWindow</name>
    <message>
        <source>Profiles, export and import of settings</source>
        <translation>Profile, Export und Import der Einstellungen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profile</translation>
    </message>
    <message>
        <source>Switch to it …</source>
        <translation>Dorthin wechseln …</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Name of a profile</source>
        <translation>Name eines Profils</translation>
    </message>
    <message>
        <source>name, for example: robot A/night</source>
        <translation>Name, zum Beispiel: Roboter A/Nacht</translation>
    </message>
    <message>
        <source>The present settings are saved under this name</source>
        <translation>Unter diesem Namen werden die jetzigen Einstellungen gespeichert</translation>
    </message>
    <message>
        <source>Save the present settings</source>
        <translation>Jetzige Einstellungen speichern</translation>
    </message>
    <message>
        <source>Replace the profile</source>
        <translation>Profil ersetzen</translation>
    </message>
    <message>
        <source>Press again to replace it</source>
        <translation>Nochmals drücken: ersetzen</translation>
    </message>
    <message>
        <source>Press again to delete it</source>
        <translation>Nochmals drücken: löschen</translation>
    </message>
    <message>
        <source>Export to a file …</source>
        <translation>In eine Datei exportieren …</translation>
    </message>
    <message>
        <source>Writes all settings but the files of this computer; in SI units</source>
        <translation>Schreibt alle Einstellungen außer den Dateien dieses Rechners; in SI-Einheiten</translation>
    </message>
    <message>
        <source>Import a file …</source>
        <translation>Eine Datei importieren …</translation>
    </message>
    <message>
        <source>Shows what the file would change before it is applied</source>
        <translation>Zeigt zuerst, was die Datei ändern würde</translation>
    </message>
    <message>
        <source>Settings (*.settings)</source>
        <translation>Einstellungen (*.settings)</translation>
    </message>
    <message>
        <source>Export settings</source>
        <translation>Einstellungen exportieren</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Einstellungen importieren</translation>
    </message>
    <message>
        <source>What will change</source>
        <translation>Was sich ändert</translation>
    </message>
    <message>
        <source>Safety-relevant changes</source>
        <translation>Sicherheitsrelevante Änderungen</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>then</source>
        <translation>dann</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Leave all as it is</source>
        <translation>Alles lassen</translation>
    </message>
    <message>
        <source>Nothing was changed</source>
        <translation>Nichts wurde geändert</translation>
    </message>
    <message>
        <source>There is no place for profiles: settings are not saved</source>
        <translation>Für Profile gibt es keinen Ort: Einstellungen werden nicht gespeichert</translation>
    </message>
    <message>
        <source>Choose a profile first</source>
        <translation>Erst ein Profil wählen</translation>
    </message>
    <message>
        <source>Shows what it would change first</source>
        <translation>Zeigt zuerst, was es ändern würde</translation>
    </message>
    <message>
        <source>Asks for a second press</source>
        <translation>Verlangt ein zweites Drücken</translation>
    </message>
    <message>
        <source>Saves all settings as a new profile</source>
        <translation>Speichert alle Einstellungen als neues Profil</translation>
    </message>
    <message>
        <source>A profile of this name exists; asks for a second press</source>
        <translation>Ein Profil dieses Namens gibt es; verlangt ein zweites Drücken</translation>
    </message>
    <message>
        <source>Applies the changes listed here</source>
        <translation>Wendet die hier genannten Änderungen an</translation>
    </message>
    <message>
        <source>Saved as profile “%1”</source>
        <translation>Gespeichert als Profil „%1“</translation>
    </message>
    <message>
        <source>Deleted: profile “%1”</source>
        <translation>Gelöscht: Profil „%1“</translation>
    </message>
    <message>
        <source>The profile “%1” could not be deleted</source>
        <translation>Das Profil „%1“ konnte nicht gelöscht werden</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>“%1” changes nothing: these settings are active</source>
        <translation>„%1“ ändert nichts: diese Einstellungen gelten schon</translation>
    </message>
    <message>
        <source>safety: %1</source>
        <translation>Sicherheit: %1</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>“%1” changes:</source>
        <translation>„%1“ ändert:</translation>
    </message>
    <message>
        <source>Safety-relevant: %1</source>
        <translation>Sicherheitsrelevant: %1</translation>
    </message>
    <message>
        <source>Apply, safety-relevant changes too</source>
        <translation>Anwenden, auch Sicherheitsrelevantes</translation>
    </message>
    <message>
        <source>Not applied: %1</source>
        <translation>Nicht angewendet: %1</translation>
    </message>
    <message>
        <source>In force: “%1”</source>
        <translation>In Kraft: „%1“</translation>
    </message>
    <message>
        <source>settings of “%1” came into force</source>
        <translation>Einstellungen „%1“ sind in Kraft</translation>
    </message>
</context>
<context>
    <name>terratact::SettingsPage</name>
    <message>
        <source>Estimate</source>
        <translation>Schätzung</translation>
    </message>
    <message>
        <source>Look and sound</source>
        <translation>Aussehen und Ton</translation>
    </message>
    <message>
        <source>Restore all defaults</source>
        <translation>Alles auf Standard</translation>
    </message>
    <message>
        <source>Resets this page, the model and the robot to their defaults</source>
        <translation>Setzt diese Seite, das Modell und den Roboter auf den Standard zurück</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>An obstacle is a step above</source>
        <translation>Hindernis ist eine Stufe über</translation>
    </message>
    <message>
        <source>Step height that the verdict asks about (PgUp, PgDown)</source>
        <translation>Stufenhöhe, nach der das Urteil fragt (Bild auf, Bild ab)</translation>
    </message>
    <message>
        <source>An element counts as contact above</source>
        <translation>Kontakt ist ein Element über</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Weaker forces count as noise</source>
        <translation>Schwächere Kräfte sind Rauschen</translation>
    </message>
    <message>
        <source>The arm is offered above a sd of</source>
        <translation>Arm wird angeboten ab sd</translation>
    </message>
    <message>
        <source>A bin less certain than this asks for a probe</source>
        <translation>Ein unsichereres Feld verlangt eine Sondierung</translation>
    </message>
    <message>
        <source>The verdict is withheld above a roll of</source>
        <translation>Kein Urteil ab Rollen von</translation>
    </message>
    <message>
        <source>Then left and right ground differ</source>
        <translation>Dann ist der Boden links und rechts verschieden</translation>
    </message>
    <message>
        <source>… or left and right flippers differ by</source>
        <translation>… oder Flipper links/rechts um</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>day</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>night, red</source>
        <translation>Nacht, rot</translation>
    </message>
    <message>
        <source>high contrast</source>
        <translation>hoher Kontrast</translation>
    </message>
    <message>
        <source>Night, red: keeps the eyes adapted to the dark</source>
        <translation>Nacht, rot: die Augen bleiben an das Dunkel gewöhnt</translation>
    </message>
    <message>
        <source>Size of text</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>Ctrl + and Ctrl −</source>
        <translation>Strg + und Strg −</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>the system&apos;s</source>
        <translation>wie das System</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Fahren</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sondieren</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Auswerten</translation>
    </message>
    <message>
        <source>What the terrain page makes large</source>
        <translation>Was die Seite Gelände groß zeigt</translation>
    </message>
    <message>
        <source>Alarm sound</source>
        <translation>Alarmton</translation>
    </message>
    <message>
        <source>Model and robot</source>
        <translation>Modell und Roboter</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>Choose a file: %1</source>
        <translation>Datei wählen: %1</translation>
    </message>
    <message>
        <source>Shipped</source>
        <translation>Mitgeliefert</translation>
    </message>
    <message>
        <source>Shipped: %1</source>
        <translation>Mitgeliefert: %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Models (*.ttm)</source>
        <translation>Modelle (*.ttm)</translation>
    </message>
    <message>
        <source>Robots (*.toml)</source>
        <translation>Roboter (*.toml)</translation>
    </message>
    <message>
        <source>Use this file from now on</source>
        <translation>Ab jetzt diese Datei verwenden</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Off: alarms are only seen</source>
        <translation>Aus: Alarme sind nur zu sehen</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>Everything is recorded</source>
        <translation>Alles wird aufgezeichnet</translation>
    </message>
    <message>
        <source>Frames, scenes, estimates, what was shown and decided, in one file per session</source>
        <translation>Rahmen, Szenen, Schätzungen, was gezeigt und entschieden wurde, in einer Datei je Sitzung</translation>
    </message>
    <message>
        <source>Delete a session after</source>
        <translation>Eine Sitzung löschen nach</translation>
    </message>
    <message>
        <source>days</source>
        <translation>Tagen</translation>
    </message>
    <message>
        <source>Delete the oldest beyond</source>
        <translation>Die ältesten löschen über</translation>
    </message>
    <message>
        <source>GB</source>
        <translation>GB</translation>
    </message>
    <message>
        <source>Restarts the console</source>
        <translation>Startet die Konsole neu</translation>
    </message>
    <message>
        <source>An estimate may take at most</source>
        <translation>Eine Schätzung darf höchstens dauern</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Sampling then ends with fewer draws, and the result says so</source>
        <translation>Das Ziehen endet dann mit weniger Ziehungen, und das Ergebnis sagt es</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>ohne Grenze</translation>
    </message>
    <message>
        <source>Measured by terratact tradeoff: time, mean error, and in brackets the distance of the quantiles from a long run&apos;s</source>
        <translation>Wie terratact tradeoff sie gemessen hat: Zeit, mittlerer Fehler und in Klammern, wie weit die Quantile von denen eines langen Laufs liegen</translation>
    </message>
    <message>
        <source>Back to the shipped file</source>
        <translation>Zurück zur mitgelieferten Datei</translation>
    </message>
    <message>
        <source>The shipped files are in use already</source>
        <translation>Die mitgelieferten Dateien sind schon in Gebrauch</translation>
    </message>
    <message>
        <source>The arm is offered</source>
        <translation>Arm wird angeboten</translation>
    </message>
    <message>
        <source>where the terrain is uncertain</source>
        <translation>wo das Gelände unsicher ist</translation>
    </message>
    <message>
        <source>there, unless the verdict is decided</source>
        <translation>dort, außer das Urteil ist entschieden</translation>
    </message>
    <message>
        <source>where it helps the verdict</source>
        <translation>wo es dem Urteil hilft</translation>
    </message>
    <message>
        <source>Uncertain: by the variance, as in the paper. About the verdict: by the entropy of the step question, and only while it is open</source>
        <translation>Unsicher: nach der Varianz, wie im Artikel. Urteil: nach der Entropie seiner Frage, gleich wie groß die sd ist, und nur solange sie offen ist</translation>
    </message>
    <message>
        <source>Applies ten seconds after the change. Never: nothing is deleted</source>
        <translation>Gilt zehn Sekunden nach der Änderung. Nie: nichts wird gelöscht</translation>
    </message>
    <message>
        <source>For all closed sessions together; applies ten seconds after the change</source>
        <translation>Für alle geschlossenen Sitzungen zusammen; gilt zehn Sekunden nach der Änderung</translation>
    </message>
    <message>
        <source>Sessions beyond these limits may be deleted</source>
        <translation>Sitzungen jenseits dieser Grenzen dürfen gelöscht werden</translation>
    </message>
    <message>
        <source>Until this is ticked, the console only lists what it would delete</source>
        <translation>Solange das nicht angekreuzt ist, sagt die Konsole nur, was sie löschen würde</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Drops and walls. At 5 % or more, CLEAR needs every bin felt up to the front flippers&apos; reach; lower rates accept ground that the flippers span</source>
        <translation>Abgründe und Wände. Ab 5 % muss für FREI jedes Feld ertastet sein, so weit die vorderen Flipper reichen; niedrigere Werte lassen Boden gelten, den die Flipper überspannen</translation>
    </message>
    <message>
        <source>Pitch or roll is steep from</source>
        <translation>Nick- oder Rollwinkel ist steil ab</translation>
    </message>
    <message>
        <source>Pitch or roll is dangerous from</source>
        <translation>Nick- oder Rollwinkel ist gefährlich ab</translation>
    </message>
    <message>
        <source>Press again to reset all settings</source>
        <translation>Nochmals drücken: alles zurück</translation>
    </message>
    <message>
        <source>Contact tick volume</source>
        <translation>Lautstärke der Kontakttöne</translation>
    </message>
    <message>
        <source>Ticks while a flipper touches the ground: higher towards the tip, faster with the force</source>
        <translation>Ticken, solange ein Flipper den Boden berührt: höher zur Spitze hin, schneller mit der Kraft</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Profiles, export and import …</source>
        <translation>Profile, Export und Import …</translation>
    </message>
    <message>
        <source>All settings as named profiles or as one file (Ctrl+,)</source>
        <translation>Alle Einstellungen als benannte Profile oder als eine Datei (Strg+,)</translation>
    </message>
    <message>
        <source>Connect to a bus, log or session …</source>
        <translation>Bus, Log oder Sitzung verbinden …</translation>
    </message>
    <message>
        <source>Connections, their faults and repairs (Ctrl+L)</source>
        <translation>Verbindungen, ihre Fehler und Abhilfen (Strg+L)</translation>
    </message>
    <message>
        <source>What the method uses</source>
        <translation>Was die Methode nutzt</translation>
    </message>
    <message>
        <source>Rate of hazards per %1 of ground that is not felt</source>
        <translation>Häufigkeit von Gefahren je %1 nicht ertasteten Bodens</translation>
    </message>
    <message>
        <source>Amber alarm; at the latest %1 before the robot tips over</source>
        <translation>Ein gelber Alarm; in jedem Fall %1 vor dem Kippen</translation>
    </message>
    <message>
        <source>Red alarm with sound; at the latest %1 before the robot tips over</source>
        <translation>Ein roter Alarm mit Ton; in jedem Fall %1 vor dem Kippen</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>Radiant</translation>
    </message>
</context>
<context>
    <name>terratact::SharedStop</name>
    <message>
        <source>STOP has no effect in windows opened from here: %1</source>
        <translation>STOP in Fenstern, die von hier geöffnet werden, hält nichts an: %1</translation>
    </message>
    <message>
        <source>STOP was pressed in a window that was opened from here</source>
        <translation>STOP wurde in einem Fenster gedrückt, das von hier geöffnet wurde</translation>
    </message>
    <message>
        <source>STOP has no effect: %1</source>
        <translation>STOP wirkt nicht: %1</translation>
    </message>
    <message>
        <source>STOP HAS NO EFFECT HERE: %1</source>
        <translation>STOP WIRKT HIER NICHT: %1</translation>
    </message>
    <message>
        <source>no folder can be made for it in TMPDIR or /tmp</source>
        <translation>dafür lässt sich in TMPDIR oder /tmp kein Ordner anlegen</translation>
    </message>
</context>
<context>
    <name>terratact::SignalList</name>
    <message>
        <source>part of a name</source>
        <translation>Teil eines Namens</translation>
    </message>
    <message>
        <source>Filter of the signals</source>
        <translation>Filter der Signale</translation>
    </message>
    <message>
        <source>Signals to plot</source>
        <translation>Signale für Kurven</translation>
    </message>
    <message>
        <source>Drag a signal onto a plot, or below the last one for a new plot</source>
        <translation>Ein Signal auf eine Kurve ziehen, oder unter die letzte für eine neue</translation>
    </message>
</context>
<context>
    <name>terratact::SignalTable</name>
    <message>
        <source>Frame</source>
        <translation>Rahmen</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signal</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Kleinster</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Größter</translation>
    </message>
    <message>
        <source>Last 12 s</source>
        <translation>Letzte 12 s</translation>
    </message>
    <message>
        <source>history of %1</source>
        <translation>Verlauf von %1</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
</context>
<context>
    <name>terratact::SignalsPage</name>
    <message>
        <source>error frame</source>
        <translation>Fehlerrahmen</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>load --- (bit rate not known): %1 to %2 kbit/s</source>
        <translation>Last --- (Bitrate unbekannt): %1 bis %2 kbit/s</translation>
    </message>
    <message>
        <source>load %1 to %2 % of %3 kbit/s (without stuff bits, with the most possible)</source>
        <translation>Last %1 bis %2 % von %3 kbit/s (ohne Stopfbits, mit allen möglichen)</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>State of the bus</source>
        <translation>Zustand des Busses</translation>
    </message>
    <message>
        <source>Reset min and max</source>
        <translation>Kleinste und größte vergessen</translation>
    </message>
    <message>
        <source>Newest frames</source>
        <translation>Neueste Rahmen</translation>
    </message>
    <message>
        <source>%1 · %2 frames/s · %3
Since the start: %4 frames, %5 dropped, %6 error frames, %7 with a wrong checksum, %8 out of sequence, %9 not in the DBC</source>
        <translation>%1 · %2 Rahmen/s · %3
Seit dem Start: %4 Rahmen, %5 verloren, %6 Fehlerrahmen, %7 mit falscher Prüfsumme, %8 außer der Reihe, %9 nicht in der DBC</translation>
    </message>
    <message>
        <source>This source is no CAN bus: it has no frames, and these are its values.</source>
        <translation>Diese Quelle ist kein CAN-Bus: sie hat keine Rahmen, dies sind ihre Werte.</translation>
    </message>
    <message>
        <source>load %1 to %2 % of nominal %3 kbit/s (without stuff bits, with the most possible)</source>
        <translation>Last %1 bis %2 % von nominell %3 kbit/s (ohne Stopfbits, mit allen möglichen)</translation>
    </message>
    <message>
        <source>%1, as %2 describes it; sent by %3
%4</source>
        <translation>%1, wie %2 ihn beschreibt; gesendet von %3
%4</translation>
    </message>
    <message>
        <source>DBC files</source>
        <translation>DBC-Dateien</translation>
    </message>
    <message>
        <source>Faults of the DBC files</source>
        <translation>Fehler der DBC-Dateien</translation>
    </message>
    <message>
        <source>Add DBC file …</source>
        <translation>DBC-Datei hinzufügen …</translation>
    </message>
    <message>
        <source>Adds a DBC file that describes frames of other devices</source>
        <translation>Fügt eine DBC-Datei hinzu, die Rahmen anderer Geräte beschreibt</translation>
    </message>
    <message>
        <source>Remove DBC file</source>
        <translation>DBC-Datei entfernen</translation>
    </message>
    <message>
        <source>Its frames are shown byte by byte again</source>
        <translation>Ihre Rahmen erscheinen wieder Byte für Byte</translation>
    </message>
    <message>
        <source>Counts restart with the next frames</source>
        <translation>Die Zählung beginnt neu mit den nächsten Rahmen</translation>
    </message>
    <message>
        <source>%1 (frames: %2)</source>
        <translation>%1 (Rahmen: %2)</translation>
    </message>
    <message>
        <source>%1 (not used)</source>
        <translation>%1 (nicht verwendet)</translation>
    </message>
    <message>
        <source>DBC files: %1</source>
        <translation>DBC-Dateien: %1</translation>
    </message>
    <message>
        <source>… and %1 more, all listed in this tooltip</source>
        <translation>… und %1 weitere; alle stehen hier im Hinweis</translation>
    </message>
    <message>
        <source>Add DBC file</source>
        <translation>DBC-Datei hinzufügen</translation>
    </message>
    <message>
        <source>DBC files (*.dbc *.DBC);;All files (*)</source>
        <translation>DBC-Dateien (*.dbc *.DBC);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>terratact::SnapshotNote</name>
    <message>
        <source>Note on the snapshot</source>
        <translation>Notiz zum Schnappschuss</translation>
    </message>
    <message>
        <source>note; empty: none</source>
        <translation>Notiz; leer: keine</translation>
    </message>
    <message>
        <source>Save the note</source>
        <translation>Notiz sichern</translation>
    </message>
    <message>
        <source>No note</source>
        <translation>Keine Notiz</translation>
    </message>
</context>
<context>
    <name>terratact::SnapshotWriter</name>
    <message>
        <source>%1: the picture cannot be coded; take the snapshot again</source>
        <translation>%1: das Bild lässt sich nicht codieren; den Schnappschuss wiederholen</translation>
    </message>
</context>
<context>
    <name>terratact::StatusHeader</name>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Where the data come from</source>
        <translation>Woher die Daten kommen</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Activity of the robot</source>
        <translation>Was der Roboter tut</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Quality of the estimate</source>
        <translation>Güte der Schätzung</translation>
    </message>
    <message>
        <source>Accuracy of an estimate against its computing time</source>
        <translation>Wie viel Zeit eine Schätzung für ihre Genauigkeit brauchen darf</translation>
    </message>
    <message>
        <source>STOP (F12)</source>
        <translation>STOP (F12)</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>STOPPED (F12)</source>
        <translation>STOP AKTIV (F12)</translation>
    </message>
    <message>
        <source>Active alarms, and past alarms not yet acknowledged (F4)</source>
        <translation>Anstehende Alarme und vergangene, die noch nicht quittiert sind (F4)</translation>
    </message>
    <message>
        <source>no alarms</source>
        <translation>keine Alarme</translation>
    </message>
    <message>
        <source>alarms: %1</source>
        <translation>Alarme: %1</translation>
    </message>
    <message>
        <source>%1, %2 not acknowledged</source>
        <translation>%1, %2 nicht quittiert</translation>
    </message>
    <message>
        <source>Checks overridden</source>
        <translation>Übergangene Prüfungen</translation>
    </message>
    <message>
        <source>! CHECK OVERRIDDEN</source>
        <translation>! PRÜFUNG ÜBERGANGEN</translation>
    </message>
    <message>
        <source>link %1 Hz · ≤ %2</source>
        <translation>Link %1 Hz · ≤ %2</translation>
    </message>
    <message>
        <source>STOP SENT …</source>
        <translation>STOP GESENDET …</translation>
    </message>
    <message>
        <source>STOP NOT SENT</source>
        <translation>STOP UNGESENDET</translation>
    </message>
    <message>
        <source>STOP: no commands</source>
        <translation>STOP: keine Befehle</translation>
    </message>
    <message>
        <source>STOP was sent but not confirmed by the robot; it is sent again</source>
        <translation>STOP wurde gesendet, der Roboter hat es nicht bestätigt; es wird erneut gesendet</translation>
    </message>
    <message>
        <source>STOP was not sent: %1</source>
        <translation>STOP wurde nicht gesendet: %1</translation>
    </message>
    <message>
        <source>The robot reports stopped; another press sends STOP again</source>
        <translation>Der Roboter meldet, dass er gestoppt ist; ein weiterer Druck sendet STOP erneut</translation>
    </message>
    <message>
        <source>STOP has no effect here: %1</source>
        <translation>STOP wirkt hier nicht: %1</translation>
    </message>
    <message>
        <source>Bus: %1</source>
        <translation>Bus: %1</translation>
    </message>
    <message>
        <source>Details: F5</source>
        <translation>Details: F5</translation>
    </message>
    <message>
        <source>Halts the robot of the console that opened this window</source>
        <translation>Hält den Roboter der Konsole an, die dieses Fenster geöffnet hat</translation>
    </message>
    <message>
        <source>Halts the robot at once and latches; F12 and Pause do the same everywhere</source>
        <translation>Hält den Roboter sofort an und rastet ein; F12 und Pause tun überall dasselbe</translation>
    </message>
</context>
<context>
    <name>terratact::StripExport</name>
    <message>
        <source>no strip to export: nothing was estimated yet, or the robot reports no odometry</source>
        <translation>kein Streifen zu exportieren: es wurde noch nichts geschätzt, oder der Roboter meldet keinen zurückgelegten Weg</translation>
    </message>
    <message>
        <source>Export the strip of felt ground</source>
        <translation>Streifen ertasteten Bodens exportieren</translation>
    </message>
    <message>
        <source>Pictures (*.svg *.png *.pdf *.html)</source>
        <translation>Bilder (*.svg *.png *.pdf *.html)</translation>
    </message>
    <message>
        <source>Profile (*.csv)</source>
        <translation>Profil (*.csv)</translation>
    </message>
    <message>
        <source>Point cloud (*.ply)</source>
        <translation>Punktwolke (*.ply)</translation>
    </message>
    <message>
        <source>a strip is still being written: try again</source>
        <translation>ein Streifen wird noch geschrieben: erneut versuchen</translation>
    </message>
    <message>
        <source>%1 exists and was not replaced; choose another name</source>
        <translation>%1 gibt es und wurde nicht ersetzt; anderen Namen wählen</translation>
    </message>
    <message>
        <source>strip of felt ground written: %1</source>
        <translation>Streifen ertasteten Bodens geschrieben: %1</translation>
    </message>
</context>
<context>
    <name>terratact::TerrainPage</name>
    <message>
        <source>Following: the arm is probing.</source>
        <translation>Mitverfolgt: der Arm sondiert.</translation>
    </message>
    <message>
        <source>The arm has measured; its height is part of the estimate.</source>
        <translation>Der Arm hat gemessen; seine Höhe ist Teil der Schätzung.</translation>
    </message>
    <message>
        <source>Following: probes are approved on the commanding console.</source>
        <translation>Mitverfolgt: Sondierungen genehmigt, wer den Roboter führt.</translation>
    </message>
    <message>
        <source>The proposal was not answered in time and counts as refused.</source>
        <translation>Der Vorschlag blieb ohne Antwort, das heißt nein.</translation>
    </message>
    <message>
        <source>No probe is proposed. After an exploration the arm is offered where the terrain stays uncertain.</source>
        <translation>Keine Sondierung vorgeschlagen. Nach einer Erkundung wird der Arm angeboten, wo das Gelände unsicher bleibt.</translation>
    </message>
    <message>
        <source>Last minutes</source>
        <translation>Letzte Minuten</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Gelände</translation>
    </message>
    <message>
        <source>view</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Optional marks: draws, a second method</source>
        <translation>Was noch gezeichnet wird: Ziehungen, eine zweite Methode</translation>
    </message>
    <message>
        <source>View of the terrain</source>
        <translation>Ansicht des Geländes</translation>
    </message>
    <message>
        <source>Front forces</source>
        <translation>Kräfte vorn</translation>
    </message>
    <message>
        <source>N / V</source>
        <translation>N / V</translation>
    </message>
    <message>
        <source>Raw voltages of the force elements</source>
        <translation>Rohe Spannungen der Kraftelemente</translation>
    </message>
    <message>
        <source>Raw voltages instead of calibrated forces</source>
        <translation>Rohe Spannungen statt kalibrierter Kräfte</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>Age of the telemetry</source>
        <translation>Alter der Telemetrie</translation>
    </message>
    <message>
        <source>- - %1 N</source>
        <translation>- - %1 N</translation>
    </message>
    <message>
        <source>raw voltages</source>
        <translation>rohe Spannungen</translation>
    </message>
    <message>
        <source>- - threshold %1 N</source>
        <translation>- - Schwelle %1 N</translation>
    </message>
    <message>
        <source>the log has ended</source>
        <translation>das Log ist zu Ende</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>%1 alt</translation>
    </message>
    <message>
        <source>The flippers still move: no ground ahead is felt yet</source>
        <translation>Die Flipper bewegen sich noch: vorn ist noch nichts ertastet</translation>
    </message>
    <message>
        <source>LIVE preview</source>
        <translation>LIVE-Vorschau</translation>
    </message>
    <message>
        <source>The flippers still move</source>
        <translation>Die Flipper bewegen sich noch</translation>
    </message>
    <message>
        <source>%1 s old</source>
        <translation>%1 s alt</translation>
    </message>
    <message>
        <source>&lt; %1 s old</source>
        <translation>&lt; %1 s alt</translation>
    </message>
    <message>
        <source>Preview while the flippers go down: the estimate is being computed</source>
        <translation>Vorschau vom Weg nach unten: die Schätzung wird berechnet</translation>
    </message>
    <message>
        <source>preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>The estimate is being computed</source>
        <translation>Die Schätzung wird berechnet</translation>
    </message>
    <message>
        <source>the forces are %1 old</source>
        <translation>die Kräfte sind %1 alt</translation>
    </message>
    <message>
        <source>The verdict is withheld: do not rely on a probe&apos;s gain.</source>
        <translation>Das Urteil wird zurückgehalten: nicht auf den Gewinn einer Sondierung verlassen.</translation>
    </message>
    <message>
        <source>Forces on the rear flippers</source>
        <translation>Kräfte an den hinteren Flippern</translation>
    </message>
    <message>
        <source>rear</source>
        <translation>hinten</translation>
    </message>
    <message>
        <source>Forces on the rear flippers instead of the front ones</source>
        <translation>Kräfte an den hinteren Flippern statt an den vorderen</translation>
    </message>
    <message>
        <source>Rear forces</source>
        <translation>Kräfte hinten</translation>
    </message>
    <message>
        <source>probe %1: its height, ± %2 instead of ± %3</source>
        <translation>Sondierung %1: ihre Höhe, ± %2 statt ± %3</translation>
    </message>
    <message>
        <source>probe %1: %2 → %3 bit</source>
        <translation>Sondierung %1: %2 → %3 bit</translation>
    </message>
    <message>
        <source>probe %1: no gain</source>
        <translation>Sondierung %1: kein Gewinn</translation>
    </message>
    <message>
        <source>an estimate of the past</source>
        <translation>eine frühere Schätzung</translation>
    </message>
    <message>
        <source>No probe is proposed; what one would tell:</source>
        <translation>Keine Sonde vorgeschlagen; was eine ergäbe:</translation>
    </message>
    <message>
        <source>%1; what one would tell:</source>
        <translation>%1; was eine Sonde ergäbe:</translation>
    </message>
</context>
<context>
    <name>terratact::TerrainProfileView</name>
    <message>
        <source>prior only</source>
        <translation>nur Vorwissen</translation>
    </message>
    <message>
        <source>Terrain profile</source>
        <translation>Geländeprofil</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>Obergrenze</translation>
    </message>
    <message>
        <source>No estimate yet</source>
        <translation>Noch keine Schätzung</translation>
    </message>
    <message>
        <source>forward from the IMU [%1]</source>
        <translation>vorwärts ab IMU [%1]</translation>
    </message>
    <message>
        <source>height [%1]</source>
        <translation>Höhe [%1]</translation>
    </message>
    <message>
        <source>IMU</source>
        <translation>IMU</translation>
    </message>
    <message>
        <source>bin %1: %2, 80 % in %3 … %4, %5</source>
        <translation>Feld %1: %2, 80 % in %3 … %4, %5</translation>
    </message>
    <message>
        <source>draws</source>
        <translation>Ziehungen</translation>
    </message>
    <message>
        <source>either … or</source>
        <translation>entweder … oder</translation>
    </message>
    <message>
        <source>80 % band</source>
        <translation>80-%-Band</translation>
    </message>
    <message>
        <source>truth</source>
        <translation>Wahrheit</translation>
    </message>
    <message>
        <source>bin %1</source>
        <translation>Feld %1</translation>
    </message>
    <message>
        <source>height %1 ± %2</source>
        <translation>Höhe %1 ± %2</translation>
    </message>
    <message>
        <source>80 % in %1 … %2</source>
        <translation>80 % in %1 … %2</translation>
    </message>
    <message>
        <source>ceiling %1</source>
        <translation>Obergrenze %1</translation>
    </message>
    <message>
        <source>no part of the robot above it</source>
        <translation>nichts vom Roboter darüber</translation>
    </message>
    <message>
        <source>either %1 (%2 %)</source>
        <translation>entweder %1 (%2 %)</translation>
    </message>
    <message>
        <source>or %1 (%2 %)</source>
        <translation>oder %1 (%2 %)</translation>
    </message>
    <message>
        <source>as of %1 ago</source>
        <translation>Stand vor %1</translation>
    </message>
    <message>
        <source>not live: no telemetry from the robot</source>
        <translation>nicht aktuell: keine Telemetrie vom Roboter</translation>
    </message>
    <message>
        <source>arm tip: probe?</source>
        <translation>Armspitze: sondieren?</translation>
    </message>
    <message>
        <source>arm tip: probing</source>
        <translation>Armspitze: sondiert</translation>
    </message>
    <message>
        <source>arm tip</source>
        <translation>Armspitze</translation>
    </message>
    <message>
        <source>forward, height [%1]</source>
        <translation>vorwärts, Höhe [%1]</translation>
    </message>
    <message>
        <source>from: %1 (%2)</source>
        <translation>aus: %1 (%2)</translation>
    </message>
    <message>
        <source>felt to %1</source>
        <translation>ertastet bis %1</translation>
    </message>
    <message>
        <source>touch: %1</source>
        <translation>ertastet: %1</translation>
    </message>
    <message>
        <source>bin %1: %2</source>
        <translation>Feld %1: %2</translation>
    </message>
    <message>
        <source>%1: height %2 ± %3</source>
        <translation>%1: Höhe %2 ± %3</translation>
    </message>
    <message>
        <source>remembered</source>
        <translation>gemerkt</translation>
    </message>
    <message>
        <source>remembered ± %1</source>
        <translation>gemerkt ± %1</translation>
    </message>
    <message>
        <source>remembered ground · %1 driven since · heights ± %2</source>
        <translation>gemerkter Boden · seither %1 gefahren · Höhen ± %2</translation>
    </message>
    <message>
        <source>free point</source>
        <translation>freier Punkt</translation>
    </message>
    <message>
        <source>%1 times closer (0: all)</source>
        <translation>%1-mal näher (0: alles)</translation>
    </message>
    <message>
        <source>measuring: drag, or ← → (Enter: begin here)</source>
        <translation>Messen: ziehen oder ← → (Enter: hier beginnen)</translation>
    </message>
    <message>
        <source>earlier: %1</source>
        <translation>früher: %1</translation>
    </message>
    <message>
        <source>earlier sections of ground behind it: %1</source>
        <translation>frühere Abschnitte des Bodens dahinter: %1</translation>
    </message>
</context>
<context>
    <name>terratact::TextSheet</name>
    <message>
        <source>Copy as text</source>
        <translation>Als Text kopieren</translation>
    </message>
    <message>
        <source>Copies everything, for a report</source>
        <translation>Kopiert alles, für einen Bericht</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Schließen (Esc)</translation>
    </message>
</context>
<context>
    <name>terratact::TimePlot</name>
    <message>
        <source>Plot of %1</source>
        <translation>Kurve: %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
</context>
<context>
    <name>terratact::TimePlots</name>
    <message>
        <source>No plot yet: drag a signal here, or choose one and press New plot</source>
        <translation>Noch keine Kurve: ein Signal hierher ziehen, oder eines wählen und „Neu“ drücken</translation>
    </message>
</context>
<context>
    <name>terratact::Touch</name>
    <message>
        <source>felt</source>
        <translation>ertastet</translation>
    </message>
    <message>
        <source>felt in part</source>
        <translation>teils ertastet</translation>
    </message>
    <message>
        <source>not felt</source>
        <translation>nicht ertastet</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>nicht aufgezeichnet</translation>
    </message>
    <message>
        <source>bounded</source>
        <translation>begrenzt</translation>
    </message>
    <message>
        <source>remembered</source>
        <translation>gemerkt</translation>
    </message>
</context>
<context>
    <name>terratact::TrainingPage</name>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>too few</source>
        <translation>zu wenig</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>scenes as CSV, with heights</source>
        <translation>Szenen als CSV, mit Höhen</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>1  Train a new model</source>
        <translation>1  Neues Modell trainieren</translation>
    </message>
    <message>
        <source>robot: the one in use</source>
        <translation>Roboter: der aktuelle</translation>
    </message>
    <message>
        <source>Train on</source>
        <translation>Lernen aus</translation>
    </message>
    <message>
        <source>Choose the training scenes</source>
        <translation>Szenen zum Lernen wählen</translation>
    </message>
    <message>
        <source>Name of the new model</source>
        <translation>Name des neuen Modells</translation>
    </message>
    <message>
        <source>Letters, digits, - _ and .; the file is %1/NAME.ttm</source>
        <translation>Buchstaben, Ziffern, - _ und .; die Datei ist %1/NAME.ttm</translation>
    </message>
    <message>
        <source>Seed of the search</source>
        <translation>Startwert der Suche</translation>
    </message>
    <message>
        <source>Same scenes and seed: the same model</source>
        <translation>Gleiche Szenen und gleicher Startwert: gleiches Modell</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Trains the model in the background</source>
        <translation>Modell trainieren; alles andere läuft weiter</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbruch</translation>
    </message>
    <message>
        <source>Cancels the training or comparison; no file is written</source>
        <translation>Beendet, was läuft; nichts wird geschrieben</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>State of the training</source>
        <translation>Stand des Trainings</translation>
    </message>
    <message>
        <source>bin</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>with
forces</source>
        <translation>mit
Kräften</translation>
    </message>
    <message>
        <source>without
forces</source>
        <translation>ohne
Kräfte</translation>
    </message>
    <message>
        <source>surface
below robot</source>
        <translation>Fläche
darunter</translation>
    </message>
    <message>
        <source>surface
ahead</source>
        <translation>Fläche
voraus</translation>
    </message>
    <message>
        <source>clearance
below robot</source>
        <translation>Abstand
darunter</translation>
    </message>
    <message>
        <source>clearance
ahead</source>
        <translation>Abstand
voraus</translation>
    </message>
    <message>
        <source>Training, bin by bin</source>
        <translation>Training, Feld für Feld</translation>
    </message>
    <message>
        <source>Centre of the bin</source>
        <translation>Mitte des Feldes</translation>
    </message>
    <message>
        <source>Gaussian process given pose, currents and forces, and its log likelihood</source>
        <translation>Gauß-Prozess aus Lage, Strömen und Kräften, und seine Log-Likelihood</translation>
    </message>
    <message>
        <source>Gaussian process given the pose alone, and its log likelihood</source>
        <translation>Gauß-Prozess nur aus der Lage, und seine Log-Likelihood</translation>
    </message>
    <message>
        <source>Surface where the robot is above the bin</source>
        <translation>Fläche, wo der Roboter über dem Feld steht</translation>
    </message>
    <message>
        <source>Surface elsewhere</source>
        <translation>Fläche anderswo</translation>
    </message>
    <message>
        <source>Clearance given the other bins, where the robot is above the bin; log likelihood</source>
        <translation>Abstand aus den anderen Feldern, wo der Roboter über dem Feld steht; Log-Likelihood</translation>
    </message>
    <message>
        <source>The same elsewhere</source>
        <translation>Dasselbe anderswo</translation>
    </message>
    <message>
        <source>2  Compare it with the model in use, then adopt it</source>
        <translation>2  Mit dem aktuellen vergleichen, dann übernehmen</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>Modelle</translation>
    </message>
    <message>
        <source>Test on</source>
        <translation>Prüfen mit</translation>
    </message>
    <message>
        <source>Choose the test scenes</source>
        <translation>Szenen zum Prüfen wählen</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Estimate the test scenes with both models</source>
        <translation>Die Prüfszenen mit beiden Modellen schätzen</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>old</source>
        <translation>alt</translation>
    </message>
    <message>
        <source>new</source>
        <translation>neu</translation>
    </message>
    <message>
        <source>new − old</source>
        <translation>neu − alt</translation>
    </message>
    <message>
        <source>Old and new model</source>
        <translation>Altes und neues Modell</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>What to keep in mind</source>
        <translation>Was zu bedenken ist</translation>
    </message>
    <message>
        <source>Why not</source>
        <translation>Warum nicht</translation>
    </message>
    <message>
        <source>Use the new model from now on</source>
        <translation>Ab jetzt das neue Modell verwenden</translation>
    </message>
    <message>
        <source>Discard (hold)</source>
        <translation>Verwerfen (halten)</translation>
    </message>
    <message>
        <source>Discard the new model</source>
        <translation>Neues Modell verwerfen</translation>
    </message>
    <message>
        <source>Delete the new model&apos;s file</source>
        <translation>Datei des neuen Modells löschen</translation>
    </message>
    <message>
        <source>Trained on %1 scenes: %2</source>
        <translation>Mit %1 Szenen trainiert: %2</translation>
    </message>
    <message>
        <source>%1. No file was written: correct this and start again.</source>
        <translation>%1. Nichts wurde geschrieben: beheben und neu starten.</translation>
    </message>
    <message>
        <source>%1. Choose another file, or discard the new model.</source>
        <translation>%1. Andere Datei wählen oder das neue Modell verwerfen.</translation>
    </message>
    <message>
        <source>Cancelled: nothing was written</source>
        <translation>Abgebrochen: nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>Comparison cancelled</source>
        <translation>Vergleich abgebrochen</translation>
    </message>
    <message>
        <source>Scenes (*.csv);;All files (*)</source>
        <translation>Szenen (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose a file of scenes for training.</source>
        <translation>Eine Datei mit Szenen zum Lernen wählen.</translation>
    </message>
    <message>
        <source>Give the new model a name.</source>
        <translation>Dem neuen Modell einen Namen geben.</translation>
    </message>
    <message>
        <source>%1 exists already: choose another name.</source>
        <translation>%1 gibt es schon: anderen Namen wählen.</translation>
    </message>
    <message>
        <source>Loading the new model …</source>
        <translation>Das neue Modell wird geladen …</translation>
    </message>
    <message>
        <source>Train a model first.</source>
        <translation>Erst ein Modell trainieren.</translation>
    </message>
    <message>
        <source>Compare the new model before it is adopted.</source>
        <translation>Das neue Modell vor dem Übernehmen vergleichen.</translation>
    </message>
    <message>
        <source>An exploration is running: the model stays until it has ended (Esc ends it).</source>
        <translation>Eine Erkundung läuft: das Modell bleibt, bis sie endet (Esc beendet sie).</translation>
    </message>
    <message>
        <source>Training on %1; driving is not affected</source>
        <translation>Training mit %1; der Roboter arbeitet derweil weiter</translation>
    </message>
    <message>
        <source>%1 is in use now</source>
        <translation>%1 ist jetzt in Gebrauch</translation>
    </message>
    <message>
        <source>Not adopted, the model in use stays: %1</source>
        <translation>Nicht übernommen, das bisherige Modell bleibt: %1</translation>
    </message>
    <message>
        <source>%1 could not be deleted: delete it by hand</source>
        <translation>%1 ließ sich nicht löschen: von Hand löschen</translation>
    </message>
    <message>
        <source>%1 discarded</source>
        <translation>%1 verworfen</translation>
    </message>
    <message>
        <source>in use: %1; no new model yet</source>
        <translation>in Gebrauch: %1; noch kein neues Modell</translation>
    </message>
    <message>
        <source>in use: %1; new: %2</source>
        <translation>in Gebrauch: %1; neu: %2</translation>
    </message>
    <message>
        <source>comparing: %1 %</source>
        <translation>vergleicht: %1 %</translation>
    </message>
    <message>
        <source>training: %1 %</source>
        <translation>trainiert: %1 %</translation>
    </message>
    <message>
        <source>, about %1 left</source>
        <translation>, noch etwa %1</translation>
    </message>
    <message>
        <source>, time left not known yet</source>
        <translation>, Restzeit noch unbekannt</translation>
    </message>
    <message>
        <source>Compared on %1 scenes</source>
        <translation>Mit %1 Szenen verglichen</translation>
    </message>
    <message>
        <source>A model is being trained: cancel that first.</source>
        <translation>Ein Modell wird trainiert: erst abbrechen.</translation>
    </message>
    <message>
        <source>Two models are being compared: cancel that first.</source>
        <translation>Zwei Modelle werden verglichen: erst abbrechen.</translation>
    </message>
    <message>
        <source>There is no new model.</source>
        <translation>Es gibt kein neues Modell.</translation>
    </message>
    <message>
        <source>Choose a file of scenes to test on.</source>
        <translation>Eine Datei mit Szenen zum Prüfen wählen.</translation>
    </message>
    <message>
        <source>No training or comparison is running.</source>
        <translation>Es läuft nichts, was man abbrechen könnte.</translation>
    </message>
    <message>
        <source>Adopt (hold)</source>
        <translation>Übernehmen (halten)</translation>
    </message>
    <message>
        <source>done (%1)</source>
        <translation>fertig (%1)</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>Untätig</translation>
    </message>
    <message>
        <source>%1: the number is the log-likelihood</source>
        <translation>%1: die Zahl ist die Log-Likelihood</translation>
    </message>
    <message>
        <source>Idle · done (log-likelihood %1)</source>
        <translation>Untätig · fertig (Log-Likelihood %1)</translation>
    </message>
</context>
<context>
    <name>terratact::TruthPage</name>
    <message>
        <source>Scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>The arrow keys choose a scene; typing a number goes to it</source>
        <translation>Die Pfeiltasten wählen eine Szene; eine getippte Nummer springt zu ihr</translation>
    </message>
    <message>
        <source>Slice of the cloud, robot and bins</source>
        <translation>Schnitt der Wolke, Roboter und Felder</translation>
    </message>
    <message>
        <source>The scene</source>
        <translation>Die Szene</translation>
    </message>
    <message>
        <source>left: dots · right: crosses · bins: mean of both sides, ± 1 and 2 sd</source>
        <translation>links: Punkte · rechts: Kreuze · Felder: Mittel beider Seiten, ± 1 und 2 Standardabw.</translation>
    </message>
    <message>
        <source>left: dots, solid · right: crosses, dashed · bins with ± 1 and 2 sd</source>
        <translation>links: Punkte, durchgezogen · rechts: Kreuze, gestrichelt · Felder mit ± 1 und 2 Standardabw.</translation>
    </message>
    <message>
        <source>both sides</source>
        <translation>beide Seiten</translation>
    </message>
    <message>
        <source>left side</source>
        <translation>linke Seite</translation>
    </message>
    <message>
        <source>right side</source>
        <translation>rechte Seite</translation>
    </message>
    <message>
        <source>Shown sides</source>
        <translation>Gezeigte Seiten</translation>
    </message>
    <message>
        <source>&amp;Accept</source>
        <translation>&amp;Annehmen</translation>
    </message>
    <message>
        <source>Keep the heights of this scene (A)</source>
        <translation>Die Höhen dieser Szene behalten (A)</translation>
    </message>
    <message>
        <source>E&amp;xclude</source>
        <translation>Ausschl&amp;ießen</translation>
    </message>
    <message>
        <source>Leave this scene out (X)</source>
        <translation>Diese Szene weglassen (X)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take the last decision back (Ctrl+Z)</source>
        <translation>Die letzte Entscheidung zurücknehmen (Strg+Z)</translation>
    </message>
    <message>
        <source>&amp;Export …</source>
        <translation>&amp;Exportieren …</translation>
    </message>
    <message>
        <source>Write the scenes with these decisions (Ctrl+E)</source>
        <translation>Die Szenen mit diesen Entscheidungen schreiben (Strg+E)</translation>
    </message>
    <message>
        <source>5 mm up</source>
        <translation>5 mm hoch</translation>
    </message>
    <message>
        <source>Move the heights up by 5 mm (U)</source>
        <translation>Die Höhen um 5 mm heben (U)</translation>
    </message>
    <message>
        <source>5 mm down</source>
        <translation>5 mm tiefer</translation>
    </message>
    <message>
        <source>Move the heights down by 5 mm (D)</source>
        <translation>Die Höhen um 5 mm senken (D)</translation>
    </message>
    <message>
        <source>front up</source>
        <translation>vorn hoch</translation>
    </message>
    <message>
        <source>Tilt by 0.005 rad: higher ahead (F)</source>
        <translation>Um 0,005 rad neigen: vorn höher (F)</translation>
    </message>
    <message>
        <source>front down</source>
        <translation>vorn tiefer</translation>
    </message>
    <message>
        <source>Tilt by 0.005 rad: lower ahead (G)</source>
        <translation>Um 0,005 rad neigen: vorn tiefer (G)</translation>
    </message>
    <message>
        <source>no nudge</source>
        <translation>ungerückt</translation>
    </message>
    <message>
        <source>Take the nudge of this scene away (0)</source>
        <translation>Die Verschiebung dieser Szene aufheben (0)</translation>
    </message>
    <message>
        <source>Decisions are saved in %1.</source>
        <translation>Entscheidungen werden in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Decisions of %1.</source>
        <translation>Entscheidungen aus %1.</translation>
    </message>
    <message>
        <source>%1. Move this file away to start again.</source>
        <translation>%1. Diese Datei verschieben, um neu zu beginnen.</translation>
    </message>
    <message>
        <source>Saved in %1.</source>
        <translation>In %1 gespeichert.</translation>
    </message>
    <message>
        <source>NOT SAVED: %1</source>
        <translation>NICHT GESPEICHERT: %1</translation>
    </message>
    <message>
        <source>%1 scenes: %2 accepted, %3 excluded</source>
        <translation>Szenen: %1, angenommen: %2, ausgeschlossen: %3</translation>
    </message>
    <message>
        <source>Scene %1 of %2</source>
        <translation>Szene %1 von %2</translation>
    </message>
    <message>
        <source>drive %1 at %2 s</source>
        <translation>Fahrt %1 bei %2 s</translation>
    </message>
    <message>
        <source>%1 bins known</source>
        <translation>bekannte Felder: %1</translation>
    </message>
    <message>
        <source>cloud %1 mm from the robot</source>
        <translation>Wolke %1 mm vom Roboter</translation>
    </message>
    <message>
        <source>nudged by %1</source>
        <translation>verschoben um %1</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>noch nicht gespeichert</translation>
    </message>
    <message>
        <source>Scenes to write</source>
        <translation>Zu schreibende Szenen</translation>
    </message>
    <message>
        <source>_accepted.csv</source>
        <translation>_angenommen.csv</translation>
    </message>
    <message>
        <source>Scenes (*.csv)</source>
        <translation>Szenen (*.csv)</translation>
    </message>
    <message>
        <source>%1 exists already: choose another name.</source>
        <translation>%1 gibt es schon: anderen Namen wählen.</translation>
    </message>
    <message>
        <source>%1 known heights written to %2.</source>
        <translation>Bekannte Höhen in %2 geschrieben: %1.</translation>
    </message>
    <message>
        <source>next scene</source>
        <translation>nächste Szene</translation>
    </message>
    <message>
        <source>previous scene</source>
        <translation>Szene davor</translation>
    </message>
    <message>
        <source>next open scene</source>
        <translation>nächste offene Szene</translation>
    </message>
    <message>
        <source>show both sides</source>
        <translation>beide Seiten zeigen</translation>
    </message>
    <message>
        <source>show the left side</source>
        <translation>die linke Seite zeigen</translation>
    </message>
    <message>
        <source>show the right side</source>
        <translation>die rechte Seite zeigen</translation>
    </message>
    <message>
        <source>Decisions</source>
        <translation>Entscheidungen</translation>
    </message>
    <message>
        <source>accept the scene</source>
        <translation>die Szene annehmen</translation>
    </message>
    <message>
        <source>exclude the scene</source>
        <translation>die Szene ausschließen</translation>
    </message>
    <message>
        <source>heights up by 5 mm</source>
        <translation>Höhen um 5 mm heben</translation>
    </message>
    <message>
        <source>heights down by 5 mm</source>
        <translation>Höhen um 5 mm senken</translation>
    </message>
    <message>
        <source>tilt: higher ahead</source>
        <translation>Neigung: vorn höher</translation>
    </message>
    <message>
        <source>tilt: lower ahead</source>
        <translation>Neigung: vorn tiefer</translation>
    </message>
    <message>
        <source>undo the last decision</source>
        <translation>die letzte Entscheidung zurücknehmen</translation>
    </message>
    <message>
        <source>write the scenes with these decisions</source>
        <translation>die Szenen mit diesen Entscheidungen schreiben</translation>
    </message>
    <message>
        <source>This truth file was written by an earlier version and holds no cells of the cloud: write it again by terratact truth --review to nudge along the way</source>
        <translation>Diese Wahrheitsdatei stammt von einer früheren Version und enthält keine Zellen der Punktwolke: mit terratact truth --review neu schreiben, um längs des Weges zu verschieben</translation>
    </message>
    <message>
        <source>2 cm ahead</source>
        <translation>2 cm vor</translation>
    </message>
    <message>
        <source>Move the cloud ahead by 2 cm under the robot (K)</source>
        <translation>Die Punktwolke unter dem Roboter um 2 cm nach vorn schieben (K)</translation>
    </message>
    <message>
        <source>2 cm back</source>
        <translation>2 cm zurück</translation>
    </message>
    <message>
        <source>Move the cloud back by 2 cm under the robot (J)</source>
        <translation>Die Punktwolke unter dem Roboter um 2 cm zurückschieben (J)</translation>
    </message>
    <message>
        <source>cloud ahead by 2 cm</source>
        <translation>Punktwolke um 2 cm nach vorn</translation>
    </message>
    <message>
        <source>cloud back by 2 cm</source>
        <translation>Punktwolke um 2 cm zurück</translation>
    </message>
</context>
<context>
    <name>terratact::TruthRows</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>another run</source>
        <translation>andere Fahrt</translation>
    </message>
    <message>
        <source>no pose around its time</source>
        <translation>keine Pose um ihre Zeit</translation>
    </message>
    <message>
        <source>left out: the robot lies off the cloud</source>
        <translation>weggelassen: der Roboter liegt neben der Wolke</translation>
    </message>
    <message>
        <source>no bin is known well enough</source>
        <translation>kein Feld ist gut genug bekannt</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>ausgeschlossen</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>decision</source>
        <translation>Entscheidung</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>Fahrt</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>cloud</source>
        <translation>Wolke</translation>
    </message>
    <message>
        <source>bins</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>nudge</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>%1 mm along</source>
        <translation>%1 mm längs</translation>
    </message>
</context>
<context>
    <name>terratact::TruthView</name>
    <message>
        <source>Slice of the cloud, robot and bins</source>
        <translation>Schnitt der Wolke, Roboter und Felder</translation>
    </message>
    <message>
        <source>height [%1]</source>
        <translation>Höhe [%1]</translation>
    </message>
    <message>
        <source>forward from the IMU [%1]</source>
        <translation>vorwärts ab IMU [%1]</translation>
    </message>
</context>
<context>
    <name>terratact::TruthWindow</name>
    <message>
        <source>TRUTH — %1 — Terratact</source>
        <translation>WAHRHEIT — %1 — Terratact</translation>
    </message>
    <message>
        <source>TRUTH FROM A LASER MAP</source>
        <translation>WAHRHEIT AUS EINER LASERKARTE</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>Wahrheit</translation>
    </message>
    <message>
        <source>Scenes, their cloud, and the decisions on them</source>
        <translation>Szenen, ihre Wolke und die Entscheidungen dazu</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
</context>
<context>
    <name>terratact::VerdictStrip</name>
    <message>
        <source>most likely at %1 … %2 (P %3)</source>
        <translation>am ehesten bei %1 … %2 (P %3)</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
    <message>
        <source>Probability of a step ahead</source>
        <translation>Wahrscheinlichkeit einer Stufe voraus</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Warum</translation>
    </message>
    <message>
        <source>Lower the limit</source>
        <translation>Grenze senken</translation>
    </message>
    <message>
        <source>Lowers the step limit (PgDown)</source>
        <translation>Auch eine niedrigere Stufe gilt als Hindernis (Bild ab)</translation>
    </message>
    <message>
        <source>Raise the limit</source>
        <translation>Grenze anheben</translation>
    </message>
    <message>
        <source>Raises the step limit (PgUp)</source>
        <translation>Erst eine höhere Stufe gilt als Hindernis (Bild auf)</translation>
    </message>
    <message>
        <source>✔ CLEAR</source>
        <translation>✔ FREI</translation>
    </message>
    <message>
        <source>up to %2 ahead of the IMU, at a risk below %1 %</source>
        <translation>bis %2 vor der IMU, Risiko unter %1 %</translation>
    </message>
    <message>
        <source>✘ BLOCKED</source>
        <translation>✘ VERSPERRT</translation>
    </message>
    <message>
        <source>? CANNOT TELL</source>
        <translation>? UNKLAR</translation>
    </message>
    <message>
        <source>withheld: %1</source>
        <translation>zurückgehalten: %1</translation>
    </message>
    <message>
        <source>NO VERDICT</source>
        <translation>KEIN URTEIL</translation>
    </message>
    <message>
        <source>Is there a step of more than %1 ahead?</source>
        <translation>Ist voraus eine Stufe über %1?</translation>
    </message>
    <message>
        <source>not decided (CLEAR below %1, BLOCKED above %2); %3</source>
        <translation>nicht entschieden (FREI unter %1, VERSPERRT über %2); %3</translation>
    </message>
    <message>
        <source>no live telemetry</source>
        <translation>keine aktuelle Telemetrie</translation>
    </message>
    <message>
        <source>not converged</source>
        <translation>nicht konvergiert</translation>
    </message>
    <message>
        <source>unlike all training</source>
        <translation>anders als im Training</translation>
    </message>
    <message>
        <source>the robot rolls</source>
        <translation>Rollwinkel zu groß</translation>
    </message>
    <message>
        <source>the flippers differ</source>
        <translation>die Flipper weichen ab</translation>
    </message>
    <message>
        <source>%1 is the lowest limit</source>
        <translation>Eine niedrigere Grenze als %1 geht nicht</translation>
    </message>
    <message>
        <source>%1 is the highest limit</source>
        <translation>Eine höhere Grenze als %1 geht nicht</translation>
    </message>
    <message>
        <source>the link was lost</source>
        <translation>Verbindung war verloren</translation>
    </message>
    <message>
        <source>A step: two bins at most %3 apart differ in height by more than the limit. The bins lie %1 to %2 ahead of the IMU</source>
        <translation>Eine Stufe: die Höhen zweier Felder, höchstens %3 voneinander, sind um mehr als die Grenze verschieden. Die Felder liegen %1 bis %2 vor der IMU</translation>
    </message>
    <message>
        <source>felt to %1 ahead of the IMU, risk below %2 %</source>
        <translation>ertastet bis %1 vor der IMU, Risiko unter %2 %</translation>
    </message>
    <message>
        <source>%1. Helps: %2</source>
        <translation>%1. Es hilft: %2</translation>
    </message>
    <message>
        <source>✔ CLEAR to %1</source>
        <translation>✔ FREI bis %1</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>a sensor may be wrong</source>
        <translation>ein Sensor misst vielleicht falsch</translation>
    </message>
    <message>
        <source>it contradicts the readings</source>
        <translation>sie widerspricht den Messwerten</translation>
    </message>
    <message>
        <source>flippers press on nothing</source>
        <translation>Flipper drücken auf nichts</translation>
    </message>
    <message>
        <source>felt to %1 only</source>
        <translation>nur bis %1 ertastet</translation>
    </message>
    <message>
        <source>not felt under the flippers</source>
        <translation>unter den Flippern nicht ertastet</translation>
    </message>
    <message>
        <source>, flatter flippers help</source>
        <translation>, flachere Flipper helfen</translation>
    </message>
    <message>
        <source>not decided; %1</source>
        <translation>nicht entschieden; %1</translation>
    </message>
    <message>
        <source>not decided</source>
        <translation>nicht entschieden</translation>
    </message>
    <message>
        <source>Verdict of each side</source>
        <translation>Urteil je Seite</translation>
    </message>
    <message>
        <source>P(step &gt; %1 to %2): %3</source>
        <translation>P(Stufe &gt; %1 bis %2): %3</translation>
    </message>
    <message>
        <source>P(step &gt; %1 to %2) = %3</source>
        <translation>P(Stufe &gt; %1 bis %2) = %3</translation>
    </message>
    <message>
        <source>P(step &gt; %1 ahead): %2</source>
        <translation>P(Stufe &gt; %1 voraus): %2</translation>
    </message>
    <message>
        <source>P(step &gt; %1 ahead) = %2</source>
        <translation>P(Stufe &gt; %1 voraus) = %2</translation>
    </message>
    <message>
        <source>, %1 further helps</source>
        <translation>, %1 weiter hilft</translation>
    </message>
    <message>
        <source>bounded: %1</source>
        <translation>begrenzt: %1</translation>
    </message>
    <message>
        <source>not felt: %1</source>
        <translation>nicht ertastet: %1</translation>
    </message>
    <message>
        <source>nothing ahead is felt</source>
        <translation>voraus ist nichts ertastet</translation>
    </message>
    <message>
        <source>%1, spanned to %2, risk below %3 %</source>
        <translation>%1, bis %2 überspannt, Risiko unter %3 %</translation>
    </message>
    <message>
        <source>the differential has turned</source>
        <translation>das Differential ist verdreht</translation>
    </message>
</context>
<context>
    <name>terratact::ViewMenu</name>
    <message>
        <source>layout: drive</source>
        <translation>Anordnung: Fahren</translation>
    </message>
    <message>
        <source>layout: probe</source>
        <translation>Anordnung: Sondieren</translation>
    </message>
    <message>
        <source>layout: review</source>
        <translation>Anordnung: Auswerten</translation>
    </message>
    <message>
        <source>default layout and text size</source>
        <translation>Anordnung und Schrift wie am Anfang</translation>
    </message>
    <message>
        <source>colours: day</source>
        <translation>Farben: Tag</translation>
    </message>
    <message>
        <source>colours: night, red</source>
        <translation>Farben: Nacht, rot</translation>
    </message>
    <message>
        <source>colours: high contrast</source>
        <translation>Farben: hoher Kontrast</translation>
    </message>
    <message>
        <source>larger text</source>
        <translation>größere Schrift</translation>
    </message>
    <message>
        <source>smaller text</source>
        <translation>kleinere Schrift</translation>
    </message>
    <message>
        <source>normal text size</source>
        <translation>Schrift in normaler Größe</translation>
    </message>
    <message>
        <source>language: %1</source>
        <translation>Sprache: %1</translation>
    </message>
</context>
<context>
    <name>terratact::WhatIfPage</name>
    <message>
        <source>What if …</source>
        <translation>Was wäre, wenn …</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Was abweicht</translation>
    </message>
    <message>
        <source>Recorded estimate and what-if, bin by bin</source>
        <translation>Aufgezeichnete und andere Schätzung, Feld für Feld</translation>
    </message>
    <message>
        <source>bin [%1]</source>
        <translation>Feld [%1]</translation>
    </message>
    <message>
        <source>then [%1]</source>
        <translation>damals [%1]</translation>
    </message>
    <message>
        <source>now [%1]</source>
        <translation>jetzt [%1]</translation>
    </message>
    <message>
        <source>by</source>
        <translation>um</translation>
    </message>
    <message>
        <source>sd then</source>
        <translation>sd damals</translation>
    </message>
    <message>
        <source>sd now</source>
        <translation>sd jetzt</translation>
    </message>
    <message>
        <source>q10 by</source>
        <translation>q10 um</translation>
    </message>
    <message>
        <source>q90 by</source>
        <translation>q90 um</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>Which method estimates</source>
        <translation>Welche Methode schätzt</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Güte</translation>
    </message>
    <message>
        <source>Draws, chains and precision</source>
        <translation>Ziehungen, Ketten und Genauigkeit</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>wie aufgezeichnet</translation>
    </message>
    <message>
        <source>An element counts as contact above</source>
        <translation>Kontakt ist ein Element über</translation>
    </message>
    <message>
        <source>Force above which an element counts as contact</source>
        <translation>Kraft, ab der ein Element den Boden berührt</translation>
    </message>
    <message>
        <source>Contact above</source>
        <translation>Kontakt über</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Seed of the random numbers: a whole number</source>
        <translation>Startwert der Zufallszahlen: eine ganze Zahl</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>File of the model</source>
        <translation>Datei des Modells</translation>
    </message>
    <message>
        <source>another file …</source>
        <translation>andere Datei …</translation>
    </message>
    <message>
        <source>Models (*.ttm)</source>
        <translation>Modelle (*.ttm)</translation>
    </message>
    <message>
        <source>As recorded</source>
        <translation>Wie aufgezeichnet</translation>
    </message>
    <message>
        <source>Sets everything to what was recorded</source>
        <translation>Setzt alles auf das Aufgezeichnete</translation>
    </message>
    <message>
        <source>Estimates the recorded scene with these settings</source>
        <translation>Schätzt die aufgezeichnete Szene mit diesen Einstellungen</translation>
    </message>
    <message>
        <source>Progress of the estimate</source>
        <translation>Fortschritt der Schätzung</translation>
    </message>
    <message>
        <source>Estimate %1 of scene %2 at %3 s, by %4 with the model %5</source>
        <translation>Schätzung %1 der Szene %2 bei %3 s, mit %4 und dem Modell %5</translation>
    </message>
    <message>
        <source>There was no estimate at this time: go to one (key 4 finds the next).</source>
        <translation>Zu dieser Zeit galt keine Schätzung: gehen Sie zu einer (Taste 4 findet die nächste).</translation>
    </message>
    <message>
        <source>No estimate: %1</source>
        <translation>Keine Schätzung: %1</translation>
    </message>
    <message>
        <source>No model is chosen</source>
        <translation>Kein Modell gewählt</translation>
    </message>
    <message>
        <source>Estimating …</source>
        <translation>Schätzt …</translation>
    </message>
    <message>
        <source>The recorded settings and model reproduce the recorded estimate bit for bit.</source>
        <translation>Die aufgezeichneten Einstellungen und das Modell ergeben die aufgezeichnete Schätzung wieder, Bit für Bit.</translation>
    </message>
    <message>
        <source>The recorded settings and model reproduce the recorded estimate except for rounding in the last bits: no number moves by more than a millionth.</source>
        <translation>Die aufgezeichneten Einstellungen und das Modell ergeben wieder die aufgezeichnete Schätzung, bis auf die letzten Bits, die ein anderer Prozessor oder eine andere Version anders rundet: keine Zahl ändert sich um mehr als ein Millionstel.</translation>
    </message>
    <message>
        <source>A time limit ended the recorded sampling, so it cannot be repeated bit for bit: %1 at most, at bin %2.</source>
        <translation>Die Zeit beendete das aufgezeichnete Ziehen, es lässt sich also nicht Bit für Bit wiederholen: höchstens %1, im Feld %2.</translation>
    </message>
    <message>
        <source>The recorded settings and model do NOT reproduce the recorded estimate: %1 at most, at bin %2.</source>
        <translation>Die aufgezeichneten Einstellungen und das Modell ergeben die aufgezeichnete Schätzung NICHT: höchstens %1, im Feld %2.</translation>
    </message>
    <message>
        <source>Differs from the recorded estimate by %1 at most, at bin %2.</source>
        <translation>Weicht von der aufgezeichneten Schätzung um höchstens %1 ab, im Feld %2.</translation>
    </message>
    <message>
        <source>Estimate again (E)</source>
        <translation>Erneut schätzen (E)</translation>
    </message>
    <message>
        <source>No estimate at this time</source>
        <translation>Zu dieser Zeit galt keine Schätzung</translation>
    </message>
    <message>
        <source>Change settings, then estimate again: the page Terrain (F2) draws both.</source>
        <translation>Einstellungen ändern, dann neu schätzen: die Seite Gelände (F2) zeichnet beide.</translation>
    </message>
    <message>
        <source>Cancel the estimate</source>
        <translation>Die Schätzung abbrechen</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>%1 links</translation>
    </message>
    <message>
        <source>%1 right</source>
        <translation>%1 rechts</translation>
    </message>
    <message>
        <source>Steps of more than %1: %2 then, %3 now.</source>
        <translation>Stufen über %1: damals %2, jetzt %3.</translation>
    </message>
    <message>
        <source>Left: %1 then, %2 now.</source>
        <translation>Links: damals %1, jetzt %2.</translation>
    </message>
    <message>
        <source>Right: %1 then, %2 now.</source>
        <translation>Rechts: damals %1, jetzt %2.</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
</context>
</TS>
