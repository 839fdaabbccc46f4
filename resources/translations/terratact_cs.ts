<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="cs" sourcelanguage="en">
<context>
    <name>About</name>
    <message>
        <source>Based in part on the work of the Qwt project (http://qwt.sf.net).</source>
        <translation>Částečně založeno na práci projektu Qwt (http://qwt.sf.net).</translation>
    </message>
    <message>
        <source>The operator&apos;s console of a tracked rescue robot. Where cameras see nothing, it estimates the terrain from what body, flippers and arm feel. Bands show how certain each height is.</source>
        <translation>Konzole operátora pásového záchranného robota. Kde kamery nic nevidí, odhaduje terén z toho, co cítí tělo, flippery a rameno. Pásma ukazují, jak jistá je každá výška.</translation>
    </message>
    <message>
        <source>Copyright %1 Terratact contributors. MIT licence: free to use, to change and to pass on; without any warranty.</source>
        <translation>Copyright %1 přispěvatelé Terratactu. Licence MIT: lze volně užívat, měnit a předávat dál; bez jakékoli záruky.</translation>
    </message>
    <message>
        <source>It uses Qt %1 (https://www.qt.io), a library of its own under the GNU LGPL, version 3, which may be replaced by another version of it.</source>
        <translation>Používá Qt %1 (https://www.qt.io), samostatnou knihovnu pod licencí GNU LGPL verze 3, kterou lze nahradit její jinou verzí.</translation>
    </message>
    <message>
        <source>Other libraries: Eigen (MPL 2.0), OpenBLAS (BSD), SQLite (public domain), cairo (LGPL 2.1), libgpiod (LGPL 2.1), ALSA (LGPL 2.1), {fmt} (MIT), CLI11 (BSD), toml++ (MIT), Boost (BSL 1.0).</source>
        <translation>Další knihovny: Eigen (MPL 2.0), OpenBLAS (BSD), SQLite (volné dílo), cairo (LGPL 2.1), libgpiod (LGPL 2.1), ALSA (LGPL 2.1), {fmt} (MIT), CLI11 (BSD), toml++ (MIT), Boost (BSL 1.0).</translation>
    </message>
    <message>
        <source>All licences in full: %1</source>
        <translation>Všechny licence v plném znění: %1</translation>
    </message>
</context>
<context>
    <name>Application</name>
    <message>
        <source>Terratact could not open this</source>
        <translation>Terratact to nemohl otevřít</translation>
    </message>
    <message>
        <source>Terratact could not start</source>
        <translation>Terratact nelze spustit</translation>
    </message>
    <message>
        <source>no font is installed, so no text could be read: install one, such as fonts-dejavu-core</source>
        <translation>není nainstalováno žádné písmo, takže by nešlo přečíst žádný text: nainstalujte některé, například fonts-dejavu-core</translation>
    </message>
</context>
<context>
    <name>BusWords</name>
    <message>
        <source>%1 does not take frames: no node acknowledges them, or the bus is full. Check the robot&apos;s power, the wires and the bit rate</source>
        <translation>%1 nebere rámce: nikdo je nepotvrzuje nebo je sběrnice plná; je robot zapnutý, jsou vodiče a přenosová rychlost v pořádku?</translation>
    </message>
    <message>
        <source>%1 has many errors: check wires, terminators and bit rate</source>
        <translation>%1 má mnoho chyb: zkontrolujte vodiče, zakončení a přenosovou rychlost</translation>
    </message>
    <message>
        <source>%1 is bus-off after too many errors: check the wires, then restart it</source>
        <translation>%1 je po příliš mnoha chybách odpojena (bus-off): zkontrolujte vodiče a pak ji restartujte</translation>
    </message>
    <message>
        <source>%1 is down: bring it up</source>
        <translation>%1 je vypnuta: zapněte ji</translation>
    </message>
    <message>
        <source>%1 does not exist: plug the adapter in, or make the interface</source>
        <translation>%1 neexistuje: zapojte převodník, nebo rozhraní vytvořte</translation>
    </message>
    <message>
        <source>%1 has ended</source>
        <translation>%1 skončil</translation>
    </message>
    <message>
        <source>%1 is receive-only: start the console with --transmit</source>
        <translation>%1: jen poslech; konzoli spusťte s --transmit</translation>
    </message>
    <message>
        <source>%1 takes no commands</source>
        <translation>%1 nepřijímá povely</translation>
    </message>
    <message>
        <source>frames still come, heartbeat %1 old</source>
        <translation>rámce stále přicházejí, poslední odpověď před %1</translation>
    </message>
    <message>
        <source>frames still come, status %1 old</source>
        <translation>rámce stále přicházejí, poslední stav před %1</translation>
    </message>
    <message>
        <source>frames still come</source>
        <translation>rámce stále přicházejí</translation>
    </message>
    <message>
        <source>ACTIVE</source>
        <translation>AKTIVNÍ</translation>
    </message>
    <message>
        <source>STALLED</source>
        <translation>STOJÍ</translation>
    </message>
    <message>
        <source>PASSIVE</source>
        <translation>PASIVNÍ</translation>
    </message>
    <message>
        <source>BUS-OFF</source>
        <translation>ODPOJENA</translation>
    </message>
    <message>
        <source>DOWN</source>
        <translation>VYPNUTA</translation>
    </message>
    <message>
        <source>ABSENT</source>
        <translation>CHYBÍ</translation>
    </message>
    <message>
        <source>ENDED</source>
        <translation>KONEC</translation>
    </message>
    <message>
        <source>%1 has errors: check wires, terminators and bit rate</source>
        <translation>%1 má chyby: zkontrolujte vodiče, zakončení a přenosovou rychlost</translation>
    </message>
    <message>
        <source>WARNING</source>
        <translation>VAROVÁNÍ</translation>
    </message>
    <message>
        <source>%1: working</source>
        <translation>%1: v provozu</translation>
    </message>
    <message>
        <source>internal bus</source>
        <translation>vnitřní sběrnice</translation>
    </message>
</context>
<context>
    <name>ComparisonWords</name>
    <message>
        <source>median error near [mm]</source>
        <translation>medián chyby blízko [mm]</translation>
    </message>
    <message>
        <source>mean error near [mm]</source>
        <translation>průměrná chyba blízko [mm]</translation>
    </message>
    <message>
        <source>CRPS near [mm]</source>
        <translation>CRPS blízko [mm]</translation>
    </message>
    <message>
        <source>80 % band near holds [%]</source>
        <translation>v pásmu 80 % blízko [%]</translation>
    </message>
    <message>
        <source>median error, all bins [mm]</source>
        <translation>medián chyby, vše [mm]</translation>
    </message>
    <message>
        <source>mean error, all bins [mm]</source>
        <translation>průměrná chyba, vše [mm]</translation>
    </message>
    <message>
        <source>CRPS, all bins [mm]</source>
        <translation>CRPS, vše [mm]</translation>
    </message>
    <message>
        <source>80 % band, all bins holds [%]</source>
        <translation>v pásmu 80 %, vše [%]</translation>
    </message>
    <message>
        <source>Near the robot the new model has the same mean error as the old one on %1 scenes</source>
        <translation>Nový model se blízko robota mýlí stejně jako starý (scén: %1)</translation>
    </message>
    <message>
        <source>Near the robot the new model&apos;s mean error is %1 % smaller on %2 scenes</source>
        <translation>Nový model se blízko robota mýlí o %1 % méně (scén: %2)</translation>
    </message>
    <message>
        <source>Near the robot the new model&apos;s mean error is %1 % larger on %2 scenes</source>
        <translation>Nový model se blízko robota mýlí o %1 % více (scén: %2)</translation>
    </message>
    <message>
        <source>%1; its 80 % bands there cover %2 % of the true heights, the old model&apos;s %3 %.</source>
        <translation>%1; v jeho pásmech 80 % tam leží %2 % skutečných výšek, u starého %3 %.</translation>
    </message>
    <message>
        <source>Too few drives: the difference may be chance.</source>
        <translation>Příliš málo jízd: nelze říci, zda rozdíl není náhoda.</translation>
    </message>
    <message>
        <source>The difference may be chance: 95 % interval %1 … %2 mm.</source>
        <translation>Rozdíl může být náhoda: interval 95 % %1 … %2 mm.</translation>
    </message>
    <message>
        <source>%1 of the file&apos;s %2 scenes, evenly picked.</source>
        <translation>%1 z %2 scén souboru, vybráno rovnoměrně.</translation>
    </message>
    <message>
        <source>%1 scenes left out that only one model or none could estimate (only the old %2, only the new %3): %4.</source>
        <translation>Vynecháno scén: %1, odhadl je jen jeden model, nebo žádný (jen starý %2, jen nový %3): %4.</translation>
    </message>
    <message>
        <source>The new model was trained on %1 of these %2 scenes or near copies, so its error looks too small. Choose scenes it has not seen.</source>
        <translation>Nový model byl naučen na %1 z těchto %2 scén nebo na jejich téměř shodných kopiích, proto jeho chyba vypadá příliš malá. Zvolte scény, které nezná.</translation>
    </message>
    <message>
        <source>The old model was trained on %1 of these %2 scenes or near copies, so its error looks too small.</source>
        <translation>Starý model byl naučen na %1 z těchto %2 scén nebo na jejich téměř shodných kopiích, proto jeho chyba vypadá příliš malá.</translation>
    </message>
</context>
<context>
    <name>DriveText</name>
    <message>
        <source>! STEEP</source>
        <translation>! STRMĚ</translation>
    </message>
    <message>
        <source>✘ DANGER</source>
        <translation>✘ POZOR</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádný</translation>
    </message>
    <message>
        <source>rear %1</source>
        <translation>vzadu %1</translation>
    </message>
    <message>
        <source>rear %1 %2: %3 N</source>
        <translation>vzadu %1 %2: %3 N</translation>
    </message>
    <message>
        <source>%1 %2: %3 N</source>
        <translation>%1 %2: %3 N</translation>
    </message>
    <message>
        <source>front %1: %2 N</source>
        <translation>vpředu %1: %2 N</translation>
    </message>
</context>
<context>
    <name>FileDialog</name>
    <message>
        <source>There is no file:</source>
        <translation>Soubor není:</translation>
    </message>
</context>
<context>
    <name>FileHeader</name>
    <message>
        <source>no link: a file</source>
        <translation>bez spojení: soubor</translation>
    </message>
    <message>
        <source>robot: --</source>
        <translation>robot: --</translation>
    </message>
    <message>
        <source>model: --</source>
        <translation>model: --</translation>
    </message>
</context>
<context>
    <name>Format</name>
    <message>
        <source>more than %1</source>
        <translation>více než %1</translation>
    </message>
    <message>
        <source>less than %1</source>
        <translation>méně než %1</translation>
    </message>
</context>
<context>
    <name>Gamepad</name>
    <message>
        <source>no gamepad is read, because SDL cannot start: %1</source>
        <translation>gamepad se nečte, protože SDL nelze spustit: %1</translation>
    </message>
    <message>
        <source>“%1” is not used, because SDL knows no layout of it: set SDL_GAMECONTROLLERCONFIG, or use another gamepad</source>
        <translation>„%1“ se nepoužívá, protože SDL nezná jeho rozložení: nastavte SDL_GAMECONTROLLERCONFIG, nebo použijte jiný gamepad</translation>
    </message>
</context>
<context>
    <name>KeyTable</name>
    <message>
        <source> or </source>
        <translation> nebo </translation>
    </message>
    <message>
        <source>%1, held</source>
        <translation>%1, držet</translation>
    </message>
</context>
<context>
    <name>Letters</name>
    <message>
        <source>%1 % wanted, %2 % fits this screen</source>
        <translation>zvoleno %1 %, vejde se %2 %</translation>
    </message>
</context>
<context>
    <name>LinkStatus</name>
    <message>
        <source>link %1 Hz · ≤ %2</source>
        <translation>spoj %1 Hz · ≤ %2</translation>
    </message>
    <message>
        <source> · %1 dropped</source>
        <translation> · %1 ztraceno</translation>
    </message>
    <message>
        <source>%1
%2 frames/s, %3
%4 frames dropped by this computer, %5 error frames</source>
        <translation>%1
%2 rámců/s, %3
%4 rámců ztratil tento počítač, %5 chybových rámců</translation>
    </message>
    <message>
        <source>robot: --</source>
        <translation>robot: --</translation>
    </message>
    <message>
        <source>the robot is armed</source>
        <translation>robot je aktivní</translation>
    </message>
    <message>
        <source>not armed: %1</source>
        <translation>není aktivní: %1</translation>
    </message>
    <message>
        <source>log</source>
        <translation>záznam</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>sběrnice</translation>
    </message>
    <message>
        <source>! %1 dropped</source>
        <translation>! ztraceno %1</translation>
    </message>
    <message>
        <source>! %1 errors</source>
        <translation>! chyb %1</translation>
    </message>
    <message>
        <source>%1 dropped</source>
        <translation>ztraceno %1</translation>
    </message>
    <message>
        <source>%1 errors</source>
        <translation>chyb %1</translation>
    </message>
    <message>
        <source>back, not steady yet</source>
        <translation>zpět, ještě ne stálé</translation>
    </message>
    <message>
        <source>%1 — gaps: %2, the longest %3; values read -- during a gap</source>
        <translation>%1 — výpadky: %2, nejdelší %3; v každém z nich je místo hodnot --</translation>
    </message>
    <message>
        <source>%1 for %2 — %3; no measured value is live%4</source>
        <translation>%1 už %2 — %3; žádná naměřená hodnota není živá%4</translation>
    </message>
    <message>
        <source>%1 for %2 — nothing on this screen is live%3</source>
        <translation>%1 už %2 — nic na obrazovce není živé%3</translation>
    </message>
    <message>
        <source>%1; gaps before: %2, the longest %3</source>
        <translation>%1; předtím výpadky: %2, nejdelší %3</translation>
    </message>
    <message>
        <source>disarmed: %1</source>
        <translation>už není aktivní: %1</translation>
    </message>
    <message>
        <source>link ≤ %1</source>
        <translation>spoj ≤ %1</translation>
    </message>
    <message>
        <source>LINK RESTORED after %1 — values are live; the terrain predates the gap</source>
        <translation>SPOJENÍ ZPĚT po %1 — hodnoty jsou živé, terén je z doby předtím</translation>
    </message>
</context>
<context>
    <name>LiveViewState</name>
    <message>
        <source>The operator&apos;s panel does not answer: STOP is asserted</source>
        <translation>Panel operátora neodpovídá, což znamená STOP</translation>
    </message>
    <message>
        <source>The operator&apos;s panel does not answer</source>
        <translation>Panel operátora neodpovídá</translation>
    </message>
</context>
<context>
    <name>MeasuredLine</name>
    <message>
        <source>%1 apart · rise and slope unknown: not felt</source>
        <translation>vzdálenost %1 · převýšení a sklon neznámé: neohmatáno</translation>
    </message>
    <message>
        <source>%1 apart · rise %2 · slope %3</source>
        <translation>vzdálenost %1 · převýšení %2 · sklon %3</translation>
    </message>
    <message>
        <source>rear</source>
        <translation>vzadu</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vpředu</translation>
    </message>
</context>
<context>
    <name>MethodText</name>
    <message>
        <source>uses pitch and flipper angles; Markov chains</source>
        <translation>užívá sklon a úhly flipperů; Markovovy řetězce</translation>
    </message>
    <message>
        <source>uses pitch, flipper angles and body; Markov chains</source>
        <translation>užívá sklon, úhly flipperů a tělo robota; Markovovy řetězce</translation>
    </message>
    <message>
        <source>uses what pac uses, forces and currents; Markov chains</source>
        <translation>užívá totéž co pac, síly a proudy; Markovovy řetězce</translation>
    </message>
    <message>
        <source>uses what pafc uses, and the arm; Markov chains</source>
        <translation>užívá totéž co pafc a rameno; Markovovy řetězce</translation>
    </message>
    <message>
        <source>uses what pafc uses, and models the clearance; Markov chains</source>
        <translation>užívá totéž co pafc a modeluje světlost; Markovovy řetězce</translation>
    </message>
    <message>
        <source>uses pose, forces, currents and clearance; closed form</source>
        <translation>užívá polohu, síly, proudy a světlost; uzavřený vzorec</translation>
    </message>
    <message>
        <source>uses what joint uses, and the most similar scenes; closed form</source>
        <translation>užívá totéž co joint a nejpodobnější scény; uzavřený vzorec</translation>
    </message>
    <message>
        <source>uses what local uses, and the way before; closed form</source>
        <translation>užívá totéž co local a předchozí cestu; uzavřený vzorec</translation>
    </message>
</context>
<context>
    <name>ModelWords</name>
    <message>
        <source>unknown</source>
        <translation>neznámo</translation>
    </message>
    <message>
        <source>trained %1; ground: %2</source>
        <translation>naučen %1; terén: %2</translation>
    </message>
    <message>
        <source>%1 scenes, %2 % with a step above %3; median relief %4</source>
        <translation>%1 scén, %2 % z nich se schodem nad %3; medián převýšení %4</translation>
    </message>
    <message>
        <source>%1: mean error %2 mm, the 80 % band holds %3 % – %4 scenes of %5, %6</source>
        <translation>%1: průměrná chyba %2 mm, v pásmu 80 % leží %3 % – %4 scén z %5, %6</translation>
    </message>
    <message>
        <source> – the scenes it was trained on</source>
        <translation> – scény, na kterých se učil</translation>
    </message>
    <message>
        <source>never evaluated: its errors are unknown</source>
        <translation>nikdy nevyhodnocen: chyby nejsou známy</translation>
    </message>
    <message>
        <source>its card is not used: %1</source>
        <translation>jeho karta se nepoužije: %1</translation>
    </message>
    <message>
        <source>content %1; scenes %2</source>
        <translation>obsah %1; scény %2</translation>
    </message>
    <message>
        <source>made by: %1</source>
        <translation>vytvořen: %1</translation>
    </message>
    <message>
        <source> – %1 of them are training scenes or near copies</source>
        <translation> – %1 z nich jsou trénovací scény nebo jejich téměř shodné kopie</translation>
    </message>
</context>
<context>
    <name>OpenConsole</name>
    <message>
        <source>not connected: %1</source>
        <translation>nepřipojeno: %1</translation>
    </message>
    <message>
        <source>%1. The former connection failed, too: %2. This is the simulated robot</source>
        <translation>%1. Selhalo i předchozí připojení: %2. Toto je simulovaný robot</translation>
    </message>
</context>
<context>
    <name>OpenFile</name>
    <message>
        <source>Open</source>
        <translation>Otevřít</translation>
    </message>
    <message>
        <source>%1 could not be opened: a second window could not be started</source>
        <translation>%1 nelze otevřít: program se nepodařilo znovu spustit</translation>
    </message>
    <message>
        <source>Sessions, logs, scenes, truth files and recordings of other programs (*.tts *.log *.asc *.trc *.csv *.gz *.truth *.mcap *.bag *.db3);;All files (*)</source>
        <translation>Relace, záznamy sběrnice, scény, soubory skutečnosti a záznamy jiných programů (*.tts *.log *.asc *.trc *.csv *.gz *.truth *.mcap *.bag *.db3);;Všechny soubory (*)</translation>
    </message>
</context>
<context>
    <name>PadText</name>
    <message>
        <source>A (lower)</source>
        <translation>A (dole)</translation>
    </message>
    <message>
        <source>B (right)</source>
        <translation>B (vpravo)</translation>
    </message>
    <message>
        <source>X (left)</source>
        <translation>X (vlevo)</translation>
    </message>
    <message>
        <source>Y (upper)</source>
        <translation>Y (nahoře)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>tlačítko Back</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>tlačítko Guide</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>tlačítko Start</translation>
    </message>
    <message>
        <source>left stick, pressed</source>
        <translation>levá páčka, stisknutá</translation>
    </message>
    <message>
        <source>right stick, pressed</source>
        <translation>pravá páčka, stisknutá</translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation>levé horní tlačítko</translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation>pravé horní tlačítko</translation>
    </message>
    <message>
        <source>cross, up</source>
        <translation>kříž, nahoru</translation>
    </message>
    <message>
        <source>cross, down</source>
        <translation>kříž, dolů</translation>
    </message>
    <message>
        <source>cross, left</source>
        <translation>kříž, vlevo</translation>
    </message>
    <message>
        <source>cross, right</source>
        <translation>kříž, vpravo</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>STOP, second control</source>
        <translation>STOP, druhý prvek</translation>
    </message>
    <message>
        <source>dead-man control (hold)</source>
        <translation>spínač bdělosti (držet)</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>jízda</translation>
    </message>
    <message>
        <source>feel forward (hold)</source>
        <translation>hmatat vpřed (držet)</translation>
    </message>
    <message>
        <source>explore</source>
        <translation>prozkoumat</translation>
    </message>
    <message>
        <source>approve the probe (hold)</source>
        <translation>schválit sondu (držet)</translation>
    </message>
    <message>
        <source>refuse the probe</source>
        <translation>odmítnout sondu</translation>
    </message>
    <message>
        <source>raise the step limit</source>
        <translation>zvýšit mez schodu</translation>
    </message>
    <message>
        <source>lower the step limit</source>
        <translation>snížit mez schodu</translation>
    </message>
    <message>
        <source>dead-man</source>
        <translation>bdělost</translation>
    </message>
    <message>
        <source>feel forward</source>
        <translation>hmatat vpřed</translation>
    </message>
    <message>
        <source>approve</source>
        <translation>schválit</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>odmítnout</translation>
    </message>
    <message>
        <source>limit up</source>
        <translation>mez výš</translation>
    </message>
    <message>
        <source>limit down</source>
        <translation>mez níž</translation>
    </message>
    <message>
        <source>left stick, sideways</source>
        <translation>levá páčka, do stran</translation>
    </message>
    <message>
        <source>left stick, up and down</source>
        <translation>levá páčka, nahoru a dolů</translation>
    </message>
    <message>
        <source>right stick, sideways</source>
        <translation>pravá páčka, do stran</translation>
    </message>
    <message>
        <source>right stick, up and down</source>
        <translation>pravá páčka, nahoru a dolů</translation>
    </message>
    <message>
        <source>left trigger</source>
        <translation>levá spoušť</translation>
    </message>
    <message>
        <source>right trigger</source>
        <translation>pravá spoušť</translation>
    </message>
</context>
<context>
    <name>PastText</name>
    <message>
        <source>no verdict</source>
        <translation>bez verdiktu</translation>
    </message>
    <message>
        <source>%1 for steps above %2</source>
        <translation>%1 pro schody nad %2</translation>
    </message>
    <message>
        <source>%1 for steps above %2 (left %3, right %4)</source>
        <translation>%1 pro schody nad %2 (vlevo %3, vpravo %4)</translation>
    </message>
    <message>
        <source>press and probe, method %1</source>
        <translation>přitlačení a sonda, metoda %1</translation>
    </message>
    <message>
        <source>press, method %1</source>
        <translation>přitlačení, metoda %1</translation>
    </message>
    <message>
        <source>error %1 against the truth</source>
        <translation>chyba %1 proti skutečnosti</translation>
    </message>
    <message>
        <source>error left %1, right %2 against the truth</source>
        <translation>chyba vlevo %1, vpravo %2 proti skutečnosti</translation>
    </message>
    <message>
        <source>error %1 %2, measured later by the arm</source>
        <translation>chyba %1 %2, později změřeno ramenem</translation>
    </message>
    <message>
        <source>error not known</source>
        <translation>chyba není známa</translation>
    </message>
    <message>
        <source>shown: estimate of %1, not the present one</source>
        <translation>zobrazen odhad z %1, ne současný</translation>
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
        <translation>P</translation>
    </message>
    <message>
        <source>left</source>
        <translation>vlevo</translation>
    </message>
    <message>
        <source>right</source>
        <translation>vpravo</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>v %1</translation>
    </message>
    <message>
        <source>left at %1</source>
        <translation>vlevo v %1</translation>
    </message>
    <message>
        <source>right at %1</source>
        <translation>vpravo v %1</translation>
    </message>
    <message>
        <source>bin %1</source>
        <translation>bod %1</translation>
    </message>
    <message>
        <source>left bin %1</source>
        <translation>levý bod %1</translation>
    </message>
    <message>
        <source>right bin %1</source>
        <translation>pravý bod %1</translation>
    </message>
</context>
<context>
    <name>PlanarGround</name>
    <message>
        <source>roll %1: left and right ground differ</source>
        <translation>náklon %1: terén vlevo a vpravo se liší</translation>
    </message>
    <message>
        <source>left and right flippers differ by %1</source>
        <translation>levý a pravý flipper se liší o %1</translation>
    </message>
    <message>
        <source>left and right agree, roll is small</source>
        <translation>vlevo i vpravo stejně, náklon malý</translation>
    </message>
    <message>
        <source>the roll is small again</source>
        <translation>náklon je zase malý</translation>
    </message>
    <message>
        <source>left and right flippers agree again</source>
        <translation>levý a pravý flipper zase souhlasí</translation>
    </message>
    <message>
        <source>%1, more than what was overridden</source>
        <translation>%1, víc, než co bylo přebito</translation>
    </message>
    <message>
        <source>the track differential has turned by %1</source>
        <translation>diferenciál pásů je pootočen o %1</translation>
    </message>
    <message>
        <source>the track differential is back</source>
        <translation>diferenciál pásů je zpět</translation>
    </message>
</context>
<context>
    <name>Preconditions</name>
    <message>
        <source>telemetry is live</source>
        <translation>telemetrie běží</translation>
    </message>
    <message>
        <source>the log has ended</source>
        <translation>záznam skončil</translation>
    </message>
    <message>
        <source>no telemetry from the robot</source>
        <translation>žádná telemetrie z robota</translation>
    </message>
    <message>
        <source>STOP is not latched</source>
        <translation>STOP nedrží</translation>
    </message>
    <message>
        <source>STOP: release sent, not yet confirmed by the robot</source>
        <translation>STOP: uvolnění odesláno, robot ještě nepotvrdil</translation>
    </message>
    <message>
        <source>STOP is latched</source>
        <translation>STOP drží</translation>
    </message>
    <message>
        <source>the robot is armed</source>
        <translation>robot je aktivní</translation>
    </message>
    <message>
        <source>no model: %1</source>
        <translation>bez modelu: %1</translation>
    </message>
    <message>
        <source>the model is being loaded</source>
        <translation>model se načítá</translation>
    </message>
    <message>
        <source>model %1 is ready</source>
        <translation>model %1 je připraven</translation>
    </message>
    <message>
        <source>STOP is latched: release it first</source>
        <translation>STOP drží: nejdřív ho uvolněte</translation>
    </message>
    <message>
        <source>An exploration is running: end it with Esc first</source>
        <translation>Běží průzkum: nejdřív ho ukončete klávesou Esc</translation>
    </message>
    <message>
        <source>nothing is being explored</source>
        <translation>nic se nezkoumá</translation>
    </message>
    <message>
        <source>scene, settings and model are unchanged since the question</source>
        <translation>scéna, nastavení a model jsou ty z otázky</translation>
    </message>
    <message>
        <source>scene, settings or model have changed since the question</source>
        <translation>scéna, nastavení nebo model se od otázky změnily</translation>
    </message>
    <message>
        <source>the robot reports stopped</source>
        <translation>robot hlásí, že je zastaven</translation>
    </message>
    <message>
        <source>the robot has not confirmed STOP</source>
        <translation>robot STOP nepotvrdil</translation>
    </message>
    <message>
        <source>there is no STOP to release</source>
        <translation>není žádný STOP k uvolnění</translation>
    </message>
    <message>
        <source>STOP: not known, no telemetry</source>
        <translation>STOP: není známo, bez telemetrie</translation>
    </message>
    <message>
        <source>left, right: not known, no telemetry</source>
        <translation>vlevo, vpravo: není známo, bez telemetrie</translation>
    </message>
    <message>
        <source>the robot reported stopped, then telemetry ended</source>
        <translation>robot hlásil, že stojí, pak telemetrie ustala</translation>
    </message>
    <message>
        <source>the link was lost, the robot may have moved: explore again</source>
        <translation>spojení bylo ztraceno, robot se mohl pohnout: prozkoumejte znovu</translation>
    </message>
    <message>
        <source>No probe: the pitch may be wrong, and the arm would touch another place</source>
        <translation>Bez sondy: podélný sklon nemusí být správný a rameno by se dotklo jiného místa</translation>
    </message>
    <message>
        <source>the arm is still out: wait until it is back, or press STOP</source>
        <translation>rameno je ještě venku: počkejte na jeho návrat, nebo stiskněte STOP</translation>
    </message>
    <message>
        <source>pitch or roll is beyond the tip-over angle: bring the robot back onto its tracks first</source>
        <translation>sklon nebo náklon je za úhlem převrácení: nejprve vraťte robota na pásy</translation>
    </message>
    <message>
        <source>left and right are estimated separately</source>
        <translation>vlevo a vpravo se odhaduje zvlášť</translation>
    </message>
    <message>
        <source>the robot reports odometry</source>
        <translation>robot hlásí odometrii</translation>
    </message>
    <message>
        <source>the robot reports no odometry</source>
        <translation>robot nehlásí odometrii</translation>
    </message>
    <message>
        <source>no open question</source>
        <translation>žádná otevřená otázka</translation>
    </message>
</context>
<context>
    <name>PreferenceText</name>
    <message>
        <source>theme</source>
        <translation>barvy</translation>
    </message>
    <message>
        <source>size of text</source>
        <translation>velikost písma</translation>
    </message>
    <message>
        <source>language</source>
        <translation>jazyk</translation>
    </message>
    <message>
        <source>layout</source>
        <translation>rozvržení</translation>
    </message>
    <message>
        <source>alarms may be heard</source>
        <translation>zvuk alarmů</translation>
    </message>
    <message>
        <source>sound of contacts</source>
        <translation>zvuk kontaktů</translation>
    </message>
    <message>
        <source>step limit</source>
        <translation>mez schodu</translation>
    </message>
    <message>
        <source>method</source>
        <translation>metoda</translation>
    </message>
    <message>
        <source>quality</source>
        <translation>kvalita</translation>
    </message>
    <message>
        <source>time limit of an estimate</source>
        <translation>časová mez odhadu</translation>
    </message>
    <message>
        <source>contact force</source>
        <translation>síla kontaktu</translation>
    </message>
    <message>
        <source>the arm is offered</source>
        <translation>rameno se nabízí</translation>
    </message>
    <message>
        <source>the arm is offered above a sd of</source>
        <translation>rameno se nabízí od sd</translation>
    </message>
    <message>
        <source>roll limit of the verdict</source>
        <translation>mez náklonu pro verdikt</translation>
    </message>
    <message>
        <source>rate of hazards</source>
        <translation>četnost nebezpečí</translation>
    </message>
    <message>
        <source>flipper difference limit of the verdict</source>
        <translation>mez rozdílu flipperů pro verdikt</translation>
    </message>
    <message>
        <source>tilt limit, amber</source>
        <translation>mez náklonu, žlutá</translation>
    </message>
    <message>
        <source>tilt limit, red</source>
        <translation>mez náklonu, červená</translation>
    </message>
    <message>
        <source>everything is recorded</source>
        <translation>vše se zaznamenává</translation>
    </message>
    <message>
        <source>delete a session after</source>
        <translation>smazat relaci po</translation>
    </message>
    <message>
        <source>delete the oldest beyond</source>
        <translation>mazat nejstarší nad</translation>
    </message>
    <message>
        <source>sessions may be deleted</source>
        <translation>relace se smějí mazat</translation>
    </message>
    <message>
        <source>model file</source>
        <translation>soubor modelu</translation>
    </message>
    <message>
        <source>robot file, with its torques</source>
        <translation>soubor robota s jeho momenty</translation>
    </message>
    <message>
        <source>DBC files</source>
        <translation>soubory DBC</translation>
    </message>
    <message>
        <source>controls of the gamepad</source>
        <translation>prvky gamepadu</translation>
    </message>
    <message>
        <source>dead zone of the gamepad</source>
        <translation>mrtvá zóna gamepadu</translation>
    </message>
    <message>
        <source>speed limit of the gamepad</source>
        <translation>mez rychlosti gamepadu</translation>
    </message>
    <message>
        <source>saved sets of plots</source>
        <translation>uložené sady grafů</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ano</translation>
    </message>
    <message>
        <source>no</source>
        <translation>ne</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nic</translation>
    </message>
    <message>
        <source>%1, forward −</source>
        <translation>%1, vpřed −</translation>
    </message>
    <message>
        <source>%1, forward +</source>
        <translation>%1, vpřed +</translation>
    </message>
    <message>
        <source>gamepad: %1</source>
        <translation>gamepad: %1</translation>
    </message>
    <message>
        <source>unit of lengths</source>
        <translation>jednotka délek</translation>
    </message>
    <message>
        <source>unit of angles</source>
        <translation>jednotka úhlů</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>Preferences: %1; the shipped robot is used</source>
        <translation>Nastavení: %1; použije se dodaný robot</translation>
    </message>
    <message>
        <source>Preferences: “%1” is no valid %2, its default is used</source>
        <translation>Nastavení: „%1“ není platná hodnota %2, použije se výchozí</translation>
    </message>
    <message>
        <source>Preferences: %1; the file is set aside as %2, defaults are used</source>
        <translation>Nastavení: %1; soubor je odložen jako %2, platí výchozí hodnoty</translation>
    </message>
    <message>
        <source>Preferences: %1; defaults are used and nothing is saved</source>
        <translation>Nastavení: %1; platí výchozí hodnoty a nic se neuloží</translation>
    </message>
    <message>
        <source>Preferences: %1 is no file; defaults are used and nothing is saved</source>
        <translation>Nastavení: %1 není soubor; platí výchozí hodnoty a nic se neuloží</translation>
    </message>
    <message>
        <source>Preferences: %1 cannot be read; defaults are used and nothing is saved</source>
        <translation>Nastavení: %1 nelze přečíst; platí výchozí hodnoty a nic se neuloží</translation>
    </message>
    <message>
        <source>%1 is too large</source>
        <translation>%1 je příliš velký</translation>
    </message>
    <message>
        <source>%1 is not understood</source>
        <translation>%1 je nesrozumitelný</translation>
    </message>
    <message>
        <source>Preferences: %1 was written by a newer version; defaults are used and nothing is saved</source>
        <translation>Nastavení: %1 zapsala novější verze; platí výchozí hodnoty a nic se neuloží</translation>
    </message>
    <message>
        <source>Preferences: %1 cannot be written</source>
        <translation>Nastavení: %1 nelze zapsat</translation>
    </message>
    <message>
        <source>Preferences: %1 cannot be read; the shipped model is used</source>
        <translation>Nastavení: %1 nelze přečíst; použije se dodaný model</translation>
    </message>
    <message>
        <source>Preferences: %1; nothing is saved</source>
        <translation>Nastavení: %1; nic se neukládá</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>číslo od %1 do %2</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>jedno z %1</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true nebo false</translation>
    </message>
    <message>
        <source>en, cs, de or nothing</source>
        <translation>en, cs, de nebo nic</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>cesta k souboru</translation>
    </message>
    <message>
        <source>paths of at most %1 files</source>
        <translation>cesty k nejvýše %1 souborům</translation>
    </message>
    <message>
        <source>controls of a gamepad as this program writes them</source>
        <translation>prvky gamepadu, jak je zapisuje tento program</translation>
    </message>
    <message>
        <source>at most %1 lines</source>
        <translation>nejvýše %1 řádků</translation>
    </message>
    <message>
        <source>a window geometry in base64</source>
        <translation>rozměry okna v base64</translation>
    </message>
    <message>
        <source>a setting of this version</source>
        <translation>nastavení této verze</translation>
    </message>
    <message>
        <source>Preferences: method is now %1, the default; before, it was %2</source>
        <translation>Nastavení: metoda je nyní %1, výchozí; předtím byla %2</translation>
    </message>
    <message>
        <source>Preferences: there is no home folder to save them in: set HOME or XDG_CONFIG_HOME</source>
        <translation>Nastavení: není domovská složka, kam je uložit: nastavte HOME nebo XDG_CONFIG_HOME</translation>
    </message>
</context>
<context>
    <name>PresetWords</name>
    <message>
        <source>%1: not measured (terratact tradeoff)</source>
        <translation>%1: neměřeno (terratact tradeoff)</translation>
    </message>
    <message>
        <source>%1: %2 ms, exact quantiles by a formula, mean error %3 mm</source>
        <translation>%1: %2 ms, přesné kvantily podle vzorce, průměrná chyba %3 mm</translation>
    </message>
    <message>
        <source>%1: %2 ms, quantiles ± %3 mm from a long run, mean error %4 mm; chains converge in %5 % of scenes, and only these have a verdict</source>
        <translation>%1: %2 ms, kvantily ± %3 mm od dlouhého běhu, průměrná chyba %4 mm; řetězce konvergují v %5 % scén, bez toho není verdikt</translation>
    </message>
    <message>
        <source>%1: not measured</source>
        <translation>%1: neměřeno</translation>
    </message>
    <message>
        <source>%1: %2 ms, %3 mm (exact)</source>
        <translation>%1: %2 ms, %3 mm (přesně)</translation>
    </message>
    <message>
        <source>%1: %2 ms, %3 mm (± %4 mm), %5 % converge</source>
        <translation>%1: %2 ms, %3 mm (± %4 mm), %5 % konverguje</translation>
    </message>
</context>
<context>
    <name>ProbeNotice</name>
    <message>
        <source>arm? %1</source>
        <translation>sonda? %1</translation>
    </message>
    <message>
        <source>PROBE at %1? Refused in %2 unless approved: F2 shows the question</source>
        <translation>SONDA na %1? Zbývá %2, pak ne: otázku ukáže F2</translation>
    </message>
    <message>
        <source>The probe was not answered in time and counts as refused: F2 shows the result</source>
        <translation>Na sondu nikdo včas neodpověděl, což znamená ne: výsledek ukáže F2</translation>
    </message>
    <message>
        <source>PROBE at %1? Refused in %2 unless approved: close the window that covers it</source>
        <translation>SONDA na %1? Zbývá %2, pak ne: zavřete okno, které otázku zakrývá</translation>
    </message>
    <message>
        <source>The probe was not answered in time and counts as refused: close the window that covers the result</source>
        <translation>Na sondu nikdo včas neodpověděl, což znamená ne: zavřete okno, které výsledek zakrývá</translation>
    </message>
    <message>
        <source>halting</source>
        <translation>zastavuje</translation>
    </message>
    <message>
        <source>pressing</source>
        <translation>přitlačuje</translation>
    </message>
    <message>
        <source>estimating</source>
        <translation>odhaduje</translation>
    </message>
    <message>
        <source>probe</source>
        <translation>sonda</translation>
    </message>
    <message>
        <source>result</source>
        <translation>výsledek</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>selhalo</translation>
    </message>
    <message>
        <source>arm: void</source>
        <translation>rameno: neplatí</translation>
    </message>
    <message>
        <source>The proposed probe is void: F2 shows the reason</source>
        <translation>Navržená sonda neplatí: F2 ukáže důvod</translation>
    </message>
    <message>
        <source>advancing</source>
        <translation>postupuje vpřed</translation>
    </message>
</context>
<context>
    <name>ProbeProposals</name>
    <message>
        <source>no probe: the arm measures no height</source>
        <translation>bez sondy: rameno neměří výšku</translation>
    </message>
    <message>
        <source>the gain of a probe is being computed</source>
        <translation>zisk sondy se počítá</translation>
    </message>
    <message>
        <source>no probe: no bin in reach is left</source>
        <translation>bez sondy: v dosahu nezbývá žádný bod</translation>
    </message>
</context>
<context>
    <name>RecordingDisplay</name>
    <message>
        <source>NOT RECORDED: %1</source>
        <translation>NEZAZNAMENÁVÁ SE: %1</translation>
    </message>
    <message>
        <source>Recorded: %1
%2 frames, %3 MB; %4 frames dropped
A click marks this moment (K)</source>
        <translation>Zaznamenává se: %1
%2 rámců, %3 MB; ztraceno rámců: %4
Kliknutí označí tento okamžik (K)</translation>
    </message>
    <message>
        <source>Nothing is recorded</source>
        <translation>Nic se nezaznamenává</translation>
    </message>
    <message>
        <source>✕ NOT
RECORDED</source>
        <translation>✕ BEZ
ZÁZNAMU</translation>
    </message>
    <message>
        <source>○ not
recorded</source>
        <translation>○ bez
záznamu</translation>
    </message>
    <message>
        <source>● REC
mark K</source>
        <translation>● REC
značka K</translation>
    </message>
    <message>
        <source>Not recorded</source>
        <translation>Nezaznamenává se</translation>
    </message>
    <message>
        <source>Recording; mark this moment</source>
        <translation>Zaznamenává se; označit tento okamžik</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>page %1 of %2</source>
        <translation>strana %1 z %2</translation>
    </message>
    <message>
        <source>en</source>
        <translation>cs</translation>
    </message>
    <message>
        <source>error against the truth: %1 m rms, %2 m at %3 m, %4 of %5 bins in their band</source>
        <translation>chyba proti skutečnosti: %1 m (střední kvadratická), %2 m v %3 m, %4 z %5 bodů ve svém pásu</translation>
    </message>
    <message>
        <source>%1. Left: %2. Right: %3. Either side: %4 %. Cross slope: %5</source>
        <translation>%1. Vlevo: %2. Vpravo: %3. Kterákoli strana: %4 %. Příčný sklon: %5</translation>
    </message>
    <message>
        <source>estimate %1 of scene %2 (second method)</source>
        <translation>odhad %1 scény %2 (druhá metoda)</translation>
    </message>
    <message>
        <source>estimate %1 of scene %2 (with the reading of the arm)</source>
        <translation>odhad %1 scény %2 (s měřením ramene)</translation>
    </message>
    <message>
        <source>estimate %1 of scene %2</source>
        <translation>odhad %1 scény %2</translation>
    </message>
    <message>
        <source>no verdict: its scene is damaged</source>
        <translation>bez verdiktu: scéna je poškozená</translation>
    </message>
    <message>
        <source>method %1, %2 s</source>
        <translation>metoda %1, %2 s</translation>
    </message>
    <message>
        <source>arm: %1</source>
        <translation>rameno: %1</translation>
    </message>
    <message>
        <source>bin %1 m left</source>
        <translation>bod %1 m vlevo</translation>
    </message>
    <message>
        <source>bin %1 m right</source>
        <translation>bod %1 m vpravo</translation>
    </message>
    <message>
        <source>bin %1 m</source>
        <translation>bod %1 m</translation>
    </message>
    <message>
        <source>%1: height %2 m, %3 m … %4 m, sd %5 m above the threshold %6 m</source>
        <translation>%1: výška %2 m, %3 m … %4 m, směr. odch. %5 m nad prahem %6 m</translation>
    </message>
    <message>
        <source>arm sd %1 m</source>
        <translation>směr. odch. ramene %1 m</translation>
    </message>
    <message>
        <source>takes %1 s</source>
        <translation>trvá %1 s</translation>
    </message>
    <message>
        <source>step above %1 m: %2 bit open, %3 bit after it</source>
        <translation>schod nad %1 m: %2 bit nejisté, poté %3 bit</translation>
    </message>
    <message>
        <source>step above %1 m: %2 bit open</source>
        <translation>schod nad %1 m: %2 bit nejisté</translation>
    </message>
    <message>
        <source>probe proposed on estimate %1</source>
        <translation>sonda navržena k odhadu %1</translation>
    </message>
    <message>
        <source>message</source>
        <translation>zpráva</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>operátor</translation>
    </message>
    <message>
        <source>exploration</source>
        <translation>průzkum</translation>
    </message>
    <message>
        <source>arming</source>
        <translation>aktivace</translation>
    </message>
    <message>
        <source>link</source>
        <translation>spojení</translation>
    </message>
    <message>
        <source>estimate void</source>
        <translation>odhad zanikl</translation>
    </message>
    <message>
        <source>telemetry gap</source>
        <translation>bez telemetrie</translation>
    </message>
    <message>
        <source>override</source>
        <translation>přebití</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>alarm</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>panel</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>značka</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>mezera</translation>
    </message>
    <message>
        <source>session</source>
        <translation>relace</translation>
    </message>
    <message>
        <source>contact closed</source>
        <translation>kontakt sepnut</translation>
    </message>
    <message>
        <source>contact open</source>
        <translation>kontakt rozepnut</translation>
    </message>
    <message>
        <source>longest gap %1 s</source>
        <translation>nejdelší výpadek %1 s</translation>
    </message>
    <message>
        <source>proposal %1</source>
        <translation>návrh %1</translation>
    </message>
    <message>
        <source>on the screen: %1</source>
        <translation>na obrazovce: %1</translation>
    </message>
    <message>
        <source>… and %1 more in the session</source>
        <translation>… a dalších %1 v relaci</translation>
    </message>
    <message>
        <source>Decisions and their numbers</source>
        <translation>Rozhodnutí a jejich čísla</translation>
    </message>
    <message>
        <source>Nothing was estimated and nobody decided anything.</source>
        <translation>Nic nebylo odhadnuto a nikdo o ničem nerozhodl.</translation>
    </message>
    <message>
        <source>since start</source>
        <translation>od začátku</translation>
    </message>
    <message>
        <source>what</source>
        <translation>co</translation>
    </message>
    <message>
        <source>numbers</source>
        <translation>čísla</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmy</translation>
    </message>
    <message>
        <source>No alarm was raised.</source>
        <translation>Žádný alarm nenastal.</translation>
    </message>
    <message>
        <source>raised</source>
        <translation>vznik</translation>
    </message>
    <message>
        <source>acknowledged</source>
        <translation>potvrzení</translation>
    </message>
    <message>
        <source>cause gone</source>
        <translation>konec příčiny</translation>
    </message>
    <message>
        <source>text</source>
        <translation>text</translation>
    </message>
    <message>
        <source>before the session</source>
        <translation>před relací</translation>
    </message>
    <message>
        <source>no</source>
        <translation>ne</translation>
    </message>
    <message>
        <source>Active settings</source>
        <translation>Platná nastavení</translation>
    </message>
    <message>
        <source>Settings of the estimates, from each change on. Other settings are recorded as decisions.</source>
        <translation>Nastavení odhadů, vždy od jejich změny. Jiná nastavení jsou zapsána jako rozhodnutí.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>od</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>odhad</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>nastavení</translation>
    </message>
    <message>
        <source>%1, step limit %2 m</source>
        <translation>%1, mez schodu %2 m</translation>
    </message>
    <message>
        <source>%1 (second)</source>
        <translation>%1 (druhý)</translation>
    </message>
    <message>
        <source>Nothing was estimated, so no settings are recorded.</source>
        <translation>Nic nebylo odhadnuto, a tak nejsou zapsána žádná nastavení.</translation>
    </message>
    <message>
        <source>nothing was estimated</source>
        <translation>nic nebylo odhadnuto</translation>
    </message>
    <message>
        <source>%1 %2 (median %3 s)</source>
        <translation>%1 %2 (medián %3 s)</translation>
    </message>
    <message>
        <source>%1, bus %2, commands could be sent</source>
        <translation>%1, sběrnice %2, povely bylo možné posílat</translation>
    </message>
    <message>
        <source>%1, bus %2, listened only</source>
        <translation>%1, sběrnice %2, jen poslech</translation>
    </message>
    <message>
        <source>decisions %1, of these stop %2, halt %3, abort %4; markers %5</source>
        <translation>rozhodnutí %1, z toho stop %2, zastavení %3, přerušení %4; značek %5</translation>
    </message>
    <message>
        <source>The session</source>
        <translation>Relace</translation>
    </message>
    <message>
        <source>file</source>
        <translation>soubor</translation>
    </message>
    <message>
        <source>begins</source>
        <translation>začátek</translation>
    </message>
    <message>
        <source>ends</source>
        <translation>konec</translation>
    </message>
    <message>
        <source>lasts</source>
        <translation>trvání</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>source</source>
        <translation>zdroj</translation>
    </message>
    <message>
        <source>recorded by</source>
        <translation>zaznamenal</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>uzavřena</translation>
    </message>
    <message>
        <source>yes, sealed</source>
        <translation>ano, zapečetěna</translation>
    </message>
    <message>
        <source>NO: still being recorded, or its program died</source>
        <translation>NE: ještě se zaznamenává, nebo program spadl</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>rámce</translation>
    </message>
    <message>
        <source>estimates</source>
        <translation>odhady</translation>
    </message>
    <message>
        <source>%1 (scenes: %2); by method: %3</source>
        <translation>%1 (scén: %2); podle metody: %3</translation>
    </message>
    <message>
        <source>probes</source>
        <translation>sondy</translation>
    </message>
    <message>
        <source>proposed %1, approved %2, refused %3</source>
        <translation>navrženo %1, schváleno %2, odmítnuto %3</translation>
    </message>
    <message>
        <source>Hashes</source>
        <translation>Otisky</translation>
    </message>
    <message>
        <source>Each hash is SHA-256. The last link of the chain proves the session if it is known from elsewhere.</source>
        <translation>Každý otisk je SHA-256. Poslední článek řetězu dokazuje relaci, je-li znám odjinud.</translation>
    </message>
    <message>
        <source>result</source>
        <translation>výsledek</translation>
    </message>
    <message>
        <source>every hash holds: %1 batches, %2 frames, %3 events</source>
        <translation>všechny otisky souhlasí: %1 dávek, %2 rámců, %3 událostí</translation>
    </message>
    <message>
        <source>PARTS ARE NOT WHAT WAS RECORDED</source>
        <translation>ČÁSTI NEJSOU TÍM, CO BYLO ZAZNAMENÁNO</translation>
    </message>
    <message>
        <source>last link</source>
        <translation>poslední článek</translation>
    </message>
    <message>
        <source>robot file</source>
        <translation>soubor robota</translation>
    </message>
    <message>
        <source>model</source>
        <translation>model</translation>
    </message>
    <message>
        <source>%1, %2, from %3 on</source>
        <translation>%1, %2, od %3</translation>
    </message>
    <message>
        <source>networks</source>
        <translation>sítě</translation>
    </message>
    <message>
        <source>broken</source>
        <translation>přerušeno</translation>
    </message>
    <message>
        <source>nothing is proven from %1</source>
        <translation>nic není dokázáno od %1</translation>
    </message>
    <message>
        <source>damage</source>
        <translation>poškození</translation>
    </message>
    <message>
        <source>Every hash holds.</source>
        <translation>Všechny otisky souhlasí.</translation>
    </message>
    <message>
        <source>PARTS ARE NOT WHAT WAS RECORDED: see Hashes. They are left out.</source>
        <translation>ČÁSTI NEJSOU TÍM, CO BYLO ZAZNAMENÁNO: viz Otisky. Jsou vynechány.</translation>
    </message>
    <message>
        <source>The session was not closed.</source>
        <translation>Relace nebyla uzavřena.</translation>
    </message>
    <message>
        <source>Mission report of %1</source>
        <translation>Zpráva o misi %1</translation>
    </message>
    <message>
        <source>%1 %2: %3, %4 s before</source>
        <translation>%1 %2: %3, %4 s předtím</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>bez hodnoty</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>náklad</translation>
    </message>
    <message>
        <source>method %1, %2 draws in %3 chains</source>
        <translation>metoda %1, %2 vzorků v %3 řetězcích</translation>
    </message>
    <message>
        <source>! not converged</source>
        <translation>! nezkonvergovalo</translation>
    </message>
    <message>
        <source>! (+%1 more) %2</source>
        <translation>! (+%1 dalších) %2</translation>
    </message>
    <message>
        <source>forward from the IMU [m]</source>
        <translation>vpřed od IMU [m]</translation>
    </message>
    <message>
        <source>height above the IMU [m]</source>
        <translation>výška nad IMU [m]</translation>
    </message>
    <message>
        <source>probe here</source>
        <translation>zde sonda</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>střední hodnota</translation>
    </message>
    <message>
        <source>0.1 to 0.9 quantile</source>
        <translation>kvantily 0.1 až 0.9</translation>
    </message>
    <message>
        <source>ceiling by the body</source>
        <translation>strop daný tělem</translation>
    </message>
    <message>
        <source>estimate before</source>
        <translation>předchozí odhad</translation>
    </message>
    <message>
        <source>truth</source>
        <translation>skutečnost</translation>
    </message>
    <message>
        <source>%1 m at %2 m left (sd %3 mm)</source>
        <translation>%1 m v %2 m vlevo (směr. odch. %3 mm)</translation>
    </message>
    <message>
        <source>%1 m at %2 m right (sd %3 mm)</source>
        <translation>%1 m v %2 m vpravo (směr. odch. %3 mm)</translation>
    </message>
    <message>
        <source>%1 m at %2 m (sd %3 mm)</source>
        <translation>%1 m v %2 m (směr. odch. %3 mm)</translation>
    </message>
    <message>
        <source>method %1</source>
        <translation>metoda %1</translation>
    </message>
    <message>
        <source>ceiling %1</source>
        <translation>strop %1</translation>
    </message>
    <message>
        <source>contacts %1</source>
        <translation>kontakty %1</translation>
    </message>
    <message>
        <source>contact above %1 N</source>
        <translation>kontakt nad %1 N</translation>
    </message>
    <message>
        <source>contact sd %1 m</source>
        <translation>směr. odch. kontaktu %1 m</translation>
    </message>
    <message>
        <source>at most %1 draws</source>
        <translation>nejvýše %1 vzorků</translation>
    </message>
    <message>
        <source>at most %1 draws (all)</source>
        <translation>nejvýše %1 vzorků (všechny)</translation>
    </message>
    <message>
        <source>%1 chains</source>
        <translation>řetězců %1</translation>
    </message>
    <message>
        <source>burn-in %1</source>
        <translation>záběh %1</translation>
    </message>
    <message>
        <source>scan %1</source>
        <translation>průchod %1</translation>
    </message>
    <message>
        <source>precision %1</source>
        <translation>přesnost %1</translation>
    </message>
    <message>
        <source>inducing %1</source>
        <translation>opěrné řádky %1</translation>
    </message>
    <message>
        <source>seed %1</source>
        <translation>semínko %1</translation>
    </message>
    <message>
        <source>probe above %1 m</source>
        <translation>sonda nad %1 m</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádné</translation>
    </message>
    <message>
        <source>%1: a step ahead of more than %2 m has probability %3 %</source>
        <translation>%1: schod vpředu nad %2 m má pravděpodobnost %3 %</translation>
    </message>
    <message>
        <source>%1° (left higher) at %2 m; more than %3° to a side has probability %4 %</source>
        <translation>%1° (vlevo výš) v %2 m; více než %3° na některou stranu má pravděpodobnost %4 %</translation>
    </message>
    <message>
        <source>left %1, right %2</source>
        <translation>vlevo %1, vpravo %2</translation>
    </message>
    <message>
        <source>pitch %1°, roll %2°; flippers front %3° %4°, rear %5° %6°; forces %7 N</source>
        <translation>podélný sklon %1°, náklon %2°; flippery vpředu %3° %4°, vzadu %5° %6°; síly %7 N</translation>
    </message>
    <message>
        <source>left</source>
        <translation>vlevo</translation>
    </message>
    <message>
        <source>right</source>
        <translation>vpravo</translation>
    </message>
    <message>
        <source>either side</source>
        <translation>kterákoli strana</translation>
    </message>
    <message>
        <source>a step ahead of more than %1 m has probability %2 %</source>
        <translation>schod vpředu nad %1 m má pravděpodobnost %2 %</translation>
    </message>
    <message>
        <source>cross slope</source>
        <translation>příčný sklon</translation>
    </message>
    <message>
        <source>bin [m]</source>
        <translation>bod [m]</translation>
    </message>
    <message>
        <source>height [m]</source>
        <translation>výška [m]</translation>
    </message>
    <message>
        <source>ceiling [m]</source>
        <translation>strop [m]</translation>
    </message>
    <message>
        <source>known by</source>
        <translation>známo z</translation>
    </message>
    <message>
        <source>touch</source>
        <translation>dotyk</translation>
    </message>
    <message>
        <source>side</source>
        <translation>strana</translation>
    </message>
    <message>
        <source>truth [m]</source>
        <translation>skut. [m]</translation>
    </message>
    <message>
        <source>Scene %1 of %2</source>
        <translation>Scéna %1 z %2</translation>
    </message>
    <message>
        <source>Estimate %1, %2</source>
        <translation>Odhad %1, %2</translation>
    </message>
    <message>
        <source>%1, bus %2, recorded by %3</source>
        <translation>%1, sběrnice %2, zaznamenal %3</translation>
    </message>
    <message>
        <source>captured</source>
        <translation>zachyceno</translation>
    </message>
    <message>
        <source>%1, %2 after the session&apos;s start</source>
        <translation>%1, %2 od začátku relace</translation>
    </message>
    <message>
        <source>estimated</source>
        <translation>odhadnuto</translation>
    </message>
    <message>
        <source>%1, in %2 s</source>
        <translation>%1, za %2 s</translation>
    </message>
    <message>
        <source>%1, in %2 s, sampling ended: %3</source>
        <translation>%1, za %2 s, vzorkování skončilo: %3</translation>
    </message>
    <message>
        <source>pose</source>
        <translation>poloha</translation>
    </message>
    <message>
        <source>arm</source>
        <translation>rameno</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>poškozeno</translation>
    </message>
    <message>
        <source>%1; last link of its chain %2</source>
        <translation>%1; poslední článek řetězu %2</translation>
    </message>
    <message>
        <source>every hash holds</source>
        <translation>všechny otisky souhlasí</translation>
    </message>
    <message>
        <source>warnings</source>
        <translation>varování</translation>
    </message>
    <message>
        <source>The operator decided nothing here</source>
        <translation>Operátor zde o ničem nerozhodl</translation>
    </message>
    <message>
        <source>The operator</source>
        <translation>Operátor</translation>
    </message>
    <message>
        <source>Section %1 (%2), %3 to %4 m along the way</source>
        <translation>Úsek %1 (%2), %3 až %4 m cesty</translation>
    </message>
    <message>
        <source>newest estimate; all else is remembered</source>
        <translation>nejnovější odhad; vše ostatní je zapamatováno</translation>
    </message>
    <message>
        <source>along the way [m]</source>
        <translation>podél cesty [m]</translation>
    </message>
    <message>
        <source>left, with its 80 % band</source>
        <translation>vlevo, s pásem 80 %</translation>
    </message>
    <message>
        <source>right, with its 80 % band</source>
        <translation>vpravo, s pásem 80 %</translation>
    </message>
    <message>
        <source>both sides alike, with the 80 % band</source>
        <translation>obě strany stejné, s pásem 80 %</translation>
    </message>
    <message>
        <source>touched by the arm</source>
        <translation>dotyk ramene</translation>
    </message>
    <message>
        <source>felt by flipper or track</source>
        <translation>ohmatáno flipperem nebo pásem</translation>
    </message>
    <message>
        <source>felt in part</source>
        <translation>ohmatáno zčásti</translation>
    </message>
    <message>
        <source>bounded</source>
        <translation>omezeno</translation>
    </message>
    <message>
        <source>not felt</source>
        <translation>neohmatáno</translation>
    </message>
    <message>
        <source>not recorded how</source>
        <translation>nezapsáno jak</translation>
    </message>
    <message>
        <source>Ground of section %1 from %2 to %3 m along the way</source>
        <translation>Terén úseku %1 od %2 do %3 m cesty</translation>
    </message>
    <message>
        <source>Strip of felt ground</source>
        <translation>Pás ohmataného terénu</translation>
    </message>
    <message>
        <source>No ground is shown: nothing was estimated, or the robot reports no odometry.</source>
        <translation>Žádný terén: nic nebylo odhadnuto, nebo robot nehlásí odometrii.</translation>
    </message>
    <message>
        <source>Ground: %1 m. Sections: %2. Heights are from the IMU at the first scene of a section; both axes have one scale. Bars reach from the 0.1 to the 0.9 quantile. At most the last %3 m are kept.</source>
        <translation>Terén: %1 m. Úseky: %2. Výšky jsou od IMU při první scéně úseku; obě osy mají stejné měřítko. Pásy sahají od kvantilu 0.1 do 0.9. Uchová se nejvýše posledních %3 m.</translation>
    </message>
    <message>
        <source>Strip of felt ground of a running drive</source>
        <translation>Pás ohmataného terénu probíhající jízdy</translation>
    </message>
    <message>
        <source>Strip of felt ground of %1</source>
        <translation>Pás ohmataného terénu z %1</translation>
    </message>
    <message>
        <source>both</source>
        <translation>obě</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>kontakt</translation>
    </message>
    <message>
        <source>constrained</source>
        <translation>vymezeno</translation>
    </message>
    <message>
        <source>sampled</source>
        <translation>vzorkováno</translation>
    </message>
    <message>
        <source>prior only</source>
        <translation>jen apriori</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>ohmatáno</translation>
    </message>
    <message>
        <source>remembered</source>
        <translation>zapamatováno</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>nezapsáno</translation>
    </message>
    <message>
        <source>converged</source>
        <translation>zkonvergovalo</translation>
    </message>
    <message>
        <source>sweeps</source>
        <translation>průchody</translation>
    </message>
    <message>
        <source>time</source>
        <translation>čas</translation>
    </message>
    <message>
        <source>%1 (%2) to %3: %4</source>
        <translation>%1 (%2) až %3: %4</translation>
    </message>
    <message>
        <source>%1: a step of more than %2 m up to there has probability %3 %</source>
        <translation>%1: schod vyšší než %2 m až tam má pravděpodobnost %3 %</translation>
    </message>
    <message>
        <source>a step of more than %1 m up to each horizon has probability %2 %</source>
        <translation>schod vyšší než %1 m až k horizontu každé strany má pravděpodobnost %2 %</translation>
    </message>
    <message>
        <source>80 % bands held at later contacts</source>
        <translation>pásma 80 % platila při pozdějších dotycích</translation>
    </message>
    <message>
        <source>80 % bands held at later probes</source>
        <translation>pásma 80 % platila při pozdějších sondách</translation>
    </message>
    <message>
        <source>80 % bands held at later passes</source>
        <translation>pásma 80 % platila při pozdějších přejezdech</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <source>open: not felt</source>
        <translation>prázdná: neohmatáno</translation>
    </message>
</context>
<context>
    <name>ReviewDifference</name>
    <message>
        <source>B − A: %1 s, pitch %2, front %3, rear %4, forces %5 N</source>
        <translation>B − A: %1 s, sklon %2, přední %3, zadní %4, síly %5 N</translation>
    </message>
    <message>
        <source>B − A: %1 s, pitch %2, roll %3, front left %4 right %5, rear left %6 right %7, forces left %8 right %9 N</source>
        <translation>B − A: %1 s, sklon %2, náklon %3, přední vlevo %4 vpravo %5, zadní vlevo %6 vpravo %7, síly vlevo %8 vpravo %9 N</translation>
    </message>
</context>
<context>
    <name>ReviewDisplay</name>
    <message>
        <source>link %1 Hz</source>
        <translation>spoj %1 Hz</translation>
    </message>
    <message>
        <source>no telemetry</source>
        <translation>žádná telemetrie</translation>
    </message>
    <message>
        <source>robot: --</source>
        <translation>robot: --</translation>
    </message>
    <message>
        <source>model %1</source>
        <translation>model %1</translation>
    </message>
    <message>
        <source>no model</source>
        <translation>bez modelu</translation>
    </message>
    <message>
        <source>DAMAGED from %1 to %2; this part is not shown: %3</source>
        <translation>POŠKOZENO od %1 do %2, nic z toho se nezobrazuje: %3</translation>
    </message>
</context>
<context>
    <name>ReviewExport</name>
    <message>
        <source>%1: a picture is a .png, .svg or .pdf</source>
        <translation>%1: obrázek je .png, .svg nebo .pdf</translation>
    </message>
    <message>
        <source>%1 could not be written</source>
        <translation>%1 nelze zapsat</translation>
    </message>
    <message>
        <source>Picture of the terrain</source>
        <translation>Obraz terénu</translation>
    </message>
    <message>
        <source>Numbers of this time</source>
        <translation>Čísla tohoto času</translation>
    </message>
    <message>
        <source>Report of the scene, one page</source>
        <translation>Zpráva o scéně, jedna strana</translation>
    </message>
    <message>
        <source>CAN frames</source>
        <translation>Rámce CAN</translation>
    </message>
    <message>
        <source>Signals, a column for each</source>
        <translation>Signály, každý ve svém sloupci</translation>
    </message>
    <message>
        <source>Estimates, a row for each bin</source>
        <translation>Odhady, řádek na každý bod</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Události</translation>
    </message>
    <message>
        <source>Frames, signals, estimates and events</source>
        <translation>Rámce, signály, odhady a události</translation>
    </message>
    <message>
        <source>Mission report, the whole session</source>
        <translation>Zpráva o misi, celá relace</translation>
    </message>
    <message>
        <source>Strip of felt ground, the whole session</source>
        <translation>Pás ohmataného terénu, celá relace</translation>
    </message>
</context>
<context>
    <name>ReviewTimeline</name>
    <message>
        <source>scene %1</source>
        <translation>scéna %1</translation>
    </message>
    <message>
        <source>estimate %1 of scene %2, %3</source>
        <translation>odhad %1 scény %2, %3</translation>
    </message>
    <message>
        <source>probe proposed at %1</source>
        <translation>návrh sondy v %1</translation>
    </message>
    <message>
        <source>an estimate stands</source>
        <translation>odhad platí</translation>
    </message>
    <message>
        <source>a force element is in contact</source>
        <translation>silový prvek je v kontaktu</translation>
    </message>
    <message>
        <source>no telemetry came</source>
        <translation>nepřišla žádná telemetrie</translation>
    </message>
    <message>
        <source>DAMAGED, not shown: %1</source>
        <translation>POŠKOZENO, nezobrazeno: %1</translation>
    </message>
    <message>
        <source>alarm: %1</source>
        <translation>alarm: %1</translation>
    </message>
    <message>
        <source>alarm seen: %1</source>
        <translation>alarm potvrzen: %1</translation>
    </message>
    <message>
        <source>alarm returned: %1</source>
        <translation>alarm pominul, nepotvrzen: %1</translation>
    </message>
    <message>
        <source>alarm gone: %1</source>
        <translation>alarm skončil: %1</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 spojení</translation>
    </message>
    <message>
        <source>2 contact</source>
        <translation>2 kontakt</translation>
    </message>
    <message>
        <source>3 scenes</source>
        <translation>3 scény</translation>
    </message>
    <message>
        <source>4 estimates</source>
        <translation>4 odhady</translation>
    </message>
    <message>
        <source>5 probes</source>
        <translation>5 sondy</translation>
    </message>
    <message>
        <source>6 operator</source>
        <translation>6 operátor</translation>
    </message>
    <message>
        <source>7 alarms</source>
        <translation>7 alarmy</translation>
    </message>
    <message>
        <source>8 markers</source>
        <translation>8 značky</translation>
    </message>
    <message>
        <source>message</source>
        <translation>zpráva</translation>
    </message>
    <message>
        <source>decision</source>
        <translation>rozhodnutí</translation>
    </message>
    <message>
        <source>exploration</source>
        <translation>průzkum</translation>
    </message>
    <message>
        <source>arming</source>
        <translation>aktivace</translation>
    </message>
    <message>
        <source>link</source>
        <translation>spojení</translation>
    </message>
    <message>
        <source>estimate void</source>
        <translation>odhad zanikl</translation>
    </message>
    <message>
        <source>alarm</source>
        <translation>alarm</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>panel</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>značka</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>mezera</translation>
    </message>
    <message>
        <source>session</source>
        <translation>relace</translation>
    </message>
    <message>
        <source>contact closed: %1</source>
        <translation>kontakt sepnut: %1</translation>
    </message>
    <message>
        <source>contact open: %1</source>
        <translation>kontakt rozepnut: %1</translation>
    </message>
    <message>
        <source>telemetry gap</source>
        <translation>bez telemetrie</translation>
    </message>
    <message>
        <source>override</source>
        <translation>přebití</translation>
    </message>
    <message>
        <source>telemetry was missing for a while since the scene</source>
        <translation>po scéně chvíli chyběla telemetrie</translation>
    </message>
    <message>
        <source>nothing is overridden</source>
        <translation>nic není přebito</translation>
    </message>
    <message>
        <source>overridden: %1</source>
        <translation>přebito: %1</translation>
    </message>
</context>
<context>
    <name>ReviewViewState</name>
    <message>
        <source>A review commands no robot</source>
        <translation>Prohlížení neřídí žádného robota</translation>
    </message>
    <message>
        <source>what if: %1</source>
        <translation>co kdyby: %1</translation>
    </message>
    <message>
        <source>No estimate at this time</source>
        <translation>V tomto čase neplatil žádný odhad</translation>
    </message>
</context>
<context>
    <name>RobotCard</name>
    <message>
        <source>%1: %2
file of %3, %4 bytes; content %5</source>
        <translation>%1: %2
soubor z %3, %4 bajtů; obsah %5</translation>
    </message>
</context>
<context>
    <name>RobotWords</name>
    <message>
        <source>halted</source>
        <translation>stojí</translation>
    </message>
    <message>
        <source>driving</source>
        <translation>jede</translation>
    </message>
    <message>
        <source>pressing down</source>
        <translation>tlačí dolů</translation>
    </message>
    <message>
        <source>flippers pressed</source>
        <translation>flippery přitlačeny</translation>
    </message>
    <message>
        <source>arm is probing</source>
        <translation>rameno sonduje</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>zastaven</translation>
    </message>
</context>
<context>
    <name>SettingsFile</name>
    <message>
        <source>line %1: %2</source>
        <translation>řádek %1: %2</translation>
    </message>
    <message>
        <source>“%1” is no valid %2; expected: %3</source>
        <translation>„%1“ není platné %2; očekává se: %3</translation>
    </message>
    <message>
        <source>a number in %1</source>
        <translation>číslo v %1</translation>
    </message>
    <message>
        <source>“%1” is no setting; expected: key = value</source>
        <translation>„%1“ není nastavení; očekává se: klíč = hodnota</translation>
    </message>
    <message>
        <source>this is no file of settings; expected first: %1 = %2</source>
        <translation>to není soubor nastavení; nejdřív se očekává: %1 = %2</translation>
    </message>
    <message>
        <source>version %1 is of a newer Terratact; expected: version %2. Update this program, or export the settings from its version</source>
        <translation>verze %1 je z novějšího programu Terratact; očekává se: verze %2. Aktualizujte tento program, nebo vyexportujte nastavení z jeho verze</translation>
    </message>
    <message>
        <source>“%1” is no setting; expected: a setting of this version</source>
        <translation>„%1“ není nastavení; očekává se: nastavení této verze</translation>
    </message>
    <message>
        <source>%1 appears twice; expected: once</source>
        <translation>%1 je tu dvakrát; očekává se: jednou</translation>
    </message>
    <message>
        <source>a file of this computer</source>
        <translation>soubor tohoto počítače</translation>
    </message>
    <message>
        <source>this is no text; expected: UTF-8</source>
        <translation>to není text; očekává se: UTF-8</translation>
    </message>
    <message>
        <source>is no file</source>
        <translation>není soubor</translation>
    </message>
    <message>
        <source>the file exists and was not replaced; choose another name</source>
        <translation>soubor existuje a nebyl nahrazen; zvolte jiné jméno</translation>
    </message>
    <message>
        <source>a profile needs a name</source>
        <translation>profil potřebuje jméno</translation>
    </message>
    <message>
        <source>a profile&apos;s name has at most %1 letters</source>
        <translation>jméno profilu má nejvýše %1 znaků</translation>
    </message>
    <message>
        <source>a profile&apos;s name is one line of plain text</source>
        <translation>jméno profilu je jeden řádek prostého textu</translation>
    </message>
</context>
<context>
    <name>SideKeys</name>
    <message>
        <source>show the left side, and probe there</source>
        <translation>ukázat levou stranu a sondovat tam</translation>
    </message>
    <message>
        <source>show the right side, and probe there</source>
        <translation>ukázat pravou stranu a sondovat tam</translation>
    </message>
    <message>
        <source>show both sides, and probe the side in full</source>
        <translation>ukázat obě strany, sondovat tu vykreslenou plně</translation>
    </message>
    <message>
        <source>show the left side</source>
        <translation>ukázat levou stranu</translation>
    </message>
    <message>
        <source>show the right side</source>
        <translation>ukázat pravou stranu</translation>
    </message>
    <message>
        <source>show both sides</source>
        <translation>ukázat obě strany</translation>
    </message>
</context>
<context>
    <name>StopDisplay</name>
    <message>
        <source>STOP SENT, NOT CONFIRMED for %1: the robot may still move; STOP is sent again</source>
        <translation>STOP ODESLÁN, NEPOTVRZEN už %1: robot se může ještě hýbat; STOP se posílá znovu</translation>
    </message>
    <message>
        <source>STOP NOT SENT for %1, trying again: use the robot&apos;s own switch — %2</source>
        <translation>STOP NEODESLÁN %1, zkouší se znovu: použijte vypínač na robotu — %2</translation>
    </message>
</context>
<context>
    <name>TwoTrackVerdict</name>
    <message>
        <source>%1 at %2</source>
        <translation>%1 v %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>the cross slope ahead may tip the robot over</source>
        <translation>příčný sklon vpředu může robota převrátit</translation>
    </message>
    <message>
        <source>the cross slope ahead is not decided</source>
        <translation>příčný sklon vpředu není rozhodnut</translation>
    </message>
    <message>
        <source>a step on one of the sides is almost certain</source>
        <translation>schod na jedné ze stran je téměř jistý</translation>
    </message>
    <message>
        <source>each side alone is clear, both together are not</source>
        <translation>každá strana sama je volná, obě dohromady ne</translation>
    </message>
    <message>
        <source>each side %1</source>
        <translation>každá strana %1</translation>
    </message>
    <message>
        <source>L %1 · R %2</source>
        <translation>L %1 · P %2</translation>
    </message>
    <message>
        <source>left %1 · right %2</source>
        <translation>vlevo %1 · vpravo %2</translation>
    </message>
    <message>
        <source>P(step &gt; %1) L %2, R %3</source>
        <translation>P(schod &gt; %1) L %2, P %3</translation>
    </message>
    <message>
        <source>P(step &gt; %1, L or R) = %2</source>
        <translation>P(schod &gt; %1, L nebo P) = %2</translation>
    </message>
    <message>
        <source>cross slope %1 of %2, %3 up</source>
        <translation>příčný sklon %1 z %2, %3 výš</translation>
    </message>
    <message>
        <source>P(step &gt; %1, L or R): %2</source>
        <translation>P(schod &gt; %1, L nebo P): %2</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>fast</source>
        <translation>rychle</translation>
    </message>
    <message>
        <source>balanced</source>
        <translation>vyváženě</translation>
    </message>
    <message>
        <source>accurate</source>
        <translation>přesně</translation>
    </message>
    <message>
        <source>the chains have not converged</source>
        <translation>řetězce nekonvergovaly</translation>
    </message>
    <message>
        <source>roll %1°: the ground is not the same left and right</source>
        <translation>náklon %1°: terén není vlevo a vpravo stejný</translation>
    </message>
    <message>
        <source>left and right flippers differ by %1°: the ground is not the same left and right</source>
        <translation>levý a pravý flipper se liší o %1°: terén není vlevo a vpravo stejný</translation>
    </message>
    <message>
        <source>contact and arm disagree about bin %1 m by %2 mm</source>
        <translation>kontakt a rameno se v bodě %1 m liší o %2 mm</translation>
    </message>
    <message>
        <source>the arm found bin %1 m %2 mm above the robot&apos;s own lower edge</source>
        <translation>rameno našlo bod %1 m o %2 mm nad spodní hranou robota</translation>
    </message>
    <message>
        <source>two heights are likely at %1 m: %2 m (%3 %) or %4 m (%5 %)</source>
        <translation>v %1 m jsou pravděpodobné dvě výšky: %2 m (%3 %) nebo %4 m (%5 %)</translation>
    </message>
    <message>
        <source>the scene is unlike all training</source>
        <translation>scéna se nepodobá ničemu z tréninku</translation>
    </message>
    <message>
        <source>STOP is latched: release it first</source>
        <translation>STOP drží: nejdřív ho uvolněte</translation>
    </message>
    <message>
        <source>The link must be good for a second</source>
        <translation>Spojení musí být sekundu v pořádku</translation>
    </message>
    <message>
        <source>CLEAR</source>
        <translation>VOLNO</translation>
    </message>
    <message>
        <source>BLOCKED</source>
        <translation>PŘEKÁŽKA</translation>
    </message>
    <message>
        <source>CANNOT TELL</source>
        <translation>NELZE ŘÍCI</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>připraveno</translation>
    </message>
    <message>
        <source>halting the robot</source>
        <translation>zastavuje robota</translation>
    </message>
    <message>
        <source>pressing the front flippers down</source>
        <translation>tlačí přední flippery dolů</translation>
    </message>
    <message>
        <source>estimating the terrain</source>
        <translation>odhaduje terén</translation>
    </message>
    <message>
        <source>arm probe proposed</source>
        <translation>navržena sonda ramenem</translation>
    </message>
    <message>
        <source>arm is probing</source>
        <translation>rameno sonduje</translation>
    </message>
    <message>
        <source>estimating again with the arm&apos;s height</source>
        <translation>odhaduje znovu s výškou z ramene</translation>
    </message>
    <message>
        <source>estimate stands</source>
        <translation>odhad platí</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>STOP DRŽÍ</translation>
    </message>
    <message>
        <source>exploration failed</source>
        <translation>průzkum selhal</translation>
    </message>
    <message>
        <source>no failure</source>
        <translation>bez chyby</translation>
    </message>
    <message>
        <source>the robot did not halt in time</source>
        <translation>robot včas nezastavil</translation>
    </message>
    <message>
        <source>the flippers found nothing to press against in time</source>
        <translation>flippery včas nenašly oporu</translation>
    </message>
    <message>
        <source>the estimate took too long</source>
        <translation>odhad trval příliš dlouho</translation>
    </message>
    <message>
        <source>the estimate could not be computed</source>
        <translation>odhad se nepodařilo spočítat</translation>
    </message>
    <message>
        <source>the arm did not finish in time</source>
        <translation>rameno včas neskončilo</translation>
    </message>
    <message>
        <source>the robot refused the probe</source>
        <translation>robot sondu odmítl</translation>
    </message>
    <message>
        <source>the robot refused to press</source>
        <translation>robot odmítl přitlačit</translation>
    </message>
    <message>
        <source>the link to the robot was lost</source>
        <translation>spojení s robotem se ztratilo</translation>
    </message>
    <message>
        <source>the robot moved, so what it felt no longer holds</source>
        <translation>robot se pohnul, co nahmatal, už neplatí</translation>
    </message>
    <message>
        <source>the approval was of another scene, settings or model</source>
        <translation>schválení patřilo jiné scéně, nastavení nebo modelu</translation>
    </message>
    <message>
        <source>the robot is not armed</source>
        <translation>robot není aktivní</translation>
    </message>
    <message>
        <source>not armed yet</source>
        <translation>dosud neaktivní</translation>
    </message>
    <message>
        <source>disarmed by the operator</source>
        <translation>deaktivoval operátor</translation>
    </message>
    <message>
        <source>window or panel does not answer</source>
        <translation>okno nebo panel neodpovídá</translation>
    </message>
    <message>
        <source>somebody else sends this console&apos;s frames</source>
        <translation>někdo jiný vysílá rámce této konzole</translation>
    </message>
    <message>
        <source>the link is not good</source>
        <translation>spojení není v pořádku</translation>
    </message>
    <message>
        <source>the robot is armed, but not by this console</source>
        <translation>robot je aktivní, ale ne z této konzole</translation>
    </message>
    <message>
        <source>not confirmed in time</source>
        <translation>nepotvrzeno včas</translation>
    </message>
    <message>
        <source>the robot did not arm in time</source>
        <translation>robot se včas neaktivoval</translation>
    </message>
    <message>
        <source>the robot has disarmed</source>
        <translation>robot se deaktivoval</translation>
    </message>
    <message>
        <source>the robot has begun anew</source>
        <translation>robot se restartoval</translation>
    </message>
    <message>
        <source>may be sent</source>
        <translation>smí se odeslat</translation>
    </message>
    <message>
        <source>not a frame that a console sends</source>
        <translation>takový rámec konzole nevysílá</translation>
    </message>
    <message>
        <source>the frame is damaged</source>
        <translation>rámec je poškozen</translation>
    </message>
    <message>
        <source>the link to the robot is not good</source>
        <translation>spojení s robotem není v pořádku</translation>
    </message>
    <message>
        <source>the robot does not answer: what arrives may be a recording</source>
        <translation>robot neodpovídá: co přichází, může být záznam</translation>
    </message>
    <message>
        <source>the robot has begun a new arming</source>
        <translation>robot začal novou aktivaci</translation>
    </message>
    <message>
        <source>the robot is not stopped</source>
        <translation>robot není zastaven</translation>
    </message>
    <message>
        <source>not armed</source>
        <translation>není aktivní</translation>
    </message>
    <message>
        <source>arming is not confirmed</source>
        <translation>aktivace není potvrzena</translation>
    </message>
    <message>
        <source>an exploration is running</source>
        <translation>běží průzkum</translation>
    </message>
    <message>
        <source>no exploration is running</source>
        <translation>žádný průzkum neběží</translation>
    </message>
    <message>
        <source>the robot is busy</source>
        <translation>robot je zaneprázdněn</translation>
    </message>
    <message>
        <source>the front flippers are not pressed to the ground</source>
        <translation>přední flippery nejsou přitlačeny k zemi</translation>
    </message>
    <message>
        <source>the value is over its limit</source>
        <translation>hodnota překračuje mez</translation>
    </message>
    <message>
        <source>the probe is not approved</source>
        <translation>sonda není schválena</translation>
    </message>
    <message>
        <source>the approval is too old</source>
        <translation>schválení je příliš staré</translation>
    </message>
    <message>
        <source>another bin was approved</source>
        <translation>schválen byl jiný bod</translation>
    </message>
    <message>
        <source>chains not converged: R-hat %1 (limit %2), effective draws %3 (limit %4)</source>
        <translation>řetězce nekonvergovaly: R-hat %1 (mez %2), účinných vzorků %3 (mez %4)</translation>
    </message>
    <message>
        <source>chains not converged when time was out: R-hat %1 (limit %2), effective draws %3 (limit %4)</source>
        <translation>řetězce do vypršení času nekonvergovaly: R-hat %1 (mez %2), účinných vzorků %3 (mez %4)</translation>
    </message>
    <message>
        <source>the model of bin %1 m is singular: %2 of its variance was added as noise</source>
        <translation>model bodu %1 m je singulární: %2 jeho rozptylu přidáno jako šum</translation>
    </message>
    <message>
        <source>following: nothing is explored</source>
        <translation>sledování: nic se nezkoumá</translation>
    </message>
    <message>
        <source>following: flippers go down</source>
        <translation>sledování: flippery jdou dolů</translation>
    </message>
    <message>
        <source>following: flippers pressed, estimating the terrain</source>
        <translation>sledování: flippery přitlačeny, odhaduje terén</translation>
    </message>
    <message>
        <source>following: flippers pressed, arm is probing</source>
        <translation>sledování: flippery přitlačeny, rameno sonduje</translation>
    </message>
    <message>
        <source>following: estimating again with the arm&apos;s height</source>
        <translation>sledování: odhaduje znovu s výškou z ramene</translation>
    </message>
    <message>
        <source>following: estimate stands</source>
        <translation>sledování: odhad platí</translation>
    </message>
    <message>
        <source>following: the robot is stopped</source>
        <translation>sledování: robot je zastaven</translation>
    </message>
    <message>
        <source>following: no estimate</source>
        <translation>sledování: bez odhadu</translation>
    </message>
    <message>
        <source>wire broken</source>
        <translation>přerušený vodič</translation>
    </message>
    <message>
        <source>short circuit</source>
        <translation>zkrat</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>nasycen</translation>
    </message>
    <message>
        <source>the robot reports no odometry</source>
        <translation>robot nehlásí odometrii</translation>
    </message>
    <message>
        <source>halted</source>
        <translation>stojí</translation>
    </message>
    <message>
        <source>driving</source>
        <translation>jede</translation>
    </message>
    <message>
        <source>front flippers pressed to the ground</source>
        <translation>přední flippery přitlačeny k zemi</translation>
    </message>
    <message>
        <source>probing with the arm</source>
        <translation>sonduje ramenem</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>zastaven</translation>
    </message>
    <message>
        <source>nothing refused</source>
        <translation>nic neodmítnuto</translation>
    </message>
    <message>
        <source>the arm does not reach that bin</source>
        <translation>rameno na tento bod nedosáhne</translation>
    </message>
    <message>
        <source>the robot finds no pose to rest in there</source>
        <translation>robot tam nenajde polohu, v níž by stál</translation>
    </message>
    <message>
        <source>the command is late or not of this arming</source>
        <translation>povel přišel pozdě nebo není z této aktivace</translation>
    </message>
    <message>
        <source>the command is beyond the robot&apos;s limits</source>
        <translation>povel je mimo meze robota</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ano</translation>
    </message>
    <message>
        <source>no</source>
        <translation>ne</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádný</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nezměřeno</translation>
    </message>
    <message>
        <source>contact at x %1 m lies %2 mm above the robot&apos;s own lower edge</source>
        <translation>kontakt na x %1 m leží %2 mm nad spodní hranou robota</translation>
    </message>
    <message>
        <source>no live telemetry, the robot may have moved</source>
        <translation>bez živé telemetrie, robot se mohl pohnout</translation>
    </message>
    <message>
        <source>the robot rolls, left and right ground differ</source>
        <translation>robot je nakloněn, terén vlevo a vpravo se liší</translation>
    </message>
    <message>
        <source>the flippers differ, left and right ground differ</source>
        <translation>flippery se liší, terén vlevo a vpravo se liší</translation>
    </message>
    <message>
        <source>commands can leave</source>
        <translation>povely se mohou odesílat</translation>
    </message>
    <message>
        <source>no other console sends commands</source>
        <translation>žádná jiná konzole nevysílá povely</translation>
    </message>
    <message>
        <source>STOP is not latched</source>
        <translation>STOP nedrží</translation>
    </message>
    <message>
        <source>the link is good</source>
        <translation>spojení je dobré</translation>
    </message>
    <message>
        <source>no other console has armed the robot</source>
        <translation>žádná jiná konzole robota neaktivovala</translation>
    </message>
    <message>
        <source>telemetry was missing for a while, in which the robot may have moved</source>
        <translation>chvíli chyběla telemetrie, robot se mezitím mohl pohnout</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>nelze otevřít</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>nelze přečíst</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>není to obyčejný soubor</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>je prázdný</translation>
    </message>
    <message>
        <source>is a directory</source>
        <translation>je složka</translation>
    </message>
    <message>
        <source>is not an SQLite file</source>
        <translation>není soubor SQLite</translation>
    </message>
    <message>
        <source>is larger than the %1 bytes allowed</source>
        <translation>je větší než povolených %1 bajtů</translation>
    </message>
    <message>
        <source>has %1 bytes where its header says %2</source>
        <translation>má %1 bajtů, hlavička udává %2</translation>
    </message>
    <message>
        <source>is larger than the %1 bytes allowed here</source>
        <translation>je větší než zde povolených %1 bajtů</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>řádek %1</translation>
    </message>
    <message>
        <source>is an SQLite file of another application, not a Terratact model</source>
        <translation>je soubor SQLite jiné aplikace, ne model Terratact</translation>
    </message>
    <message>
        <source>is a part of a model; `terratact merge` makes a model of all parts</source>
        <translation>je část modelu; `terratact merge` složí ze všech částí model</translation>
    </message>
    <message>
        <source>its tables are not those of a Terratact model</source>
        <translation>jeho tabulky nejsou tabulky modelu Terratact</translation>
    </message>
    <message>
        <source>its content was altered: it does not have the hash that was stored with it</source>
        <translation>jeho obsah byl změněn: nemá otisk, který s ním byl uložen</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>disk je plný</translation>
    </message>
    <message>
        <source>%1: the disk is slow, it has been writing for %2 s; %3 frames wait</source>
        <translation>%1: disk je pomalý, zapisuje už %2 s; čeká %3 rámců</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>soubor nebo složka neexistuje</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>přístup odepřen</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>operace není dovolena</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>je to složka</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>není to složka</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>souborový systém jen pro čtení</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>na zařízení není místo</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>chyba vstupu a výstupu</translation>
    </message>
    <message>
        <source>Network is down</source>
        <translation>síť neběží</translation>
    </message>
    <message>
        <source>No such device</source>
        <translation>zařízení neexistuje</translation>
    </message>
    <message>
        <source>No such device or address</source>
        <translation>zařízení nebo adresa neexistuje</translation>
    </message>
    <message>
        <source>Device or resource busy</source>
        <translation>zařízení je obsazené</translation>
    </message>
    <message>
        <source>No buffer space available</source>
        <translation>není místo ve vyrovnávací paměti</translation>
    </message>
    <message>
        <source>another program, or the kernel,</source>
        <translation>jiný program nebo jádro</translation>
    </message>
    <message>
        <source>reading an edge</source>
        <translation>čtení hrany</translation>
    </message>
    <message>
        <source>reading a level</source>
        <translation>čtení úrovně</translation>
    </message>
    <message>
        <source>reading the levels</source>
        <translation>čtení úrovní</translation>
    </message>
    <message>
        <source>waiting for an edge</source>
        <translation>čekání na hranu</translation>
    </message>
    <message>
        <source>setting an output</source>
        <translation>nastavení výstupu</translation>
    </message>
    <message>
        <source>no GPIO chip named %1: this computer has none (no /dev/gpiochip*); plug it in, or load its driver</source>
        <translation>žádný čip GPIO jménem %1: tento počítač nemá žádný (není /dev/gpiochip*); připojte jej, nebo načtěte jeho ovladač</translation>
    </message>
    <message>
        <source>no GPIO chip labelled %1: this computer has none (no /dev/gpiochip*); plug it in, or load its driver</source>
        <translation>žádný čip GPIO s označením %1: tento počítač nemá žádný (není /dev/gpiochip*); připojte jej, nebo načtěte jeho ovladač</translation>
    </message>
    <message>
        <source>no GPIO chip named %1: there is %2</source>
        <translation>žádný čip GPIO jménem %1: je tu %2</translation>
    </message>
    <message>
        <source>no GPIO chip labelled %1: there is %2</source>
        <translation>žádný čip GPIO s označením %1: je tu %2</translation>
    </message>
    <message>
        <source>several GPIO chips named %1: there is %2; give the chip&apos;s name instead</source>
        <translation>několik čipů GPIO jménem %1: je tu %2; uveďte místo toho jméno čipu</translation>
    </message>
    <message>
        <source>several GPIO chips labelled %1: there is %2; give the chip&apos;s name instead</source>
        <translation>několik čipů GPIO s označením %1: je tu %2; uveďte místo toho jméno čipu</translation>
    </message>
    <message>
        <source>%1 has several lines named %2: give offset instead</source>
        <translation>%1 má několik linek jménem %2: uveďte místo toho offset</translation>
    </message>
    <message>
        <source>the panel&apos;s %1 does not obey: %2</source>
        <translation>%1 panelu neposlouchá: %2</translation>
    </message>
    <message>
        <source>the panel&apos;s button %1 was held when the panel came up. It counts as not pressed until it is released. If it is not held, its contact sticks or its wires touch</source>
        <translation>tlačítko %1 na panelu bylo drženo, když panel naběhl. Počítá se jako nestisknuté, dokud se neuvolní. Není-li drženo, vázne jeho kontakt, nebo se dotýkají jeho vodiče</translation>
    </message>
    <message>
        <source>the panel&apos;s button %1 has been held for too long. It counts as not pressed until it is released. If it is not held, its contact sticks or its wires touch</source>
        <translation>tlačítko %1 na panelu je drženo příliš dlouho. Počítá se jako nestisknuté, dokud se neuvolní. Není-li drženo, vázne jeho kontakt, nebo se dotýkají jeho vodiče</translation>
    </message>
    <message>
        <source>line %1 of %2 is requested twice</source>
        <translation>linka %1 čipu %2 je požadována dvakrát</translation>
    </message>
    <message>
        <source>line %1 of %2 is in use: %3 holds it; end that program, or wire the panel to another line</source>
        <translation>linka %1 čipu %2 je obsazena: drží ji %3; ukončete ten program, nebo zapojte panel na jinou linku</translation>
    </message>
    <message>
        <source>the link was lost, the robot may have moved</source>
        <translation>spojení bylo ztraceno, robot se mohl pohnout</translation>
    </message>
    <message>
        <source>STOP is latched</source>
        <translation>STOP drží</translation>
    </message>
    <message>
        <source>nests deeper than %1 levels</source>
        <translation>vnoření je hlubší než %1 úrovní</translation>
    </message>
    <message>
        <source>is a whole model, expected a part of one</source>
        <translation>je celý model, očekává se jeho část</translation>
    </message>
    <message>
        <source>its table meta describes another kind of model</source>
        <translation>jeho tabulka meta popisuje jiný druh modelu</translation>
    </message>
    <message>
        <source>its training rows have the wrong number of columns</source>
        <translation>jeho trénovací řádky mají nesprávný počet sloupců</translation>
    </message>
    <message>
        <source>its list of bins is empty</source>
        <translation>jeho seznam bodů je prázdný</translation>
    </message>
    <message>
        <source>its texts are too long</source>
        <translation>jeho texty jsou příliš dlouhé</translation>
    </message>
    <message>
        <source>a row covers a bin that does not exist</source>
        <translation>řádek zahrnuje neexistující bod</translation>
    </message>
    <message>
        <source>%1 scenes without any known height left out</source>
        <translation>vynecháno scén bez jediné známé výšky: %1</translation>
    </message>
    <message>
        <source>Address already in use</source>
        <translation>adresa se již používá</translation>
    </message>
    <message>
        <source>the key %1 is missing</source>
        <translation>chybí klíč %1</translation>
    </message>
    <message>
        <source>is a model of other features: it has %1 where %2 is expected</source>
        <translation>je model jiných příznaků: stojí tu %1, očekává se %2</translation>
    </message>
    <message>
        <source>is a model of other bins: it has %1 where %2 is expected</source>
        <translation>je model jiných bodů: stojí tu %1, očekává se %2</translation>
    </message>
    <message>
        <source>its table %1 ends too early</source>
        <translation>jeho tabulka %1 končí příliš brzy</translation>
    </message>
    <message>
        <source>its table %1 has too many rows</source>
        <translation>jeho tabulka %1 má příliš mnoho řádků</translation>
    </message>
    <message>
        <source>Address family not supported by protocol</source>
        <translation>rodina adres není podporována</translation>
    </message>
    <message>
        <source>Protocol not supported</source>
        <translation>protokol není podporován</translation>
    </message>
    <message>
        <source>sudo modprobe can_raw   (where that fails: a kernel with CONFIG_CAN_RAW)</source>
        <translation>sudo modprobe can_raw   (kde to selže: jádro s CONFIG_CAN_RAW)</translation>
    </message>
    <message>
        <source>run it outside of the sandbox or container that forbids it, or as another user</source>
        <translation>spusťte mimo sandbox nebo kontejner, který to zakazuje, nebo jako jiný uživatel</translation>
    </message>
    <message>
        <source>no telemetry yet</source>
        <translation>zatím bez telemetrie</translation>
    </message>
    <message>
        <source>link is up</source>
        <translation>spojení navázáno</translation>
    </message>
    <message>
        <source>link lost</source>
        <translation>spojení ztraceno</translation>
    </message>
    <message>
        <source>telemetry lost</source>
        <translation>telemetrie ztracena</translation>
    </message>
    <message>
        <source>link unsteady</source>
        <translation>spojení nestálé</translation>
    </message>
    <message>
        <source>telemetry unsteady</source>
        <translation>telemetrie nestálá</translation>
    </message>
    <message>
        <source>end of the log</source>
        <translation>konec záznamu</translation>
    </message>
    <message>
        <source>gaps before: %1, the longest %2 s</source>
        <translation>předtím výpadky: %1, nejdelší %2 s</translation>
    </message>
    <message>
        <source>the kernel has no CAN sockets (%1)</source>
        <translation>jádro nemá CAN sockety (%1)</translation>
    </message>
    <message>
        <source>this user may not open CAN sockets (%1)</source>
        <translation>tento uživatel nesmí otevírat CAN sockety (%1)</translation>
    </message>
    <message>
        <source>a CAN socket cannot be opened (%1)</source>
        <translation>CAN socket nelze otevřít (%1)</translation>
    </message>
    <message>
        <source>is it in degrees?</source>
        <translation>není ve stupních?</translation>
    </message>
    <message>
        <source>is it in mA?</source>
        <translation>není v mA?</translation>
    </message>
    <message>
        <source>is it in mm?</source>
        <translation>není v mm?</translation>
    </message>
    <message>
        <source>is it raw or without its bias taken off?</source>
        <translation>není surová, bez odečteného posunu?</translation>
    </message>
    <message>
        <source>a standard deviation of clearances</source>
        <translation>směrodatná odchylka světlostí</translation>
    </message>
    <message>
        <source>the surface of bin %1</source>
        <translation>povrch bodu %1</translation>
    </message>
    <message>
        <source>the clearance conditional of bin %1</source>
        <translation>podmíněné rozdělení světlosti bodu %1</translation>
    </message>
    <message>
        <source>its clearances lack the features&apos; standardisation</source>
        <translation>jeho světlostem chybí normování příznaků</translation>
    </message>
    <message>
        <source>it has not one residual per training row and bin</source>
        <translation>nemá jedno reziduum na každý trénovací řádek a bod</translation>
    </message>
    <message>
        <source>its scanned rows do not fit its training rows</source>
        <translation>jeho skenované řádky neodpovídají trénovacím</translation>
    </message>
    <message>
        <source>its number of inducing rows is out of range</source>
        <translation>jeho počet opěrných řádků je mimo rozsah</translation>
    </message>
    <message>
        <source>its table length_scale is not in the order of the inputs</source>
        <translation>jeho tabulka length_scale není v pořadí vstupů</translation>
    </message>
    <message>
        <source>chip must have a label or a name, not both</source>
        <translation>chip musí mít label, nebo name, ne obojí</translation>
    </message>
    <message>
        <source>has more than %1 fields</source>
        <translation>má více než %1 polí</translation>
    </message>
    <message>
        <source>has a field of more than %1 bytes</source>
        <translation>má pole delší než %1 bajtů</translation>
    </message>
    <message>
        <source>has more than %1 columns</source>
        <translation>má více než %1 sloupců</translation>
    </message>
    <message>
        <source>has %1 fields where the header has %2</source>
        <translation>má %1 polí, hlavička jich má %2</translation>
    </message>
    <message>
        <source>is one scene more than the %1 allowed in a file</source>
        <translation>je o jednu scénu více, než kolik smí být v souboru (%1)</translation>
    </message>
    <message>
        <source>is the header, and no scene follows it</source>
        <translation>je hlavička a nenásleduje po ní žádná scéna</translation>
    </message>
    <message>
        <source>too many notes</source>
        <translation>příliš mnoho poznámek</translation>
    </message>
    <message>
        <source>its robot</source>
        <translation>její robot</translation>
    </message>
    <message>
        <source>is an SQLite file of another application, not a session</source>
        <translation>je soubor SQLite jiné aplikace, ne relace</translation>
    </message>
    <message>
        <source>its tables are not those of a session</source>
        <translation>jeho tabulky nejsou tabulky relace</translation>
    </message>
    <message>
        <source>has unknown entries about its start</source>
        <translation>má neznámé údaje o svém začátku</translation>
    </message>
    <message>
        <source>lacks the entry whether it could transmit</source>
        <translation>chybí údaj, zda mohla vysílat</translation>
    </message>
    <message>
        <source>has draws that are not whole</source>
        <translation>má neúplné vzorky</translation>
    </message>
    <message>
        <source>has a draw that is not finite</source>
        <translation>má vzorek, který není konečný</translation>
    </message>
    <message>
        <source>the draws of an estimate are missing</source>
        <translation>vzorky některého odhadu chybějí</translation>
    </message>
    <message>
        <source>the draws of an estimate were changed</source>
        <translation>vzorky některého odhadu byly změněny</translation>
    </message>
    <message>
        <source>has more batches than a session can have</source>
        <translation>má více dávek, než relace může mít</translation>
    </message>
    <message>
        <source>a table has more rows than a session can have</source>
        <translation>některá tabulka má více řádků, než relace může mít</translation>
    </message>
    <message>
        <source>the chain of hashes is broken here</source>
        <translation>řetěz otisků je zde přerušen</translation>
    </message>
    <message>
        <source>rows were changed, lost or added</source>
        <translation>řádky byly změněny, ztraceny nebo přidány</translation>
    </message>
    <message>
        <source>%1 rows belong to no batch</source>
        <translation>řádků, které nepatří do žádné dávky: %1</translation>
    </message>
    <message>
        <source>frames belong to no batch</source>
        <translation>rámce nepatří do žádné dávky</translation>
    </message>
    <message>
        <source>frames were changed, lost or added</source>
        <translation>rámce byly změněny, ztraceny nebo přidány</translation>
    </message>
    <message>
        <source>more than %1 places are damaged</source>
        <translation>poškozeno více než %1 míst</translation>
    </message>
    <message>
        <source>a number is out of range</source>
        <translation>číslo je mimo rozsah</translation>
    </message>
    <message>
        <source>a seed is no number</source>
        <translation>semínko není číslo</translation>
    </message>
    <message>
        <source>a frame is too long</source>
        <translation>rámec je příliš dlouhý</translation>
    </message>
    <message>
        <source>a frame has the wrong length</source>
        <translation>rámec má nesprávnou délku</translation>
    </message>
    <message>
        <source>an identifier is too large</source>
        <translation>identifikátor je příliš velký</translation>
    </message>
    <message>
        <source>truth of no scene</source>
        <translation>skutečnost bez scény</translation>
    </message>
    <message>
        <source>a reading of no estimate</source>
        <translation>měření bez odhadu</translation>
    </message>
    <message>
        <source>an offer of no proposal</source>
        <translation>nabídka bez návrhu</translation>
    </message>
    <message>
        <source>an estimate of no scene</source>
        <translation>odhad bez scény</translation>
    </message>
    <message>
        <source>an estimate without settings</source>
        <translation>odhad bez nastavení</translation>
    </message>
    <message>
        <source>an estimate without a model</source>
        <translation>odhad bez modelu</translation>
    </message>
    <message>
        <source>a bin of no estimate</source>
        <translation>bod bez odhadu</translation>
    </message>
    <message>
        <source>a proposal without an estimate</source>
        <translation>návrh bez odhadu</translation>
    </message>
    <message>
        <source>a batch ends before it begins</source>
        <translation>dávka končí dříve, než začíná</translation>
    </message>
    <message>
        <source>a hash has the wrong length</source>
        <translation>otisk má nesprávnou délku</translation>
    </message>
    <message>
        <source>an unknown name</source>
        <translation>neznámé jméno</translation>
    </message>
    <message>
        <source>the model gives no finite estimate of this scene</source>
        <translation>model nedává pro tuto scénu konečný odhad</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>nedostatek paměti</translation>
    </message>
    <message>
        <source>its structure cannot be checked</source>
        <translation>jeho strukturu nelze ověřit</translation>
    </message>
    <message>
        <source>a number is missing</source>
        <translation>chybí číslo</translation>
    </message>
    <message>
        <source>its file system keeps no write-ahead journal</source>
        <translation>jeho souborový systém nevede předem psaný žurnál</translation>
    </message>
    <message>
        <source>database disk image is malformed</source>
        <translation>obsah databáze je poškozen</translation>
    </message>
    <message>
        <source>file is not a database</source>
        <translation>soubor není databáze</translation>
    </message>
    <message>
        <source>database is locked</source>
        <translation>databáze je zamčena</translation>
    </message>
    <message>
        <source>disk I/O error</source>
        <translation>chyba čtení nebo zápisu na disk</translation>
    </message>
    <message>
        <source>unable to open database file</source>
        <translation>soubor databáze nelze otevřít</translation>
    </message>
    <message>
        <source>attempt to write a readonly database</source>
        <translation>zápis do databáze jen pro čtení</translation>
    </message>
    <message>
        <source>string or blob too big</source>
        <translation>příliš velká hodnota</translation>
    </message>
    <message>
        <source>SQL logic error</source>
        <translation>chyba v SQL</translation>
    </message>
    <message>
        <source>describes no message: expected lines that begin with BO_; is it a DBC file?</source>
        <translation>nepopisuje žádnou zprávu: očekávají se řádky začínající BO_; je to soubor DBC?</translation>
    </message>
    <message>
        <source>the name of a table of words (VAL_TABLE_) is passed over</source>
        <translation>jméno tabulky slov (VAL_TABLE_) se přeskakuje</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>konec souboru</translation>
    </message>
    <message>
        <source>a message (BO_) before its signals</source>
        <translation>zpráva (BO_) před svými signály</translation>
    </message>
    <message>
        <source>the keyword of a section (BO_, CM_ …)</source>
        <translation>klíčové slovo oddílu (BO_, CM_ …)</translation>
    </message>
    <message>
        <source>the keyword of a section, such as BO_ or CM_</source>
        <translation>klíčové slovo oddílu, například BO_ nebo CM_</translation>
    </message>
    <message>
        <source>the version</source>
        <translation>verze</translation>
    </message>
    <message>
        <source>what the comment is about</source>
        <translation>předmět komentáře</translation>
    </message>
    <message>
        <source>a comment</source>
        <translation>komentář</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>text</translation>
    </message>
    <message>
        <source>a raw value</source>
        <translation>surová hodnota</translation>
    </message>
    <message>
        <source>the word of a raw value</source>
        <translation>slovo surové hodnoty</translation>
    </message>
    <message>
        <source>the name of a multiplexor</source>
        <translation>jméno multiplexoru</translation>
    </message>
    <message>
        <source>the first value of a multiplexor</source>
        <translation>první hodnota multiplexoru</translation>
    </message>
    <message>
        <source>the last value of a multiplexor</source>
        <translation>poslední hodnota multiplexoru</translation>
    </message>
    <message>
        <source>an attribute&apos;s name</source>
        <translation>jméno atributu</translation>
    </message>
    <message>
        <source>the attribute&apos;s value</source>
        <translation>hodnota atributu</translation>
    </message>
    <message>
        <source>the attribute&apos;s default</source>
        <translation>výchozí hodnota atributu</translation>
    </message>
    <message>
        <source>the message&apos;s identifier</source>
        <translation>identifikátor zprávy</translation>
    </message>
    <message>
        <source>the message&apos;s name</source>
        <translation>jméno zprávy</translation>
    </message>
    <message>
        <source>the message&apos;s length in bytes</source>
        <translation>délka zprávy v bajtech</translation>
    </message>
    <message>
        <source>the message&apos;s sender</source>
        <translation>odesílatel zprávy</translation>
    </message>
    <message>
        <source>a message&apos;s identifier</source>
        <translation>identifikátor některé zprávy</translation>
    </message>
    <message>
        <source>the signal&apos;s name</source>
        <translation>jméno signálu</translation>
    </message>
    <message>
        <source>a signal&apos;s name</source>
        <translation>jméno některého signálu</translation>
    </message>
    <message>
        <source>the signal&apos;s first bit</source>
        <translation>první bit signálu</translation>
    </message>
    <message>
        <source>the signal&apos;s length in bits</source>
        <translation>délka signálu v bitech</translation>
    </message>
    <message>
        <source>the signal&apos;s scale</source>
        <translation>měřítko signálu</translation>
    </message>
    <message>
        <source>the signal&apos;s offset</source>
        <translation>posun signálu</translation>
    </message>
    <message>
        <source>the signal&apos;s unit</source>
        <translation>jednotka signálu</translation>
    </message>
    <message>
        <source>closed with the console</source>
        <translation>uzavřena s konzolí</translation>
    </message>
    <message>
        <source>the program that recorded ended without closing the session</source>
        <translation>zaznamenávající program skončil, aniž relaci uzavřel</translation>
    </message>
    <message>
        <source>from a log of CAN frames</source>
        <translation>ze záznamu rámců CAN</translation>
    </message>
    <message>
        <source>frames that were lost when the log was recorded</source>
        <translation>rámce ztracené při pořizování záznamu</translation>
    </message>
    <message>
        <source>%1 frames and %2 other rows were dropped: the disk was slow or full, or they could not be written</source>
        <translation>%1 rámců a %2 jiných řádků bylo zahozeno: disk byl pomalý nebo plný, nebo je nešlo zapsat</translation>
    </message>
    <message>
        <source>no scene has a known height (columns h_-0.3_m … h_+0.7_m)</source>
        <translation>žádná scéna nemá známou výšku (sloupce h_-0.3_m … h_+0.7_m)</translation>
    </message>
    <message>
        <source>%1 is %2, expected 1e-9 to 1e9</source>
        <translation>%1 je %2, očekává se 1e-9 až 1e9</translation>
    </message>
    <message>
        <source>%1 is %2, beyond the range from %3 to %4 %5 (%6)</source>
        <translation>%1 je %2, mimo rozsah od %3 do %4 %5 (%6)</translation>
    </message>
    <message>
        <source>%1 must have the line&apos;s name or its offset, not both</source>
        <translation>%1 musí mít jméno linky, nebo její offset, ne obojí</translation>
    </message>
    <message>
        <source>%1 names a line that the file has used before</source>
        <translation>%1 uvádí linku, kterou soubor už použil</translation>
    </message>
    <message>
        <source>is the card of another model: of content %1, and the model&apos;s is %2</source>
        <translation>je karta jiného modelu: s obsahem %1, model má %2</translation>
    </message>
    <message>
        <source>%1 is not a height column, expected %2</source>
        <translation>%1 není sloupec výšky, očekává se %2</translation>
    </message>
    <message>
        <source>the column %1 appears twice</source>
        <translation>sloupec %1 je tu dvakrát</translation>
    </message>
    <message>
        <source>the column %1 is missing; not known: %2</source>
        <translation>chybí sloupec %1; neznámé: %2</translation>
    </message>
    <message>
        <source>the column %1 is missing</source>
        <translation>chybí sloupec %1</translation>
    </message>
    <message>
        <source>its table meta lacks %1</source>
        <translation>jeho tabulce meta chybí %1</translation>
    </message>
    <message>
        <source>the rows of its table %1 are not numbered from 0</source>
        <translation>řádky jeho tabulky %1 nejsou číslovány od 0</translation>
    </message>
    <message>
        <source>its table %1 is not numbered from 0</source>
        <translation>jeho tabulka %1 není číslována od 0</translation>
    </message>
    <message>
        <source>its table %1 holds a bin that does not exist</source>
        <translation>jeho tabulka %1 obsahuje neexistující bod</translation>
    </message>
    <message>
        <source>its table %1 holds a feature set other than pa and paf</source>
        <translation>jeho tabulka %1 obsahuje jinou sadu příznaků než pa a paf</translation>
    </message>
    <message>
        <source>a value of the wrong type in %1</source>
        <translation>hodnota nesprávného typu v %1</translation>
    </message>
    <message>
        <source>lacks the entry %1</source>
        <translation>chybí údaj %1</translation>
    </message>
    <message>
        <source>the session&apos;s model %1 (%2…) is not there</source>
        <translation>model relace %1 (%2…) tu není</translation>
    </message>
    <message>
        <source>%1 is %2…</source>
        <translation>%1 je %2…</translation>
    </message>
    <message>
        <source>%1 has the wrong number of length scales</source>
        <translation>%1 má nesprávný počet délkových měřítek</translation>
    </message>
    <message>
        <source>%1 has the wrong number of inputs</source>
        <translation>%1 má nesprávný počet vstupů</translation>
    </message>
    <message>
        <source>%1 has not one weight per inducing row</source>
        <translation>%1 nemá jednu váhu na každý opěrný řádek</translation>
    </message>
    <message>
        <source>%1 is not finite</source>
        <translation>%1 není konečné číslo</translation>
    </message>
    <message>
        <source>%1 is empty</source>
        <translation>%1 je prázdné</translation>
    </message>
    <message>
        <source>a length scale of %1</source>
        <translation>délkové měřítko (%1)</translation>
    </message>
    <message>
        <source>a standard deviation of %1</source>
        <translation>směrodatná odchylka (%1)</translation>
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
        <translation>sada příznaků %1, bod %2</translation>
    </message>
    <message>
        <source>feature set %1</source>
        <translation>sada příznaků %1</translation>
    </message>
    <message>
        <source>the message %1 is left out: it has %2 bytes, no frame more than %3</source>
        <translation>zpráva %1 je vynechána: má %2 bajtů, žádný rámec nemá více než %3</translation>
    </message>
    <message>
        <source>the message %1 is left out: %2 has its identifier</source>
        <translation>zpráva %1 je vynechána: její identifikátor má %2</translation>
    </message>
    <message>
        <source>the signal %1 is left out: its scale is 0</source>
        <translation>signál %1 je vynechán: jeho měřítko je 0</translation>
    </message>
    <message>
        <source>the signal %1 is left out: %2 has another of that name</source>
        <translation>signál %1 je vynechán: %2 má jiný téhož jména</translation>
    </message>
    <message>
        <source>is not of this program: %1 is another or missing; install the file that came with the program</source>
        <translation>nepatří k tomuto programu: %1 je jiné nebo chybí; nainstalujte soubor, který k programu patří</translation>
    </message>
    <message>
        <source>%1 frames (%2)</source>
        <translation>rámců %1 (%2)</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>rámec %1</translation>
    </message>
    <message>
        <source>%1, a whole number of at most %2</source>
        <translation>%1, celé číslo nejvýše %2</translation>
    </message>
    <message>
        <source>%1, a number</source>
        <translation>%1, číslo</translation>
    </message>
    <message>
        <source>a quotation mark at the end of %1</source>
        <translation>uvozovka na konci (%1)</translation>
    </message>
    <message>
        <source>%1 of at most %2 letters, digits and _</source>
        <translation>%1 o nejvýše %2 písmenech, číslicích a _</translation>
    </message>
    <message>
        <source>%1 in quotation marks</source>
        <translation>%1 v uvozovkách</translation>
    </message>
    <message>
        <source>%1 behind the message&apos;s name</source>
        <translation>%1 za jménem zprávy</translation>
    </message>
    <message>
        <source>%1 between two values of a multiplexor</source>
        <translation>%1 mezi dvěma hodnotami multiplexoru</translation>
    </message>
    <message>
        <source>%1 behind the signal&apos;s name</source>
        <translation>%1 za jménem signálu</translation>
    </message>
    <message>
        <source>%1 behind the signal&apos;s first bit</source>
        <translation>%1 za prvním bitem signálu</translation>
    </message>
    <message>
        <source>%1 behind the signal&apos;s length</source>
        <translation>%1 za délkou signálu</translation>
    </message>
    <message>
        <source>%1 before the signal&apos;s scale</source>
        <translation>%1 před měřítkem signálu</translation>
    </message>
    <message>
        <source>%1 between scale and offset</source>
        <translation>%1 mezi měřítkem a posunem</translation>
    </message>
    <message>
        <source>%1 behind the signal&apos;s offset</source>
        <translation>%1 za posunem signálu</translation>
    </message>
    <message>
        <source>%1 before the signal&apos;s range</source>
        <translation>%1 před rozsahem signálu</translation>
    </message>
    <message>
        <source>%1 behind the signal&apos;s range</source>
        <translation>%1 za rozsahem signálu</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>po %1</translation>
    </message>
    <message>
        <source>from %1, %2 frames, last link %3, %4 batches of which are not what was recorded and left out</source>
        <translation>z %1, rámců %2, poslední článek %3, z toho %4 dávek neodpovídá záznamu a jsou vynechány</translation>
    </message>
    <message>
        <source>from %1, %2 frames, last link %3</source>
        <translation>z %1, rámců %2, poslední článek %3</translation>
    </message>
    <message>
        <source>is longer than %1 bytes</source>
        <translation>je delší než %1 bajtů</translation>
    </message>
    <message>
        <source>has no time; record with candump -L</source>
        <translation>nemá čas; zaznamenávejte pomocí candump -L</translation>
    </message>
    <message>
        <source>an error frame cannot be a remote frame</source>
        <translation>chybový rámec nemůže být žádostí o data</translation>
    </message>
    <message>
        <source>an error frame cannot be a CAN FD frame</source>
        <translation>chybový rámec nemůže být rámcem CAN FD</translation>
    </message>
    <message>
        <source>only a classic data frame can be requested</source>
        <translation>vyžádat lze jen klasický datový rámec</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>konec řádku</translation>
    </message>
    <message>
        <source>the name of an interface</source>
        <translation>název rozhraní</translation>
    </message>
    <message>
        <source>as many bytes as CAN FD can have</source>
        <translation>tolik bajtů, kolik CAN FD může mít</translation>
    </message>
    <message>
        <source>a byte of two hexadecimal digits</source>
        <translation>bajt o dvou šestnáctkových číslicích</translation>
    </message>
    <message>
        <source>an even number of hexadecimal digits</source>
        <translation>sudý počet šestnáctkových číslic</translation>
    </message>
    <message>
        <source>a digit of flags after ##</source>
        <translation>číslice příznaků za ##</translation>
    </message>
    <message>
        <source>no more than the bytes</source>
        <translation>nic kromě bajtů</translation>
    </message>
    <message>
        <source>a direction R or T</source>
        <translation>směr R nebo T</translation>
    </message>
    <message>
        <source>the words remote request</source>
        <translation>slova remote request</translation>
    </message>
    <message>
        <source>the word ERRORFRAME</source>
        <translation>slovo ERRORFRAME</translation>
    </message>
    <message>
        <source>holds no frame</source>
        <translation>neobsahuje žádný rámec</translation>
    </message>
    <message>
        <source>holds no frame of %1, only of %2</source>
        <translation>neobsahuje rámec z %1, jen z %2</translation>
    </message>
    <message>
        <source>holds frames of %1: name the one to replay with --interface</source>
        <translation>obsahuje rámce z %1: uveďte pomocí --interface, které se má přehrát</translation>
    </message>
    <message>
        <source>a long name</source>
        <translation>dlouhý název</translation>
    </message>
    <message>
        <source>the protocol</source>
        <translation>protokol</translation>
    </message>
    <message>
        <source>a frame format</source>
        <translation>formát rámce</translation>
    </message>
    <message>
        <source>the number of a frame format</source>
        <translation>číslo formátu rámce</translation>
    </message>
    <message>
        <source>is a folder, no log of CAN traffic</source>
        <translation>je složka, ne záznam provozu na CAN</translation>
    </message>
    <message>
        <source>cannot be unpacked from here on: its packed bytes are damaged</source>
        <translation>odsud dál nejde rozbalit: zabalené bajty jsou poškozené</translation>
    </message>
    <message>
        <source>cannot be unpacked: there is no memory</source>
        <translation>nejde rozbalit: není dost paměti</translation>
    </message>
    <message>
        <source>a time, a number that is not negative</source>
        <translation>čas, číslo, které není záporné</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>čas</translation>
    </message>
    <message>
        <source>the number of a channel</source>
        <translation>číslo kanálu</translation>
    </message>
    <message>
        <source>the number of a bus</source>
        <translation>číslo sběrnice</translation>
    </message>
    <message>
        <source>a length code</source>
        <translation>kód délky</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>délka</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>číslo</translation>
    </message>
    <message>
        <source>a line with the columns of the heading</source>
        <translation>řádek se sloupci ze záhlaví</translation>
    </message>
    <message>
        <source>Rx or Tx</source>
        <translation>Rx nebo Tx</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true nebo false</translation>
    </message>
    <message>
        <source>as many bytes as the length says</source>
        <translation>tolik bajtů, kolik říká délka</translation>
    </message>
    <message>
        <source>an error frame cannot be of another kind, too</source>
        <translation>chybový rámec nemůže být zároveň jiného druhu</translation>
    </message>
    <message>
        <source>a CAN FD frame cannot be a remote frame</source>
        <translation>rámec CAN FD nemůže být žádostí o data</translation>
    </message>
    <message>
        <source>a binary log of Vector (.blf)</source>
        <translation>binární záznam Vector (.blf)</translation>
    </message>
    <message>
        <source>a measurement file (.mf4, .mdf)</source>
        <translation>soubor měření (.mf4, .mdf)</translation>
    </message>
    <message>
        <source>an MCAP file</source>
        <translation>soubor MCAP</translation>
    </message>
    <message>
        <source>a capture of Wireshark (.pcapng)</source>
        <translation>záchyt programu Wireshark (.pcapng)</translation>
    </message>
    <message>
        <source>a capture of tcpdump (.pcap)</source>
        <translation>záchyt programu tcpdump (.pcap)</translation>
    </message>
    <message>
        <source>a log of BusMaster</source>
        <translation>záznam BusMaster</translation>
    </message>
    <message>
        <source>a log of CRTD</source>
        <translation>záznam CRTD</translation>
    </message>
    <message>
        <source>a table, no known log</source>
        <translation>tabulka, ne známý záznam</translation>
    </message>
    <message>
        <source>JSON or XML, no known log</source>
        <translation>JSON nebo XML, ne známý záznam</translation>
    </message>
    <message>
        <source>is a session or another SQLite file; expected a log of CAN frames: session export makes one of a session</source>
        <translation>je relace nebo jiný soubor SQLite; očekává se záznam rámců CAN: session export jej z relace vytvoří</translation>
    </message>
    <message>
        <source>is a ZIP archive: unpack it</source>
        <translation>je archiv ZIP: rozbalte jej</translation>
    </message>
    <message>
        <source>is packed by xz: unpack it (xz -d)</source>
        <translation>je zabalený programem xz: rozbalte jej (xz -d)</translation>
    </message>
    <message>
        <source>is packed by zstd: unpack it (zstd -d)</source>
        <translation>je zabalený programem zstd: rozbalte jej (zstd -d)</translation>
    </message>
    <message>
        <source>is packed by bzip2: unpack it (bzip2 -d)</source>
        <translation>je zabalený programem bzip2: rozbalte jej (bzip2 -d)</translation>
    </message>
    <message>
        <source>is a DBC file, which --dbc reads; expected a log of CAN traffic</source>
        <translation>je soubor DBC, který čte --dbc; očekává se záznam provozu na CAN</translation>
    </message>
    <message>
        <source>at line %1 the log&apos;s clock was set back by %2 s; the session continues evenly</source>
        <translation>na řádku %1 byly hodiny záznamu vráceny o %2 s; relace pokračuje rovnoměrně</translation>
    </message>
    <message>
        <source>at line %1 the log&apos;s clock was set forward by %2 s; the session continues evenly</source>
        <translation>na řádku %1 byly hodiny záznamu posunuty vpřed o %2 s; relace pokračuje rovnoměrně</translation>
    </message>
    <message>
        <source>its journal %1 cannot be read: %2; both files belong together</source>
        <translation>její žurnál %1 nelze číst: %2; oba soubory patří k sobě</translation>
    </message>
    <message>
        <source>its journal %1 is not a file; both files belong together</source>
        <translation>její žurnál %1 není soubor; oba soubory patří k sobě</translation>
    </message>
    <message>
        <source>its journal %1 is damaged from its beginning: what was recorded after that was in there</source>
        <translation>její žurnál %1 je poškozen od začátku: bylo v něm to, co bylo zaznamenáno potom</translation>
    </message>
    <message>
        <source>is packed by gzip twice: unpack it once (gzip -d)</source>
        <translation>je dvakrát zabalen pomocí gzip: jednou jej rozbalte (gzip -d)</translation>
    </message>
    <message>
        <source>is a tar archive: unpack it (tar -xf)</source>
        <translation>je archiv tar: rozbalte jej (tar -xf)</translation>
    </message>
    <message>
        <source>the log&apos;s clock was set back %1 more times</source>
        <translation>hodiny záznamu byly vráceny ještě %1krát</translation>
    </message>
    <message>
        <source>the end of the log is torn</source>
        <translation>konec záznamu je utržený</translation>
    </message>
    <message>
        <source>is no text in UTF-8 or Windows code page 1252: expected a DBC file; save it again as one</source>
        <translation>není text v UTF-8 ani v kódové stránce Windows 1252: očekává se soubor DBC; uložte jej tak znovu</translation>
    </message>
    <message>
        <source>describes no message: expected lines that begin with BO_; is it a DBC file? First fault: %1</source>
        <translation>nepopisuje žádnou zprávu: očekávají se řádky začínající na BO_; je to soubor DBC? První chyba: %1</translation>
    </message>
    <message>
        <source>the signal %1 is left out: expected &apos;:&apos; behind its name, or M or a multiplexor&apos;s value such as m1, found %2</source>
        <translation>signál %1 je vynechán: za jeho názvem se očekává &apos;:&apos;, nebo M či hodnota multiplexoru jako m1, nalezeno %2</translation>
    </message>
    <message>
        <source>the message %1 is left out: its identifier %2 is none of CAN; expected at most 2047, or 2147483648 and 29 bits</source>
        <translation>zpráva %1 je vynechána: její identifikátor %2 není z CAN; očekává se nejvýše 2047, nebo 2147483648 a 29 bitů</translation>
    </message>
    <message>
        <source>the signal %1 is left out: it has %2 bits, expected 1 to 64</source>
        <translation>signál %1 je vynechán: má %2 bitů, očekává se 1 až 64</translation>
    </message>
    <message>
        <source>the signal %1 is left out: it does not fit its message %2, it ends with bit %3 of %4</source>
        <translation>signál %1 je vynechán: nevejde se do své zprávy %2, končí bitem %3 z %4</translation>
    </message>
    <message>
        <source>the signal %1 is left out: it is no %2 of IEEE 754, it has %3 bits, expected %4</source>
        <translation>signál %1 je vynechán: není %2 podle IEEE 754, má %3 bitů, očekává se %4</translation>
    </message>
    <message>
        <source>%1 multiplexed signals of %2 are left out: expected one signal marked M, or what selects them (SG_MUL_VAL_), at most %3 below each other</source>
        <translation>%1 multiplexovaných signálů zprávy %2 je vynecháno: očekává se jeden signál označený M, nebo co je vybírá (SG_MUL_VAL_), nejvýše %3 pod sebou</translation>
    </message>
    <message>
        <source>what selects %1 is passed over: its message has no signal %2</source>
        <translation>co vybírá %1, se přechází: jeho zpráva nemá signál %2</translation>
    </message>
    <message>
        <source>is %1; expected a log of candump, .asc, .trc, or CSV of GVRET or python-can: export it as one of them</source>
        <translation>je %1; očekává se záznam candump, .asc, .trc, nebo CSV z GVRET či python-can: exportujte jej jako jeden z nich</translation>
    </message>
    <message>
        <source>is %1; expected a log as text: can_logconvert of python-can makes one</source>
        <translation>je %1; očekává se záznam jako text: can_logconvert z python-can jej vytvoří</translation>
    </message>
    <message>
        <source>%1 sessions (%2 MB) exceed your limits. None is deleted until you allow it on page Settings</source>
        <translation>Relace (%1, %2 MB) překračují vaše meze. Žádná se nesmaže, dokud to nepovolíte na stránce Nastavení</translation>
    </message>
    <message>
        <source>there is no home folder to record in: --sessions names another</source>
        <translation>není domovská složka, do níž by se zaznamenávalo: --sessions určí jinou</translation>
    </message>
    <message>
        <source>a text is too long</source>
        <translation>text je příliš dlouhý</translation>
    </message>
    <message>
        <source>its rows hold more bytes than the file has: they share pages</source>
        <translation>její řádky mají více bajtů než soubor: sdílejí stránky</translation>
    </message>
    <message>
        <source>the batches are not in the order of their numbers</source>
        <translation>dávky nejsou v pořadí svých čísel</translation>
    </message>
    <message>
        <source>the rows of a table are not in the order of their numbers</source>
        <translation>řádky tabulky nejsou v pořadí svých čísel</translation>
    </message>
    <message>
        <source>is a symbolic link: name the file itself</source>
        <translation>je symbolický odkaz: zadejte přímo soubor</translation>
    </message>
    <message>
        <source>its journal is a symbolic link, which is not followed</source>
        <translation>její žurnál je symbolický odkaz, který se nesleduje</translation>
    </message>
    <message>
        <source>its journal is not beside it: both files belong together</source>
        <translation>její žurnál není vedle ní: oba soubory patří k sobě</translation>
    </message>
    <message>
        <source>its settings need %1 chains; the limit is %2</source>
        <translation>její nastavení žádá %1 řetězců; mez je %2</translation>
    </message>
    <message>
        <source>its settings need %1 kept and %2 discarded sweeps; the limit is %3 in total</source>
        <translation>její nastavení žádá %1 ponechaných a %2 zahozených průchodů; mez je celkem %3</translation>
    </message>
    <message>
        <source>has too long an entry %1</source>
        <translation>má příliš dlouhý údaj %1</translation>
    </message>
    <message>
        <source>its journal %1 is not beside it: what was recorded after that is in there; both files belong together</source>
        <translation>její žurnál %1 není vedle ní: co se zaznamenalo potom, je v něm; oba soubory patří k sobě</translation>
    </message>
    <message>
        <source>is empty without its journal %1, which is missing: copy both files</source>
        <translation>je prázdná bez svého žurnálu %1, který chybí: zkopírujte oba soubory</translation>
    </message>
    <message>
        <source>is not made: the name of the bus %1 has control characters</source>
        <translation>nevznikne: název sběrnice %1 obsahuje řídicí znaky</translation>
    </message>
    <message>
        <source>a log of Microchip</source>
        <translation>záznam Microchip</translation>
    </message>
    <message>
        <source>the front flippers press on nothing</source>
        <translation>přední flippery na nic netlačí</translation>
    </message>
    <message>
        <source>the front flippers reach further than they press</source>
        <translation>přední flippery sahají dál, než kam tlačí</translation>
    </message>
    <message>
        <source>the front flippers span ground that they do not press</source>
        <translation>přední flippery překlenují terén, na který netlačí</translation>
    </message>
    <message>
        <source>lay the front flippers flatter</source>
        <translation>položte přední flippery plošeji</translation>
    </message>
    <message>
        <source>is an SQLite file, not text</source>
        <translation>je soubor SQLite, ne text</translation>
    </message>
    <message>
        <source>the fields are separated by |</source>
        <translation>pole jsou oddělena znakem |</translation>
    </message>
    <message>
        <source>the fields are separated by blanks</source>
        <translation>pole jsou oddělena mezerami</translation>
    </message>
    <message>
        <source>the fields are separated in more than one way</source>
        <translation>pole jsou oddělena více způsoby</translation>
    </message>
    <message>
        <source>has text behind a closing quote</source>
        <translation>má text za koncovou uvozovkou</translation>
    </message>
    <message>
        <source>nothing was recorded</source>
        <translation>nic nebylo zaznamenáno</translation>
    </message>
    <message>
        <source>nothing was recorded from %1 s to %2 s</source>
        <translation>od %1 s do %2 s nebylo nic zaznamenáno</translation>
    </message>
    <message>
        <source>nothing was recorded from %1 s on</source>
        <translation>od %1 s dál nebylo nic zaznamenáno</translation>
    </message>
    <message>
        <source>nothing was recorded until %1 s</source>
        <translation>do %1 s nebylo nic zaznamenáno</translation>
    </message>
    <message>
        <source>no frames</source>
        <translation>žádné rámce</translation>
    </message>
    <message>
        <source>no signals</source>
        <translation>žádné signály</translation>
    </message>
    <message>
        <source>no estimates</source>
        <translation>žádné odhady</translation>
    </message>
    <message>
        <source>no events</source>
        <translation>žádné události</translation>
    </message>
    <message>
        <source>the session lasts %1 s</source>
        <translation>relace trvá %1 s</translation>
    </message>
    <message>
        <source>%1 is %2, expected a number, or its unit %3</source>
        <translation>%1 je %2, čekalo se číslo nebo jeho jednotka %3</translation>
    </message>
    <message>
        <source>pitch angle</source>
        <translation>podélný sklon</translation>
    </message>
    <message>
        <source>roll angle</source>
        <translation>náklon</translation>
    </message>
    <message>
        <source>front left flipper angle</source>
        <translation>úhel levého předního flipperu</translation>
    </message>
    <message>
        <source>front right flipper angle</source>
        <translation>úhel pravého předního flipperu</translation>
    </message>
    <message>
        <source>rear left flipper angle</source>
        <translation>úhel levého zadního flipperu</translation>
    </message>
    <message>
        <source>rear right flipper angle</source>
        <translation>úhel pravého zadního flipperu</translation>
    </message>
    <message>
        <source>front left flipper current</source>
        <translation>proud levého předního flipperu</translation>
    </message>
    <message>
        <source>front right flipper current</source>
        <translation>proud pravého předního flipperu</translation>
    </message>
    <message>
        <source>rear left flipper current</source>
        <translation>proud levého zadního flipperu</translation>
    </message>
    <message>
        <source>rear right flipper current</source>
        <translation>proud pravého zadního flipperu</translation>
    </message>
    <message>
        <source>track odometry</source>
        <translation>odometrie pásů</translation>
    </message>
    <message>
        <source>not changed for %1 s while the robot drove %2 m, stuck?</source>
        <translation>beze změny %1 s, zatímco robot ujel %2 m, zaseknutý?</translation>
    </message>
    <message>
        <source>not changed for %1 s, not even by noise, stuck?</source>
        <translation>beze změny %1 s, ani šum, zaseknutý?</translation>
    </message>
    <message>
        <source>jumps away and comes back, loose contact?</source>
        <translation>skočí a vrátí se, volný kontakt?</translation>
    </message>
    <message>
        <source>reads what the robot cannot do</source>
        <translation>ukazuje, co robot nedokáže</translation>
    </message>
    <message>
        <source>changes the wrong way, sign flipped?</source>
        <translation>mění se opačně, obrácené znaménko?</translation>
    </message>
    <message>
        <source>moves with the other axle, front and rear swapped?</source>
        <translation>pohybuje se s druhou nápravou, zaměněný předek a zadek?</translation>
    </message>
    <message>
        <source>still changes when the robot stands still, late?</source>
        <translation>mění se, i když robot stojí, zpožděný?</translation>
    </message>
    <message>
        <source>no load while the flippers press, disconnected?</source>
        <translation>bez zátěže, i když flippery tlačí, odpojený?</translation>
    </message>
    <message>
        <source>loaded while nothing presses, drifted?</source>
        <translation>zatížený, i když nic netlačí, posunutý?</translation>
    </message>
    <message>
        <source>left and right differ by the same at every press</source>
        <translation>levý a pravý se liší stejně při každém přítlaku</translation>
    </message>
    <message>
        <source>does not fit the ground driven over, offset or sign flipped?</source>
        <translation>neodpovídá přejetému terénu, posun nebo obrácené znaménko?</translation>
    </message>
    <message>
        <source>load where no ground was, order reversed?</source>
        <translation>zátěž tam, kde terén nebyl, obrácené pořadí?</translation>
    </message>
    <message>
        <source>does not fit the same ground driven in both directions, zero shifted?</source>
        <translation>neodpovídá témuž terénu přejetému oběma směry, posunutá nula?</translation>
    </message>
    <message>
        <source>a sensor may be wrong, see the alarms</source>
        <translation>snímač možná neměří správně, viz alarmy</translation>
    </message>
    <message>
        <source>the estimate contradicts the readings</source>
        <translation>odhad odporuje údajům</translation>
    </message>
    <message>
        <source>the estimate contradicts the readings: pitch %1° measured, %2° on its ground; front flippers %3° measured, %4° on its ground</source>
        <translation>odhad odporuje údajům: sklon naměřen %1°, na jeho terénu %2°; přední flippery naměřeny %3°, na jeho terénu %4°</translation>
    </message>
    <message>
        <source>no force was measured: the bands are wider</source>
        <translation>nebyla změřena žádná síla: pásma jsou širší</translation>
    </message>
    <message>
        <source>the force of element %1 was not measured: the bands are wider</source>
        <translation>síla prvku %1 nebyla změřena: pásma jsou širší</translation>
    </message>
    <message>
        <source>no flipper current was measured: the bands are wider</source>
        <translation>nebyl změřen žádný proud flipperů: pásma jsou širší</translation>
    </message>
    <message>
        <source>the front flippers&apos; current was not measured: the bands are wider</source>
        <translation>proud předních flipperů nebyl změřen: pásma jsou širší</translation>
    </message>
    <message>
        <source>the rear flippers&apos; current was not measured: the bands are wider</source>
        <translation>proud zadních flipperů nebyl změřen: pásma jsou širší</translation>
    </message>
    <message>
        <source>method clearance needs every current and force: local estimates</source>
        <translation>metoda clearance potřebuje všechny proudy a síly: odhaduje local</translation>
    </message>
    <message>
        <source>the processes use pitch and flipper angles alone</source>
        <translation>procesy používají jen sklon a úhly flipperů</translation>
    </message>
    <message>
        <source>is longer than %1 bytes: this is no log of CAN frames as text</source>
        <translation>je delší než %1 bajtů: to není textový záznam rámců CAN</translation>
    </message>
    <message>
        <source>%1: %2 is not a whole number</source>
        <translation>%1: %2 není celé číslo</translation>
    </message>
    <message>
        <source>%1: the column %2 is not known and was left out</source>
        <translation>%1: sloupec %2 není známý a byl vynechán</translation>
    </message>
    <message>
        <source>run is longer than %1 bytes: %2</source>
        <translation>run je delší než %1 bajtů: %2</translation>
    </message>
    <message>
        <source>run is not text in UTF-8: %1: save the file as CSV in UTF-8</source>
        <translation>run není text v UTF-8: %1: uložte soubor jako CSV v UTF-8</translation>
    </message>
    <message>
        <source>run is not a name: %1: it holds a comma, a quote or a control character</source>
        <translation>run není jméno: %1: obsahuje čárku, uvozovku nebo řídicí znak</translation>
    </message>
    <message>
        <source>%1: the last line has no line end; it was read as it is</source>
        <translation>%1: poslední řádek nemá konec řádku; byl přečten tak, jak je</translation>
    </message>
    <message>
        <source>%1: %2 is not the name of a method: %3</source>
        <translation>%1: %2 není jméno metody: %3</translation>
    </message>
    <message>
        <source>%1: %2 is not a date such as 2026-11-22T07:05:00Z: %3</source>
        <translation>%1: %2 není datum jako 2026-11-22T07:05:00Z: %3</translation>
    </message>
    <message>
        <source>%1: %2 is not a SHA-256: %3</source>
        <translation>%1: %2 není SHA-256: %3</translation>
    </message>
    <message>
        <source>%1: %2 is not a table</source>
        <translation>%1: %2 není tabulka</translation>
    </message>
    <message>
        <source>has %1 training rows, expected 1 to %2</source>
        <translation>má %1 trénovacích řádků, očekává se 1 až %2</translation>
    </message>
    <message>
        <source>training row %1: %2</source>
        <translation>trénovací řádek %1: %2</translation>
    </message>
    <message>
        <source>mean of %1 is out of range</source>
        <translation>střední hodnota (%1) je mimo rozsah</translation>
    </message>
    <message>
        <source>a weight of %1 is out of range</source>
        <translation>váha (%1) je mimo rozsah</translation>
    </message>
    <message>
        <source>contact_bias is out of range</source>
        <translation>contact_bias je mimo rozsah</translation>
    </message>
    <message>
        <source>scanned row: %1</source>
        <translation>skenovaný řádek: %1</translation>
    </message>
    <message>
        <source>noise_sd of %1 is out of range</source>
        <translation>noise_sd (%1) je mimo rozsah</translation>
    </message>
    <message>
        <source>log_likelihood of %1 is not finite</source>
        <translation>log_likelihood (%1) není konečné číslo</translation>
    </message>
    <message>
        <source>a mean of %1 is out of range</source>
        <translation>střední hodnota (%1) je mimo rozsah</translation>
    </message>
    <message>
        <source>holds a bin that is not in its list of bins</source>
        <translation>obsahuje bod, který není v jeho seznamu bodů</translation>
    </message>
    <message>
        <source>holds residuals of a bin that is not in its list of bins</source>
        <translation>obsahuje rezidua bodu, který není v jeho seznamu bodů</translation>
    </message>
    <message>
        <source>holds what only a whole model has</source>
        <translation>obsahuje to, co má jen celý model</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>nelze zapsat: %1</translation>
    </message>
    <message>
        <source>its seed is not a number: %1</source>
        <translation>jeho semínko není číslo: %1</translation>
    </message>
    <message>
        <source>its list of bins is wrong: %1</source>
        <translation>jeho seznam bodů je chybný: %1</translation>
    </message>
    <message>
        <source>has %1 rows in its table %2, expected 1 to %3</source>
        <translation>má v tabulce %2 řádků: %1, očekává se 1 až %3</translation>
    </message>
    <message>
        <source>its structure is damaged: %1</source>
        <translation>jeho struktura je poškozena: %1</translation>
    </message>
    <message>
        <source>a message is no JSON</source>
        <translation>zpráva není JSON</translation>
    </message>
    <message>
        <source>nothing of a session is whole in it</source>
        <translation>nic z relace v něm není celé</translation>
    </message>
    <message>
        <source>its start is no time: %1</source>
        <translation>jeho začátek není čas: %1</translation>
    </message>
    <message>
        <source>is a session of format version %1, and this program reads versions %2 to %3</source>
        <translation>je relace ve formátu verze %1 a tento program čte verze %2 až %3</translation>
    </message>
    <message>
        <source>it has as many batches as a session can have</source>
        <translation>má už tolik dávek, kolik jich relace může mít</translation>
    </message>
    <message>
        <source>recording into it has ended</source>
        <translation>záznam do něj skončil</translation>
    </message>
    <message>
        <source>is open in another program, so its journal stays beside it</source>
        <translation>je otevřen v jiném programu, jeho žurnál proto zůstává vedle něj</translation>
    </message>
    <message>
        <source>%1: %2 holds a polygon that is not convex</source>
        <translation>%1: %2 obsahuje mnohoúhelník, který není konvexní</translation>
    </message>
    <message>
        <source>%1: %2 must rise in force and fall in resistance from point to point</source>
        <translation>%1: %2 musí od bodu k bodu růst v síle a klesat v odporu</translation>
    </message>
    <message>
        <source>%1: %2 does not increase from pivot to tip</source>
        <translation>%1: %2 neroste od čepu ke špičce</translation>
    </message>
    <message>
        <source>%1: %2 holds %3, expected whole numbers</source>
        <translation>%1: %2 obsahuje %3, očekávají se celá čísla</translation>
    </message>
    <message>
        <source>%1: %2 names element %3 of that side again, expected one array for each</source>
        <translation>%1: %2 uvádí prvek %3 téže strany znovu, očekává se pro každý jedno pole</translation>
    </message>
    <message>
        <source>%1: %2 is %3, expected at most %4 bytes</source>
        <translation>%1: %2 je %3, očekává se nejvýše %4 bajtů</translation>
    </message>
    <message>
        <source>%1: no force_array has element %2, expected each of 1 to 6 left, right or on both sides</source>
        <translation>%1: žádné force_array nemá prvek %2, očekává se každý z 1 až 6 vlevo, vpravo nebo na obou stranách</translation>
    </message>
    <message>
        <source>%1: force_array is no list of tables, expected [[force_array]]</source>
        <translation>%1: force_array není seznam tabulek, očekává se [[force_array]]</translation>
    </message>
    <message>
        <source>%1: one [[force_array]] more than the %2 expected at most</source>
        <translation>%1: o jedno [[force_array]] více než nejvýše očekávaných %2</translation>
    </message>
    <message>
        <source>%1: force_array holds no table</source>
        <translation>%1: force_array neobsahuje tabulku</translation>
    </message>
    <message>
        <source>%1: %2 is %3 again, expected a name of its own for each array</source>
        <translation>%1: %2 je znovu %3, očekává se pro každé pole vlastní jméno</translation>
    </message>
    <message>
        <source>%1: %2 is not a number, expected a number from %3 to %4</source>
        <translation>%1: %2 není číslo, očekává se číslo od %3 do %4</translation>
    </message>
    <message>
        <source>%1: %2 is %3, expected a number from %4 to %5</source>
        <translation>%1: %2 je %3, očekává se číslo od %4 do %5</translation>
    </message>
    <message>
        <source>%1: %2 is not an array of %3 elements</source>
        <translation>%1: %2 není pole o počtu prvků %3</translation>
    </message>
    <message>
        <source>%1: %2 is not an array of %3 to %4 elements</source>
        <translation>%1: %2 není pole o počtu prvků %3 až %4</translation>
    </message>
    <message>
        <source>%1: %2 is not a text of 1 to 100 characters, none of them a control character</source>
        <translation>%1: %2 není text o 1 až 100 znacích bez řídicích znaků</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 nebo %2</translation>
    </message>
    <message>
        <source>%1: %2 is %3, expected %4</source>
        <translation>%1: %2 je %3, očekává se %4</translation>
    </message>
    <message>
        <source>%1: %2 is not a known key</source>
        <translation>%1: %2 není známý klíč</translation>
    </message>
    <message>
        <source>line %1: is not TOML: %2</source>
        <translation>řádek %1: není TOML: %2</translation>
    </message>
    <message>
        <source>is text in UTF-16: save it as CSV in UTF-8</source>
        <translation>je text v UTF-16: uložte ho jako CSV v UTF-8</translation>
    </message>
    <message>
        <source>is text in UTF-32: save it as CSV in UTF-8</source>
        <translation>je text v UTF-32: uložte ho jako CSV v UTF-8</translation>
    </message>
    <message>
        <source>is a workbook or an archive, not text: save the sheet as CSV in UTF-8</source>
        <translation>je sešit tabulkového programu nebo archiv, ne text: uložte list jako CSV v UTF-8</translation>
    </message>
    <message>
        <source>is a workbook of an office program, not text: save the sheet as CSV in UTF-8</source>
        <translation>je sešit kancelářského programu, ne text: uložte list jako CSV v UTF-8</translation>
    </message>
    <message>
        <source>is compressed by gzip, not text: unpack it first</source>
        <translation>je komprimován programem gzip, není text: nejprve ho rozbalte</translation>
    </message>
    <message>
        <source>is a PDF, not text: export the numbers as CSV</source>
        <translation>je PDF, ne text: exportujte čísla jako CSV</translation>
    </message>
    <message>
        <source>is a recorded session, not text: terratact session scenes writes its scenes as CSV</source>
        <translation>je zaznamenaná relace, ne text: terratact session scenes zapíše její scény jako CSV</translation>
    </message>
    <message>
        <source>holds bytes of value 0, which no text in UTF-8 does: save it as CSV in UTF-8</source>
        <translation>obsahuje bajty s hodnotou 0, což žádný text v UTF-8 nemá: uložte ho jako CSV v UTF-8</translation>
    </message>
    <message>
        <source>line 1: names a separator that is no comma, semicolon or tab</source>
        <translation>řádek 1: uvádí oddělovač, který není čárka, středník ani tabulátor</translation>
    </message>
    <message>
        <source>line %1: %2: save them separated by commas, numbers with a point</source>
        <translation>řádek %1: %2: uložte je oddělená čárkami, čísla s desetinnou tečkou</translation>
    </message>
    <message>
        <source>%1: are there decimal commas? save numbers with a point</source>
        <translation>%1: jsou tam desetinné čárky? uložte čísla s desetinnou tečkou</translation>
    </message>
    <message>
        <source>%1 is not measured: %2</source>
        <translation>%1 není změřeno: %2</translation>
    </message>
    <message>
        <source>%1 is not a number: %2: save numbers with a point, and nothing between thousands</source>
        <translation>%1 není číslo: %2: uložte čísla s desetinnou tečkou a bez oddělovače tisíců</translation>
    </message>
    <message>
        <source>%1 is %2, and line %3 has a decimal comma: save all numbers with a decimal point</source>
        <translation>%1 je %2, a řádek %3 má desetinnou čárku: uložte všechna čísla s desetinnou tečkou</translation>
    </message>
    <message>
        <source>%1 is %2, and line %3 has a decimal point: save all numbers with a decimal point</source>
        <translation>%1 je %2, a řádek %3 má desetinnou tečku: uložte všechna čísla s desetinnou tečkou</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>řádek %1: %2</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2</source>
        <translation>%1: nelze zapsat: %2</translation>
    </message>
    <message>
        <source>a recorded session is there, which is never replaced: name another file</source>
        <translation>je tam zaznamenaná relace, která se nikdy nepřepisuje: zvolte jiný soubor</translation>
    </message>
    <message>
        <source>it is write-protected: name another file</source>
        <translation>je chráněn proti zápisu: zvolte jiný soubor</translation>
    </message>
    <message>
        <source>%1: the directory cannot be made: %2</source>
        <translation>%1: složku nelze vytvořit: %2</translation>
    </message>
    <message>
        <source>is a pipe or a device, which is read only once, and this is read twice: save it as a file first</source>
        <translation>je roura nebo zařízení, které lze číst jen jednou, a tohle se čte dvakrát: nejprve to uložte jako soubor</translation>
    </message>
    <message>
        <source>malformed database schema %1</source>
        <translation>chybné schéma databáze %1</translation>
    </message>
    <message>
        <source>it is not a regular file, and an SQLite file is read back and forth: save it as a file first</source>
        <translation>není to obyčejný soubor, a soubor SQLite se čte na přeskáčku: nejprve to uložte jako soubor</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>nelze otevřít: %1</translation>
    </message>
    <message>
        <source>has no size: %1</source>
        <translation>nemá velikost: %1</translation>
    </message>
    <message>
        <source>cannot be created: %1</source>
        <translation>nelze vytvořit: %1</translation>
    </message>
    <message>
        <source>the date is not understood: times count from 0</source>
        <translation>datum není srozumitelné: časy se počítají od 0</translation>
    </message>
    <message>
        <source>a length from 0 to 8</source>
        <translation>délka od 0 do 8</translation>
    </message>
    <message>
        <source>0 or 1 for the flags BRS and ESI</source>
        <translation>0 nebo 1 pro příznaky BRS a ESI</translation>
    </message>
    <message>
        <source>a time like (1436509052.249713)</source>
        <translation>čas jako (1436509052.249713)</translation>
    </message>
    <message>
        <source>a time like (2025-01-10 12:34:56.249713)</source>
        <translation>čas jako (2025-01-10 12:34:56.249713)</translation>
    </message>
    <message>
        <source>an identifier of 3 or 8 hexadecimal digits</source>
        <translation>identifikátor o 3 nebo 8 šestnáctkových číslicích</translation>
    </message>
    <message>
        <source>a standard identifier up to 7FF</source>
        <translation>standardní identifikátor do 7FF</translation>
    </message>
    <message>
        <source>an identifier up to 3FFFFFFF</source>
        <translation>identifikátor do 3FFFFFFF</translation>
    </message>
    <message>
        <source>a length from 0 to 8 after R</source>
        <translation>délka od 0 do 8 za R</translation>
    </message>
    <message>
        <source>a length like [5]</source>
        <translation>délka jako [5]</translation>
    </message>
    <message>
        <source>as many bytes in base 64 as dlc says</source>
        <translation>tolik bajtů v base 64, kolik říká dlc</translation>
    </message>
    <message>
        <source>%1; this entry is left out</source>
        <translation>%1; tato položka je vynechána</translation>
    </message>
    <message>
        <source>line %1: expected %2, found %3</source>
        <translation>řádek %1: očekáváno: %2, nalezeno: %3</translation>
    </message>
    <message>
        <source>0 (integer), 1 (float) or 2 (double)</source>
        <translation>0 (celé číslo), 1 (float) nebo 2 (double)</translation>
    </message>
    <message>
        <source>is not UTF-8: read as Windows code page 1252; if characters look wrong, save it as UTF-8</source>
        <translation>není v UTF-8: přečteno podle kódové stránky Windows 1252; vypadají-li znaky špatně, uložte soubor jako UTF-8</translation>
    </message>
    <message>
        <source>the byte order, 1 (little-endian) or 0</source>
        <translation>pořadí bajtů, 1 (little-endian) nebo 0</translation>
    </message>
    <message>
        <source>%1 or &apos;-&apos; behind the byte order</source>
        <translation>%1 nebo &apos;-&apos; za pořadím bajtů</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>nelze přečíst: %1</translation>
    </message>
    <message>
        <source>a log of NMEA 2000 of canboat</source>
        <translation>záznam NMEA 2000 programu canboat</translation>
    </message>
    <message>
        <source>a bag of ROS</source>
        <translation>záznam systému ROS (bag)</translation>
    </message>
    <message>
        <source>the packed log is torn behind it: what came before is read</source>
        <translation>komprimovaný záznam je za ním utržený: čte se, co bylo předtím</translation>
    </message>
    <message>
        <source>the packed log is torn before its first line</source>
        <translation>komprimovaný záznam je utržený před prvním řádkem</translation>
    </message>
    <message>
        <source>bytes behind the packed log are not gzip and are left out</source>
        <translation>za komprimovaným záznamem jsou bajty, které nejsou gzip, a jsou vynechány</translation>
    </message>
    <message>
        <source>the clock is set %1 more times</source>
        <translation>hodiny jsou nastaveny ještě %1krát</translation>
    </message>
    <message>
        <source>%1 of %2 times are no later than the one before, from 0 on: is this a log of candump -td, whose times are wrong here? Record with candump -L</source>
        <translation>%1 z %2 časů nejsou pozdější než předchozí, od 0: je to záznam z candump -td, jehož časy tu nesouhlasí? Zaznamenávejte pomocí candump -L</translation>
    </message>
    <message>
        <source>line %1 holds no frame and is passed over</source>
        <translation>řádek %1 neobsahuje žádný rámec a je přeskočen</translation>
    </message>
    <message>
        <source>%1 lines hold no frame and are passed over, the first is line %2</source>
        <translation>%1 řádků neobsahuje žádný rámec a jsou přeskočeny, první je řádek %2</translation>
    </message>
    <message>
        <source>%1 s later than the line before: was the clock set? The silence is left out</source>
        <translation>o %1 s později než předchozí řádek: byly hodiny přestaveny? Mezera je vynechána</translation>
    </message>
    <message>
        <source>%1 s earlier than the line before: was the clock set, or is this a log of candump -td?</source>
        <translation>o %1 s dříve než předchozí řádek: byly hodiny přestaveny, nebo je to záznam z candump -td?</translation>
    </message>
    <message>
        <source>%1 s earlier than the line before: was the clock set?</source>
        <translation>o %1 s dříve než předchozí řádek: byly hodiny přestaveny?</translation>
    </message>
    <message>
        <source>has no line end: it is read, but may be truncated</source>
        <translation>nemá konec řádku: čte se, ale může být useknutý</translation>
    </message>
    <message>
        <source>has no line end and holds no frame: it may be torn</source>
        <translation>nemá konec řádku ani rámec: může být utržený</translation>
    </message>
    <message>
        <source>is torn: the log ends within it; what came before is read</source>
        <translation>je utržený: záznam končí uvnitř něj; čte se, co bylo předtím</translation>
    </message>
    <message>
        <source>at most 8 bytes</source>
        <translation>nejvýše 8 bajtů</translation>
    </message>
    <message>
        <source>a byte from 0 to 255</source>
        <translation>bajt od 0 do 255</translation>
    </message>
    <message>
        <source>an identifier up to 1FFFFFFF</source>
        <translation>identifikátor do 1FFFFFFF</translation>
    </message>
    <message>
        <source>the start time is not understood: times count from 0</source>
        <translation>čas začátku není srozumitelný: časy se počítají od 0</translation>
    </message>
    <message>
        <source>the number of a frame, such as 1)</source>
        <translation>číslo rámce, například 1)</translation>
    </message>
    <message>
        <source>is no file, and too long to be kept: copy it to one</source>
        <translation>není soubor a je příliš dlouhý na to, aby se uchoval: zkopírujte jej do souboru</translation>
    </message>
    <message>
        <source>follows %1 s of silence, which the replay shortens to %2 s</source>
        <translation>následuje po %1 s ticha, které přehrávání zkracuje na %2 s</translation>
    </message>
    <message>
        <source>has lost its time: the log has changed</source>
        <translation>ztratil svůj čas: záznam se změnil</translation>
    </message>
    <message>
        <source>%1: a replay takes no commands</source>
        <translation>%1: přehrávání nepřijímá povely</translation>
    </message>
    <message>
        <source>is no regular file, which would be waited for: copy it to one</source>
        <translation>není běžný soubor, čekalo by se na něj: zkopírujte jej do souboru</translation>
    </message>
    <message>
        <source>%1: ignored; the robot&apos;s protocol already uses this identifier</source>
        <translation>%1: nepoužito; tento identifikátor už má protokol robota</translation>
    </message>
    <message>
        <source>%1: ignored; %2 already describes it</source>
        <translation>%1: nepoužito; už to popisuje %2</translation>
    </message>
    <message>
        <source>%1 scenes with unknown values left out</source>
        <translation>vynechané scény s neznámými hodnotami: %1</translation>
    </message>
    <message>
        <source>%1 scenes are there twice: their copies were left out</source>
        <translation>scén, které jsou tu dvakrát: %1; jejich kopie byly vynechány</translation>
    </message>
    <message>
        <source>%1 scenes for each conditional, whose training grows with their cube: --inducing 1200 predicts nearly as well and trains in a fraction of the time</source>
        <translation>%1 scén pro každou podmíněnou předpověď, jejíž trénink roste s jejich třetí mocninou: --inducing 1200 předpovídá skoro stejně dobře a trénuje se ve zlomku času</translation>
    </message>
    <message>
        <source>none of the frames can be written in this format: %1 left out</source>
        <translation>v tomto formátu nelze zapsat žádný rámec: vynecháno %1</translation>
    </message>
    <message>
        <source>a log of CAN frames holds nothing else; csv and mcap do</source>
        <translation>záznam rámců CAN nic jiného neobsahuje; csv a mcap ano</translation>
    </message>
    <message>
        <source>not written: ended before it was whole</source>
        <translation>nezapsáno: skončilo dříve, než bylo celé</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>estimate %1: its scene is not there</source>
        <translation>odhad %1: jeho scéna tu není</translation>
    </message>
    <message>
        <source>estimate %1: %2</source>
        <translation>odhad %1: %2</translation>
    </message>
    <message>
        <source>is no file of notes: expected the columns t_s,note</source>
        <translation>není soubor poznámek: očekávají se sloupce t_s,note</translation>
    </message>
    <message>
        <source>drive on 0.1 m and explore again</source>
        <translation>popojeďte o 0.1 m a prozkoumejte znovu</translation>
    </message>
    <message>
        <source>force 1</source>
        <translation>síla 1</translation>
    </message>
    <message>
        <source>force 2</source>
        <translation>síla 2</translation>
    </message>
    <message>
        <source>force 3</source>
        <translation>síla 3</translation>
    </message>
    <message>
        <source>force 4</source>
        <translation>síla 4</translation>
    </message>
    <message>
        <source>force 5</source>
        <translation>síla 5</translation>
    </message>
    <message>
        <source>force 6</source>
        <translation>síla 6</translation>
    </message>
    <message>
        <source>left force 1</source>
        <translation>levá síla 1</translation>
    </message>
    <message>
        <source>left force 2</source>
        <translation>levá síla 2</translation>
    </message>
    <message>
        <source>left force 3</source>
        <translation>levá síla 3</translation>
    </message>
    <message>
        <source>left force 4</source>
        <translation>levá síla 4</translation>
    </message>
    <message>
        <source>left force 5</source>
        <translation>levá síla 5</translation>
    </message>
    <message>
        <source>left force 6</source>
        <translation>levá síla 6</translation>
    </message>
    <message>
        <source>right force 1</source>
        <translation>pravá síla 1</translation>
    </message>
    <message>
        <source>right force 2</source>
        <translation>pravá síla 2</translation>
    </message>
    <message>
        <source>right force 3</source>
        <translation>pravá síla 3</translation>
    </message>
    <message>
        <source>right force 4</source>
        <translation>pravá síla 4</translation>
    </message>
    <message>
        <source>right force 5</source>
        <translation>pravá síla 5</translation>
    </message>
    <message>
        <source>right force 6</source>
        <translation>pravá síla 6</translation>
    </message>
    <message>
        <source>%1: the disk is full; recording continues when there is space</source>
        <translation>%1: disk je plný; záznam pokračuje, jakmile bude místo</translation>
    </message>
    <message>
        <source>its number of repeated rows is out of range</source>
        <translation>jeho počet opakovaných řádků je mimo rozsah</translation>
    </message>
    <message>
        <source>%1 scenes repeat a place within the sensors&apos; noise; training counts each place once (runs %2)</source>
        <translation>%1 scén opakuje totéž místo v mezích šumu snímačů; trénink počítá každé místo jednou (jízdy %2)</translation>
    </message>
    <message>
        <source>unlike the training scenes: %1 times the distance that 1 % of them exceed</source>
        <translation>nepodobá se trénovacím scénám: %1násobek vzdálenosti, kterou překročí 1 % z nich</translation>
    </message>
    <message>
        <source>time was out %1 sweeps before the burn-in&apos;s end: the draws depend on where the chains started</source>
        <translation>čas vypršel %1 průchodů před koncem záběhu: vzorky závisejí na tom, kde řetězce začaly</translation>
    </message>
    <message>
        <source>bin %1 m under the robot was seen in %2 training scenes, and %3 are needed</source>
        <translation>bod %1 m pod robotem byl v %2 trénovacích scénách a potřeba je %3</translation>
    </message>
    <message>
        <source>bin %1 m with no robot above it was seen in %2 training scenes, and %3 are needed</source>
        <translation>bod %1 m bez robota nad ním byl v %2 trénovacích scénách a potřeba je %3</translation>
    </message>
    <message>
        <source>the frame was cut short</source>
        <translation>rámec byl zkrácen</translation>
    </message>
    <message>
        <source>the kernel has no CAN here: load it (sudo modprobe can_raw), or use another kernel</source>
        <translation>jádro tu nemá CAN: načtěte ho (sudo modprobe can_raw), nebo použijte jiné jádro</translation>
    </message>
    <message>
        <source>this process may not open CAN sockets: a sandbox or container forbids it, start it outside (or: sudo setcap cap_net_raw+ep PROGRAM)</source>
        <translation>tento proces nesmí otevírat CAN sockety: zakazuje to sandbox nebo kontejner, spusťte ho mimo něj (nebo: sudo setcap cap_net_raw+ep PROGRAM)</translation>
    </message>
    <message>
        <source>no socket: %1</source>
        <translation>žádný socket: %1</translation>
    </message>
    <message>
        <source>is no CAN interface (ip -brief link show type can lists those)</source>
        <translation>není rozhraní CAN (vypíše je ip -brief link show type can)</translation>
    </message>
    <message>
        <source>the kernel&apos;s CAN is too old: %1</source>
        <translation>CAN v jádře je příliš staré: %1</translation>
    </message>
    <message>
        <source>not bound: %1</source>
        <translation>nepřipojeno: %1</translation>
    </message>
    <message>
        <source>its lines have no names: give offset instead</source>
        <translation>jeho linky nemají jména: uveďte místo toho offset</translation>
    </message>
    <message>
        <source>it has %1 and more</source>
        <translation>má %1 a další</translation>
    </message>
    <message>
        <source>it has %1</source>
        <translation>má %1</translation>
    </message>
    <message>
        <source>%1 has no line named %2: %3</source>
        <translation>%1 nemá linku jménem %2: %3</translation>
    </message>
    <message>
        <source>%1 has no line %2: it has 0 to %3</source>
        <translation>%1 nemá linku %2: má 0 až %3</translation>
    </message>
    <message>
        <source>%1: the lines were refused: %2</source>
        <translation>%1: linky byly odmítnuty: %2</translation>
    </message>
    <message>
        <source>%1: a line is in use by another program, or by the kernel; gpioinfo shows which</source>
        <translation>%1: některou linku používá jiný program nebo jádro; gpioinfo ukáže kterou</translation>
    </message>
    <message>
        <source>%1: it is open to the group %2; run: %3 (and log in again)</source>
        <translation>%1: je otevřen skupině %2; spusťte: %3 (a znovu se přihlaste)</translation>
    </message>
    <message>
        <source>%1: it is open to root only; run: %2 (and restart)</source>
        <translation>%1: je otevřen jen správci (root); spusťte: %2 (a restartujte)</translation>
    </message>
    <message>
        <source>%1: the chip is gone: unplugged, or its driver was removed</source>
        <translation>%1: čip zmizel: byl odpojen, nebo byl odebrán jeho ovladač</translation>
    </message>
    <message>
        <source>the panel is absent: %1</source>
        <translation>panel chybí: %1</translation>
    </message>
    <message>
        <source>%1: not readable: %2</source>
        <translation>%1: nelze číst: %2</translation>
    </message>
    <message>
        <source>%1: not sent, the kernel&apos;s queue is full</source>
        <translation>%1: neodesláno, fronta jádra je plná</translation>
    </message>
    <message>
        <source>%1: not sent: %2</source>
        <translation>%1: neodesláno: %2</translation>
    </message>
    <message>
        <source>%1 was opened to receive only: nothing is sent</source>
        <translation>%1 bylo otevřeno jen pro příjem: nic se neodesílá</translation>
    </message>
    <message>
        <source>%1: not sent, %2 frames before it have not left yet</source>
        <translation>%1: neodesláno, %2 předchozích rámců ještě neodešlo</translation>
    </message>
    <message>
        <source>a stop line needs a name of 1 to 100 characters</source>
        <translation>vedení pro zastavení potřebuje jméno o 1 až 100 znacích</translation>
    </message>
    <message>
        <source>there is no interface %1, but %2</source>
        <translation>rozhraní %1 neexistuje, ale existuje %2</translation>
    </message>
    <message>
        <source>there is no interface %1, nor any CAN interface</source>
        <translation>rozhraní %1 neexistuje, ani žádné rozhraní CAN</translation>
    </message>
    <message>
        <source>plug the adapter in and load its driver; for a virtual one: sudo ip link add dev vcan0 type vcan</source>
        <translation>připojte adaptér a načtěte jeho ovladač; virtuální: sudo ip link add dev vcan0 type vcan</translation>
    </message>
    <message>
        <source>it is virtual: no bit rate, no controller</source>
        <translation>je virtuální: bez rychlosti, bez řadiče</translation>
    </message>
    <message>
        <source>its bit rate and its controller&apos;s state are not known</source>
        <translation>jeho rychlost a stav jeho řadiče nejsou známy</translation>
    </message>
    <message>
        <source>it has no bit rate</source>
        <translation>nemá nastavenou rychlost</translation>
    </message>
    <message>
        <source>%1   (as on the robot&apos;s bus)</source>
        <translation>%1   (jako na sběrnici robota)</translation>
    </message>
    <message>
        <source>bit rate %1 bit/s</source>
        <translation>rychlost %1 bit/s</translation>
    </message>
    <message>
        <source>its controller has given up (bus-off): wrong bit rate, no terminators or crossed wires</source>
        <translation>jeho řadič to vzdal (bus-off): špatná rychlost, chybějící zakončení nebo prohozené vodiče</translation>
    </message>
    <message>
        <source>its controller sees many errors (%1): wrong bit rate, no terminators or loose wires</source>
        <translation>jeho řadič vidí mnoho chyb (%1): špatná rychlost, chybějící zakončení nebo uvolněné vodiče</translation>
    </message>
    <message>
        <source>it is up</source>
        <translation>je zapnuté</translation>
    </message>
    <message>
        <source>it is down</source>
        <translation>je vypnuté</translation>
    </message>
    <message>
        <source>its send queue holds %1 frames: without acknowledgement, other programs&apos; frames wait in it too long</source>
        <translation>jeho odesílací fronta pojme %1 rámců: bez potvrzení v ní rámce jiných programů čekají příliš dlouho</translation>
    </message>
    <message>
        <source>the receive buffer may be as large as it has to</source>
        <translation>přijímací vyrovnávací paměť smí být tak velká, jak je třeba</translation>
    </message>
    <message>
        <source>the receive buffer is limited to %1 of %2 bytes: frames are lost when this computer is busy</source>
        <translation>přijímací vyrovnávací paměť je omezena na %1 z %2 bajtů: když je tento počítač vytížen, rámce se ztrácejí</translation>
    </message>
    <message>
        <source>the kernel has CAN and this user may use it</source>
        <translation>jádro má CAN a tento uživatel ho smí používat</translation>
    </message>
    <message>
        <source>%1 is no CAN interface</source>
        <translation>%1 není rozhraní CAN</translation>
    </message>
    <message>
        <source>ip -brief link   (lists all there are)</source>
        <translation>ip -brief link   (vypíše všechna)</translation>
    </message>
    <message>
        <source>it is a CAN interface</source>
        <translation>je to rozhraní CAN</translation>
    </message>
    <message>
        <source>unknown error</source>
        <translation>neznámá chyba</translation>
    </message>
    <message>
        <source>no scene that both models can estimate: %1; choose another file of scenes</source>
        <translation>žádná scéna, kterou by uměly odhadnout oba modely: %1; zvolte jiný soubor scén</translation>
    </message>
    <message>
        <source>arm not simulated: the truth of bin %1 m is unknown</source>
        <translation>rameno nebylo simulováno: skutečná výška bodu %1 m není známa</translation>
    </message>
    <message>
        <source>session not recovered: %1</source>
        <translation>relace nebyla obnovena: %1</translation>
    </message>
    <message>
        <source>session recovered, whose program had ended without closing it: %1</source>
        <translation>relace obnovena; její program skončil, aniž ji uzavřel: %1</translation>
    </message>
    <message>
        <source>session deleted, since it is older than you have set: %1</source>
        <translation>relace smazána, neboť je starší, než jste nastavili: %1</translation>
    </message>
    <message>
        <source>session deleted, since all together are larger than you have set: %1</source>
        <translation>relace smazána, neboť všechny dohromady jsou větší, než jste nastavili: %1</translation>
    </message>
    <message>
        <source>recording was switched off</source>
        <translation>zaznamenávání bylo vypnuto</translation>
    </message>
    <message>
        <source>%1: the disk is full: only %2 MB are free, %3 MB are kept free; recording continues when there is space</source>
        <translation>%1: disk je plný: volných je jen %2 MB, %3 MB se nechává volných; záznam pokračuje, jakmile bude místo</translation>
    </message>
    <message>
        <source>the file is large enough</source>
        <translation>soubor je dost velký</translation>
    </message>
    <message>
        <source>the bus is down</source>
        <translation>sběrnice je vypnutá</translation>
    </message>
    <message>
        <source>the controller is off the bus</source>
        <translation>řadič je odpojen od sběrnice</translation>
    </message>
    <message>
        <source>what was sent before has not left yet</source>
        <translation>co bylo odesláno dříve, ještě neodešlo</translation>
    </message>
    <message>
        <source>has no scenes</source>
        <translation>nemá žádné scény</translation>
    </message>
    <message>
        <source>%1: nothing is written here: %2 is a symbolic link of another user; name the folder itself</source>
        <translation>%1: sem se nic nezapíše: %2 je symbolický odkaz jiného uživatele; uveďte přímo složku</translation>
    </message>
    <message>
        <source>it is a symbolic link to %1, and nothing is written through a link: name the file itself</source>
        <translation>je to symbolický odkaz na %1 a přes odkaz se nic nezapisuje: uveďte přímo soubor</translation>
    </message>
    <message>
        <source>%1: %2 is %3, expected at least %4 m from track_y_m: flipper and track overlap</source>
        <translation>%1: %2 je %3, očekává se aspoň %4 m od track_y_m: flipper a pás se překrývají</translation>
    </message>
    <message>
        <source>unpacks to more than %1 times its size: if it is a log, unpack it first (gzip -d)</source>
        <translation>se rozbalí na více než %1násobek své velikosti: je-li to záznam, nejprve jej rozbalte (gzip -d)</translation>
    </message>
    <message>
        <source>the window&apos;s picture could not be made: end other programs</source>
        <translation>obrázek okna se nepodařilo vytvořit: ukončete jiné programy</translation>
    </message>
    <message>
        <source>the model has learnt one plane only: `terratact train --tracks` makes one for two tracks</source>
        <translation>model se naučil jen jednu rovinu: model pro dva pásy vytvoří `terratact train --tracks`</translation>
    </message>
    <message>
        <source>the track differential has turned: estimates of both sides need it locked</source>
        <translation>diferenciál pásů se pootočil: odhady obou stran potřebují, aby byl zajištěn</translation>
    </message>
    <message>
        <source>row %1 of two tracks: %2</source>
        <translation>řádek %1 dvou pásů: %2</translation>
    </message>
    <message>
        <source>a value of its two tracks is not a multiple of its step</source>
        <translation>číslo jeho dvou pásů není násobkem svého kroku</translation>
    </message>
    <message>
        <source>the two sides of a scene have other readings</source>
        <translation>obě strany jedné scény mají různá měření</translation>
    </message>
    <message>
        <source>its rows of two tracks have the wrong size</source>
        <translation>jeho řádky dvou pásů mají špatnou velikost</translation>
    </message>
    <message>
        <source>is a part of a model of two tracks</source>
        <translation>je část modelu pro dva pásy</translation>
    </message>
    <message>
        <source>is a model of format version %1, and this program reads versions %2 and %3: `terratact train` makes a new one</source>
        <translation>je model formátu verze %1, ale tento program čte verze %2 a %3: nový vytvoří `terratact train`</translation>
    </message>
    <message>
        <source>row %1 of its table %2: %3</source>
        <translation>řádek %1 jeho tabulky %2: %3</translation>
    </message>
    <message>
        <source>columns of the right side are expected for two sides, and none for one plane</source>
        <translation>sloupce pravé strany se očekávají u dvou stran, u jedné roviny žádné</translation>
    </message>
    <message>
        <source>bins of one plane are expected to be of both sides, and others of one</source>
        <translation>u jedné roviny se očekávají body obou stran, jinak body jedné strany</translation>
    </message>
    <message>
        <source>the track differential has turned: left and right are estimated as one plane</source>
        <translation>diferenciál pásů se pootočil: vlevo a vpravo se odhaduje jako jedna rovina</translation>
    </message>
    <message>
        <source>method %1 estimates left and right as one plane, although they differ</source>
        <translation>metoda %1 odhaduje vlevo a vpravo jako jednu rovinu, ačkoli se liší</translation>
    </message>
    <message>
        <source>the arm&apos;s reading at %1 m lies in the middle and counts for neither side</source>
        <translation>měření ramene v %1 m leží uprostřed a nepočítá se k žádné straně</translation>
    </message>
    <message>
        <source>left: %1</source>
        <translation>vlevo: %1</translation>
    </message>
    <message>
        <source>right: %1</source>
        <translation>vpravo: %1</translation>
    </message>
    <message>
        <source>the estimate contradicts the readings: pitch %1°, roll %2°, front flippers %3° left, %4° right measured; %5°, %6°, %7°, %8° on its ground</source>
        <translation>odhad odporuje údajům: naměřen sklon %1°, náklon %2°, přední flippery vlevo %3°, vpravo %4°; na jeho terénu %5°, %6°, %7°, %8°</translation>
    </message>
    <message>
        <source>from a recording by the mapping %1</source>
        <translation>ze záznamu podle mapování %1</translation>
    </message>
    <message>
        <source>the recording does not say what the robot did: pressing, driving and halting follow from its movement and currents</source>
        <translation>záznam neříká, co robot dělal: tlak, jízda a stání plynou z jeho pohybu a proudů</translation>
    </message>
    <message>
        <source>advancing</source>
        <translation>postupuje vpřed</translation>
    </message>
    <message>
        <source>the robot did not finish the advance in time</source>
        <translation>robot nedokončil postup včas</translation>
    </message>
    <message>
        <source>the advance was refused</source>
        <translation>postup byl odmítnut</translation>
    </message>
    <message>
        <source>the tracks moved less than the commanded advance</source>
        <translation>pásy ujely méně, než žádal povel</translation>
    </message>
    <message>
        <source>the tracks moved further than the commanded advance</source>
        <translation>pásy ujely více, než žádal povel</translation>
    </message>
    <message>
        <source>running</source>
        <translation>probíhá</translation>
    </message>
    <message>
        <source>the control was let go</source>
        <translation>prvek byl puštěn</translation>
    </message>
    <message>
        <source>the operator ended it</source>
        <translation>ukončil operátor</translation>
    </message>
    <message>
        <source>STOP was pressed</source>
        <translation>byl stisknut STOP</translation>
    </message>
    <message>
        <source>a fault</source>
        <translation>porucha</translation>
    </message>
    <message>
        <source>a probe would decide</source>
        <translation>rozhodla by sonda</translation>
    </message>
    <message>
        <source>telemetry is stale or was interrupted</source>
        <translation>telemetrie je zastaralá nebo byla přerušena</translation>
    </message>
    <message>
        <source>there is no verdict</source>
        <translation>není žádný verdikt</translation>
    </message>
    <message>
        <source>a sensor is suspected</source>
        <translation>některý snímač je podezřelý</translation>
    </message>
    <message>
        <source>the readings contradict the estimate</source>
        <translation>naměřené hodnoty odporují odhadu</translation>
    </message>
    <message>
        <source>the verdict is withheld</source>
        <translation>verdikt je zadržen</translation>
    </message>
    <message>
        <source>BLOCKED: there is a step ahead</source>
        <translation>PŘEKÁŽKA: vpředu je schod</translation>
    </message>
    <message>
        <source>the ground ahead is not felt</source>
        <translation>terén vpředu není ohmatán</translation>
    </message>
    <message>
        <source>the ground is felt less far than the flippers reach</source>
        <translation>terén je ohmatán méně daleko, než dosahují flippery</translation>
    </message>
    <message>
        <source>ground before the horizon is only bounded</source>
        <translation>terén před horizontem je jen omezen</translation>
    </message>
    <message>
        <source>CANNOT TELL: what was felt does not decide</source>
        <translation>NELZE ŘÍCI: ohmatané nerozhoduje</translation>
    </message>
    <message>
        <source>the ground is felt no further than the advance</source>
        <translation>terén není ohmatán dál, než je postup</translation>
    </message>
    <message>
        <source>pitch or roll is near its limit</source>
        <translation>sklon nebo náklon je blízko meze</translation>
    </message>
    <message>
        <source>the first felt ground</source>
        <translation>první ohmataný terén</translation>
    </message>
    <message>
        <source>the robot has turned</source>
        <translation>robot se otočil</translation>
    </message>
    <message>
        <source>the reported way has jumped</source>
        <translation>hlášená ujetá dráha skočila</translation>
    </message>
    <message>
        <source>the remembered ground was cleared</source>
        <translation>zapamatovaný terén byl smazán</translation>
    </message>
    <message>
        <source>nothing of the way is remembered: this scene alone counts</source>
        <translation>z cesty není nic zapamatováno: platí jen tato scéna</translation>
    </message>
    <message>
        <source>a table holds numbers of another size</source>
        <translation>tabulka obsahuje čísla jiné velikosti</translation>
    </message>
    <message>
        <source>its inputs are not those of this program</source>
        <translation>jeho vstupy nejsou vstupy tohoto programu</translation>
    </message>
    <message>
        <source>a bin&apos;s scale is missing</source>
        <translation>chybí měřítko bodu</translation>
    </message>
    <message>
        <source>a bin has two scales</source>
        <translation>bod má dvě měřítka</translation>
    </message>
    <message>
        <source>a layer of a network is too wide</source>
        <translation>vrstva sítě je příliš široká</translation>
    </message>
    <message>
        <source>a layer of a network is missing</source>
        <translation>chybí vrstva sítě</translation>
    </message>
    <message>
        <source>covered bins are out of range</source>
        <translation>zakryté body jsou mimo rozsah</translation>
    </message>
    <message>
        <source>a scene of the errors is missing, or there are too many</source>
        <translation>chybí scéna chyb, nebo je jich příliš mnoho</translation>
    </message>
    <message>
        <source>is an SQLite file of another application, not trail networks</source>
        <translation>je soubor SQLite jiného programu, ne sítě metody trail</translation>
    </message>
    <message>
        <source>is of another format version: `terratact train --drives` makes new networks</source>
        <translation>má jinou verzi formátu: nové sítě vytvoří `terratact train --drives`</translation>
    </message>
    <message>
        <source>its tables are not those of trail networks</source>
        <translation>jeho tabulky nejsou tabulky sítí metody trail</translation>
    </message>
    <message>
        <source>its seed is not a number</source>
        <translation>jeho semínko není číslo</translation>
    </message>
    <message>
        <source>it holds no network</source>
        <translation>neobsahuje žádnou síť</translation>
    </message>
    <message>
        <source>its content does not match its hash: it was changed or damaged</source>
        <translation>jeho obsah neodpovídá otisku: byl změněn nebo poškozen</translation>
    </message>
    <message>
        <source>it has rows of networks without layers</source>
        <translation>obsahuje řádky sítí bez vrstev</translation>
    </message>
    <message>
        <source>it has rows of an unknown kind of networks</source>
        <translation>obsahuje řádky neznámého druhu sítí</translation>
    </message>
    <message>
        <source>the networks of method trail give no finite number</source>
        <translation>sítě metody trail nedávají konečné číslo</translation>
    </message>
    <message>
        <source>left</source>
        <translation>vlevo</translation>
    </message>
    <message>
        <source>right</source>
        <translation>vpravo</translation>
    </message>
    <message>
        <source>P(step)</source>
        <translation>P(schod)</translation>
    </message>
    <message>
        <source>computing time</source>
        <translation>doba výpočtu</translation>
    </message>
    <message>
        <source>P(step), %1</source>
        <translation>P(schod), %1</translation>
    </message>
    <message>
        <source>mean sd ahead, %1</source>
        <translation>průměrná sd vpředu, %1</translation>
    </message>
    <message>
        <source>largest sd ahead, %1</source>
        <translation>největší sd vpředu, %1</translation>
    </message>
    <message>
        <source>mean absolute error, %1</source>
        <translation>průměrná absolutní chyba, %1</translation>
    </message>
    <message>
        <source>largest absolute error, %1</source>
        <translation>největší absolutní chyba, %1</translation>
    </message>
    <message>
        <source>height at %1 m, %2</source>
        <translation>výška v %1 m, %2</translation>
    </message>
    <message>
        <source>sd at %1 m, %2</source>
        <translation>sd v %1 m, %2</translation>
    </message>
    <message>
        <source>error at %1 m, %2</source>
        <translation>chyba v %1 m, %2</translation>
    </message>
    <message>
        <source>frames per second</source>
        <translation>rámců za sekundu</translation>
    </message>
    <message>
        <source>telemetry</source>
        <translation>telemetrie</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>sběrnice</translation>
    </message>
    <message>
        <source>estimate</source>
        <translation>odhad</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>náklad</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>podélný sklon</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>náklon</translation>
    </message>
    <message>
        <source>front flipper left</source>
        <translation>přední flipper vlevo</translation>
    </message>
    <message>
        <source>front flipper right</source>
        <translation>přední flipper vpravo</translation>
    </message>
    <message>
        <source>rear flipper left</source>
        <translation>zadní flipper vlevo</translation>
    </message>
    <message>
        <source>rear flipper right</source>
        <translation>zadní flipper vpravo</translation>
    </message>
    <message>
        <source>front current left</source>
        <translation>proud vpředu vlevo</translation>
    </message>
    <message>
        <source>front current right</source>
        <translation>proud vpředu vpravo</translation>
    </message>
    <message>
        <source>rear current left</source>
        <translation>proud vzadu vlevo</translation>
    </message>
    <message>
        <source>rear current right</source>
        <translation>proud vzadu vpravo</translation>
    </message>
    <message>
        <source>way of the tracks</source>
        <translation>dráha pásů</translation>
    </message>
    <message>
        <source>turn of the tracks</source>
        <translation>otočení pásů</translation>
    </message>
    <message>
        <source>differential</source>
        <translation>diferenciál</translation>
    </message>
    <message>
        <source>force %1, front left</source>
        <translation>síla %1, vpředu vlevo</translation>
    </message>
    <message>
        <source>force %1, front right</source>
        <translation>síla %1, vpředu vpravo</translation>
    </message>
    <message>
        <source>force %1, rear left</source>
        <translation>síla %1, vzadu vlevo</translation>
    </message>
    <message>
        <source>force %1, rear right</source>
        <translation>síla %1, vzadu vpravo</translation>
    </message>
    <message>
        <source>force %1</source>
        <translation>síla %1</translation>
    </message>
    <message>
        <source>reading was cancelled</source>
        <translation>čtení bylo zrušeno</translation>
    </message>
    <message>
        <source>the folder cannot be read: %1</source>
        <translation>složku nelze číst: %1</translation>
    </message>
    <message>
        <source>a memory of the way is expected to hold 103 or 202 numbers in their ranges</source>
        <translation>paměť cesty má obsahovat 103 nebo 202 čísel ve svých mezích</translation>
    </message>
    <message>
        <source>its inducing row count is not a positive whole number: %1</source>
        <translation>počet jejích opěrných řádků není kladné celé číslo: %1</translation>
    </message>
    <message>
        <source>its repeated row count is not a positive whole number: %1</source>
        <translation>počet jejích opakovaných řádků není kladné celé číslo: %1</translation>
    </message>
    <message>
        <source>the recording&apos;s clock was set forward by %1 s; the session continues evenly</source>
        <translation>hodiny záznamu byly posunuty vpřed o %1 s; relace pokračuje rovnoměrně</translation>
    </message>
    <message>
        <source>the recording&apos;s clock was set back by %1 s; the session continues evenly</source>
        <translation>hodiny záznamu byly vráceny o %1 s; relace pokračuje rovnoměrně</translation>
    </message>
    <message>
        <source>a CAN XL frame is not read; expected CAN or CAN FD</source>
        <translation>rámce CAN XL se nečtou; očekáván CAN nebo CAN FD</translation>
    </message>
    <message>
        <source>%1 frames have more bytes than their length says, which are left out; the first is in line %2</source>
        <translation>%1 rámců má více bajtů, než udává jejich délka; tyto bajty jsou vynechány, poprvé na řádku %2</translation>
    </message>
    <message>
        <source>the sd of its heights do not fit its training rows</source>
        <translation>směrodatné odchylky výšek neodpovídají trénovacím řádkům</translation>
    </message>
    <message>
        <source>sd of a height: %1</source>
        <translation>směrodatná odchylka výšky: %1</translation>
    </message>
    <message>
        <source>its unknown heights do not fit its training rows</source>
        <translation>jeho neznámé výšky neodpovídají trénovacím řádkům</translation>
    </message>
    <message>
        <source>its table of unknown heights names none</source>
        <translation>jeho tabulka neznámých výšek žádnou neuvádí</translation>
    </message>
    <message>
        <source>an unknown height is of a bin that does not exist</source>
        <translation>neznámá výška patří bodu, který neexistuje</translation>
    </message>
    <message>
        <source>it has a number for a height that is unknown</source>
        <translation>má číslo pro výšku, která je neznámá</translation>
    </message>
    <message>
        <source>a scanned row has an unknown height</source>
        <translation>skenovaný řádek má neznámou výšku</translation>
    </message>
    <message>
        <source>%1 scenes have unknown heights: the surfaces learn their known bins, the conditionals leave them out</source>
        <translation>%1 scén má neznámé výšky: povrchy se učí z jejich známých bodů, podmíněná rozdělení je vynechávají</translation>
    </message>
    <message>
        <source>%1 scenes of two tracks left out: a reading or all heights are unknown, or there are more than %2</source>
        <translation>%1 scén dvou pásů vynecháno: některý údaj nebo všechny výšky jsou neznámé, nebo je jich více než %2</translation>
    </message>
    <message>
        <source>%1 scenes of two tracks have unknown heights: their known bins are learnt</source>
        <translation>%1 scén dvou pásů má neznámé výšky: učí se jejich známé body</translation>
    </message>
    <message>
        <source>%1 is %2, expected %3 to %4</source>
        <translation>%1 je %2, očekáváno %3 až %4</translation>
    </message>
    <message>
        <source>row is %1, expected the number of a scene, from 1</source>
        <translation>row je %1, očekáváno číslo scény, od 1</translation>
    </message>
    <message>
        <source>decision is %1, expected accept or exclude</source>
        <translation>decision je %1, očekáváno accept nebo exclude</translation>
    </message>
    <message>
        <source>is not the header %1</source>
        <translation>není hlavička %1</translation>
    </message>
    <message>
        <source>row %1 already has a decision above, expected one for each row</source>
        <translation>řádek %1 už má výše rozhodnutí, očekáváno jedno na řádek</translation>
    </message>
    <message>
        <source>line %1: row %2 does not exist, the scenes have %3 rows; were they made again?</source>
        <translation>řádek %1: scéna %2 neexistuje, soubor má %3 scén; byl vytvořen znovu?</translation>
    </message>
    <message>
        <source>line %1: row %2 belongs to the run %3, not %4: take the decisions on these scenes</source>
        <translation>řádek %1: scéna %2 patří k jízdě %3, ne %4: použijte rozhodnutí k těmto scénám</translation>
    </message>
    <message>
        <source>the slice of a scene is damaged: write the file again</source>
        <translation>řez scény je poškozen: zapište soubor znovu</translation>
    </message>
    <message>
        <source>scene %1 is not one line of a scenes file</source>
        <translation>scéna %1 není řádek souboru scén</translation>
    </message>
    <message>
        <source>scene %1 is missing: write the file again</source>
        <translation>scéna %1 chybí: zapište soubor znovu</translation>
    </message>
    <message>
        <source>has more than %1 scenes</source>
        <translation>má více než %1 scén</translation>
    </message>
    <message>
        <source>scene %1: why it has no heights is unknown</source>
        <translation>scéna %1: proč nemá výšky, není známo</translation>
    </message>
    <message>
        <source>scene %1: its distance to the cloud is not a number</source>
        <translation>scéna %1: její vzdálenost od mračna není číslo</translation>
    </message>
    <message>
        <source>would hold %1 scenes; expected at most %2: take fewer scenes, or leave out --review</source>
        <translation>obsahoval by %1 scén; očekáváno nejvýše %2: vezměte méně scén nebo vynechte --review</translation>
    </message>
    <message>
        <source>is not a truth file: terratact truth --review writes one</source>
        <translation>není soubor skutečnosti: zapíše ho terratact truth --review</translation>
    </message>
    <message>
        <source>is a truth file of another version: write it again by terratact truth --review</source>
        <translation>je soubor skutečnosti jiné verze: zapište ho znovu příkazem terratact truth --review</translation>
    </message>
    <message>
        <source>is a damaged truth file: write it again</source>
        <translation>je poškozený soubor skutečnosti: zapište ho znovu</translation>
    </message>
    <message>
        <source>holds numbers, expected the names of the columns: add that line at the top, as docs/files.md shows it</source>
        <translation>obsahuje čísla, očekávají se názvy sloupců: přidejte tento řádek na začátek, jak ukazuje docs/files.md</translation>
    </message>
    <message>
        <source>is text in UTF-32: save it in UTF-8</source>
        <translation>je text v UTF-32: uložte jej v UTF-8</translation>
    </message>
    <message>
        <source>a quote does not end: close it, or delete the line</source>
        <translation>uvozovky nejsou uzavřeny: uzavřete je, nebo řádek smažte</translation>
    </message>
    <message>
        <source>is torn: has %1 fields where the header has %2, and the file does not end with a line end: delete the line</source>
        <translation>je utržený: má %1 polí, kde jich má záhlaví %2, a soubor nekončí koncem řádku: řádek smažte</translation>
    </message>
    <message>
        <source>%1: correct or delete the line</source>
        <translation>%1: opravte nebo smažte řádek</translation>
    </message>
    <message>
        <source>%1 is not a number: %2: write a number there</source>
        <translation>%1 není číslo: %2: napište tam číslo</translation>
    </message>
    <message>
        <source>%1 is not finite: %2: write a finite number there</source>
        <translation>%1 není konečné: %2: napište tam konečné číslo</translation>
    </message>
    <message>
        <source>is text in UTF-16: save it as UTF-8</source>
        <translation>je text v UTF-16: uložte jej jako UTF-8</translation>
    </message>
    <message>
        <source>zero bytes, as after a power loss, are left out</source>
        <translation>nulové bajty jako po výpadku napájení jsou vynechány</translation>
    </message>
    <message>
        <source>zero bytes, as after a power loss, are left out, and the text that they cut</source>
        <translation>nulové bajty jako po výpadku napájení jsou vynechány i s textem, který přerušily</translation>
    </message>
    <message>
        <source>expected %1, found %2: correct or delete the line</source>
        <translation>očekáváno: %1, nalezeno: %2: opravte nebo smažte řádek</translation>
    </message>
    <message>
        <source>is of version %1 of the format: export it as version 1.0 to 2.1</source>
        <translation>má verzi formátu %1: exportujte jej jako verzi 1.0 až 2.1</translation>
    </message>
    <message>
        <source>a step ahead of more than %1 mm: probability %2 ± %3, most likely at %4 m … %5 m (%6)</source>
        <translation>schod vyšší než %1 mm: pravděpodobnost %2 ± %3, nejspíš v %4 m … %5 m (%6)</translation>
    </message>
    <message>
        <source>%1 at %2 m</source>
        <translation>%1 v %2 m</translation>
    </message>
    <message>
        <source>%1 for the robot</source>
        <translation>%1 pro robota</translation>
    </message>
    <message>
        <source>both %1</source>
        <translation>obě strany %1</translation>
    </message>
    <message>
        <source>each side %1</source>
        <translation>každá strana %1</translation>
    </message>
    <message>
        <source>left %1 · right %2</source>
        <translation>vlevo %1 · vpravo %2</translation>
    </message>
    <message>
        <source>cross slope %1° of %2°</source>
        <translation>příčný sklon %1° z %2°</translation>
    </message>
    <message>
        <source>%1 to %2 m</source>
        <translation>%1 do %2 m</translation>
    </message>
    <message>
        <source>not felt: %1</source>
        <translation>neohmatáno: %1</translation>
    </message>
    <message>
        <source>%1 to %2 m, felt to %3 m</source>
        <translation>%1 do %2 m, ohmatáno do %3 m</translation>
    </message>
    <message>
        <source>a step ahead of more than %1 mm: probability %2 ± %3, likeliest between %4 and %5 m (%6)</source>
        <translation>schod vyšší než %1 mm: pravděpodobnost %2 ± %3, nejspíš mezi %4 a %5 m (%6)</translation>
    </message>
    <message>
        <source>the disk is full: free space on it, or name a file on another disk</source>
        <translation>disk je plný: uvolněte na něm místo, nebo zadejte soubor na jiném disku</translation>
    </message>
    <message>
        <source>line %1: along_m moves the cloud, but the truth file was written by an earlier version and does not hold its cells: write it again by terratact truth --review</source>
        <translation>řádek %1: along_m posouvá mračno bodů, ale soubor skutečnosti zapsala dřívější verze a nemá jeho buňky: zapište ho znovu příkazem terratact truth --review</translation>
    </message>
    <message>
        <source>along_m is %1, expected a multiple of %2: the cells of the cloud</source>
        <translation>along_m je %1, očekáván násobek %2: buňky mračna bodů</translation>
    </message>
    <message>
        <source>was written by an earlier version and holds no cells of the cloud: write it again by terratact truth --review to nudge along the way</source>
        <translation>zapsala dřívější verze a nemá buňky mračna bodů: pro posun podél cesty ho zapište znovu příkazem terratact truth --review</translation>
    </message>
    <message>
        <source>the cells of scene %1 are damaged: write the file again</source>
        <translation>buňky scény %1 jsou poškozené: zapište soubor znovu</translation>
    </message>
    <message>
        <source>%1: the column %2 was read as %3</source>
        <translation>%1: sloupec %2 byl přečten jako %3</translation>
    </message>
    <message>
        <source>its journal %1 was written for another session: move it away</source>
        <translation>její žurnál %1 patří jiné relaci: přesuňte ho jinam</translation>
    </message>
    <message>
        <source>%1 to %2 m, nothing felt ahead</source>
        <translation>%1 do %2 m, vpředu nic neohmatáno</translation>
    </message>
    <message>
        <source>bounded: %1</source>
        <translation>omezeno: %1</translation>
    </message>
    <message>
        <source>the number of a drive is out of range</source>
        <translation>číslo jízdy je mimo rozsah</translation>
    </message>
    <message>
        <source>a step of more than %1 m anywhere ahead, felt or not: P %2 ± %3, most likely at %4 … %5 m (P %6)</source>
        <translation>schod vyšší než %1 m kdekoli vpředu, ohmataný i neohmataný: P %2 ± %3, nejspíš v %4 … %5 m (P %6)</translation>
    </message>
    <message>
        <source>is empty: expected a line with the names of its columns</source>
        <translation>je prázdný: očekává se řádek s názvy sloupců</translation>
    </message>
    <message>
        <source>is empty: copy it again</source>
        <translation>je prázdný: zkopírujte jej znovu</translation>
    </message>
    <message>
        <source>has %1 bytes where its header says %2: it is truncated, copy it again</source>
        <translation>má %1 bajtů, hlavička udává %2: je uříznutý, zkopírujte jej znovu</translation>
    </message>
    <message>
        <source>a row is more than 36 years from the session&apos;s begin, which no reader accepts: split the recording, or correct its clock</source>
        <translation>řádek je od začátku relace vzdálen více než 36 let, což žádná čtečka nepřijme: rozdělte záznam, nebo opravte jeho hodiny</translation>
    </message>
    <message>
        <source>it has the name of a session&apos;s journal: name another file</source>
        <translation>má název žurnálu relace: zadejte jiný soubor</translation>
    </message>
    <message>
        <source>is there already: name another file</source>
        <translation>již existuje: zadejte jiný soubor</translation>
    </message>
    <message>
        <source>the file system refuses it: %1</source>
        <translation>souborový systém to odmítl: %1</translation>
    </message>
    <message>
        <source>%1 is there already and would be taken for its journal: name another file</source>
        <translation>%1 již existuje a bylo by považováno za jeho žurnál: zadejte jiný soubor</translation>
    </message>
    <message>
        <source>cannot be written: is the disk full, or the file larger than ulimit -f allows?</source>
        <translation>nelze zapsat: není disk plný, nebo soubor větší, než dovoluje ulimit -f?</translation>
    </message>
    <message>
        <source>a command could not be sent</source>
        <translation>povel nebylo možné odeslat</translation>
    </message>
    <message>
        <source>the robot did not begin the exploration in time</source>
        <translation>robot nezačal průzkum včas</translation>
    </message>
    <message>
        <source>the memory of the way needs every current and force: only the arm&apos;s earlier readings are used</source>
        <translation>paměť cesty potřebuje všechny proudy a síly: použijí se jen dřívější měření ramene</translation>
    </message>
    <message>
        <source>the memory of the way needs every current and force: this scene alone counts</source>
        <translation>paměť cesty potřebuje všechny proudy a síly: platí jen tato scéna</translation>
    </message>
    <message>
        <source>of the way, only the arm&apos;s earlier readings are used</source>
        <translation>z cesty se použijí jen dřívější měření ramene</translation>
    </message>
    <message>
        <source>the track differential has turned, left and right ground differ</source>
        <translation>diferenciál pásů je pootočen, terén vlevo a vpravo se liší</translation>
    </message>
    <message>
        <source>the odometry or the pitch is suspected</source>
        <translation>odometrie nebo podélný sklon jsou podezřelé</translation>
    </message>
    <message>
        <source>a training drive is missing</source>
        <translation>chybí trénovací jízda</translation>
    </message>
    <message>
        <source>%1 more things are left out, in lines %2</source>
        <translation>další vynechané věci: %1, na řádcích %2</translation>
    </message>
    <message>
        <source>the signal %1 is left out: its message %2 has more than %3 signals</source>
        <translation>signál %1 je vynechán: jeho zpráva %2 má více než %3 signálů</translation>
    </message>
    <message>
        <source>there is no home folder that may hold recordings: name a folder, or set HOME or XDG_STATE_HOME</source>
        <translation>není domovská složka pro záznamy: uveďte složku, nebo nastavte HOME nebo XDG_STATE_HOME</translation>
    </message>
    <message>
        <source>%1: the key %2 is missing</source>
        <translation>%1: chybí klíč %2</translation>
    </message>
    <message>
        <source>its tables take more steps to read than a file of its size needs</source>
        <translation>čtení jeho tabulek trvá déle, než soubor této velikosti potřebuje</translation>
    </message>
    <message>
        <source>%1 is longer than %2 bytes: the rest is left out</source>
        <translation>%1: delší než %2 bajtů, zbytek je vynechán</translation>
    </message>
    <message>
        <source>the message %1 describes up to %2 signals in a frame of %3 bytes: only the first %4 of a frame are read</source>
        <translation>zpráva %1 popisuje až %2 signálů v rámci o %3 bajtech: čte se jen prvních %4 z rámce</translation>
    </message>
    <message>
        <source>its journal %1 is damaged from byte %2: %3 pages in it are not read</source>
        <translation>její žurnál %1 je poškozen od bajtu %2: počet stránek, které se z něj nečtou: %3</translation>
    </message>
    <message>
        <source>has zero bytes, which are read as blanks</source>
        <translation>obsahuje nulové bajty, které se čtou jako mezery</translation>
    </message>
    <message>
        <source>the word %1 is left out: expected its raw value in at most 64 bits, with all its digits</source>
        <translation>slovo %1 je vynecháno: očekává se jeho surová hodnota nejvýše v 64 bitech a se všemi číslicemi</translation>
    </message>
    <message>
        <source>the long name %1 of the signal %2 is left out: %3 has another signal of that name</source>
        <translation>dlouhý název %1 signálu %2 je vynechán: %3 má jiný signál téhož názvu</translation>
    </message>
    <message>
        <source>%1 has lost its digits in a spreadsheet: export the log again, and keep this column as text</source>
        <translation>%1 ztratil v tabulkovém procesoru číslice: exportujte záznam znovu a tento sloupec ponechte jako text</translation>
    </message>
    <message>
        <source>a workbook of an office program</source>
        <translation>sešit kancelářského programu</translation>
    </message>
    <message>
        <source>a PDF file</source>
        <translation>soubor PDF</translation>
    </message>
    <message>
        <source>is a log of slcan, which is not read: record the bus with candump -l</source>
        <translation>je záznam slcan, který se nečte: zaznamenejte sběrnici pomocí candump -l</translation>
    </message>
    <message>
        <source>no text in UTF-8</source>
        <translation>soubor, který není textem v UTF-8</translation>
    </message>
    <message>
        <source>no force was measured: the other side&apos;s forces count for both</source>
        <translation>nebyla změřena žádná síla: pro obě strany platí síly druhé strany</translation>
    </message>
    <message>
        <source>the force of element %1 was not measured: the other side&apos;s counts for both</source>
        <translation>síla prvku %1 nebyla změřena: pro obě strany platí síla druhé strany</translation>
    </message>
    <message>
        <source>the %1 was not measured: the other side counts for both</source>
        <translation>%1: nezměřeno, za obě strany platí druhá</translation>
    </message>
    <message>
        <source>repeats the header: a second table begins here: save each table as a file of its own</source>
        <translation>opakuje hlavičku: zde začíná druhá tabulka: uložte každou tabulku do vlastního souboru</translation>
    </message>
    <message>
        <source>%1, and no number: does a second table begin here? save it as a file of its own, or correct the line</source>
        <translation>%1, a žádné číslo: začíná zde druhá tabulka? uložte ji do vlastního souboru, nebo opravte řádek</translation>
    </message>
    <message>
        <source>%1 is not a number: %2, and its line holds none: does a second table begin here? save it as a file of its own, or write a number there</source>
        <translation>%1 není číslo: %2, a řádek žádné neobsahuje: začíná zde druhá tabulka? uložte ji do vlastního souboru, nebo zde napište číslo</translation>
    </message>
</context>
<context>
    <name>event</name>
    <message>
        <source>up</source>
        <translation>funguje</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>ztraceno</translation>
    </message>
    <message>
        <source>telemetry lost</source>
        <translation>telemetrie ztracena</translation>
    </message>
    <message>
        <source>approve</source>
        <translation>schválit</translation>
    </message>
    <message>
        <source>choose</source>
        <translation>zvolit</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>jet</translation>
    </message>
    <message>
        <source>explore</source>
        <translation>prozkoumat</translation>
    </message>
    <message>
        <source>abort</source>
        <translation>přerušit</translation>
    </message>
    <message>
        <source>halt</source>
        <translation>zastavit jízdu</translation>
    </message>
    <message>
        <source>override</source>
        <translation>přebití</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>odmítnout</translation>
    </message>
    <message>
        <source>release stop</source>
        <translation>uvolnit STOP</translation>
    </message>
    <message>
        <source>second method</source>
        <translation>druhá metoda</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>nastavení</translation>
    </message>
    <message>
        <source>forward</source>
        <translation>vpřed</translation>
    </message>
    <message>
        <source>back</source>
        <translation>zpět</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádná</translation>
    </message>
    <message>
        <source>begun</source>
        <translation>začala</translation>
    </message>
    <message>
        <source>continued</source>
        <translation>pokračuje</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>skončila</translation>
    </message>
    <message>
        <source>recovered</source>
        <translation>obnovena</translation>
    </message>
    <message>
        <source>merged</source>
        <translation>sloučena</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>chybí</translation>
    </message>
    <message>
        <source>log</source>
        <translation>záznam</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>operátor</translation>
    </message>
    <message>
        <source>silence</source>
        <translation>žádná telemetrie</translation>
    </message>
    <message>
        <source>link</source>
        <translation>spojení</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>sběrnice</translation>
    </message>
    <message>
        <source>foreign</source>
        <translation>jiná konzole</translation>
    </message>
    <message>
        <source>dropped</source>
        <translation>ztracené rámce</translation>
    </message>
    <message>
        <source>checksum</source>
        <translation>kontrolní součet</translation>
    </message>
    <message>
        <source>disarmed</source>
        <translation>neaktivní</translation>
    </message>
    <message>
        <source>sensors</source>
        <translation>snímače</translation>
    </message>
    <message>
        <source>model</source>
        <translation>model</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>panel</translation>
    </message>
    <message>
        <source>exploration</source>
        <translation>průzkum</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>záznam relace</translation>
    </message>
    <message>
        <source>atem</source>
        <translation>ATEM</translation>
    </message>
    <message>
        <source>confirm to arm</source>
        <translation>čeká se na potvrzení aktivace</translation>
    </message>
    <message>
        <source>waiting for the robot to arm</source>
        <translation>čeká se, až se robot aktivuje</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>aktivní</translation>
    </message>
    <message>
        <source>clock</source>
        <translation>hodiny</translation>
    </message>
    <message>
        <source>forget</source>
        <translation>zapomenout</translation>
    </message>
    <message>
        <source>restore</source>
        <translation>vrátit</translation>
    </message>
    <message>
        <source>sensor-fault</source>
        <translation>porucha snímače</translation>
    </message>
    <message>
        <source>attitude</source>
        <translation>náklon</translation>
    </message>
    <message>
        <source>feel forward</source>
        <translation>ohmatávat vpřed</translation>
    </message>
    <message>
        <source>let go</source>
        <translation>puštěno</translation>
    </message>
    <message>
        <source>snapshot</source>
        <translation>snímek</translation>
    </message>
    <message>
        <source>snapshot note</source>
        <translation>poznámka ke snímku</translation>
    </message>
</context>
<context>
    <name>source</name>
    <message>
        <source>SIMULATED ROBOT</source>
        <translation>SIMULOVANÝ ROBOT</translation>
    </message>
    <message>
        <source>REPLAY %1</source>
        <translation>PŘEHRÁVÁNÍ %1</translation>
    </message>
</context>
<context>
    <name>terratact::AlarmTable</name>
    <message>
        <source>▲ CRITICAL, new</source>
        <translation>▲ KRITICKÉ, nové</translation>
    </message>
    <message>
        <source>◆ caution, new</source>
        <translation>◆ pozor, nové</translation>
    </message>
    <message>
        <source>▽ over, not seen</source>
        <translation>▽ pominulo, neviděno</translation>
    </message>
    <message>
        <source>■ critical, seen</source>
        <translation>■ kritické, viděno</translation>
    </message>
    <message>
        <source>■ caution, seen</source>
        <translation>■ pozor, viděno</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>už %1</translation>
    </message>
    <message>
        <source>over for %1</source>
        <translation>pominul před %1</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmy</translation>
    </message>
    <message>
        <source>Alarms, most urgent first</source>
        <translation>Alarmy, nejnaléhavější první</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stav</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Co</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Od</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Krát</translation>
    </message>
    <message>
        <source>✔ No alarms.</source>
        <translation>✔ Bez alarmů.</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>Potvrdit</translation>
    </message>
    <message>
        <source>Acknowledges the selected alarm</source>
        <translation>Potvrdí vybraný alarm</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>Potvrdit vše</translation>
    </message>
    <message>
        <source>Acknowledges all alarms</source>
        <translation>Potvrdí všechny alarmy</translation>
    </message>
    <message>
        <source>Mute 60 s</source>
        <translation>Ticho 60 s</translation>
    </message>
    <message>
        <source>Mutes alarms for 60 s; new alarms still sound</source>
        <translation>Minutu ticho; nový alarm přesto zazní</translation>
    </message>
    <message>
        <source>Mute 120 s</source>
        <translation>Ticho 120 s</translation>
    </message>
    <message>
        <source>Mutes alarms for 120 s; new alarms still sound</source>
        <translation>Dvě minuty ticho; nový alarm přesto zazní</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Zvuk</translation>
    </message>
    <message>
        <source>Critical alarms beep until they are acknowledged: at once, then every 10 s</source>
        <translation>Kritické alarmy pípají do potvrzení: hned a pak každých 10 s</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>Ticho</translation>
    </message>
    <message>
        <source>muted for %1</source>
        <translation>ticho %1</translation>
    </message>
    <message>
        <source>No alarm is active</source>
        <translation>Není žádný alarm</translation>
    </message>
    <message>
        <source>No alarm is selected in the list</source>
        <translation>V seznamu není vybrán žádný alarm</translation>
    </message>
    <message>
        <source>Test the sound</source>
        <translation>Vyzkoušet zvuk</translation>
    </message>
    <message>
        <source>Plays the alarm sound once</source>
        <translation>Zazní jednou, jako alarm</translation>
    </message>
    <message>
        <source>✘ Only the desktop&apos;s bell can sound: %1</source>
        <translation>✘ Žádný zvuk kromě zvonku plochy: %1</translation>
    </message>
</context>
<context>
    <name>terratact::AlarmsPage</name>
    <message>
        <source>Alarms</source>
        <translation>Alarmy</translation>
    </message>
</context>
<context>
    <name>terratact::ArmingControl</name>
    <message>
        <source>Arming</source>
        <translation>Aktivace</translation>
    </message>
    <message>
        <source>hold to arm (M)</source>
        <translation>držet: aktivovat (M)</translation>
    </message>
    <message>
        <source>Hold to arm the robot</source>
        <translation>Držením aktivovat robota</translation>
    </message>
    <message>
        <source>Hold within 5 s; then commands from this console move the robot</source>
        <translation>Do 5 s; pak povely odtud pohybují robotem</translation>
    </message>
    <message>
        <source>Commands from this console move the robot. A click halts and disarms it</source>
        <translation>Povely odtud pohybují robotem. Kliknutí ho zastaví a deaktivuje</translation>
    </message>
    <message>
        <source>Asks for a second action within 5 s</source>
        <translation>Do 5 s vyžádá druhý úkon</translation>
    </message>
    <message>
        <source>
Last disarmed: %1</source>
        <translation>
Poslední deaktivace: %1</translation>
    </message>
    <message>
        <source>DISARMED · arm (M)</source>
        <translation>NEAKTIVNÍ · aktivovat (M)</translation>
    </message>
    <message>
        <source>ARMED · disarm (M)</source>
        <translation>AKTIVNÍ · deaktivovat (M)</translation>
    </message>
    <message>
        <source>arming … cancel (M)</source>
        <translation>aktivace … zrušit (M)</translation>
    </message>
    <message>
        <source>NO COMMANDS</source>
        <translation>BEZ POVELŮ</translation>
    </message>
    <message>
        <source>Not possible now:</source>
        <translation>Teď nelze:</translation>
    </message>
</context>
<context>
    <name>terratact::AtemPanel</name>
    <message>
        <source>Exploration (ATEM)</source>
        <translation>Průzkum (ATEM)</translation>
    </message>
    <message>
        <source>State of the exploration</source>
        <translation>Stav průzkumu</translation>
    </message>
    <message>
        <source>Explore the terrain (A)</source>
        <translation>Prozkoumat terén (A)</translation>
    </message>
    <message>
        <source>Abort (Esc)</source>
        <translation>Přerušit (Esc)</translation>
    </message>
    <message>
        <source>hold to release STOP (R)</source>
        <translation>držet: uvolnit STOP (R)</translation>
    </message>
    <message>
        <source>Hold to release STOP</source>
        <translation>Držením uvolnit STOP</translation>
    </message>
    <message>
        <source>Allows commands again; the robot does not move by itself</source>
        <translation>Povely zase projdou; robot se sám nepohne</translation>
    </message>
    <message>
        <source>; no answer in time counts as refused</source>
        <translation>; bez odpovědi včas, tedy bez sondy</translation>
    </message>
    <message>
        <source>, arm included</source>
        <translation>, včetně ramene</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>zbývá %1</translation>
    </message>
    <message>
        <source>An exploration is running: end it with Esc first</source>
        <translation>Běží průzkum: nejdřív ho ukončete klávesou Esc</translation>
    </message>
    <message>
        <source>Halts the robot, presses the front flippers down and estimates the terrain</source>
        <translation>Zastaví robota, přitlačí přední flippery a odhadne terén</translation>
    </message>
    <message>
        <source>Halts the robot and ends the exploration</source>
        <translation>Zastaví robota a ukončí průzkum</translation>
    </message>
    <message>
        <source>No exploration is running</source>
        <translation>Žádný průzkum neběží</translation>
    </message>
    <message>
        <source>Override (O)</source>
        <translation>Přesto (O)</translation>
    </message>
    <message>
        <source>Explores in spite of the doubtful requirement. The override is recorded and stays on the screen</source>
        <translation>Prozkoumá navzdory spornému předpokladu. Přebití se zaznamená a zůstane na obrazovce</translation>
    </message>
    <message>
        <source>about %1 left</source>
        <translation>zbývá asi %1</translation>
    </message>
    <message>
        <source>gives up in %1</source>
        <translation>vzdá to za %1</translation>
    </message>
    <message>
        <source>Not possible now:</source>
        <translation>Teď nelze:</translation>
    </message>
    <message>
        <source>Doubtful, override it first (O):</source>
        <translation>Sporné, nejdřív přebijte (O):</translation>
    </message>
    <message>
        <source>exploring</source>
        <translation>průzkum</translation>
    </message>
    <message>
        <source>driving</source>
        <translation>jízda</translation>
    </message>
    <message>
        <source>arming</source>
        <translation>aktivace</translation>
    </message>
    <message>
        <source>approving a probe</source>
        <translation>schválení sondy</translation>
    </message>
    <message>
        <source>releasing STOP</source>
        <translation>uvolnění STOP</translation>
    </message>
    <message>
        <source>needs (P)</source>
        <translation>potřeby (P)</translation>
    </message>
    <message>
        <source>Requirements of a command</source>
        <translation>Co povel potřebuje</translation>
    </message>
    <message>
        <source>Requirements of each command, and which are missing (P)</source>
        <translation>Co který povel potřebuje a co z toho chybí (P)</translation>
    </message>
    <message>
        <source>%1 needs:</source>
        <translation>%1 potřebuje:</translation>
    </message>
    <message>
        <source>nothing is explored</source>
        <translation>nic se nezkoumá</translation>
    </message>
    <message>
        <source>not ready</source>
        <translation>nepřipraveno</translation>
    </message>
    <message>
        <source>not ready: doubtful</source>
        <translation>nepřipraveno: sporné</translation>
    </message>
    <message>
        <source>Exploration</source>
        <translation>Průzkum</translation>
    </message>
    <message>
        <source>Forget (Del)</source>
        <translation>Zapomenout (Del)</translation>
    </message>
    <message>
        <source>The robot presses again, then the probe is proposed. The arm moves only after your approval</source>
        <translation>Robot znovu přitlačí, pak se navrhne rameno; než je schválíte, rameno se nepohne</translation>
    </message>
    <message>
        <source>Hides the result; Ctrl+Z restores it</source>
        <translation>Odstraní výsledek z obrazovky; Ctrl+Z ho vrátí</translation>
    </message>
    <message>
        <source>Probe %1 (B)</source>
        <translation>Sonda %1 (B)</translation>
    </message>
    <message>
        <source>Explore (A)</source>
        <translation>Prozkoumat (A)</translation>
    </message>
    <message>
        <source>Probe (B)</source>
        <translation>Sonda (B)</translation>
    </message>
</context>
<context>
    <name>terratact::BinInspector</name>
    <message>
        <source>Selected bin</source>
        <translation>Bod zblízka</translation>
    </message>
</context>
<context>
    <name>terratact::ConnectWindow</name>
    <message>
        <source>can be used</source>
        <translation>lze použít</translation>
    </message>
    <message>
        <source>can be used, see below</source>
        <translation>lze použít, viz níže</translation>
    </message>
    <message>
        <source>cannot be used, see below</source>
        <translation>nelze použít, viz níže</translation>
    </message>
    <message>
        <source>repair: %1</source>
        <translation>oprava: %1</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Připojit</translation>
    </message>
    <message>
        <source>In use: %1</source>
        <translation>V provozu: %1</translation>
    </message>
    <message>
        <source>What to work with</source>
        <translation>S čím pracovat</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Co se zjistilo</translation>
    </message>
    <message>
        <source>This console may send commands on that bus</source>
        <translation>Tato konzole smí na sběrnici posílat povely</translation>
    </message>
    <message>
        <source>Without it, the console only listens; like --transmit at the start</source>
        <translation>Bez toho konzole jen poslouchá; jako --transmit při startu</translation>
    </message>
    <message>
        <source>Why it is not connected</source>
        <translation>Proč není připojeno</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Hledat znovu</translation>
    </message>
    <message>
        <source>Looks at the CAN interfaces of this computer again</source>
        <translation>Znovu prohledá rozhraní CAN tohoto počítače</translation>
    </message>
    <message>
        <source>Simulated robot in this program</source>
        <translation>Simulovaný robot v tomto programu</translation>
    </message>
    <message>
        <source>CAN bus %1 — %2</source>
        <translation>Sběrnice CAN %1 — %2</translation>
    </message>
    <message>
        <source>Log to replay, in another window</source>
        <translation>Záznam k přehrání, v jiném okně</translation>
    </message>
    <message>
        <source>Session to review, in another window</source>
        <translation>Relace k prohlížení, v jiném okně</translation>
    </message>
    <message>
        <source>This interface cannot be used: repair it first, then look again</source>
        <translation>Toto rozhraní nelze použít: nejdřív je opravte, pak hledejte znovu</translation>
    </message>
    <message>
        <source>✔ Needs no hardware. Its ground is the one that the console was started with</source>
        <translation>✔ Nepotřebuje hardware. Jeho terén je ten, se kterým konzole začala</translation>
    </message>
    <message>
        <source>Logs of candump, Vector (.asc), PEAK (.trc), GVRET and python-can, also packed by gzip</source>
        <translation>Záznamy candump, Vector (.asc), PEAK (.trc), GVRET a python-can, i zabalené gzip</translation>
    </message>
    <message>
        <source>Choose a log …</source>
        <translation>Zvolit záznam …</translation>
    </message>
    <message>
        <source>Recordings of this console (.tts), in %1</source>
        <translation>Záznamy této konzole (.tts), v %1</translation>
    </message>
    <message>
        <source>Choose a session …</source>
        <translation>Zvolit relaci …</translation>
    </message>
    <message>
        <source>Restarts the console with it (Return)</source>
        <translation>Restartuje s tím konzoli (Return)</translation>
    </message>
    <message>
        <source>Session to review</source>
        <translation>Relace k prohlížení</translation>
    </message>
    <message>
        <source>Log to replay</source>
        <translation>Záznam k přehrání</translation>
    </message>
    <message>
        <source>Sessions (*.tts)</source>
        <translation>Relace (*.tts)</translation>
    </message>
    <message>
        <source>%1 is no session; choose a recording of this console, or replay it as a log</source>
        <translation>%1 není relace; zvolte záznam této konzole, nebo jej přehrajte jako záznam sběrnice</translation>
    </message>
    <message>
        <source>%1 is a session; choose it as a session</source>
        <translation>%1 je relace; zvolte ji jako relaci</translation>
    </message>
    <message>
        <source>Looking for CAN buses …</source>
        <translation>Hledají se sběrnice CAN …</translation>
    </message>
    <message>
        <source>Choose what to work with</source>
        <translation>Zvolte, s čím pracovat</translation>
    </message>
    <message>
        <source>CAN bus %1 is no longer there</source>
        <translation>Sběrnice CAN %1 už tu není</translation>
    </message>
    <message>
        <source>Logs and recordings of other programs (*.log *.asc *.trc *.csv *.gz *.mcap *.bag *.db3);;All files (*)</source>
        <translation>Záznamy sběrnice a záznamy jiných programů (*.log *.asc *.trc *.csv *.gz *.mcap *.bag *.db3);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Recordings of this console (.tts)</source>
        <translation>Záznamy této konzole (.tts)</translation>
    </message>
</context>
<context>
    <name>terratact::ConsoleAlarms</name>
    <message>
        <source>No model, so nothing can be estimated: %1</source>
        <translation>Bez modelu nelze nic odhadnout: %1</translation>
    </message>
    <message>
        <source>Exploration failed: %1</source>
        <translation>Průzkum selhal: %1</translation>
    </message>
    <message>
        <source>The robot is stopped and moves only after a release</source>
        <translation>Robot je zastaven a pohne se až po uvolnění</translation>
    </message>
    <message>
        <source>Another console sends commands on this bus: find it and turn it off</source>
        <translation>Na sběrnici vysílá povely jiná konzole: najděte ji a vypněte</translation>
    </message>
    <message>
        <source>This computer was too slow for the bus: %1 frames lost since the start</source>
        <translation>Tento počítač nestíhal sběrnici: od spuštění ztraceno %1 rámců</translation>
    </message>
    <message>
        <source>Damaged frames: %1 with a wrong checksum since the start</source>
        <translation>Poškozené rámce: od spuštění %1 se špatným součtem</translation>
    </message>
    <message>
        <source>Force sensors not usable: %1</source>
        <translation>Silové snímače nepoužitelné: %1</translation>
    </message>
    <message>
        <source>Not recorded: %1</source>
        <translation>Nezaznamenává se: %1</translation>
    </message>
    <message>
        <source>%1; gaps: %2, the longest %3</source>
        <translation>%1; výpadky: %2, nejdelší %3</translation>
    </message>
    <message>
        <source>Disarmed: %1</source>
        <translation>Už není aktivní: %1</translation>
    </message>
    <message>
        <source>pitch %1, tips over at %2</source>
        <translation>podélný sklon %1, převrátí se při %2</translation>
    </message>
    <message>
        <source>roll %1, tips over at %2</source>
        <translation>náklon %1, převrátí se při %2</translation>
    </message>
    <message>
        <source>Danger of tipping over: %1</source>
        <translation>Hrozí převrácení: %1</translation>
    </message>
    <message>
        <source>Steep: %1</source>
        <translation>Strmě: %1</translation>
    </message>
    <message>
        <source>Do not trust this sensor: %1</source>
        <translation>Tomuto snímači nevěřte: %1</translation>
    </message>
    <message>
        <source>The robot has halted by itself: %1</source>
        <translation>Robot se sám zastavil: %1</translation>
    </message>
    <message>
        <source>left %1 %2</source>
        <translation>vlevo %1 %2</translation>
    </message>
    <message>
        <source>right %1 %2</source>
        <translation>vpravo %1 %2</translation>
    </message>
    <message>
        <source>Telemetry unsteady</source>
        <translation>Telemetrie nestálá</translation>
    </message>
    <message>
        <source>Link unsteady</source>
        <translation>Spojení nestálé</translation>
    </message>
    <message>
        <source>Telemetry lost</source>
        <translation>Telemetrie ztracena</translation>
    </message>
    <message>
        <source>Link lost</source>
        <translation>Spojení ztraceno</translation>
    </message>
    <message>
        <source>No telemetry since the start</source>
        <translation>Od spuštění nepřišla telemetrie</translation>
    </message>
</context>
<context>
    <name>terratact::ConsoleWindow</name>
    <message>
        <source>View</source>
        <translation>Vzhled</translation>
    </message>
    <message>
        <source>Layout, colours and font size</source>
        <translation>Rozvržení, barvy a velikost písma</translation>
    </message>
    <message>
        <source>this sheet</source>
        <translation>tento přehled</translation>
    </message>
    <message>
        <source>STOP HAS NO EFFECT HERE: this window has no robot. Use the console&apos;s own window</source>
        <translation>STOP TU NEPŮSOBÍ: toto okno nemá robota. Přejděte do okna konzole</translation>
    </message>
    <message>
        <source>no STOP: this window has no robot</source>
        <translation>žádný STOP: toto okno nemá robota</translation>
    </message>
    <message>
        <source>Sends STOP through the console that opened this window</source>
        <translation>STOP konzole, která toto okno otevřela</translation>
    </message>
    <message>
        <source>SAFE MODE: default settings; none are read or saved · start without --safe-mode to leave it</source>
        <translation>NOUZOVÝ REŽIM: výchozí nastavení, nic se nečte ani neukládá · ukončíte ho spuštěním bez --safe-mode</translation>
    </message>
    <message>
        <source>Help
F1</source>
        <translation>Nápověda
F1</translation>
    </message>
    <message>
        <source>All keys, and about this program</source>
        <translation>Všechny klávesy a co je tento program</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Nápověda</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Klávesy</translation>
    </message>
    <message>
        <source>About Terratact</source>
        <translation>O programu Terratact</translation>
    </message>
    <message>
        <source>what this program is</source>
        <translation>co je tento program</translation>
    </message>
    <message>
        <source>Recorded demonstration</source>
        <translation>Nahraná ukázka</translation>
    </message>
    <message>
        <source>Recorded demonstration, two tracks</source>
        <translation>Nahraná ukázka, dva pásy</translation>
    </message>
    <message>
        <source>full screen, and back</source>
        <translation>celá obrazovka a zpět</translation>
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
        <translation>Verze</translation>
    </message>
    <message>
        <source>kernel</source>
        <translation>jádro</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Procesor</translation>
    </message>
    <message>
        <source>cores</source>
        <translation>jádra</translation>
    </message>
    <message>
        <source>estimator uses</source>
        <translation>odhad používá</translation>
    </message>
    <message>
        <source>training uses</source>
        <translation>trénink používá</translation>
    </message>
    <message>
        <source>✔ possible</source>
        <translation>✔ možné</translation>
    </message>
    <message>
        <source>✘ not possible: %1</source>
        <translation>✘ není možné: %1</translation>
    </message>
    <message>
        <source>none here</source>
        <translation>zde žádné</translation>
    </message>
    <message>
        <source>✔ %1</source>
        <translation>✔ %1</translation>
    </message>
    <message>
        <source>✘ %1: no permission (join the group gpio)</source>
        <translation>✘ %1: bez oprávnění (vstupte do skupiny gpio)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádná</translation>
    </message>
    <message>
        <source>Permissions</source>
        <translation>Oprávnění</translation>
    </message>
    <message>
        <source>CAN socket</source>
        <translation>soket CAN</translation>
    </message>
    <message>
        <source>CAN interfaces</source>
        <translation>rozhraní CAN</translation>
    </message>
    <message>
        <source>GPIO chips</source>
        <translation>čipy GPIO</translation>
    </message>
    <message>
        <source>groups</source>
        <translation>skupiny</translation>
    </message>
    <message>
        <source>Last minute</source>
        <translation>Poslední minuta</translation>
    </message>
    <message>
        <source>a frame takes</source>
        <translation>snímek trvá</translation>
    </message>
    <message>
        <source>an event waits</source>
        <translation>událost čeká</translation>
    </message>
    <message>
        <source>telemetry to screen</source>
        <translation>z telemetrie na obrazovku</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnostika</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Kopírovat jako text</translation>
    </message>
    <message>
        <source>Copies this page, for a report</source>
        <translation>Celá stránka, pro hlášení</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Teď</translation>
    </message>
    <message>
        <source>age of the telemetry</source>
        <translation>stáří telemetrie</translation>
    </message>
    <message>
        <source>telemetry</source>
        <translation>telemetrie</translation>
    </message>
    <message>
        <source>CAN frames waiting</source>
        <translation>čekající rámce CAN</translation>
    </message>
    <message>
        <source>%1 now, %2 at most</source>
        <translation>%1 teď, nejvýš %2</translation>
    </message>
    <message>
        <source>estimator</source>
        <translation>odhad</translation>
    </message>
    <message>
        <source>one estimate under way</source>
        <translation>jeden odhad běží</translation>
    </message>
    <message>
        <source>idle</source>
        <translation>nečinný</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>paměť</translation>
    </message>
    <message>
        <source>What it works with</source>
        <translation>S čím pracuje</translation>
    </message>
    <message>
        <source>source</source>
        <translation>zdroj</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>facts of the robot</source>
        <translation>údaje o robotu</translation>
    </message>
    <message>
        <source>model</source>
        <translation>model</translation>
    </message>
    <message>
        <source>facts of the model</source>
        <translation>údaje o modelu</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>sepnuto</translation>
    </message>
    <message>
        <source>open</source>
        <translation>rozepnuto</translation>
    </message>
    <message>
        <source>%1 · edges %2</source>
        <translation>%1 · hran %2</translation>
    </message>
    <message>
        <source>%1 · edges %2 · presses %3</source>
        <translation>%1 · hran %2 · stisků %3</translation>
    </message>
    <message>
        <source>newest %1 · worst %2 of %3</source>
        <translation>poslední %1 · nejhorší %2 z %3</translation>
    </message>
    <message>
        <source>Operator&apos;s panel</source>
        <translation>Panel operátora</translation>
    </message>
    <message>
        <source>panel</source>
        <translation>panel</translation>
    </message>
    <message>
        <source>✘ does not answer: %1</source>
        <translation>✘ neodpovídá: %1</translation>
    </message>
    <message>
        <source>✔ answers</source>
        <translation>✔ odpovídá</translation>
    </message>
    <message>
        <source>contact %1</source>
        <translation>kontakt %1</translation>
    </message>
    <message>
        <source>events lost</source>
        <translation>ztracené události</translation>
    </message>
    <message>
        <source>%1 by the kernel · panel gone %2 times</source>
        <translation>jádro ztratilo %1 · panel zmizel %2×</translation>
    </message>
    <message>
        <source>STOP to the bus</source>
        <translation>STOP až na sběrnici</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>sběrnice</translation>
    </message>
    <message>
        <source>estimates</source>
        <translation>odhady</translation>
    </message>
    <message>
        <source>%1 of %2 contradicted the readings</source>
        <translation>%1 z %2 odporovalo údajům</translation>
    </message>
    <message>
        <source>median %1 · 99 % below %2 · longest %3</source>
        <translation>medián %1 · 99 % pod %2 · nejdelší %3</translation>
    </message>
</context>
<context>
    <name>terratact::DrivePad</name>
    <message>
        <source>Drive</source>
        <translation>Jízda</translation>
    </message>
    <message>
        <source>◀ hold: back (S)</source>
        <translation>◀ držet: zpět (S)</translation>
    </message>
    <message>
        <source>Hold to drive back</source>
        <translation>Držením jet zpět</translation>
    </message>
    <message>
        <source>hold: forward (W) ▶</source>
        <translation>držet: vpřed (W) ▶</translation>
    </message>
    <message>
        <source>Hold to drive forward</source>
        <translation>Držením jet vpřed</translation>
    </message>
    <message>
        <source>Dead-man key: drives while held; also the arrow keys Up and Down</source>
        <translation>Jede, dokud držíte; také šipky nahoru a dolů</translation>
    </message>
    <message>
        <source>Hold to feel forward</source>
        <translation>Podržením ohmatávat vpřed</translation>
    </message>
    <message>
        <source>Dead-man key: while held, the robot presses, estimates and advances, as long as the verdict is CLEAR</source>
        <translation>Dokud držíte, robot tlačí, odhaduje a postupuje, pokud je verdikt VOLNO</translation>
    </message>
    <message>
        <source>hold: feel (F)</source>
        <translation>držet: hmatat (F)</translation>
    </message>
    <message>
        <source>◀ S</source>
        <translation>◀ S</translation>
    </message>
    <message>
        <source>feel F</source>
        <translation>hmatat F</translation>
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
        <translation>sklon</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>náklon</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>kontakt</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>rychlost</translation>
    </message>
    <message>
        <source>since estimate</source>
        <translation>od odhadu</translation>
    </message>
    <message>
        <source>felt to</source>
        <translation>ohmatáno do</translation>
    </message>
    <message>
        <source>The element of each flipper that touches the ground hardest: its side and its number, 1 (pivot) to 6 (tip)</source>
        <translation>Prvek každého flipperu, který se terénu dotýká nejsilněji: jeho strana a číslo, 1 (čep) až 6 (špička)</translation>
    </message>
    <message>
        <source>Distance rolled since the last estimate</source>
        <translation>Ujetá vzdálenost od posledního odhadu</translation>
    </message>
    <message>
        <source>● CONTACT</source>
        <translation>● KONTAKT</translation>
    </message>
    <message>
        <source>Driving</source>
        <translation>Jízda</translation>
    </message>
    <message>
        <source>STEEP at %1, DANGER at %2, tips over at %3</source>
        <translation>STRMĚ od %1, POZOR od %2, převrátí se při %3</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>není známo</translation>
    </message>
    <message>
        <source>Along the tracks, over the last 0.3 s</source>
        <translation>Podél pásů, za posledních 0.3 s</translation>
    </message>
    <message>
        <source>The ground is felt up to here, forward from the IMU, on both sides. &quot;!&quot;: the tracks are about to leave felt ground. &quot;none&quot;: nothing ahead is felt</source>
        <translation>Terén je ohmatán až sem, vpřed od IMU, na obou stranách. „!“: pásy brzy opustí ohmataný terén. „nikam“: vpředu není nic ohmatáno</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nikam</translation>
    </message>
</context>
<context>
    <name>terratact::EstimateStrip</name>
    <message>
        <source>Result</source>
        <translation>Výsledek</translation>
    </message>
    <message>
        <source>Warnings about the result</source>
        <translation>Varování k výsledku</translation>
    </message>
    <message>
        <source>Progress of the estimate</source>
        <translation>Průběh odhadu</translation>
    </message>
    <message>
        <source>Cancel (Esc)</source>
        <translation>Zrušit (Esc)</translation>
    </message>
    <message>
        <source>Ends the estimate and the exploration</source>
        <translation>Ukončí odhad i průzkum</translation>
    </message>
    <message>
        <source>Known to ± %1, widest at %2</source>
        <translation>Známo na ± %1, nejhůř v %2</translation>
    </message>
    <message>
        <source>%1 · %2 draws · %3</source>
        <translation>%1 · %2 vzorků · %3</translation>
    </message>
    <message>
        <source>the chains have not converged</source>
        <translation>řetězce nekonvergovaly</translation>
    </message>
    <message>
        <source>estimating %p %</source>
        <translation>odhad %p %</translation>
    </message>
    <message>
        <source>Uncertain at %1: ± %2</source>
        <translation>Nejisté v %1: ± %2</translation>
    </message>
    <message>
        <source>ended: converged</source>
        <translation>konec: zkonvergovalo</translation>
    </message>
    <message>
        <source>ended: all draws made</source>
        <translation>konec: všechny vzorky hotovy</translation>
    </message>
    <message>
        <source>ended: time limit</source>
        <translation>konec: vypršel čas</translation>
    </message>
</context>
<context>
    <name>terratact::Estimation</name>
    <message>
        <source>model %1 loaded</source>
        <translation>model %1 načten</translation>
    </message>
    <message>
        <source>model %1 stays in use: %2</source>
        <translation>dál se používá model %1: %2</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>uvnitř</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>mimo</translation>
    </message>
    <message>
        <source>No live estimate: %1</source>
        <translation>Bez živého odhadu: %1</translation>
    </message>
    <message>
        <source>no second estimate: %1</source>
        <translation>bez druhého odhadu: %1</translation>
    </message>
    <message>
        <source>estimate failed: %1</source>
        <translation>odhad selhal: %1</translation>
    </message>
    <message>
        <source>estimate in %1</source>
        <translation>odhad za %1</translation>
    </message>
    <message>
        <source>arm %1: %2 m, between the sides that are estimated</source>
        <translation>rameno %1: %2 m, mezi odhadovanými stranami</translation>
    </message>
    <message>
        <source>arm %1: %2 m, %3 the band shown before</source>
        <translation>rameno %1: %2 m, %3 předtím ukázaného pásma</translation>
    </message>
    <message>
        <source>Nothing is remembered here: %1</source>
        <translation>Zde není nic zapamatováno: %1</translation>
    </message>
    <message>
        <source>No remembered ground while telemetry is missing</source>
        <translation>Bez zapamatovaného terénu, dokud chybí telemetrie</translation>
    </message>
    <message>
        <source>no memory: %1</source>
        <translation>bez paměti: %1</translation>
    </message>
    <message>
        <source>a current or a force was not measured</source>
        <translation>některý proud nebo síla nebyly změřeny</translation>
    </message>
    <message>
        <source>the networks do not know such a pose</source>
        <translation>sítě takovou polohu neznají</translation>
    </message>
    <message>
        <source>the model has no networks for it (%1 is not beside it)</source>
        <translation>model k ní nemá sítě (%1 není vedle něj)</translation>
    </message>
    <message>
        <source>the networks %1 learnt from another robot</source>
        <translation>sítě %1 se učily na jiném robotu</translation>
    </message>
    <message>
        <source>the way begins here</source>
        <translation>cesta zde začíná</translation>
    </message>
    <message>
        <source>memory cleared: %1</source>
        <translation>paměť vymazána: %1</translation>
    </message>
    <message>
        <source>the model has no networks for it</source>
        <translation>model k ní nemá sítě</translation>
    </message>
    <message>
        <source>memory: %1 m</source>
        <translation>paměť: %1 m</translation>
    </message>
    <message>
        <source>memory: %1 m · earlier presses: %2</source>
        <translation>paměť: %1 m · dřívější přítlaky: %2</translation>
    </message>
    <message>
        <source>bands held: %1 of %2</source>
        <translation>pásma platila: %1 z %2</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>no memory but of the arm: %1</source>
        <translation>bez paměti kromě ramene: %1</translation>
    </message>
</context>
<context>
    <name>terratact::EventList</name>
    <message>
        <source>Last minutes</source>
        <translation>Poslední minuty</translation>
    </message>
</context>
<context>
    <name>terratact::Exploration</name>
    <message>
        <source>No estimate yet: explore the terrain (A)</source>
        <translation>Zatím bez odhadu: prozkoumejte terén (A)</translation>
    </message>
    <message>
        <source>STOP not sent: %1</source>
        <translation>STOP neodeslán: %1</translation>
    </message>
    <message>
        <source>STOP released by the operator</source>
        <translation>STOP uvolnil operátor</translation>
    </message>
    <message>
        <source>command not sent: %1</source>
        <translation>povel neodeslán: %1</translation>
    </message>
    <message>
        <source>the robot did not release STOP: hold R again</source>
        <translation>robot neuvolnil STOP: podržte R znovu</translation>
    </message>
    <message>
        <source>No estimate: explore the terrain (A)</source>
        <translation>Bez odhadu: prozkoumejte terén (A)</translation>
    </message>
    <message>
        <source>The robot has moved: explore again (A)</source>
        <translation>Robot se pohnul: prozkoumejte znovu (A)</translation>
    </message>
    <message>
        <source>Exploring: the robot halts</source>
        <translation>Průzkum: robot zastavuje</translation>
    </message>
    <message>
        <source>exploration requested</source>
        <translation>vyžádán průzkum</translation>
    </message>
    <message>
        <source>Exploring: the front flippers press down</source>
        <translation>Průzkum: přední flippery tlačí dolů</translation>
    </message>
    <message>
        <source>Estimating …</source>
        <translation>Odhaduje se …</translation>
    </message>
    <message>
        <source>no answer in time: refused</source>
        <translation>bez odpovědi včas: bez sondy</translation>
    </message>
    <message>
        <source>probe refused</source>
        <translation>sonda odmítnuta</translation>
    </message>
    <message>
        <source>exploration ended by the operator</source>
        <translation>průzkum ukončil operátor</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>exploration failed: %1</source>
        <translation>průzkum selhal: %1</translation>
    </message>
    <message>
        <source>No estimate: %1</source>
        <translation>Bez odhadu: %1</translation>
    </message>
    <message>
        <source>No estimate yet: one is made when the robot presses its flippers</source>
        <translation>Zatím bez odhadu: přijde, až robot přitlačí flippery</translation>
    </message>
    <message>
        <source>No estimate yet: press M, then hold M to arm; then explore (A)</source>
        <translation>Zatím bez odhadu: aktivujte (stisk M, pak držet M); pak průzkum (A)</translation>
    </message>
    <message>
        <source>not armed: press M, then hold M</source>
        <translation>není aktivní: stisknout M, pak držet M</translation>
    </message>
    <message>
        <source>the next estimate: %1, %2 draws, contacts above %3 N</source>
        <translation>příští odhad: %1, %2 vzorků, kontakty nad %3 N</translation>
    </message>
    <message>
        <source>overridden by the operator: %1</source>
        <translation>operátor přebil: %1</translation>
    </message>
    <message>
        <source>No estimate: there is no model</source>
        <translation>Bez odhadu: chybí model</translation>
    </message>
    <message>
        <source>No estimate yet: the model is being loaded</source>
        <translation>Zatím bez odhadu: model se načítá</translation>
    </message>
    <message>
        <source>the robot reports stopped</source>
        <translation>robot hlásí, že je zastaven</translation>
    </message>
    <message>
        <source>STOP sent, not confirmed by the robot</source>
        <translation>STOP odeslán, robot ho nepotvrdil</translation>
    </message>
    <message>
        <source>the override has ended: %1</source>
        <translation>přebití skončilo: %1</translation>
    </message>
    <message>
        <source>No probe offered: every bin in reach is known to ± %1 m or better</source>
        <translation>Nenabízí se: každý bod v dosahu je znám na ± %1 m nebo přesněji</translation>
    </message>
    <message>
        <source>No probe offered, by the settings: %1 is decided without the arm</source>
        <translation>Nenabízí se podle nastavení: %1 je rozhodnuto i bez ramene</translation>
    </message>
    <message>
        <source>No probe offered, by the settings: no bin in reach informs about the step</source>
        <translation>Nenabízí se podle nastavení: žádný bod v dosahu o schodu nic neřekne</translation>
    </message>
    <message>
        <source>No probe was offered with this estimate: explore again</source>
        <translation>S tímto odhadem se sonda nenabídla: prozkoumejte znovu</translation>
    </message>
    <message>
        <source>No estimate yet: no telemetry from the robot</source>
        <translation>Zatím bez odhadu: od robota nejde telemetrie</translation>
    </message>
    <message>
        <source>No estimate: STOP is latched</source>
        <translation>Bez odhadu: STOP drží</translation>
    </message>
    <message>
        <source>an exploration is running</source>
        <translation>běží průzkum</translation>
    </message>
    <message>
        <source>no probe requested: %1</source>
        <translation>sonda nevyžádána: %1</translation>
    </message>
    <message>
        <source>the estimate is hidden: Ctrl+Z restores it</source>
        <translation>odhad je pryč z obrazovky: Ctrl+Z ho vrátí</translation>
    </message>
    <message>
        <source>the estimate is back</source>
        <translation>odhad je zpět</translation>
    </message>
    <message>
        <source>no estimate can be brought back</source>
        <translation>žádný odhad nelze vrátit</translation>
    </message>
    <message>
        <source>the robot drives no further: the built-in ground ends here, or is too steep. Drive back, or start with another --terrain</source>
        <translation>robot dál nejede: vestavěný terén zde končí, nebo je příliš strmý. Jeďte zpět, nebo začněte s jiným --terrain</translation>
    </message>
    <message>
        <source>the robot drives no further: the ground of the file %1 ends here, or is too steep. Drive back, or start with another --terrain</source>
        <translation>robot dál nejede: terén souboru %1 zde končí, nebo je příliš strmý. Jeďte zpět, nebo začněte s jiným --terrain</translation>
    </message>
    <message>
        <source>the robot reports driving, but its tracks do not move</source>
        <translation>robot hlásí, že jede, a jeho pásy se nehýbou</translation>
    </message>
    <message>
        <source>probe proposed %1</source>
        <translation>návrh sondy %1</translation>
    </message>
    <message>
        <source>probe %1 approved</source>
        <translation>sonda %1 schválena</translation>
    </message>
    <message>
        <source>a probe %1 is requested: the robot presses again, then asks for approval</source>
        <translation>žádá se sonda %1: robot znovu přitlačí, pak přijde dotaz</translation>
    </message>
    <message>
        <source>probe %1 requested instead</source>
        <translation>místo toho vyžádána sonda %1</translation>
    </message>
    <message>
        <source>the arm does not reach the ground %1</source>
        <translation>rameno nedosáhne na terén %1</translation>
    </message>
    <message>
        <source>advancing %1 m: CLEAR for %2 m ahead of the tracks</source>
        <translation>postup o %1 m: VOLNO %2 m před pásy</translation>
    </message>
    <message>
        <source>feeling forward while the control is held</source>
        <translation>ohmatává vpřed, dokud je prvek držen</translation>
    </message>
    <message>
        <source>feel forward has ended after %1 m, %2 m/min: %3</source>
        <translation>ohmatávání vpřed skončilo po %1 m, %2 m/min: %3</translation>
    </message>
    <message>
        <source>feel forward: %1 · %2 m · %3 m/min</source>
        <translation>ohmatávání vpřed: %1 · %2 m · %3 m/min</translation>
    </message>
    <message>
        <source>feel forward has ended after %1 m: %2</source>
        <translation>ohmatávání vpřed skončilo po %1 m: %2</translation>
    </message>
    <message>
        <source>no answer in time: no probe</source>
        <translation>včas nepřišla odpověď: bez sondy</translation>
    </message>
    <message>
        <source>the robot says that it is stopped</source>
        <translation>robot hlásí, že je zastaven</translation>
    </message>
    <message>
        <source>The probe was refused</source>
        <translation>Sonda byla odmítnuta</translation>
    </message>
    <message>
        <source>it still reports the exploration before</source>
        <translation>stále hlásí předchozí průzkum</translation>
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
        <translation>P</translation>
    </message>
</context>
<context>
    <name>terratact::ForceBars</name>
    <message>
        <source>1 pivot</source>
        <translation>1 čep</translation>
    </message>
    <message>
        <source>%1 tip</source>
        <translation>%1 špička</translation>
    </message>
    <message>
        <source>Forces on the front flippers</source>
        <translation>Síly na předních flipperech</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>kontakt</translation>
    </message>
    <message>
        <source>bias %1 N</source>
        <translation>posun %1 N</translation>
    </message>
    <message>
        <source>▲ sat.</source>
        <translation>▲ nas.</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>nasycen</translation>
    </message>
    <message>
        <source>element %1: %2</source>
        <translation>prvek %1: %2</translation>
    </message>
    <message>
        <source>Thin lines: highest of the last 3 s</source>
        <translation>Tenké čáry: nejvyšší hodnota posledních 3 s</translation>
    </message>
</context>
<context>
    <name>terratact::GamepadControl</name>
    <message>
        <source>gamepad lost: all its controls are released</source>
        <translation>gamepad ztracen: všechny jeho prvky jsou uvolněny</translation>
    </message>
    <message>
        <source>STOP pressed on the gamepad</source>
        <translation>STOP stisknut na gamepadu</translation>
    </message>
    <message>
        <source>the gamepad “%1” is not connected any more</source>
        <translation>gamepad „%1“ už není připojen</translation>
    </message>
    <message>
        <source>gamepad connected: %1</source>
        <translation>gamepad připojen: %1</translation>
    </message>
    <message>
        <source>the gamepad is connected by radio, whose loss is noticed late: connect it by cable</source>
        <translation>gamepad je připojen rádiem, jehož výpadek se pozná pozdě: připojte jej kabelem</translation>
    </message>
    <message>
        <source>not driven: hold the dead-man control first, then push the stick from its centre</source>
        <translation>nejede se: nejdříve držte spínač bdělosti, pak vychylte páčku ze středu</translation>
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
        <translation>Přiřazení</translation>
    </message>
    <message>
        <source>Nothing was assigned: no control was moved for 10 s.</source>
        <translation>Nic nebylo přiřazeno: 10 s se nepohnul žádný prvek.</translation>
    </message>
    <message>
        <source>Actions and their controls</source>
        <translation>Akce a jejich prvky</translation>
    </message>
    <message>
        <source>Actions that work now</source>
        <translation>Akce, které teď působí</translation>
    </message>
    <message>
        <source>Action to assign</source>
        <translation>Akce k přiřazení</translation>
    </message>
    <message>
        <source>The action that gets another control</source>
        <translation>Akce, která dostane jiný prvek</translation>
    </message>
    <message>
        <source>What arrives</source>
        <translation>Co přichází</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Osy</translation>
    </message>
    <message>
        <source>Pressed buttons</source>
        <translation>Stisknutá tlačítka</translation>
    </message>
    <message>
        <source>Driving</source>
        <translation>Jízda</translation>
    </message>
    <message>
        <source>Dead zone of the stick</source>
        <translation>Mrtvá zóna páčky</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Share of the stick&apos;s way around its centre that drives nothing</source>
        <translation>Část dráhy páčky kolem středu, která nic neřídí</translation>
    </message>
    <message>
        <source>Speed at full deflection</source>
        <translation>Rychlost při plné výchylce</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>The command gate accepts at most 0.6 m/s</source>
        <translation>Brána povelů přijme nejvýše 0.6 m/s</translation>
    </message>
    <message>
        <source>Gamepad back to the defaults</source>
        <translation>Gamepad zpět na výchozí</translation>
    </message>
    <message>
        <source>Resets controls, dead zone and speed</source>
        <translation>Obnoví prvky, mrtvou zónu a rychlost</translation>
    </message>
    <message>
        <source>Press again to reset the gamepad</source>
        <translation>Stiskněte znovu pro obnovení gamepadu</translation>
    </message>
    <message>
        <source>Nothing was assigned.</source>
        <translation>Nic nebylo přiřazeno.</translation>
    </message>
    <message>
        <source>Push the stick that drives in the direction of forward, for at most 10 s.</source>
        <translation>Vychylte páčku, která řídí jízdu, ve směru vpřed; čeká se 10 s.</translation>
    </message>
    <message>
        <source>Press the button or trigger for: %1. It waits 10 s.</source>
        <translation>Stiskněte tlačítko nebo spoušť pro: %1. Čeká se 10 s.</translation>
    </message>
    <message>
        <source>On this page the gamepad moves nothing; STOP acts.</source>
        <translation>Na této stránce gamepad nic nepohne; STOP působí.</translation>
    </message>
    <message>
        <source>Not assigned: “%1” is a control of STOP. Give STOP another one first.</source>
        <translation>Nepřiřazeno: „%1“ je prvek pro STOP. Dejte nejdříve STOP jiný.</translation>
    </message>
    <message>
        <source>“%1” is now: %2.</source>
        <translation>„%1“ je nyní: %2.</translation>
    </message>
    <message>
        <source>Without a control now: %1.</source>
        <translation>Nyní bez prvku: %1.</translation>
    </message>
    <message>
        <source>Nothing was assigned: the gamepad is not connected any more.</source>
        <translation>Nic nebylo přiřazeno: gamepad už není připojen.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>no control</source>
        <translation>žádný prvek</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
    <message>
        <source>Assign</source>
        <translation>Přiřadit</translation>
    </message>
    <message>
        <source>Connected: %1</source>
        <translation>Připojeno: %1</translation>
    </message>
    <message>
        <source>By radio: its loss is noticed late. Connect it by cable.</source>
        <translation>Rádiem: výpadek se pozná pozdě. Připojte jej kabelem.</translation>
    </message>
    <message>
        <source>No gamepad is connected. Plug one in at any time.</source>
        <translation>Není připojen žádný gamepad. Připojte jej kdykoli.</translation>
    </message>
    <message>
        <source>Then move the control that shall do this</source>
        <translation>Pak pohněte prvkem, který to má dělat</translation>
    </message>
    <message>
        <source>No gamepad is connected</source>
        <translation>Není připojen žádný gamepad</translation>
    </message>
    <message>
        <source>%1 m/s</source>
        <translation>%1 m/s</translation>
    </message>
    <message>
        <source>release it first</source>
        <translation>nejdříve pusťte</translation>
    </message>
</context>
<context>
    <name>terratact::HistoryControl</name>
    <message>
        <source>the picture shows the estimate of %1, not the present one</source>
        <translation>obraz ukazuje odhad z %1, ne současný</translation>
    </message>
    <message>
        <source>the picture shows the present estimate again</source>
        <translation>obraz znovu ukazuje současný odhad</translation>
    </message>
    <message>
        <source>The picture shows the estimate of %1, not the present one. Backspace: the present</source>
        <translation>Obraz ukazuje odhad z %1, ne současný. Backspace: současný</translation>
    </message>
    <message>
        <source>past: estimate of %1</source>
        <translation>minulý: odhad z %1</translation>
    </message>
    <message>
        <source>Dashed in the picture: the past estimate of %1%2. Backspace takes it away</source>
        <translation>Čárkovaně v obraze: minulý odhad z %1%2. Backspace ho odebere</translation>
    </message>
    <message>
        <source>, not moved by what was driven since</source>
        <translation>, neposunutý o jízdu od té doby</translation>
    </message>
    <message>
        <source>, not moved by the %1 driven since</source>
        <translation>, neposunutý o %1 ujeté od té doby</translation>
    </message>
</context>
<context>
    <name>terratact::HistoryWindow</name>
    <message>
        <source>Present estimate (Backspace)</source>
        <translation>Současný odhad (Backspace)</translation>
    </message>
    <message>
        <source>Restore (Ctrl+Z)</source>
        <translation>Obnovit (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Estimates of this run</source>
        <translation>Odhady tohoto běhu</translation>
    </message>
    <message>
        <source>Estimates, newest first</source>
        <translation>Odhady, nejnovější první</translation>
    </message>
    <message>
        <source>The picture shows the present estimate again</source>
        <translation>Obraz znovu ukáže současný odhad</translation>
    </message>
    <message>
        <source>Brings the hidden estimate back while the robot has not moved</source>
        <translation>Vrátí skrytý odhad, dokud se robot nepohnul</translation>
    </message>
    <message>
        <source>%1 · number %2</source>
        <translation>%1 · číslo %2</translation>
    </message>
    <message>
        <source>present</source>
        <translation>současný</translation>
    </message>
    <message>
        <source>hidden by the operator</source>
        <translation>skryt operátorem</translation>
    </message>
    <message>
        <source>restored, from before</source>
        <translation>obnoven, z dřívějška</translation>
    </message>
    <message>
        <source>No estimate yet. The last %1 of this run are kept.</source>
        <translation>Zatím žádný odhad. Uchovává se posledních %1 z tohoto běhu.</translation>
    </message>
    <message>
        <source>The estimate of %1 lies over the present one, in the robot&apos;s frame of that time.</source>
        <translation>Odhad z %1 leží přes současný, v souřadnicích robota z té doby.</translation>
    </message>
    <message>
        <source>The picture shows the present. Choose an estimate to see it; the verdict stays that of the present.</source>
        <translation>Obraz ukazuje současnost. Vyberte odhad k zobrazení; verdikt zůstává současný.</translation>
    </message>
    <message>
        <source>Take it away (L)</source>
        <translation>Odebrat (L)</translation>
    </message>
    <message>
        <source>Lay over the present (L)</source>
        <translation>Položit přes současný (L)</translation>
    </message>
    <message>
        <source>Draws it as a lighter profile over the present one</source>
        <translation>Nakreslí jej jako světlejší profil přes současný</translation>
    </message>
    <message>
        <source>Choose an estimate first</source>
        <translation>Nejprve vyberte odhad</translation>
    </message>
</context>
<context>
    <name>terratact::ImportPage</name>
    <message>
        <source>Reading %1 …</source>
        <translation>Čte se %1 …</translation>
    </message>
    <message>
        <source>What the recording holds</source>
        <translation>Co záznam obsahuje</translation>
    </message>
    <message>
        <source>Mapping: which topic and field is which sensor</source>
        <translation>Přiřazení: které téma a pole je který snímač</translation>
    </message>
    <message>
        <source>What is missing or doubtful</source>
        <translation>Co chybí nebo je pochybné</translation>
    </message>
    <message>
        <source>The recording h&amp;olds</source>
        <translation>Zázn&amp;am obsahuje</translation>
    </message>
    <message>
        <source>&amp;Mapping: correct it where it is wrong</source>
        <translation>&amp;Přiřazení: opravte, co je špatně</translation>
    </message>
    <message>
        <source>Where the mapping comes from</source>
        <translation>Odkud přiřazení pochází</translation>
    </message>
    <message>
        <source>proposed mapping</source>
        <translation>navržené přiřazení</translation>
    </message>
    <message>
        <source>shipped: %1</source>
        <translation>dodané: %1</translation>
    </message>
    <message>
        <source>from a file …</source>
        <translation>ze souboru …</translation>
    </message>
    <message>
        <source>&amp;Check</source>
        <translation>&amp;Zkontrolovat</translation>
    </message>
    <message>
        <source>Read the recording by this mapping and list gaps, doubtful units and signs</source>
        <translation>Přečte záznam podle tohoto přiřazení a vypíše mezery, pochybné jednotky a znaménka</translation>
    </message>
    <message>
        <source>&amp;Import …</source>
        <translation>&amp;Importovat …</translation>
    </message>
    <message>
        <source>Write a session by this mapping and open it</source>
        <translation>Zapíše relaci podle tohoto přiřazení a otevře ji</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>Z&amp;rušit</translation>
    </message>
    <message>
        <source>Stop reading; nothing is written</source>
        <translation>Ukončí čtení; nic se nezapíše</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Průběh</translation>
    </message>
    <message>
        <source>Missing or &amp;doubtful</source>
        <translation>&amp;Chybí nebo je pochybné</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Kontroluje se …</translation>
    </message>
    <message>
        <source>%1 messages read</source>
        <translation>přečteno zpráv: %1</translation>
    </message>
    <message>
        <source>Look at each table of the mapping, above all at signs and units; then check it.</source>
        <translation>Projděte každou tabulku přiřazení, hlavně znaménka a jednotky; pak je zkontrolujte.</translation>
    </message>
    <message>
        <source>Nothing is doubtful.</source>
        <translation>Nic není pochybné.</translation>
    </message>
    <message numerus="yes">
        <source>%n warning(s), see below.</source>
        <translation>
            <numerusform>%n varování, viz níže.</numerusform>
            <numerusform>%n varování, viz níže.</numerusform>
            <numerusform>%n varování, viz níže.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 lines of telemetry in %2 s and %3 scenes written to %4</source>
        <translation>řádků telemetrie: %1 za %2 s, scén: %3, zapsáno do %4</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>Zrušeno; nic se nezapsalo.</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Přiřazení</translation>
    </message>
    <message>
        <source>Mapping files (*.toml);;All files (*)</source>
        <translation>Soubory přiřazení (*.toml);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Mapping of %1</source>
        <translation>Přiřazení ze souboru %1</translation>
    </message>
    <message>
        <source>Session to write</source>
        <translation>Relace k zapsání</translation>
    </message>
    <message>
        <source>Sessions (*.tts)</source>
        <translation>Relace (*.tts)</translation>
    </message>
    <message>
        <source>Importing …</source>
        <translation>Importuje se …</translation>
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
        <translation>IMPORT ZÁZNAMU</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Import</translation>
    </message>
    <message>
        <source>What the recording holds, and its mapping</source>
        <translation>Co záznam obsahuje a jeho přiřazení</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Stránky</translation>
    </message>
</context>
<context>
    <name>terratact::MainWindow</name>
    <message>
        <source>model loading …</source>
        <translation>model se načítá …</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Terén</translation>
    </message>
    <message>
        <source>Terrain, exploration and arm</source>
        <translation>Terén pod robotem, jeho průzkum a rameno</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vzhled</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>model %1</source>
        <translation>model %1</translation>
    </message>
    <message>
        <source>no model</source>
        <translation>bez modelu</translation>
    </message>
    <message>
        <source>STOP, in every window</source>
        <translation>STOP, v každém okně</translation>
    </message>
    <message>
        <source>release STOP</source>
        <translation>uvolnit STOP</translation>
    </message>
    <message>
        <source>drive forward</source>
        <translation>jet vpřed</translation>
    </message>
    <message>
        <source>drive back</source>
        <translation>jet zpět</translation>
    </message>
    <message>
        <source>arm the robot: press, then hold; again disarms it</source>
        <translation>aktivovat robota: stisknout, pak držet; znovu ho deaktivuje</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Stránky</translation>
    </message>
    <message>
        <source>Exploration</source>
        <translation>Průzkum</translation>
    </message>
    <message>
        <source>explore the terrain</source>
        <translation>prozkoumat terén</translation>
    </message>
    <message>
        <source>approve the proposed probe, or press the button that has the focus</source>
        <translation>schválit navrženou sondu, nebo stisknout zaměřené tlačítko</translation>
    </message>
    <message>
        <source>refuse it</source>
        <translation>odmítnout ji</translation>
    </message>
    <message>
        <source>to the next control, to the previous one</source>
        <translation>na další prvek, na předchozí</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Čísla</translation>
    </message>
    <message>
        <source>The same scene as a table</source>
        <translation>Táž scéna jako tabulka</translation>
    </message>
    <message>
        <source>ask for another bin instead: the %1. offered</source>
        <translation>žádat jiný bod: %1. nabízený</translation>
    </message>
    <message>
        <source>raise the step limit</source>
        <translation>zvýšit mez schodu</translation>
    </message>
    <message>
        <source>lower it</source>
        <translation>snížit ji</translation>
    </message>
    <message>
        <source>show some draws as thin lines</source>
        <translation>některé vzorky jako tenké čáry</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarmy</translation>
    </message>
    <message>
        <source>Active alarms, and past alarms not yet acknowledged</source>
        <translation>Trvající alarmy a minulé nepotvrzené</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signály</translation>
    </message>
    <message>
        <source>Every signal on the bus, and its newest frames</source>
        <translation>Všechny signály na sběrnici a poslední rámce</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Diagnostika</translation>
    </message>
    <message>
        <source>Versions, permissions and how fast the console is</source>
        <translation>Verze, oprávnění a rychlost konzole</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Nastavení</translation>
    </message>
    <message>
        <source>Method, limits, look, model and robot</source>
        <translation>Metoda, meze, vzhled, model a robot</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Trénink</translation>
    </message>
    <message>
        <source>Train a model, compare it with the one in use, adopt it</source>
        <translation>Natrénovat model, porovnat s používaným, převzít</translation>
    </message>
    <message>
        <source>no model: %1</source>
        <translation>bez modelu: %1</translation>
    </message>
    <message>
        <source>An exploration is running: end it with Esc first</source>
        <translation>Běží průzkum: nejdřív ho ukončete klávesou Esc</translation>
    </message>
    <message>
        <source>The robot is armed: disarm it first (M)</source>
        <translation>Robot je aktivní: deaktivujte ho (M)</translation>
    </message>
    <message>
        <source>explore in spite of a doubtful requirement (override)</source>
        <translation>prozkoumat navzdory spornému předpokladu (přebít)</translation>
    </message>
    <message>
        <source>marked in the recording</source>
        <translation>označeno v záznamu</translation>
    </message>
    <message>
        <source>mark this moment in the recording</source>
        <translation>označit tento okamžik v záznamu</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otevřít</translation>
    </message>
    <message>
        <source>Review a session, a log or scenes in a separate window (Ctrl+O)</source>
        <translation>Prohlédnout relaci, záznam nebo scény ve vlastním okně; toto běží dál (Ctrl+O)</translation>
    </message>
    <message>
        <source>open a session, a log or scenes in another window</source>
        <translation>otevřít relaci, záznam nebo scény v jiném okně</translation>
    </message>
    <message>
        <source>Forces, attitude and the last events</source>
        <translation>Síly, náklon a poslední události</translation>
    </message>
    <message>
        <source>restarts the console</source>
        <translation>restartuje konzoli</translation>
    </message>
    <message>
        <source>not marked: nothing is recorded</source>
        <translation>neoznačeno: nic se nezaznamenává</translation>
    </message>
    <message>
        <source>requirements of each command, one after the other</source>
        <translation>co potřebují jednotlivé povely, jeden po druhém</translation>
    </message>
    <message>
        <source>PANEL LOST: connect the operator&apos;s panel</source>
        <translation>PANEL ZTRACEN: připojte panel operátora</translation>
    </message>
    <message>
        <source>PANEL LOST, STOP is asserted: connect the operator&apos;s panel, then hold R; or start without --panel</source>
        <translation>PANEL ZTRACEN, což znamená STOP: připojte panel operátora a podržte R; nebo spusťte bez --panel</translation>
    </message>
    <message>
        <source>the robot stays: %1</source>
        <translation>robot zůstává: %1</translation>
    </message>
    <message>
        <source>PANEL LOST: connect the operator&apos;s panel, or start without --panel</source>
        <translation>PANEL ZTRACEN: připojte panel operátora, nebo spusťte bez --panel</translation>
    </message>
    <message>
        <source>THE ROBOT IS ARMED: close the window again within %1 s to halt and disarm it; or disarm it first (M)</source>
        <translation>ROBOT JE AKTIVNÍ: zavřete okno znovu do %1 s, pak se zastaví a deaktivuje; nebo ho nejdřív deaktivujte (M)</translation>
    </message>
    <message>
        <source>not driven: %1</source>
        <translation>nejede se: %1</translation>
    </message>
    <message>
        <source>it is done on the page Terrain (F2)</source>
        <translation>jezdí se na stránce Terén (F2)</translation>
    </message>
    <message>
        <source>ask for a probe: of the selected bin, else of the best one</source>
        <translation>požádat o sondu: zvoleného bodu, jinak nejlepšího</translation>
    </message>
    <message>
        <source>abort the exploration; its result stays</source>
        <translation>přerušit průzkum; výsledek zůstává</translation>
    </message>
    <message>
        <source>forget the estimate</source>
        <translation>zapomenout odhad</translation>
    </message>
    <message>
        <source>restore the hidden estimate</source>
        <translation>vrátit skrytý odhad</translation>
    </message>
    <message>
        <source>this window froze for %1 ms: no command could leave</source>
        <translation>toto okno bylo zamrzlé %1 ms: žádný povel nemohl odejít</translation>
    </message>
    <message>
        <source>no bin is selected: point at a bin first</source>
        <translation>není zvolen žádný bod: nejdřív na nějaký ukažte</translation>
    </message>
    <message>
        <source>In a review, these keys move in time and no robot: A, B, F, M, P, K, 1 to 8, Space, Page Up and Down, Up and Down.</source>
        <translation>V prohlížení tyto klávesy posouvají čas, ne robota: A, B, F, M, P, K, 1 až 8, mezerník, Page Up a Down, šipky nahoru a dolů.</translation>
    </message>
    <message>
        <source>feel forward: press, estimate and advance while CLEAR</source>
        <translation>ohmatávat vpřed: tlačit, odhadovat a postupovat, dokud je VOLNO</translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation>Gamepad</translation>
    </message>
    <message>
        <source>What arrives from the gamepad, and what its controls do</source>
        <translation>Co přichází z gamepadu a co dělají jeho prvky</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Grafy</translation>
    </message>
    <message>
        <source>Any signal over time</source>
        <translation>Libovolný signál v čase</translation>
    </message>
    <message>
        <source>picture written: %1</source>
        <translation>obrázek zapsán: %1</translation>
    </message>
    <message>
        <source>%1 — Terratact</source>
        <translation>%1 — Terratact</translation>
    </message>
    <message>
        <source>profiles, export and import of settings</source>
        <translation>profily, export a import nastavení</translation>
    </message>
    <message>
        <source>The robot is moving: wait until it stands</source>
        <translation>Robot se pohybuje: počkejte, až zastaví</translation>
    </message>
    <message>
        <source>list the estimates of this run</source>
        <translation>seznam odhadů tohoto běhu</translation>
    </message>
    <message>
        <source>show the present estimate in the picture again</source>
        <translation>znovu ukázat v obraze současný odhad</translation>
    </message>
    <message>
        <source>no probe requested: the picture shows an earlier estimate</source>
        <translation>sonda nevyžádána: obraz ukazuje dřívější odhad</translation>
    </message>
    <message>
        <source>connect to a bus, the simulated robot, a log or a session</source>
        <translation>připojit se ke sběrnici, simulovanému robotu, záznamu nebo relaci</translation>
    </message>
    <message>
        <source>save a snapshot: picture and numbers, with a note</source>
        <translation>uložit snímek: obrázek a čísla, s poznámkou</translation>
    </message>
    <message>
        <source>open or close a second window with terrain and verdict, view only</source>
        <translation>otevřít nebo zavřít druhé okno s terénem a verdiktem, jen pro čtení</translation>
    </message>
    <message>
        <source>Second window, view only (Ctrl+D)</source>
        <translation>Druhé okno, jen pro čtení (Ctrl+D)</translation>
    </message>
    <message>
        <source>Snapshot with a note (C)</source>
        <translation>Snímek s poznámkou (C)</translation>
    </message>
    <message>
        <source>SNAPSHOT NOT SAVED: %1</source>
        <translation>SNÍMEK NEULOŽEN: %1</translation>
    </message>
    <message>
        <source>snapshot %1, beside the session</source>
        <translation>snímek %1, vedle relace</translation>
    </message>
    <message>
        <source>no session records; the snapshot is in %1</source>
        <translation>nic se nezaznamenává; snímek je v %1</translation>
    </message>
    <message>
        <source>a snapshot is still being written: try again</source>
        <translation>snímek se ještě zapisuje: zkuste to znovu</translation>
    </message>
    <message>
        <source>snapshot %1 is being written</source>
        <translation>snímek %1 se zapisuje</translation>
    </message>
    <message>
        <source>Export the strip of felt ground …</source>
        <translation>Exportovat pás ohmataného terénu …</translation>
    </message>
    <message>
        <source>robot, language and units change at the next start: %1</source>
        <translation>robot, jazyk a jednotky se změní při příštím spuštění: %1</translation>
    </message>
    <message>
        <source>not armed: %1</source>
        <translation>není aktivní: %1</translation>
    </message>
    <message>
        <source>colours and font change once the robot has stopped</source>
        <translation>barvy a písmo se změní, až robot zastaví</translation>
    </message>
    <message>
        <source>not explored: %1</source>
        <translation>neprozkoumává se: %1</translation>
    </message>
</context>
<context>
    <name>terratact::NavigationRail</name>
    <message>
        <source>Pages</source>
        <translation>Stránky</translation>
    </message>
</context>
<context>
    <name>terratact::NumbersPage</name>
    <message>
        <source>The scene as numbers</source>
        <translation>Scéna v číslech</translation>
    </message>
    <message>
        <source>Copy (Ctrl+C)</source>
        <translation>Kopírovat (Ctrl+C)</translation>
    </message>
    <message>
        <source>Copies the whole table, columns separated by tabs</source>
        <translation>Celá tabulka, sloupce oddělené tabulátory</translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation>Odhad</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdikt</translation>
    </message>
    <message>
        <source>last telemetry %1 ago</source>
        <translation>telemetrie stará %1</translation>
    </message>
    <message>
        <source>copy the numbers, on their page</source>
        <translation>zkopírovat čísla, na jejich stránce</translation>
    </message>
    <message>
        <source>%1, %2 draws, seed %3; heights above the IMU, steps of more than %4. The verdict&apos;s P counts steps over two bins (%5) anywhere ahead, the column those to the next bin alone</source>
        <translation>%1, %2 vzorků, semínko %3; výšky nad IMU, schody nad %4. P verdiktu počítá schody přes dva body (%5) kdekoli vpředu, sloupec jen ty k dalšímu bodu</translation>
    </message>
</context>
<context>
    <name>terratact::NumbersTable</name>
    <message>
        <source>The scene as numbers</source>
        <translation>Scéna v číslech</translation>
    </message>
    <message>
        <source>bin [%1]</source>
        <translation>bod [%1]</translation>
    </message>
    <message>
        <source>height [%1]</source>
        <translation>výška [%1]</translation>
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
        <translation>strop [%1]</translation>
    </message>
    <message>
        <source>from</source>
        <translation>z čeho</translation>
    </message>
    <message>
        <source>step to next</source>
        <translation>schod k další</translation>
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
        <translation>dvě výšky</translation>
    </message>
    <message>
        <source>%1 (%2 %) or %3 (%4 %)</source>
        <translation>%1 (%2 %) nebo %3 (%4 %)</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ano</translation>
    </message>
    <message>
        <source>in part</source>
        <translation>zčásti</translation>
    </message>
    <message>
        <source>no</source>
        <translation>ne</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>ohmatáno</translation>
    </message>
    <message>
        <source>side</source>
        <translation>strana</translation>
    </message>
    <message>
        <source>P of a step to the next bin alone. The verdict&apos;s P counts steps over two bins (%1), anywhere ahead</source>
        <translation>P schodu jen k dalšímu bodu. P verdiktu počítá schody přes dva body (%1), kdekoli vpředu</translation>
    </message>
</context>
<context>
    <name>terratact::PanelControl</name>
    <message>
        <source>STOP pressed on the panel</source>
        <translation>STOP stisknut na panelu</translation>
    </message>
    <message>
        <source>the panel is lost: STOP is asserted</source>
        <translation>panel ztracen, což znamená STOP</translation>
    </message>
    <message>
        <source>the operator&apos;s panel does not answer</source>
        <translation>panel operátora neodpovídá</translation>
    </message>
    <message>
        <source>STOP is pressed on the panel</source>
        <translation>STOP je stisknut na panelu</translation>
    </message>
    <message>
        <source>the operator&apos;s panel answers</source>
        <translation>panel operátora odpovídá</translation>
    </message>
    <message>
        <source>not approved: the question is not on the screen (Terrain, F2)</source>
        <translation>neschváleno: otázka není na obrazovce (Terén, F2)</translation>
    </message>
    <message>
        <source>not approved: the panel&apos;s button has to be held for 1.5 s</source>
        <translation>neschváleno: tlačítko panelu je třeba držet 1.5 s</translation>
    </message>
    <message>
        <source>STOP is pressed on the panel: release it there first</source>
        <translation>STOP je stisknut na panelu: nejprve ho uvolněte tam</translation>
    </message>
    <message>
        <source>the panel is lost: connect it first, or start the console without --panel</source>
        <translation>panel je ztracen: nejprve ho připojte, nebo spusťte konzoli bez --panel</translation>
    </message>
    <message>
        <source>not approved: close the window that covers the question</source>
        <translation>neschváleno: zavřete okno, které otázku zakrývá</translation>
    </message>
    <message>
        <source>the panel is lost</source>
        <translation>panel ztracen</translation>
    </message>
</context>
<context>
    <name>terratact::PassiveExploration</name>
    <message>
        <source>Following: the front flippers press down</source>
        <translation>Sledování: přední flippery tlačí dolů</translation>
    </message>
    <message>
        <source>Estimating …</source>
        <translation>Odhaduje se …</translation>
    </message>
    <message>
        <source>following: the robot has pressed its flippers down</source>
        <translation>sledování: robot přitlačil flippery</translation>
    </message>
    <message>
        <source>following: the arm is probing</source>
        <translation>sledování: rameno sonduje</translation>
    </message>
    <message>
        <source>following: the robot is stopped</source>
        <translation>sledování: robot je zastaven</translation>
    </message>
    <message>
        <source>No estimate: the robot is stopped</source>
        <translation>Bez odhadu: robot je zastaven</translation>
    </message>
    <message>
        <source>following: no estimate: %1</source>
        <translation>sledování: bez odhadu: %1</translation>
    </message>
    <message>
        <source>No estimate: %1</source>
        <translation>Bez odhadu: %1</translation>
    </message>
    <message>
        <source>The robot has moved: the next press gives the next estimate</source>
        <translation>Robot se pohnul: další přitlačení přinese další odhad</translation>
    </message>
</context>
<context>
    <name>terratact::PictureTools</name>
    <message>
        <source>Terrain picture</source>
        <translation>Obraz terénu</translation>
    </message>
    <message>
        <source>Copy the picture</source>
        <translation>Kopírovat obraz</translation>
    </message>
    <message>
        <source>Copy the numbers</source>
        <translation>Kopírovat čísla</translation>
    </message>
    <message>
        <source>Export …</source>
        <translation>Export …</translation>
    </message>
    <message>
        <source>Measure height and slope</source>
        <translation>Měřit výšku a sklon</translation>
    </message>
    <message>
        <source>Closer</source>
        <translation>Přiblížit</translation>
    </message>
    <message>
        <source>Farther away</source>
        <translation>Oddálit</translation>
    </message>
    <message>
        <source>The whole robot</source>
        <translation>Celý robot</translation>
    </message>
    <message>
        <source>measure height and slope between two points; again ends it</source>
        <translation>měřit výšku a sklon mezi dvěma body; znovu měření ukončí</translation>
    </message>
    <message>
        <source>menu of the picture: copy, export, measure, zoom</source>
        <translation>nabídka obrazu: kopírovat, export, měřit, přiblížit</translation>
    </message>
    <message>
        <source>in the picture (Tab): closer, farther away, the whole robot</source>
        <translation>v obraze (Tab): blíž, dál, celý robot</translation>
    </message>
    <message>
        <source>Export the picture</source>
        <translation>Export obrazu</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg *.pdf)</source>
        <translation>Obrázky (*.png *.svg *.pdf)</translation>
    </message>
    <message>
        <source>%1 exists and was not replaced; choose another name</source>
        <translation>%1 existuje a nebyl nahrazen; zvolte jiné jméno</translation>
    </message>
</context>
<context>
    <name>terratact::Place</name>
    <message>
        <source>at %1</source>
        <translation>v %1</translation>
    </message>
    <message>
        <source>left at %1</source>
        <translation>vlevo v %1</translation>
    </message>
    <message>
        <source>right at %1</source>
        <translation>vpravo v %1</translation>
    </message>
</context>
<context>
    <name>terratact::PlotValues</name>
    <message>
        <source>Plot</source>
        <translation>Graf</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signál</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Jednotka</translation>
    </message>
    <message>
        <source>Cursor</source>
        <translation>Kurzor</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Nejméně</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Nejvíce</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Průměr</translation>
    </message>
    <message>
        <source>sd</source>
        <translation>sd</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Hodnot</translation>
    </message>
    <message>
        <source>Values in sight</source>
        <translation>Viditelné hodnoty</translation>
    </message>
</context>
<context>
    <name>terratact::PlotsPage</name>
    <message>
        <source>plots below every page, and back</source>
        <translation>grafy pod každou stránkou, a zpět</translation>
    </message>
</context>
<context>
    <name>terratact::PlotsPanel</name>
    <message>
        <source>State of the plots</source>
        <translation>Stav grafů</translation>
    </message>
    <message>
        <source>Saved set of plots</source>
        <translation>Uložená sada grafů</translation>
    </message>
    <message>
        <source>name of a set</source>
        <translation>název sady</translation>
    </message>
    <message>
        <source>Name of a set</source>
        <translation>Název sady</translation>
    </message>
    <message>
        <source>Save set</source>
        <translation>Uložit sadu</translation>
    </message>
    <message>
        <source>Saves these plots under the name above</source>
        <translation>Uloží tyto grafy pod názvem nahoře</translation>
    </message>
    <message>
        <source>Delete set</source>
        <translation>Smazat sadu</translation>
    </message>
    <message>
        <source>Deletes the saved set of this name</source>
        <translation>Smaže uloženou sadu tohoto názvu</translation>
    </message>
    <message>
        <source>New plot</source>
        <translation>Nový graf</translation>
    </message>
    <message>
        <source>Plots the chosen signal in a new row</source>
        <translation>Kreslí vybraný signál v novém řádku</translation>
    </message>
    <message>
        <source>Add to plot</source>
        <translation>Do grafu</translation>
    </message>
    <message>
        <source>Adds the chosen signal to the chosen plot, which has a frame</source>
        <translation>Přidá vybraný signál do vybraného grafu, který má rámeček</translation>
    </message>
    <message>
        <source>Remove plot</source>
        <translation>Odebrat graf</translation>
    </message>
    <message>
        <source>Removes the chosen plot</source>
        <translation>Odebere vybraný graf</translation>
    </message>
    <message>
        <source>Closer</source>
        <translation>Blíž</translation>
    </message>
    <message>
        <source>Shows a shorter time; also the wheel, or a box drawn with the mouse</source>
        <translation>Ukáže kratší čas; také kolečkem nebo rámečkem nakresleným myší</translation>
    </message>
    <message>
        <source>Wider</source>
        <translation>Dál</translation>
    </message>
    <message>
        <source>Shows a longer time</source>
        <translation>Ukáže delší čas</translation>
    </message>
    <message>
        <source>Earlier</source>
        <translation>Dřív</translation>
    </message>
    <message>
        <source>Moves to earlier times; also a drag with the right button, or the wheel with Shift</source>
        <translation>Posune k dřívějším časům; také tažením pravým tlačítkem nebo kolečkem se Shiftem</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Později</translation>
    </message>
    <message>
        <source>Moves to later times</source>
        <translation>Posune k pozdějším časům</translation>
    </message>
    <message>
        <source>Cursor earlier</source>
        <translation>Kurzor dřív</translation>
    </message>
    <message>
        <source>Moves the cursor by a hundredth of the time in sight</source>
        <translation>Posune kurzor o setinu viditelného času</translation>
    </message>
    <message>
        <source>Cursor later</source>
        <translation>Kurzor později</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Vše</translation>
    </message>
    <message>
        <source>Shows everything</source>
        <translation>Ukáže vše</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Živě</translation>
    </message>
    <message>
        <source>Follows the newest values</source>
        <translation>Sleduje nejnovější hodnoty</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Měřítko</translation>
    </message>
    <message>
        <source>Fits the scales to the values in sight</source>
        <translation>Přizpůsobí stupnice viditelným hodnotám</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Čísla</translation>
    </message>
    <message>
        <source>Shows the values at the cursor and the statistics of the time in sight</source>
        <translation>Ukáže hodnoty u kurzoru a statistiku viditelného času</translation>
    </message>
    <message>
        <source>Dock</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Keeps the plots below every page, where the window is high enough</source>
        <translation>Nechá grafy pod každou stránkou, pokud je okno dost vysoké</translation>
    </message>
    <message>
        <source>No room: at most %1 plots, %2 signals in each, %3 in all</source>
        <translation>Není místo: nejvýš %1 grafů, v každém %2 signály, celkem %3</translation>
    </message>
    <message>
        <source>the session is read: %1 %</source>
        <translation>relace se čte: %1 %</translation>
    </message>
    <message>
        <source>Enter a name for the set first</source>
        <translation>Nejdřív zadejte název sady</translation>
    </message>
    <message>
        <source>There is no plot to save</source>
        <translation>Není žádný graf k uložení</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Uloženo: %1</translation>
    </message>
    <message>
        <source>Deleted: %1</source>
        <translation>Smazáno: %1</translation>
    </message>
</context>
<context>
    <name>terratact::PreconditionGrid</name>
    <message>
        <source>met</source>
        <translation>splněno</translation>
    </message>
    <message>
        <source>overridden</source>
        <translation>přebito</translation>
    </message>
    <message>
        <source>doubtful</source>
        <translation>sporné</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>chybí</translation>
    </message>
    <message>
        <source>%1 (overridden)</source>
        <translation>%1 (přebito)</translation>
    </message>
</context>
<context>
    <name>terratact::ProbeCard</name>
    <message>
        <source>Arm probe</source>
        <translation>Sonda ramenem</translation>
    </message>
    <message>
        <source>where</source>
        <translation>kde</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>odhad</translation>
    </message>
    <message>
        <source>80 % band</source>
        <translation>pásmo 80 %</translation>
    </message>
    <message>
        <source>costs</source>
        <translation>stojí</translation>
    </message>
    <message>
        <source>Hold the mouse button or Space for 1.5 s; releasing early has no effect</source>
        <translation>Držte tlačítko myši nebo mezerník 1.5 s; dřívější puštění neznamená nic</translation>
    </message>
    <message>
        <source>Progress of the probe</source>
        <translation>Průběh sondy</translation>
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
        <translation>tento bod na ± %1</translation>
    </message>
    <message>
        <source>≈ %1 s, arm out in smoke</source>
        <translation>≈ %1 s, rameno venku v kouři</translation>
    </message>
    <message>
        <source>%1 left, then refused</source>
        <translation>zbývá %1, pak ne</translation>
    </message>
    <message>
        <source>%1 of about %2</source>
        <translation>%1 z asi %2</translation>
    </message>
    <message>
        <source>all bins</source>
        <translation>všechny body</translation>
    </message>
    <message>
        <source>step ahead</source>
        <translation>schod vpředu</translation>
    </message>
    <message>
        <source>Do not probe: 0 s, the estimate stays (N)</source>
        <translation>Bez sondy: 0 s, odhad zůstane (N)</translation>
    </message>
    <message>
        <source>Refuses the probe; the estimate stays as it is</source>
        <translation>Odmítne sondu; odhad zůstane, jak je</translation>
    </message>
    <message>
        <source>step &gt; %1</source>
        <translation>schod &gt; %1</translation>
    </message>
    <message>
        <source>total variance %1 %</source>
        <translation>celkový rozptyl %1 %</translation>
    </message>
    <message>
        <source>not known for this method</source>
        <translation>u této metody neznámo</translation>
    </message>
    <message>
        <source>%1: %2, %3 %</source>
        <translation>%1: %2, %3 %</translation>
    </message>
    <message>
        <source>Expected gain of the probe</source>
        <translation>Co má sonda přinést</translation>
    </message>
    <message>
        <source>Do not probe (N)</source>
        <translation>Bez sondy (N)</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>zbývá %1</translation>
    </message>
    <message>
        <source>Need for a probe</source>
        <translation>Zda je sonda potřeba</translation>
    </message>
    <message>
        <source>80 % in %1 … %2</source>
        <translation>80 % v %1 … %2</translation>
    </message>
    <message>
        <source>%1 for %2 s</source>
        <translation>%1 za %2 s</translation>
    </message>
    <message>
        <source>step: not known for this method</source>
        <translation>schod: u této metody neznámo</translation>
    </message>
    <message>
        <source>%1 bit, no gain</source>
        <translation>%1 bit, bez zisku</translation>
    </message>
    <message>
        <source>step: %1 bit, no gain</source>
        <translation>schod: %1 bit, bez zisku</translation>
    </message>
    <message>
        <source>Already %1; no gain</source>
        <translation>%1 platí: bez zisku</translation>
    </message>
    <message>
        <source>step: %1 → %2 bit, %3/min</source>
        <translation>schod: %1 → %2 bit, %3/min</translation>
    </message>
    <message>
        <source>Already %1; a probe makes it more certain.</source>
        <translation>%1 platí: sonda dá větší jistotu.</translation>
    </message>
    <message>
        <source>Do not probe: 0 s, keep %1 (N)</source>
        <translation>Bez sondy: 0 s, %1 platí (N)</translation>
    </message>
    <message>
        <source>Already %1; a probe only refines the profile.</source>
        <translation>%1 platí: zpřesní jen profil.</translation>
    </message>
    <message>
        <source>%1 → %2 bit: %3/min</source>
        <translation>%1 → %2 bit: %3/min</translation>
    </message>
    <message>
        <source>The other bins, the best first</source>
        <translation>Ostatní body, nejlepší první</translation>
    </message>
    <message>
        <source>Cannot be approved: %1</source>
        <translation>Nelze schválit: %1</translation>
    </message>
    <message>
        <source>void</source>
        <translation>neplatí</translation>
    </message>
    <message>
        <source>%1: %2 ± %3</source>
        <translation>%1: %2 ± %3</translation>
    </message>
    <message>
        <source>Ask for %1 instead: total variance %2 %, step ahead to %3 bit</source>
        <translation>Místo toho %1: celkový rozptyl %2 %, schod vpředu na %3 bit</translation>
    </message>
    <message>
        <source>or %1: %2 %, %3 bit</source>
        <translation>nebo %1: %2 %, %3 bit</translation>
    </message>
    <message>
        <source>approval void: probe %1</source>
        <translation>schválení neplatí: sonda %1</translation>
    </message>
    <message>
        <source>hold to approve probe %1 (Space)</source>
        <translation>držet: sonda %1 (mezerník)</translation>
    </message>
    <message>
        <source>The probe of %1 cannot be approved</source>
        <translation>Sondu nelze schválit: %1</translation>
    </message>
    <message>
        <source>Hold to approve the probe of %1</source>
        <translation>Držením schválit sondu: %1</translation>
    </message>
    <message>
        <source>The arm is probing %1</source>
        <translation>Rameno sonduje %1</translation>
    </message>
    <message>
        <source>no probe is proposed</source>
        <translation>žádná sonda není navržena</translation>
    </message>
</context>
<context>
    <name>terratact::ProfileMenu</name>
    <message>
        <source>Some of the draws as thin lines (D)</source>
        <translation>Některé vzorky jako tenké čáry (D)</translation>
    </message>
    <message>
        <source>A second method beside it</source>
        <translation>Druhá metoda vedle</translation>
    </message>
    <message>
        <source>none</source>
        <translation>žádná</translation>
    </message>
    <message>
        <source>Estimates of this run … (Ctrl+H)</source>
        <translation>Odhady tohoto běhu … (Ctrl+H)</translation>
    </message>
    <message>
        <source>Restore the hidden estimate (Ctrl+Z)</source>
        <translation>Obnovit skrytý odhad (Ctrl+Z)</translation>
    </message>
</context>
<context>
    <name>terratact::Provenance</name>
    <message>
        <source>arm</source>
        <translation>rameno</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>kontakt</translation>
    </message>
    <message>
        <source>constrained</source>
        <translation>vymezeno</translation>
    </message>
    <message>
        <source>sampled</source>
        <translation>vzorkováno</translation>
    </message>
    <message>
        <source>prior only</source>
        <translation>jen apriori</translation>
    </message>
    <message>
        <source>A</source>
        <comment>letter of a mark</comment>
        <translation>R</translation>
    </message>
    <message>
        <source>C</source>
        <comment>letter of a mark</comment>
        <translation>K</translation>
    </message>
    <message>
        <source>E</source>
        <comment>letter of a mark</comment>
        <translation>O</translation>
    </message>
    <message>
        <source>S</source>
        <comment>letter of a mark</comment>
        <translation>V</translation>
    </message>
    <message>
        <source>P</source>
        <comment>letter of a mark</comment>
        <translation>A</translation>
    </message>
</context>
<context>
    <name>terratact::RawTrace</name>
    <message>
        <source>after a gap</source>
        <translation>po mezeře</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>špatný součet</translation>
    </message>
    <message>
        <source>repeated or out of sequence</source>
        <translation>opakovaný nebo mimo pořadí</translation>
    </message>
    <message>
        <source>not usable</source>
        <translation>nepoužitelné</translation>
    </message>
    <message>
        <source>not in the DBC</source>
        <translation>mimo DBC</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Číslo</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Čas [s]</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Id</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Rámec</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bajty</translation>
    </message>
    <message>
        <source>Content</source>
        <translation>Obsah</translation>
    </message>
    <message>
        <source>%1 (from here)</source>
        <translation>%1 (odsud)</translation>
    </message>
    <message>
        <source>id (hexadecimal) or a part of the name</source>
        <translation>id (šestnáctkově) nebo část názvu</translation>
    </message>
    <message>
        <source>Filter of the frames</source>
        <translation>Filtr rámců</translation>
    </message>
    <message>
        <source>Pause display</source>
        <translation>Podržet obraz</translation>
    </message>
    <message>
        <source>Display paused; recording and counting continue</source>
        <translation>Seznam stojí; vše se přesto přijímá a počítá</translation>
    </message>
    <message>
        <source>Newest frames</source>
        <translation>Poslední rámce</translation>
    </message>
    <message>
        <source>Paused: continue</source>
        <translation>Stojí: pokračovat</translation>
    </message>
    <message>
        <source>%1 of the newest %2 frames</source>
        <translation>%1 z posledních %2 rámců</translation>
    </message>
</context>
<context>
    <name>terratact::RearView</name>
    <message>
        <source>%1 L up</source>
        <translation>%1, L výš</translation>
    </message>
    <message>
        <source>%1 R up</source>
        <translation>%1, P výš</translation>
    </message>
    <message>
        <source>roll %1</source>
        <translation>náklon %1</translation>
    </message>
    <message>
        <source>From behind: %1; front flippers L %2, R %3</source>
        <translation>Zezadu: %1; přední flippery L %2, P %3</translation>
    </message>
    <message>
        <source>View from behind</source>
        <translation>Pohled zezadu</translation>
    </message>
    <message>
        <source>From behind: not known</source>
        <translation>Zezadu: není známo</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>R</source>
        <translation>P</translation>
    </message>
    <message>
        <source>cross %1</source>
        <translation>příčně %1</translation>
    </message>
    <message>
        <source>cross slope %1</source>
        <translation>příčný sklon %1</translation>
    </message>
</context>
<context>
    <name>terratact::RemoteStop</name>
    <message>
        <source>STOP SENT to the console that opened this window …</source>
        <translation>STOP ODESLÁN konzoli, která toto okno otevřela …</translation>
    </message>
    <message>
        <source>STOP HAS NO EFFECT HERE: the console that opened this window is gone</source>
        <translation>STOP TU NEPŮSOBÍ: konzole, která toto okno otevřela, už neběží</translation>
    </message>
    <message>
        <source>STOP NOT SENT: the console&apos;s stop line was not found at %1; press STOP in the console, or use the robot&apos;s own switch</source>
        <translation>STOP NEODESLÁN: spojení s konzolí nebylo v %1 nalezeno; stiskněte STOP v konzoli, nebo použijte vypínač na robotu</translation>
    </message>
    <message>
        <source>STOP NOT SENT: %1</source>
        <translation>STOP NEODESLÁN: %1</translation>
    </message>
    <message>
        <source>STOP: the console that opened this window has received it; look there whether the robot confirms it</source>
        <translation>STOP: konzole, která toto okno otevřela, jej převzala; tam uvidíte, zda jej robot potvrdí</translation>
    </message>
    <message>
        <source>STOP NOT RECEIVED: the console that opened this window does not answer; use the robot&apos;s own switch</source>
        <translation>STOP NEPŘEVZAT: konzole, která toto okno otevřela, neodpovídá; použijte vypínač na robotu</translation>
    </message>
</context>
<context>
    <name>terratact::ReplayBar</name>
    <message>
        <source>Replay</source>
        <translation>Přehrávání</translation>
    </message>
    <message>
        <source>◀ %1 s</source>
        <translation>◀ %1 s</translation>
    </message>
    <message>
        <source>Steps back in the log (Ctrl+Left)</source>
        <translation>Vrátí se v záznamu zpět (Ctrl+vlevo)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pozastavit</translation>
    </message>
    <message>
        <source>Pauses or continues the log (Ctrl+Space)</source>
        <translation>Zastaví záznam, nebo ho nechá běžet dál (Ctrl+mezerník)</translation>
    </message>
    <message>
        <source>%1 s ▶</source>
        <translation>%1 s ▶</translation>
    </message>
    <message>
        <source>Steps forward in the log (Ctrl+Right)</source>
        <translation>Přejde v záznamu dál (Ctrl+vpravo)</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Opakovat</translation>
    </message>
    <message>
        <source>Repeats the log from its end (Ctrl+R)</source>
        <translation>Na konci záznamu začne znovu (Ctrl+R)</translation>
    </message>
    <message>
        <source>How far the log is</source>
        <translation>Jak daleko je záznam</translation>
    </message>
    <message>
        <source>pause or continue the log</source>
        <translation>pozastavit záznam, nebo ho nechat běžet dál</translation>
    </message>
    <message>
        <source>back in the log</source>
        <translation>zpět v záznamu</translation>
    </message>
    <message>
        <source>forward in the log</source>
        <translation>dál v záznamu</translation>
    </message>
    <message>
        <source>repeat the log, on or off</source>
        <translation>na konci záznamu začít znovu, nebo ne</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Pokračovat</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 z %2 s</translation>
    </message>
    <message>
        <source>paused at %1</source>
        <translation>pozastaveno v %1</translation>
    </message>
</context>
<context>
    <name>terratact::ReviewEventsPage</name>
    <message>
        <source>time</source>
        <translation>čas</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>druh</translation>
    </message>
    <message>
        <source>what</source>
        <translation>co</translation>
    </message>
    <message>
        <source>on the screen</source>
        <translation>na obrazovce</translation>
    </message>
    <message>
        <source>Events of the session</source>
        <translation>Události relace</translation>
    </message>
    <message>
        <source>Active alarms</source>
        <translation>Trvající alarmy</translation>
    </message>
    <message>
        <source>Kind of the events</source>
        <translation>Druh událostí</translation>
    </message>
    <message>
        <source>Which events are listed</source>
        <translation>Které události se vypisují</translation>
    </message>
    <message>
        <source>all kinds</source>
        <translation>všechny druhy</translation>
    </message>
    <message>
        <source>Enter or a double click goes to that time</source>
        <translation>Enter nebo dvojklik přejde na místo</translation>
    </message>
    <message>
        <source>No alarm was active at this time.</source>
        <translation>V tomto čase netrval žádný alarm.</translation>
    </message>
    <message>
        <source>Alarms at this time: %1</source>
        <translation>Alarmy v tomto čase: %1</translation>
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
        <translation>%1 až %2</translation>
    </message>
    <message>
        <source>Export — %1</source>
        <translation>Export — %1</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Průběh exportu</translation>
    </message>
    <message>
        <source>Result of the export</source>
        <translation>Výsledek exportu</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Co</translation>
    </message>
    <message>
        <source>Part of the session to export</source>
        <translation>Co z relace má být v souboru</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Formát</translation>
    </message>
    <message>
        <source>Which programs can read it</source>
        <translation>Které programy to přečtou</translation>
    </message>
    <message>
        <source>Of</source>
        <translation>Rozsah</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Soubor</translation>
    </message>
    <message>
        <source>From A to B, else the visible part of the timeline: zoom with Z and X</source>
        <translation>Od A do B, jinak co ukazuje časová osa: přiblížení Z a X</translation>
    </message>
    <message>
        <source>Where it is written</source>
        <translation>Kam se zapíše</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Vybrat …</translation>
    </message>
    <message>
        <source>Choose the file</source>
        <translation>Vybrat soubor</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
    <message>
        <source>Cancels the export and leaves no file (Esc)</source>
        <translation>Ukončí export a nezanechá soubor (Esc)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zavřít</translation>
    </message>
    <message>
        <source>from A to B, %1</source>
        <translation>od A do B, %1</translation>
    </message>
    <message>
        <source>what is visible: all, %1</source>
        <translation>co je vidět: vše, %1</translation>
    </message>
    <message>
        <source>what is visible, %1</source>
        <translation>co je vidět, %1</translation>
    </message>
    <message>
        <source>everything, %1</source>
        <translation>vše, %1</translation>
    </message>
    <message>
        <source>this time, %1</source>
        <translation>tento čas, %1</translation>
    </message>
    <message>
        <source>scene %1</source>
        <translation>scéna %1</translation>
    </message>
    <message>
        <source>there is no estimate at this time</source>
        <translation>v tomto čase není žádný odhad</translation>
    </message>
    <message>
        <source>Replace the file</source>
        <translation>Nahradit soubor</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>Exportovat do</translation>
    </message>
    <message>
        <source>Cancelled: no file was written</source>
        <translation>Zrušeno: žádný soubor nebyl zapsán</translation>
    </message>
    <message>
        <source>NOT WRITTEN: %1</source>
        <translation>NEZAPSÁNO: %1</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Zapsáno: %1</translation>
    </message>
    <message>
        <source>frames left out because the format cannot hold them: %1</source>
        <translation>vynechané rámce, které formát neumí: %1</translation>
    </message>
    <message>
        <source>damaged and left out, places: %1</source>
        <translation>poškozeno a vynecháno, míst: %1</translation>
    </message>
    <message>
        <source>A file is being written</source>
        <translation>Zapisuje se soubor</translation>
    </message>
    <message>
        <source>There is no estimate at this time</source>
        <translation>V tomto čase není žádný odhad</translation>
    </message>
    <message>
        <source>Name the file first</source>
        <translation>Nejdřív pojmenujte soubor</translation>
    </message>
    <message>
        <source>Writes the file</source>
        <translation>Zapíše soubor</translation>
    </message>
    <message>
        <source>The whole session</source>
        <translation>Celá relace</translation>
    </message>
    <message>
        <source>Nothing is being written</source>
        <translation>Nic se nezapisuje</translation>
    </message>
    <message>
        <source>Other devices</source>
        <translation>Jiná zařízení</translation>
    </message>
    <message>
        <source>with the signals of %1</source>
        <translation>se signály podle %1</translation>
    </message>
    <message>
        <source>no DBC file describes them</source>
        <translation>nepopisuje je žádný soubor DBC</translation>
    </message>
    <message>
        <source>The page Signals (F7) adds DBC files</source>
        <translation>Soubory DBC přidává stránka Signály (F7)</translation>
    </message>
    <message>
        <source>Only the kind Signals holds the values of DBC files</source>
        <translation>Co popisují soubory DBC, je jen v signálech</translation>
    </message>
    <message>
        <source>messages of DBC files left out for lack of room: %1</source>
        <translation>vynechané zprávy ze souborů DBC, na něž nezbylo místo: %1</translation>
    </message>
    <message>
        <source>the whole session, %1</source>
        <translation>celá relace, %1</translation>
    </message>
</context>
<context>
    <name>terratact::ReviewNoteField</name>
    <message>
        <source>note (M)</source>
        <translation>poznámka (M)</translation>
    </message>
    <message>
        <source>Note at this time</source>
        <translation>Poznámka k tomuto času</translation>
    </message>
    <message>
        <source>Kept beside the session, in %1; Enter saves it</source>
        <translation>Ukládá se vedle relace, do %1; Enter ji uloží</translation>
    </message>
    <message>
        <source>NOTE NOT SAVED: %1</source>
        <translation>POZNÁMKA NEULOŽENA: %1</translation>
    </message>
</context>
<context>
    <name>terratact::ReviewPlayerBar</name>
    <message>
        <source>From A to B</source>
        <translation>Od A do B</translation>
    </message>
    <message>
        <source>To the beginning</source>
        <translation>Na začátek</translation>
    </message>
    <message>
        <source>To the beginning (Home)</source>
        <translation>Na začátek (Home)</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>Rámec zpět</translation>
    </message>
    <message>
        <source>Previous frame (,)</source>
        <translation>O rámec zpět (,)</translation>
    </message>
    <message>
        <source>Play backwards</source>
        <translation>Přehrávat pozpátku</translation>
    </message>
    <message>
        <source>Play backwards (J)</source>
        <translation>Přehrávat pozpátku (J)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Přehrát</translation>
    </message>
    <message>
        <source>Play, pause (Space)</source>
        <translation>Přehrát, pozastavit (mezerník)</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Rámec vpřed</translation>
    </message>
    <message>
        <source>Next frame (.)</source>
        <translation>O rámec vpřed (.)</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Na konec</translation>
    </message>
    <message>
        <source>To the end (End)</source>
        <translation>Na konec (End)</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>Pomaleji</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Rychlost</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>Rychleji</translation>
    </message>
    <message>
        <source>Twice as fast (F)</source>
        <translation>Dvojnásobnou rychlostí (F)</translation>
    </message>
    <message>
        <source>Cursor A here</source>
        <translation>Kurzor A sem</translation>
    </message>
    <message>
        <source>Cursor A here (A); again removes it</source>
        <translation>Kurzor A sem (A); znovu jej odstraní</translation>
    </message>
    <message>
        <source>Cursor B here</source>
        <translation>Kurzor B sem</translation>
    </message>
    <message>
        <source>Cursor B here (B); again removes it</source>
        <translation>Kurzor B sem (B); znovu jej odstraní</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>smyčka</translation>
    </message>
    <message>
        <source>Loop between A and B</source>
        <translation>Smyčka mezi A a B</translation>
    </message>
    <message>
        <source>Play from A to B again and again (P)</source>
        <translation>Přehrávat od A do B stále dokola (P)</translation>
    </message>
    <message>
        <source>follow</source>
        <translation>sledovat</translation>
    </message>
    <message>
        <source>Follow the end</source>
        <translation>Sledovat konec</translation>
    </message>
    <message>
        <source>Stay at the end of a session that is still recorded (T)</source>
        <translation>Zůstat na konci relace, která se ještě zaznamenává (T)</translation>
    </message>
    <message>
        <source>Time in the session</source>
        <translation>Čas v relaci</translation>
    </message>
    <message>
        <source>Go to a time (G): seconds, or hours:minutes:seconds</source>
        <translation>Přejít na čas (G): sekundy, nebo hodiny:minuty:sekundy</translation>
    </message>
    <message>
        <source>of %1 · %2%3</source>
        <translation>z %1 · %2%3</translation>
    </message>
    <message>
        <source>END</source>
        <translation>KONEC</translation>
    </message>
    <message>
        <source>BEGIN</source>
        <translation>ZAČÁTEK</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pozastavit</translation>
    </message>
    <message>
        <source>The session is closed: it does not grow any more</source>
        <translation>Relace je uzavřena: nic dalšího nepřijde</translation>
    </message>
    <message>
        <source>play, pause</source>
        <translation>přehrát, pozastavit</translation>
    </message>
    <message>
        <source>play backwards</source>
        <translation>přehrávat pozpátku</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>pozastavit</translation>
    </message>
    <message>
        <source>play</source>
        <translation>přehrát</translation>
    </message>
    <message>
        <source>twice as fast</source>
        <translation>dvojnásobnou rychlostí</translation>
    </message>
    <message>
        <source>half as fast</source>
        <translation>poloviční rychlostí</translation>
    </message>
    <message>
        <source>cursor A here; again removes it</source>
        <translation>kurzor A sem; znovu jej odstraní</translation>
    </message>
    <message>
        <source>cursor B here; again removes it</source>
        <translation>kurzor B sem; znovu jej odstraní</translation>
    </message>
    <message>
        <source>loop from A to B</source>
        <translation>smyčka od A do B</translation>
    </message>
    <message>
        <source>follow a session that is still recorded</source>
        <translation>sledovat relaci, která se zaznamenává</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Přejít</translation>
    </message>
    <message>
        <source>previous frame</source>
        <translation>o rámec zpět</translation>
    </message>
    <message>
        <source>next frame</source>
        <translation>o rámec vpřed</translation>
    </message>
    <message>
        <source>a second back</source>
        <translation>o sekundu zpět</translation>
    </message>
    <message>
        <source>a second on</source>
        <translation>o sekundu vpřed</translation>
    </message>
    <message>
        <source>to the next event</source>
        <translation>na další událost</translation>
    </message>
    <message>
        <source>to the next: %1 (with Alt: previous)</source>
        <translation>na další: %1 (s Alt: předchozí)</translation>
    </message>
    <message>
        <source>to the beginning</source>
        <translation>na začátek</translation>
    </message>
    <message>
        <source>to the end</source>
        <translation>na konec</translation>
    </message>
    <message>
        <source>to a time</source>
        <translation>na čas</translation>
    </message>
    <message>
        <source>Half as fast (H)</source>
        <translation>Poloviční rychlost (H)</translation>
    </message>
    <message>
        <source>to the previous scene, with its estimate</source>
        <translation>na předchozí scénu s jejím odhadem</translation>
    </message>
    <message>
        <source>to the next scene, with its estimate</source>
        <translation>na další scénu s jejím odhadem</translation>
    </message>
    <message>
        <source>to the previous event</source>
        <translation>na předchozí událost</translation>
    </message>
</context>
<context>
    <name>terratact::ReviewSignalsPage</name>
    <message>
        <source>Signals of other devices</source>
        <translation>Signály jiných zařízení</translation>
    </message>
    <message>
        <source>Which signals these are</source>
        <translation>Které signály to jsou</translation>
    </message>
    <message>
        <source>No other device had sent a frame in the %1 s before this time</source>
        <translation>Žádné jiné zařízení neposlalo v %1 s před tímto časem rámec</translation>
    </message>
    <message>
        <source>The newest values of the %1 s before this time; minimum and maximum are of those seconds</source>
        <translation>Nejnovější hodnoty z %1 s před tímto časem; nejmenší a největší jsou z těchto sekund</translation>
    </message>
</context>
<context>
    <name>terratact::ReviewWindow</name>
    <message>
        <source>REVIEW — %1 — Terratact</source>
        <translation>PROHLÍŽENÍ — %1 — Terratact</translation>
    </message>
    <message>
        <source>REVIEW · %1</source>
        <translation>PROHLÍŽENÍ · %1</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Terén</translation>
    </message>
    <message>
        <source>What the operator saw at this time</source>
        <translation>Co operátor v tomto čase viděl</translation>
    </message>
    <message>
        <source>No estimate at this time</source>
        <translation>V tomto čase neplatil žádný odhad</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Čísla</translation>
    </message>
    <message>
        <source>The scene of this time as a table</source>
        <translation>Scéna tohoto času jako tabulka</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Události</translation>
    </message>
    <message>
        <source>All events of the session</source>
        <translation>Všechny události relace</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Forces, attitude and the last events</source>
        <translation>Síly, náklon a poslední události</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>Co kdyby</translation>
    </message>
    <message>
        <source>Estimate the recorded scene with other settings</source>
        <translation>Odhadnout zaznamenanou scénu s jiným nastavením</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otevřít</translation>
    </message>
    <message>
        <source>Open a file in another window (Ctrl+O)</source>
        <translation>Otevřít soubor v jiném okně (Ctrl+O)</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vzhled</translation>
    </message>
    <message>
        <source>recorded %1</source>
        <translation>zaznamenáno %1</translation>
    </message>
    <message>
        <source>closed and sealed</source>
        <translation>uzavřena a zapečetěna</translation>
    </message>
    <message>
        <source>BEING RECORDED</source>
        <translation>PRÁVĚ SE ZAZNAMENÁVÁ</translation>
    </message>
    <message>
        <source>NOT SEALED: the recording program did not close it</source>
        <translation>NEZAPEČETĚNO: program ji neuzavřel</translation>
    </message>
    <message>
        <source>DAMAGED, places: %1</source>
        <translation>POŠKOZENO, míst: %1</translation>
    </message>
    <message>
        <source>frames are looked through …</source>
        <translation>rámce se procházejí …</translation>
    </message>
    <message>
        <source>no command can be sent</source>
        <translation>nelze odeslat žádný povel</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Stránky</translation>
    </message>
    <message>
        <source>estimate the recorded scene again on the page What if</source>
        <translation>odhadnout zaznamenanou scénu znovu, na stránce Co kdyby</translation>
    </message>
    <message>
        <source>a note at this time</source>
        <translation>poznámka k tomuto času</translation>
    </message>
    <message>
        <source>open another file</source>
        <translation>otevřít jiný soubor</translation>
    </message>
    <message>
        <source>timeline closer</source>
        <translation>přiblížit časovou osu</translation>
    </message>
    <message>
        <source>timeline wider</source>
        <translation>oddálit časovou osu</translation>
    </message>
    <message>
        <source>all of the timeline</source>
        <translation>celá časová osa</translation>
    </message>
    <message>
        <source>show some draws as thin lines</source>
        <translation>některé vzorky jako tenké čáry</translation>
    </message>
    <message>
        <source>back from a field to the keys</source>
        <translation>z pole zpět ke klávesám</translation>
    </message>
    <message>
        <source>to the next control, to the previous one</source>
        <translation>na další prvek, na předchozí</translation>
    </message>
    <message>
        <source>Exports the visible part or the whole session to a file (Ctrl+E)</source>
        <translation>Zapsat zobrazené nebo obsah relace do souboru (Ctrl+E)</translation>
    </message>
    <message>
        <source>export to a file</source>
        <translation>exportovat do souboru</translation>
    </message>
    <message>
        <source>at the next start</source>
        <translation>po novém spuštění</translation>
    </message>
    <message>
        <source>In the console the same keys send commands. A explores, B asks for a probe, F feels forward and drives, M arms, Space approves a probe. Up and Down drive, Page Up and Down change the limit. P shows what a command needs, K marks, 1 to 3 ask for another bin.</source>
        <translation>V konzoli tytéž klávesy vysílají povely. A zkoumá, B žádá o sondu, F ohmatává vpřed a jede, M aktivuje, mezerník schvaluje sondu. Šipky nahoru a dolů jedou, Page Up a Down mění mez. P ukáže, co povel potřebuje, K značí, 1 až 3 žádají o jiný bod.</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signály</translation>
    </message>
    <message>
        <source>What other devices had sent: gas sensors, batteries</source>
        <translation>Co poslala jiná zařízení: snímače plynů, baterie</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Grafy</translation>
    </message>
    <message>
        <source>Any signal over the session</source>
        <translation>Libovolný signál přes celou relaci</translation>
    </message>
</context>
<context>
    <name>terratact::RobotReadout</name>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>podélný sklon</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>náklon</translation>
    </message>
    <message>
        <source>front flippers</source>
        <translation>přední flippery</translation>
    </message>
    <message>
        <source>rear flippers</source>
        <translation>zadní flippery</translation>
    </message>
    <message>
        <source>front currents</source>
        <translation>proudy vpředu</translation>
    </message>
    <message>
        <source>rear currents</source>
        <translation>proudy vzadu</translation>
    </message>
    <message>
        <source>L %1   R %2</source>
        <translation>L %1   P %2</translation>
    </message>
    <message>
        <source>%1   captured %2</source>
        <translation>%1   sejmuto %2</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>stáří %1</translation>
    </message>
    <message>
        <source>; beside it the value of the captured scene, at which the robot is drawn</source>
        <translation>; vedle je hodnota zachycené scény: robot je nakreslen, jak tehdy stál</translation>
    </message>
    <message>
        <source>%1 DANGER</source>
        <translation>%1 POZOR</translation>
    </message>
    <message>
        <source>%1 STEEP</source>
        <translation>%1 STRMĚ</translation>
    </message>
</context>
<context>
    <name>terratact::SceneRows</name>
    <message>
        <source>scene</source>
        <translation>scéna</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>jízda</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>čas [s]</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>podélný sklon</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>náklon</translation>
    </message>
    <message>
        <source>truth</source>
        <translation>skutečnost</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>verdikt</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>neznámá</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>error, median</source>
        <translation>chyba, medián</translation>
    </message>
    <message>
        <source>error, mean</source>
        <translation>chyba, průměr</translation>
    </message>
    <message>
        <source>%1 bins</source>
        <translation>%1 bodů</translation>
    </message>
</context>
<context>
    <name>terratact::ScenesPage</name>
    <message>
        <source>Scenes of the file</source>
        <translation>Scény souboru</translation>
    </message>
    <message>
        <source>Summary of the scenes</source>
        <translation>Souhrn scén</translation>
    </message>
    <message>
        <source>Enter or a double click shows the scene; typing a number goes to it</source>
        <translation>Enter nebo dvojklik ukáže scénu; napsané číslo na ni přejde</translation>
    </message>
    <message>
        <source>%1 CLEAR, %2 BLOCKED, %3 CANNOT TELL</source>
        <translation>VOLNO %1, PŘEKÁŽKA %2, NELZE ŘÍCI %3</translation>
    </message>
    <message>
        <source>%1 of %2 scenes estimated now · %3 · %4</source>
        <translation>odhadnuto %1 z %2 scén · %3 · %4</translation>
    </message>
    <message>
        <source>no truth is known</source>
        <translation>skutečnost není známa</translation>
    </message>
    <message>
        <source>median error of the median scene: %1</source>
        <translation>medián chyby prostřední scény: %1</translation>
    </message>
</context>
<context>
    <name>terratact::ScenesWindow</name>
    <message>
        <source>SCENES — %1 — Terratact</source>
        <translation>SCÉNY — %1 — Terratact</translation>
    </message>
    <message>
        <source>SCENES OF A FILE</source>
        <translation>SCÉNY ZE SOUBORU</translation>
    </message>
    <message>
        <source>model loading …</source>
        <translation>model se načítá …</translation>
    </message>
    <message>
        <source>model %1</source>
        <translation>model %1</translation>
    </message>
    <message>
        <source>no model</source>
        <translation>bez modelu</translation>
    </message>
    <message>
        <source>Estimating …</source>
        <translation>Odhaduje se …</translation>
    </message>
    <message>
        <source>A scene of a file commands no robot</source>
        <translation>Scéna ze souboru neřídí žádného robota</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>Scény</translation>
    </message>
    <message>
        <source>next scene</source>
        <translation>další scéna</translation>
    </message>
    <message>
        <source>previous scene</source>
        <translation>předchozí scéna</translation>
    </message>
    <message>
        <source>first scene</source>
        <translation>první scéna</translation>
    </message>
    <message>
        <source>last scene</source>
        <translation>poslední scéna</translation>
    </message>
    <message>
        <source>no link: a file</source>
        <translation>bez spojení: soubor</translation>
    </message>
    <message>
        <source>robot: --</source>
        <translation>robot: --</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Terén</translation>
    </message>
    <message>
        <source>The scene and its estimate</source>
        <translation>Scéna a její odhad</translation>
    </message>
    <message>
        <source>next
.</source>
        <translation>další
.</translation>
    </message>
    <message>
        <source>Next scene (.)</source>
        <translation>Další scéna (.)</translation>
    </message>
    <message>
        <source>Previous scene (,)</source>
        <translation>Předchozí scéna (,)</translation>
    </message>
    <message>
        <source>All scenes, their verdicts and errors</source>
        <translation>Všechny scény, jejich verdikty a chyby</translation>
    </message>
    <message>
        <source>the truth is unknown</source>
        <translation>skutečnost není známa</translation>
    </message>
    <message>
        <source>no error yet</source>
        <translation>chyba zatím není</translation>
    </message>
    <message>
        <source>error: median %1 mm, mean %2 mm</source>
        <translation>chyba: medián %1 mm, průměr %2 mm</translation>
    </message>
    <message>
        <source>SCENE %1 of %2 in %3 · drive %4 at %5 s · estimated now, not recorded · %6</source>
        <translation>SCÉNA %1 z %2 v %3 · jízda %4 v %5 s · odhadnuto teď, bez záznamu · %6</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Stránky</translation>
    </message>
    <message>
        <source>previous
,</source>
        <translation>předchozí
,</translation>
    </message>
</context>
<context>
    <name>terratact::ScreenshotDemo</name>
    <message>
        <source>the demonstration took too long</source>
        <translation>ukázka trvala příliš dlouho</translation>
    </message>
    <message>
        <source>%1 shows the window at that time</source>
        <translation>%1 ukazuje okno v té chvíli</translation>
    </message>
</context>
<context>
    <name>terratact::SecondView</name>
    <message>
        <source>%1 — view only — Terratact</source>
        <translation>%1 — jen pro čtení — Terratact</translation>
    </message>
</context>
<context>
    <name>terratact::SessionBrowser</name>
    <message>
        <source>Recordings</source>
        <translation>Záznamy jízd</translation>
    </message>
    <message>
        <source>Enter or a double click opens a recording; Alt+1 to Alt+0 sort by a column</source>
        <translation>Enter nebo dvojklik otevře záznam; Alt+1 až Alt+0 řadí podle sloupce</translation>
    </message>
    <message>
        <source>Search the recordings</source>
        <translation>Hledat v záznamech</translation>
    </message>
    <message>
        <source>Search (/): date, robot, verdict, notes, state</source>
        <translation>Hledat (/): datum, robot, verdikt, poznámky, stav</translation>
    </message>
    <message>
        <source>&amp;Folder…</source>
        <translation>&amp;Složka…</translation>
    </message>
    <message>
        <source>Shows the recordings of another folder, also at the next start</source>
        <translation>Ukáže záznamy jiné složky, i při příštím spuštění</translation>
    </message>
    <message>
        <source>State of the list</source>
        <translation>Stav seznamu</translation>
    </message>
    <message>
        <source>O&amp;ther file…</source>
        <translation>&amp;Jiný soubor…</translation>
    </message>
    <message>
        <source>Asks for a session, a log or scenes anywhere</source>
        <translation>Zeptá se na relaci, záznam nebo scény kdekoli</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zavřít</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Otevřít</translation>
    </message>
    <message>
        <source>Reviews the chosen recording in another window (Enter)</source>
        <translation>Otevře vybraný záznam k prohlížení v jiném okně (Enter)</translation>
    </message>
    <message>
        <source>reading: %1 of %2 recordings</source>
        <translation>čte se: %1 z %2 záznamů</translation>
    </message>
    <message>
        <source>%1 of %2 recordings match</source>
        <translation>odpovídá %1 z %2 záznamů</translation>
    </message>
    <message>
        <source>recordings: %1</source>
        <translation>záznamů: %1</translation>
    </message>
    <message>
        <source>%1 older ones are not listed</source>
        <translation>starších mimo seznam: %1</translation>
    </message>
    <message>
        <source>The folder is being read …</source>
        <translation>Složka se čte …</translation>
    </message>
    <message>
        <source>No recording matches the search.</source>
        <translation>Hledání neodpovídá žádný záznam.</translation>
    </message>
    <message>
        <source>The folder holds no recording.</source>
        <translation>Ve složce není žádný záznam.</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Složka záznamů</translation>
    </message>
</context>
<context>
    <name>terratact::SessionDetails</name>
    <message>
        <source>This console is recording it. It can be reviewed meanwhile.</source>
        <translation>Tato konzole ho právě zaznamenává. Prohlížet ho lze už teď.</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 frames, %4 scenes, %5 estimates</source>
        <translation>%1 · %2 · rámců %3, scén %4, odhadů %5</translation>
    </message>
    <message>
        <source>last verdicts of the scenes: %1</source>
        <translation>poslední verdikty scén: %1</translation>
    </message>
    <message>
        <source>probes: %1 approved of %2 proposed; alarms raised: %3</source>
        <translation>sondy: schváleno %1 z %2 navržených; alarmů: %3</translation>
    </message>
    <message>
        <source>It is still being recorded, or its program died.</source>
        <translation>Ještě se zaznamenává, nebo jeho program skončil předčasně.</translation>
    </message>
    <message>
        <source>Its journal is missing or damaged: the end is not in the file.</source>
        <translation>Jeho žurnál chybí nebo je poškozený: konec v souboru není.</translation>
    </message>
    <message>
        <source>notes: %1</source>
        <translation>poznámky: %1</translation>
    </message>
    <message>
        <source>Ground of the last estimate</source>
        <translation>Terén posledního odhadu</translation>
    </message>
    <message>
        <source>No estimate</source>
        <translation>Žádný odhad</translation>
    </message>
    <message>
        <source>The chosen recording</source>
        <translation>Vybraný záznam</translation>
    </message>
</context>
<context>
    <name>terratact::SessionEventLogger</name>
    <message>
        <source>P(step &gt; %1 m) = %2 % ± %3</source>
        <translation>P(schod &gt; %1 m) = %2 % ± %3</translation>
    </message>
    <message>
        <source>P(step &gt; %1 m to %2 m) = %3 % ± %4</source>
        <translation>P(schod &gt; %1 m do %2 m) = %3 % ± %4</translation>
    </message>
    <message>
        <source>not felt: %1</source>
        <translation>neohmatáno: %1</translation>
    </message>
    <message>
        <source>either side: %1</source>
        <translation>kterákoli strana: %1</translation>
    </message>
    <message>
        <source>left: %1</source>
        <translation>vlevo: %1</translation>
    </message>
    <message>
        <source>right: %1</source>
        <translation>vpravo: %1</translation>
    </message>
    <message>
        <source>probe proposed %1: %2 m, %3 … %4 m, sd %5 m</source>
        <translation>návrh sondy %1: %2 m, %3 … %4 m, směr. odch. %5 m</translation>
    </message>
    <message>
        <source>exploration: %1</source>
        <translation>průzkum: %1</translation>
    </message>
    <message>
        <source>no estimate</source>
        <translation>žádný odhad</translation>
    </message>
    <message>
        <source>probing %1</source>
        <translation>sonduje %1</translation>
    </message>
    <message>
        <source>P(step &gt; %1 m up to each horizon) = %2 % ± %3</source>
        <translation>P(schod &gt; %1 m až k horizontu každé strany) = %2 % ± %3</translation>
    </message>
    <message>
        <source>bounded: %1</source>
        <translation>omezeno: %1</translation>
    </message>
</context>
<context>
    <name>terratact::SessionList</name>
    <message>
        <source>%1 not read</source>
        <translation>nečteno %1</translation>
    </message>
    <message>
        <source>● being recorded</source>
        <translation>● zaznamenává se</translation>
    </message>
    <message>
        <source>✕ cannot be read</source>
        <translation>✕ nelze číst</translation>
    </message>
    <message>
        <source>○ not closed</source>
        <translation>○ neuzavřený</translation>
    </message>
    <message>
        <source>✕ torn</source>
        <translation>✕ utržený</translation>
    </message>
    <message>
        <source>✕ damaged</source>
        <translation>✕ poškozený</translation>
    </message>
    <message>
        <source>✓ sealed</source>
        <translation>✓ uzavřený</translation>
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
        <translation>terén</translation>
    </message>
    <message>
        <source>begins</source>
        <translation>začátek</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>robot</translation>
    </message>
    <message>
        <source>lasts</source>
        <translation>délka</translation>
    </message>
    <message>
        <source>verdicts</source>
        <translation>verdikty</translation>
    </message>
    <message>
        <source>probes</source>
        <translation>sondy</translation>
    </message>
    <message>
        <source>alarms</source>
        <translation>alarmy</translation>
    </message>
    <message>
        <source>size</source>
        <translation>velikost</translation>
    </message>
    <message>
        <source>state</source>
        <translation>stav</translation>
    </message>
    <message>
        <source>notes</source>
        <translation>poznámky</translation>
    </message>
    <message>
        <source>picture of the last estimate</source>
        <translation>obrázek posledního odhadu</translation>
    </message>
    <message>
        <source>no estimate</source>
        <translation>žádný odhad</translation>
    </message>
    <message>
        <source>before %1</source>
        <translation>před %1</translation>
    </message>
</context>
<context>
    <name>terratact::SessionListView</name>
    <message>
        <source>Recordings</source>
        <translation>Záznamy jízd</translation>
    </message>
</context>
<context>
    <name>terratact::SessionTimeline</name>
    <message>
        <source>Timeline</source>
        <translation>Časová osa</translation>
    </message>
    <message>
        <source>%1 – %2  %3</source>
        <translation>%1 – %2  %3</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
</context>
<context>
    <name>terratact::SettingsFilesWindow</name>
    <message>
        <source>Profiles, export and import of settings</source>
        <translation>Profily, export a import nastavení</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Výsledek</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profily</translation>
    </message>
    <message>
        <source>Switch to it …</source>
        <translation>Přepnout na něj …</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>Smazat jej</translation>
    </message>
    <message>
        <source>Name of a profile</source>
        <translation>Jméno profilu</translation>
    </message>
    <message>
        <source>name, for example: robot A/night</source>
        <translation>jméno, například: robot A/noc</translation>
    </message>
    <message>
        <source>The present settings are saved under this name</source>
        <translation>Pod tímto jménem se uloží nynější nastavení</translation>
    </message>
    <message>
        <source>Save the present settings</source>
        <translation>Uložit nynější nastavení</translation>
    </message>
    <message>
        <source>Replace the profile</source>
        <translation>Nahradit profil</translation>
    </message>
    <message>
        <source>Press again to replace it</source>
        <translation>Stiskněte znovu: nahradí se</translation>
    </message>
    <message>
        <source>Press again to delete it</source>
        <translation>Stiskněte znovu: smaže se</translation>
    </message>
    <message>
        <source>Export to a file …</source>
        <translation>Exportovat do souboru …</translation>
    </message>
    <message>
        <source>Writes all settings but the files of this computer; in SI units</source>
        <translation>Zapíše všechna nastavení kromě souborů tohoto počítače; v jednotkách SI</translation>
    </message>
    <message>
        <source>Import a file …</source>
        <translation>Importovat soubor …</translation>
    </message>
    <message>
        <source>Shows what the file would change before it is applied</source>
        <translation>Nejdřív ukáže, co by soubor změnil</translation>
    </message>
    <message>
        <source>Settings (*.settings)</source>
        <translation>Nastavení (*.settings)</translation>
    </message>
    <message>
        <source>Export settings</source>
        <translation>Export nastavení</translation>
    </message>
    <message>
        <source>Import settings</source>
        <translation>Import nastavení</translation>
    </message>
    <message>
        <source>What will change</source>
        <translation>Co se změní</translation>
    </message>
    <message>
        <source>Safety-relevant changes</source>
        <translation>Změny důležité pro bezpečnost</translation>
    </message>
    <message>
        <source>Setting</source>
        <translation>Nastavení</translation>
    </message>
    <message>
        <source>now</source>
        <translation>nyní</translation>
    </message>
    <message>
        <source>then</source>
        <translation>pak</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Použít</translation>
    </message>
    <message>
        <source>Leave all as it is</source>
        <translation>Nechat vše, jak je</translation>
    </message>
    <message>
        <source>Nothing was changed</source>
        <translation>Nic se nezměnilo</translation>
    </message>
    <message>
        <source>There is no place for profiles: settings are not saved</source>
        <translation>Pro profily není místo: nastavení se neukládá</translation>
    </message>
    <message>
        <source>Choose a profile first</source>
        <translation>Nejdřív zvolte profil</translation>
    </message>
    <message>
        <source>Shows what it would change first</source>
        <translation>Nejdřív ukáže, co by změnil</translation>
    </message>
    <message>
        <source>Asks for a second press</source>
        <translation>Žádá druhé stisknutí</translation>
    </message>
    <message>
        <source>Saves all settings as a new profile</source>
        <translation>Uloží všechna nastavení jako nový profil</translation>
    </message>
    <message>
        <source>A profile of this name exists; asks for a second press</source>
        <translation>Profil tohoto jména existuje; žádá druhé stisknutí</translation>
    </message>
    <message>
        <source>Applies the changes listed here</source>
        <translation>Použije změny uvedené zde</translation>
    </message>
    <message>
        <source>Saved as profile “%1”</source>
        <translation>Uloženo jako profil „%1“</translation>
    </message>
    <message>
        <source>Deleted: profile “%1”</source>
        <translation>Smazáno: profil „%1“</translation>
    </message>
    <message>
        <source>The profile “%1” could not be deleted</source>
        <translation>Profil „%1“ se nepodařilo smazat</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Zapsáno: %1</translation>
    </message>
    <message>
        <source>“%1” changes nothing: these settings are active</source>
        <translation>„%1“ nic nemění: tato nastavení už platí</translation>
    </message>
    <message>
        <source>safety: %1</source>
        <translation>bezpečnost: %1</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>“%1” changes:</source>
        <translation>„%1“ změní:</translation>
    </message>
    <message>
        <source>Safety-relevant: %1</source>
        <translation>Důležité pro bezpečnost: %1</translation>
    </message>
    <message>
        <source>Apply, safety-relevant changes too</source>
        <translation>Použít, i změny důležité pro bezpečnost</translation>
    </message>
    <message>
        <source>Not applied: %1</source>
        <translation>Nepoužito: %1</translation>
    </message>
    <message>
        <source>In force: “%1”</source>
        <translation>Platí: „%1“</translation>
    </message>
    <message>
        <source>settings of “%1” came into force</source>
        <translation>nastavení „%1“ začalo platit</translation>
    </message>
</context>
<context>
    <name>terratact::SettingsPage</name>
    <message>
        <source>Estimate</source>
        <translation>Odhad</translation>
    </message>
    <message>
        <source>Look and sound</source>
        <translation>Vzhled a zvuk</translation>
    </message>
    <message>
        <source>Restore all defaults</source>
        <translation>Vše na výchozí</translation>
    </message>
    <message>
        <source>Resets this page, the model and the robot to their defaults</source>
        <translation>Vše na této stránce i dodaný model a robot</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metoda</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Kvalita</translation>
    </message>
    <message>
        <source>An obstacle is a step above</source>
        <translation>Překážka je schod nad</translation>
    </message>
    <message>
        <source>Step height that the verdict asks about (PgUp, PgDown)</source>
        <translation>Výška schodu v otázce verdiktu (PgUp, PgDown)</translation>
    </message>
    <message>
        <source>An element counts as contact above</source>
        <translation>Kontakt je prvek nad</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Weaker forces count as noise</source>
        <translation>Slabší síly jsou šum</translation>
    </message>
    <message>
        <source>The arm is offered above a sd of</source>
        <translation>Rameno se nabízí od sd</translation>
    </message>
    <message>
        <source>A bin less certain than this asks for a probe</source>
        <translation>Méně jistý bod žádá sondu</translation>
    </message>
    <message>
        <source>The verdict is withheld above a roll of</source>
        <translation>Verdikt se zadrží od náklonu</translation>
    </message>
    <message>
        <source>Then left and right ground differ</source>
        <translation>Pak se terén vlevo a vpravo liší</translation>
    </message>
    <message>
        <source>… or left and right flippers differ by</source>
        <translation>… nebo od rozdílu flipperů</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Barvy</translation>
    </message>
    <message>
        <source>day</source>
        <translation>den</translation>
    </message>
    <message>
        <source>night, red</source>
        <translation>noc, červená</translation>
    </message>
    <message>
        <source>high contrast</source>
        <translation>vysoký kontrast</translation>
    </message>
    <message>
        <source>Night, red: keeps the eyes adapted to the dark</source>
        <translation>Noc, červená: oči zůstanou přivyklé tmě</translation>
    </message>
    <message>
        <source>Size of text</source>
        <translation>Velikost písma</translation>
    </message>
    <message>
        <source>Ctrl + and Ctrl −</source>
        <translation>Ctrl + a Ctrl −</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Jazyk</translation>
    </message>
    <message>
        <source>the system&apos;s</source>
        <translation>podle systému</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Rozvržení</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Jízda</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonda</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Přehled</translation>
    </message>
    <message>
        <source>What the terrain page makes large</source>
        <translation>Co je na stránce Terén velké</translation>
    </message>
    <message>
        <source>Alarm sound</source>
        <translation>Zvuk alarmů</translation>
    </message>
    <message>
        <source>Model and robot</source>
        <translation>Model a robot</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Vybrat soubor …</translation>
    </message>
    <message>
        <source>Choose a file: %1</source>
        <translation>Vybrat soubor: %1</translation>
    </message>
    <message>
        <source>Shipped</source>
        <translation>Dodaný</translation>
    </message>
    <message>
        <source>Shipped: %1</source>
        <translation>Dodaný: %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Models (*.ttm)</source>
        <translation>Modely (*.ttm)</translation>
    </message>
    <message>
        <source>Robots (*.toml)</source>
        <translation>Roboti (*.toml)</translation>
    </message>
    <message>
        <source>Use this file from now on</source>
        <translation>Od teď používat tento soubor</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Nastavení</translation>
    </message>
    <message>
        <source>Off: alarms are only seen</source>
        <translation>Vypnuto: alarmy jsou jen vidět</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Záznam</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nikdy</translation>
    </message>
    <message>
        <source>Everything is recorded</source>
        <translation>Vše se zaznamenává</translation>
    </message>
    <message>
        <source>Frames, scenes, estimates, what was shown and decided, in one file per session</source>
        <translation>Rámce, scény, odhady, co bylo zobrazeno a rozhodnuto, v jednom souboru na relaci</translation>
    </message>
    <message>
        <source>Delete a session after</source>
        <translation>Smazat relaci po</translation>
    </message>
    <message>
        <source>days</source>
        <translation>dnech</translation>
    </message>
    <message>
        <source>Delete the oldest beyond</source>
        <translation>Nejstarší smazat nad</translation>
    </message>
    <message>
        <source>GB</source>
        <translation>GB</translation>
    </message>
    <message>
        <source>Restarts the console</source>
        <translation>Restartuje konzoli</translation>
    </message>
    <message>
        <source>An estimate may take at most</source>
        <translation>Odhad smí trvat nejvýše</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Sampling then ends with fewer draws, and the result says so</source>
        <translation>Pak vzorkování skončí s tím, co je hotovo, a výsledek to říká</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>bez omezení</translation>
    </message>
    <message>
        <source>Measured by terratact tradeoff: time, mean error, and in brackets the distance of the quantiles from a long run&apos;s</source>
        <translation>Jak je změřil terratact tradeoff: čas, průměrná chyba a v závorkách, jak daleko jsou kvantily od dlouhého běhu</translation>
    </message>
    <message>
        <source>Back to the shipped file</source>
        <translation>Zpět k tomu, co přišlo s programem</translation>
    </message>
    <message>
        <source>The shipped files are in use already</source>
        <translation>To, co přišlo s programem, se už používá</translation>
    </message>
    <message>
        <source>The arm is offered</source>
        <translation>Rameno se nabízí</translation>
    </message>
    <message>
        <source>where the terrain is uncertain</source>
        <translation>kde je terén nejistý</translation>
    </message>
    <message>
        <source>there, unless the verdict is decided</source>
        <translation>tam, pokud verdikt není rozhodnut</translation>
    </message>
    <message>
        <source>where it helps the verdict</source>
        <translation>kde pomůže verdiktu</translation>
    </message>
    <message>
        <source>Uncertain: by the variance, as in the paper. About the verdict: by the entropy of the step question, and only while it is open</source>
        <translation>Nejistý: podle rozptylu, jako v článku. Verdikt: podle entropie otázky na schod, jen dokud je otevřená</translation>
    </message>
    <message>
        <source>Applies ten seconds after the change. Never: nothing is deleted</source>
        <translation>Platí deset sekund po změně; nikdy: nic se nemaže</translation>
    </message>
    <message>
        <source>For all closed sessions together; applies ten seconds after the change</source>
        <translation>Pro všechny uzavřené relace dohromady; platí deset sekund po změně</translation>
    </message>
    <message>
        <source>Sessions beyond these limits may be deleted</source>
        <translation>Relace za těmito mezemi se smějí mazat</translation>
    </message>
    <message>
        <source>Until this is ticked, the console only lists what it would delete</source>
        <translation>Dokud není zaškrtnuto, konzole jen říká, co by smazala</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Drops and walls. At 5 % or more, CLEAR needs every bin felt up to the front flippers&apos; reach; lower rates accept ground that the flippers span</source>
        <translation>Propasti a stěny. Od 5 % potřebuje VOLNO ohmatané všechny body, kam přední flippery sahají; nižší hodnoty připouštějí terén, který flippery překlenují</translation>
    </message>
    <message>
        <source>Pitch or roll is steep from</source>
        <translation>Náklon je strmý od</translation>
    </message>
    <message>
        <source>Pitch or roll is dangerous from</source>
        <translation>Náklon je nebezpečný od</translation>
    </message>
    <message>
        <source>Press again to reset all settings</source>
        <translation>Stiskněte znovu: vše se vrátí</translation>
    </message>
    <message>
        <source>Contact tick volume</source>
        <translation>Hlasitost kontaktů</translation>
    </message>
    <message>
        <source>Ticks while a flipper touches the ground: higher towards the tip, faster with the force</source>
        <translation>Tikání, když se flipper dotýká terénu: vyšší směrem ke špičce, rychlejší s větší silou</translation>
    </message>
    <message>
        <source>off</source>
        <translation>vypnuto</translation>
    </message>
    <message>
        <source>Profiles, export and import …</source>
        <translation>Profily, export a import …</translation>
    </message>
    <message>
        <source>All settings as named profiles or as one file (Ctrl+,)</source>
        <translation>Všechna nastavení jako pojmenované profily nebo jako jeden soubor (Ctrl+,)</translation>
    </message>
    <message>
        <source>Connect to a bus, log or session …</source>
        <translation>Připojit sběrnici, záznam nebo relaci …</translation>
    </message>
    <message>
        <source>Connections, their faults and repairs (Ctrl+L)</source>
        <translation>Připojení, jejich chyby a opravy (Ctrl+L)</translation>
    </message>
    <message>
        <source>What the method uses</source>
        <translation>Co metoda užívá</translation>
    </message>
    <message>
        <source>Rate of hazards per %1 of ground that is not felt</source>
        <translation>Četnost nebezpečí na %1, které nic neohmatalo</translation>
    </message>
    <message>
        <source>Amber alarm; at the latest %1 before the robot tips over</source>
        <translation>Žlutý alarm; v každém případě %1 před převrácením</translation>
    </message>
    <message>
        <source>Red alarm with sound; at the latest %1 before the robot tips over</source>
        <translation>Červený alarm se zvukem; v každém případě %1 před převrácením</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Délky</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>metry</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>centimetry</translation>
    </message>
    <message>
        <source>Angles</source>
        <translation>Úhly</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>stupně</translation>
    </message>
    <message>
        <source>radians</source>
        <translation>radiány</translation>
    </message>
</context>
<context>
    <name>terratact::SharedStop</name>
    <message>
        <source>STOP has no effect in windows opened from here: %1</source>
        <translation>STOP v oknech otevřených odtud nic nezastaví: %1</translation>
    </message>
    <message>
        <source>STOP was pressed in a window that was opened from here</source>
        <translation>STOP byl stisknut v okně otevřeném odtud</translation>
    </message>
    <message>
        <source>STOP has no effect: %1</source>
        <translation>STOP nepůsobí: %1</translation>
    </message>
    <message>
        <source>STOP HAS NO EFFECT HERE: %1</source>
        <translation>STOP TU NEPŮSOBÍ: %1</translation>
    </message>
    <message>
        <source>no folder can be made for it in TMPDIR or /tmp</source>
        <translation>v TMPDIR ani /tmp pro to nelze vytvořit složku</translation>
    </message>
</context>
<context>
    <name>terratact::SignalList</name>
    <message>
        <source>part of a name</source>
        <translation>část názvu</translation>
    </message>
    <message>
        <source>Filter of the signals</source>
        <translation>Filtr signálů</translation>
    </message>
    <message>
        <source>Signals to plot</source>
        <translation>Signály pro grafy</translation>
    </message>
    <message>
        <source>Drag a signal onto a plot, or below the last one for a new plot</source>
        <translation>Přetáhněte signál na graf, nebo pod poslední pro nový graf</translation>
    </message>
</context>
<context>
    <name>terratact::SignalTable</name>
    <message>
        <source>Frame</source>
        <translation>Rámec</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Signál</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Hodnota</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Jednotka</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Frekvence</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Stáří</translation>
    </message>
    <message>
        <source>Min</source>
        <translation>Nejméně</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Nejvíce</translation>
    </message>
    <message>
        <source>Last 12 s</source>
        <translation>Za 12 s</translation>
    </message>
    <message>
        <source>history of %1</source>
        <translation>průběh: %1</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signály</translation>
    </message>
</context>
<context>
    <name>terratact::SignalsPage</name>
    <message>
        <source>error frame</source>
        <translation>chybový rámec</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>neznámo</translation>
    </message>
    <message>
        <source>load --- (bit rate not known): %1 to %2 kbit/s</source>
        <translation>zátěž --- (rychlost neznámá): %1 až %2 kbit/s</translation>
    </message>
    <message>
        <source>load %1 to %2 % of %3 kbit/s (without stuff bits, with the most possible)</source>
        <translation>zátěž %1 až %2 % z %3 kbit/s (bez vkládaných bitů, se všemi možnými)</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signály</translation>
    </message>
    <message>
        <source>State of the bus</source>
        <translation>Stav sběrnice</translation>
    </message>
    <message>
        <source>Reset min and max</source>
        <translation>Vynulovat minima a maxima</translation>
    </message>
    <message>
        <source>Newest frames</source>
        <translation>Poslední rámce</translation>
    </message>
    <message>
        <source>%1 · %2 frames/s · %3
Since the start: %4 frames, %5 dropped, %6 error frames, %7 with a wrong checksum, %8 out of sequence, %9 not in the DBC</source>
        <translation>%1 · %2 rámců/s · %3
Od spuštění: %4 rámců, %5 ztraceno, %6 chybových, %7 se špatným součtem, %8 mimo pořadí, %9 mimo DBC</translation>
    </message>
    <message>
        <source>This source is no CAN bus: it has no frames, and these are its values.</source>
        <translation>Tento zdroj není sběrnice CAN: nemá rámce, zde jsou jeho hodnoty.</translation>
    </message>
    <message>
        <source>load %1 to %2 % of nominal %3 kbit/s (without stuff bits, with the most possible)</source>
        <translation>zátěž %1 až %2 % z nominálních %3 kbit/s (bez vkládaných bitů, se všemi možnými)</translation>
    </message>
    <message>
        <source>%1, as %2 describes it; sent by %3
%4</source>
        <translation>%1 podle souboru %2; odesílá %3
%4</translation>
    </message>
    <message>
        <source>DBC files</source>
        <translation>Soubory DBC</translation>
    </message>
    <message>
        <source>Faults of the DBC files</source>
        <translation>Co není v pořádku se soubory DBC</translation>
    </message>
    <message>
        <source>Add DBC file …</source>
        <translation>Přidat soubor DBC …</translation>
    </message>
    <message>
        <source>Adds a DBC file that describes frames of other devices</source>
        <translation>Přidá soubor DBC, který popisuje rámce jiných zařízení</translation>
    </message>
    <message>
        <source>Remove DBC file</source>
        <translation>Odebrat soubor DBC</translation>
    </message>
    <message>
        <source>Its frames are shown byte by byte again</source>
        <translation>Jeho rámce se zase zobrazí bajt po bajtu</translation>
    </message>
    <message>
        <source>Counts restart with the next frames</source>
        <translation>Začnou znovu od příštích rámců</translation>
    </message>
    <message>
        <source>%1 (frames: %2)</source>
        <translation>%1 (rámců: %2)</translation>
    </message>
    <message>
        <source>%1 (not used)</source>
        <translation>%1 (nepoužit)</translation>
    </message>
    <message>
        <source>DBC files: %1</source>
        <translation>Soubory DBC: %1</translation>
    </message>
    <message>
        <source>… and %1 more, all listed in this tooltip</source>
        <translation>… a dalších %1; všechny jsou zde v nápovědě</translation>
    </message>
    <message>
        <source>Add DBC file</source>
        <translation>Přidat soubor DBC</translation>
    </message>
    <message>
        <source>DBC files (*.dbc *.DBC);;All files (*)</source>
        <translation>Soubory DBC (*.dbc *.DBC);;Všechny soubory (*)</translation>
    </message>
</context>
<context>
    <name>terratact::SnapshotNote</name>
    <message>
        <source>Note on the snapshot</source>
        <translation>Poznámka ke snímku</translation>
    </message>
    <message>
        <source>note; empty: none</source>
        <translation>poznámka; prázdná: žádná</translation>
    </message>
    <message>
        <source>Save the note</source>
        <translation>Uložit poznámku</translation>
    </message>
    <message>
        <source>No note</source>
        <translation>Bez poznámky</translation>
    </message>
</context>
<context>
    <name>terratact::SnapshotWriter</name>
    <message>
        <source>%1: the picture cannot be coded; take the snapshot again</source>
        <translation>%1: obrázek nelze zakódovat; pořiďte snímek znovu</translation>
    </message>
</context>
<context>
    <name>terratact::StatusHeader</name>
    <message>
        <source>Status</source>
        <translation>Stav</translation>
    </message>
    <message>
        <source>Where the data come from</source>
        <translation>Odkud jsou data</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Spojení</translation>
    </message>
    <message>
        <source>Activity of the robot</source>
        <translation>Co robot dělá</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Quality of the estimate</source>
        <translation>Kvalita odhadu</translation>
    </message>
    <message>
        <source>Accuracy of an estimate against its computing time</source>
        <translation>Kolik času smí odhad stát za svou přesnost</translation>
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
        <translation>STOP DRŽÍ (F12)</translation>
    </message>
    <message>
        <source>Active alarms, and past alarms not yet acknowledged (F4)</source>
        <translation>Trvající alarmy a minulé nepotvrzené (F4)</translation>
    </message>
    <message>
        <source>no alarms</source>
        <translation>bez alarmů</translation>
    </message>
    <message>
        <source>alarms: %1</source>
        <translation>alarmy: %1</translation>
    </message>
    <message>
        <source>%1, %2 not acknowledged</source>
        <translation>%1, nepotvrzeno %2</translation>
    </message>
    <message>
        <source>Checks overridden</source>
        <translation>Přebité kontroly</translation>
    </message>
    <message>
        <source>! CHECK OVERRIDDEN</source>
        <translation>! KONTROLA PŘEBITA</translation>
    </message>
    <message>
        <source>link %1 Hz · ≤ %2</source>
        <translation>spoj %1 Hz · ≤ %2</translation>
    </message>
    <message>
        <source>STOP SENT …</source>
        <translation>STOP ODESLÁN …</translation>
    </message>
    <message>
        <source>STOP NOT SENT</source>
        <translation>STOP NEODESLÁN</translation>
    </message>
    <message>
        <source>STOP: no commands</source>
        <translation>STOP: bez povelů</translation>
    </message>
    <message>
        <source>STOP was sent but not confirmed by the robot; it is sent again</source>
        <translation>STOP byl odeslán, robot ho nepotvrdil; posílá se znovu</translation>
    </message>
    <message>
        <source>STOP was not sent: %1</source>
        <translation>STOP nebyl odeslán: %1</translation>
    </message>
    <message>
        <source>The robot reports stopped; another press sends STOP again</source>
        <translation>Robot hlásí, že je zastaven; další stisk znovu pošle STOP</translation>
    </message>
    <message>
        <source>STOP has no effect here: %1</source>
        <translation>STOP tu nepůsobí: %1</translation>
    </message>
    <message>
        <source>Bus: %1</source>
        <translation>Sběrnice: %1</translation>
    </message>
    <message>
        <source>Details: F5</source>
        <translation>Vše: F5</translation>
    </message>
    <message>
        <source>Halts the robot of the console that opened this window</source>
        <translation>Zastaví robota konzole, která otevřela toto okno</translation>
    </message>
    <message>
        <source>Halts the robot at once and latches; F12 and Pause do the same everywhere</source>
        <translation>Robota hned zastaví a drží; F12 a Pause dělají totéž všude</translation>
    </message>
</context>
<context>
    <name>terratact::StripExport</name>
    <message>
        <source>no strip to export: nothing was estimated yet, or the robot reports no odometry</source>
        <translation>není co exportovat: zatím nic nebylo odhadnuto, nebo robot nehlásí odometrii</translation>
    </message>
    <message>
        <source>Export the strip of felt ground</source>
        <translation>Exportovat pás ohmataného terénu</translation>
    </message>
    <message>
        <source>Pictures (*.svg *.png *.pdf *.html)</source>
        <translation>Obrázky (*.svg *.png *.pdf *.html)</translation>
    </message>
    <message>
        <source>Profile (*.csv)</source>
        <translation>Profil (*.csv)</translation>
    </message>
    <message>
        <source>Point cloud (*.ply)</source>
        <translation>Mračno bodů (*.ply)</translation>
    </message>
    <message>
        <source>a strip is still being written: try again</source>
        <translation>pás se ještě zapisuje: zkuste to znovu</translation>
    </message>
    <message>
        <source>%1 exists and was not replaced; choose another name</source>
        <translation>%1 existuje a nebyl nahrazen; zvolte jiné jméno</translation>
    </message>
    <message>
        <source>strip of felt ground written: %1</source>
        <translation>pás ohmataného terénu zapsán: %1</translation>
    </message>
</context>
<context>
    <name>terratact::TerrainPage</name>
    <message>
        <source>Following: the arm is probing.</source>
        <translation>Sledování: rameno sonduje.</translation>
    </message>
    <message>
        <source>The arm has measured; its height is part of the estimate.</source>
        <translation>Rameno změřilo; jeho výška je součástí odhadu.</translation>
    </message>
    <message>
        <source>Following: probes are approved on the commanding console.</source>
        <translation>Sledování: sondy schvaluje ten, kdo robota řídí.</translation>
    </message>
    <message>
        <source>The proposal was not answered in time and counts as refused.</source>
        <translation>Návrh zůstal bez odpovědi, což znamená ne.</translation>
    </message>
    <message>
        <source>No probe is proposed. After an exploration the arm is offered where the terrain stays uncertain.</source>
        <translation>Sonda se nenavrhuje. Po průzkumu se rameno nabídne tam, kde terén zůstal nejistý.</translation>
    </message>
    <message>
        <source>Last minutes</source>
        <translation>Poslední minuty</translation>
    </message>
    <message>
        <source>Terrain</source>
        <translation>Terén</translation>
    </message>
    <message>
        <source>view</source>
        <translation>pohled</translation>
    </message>
    <message>
        <source>Optional marks: draws, a second method</source>
        <translation>Co ještě kreslit: vzorky, druhou metodu</translation>
    </message>
    <message>
        <source>View of the terrain</source>
        <translation>Zobrazení terénu</translation>
    </message>
    <message>
        <source>Front forces</source>
        <translation>Síly vpředu</translation>
    </message>
    <message>
        <source>N / V</source>
        <translation>N / V</translation>
    </message>
    <message>
        <source>Raw voltages of the force elements</source>
        <translation>Surová napětí silových prvků</translation>
    </message>
    <message>
        <source>Raw voltages instead of calibrated forces</source>
        <translation>Surová napětí místo kalibrovaných sil</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Robot</translation>
    </message>
    <message>
        <source>Age of the telemetry</source>
        <translation>Stáří telemetrie</translation>
    </message>
    <message>
        <source>- - %1 N</source>
        <translation>- - %1 N</translation>
    </message>
    <message>
        <source>raw voltages</source>
        <translation>surová napětí</translation>
    </message>
    <message>
        <source>- - threshold %1 N</source>
        <translation>- - práh %1 N</translation>
    </message>
    <message>
        <source>the log has ended</source>
        <translation>záznam skončil</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>stáří %1</translation>
    </message>
    <message>
        <source>The flippers still move: no ground ahead is felt yet</source>
        <translation>Flippery se ještě hýbou: vpředu zatím nic nahmatáno</translation>
    </message>
    <message>
        <source>LIVE preview</source>
        <translation>ŽIVÝ náhled</translation>
    </message>
    <message>
        <source>The flippers still move</source>
        <translation>Flippery se ještě hýbou</translation>
    </message>
    <message>
        <source>%1 s old</source>
        <translation>stáří %1 s</translation>
    </message>
    <message>
        <source>&lt; %1 s old</source>
        <translation>stáří &lt; %1 s</translation>
    </message>
    <message>
        <source>Preview while the flippers go down: the estimate is being computed</source>
        <translation>Náhled z cesty dolů: odhad se počítá</translation>
    </message>
    <message>
        <source>preview</source>
        <translation>náhled</translation>
    </message>
    <message>
        <source>The estimate is being computed</source>
        <translation>Odhad se počítá</translation>
    </message>
    <message>
        <source>the forces are %1 old</source>
        <translation>síly jsou staré %1</translation>
    </message>
    <message>
        <source>The verdict is withheld: do not rely on a probe&apos;s gain.</source>
        <translation>Verdikt je zadržen: na přínos sondy nespoléhejte.</translation>
    </message>
    <message>
        <source>Forces on the rear flippers</source>
        <translation>Síly na zadních flipperech</translation>
    </message>
    <message>
        <source>rear</source>
        <translation>vzadu</translation>
    </message>
    <message>
        <source>Forces on the rear flippers instead of the front ones</source>
        <translation>Síly na zadních flipperech místo předních</translation>
    </message>
    <message>
        <source>Rear forces</source>
        <translation>Síly vzadu</translation>
    </message>
    <message>
        <source>probe %1: its height, ± %2 instead of ± %3</source>
        <translation>sonda %1: její výška, ± %2 místo ± %3</translation>
    </message>
    <message>
        <source>probe %1: %2 → %3 bit</source>
        <translation>sonda %1: %2 → %3 bit</translation>
    </message>
    <message>
        <source>probe %1: no gain</source>
        <translation>sonda %1: bez zisku</translation>
    </message>
    <message>
        <source>an estimate of the past</source>
        <translation>minulý odhad</translation>
    </message>
    <message>
        <source>No probe is proposed; what one would tell:</source>
        <translation>Rameno se nenabízí; co by zjistilo:</translation>
    </message>
    <message>
        <source>%1; what one would tell:</source>
        <translation>%1; co by zjistilo:</translation>
    </message>
</context>
<context>
    <name>terratact::TerrainProfileView</name>
    <message>
        <source>prior only</source>
        <translation>jen apriori</translation>
    </message>
    <message>
        <source>Terrain profile</source>
        <translation>Profil terénu</translation>
    </message>
    <message>
        <source>ceiling</source>
        <translation>strop</translation>
    </message>
    <message>
        <source>No estimate yet</source>
        <translation>Zatím bez odhadu</translation>
    </message>
    <message>
        <source>forward from the IMU [%1]</source>
        <translation>vpřed od IMU [%1]</translation>
    </message>
    <message>
        <source>height [%1]</source>
        <translation>výška [%1]</translation>
    </message>
    <message>
        <source>IMU</source>
        <translation>IMU</translation>
    </message>
    <message>
        <source>bin %1: %2, 80 % in %3 … %4, %5</source>
        <translation>bod %1: %2, 80 % v %3 … %4, %5</translation>
    </message>
    <message>
        <source>draws</source>
        <translation>vzorky</translation>
    </message>
    <message>
        <source>either … or</source>
        <translation>buď … nebo</translation>
    </message>
    <message>
        <source>80 % band</source>
        <translation>pásmo 80 %</translation>
    </message>
    <message>
        <source>truth</source>
        <translation>skutečnost</translation>
    </message>
    <message>
        <source>bin %1</source>
        <translation>bod %1</translation>
    </message>
    <message>
        <source>height %1 ± %2</source>
        <translation>výška %1 ± %2</translation>
    </message>
    <message>
        <source>80 % in %1 … %2</source>
        <translation>80 % v %1 … %2</translation>
    </message>
    <message>
        <source>ceiling %1</source>
        <translation>strop %1</translation>
    </message>
    <message>
        <source>no part of the robot above it</source>
        <translation>nad ním nic z robota</translation>
    </message>
    <message>
        <source>either %1 (%2 %)</source>
        <translation>buď %1 (%2 %)</translation>
    </message>
    <message>
        <source>or %1 (%2 %)</source>
        <translation>nebo %1 (%2 %)</translation>
    </message>
    <message>
        <source>as of %1 ago</source>
        <translation>stav před %1</translation>
    </message>
    <message>
        <source>not live: no telemetry from the robot</source>
        <translation>neaktuální: žádná telemetrie z robota</translation>
    </message>
    <message>
        <source>arm tip: probe?</source>
        <translation>hrot ramene: sonda?</translation>
    </message>
    <message>
        <source>arm tip: probing</source>
        <translation>hrot ramene: sonduje</translation>
    </message>
    <message>
        <source>arm tip</source>
        <translation>hrot ramene</translation>
    </message>
    <message>
        <source>forward, height [%1]</source>
        <translation>vpřed, výška [%1]</translation>
    </message>
    <message>
        <source>from: %1 (%2)</source>
        <translation>z: %1 (%2)</translation>
    </message>
    <message>
        <source>felt to %1</source>
        <translation>ohmatáno do %1</translation>
    </message>
    <message>
        <source>touch: %1</source>
        <translation>dotyk: %1</translation>
    </message>
    <message>
        <source>bin %1: %2</source>
        <translation>bod %1: %2</translation>
    </message>
    <message>
        <source>%1: height %2 ± %3</source>
        <translation>%1: výška %2 ± %3</translation>
    </message>
    <message>
        <source>remembered</source>
        <translation>zapamatováno</translation>
    </message>
    <message>
        <source>remembered ± %1</source>
        <translation>zapamatováno ± %1</translation>
    </message>
    <message>
        <source>remembered ground · %1 driven since · heights ± %2</source>
        <translation>zapamatovaný terén · od té doby ujeto %1 · výšky ± %2</translation>
    </message>
    <message>
        <source>free point</source>
        <translation>volný bod</translation>
    </message>
    <message>
        <source>%1 times closer (0: all)</source>
        <translation>%1× blíž (0: vše)</translation>
    </message>
    <message>
        <source>measuring: drag, or ← → (Enter: begin here)</source>
        <translation>měření: táhnout nebo ← → (Enter: začít zde)</translation>
    </message>
    <message>
        <source>earlier: %1</source>
        <translation>dříve: %1</translation>
    </message>
    <message>
        <source>earlier sections of ground behind it: %1</source>
        <translation>dřívější úseky terénu za ním: %1</translation>
    </message>
</context>
<context>
    <name>terratact::TextSheet</name>
    <message>
        <source>Copy as text</source>
        <translation>Kopírovat jako text</translation>
    </message>
    <message>
        <source>Copies everything, for a report</source>
        <translation>Vše, do hlášení</translation>
    </message>
    <message>
        <source>Close (Esc)</source>
        <translation>Zavřít (Esc)</translation>
    </message>
</context>
<context>
    <name>terratact::TimePlot</name>
    <message>
        <source>Plot of %1</source>
        <translation>Graf: %1</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nic</translation>
    </message>
</context>
<context>
    <name>terratact::TimePlots</name>
    <message>
        <source>No plot yet: drag a signal here, or choose one and press New plot</source>
        <translation>Zatím žádný graf: přetáhněte sem signál, nebo ho vyberte a stiskněte Nový graf</translation>
    </message>
</context>
<context>
    <name>terratact::Touch</name>
    <message>
        <source>felt</source>
        <translation>ohmatáno</translation>
    </message>
    <message>
        <source>felt in part</source>
        <translation>ohmatáno zčásti</translation>
    </message>
    <message>
        <source>not felt</source>
        <translation>neohmatáno</translation>
    </message>
    <message>
        <source>not recorded</source>
        <translation>nezaznamenáno</translation>
    </message>
    <message>
        <source>bounded</source>
        <translation>omezeno</translation>
    </message>
    <message>
        <source>remembered</source>
        <translation>zapamatováno</translation>
    </message>
</context>
<context>
    <name>terratact::TrainingPage</name>
    <message>
        <source>waiting</source>
        <translation>čeká</translation>
    </message>
    <message>
        <source>running</source>
        <translation>běží</translation>
    </message>
    <message>
        <source>too few</source>
        <translation>málo</translation>
    </message>
    <message>
        <source>done</source>
        <translation>hotovo</translation>
    </message>
    <message>
        <source>scenes as CSV, with heights</source>
        <translation>scény CSV s výškami</translation>
    </message>
    <message>
        <source>Choose …</source>
        <translation>Vybrat …</translation>
    </message>
    <message>
        <source>1  Train a new model</source>
        <translation>1  Natrénovat nový model</translation>
    </message>
    <message>
        <source>robot: the one in use</source>
        <translation>robot: používaný</translation>
    </message>
    <message>
        <source>Train on</source>
        <translation>Učit z</translation>
    </message>
    <message>
        <source>Choose the training scenes</source>
        <translation>Vybrat scény k učení</translation>
    </message>
    <message>
        <source>Name of the new model</source>
        <translation>Název nového modelu</translation>
    </message>
    <message>
        <source>Letters, digits, - _ and .; the file is %1/NAME.ttm</source>
        <translation>Písmena, číslice, - _ a .; soubor je %1/NAME.ttm</translation>
    </message>
    <message>
        <source>Seed of the search</source>
        <translation>Semínko hledání</translation>
    </message>
    <message>
        <source>Same scenes and seed: the same model</source>
        <translation>Stejné scény a semínko: stejný model</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Trains the model in the background</source>
        <translation>Trénovat model; vše ostatní běží dál</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Zrušit</translation>
    </message>
    <message>
        <source>Cancels the training or comparison; no file is written</source>
        <translation>Ukončí, co běží; nic se nezapíše</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Název</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semínko</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Průběh</translation>
    </message>
    <message>
        <source>State of the training</source>
        <translation>Stav tréninku</translation>
    </message>
    <message>
        <source>bin</source>
        <translation>bod</translation>
    </message>
    <message>
        <source>with
forces</source>
        <translation>se
silami</translation>
    </message>
    <message>
        <source>without
forces</source>
        <translation>bez
sil</translation>
    </message>
    <message>
        <source>surface
below robot</source>
        <translation>povrch
pod tělem</translation>
    </message>
    <message>
        <source>surface
ahead</source>
        <translation>povrch
vpředu</translation>
    </message>
    <message>
        <source>clearance
below robot</source>
        <translation>světlost
pod tělem</translation>
    </message>
    <message>
        <source>clearance
ahead</source>
        <translation>světlost
vpředu</translation>
    </message>
    <message>
        <source>Training, bin by bin</source>
        <translation>Trénink po bodech</translation>
    </message>
    <message>
        <source>Centre of the bin</source>
        <translation>Střed bodu</translation>
    </message>
    <message>
        <source>Gaussian process given pose, currents and forces, and its log likelihood</source>
        <translation>Gaussovský proces z polohy, proudů a sil, a jeho log-věrohodnost</translation>
    </message>
    <message>
        <source>Gaussian process given the pose alone, and its log likelihood</source>
        <translation>Gaussovský proces jen z polohy, a jeho log-věrohodnost</translation>
    </message>
    <message>
        <source>Surface where the robot is above the bin</source>
        <translation>Povrch, kde je robot nad bodem</translation>
    </message>
    <message>
        <source>Surface elsewhere</source>
        <translation>Povrch jinde</translation>
    </message>
    <message>
        <source>Clearance given the other bins, where the robot is above the bin; log likelihood</source>
        <translation>Světlost podle ostatních bodů, kde je robot nad bodem; log-věrohodnost</translation>
    </message>
    <message>
        <source>The same elsewhere</source>
        <translation>Totéž jinde</translation>
    </message>
    <message>
        <source>2  Compare it with the model in use, then adopt it</source>
        <translation>2  Porovnat s používaným, pak převzít</translation>
    </message>
    <message>
        <source>Models</source>
        <translation>Modely</translation>
    </message>
    <message>
        <source>Test on</source>
        <translation>Zkusit na</translation>
    </message>
    <message>
        <source>Choose the test scenes</source>
        <translation>Vybrat scény ke zkoušce</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Porovnat</translation>
    </message>
    <message>
        <source>Estimate the test scenes with both models</source>
        <translation>Odhadnout zkušební scény oběma modely</translation>
    </message>
    <message>
        <source>error</source>
        <translation>chyba</translation>
    </message>
    <message>
        <source>old</source>
        <translation>starý</translation>
    </message>
    <message>
        <source>new</source>
        <translation>nový</translation>
    </message>
    <message>
        <source>new − old</source>
        <translation>rozdíl</translation>
    </message>
    <message>
        <source>Old and new model</source>
        <translation>Starý a nový model</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Výsledek</translation>
    </message>
    <message>
        <source>What to keep in mind</source>
        <translation>Na co pamatovat</translation>
    </message>
    <message>
        <source>Why not</source>
        <translation>Proč ne</translation>
    </message>
    <message>
        <source>Use the new model from now on</source>
        <translation>Od teď používat nový model</translation>
    </message>
    <message>
        <source>Discard (hold)</source>
        <translation>Zahodit (držet)</translation>
    </message>
    <message>
        <source>Discard the new model</source>
        <translation>Zahodit nový model</translation>
    </message>
    <message>
        <source>Delete the new model&apos;s file</source>
        <translation>Smazat soubor nového modelu</translation>
    </message>
    <message>
        <source>Trained on %1 scenes: %2</source>
        <translation>Natrénováno, scén %1: %2</translation>
    </message>
    <message>
        <source>%1. No file was written: correct this and start again.</source>
        <translation>%1. Nic se nezapsalo: napravte to a spusťte znovu.</translation>
    </message>
    <message>
        <source>%1. Choose another file, or discard the new model.</source>
        <translation>%1. Vyberte jiný soubor, nebo nový model zahoďte.</translation>
    </message>
    <message>
        <source>Cancelled: nothing was written</source>
        <translation>Zrušeno: nic se nezapsalo</translation>
    </message>
    <message>
        <source>Comparison cancelled</source>
        <translation>Porovnání zrušeno</translation>
    </message>
    <message>
        <source>Scenes (*.csv);;All files (*)</source>
        <translation>Scény (*.csv);;Všechny soubory (*)</translation>
    </message>
    <message>
        <source>Choose a file of scenes for training.</source>
        <translation>Vyberte soubor scén k učení.</translation>
    </message>
    <message>
        <source>Give the new model a name.</source>
        <translation>Pojmenujte nový model.</translation>
    </message>
    <message>
        <source>%1 exists already: choose another name.</source>
        <translation>%1 už existuje: zvolte jiný název.</translation>
    </message>
    <message>
        <source>Loading the new model …</source>
        <translation>Načítá se nový model …</translation>
    </message>
    <message>
        <source>Train a model first.</source>
        <translation>Nejdřív natrénujte model.</translation>
    </message>
    <message>
        <source>Compare the new model before it is adopted.</source>
        <translation>Nový model před převzetím porovnejte.</translation>
    </message>
    <message>
        <source>An exploration is running: the model stays until it has ended (Esc ends it).</source>
        <translation>Běží průzkum: model zůstane, dokud neskončí (ukončí ho Esc).</translation>
    </message>
    <message>
        <source>Training on %1; driving is not affected</source>
        <translation>Trénuje se na %1; robot zatím pracuje dál</translation>
    </message>
    <message>
        <source>%1 is in use now</source>
        <translation>%1 se teď používá</translation>
    </message>
    <message>
        <source>Not adopted, the model in use stays: %1</source>
        <translation>Nepřevzato, zůstává dosavadní model: %1</translation>
    </message>
    <message>
        <source>%1 could not be deleted: delete it by hand</source>
        <translation>%1 nelze smazat: smažte ručně</translation>
    </message>
    <message>
        <source>%1 discarded</source>
        <translation>%1 zahozen</translation>
    </message>
    <message>
        <source>in use: %1; no new model yet</source>
        <translation>používá se: %1; nový model zatím není</translation>
    </message>
    <message>
        <source>in use: %1; new: %2</source>
        <translation>používá se: %1; nový: %2</translation>
    </message>
    <message>
        <source>comparing: %1 %</source>
        <translation>porovnává: %1 %</translation>
    </message>
    <message>
        <source>training: %1 %</source>
        <translation>trénuje: %1 %</translation>
    </message>
    <message>
        <source>, about %1 left</source>
        <translation>, zbývá asi %1</translation>
    </message>
    <message>
        <source>, time left not known yet</source>
        <translation>, zbývající čas zatím neznámý</translation>
    </message>
    <message>
        <source>Compared on %1 scenes</source>
        <translation>Porovnáno, scén: %1</translation>
    </message>
    <message>
        <source>A model is being trained: cancel that first.</source>
        <translation>Model se učí: nejdřív to zrušte.</translation>
    </message>
    <message>
        <source>Two models are being compared: cancel that first.</source>
        <translation>Porovnávají se dva modely: nejdřív to zrušte.</translation>
    </message>
    <message>
        <source>There is no new model.</source>
        <translation>Není žádný nový model.</translation>
    </message>
    <message>
        <source>Choose a file of scenes to test on.</source>
        <translation>Vyberte soubor scén ke zkoušce.</translation>
    </message>
    <message>
        <source>No training or comparison is running.</source>
        <translation>Neběží nic, co by šlo zrušit.</translation>
    </message>
    <message>
        <source>Adopt (hold)</source>
        <translation>Převzít (podržet)</translation>
    </message>
    <message>
        <source>done (%1)</source>
        <translation>hotovo (%1)</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>Nečinné</translation>
    </message>
    <message>
        <source>%1: the number is the log-likelihood</source>
        <translation>%1: číslo je log-věrohodnost</translation>
    </message>
    <message>
        <source>Idle · done (log-likelihood %1)</source>
        <translation>Nečinné · hotovo (log-věrohodnost %1)</translation>
    </message>
</context>
<context>
    <name>terratact::TruthPage</name>
    <message>
        <source>Scenes</source>
        <translation>Scény</translation>
    </message>
    <message>
        <source>The arrow keys choose a scene; typing a number goes to it</source>
        <translation>Šipky vybírají scénu; napsané číslo na ni přejde</translation>
    </message>
    <message>
        <source>Slice of the cloud, robot and bins</source>
        <translation>Řez mračnem, robot a body</translation>
    </message>
    <message>
        <source>The scene</source>
        <translation>Scéna</translation>
    </message>
    <message>
        <source>left: dots · right: crosses · bins: mean of both sides, ± 1 and 2 sd</source>
        <translation>vlevo: tečky · vpravo: křížky · body: průměr obou stran, ± 1 a 2 směr. odch.</translation>
    </message>
    <message>
        <source>left: dots, solid · right: crosses, dashed · bins with ± 1 and 2 sd</source>
        <translation>vlevo: tečky, plně · vpravo: křížky, čárkovaně · body s ± 1 a 2 směr. odch.</translation>
    </message>
    <message>
        <source>both sides</source>
        <translation>obě strany</translation>
    </message>
    <message>
        <source>left side</source>
        <translation>levá strana</translation>
    </message>
    <message>
        <source>right side</source>
        <translation>pravá strana</translation>
    </message>
    <message>
        <source>Shown sides</source>
        <translation>Zobrazené strany</translation>
    </message>
    <message>
        <source>&amp;Accept</source>
        <translation>&amp;Přijmout</translation>
    </message>
    <message>
        <source>Keep the heights of this scene (A)</source>
        <translation>Ponechat výšky této scény (A)</translation>
    </message>
    <message>
        <source>E&amp;xclude</source>
        <translation>&amp;Vyřadit</translation>
    </message>
    <message>
        <source>Leave this scene out (X)</source>
        <translation>Vynechat tuto scénu (X)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Zpět</translation>
    </message>
    <message>
        <source>Take the last decision back (Ctrl+Z)</source>
        <translation>Vzít zpět poslední rozhodnutí (Ctrl+Z)</translation>
    </message>
    <message>
        <source>&amp;Export …</source>
        <translation>&amp;Exportovat …</translation>
    </message>
    <message>
        <source>Write the scenes with these decisions (Ctrl+E)</source>
        <translation>Zapsat scény s těmito rozhodnutími (Ctrl+E)</translation>
    </message>
    <message>
        <source>5 mm up</source>
        <translation>5 mm nahoru</translation>
    </message>
    <message>
        <source>Move the heights up by 5 mm (U)</source>
        <translation>Posunout výšky o 5 mm nahoru (U)</translation>
    </message>
    <message>
        <source>5 mm down</source>
        <translation>5 mm dolů</translation>
    </message>
    <message>
        <source>Move the heights down by 5 mm (D)</source>
        <translation>Posunout výšky o 5 mm dolů (D)</translation>
    </message>
    <message>
        <source>front up</source>
        <translation>vpředu výš</translation>
    </message>
    <message>
        <source>Tilt by 0.005 rad: higher ahead (F)</source>
        <translation>Naklonit o 0.005 rad: vpředu výš (F)</translation>
    </message>
    <message>
        <source>front down</source>
        <translation>vpředu níž</translation>
    </message>
    <message>
        <source>Tilt by 0.005 rad: lower ahead (G)</source>
        <translation>Naklonit o 0.005 rad: vpředu níž (G)</translation>
    </message>
    <message>
        <source>no nudge</source>
        <translation>bez posunu</translation>
    </message>
    <message>
        <source>Take the nudge of this scene away (0)</source>
        <translation>Zrušit posun této scény (0)</translation>
    </message>
    <message>
        <source>Decisions are saved in %1.</source>
        <translation>Rozhodnutí se ukládají do %1.</translation>
    </message>
    <message>
        <source>Decisions of %1.</source>
        <translation>Rozhodnutí ze souboru %1.</translation>
    </message>
    <message>
        <source>%1. Move this file away to start again.</source>
        <translation>%1. Chcete-li začít znovu, soubor přesuňte jinam.</translation>
    </message>
    <message>
        <source>Saved in %1.</source>
        <translation>Uloženo do %1.</translation>
    </message>
    <message>
        <source>NOT SAVED: %1</source>
        <translation>NEULOŽENO: %1</translation>
    </message>
    <message>
        <source>%1 scenes: %2 accepted, %3 excluded</source>
        <translation>scén: %1, přijato: %2, vyřazeno: %3</translation>
    </message>
    <message>
        <source>Scene %1 of %2</source>
        <translation>Scéna %1 z %2</translation>
    </message>
    <message>
        <source>drive %1 at %2 s</source>
        <translation>jízda %1 v %2 s</translation>
    </message>
    <message>
        <source>%1 bins known</source>
        <translation>známých bodů: %1</translation>
    </message>
    <message>
        <source>cloud %1 mm from the robot</source>
        <translation>mračno %1 mm od robota</translation>
    </message>
    <message>
        <source>nudged by %1</source>
        <translation>posunuto o %1</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>zatím neuloženo</translation>
    </message>
    <message>
        <source>Scenes to write</source>
        <translation>Scény k zapsání</translation>
    </message>
    <message>
        <source>_accepted.csv</source>
        <translation>_prijate.csv</translation>
    </message>
    <message>
        <source>Scenes (*.csv)</source>
        <translation>Scény (*.csv)</translation>
    </message>
    <message>
        <source>%1 exists already: choose another name.</source>
        <translation>%1 už existuje: zvolte jiné jméno.</translation>
    </message>
    <message>
        <source>%1 known heights written to %2.</source>
        <translation>Známých výšek zapsaných do %2: %1.</translation>
    </message>
    <message>
        <source>next scene</source>
        <translation>další scéna</translation>
    </message>
    <message>
        <source>previous scene</source>
        <translation>předchozí scéna</translation>
    </message>
    <message>
        <source>next open scene</source>
        <translation>další nerozhodnutá scéna</translation>
    </message>
    <message>
        <source>show both sides</source>
        <translation>ukázat obě strany</translation>
    </message>
    <message>
        <source>show the left side</source>
        <translation>ukázat levou stranu</translation>
    </message>
    <message>
        <source>show the right side</source>
        <translation>ukázat pravou stranu</translation>
    </message>
    <message>
        <source>Decisions</source>
        <translation>Rozhodnutí</translation>
    </message>
    <message>
        <source>accept the scene</source>
        <translation>přijmout scénu</translation>
    </message>
    <message>
        <source>exclude the scene</source>
        <translation>vyřadit scénu</translation>
    </message>
    <message>
        <source>heights up by 5 mm</source>
        <translation>výšky o 5 mm nahoru</translation>
    </message>
    <message>
        <source>heights down by 5 mm</source>
        <translation>výšky o 5 mm dolů</translation>
    </message>
    <message>
        <source>tilt: higher ahead</source>
        <translation>sklon: vpředu výš</translation>
    </message>
    <message>
        <source>tilt: lower ahead</source>
        <translation>sklon: vpředu níž</translation>
    </message>
    <message>
        <source>undo the last decision</source>
        <translation>vzít zpět poslední rozhodnutí</translation>
    </message>
    <message>
        <source>write the scenes with these decisions</source>
        <translation>zapsat scény s těmito rozhodnutími</translation>
    </message>
    <message>
        <source>This truth file was written by an earlier version and holds no cells of the cloud: write it again by terratact truth --review to nudge along the way</source>
        <translation>Tento soubor skutečnosti zapsala dřívější verze a nemá buňky mračna bodů: pro posun podél cesty ho zapište znovu příkazem terratact truth --review</translation>
    </message>
    <message>
        <source>2 cm ahead</source>
        <translation>2 cm vpřed</translation>
    </message>
    <message>
        <source>Move the cloud ahead by 2 cm under the robot (K)</source>
        <translation>Posunout mračno bodů pod robotem o 2 cm vpřed (K)</translation>
    </message>
    <message>
        <source>2 cm back</source>
        <translation>2 cm vzad</translation>
    </message>
    <message>
        <source>Move the cloud back by 2 cm under the robot (J)</source>
        <translation>Posunout mračno bodů pod robotem o 2 cm vzad (J)</translation>
    </message>
    <message>
        <source>cloud ahead by 2 cm</source>
        <translation>mračno bodů o 2 cm vpřed</translation>
    </message>
    <message>
        <source>cloud back by 2 cm</source>
        <translation>mračno bodů o 2 cm vzad</translation>
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
        <translation>jiná jízda</translation>
    </message>
    <message>
        <source>no pose around its time</source>
        <translation>žádná poloha kolem jejího času</translation>
    </message>
    <message>
        <source>left out: the robot lies off the cloud</source>
        <translation>vynecháno: robot leží mimo mračno</translation>
    </message>
    <message>
        <source>no bin is known well enough</source>
        <translation>žádný bod není dost přesně znám</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>vyřazena</translation>
    </message>
    <message>
        <source>open</source>
        <translation>nerozhodnuto</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>přijata</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>scéna</translation>
    </message>
    <message>
        <source>decision</source>
        <translation>rozhodnutí</translation>
    </message>
    <message>
        <source>drive</source>
        <translation>jízda</translation>
    </message>
    <message>
        <source>time [s]</source>
        <translation>čas [s]</translation>
    </message>
    <message>
        <source>cloud</source>
        <translation>mračno</translation>
    </message>
    <message>
        <source>bins</source>
        <translation>body</translation>
    </message>
    <message>
        <source>nudge</source>
        <translation>posun</translation>
    </message>
    <message>
        <source>%1 mm along</source>
        <translation>%1 mm podél</translation>
    </message>
</context>
<context>
    <name>terratact::TruthView</name>
    <message>
        <source>Slice of the cloud, robot and bins</source>
        <translation>Řez mračnem, robot a body</translation>
    </message>
    <message>
        <source>height [%1]</source>
        <translation>výška [%1]</translation>
    </message>
    <message>
        <source>forward from the IMU [%1]</source>
        <translation>vpřed od IMU [%1]</translation>
    </message>
</context>
<context>
    <name>terratact::TruthWindow</name>
    <message>
        <source>TRUTH — %1 — Terratact</source>
        <translation>SKUTEČNOST — %1 — Terratact</translation>
    </message>
    <message>
        <source>TRUTH FROM A LASER MAP</source>
        <translation>SKUTEČNOST Z LASEROVÉ MAPY</translation>
    </message>
    <message>
        <source>Truth</source>
        <translation>Skutečnost</translation>
    </message>
    <message>
        <source>Scenes, their cloud, and the decisions on them</source>
        <translation>Scény, jejich mračno a rozhodnutí o nich</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Stránky</translation>
    </message>
</context>
<context>
    <name>terratact::VerdictStrip</name>
    <message>
        <source>most likely at %1 … %2 (P %3)</source>
        <translation>nejspíš v %1 … %2 (P %3)</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Verdikt</translation>
    </message>
    <message>
        <source>Probability of a step ahead</source>
        <translation>Pravděpodobnost schodu vpředu</translation>
    </message>
    <message>
        <source>Why</source>
        <translation>Proč</translation>
    </message>
    <message>
        <source>Lower the limit</source>
        <translation>Snížit mez</translation>
    </message>
    <message>
        <source>Lowers the step limit (PgDown)</source>
        <translation>Překážkou je i nižší schod (PgDown)</translation>
    </message>
    <message>
        <source>Raise the limit</source>
        <translation>Zvýšit mez</translation>
    </message>
    <message>
        <source>Raises the step limit (PgUp)</source>
        <translation>Překážkou je až vyšší schod (PgUp)</translation>
    </message>
    <message>
        <source>✔ CLEAR</source>
        <translation>✔ VOLNO</translation>
    </message>
    <message>
        <source>up to %2 ahead of the IMU, at a risk below %1 %</source>
        <translation>do %2 před IMU, riziko pod %1 %</translation>
    </message>
    <message>
        <source>✘ BLOCKED</source>
        <translation>✘ PŘEKÁŽKA</translation>
    </message>
    <message>
        <source>? CANNOT TELL</source>
        <translation>? NELZE ŘÍCI</translation>
    </message>
    <message>
        <source>withheld: %1</source>
        <translation>zadrženo: %1</translation>
    </message>
    <message>
        <source>NO VERDICT</source>
        <translation>BEZ VERDIKTU</translation>
    </message>
    <message>
        <source>Is there a step of more than %1 ahead?</source>
        <translation>Je vpředu schod vyšší než %1?</translation>
    </message>
    <message>
        <source>not decided (CLEAR below %1, BLOCKED above %2); %3</source>
        <translation>nerozhodnuto (VOLNO pod %1, PŘEKÁŽKA nad %2); %3</translation>
    </message>
    <message>
        <source>no live telemetry</source>
        <translation>bez živé telemetrie</translation>
    </message>
    <message>
        <source>not converged</source>
        <translation>nezkonvergovalo</translation>
    </message>
    <message>
        <source>unlike all training</source>
        <translation>nepodobá se tréninku</translation>
    </message>
    <message>
        <source>the robot rolls</source>
        <translation>robot se naklání</translation>
    </message>
    <message>
        <source>the flippers differ</source>
        <translation>flippery se liší</translation>
    </message>
    <message>
        <source>%1 is the lowest limit</source>
        <translation>Nižší mez než %1 nelze nastavit</translation>
    </message>
    <message>
        <source>%1 is the highest limit</source>
        <translation>Vyšší mez než %1 nelze nastavit</translation>
    </message>
    <message>
        <source>the link was lost</source>
        <translation>spojení bylo ztraceno</translation>
    </message>
    <message>
        <source>A step: two bins at most %3 apart differ in height by more than the limit. The bins lie %1 to %2 ahead of the IMU</source>
        <translation>Schod: výšky dvou bodů nejvýše %3 od sebe se liší o víc než mez. Body leží %1 až %2 před IMU</translation>
    </message>
    <message>
        <source>felt to %1 ahead of the IMU, risk below %2 %</source>
        <translation>ohmatáno do %1 před IMU, riziko pod %2 %</translation>
    </message>
    <message>
        <source>%1. Helps: %2</source>
        <translation>%1. Pomůže: %2</translation>
    </message>
    <message>
        <source>✔ CLEAR to %1</source>
        <translation>✔ VOLNO do %1</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>do %1</translation>
    </message>
    <message>
        <source>a sensor may be wrong</source>
        <translation>snímač možná neměří správně</translation>
    </message>
    <message>
        <source>it contradicts the readings</source>
        <translation>odporuje údajům</translation>
    </message>
    <message>
        <source>flippers press on nothing</source>
        <translation>flippery na nic netlačí</translation>
    </message>
    <message>
        <source>felt to %1 only</source>
        <translation>ohmatáno jen do %1</translation>
    </message>
    <message>
        <source>not felt under the flippers</source>
        <translation>pod flippery neohmatáno</translation>
    </message>
    <message>
        <source>, flatter flippers help</source>
        <translation>, pomohou plošší flippery</translation>
    </message>
    <message>
        <source>not decided; %1</source>
        <translation>nerozhodnuto; %1</translation>
    </message>
    <message>
        <source>not decided</source>
        <translation>nerozhodnuto</translation>
    </message>
    <message>
        <source>Verdict of each side</source>
        <translation>Verdikt každé strany</translation>
    </message>
    <message>
        <source>P(step &gt; %1 to %2): %3</source>
        <translation>P(schod &gt; %1 do %2): %3</translation>
    </message>
    <message>
        <source>P(step &gt; %1 to %2) = %3</source>
        <translation>P(schod &gt; %1 do %2) = %3</translation>
    </message>
    <message>
        <source>P(step &gt; %1 ahead): %2</source>
        <translation>P(schod &gt; %1 vpředu): %2</translation>
    </message>
    <message>
        <source>P(step &gt; %1 ahead) = %2</source>
        <translation>P(schod &gt; %1 vpředu) = %2</translation>
    </message>
    <message>
        <source>, %1 further helps</source>
        <translation>, pomůže o %1 dál</translation>
    </message>
    <message>
        <source>bounded: %1</source>
        <translation>omezeno: %1</translation>
    </message>
    <message>
        <source>not felt: %1</source>
        <translation>neohmatáno: %1</translation>
    </message>
    <message>
        <source>nothing ahead is felt</source>
        <translation>vpředu není nic ohmatáno</translation>
    </message>
    <message>
        <source>%1, spanned to %2, risk below %3 %</source>
        <translation>%1, překlenuto do %2, riziko pod %3 %</translation>
    </message>
    <message>
        <source>the differential has turned</source>
        <translation>diferenciál je pootočen</translation>
    </message>
</context>
<context>
    <name>terratact::ViewMenu</name>
    <message>
        <source>layout: drive</source>
        <translation>rozvržení: jízda</translation>
    </message>
    <message>
        <source>layout: probe</source>
        <translation>rozvržení: sonda</translation>
    </message>
    <message>
        <source>layout: review</source>
        <translation>rozvržení: přehled</translation>
    </message>
    <message>
        <source>default layout and text size</source>
        <translation>rozvržení a písmo jako na začátku</translation>
    </message>
    <message>
        <source>colours: day</source>
        <translation>barvy: den</translation>
    </message>
    <message>
        <source>colours: night, red</source>
        <translation>barvy: noc, červená</translation>
    </message>
    <message>
        <source>colours: high contrast</source>
        <translation>barvy: vysoký kontrast</translation>
    </message>
    <message>
        <source>larger text</source>
        <translation>větší písmo</translation>
    </message>
    <message>
        <source>smaller text</source>
        <translation>menší písmo</translation>
    </message>
    <message>
        <source>normal text size</source>
        <translation>písmo normální velikosti</translation>
    </message>
    <message>
        <source>language: %1</source>
        <translation>jazyk: %1</translation>
    </message>
</context>
<context>
    <name>terratact::WhatIfPage</name>
    <message>
        <source>What if …</source>
        <translation>Co kdyby …</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>V čem se liší</translation>
    </message>
    <message>
        <source>Recorded estimate and what-if, bin by bin</source>
        <translation>Zaznamenaný odhad a co kdyby, bod po bodu</translation>
    </message>
    <message>
        <source>bin [%1]</source>
        <translation>bod [%1]</translation>
    </message>
    <message>
        <source>then [%1]</source>
        <translation>tehdy [%1]</translation>
    </message>
    <message>
        <source>now [%1]</source>
        <translation>nyní [%1]</translation>
    </message>
    <message>
        <source>by</source>
        <translation>o</translation>
    </message>
    <message>
        <source>sd then</source>
        <translation>sd tehdy</translation>
    </message>
    <message>
        <source>sd now</source>
        <translation>sd nyní</translation>
    </message>
    <message>
        <source>q10 by</source>
        <translation>q10 o</translation>
    </message>
    <message>
        <source>q90 by</source>
        <translation>q90 o</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metoda</translation>
    </message>
    <message>
        <source>Which method estimates</source>
        <translation>Která metoda odhaduje</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Kvalita</translation>
    </message>
    <message>
        <source>Draws, chains and precision</source>
        <translation>Vzorky, řetězce a přesnost</translation>
    </message>
    <message>
        <source>as recorded</source>
        <translation>jako v záznamu</translation>
    </message>
    <message>
        <source>An element counts as contact above</source>
        <translation>Kontakt je prvek nad</translation>
    </message>
    <message>
        <source>Force above which an element counts as contact</source>
        <translation>Síla, nad kterou prvek platí za kontakt</translation>
    </message>
    <message>
        <source>Contact above</source>
        <translation>Kontakt nad</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Semínko</translation>
    </message>
    <message>
        <source>Seed of the random numbers: a whole number</source>
        <translation>Semínko náhodných čísel: celé číslo</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>File of the model</source>
        <translation>Soubor modelu</translation>
    </message>
    <message>
        <source>another file …</source>
        <translation>jiný soubor …</translation>
    </message>
    <message>
        <source>Models (*.ttm)</source>
        <translation>Modely (*.ttm)</translation>
    </message>
    <message>
        <source>As recorded</source>
        <translation>Jako v záznamu</translation>
    </message>
    <message>
        <source>Sets everything to what was recorded</source>
        <translation>Nastaví vše podle záznamu</translation>
    </message>
    <message>
        <source>Estimates the recorded scene with these settings</source>
        <translation>Odhadne zaznamenanou scénu s tímto nastavením</translation>
    </message>
    <message>
        <source>Progress of the estimate</source>
        <translation>Průběh odhadu</translation>
    </message>
    <message>
        <source>Estimate %1 of scene %2 at %3 s, by %4 with the model %5</source>
        <translation>Odhad %1 scény %2 v %3 s, metodou %4 s modelem %5</translation>
    </message>
    <message>
        <source>There was no estimate at this time: go to one (key 4 finds the next).</source>
        <translation>V tomto čase neplatil žádný odhad: přejděte na některý (klávesa 4 najde další).</translation>
    </message>
    <message>
        <source>No estimate: %1</source>
        <translation>Bez odhadu: %1</translation>
    </message>
    <message>
        <source>No model is chosen</source>
        <translation>Není vybrán žádný model</translation>
    </message>
    <message>
        <source>Estimating …</source>
        <translation>Odhaduje se …</translation>
    </message>
    <message>
        <source>The recorded settings and model reproduce the recorded estimate bit for bit.</source>
        <translation>Zaznamenané nastavení a model dávají znovu zaznamenaný odhad, bit po bitu.</translation>
    </message>
    <message>
        <source>The recorded settings and model reproduce the recorded estimate except for rounding in the last bits: no number moves by more than a millionth.</source>
        <translation>Zaznamenané nastavení a model dávají znovu zaznamenaný odhad až na poslední bity, které jiný procesor nebo verze zaokrouhluje jinak: žádné číslo se neposune o více než milióntinu.</translation>
    </message>
    <message>
        <source>A time limit ended the recorded sampling, so it cannot be repeated bit for bit: %1 at most, at bin %2.</source>
        <translation>Zaznamenané vzorkování ukončil čas, nelze je tedy opakovat bit po bitu: nejvýše %1, v bodu %2.</translation>
    </message>
    <message>
        <source>The recorded settings and model do NOT reproduce the recorded estimate: %1 at most, at bin %2.</source>
        <translation>Zaznamenané nastavení a model NEDÁVAJÍ zaznamenaný odhad: nejvýše %1, v bodu %2.</translation>
    </message>
    <message>
        <source>Differs from the recorded estimate by %1 at most, at bin %2.</source>
        <translation>Liší se od zaznamenaného odhadu nejvýše o %1, v bodu %2.</translation>
    </message>
    <message>
        <source>Estimate again (E)</source>
        <translation>Odhadnout znovu (E)</translation>
    </message>
    <message>
        <source>No estimate at this time</source>
        <translation>V tomto čase neplatil žádný odhad</translation>
    </message>
    <message>
        <source>Change settings, then estimate again: the page Terrain (F2) draws both.</source>
        <translation>Změňte, co chcete, a odhadněte znovu: stránka Terén (F2) nakreslí oba odhady.</translation>
    </message>
    <message>
        <source>Cancel the estimate</source>
        <translation>Zrušit odhad</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>%1 vlevo</translation>
    </message>
    <message>
        <source>%1 right</source>
        <translation>%1 vpravo</translation>
    </message>
    <message>
        <source>Steps of more than %1: %2 then, %3 now.</source>
        <translation>Schody nad %1: tehdy %2, nyní %3.</translation>
    </message>
    <message>
        <source>Left: %1 then, %2 now.</source>
        <translation>Vlevo: tehdy %1, nyní %2.</translation>
    </message>
    <message>
        <source>Right: %1 then, %2 now.</source>
        <translation>Vpravo: tehdy %1, nyní %2.</translation>
    </message>
    <message>
        <source>left</source>
        <translation>vlevo</translation>
    </message>
    <message>
        <source>right</source>
        <translation>vpravo</translation>
    </message>
</context>
</TS>
